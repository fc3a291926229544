// A spin curve: points with their spread, gaits by shape and colour, failures apart, the Lorentz line, other curves.
import { colours, onColours } from "./colours.js";
import { lorentzian } from "../curve/lorentz.js";
import { drawMark, MARKS, markInLegend } from "./marks.js";
import { axis, element, leftAxis, plotIn, read, roomy } from "./plot.js";

const DEGREE = Math.PI / 180;
const LINE = 240; // points of a fitted line
const RADIUS = 5;
const FADED = 0.4; // what is beyond the run-off
const OVERLAYS = ["running", "walking", "failed", "sliding"];

/** What the Lorentz fit says, in words, number by number; the rates of `fit` are in rad/s. */
export const fitInParts = (fit) => {
  if (!fit) return [];
  if (fit.refused) return [`No Lorentz fit: got ${fit.refused}. Try ${fit.advice}.`];
  const line = (name, value, interval, unit) => `${name} ${read(value, 4)} ${unit} [${read(interval[0], 4)}, ${read(interval[1], 4)}]`;
  const degrees = fit.peakInterval.map((rate) => rate / DEGREE);
  return [
    line("f0", fit.f0, fit.f0Interval, "Hz"), line("b", fit.halfWidth, fit.halfWidthInterval, "Hz"),
    line("peak", fit.peak / DEGREE, degrees, "°/s"), `R² ${fit.r2.toFixed(3)}`,
  ];
};

export const fitInWords = (fit) => fitInParts(fit).join(" · ");

/** What a point shows, in words. */
export const pointInWords = (point, unit = "Hz") => {
  const sides = [`${read(point.frequency, 4)} ${unit}`.trim()];
  if (Number.isFinite(point.rate)) {
    const spread = Number.isFinite(point.spread) ? ` ± ${read(point.spread / DEGREE, 2)}` : "";
    sides.push(`${read(point.rate / DEGREE)}${spread} °/s`);
  }
  if (point.gait) sides.push(point.gait);
  if (point.failure) {
    const how = point.runs > 1 ? `${point.failedRuns} of ${point.runs} failed: ` : "";
    const when = Number.isFinite(point.failureTime) ? ` at ${read(point.failureTime, 2)} s` : "";
    sides.push(`${how}${point.failure}${when}`);
  }
  return sides.join(", ");
};

/**
 * @param {HTMLElement} el
 * @param {{onPick?: (point: object) => void}} given called with a point that was clicked, or Enter on it
 * @returns {{update(data: {points: object[], fit?: object, from?: number, to?: number,
 *   overlays?: {name: string, points: {frequency, rate}[]}[], label?: string, unit?: string}), resize(), destroy()}} points as `together` gives them,
 *   with their frequency, Hz, and whether they are `fitted`; `from` and `to` keep that range in view while points still come;
 *   `label` and `unit` tell what the curve is over where that is no frequency (which `frequency` holds all the same)
 */
export const spinCurve = (el, { onPick } = {}) => {
  el.classList.add("chart-parts");
  const legend = legendOf(el);
  const below = el.appendChild(element("div", "chart-below"));
  const readout = el.appendChild(element("p", "chart-readout"));
  let data = { points: [], overlays: [] };
  let chosen = -1;
  const draw = (u) => drawCurve(u, data, chosen);
  const words = (point) => pointInWords(point, data.unit);
  const chart = plotIn(below, {
    scales: {
      x: { time: false, range: () => xRange(data) },
      y: { range: () => yRange(data) },
    },
    series: [{}, { show: false }],
    axes: [axis(() => data.label ?? "plate frequency (Hz)"), leftAxis("spin rate (°/s)")],
    hooks: { draw: [draw] },
  }, [[0, 1], [null, null]]);
  const choose = (index) => {
    chosen = index;
    readout.textContent = index < 0 ? "" : words(data.points[index]) + (onPick ? "; click or Enter watches it" : "");
    chart.plot?.redraw(false);
    if (index >= 0) {
      below.setAttribute("aria-valuenow", String(data.points[index].frequency));
      below.setAttribute("aria-valuetext", words(data.points[index]));
    }
  };
  if (onPick) pickable(below, chart, () => data.points, () => chosen, choose, onPick);
  const describe = () => {
    const measured = data.points.filter(({ rate }) => Number.isFinite(rate)).length;
    const failed = data.points.filter((point) => point.failed).length;
    chart.describe(`Spin rate over ${data.label ?? "plate frequency"}, ${data.points.length} points: ${measured} measured, ${failed} ` +
      `failed. ${fitInWords(data.fit)}`);
  };
  describe();
  return {
    update(next) {
      data = { overlays: [], ...next, points: [...next.points].sort((a, b) => a.frequency - b.frequency) };
      if (chosen >= data.points.length) choose(-1);
      legend.update(data);
      chart.update([[0, 1], [null, null]]);
      if (onPick && data.points.length) {
        below.setAttribute("aria-valuemin", String(data.points[0].frequency));
        below.setAttribute("aria-valuemax", String(data.points.at(-1).frequency));
        if (chosen < 0) below.setAttribute("aria-valuenow", String(data.points[0].frequency));
      }
      describe();
    },
    resize: chart.resize,
    destroy() {
      legend.destroy();
      chart.destroy();
      below.remove();
      readout.remove();
    },
  };
};

