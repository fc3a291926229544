// Tables of a sampled trajectory for the core: position and speed on each axis, from natural cubic splines.
import { AXES } from "./motion.js";
import { Refusal } from "./refusal.js";

const MOST_KNOTS = 2_000_000;

/** Position and speed every `step` s, [n][12], to a knot past `end` or past the last sample, whichever is first. */
export function knotsOf(samples, step, end) {
  const last = samples.time.at(-1);
  const n = Math.ceil((Math.min(last, end) + 2 * step) / step);
  if (!(n <= MOST_KNOTS))
    throw new Refusal(
      "motion.samples",
      `${n} knots`,
      `at most ${MOST_KNOTS}`,
      "samples further apart, or a shorter run",
    );
  const table = new Float64Array(12 * n);
  AXES.forEach((axis, d) => {
    const values = samples[axis];
    if (!values?.length) return;
    const spline = naturalSpline(samples.time, values);
    for (let k = 0; k < n; k++) {
      const time = k * step;
      const [at, speed] = spline(Math.min(time, last));
      table[12 * k + 2 * d] = at;
      table[12 * k + 2 * d + 1] = time < last ? speed : 0;
    }
  });
  return table;
}

/** Natural cubic spline through points: value and slope at a time. */
export function naturalSpline(x, y) {
  const n = x.length;
  const second = new Float64Array(n);
  const u = new Float64Array(n);
  for (let k = 1; k < n - 1; k++) {
    const share = (x[k] - x[k - 1]) / (x[k + 1] - x[k - 1]);
    const p = share * second[k - 1] + 2;
    second[k] = (share - 1) / p;
    const bend = (y[k + 1] - y[k]) / (x[k + 1] - x[k]) - (y[k] - y[k - 1]) / (x[k] - x[k - 1]);
    u[k] = ((6 * bend) / (x[k + 1] - x[k - 1]) - share * u[k - 1]) / p;
  }
  second[n - 1] = 0;
  for (let k = n - 2; k >= 0; k--) second[k] = second[k] * second[k + 1] + u[k];
  let at = 0;
  return (time) => {
    if (time < x[at]) at = 0;
    while (at < n - 2 && time >= x[at + 1]) at++;
    const h = x[at + 1] - x[at];
    const [a, b] = [(x[at + 1] - time) / h, (time - x[at]) / h];
    const value = a * y[at] + b * y[at + 1] + (((a ** 3 - a) * second[at] + (b ** 3 - b) * second[at + 1]) * h * h) / 6;
    const slope =
      (y[at + 1] - y[at]) / h + ((-(3 * a * a - 1) * second[at] + (3 * b * b - 1) * second[at + 1]) * h) / 6;
    return [value, slope];
  };
}
