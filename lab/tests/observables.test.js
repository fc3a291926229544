// Closed forms of what a motion shows; the package's own numbers are compared in tests/agreement.
import assert from "node:assert/strict";
import { test } from "node:test";
import { starts, together } from "../src/simulation/ensemble.js";
import { energyLedger } from "../src/simulation/energy.js";
import { firstFailure, gait, rotation, slip, spinRate, twist } from "../src/simulation/observables.js";
import { roundHalfEven } from "../src/simulation/samples.js";

const PERIOD = 1 / 24;
const time = Float64Array.from({ length: 1201 }, (_, i) => i / 600);
const swinging = (rate) => time.map((t) => rate * t + 0.2 * Math.sin((2 * Math.PI * t) / PERIOD));

test("a swing within each period does not touch the spin rate", () => {
  const spin = spinRate(time, swinging(3), PERIOD, 0.5, 2);
  assert.ok(Math.abs(spin.rate - 3) < 1e-9);
  assert.ok(spin.settled && spin.low <= spin.rate && spin.rate <= spin.high);
  assert.ok(Number.isNaN(spinRate(time, swinging(3), PERIOD, 1.95, 2).rate));
});

test("a rotation has no jumps, however far it goes", () => {
  const angle = swinging(9);
  const back = rotation(angle.map(Math.sin), angle.map(Math.cos));
  back.forEach((value, i) => assert.ok(Math.abs(value - angle[i]) < 1e-9));
});

test("a straight way has its velocity and no covariance", () => {
  const { mean, covariance } = twist(time, [time.map((t) => 0.1 * t), time.map((t) => -0.2 * t), time], PERIOD, 0, 2);
  [0.1, -0.2, 1].forEach((value, i) => assert.ok(Math.abs(mean[i] - value) < 1e-9));
  assert.ok(covariance.flat().every((value) => Math.abs(value) < 1e-15));
});

test("gaits are the dissertation's", () => {
  assert.equal(gait([1, 1], [1, 1], [0, 0]), "sliding");
  assert.equal(gait([0.5, 1], [1, 0.4], [0, 0]), "walking");
  assert.equal(gait([0.5, 0.5], [0.4, 0.4], [0.1, 0.1]), "running");
  assert.equal(gait([], [], []), "");
});

test("a swing is no slip, a way is", () => {
  const x = time.map((t) => 0.004 * Math.sin((2 * Math.PI * t) / PERIOD));
  const still = new Float64Array(time.length);
  const middle = slip(time, x, still, PERIOD).subarray(100, 1100);
  // The window holds one sample more than a period of 25: 1/26 of the swing is left.
  assert.ok(middle.every((way) => way < 0.004 / 20));
  const channels = { time, centre_x: time.map((t) => 0.02 * t), centre_y: still };
  const failure = firstFailure(channels, PERIOD, 0.01);
  assert.equal(failure.kind, "slipped");
  assert.ok(Math.abs(failure.time - 0.5) < 0.01);
  const off = firstFailure(channels, PERIOD, 0.01, [0.06, 0.1]);
  assert.equal(off.kind, "left the plate");
  assert.equal(off.first_sign, failure.time);
});

test("what ceases to be finite has diverged before it", () => {
  const still = new Float64Array(time.length);
  const channels = { time, centre_x: still, centre_y: still, kinetic_energy: still.map((_, i) => (i < 600 ? 0 : Infinity)) };
  assert.deepEqual(firstFailure(channels, PERIOD, 0.01), { kind: "diverged", time: time[599], first_sign: Infinity });
});

test("books that balance close, and a loss that gives energy back does not", () => {
  const names = ["kinetic", "gravity", "axial", "bending", "torsion", "contact"].map((name) => `${name}_energy`);
  const books = () =>
    Object.fromEntries(["time", "contact_work", "joint_loss", "friction_loss", "plate_work", ...names].map((name) =>
      [name, new Float64Array(10)]));
  const channels = books();
  channels.plate_work.fill(1, 1);
  channels.friction_loss.fill(1, 1);
  const ledger = energyLedger(channels);
  assert.ok(ledger.closes && ledger.imbalance === 0 && ledger.plateWork === 9);
  channels.friction_loss.fill(-1, 1);
  assert.ok(!energyLedger(channels).closes);
  assert.ok(energyLedger(books()).closes);
});

test("half of the runs failing is a failed point, and failed runs are in no mean", () => {
  const run = (rate, failure = null, kind = "walking") =>
    ({ spin: { rate, low: rate, high: rate, sd: 0, settled: true }, gait: kind, failure, values: { energy_residual: -rate } });
  const slipped = { kind: "slipped", time: 1, first_sign: Infinity };
  const [half, third] = together([[run(1), run(5, slipped)], [run(1), run(3, null, "running"), run(9, slipped)]]);
  assert.ok(half.failed && half.rate === 1 && half.failure === "slipped" && half.failureTime === 1);
  assert.ok(!third.failed && third.partlyFailed && third.rate === 2 && third.gait === "running");
  assert.equal(third.values.energy_residual, -9);
});

test("starts are the nominal one and others of the told spread", () => {
  const drawn = starts(4001, 3).slice(1);
  assert.deepEqual(starts(1, 7), [[0, 0, 0]]);
  assert.deepEqual(starts(5, 3), starts(9, 3).slice(0, 5));
  assert.notDeepEqual(starts(2, 3)[1], starts(3, 2)[2]);
  [1e-4, 1e-4, Math.PI / 180].forEach((spread, axis) => {
    const values = drawn.map((start) => start[axis] / spread);
    const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
    const variance = values.reduce((sum, value) => sum + (value - mean) ** 2, 0) / values.length;
    // Four standard errors of 4,000 draws.
    assert.ok(Math.abs(mean) < 4 / Math.sqrt(4000) && Math.abs(variance - 1) < 4 * Math.sqrt(2 / 4000));
  });
});

test("halves go to the even number", () => {
  assert.deepEqual([0.5, 1.5, 2.5, 2.4, 3.5, 3].map(roundHalfEven), [0, 2, 2, 2, 4, 3]);
});
