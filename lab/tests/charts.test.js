// What charts make of numbers before they draw them.
import assert from "node:assert/strict";
import { test } from "node:test";
import { inkOn, scaleColour } from "../src/charts/colours.js";
import { fitInWords, pointInWords } from "../src/charts/curve.js";
import { timesOf } from "../src/charts/gait.js";
import { read } from "../src/charts/plot.js";
import { thinned } from "../src/charts/series.js";

test("a thinned series keeps its ends and every peak", () => {
  const time = Float64Array.from({ length: 20000 }, (_, i) => i);
  const spike = time.map((t) => (t === 12345 ? 9 : t === 777 ? -9 : Math.sin(t)));
  const kept = thinned(time, [spike, time]);
  assert.ok(kept.length < 3000);
  assert.deepEqual([kept[0], kept.at(-1)], [0, 19999]);
  assert.ok(kept.includes(12345) && kept.includes(777));
  assert.deepEqual(kept, [...new Set(kept)].sort((a, b) => a - b));
  assert.deepEqual(thinned([0, 1, 2], [[1, 2, 3]]), [0, 1, 2]);
});

test("bars of a leg are the times in which it touches", () => {
  assert.deepEqual(timesOf([0, 1, 2, 3, 4, 5], [0, 1, 1, 0, 0.2, 1], 0), [[0, 2], [4, 5]]);
  assert.deepEqual(timesOf([0, 1, 2, 3], [1, 1, 1, 1], 3), [[2, 3]]);
  assert.deepEqual(timesOf([], [], 0), []);
});

test("numbers are read with so many digits and no needless zeros", () => {
  assert.deepEqual([0, 0.5, 123.456, 1234.56, -2e-5, 3e7, NaN, 24].map((value) => read(value)),
    ["0", "0.5", "123", "1235", "-2e-5", "3e+7", "–", "24"]);
});

test("the scale is one of lightness, and what stands on it can be read", () => {
  const lightness = (colour) => colour.match(/\d+/g).map(Number).reduce((sum, value, i) => sum + [0.299, 0.587, 0.114][i] * value, 0);
  const along = Array.from({ length: 21 }, (_, i) => lightness(scaleColour(i / 20)));
  assert.ok(along.every((value, i) => i === 0 || value > along[i - 1]));
  along.forEach((value, i) => assert.ok(inkOn(i / 20) === "#ffffff" ? value < 150 : value > 120));
  assert.equal(scaleColour(7), scaleColour(1));
});

test("a point and a fit are told in words", () => {
  const words = pointInWords({ frequency: 24, rate: Math.PI, spread: 0.1, gait: "walking", failure: "slipped", failureTime: 1.25,
    runs: 3, failedRuns: 1 });
  assert.equal(words, "24 Hz, 180 ± 5.7 °/s, walking, 1 of 3 failed: slipped at 1.3 s");
  assert.match(fitInWords({ refused: "rates that are all alike", advice: "more" }), /No Lorentz fit: got rates.*Try more/);
  assert.equal(fitInWords(null), "");
});
