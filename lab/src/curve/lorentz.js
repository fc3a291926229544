// The Lorentz line shape of a spin curve, equation (5.5), and its fit (section 5.3.2): the package's curve/lorentz.py.
import { chiSquareUpper, fisherQuantile, studentQuantile } from "./distributions.js";
import { leastSquares, minimise, normalMatrix, pseudoInverse, rootBetween } from "./minimise.js";
import { anywhere, digits, distinct, unseenPeak, unseenTop } from "./peak.js";

// How far an end of an interval is sought: a factor 100 in peak and half width, one and a half spans in f0.
const REACH = [Math.log(100), 1.5, Math.log(100)];
const LIMIT = 40; // scaled parameters stay within ±40, e^40 in peak and half width: no overflow
const EVALUATIONS = 100; // of one minimisation
const CONFIDENCE = 0.95;
const NORMAL = 1.959963984540054; // within as many standard deviations lie 95 % of a normal distribution
const SIGNIFICANCE = 0.01; // of the tests that reject a given sd, or a peak
const ROUNDING = 1e-24; // share of the squared rates under which squared residuals are rounding

const sum = (values) => values.reduce((total, value) => total + value, 0);
const squares = (values) => values.reduce((total, value) => total + value * value, 0);
const clipped = (value) => Math.min(Math.max(value, -LIMIT), LIMIT);

/** Spin rate of the line at a frequency, Hz, in the unit of the peak. */
export const lorentzian = (frequency, peak, f0, halfWidth) => peak / (1 + ((frequency - f0) / halfWidth) ** 2);

/**
 * Fit (5.5) to a spin curve by least squares (Levenberg and Marquardt).
 *
 * @param frequency (n,) Hz, in any order, repeats allowed
 * @param rate (n,) in any unit; NaN or null leaves a point out
 * @param sd standard deviation of each rate: weights the points, and sizes the intervals where they bear it
 * @param endsInFailure whether the object ran off at the next higher frequency: then a curve may end at its peak
 * @returns {{peak, f0, halfWidth, r2, nPoints, peakInterval, f0Interval, halfWidthInterval, method, scatter}} or, where
 *   the curve does not show its peak, {{refused, advice}}: why not, and what to measure
 */
export const fitLorentzian = (frequency, rate, { sd = null, endsInFailure = false } = {}) => {
  const points = pointsOf(frequency, rate, sd);
  if (points.refused) return points;
  const { f, y, sds } = points;
  const top = unseenTop(f, y, endsInFailure);
  if (top) return noPeak(f, y, top);
  const curve = curveOf(f, y, sds);
  const { p: best, cost } = bestOf(curve, startsOf(curve));
  const [peak, f0, halfWidth] = inUnits(curve, best);
  const unseen = unseenPeak(f, y, f0, halfWidth, endsInFailure);
  if (unseen) return noPeak(f, y, unseen, f0);
  if (hasRival(curve, cost, endsInFailure)) return noPeak(f, y, "a curve that a straight line or an exponential fits better");
  const { threshold, sdHolds } = thresholdOf(cost, f.length - 3, sd !== null);
  const { ends, method } = intervalsOf(curve, best, cost, threshold);
  const units = [inUnits(curve, ends.map(([low]) => low)), inUnits(curve, ends.map(([, high]) => high))];
  const [peakInterval, f0Interval, halfWidthInterval] = [0, 1, 2].map((i) => units.map((each) => each[i]).sort((a, b) => a - b));
  const open = unbounded(f, peakInterval, f0Interval, halfWidthInterval, endsInFailure);
  if (open) return noPeak(f, y, open, f0);
  return {
    peak, f0, halfWidth, r2: 1 - cost / spreadOf(curve), nPoints: f.length,
    peakInterval, f0Interval, halfWidthInterval, method, scatter: sdHolds ? "given" : "residual",
  };
};

/** Frequencies, rates and their sd (alike if not given) of the points that have a rate, or why they cannot be fitted. */
const pointsOf = (frequency, rate, sd) => {
  const has = Array.from(rate, (value) => value !== null && !Number.isNaN(value));
  const kept = (values) => Array.from(values).filter((_, i) => has[i]);
  const [f, y] = [kept(frequency), kept(rate)];
  const largest = Math.max(0, ...y.map(Math.abs));
  const sds = sd ? kept(sd) : y.map(() => largest || 1);
  if (f.some((value) => !(value > 0 && value < Infinity))) {
    return { refused: "a frequency that is not above 0 Hz", advice: "frequencies above 0 Hz" };
  }
  if (y.some((value) => !Number.isFinite(value))) return { refused: "an infinite rate", advice: "leaving it out" };
  if (sds.some((value) => !(value > 0 && value < Infinity))) {
    return { refused: "a standard deviation that is not above 0", advice: "leaving it out" };
  }
  const count = distinct(f).length;
  if (count < 4) {
    return { refused: `${f.length} rates at ${count} frequencies, where four are needed`, advice: "more frequencies" };
  }
  if (Math.max(...y) - Math.min(...y) <= 1e-12 * largest) {
    return { refused: "rates that are all alike", advice: "frequencies where the object spins" };
  }
  return { f, y, sds };
};

