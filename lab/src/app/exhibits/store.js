// A store's points: its curve or its map, with the run behind each point.
import { button, choice, make } from "../elements.js";
import { heatMap } from "../../charts/map.js";
import { fitInWords, spinCurve } from "../../charts/curve.js";
import { fitPoints, fittedPoints } from "../../curve/points.js";
import { withValues } from "../change.js";
import { pretty, trimmed } from "../quantity.js";

const DEG = Math.PI / 180;
const MOST_ROWS = 300; // of the table
const FREQUENCY = "motion.frequency";

export function stored(element, desk) {
  const { payload, facts } = desk;
  const { parameters, points } = payload;
  if (!parameters?.length || !points?.length) throw new Error("no points in it");
  const store = { ...payload, factors: parameters.map(({ display }) => (Object.hasOwn(facts.units, display) ? facts.units[display][0] : 1)) };
  const watch = (point) => desk.watch(withValues(structuredClone(payload.scenario), point.set));
  const chart = make("div");
  const rest = make("div", { class: "row wide" });
  element.append(make("p", {}, `${points.length} points over ${parameters.map(wordsOf).join(", ")}. `
    + "Choose a point and that motion is shown above."),
  ...(payload.notes ?? []).map((note) => make("p", { class: "note" }, note)), rest, chart, listOf(store, watch));
  const plot = (parameters.length > 1 && payload.grid ? mapOf : curveOf)(chart, rest, store, watch);
  return { shown: () => plot.resize() };
}

const wordsOf = ({ name }) => name.replaceAll(/[._]/g, " ");
const labelOf = (parameter) => `${wordsOf(parameter)}${parameter.display ? ` (${pretty(parameter.display)})` : ""}`;

/** A parameter's value as people read it; words stay words. */
const readable = ({ factors }, k, value) => (typeof value === "number" ? value / factors[k] : value);

/** Spin rate over one parameter; of points that are no grid over whichever is chosen. */
function curveOf(chart, rest, store, watch) {
  const { parameters, points, repeats } = store;
  const plot = spinCurve(chart, { onPick: (picked) => watch(picked.point) });
  const words = make("p", { class: "study-words" });
  chart.append(words);
  const draw = (k) => {
    const over = points.filter((point) => typeof point.at[k] === "number").map((point) => ({
      point, frequency: readable(store, k, point.at[k]), rate: point.spin_rate ?? NaN, spread: point.spread ?? NaN, gait: point.gait,
      failure: point.failure ?? "", failureTime: point.failure_time ?? NaN, failed: point.failed, runs: repeats,
      failedRuns: point.failed_runs, partlyFailed: point.failed_runs > 0 && point.failed_runs < repeats,
    }));
    const isCurve = parameters.length === 1 && parameters[k].name === FREQUENCY;
    const fit = isCurve ? fitPoints(over) : null;
    const used = isCurve ? fittedPoints(over) : over.map(() => true);
    words.textContent = fitInWords(fit);
    plot.update({ points: over.map((point, i) => ({ ...point, fitted: used[i] })), fit, label: labelOf(parameters[k]), unit: pretty(parameters[k].display) });
  };
  const numbers = parameters.map((_, k) => k).filter((k) => points.some((point) => typeof point.at[k] === "number"));
  if (numbers.length > 1) {
    rest.append(choice("Parameter across", numbers.map((k) => [String(k), labelOf(parameters[k])]), String(numbers[0]), (k) => draw(Number(k))));
  }
  draw(numbers[0] ?? 0);
  return plot;
}

/** An observable over the first two parameters; of the others one value each is chosen. */
function mapOf(chart, rest, store, watch) {
  const { parameters, points, observables } = store;
  const others = parameters.slice(2).map((_, k) => k + 2);
  const fixed = Object.fromEntries(others.map((k) => [k, parameters[k].values[0]]));
  const shown = [{ name: "spin_rate", label: "spin rate", unit: "°/s", of: (point) => (point.spin_rate ?? NaN) / DEG },
    ...observables.map(({ name, label, display, scale }) => ({
      name, label: label || name, unit: pretty(display), of: ({ values }) => (values[name] ?? NaN) * (display === "%" ? 100 : scale) }))];
  let which = shown[0];
  let here = new Map();
  const plot = heatMap(chart, { onPick: ({ i, j }) => here.has(`${i},${j}`) && watch(here.get(`${i},${j}`)) });
  const [x, y] = parameters;
  const draw = () => {
    const kept = points.filter((point) => others.every((k) => point.at[k] === fixed[k]));
    here = new Map(kept.map((point) => [`${x.values.indexOf(point.at[0])},${y.values.indexOf(point.at[1])}`, point]));
    const cells = new Map([...here].map(([key, point]) => [key,
      { value: which.of(point), gait: point.gait, failed: point.failed, failure: point.failure ?? "" }]));
    const axis = (k) => ({ label: labelOf(parameters[k]), values: parameters[k].values.map((value) => readable(store, k, value)) });
    plot.update({ x: axis(0), y: axis(1), cells, label: which.label, unit: which.unit });
  };
  rest.append(choice("What the map shows", shown.map(({ name, label }) => [name, label]), which.name, (name) => {
    which = shown.find((each) => each.name === name);
    draw();
  }), ...others.map((k) => choice(wordsOf(parameters[k]),
    parameters[k].values.map((value, i) => [String(i), `${wordsOf(parameters[k])} ${toldOf(store, k, value)}`]), "0", (i) => {
      fixed[k] = parameters[k].values[Number(i)];
      draw();
    })));
  draw();
  return plot;
}

const toldOf = (store, k, value) => {
  const read = readable(store, k, value);
  return typeof read === "number" ? `${trimmed(read)} ${pretty(store.parameters[k].display)}`.trim() : String(read);
};

/** The points as a table, for those who would rather read. */
function listOf(store, watch) {
  const { parameters, points } = store;
  const rows = points.slice(0, MOST_ROWS).map((point) => make("tr", {},
    ...point.at.map((value, k) => make("td", {}, toldOf(store, k, value))),
    make("td", {}, point.failed ? (point.failure ?? "failed") : `${trimmed((point.spin_rate ?? NaN) / DEG, 3)} °/s`),
    make("td", {}, point.gait || "–"),
    make("td", {}, button("Watch", () => watch(point)))));
  const head = make("tr", {}, ...parameters.map((parameter) => make("th", { scope: "col" }, wordsOf(parameter))),
    make("th", { scope: "col" }, "spin rate"), make("th", { scope: "col" }, "gait"), make("th", { scope: "col" }, "the run"));
  const body = make("div", { class: "scroll" }, make("table", {}, make("thead", {}, head), make("tbody", {}, ...rows)));
  return make("details", {}, make("summary", {}, `The points as a table${points.length > MOST_ROWS ? ` (the first ${MOST_ROWS})` : ""}`), body);
}
