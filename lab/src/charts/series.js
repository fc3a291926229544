// Numbers over time: spin rate, drift with its limit, bending, forces. Cheap enough to be drawn with every picture.
import { colours } from "./colours.js";
import { axis, element, leftAxis, plotIn, read, roomy } from "./plot.js";

// Columns of pixels that a long series is thinned to: the least and the largest of each.
const COLUMNS = 500;
const USUAL = ["accent", "walking", "running", "failed", "muted"];
const DASHES = [[], [6, 4], [2, 3], [8, 3, 2, 3], [1, 2]];

/** Places of the samples that keep a series' look: of each column the least and the largest, of all series together. */
export const thinned = (time, values, columns = COLUMNS) => {
  const n = time.length;
  if (n <= 2 * columns) return Array.from({ length: n }, (_, i) => i);
  const kept = new Set([0, n - 1]);
  for (let c = 0; c < columns; c++) {
    const [begin, end] = [Math.floor((c * n) / columns), Math.floor(((c + 1) * n) / columns)];
    for (const series of values) {
      let [least, largest] = [begin, begin];
      for (let i = begin; i < end; i++) {
        if (series[i] < series[least]) least = i;
        if (series[i] > series[largest]) largest = i;
      }
      kept.add(least).add(largest);
    }
  }
  return [...kept].sort((a, b) => a - b);
};

/** Name of a series' colour, with or without the dashes of a style sheet. */
const nameOf = ({ colour }, i) => colour?.replace(/^--/, "") ?? USUAL[i % USUAL.length];

const shown = (value) => (Number.isFinite(value) ? value : null);

/**
 * @param {HTMLElement} el
 * @param {{series: {label: string, colour?: string}[], unit?: string, label?: string, zero?: boolean,
 *   limit?: {value: number, label: string}}} given `colour` is one of the page's; `zero` keeps zero in view
 * @returns {{update(data: {time, values: ArrayLike<number>[], limit?: {value, label} | null}), resize(), destroy()}}
 */
export const timeSeries = (el, { series, unit = "", label = "", zero = true, limit = null }) => {
  let bound = limit;
  const legend = series.length > 1 ? legendOf(el, series) : null;
  const colourOf = (i) => () => colours[nameOf(series[i], i)];
  const range = (_, low, high) => {
    const all = [low, high, ...(zero ? [0] : []), ...(bound ? [bound.value] : [])].filter(Number.isFinite);
    return roomy(Math.min(...all), Math.max(...all));
  };
  const chart = plotIn(legend ? legend.below : el, {
    scales: { x: { time: false, range: (_, low, high) => (low < high ? [low, high] : [low ?? 0, (low ?? 0) + 1]) }, y: { range } },
    series: [{}, ...series.map((each, i) => ({
      label: each.label, stroke: colourOf(i), width: 1.5, dash: DASHES[i % DASHES.length], points: { show: false },
    }))],
    axes: [axis("time (s)"), leftAxis(unit ? `${label} (${unit})`.trim() : label)],
    hooks: { draw: [(u) => bound && drawLimit(u, bound)] },
  }, [[], ...series.map(() => [])]);
  const title = label || series.map((each) => each.label).join(", ");
  chart.describe(`${title} over time: nothing yet`);
  return {
    update({ time, values, limit: next }) {
      if (next !== undefined) bound = next;
      const kept = thinned(time, values);
      const lengths = series.map((_, s) => values[s]?.length ?? 0);
      chart.update([kept.map((i) => time[i]), ...series.map((_, s) => kept.map((i) => (i < lengths[s] ? shown(values[s][i]) : null)))]);
      const last = values.map((each, s) => `${series[s].label} ${read(each[each.length - 1])} ${unit}`.trim());
      const bounded = bound ? `; ${bound.label} ${read(bound.value)} ${unit}` : "";
      chart.describe(`${title} over time, now at ${read(time[time.length - 1] ?? NaN)} s: ${last.join(", ")}${bounded}`);
    },
    resize: chart.resize,
    destroy() {
      chart.destroy();
      legend?.destroy();
    },
  };
};

/** Line that must not be crossed. */
const drawLimit = (u, { value, label }) => {
  const { ctx } = u;
  const y = u.valToPos(value, "y", true);
  const scale = devicePixelRatio || 1;
  ctx.save();
  ctx.strokeStyle = ctx.fillStyle = colours.failed;
  ctx.lineWidth = 1.2 * scale;
  ctx.setLineDash([4 * scale, 4 * scale]);
  ctx.beginPath();
  ctx.moveTo(u.bbox.left, y);
  ctx.lineTo(u.bbox.left + u.bbox.width, y);
  ctx.stroke();
  ctx.font = `${11 * scale}px system-ui, sans-serif`;
  ctx.textAlign = "left";
  ctx.textBaseline = "bottom";
  ctx.fillText(label, u.bbox.left + 4 * scale, y - 2 * scale);
  ctx.restore();
};

/** Names of the lines above the chart; `below` is where the chart goes. */
const legendOf = (el, series) => {
  const list = element("p", "chart-legend");
  series.forEach((each, i) => {
    const line = element("i", `line line-${i % DASHES.length}`);
    line.style.color = `var(--${nameOf(each, i)})`;
    const item = element("span");
    item.append(line, each.label);
    list.append(item);
  });
  const below = element("div", "chart-below");
  el.classList.add("chart-with-legend");
  el.append(list, below);
  return {
    below,
    destroy() {
      list.remove();
      below.remove();
    },
  };
};
