// A link that holds the scenario: what differs from a preset, in the address's fragment, which no server ever sees.
import { differences } from "./change.js";

const LONGEST = 20_000;

/** The fragment of a link to a scenario. */
export function fragmentOf(scenario, facts) {
  const name = Object.hasOwn(facts.presets, scenario.name) ? scenario.name : Object.keys(facts.presets)[0];
  const preset = facts.presets[name].scenario;
  // An outline goes as a whole: what tells one kind is no part of another.
  const names = differences(preset, scenario).map((field) => (field.startsWith("sheet.outline.") ? "sheet.outline" : field));
  const changed = Object.fromEntries([...new Set(names)].map((field) => [field, plain(scenario, field)]));
  return `#${encodeURIComponent(JSON.stringify({ v: 1, of: name, with: changed }))}`;
}

// Dotted names as they are stored, without the page's shorthands.
const plain = (scenario, field) => field.split(".").reduce((part, key) => part?.[key], scenario) ?? null;

/**
 * The scenario that a fragment holds; null where there is none.
 *
 * @throws {Error} where it is spoilt
 */
export function scenarioOf(fragment, facts) {
  const text = fragment.replace(/^#/, "");
  if (!text) return null;
  if (text.length > LONGEST) throw new Error("the link is too long to be one of this page's");
  let held;
  try {
    held = JSON.parse(decodeURIComponent(text));
  } catch {
    throw new Error("the link is spoilt: it was cut off, or changed on its way");
  }
  if (held === null || typeof held !== "object" || !Object.hasOwn(facts.presets, held.of ?? ""))
    throw new Error("the link is of no preset that this page knows");
  const scenario = structuredClone(facts.presets[held.of].scenario);
  for (const [name, value] of Object.entries(held.with ?? {})) {
    if (!/^[a-z_]+(\.[a-z_0-9]+)*$/.test(name) || /__proto__|constructor|prototype/.test(name))
      throw new Error("the link names something that no scenario has");
    const keys = name.split(".");
    let part = scenario;
    for (const key of keys.slice(0, -1)) {
      if (part[key] === null || typeof part[key] !== "object") part[key] = {};
      part = part[key];
    }
    part[keys.at(-1)] = value;
  }
  return scenario;
}

