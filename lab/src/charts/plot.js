// A uPlot in an element: sized with it, in the page's colours, told in words to who cannot see it.
import uPlot from "uplot";
import { colours, onColours } from "./colours.js";

const FONT = "12px system-ui, sans-serif";

/** An axis in the page's colours. */
export const axis = (label, given = {}) => ({
  label,
  font: FONT,
  labelFont: FONT,
  labelSize: label ? 18 : 0,
  size: 34,
  stroke: () => colours.muted,
  grid: { stroke: () => colours.line, width: 1 },
  ticks: { stroke: () => colours.line, width: 1, size: 5 },
  // Six digits: what is left of a step's rounding is not read, and large numbers stay short.
  values: (_, splits) => splits.map((value) => read(value, 6)),
  ...given,
});

/** An axis of numbers at the left, as wide as its numbers. */
export const leftAxis = (label, given = {}) =>
  axis(label, { size: (_, values) => 16 + 7 * Math.max(2, ...(values ?? []).map((value) => String(value).length)), ...given });

/** Range of what is shown, with some room, never empty. */
export const roomy = (low, high, share = 0.06) => {
  if (!(low <= high)) return [0, 1];
  const room = share * (high - low) || 0.1 * Math.abs(high) || 1;
  return [low - room, high + room];
};

/**
 * A chart in `el`: its canvas is an image to screen readers, with the words that `describe` is given.
 *
 * @param {HTMLElement} el of a height that its class gives
 * @param {object} options of uPlot, without size
 * @param {any[]} data uPlot's
 */
export const plotIn = (el, options, data) => {
  el.classList.add("chart");
  const frame = el.appendChild(document.createElement("div"));
  frame.className = "chart-frame";
  frame.setAttribute("role", "img");
  frame.setAttribute("aria-label", "chart, empty so far");
  const size = () => ({ width: Math.max(el.clientWidth, 120), height: Math.max(el.clientHeight, 80) });
  let drawn = null;
  let waiting = data;
  let stale = false;
  const show = () => {
    // Not while the page hides it: it has no size then.
    stale = !el.clientWidth;
    if (stale) return;
    if (drawn) drawn.setData(waiting);
    else drawn = new uPlot({ ...size(), legend: { show: false }, cursor: { show: false }, ...options }, waiting, frame);
  };
  const resize = () => {
    if (!el.clientWidth) return;
    if (!drawn || stale) show();
    const now = size();
    if (drawn.width !== now.width || drawn.height !== now.height) drawn.setSize(now);
  };
  const away = onColours(() => drawn?.redraw(false));
  const observer = new ResizeObserver(resize);
  observer.observe(el);
  show();
  return {
    frame,
    get plot() {
      return drawn;
    },
    update(next) {
      waiting = next;
      show();
    },
    describe(words) {
      if (frame.getAttribute("aria-label") !== words) frame.setAttribute("aria-label", words);
    },
    resize,
    destroy() {
      away();
      observer.disconnect();
      drawn?.destroy();
      frame.remove();
    },
  };
};

/** An element with a class and text. */
export const element = (tag, name = "", text = "") => {
  const made = document.createElement(tag);
  if (name) made.className = name;
  made.textContent = text;
  return made;
};

/** A number as people read it: so many digits, no needless zeros. */
export const read = (value, count = 3) => {
  if (!Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e6)) return value.toExponential(count - 1).replace(/\.?0+e/, "e");
  return String(Number(value.toPrecision(Math.max(count, Math.ceil(Math.log10(size + 1))))));
};
