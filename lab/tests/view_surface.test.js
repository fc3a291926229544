// The drawn surface: cut to the outline, through the nodes, and finite whatever they do.
import assert from "node:assert/strict";
import test from "node:test";
import { insideOf } from "../src/model/outline.js";
import { latticeOf } from "../src/model/scenario.js";
import { Curvature } from "../src/view/curvature.js";
import { FRAME_SIZE, intoWorld, ontoPlate, plateFrame } from "../src/view/frame.js";
import { SheetSurface } from "../src/view/surface.js";
import { cutGrid } from "../src/view/trimming.js";

const FISH = [[-0.055, 0], [-0.04, 0.014], [-0.015, 0.02], [0.012, 0.014], [0.03, 0.008], [0.052, 0.024], [0.046, 0],
  [0.052, -0.024], [0.03, -0.008], [0.012, -0.014], [-0.015, -0.02], [-0.04, -0.014]];
const RING = ["..####..", ".######.", "###..###", "##....##", "##....##", "###..###", ".######.", "..####.."];
const SHEETS = {
  disk: { outline: { shape: "disk", radius: 0.04 }, pitch: 0.01, area: Math.PI * 0.04 ** 2 },
  "fine disk": { outline: { shape: "disk", radius: 0.04 }, pitch: 0.0025, area: Math.PI * 0.04 ** 2 },
  ellipse: { outline: { shape: "ellipse", length: 0.12, width: 0.03 }, pitch: 0.006, area: Math.PI * 9e-4 },
  rectangle: { outline: { shape: "rectangle", length: 0.1, width: 0.06 }, pitch: 0.01, area: 0.006 },
  fish: { outline: { shape: "polygon", corners: FISH }, pitch: 0.005, area: shoelace(FISH) },
  ring: { outline: { shape: "mask", rows: RING, width_of_picture: 0.08 }, pitch: 0.01, area: 40e-4 },
  strip: { outline: { shape: "rectangle", length: 0.08, width: 0.01 }, pitch: 0.01, area: 8e-4 },
  tile: { outline: { shape: "rectangle", length: 0.01, width: 0.01 }, pitch: 0.01, area: 1e-4 },
};

function shoelace(corners) {
  const twice = corners.reduce((sum, [x, y], k) => {
    const [u, v] = corners[(k + 1) % corners.length];
    return sum + x * v - u * y;
  }, 0);
  return Math.abs(twice) / 2;
}

const laid = (name, height = () => 0) => {
  const sheet = { ...SHEETS[name], thickness: 0.002 }, lattice = latticeOf(sheet);
  const surface = new SheetSurface(sheet, lattice);
  const nodes = new Float32Array(3 * lattice.nNodes);
  for (let k = 0; k < lattice.nNodes; k++) {
    const x = (lattice.squares[2 * k] - (lattice.columns - 1) / 2) * sheet.pitch;
    const y = (lattice.squares[2 * k + 1] - (lattice.rows - 1) / 2) * sheet.pitch;
    nodes.set([x, y, height(x, y)], 3 * k);
  }
  const frame = plateFrame([0, 0, 0, 0, 0, 0], 0, new Float64Array(FRAME_SIZE));
  surface.update(nodes, nodes, frame);
  return { sheet, lattice, surface, nodes, frame };
};

for (const name of Object.keys(SHEETS))
  test(`a ${name} covers its outline and no more`, () => {
    const { sheet, surface } = laid(name), { x, y, triangles, loops } = surface.cut;
    const area = surface.area.reduce((sum, each) => sum + each, 0);
    assert.ok(Math.abs(area / sheet.area - 1) < 0.01, `area ${area} of ${sheet.area}`);
    const inside = insideOf(sheet.outline), within = 1 - 1e-4;
    for (let k = 0; k < x.length; k++) assert.ok(inside(x[k] * within, y[k] * within) || onEdge(inside, x[k], y[k]));
    assert.ok(triangles.every((k) => k < x.length));
    assert.equal(loops.length, name === "ring" ? 2 : 1);
    assert.ok(surface.nVertices < 6500);
  });

const onEdge = (inside, x, y) => [[1e-5, 0], [-1e-5, 0], [0, 1e-5], [0, -1e-5]].some(([u, v]) => inside(x + u, y + v));

