// A map over two parameters: values by an even scale of colours, letters for gaits, hatching where a point failed.
import { colours, inkOn, onColours, scaleColour } from "./colours.js";
import { MARKS } from "./marks.js";
import { axis, element, leftAxis, plotIn, read } from "./plot.js";

/**
 * @param {HTMLElement} el
 * @param {{onPick?: (cell: {i: number, j: number}) => void}} given called with a cell that was clicked, or Enter on it
 * @returns {{update(data: object), resize(), destroy()}} data: x and y {label, values} in people's units, `cells` a map of
 *   "i,j" to {value, gait, failed, failure, refused} with values in people's units, `label` and `unit` of the values; where
 *   these are the numbers of words, the words as `categories`; `step(i, j)` the coarse cell that stands in for one that is not computed yet, or null
 */
export const heatMap = (el, { onPick } = {}) => {
  el.classList.add("chart-parts");
  const legend = legendOf(el);
  const below = el.appendChild(element("div", "chart-below"));
  const readout = el.appendChild(element("p", "chart-readout"));
  readout.setAttribute("aria-live", "polite");
  let data = { x: { label: "", values: [0, 1] }, y: { label: "", values: [0, 1] }, cells: new Map(), label: "", unit: "" };
  let chosen = null;
  // Cells are drawn by their number, so that they are of one size whatever the spacing of the values.
  const chart = plotIn(below, {
    scales: { x: { time: false, range: () => [0, data.x.values.length] }, y: { range: () => [0, data.y.values.length] } },
    series: [{}, { show: false }],
    axes: [
      axis(() => data.x.label, { ...ticksOf(() => data.x.values, 60), grid: { show: false } }),
      leftAxis(() => data.y.label, { ...ticksOf(() => data.y.values, 28), grid: { show: false } }),
    ],
    hooks: { draw: [(u) => drawCells(u, data, chosen)] },
  }, [[0, 1], [null, null]]);
  const choose = (cell) => {
    chosen = cell;
    readout.textContent = cell ? cellInWords(data, cell) : "";
    chart.plot?.redraw(false);
  };
  if (onPick) pickable(below, chart, () => data, () => chosen, choose, onPick);
  return {
    update(next) {
      const moved = JSON.stringify([data.x, data.y]) !== JSON.stringify([next.x, next.y]);
      data = next;
      const [nx, ny] = [data.x.values.length, data.y.values.length];
      if (chosen && (chosen.i >= nx || chosen.j >= ny)) choose(null);
      legend.update(data);
      chart.update([[0, 1], [null, null]]);
      // Cells are drawn by number: their range may be the same where the values on the axes are others.
      if (moved) chart.plot?.redraw(true, true);
      const done = [...data.cells.values()];
      const [low, high] = extent(data);
      const failed = done.filter((cell) => cell.failed).length;
      chart.describe(`Map of ${data.label} over ${data.x.label} and ${data.y.label}: ${done.length} of ${nx * ny} cells, ` +
        `from ${read(low)} to ${read(high)} ${data.unit}, ${failed} failed`);
    },
    resize: chart.resize,
    destroy() {
      chart.destroy();
      legend.remove();
      below.remove();
      readout.remove();
    },
  };
};

/** Least and largest of the values that there are. */
const extent = ({ cells, categories }) => {
  if (categories) return [0, categories.length - 1];
  const values = [...cells.values()].filter((cell) => !cell.failed).map(({ value }) => value).filter(Number.isFinite);
  return values.length ? [Math.min(...values), Math.max(...values)] : [NaN, NaN];
};

const shareOf = (value, [low, high]) => (high > low ? (value - low) / (high - low) : 0.5);

/** A value of an axis: a number, or a word such as a law of friction. */
const told = (value, count) => (typeof value === "string" ? value : read(value, count));

/** Marks of an axis in the middle of cells, no nearer than `space` pixels. */
const ticksOf = (valuesOf, space) => ({
  splits: (u, index) => {
    const n = valuesOf().length;
    const pixels = (index === 0 ? u.bbox.width : u.bbox.height) / (devicePixelRatio || 1);
    const every = Math.max(1, Math.ceil((n * space) / Math.max(pixels, 1)));
    return Array.from({ length: Math.ceil(n / every) }, (_, k) => k * every + 0.5);
  },
  values: (_, splits) => splits.map((at) => told(valuesOf()[Math.floor(at)] ?? NaN)),
});

