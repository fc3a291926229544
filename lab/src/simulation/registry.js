// What a run shows beside its spin, gait and failure: the package's simulation/registry.py, in the same order.
import { isAveraged, slip } from "./observables.js";
import { mean } from "./samples.js";

const finiteMean = (values) => (values.length ? mean(values) : NaN);

const drift = ({ channels, period }) => {
  const { time } = channels;
  let furthest = NaN;
  slip(time, channels.centre_x, channels.centre_y, period).forEach((way, i) => {
    if (Number.isFinite(way) && isAveraged(time, i, time.length - 1, period) && !(way <= furthest)) furthest = way;
  });
  return furthest;
};

const bendingAmplitude = ({ channels, start, end }) => {
  let largest = -Infinity;
  channels.bend_rms.forEach((angle, i) => {
    if (channels.time[i] > start && channels.time[i] <= end) largest = Math.max(largest, angle);
  });
  return largest === -Infinity ? NaN : largest;
};

const platePower = ({ channels, start, end }) => {
  if (end <= start) return NaN;
  let work = 0;
  channels.plate_work.forEach((given, i) => {
    if (channels.time[i] > start && channels.time[i] <= end) work += given;
  });
  return work / (end - start);
};

const velocity = (which) => (window) => window.twist.mean[which];
const strideCovariance = (one, other) => (window) => window.twist.covariance[one][other];

const TWIST = ["velocity along the bar", "velocity across the bar", "spin rate"];
const covariances = [
  [0, 0, "m^2/s^2", "mm^2/s^2"], [0, 1, "m^2/s^2", "mm^2/s^2"], [1, 1, "m^2/s^2", "mm^2/s^2"],
  [0, 2, "m*rad/s^2", "mm*deg/s^2"], [1, 2, "m*rad/s^2", "mm*deg/s^2"], [2, 2, "rad^2/s^2", "deg^2/s^2"],
].map(([one, other, unit, display]) => ({
  name: `twist_${"xyw"[one]}${"xyw"[other]}`,
  unit,
  display,
  longName: `covariance over strides of the ${TWIST[one]} and the ${TWIST[other]}`,
  measure: strideCovariance(one, other),
}));

/**
 * Observables: name, SI unit, unit that people read, what it is, its row in tables (none: in files alone), how it is
 * measured from a window {channels, period, start, end, twist, means, maxima, energy}, and whether several starts show
 * the worst of theirs rather than the mean.
 */
export const OBSERVABLES = [
  { name: "drift", unit: "m", display: "mm", longName: "furthest slip of the centre", label: "drift of the centre",
    measure: drift },
  { name: "velocity_x", unit: "m/s", display: "mm/s", longName: "mean velocity of the centre along the bar, plate frame",
    label: "velocity along the bar", measure: velocity(0) },
  { name: "velocity_y", unit: "m/s", display: "mm/s", longName: "mean velocity of the centre across the bar, plate frame",
    label: "velocity across the bar", measure: velocity(1) },
  ...covariances,
  { name: "contact_fraction", unit: "1", display: "%", longName: "mean share of the nodes that touch",
    label: "nodes in contact", measure: (window) => finiteMean(window.means("contact")) },
  { name: "flight_fraction", unit: "1", display: "%", longName: "share of the time in which nothing touches",
    label: "time in flight", measure: (window) => finiteMean(window.means("flight")) },
  { name: "bending_amplitude", unit: "rad", display: "deg", longName: "largest rms angle of the bending joints",
    label: "bending amplitude", measure: bendingAmplitude },
  { name: "rim_lift", unit: "m", display: "mm",
    longName: "greatest height of the object above the plate in each plate period, in the mean",
    label: "lift of the rim", measure: (window) => finiteMean(window.maxima("height_high")) },
  { name: "plate_power", unit: "W", display: "mW", longName: "mean power of the plate", label: "plate power",
    measure: platePower },
  { name: "energy_residual", unit: "1", longName: "energy unaccounted for at the end over the energy given",
    overRuns: "worst", measure: (window) => window.energy.relativeResidual },
  { name: "energy_imbalance", unit: "1", longName: "furthest that the energy was out of balance, over the energy given",
    overRuns: "worst", measure: (window) => window.energy.imbalance },
];

/** People's numbers over SI's, by the units that observables are read in. */
const SCALES = {
  mm: 1e3, "mm/s": 1e3, "mm^2/s^2": 1e6, "mm*deg/s^2": 1e3 * (180 / Math.PI), "deg^2/s^2": (180 / Math.PI) ** 2,
  deg: 180 / Math.PI, "deg/s": 180 / Math.PI, mW: 1e3, "%": 100,
};

/** People's number over SI's of an observable on the page. */
export const scaleOf = ({ display }) => SCALES[display] ?? 1;

export const findObservable = (name) => OBSERVABLES.find((observable) => observable.name === name);

/** Every observable of a window by its name, SI; NaN where there is nothing to measure. */
export const measureAll = (window) =>
  Object.fromEntries(OBSERVABLES.map(({ name, measure }) => [name, measure(window)]));
