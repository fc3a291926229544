// Elements of the page, made without markup: whatever comes from data stays text.

/**
 * An element with properties, attributes and children.
 *
 * @param {string} tag
 * @param {Record<string, any>} [given] properties of the element; `class`, `for`, `role`, `aria-*` and `data-*` as
 *   attributes; functions by `on…` as listeners
 * @param {...(Node|string|null)} children
 * @returns {any}
 */
export function make(tag, given = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(given)) {
    if (value === null || value === undefined) continue;
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (/^(class|for|role|list|form|aria-.*|data-.*)$/.test(name)) element.setAttribute(name, value);
    else element[name] = value;
  }
  element.append(...children.filter((child) => child !== null && child !== undefined));
  return element;
}

/** A button that says what it does. */
export function button(text, act, given = {}) {
  return make("button", { type: "button", onclick: act, ...given }, text);
}

/** A choice of one among words: [value, text] pairs. */
export function choice(label, options, value, choose, given = {}) {
  const select = make("select", { "aria-label": label, onchange: () => choose(select.value), ...given });
  for (const [key, text] of options) select.append(make("option", { value: key, selected: key === value }, text));
  return select;
}

let last = 0;

/** An identity for a label and what it labels. */
export const identity = (stem) => `${stem}-${++last}`;
