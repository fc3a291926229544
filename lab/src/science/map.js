// The tab "Map": an observable over any two parameters, coarse first, on all workers.
import { valueOf, withValue } from "../app/change.js";
import { pretty } from "../app/quantity.js";
import { saveText } from "../app/save.js";
import { heatMap } from "../charts/map.js";
import { element, read } from "../charts/plot.js";
import { together } from "../simulation/ensemble.js";
import { FAILURES, GAITS } from "../simulation/observables.js";
import { OBSERVABLES, scaleOf } from "../simulation/registry.js";
import { buttonOf, choiceField, faultLine, notAllowed, quantity, textField, whole } from "./form.js";
import { cellsOf, mapCsv, parametersOf, standIn, valuesOf, wordsOf } from "./grid.js";
import { fileName, observeAll, oncePerPicture } from "./work.js";

const MOST_CELLS = 2000;
const MOST_ON_AN_AXIS = 100;
const MOST_REPEATS = 16;
const MOST_SECONDS = 20;
const SEED = 0;
const SECONDS = { unit: "s", display: "s", factor: 1, example: "1 s", above: 0, at_least: null, at_most: MOST_SECONDS };
const DEGREE = Math.PI / 180;
const FIRST = ["motion.frequency", "motion.angle"];

/** What a map can show: a number of each point in people's units, or one of some words. */
export const SHOWN = [
  { name: "spin_rate", label: "spin rate", unit: "°/s", of: (point) => point.rate / DEGREE },
  { name: "gait", label: "gait", unit: "", categories: GAITS, of: ({ gait }) => (gait ? GAITS.indexOf(gait) : NaN) },
  { name: "failure", label: "failure", unit: "", categories: ["none", ...FAILURES],
    of: ({ failure, failed }) => (failed ? 1 + FAILURES.indexOf(failure) : 0) },
  { name: "spread", label: "spread of the spin rate", unit: "°/s", of: (point) => point.spread / DEGREE },
  ...OBSERVABLES.filter(({ label }) => label).map((observable) => ({
    name: observable.name, label: observable.label, unit: pretty(observable.display ?? observable.unit),
    of: ({ values }) => scaleOf(observable) * values[observable.name],
  })),
  { name: "energy_imbalance", label: "energy out of balance", unit: "%", of: ({ values }) => 100 * values.energy_imbalance },
];

/**
 * @param {HTMLElement} el
 * @param {object} desk scenario(), pool, facts, payload, watch(scenario), on("change", fn)
 */
export const mapTab = (el, desk) => {
  const axes = [axisOf("across", 0, desk), axisOf("up", 1, desk)];
  const general = { seconds: textField("time of a point", "1", "s"), repeats: textField("starts of a point", "1") };
  const fields = [...axes.flatMap((axis) => axis.fields), ...Object.values(general)];
  const shown = choiceField("show", SHOWN.map(({ name, label }) => [name, label]), "spin_rate");
  const fault = faultLine(() => fields);
  const state = { points: new Map(), told: null, scenario: null, stop: null, took: 0 };
  const asked = () => {
    const [x, y] = axes.map((axis) => axis.asked());
    if (x.field.name === y.field.name) throw notAllowed("parameter up", wordsOf(y.field), "another than the one across");
    const told = {
      x, y,
      duration: quantity("time of a point", general.seconds.input.value, SECONDS, desk.facts.units),
      repeats: whole("starts of a point", general.repeats.input.value, 1, MOST_REPEATS),
    };
    const runs = x.values.length * y.values.length * told.repeats;
    if (runs > MOST_CELLS) throw notAllowed("points up", `${runs} runs in all`, `such that there are ${MOST_CELLS} runs at most`);
    return told;
  };
  const page = layout(el, axes, Object.values(general), shown, fault.line, {
    run: () => {
      fault.clear();
      try {
        const told = asked();
        state.stop?.abort();
        Object.assign(state, { points: new Map(), told, scenario: structuredClone(desk.scenario()), took: 0 });
        compute(desk, state, draw);
      } catch (error) {
        fault.tell(error);
      }
    },
    stop: () => (state.stop ? state.stop.abort() : compute(desk, state, draw)),
    save: () => saveText(`${fileName(state.scenario.name)}-map.csv`, mapCsv(state.told.x, state.told.y, state.points), "text/csv"),
  });
  const watch = (cell) => {
    if (state.told) desk.watch(scenarioOf(state, cell));
  };
  const chart = heatMap(page.chart, { onPick: watch });
  const draw = oncePerPicture(() => {
    if (state.told) chart.update(pictureOf(state, SHOWN.find(({ name }) => name === shown.input.value)));
    page.tell(state);
  });
  shown.input.addEventListener("change", draw);
  desk.on("change", () => axes.forEach((axis) => axis.refresh()));
  page.tell(state);
  return { shown: () => chart.resize(), hidden() {}, destroy: () => (state.stop?.abort(), chart.destroy()) };
};

