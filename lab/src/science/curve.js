// The tab "Spin curve": spin rate over frequency on all workers, drawn as it is computed, with its Lorentz fit.
import { saveText } from "../app/save.js";
import { fitInParts, pointInWords, spinCurve } from "../charts/curve.js";
import { element } from "../charts/plot.js";
import { curveCsv } from "../curve/file.js";
import { fitPoints, fittedPoints } from "../curve/points.js";
import { together } from "../simulation/ensemble.js";
import { buttonOf, choiceField, faultLine, notAllowed, quantity, textField, whole } from "./form.js";
import { readCurve, storedCurves } from "./overlays.js";
import { coarseFirst, fileName, observeAll, oncePerPicture } from "./work.js";

const MOST_POINTS = 200;
const MOST_REPEATS = 32;
const MOST_RUNS = 2000;
const MOST_SECONDS = 60;
const SEED = 0;
const FIT_EVERY = 300; // ms while points come
const MOST_BYTES = 2e6; // of a measured curve
const SECONDS = { unit: "s", display: "s", factor: 1, example: "2 s", above: 0, at_least: null, at_most: MOST_SECONDS };

/** Frequencies from `from` to `to`, both included. */
export const frequenciesOf = (from, to, count) =>
  Array.from({ length: count }, (_, i) => Number((from + (i * (to - from)) / (count - 1)).toPrecision(12)));

/** Scenario of a point: measured after three tenths of its time, as the package does. */
export const scenarioAt = (scenario, frequency, duration) =>
  ({ ...scenario, duration, transient: null, motion: { ...scenario.motion, frequency } });

/**
 * @param {HTMLElement} el
 * @param {object} desk scenario(), pool, facts, payload, watch(scenario), on("change", fn)
 */
export const curveTab = (el, desk) => {
  const units = desk.facts.units;
  const hertz = desk.facts.fields.find(({ name }) => name === "motion.frequency");
  const fields = {
    from: textField("from", "12", "Hz"), to: textField("to", "30", "Hz"), points: textField("points", "30"),
    seconds: textField("time of a point", "2", "s"), repeats: textField("starts of a point", "1"),
  };
  const fault = faultLine(() => Object.values(fields));
  const state = { points: [], scenario: null, told: null, stop: null, refused: "", own: [] };
  const asked = () => {
    const told = {
      from: quantity("from", fields.from.input.value, hertz, units),
      to: quantity("to", fields.to.input.value, hertz, units),
      count: whole("points", fields.points.input.value, 2, MOST_POINTS),
      duration: quantity("time of a point", fields.seconds.input.value, SECONDS, units),
      repeats: whole("starts of a point", fields.repeats.input.value, 1, MOST_REPEATS),
    };
    if (!(told.to > told.from)) throw notAllowed("to", fields.to.input.value, `above ${told.from} Hz, where the curve begins`);
    if (told.count * told.repeats > MOST_RUNS) {
      throw notAllowed("starts of a point", `${told.count * told.repeats} runs in all`, `at most ${MOST_RUNS} runs`);
    }
    return told;
  };
  const page = layout(el, fields, fault.line, {
    run: () => {
      if (state.stop) return state.stop.abort();
      fault.clear();
      try {
        return void compute(desk, state, asked(), page, draw);
      } catch (error) {
        return fault.tell(error);
      }
    },
    save: () => saveText(`${fileName(state.scenario.name)}-curve.csv`,
      curveCsv(state.points, { duration: state.told.duration, slip_limit: state.scenario.slip_limit }), "text/csv"),
    open: async (file) => {
      fault.clear();
      try {
        if (file.size > MOST_BYTES) throw notAllowed(file.name, `${Math.round(file.size / 1e6)} MB`, "a curve of 2 MB at most");
        state.own.push(readCurve(file.name, await file.text()));
        page.fillOverlays(stored, state.own, `own ${state.own.length - 1}`);
        draw();
      } catch (error) {
        fault.tell(error);
      }
    },
    overlay: () => draw(),
  });
  const stored = storedCurves(desk.payload, units);
  page.fillOverlays(stored, state.own, stored.length ? "stored 0" : "");
  const watch = (point) => desk.watch({ ...state.scenario, motion: { ...state.scenario.motion, frequency: point.frequency } });
  const chart = spinCurve(page.chart, { onPick: watch });
  const draw = oncePerPicture(() => {
    const fit = fitOf(state);
    const used = fittedPoints(state.points);
    const points = state.points.map((point, i) => ({ ...point, fitted: used[i] }));
    chart.update({ points, fit, from: state.told?.from, to: state.told?.to, overlays: page.overlays(stored, state.own) });
    page.tell(state, fit, watch);
  });
  draw();
  return { shown: () => chart.resize(), hidden() {}, destroy: () => (state.stop?.abort(), chart.destroy()) };
};

/** Fit of the points so far, anew at the end and not too often before it. */
const fitOf = (state) => {
  const now = performance.now();
  if (!state.stop || now - (state.fittedAt ?? 0) > FIT_EVERY) {
    state.fit = state.points.length ? fitPoints(state.points) : null;
    state.fittedAt = now;
  }
  return state.fit;
};

