// Colours of charts: those of the page's style sheet, read anew when the theme changes.

const NAMES = ["paper", "panel", "ink", "muted", "line", "accent", "sliding", "walking", "running", "failed", "left", "right"];

/** Colours by the names of the page's variables, as they are now. */
export const colours = {};

const listeners = new Set();
let watching = false;

const read = () => {
  const style = getComputedStyle(document.documentElement);
  for (const name of NAMES) colours[name] = style.getPropertyValue(`--${name}`).trim() || "#777777";
};

const changed = () => {
  read();
  for (const listener of listeners) listener();
};

/** Call `listener` whenever the colours have changed; what is returned ends it. */
export const onColours = (listener) => {
  if (!watching) {
    watching = true;
    read();
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", changed);
    new MutationObserver(changed).observe(document.documentElement, { attributeFilter: ["data-theme", "class"] });
  }
  listeners.add(listener);
  return () => listeners.delete(listener);
};

// Cividis (Nuñez, Anderton, Renslow 2018): even in lightness, and the same to colour-blind eyes.
const CIVIDIS = [
  [0, 32, 76], [0, 48, 111], [42, 63, 109], [71, 79, 109], [93, 95, 111], [114, 111, 114], [135, 128, 120],
  [158, 146, 119], [181, 164, 111], [206, 183, 101], [231, 204, 84], [255, 234, 70],
];

/** Colour of a share from 0 to 1 of an even scale. */
export const scaleColour = (share) => {
  const at = Math.min(Math.max(share, 0), 1) * (CIVIDIS.length - 1);
  const below = Math.min(Math.floor(at), CIVIDIS.length - 2);
  const part = CIVIDIS[below].map((low, i) => Math.round(low + (at - below) * (CIVIDIS[below + 1][i] - low)));
  return `rgb(${part.join(" ")})`;
};

/** Ink that is read on a colour of the scale. */
export const inkOn = (share) => (share > 0.55 ? "#10131a" : "#ffffff");
