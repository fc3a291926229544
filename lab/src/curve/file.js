// Spin curves as CSV files that the package reads: its curve/curve_file.py.
import { OBSERVABLES, scaleOf } from "../simulation/registry.js";

const DEGREE = Math.PI / 180;

/** A cell: a number with ten digits, nothing where there is none. Words here never hold a comma or a quote. */
const cell = (value) =>
  typeof value === "string" ? value : Number.isFinite(value) ? String(Number(value.toPrecision(10))) : "";

/** Observables of a file of a curve: heading, which tells the unit, and scale; a share stays a share. */
export const observableColumns = () =>
  OBSERVABLES.filter(({ label, name }) => label || name.startsWith("twist_")).map((observable) => {
    const { name, unit, display } = observable;
    const readIn = display ?? unit;
    if (readIn === "%" || readIn === "1") return { name, heading: name, scale: 1 };
    return { name, heading: `${name}_${readIn.replaceAll("/", "_")}`, scale: scaleOf(observable) };
  });

/**
 * A curve's points as CSV text.
 *
 * @param points {frequency (Hz), …} with what `together` says of each, SI
 * @param protocol {duration (s), slip_limit (m)} of each point
 */
export const curveCsv = (points, protocol) => {
  const observables = observableColumns();
  const heading = [
    "frequency_hz", "spin_rate_deg_s", "spin_rate_sd_deg_s", "gait", "failure", "runs", "failed_runs",
    ...observables.map(({ heading: each }) => each), "duration_s", "slip_limit_mm",
  ];
  const rows = points.map((point) => [
    point.frequency, point.rate / DEGREE, point.spread > 0 ? point.spread / DEGREE : NaN, point.gait, point.failure,
    point.runs, point.failedRuns, ...observables.map(({ name, scale }) => scale * point.values[name]),
    protocol.duration, 1e3 * protocol.slip_limit,
  ]);
  return [heading, ...rows.map((row) => row.map(cell))].map((row) => `${row.join(",")}\n`).join("");
};
