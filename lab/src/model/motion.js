// How the plate moves: sines on each degree of freedom, or a sampled trajectory, with a smooth start. As the package's
// model/motion.py.
import {
  ANGLE,
  DELAY,
  FREQUENCY,
  OFFSET,
  PLATE_ANGLE,
  PLATE_STROKE,
  RATIO,
  STROKE,
  checkNumber,
  checkNumbers,
} from "./quantity.js";
import { Refusal, checkTable, told } from "./refusal.js";
import { roundHalfEven } from "./rounding.js";

export const AXES = ["x", "y", "z", "rx", "ry", "rz"];
/** A ramp no longer than this is none, s: the core adds as much to what it divides by. */
export const SHORTEST_RAMP = 1e-12;

const SHORTEST_SAMPLE = 1e-9; // s
const LARGEST_SAMPLE = 1e9; // m or rad
const MOST_SAMPLES = 200_000; // of a trajectory that a page follows
const MOST_WAVES = 100;
const TIMES = "[0, 0.01, 0.02]";

const turns = (axis) => axis.startsWith("r");

/** Sines as [degree of freedom, amplitude, frequency in Hz, phase in turns]. */
export const termsOf = ({ stroke, angle, frequency, waves }) =>
  [
    [0, stroke, frequency, 0],
    [3, -angle, frequency, 0],
    ...waves.map((wave) => [
      AXES.indexOf(wave.axis),
      wave.amplitude,
      wave.ratio * frequency,
      wave.phase / (2 * Math.PI),
    ]),
  ].filter(([, amplitude]) => amplitude !== 0);

/** Where the plate is held off its rest, on each axis, m and rad. */
export const offsetOf = (motion) => AXES.map((axis) => motion.offset?.[axis] ?? 0);

/** Where the plate starts from, m and rad: its offset in a smooth start. */
export const poseAtStart = (motion) => {
  const pose = offsetOf(motion);
  if (motion.ramp > SHORTEST_RAMP) return pose;
  for (const [d, amplitude, , phase] of termsOf(motion)) pose[d] += amplitude * Math.sin(2 * Math.PI * phase);
  AXES.forEach((axis, d) => {
    if (motion.samples?.[axis]?.length) pose[d] += motion.samples[axis][0];
  });
  return pose;
};

/** Period of the fastest sine, s; infinite where there is none. */
export const shortestPeriod = (motion) => {
  const fastest = Math.max(0, ...termsOf(motion).map(([, , frequency]) => frequency));
  return fastest > 0 ? 1 / fastest : Infinity;
};

/** Time after which the sines repeat, s: that of the frequency, or a multiple where ratios are not whole. */
export const periodOf = ({ frequency, waves }) => {
  const denominators = waves.filter(({ ratio }) => ratio !== 1).map(({ ratio }) => denominatorOf(ratio));
  return Math.min(denominators.reduce(leastCommonMultiple, 1) / frequency, 1e300);
};

/** Denominator of the fraction nearest to a number, at most 12; the least where several are as near. */
const denominatorOf = (number) => {
  let [nearest, least] = [1, Infinity];
  for (let q = 1; q <= 12; q++) {
    const off = Math.abs(number - roundHalfEven(number * q) / q);
    if (off < least) [nearest, least] = [q, off];
  }
  return nearest;
};

const leastCommonMultiple = (a, b) => (a / greatestCommonDivisor(a, b)) * b;
const greatestCommonDivisor = (a, b) => (b === 0 ? a : greatestCommonDivisor(b, a % b));

/** Rotation Rx Ry Rz of a pose, row by row: its columns are the plate's axes as the world sees them. */
export const rotationOf = (pose) => {
  const [cx, cy, cz] = [Math.cos(pose[3]), Math.cos(pose[4]), Math.cos(pose[5])];
  const [sx, sy, sz] = [Math.sin(pose[3]), Math.sin(pose[4]), Math.sin(pose[5])];
  return [
    cy * cz,
    -cy * sz,
    sy,
    cx * sz + sx * sy * cz,
    cx * cz - sx * sy * sz,
    -sx * cy,
    sx * sz - cx * sy * cz,
    sx * cz + cx * sy * sz,
    cx * cy,
  ];
};

/** Shortest time between two samples, s. */
export const finestStep = ({ time }) => {
  let finest = Infinity;
  for (let k = 1; k < time.length; k++) finest = Math.min(finest, time[k] - time[k - 1]);
  return finest;
};

const NUMBERS = { frequency: FREQUENCY, angle: PLATE_ANGLE, stroke: PLATE_STROKE, height: OFFSET, ramp: DELAY };

/** @throws {Refusal} */
export const checkMotion = (motion) => {
  checkTable(motion, "motion");
  checkNumbers(motion, "motion", NUMBERS);
  if (motion.offset !== undefined) checkTable(motion.offset, "motion.offset");
  for (const [axis, value] of Object.entries(motion.offset ?? {}))
    if (AXES.includes(axis)) checkNumber(value, `motion.offset.${axis}`, turns(axis) ? PLATE_ANGLE : OFFSET);
  checkWaves(motion.waves);
  if (motion.samples !== null && motion.samples !== undefined)
    checkSamples(checkTable(motion.samples, "motion.samples"));
};

const checkWaves = (waves) => {
  const example = '[{ axis = "z", amplitude = "1 mm" }]';
  if (!Array.isArray(waves) || waves.length > MOST_WAVES)
    throw new Refusal("motion.waves", told(waves), `a list of at most ${MOST_WAVES} sines`, example);
  waves.forEach((wave, i) => {
    const field = `motion.waves.${i}`;
    checkTable(wave, field);
    if (!AXES.includes(wave.axis))
      throw new Refusal(`${field}.axis`, told(wave.axis), `one of ${AXES.join(", ")}`, '"z"');
    checkNumbers(wave, field, { amplitude: turns(wave.axis) ? ANGLE : STROKE, ratio: RATIO, phase: ANGLE });
  });
};

const checkSamples = (samples) => {
  const { time } = samples;
  const field = "motion.samples.time";
  if (!Array.isArray(time) || time.length < 2 || time.length > MOST_SAMPLES)
    throw new Refusal(field, told(time), `2 to ${MOST_SAMPLES} finite times that rise from 0 s`, TIMES);
  const rises =
    time[0] === 0 && time.every((t, k) => Number.isFinite(t) && (k === 0 || t - time[k - 1] >= SHORTEST_SAMPLE));
  if (!rises)
    throw new Refusal(field, told(time), `finite times that rise from 0 s by at least ${SHORTEST_SAMPLE} s`, TIMES);
  for (const axis of AXES) {
    const values = samples[axis];
    if (values === undefined || values === null || values.length === 0) continue;
    const fits =
      Array.isArray(values) &&
      values.length === time.length &&
      values.every((value) => typeof value === "number" && Math.abs(value) <= LARGEST_SAMPLE);
    if (!fits)
      throw new Refusal(
        `motion.samples.${axis}`,
        told(values),
        `${time.length} values, one for each time, of at most ${LARGEST_SAMPLE} in size`,
        TIMES,
      );
  }
};
