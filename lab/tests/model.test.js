// The model by closed forms and by what it must refuse; tests/agreement holds it to the package's.
import assert from "node:assert/strict";
import { test } from "node:test";
import { courseOf, goneOver, stillNeeded } from "../src/model/course.js";
import { lattice } from "../src/model/lattice.js";
import { tridiagonalModes } from "../src/model/lanczos.js";
import { naturalFrequency } from "../src/model/modes.js";
import { periodOf, poseAtStart, rotationOf, termsOf } from "../src/model/motion.js";
import { occupiedSquares } from "../src/model/outline.js";
import { samplesOf, startPositions, stepsOf, strideOf, thinningOf } from "../src/model/recording.js";
import { roundHalfEven } from "../src/model/rounding.js";
import { checkScenario, latticeOf, measuredFrom, timeStep } from "../src/model/scenario.js";
import { stableTimeStep } from "../src/model/sheet.js";
import { knotsOf, naturalSpline } from "../src/model/spline.js";
import { cheese } from "./scenarios.js";

const near = (got, want, within) => assert.ok(Math.abs(got - want) <= within, `${got} is not ${want} within ${within}`);

/** Rows of a lattice as text, the top one first. */
const drawn = ({ columns, rows, inside }) =>
  Array.from({ length: rows }, (_, j) =>
    Array.from({ length: columns }, (__, i) => ".#"[inside[i * rows + rows - 1 - j]]).join(""));