const scenarioOf = ({ scenario, told: { x, y } }, { i, j }) =>
  withValue(withValue(scenario, x.field.name, x.values[i]), y.field.name, y.values[j]);

/** Run the cells that are not there yet, coarse first. */
const compute = async (desk, state, draw) => {
  const { told, points } = state;
  const stop = new AbortController();
  state.stop = stop;
  const began = performance.now() - 1000 * state.took;
  draw();
  await observeAll({
    pool: desk.pool, items: cellsOf(told.x, told.y).filter(({ i, j }) => !points.has(`${i},${j}`)),
    repeats: told.repeats, seed: SEED, signal: stop.signal,
    scenarioOf: (cell) => ({ ...scenarioOf(state, cell), duration: told.duration, transient: null }),
    onObserved: ({ i, j }, runs) => {
      points.set(`${i},${j}`, together([runs])[0]);
      draw();
    },
    onRefused: ({ i, j }, message) => {
      points.set(`${i},${j}`, { refused: message });
      draw();
    },
  });
  if (state.stop !== stop) return; // another map has begun meanwhile
  state.took = (performance.now() - began) / 1000;
  state.stop = null;
  draw();
};

/** What the chart draws of the points. */
const pictureOf = ({ points, told: { x, y } }, shown) => {
  const cells = new Map([...points].map(([key, point]) => [key, point.refused ? point : {
    value: shown.of(point), gait: point.gait, failure: point.failure, failed: point.failed && shown.name !== "failure",
  }]));
  const axis = ({ field, values }) => ({
    label: field.display ? `${wordsOf(field)} (${pretty(field.display)})` : wordsOf(field),
    values: values.map((value) => value / field.factor),
  });
  return {
    x: axis(x), y: axis(y), cells, label: shown.label, unit: shown.unit, categories: shown.categories ?? null,
    step: (i, j) => standIn(cells, i, j),
  };
};

