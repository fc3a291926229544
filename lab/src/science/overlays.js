// Curves to lay over the one that is computed: a store's, and measured ones of a file.
import { pretty } from "../app/quantity.js";
import { read } from "../charts/plot.js";

const DEGREE = Math.PI / 180;
const MOST_CURVES = 60;

/** Curves over the frequency that a store holds, one for each combination of its other parameters. */
export const storedCurves = (payload, units = {}) => {
  if (payload?.kind !== "store" || !Array.isArray(payload.points) || !Array.isArray(payload.parameters)) return [];
  const names = payload.parameters.map(({ name }) => name);
  const which = names.indexOf("motion.frequency");
  if (which < 0) return [];
  const curves = new Map();
  for (const { at, spin_rate: rate } of payload.points) {
    if (!Array.isArray(at) || !Number.isFinite(at[which])) continue; // data that were damaged on their way
    const others = names.map((name, i) => (i === which ? "" : worded(name, at[i], payload.parameters[i], units))).filter(Boolean);
    const name = others.join(", ") || String(payload.name ?? "store");
    if (!curves.has(name) && curves.size >= MOST_CURVES) continue;
    if (!curves.has(name)) curves.set(name, []);
    curves.get(name).push({ frequency: at[which], rate: rate ?? NaN });
  }
  return [...curves].map(([name, points]) => ({ name, points: sorted(points) }));
};

const worded = (name, value, { display }, units) => {
  const short = name.split(".").at(-1).replaceAll("_", " ");
  if (typeof value !== "number") return `${short} ${String(value)}`;
  const [factor] = Object.hasOwn(units, display) ? units[display] : [1];
  return `${short} ${read(value / factor, 4)} ${pretty(display)}`.trim();
};

const sorted = (points) => points.sort((a, b) => a.frequency - b.frequency);

const RATES = { spin_rate_deg_s: DEGREE, spin_rate_rad_s: 1, spin_rate: DEGREE };
const FREQUENCIES = { frequency_hz: 1, frequency: 1 };

/**
 * Curve of a CSV file with the headings frequency_hz and spin_rate_deg_s (or spin_rate_rad_s).
 *
 * @throws {Error} in one line, with what the file must have
 */
export const readCurve = (name, text) => {
  const lines = text.replace(/^\ufeff/, "").split(/\r?\n/).filter((line) => line.trim() && !line.startsWith("#"));
  const separator = lines[0]?.includes(";") ? ";" : lines[0]?.includes("\t") ? "\t" : ",";
  const headings = (lines[0] ?? "").split(separator).map((word) => word.trim().toLowerCase().replace(/^"|"$/g, ""));
  const columnOf = (known) => headings.findIndex((heading) => Object.hasOwn(known, heading));
  const [f, r] = [columnOf(FREQUENCIES), columnOf(RATES)];
  if (f < 0 || r < 0) {
    throw new Error(`${name}: got the columns ${headings.slice(0, 5).join(", ").slice(0, 80)}, must be frequency_hz and spin_rate_deg_s`);
  }
  const number = (cell) => (cell?.trim() ? Number(separator === ";" ? cell.replace(",", ".") : cell) : NaN);
  const points = lines.slice(1).map((line) => line.split(separator)).map((cells) => ({
    frequency: FREQUENCIES[headings[f]] * number(cells[f]), rate: RATES[headings[r]] * number(cells[r]),
  })).filter(({ frequency }) => frequency > 0 && frequency < Infinity);
  if (!points.length) throw new Error(`${name}: got no row with a frequency above 0 Hz, must be one row for each point`);
  return { name: name.replace(/\.[^.]*$/, ""), points: sorted(points) };
};
