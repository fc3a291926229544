// The page's colours, as its CSS variables have them, for pictures.

/** What the picture takes from the page, and what it is where the page does not say. */
const NAMES = {
  paper: "#fdfdfb", panel: "#f3f3ef", ink: "#1b1d22", muted: "#575c66", line: "#d5d5cf", accent: "#0b5cad",
  failed: "#c2410c", left: "#0072b2", right: "#b06f00", sheet: "#e8b04a", plate: "#c9ced6",
};

/** Colours of what is bent one way, not, and the other; and of what is low, halfway and high. */
export const BENT = [[0, 114, 178], [247, 247, 247], [213, 94, 0]].map((c) => c.map((v) => v / 255));
export const HIGH = [[0, 32, 77], [124, 123, 120], [255, 234, 70]].map((c) => c.map((v) => v / 255));

/** Any colour that a page may name becomes red, green and blue from 0 to 1, by way of a 2-D canvas. */
let interpreter = null;
const components = (text, otherwise) => {
  interpreter ??= document.createElement("canvas").getContext("2d");
  interpreter.fillStyle = otherwise;
  interpreter.fillStyle = text || otherwise;
  const plain = interpreter.fillStyle;
  const numbers = plain.startsWith("#")
    ? [1, 3, 5].map((k) => parseInt(plain.slice(k, k + 2), 16))
    : plain.match(/[\d.]+/g).slice(0, 3).map(Number);
  return numbers.map((value) => value / 255);
};

/**
 * The colours at an element, by name: [red, green, blue] from 0 to 1; `dark` says whether the paper is.
 * @param {Element} element
 */
export const coloursAt = (element) => {
  const style = getComputedStyle(element);
  const colours = {};
  for (const [name, otherwise] of Object.entries(NAMES))
    colours[name] = components(style.getPropertyValue(`--${name}`).trim(), otherwise);
  return { ...colours, dark: brightness(colours.paper) < 0.4, font: style.fontFamily || "sans-serif" };
};

const brightness = ([red, green, blue]) => 0.3 * red + 0.6 * green + 0.1 * blue;

/** As CSS and 2-D canvases take it. */
export const css = ([red, green, blue], alpha = 1) =>
  `rgba(${Math.round(255 * red)}, ${Math.round(255 * green)}, ${Math.round(255 * blue)}, ${alpha})`;

/** Between two colours. */
export const mix = (a, b, share) => a.map((value, k) => value + share * (b[k] - value));
