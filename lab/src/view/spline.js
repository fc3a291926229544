// A smooth surface through the nodes of a square lattice, and on to the outline half a pitch beyond them.
//
// Between nodes it is Catmull and Rom's cubic, both ways. Squares that the cubic asks for and that carry no node are
// continued to, ring by ring: along straight lines of two squares inwards where there are any, else as the fourth
// corner of a parallelogram, else by as much as the sheet has turned as a whole.

const AROUND = [[1, 0, 1], [-1, 0, 1], [0, 1, 1], [0, -1, 1], [1, 1, 0.5], [-1, 1, 0.5], [1, -1, 0.5], [-1, -1, 0.5]];
const QUARTERS = [[1, 1], [-1, 1], [1, -1], [-1, -1]];
const TAPS = 16;

export class LatticeSpline {
  /**
   * @param {ArrayLike<number>} squares column and row of each node
   * @param {ArrayLike<number>} u columns of the points to give the surface at, in squares
   * @param {ArrayLike<number>} v rows of them
   */
  constructor(squares, u, v) {
    this.nNodes = squares.length / 2;
    this.nPoints = u.length;
    const grid = gridAround(squares, u, v);
    this.taps = new Uint32Array(TAPS * this.nPoints);
    this.weights = new Float32Array(TAPS * this.nPoints);
    const wanted = new Set();
    for (let k = 0; k < this.nPoints; k++) this.lay(grid, u[k], v[k], k, wanted);
    this.continueTo(grid, wanted);
    for (let t = 0; t < this.taps.length; t++) this.taps[t] = grid.number[this.taps[t]];
    this.extended = new Float32Array(3 * (this.nNodes + this.nBeyond));
  }

  /** Squares and weights that give point k. */
  lay(grid, u, v, k, wanted) {
    const i = Math.floor(u), j = Math.floor(v), across = cubic(u - i), along = cubic(v - j);
    for (let a = 0; a < 4; a++)
      for (let b = 0; b < 4; b++) {
        const weight = across[a] * along[b], t = TAPS * k + 4 * a + b;
        const none = weight === 0, column = none ? squareNear(i, across) : i + a - 1;
        const asked = grid.at(column, none ? squareNear(j, along) : j + b - 1);
        this.taps[t] = asked;
        this.weights[t] = weight;
        if (grid.number[asked] < 0) wanted.add(asked);
      }
  }

  /** Number the squares beyond the nodes that are wanted, and say what each is continued from. */
  continueTo(grid, wanted) {
    const start = [0], from = [], weight = [], steps = [];
    let next = this.nNodes;
    while ([...wanted].some((square) => grid.number[square] < 0)) {
      const ring = grid.ring();
      const rules = ring.map((square) => ruleFor(grid, square));
      ring.forEach((square, k) => {
        grid.number[square] = next++;
        for (const [index, share] of rules[k].from) {
          from.push(index);
          weight.push(share);
        }
        steps.push(...rules[k].step);
        start.push(from.length);
      });
    }
    this.nBeyond = next - this.nNodes;
    this.start = Uint32Array.from(start);
    this.from = Uint32Array.from(from);
    this.weight = Float32Array.from(weight);
    this.steps = Float32Array.from(steps);
  }

  /**
   * Points of the surface.
   * @param {Float32Array} nodes x, y, z of each, m
   * @param {Float32Array} points what is written to
   * @param {ArrayLike<number>} turned how far one square further along columns and along rows is, were the sheet stiff
   */
  through(nodes, points, turned) {
    const { extended: e, start, from, weight, steps, taps, weights } = this;
    e.set(nodes);
    for (let k = 0, g = 3 * this.nNodes; k < this.nBeyond; k++, g += 3) {
      const i = steps[2 * k], j = steps[2 * k + 1];
      let x = i * turned[0] + j * turned[3], y = i * turned[1] + j * turned[4], z = i * turned[2] + j * turned[5];
      for (let t = start[k]; t < start[k + 1]; t++) {
        const w = weight[t], n = 3 * from[t];
        x += w * e[n];
        y += w * e[n + 1];
        z += w * e[n + 2];
      }
      e[g] = x;
      e[g + 1] = y;
      e[g + 2] = z;
    }
    for (let k = 0, t = 0; k < 3 * this.nPoints; k += 3) {
      let x = 0, y = 0, z = 0;
      for (const last = t + TAPS; t < last; t++) {
        const w = weights[t], n = 3 * taps[t];
        x += w * e[n];
        y += w * e[n + 1];
        z += w * e[n + 2];
      }
      points[k] = x;
      points[k + 1] = y;
      points[k + 2] = z;
    }
    return points;
  }

