// Series that a file gave, looked over before anything is made of them.

/**
 * Rows of series in which every number is there: those without are left out.
 *
 * @param {object} given
 * @param {string[]} names of series, all as long as the first; "time" must not fall
 * @throws {Error} with what is wrong
 */
export function wholeRows(given, names) {
  const lists = names.map((name) => given?.[name]);
  lists.forEach((list, k) => {
    if (!Array.isArray(list)) throw new Error(`no ${names[k]} in it`);
    if (list.length !== lists[0].length) throw new Error(`${names[k]} is not as long as ${names[0]}`);
  });
  const rows = [];
  let before = -Infinity;
  for (let k = 0; k < lists[0].length; k++) {
    const row = lists.map((list) => list[k]);
    if (!row.every(Number.isFinite)) continue;
    if (names[0] === "time" && row[0] < before) throw new Error("times that fall");
    before = row[0];
    rows.push(row);
  }
  return Object.fromEntries(names.map((name, column) => [name, rows.map((row) => row[column])]));
}

/** Whether something is a plain table of names. */
export const isTable = (value) => value !== null && typeof value === "object" && !Array.isArray(value);
