// A scenario: what is checked of it, its time step, and how a run of it is sampled. As model/scenario.py and
// engine/recording.py.
import { Refusal, checkNumber } from "./refusal.js";
import { checkMotion, periodOf, poseAtStart, rotationOf, shortestPeriod } from "./motion.js";
import { latticeOf, nodeMass, stableTimeStep } from "./sheet.js";

export { latticeOf };

const LARGEST_TIME_STEP = 1e-4;
const SHARE_OF_STABLE_STEP = 0.85;
const STEPS_PER_SINE = 20;
const MOST_STEPS = 2e9;
const SAMPLES_PER_PERIOD = 24;
const LONGEST_SAMPLE_INTERVAL = 2e-3;
const SMALLEST = 1e-30;
const LARGEST = 1e30;
const MOST_NODES = 20_000; // that a page simulates

const NUMBERS = {
  sheet: {
    mass: { above: 0, hint: "0.0136" }, pitch: { above: 0, atMost: 1e3, hint: "0.01" }, thickness: { above: 0, atMost: 1e3, hint: "0.0025" },
    bending_stiffness: { atLeast: 0, hint: "1.6e-4" }, bending_damping: { atLeast: 0, hint: "0" },
    axial_stiffness: { atLeast: 0, hint: "790" }, axial_damping: { atLeast: 0, hint: "0.49" }, shear_ratio: { above: 0, hint: "1" },
    torsion_stiffness: { atLeast: 0, hint: "0" }, torsion_damping: { atLeast: 0, hint: "0" },
  },
  contact: { stiffness: { atLeast: 0, hint: "11860" }, damping: { atLeast: 0, hint: "7.65" }, damping_ramp: { atLeast: 0, hint: "0" }, tile_area: { above: 0, hint: "1e-4" } },
  friction: { static: { atLeast: 0, hint: "0.75" }, kinetic: { atLeast: 0, hint: "0.4" }, transition_speed: { above: 0, hint: "0.1" }, kinetic_speed_ratio: { above: 1, hint: "10" } },
  start: { x: { atLeast: -1e3, atMost: 1e3, hint: "0" }, y: { atLeast: -1e3, atMost: 1e3, hint: "0" }, angle: { atLeast: -1e6, atMost: 1e6, hint: "0" } },
  plate: { length: { above: 0, atMost: 1e3, hint: "0.2" }, width: { above: 0, atMost: 1e3, hint: "0.2" } },
};

/** Refuse what cannot be simulated, in one line that says what to type. @throws {Refusal} */
export function checkScenario(s) {
  if (!s || typeof s !== "object") throw new Refusal("scenario", "nothing", "a scenario", "a preset");
  for (const [part, fields] of Object.entries(NUMBERS)) {
    if (part === "plate" && (s.plate === null || s.plate === undefined)) continue;
    if (!s[part] || typeof s[part] !== "object") throw new Refusal(part, "nothing", "a table of its fields", "a preset");
    for (const [name, bounds] of Object.entries(fields)) {
      checkNumber(s[part][name], `${part}.${name}`, { ...bounds, atMost: bounds.atMost ?? LARGEST });
      if (bounds.above === 0 && s[part][name] < SMALLEST) throw new Refusal(`${part}.${name}`, `${s[part][name]}`, `at least ${SMALLEST}`, bounds.hint);
    }
  }
  if (s.friction.kinetic > s.friction.static)
    throw new Refusal("friction.kinetic", `${s.friction.kinetic}`, `at most the static coefficient ${s.friction.static}`, `${(0.53 * s.friction.static).toPrecision(3)}`);
  if (!["thesis", "adams"].includes(s.friction.law)) throw new Refusal("friction.law", String(s.friction.law), "thesis or adams", "thesis");
  if (!s.motion || typeof s.motion !== "object") throw new Refusal("motion", "nothing", "a table of its fields", "a preset");
  checkMotion(s.motion);
  checkNumber(s.gravity, "gravity", { above: 0, atMost: 1e6, hint: "9.81" });
  checkNumber(s.duration, "duration", { above: 0, atMost: 1e6, hint: "4" });
  checkNumber(s.slip_limit, "slip_limit", { above: 0, atMost: 1e9, hint: "0.01" });
  const { nNodes } = latticeOf(s.sheet);
  if (nNodes > MOST_NODES) throw new Refusal("sheet.pitch", `${nNodes} nodes`, `at most ${MOST_NODES} in a page`, `${(1000 * s.sheet.pitch * Math.sqrt(nNodes / 800)).toPrecision(3)} mm`);
  if (s.transient !== null && s.transient !== undefined) checkNumber(s.transient, "transient", { atLeast: 0, hint: "0" });
  if (measuredFrom(s) >= s.duration) throw new Refusal("transient", `${measuredFrom(s)} s`, `below the duration ${s.duration} s`, `${0.3 * s.duration} s`);
  const [joints, sine] = [stableTimeStep(s.sheet), stepOfFastestSine(s.motion)];
  if (s.duration / usualStep(s) > MOST_STEPS) throw new Refusal("duration", `${s.duration} s`, `at most ${(MOST_STEPS * usualStep(s)).toPrecision(3)} s at such a time step`, "4 s");
  if (s.time_step !== null && s.time_step !== undefined)
    checkNumber(s.time_step, "time_step", { atLeast: s.duration / MOST_STEPS, atMost: Math.min(joints, sine), hint: `${(SHARE_OF_STABLE_STEP * usualStep(s)).toPrecision(2)}, or leave it out` });
}

