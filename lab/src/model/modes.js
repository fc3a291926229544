// The natural frequency of a sheet: of its dish mode, as the package's model/modes.py chooses it.
//
// Lanczos' method on the inverse of the stiffness, begun from the ideal dish x² + y²: what it finds are the modes that
// hold some of that shape, the lowest first, each with its share of it.
import { latticeOf, nodeMass } from "./sheet.js";

const MOST_NODES = 3000;
const STEPS = 60;
const MOSTLY = 0.6; // share of the shape at which a mode is mostly that shape
const PARTLY = 0.3; // and below which it is not it
const ROUNDING = 1e-9; // of the stiffest: what is less is no stiffness

const kept = new Map();

/** First-order natural angular frequency ω_n, rad/s; NaN where no mode bends the sheet, or it has too many nodes. */
export function naturalFrequency(sheet) {
  const lattice = latticeOf(sheet);
  if (lattice.nNodes > MOST_NODES || !(sheet.bending_stiffness > 0)) return NaN;
  const torsion = sheet.torsion_stiffness / sheet.bending_stiffness;
  let byLattice = kept.get(lattice);
  if (!byLattice) {
    if (kept.size > 12) kept.clear();
    kept.set(lattice, (byLattice = new Map()));
  }
  // In units of k_b/(m l²): what remains is the lattice's and the ratio's own.
  if (!byLattice.has(torsion)) byLattice.set(torsion, unitFrequency(lattice, torsion));
  return byLattice.get(torsion) * Math.sqrt(sheet.bending_stiffness / nodeMass(sheet)) / sheet.pitch;
}

function unitFrequency(lattice, torsion) {
  const matrix = stiffness(lattice, torsion);
  const rigid = rigidMotion(lattice);
  const [x, y] = [0, 1].map((a) => Float64Array.from({ length: lattice.nNodes }, (_, k) => lattice.rest[2 * k + a]));
  const wide = [x, y].every((values) => Math.max(...values) > Math.min(...values));
  if (wide) {
    const found = modesAlong(matrix, rigid, x.map((each, k) => each * each + y[k] * y[k]));
    const dish = found.find((mode) => mode.share > MOSTLY) ?? [...found].sort((a, b) => b.share - a.share)[0];
    if (dish && dish.share > PARTLY && dish.squared > 0) return Math.sqrt(dish.squared);
  }
  // No dish: the lowest that bends, found from a shape that no symmetry keeps from anything.
  const any = modesAlong(matrix, rigid, x.map((_, k) => Math.sin(1.3 * k * k + 0.7)));
  return Math.sqrt(any.find((mode) => mode.squared > ROUNDING * matrix.largest)?.squared ?? NaN);
}

/** Banded matrix of the nodes' deflections: [row][half + 1] from the diagonal to the left. */
function stiffness(lattice, torsion) {
  const { nNodes: n, lineStart, lineNodes, axial, cells } = lattice;
  const elements = [];
  for (let i = 0; i < axial; i++)
    for (let k = lineStart[i]; k + 2 < lineStart[i + 1]; k++)
      elements.push([[lineNodes[k], lineNodes[k + 1], lineNodes[k + 2]], [1, -2, 1], 1]);
  if (torsion > 0)
    for (let c = 0; c < cells.length; c += 4) elements.push([[...cells.subarray(c, c + 4)], [1, -1, -1, 1], 2 * torsion]);
  const half = Math.max(1, ...elements.map(([nodes]) => Math.max(...nodes) - Math.min(...nodes)));
  const width = half + 1;
  const band = new Float64Array(n * width);
  for (const [nodes, weights, factor] of elements)
    nodes.forEach((a, p) => nodes.forEach((b, q) => {
      if (b <= a) band[a * width + half - (a - b)] += factor * weights[p] * weights[q];
    }));
  let largest = 0;
  for (let k = 0; k < n; k++) largest = Math.max(largest, band[k * width + half]);
  return { n, half, band, largest: 4 * largest };
}

/** Heave, roll and pitch, orthonormal. */
function rigidMotion({ nNodes, rest }) {
  const columns = [() => 1, (k) => rest[2 * k], (k) => rest[2 * k + 1]].map((of) => Float64Array.from({ length: nNodes }, (_, k) => of(k)));
  const basis = [];
  for (const column of columns) {
    const own = without(column, basis);
    if (own) basis.push(own);
  }
  return basis;
}

/** A vector with what lies along others taken out, of length 1; null where nothing is left. */
function without(vector, others) {
  const out = vector.slice();
  const before = Math.sqrt(dot(out, out));
  for (let pass = 0; pass < 2; pass++) for (const other of others) add(out, other, -dot(out, other));
  const size = Math.sqrt(dot(out, out));
  return size > 1e-9 * before && size > 0 ? out.map((each) => each / size) : null;
}

