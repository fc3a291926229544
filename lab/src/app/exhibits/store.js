// A store's points: its curve or its map, with the run behind each point.
import { button, choice, make } from "../elements.js";
import { heatMap } from "../../charts/map.js";
import { spinCurve } from "../../charts/curve.js";
import { withValues } from "../change.js";
import { trimmed } from "../quantity.js";

const DEG = Math.PI / 180;

export function stored(element, desk) {
  const { payload } = desk;
  const { parameters, points, observables } = payload;
  if (!parameters?.length || !points?.length) throw new Error("no points in it");
  const watch = (point) => desk.watch(withValues(structuredClone(payload.scenario), point.set));
  const chart = make("div");
  const rest = make("div", { class: "row wide" });
  element.append(make("p", {}, `${points.length} points over ${parameters.map(({ name }) => name).join(", ")}. `
    + "Choose a point and that motion is shown above."), rest, chart, list(points, parameters, watch));
  const draw = parameters.length === 1 ? curveOf : mapOf;
  draw(chart, rest, { parameters, points, observables, watch });
}

const factorOf = ({ display }) => ({ deg: DEG, mm: 1e-3, g: 1e-3, "pi rad/s": Math.PI, "mm/s": 1e-3 })[display] ?? 1;

function curveOf(chart, _, { parameters: [parameter], points, watch }) {
  const plot = spinCurve(chart, { onSelect: (index) => watch(points[index]), xLabel: parameter.name });
  plot.update({
    points: points.map((point) => ({
      x: point.at[0] / factorOf(parameter), rate: (point.spin_rate ?? NaN) / DEG, spread: (point.spread ?? NaN) / DEG,
      gait: point.gait, failed: point.failed, failure: point.failure })),
  });
}

function mapOf(chart, rest, { parameters, points, observables, watch }) {
  const axes = [0, 1];
  const others = parameters.slice(2).map((_, k) => k + 2);
  const fixed = Object.fromEntries(others.map((k) => [k, parameters[k].values[0]]));
  const names = [["spin_rate", "spin rate"], ...observables.map(({ name, label }) => [name, label || name])];
  let shown = "spin_rate";
  let cells = [];
  const plot = heatMap(chart, { onSelect: (index) => cells[index] && watch(cells[index]) });
  const draw = () => {
    const [x, y] = axes.map((k) => parameters[k]);
    cells = y.values.flatMap((b) => x.values.map((a) =>
      points.find((p) => p.at[0] === a && p.at[1] === b && others.every((k) => p.at[k] === fixed[k])) ?? null));
    const value = (point) => (shown === "spin_rate" ? (point.spin_rate ?? NaN) / DEG : (point.values?.[shown] ?? NaN));
    plot.update({
      x: x.values.map((each) => each / factorOf(x)), y: y.values.map((each) => each / factorOf(y)),
      xLabel: `${x.name} (${x.display || x.unit})`, yLabel: `${y.name} (${y.display || y.unit})`,
      label: shown === "spin_rate" ? "spin rate (deg/s)" : shown,
      cells: cells.map((point) => point && { value: value(point), gait: point.gait, failed: point.failed, failure: point.failure }),
    });
  };
  rest.append(choice("What the map shows", names, shown, (name) => {
    shown = name;
    draw();
  }), ...others.map((k) => choice(parameters[k].name, parameters[k].values.map((v) => [String(v), `${parameters[k].name} ${trimmed(v / factorOf(parameters[k]))}`]),
    String(fixed[k]), (value) => {
      fixed[k] = parameters[k].values.find((each) => String(each) === value);
      draw();
    })));
  draw();
}

/** The points as a table, for those who would rather read. */
function list(points, parameters, watch) {
  const rows = points.slice(0, 300).map((point) => make("tr", {},
    ...point.at.map((value, k) => make("td", {}, trimmed(value / factorOf(parameters[k])))),
    make("td", {}, point.failed ? (point.failure ?? "failed") : `${trimmed((point.spin_rate ?? NaN) / DEG, 3)} °/s`),
    make("td", {}, point.gait || "–"),
    make("td", {}, button("Watch", () => watch(point)))));
  const head = make("tr", {}, ...parameters.map(({ name, display, unit }) => make("th", { scope: "col" }, `${name} (${display || unit || "–"})`)),
    make("th", { scope: "col" }, "spin rate"), make("th", { scope: "col" }, "gait"), make("th", { scope: "col" }, "the run"));
  const body = make("div", { class: "scroll" }, make("table", {}, make("thead", {}, head), make("tbody", {}, ...rows)));
  return make("details", {}, make("summary", {}, `The points as a table${points.length > 300 ? " (the first 300)" : ""}`), body);
}