test("the dissertation's disk is 8 × 8 squares less three at each corner", () => {
  assert.deepEqual(drawn(occupiedSquares({ shape: "disk", radius: 0.04 }, 0.01)).map((row) => row.match(/#/g).length),
    [4, 6, 8, 8, 8, 8, 6, 4]);
});

test("a mask comes out as it was drawn, its first row on top and its margin left out", () => {
  const rows = [".....", ".##..", ".#...", ".###."];
  const outline = { shape: "mask", width_of_picture: 0.05, image: null, rows };
  assert.deepEqual(drawn(occupiedSquares(outline, 0.01)), ["##.", "#..", "###"]);
});

test("points on a polygon's edge are inside where both sides are", () => {
  const square = { shape: "polygon", corners: [[0, 0], [0.04, 0], [0.04, 0.04], [0, 0.04]] };
  assert.deepEqual(drawn(occupiedSquares(square, 0.01)), ["####", "####", "####", "####"]);
});

test("lines and cells of a lattice are in the core's order", () => {
  const inside = Uint8Array.from([1, 1, 1, 1, 1, 0]);
  const { nNodes, axial, lineStart, lineNodes, cells, nCells } = lattice({ columns: 3, rows: 2, inside });
  assert.equal(nNodes, 5);
  assert.equal(axial, 4);
  const lines = [...lineStart].slice(1).map((end, k) => [...lineNodes.subarray(lineStart[k], end)]);
  assert.deepEqual(lines, [[0, 1, 2], [3, 4], [0, 3], [1, 4], [0, 4], [3, 1], [4, 2]]);
  assert.deepEqual([nCells, ...cells], [1, 0, 1, 3, 4]);
});

test("like sheets share a lattice, and unlike ones do not", () => {
  assert.equal(latticeOf(cheese().sheet), latticeOf(cheese().sheet));
  assert.notEqual(latticeOf(cheese().sheet), latticeOf({ ...cheese().sheet, pitch: 0.011 }));
});

test("the stable step of undamped springs is 2/ω of the stiffest", () => {
  const sheet = { ...cheese().sheet, bending_damping: 0, axial_damping: 0 };
  const mass = sheet.mass / 52;
  const squared = (4 * 2 * sheet.axial_stiffness + (32 * sheet.bending_stiffness) / sheet.pitch ** 2) / mass;
  near(stableTimeStep(sheet), 2 / Math.sqrt(squared), 1e-12);
});

test("a step given is kept, and else the shortest of three is taken", () => {
  assert.equal(timeStep(cheese()), 1e-4);
  assert.equal(timeStep(cheese({ time_step: 3e-5 })), 3e-5);
  near(timeStep(cheese({ motion: { ...cheese().motion, frequency: 1000 } })), 1 / 20_000, 1e-18);
  assert.equal(measuredFrom(cheese({ duration: 2 })), 0.6);
  assert.equal(measuredFrom(cheese({ transient: 0 })), 0);
});

test("a plate period holds 24 samples, and none is further than 2 ms from the next", () => {
  const slow = cheese({ motion: { ...cheese().motion, frequency: 5 } });
  assert.equal(strideOf(slow), 20);
  assert.equal(strideOf(cheese()), 17);
  assert.equal(stepsOf(cheese()), 2000);
  assert.equal(samplesOf(cheese()), 118);
  assert.equal(thinningOf(cheese(), 0), 0);
  assert.equal(thinningOf(cheese(), 1 / 60), 10);
});

test("sines of other ratios repeat after a multiple of the period", () => {
  const waves = (...ratios) => ratios.map((ratio) => ({ axis: "z", amplitude: 1e-3, ratio, phase: 0 }));
  assert.equal(periodOf({ frequency: 10, waves: [] }), 0.1);
  assert.equal(periodOf({ frequency: 10, waves: waves(1.5) }), 0.2);
  near(periodOf({ frequency: 10, waves: waves(2 / 3, 0.25) }), 1.2, 1e-15);
});

test("the short form is a stroke and a turn the other way, and what is zero is left out", () => {
  const { motion } = cheese();
  assert.deepEqual(termsOf(motion), [[0, 0.003, 24, 0], [3, -Math.PI / 60, 24, 0]]);
  assert.deepEqual(termsOf({ ...motion, angle: 0 }), [[0, 0.003, 24, 0]]);
});

test("a plate without a smooth start begins where its sines and samples are", () => {
  const motion = {
    ...cheese().motion, ramp: 0, offset: { x: 0.01 },
    waves: [{ axis: "x", amplitude: 0.002, ratio: 1, phase: Math.PI / 2 }],
    samples: { time: [0, 1], x: [0.1, 0] },
  };
  near(poseAtStart(motion)[0], 0.112, 1e-15);
  near(poseAtStart({ ...motion, ramp: 0.1 })[0], 0.01, 0);
});

test("rotations are Rx Ry Rz", () => {
  const [, , sineY, , , minusSineX] = rotationOf([0, 0, 0, 0.3, 0.2, 0.1]);
  near(sineY, Math.sin(0.2), 1e-16);
  near(minusSineX, -Math.sin(0.3) * Math.cos(0.2), 1e-16);
});

test("a sheet lies flat on a plate that is off level, as deep as it is carried", () => {
  const s = cheese({ motion: { ...cheese().motion, offset: { x: 0, y: 0, z: 0.01, rx: 0.1, ry: 0, rz: 0 } } });
  const x = startPositions(s, [0.001, 0, 0.5]);
  const up = [0, -Math.sin(0.1), Math.cos(0.1)];
  const { height } = s.motion;
  const depths = Array.from({ length: 52 }, (_, k) =>
    up.reduce((sum, axis, d) => sum + axis * (x[3 * k + d] - (d === 2 ? 0.01 - height : 0)), 0) - height);
  for (const depth of depths) near(depth, depths[0], 1e-15);
  assert.ok(depths[0] < 0 && depths[0] > -1e-3);
});

test("a natural spline goes through its points, straight at its ends", () => {
  const time = [0, 0.1, 0.25, 0.3];
  const values = [0, 1, -1, 0.5];
  const spline = naturalSpline(time, values);
  time.forEach((t, k) => near(spline(t)[0], values[k], 1e-14));
  const h = 1e-6;
  for (const t of [0, 0.3 - 2 * h]) near((spline(t)[0] - 2 * spline(t + h)[0] + spline(t + 2 * h)[0]) / h ** 2, 0, 0.1);
  near(spline(0.2)[1], (spline(0.2 + 1e-6)[0] - spline(0.2 - 1e-6)[0]) / 2e-6, 1e-4);
});

test("a plate stays where its samples end", () => {
  const table = knotsOf({ time: [0, 0.1], z: [0, 0.01] }, 0.03, Infinity);
  assert.equal(table.length % 12, 0);
  assert.deepEqual([...table.slice(-8, -6)], [0.01, 0]);
});

test("a course keeps what still matters", () => {
  const motion = (stroke) => ({ ...cheese().motion, stroke });
  const first = courseOf(motion(1));
  const second = goneOver(first, motion(2), 1, 0.1);
  const third = goneOver(second, motion(3), 1.05, 0.1);
  assert.deepEqual(third.map((layer) => layer.motion.stroke), [1, 2, 3]);
  assert.deepEqual(stillNeeded(third, 1.2).map((layer) => layer.motion.stroke), [3]);
  assert.equal(stillNeeded(third, 1.1), third);
});

test("a sampled trajectory that stays the same goes on, and another begins", () => {
  const with_ = (x) => ({ ...cheese().motion, samples: { time: [0, 1], x } });
  const course = goneOver(courseOf(with_([0, 1])), with_([0, 1]), 2, 0.1);
  assert.equal(course.at(-1).tableBegin, 0);
  assert.equal(goneOver(course, with_([0, 2]), 3, 0.1).at(-1).tableBegin, 3);
});

test("halves are rounded to the even number", () => {
  assert.deepEqual([0.5, 1.5, 2.5, -0.5, 2.4].map(roundHalfEven).map(Math.abs), [0, 2, 2, 0, 2]);
});

test("a chain's tridiagonal matrix has the eigenvalues of its closed form", () => {
  const m = 12;
  const { values, vectors } = tridiagonalModes(new Array(m).fill(2), new Array(m - 1).fill(-1));
  const sorted = [...values].sort((a, b) => a - b);
  sorted.forEach((value, k) => near(value, 2 - 2 * Math.cos(((k + 1) * Math.PI) / (m + 1)), 1e-13));
  near(vectors[0].reduce((sum, each) => sum + each * each, 0), 1, 1e-13);
});

test("a free strip swings as a beam, and twice as fast where it is four times as stiff", () => {
  const sheet = { ...cheese().sheet, outline: { shape: "rectangle", length: 0.6, width: 0.01 } };
  // ω = (4.73004/L)² √(k_b w/(M/L)), of a beam as long as its nodes stand for.
  const beam = (4.73004 / 0.6) ** 2 * Math.sqrt((sheet.bending_stiffness * 0.01 * 0.6) / sheet.mass);
  near(naturalFrequency(sheet) / beam, 1, 0.02);
  const stiffer = { ...sheet, bending_stiffness: 4 * sheet.bending_stiffness };
  near(naturalFrequency(stiffer) / naturalFrequency(sheet), 2, 1e-12);
});

test("what no stiffness bends has no natural frequency, or none above 0", () => {
  assert.ok(!(naturalFrequency({ ...cheese().sheet, bending_stiffness: 0 }) > 0));
  assert.ok(Number.isNaN(naturalFrequency({ ...cheese().sheet, outline: { shape: "disk", radius: 0.004 } })));
});

test("a wrong scenario is refused for its field, in one line that says what to type", () => {
  const spoilt = [
    ["sheet.mass", (s) => (s.sheet.mass = -1)], ["sheet.pitch", (s) => (s.sheet.pitch = 11)],
    ["sheet.pitch", (s) => (s.sheet.pitch = 1e-4)], ["sheet.outline.radius", (s) => delete s.sheet.outline.radius],
    ["sheet.outline.shape", (s) => (s.sheet.outline = { shape: "__proto__" })],
    ["sheet.outline", (s) => (s.sheet.outline = { shape: "mask", width_of_picture: 0.05, rows: ["##..##"] })],
    ["sheet.outline.rows", (s) => (s.sheet.outline = { shape: "mask", width_of_picture: 0.05, rows: ["..", "..."] })],
    ["sheet.outline.corners", (s) => (s.sheet.outline = { shape: "polygon", corners: [[0, 0], [1, 1], [2, 2]] })],
    ["motion.waves.0.axis", (s) => (s.motion.waves = [{ axis: "w", amplitude: 1, ratio: 1, phase: 0 }])],
    ["motion.samples.time", (s) => (s.motion.samples = { time: [0, 0] })],
    ["motion.samples.x", (s) => (s.motion.samples = { time: [0, 1], x: [0, NaN] })],
    ["friction.kinetic", (s) => (s.friction.kinetic = 0.9)], ["friction.law", (s) => (s.friction.law = "none")],
    ["gravity", (s) => (s.gravity = "9.81")], ["transient", (s) => (s.transient = 1)],
    ["duration", (s) => (s.duration = 1e9)],
    ["motion.frequency", (s) => (s.motion.frequency = 1e12)], ["time_step", (s) => (s.time_step = 0.01)],
    ["plate.width", (s) => (s.plate = { length: 0.1 })], ["start", (s) => (s.start = null)],
    ["motion", (s) => delete s.motion],
  ];
  for (const [field, spoil] of spoilt) {
    const s = structuredClone(cheese());
    spoil(s);
    assert.throws(() => checkScenario(s), (error) => error.field === field && /must be .+; try \S/.test(error.message)
      && !error.message.includes("\n"), field);
  }
  checkScenario(cheese());
});

test("a refusal is told in the unit that people read", () => {
  const s = cheese();
  s.sheet.mass = 13.6;
  const message = "got 13600 g, must be a number above 0 g and at most 10000 g; try 13.6 g";
  assert.throws(() => checkScenario(s), { message });
});
