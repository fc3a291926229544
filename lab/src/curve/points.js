// Which points of a curve its fit may use, and the fit: the package's curve/curve.py.
import { fitLorentzian } from "./lorentz.js";

// Successive failed frequencies that end a curve.
const RUN_OFF = 3;

/**
 * Points that the fit may use: measured, not failed, and below the run-off, the first of three successive frequencies
 * that all failed; islands of stability beyond it belong to another motion.
 *
 * @param points {frequency, rate, failed} in any order
 * @returns for each point whether it is used
 */
export const fittedPoints = (points) => {
  const order = points.map((_, i) => i).sort((a, b) => points[a].frequency - points[b].frequency);
  const runsOff = (_, at) =>
    at + RUN_OFF <= order.length && order.slice(at, at + RUN_OFF).every((i) => points[i].failed);
  const end = order.findIndex(runsOff);
  const usable = new Set(end < 0 ? order : order.slice(0, end));
  return points.map(({ rate, failed }, i) => usable.has(i) && !failed && Number.isFinite(rate));
};

/** Whether the object failed at a frequency above those that the fit may use. */
export const endsInFailure = (points) => {
  const fitted = fittedPoints(points);
  const highest = Math.max(0, ...points.filter((_, i) => fitted[i]).map(({ frequency }) => frequency));
  return points.some(({ frequency, failed }) => failed && frequency > highest);
};

/** The Lorentz fit of a curve's points, or why there is none: see `fitLorentzian`. */
export const fitPoints = (points) => {
  const fitted = fittedPoints(points);
  const used = points.filter((_, i) => fitted[i]);
  return fitLorentzian(used.map(({ frequency }) => frequency), used.map(({ rate }) => rate),
    { endsInFailure: endsInFailure(points) });
};
