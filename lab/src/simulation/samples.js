// Arithmetic of samples over time, with numpy's rules, so that both languages measure alike.

export { roundHalfEven } from "../model/rounding.js";

/** Values at `x` by straight lines between samples, the ends' values beyond them. */
export const interpolate = (x, time, values) => {
  const n = time.length;
  if (x <= time[0]) return values[0];
  if (x >= time[n - 1]) return values[n - 1];
  let low = 0;
  let high = n - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (time[middle] <= x) low = middle;
    else high = middle;
  }
  if (x === time[low]) return values[low];
  return values[low] + ((values[high] - values[low]) / (time[high] - time[low])) * (x - time[low]);
};

/** Angles without jumps of more than half a turn from one sample to the next. */
export const unwrap = (angles) => {
  const out = Float64Array.from(angles);
  const turn = 2 * Math.PI;
  let added = 0;
  for (let i = 1; i < out.length; i++) {
    const step = angles[i] - angles[i - 1];
    if (!(Math.abs(step) < Math.PI)) {
      let wrapped = ((((step + Math.PI) % turn) + turn) % turn) - Math.PI;
      if (wrapped === -Math.PI && step > 0) wrapped = Math.PI;
      added += wrapped - step;
    }
    out[i] = angles[i] + added;
  }
  return out;
};

export const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;

/** Middle of the sorted values; NaN where there is none. */
export const median = (values) => {
  if (!values.length) return NaN;
  const sorted = Float64Array.from(values).sort();
  const half = sorted.length >> 1;
  return sorted.length % 2 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
};

/** Place of the first largest value. */
export const placeOfLargest = (values) => values.reduce((best, value, i) => (value > values[best] ? i : best), 0);

/** Student's t, 97.5 % point, within 0.2 %. */
export const student95 = (freedom) =>
  freedom < STUDENT_95.length ? STUDENT_95[freedom] : 1.95996 + 2.37227 / freedom + 2.8225 / freedom ** 2;

const STUDENT_95 = [Infinity, 12.7062, 4.30265, 3.18245, 2.77645, 2.57058, 2.44691, 2.36462];
