// The Lorentz fit on curves whose answer is known; the package's own numbers are compared in tests/agreement.
import assert from "node:assert/strict";
import { test } from "node:test";
import { chiSquareUpper, fisherQuantile, studentQuantile } from "../src/curve/distributions.js";
import { fitLorentzian, lorentzian } from "../src/curve/lorentz.js";
import { leastSquares, rootBetween } from "../src/curve/minimise.js";
import { endsInFailure, fittedPoints } from "../src/curve/points.js";
import { measuredAs } from "../src/curve/protocol.js";

const near = (got, want, share = 1e-6) => assert.ok(Math.abs(got - want) <= share * Math.abs(want), `${got}, not ${want}`);
const FREQUENCY = Array.from({ length: 15 }, (_, i) => 16 + i);

test("quantiles are those of the tables", () => {
  near(studentQuantile(1, 0.975), 12.7062047364, 1e-9);
  near(studentQuantile(27, 0.975), 2.05183051648, 1e-9);
  near(fisherQuantile(1, 2, 0.99), 98.5025125628, 1e-9);
  near(fisherQuantile(12, 13, 0.99), 3.9603264, 1e-6);
  near(chiSquareUpper(1, 0.01), 6.63489660102, 1e-9);
  near(chiSquareUpper(40, 0.01), 63.6907397515, 1e-9);
});

test("an exact curve gives its numbers, whichever way it turns", () => {
  for (const [peak, f0, halfWidth] of [[600, 24, 5], [-0.01, 17.3, 11], [3e4, 28.9, 2]]) {
    const fit = fitLorentzian(FREQUENCY, FREQUENCY.map((f) => lorentzian(f, peak, f0, halfWidth)));
    near(fit.peak, peak);
    near(fit.f0, f0);
    near(fit.halfWidth, halfWidth);
    assert.ok(fit.r2 > 1 - 1e-10);
  }
});

test("curves without a peak are refused with what to measure", () => {
  const rising = fitLorentzian(FREQUENCY, FREQUENCY.map((f) => lorentzian(f, 600, 40, 8)));
  assert.match(rising.refused, /highest at the last frequency, 30 Hz/);
  assert.match(rising.advice, /beyond 30 Hz/);
  assert.match(fitLorentzian(FREQUENCY, FREQUENCY.map(() => 5)).refused, /all alike/);
  assert.match(fitLorentzian([10, 12, 14], [1, 2, 1]).refused, /3 rates at 3 frequencies/);
  assert.match(fitLorentzian(FREQUENCY, FREQUENCY.map(() => NaN)).refused, /0 rates/);
  assert.match(fitLorentzian([], []).refused, /0 rates/);
  assert.match(fitLorentzian([0, 1, 2, 3], [1, 3, 2, 1]).refused, /not above 0 Hz/);
});

test("the scatter of a curve is in its intervals", () => {
  const rate = FREQUENCY.map((f, i) => lorentzian(f, 600, 24, 5) + 12 * Math.sin(7 * i * i));
  const fit = fitLorentzian(FREQUENCY, rate);
  for (const [interval, value] of [[fit.peakInterval, 600], [fit.f0Interval, 24], [fit.halfWidthInterval, 5]]) {
    assert.ok(interval[0] < value && value < interval[1]);
  }
  const sure = fitLorentzian(FREQUENCY, rate, { sd: FREQUENCY.map(() => 1e3) });
  assert.equal(sure.scatter ?? "refused", "refused", "nothing can be said of rates that are known to 1000");
});

test("three failures end a curve, one does not", () => {
  const points = [1, 1, 0, 1, 0, 0, 0, 1].map((sound, i) => ({ frequency: 10 + i, rate: 1, failed: !sound }));
  assert.deepEqual(fittedPoints(points), [true, true, false, true, false, false, false, false]);
  assert.ok(endsInFailure(points));
  const shuffled = [...points].reverse();
  assert.deepEqual(fittedPoints(shuffled), fittedPoints(points).reverse());
  assert.ok(!endsInFailure(points.slice(0, 4)));
});

test("a measurement leaves out half of a short run at most", () => {
  const scenario = measuredAs({ name: "a", slip_limit: 0.01 }, { duration: 1, transient: 0.6, slip_limit: 0.02 });
  assert.deepEqual(scenario, { name: "a", duration: 1, transient: 0.5, slip_limit: 0.02 });
});

test("least squares of rows that do not tell everything is the shortest", () => {
  assert.deepEqual(leastSquares([[0, 2], [0, 0]], [5, 4]).map((x) => Math.round(1e9 * x) / 1e9), [2, 0]);
  near(rootBetween((x) => x ** 3 - 2, 0, 4, 1e-12), Math.cbrt(2), 1e-11);
});
