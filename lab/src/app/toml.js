// A scenario as a file that `plategait simulate` takes, and back.
import { parse } from "smol-toml";

/** TOML of a scenario in SI: the very numbers that the page computes with. */
export function tomlOf(scenario, version) {
  const lines = [`# From the plategait lab ${version}. Bare numbers are SI; text with units works too.`,
    `# Run it: plategait simulate ${fileName(scenario)}`];
  table(scenario, "", lines);
  return `${lines.join("\n").trim()}\n`;
}

export const fileName = (scenario) => `${(scenario.name || "scenario").replace(/[^\w.-]+/g, "-").slice(0, 60)}.toml`;

function table(part, prefix, lines) {
  const nested = [];
  for (const [key, value] of Object.entries(part)) {
    if (value === null || value === undefined || (Array.isArray(value) && value.length === 0)) continue;
    if (typeof value === "object" && !Array.isArray(value) && key !== "samples") nested.push([key, value]);
    else lines.push(`${key} = ${literal(value)}`);
  }
  for (const [key, value] of nested) {
    lines.push("", `[${prefix}${key}]`);
    table(value, `${prefix}${key}.`, lines);
  }
}

function literal(value) {
  if (typeof value === "number") return Number.isInteger(value) && Math.abs(value) < 1e15 ? `${value}.0` : String(value);
  if (typeof value === "boolean") return String(value);
  if (typeof value === "string") return JSON.stringify(value).replaceAll("\u007f", "\\u007F");
  if (Array.isArray(value)) return `[${value.map(literal).join(", ")}]`;
  const items = Object.entries(value).filter(([, item]) => item !== null && !(Array.isArray(item) && item.length === 0));
  return `{ ${items.map(([key, item]) => `${key} = ${literal(item)}`).join(", ")} }`;
}

/**
 * A scenario from TOML, in SI and whole: what the file leaves out is the model's default, or of `base`.
 *
 * @param {string} text
 * @param {object} base scenario of whose form it must be
 * @param {{units: Record<string, [number, string]>, fields: object[]}} facts
 * @throws {Error} with what is wrong in one line
 */
export function scenarioFrom(text, base, facts) {
  let data;
  try {
    data = parse(text);
  } catch (error) {
    throw new Error(`no TOML: ${String(error.message).split("\n")[0]}`);
  }
  if (!data.sheet || typeof data.sheet !== "object") throw new Error("no [sheet] in the file: it is no scenario");
  const fresh = { ...base, name: "scenario", start: { x: 0, y: 0, angle: 0 }, plate: null, transient: null, time_step: null,
    motion: { ...base.motion, waves: [], samples: null, offset: { x: 0, y: 0, z: 0, rx: 0, ry: 0, rz: 0 }, height: 0 },
    sheet: { ...base.sheet, outline: {} } };
  return merged(fresh, data, "", facts);
}

function merged(base, data, prefix, facts) {
  const copy = { ...base };
  for (const [key, value] of Object.entries(data)) {
    const name = prefix + key;
    if (key === "image") throw new Error(`${name}: pictures stay outside the page: type plategait lab FILE.toml instead`);
    if (name === "motion.samples" && typeof value === "string")
      throw new Error(`${name}: a file beside the file; type plategait lab FILE.toml instead`);
    if (prefix !== "sheet.outline." && prefix !== "motion.samples." && !/waves/.test(prefix) && !Object.hasOwn(base ?? {}, key))
      throw new Error(`${name}: nothing known by that name`);
    const inner = value && typeof value === "object" && !Array.isArray(value);
    if (inner) copy[key] = merged(base?.[key] ?? (key === "plate" ? { length: 0.1, width: 0.1 } : {}), value, `${name}.`, facts);
    else copy[key] = key === "waves" && Array.isArray(value) ? value.map(wave(facts)) : si(value, name, facts);
  }
  return copy;
}

const wave = (facts) => (given, i) => {
  if (typeof given !== "object" || given === null || Array.isArray(given)) throw new Error(`motion.waves.${i}: no table of its fields`);
  const known = { axis: "z", amplitude: 0, ratio: 1, phase: 0 };
  return { ...known, ...Object.fromEntries(Object.entries(given).map(([key, value]) => [key, si(value, key, facts)])) };
};

const WORDS = new Set(["name", "shape", "law", "axis", "rows"]);

/** A number with its unit, or a list of them, in SI. */
function si(value, name, facts) {
  if (Array.isArray(value)) return value.map((item) => si(item, name, facts));
  if (typeof value === "bigint") return Number(value);
  if (typeof value !== "string" || WORDS.has(name.split(".").pop())) return value;
  const match = /^\s*([-+]?[\d.]+(?:e[-+]?\d+)?)\s*(.*?)\s*$/i.exec(value);
  const unit = match?.[2] ?? "";
  if (!match || (unit && !Object.hasOwn(facts.units, unit))) throw new Error(`${name}: “${value.slice(0, 40)}” is no number with a unit known here`);
  return Number(match[1]) * (unit ? facts.units[unit][0] : 1);
}
