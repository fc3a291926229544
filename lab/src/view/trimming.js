// A grid of cells cut to an outline: the triangles inside, and the way around its edge.

const HALVINGS = 24;

/**
 * @typedef {object} Cut
 * @property {Float64Array} x of each vertex, m from the outline's middle; grid points first, then crossings
 * @property {Float64Array} y
 * @property {Uint32Array} triangles three vertices each, counter-clockwise from above
 * @property {number[][]} loops vertices along each edge, the sheet on the left
 * @property {Int32Array} inner of each vertex, itself where it is a grid point and else the grid point inside of it
 */

/**
 * Cut the cells between grid lines to what lies inside.
 * @param {(x: number, y: number) => boolean} inside nothing on the outermost grid lines is
 * @param {ArrayLike<number>} xs grid lines, m
 * @param {ArrayLike<number>} ys
 * @returns {Cut}
 */
export const cutGrid = (inside, xs, ys) => {
  const columns = xs.length, rows = ys.length;
  const within = new Uint8Array(columns * rows);
  for (let i = 0; i < columns; i++)
    for (let j = 0; j < rows; j++) within[i * rows + j] = inside(xs[i], ys[j]) ? 1 : 0;
  const vertices = new Vertices(inside, xs, ys, within);
  const triangles = [], after = new Map();
  for (let i = 0; i + 1 < columns; i++)
    for (let j = 0; j + 1 < rows; j++) {
      const a = i * rows + j;
      cutCell([a, a + rows, a + rows + 1, a + 1], within, vertices, triangles, after);
    }
  return { ...vertices.arrays(), triangles: Uint32Array.from(triangles), loops: closed(after) };
};

/** Vertices by the grid point or the cut edge that they lie on, numbered as they are asked for. */
class Vertices {
  constructor(inside, xs, ys, within) {
    Object.assign(this, { inside, xs, ys, within, points: [], inner: [], byGrid: new Map(), byEdge: new Map() });
  }

  at(point) {
    if (!this.byGrid.has(point)) {
      const n = this.points.length;
      this.byGrid.set(point, n);
      this.points.push(this.place(point));
      this.inner.push(n);
    }
    return this.byGrid.get(point);
  }

  /** Where the outline crosses the edge between a grid point inside and one outside, by halving. */
  crossing(a, b) {
    const key = a * this.within.length + b;
    if (!this.byEdge.has(key)) {
      const [x0, y0] = this.place(a), [x1, y1] = this.place(b);
      let low = 0, high = 1;
      for (let k = 0; k < HALVINGS; k++) {
        const share = (low + high) / 2;
        if (this.inside(x0 + share * (x1 - x0), y0 + share * (y1 - y0))) low = share;
        else high = share;
      }
      const inner = this.at(a);
      this.byEdge.set(key, this.points.length);
      this.points.push([x0 + low * (x1 - x0), y0 + low * (y1 - y0)]);
      this.inner.push(inner);
    }
    return this.byEdge.get(key);
  }

  place(point) {
    const rows = this.ys.length, j = point % rows;
    return [this.xs[(point - j) / rows], this.ys[j]];
  }

  arrays() {
    return {
      x: Float64Array.from(this.points, ([x]) => x),
      y: Float64Array.from(this.points, ([, y]) => y),
      inner: Int32Array.from(this.inner),
    };
  }
}

/** Add the triangles of one cell, corners counter-clockwise, and its pieces of edge: from a crossing to the next. */
const cutCell = (corners, within, vertices, triangles, after) => {
  const count = within[corners[0]] + within[corners[1]] + within[corners[2]] + within[corners[3]];
  if (count === 0) return;
  // From a corner inside whose predecessor is outside, so that each way out is followed by the way in.
  let first = 0;
  if (count < 4) while (!within[corners[first]] || within[corners[(first + 3) % 4]]) first++;
  const polygon = [];
  let leaving = -1;
  for (let k = first; k < first + 4; k++) {
    const a = corners[k % 4], b = corners[(k + 1) % 4];
    if (within[a]) polygon.push(vertices.at(a));
    if (within[a] === within[b]) continue;
    const crossing = within[a] ? vertices.crossing(a, b) : vertices.crossing(b, a);
    polygon.push(crossing);
    if (within[a]) leaving = crossing;
    else after.set(leaving, crossing);
  }
  for (let k = 2; k < polygon.length; k++) triangles.push(polygon[0], polygon[k - 1], polygon[k]);
};

/** Loops of what follows what. */
const closed = (after) => {
  const loops = [];
  while (after.size) {
    const [start] = after.keys();
    const loop = [];
    for (let at = start; after.has(at); ) {
      const next = after.get(at);
      after.delete(at);
      loop.push(at);
      at = next;
    }
    loops.push(loop);
  }
  return loops;
};
