// A scenario: what is checked of it, and its time step. As the package's model/scenario.py and model/contact.py.
import { checkMotion, periodOf, shortestPeriod } from "./motion.js";
import {
  ACCELERATION,
  ANGLE,
  AREA,
  AXIAL_DAMPING,
  AXIAL_STIFFNESS,
  COEFFICIENT,
  DELAY,
  DEPTH,
  DURATION,
  LENGTH,
  OFFSET,
  SPEED,
  SPEED_RATIO,
  TIME_STEP,
  checkNumber,
  checkNumbers,
} from "./quantity.js";
import { Refusal, checkTable, told } from "./refusal.js";
import { checkSheet, latticeOf, nodeMass, stableTimeStep } from "./sheet.js";

export { latticeOf };

const LARGEST_TIME_STEP = 1e-4; // s
const SHARE_OF_STABLE_STEP = 0.85;
export const STEPS_PER_SINE = 20;
const MOST_STEPS = 2e9;
const FRICTION_RATIO = 0.53; // kinetic over static, as the dissertation has it
const LAWS = ["thesis", "adams"];

const CONTACT = { stiffness: AXIAL_STIFFNESS, damping: AXIAL_DAMPING, damping_ramp: DEPTH, tile_area: AREA };
const FRICTION = {
  static: COEFFICIENT,
  kinetic: COEFFICIENT,
  transition_speed: SPEED,
  kinetic_speed_ratio: SPEED_RATIO,
};
const START = { x: OFFSET, y: OFFSET, angle: ANGLE };
const PLATE = { length: LENGTH, width: LENGTH };

const given = (value) => value !== null && value !== undefined;

/** Refuse what cannot be simulated, in one line that says what to type. @throws {Refusal} */
export const checkScenario = (s) => {
  checkTable(s, "scenario");
  checkName(s.name, "name");
  checkSheet(s.sheet);
  checkName(s.sheet.name, "sheet.name");
  checkMotion(s.motion);
  checkNumbers(checkTable(s.contact, "contact"), "contact", CONTACT);
  checkFriction(checkTable(s.friction, "friction"));
  checkNumbers(checkTable(s.start, "start"), "start", START);
  if (given(s.plate)) checkNumbers(checkTable(s.plate, "plate"), "plate", PLATE);
  checkNumber(s.gravity, "gravity", ACCELERATION);
  checkNumber(s.duration, "duration", DURATION);
  if (given(s.transient)) checkNumber(s.transient, "transient", DELAY);
  checkNumber(s.slip_limit, "slip_limit", LENGTH);
  if (given(s.time_step)) checkNumber(s.time_step, "time_step", TIME_STEP);
  checkTimes(s);
};

const checkName = (name, field) => {
  if (given(name) && typeof name !== "string") throw new Refusal(field, told(name), "a word", '"cheese"');
};

const checkFriction = (friction) => {
  checkNumbers(friction, "friction", FRICTION);
  if (!LAWS.includes(friction.law))
    throw new Refusal("friction.law", told(friction.law), `one of ${LAWS.join(", ")}`, '"thesis"');
  if (friction.kinetic > friction.static)
    throw new Refusal(
      "friction.kinetic",
      told(friction.kinetic),
      `at most the static coefficient ${friction.static}`,
      digits(FRICTION_RATIO * friction.static),
    );
};

/** Transient, steps and time step fit each other. */
const checkTimes = (s) => {
  if (measuredFrom(s) >= s.duration)
    throw new Refusal(
      "transient",
      `${digits(measuredFrom(s))} s`,
      `below the duration ${digits(s.duration)} s`,
      `${digits(0.3 * s.duration)} s`,
    );
  const [joints, sine, usual] = [stableTimeStep(s.sheet), stepOfFastestSine(s.motion), usualStep(s)];
  if (s.duration / usual > MOST_STEPS && usual === sine) {
    const fastest = (s.motion.frequency * sine * MOST_STEPS) / s.duration;
    throw new Refusal(
      "motion.frequency",
      `${digits(s.motion.frequency)} Hz`,
      `at most ${digits(fastest)} Hz where ${digits(s.duration)} s are simulated`,
      `${digits(Math.min(24, 0.5 * fastest))} Hz`,
    );
  }
  if (s.duration / usual > MOST_STEPS)
    throw new Refusal(
      "duration",
      `${digits(s.duration)} s`,
      `at most ${digits(MOST_STEPS * usual)} s at a time step of ${digits(usual)} s`,
      `${digits(Math.min(4, 0.5 * MOST_STEPS * usual))} s`,
    );
  const [least, largest] = [s.duration / MOST_STEPS, Math.min(joints, sine)];
  if (!given(s.time_step) || (s.time_step >= least && s.time_step <= largest)) return;
  const reason = joints < sine ? "the joints stay stable" : `the fastest sine gets ${STEPS_PER_SINE} steps`;
  throw new Refusal(
    "time_step",
    `${digits(s.time_step)} s`,
    `at least ${digits(least)} s and at most ${digits(largest)} s, where ${reason}`,
    `${digits(SHARE_OF_STABLE_STEP * usual)} s, or leave it out`,
  );
};

const digits = (value) => String(Number(value.toPrecision(3)));

// A plate that stands still has a period too, over which everything is measured.
const stepOfFastestSine = (motion) => Math.min(shortestPeriod(motion), periodOf(motion)) / STEPS_PER_SINE;

const usualStep = ({ sheet, motion }) =>
  Math.min(LARGEST_TIME_STEP, SHARE_OF_STABLE_STEP * stableTimeStep(sheet), stepOfFastestSine(motion));

/** Time step, s: the one given, or the least of 1e-4 s, 85 % of the stable one and 1/20 of a fast sine. */
export const timeStep = (s) => s.time_step ?? usualStep(s);

/** Time from which observables are measured, s. */
export const measuredFrom = (s) => s.transient ?? 0.3 * s.duration;

/** Depth at which the plate carries a node at rest, m. */
export const staticDepth = ({ sheet, contact, gravity }) => {
  const forceAt1Millimetre = (contact.stiffness * 1e-3 * sheet.pitch ** 2) / contact.tile_area;
  return 1e-3 * ((nodeMass(sheet) * gravity) / forceAt1Millimetre) ** (1 / 2.2);
};
