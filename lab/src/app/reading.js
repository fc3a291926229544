// What a live sheet shows now: rate, gait, drift, failure, from the samples so far, by the package's own definitions.
import { firstFailure, gait, periodMeans, rotation, slip, spinRate, twist } from "../simulation/observables.js";
import { periodOf } from "../model/motion.js";

const PERIODS = 12; // that a rate is taken over while a sheet lives
const LEAST = 0.4; // s

/**
 * @param {object} scenario
 * @param {import("./history.js").Samples} samples
 * @param {boolean} diverged
 */
export function reading(scenario, samples, diverged) {
  const period = periodOf(scenario.motion);
  const all = samples.all();
  const n = samples.length;
  const empty = { rate: NaN, low: NaN, high: NaN, gait: "", drift: NaN, failure: null, twist: [NaN, NaN, NaN], time: 0 };
  if (n < 4) return empty;
  const end = all.time[n - 1];
  const size = scenario.plate ? [scenario.plate.length, scenario.plate.width] : null;
  const failure = firstFailure(all, period, scenario.slip_limit, size, diverged);
  const span = Math.max(LEAST, PERIODS * period);
  const start = Math.max(0, end - span);
  const recent = samples.from(samples.indexAfter(start - period));
  const angle = rotation(recent.spin_cross, recent.spin_dot);
  const spin = spinRate(recent.time, angle, period, start, end);
  const legs = ["left_contact", "right_contact", "flight"].map((name) =>
    periodMeans(recent.time, recent[name], period, start, end));
  const drifts = slip(all.time, all.centre_x, all.centre_y, period);
  // The swing of the last half period is not averaged out yet.
  let whole = n - 1;
  while (whole > 0 && all.time[whole] > end - period / 2) whole--;
  const moves = [recent.centre_x, recent.centre_y, angle];
  return {
    rate: spin.rate, low: spin.low, high: spin.high, time: end, gait: gait(...legs),
    drift: drifts[whole], failure, twist: Array.from(twist(recent.time, moves, period, start, end).mean),
  };
}

const DEG = Math.PI / 180;

/** A reading in a few words. */
export function inWords(read) {
  if (!(read.time > 0)) return "starting";
  const parts = [];
  if (read.failure) parts.push(`${read.failure.kind} at ${read.failure.time.toFixed(2)} s`);
  if (read.gait) parts.push(read.gait);
  parts.push(Number.isFinite(read.rate) ? `${(read.rate / DEG).toFixed(0)} °/s` : "no rate yet");
  return parts.join(" · ");
}