  /** One number of each node, as the points have it: beyond the nodes, what the nearest have. */
  spread(values, points) {
    const { extended: e, start, from, taps, weights, nNodes } = this;
    for (let k = 0; k < nNodes; k++) e[k] = values[k];
    for (let k = 0; k < this.nBeyond; k++) {
      let sum = 0;
      for (let t = start[k]; t < start[k + 1]; t++) sum += e[from[t]];
      e[nNodes + k] = sum / (start[k + 1] - start[k]);
    }
    for (let k = 0, t = 0; k < this.nPoints; k++) {
      let sum = 0;
      for (const last = t + TAPS; t < last; t++) sum += weights[t] * e[taps[t]];
      points[k] = sum;
    }
    return points;
  }
}

/** Weights of four squares in a row for a point a share of the way from the second to the third. */
const cubic = (s) => [
  ((2 - s) * s - 1) * s / 2, ((3 * s - 5) * s * s + 2) / 2, ((4 - 3 * s) * s + 1) * s / 2, (s - 1) * s * s / 2,
];

/** A square that a point on the lattice's own line asks for. */
const squareNear = (i, weights) => i + weights.findIndex((w) => w !== 0) - 1;

/** The lattice's squares with room around them; `number` is what each is called, -1 so far. */
const gridAround = (squares, u, v) => {
  let low = Infinity, right = -Infinity, bottom = Infinity, top = -Infinity;
  const reach = (i, j) => {
    low = Math.min(low, i);
    right = Math.max(right, i);
    bottom = Math.min(bottom, j);
    top = Math.max(top, j);
  };
  for (let k = 0; k < squares.length; k += 2) reach(squares[k], squares[k + 1]);
  for (let k = 0; k < u.length; k++) reach(Math.floor(u[k]), Math.floor(v[k]));
  low -= 4;
  bottom -= 4;
  const columns = right - low + 5, rows = top - bottom + 5;
  const number = new Int32Array(columns * rows).fill(-1);
  const at = (i, j) => (i - low) * rows + j - bottom;
  for (let k = 0; k < squares.length; k += 2) number[at(squares[k], squares[k + 1])] = k / 2;
  const ring = () => {
    const found = [];
    for (let i = 1; i + 1 < columns; i++)
      for (let j = 1; j + 1 < rows; j++) {
        const s = i * rows + j;
        if (number[s] < 0 && AROUND.some(([di, dj]) => number[s + di * rows + dj] >= 0)) found.push(s);
      }
    return found;
  };
  return { number, rows, at, ring };
};

/** What a square is continued from: numbers and weights, and how many steps to add of the sheet as a whole. */
const ruleFor = ({ number, rows }, square) => {
  const known = (di, dj) => number[square + di * rows + dj] ?? -1;
  const lines = AROUND.filter(([i, j]) => known(i, j) >= 0 && known(2 * i, 2 * j) >= 0);
  const total = lines.reduce((sum, [, , w]) => sum + w, 0);
  if (total > 0) {
    const from = lines.flatMap(([i, j, w]) => [[known(i, j), (2 * w) / total], [known(2 * i, 2 * j), -w / total]]);
    return { from, step: [0, 0] };
  }
  const corner = QUARTERS.find(([i, j]) => known(i, 0) >= 0 && known(0, j) >= 0 && known(i, j) >= 0);
  if (corner) {
    const [i, j] = corner;
    return { from: [[known(i, 0), 1], [known(0, j), 1], [known(i, j), -1]], step: [0, 0] };
  }
  const [i, j] = AROUND.find(([di, dj]) => known(di, dj) >= 0);
  return { from: [[known(i, j), 1]], step: [-i, -j] };
};
