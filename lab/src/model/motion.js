// How the plate moves: sines on each degree of freedom, or a sampled trajectory, with a smooth start. As model/motion.py.
import { Refusal, checkNumber } from "./refusal.js";

export const AXES = ["x", "y", "z", "rx", "ry", "rz"];
export const SHORTEST_RAMP = 1e-12; // s: the core adds as much to what it divides by
const SHORTEST_SAMPLE = 1e-9;
const LARGEST_SAMPLE = 1e9;
const MOST_SAMPLES = 2_000_000;
const MOST_WAVES = 100;
const LARGEST_ANGLE = Math.PI / 2;

/** Sines as [degree of freedom, amplitude, frequency in Hz, phase in turns]. */
export function termsOf(motion) {
  const waves = motion.waves.map((w) => [AXES.indexOf(w.axis), w.amplitude, w.ratio * motion.frequency, w.phase / (2 * Math.PI)]);
  return [[0, motion.stroke, motion.frequency, 0], [3, -motion.angle, motion.frequency, 0], ...waves].filter((term) => term[1] !== 0);
}

export const offsetOf = (motion) => AXES.map((axis) => motion.offset?.[axis] ?? 0);

/** Where the plate starts from, m and rad: its offset in a smooth start. */
export function poseAtStart(motion) {
  const pose = offsetOf(motion);
  if (motion.ramp > SHORTEST_RAMP) return pose;
  for (const [d, amplitude, , phase] of termsOf(motion)) pose[d] += amplitude * Math.sin(2 * Math.PI * phase);
  AXES.forEach((axis, d) => {
    if (motion.samples?.[axis]?.length) pose[d] += motion.samples[axis][0];
  });
  return pose;
}

/** Period of the fastest sine, s. */
export function shortestPeriod(motion) {
  const fastest = Math.max(0, ...termsOf(motion).map((term) => term[2]));
  return fastest > 0 ? 1 / fastest : Infinity;
}

/** Time after which the sines repeat, s. */
export function periodOf(motion) {
  let multiple = 1;
  for (const { ratio } of motion.waves) if (ratio !== 1) multiple = lcm(multiple, denominator(ratio, 12));
  return Math.min(multiple / motion.frequency, 1e300);
}

const gcd = (a, b) => (b ? gcd(b, a % b) : a);
const lcm = (a, b) => (a / gcd(a, b)) * b;

/** Denominator of the fraction nearest to a number, no larger than `most`. */
function denominator(value, most) {
  let best = 1;
  for (let q = 1; q <= most; q++)
    if (Math.abs(value - Math.round(value * q) / q) < Math.abs(value - Math.round(value * best) / best)) best = q;
  return best;
}

/** (3 × 3) rotation Rx Ry Rz of a pose, rows one after the other: its columns are the plate's axes. */
export function rotationOf(pose) {
  const [cx, cy, cz] = [Math.cos(pose[3]), Math.cos(pose[4]), Math.cos(pose[5])];
  const [sx, sy, sz] = [Math.sin(pose[3]), Math.sin(pose[4]), Math.sin(pose[5])];
  return [cy * cz, -cy * sz, sy, cx * sz + sx * sy * cz, cx * cz - sx * sy * sz, -sx * cy,
    sx * sz - cx * sy * cz, sx * cz + cx * sy * sz, cx * cy];
}

/** Shortest time between two samples, s. */
export function finestStep(samples) {
  let finest = Infinity;
  for (let k = 1; k < samples.time.length; k++) finest = Math.min(finest, samples.time[k] - samples.time[k - 1]);
  return finest;
}

export function checkMotion(motion) {
  const is = (name, bounds) => checkNumber(motion[name], `motion.${name}`, bounds);
  is("frequency", { above: 0, atMost: 1e6, hint: "24" });
  is("angle", { atLeast: -LARGEST_ANGLE, atMost: LARGEST_ANGLE, hint: "0.05" });
  is("stroke", { atLeast: -10, atMost: 10, hint: "0.003" });
  is("height", { atLeast: -1e3, atMost: 1e3, hint: "0" });
  is("ramp", { atLeast: 0, atMost: 1e6, hint: "0.1" });
  offsetOf(motion).forEach((value, d) => checkNumber(value, `motion.offset.${AXES[d]}`, { atLeast: -1e3, atMost: 1e3, hint: "0" }));
  if (!Array.isArray(motion.waves) || motion.waves.length > MOST_WAVES)
    throw new Refusal("motion.waves", "no list of sines", `at most ${MOST_WAVES}`, "[]");
  motion.waves.forEach((wave, i) => {
    if (!AXES.includes(wave?.axis)) throw new Refusal(`motion.waves.${i}.axis`, String(wave?.axis), `one of ${AXES.join(", ")}`, "z");
    checkNumber(wave.amplitude, `motion.waves.${i}.amplitude`, { atLeast: -1e3, atMost: 1e3, hint: "0.001" });
    checkNumber(wave.ratio, `motion.waves.${i}.ratio`, { above: 0, atMost: 1e6, hint: "2" });
    checkNumber(wave.phase, `motion.waves.${i}.phase`, { atLeast: -1e6, atMost: 1e6, hint: "0" });
  });
  if (motion.samples !== null && motion.samples !== undefined) checkSamples(motion.samples);
}

function checkSamples(samples) {
  const { time } = samples;
  const rises = Array.isArray(time) && time.length >= 2 && time.length <= MOST_SAMPLES && time[0] === 0
    && time.every((t, k) => Number.isFinite(t) && (k === 0 || t - time[k - 1] >= SHORTEST_SAMPLE));
  if (!rises) throw new Refusal("motion.samples.time", "no times", "2 or more finite times that rise from 0 s", "[0, 0.01, 0.02]");
  for (const axis of AXES) {
    const values = samples[axis];
    if (!values?.length) continue;
    if (values.length !== time.length || !values.every((v) => Number.isFinite(v) && Math.abs(v) <= LARGEST_SAMPLE))
      throw new Refusal(`motion.samples.${axis}`, `${values.length} values`, `${time.length} finite values, one for each time`, "[0, 0, 0]");
  }
}
