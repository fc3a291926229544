// Arithmetic of vectors, one number for each node.

export const dot = (a, b) => {
  let sum = 0;
  for (let k = 0; k < a.length; k++) sum += a[k] * b[k];
  return sum;
};

export const scaled = (a, factor) => a.map((each) => factor * each);

/** Add so many times another to a vector, in its place. */
export const add = (a, b, factor) => {
  for (let k = 0; k < a.length; k++) a[k] += factor * b[k];
};

/**
 * A vector less what lies along others, which are orthonormal: its size, and its direction where it has one.
 *
 * @returns {{unit: Float64Array, size: number}}
 */
export const without = (vector, others) => {
  const rest = vector.slice();
  // Twice, as the first time leaves rounding along them.
  for (let pass = 0; pass < 2; pass++) for (const other of others) add(rest, other, -dot(rest, other));
  const size = Math.sqrt(dot(rest, rest));
  return { unit: size > 0 ? scaled(rest, 1 / size) : rest, size };
};