/** Refusal that says where to measure more: about the peak that the line has, or else about the highest rate. */
const noPeak = (f, y, refused, f0 = null) => {
  const [low, high] = [Math.min(...f), Math.max(...f)];
  const highest = f[y.reduce((best, value, i) => (Math.abs(value) > Math.abs(y[best]) ? i : best), 0)];
  const near = f0 === null ? highest : Math.min(Math.max(f0, low), high);
  const side = near === high ? "beyond" : near === low ? "below" : "around";
  return { refused, advice: `adding frequencies ${side} ${digits(near, 4)} Hz` };
};

/** Points to fit, in scaled terms: rates over the largest, frequencies from their middle in spans. */
const curveOf = (f, y, sds) => {
  const largest = y.reduce((best, value) => (Math.abs(value) > Math.abs(best) ? value : best), y[0]);
  const [low, high] = [Math.min(...f), Math.max(...f)];
  const [centre, span] = [(low + high) / 2, high - low];
  return {
    largest, centre, span, x: f.map((value) => (value - centre) / span), v: y.map((value) => value / largest),
    w: sds.map((value) => Math.abs(largest) / value),
  };
};

/** Peak, f0 and half width of scaled parameters (ln |peak|, f0, ln half width). */
const inUnits = ({ largest, centre, span }, p) => [largest * Math.exp(p[0]), centre + span * p[1], span * Math.exp(p[2])];

/** Points to start from: the guess by the inverse of (5.5), which is a parabola, and the largest rate. */
const startsOf = ({ x, v }) => {
  const top = v.reduce((best, value, i) => (Math.abs(value) > Math.abs(v[best]) ? i : best), 0);
  const about = x.map((value) => value - x[top]);
  const plain = [0, x[v.indexOf(Math.max(...v))], Math.log(0.25)];
  const [c0, c1, c2] = leastSquares([0, 1, 2].map((power) => about.map((value, i) => v[i] ** 2 * value ** power)), v);
  const base = c2 > 0 ? c0 - c1 ** 2 / (4 * c2) : 0;
  if (!(base > 0)) return [[0, x[top], Math.log(0.25)], plain];
  return [[-Math.log(base), x[top] - c1 / (2 * c2), Math.log(base / c2) / 2], plain];
};

const residualOf = ({ x, v, w }, p) => {
  const [peak, halfWidth] = [Math.exp(clipped(p[0])), Math.exp(clipped(p[2]))];
  return Float64Array.from(x, (value, i) => w[i] * (peak / (1 + ((value - p[1]) / halfWidth) ** 2) - v[i]));
};

/** Derivatives of the residuals by each parameter, one column (n,) each. */
const jacobianOf = ({ x, w }, p) => {
  const [peak, halfWidth] = [Math.exp(clipped(p[0])), Math.exp(clipped(p[2]))];
  const columns = [0, 1, 2].map(() => new Float64Array(x.length));
  for (let i = 0; i < x.length; i++) {
    const u = (x[i] - p[1]) / halfWidth;
    const line = (w[i] * peak) / (1 + u * u);
    const common = (line * 2 * u) / (1 + u * u);
    columns[0][i] = line;
    columns[1][i] = common / halfWidth;
    columns[2][i] = common * u;
  }
  return columns;
};

/** Lowest of the minima reached from `starts`, one parameter held if asked: parameters and weighted sum of squares. */
const bestOf = (curve, starts, held = -1) => {
  const minima = starts.map((start) => {
    const free = [0, 1, 2].filter((i) => i !== held);
    const whole = (part) => start.map((value, i) => (i === held ? value : part[free.indexOf(i)]));
    const { p, cost } = minimise(
      (part) => residualOf(curve, whole(part)),
      (part) => jacobianOf(curve, whole(part)).filter((_, i) => i !== held),
      free.map((i) => start[i]), EVALUATIONS,
    );
    return { p: whole(p).map(clipped), cost };
  });
  return minima.reduce((best, minimum) => (minimum.cost < best.cost ? minimum : best));
};

