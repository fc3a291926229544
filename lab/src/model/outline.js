// Outlines that a sheet can be cut to, and the grid squares inside them. As the package's model/outline.py.
import { Refusal, checkNumber } from "./refusal.js";

const MOST_SQUARES = 250_000;
const MOST_CORNERS = 1000;
const MOST_PIXELS = 1_000_000;
const EDGE = 1e-9; // of a polygon's extent: what is nearer to an edge lies on it
const LARGEST = 1e3; // m
const LENGTH = { above: 0, atMost: LARGEST, hint: "0.04" };

const SHAPES = {
  disk: {
    check: (o) => checkNumber(o.radius, "sheet.outline.radius", LENGTH),
    size: (o) => [2 * o.radius, 2 * o.radius],
    contains: (o) => (x, y) => Math.hypot(x, y) <= o.radius,
  },
  ellipse: {
    check: checkSides,
    size: (o) => [o.length, o.width],
    contains: (o) => (x, y) => Math.hypot((2 * x) / o.length, (2 * y) / o.width) <= 1,
  },
  rectangle: {
    check: checkSides,
    size: (o) => [o.length, o.width],
    contains: (o) => (x, y) => Math.abs(x) <= o.length / 2 && Math.abs(y) <= o.width / 2,
  },
  polygon: { check: checkCorners, size: polygonSize, contains: insidePolygon },
  mask: { check: checkRows, size: maskSize, contains: insideMask },
};

const own = (outline) => {
  if (!outline || !Object.hasOwn(SHAPES, outline.shape))
    throw new Refusal("sheet.outline.shape", JSON.stringify(outline?.shape ?? null), `one of ${Object.keys(SHAPES).join(", ")}`, "disk");
  return SHAPES[outline.shape];
};

/** Length along x and width along y, m. */
export const outlineSize = (outline) => own(outline).size(outline);

function checkSides(o) {
  checkNumber(o.length, "sheet.outline.length", LENGTH);
  checkNumber(o.width, "sheet.outline.width", LENGTH);
}

function checkCorners({ corners }) {
  const field = "sheet.outline.corners";
  if (!Array.isArray(corners)) throw new Refusal(field, "no list", "3 or more corners", "[[0, 0], [0.06, 0], [0, 0.06]]");
  if (corners.length > MOST_CORNERS) throw new Refusal(field, `${corners.length} corners`, `at most ${MOST_CORNERS}`, "fewer");
  for (const corner of corners) {
    if (!Array.isArray(corner) || corner.length !== 2) throw new Refusal(field, "a corner without two numbers", "(x, y)", "[0, 0]");
    for (const value of corner) checkNumber(value, field, { atLeast: -LARGEST, atMost: LARGEST, hint: "0.02" });
  }
  const spread = corners.map(([x, y]) => [x - corners[0][0], y - corners[0][1]]);
  const most = Math.max(0, ...spread.flat().map(Math.abs));
  // The smaller singular value of the corners about the first: none where they lie on one line.
  const [xx, xy, yy] = spread.reduce(([a, b, c], [x, y]) => [a + x * x, b + x * y, c + y * y], [0, 0, 0]);
  const smaller = Math.sqrt(Math.max(0, (xx + yy - Math.hypot(xx - yy, 2 * xy)) / 2));
  if (corners.length < 3 || !(smaller > Math.max(EDGE * most, 1e-8 * Math.sqrt(xx + yy))))
    throw new Refusal(field, `${corners.length} corners on one line`, "3 or more corners that span an area", "[[0, 0], [0.06, 0], [0, 0.06]]");
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
  const around = Array.from({ length: 8 }, (_, k) => ((k + 0.5) * Math.PI) / 4).map((d) => [hair * Math.cos(d), hair * Math.sin(d)]);
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
  checkNumber(o.width_of_picture, "sheet.outline.width_of_picture", LENGTH);
  const field = "sheet.outline.rows";
  const { rows } = o;
  if (!Array.isArray(rows) || !rows.length || rows.some((row) => typeof row !== "string" || row.length !== rows[0].length))
    throw new Refusal(field, "no picture", "rows of equal length", '[".##.", "####"]');
  if (rows.length * rows[0].length > MOST_PIXELS) throw new Refusal(field, "too large a picture", `at most ${MOST_PIXELS} pixels`, "a smaller one");
  if (!rows.some((row) => row.includes("#"))) throw new Refusal(field, "nothing dark in the picture", "# where the sheet is", '[".##.", "####"]');
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

/** Half to even, as Python rounds. */
const rounded = (value) => {
  const floor = Math.floor(value);
  if (value - floor !== 0.5) return Math.round(value);
  return floor % 2 === 0 ? floor : floor + 1;
};

/**
 * Grid squares whose middle lies inside an outline; the grid is centred on the outline's bounding box.
 *
 * @returns {{columns: number, rows: number, inside: Uint8Array}} `inside[i * rows + j]`, column i along x
 */
export function occupiedSquares(outline, pitch) {
  const shape = own(outline);
  shape.check(outline);
  checkNumber(pitch, "sheet.pitch", { above: 0, atMost: LARGEST, hint: "0.01" });
  const size = shape.size(outline);
  const [columns, rows] = size.map((each) => Math.max(1, rounded(Math.min(each / pitch, 1e9))));
  if (columns * rows > MOST_SQUARES)
    throw new Refusal("sheet.pitch", `${1000 * pitch} mm`, `coarse enough for at most ${MOST_SQUARES} squares`, `${Math.max(...size) * 10} mm`);
  const contains = shape.contains(outline);
  const inside = new Uint8Array(columns * rows);
  // A hair inwards, so that a middle on the very edge falls the same way on every side.
  for (let i = 0; i < columns; i++) {
    const x = (i - (columns - 1) / 2) * pitch * (1 - 1e-12);
    for (let j = 0; j < rows; j++) inside[i * rows + j] = contains(x, (j - (rows - 1) / 2) * pitch * (1 - 1e-12)) ? 1 : 0;
  }
  const finer = `${Number((1e3 * Math.min(Math.min(...size) / 8, pitch / 2)).toPrecision(3))} mm`;
  if (!inside.includes(1)) throw new Refusal("sheet.pitch", `${1000 * pitch} mm`, "fine enough for at least one grid square inside the outline", finer);
  const pieces = countPieces(inside, columns, rows);
  if (pieces > 1) throw new Refusal("sheet.outline", `${pieces} separate pieces at a pitch of ${1000 * pitch} mm`, "one connected piece", `a finer pitch such as ${finer}`);
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
      for (const [a, b] of [[i - 1, j], [i + 1, j], [i, j - 1], [i, j + 1]]) {
        if (a < 0 || b < 0 || a >= columns || b >= rows || !left[a * rows + b]) continue;
        left[a * rows + b] = 0;
        front.push(a * rows + b);
      }
    }
  }
  return pieces;
}
