// What the lab makes of recordings and curves that the package sends it as JSON on standard input.
import { readFileSync } from "node:fs";
import { together } from "../../src/simulation/ensemble.js";
import { observe } from "../../src/simulation/observe.js";

const doubles = (text) => {
  const bytes = Buffer.from(text, "base64");
  return new Float64Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
};

const { runs, points } = JSON.parse(readFileSync(0, "utf8"));
const observations = runs.map(({ scenario, channels, diverged }) => {
  const decoded = Object.fromEntries(Object.entries(channels).map(([name, text]) => [name, doubles(text)]));
  return observe(scenario, { channels: decoded, diverged });
});
// Numbers that JSON cannot hold go as words.
const worded = (_, value) => (typeof value === "number" && !Number.isFinite(value) ? String(value) : value);
const ensembles = together(points.map((numbers) => numbers.map((number) => observations[number])));
process.stdout.write(JSON.stringify({ observations, ensembles }, worded));
