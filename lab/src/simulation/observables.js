// What a motion shows: spin rate, gait, failure, drift. The rules of the package's simulation/observables.py.
import { interpolate, mean, placeOfLargest, roundHalfEven, student95, unwrap } from "./samples.js";

export const GAITS = ["sliding", "walking", "running"];
export const FAILURES = ["slipped", "turned over", "folded", "left the plate", "diverged"];

// A leg counts as off the plate in a period when it is so for longer than this share of it.
const SHORTEST_STRIDE = 0.01;
// A sheet is folded when its halves hide this much of its area from its own mean plane.
const FOLDED_AREA = 0.5;
// Centre this far below the plate's surface, m: no sheet that the plate carries lies so deep in it.
const HANGING_DEPTH = 1e-3;
// Blocks of whole periods that the spin rate's interval is made from.
const BLOCKS = 8;
// A run has settled when its two halves agree within this share, or within this rate.
const SETTLED_SHARE = 0.05;
const SETTLED_RATE = (2 * Math.PI) / 180;

/** Whole plate periods between two times. */
export const wholePeriods = (period, start, end) => Math.floor((end - start) / period + 1e-6);

/** Unwrapped best-fit rotation in the plate frame, rad, from the sums of X0 × p and X0 · p. */
export const rotation = (cross, dot) => unwrap(Float64Array.from(cross, (value, i) => Math.atan2(value, dot[i])));

/**
 * Turn over whole plate periods between two times, over the time they take, rad/s: rate, its 95 % interval from up to
 * eight blocks of periods, their standard deviation, and whether the two halves agree. NaN for fewer than two periods.
 */
export const spinRate = (time, angle, period, start, end) => {
  const periods = wholePeriods(period, start, end);
  if (!(periods >= 2) || time.length < 4) return { rate: NaN, low: NaN, high: NaN, settled: false, sd: NaN };
  const from = end - periods * period;
  const blocks = Math.min(BLOCKS, periods);
  const edges = Array.from({ length: blocks + 1 }, (_, i) => from + period * roundHalfEven((i * periods) / blocks));
  const at = edges.map((edge) => interpolate(edge, time, angle));
  const weights = edges.slice(1).map((edge, i) => edge - edges[i]);
  const slopes = weights.map((weight, i) => (at[i + 1] - at[i]) / weight);
  const total = weights.reduce((sum, weight) => sum + weight, 0);
  const average = (values) => values.reduce((sum, value, i) => sum + weights[i] * value, 0) / total;
  const rate = average(slopes);
  const spread = Math.sqrt((average(slopes.map((slope) => (slope - rate) ** 2)) * blocks) / (blocks - 1));
  const half = (student95(blocks - 1) * spread) / Math.sqrt(blocks);
  // The first and the last whole periods, as many as half the window holds.
  const span = Math.floor(periods / 2) * period;
  const rateFrom = (a) => (interpolate(a + span, time, angle) - interpolate(a, time, angle)) / span;
  const settled = Math.abs(rateFrom(end - span) - rateFrom(from)) <= Math.max(SETTLED_SHARE * Math.abs(rate), SETTLED_RATE);
  return { rate, low: rate - half, high: rate + half, settled, sd: spread };
};

/**
 * Mean velocity over whole plate periods between two times, and its covariance from stride to stride.
 * `moves`: centre along and across the bar, m, and unwrapped rotation, rad. NaN for fewer than two periods.
 */
export const twist = (time, moves, period, start, end) => {
  const periods = wholePeriods(period, start, end);
  if (!(periods >= 2) || time.length < 4) {
    return { mean: [NaN, NaN, NaN], covariance: [0, 1, 2].map(() => [NaN, NaN, NaN]) };
  }
  const edges = Array.from({ length: periods + 1 }, (_, i) => end - period * (periods - i));
  const strides = moves.map((move) => {
    const at = edges.map((edge) => interpolate(edge, time, move));
    return Float64Array.from({ length: periods }, (_, i) => (at[i + 1] - at[i]) / (edges[i + 1] - edges[i]));
  });
  const means = strides.map(mean);
  const covariance = strides.map((one, a) =>
    strides.map((other, b) => {
      let sum = 0;
      for (let i = 0; i < periods; i++) sum += (one[i] - means[a]) * (other[i] - means[b]);
      return sum / (periods - 1);
    }),
  );
  return { mean: means, covariance };
};

/** Calls `take(period's number, value)` for every sample within whole plate periods; how many periods there are. */
const inPeriods = (time, values, period, start, end, take) => {
  const count = Math.max(0, wholePeriods(period, start, end)) || 0;
  for (let i = 0; i < time.length; i++) {
    const index = Math.floor((time[i] - start) / period - 1e-9);
    if (time[i] > start && index >= 0 && index < count) take(index, values[i]);
  }
  return count;
};

/** Mean of the samples of each whole plate period between two times. */
export const periodMeans = (time, values, period, start, end) => {
  const sums = [];
  const numbers = [];
  const count = inPeriods(time, values, period, start, end, (index, value) => {
    sums[index] = (sums[index] ?? 0) + value;
    numbers[index] = (numbers[index] ?? 0) + 1;
  });
  return Float64Array.from({ length: count }, (_, i) => (sums[i] ?? 0) / Math.max(numbers[i] ?? 0, 1));
};

