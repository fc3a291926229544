// Lowest modes of a banded matrix: Lanczos' method on its inverse.
import { add, dot, scaled, without } from "./vectors.js";

const STEPS = 40;
const MOST_TURNS = 60; // of QL, for one value; two or three are usual
const EXHAUSTED = 1e-11; // of a vector: what is left of it once nothing new is found

/** A symmetric matrix, [row][half + 1] from the left to the diagonal, of elements factor · weights weightsᵀ. */
export class BandedMatrix {
  /** @param {number} n @param {{nodes: number[], weights: number[], factor: number}[]} elements */
  constructor(n, elements) {
    this.n = n;
    this.half = elements.reduce((most, { nodes }) => Math.max(most, Math.max(...nodes) - Math.min(...nodes)), 0);
    this.rows = new Float64Array(n * (this.half + 1));
    for (const { nodes, weights, factor } of elements)
      nodes.forEach((a, p) =>
        nodes.forEach((b, q) => {
          if (b <= a) this.rows[this.#at(a, b)] += factor * weights[p] * weights[q];
        }),
      );
    /** No less than the largest eigenvalue. */
    this.largest = this.#bound();
  }

  #at(row, column) {
    return row * (this.half + 1) + this.half - (row - column);
  }

  #bound() {
    const sums = new Float64Array(this.n);
    this.#each((i, j, value) => {
      sums[i] += Math.abs(value);
      if (j !== i) sums[j] += Math.abs(value);
    });
    return sums.reduce((most, sum) => Math.max(most, sum), 0);
  }

  #each(visit) {
    for (let i = 0; i < this.n; i++)
      for (let j = Math.max(0, i - this.half); j <= i; j++) visit(i, j, this.rows[this.#at(i, j)]);
  }

  /** Rayleigh's quotient of a unit vector. */
  quotient(unit) {
    let sum = 0;
    this.#each((i, j, value) => (sum += (j === i ? 1 : 2) * value * unit[i] * unit[j]));
    return sum;
  }

  /** Solver of the matrix with a shift along its diagonal. @param {number} about an eigenvalue */
  inverse(about) {
    const shift = about > 1e-12 * this.largest ? about : 1e-6 * this.largest || 1;
    const { n, half } = this;
    const width = half + 1;
    const lower = this.rows.slice();
    // The place of row i, column k is own + k.
    for (let i = 0; i < n; i++) {
      const own = i * width + half - i;
      lower[own + i] += shift;
      for (let j = Math.max(0, i - half); j <= i; j++) {
        const other = j * width + half - j;
        let sum = lower[own + j];
        for (let k = Math.max(0, i - half); k < j; k++) sum -= lower[own + k] * lower[other + k];
        lower[own + j] = i === j ? Math.sqrt(sum) : sum / lower[other + j];
      }
    }
    const solve = (right) => {
      const y = Float64Array.from(right);
      for (let i = 0; i < n; i++) {
        const own = i * width + half - i;
        let sum = y[i];
        for (let k = Math.max(0, i - half); k < i; k++) sum -= lower[own + k] * y[k];
        y[i] = sum / lower[own + i];
      }
      for (let i = n - 1; i >= 0; i--) {
        const own = i * width + half - i;
        const value = (y[i] /= lower[own + i]);
        for (let k = Math.max(0, i - half); k < i; k++) y[k] -= lower[own + k] * value;
      }
      return y;
    };
    return { solve, shift };
  }
}

/**
 * Modes that hold some of a unit vector: eigenvalue, share of the vector, and unit direction of what they hold; the
 * lowest are right to rounding.
 *
 * @param {ReturnType<BandedMatrix["inverse"]>} inverse
 * @param {Float64Array} start
 * @param {Float64Array[]} along directions that have no stiffness or do not count, orthonormal, none along `start`
 * @returns {{squared: number, share: number, direction: Float64Array}[]} rising
 */
export const heldModes = ({ solve, shift }, start, along) => {
  const [basis, diagonal, beside] = [[start], [], []];
  for (let step = 0; step < Math.min(STEPS, start.length); step++) {
    const next = solve(basis[step]);
    diagonal.push(dot(next, basis[step]));
    const fresh = without(next, [...along, ...basis]);
    if (!(fresh.size > EXHAUSTED * Math.sqrt(dot(next, next)))) break;
    beside.push(fresh.size);
    basis.push(fresh.unit);
  }
  const { values, vectors } = tridiagonalModes(diagonal, beside);
  return values
    .map((value, k) => {
      const direction = new Float64Array(start.length);
      vectors[k].forEach((weight, j) => add(direction, basis[j], weight));
      // So turned that it lies along the vector that it holds some of.
      const share = vectors[k][0];
      return { squared: 1 / value - shift, share: Math.abs(share), direction: scaled(direction, share < 0 ? -1 : 1) };
    })
    .sort((a, b) => a.squared - b.squared);
};

/** Eigenvalues and vectors of a small symmetric tridiagonal matrix: QL steps with Wilkinson's shift. */
export const tridiagonalModes = (diagonal, beside) => {
  const m = diagonal.length;
  const d = Float64Array.from(diagonal);
  const e = Float64Array.from({ length: m }, (_, k) => (k < m - 1 ? beside[k] : 0));
  const vectors = Array.from({ length: m }, (_, i) => Float64Array.from({ length: m }, (__, j) => (i === j ? 1 : 0)));
  for (let low = 0; low < m; low++)
    for (let turn = 0; turn < MOST_TURNS; turn++) {
      let high = low;
      while (high < m - 1 && Math.abs(e[high]) > Number.EPSILON * (Math.abs(d[high]) + Math.abs(d[high + 1]))) high++;
      if (high === low) break;
      chase(d, e, vectors, low, high);
    }
  return { values: [...d], vectors };
};

/** One QL step on the rows from `low` to `high`: what is beside the diagonal is chased upwards, and shrinks. */
const chase = (d, e, vectors, low, high) => {
  const theta = (d[low + 1] - d[low]) / (2 * e[low]);
  let [sine, cosine, lost] = [1, 1, 0];
  let g = d[high] - d[low] + e[low] / (theta + (theta < 0 ? -1 : 1) * Math.hypot(theta, 1));
  for (let i = high - 1; i >= low; i--) {
    const [f, b] = [sine * e[i], cosine * e[i]];
    const size = Math.hypot(f, g);
    e[i + 1] = size;
    if (size === 0) {
      d[i + 1] -= lost;
      e[high] = 0;
      return;
    }
    sine = f / size;
    cosine = g / size;
    g = d[i + 1] - lost;
    const moved = (d[i] - g) * sine + 2 * cosine * b;
    lost = sine * moved;
    d[i + 1] = g + lost;
    g = cosine * moved - b;
    const [below, above] = [vectors[i], vectors[i + 1]];
    for (let k = 0; k < below.length; k++) {
      const [left, right] = [below[k], above[k]];
      above[k] = sine * left + cosine * right;
      below[k] = cosine * left - sine * right;
    }
  }
  d[low] -= lost;
  e[low] = g;
  e[high] = 0;
};
