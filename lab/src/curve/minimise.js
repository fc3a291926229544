// Small dense problems: least squares by Levenberg and Marquardt, pseudo-inverses, a root between two places.

// A step of scaled parameters, or a share of the slope that the cost allows, that counts as none; and such a share of the
// cost itself, which is flat about its minimum.
const TOLERANCE = 1e-10;
const FLAT = 1e-15;

const dot = (a, b) => {
  let sum = 0;
  for (let k = 0; k < a.length; k++) sum += a[k] * b[k];
  return sum;
};

/** AᵀA of columns. */
export const normalMatrix = (columns) => columns.map((one) => columns.map((other) => dot(one, other)));

/** Pseudo-inverse of a symmetric matrix, by Jacobi's rotations. */
export const pseudoInverse = (matrix, least = 1e-15) => {
  const n = matrix.length;
  const a = matrix.map((row) => [...row]);
  const vectors = a.map((_, i) => a.map((_, j) => (i === j ? 1 : 0)));
  // Each sweep squares what is left beside the diagonal: six leave nothing of it.
  for (let sweep = 0; sweep < 8; sweep++) {
    for (let p = 0; p < n; p++) for (let q = p + 1; q < n; q++) rotate(a, vectors, p, q);
  }
  const largest = Math.max(...a.map((row, i) => Math.abs(row[i])));
  return matrix.map((_, i) => matrix.map((_, j) => {
    const parts = a.map((row, k) => (Math.abs(row[k]) > least * largest ? (vectors[i][k] * vectors[j][k]) / row[k] : 0));
    return parts.reduce((sum, part) => sum + part, 0);
  }));
};

/** Turn axes p and q so that a[p][q] vanishes. */
const rotate = (a, vectors, p, q) => {
  if (a[p][q] === 0) return;
  const theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
  const t = (theta >= 0 ? 1 : -1) / (Math.abs(theta) + Math.hypot(theta, 1));
  const c = 1 / Math.hypot(t, 1);
  const s = t * c;
  const turned = (x, y) => [c * x - s * y, s * x + c * y];
  for (const row of a) [row[p], row[q]] = turned(row[p], row[q]);
  for (let j = 0; j < a.length; j++) [a[p][j], a[q][j]] = turned(a[p][j], a[q][j]);
  for (const row of vectors) [row[p], row[q]] = turned(row[p], row[q]);
};

/** Linear least squares: the shortest x of those that bring the columns' sum by x nearest to `values`. */
export const leastSquares = (columns, values) => {
  const inverse = pseudoInverse(normalMatrix(columns));
  const right = columns.map((column) => dot(column, values));
  return inverse.map((row) => dot(row, right));
};

/** x of a positive definite matrix and a right side, by Cholesky; null where the matrix is not. */
const solve = (matrix, right) => {
  const n = right.length;
  const lower = matrix.map(() => new Float64Array(n));
  const x = Float64Array.from(right);
  for (let i = 0; i < n; i++) {
    for (let j = 0; j <= i; j++) {
      let left = matrix[i][j];
      for (let k = 0; k < j; k++) left -= lower[i][k] * lower[j][k];
      if (i === j && !(left > 0)) return null;
      lower[i][j] = i === j ? Math.sqrt(left) : left / lower[j][j];
      if (j < i) x[i] -= lower[i][j] * x[j];
    }
    x[i] /= lower[i][i];
  }
  for (let i = n - 1; i >= 0; i--) {
    for (let k = i + 1; k < n; k++) x[i] -= lower[k][i] * x[k];
    x[i] /= lower[i][i];
  }
  return x;
};

/**
 * Least squares from `start` by Levenberg and Marquardt: parameters, and sum of squares.
 *
 * @param residual parameters → (n,) residuals
 * @param jacobian parameters → columns (n,) of derivatives, one for each parameter
 */
export const minimise = (residual, jacobian, start, evaluations) => {
  let [p, r, damping, used] = [start, residual(start), 1e-3, 1];
  let cost = dot(r, r);
  const scale = start.map(() => 0);
  while (used < evaluations) {
    const columns = jacobian(p);
    const matrix = normalMatrix(columns);
    const slope = columns.map((column) => -dot(column, r));
    matrix.forEach((row, i) => (scale[i] = Math.max(scale[i], row[i])));
    if (slope.every((value, i) => Math.abs(value) <= TOLERANCE * Math.sqrt(matrix[i][i] * cost))) break;
    let [length, gain] = [Infinity, -1];
    while (gain < 0 && length > TOLERANCE && used < evaluations) {
      const step = solve(matrix.map((row, i) => row.map((value, j) => value + (i === j ? damping * (scale[i] || 1) : 0))), slope);
      const tried = step && p.map((value, i) => value + step[i]);
      const reached = step ? residual(tried) : r;
      const next = step ? dot(reached, reached) : Infinity;
      length = step ? Math.max(...step.map(Math.abs)) : Infinity;
      used++;
      if (next <= cost) [gain, p, r, cost, damping] = [cost - next, tried, reached, next, Math.max(damping / 10, 1e-15)];
      else damping *= 5;
    }
    if (length <= TOLERANCE || gain <= FLAT * cost) break;
  }
  return { p, cost };
};

/** Root of a function between two places where its signs differ, within `tolerance`: halving and secants (Illinois). */
export const rootBetween = (f, low, high, tolerance) => {
  let [a, b, fa, fb] = [low, high, f(low), f(high)];
  let side = 0;
  for (let i = 0; i < 100 && Math.abs(b - a) > tolerance; i++) {
    // Every third step halves, so that the bracket shrinks whatever the function.
    const middle = i % 3 === 2 ? (a + b) / 2 : (a * fb - b * fa) / (fb - fa);
    const fm = f(middle);
    if (fm === 0) return middle;
    if (fm < 0 === fb < 0) {
      [b, fb] = [middle, fm];
      if (side === -1) fa /= 2;
      side = -1;
    } else {
      [a, fa] = [middle, fm];
      if (side === 1) fb /= 2;
      side = 1;
    }
  }
  return Math.abs(fa) < Math.abs(fb) ? a : b;
};
