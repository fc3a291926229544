// A steering run: where the object was at each tick, and where it was to go.
import { button, make } from "../elements.js";
import { Replay } from "../replay.js";
import { latticeOf } from "../../model/scenario.js";
import { isTable, wholeRows } from "./series.js";

const DEG = Math.PI / 180;

export function steered(element, desk, scenes) {
  const { payload } = desk;
  const ticks = wholeRows(payload.ticks, ["time", "x", "y", "angle"]);
  const goals = (Array.isArray(payload.goals) ? payload.goals : []).filter((goal) => [goal?.x, goal?.y, goal?.from].every(Number.isFinite));
  if (!goals.length) throw new Error("no goal in it");
  const told = toldOf(payload);
  const frames = flatFrames(payload.scenario, ticks);
  if (!frames.length) throw new Error("no poses in it");
  const end = frames.at(-1).at;
  const goal = goals.at(-1);
  const off = Math.hypot(end.x - goal.x, end.y - goal.y) * 1000;
  const turn = !Number.isFinite(goal.angle) ? null : Math.abs(Math.atan2(Math.sin(end.angle - goal.angle), Math.cos(end.angle - goal.angle))) / DEG;
  element.append(
    make("p", {}, `${frames.length} ticks, ${goals.length === 1 ? "one goal" : `${goals.length} goals`}; at the end `
      + `${off.toFixed(1)} mm${turn === null ? "" : ` and ${turn.toFixed(1)} deg`} from the last.`),
    button("Play it beside the live sheet", () => {
      const told = { changed: () => desk.tell("frame"), refused: (message) => desk.tell("notice", message) };
      desk.sit(new Replay(payload.scenario, frames, {}, told), { ...payload.scenario, name: "as steered" });
      mark();
    }),
    told.length
      ? button("Steer it again here", () => {
        if (desk.set({ ...payload.scenario, duration: Math.max(payload.scenario.duration, frames.at(-1).time) }, told))
          desk.tell("notice", "The plate is told what it was told then: the sheet goes its own way there");
      })
      : null,
    make("p", { class: "note" }, "The file holds where the object was, not how it bent: it is drawn flat."),
  );
  const mark = () => desk.seats.forEach(({ live }, k) => {
    const now = [...goals].reverse().find((each) => each.from <= live.clock) ?? goals[0];
    scenes[k]?.view.setGoal(live.recorded || live.plan.length ? { x: now.x, y: now.y, angle: now.angle ?? 0 } : null);
  });
  desk.on("drawn", mark);
}

/** What the plate was told, in the order of times; nothing where the file does not hold it. */
function toldOf({ told, motions }) {
  if (!Array.isArray(told) || !Array.isArray(motions)) return [];
  const all = told.map((each) => ({ time: each?.time, within: each?.within, motion: motions[each?.motion] }));
  if (!all.every(({ time, within, motion }) => Number.isFinite(time) && Number.isFinite(within) && isTable(motion))) return [];
  return all.sort((a, b) => a.time - b.time);
}

/** The sheet laid flat at each tick's pose, the plate at rest. */
function flatFrames(scenario, ticks) {
  const { rest } = latticeOf(scenario.sheet);
  const { pitch } = scenario.sheet;
  const frames = [];
  ticks.time.forEach((time, k) => {
    const [x, y, angle] = [ticks.x[k], ticks.y[k], ticks.angle[k]];
    const [c, s] = [Math.cos(angle) * pitch, Math.sin(angle) * pitch];
    const nodes = new Float32Array((rest.length / 2) * 3);
    for (let j = 0; 2 * j < rest.length; j++) {
      nodes[3 * j] = x + c * rest[2 * j] - s * rest[2 * j + 1];
      nodes[3 * j + 1] = y + s * rest[2 * j] + c * rest[2 * j + 1];
    }
    frames.push({ time, nodes, pose: [0, 0, 0, 0, 0, 0], at: { x, y, angle } });
  });
  return frames;
}