/** Controls of one axis: which parameter, from where to where, how many points, how they are spaced. */
const axisOf = (way, which, desk) => {
  const offered = () => parametersOf(desk.facts, desk.scenario());
  const fieldOf = (name) => offered().find((field) => field.name === name) ?? offered()[which];
  const rows = () => offered().map((field) => [field.name, wordsOf(field), field.name.includes(".") ? field.name.split(".")[0] : "whole"]);
  const parameter = choiceField(`parameter ${way}`, rows(), FIRST[which]);
  const from = textField(`from, ${way}`, "");
  const to = textField(`to, ${way}`, "");
  const points = textField(`points ${way}`, ["12", "10"][which]);
  const spacing = choiceField(`spacing ${way}`, [["even", "even"], ["log", "by factors"]], "even");
  const suggest = () => {
    const field = fieldOf(parameter.input.value);
    const [low, high] = around(field, valueOf(desk.scenario(), field.name));
    [from.input.value, to.input.value] = [low, high].map((value) => read(value / field.factor, 3));
    from.setUnit(field.display);
    to.setUnit(field.display);
  };
  parameter.input.addEventListener("change", suggest);
  suggest();
  return {
    fields: [parameter, from, to, points, spacing],
    refresh() {
      const names = rows().map(([name]) => name);
      if (JSON.stringify(names) === JSON.stringify([...parameter.input.options].map(({ value }) => value))) return;
      const kept = names.includes(parameter.input.value) ? parameter.input.value : FIRST[which];
      const changed = kept !== parameter.input.value;
      parameter.fill(rows(), kept);
      if (changed) suggest();
    },
    asked() {
      const field = fieldOf(parameter.input.value);
      const [low, high] = [from, to].map((each) => quantity(each.name, each.input.value, field, desk.facts.units));
      if (!(high > low)) throw notAllowed(to.name, to.input.value, `above ${from.input.value}, where the map begins`);
      const even = spacing.input.value === "even";
      if (!even && !(low > 0)) throw notAllowed(from.name, from.input.value, "above 0 where points are spaced by factors");
      return { field, values: valuesOf(low, high, whole(points.name, points.input.value, 2, MOST_ON_AN_AXIS), even) };
    },
  };
};

/** A range about a value that the field allows. */
const around = (field, value) => {
  if (field.name === "motion.frequency") return [12, 30];
  const reach = value !== 0 ? 0.4 * Math.abs(value) : field.factor * (Math.abs(Number.parseFloat(field.example)) || 1);
  const low = field.at_least ?? field.above ?? -Infinity;
  return [Math.max(value - reach, low), Math.min(value + reach, field.at_most ?? Infinity)];
};

/** The tab's elements, and what is told in them. */
const layout = (el, axes, general, shown, faultElement, act) => {
  const form = element("form", "study-fields");
  for (const axis of axes) {
    const group = element("div", "study-axis");
    group.append(...axis.fields.map(({ label }) => label));
    form.append(group);
  }
  const run = element("button", "play", "Run");
  run.type = "submit";
  const stop = buttonOf("Stop", act.stop);
  stop.disabled = true;
  form.append(...general.map(({ label }) => label), run, stop);
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    act.run();
  });
  const progress = document.createElement("progress");
  progress.setAttribute("aria-label", "Cells of the map that are done");
  progress.max = 1;
  progress.value = 0;
  const count = element("span", "study-count");
  const save = buttonOf("Save CSV", act.save);
  save.disabled = true;
  const actions = element("div", "study-actions");
  actions.append(progress, count, save, shown.label);
  const status = element("p", "study-status");
  status.setAttribute("role", "status");
  const chart = element("div");
  el.append(form, faultElement, actions, status, chart);
  return {
    chart,
    tell(state) {
      const total = state.told ? state.told.x.values.length * state.told.y.values.length : 0;
      const done = state.points.size;
      progress.value = total ? done / total : 0;
      count.textContent = total ? `${done} of ${total}` : "";
      save.disabled = done === 0;
      stop.disabled = !state.told || (!state.stop && done === total);
      stop.textContent = state.stop || stop.disabled ? "Stop" : "Go on";
      const now = statusOf(state, done, total);
      if (status.textContent !== now) status.textContent = now;
    },
  };
};

const statusOf = ({ told, scenario, stop, took, points }, done, total) => {
  if (!told) return "Computes every point of a grid over two parameters, coarse first; a click on a cell shows its motion.";
  if (stop) return `computing ${total} points of ${scenario.name}`;
  const refused = [...points.values()].filter((point) => point.refused);
  const why = refused.length ? ` · ${refused.length} cannot be run: ${refused[0].refused}` : "";
  return `${done} points of ${scenario.name} ${done < total ? "so far," : ""} in ${took.toFixed(1)} s${why}`;
};