const drawCells = (u, data, chosen) => {
  const { ctx } = u;
  const scale = devicePixelRatio || 1;
  const [nx, ny] = [data.x.values.length, data.y.values.length];
  const [w, h] = [u.bbox.width / nx, u.bbox.height / ny];
  const ends = extent(data);
  const letters = Math.min(w, h) > 13 * scale;
  ctx.save();
  ctx.font = `${11 * scale}px system-ui, sans-serif`;
  ctx.textAlign = "center";
  ctx.textBaseline = "middle";
  for (let i = 0; i < nx; i++) {
    for (let j = 0; j < ny; j++) {
      const own = data.cells.get(`${i},${j}`);
      const cell = own ?? data.step?.(i, j);
      if (!cell) continue;
      const [left, top] = [Math.round(u.bbox.left + i * w), Math.round(u.bbox.top + (ny - 1 - j) * h)];
      const [right, bottom] = [Math.round(u.bbox.left + (i + 1) * w), Math.round(u.bbox.top + (ny - j) * h)];
      ctx.globalAlpha = own ? 1 : 0.45;
      drawCell(ctx, [left, top, right - left, bottom - top], cell, lookOf(data, cell, ends), letters && own, scale);
      ctx.globalAlpha = 1;
    }
  }
  // A ring of two colours, of which one is seen on whatever lies below.
  for (const [colour, width] of chosen ? [[colours.ink, 5], [colours.paper, 2]] : []) {
    ctx.strokeStyle = colour;
    ctx.lineWidth = width * scale;
    ctx.strokeRect(u.bbox.left + chosen.i * w, u.bbox.top + (ny - 1 - chosen.j) * h, w, h);
  }
  ctx.restore();
};

/** Colour of a word of a map of words: gaits have theirs everywhere. */
const wordColour = (categories, i) => {
  if (MARKS[categories[i]]) return colours[MARKS[categories[i]].colour];
  return i === 0 ? colours.panel : scaleColour(i / (categories.length - 1));
};

/** Colour of a cell, and the letter on it with its ink: its gait's, or that of the word which the map shows. */
const lookOf = ({ categories }, { value, gait, failed }, ends) => {
  if (!Number.isFinite(value) || failed) return { fill: colours.panel, letter: "", ink: colours.ink };
  if (!categories) return { fill: scaleColour(shareOf(value, ends)), letter: MARKS[gait]?.letter ?? "", ink: inkOn(shareOf(value, ends)) };
  const word = categories[value];
  if (MARKS[word]) return { fill: wordColour(categories, value), letter: MARKS[word].letter, ink: colours.paper };
  return { fill: wordColour(categories, value), letter: value > 0 ? word[0] : "", ink: inkOn(value / (categories.length - 1)) };
};

const drawCell = (ctx, [x, y, w, h], cell, { fill, letter, ink }, letters, scale) => {
  ctx.fillStyle = fill;
  ctx.fillRect(x, y, w, h);
  if (cell.failed || cell.refused) hatch(ctx, x, y, w, h, cell.refused ? colours.muted : colours.failed, scale);
  if (letters && letter) {
    ctx.fillStyle = ink;
    ctx.fillText(letter, x + w / 2, y + h / 2);
  }
};

const hatch = (ctx, x, y, w, h, colour, scale) => {
  ctx.save();
  ctx.beginPath();
  ctx.rect(x, y, w, h);
  ctx.clip();
  ctx.strokeStyle = colour;
  ctx.lineWidth = scale;
  ctx.beginPath();
  // Lines of one pattern over all cells.
  const gap = 6 * scale;
  for (let c = Math.floor((x + y) / gap) * gap; c < x + y + w + h; c += gap) {
    ctx.moveTo(c - y, y);
    ctx.lineTo(c - y - h, y + h);
  }
  ctx.stroke();
  ctx.restore();
};

