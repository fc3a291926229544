// What one run shows, from its recording to plain numbers. As the package's simulation/observation.py.
import { periodOf } from "../model/motion.js";
import { measuredFrom } from "../model/scenario.js";
import { latticeOf } from "../model/sheet.js";
import { energyLedger, leastEnergy } from "./energy.js";
import {
  firstFailure, gait, periodMaxima, periodMeans, rotation, soundUntil, spinRate, twist, wholePeriods,
} from "./observables.js";
import { measureAll } from "./registry.js";

/**
 * Measure a recording over whole plate periods, from the end of the transient to its end or its failure.
 *
 * @param scenario plain JSON, SI
 * @param recording {channels: {name: Float32Array | Float64Array}, diverged}
 * @returns {{spin: {rate, low, high, settled, sd}, gait, failure: null | {kind, time, first_sign}, energy, values}}
 */
export const observe = (scenario, recording) => {
  const { channels } = recording;
  const period = periodOf(scenario.motion);
  const from = measuredFrom(scenario);
  const plateSize = scenario.plate ? [scenario.plate.length, scenario.plate.width] : null;
  const failure = firstFailure(channels, period, scenario.slip_limit, plateSize, recording.diverged);
  const energy = energyLedger(channels, least(scenario));
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

/** Energy too small to matter in the ledger of a scenario, J. */
export const least = ({ sheet, gravity }) => {
  const { rest } = latticeOf(sheet);
  const sides = [0, 1].map((axis) => {
    const along = rest.filter((_, i) => i % 2 === axis);
    return along.reduce((most, place) => Math.max(most, place), -Infinity) - along.reduce((low, place) => Math.min(low, place), Infinity);
  });
  return leastEnergy(sheet.mass * gravity, (Math.max(...sides) + 1) * sheet.pitch);
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
