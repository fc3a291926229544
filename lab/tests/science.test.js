// What the tabs ask of the workers, and how they read what was typed.
import assert from "node:assert/strict";
import { test } from "node:test";
import { withValue } from "../src/app/change.js";
import { frequenciesOf, scenarioAt } from "../src/science/curve.js";
import { FieldError, quantity, whole } from "../src/science/form.js";
import { cellsOf, mapCsv, parametersOf, standIn, valuesOf } from "../src/science/grid.js";
import { readCurve, storedCurves } from "../src/science/overlays.js";
import { coarseFirst, groupsOf, observeAll } from "../src/science/work.js";

const HERTZ = { name: "motion.frequency", kind: "number", unit: "Hz", display: "Hz", factor: 1, example: "24 Hz", above: 0 };
const ANGLE = { name: "motion.angle", kind: "number", unit: "rad", display: "deg", factor: Math.PI / 180, example: "8 deg", at_least: 0 };
const UNITS = { Hz: [1, "Hz"], kHz: [1000, "Hz"], deg: [Math.PI / 180, "rad"], s: [1, "s"] };
const SCENARIO = { name: "a", gravity: 9.81, plate: null, duration: 4, transient: 1, sheet: { outline: { shape: "disk", radius: 0.04 }, pitch: 0.01 },
  motion: { frequency: 24, angle: 0.1 }, friction: { static: 0.5, kinetic: 0.25 } };

test("numbers are read with their unit, or in the one that people read", () => {
  assert.equal(quantity("from", "0.02 kHz", HERTZ, UNITS), 20);
  assert.equal(quantity("from", " 12,5 ", HERTZ, UNITS), 12.5);
  assert.ok(Math.abs(quantity("angle", "180", ANGLE, UNITS) - Math.PI) < 1e-12);
  assert.ok(Math.abs(quantity("angle", "90 °", ANGLE, UNITS) - Math.PI / 2) < 1e-12);
});

test("what cannot be is told in a line with field, what was got and what is allowed", () => {
  const refusal = (text, field = HERTZ) => {
    try {
      return quantity("from", text, field, UNITS);
    } catch (error) {
      assert.ok(error instanceof FieldError && error.field === "from");
      return error.message;
    }
  };
  assert.equal(refusal("0"), "from: 0 Hz is not allowed: above 0 Hz. Type 24 Hz.");
  assert.match(refusal("12 deg"), /from: “deg” is no unit here: Hz/);
  for (const text of ["", "abc", "1e400", "NaN", "12 constructor", "12 __proto__", "-3 Hz", "1 2"]) assert.match(refusal(text), /^from: .+/);
  assert.match(refusal("-1", ANGLE), /at least 0 °/);
  assert.throws(() => whole("points", "2.5", 2, 200), /points: “2.5” is not allowed: a whole number from 2 to 200/);
  for (const text of ["", "1", "201", "x"]) assert.throws(() => whole("points", text, 2, 200), FieldError);
  assert.equal(whole("points", "30", 2, 200), 30);
});

test("groups fill whole blocks of four lanes", () => {
  const items = Array.from({ length: 30 }, (_, i) => i);
  for (const repeats of [1, 2, 3, 4, 5, 6, 8]) {
    const groups = groupsOf(items, repeats);
    assert.deepEqual(groups.flat(), items);
    for (const group of groups.slice(0, -1)) assert.equal((group.length * repeats) % 4, 0);
  }
});

test("the order is from coarse to fine and leaves nothing out", () => {
  assert.deepEqual(coarseFirst(10), [0, 8, 4, 2, 6, 1, 3, 5, 7, 9]);
  const axis = (count, name = "motion.frequency") => ({ field: { name }, values: Array.from({ length: count }, (_, i) => i) });
  const cells = cellsOf(axis(20), axis(11, "sheet.outline.radius"));
  assert.equal(new Set(cells.map(({ i, j }) => `${i},${j}`)).size, 220);
  assert.deepEqual(cells.slice(0, 6).map(({ i, j }) => [i, j]), [[0, 0], [8, 0], [16, 0], [0, 8], [8, 8], [16, 8]]);
  const done = new Map([["0,0", "a"], ["4,4", "b"]]);
  assert.deepEqual([standIn(done, 1, 1), standIn(done, 5, 6), standIn(done, 9, 9)], ["a", "b", undefined]);
});

test("frequencies and values go from end to end", () => {
  assert.deepEqual(frequenciesOf(12, 30, 4), [12, 18, 24, 30]);
  assert.deepEqual(valuesOf(1, 100, 3, false), [1, 10, 100]);
  assert.deepEqual(valuesOf(0, 1, 3, true), [0, 0.5, 1]);
});

test("a scenario is changed where it is told and nowhere else", () => {
  const before = structuredClone(SCENARIO);
  assert.equal(withValue(SCENARIO, "sheet.outline.radius", 0.05).sheet.outline.radius, 0.05);
  const steep = withValue(SCENARIO, "friction_angle", Math.PI / 4).friction;
  assert.ok(Math.abs(steep.static - 1) < 1e-12 && Math.abs(steep.kinetic - 0.5) < 1e-12);
  const point = scenarioAt(SCENARIO, 20, 2);
  assert.deepEqual([point.motion.frequency, point.duration, point.transient], [20, 2, null]);
  assert.deepEqual(SCENARIO, before);
});

