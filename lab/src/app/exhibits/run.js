// A recorded run beside the sheet that lives here.
import { button, make } from "../elements.js";
import { floatsOf } from "../data.js";
import { Replay } from "../replay.js";
import { inWords, reading } from "../reading.js";
import { isTable } from "./series.js";

export function recorded(element, desk) {
  const { payload } = desk;
  const frames = framesOf(payload);
  const channels = Object.fromEntries(Object.entries(seriesOf(payload)).map(([name, values]) => [name, Float32Array.from(values, real)]));
  const replay = () => new Replay(payload.scenario, frames, channels, { changed: () => desk.tell("frame"), refused: (m) => desk.tell("notice", m) });
  const read = reading(payload.scenario, replay().samples, false);
  element.append(
    make("p", {}, `The file's run: ${inWords(read)}, ${frames.length} shapes of ${(frames.at(-1)?.time ?? 0).toFixed(2)} s.`),
    button("Play it beside the live sheet", () => {
      desk.sit(replay(), payload.scenario);
    }, { disabled: frames.length === 0 }),
  );
}

/** Channels of one length, the times among them. */
function seriesOf({ time, channels }) {
  const all = { ...(isTable(channels) ? channels : {}), time };
  if (!Array.isArray(time) || !Object.values(all).every((values) => Array.isArray(values) && values.length === time.length))
    throw new Error("series of different lengths");
  return all;
}

const real = (value) => (value === null ? NaN : Number(value));

/** Frames of shapes as a file holds them. */
export function framesOf(payload) {
  const { snapshot_time: times = [], plate_pose: poses = [], snapshots = "" } = payload;
  const isPose = (pose) => Array.isArray(pose) && pose.length === 6 && pose.every(Number.isFinite);
  if (!Array.isArray(times) || !Array.isArray(poses) || poses.length !== times.length || !poses.every(isPose) || typeof snapshots !== "string")
    throw new Error("no shapes with the plate's poses in it");
  const numbers = floatsOf(snapshots);
  const each = times.length ? Math.floor(numbers.length / times.length) : 0;
  if (each % 3) throw new Error("shapes that are no nodes");
  return times.map((time, k) => ({ time: Number(time), nodes: numbers.subarray(k * each, (k + 1) * each), pose: poses[k] }));
}