/** Weighted sum of squares about the weighted mean. */
const spreadOf = ({ v, w }) => {
  const weights = w.map((value) => value ** 2);
  const mean = sum(v.map((value, i) => weights[i] * value)) / sum(weights);
  return squares(v.map((value, i) => w[i] * (value - mean)));
};

/** Whether a line without a peak does as well as one of this cost, by an F test at 1 %. */
const hasRival = (curve, cost, endsInFailure) => {
  const [freedom, rivals] = [curve.x.length - 3, curve.x.length - 2];
  const least = monotoneCost(curve, endsInFailure) / rivals;
  return cost / freedom > fisherQuantile(freedom, rivals, 1 - SIGNIFICANCE) * least;
};

/** Weighted sum of squares of the best of a constant, a straight line and an exponential; falling ones only if asked. */
const monotoneCost = (curve, fallingOnly) => {
  const { x, v, w } = curve;
  const line = (weights, values) =>
    leastSquares([weights, x.map((value, i) => weights[i] * value)], values.map((value, i) => weights[i] * value));
  const positive = v.map((value) => Math.max(value, 0));
  const straight = line(w, v);
  const power = line(w.map((value, i) => value * positive[i]), positive.map((value) => (value > 0 ? Math.log(value) : 0)));
  const rivals = [
    [straight, (value) => straight[0] + straight[1] * value],
    [power, (value) => Math.exp(power[0] + power[1] * value)],
  ].filter(([[, slope]]) => slope <= 0 || !fallingOnly);
  return Math.min(spreadOf(curve), ...rivals.map(([, of]) => squares(x.map((value, i) => w[i] * (of(value) - v[i])))));
};

/** Rise of the cost at an interval's ends, and whether it rests on the sd as given rather than on the residuals. */
const thresholdOf = (cost, freedom, sdIsKnown) => {
  if (sdIsKnown && cost <= chiSquareUpper(freedom, SIGNIFICANCE)) return { threshold: NORMAL ** 2, sdHolds: true };
  return { threshold: (cost / freedom) * studentQuantile(freedom, (1 + CONFIDENCE) / 2) ** 2, sdHolds: false };
};

/** Ends of each parameter where its profile rises by `threshold`, and how they were found. */
const intervalsOf = (curve, best, cost, threshold) => {
  const covariance = pseudoInverse(normalMatrix(jacobianOf(curve, best)));
  const wald = best.map((_, i) => Math.sqrt(Math.max(covariance[i][i], 0) * threshold));
  if (threshold <= ROUNDING * squares(curve.v.map((value, i) => curve.w[i] * value))) {
    return { ends: best.map((value, i) => [value - wald[i], value + wald[i]]), method: "covariance" };
  }
  const ends = best.map((_, i) => [-1, 1].map((side) => profileEnd(curve, best, cost, threshold, i, side, wald[i])));
  return { ends, method: "profile likelihood" };
};

/** Where the cost, minimised over the other two parameters, has risen by `threshold`; infinite if nowhere. */
const profileEnd = (curve, best, cost, threshold, i, side, wald) => {
  let nearest = best;
  const known = new Map();
  const rise = (step) => {
    if (known.has(step)) return known.get(step);
    const starts = [best, nearest].map((start) => start.with(i, best[i] + side * step));
    const minimum = bestOf(curve, starts, i);
    nearest = minimum.p;
    known.set(step, Math.sqrt(Math.max(minimum.cost - cost, 0)) - Math.sqrt(threshold));
    return known.get(step);
  };
  let [inside, outside] = [0, Math.min(Math.max(wald, 1e-9), REACH[i])];
  while (rise(outside) < 0) {
    if (outside === REACH[i]) return side * Infinity;
    [inside, outside] = [outside, Math.min(2 * outside, REACH[i])];
  }
  return best[i] + side * rootBetween(rise, inside, outside, 1e-5 * outside);
};

/** What the intervals leave open, if anything. */
const unbounded = (f, peaks, centres, widths, endsInFailure) => {
  const each = distinct(f);
  const low = each[0] - (each[1] - each[0]) / 2;
  const high = each.at(-1) + (each.at(-1) - each.at(-2)) / 2;
  const inside = low <= centres[0] && (endsInFailure || centres[1] <= high);
  if (!(inside && centres[1] - centres[0] <= each.at(-1) - each[0])) {
    return `a peak ${anywhere(...centres, 4)}`;
  }
  if (![...peaks, ...widths].every(Number.isFinite) || widths[0] === 0) {
    return `a half width ${anywhere(...widths, 2)}`;
  }
  return null;
};