const stepOfFastestSine = (motion) => Math.min(shortestPeriod(motion), periodOf(motion)) / STEPS_PER_SINE;
const usualStep = (s) => Math.min(LARGEST_TIME_STEP, SHARE_OF_STABLE_STEP * stableTimeStep(s.sheet), stepOfFastestSine(s.motion));

/** Time step, s. */
export const timeStep = (s) => s.time_step ?? usualStep(s);

/** Time from which observables are measured, s. */
export const measuredFrom = (s) => s.transient ?? 0.3 * s.duration;

const roundHalfEven = (value) => {
  const floor = Math.floor(value);
  if (value - floor !== 0.5) return Math.round(value);
  return floor % 2 === 0 ? floor : floor + 1;
};

/** Steps of a whole run. */
export const stepsOf = (s) => Math.max(1, roundHalfEven(s.duration / timeStep(s)));

/** Steps between samples while the plate moves so. */
export function strideOf(s, motion = s.motion, interval = 0) {
  const wanted = interval || Math.min(LONGEST_SAMPLE_INTERVAL, periodOf(motion) / SAMPLES_PER_PERIOD);
  return Math.max(1, Math.min(roundHalfEven(wanted / timeStep(s)), stepsOf(s)));
}

/** Samples between snapshots, 0 for none. */
export function thinningOf(s, interval) {
  if (!(interval > 0)) return 0;
  const stride = strideOf(s);
  const samples = Math.floor(stepsOf(s) / stride) + 1;
  return Math.max(1, roundHalfEven(Math.min(interval / (stride * timeStep(s)), samples)));
}

/** Node positions at the start, world frame, m: at rest, flat on the plate, which carries the weight. */
export function startPositions(s, offset = [0, 0, 0]) {
  const { rest, nNodes } = latticeOf(s.sheet);
  const [x, y, angle] = [s.start.x + offset[0], s.start.y + offset[1], s.start.angle + offset[2]];
  const [c, d] = [Math.cos(angle), Math.sin(angle)];
  const depth = staticDepth(s);
  const pose = poseAtStart(s.motion);
  const turned = pose.some((value) => value !== 0);
  const R = rotationOf(pose);
  const out = new Float64Array(3 * nNodes);
  for (let k = 0; k < nNodes; k++) {
    const [rx, ry] = [rest[2 * k] * s.sheet.pitch, rest[2 * k + 1] * s.sheet.pitch];
    const p = [rx * c - ry * d + x, rx * d + ry * c + y, -depth];
    const up = [p[0], p[1], p[2] + s.motion.height];
    for (let a = 0; a < 3; a++)
      out[3 * k + a] = turned ? R[3 * a] * up[0] + R[3 * a + 1] * up[1] + R[3 * a + 2] * up[2] - (a === 2 ? s.motion.height : 0) + pose[a] : p[a];
  }
  return out;
}

function staticDepth(s) {
  const force = (s.contact.stiffness * 1e-3 * s.sheet.pitch ** 2) / s.contact.tile_area;
  return 1e-3 * ((nodeMass(s.sheet) * s.gravity) / force) ** (1 / 2.2);
}
