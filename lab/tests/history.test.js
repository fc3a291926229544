// What is kept of a sheet that lives for long.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Samples } from "../src/app/history.js";

test("energies of a long run are all in its books, though most of its samples are forgotten", () => {
  const samples = new Samples();
  const each = 7000;
  for (let piece = 0; piece < 20; piece++) {
    const time = Float32Array.from({ length: each }, (_, i) => piece * each + i);
    samples.add({ time, plate_work: time.map((t) => (t === 0 ? 0 : 0.5)), centre_x: time.map((t) => 2 * t) });
  }
  const { time, plate_work: work, centre_x: x } = samples.all();
  assert.ok(samples.length < 70_000 && time.length === samples.length);
  assert.deepEqual([time[0], time.at(-1)], [0, 20 * each - 1]);
  assert.equal(work.reduce((sum, value) => sum + value, 0), 0.5 * (20 * each - 1));
  assert.ok(time.every((t, i) => x[i] === 2 * t && (i === 0 || t > time[i - 1])));
});
