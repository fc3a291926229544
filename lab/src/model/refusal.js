// What is wrong with a scenario: the field, what was got, what is allowed, what to type instead.

export class Refusal extends Error {
  constructor(field, got, allowed, hint) {
    super(`${got} is not allowed: ${allowed}. Try ${hint}.`);
    this.name = "Refusal";
    this.field = field;
  }
}

/** A finite number between bounds, or a refusal; bounds that are left out do not count. */
export function checkNumber(value, field, { above = -Infinity, atLeast = -Infinity, atMost = Infinity, hint = "1" } = {}) {
  const bounds = [above > -Infinity && `above ${above}`, atLeast > -Infinity && `at least ${atLeast}`,
    atMost < Infinity && `at most ${Number(atMost.toPrecision(6))}`].filter(Boolean).join(" and ");
  if (typeof value === "number" && Number.isFinite(value) && value > above && value >= atLeast && value <= atMost) return value;
  const got = typeof value === "number" ? String(value) : value === undefined || value === null ? "nothing" : `a ${typeof value}`;
  throw new Refusal(field, got, `a number ${bounds}`.trim(), hint);
}
