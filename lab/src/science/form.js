// Controls of a study: labelled fields that are read with their units, and one line for what is wrong with one.
import { parsed, pretty } from "../app/quantity.js";
import { element } from "../charts/plot.js";

/** What is wrong with a field, in one line: which, what was got, what is allowed. */
export class FieldError extends Error {
  constructor(field, fault) {
    super(`${field}: ${fault}`);
    this.field = field;
  }
}

/** Refusal of what was got, with what is allowed. */
export const notAllowed = (field, got, allowed) => new FieldError(field, `${got} is not allowed: ${allowed}.`);

/**
 * A quantity as typed, in SI. A bare number is in the unit that people read.
 *
 * @param {string} name of the control
 * @param {string} text
 * @param {import("../app/quantity.js").Field} field of the model
 * @param {Record<string, [number, string]>} units factor and SI unit of each
 * @throws {FieldError}
 */
export const quantity = (name, text, field, units) => {
  const told = parsed(text, field, units);
  if (told.fault) throw new FieldError(name, told.fault);
  return told.value;
};

/** A whole number as typed, within bounds. */
export const whole = (name, text, least, most) => {
  const value = Number(text);
  if (text.trim() === "" || !Number.isInteger(value) || value < least || value > most) {
    throw notAllowed(name, `“${text.slice(0, 40)}”`, `a whole number from ${least} to ${most}`);
  }
  return value;
};

/** A labelled field for text; `unit` stands in the label. */
export const textField = (text, value, unit = "") => {
  const input = document.createElement("input");
  Object.assign(input, { type: "text", value, autocomplete: "off", spellcheck: false, inputMode: "decimal" });
  const label = element("label");
  const words = element("span", "", text);
  label.append(words, input);
  const field = {
    name: text, input, label,
    setUnit: (next) => (words.textContent = next ? `${text} (${pretty(next)})` : text),
  };
  field.setUnit(unit);
  return field;
};

/** A labelled choice among [value, words, group] rows. */
export const choiceField = (text, rows, value) => {
  const select = document.createElement("select");
  const label = element("label");
  label.append(element("span", "", text), select);
  const fill = (options, chosen) => {
    const groups = new Map([["", select]]);
    select.replaceChildren();
    for (const [key, words, group = ""] of options) {
      if (!groups.has(group)) {
        const made = document.createElement("optgroup");
        made.label = group;
        groups.set(group, select.appendChild(made));
      }
      groups.get(group).append(new Option(words, key, key === chosen, key === chosen));
    }
  };
  fill(rows, value);
  return { name: text, input: select, label, fill };
};

/** A button. */
export const buttonOf = (text, act) => {
  const button = element("button", "", text);
  button.type = "button";
  button.addEventListener("click", act);
  return button;
};

/** A line that is told when something is wrong, and marks the field that it is about. */
export const faultLine = (fields) => {
  const line = element("p", "study-fault");
  line.setAttribute("role", "alert");
  const clear = () => {
    line.textContent = "";
    for (const { input } of fields()) input.removeAttribute("aria-invalid");
  };
  return {
    line,
    clear,
    tell(error) {
      clear();
      line.textContent = error.message;
      const wrong = fields().find(({ name }) => name === error.field);
      wrong?.input.setAttribute("aria-invalid", "true");
      wrong?.input.focus();
    },
  };
};