test("a flat and a tilted sheet are drawn exactly, an arched one to what straight lines beyond its nodes miss", () => {
  const heights = [[() => 0.003, 1e-7], [(x, y) => 0.2 * x - 0.1 * y, 1e-7], [(x, y) => 5 * x * x - 3 * x * y, 1.1e-3]];
  for (const name of ["disk", "fish", "ring", "fine disk"])
    for (const [height, off] of heights) {
      const { surface } = laid(name, height), { x, y } = surface.cut;
      for (let k = 0; k < x.length; k++) {
        assert.ok(Math.abs(surface.points[3 * k + 2] - height(x[k], y[k])) < off, `${name} at ${x[k]}, ${y[k]}`);
        assert.ok(Math.abs(surface.points[3 * k] - x[k]) < 1e-7);
      }
    }
});

test("normals are of length one, up where the sheet is flat and down where it lies turned over", () => {
  for (const name of Object.keys(SHEETS)) {
    const { surface, nodes, frame } = laid(name);
    const third = (values) => values.filter((_, k) => k % 3 === 2);
    assert.ok(third(surface.normals).every((z) => z > 0.999), name);
    assert.ok(surface.steepest > 0.999);
    if (name === "tile" || name === "strip") continue; // a row of nodes has no sides
    for (let k = 1; k < nodes.length; k += 3) nodes[k] = -nodes[k];
    surface.update(nodes, nodes, frame);
    assert.ok(third(surface.normals).every((z) => z < -0.999), name);
    assert.ok(surface.steepest < -0.999);
  }
});

test("nodes all in one place, or in disorder, leave nothing that is not finite", () => {
  const { surface, nodes, frame } = laid("fish");
  surface.update(nodes.map(() => 0.01), nodes.map(() => 0.01), frame);
  assert.ok([...surface.points, ...surface.normals].every(Number.isFinite));
  const torn = nodes.map((_, k) => Math.sin(1000 * k));
  surface.update(torn, torn, frame);
  assert.ok([...surface.points, ...surface.normals].every(Number.isFinite));
});

test("a sheet that has turned knows by how much", () => {
  const { surface, nodes, frame } = laid("ellipse");
  const turned = nodes.slice(), cos = Math.cos(2.5), sin = Math.sin(2.5);
  for (let k = 0; k < nodes.length; k += 3)
    turned.set([0.02 + cos * nodes[k] - sin * nodes[k + 1], sin * nodes[k] + cos * nodes[k + 1] - 0.01], k);
  surface.update(turned, turned, frame);
  assert.ok(Math.abs(surface.angle - 2.5) < 1e-6);
  assert.ok(Math.hypot(surface.centre[0] - 0.02, surface.centre[1] + 0.01) < 1e-7);
});

test("curvature of a bowl is that of its paraboloid", () => {
  const { sheet, lattice, nodes, frame } = laid("fine disk", (x, y) => 2 * x * x + 2 * y * y);
  const curvature = new Curvature(sheet, lattice);
  curvature.update(nodes, frame);
  const off = (k) => Math.hypot(nodes[3 * k], nodes[3 * k + 1]);
  const middle = curvature.values[curvature.values.reduce((best, _, k) => (off(k) < off(best) ? k : best), 0)];
  assert.ok(Math.abs(middle + 4) < 0.15, `${middle}`); // second derivative 4 both ways; a bowl is negative
  assert.ok(curvature.most < 4.2);
});

test("a cell with two opposite corners inside is cut into one piece", () => {
  const corners = new Set(["1,1", "2,2"]);
  const off = (v) => Math.abs(v - Math.round(v));
  const inside = (x, y) => corners.has(`${Math.round(x)},${Math.round(y)}`) && Math.max(off(x), off(y)) < 0.25;
  const { x, triangles, loops } = cutGrid(inside, [0, 1, 2, 3], [0, 1, 2, 3]);
  assert.equal(loops.length, 1);
  assert.equal(loops[0].length, 8);
  assert.ok(triangles.length > 0 && x.length === 10);
});

test("the plate's frame turns about a point below its surface", () => {
  const frame = plateFrame([0.001, -0.002, 0.003, 0.3, -0.2, 0.5], 0.05, new Float64Array(FRAME_SIZE));
  const point = intoWorld(frame, 0.01, -0.02, 0.005, [0, 0, 0]);
  const back = ontoPlate(frame, point, new Float64Array(3));
  [0.01, -0.02, 0.005].forEach((value, d) => assert.ok(Math.abs(back[d] - value) < 1e-12));
  const axis = intoWorld(frame, 0, 0, -0.05, [0, 0, 0]); // the point turned about: only moved along
  [0.001, -0.002, 0.003 - 0.05].forEach((value, d) => assert.ok(Math.abs(axis[d] - value) < 1e-12));
});