const dot = (a, b) => {
  let sum = 0;
  for (let k = 0; k < a.length; k++) sum += a[k] * b[k];
  return sum;
};
const add = (a, b, factor) => {
  for (let k = 0; k < a.length; k++) a[k] += factor * b[k];
};

/** Modes that hold some of a shape: ω² and the shape's share, rising in ω². */
function modesAlong(matrix, rigid, shape) {
  const first = without(shape, rigid);
  if (!first) return [];
  const shift = 1e-3 * Math.max(dot(first, times(matrix, first)), 1e-12 * matrix.largest);
  const factor = cholesky(matrix, shift);
  const basis = [first];
  const [alpha, beta] = [[], []];
  for (let step = 0; step < Math.min(STEPS, matrix.n); step++) {
    const next = solve(factor, basis[step]);
    alpha.push(dot(next, basis[step]));
    const size = Math.sqrt(dot(next, next));
    const own = without(next, [...rigid, ...basis]);
    if (!own) break;
    const along = dot(own, next);
    if (along < 1e-11 * size) break;
    beta.push(along);
    basis.push(own);
  }
  const { values, firsts } = tridiagonal(alpha, beta);
  return values
    .map((value, k) => ({ squared: Math.max(0, 1 / value - shift), share: Math.abs(firsts[k]) }))
    .filter(({ squared, share }) => Number.isFinite(squared) && share > 1e-6)
    .sort((a, b) => a.squared - b.squared);
}

function times({ n, half, band }, v) {
  const out = new Float64Array(n);
  for (let i = 0; i < n; i++)
    for (let d = 0; d <= Math.min(half, i); d++) {
      const value = band[i * (half + 1) + half - d];
      out[i] += value * v[i - d];
      if (d) out[i - d] += value * v[i];
    }
  return out;
}

function cholesky({ n, half, band }, shift) {
  const width = half + 1;
  const L = band.slice();
  for (let i = 0; i < n; i++) {
    L[i * width + half] += shift;
    for (let j = Math.max(0, i - half); j <= i; j++) {
      let sum = L[i * width + half - (i - j)];
      for (let k = Math.max(0, i - half, j - half); k < j; k++) sum -= L[i * width + half - (i - k)] * L[j * width + half - (j - k)];
      L[i * width + half - (i - j)] = i === j ? Math.sqrt(Math.max(sum, 1e-300)) : sum / L[j * width + half];
    }
  }
  return { n, half, L };
}

function solve({ n, half, L }, b) {
  const width = half + 1;
  const y = Float64Array.from(b);
  for (let i = 0; i < n; i++) {
    for (let k = Math.max(0, i - half); k < i; k++) y[i] -= L[i * width + half - (i - k)] * y[k];
    y[i] /= L[i * width + half];
  }
  for (let i = n - 1; i >= 0; i--) {
    y[i] /= L[i * width + half];
    for (let k = Math.max(0, i - half); k < i; k++) y[k] -= L[i * width + half - (i - k)] * y[i];
  }
  return y;
}

/** Eigenvalues of a small symmetric tridiagonal matrix, and the first components of its vectors, by Jacobi's rotations. */
function tridiagonal(alpha, beta) {
  const m = alpha.length;
  const A = Array.from({ length: m }, (_, i) => Float64Array.from({ length: m }, (_, j) => (i === j ? alpha[i] : Math.abs(i - j) === 1 ? beta[Math.min(i, j)] : 0)));
  const row = new Float64Array(m);
  if (m) row[0] = 1;
  for (let sweep = 0; sweep < 60; sweep++) {
    let off = 0;
    for (let p = 0; p < m; p++)
      for (let q = p + 1; q < m; q++) {
        off += A[p][q] ** 2;
        if (Math.abs(A[p][q]) < 1e-300) continue;
        const theta = (A[q][q] - A[p][p]) / (2 * A[p][q]);
        const t = Math.sign(theta || 1) / (Math.abs(theta) + Math.sqrt(theta * theta + 1));
        const c = 1 / Math.sqrt(t * t + 1);
        const s = t * c;
        for (let k = 0; k < m; k++) [A[k][p], A[k][q]] = [c * A[k][p] - s * A[k][q], s * A[k][p] + c * A[k][q]];
        for (let k = 0; k < m; k++) [A[p][k], A[q][k]] = [c * A[p][k] - s * A[q][k], s * A[p][k] + c * A[q][k]];
        [row[p], row[q]] = [c * row[p] - s * row[q], s * row[p] + c * row[q]];
      }
    if (off < 1e-28 * A.reduce((sum, r, i) => sum + r[i] ** 2, 0)) break;
  }
  return { values: A.map((r, i) => r[i]), firsts: row };
}
