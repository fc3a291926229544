// The grid of a map: which parameters there are, their values, the order of cells, and the map as a file.
import { valueOf } from "../app/change.js";
import { observableColumns } from "../curve/file.js";

const DEGREE = Math.PI / 180;
const COARSEST = 8;
// Of the run, not of the object or its motion; a map has a control of its own for them.
const OF_THE_RUN = new Set(["duration", "transient", "time_step", "motion.ramp"]);
// What changes several fields together.
const SHORTHANDS = new Set(["natural_frequency", "friction_angle"]);
// Sheets that differ in these differ in their lattices, of which a module runs one at a time.
const OF_THE_LATTICE = /^sheet\.(outline|pitch)/;

/** Numbers of a scenario that a map can go over: fields of the model that this scenario has. */
export const parametersOf = (facts, scenario) => {
  const seen = new Set();
  const shorthands = (facts.shorthands ?? []).filter(({ name }) => SHORTHANDS.has(name));
  return [...facts.fields, ...shorthands].filter((field) => {
    const { name, kind, choices, on } = field;
    if (seen.has(name) || name.includes("*") || OF_THE_RUN.has(name) || choices || (kind ?? "number") !== "number") return false;
    if (!Number.isFinite(numberOf(scenario, name)) || (on && !on.includes(valueOf(scenario, `${name.replace(/\.[^.]*$/, "")}.shape`)))) {
      return false;
    }
    seen.add(name);
    return true;
  });
};

/** What a scenario has by a name; NaN where it has nothing, or a sheet that has no such mode. */
const numberOf = (scenario, name) => {
  try {
    return valueOf(scenario, name);
  } catch {
    return NaN;
  }
};

/** A parameter's words: "motion angle". */
export const wordsOf = ({ name }) => name.replaceAll(/[._]/g, " ");

/** Values from one to another, evenly apart, or evenly in their logarithm. */
export const valuesOf = (from, to, count, even) =>
  Array.from({ length: count }, (_, i) => {
    const share = i / (count - 1);
    return Number((even ? from + share * (to - from) : from * (to / from) ** share).toPrecision(12));
  });

/** Cells from coarse to fine; of each step those of one lattice together. */
export const cellsOf = (x, y) => {
  const [nx, ny] = [x.values.length, y.values.length];
  const byRow = OF_THE_LATTICE.test(y.field.name);
  const seen = new Set();
  const cells = [];
  for (let step = COARSEST; step >= 1; step /= 2) {
    const own = [];
    for (let i = 0; i < nx; i += step) for (let j = 0; j < ny; j += step) if (!seen.has(`${i},${j}`)) own.push({ i, j });
    if (byRow) own.sort((a, b) => a.j - b.j || a.i - b.i);
    for (const cell of own) seen.add(`${cell.i},${cell.j}`);
    cells.push(...own);
  }
  return cells;
};

/** The coarse cell that stands in for one that is not there yet; undefined where there is none. */
export const standIn = (cells, i, j) => {
  for (let step = 2; step <= COARSEST; step *= 2) {
    const coarse = cells.get(`${i - (i % step)},${j - (j % step)}`);
    if (coarse) return coarse;
  }
  return undefined;
};

const heading = ({ name, display }) => (display ? `${name}_${display.replaceAll("/", "_")}` : name);

const cell = (value) => {
  if (typeof value === "number") return Number.isFinite(value) ? String(Number(value.toPrecision(10))) : "";
  // What a spreadsheet would take for a formula stays text.
  const text = String(value ?? "").replace(/^[=+\-@]/, "'$&");
  return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
};

/** A map as CSV text: a row for each cell that was computed. */
export const mapCsv = (x, y, points) => {
  const observables = observableColumns();
  const rows = [[
    heading(x.field), heading(y.field), "spin_rate_deg_s", "spin_rate_sd_deg_s", "gait", "failure", "runs", "failed_runs",
    ...observables.map(({ heading: each }) => each), "note",
  ]];
  for (const [key, point] of points) {
    const [i, j] = key.split(",").map(Number);
    const place = [x.values[i] / x.field.factor, y.values[j] / y.field.factor];
    if (point.refused) rows.push([...place, ...Array.from({ length: 6 + observables.length }, () => ""), point.refused]);
    else {
      rows.push([...place, point.rate / DEGREE, point.spread / DEGREE, point.gait, point.failure, point.runs, point.failedRuns,
        ...observables.map(({ name, scale }) => scale * point.values[name]), ""]);
    }
  }
  return rows.map((row) => `${row.map(cell).join(",")}\n`).join("");
};
