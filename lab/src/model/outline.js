// Outlines that a sheet can be cut to, and the grid squares inside them. As the package's model/outline.py.
import { LENGTH, OFFSET, checkNumber, checkNumbers, shown } from "./quantity.js";
import { Refusal, checkTable, told } from "./refusal.js";
import { roundHalfEven } from "./rounding.js";

const MOST_SQUARES = 250_000;
const MOST_CORNERS = 1000;
const MOST_PIXELS = 1_000_000;
const EDGE = 1e-9; // of a polygon's extent: what is nearer to an edge lies on it
const TRIANGLE = '[["0 mm", "0 mm"], ["60 mm", "0 mm"], ["0 mm", "60 mm"]]';
const ROWS = '[".##.", "####", ".##."]';
const FIELD = "sheet.outline";

const SHAPES = {
  disk: {
    check: (o) => checkNumbers(o, FIELD, { radius: LENGTH }),
    size: (o) => [2 * o.radius, 2 * o.radius],
    contains: (o) => (x, y) => Math.hypot(x, y) <= o.radius,
  },
  ellipse: {
    check: (o) => checkNumbers(o, FIELD, { length: LENGTH, width: LENGTH }),
    size: (o) => [o.length, o.width],
    contains: (o) => (x, y) => Math.hypot((2 * x) / o.length, (2 * y) / o.width) <= 1,
  },
  rectangle: {
    check: (o) => checkNumbers(o, FIELD, { length: LENGTH, width: LENGTH }),
    size: (o) => [o.length, o.width],
    contains: (o) => (x, y) => Math.abs(x) <= o.length / 2 && Math.abs(y) <= o.width / 2,
  },
  polygon: { check: checkCorners, size: polygonSize, contains: insidePolygon },
  mask: { check: checkRows, size: maskSize, contains: insideMask },
};

const kindOf = (outline) => {
  checkTable(outline, FIELD);
  if (typeof outline.shape !== "string" || !Object.hasOwn(SHAPES, outline.shape))
    throw new Refusal(`${FIELD}.shape`, told(outline.shape), `one of ${Object.keys(SHAPES).join(", ")}`, '"disk"');
  return SHAPES[outline.shape];
};

/** @throws {Refusal} */
export const checkOutline = (outline) => kindOf(outline).check(outline);

/** Length along x and width along y, m. */
export const outlineSize = (outline) => kindOf(outline).size(outline);

/** A test of points about the middle of the bounding box, m. @returns {(x: number, y: number) => boolean} */
export const insideOf = (outline) => kindOf(outline).contains(outline);

function checkCorners({ corners }) {
  const field = `${FIELD}.corners`;
  if (!Array.isArray(corners)) throw new Refusal(field, told(corners), "a list", TRIANGLE);
  if (corners.length > MOST_CORNERS)
    throw new Refusal(
      field,
      `${corners.length} corners`,
      `at most ${MOST_CORNERS}`,
      "leaving out some that are near to others",
    );
  corners.forEach((corner, i) => {
    if (!Array.isArray(corner) || corner.length !== 2)
      throw new Refusal(`${field}.${i}`, told(corner), "x and y", TRIANGLE);
    corner.forEach((value, k) => checkNumber(value, `${field}.${i}.${k}`, OFFSET));
  });
  if (corners.length < 3 || !spanAnArea(corners)) {
    const got = `${corners.length} corners${corners.length > 1 ? " on one line" : ""}`;
    throw new Refusal(field, got, "3 or more corners that span an area", TRIANGLE);
  }
}

/** Whether corners lie off one line: by the smaller singular value of where they are from the first. */
function spanAnArea(corners) {
  const across = (k) => corners.map((corner) => corner[k] - corners[0][k]);
  const dot = (a, b) => a.reduce((sum, each, i) => sum + each * b[i], 0);
  const [x, y] = [across(0), across(1)];
  const most = Math.max(...[...x, ...y].map(Math.abs));
  const [longer, other] = dot(x, x) >= dot(y, y) ? [x, y] : [y, x];
  const size = Math.sqrt(dot(longer, longer));
  if (size === 0) return false;
  // What of one direction is not along the other, squared off twice as the first time leaves rounding.
  const unit = longer.map((each) => each / size);
  const part = dot(other, unit);
  const once = other.map((each, i) => each - part * unit[i]);
  const rest = dot(once, unit);
  const off = Math.hypot(...once.map((each, i) => each - rest * unit[i]));
  const larger = Math.sqrt(
    (size ** 2 + part ** 2 + off ** 2 + Math.sqrt((size ** 2 + part ** 2 + off ** 2) ** 2 - 4 * (size * off) ** 2)) / 2,
  );
  return (size * off) / larger > EDGE * most;
}

function extent(corners, k) {
  let [low, high] = [Infinity, -Infinity];
  for (const corner of corners) {
    low = Math.min(low, corner[k]);
    high = Math.max(high, corner[k]);
  }
  return [low, high];
}

function polygonSize({ corners }) {
  return [0, 1].map((k) => {
    const [low, high] = extent(corners, k);
    return high - low;
  });
}

