// A scenario with some of it changed: dotted names as the command line and the files have them.
import { naturalFrequency } from "../model/modes.js";

/** What a scenario has by a dotted name; undefined where there is nothing. */
export function valueOf(scenario, name) {
  if (name === "friction_angle") return Math.atan(scenario.friction.static);
  if (name === "natural_frequency") return naturalFrequency(scenario.sheet);
  if (name === "motion.phase") return strokeOf(scenario.motion).phase;
  if (name === "motion.stroke") return strokeOf(scenario.motion).amplitude;
  return name.split(".").reduce((part, key) => (part === null || part === undefined ? undefined : part[key]), scenario);
}

/** The scenario with one value set; all else shared. */
export function withValue(scenario, name, value) {
  if (name === "friction_angle") return withFriction(scenario, Math.tan(value));
  if (name === "natural_frequency") return withNaturalFrequency(scenario, value);
  if (name === "friction.static") return withFriction(scenario, value);
  if (name === "motion.phase") return withStroke(scenario, strokeOf(scenario.motion).amplitude, value);
  if (name === "motion.stroke") return withStroke(scenario, value, strokeOf(scenario.motion).phase);
  return put(scenario, name.split("."), value);
}

/** The scenario with many values set. */
export const withValues = (scenario, values) =>
  Object.entries(values).reduce((changed, [name, value]) => withValue(changed, name, value), scenario);

function put(part, [key, ...rest], value) {
  const copy = Array.isArray(part) ? [...part] : { ...part };
  copy[key] = rest.length ? put(part?.[key] ?? {}, rest, value) : value;
  return copy;
}

/** Bending and torsion stiffness scaled together to another frequency of the dish mode. */
function withNaturalFrequency(scenario, value) {
  const own = naturalFrequency(scenario.sheet);
  if (!(own > 0)) throw new Error("the sheet has no bending stiffness to scale: give it one first");
  const by = (value / own) ** 2;
  const { bending_stiffness: kb, torsion_stiffness: kt } = scenario.sheet;
  return { ...scenario, sheet: { ...scenario.sheet, bending_stiffness: kb * by, torsion_stiffness: kt * by } };
}

/** Another static friction, the ratio of the two kept, as in section 4.5. */
function withFriction(scenario, mu) {
  const { static: before, kinetic } = scenario.friction;
  const ratio = before > 0 ? kinetic / before : 1;
  return { ...scenario, friction: { ...scenario.friction, static: mu, kinetic: Math.min(mu, ratio * mu) } };
}

// A stroke out of phase with the swing is a sine beside the short form, which has no phase.
const isStroke = (wave) => wave.axis === "x" && wave.ratio === 1;

function strokeOf(motion) {
  const wave = motion.stroke === 0 ? motion.waves.find(isStroke) : undefined;
  return wave ? { amplitude: wave.amplitude, phase: wave.phase } : { amplitude: motion.stroke, phase: 0 };
}

function withStroke(scenario, amplitude, phase) {
  const { motion } = scenario;
  const which = motion.stroke === 0 ? motion.waves.findIndex(isStroke) : -1;
  const others = motion.waves.filter((_, i) => i !== which);
  const own = phase === 0 ? [] : [{ axis: "x", amplitude, ratio: 1, phase }];
  return { ...scenario, motion: { ...motion, stroke: phase === 0 ? amplitude : 0, waves: [...own, ...others] } };
}

/** Names of the numbers in which two scenarios differ, but for what outlines are cut of. */
export function differences(a, b, prefix = "") {
  if (a === b) return [];
  const whole = a === null || b === null || typeof a !== "object" || typeof b !== "object";
  if (whole || Array.isArray(a) || Array.isArray(b)) return JSON.stringify(a) === JSON.stringify(b) ? [] : [prefix];
  const keys = new Set([...Object.keys(a), ...Object.keys(b)]);
  return [...keys].flatMap((key) => differences(a[key], b[key], prefix ? `${prefix}.${key}` : key));
}

/** How a live sheet gets from one scenario to another: the plate alone, the numbers, or laid down anew. */
export function wayTo(before, after) {
  const changed = differences(before, after).filter((name) => !["name", "sheet.name"].includes(name));
  if (changed.length === 0) return "same";
  const anew = /^(sheet\.outline|sheet\.pitch|start|time_step)/;
  if (changed.some((name) => anew.test(name))) return "anew";
  if (changed.every((name) => name.startsWith("motion.") && name !== "motion.height")) return "motion";
  if (changed.every((name) => ["duration", "transient", "slip_limit"].includes(name))) return "measure";
  return "become";
}
