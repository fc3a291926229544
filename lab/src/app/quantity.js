// Numbers with units: as people read and type them, and in SI.

/**
 * What a field measures, as the package's own models say it.
 * @typedef {{name: string, unit: string, display: string, factor: number, example: string, above: number|null,
 *   at_least: number|null, at_most: number|null, description: string, choices: string[]|null}} Field
 */

const NUMBER = /^\s*([-+−]?(?:\d+(?:\.\d*)?|\.\d+)(?:e[-+]?\d+)?)\s*(.*?)\s*$/i;

/** A number in the unit that people read it in, with so many digits. */
export function shown(value, field, digits = 4) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  const number = value / (field.factor ?? 1);
  return trimmed(number, digits);
}

/** A number with so many digits, and no zeros for show. */
export function trimmed(number, digits = 4) {
  if (!Number.isFinite(number)) return "–";
  const size = Math.abs(number);
  const text = size !== 0 && (size < 1e-4 || size >= 1e6) ? number.toExponential(digits - 1) : number.toPrecision(digits);
  return text.includes("e") ? text.replace(/\.?0+e/, "e") : text.includes(".") ? text.replace(/\.?0+$/, "") : text;
}

/** The same with its unit: "24 Hz". */
export const withUnit = (value, field, digits = 4) => `${shown(value, field, digits)} ${pretty(field.display)}`.trim();

/** A unit as people write it. */
export const pretty = (unit) =>
  unit.replaceAll("*", "\u202f").replace("pi rad", "π rad").replace("^2", "²").replace("^3", "³").replace(/\bdeg\b/g, "°").replace("mm/deg", "mm/°");

/** Why a value in SI cannot be, in one line; null where it can. */
export function fault(value, field) {
  const allowed = [];
  if (field.above !== null && field.above !== undefined) allowed.push(["above", field.above, value > field.above]);
  if (field.at_least !== null && field.at_least !== undefined)
    allowed.push(["at least", field.at_least, value >= field.at_least]);
  if (field.at_most !== null && field.at_most !== undefined)
    allowed.push(["at most", field.at_most, value <= field.at_most]);
  if (Number.isFinite(value) && allowed.every(([, , holds]) => holds)) return null;
  const bounds = allowed.map(([word, bound]) => `${word} ${withUnit(bound, field)}`).join(" and ");
  const got = Number.isFinite(value) ? withUnit(value, field) : "no number";
  return `${got} is not allowed: ${bounds || "a finite number"}. Type ${field.example}.`;
}

/**
 * What was typed, in SI. A bare number is in the unit that is shown beside it.
 *
 * @param {string} text
 * @param {Field} field
 * @param {Record<string, [number, string]>} units
 * @returns {{value: number} | {fault: string}}
 */
export function parsed(text, field, units) {
  const match = NUMBER.exec(text.replace(/^(\s*[-+]?\d+),(\d+)/, "$1.$2"));
  if (!match) return { fault: `“${text.slice(0, 40)}” does not begin with a number. Type ${field.example}.` };
  const number = Number(match[1].replace("−", "-"));
  const factor = match[2] === "" ? (field.factor ?? 1) : factorOf(match[2], field, units);
  if (factor === null) {
    const known = Object.entries(units).filter(([, [, si]]) => si === field.unit).map(([name]) => name);
    return { fault: `“${match[2].slice(0, 20)}” is no unit here: ${known.slice(0, 6).join(", ") || "a plain number"}.` };
  }
  const value = number * factor;
  const wrong = fault(value, field);
  return wrong ? { fault: wrong } : { value };
}

function factorOf(unit, field, units) {
  let name = unit.replaceAll("·", "*").replaceAll("°", "deg").replaceAll("µ", "u").replaceAll("μ", "u");
  let turns = 1;
  const times = /^(?:pi|π)\s*\*?\s*(.*)$/.exec(name);
  if (field.unit === "rad/s" && times) {
    turns = Math.PI;
    name = times[1] || "rad/s";
  }
  if (!Object.hasOwn(units, name)) return null;
  const [factor, si] = units[name];
  if (si === field.unit) return factor * turns;
  return si === "Hz" && field.unit === "rad/s" ? 2 * Math.PI * factor : null;
}