/** Largest sample of each whole plate period between two times; NaN where one has none. */
export const periodMaxima = (time, values, period, start, end) => {
  const largest = [];
  const count = inPeriods(time, values, period, start, end, (index, value) => {
    const before = largest[index] ?? -Infinity;
    largest[index] = value > before || Number.isNaN(value) ? value : before;
  });
  return Float64Array.from({ length: count }, (_, i) => (Number.isFinite(largest[i]) ? largest[i] : NaN));
};

/**
 * Gait of most periods by the dissertation's definition (section 4.3), from each period's shares in which the left leg
 * touches, the right leg touches, nothing touches; empty where there is no period.
 */
export const gait = (left, right, flight) => {
  if (!flight.length) return "";
  const counts = [0, 0, 0];
  for (let i = 0; i < flight.length; i++) counts[gaitOf(left[i], right[i], flight[i])]++;
  return GAITS[placeOfLargest(counts)];
};

const gaitOf = (left, right, flight) => {
  if (flight > SHORTEST_STRIDE) return 2;
  return Math.min(left, right) < 1 - SHORTEST_STRIDE ? 1 : 0;
};

/** Samples to each side that the mean over a plate period takes. */
const halfPeriod = (time, period) => roundHalfEven(Math.min(period / (time[1] - time[0]) / 2, time.length));

/** Distance of the centre, averaged over the plate period around each time, from where it lay at first, m. */
export const slip = (time, x, y, period) => {
  const n = time.length;
  if (n < 2) return Float64Array.from(x, (value, i) => Math.hypot(value - x[0], y[i] - y[0]));
  const half = halfPeriod(time, period);
  const sums = [x, y].map((values) => {
    const sum = new Float64Array(n + 1);
    for (let i = 0; i < n; i++) sum[i + 1] = sum[i] + values[i];
    return sum;
  });
  return Float64Array.from({ length: n }, (_, i) => {
    // Near the ends the window shrinks to both sides alike, so that no time sees what comes later than its period.
    const reach = Math.min(half, i, n - 1 - i);
    const [dx, dy] = sums.map((sum) => (sum[i + reach + 1] - sum[i - reach]) / (2 * reach + 1));
    return Math.hypot(dx - x[0], dy - y[0]);
  });
};

/** Whether the slip at a sample is averaged over a period: the swing of the last half period may look like a slip. */
export const isAveraged = (time, i, last, period) => time[i] <= time[last] - period / 2 || time[last] < period;

/** Samples before the first at which a channel is not finite. */
const finiteSamples = (channels) => {
  const all = Object.values(channels);
  const n = channels.time.length;
  return all.reduce((finite, values) => {
    for (let i = 0; i < finite; i++) if (!Number.isFinite(values[i])) return i;
    return finite;
  }, n);
};

/**
 * First thing that went wrong in a run, or null: {kind, time, first_sign}. A sheet that slips on its way off the plate
 * is told by where it ended, with the slip as the first sign.
 *
 * @param channels `time`, `centre_x`, `centre_y` and, where known, `centre_z` and `area_x/y/z`
 * @param plateSize [length, width] in m, or null for a plate that never ends
 */
export const firstFailure = (channels, period, slipLimit, plateSize = null, diverged = false) => {
  const { time } = channels;
  const last = finiteSamples(channels);
  const failures = [];
  const sign = (kind, at) => at >= 0 && failures.push({ kind, time: time[at], first_sign: Infinity });
  if (last > 0) {
    const [t, x, y] = [time, channels.centre_x, channels.centre_y].map((values) => values.subarray(0, last));
    const slipped = slip(t, x, y, period);
    sign("slipped", slipped.findIndex((way, i) => way > slipLimit && isAveraged(t, i, last - 1, period)));
  }
  const state = stateOf(channels, plateSize);
  const first = (holds) => {
    for (let i = 0; i < last; i++) if (holds(i)) return i;
    return -1;
  };
  sign("folded", first((i) => state.folded(i) && !state.hanging(i)));
  sign("turned over", first((i) => state.over(i) && !state.hanging(i)));
  sign("left the plate", first((i) => state.beyond(i) || (state.hanging(i) && (state.folded(i) || state.over(i)))));
  if (diverged || last < time.length) sign("diverged", Math.max(last - 1, 0));
  if (!failures.length) return null;
  const earliest = failures.reduce((best, failure) => (failure.time < best.time ? failure : best));
  const left = earliest.kind === "slipped" && failures.find(({ kind }) => kind === "left the plate");
  return left ? { ...left, first_sign: earliest.time } : earliest;
};

/** What a sheet is like at a sample: folded, turned over, beyond the plate's edge, hanging below it. */
const stateOf = (channels, plateSize) => {
  const { centre_x: x, centre_y: y, centre_z: z, area_x: ax, area_y: ay, area_z: az } = channels;
  const never = () => false;
  const told = az && az[0] > 0;
  const size = (i) => Math.hypot(ax[i], ay[i], az[i]);
  return {
    folded: told ? (i) => size(i) < FOLDED_AREA : never,
    over: told ? (i) => size(i) >= FOLDED_AREA && az[i] < 0 : never,
    beyond: plateSize ? (i) => Math.abs(x[i]) > plateSize[0] / 2 || Math.abs(y[i]) > plateSize[1] / 2 : never,
    hanging: plateSize && z ? (i) => z[i] < -HANGING_DEPTH : never,
  };
};

/** End of what can be measured, s. */
export const soundUntil = (time, failure) =>
  failure ? Math.min(failure.time, failure.first_sign) : time[time.length - 1];