const xRange = ({ points, overlays, from, to }) => {
  const all = [...points, ...overlays.flatMap((each) => each.points)].map(({ frequency }) => frequency);
  return roomy(Math.min(...all, from ?? Infinity), Math.max(...all, to ?? -Infinity), 0.04);
};

const yRange = ({ points, overlays, fit }) => {
  const all = [...points, ...overlays.flatMap((each) => each.points)].flatMap(({ rate, spread }) =>
    [rate - (spread || 0), rate + (spread || 0)]).map((rate) => rate / DEGREE).filter(Number.isFinite);
  const peak = fit && !fit.refused ? [fit.peak / DEGREE] : [];
  return roomy(Math.min(0, ...all, ...peak), Math.max(all.length ? 0 : 10, ...all, ...peak), 0.08);
};

/** Lines below, then bars and marks; failed points stand on the axis. */
const drawCurve = (u, { points, overlays, fit, from }, chosen) => {
  const { ctx } = u;
  const scale = devicePixelRatio || 1;
  const x = (frequency) => u.valToPos(frequency, "x", true);
  const y = (rate) => u.valToPos(rate / DEGREE, "y", true);
  const line = (at, colour, dash, width) => {
    ctx.beginPath();
    at.forEach(([f, rate], i) => (i ? ctx.lineTo(x(f), y(rate)) : ctx.moveTo(x(f), y(rate))));
    ctx.strokeStyle = colour;
    ctx.lineWidth = width * scale;
    ctx.setLineDash(dash.map((each) => each * scale));
    ctx.stroke();
    ctx.setLineDash([]);
  };
  ctx.save();
  ctx.beginPath();
  ctx.rect(u.bbox.left, u.bbox.top, u.bbox.width, u.bbox.height);
  ctx.clip();
  overlays.forEach((each, i) => {
    const known = each.points.filter(({ rate }) => Number.isFinite(rate));
    line(known.map(({ frequency, rate }) => [frequency, rate]), colours[OVERLAYS[i % OVERLAYS.length]], [3, 3], 1.2);
    ctx.fillStyle = colours[OVERLAYS[i % OVERLAYS.length]];
    for (const { frequency, rate } of known) {
      ctx.beginPath();
      ctx.arc(x(frequency), y(rate), 2.2 * scale, 0, 2 * Math.PI);
      ctx.fill();
    }
  });
  if (fit && !fit.refused) {
    const used = points.filter((point) => isUsed(point)).map(({ frequency }) => frequency);
    const [low, high] = [Math.min(...used, from ?? Infinity), Math.max(...used)];
    const at = Array.from({ length: LINE }, (_, i) => low + (i * (high - low)) / (LINE - 1));
    line(at.map((f) => [f, lorentzian(f, fit.peak, fit.f0, fit.halfWidth)]), colours.ink, [], 1.4);
  }
  points.forEach((point, i) => drawPoint(u, point, x(point.frequency), y, scale, i === chosen));
  ctx.restore();
};

/** Whether the fit rests on a point. */
const isUsed = (point) => Number.isFinite(point.rate) && !point.failed && point.fitted !== false;
const isBeyond = (point) => Number.isFinite(point.rate) && !point.failed && point.fitted === false;