test("parameters are those that the scenario has", () => {
  const radius = { ...HERTZ, name: "sheet.outline.radius", on: ["disk"] };
  const length = { ...HERTZ, name: "sheet.outline.length", on: ["ellipse"] };
  const facts = { fields: [HERTZ, ANGLE, radius, length, { ...HERTZ, name: "plate.length" }, { ...HERTZ, name: "duration" },
    { ...HERTZ, name: "motion.waves.*.ratio" }, { ...HERTZ, name: "friction.law", kind: "choice", choices: ["a"] }] };
  assert.deepEqual(parametersOf(facts, SCENARIO).map(({ name }) => name), ["motion.frequency", "motion.angle", "sheet.outline.radius"]);
});

/** A pool that answers after a while, in which scenarios of no mass cannot be run. */
const poolOf = (asked) => ({
  size: 2,
  ask: async ({ scenarios, repeats }, { signal }) => {
    asked.push(scenarios.length);
    await new Promise((resolve) => setTimeout(resolve, 1));
    if (signal.aborted) throw new Error("stopped");
    if (scenarios.some(({ mass }) => mass === 0)) throw Object.assign(new Error("got 0"), { field: "sheet.mass" });
    return { observations: scenarios.map(({ mass }) => Array(repeats).fill(mass)) };
  },
});

const study = (given) => {
  const [seen, refused, stop] = [new Map(), new Map(), new AbortController()];
  const done = observeAll({ scenarioOf: (mass) => ({ mass }), repeats: 1, seed: 0, signal: stop.signal,
    onObserved: (item, runs) => seen.set(item, runs), onRefused: (item, message) => refused.set(item, message), ...given });
  return { seen, refused, stop, done };
};

test("every item is observed once, four at a time, and one that cannot be run spoils no other", async () => {
  const asked = [];
  const { seen, refused, done } = study({ pool: poolOf(asked), items: [1, 2, 0, 3, 4, 5, 6] });
  await done;
  assert.deepEqual([...seen.keys()].sort(), [1, 2, 3, 4, 5, 6]);
  assert.deepEqual([...refused], [[0, "sheet.mass: got 0"]]);
  assert.deepEqual(asked.sort(), [1, 1, 1, 1, 3, 4]);
});

test("a study stops at a word, and what it has stays", async () => {
  const items = Array.from({ length: 400 }, (_, i) => i + 1);
  const { seen, refused, stop, done } = study({ pool: poolOf([]), items });
  setTimeout(() => stop.abort(), 8);
  await done;
  assert.ok(seen.size > 0 && seen.size < 400 && refused.size === 0);
});

test("a map's file has a row for each cell, and no formula", () => {
  const [x, y] = [{ field: HERTZ, values: [12, 24] }, { field: ANGLE, values: [0, Math.PI / 2] }];
  const point = { rate: Math.PI, spread: NaN, gait: "walking", failure: "", runs: 1, failedRuns: 0, values: { drift: 0.002 } };
  const rows = mapCsv(x, y, new Map([["1,1", point], ["0,0", { refused: '=cmd("x"), no' }]])).split("\n");
  assert.match(rows[0], /^motion.frequency_Hz,motion.angle_deg,spin_rate_deg_s,.*,drift_mm,.*,note$/);
  assert.match(rows[1], /^24,90,180,,walking,,1,0,2,/);
  assert.match(rows[2], /"'=cmd\(""x""\), no"$/);
  assert.ok(rows.slice(1, 3).every((row, i) => i === 1 || row.split(",").length === rows[0].split(",").length));
});

test("measured curves and a store's are laid beside", () => {
  const { name, points } = readCurve("my film.csv", "Frequency_Hz;spin_rate_deg_s;gait\n20;180;walking\n12,5;90,0;\n22;;failed\n");
  assert.equal(name, "my film");
  assert.deepEqual(points.map(({ frequency }) => frequency), [12.5, 20, 22]);
  assert.ok(Math.abs(points[1].rate - Math.PI) < 1e-12 && Number.isNaN(points[2].rate));
  assert.throws(() => readCurve("x.csv", "a,b\n1,2"), /x.csv: got the columns a, b, must be frequency_hz/);
  assert.throws(() => readCurve("x.csv", ""), /got the columns/);
  assert.throws(() => readCurve("x.csv", "frequency_hz,spin_rate_deg_s\n"), /no row/);
  const payload = { kind: "store", name: "s", parameters: [{ name: "motion.angle", display: "deg" }, { name: "motion.frequency", display: "Hz" }],
    points: [{ at: [Math.PI / 18, 20], spin_rate: 3 }, { at: [Math.PI / 18, 12], spin_rate: null }, { at: [0.2, 12], spin_rate: 1 }] };
  const curves = storedCurves(payload, UNITS);
  assert.deepEqual(curves.map((curve) => curve.name), ["angle 10 °", "angle 11.46 °"]);
  assert.deepEqual(curves[0].points, [{ frequency: 12, rate: NaN }, { frequency: 20, rate: 3 }]);
  assert.deepEqual(storedCurves({ kind: "none" }), []);
});