/** Even-odd rule; a point on an edge is inside where all points a hair around it are. */
function insidePolygon(outline) {
  const middle = [0, 1].map((k) => {
    const [low, high] = extent(outline.corners, k);
    return (low + high) / 2;
  });
  const corners = outline.corners.map(([x, y]) => [x - middle[0], y - middle[1]]);
  const hair = EDGE * Math.max(...polygonSize(outline));
  const around = Array.from({ length: 8 }, (_, k) => ((k + 0.5) * Math.PI) / 4).map((d) => [
    hair * Math.cos(d),
    hair * Math.sin(d),
  ]);
  const odd = (x, y) => {
    let inside = false;
    for (let k = 0; k < corners.length; k++) {
      const [x0, y0] = corners[k];
      const [x1, y1] = corners[(k + 1) % corners.length];
      if (y0 !== y1 && y0 > y !== y1 > y && x < x0 + ((y - y0) * (x1 - x0)) / (y1 - y0)) inside = !inside;
    }
    return inside;
  };
  return (x, y) => around.every(([dx, dy]) => odd(x + dx, y + dy));
}

function checkRows(o) {
  checkNumbers(o, FIELD, { width_of_picture: LENGTH });
  const field = `${FIELD}.rows`;
  const { rows } = o;
  if (
    !Array.isArray(rows) ||
    !rows.length ||
    rows.some((row) => typeof row !== "string" || row.length !== rows[0].length)
  )
    throw new Refusal(field, told(rows), "rows of equal length", ROWS);
  if (rows.length * rows[0].length > MOST_PIXELS)
    throw new Refusal(
      field,
      `${rows[0].length} × ${rows.length} pixels`,
      `at most ${MOST_PIXELS} of them`,
      "a smaller copy",
    );
  if (!rows.some((row) => row.includes("#")))
    throw new Refusal(field, "nothing dark in the picture", "a dark object on a light ground", ROWS);
}

/** Rows and columns of a picture that hold its sheet: [first row, last row, first column, last column]. */
function cropped({ rows }) {
  const dark = rows.map((row, i) => (row.includes("#") ? i : -1)).filter((i) => i >= 0);
  const left = Math.min(...dark.map((i) => rows[i].indexOf("#")));
  const right = Math.max(...dark.map((i) => rows[i].lastIndexOf("#")));
  return [dark[0], dark.at(-1), left, right];
}

function maskSize(outline) {
  const [top, bottom, left, right] = cropped(outline);
  const pixel = outline.width_of_picture / outline.rows[0].length;
  return [(right - left + 1) * pixel, (bottom - top + 1) * pixel];
}

function insideMask(outline) {
  const [top, bottom, left, right] = cropped(outline);
  const [length, width] = maskSize(outline);
  const [columns, rows] = [right - left + 1, bottom - top + 1];
  return (x, y) => {
    const i = Math.floor((x / length + 0.5) * columns);
    const j = Math.floor((y / width + 0.5) * rows);
    return i >= 0 && i < columns && j >= 0 && j < rows && outline.rows[bottom - j][left + i] === "#";
  };
}

/**
 * Grid squares whose middle lies inside an outline; the grid is centred on the outline's bounding box.
 *
 * @returns {{columns: number, rows: number, inside: Uint8Array}} `inside[i * rows + j]`, column i along x
 */
export function occupiedSquares(outline, pitch) {
  const kind = kindOf(outline);
  const size = kind.size(outline);
  const [columns, rows] = size.map((extent) => Math.max(1, roundHalfEven(Math.min(extent / pitch, 1e9))));
  const wide = shown(pitch, LENGTH);
  if (columns * rows > MOST_SQUARES)
    throw new Refusal(
      "sheet.pitch",
      wide,
      `coarse enough for at most ${MOST_SQUARES} squares`,
      shown(Math.max(...size) / 100, LENGTH),
    );
  const contains = kind.contains(outline);
  const inside = new Uint8Array(columns * rows);
  // A hair inwards, so that a middle on the very edge falls the same way on every side.
  const middle = (k, count) => (k - (count - 1) / 2) * pitch * (1 - 1e-12);
  for (let i = 0; i < columns; i++)
    for (let j = 0; j < rows; j++) inside[i * rows + j] = contains(middle(i, columns), middle(j, rows)) ? 1 : 0;
  const finer = shown(Number(Math.min(Math.min(...size) / 8, pitch / 2).toPrecision(3)), LENGTH);
  if (!inside.includes(1))
    throw new Refusal("sheet.pitch", wide, "fine enough for at least one grid square inside the outline", finer);
  const pieces = countPieces(inside, columns, rows);
  if (pieces > 1)
    throw new Refusal(
      FIELD,
      `${pieces} separate pieces at a pitch of ${wide}`,
      "one connected piece",
      `a mask without gaps, or a finer pitch such as ${finer}`,
    );
  return { columns, rows, inside };
}

function countPieces(inside, columns, rows) {
  const left = inside.slice();
  let pieces = 0;
  for (let start = 0; start < left.length; start++) {
    if (!left[start]) continue;
    pieces++;
    const front = [start];
    left[start] = 0;
    while (front.length) {
      const at = front.pop();
      const [i, j] = [Math.floor(at / rows), at % rows];
      for (const [a, b] of [
        [i - 1, j],
        [i + 1, j],
        [i, j - 1],
        [i, j + 1],
      ]) {
        if (a < 0 || b < 0 || a >= columns || b >= rows || !left[a * rows + b]) continue;
        left[a * rows + b] = 0;
        front.push(a * rows + b);
      }
    }
  }
  return pieces;
}
