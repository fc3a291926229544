// The dissertation's gait diagram: for each leg a bar while it touches the plate, over plate periods; flight between.
import { colours } from "./colours.js";
import { axis, plotIn } from "./plot.js";

// Plate periods that are shown: few enough to see single strides.
const STRIDES = 6;
const ROWS = [["left", "left leg"], ["right", "right leg"], ["flight", "flight"]];
const COLOUR = { left: "left", right: "right", flight: "failed" };

/** Times [from, to] in which a share of samples is above a half: each sample tells of the time since the one before. */
export const timesOf = (time, share, first) => {
  const bars = [];
  for (let i = Math.max(first, 1); i < time.length; i++) {
    if (!(share[i] >= 0.5)) continue;
    const last = bars.at(-1);
    if (last && last[1] === time[i - 1]) last[1] = time[i];
    else bars.push([time[i - 1], time[i]]);
  }
  return bars;
};

/**
 * @param {HTMLElement} el
 * @returns {{update(data: {time, left, right, flight, period: number, gait?: string}), resize(), destroy()}} `left`,
 *   `right` and `flight` are shares of the time since the sample before; the last periods of what is given are shown
 */
export const gaitDiagram = (el) => {
  let state = { bars: {}, from: 0, period: 1, shown: 0 };
  const draw = (u) => {
    const { ctx } = u;
    const height = u.bbox.height / ROWS.length;
    ctx.save();
    ctx.beginPath();
    ctx.rect(u.bbox.left, u.bbox.top, u.bbox.width, u.bbox.height);
    ctx.clip();
    ROWS.forEach(([name], row) => {
      ctx.fillStyle = colours[COLOUR[name]];
      for (const [from, to] of state.bars[name] ?? []) {
        const [left, right] = [from, to].map((t) => u.valToPos((t - state.from) / state.period, "x", true));
        if (name === "flight") {
          ctx.globalAlpha = 0.16;
          ctx.fillRect(left, u.bbox.top, right - left, u.bbox.height);
          ctx.globalAlpha = 1;
        }
        ctx.fillRect(left, u.bbox.top + (row + 0.2) * height, Math.max(right - left, 1), 0.6 * height);
      }
    });
    ctx.restore();
  };
  const chart = plotIn(el, {
    scales: { x: { time: false, range: () => [0, STRIDES] }, y: { range: () => [0, ROWS.length] } },
    series: [{}, { show: false }],
    axes: [
      axis("plate periods", { splits: () => Array.from({ length: STRIDES + 1 }, (_, i) => i) }),
      axis("", {
        size: 66, grid: { show: false }, ticks: { show: false }, splits: () => ROWS.map((_, i) => ROWS.length - i - 0.5),
        values: () => ROWS.map(([, label]) => label),
      }),
    ],
    hooks: { draw: [draw] },
  }, [[0, STRIDES], [null, null]]);
  chart.describe("Gait diagram: nothing yet");
  return {
    update({ time, left, right, flight, period, gait = "" }) {
      const end = time.length ? time[time.length - 1] : 0;
      // Whole periods are kept in place, so that bars do not run: a picture for each period.
      const from = Math.max(0, Math.floor(end / period + 1e-6) - STRIDES) * period;
      let first = time.length;
      while (first > 0 && time[first - 1] > from) first--;
      const shares = { left, right, flight };
      const bars = Object.fromEntries(ROWS.map(([name]) => [name, timesOf(time, shares[name], first)]));
      state = { bars, from, period };
      chart.update([[0, STRIDES], [null, null]]);
      const shown = Math.min(end - from, STRIDES * period) || 1;
      const told = (name) => `${Math.round((100 * bars[name].reduce((sum, [a, b]) => sum + b - a, 0)) / shown)} %`;
      chart.describe(`Gait diagram of the last ${STRIDES} plate periods${gait ? `, ${gait}` : ""}: the left leg touches ` +
        `${told("left")} of the time, the right leg ${told("right")}; in flight ${told("flight")}`);
    },
    resize: chart.resize,
    destroy: chart.destroy,
  };
};
