// What one run shows, from its recording to plain numbers. As the package's simulation/observation.py.
import { energyLedger, leastEnergy } from "./energy.js";
import {
  firstFailure, gait, periodMaxima, periodMeans, rotation, soundUntil, spinRate, twist, wholePeriods,
} from "./observables.js";
import { measureAll } from "./registry.js";

/** Time after which the plate's sines repeat, s: a multiple of its period where ratios are not whole. */
export const platePeriod = ({ frequency, waves }) => {
  const denominators = (waves ?? []).filter(({ ratio }) => (ratio ?? 1) !== 1).map(({ ratio }) => denominatorOf(ratio));
  return Math.min(denominators.reduce(leastCommonMultiple, 1) / frequency, 1e300);
};

/** Denominator of the nearest fraction with one of at most 12. */
const denominatorOf = (ratio) => {
  let [nearest, least] = [1, Infinity];
  for (let q = 1; q <= 12; q++) {
    const off = Math.abs(ratio - Math.round(ratio * q) / q);
    if (off < least) [nearest, least] = [q, off];
  }
  return nearest;
};

const leastCommonMultiple = (a, b) => (a / greatestCommonDivisor(a, b)) * b;
const greatestCommonDivisor = (a, b) => (b === 0 ? a : greatestCommonDivisor(b, a % b));

/** Time from which a scenario is measured, s. */
export const measuredSince = ({ duration, transient }) => transient ?? 0.3 * duration;

/**
 * Measure a recording over whole plate periods, from the end of the transient to its end or its failure.
 *
 * @param scenario plain JSON, SI
 * @param recording {channels: {name: Float32Array | Float64Array}, diverged}
 * @param size longer side of the sheet's lattice, m: what its ledger counts as too little to matter
 * @returns {{spin: {rate, low, high, settled, sd}, gait, failure: null | {kind, time, first_sign}, energy, values}}
 */
export const observe = (scenario, recording, size = 0) => {
  const { channels } = recording;
  const period = platePeriod(scenario.motion);
  const from = measuredSince(scenario);
  const plateSize = scenario.plate ? [scenario.plate.length, scenario.plate.width] : null;
  const failure = firstFailure(channels, period, scenario.slip_limit, plateSize, recording.diverged);
  const energy = energyLedger(channels, leastEnergy(scenario.sheet.mass * scenario.gravity, size));
  const end = soundUntil(channels.time, failure);
  const angle = rotation(channels.spin_cross, channels.spin_dot);
  const window = windowOf(channels, angle, period, from, end, energy);
  const legs = ["left_contact", "right_contact", "flight"].map(window.means);
  return {
    spin: spinRate(channels.time, angle, period, from, end),
    gait: gait(...legs),
    failure,
    energy,
    values: measureAll(window),
  };
};

/** What observables are measured from: whole plate periods, as many as there are from the end of the transient. */
const windowOf = (channels, angle, period, from, end, energy) => {
  const start = end - Math.max(0, wholePeriods(period, from, end)) * period;
  const { time } = channels;
  return {
    channels,
    period,
    start,
    end,
    energy,
    twist: twist(time, [channels.centre_x, channels.centre_y, angle], period, start, end),
    means: (name) => periodMeans(time, channels[name], period, start, end),
    maxima: (name) => periodMaxima(time, channels[name], period, start, end),
  };
};
