// A recorded run beside the sheet that lives here.
import { button, make } from "../elements.js";
import { floatsOf } from "../data.js";
import { Replay } from "../replay.js";
import { inWords, reading } from "../reading.js";

export function recorded(element, desk) {
  const { payload } = desk;
  const frames = framesOf(payload);
  const channels = Object.fromEntries(Object.entries(payload.channels ?? {}).map(([name, values]) => [name, Float32Array.from(values, real)]));
  channels.time ??= Float32Array.from(payload.time ?? [], real);
  const replay = () => new Replay(payload.scenario, frames, channels, { changed: () => desk.tell("frame"), refused: (m) => desk.tell("notice", m) });
  const read = reading(payload.scenario, replay().samples, false);
  element.append(
    make("p", {}, `The file's run: ${inWords(read)}, ${frames.length} shapes of ${(frames.at(-1)?.time ?? 0).toFixed(2)} s.`),
    button("Play it beside the live sheet", () => {
      desk.sit(replay(), payload.scenario);
    }, { disabled: frames.length === 0 }),
  );
}

const real = (value) => (value === null ? NaN : Number(value));

/** Frames of shapes as a file holds them. */
export function framesOf(payload) {
  const times = payload.snapshot_time ?? [];
  const numbers = payload.snapshots ? floatsOf(payload.snapshots) : new Float32Array(0);
  const each = times.length ? Math.floor(numbers.length / times.length) : 0;
  if (each % 3) throw new Error("shapes that are no nodes");
  return times.map((time, k) => ({ time: Number(time), nodes: numbers.subarray(k * each, (k + 1) * each), pose: payload.plate_pose[k].map(Number) }));
}
