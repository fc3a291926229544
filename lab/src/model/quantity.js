// What the numbers of a scenario measure and allow, in SI, and how people read them. As the package's units.py.
import { Refusal, told } from "./refusal.js";

const DEG = Math.PI / 180;
// Sizes beyond which products and quotients of a few numbers leave floating point.
const SMALLEST = 1e-30;
const LARGEST = 1e30;

/**
 * @typedef {{display: string, factor: number, example: string, above: number, atLeast: number, atMost: number,
 *   smallest: number}} Quantity limits in SI; `factor` is what one of the unit that people read is in SI
 */

/** @returns {Quantity} */
const quantity = (
  display,
  factor,
  example,
  { above = -Infinity, atLeast = -Infinity, atMost = Infinity, smallest = SMALLEST } = {},
) => ({ display, factor, example, above, atLeast, atMost, smallest: above === 0 ? smallest : 0 });

export const LENGTH = quantity("mm", 1e-3, "10 mm", { above: 0, atMost: 10 });
export const OFFSET = quantity("mm", 1e-3, "0 mm", { atLeast: -10, atMost: 10 });
export const DEPTH = quantity("mm", 1e-3, "0.1 mm", { atLeast: 0 });
export const AREA = quantity("mm^2", 1e-6, "100 mm^2", { above: 0 });
export const MASS = quantity("g", 1e-3, "13.6 g", { above: 0, atMost: 10 });
export const ANGLE = quantity("deg", DEG, "12 deg");
export const STROKE = quantity("mm", 1e-3, "3 mm");
export const PLATE_ANGLE = quantity("deg", DEG, "3 deg", { atLeast: -Math.PI / 2, atMost: Math.PI / 2 });
export const PLATE_STROKE = quantity("mm", 1e-3, "3 mm", { atLeast: -1, atMost: 1 });
export const DURATION = quantity("s", 1, "4 s", { above: 0 });
export const DELAY = quantity("s", 1, "0.1 s", { atLeast: 0 });
export const TIME_STEP = quantity("s", 1, "1e-4 s", { above: 0 });
export const FREQUENCY = quantity("Hz", 1, "24 Hz", { above: 0, smallest: 0 });
export const SPEED = quantity("mm/s", 1e-3, "100 mm/s", { above: 0 });
export const ACCELERATION = quantity("m/s^2", 1, "9.81 m/s^2", { atLeast: 0 });
export const AXIAL_STIFFNESS = quantity("N/mm", 1e3, "0.79 N/mm", { above: 0 });
export const AXIAL_DAMPING = quantity("N/(mm/s)", 1e3, "4.9e-4 N/(mm/s)", { atLeast: 0 });
export const BENDING_STIFFNESS = quantity("N*mm/deg", 1e-3 / DEG, "2.72e-3 N*mm/deg", { atLeast: 0 });
export const BENDING_DAMPING = quantity("N*mm/(deg/s)", 1e-3 / DEG, "4.23e-6 N*mm/(deg/s)", { atLeast: 0 });
export const COEFFICIENT = quantity("", 1, "0.75", { atLeast: 0 });
export const RATIO = quantity("", 1, "1", { above: 0 });
export const SPEED_RATIO = quantity("", 1, "10", { above: 1 });

/** A number of SI in the unit that people read, as `-3 mm`. */
export const shown = (value, { display, factor }) => `${Number((value / factor).toPrecision(6))} ${display}`.trim();

/** A finite number within what a quantity allows. @throws {Refusal} */
export const checkNumber = (value, field, measured) => {
  const { above, atLeast, atMost, smallest, example } = measured;
  const within = typeof value === "number" && value > above && value >= atLeast && value <= atMost;
  if (within && Math.abs(value) <= LARGEST && Math.abs(value) >= smallest) return value;
  const bounds = [
    above > -Infinity && `above ${shown(above, measured)}`,
    atLeast > -Infinity && `at least ${shown(atLeast, measured)}`,
    atMost < Infinity && `at most ${shown(atMost, measured)}`,
  ].filter(Boolean);
  if (within) bounds.push(`from ${smallest} to ${LARGEST} in size, in SI`);
  const got = Number.isFinite(value) ? shown(value, measured) : told(value);
  throw new Refusal(field, got, ["a number", bounds.join(" and ")].join(" ").trim(), example);
};

/** Every number of a part, each under its dotted name. @throws {Refusal} */
export const checkNumbers = (part, field, quantities) => {
  for (const [name, measured] of Object.entries(quantities)) checkNumber(part[name], `${field}.${name}`, measured);
};