const drawPoint = (u, point, x, y, scale, isChosen) => {
  const { ctx } = u;
  const bottom = u.bbox.top + u.bbox.height - 9 * scale;
  const known = Number.isFinite(point.rate);
  if (known && point.spread > 0) {
    ctx.strokeStyle = colours[MARKS[point.gait]?.colour ?? "muted"];
    ctx.lineWidth = 1.2 * scale;
    ctx.beginPath();
    ctx.moveTo(x, y(point.rate - point.spread));
    ctx.lineTo(x, y(point.rate + point.spread));
    ctx.stroke();
  }
  if (isChosen) {
    ctx.strokeStyle = colours.accent;
    ctx.lineWidth = 2 * scale;
    ctx.beginPath();
    ctx.arc(x, known && !point.failed ? y(point.rate) : bottom, 10 * scale, 0, 2 * Math.PI);
    ctx.stroke();
  }
  if (known && (!point.failed || point.partlyFailed)) {
    ctx.globalAlpha = isBeyond(point) ? FADED : 1;
    drawMark(ctx, point.gait, x, y(point.rate), RADIUS * scale, point.partlyFailed);
    ctx.globalAlpha = 1;
  }
  if (point.failed) drawMark(ctx, "failed", x, bottom, RADIUS * scale);
};

/** Points chosen by pointer and arrows, picked by a click or Enter. */
const pickable = (below, chart, points, chosen, choose, onPick) => {
  below.tabIndex = 0;
  below.setAttribute("role", "slider");
  below.setAttribute("aria-label", "Points of the spin curve; Enter watches the one that is chosen");
  below.setAttribute("aria-valuenow", "0");
  const nearest = (event) => {
    if (!chart.plot) return -1;
    const f = chart.plot.posToVal(event.clientX - chart.plot.over.getBoundingClientRect().left, "x");
    return points().reduce((best, point, i, all) =>
      best < 0 || Math.abs(point.frequency - f) < Math.abs(all[best].frequency - f) ? i : best, -1);
  };
  below.addEventListener("pointermove", (event) => {
    const index = nearest(event);
    if (index !== chosen()) choose(index);
  });
  below.addEventListener("click", (event) => {
    const index = nearest(event);
    choose(index);
    if (index >= 0) onPick(points()[index]);
  });
  below.addEventListener("keydown", (event) => {
    const last = points().length - 1;
    if (last < 0) return;
    const at = { ArrowRight: chosen() + 1, ArrowUp: chosen() + 1, ArrowLeft: chosen() - 1, ArrowDown: chosen() - 1, Home: 0, End: last }[event.key];
    if (at !== undefined) choose(Math.min(Math.max(at, 0), last));
    else if ((event.key === "Enter" || event.key === " ") && chosen() >= 0) onPick(points()[chosen()]);
    else return;
    event.preventDefault();
  });
};

/** What the marks mean: of those only that are in the picture. */
const legendOf = (el) => {
  const list = el.appendChild(element("p", "chart-legend"));
  let shown = "";
  let marks = [];
  const away = onColours(() => marks.forEach(({ draw }) => draw()));
  return {
    update({ points, overlays, fit }) {
      const kinds = Object.keys(MARKS).filter((kind) =>
        kind === "failed" ? points.some(({ failed }) => failed)
          : points.some((point) => point.gait === kind && Number.isFinite(point.rate)));
      const partly = points.some(({ partlyFailed }) => partlyFailed);
      const beyond = points.some(isBeyond);
      const key = JSON.stringify([kinds, partly, beyond, overlays.map(({ name }) => name), Boolean(fit && !fit.refused)]);
      if (key === shown) return;
      shown = key;
      marks = kinds.map((kind) => markInLegend(kind, kind || "gait unknown"));
      if (partly) marks.push(markInLegend("", "half-filled: some of the runs failed", true));
      const items = marks.map(({ item }) => item);
      if (beyond) items.push(element("span", "", "faded: beyond the run-off, left out of the fit"));
      if (fit && !fit.refused) items.push(lineInLegend("ink", 0, "Lorentz fit"));
      overlays.forEach(({ name }, i) => items.push(lineInLegend(OVERLAYS[i % OVERLAYS.length], 2, name)));
      list.replaceChildren(...items);
    },
    destroy() {
      away();
      list.remove();
    },
  };
};

const lineInLegend = (colour, dash, text) => {
  const item = element("span");
  const line = element("i", `line line-${dash}`);
  line.style.color = `var(--${colour})`;
  item.append(line, text);
  return item;
};
