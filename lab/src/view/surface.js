// The sheet's lower face: a smooth surface through its nodes, cut to its outline.
import { insideOf, outlineSize } from "../model/outline.js";
import { LatticeSpline } from "./spline.js";
import { cutGrid } from "./trimming.js";

/** Cells over the outline's box, and the least and most along a side. */
const CELLS = 2000, LEAST_ALONG = 6, MOST_ALONG = 180;

export class SheetSurface {
  /**
   * @param {object} sheet of a scenario: outline, pitch, thickness
   * @param {import("../model/lattice.js").Lattice} lattice its nodes
   * @param {number} [cells] over the outline's box
   */
  constructor(sheet, lattice, cells = CELLS) {
    const { columns, rows, squares, nNodes } = lattice, { pitch } = sheet;
    this.nNodes = nNodes;
    this.pitch = pitch;
    this.thickness = sheet.thickness;
    this.size = outlineSize(sheet.outline);
    const middle = [(columns - 1) / 2, (rows - 1) / 2];
    const lines = gridLines(this.size, cells, STRAIGHT.has(sheet.outline.shape));
    this.cut = cutGrid(insideNear(sheet, lattice, middle), ...lines);
    const onLattice = (places, d) => places.map((at) => at / pitch + middle[d]), { x, y } = this.cut;
    this.nVertices = x.length;
    this.spline = new LatticeSpline(squares, onLattice(x, 0), onLattice(y, 1));
    this.rest = restOf(squares, pitch);
    /** Centroid of the nodes, m from the outline's middle. */
    this.centroid = [0, 1].map((d) => meanOf(squares, d) * pitch - middle[d] * pitch);
    this.area = areaOf(this.cut);
    this.points = new Float32Array(3 * this.nVertices);
    this.normals = new Float32Array(3 * this.nVertices);
    this.turned = new Float64Array(6);
    /** Cosine of the steepest slope anywhere over the plate; negative where the sheet is turned over. */
    this.steepest = 1;
    /** Middle of the nodes in the plate's frame, m, and how far the sheet has turned about its normal, rad. */
    this.centre = new Float64Array(3);
    this.angle = 0;
  }

  /**
   * Put the surface through nodes.
   * @param {Float32Array} nodes world, m
   * @param {Float32Array} onPlate the same in the plate's frame
   * @param {Float64Array} frame of the plate
   */
  update(nodes, onPlate, frame) {
    this.findPlace(onPlate);
    const cos = this.pitch * Math.cos(this.angle), sin = this.pitch * Math.sin(this.angle);
    for (let d = 0; d < 3; d++) {
      this.turned[d] = cos * frame[3 * d] + sin * frame[3 * d + 1];
      this.turned[3 + d] = -sin * frame[3 * d] + cos * frame[3 * d + 1];
    }
    this.spline.through(nodes, this.points, this.turned);
    this.findNormals(frame);
  }

  findPlace(onPlate) {
    const { rest, centre, nNodes: n } = this;
    centre.fill(0);
    for (let k = 0; k < 3 * n; k++) centre[k % 3] += onPlate[k] / n;
    let cross = 0, dot = 0;
    for (let k = 0; k < n; k++) {
      const x = onPlate[3 * k] - centre[0], y = onPlate[3 * k + 1] - centre[1];
      cross += rest[2 * k] * y - rest[2 * k + 1] * x;
      dot += rest[2 * k] * x + rest[2 * k + 1] * y;
    }
    this.angle = Math.atan2(cross, dot);
  }

  /** Upward unit normals of the vertices, from the triangles around each. */
  findNormals(frame) {
    const { points: p, normals: n } = this, { triangles, inner } = this.cut;
    n.fill(0);
    for (let t = 0; t < triangles.length; t += 3) {
      const a = 3 * triangles[t], b = 3 * triangles[t + 1], c = 3 * triangles[t + 2];
      const ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
      const vx = p[c] - p[a], vy = p[c + 1] - p[a + 1], vz = p[c + 2] - p[a + 2];
      const x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
      n[a] += x; n[a + 1] += y; n[a + 2] += z;
      n[b] += x; n[b + 1] += y; n[b + 2] += z;
      n[c] += x; n[c + 1] += y; n[c + 2] += z;
    }
    let steepest = 1;
    for (let k = 0; k < inner.length; k++) {
      const i = 3 * k, from = 3 * inner[k];
      const length = Math.sqrt(n[i] * n[i] + n[i + 1] * n[i + 1] + n[i + 2] * n[i + 2]);
      if (length > 1e-16) {
        n[i] /= length; n[i + 1] /= length; n[i + 2] /= length;
      } else if (from !== i) {
        n[i] = n[from]; n[i + 1] = n[from + 1]; n[i + 2] = n[from + 2];
      } else n[i + 2] = 1;
      steepest = Math.min(steepest, n[i] * frame[2] + n[i + 1] * frame[5] + n[i + 2] * frame[8]);
    }
    this.steepest = steepest;
  }
}

/** Outlines that lie along their bounding box; others only touch it. */
const STRAIGHT = new Set(["rectangle", "mask"]);

/** Lines of a grid over the outline, with one more all around: the outermost along its box, or half a cell off. */
const gridLines = (size, cells, straight) => {
  const step = Math.sqrt((size[0] * size[1]) / cells);
  return size.map((extent) => {
    const n = Math.min(Math.max(LEAST_ALONG, Math.round(extent / step)), MOST_ALONG);
    const first = straight ? -1 : -0.5;
    return Float64Array.from({ length: straight ? n + 3 : n + 2 }, (_, k) => ((k + first) / n - 0.5) * extent);
  });
};

/** Inside the outline, and no further than a pitch from a node. */
const insideNear = ({ outline, pitch }, { squares, columns, rows }, middle) => {
  const inside = insideOf(outline), there = new Set();
  for (let k = 0; k < squares.length; k += 2) there.add(squares[k] * (rows + 4) + squares[k + 1]);
  const carried = (i, j) => i >= 0 && j >= 0 && i < columns && j < rows && there.has(i * (rows + 4) + j);
  const near = (x, y) => {
    const u = x / pitch + middle[0], v = y / pitch + middle[1];
    for (let i = Math.ceil(u - 1); i <= u + 1; i++)
      for (let j = Math.ceil(v - 1); j <= v + 1; j++)
        if (carried(i, j) && Math.hypot(u - i, v - j) <= 1) return true;
    return false;
  };
  // A hair inwards, so that grid lines along an edge lie within it.
  return (x, y) => inside(x * (1 - 1e-9), y * (1 - 1e-9)) && near(x, y);
};

const meanOf = (squares, d) => {
  let sum = 0;
  for (let k = d; k < squares.length; k += 2) sum += squares[k];
  return (2 * sum) / squares.length;
};

/** Where each node is at rest, about the middle of all of them, m. */
const restOf = (squares, pitch) => {
  const mean = [meanOf(squares, 0), meanOf(squares, 1)];
  return Float64Array.from(squares, (at, k) => (at - mean[k % 2]) * pitch);
};

/** Share of the sheet's area that each vertex stands for, m². */
const areaOf = ({ x, y, triangles }) => {
  const area = new Float32Array(x.length);
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = triangles.subarray(t, t + 3);
    const whole = ((x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a])) / 2;
    for (const k of [a, b, c]) area[k] += whole / 3;
  }
  return area;
};
