// The lattice: mass nodes on a square grid, cut to an outline, and how they are joined. As model/lattice.py.

const AXIAL = [
  [1, 0],
  [0, 1],
];
const DIAGONAL = [
  [1, 1],
  [1, -1],
];

/**
 * @typedef {{nNodes: number, rest: Float64Array, axial: number, lineStart: Int32Array, lineNodes: Int32Array,
 *   cells: Int32Array, nCells: number, columns: number, rows: number, squares: Int32Array}} Lattice `squares` are
 *   [node][column, row]; `rest` is [node][x, y] about the centroid in pitches; lines are chains of neighbours, the first
 *   `axial` of them along the grid; cells list corners 00 10 01 11
 */

/** @param {{columns: number, rows: number, inside: Uint8Array}} squares @returns {Lattice} */
export function lattice({ columns, rows, inside }) {
  const number = new Int32Array(columns * rows).fill(-1);
  const squares = [];
  for (let j = 0; j < rows; j++)
    for (let i = 0; i < columns; i++)
      if (inside[i * rows + j]) {
        number[i * rows + j] = squares.length;
        squares.push([i, j]);
      }
  const at = (i, j) => (i >= 0 && i < columns && j >= 0 && j < rows ? number[i * rows + j] : -1);
  const chains = ([di, dj]) => {
    const found = [];
    for (let [i, j] of squares) {
      if (at(i - di, j - dj) >= 0) continue;
      const chain = [];
      for (let node = at(i, j); node >= 0; node = at(i, j)) {
        chain.push(node);
        i += di;
        j += dj;
      }
      if (chain.length > 1) found.push(chain);
    }
    return found;
  };
  const axial = AXIAL.flatMap(chains);
  const lines = [...axial, ...DIAGONAL.flatMap(chains)];
  const lineStart = new Int32Array(lines.length + 1);
  lines.forEach((line, k) => (lineStart[k + 1] = lineStart[k] + line.length));
  const cells = [];
  for (let i = 0; i + 1 < columns; i++)
    for (let j = 0; j + 1 < rows; j++) {
      const corners = [at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)];
      if (corners.every((node) => node >= 0)) cells.push(...corners);
    }
  return {
    nNodes: squares.length,
    rest: restOf(squares),
    axial: axial.length,
    lineStart,
    lineNodes: Int32Array.from(lines.flat()),
    cells: Int32Array.from(cells),
    nCells: cells.length / 4,
    columns,
    rows,
    squares: Int32Array.from(squares.flat()),
  };
}

function restOf(squares) {
  const n = squares.length;
  const mean = [0, 1].map((k) => squares.reduce((sum, square) => sum + square[k], 0) / n);
  const rest = new Float64Array(2 * n);
  squares.forEach(([i, j], node) => {
    rest[2 * node] = i - mean[0];
    rest[2 * node + 1] = j - mean[1];
  });
  return rest;
}