/** Run all points, coarse first, each drawn as it comes. */
const compute = async (desk, state, told, page, draw) => {
  const scenario = structuredClone(desk.scenario());
  Object.assign(state, { points: [], fit: null, scenario, told, stop: new AbortController(), refused: "", began: performance.now() });
  const frequencies = frequenciesOf(told.from, told.to, told.count);
  page.running(true);
  draw();
  const { signal } = state.stop;
  await observeAll({
    pool: desk.pool, items: coarseFirst(told.count).map((i) => frequencies[i]), repeats: told.repeats, seed: SEED, signal,
    scenarioOf: (frequency) => scenarioAt(scenario, frequency, told.duration),
    onObserved: (frequency, runs) => {
      state.points.push({ frequency, ...together([runs])[0] });
      state.points.sort((a, b) => a.frequency - b.frequency);
      draw();
    },
    onRefused: (frequency, message) => {
      state.refused = `${frequency} Hz cannot be run: ${message}`;
      draw();
    },
  });
  state.took = (performance.now() - state.began) / 1000;
  state.stop = null;
  page.running(false);
  draw();
};

/** The tab's elements, and what is told in them. */
const layout = (el, fields, faultElement, act) => {
  const form = element("form", "study-fields");
  form.append(...Object.values(fields).map(({ label }) => label));
  const run = element("button", "play", "Run");
  run.type = "submit";
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    act.run();
  });
  form.append(run);
  const progress = document.createElement("progress");
  progress.setAttribute("aria-label", "Points of the curve that are done");
  progress.max = 1;
  progress.value = 0;
  const save = buttonOf("Save CSV", act.save);
  save.disabled = true;
  const file = document.createElement("input");
  Object.assign(file, { type: "file", accept: ".csv,text/csv", hidden: true });
  file.addEventListener("change", () => {
    if (file.files[0]) act.open(file.files[0]);
    file.value = "";
  });
  const overlay = choiceField("beside it", [["", "no other curve"]], "");
  overlay.input.addEventListener("change", act.overlay);
  const actions = element("div", "study-actions");
  const count = element("span", "study-count");
  actions.append(progress, count, save, buttonOf("Open a measured curve…", () => file.click()), file, overlay.label);
  const status = element("p", "study-status");
  status.setAttribute("role", "status");
  const words = element("p", "study-words");
  const chart = element("div");
  const table = tableOf();
  el.append(form, faultElement, actions, status, chart, words, table.details);
  return {
    chart,
    running(on) {
      run.textContent = on ? "Stop" : "Run";
    },
    fillOverlays(stored, own, chosen) {
      overlay.fill([["", "no other curve"], ...stored.map(({ name }, i) => [`stored ${i}`, name, "of the store"]),
        ...(stored.length > 1 ? [["stored", "all of the store's", "of the store"]] : []),
        ...own.map(({ name }, i) => [`own ${i}`, name, "measured"])], chosen);
    },
    overlays(stored, own) {
      const [kind, number] = overlay.input.value.split(" ");
      const list = { stored, own }[kind] ?? [];
      return number === undefined ? list : [list[Number(number)]].filter(Boolean);
    },
    tell(state, fit, watch) {
      save.disabled = !state.points.length;
      progress.value = state.told ? state.points.length / state.told.count : 0;
      count.textContent = state.told ? `${state.points.length} of ${state.told.count}` : "";
      // A live region: told when it begins and ends, not with every point.
      const now = statusOf(state);
      if (status.textContent !== now) status.textContent = now;
      words.replaceChildren(...fitInParts(fit).flatMap((part) => [element("span", "", part), " "]));
      if (!state.stop) table.update(state.points, watch);
    },
  };
};

const statusOf = ({ points, told, scenario, stop, took, refused }) => {
  if (!told) return "Computes the spin rate of the sheet on the plate at each frequency, on all of the computer's cores.";
  const count = stop ? `computing ${told.count} points of ${scenario.name}` : `${points.length} points of ${scenario.name}`;
  const how = `fails at a slip of ${Number((1e3 * scenario.slip_limit).toPrecision(3))} mm`;
  const end = stop ? "" : `${points.length < told.count && !refused ? "stopped after" : "in"} ${took.toFixed(1)} s`;
  return [count, how, end, refused].filter(Boolean).join(" · ");
};

/** The points in words, for who would rather read, each with a button that shows its motion. */
const tableOf = () => {
  const details = document.createElement("details");
  const body = element("div", "study-table");
  body.tabIndex = 0;
  body.setAttribute("role", "region");
  body.setAttribute("aria-label", "Points of the curve");
  details.append(element("summary", "", "Points as a list"), body);
  let last = null;
  let shown = [];
  const fill = () => {
    if (!details.open) return;
    const list = element("ul");
    for (const point of shown) {
      const item = element("li", "", `${pointInWords(point)} `);
      item.append(buttonOf(`Watch ${Number(point.frequency.toPrecision(4))} Hz`, () => last(point)));
      list.append(item);
    }
    body.replaceChildren(list);
  };
  details.addEventListener("toggle", fill);
  return {
    details,
    update(points, watch) {
      [shown, last] = [points, watch];
      fill();
    },
  };
};
