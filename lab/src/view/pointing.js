// What is pointed at: a ray from the eye, where it meets the sheet's plane, and what a drag from there does.

/** Speed of a push over how far was dragged, 1/s, and the most, m/s. */
export const PER_DRAG = 8, FASTEST = 1.2;

/**
 * Where a ray meets the plane of the plate, moved up by a height.
 * @param {ArrayLike<number>} from world, m
 * @param {ArrayLike<number>} way
 * @param {Float64Array} frame of the plate
 * @param {number} height m
 * @returns {number[] | null} world; null where it does not
 */
export const meetPlane = (from, way, frame, height) => {
  const normal = [frame[2], frame[5], frame[8]];
  let down = 0, above = -height;
  for (let d = 0; d < 3; d++) {
    down += way[d] * normal[d];
    above += (from[d] - frame[9 + d]) * normal[d];
  }
  const far = -above / down;
  return Math.abs(down) > 1e-6 && far > 0 && Number.isFinite(far) ? [0, 1, 2].map((d) => from[d] + far * way[d]) : null;
};

/** The node nearest to a ray, and how far from it, m; of those equally near, the first the ray comes to. */
export const nearestNode = (from, way, nodes) => {
  const length = Math.hypot(...way);
  let best = { node: -1, off: Infinity };
  for (let k = 0; k < nodes.length / 3; k++) {
    const x = nodes[3 * k] - from[0], y = nodes[3 * k + 1] - from[1], z = nodes[3 * k + 2] - from[2];
    const along = (x * way[0] + y * way[1] + z * way[2]) / length;
    const off = Math.sqrt(Math.max(0, x * x + y * y + z * z - along * along));
    if (along > 0 && off < best.off) best = { node: k, off };
  }
  return best;
};

/**
 * What a drag from one place to another pushes with.
 * @param {number[]} at where the sheet was taken hold of, world, m
 * @param {number[]} to where it was let go
 * @returns {{at: number[], velocity: number[]}}
 */
export const pushOf = (at, to) => {
  const drag = [0, 1, 2].map((d) => PER_DRAG * (to[d] - at[d]));
  const speed = Math.hypot(...drag), share = speed > FASTEST ? FASTEST / speed : 1;
  return { at: [at[0], at[1]], velocity: drag.map((v) => v * share) };
};

/** The way in the world that is to the right or left, away or towards, or up, for an eye at an azimuth, rad. */
export const wayOf = (direction, azimuth) => {
  const right = [-Math.sin(azimuth), Math.cos(azimuth), 0], away = [-Math.cos(azimuth), -Math.sin(azimuth), 0];
  const ways = { right, left: right.map((v) => -v), away, towards: away.map((v) => -v), up: [0, 0, 1] };
  return ways[direction] ?? null;
};
