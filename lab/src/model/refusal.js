// What is wrong with a scenario: the field, what was got, what is allowed, what to type. As the package's errors.py.

const MOST_LETTERS = 80;

export class Refusal extends Error {
  /**
   * @param {string} field dotted name
   * @param {string} got
   * @param {string} allowed as the end of "must be …"
   * @param {string} hint what to type
   */
  constructor(field, got, allowed, hint) {
    super(`got ${got}, must be ${allowed}; try ${hint}`);
    this.name = "Refusal";
    this.field = field;
  }
}

/** What was given, in a few letters of one line. */
export const told = (value) => {
  if (value === undefined || value === null) return "nothing";
  if (Array.isArray(value)) return `a list of ${value.length}`;
  if (typeof value === "object") return "a table";
  const text = typeof value === "string" ? JSON.stringify(value) : String(value);
  return text.length <= MOST_LETTERS ? text : `${text.slice(0, MOST_LETTERS)}…`;
};

/** A part of a scenario that holds fields. @throws {Refusal} */
export const checkTable = (value, field) => {
  if (typeof value !== "object" || value === null || Array.isArray(value))
    throw new Refusal(field, told(value), "a table of its fields", "a preset's");
  return value;
};