/** What a cell shows, in words. */
const cellInWords = (data, { i, j }) => {
  const cell = data.cells.get(`${i},${j}`);
  const place = `${data.x.label} ${told(data.x.values[i], 4)}, ${data.y.label} ${told(data.y.values[j], 4)}`;
  if (!cell) return `${place}: not computed yet`;
  if (cell.refused) return `${place}: ${cell.refused}`;
  const value = Number.isFinite(cell.value) && !data.categories ? `${data.label} ${read(cell.value)} ${data.unit}`.trim() : "";
  return `${place}: ${[value, cell.gait, cell.failure].filter(Boolean).join(", ") || "nothing to measure"}`;
};

/** Cells chosen by pointer and arrows, picked by a click or Enter. */
const pickable = (below, chart, dataOf, chosen, choose, onPick) => {
  below.tabIndex = 0;
  below.setAttribute("role", "application");
  below.setAttribute("aria-label", "Cells of the map: arrows choose one, Enter watches it");
  const cellAt = (event) => {
    if (!chart.plot) return null;
    const box = chart.plot.over.getBoundingClientRect();
    const { x, y } = dataOf();
    const i = Math.floor(((event.clientX - box.left) / box.width) * x.values.length);
    const j = y.values.length - 1 - Math.floor(((event.clientY - box.top) / box.height) * y.values.length);
    return i >= 0 && j >= 0 && i < x.values.length && j < y.values.length ? { i, j } : null;
  };
  below.addEventListener("pointermove", (event) => {
    const cell = cellAt(event);
    if (cell && (cell.i !== chosen()?.i || cell.j !== chosen()?.j)) choose(cell);
  });
  below.addEventListener("click", (event) => {
    const cell = cellAt(event);
    if (!cell) return;
    choose(cell);
    onPick(cell);
  });
  below.addEventListener("keydown", (event) => {
    const by = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    const { x, y } = dataOf();
    const now = chosen() ?? { i: 0, j: 0 };
    const inside = (value, count) => Math.min(Math.max(value, 0), count - 1);
    if (by) choose({ i: inside(now.i + by[0], x.values.length), j: inside(now.j + by[1], y.values.length) });
    else if ((event.key === "Enter" || event.key === " ") && chosen()) onPick(chosen());
    else return;
    event.preventDefault();
  });
};

/** The scale of colours with its ends or words, and what letters and hatching mean. */
const legendOf = (el) => {
  const list = el.appendChild(element("p", "chart-legend"));
  const what = element("span");
  const scale = element("span");
  const letters = element("span");
  list.append(what, scale, letters);
  const [low, high] = [element("span"), element("span")];
  const ramp = swatch(64, (share) => scaleColour(share), "ramp");
  let words = "";
  let shown = null;
  const away = onColours(() => {
    words = "";
    if (shown) update(shown);
  });
  const update = (data) => {
    shown = data;
    what.textContent = data.label + (data.unit ? ` (${data.unit})` : "");
    const now = JSON.stringify(data.categories);
    if (now !== words) {
      words = now;
      scale.replaceChildren(...(data.categories
        ? data.categories.flatMap((word, i) => [swatch(1, () => wordColour(data.categories, i), "patch"), word]) : [low, ramp, high]));
      const gaits = data.categories ? "" : "s sliding · w walking · r running · ";
      letters.textContent = data.label === "failure" ? "letters: how it failed" : `${gaits}hatched: failed`;
    }
    if (!data.categories) [low.textContent, high.textContent] = extent(data).map((end) => read(end));
  };
  return {
    update,
    remove() {
      away();
      list.remove();
    },
  };
};

/** A strip of colours. */
const swatch = (width, colour, name) => {
  const canvas = document.createElement("canvas");
  Object.assign(canvas, { className: name, width, height: 1 });
  canvas.setAttribute("aria-hidden", "true");
  const ctx = canvas.getContext("2d");
  for (let x = 0; x < width; x++) {
    ctx.fillStyle = colour(x / Math.max(width - 1, 1));
    ctx.fillRect(x, 0, 1, 1);
  }
  return canvas;
};
