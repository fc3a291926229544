// What needs no WebGL of the picture: pointing, pushing, the way so far, shadow, scales, camera.
import assert from "node:assert/strict";
import test from "node:test";
import { latticeOf } from "../src/model/scenario.js";
import { ViewCamera, VIEWS } from "../src/view/camera.js";
import { FRAME_SIZE, intoWorld, plateFrame } from "../src/view/frame.js";
import { arrowLength, discRadius } from "../src/view/loads.js";
import { scaleInWords } from "../src/view/notes.js";
import { Pace } from "../src/view/pace.js";
import { FASTEST, meetPlane, nearestNode, PER_DRAG, pushOf, wayOf } from "../src/view/pointing.js";
import { marksAlong } from "../src/view/print.js";
import { CELLS, Shadow } from "../src/view/shadow.js";
import { roundedUp, Shown } from "../src/view/shown.js";
import { Way } from "../src/view/way.js";

const close = (got, wanted, off = 1e-9) => assert.ok(Math.abs(got - wanted) <= off, `${got}, not ${wanted}`);
const frameOf = (pose, height = 0) => plateFrame(pose, height, new Float64Array(FRAME_SIZE));

const scenario = {
  sheet: { outline: { shape: "disk", radius: 0.04 }, pitch: 0.01, thickness: 0.0025, mass: 0.0136 },
  motion: { height: 0.005 }, start: { x: 0, y: 0, angle: 0 }, slip_limit: 0.01, gravity: 9.81, plate: null,
};
const lattice = latticeOf(scenario.sheet);
const flat = (z = 0) => {
  const nodes = new Float32Array(3 * lattice.nNodes);
  for (let k = 0; k < lattice.nNodes; k++)
    nodes.set([0.01 * lattice.rest[2 * k], 0.01 * lattice.rest[2 * k + 1], z], 3 * k);
  return nodes;
};
const still = { pose: [0, 0, 0, 0, 0, 0], time: 0 };

test("a ray meets the plate where it is, tilted or lifted, and never behind the eye", () => {
  const at = meetPlane([0.1, 0.2, 1], [0, 0, -1], frameOf([0, 0, 0.003, 0, 0, 0]), 0.002);
  [0.1, 0.2, 0.005].forEach((value, d) => close(at[d], value));
  const tilted = meetPlane([0, 0.05, 1], [0, 0, -1], frameOf([0, 0, 0, 0.1, 0, 0]), 0);
  close(tilted[2], 0.05 * Math.tan(0.1));
  assert.equal(meetPlane([0, 0, 1], [0, 0, 1], frameOf([0, 0, 0, 0, 0, 0]), 0), null);
  assert.equal(meetPlane([0, 0, 1], [1, 0, 0], frameOf([0, 0, 0, 0, 0, 0]), 0), null);
});

test("the node nearest to a ray is found, and none behind the eye", () => {
  const nodes = flat(), from = [0.3, 0.02, 0.3], node = 7;
  const way = [0, 1, 2].map((d) => nodes[3 * node + d] - from[d]);
  const found = nearestNode(from, way, nodes);
  assert.equal(found.node, node);
  assert.ok(found.off < 1e-8);
  assert.equal(nearestNode(from, way.map((v) => -v), nodes).node, -1);
});

test("a drag becomes a push along it, as fast as it is long, up to a limit", () => {
  const short = pushOf([0.01, 0.02, 0], [0.02, 0.02, 0]);
  assert.deepEqual(short.at, [0.01, 0.02]);
  close(short.velocity[0], PER_DRAG * 0.01);
  close(short.velocity[1], 0);
  close(Math.hypot(...pushOf([0, 0, 0], [3, -4, 0]).velocity), FASTEST);
});

test("ways are as the picture shows them", () => {
  // From the bar's free end, at +x, y is to the right.
  wayOf("right", 0).forEach((v, d) => close(v, [0, 1, 0][d]));
  wayOf("away", 0).forEach((v, d) => close(v, [-1, 0, 0][d]));
  assert.deepEqual(wayOf("up", 1), [0, 0, 1]);
  assert.equal(wayOf("sideways", 0), null);
});

test("only whole, finite frames of this sheet are taken", () => {
  const shown = new Shown(scenario, lattice), nodes = flat();
  assert.ok(shown.take({ ...still, nodes }));
  for (const [k, value] of [[0, NaN], [5, Infinity], [2, 1e30]]) {
    const spoilt = nodes.slice();
    spoilt[k] = value;
    assert.equal(shown.take({ ...still, nodes: spoilt }), false);
  }
  assert.equal(shown.take({ ...still, nodes: nodes.slice(3) }), false);
  assert.equal(shown.take({ nodes, pose: [0, 0, NaN, 0, 0, 0], time: 0 }), false);
  assert.equal(shown.take({ nodes, pose: [0, 0], time: 0 }), false);
  assert.equal(shown.take({ nodes, pose: still.pose, time: NaN }), false);
  assert.ok([...shown.nodes, ...shown.surface.points].every(Number.isFinite));
  const forces = nodes.map(() => NaN);
  assert.ok(shown.take({ ...still, nodes, forces }));
  assert.equal(shown.hasForces, false);
});

test("legs are the halves on either side of the bar's direction, and touch as their nodes do", () => {
  const shown = new Shown(scenario, lattice), forces = new Float32Array(3 * lattice.nNodes), nodes = flat(0.004);
  shown.take({ ...still, nodes, forces });
  assert.deepEqual(shown.touching, { left: false, right: false });
  const left = Array.from({ length: lattice.nNodes }, (_, k) => k).find((k) => nodes[3 * k + 1] > 0);
  forces[3 * left] = 0.01;
  shown.take({ ...still, nodes, forces });
  assert.deepEqual(shown.touching, { left: true, right: false });
  shown.take({ ...still, nodes: flat(-1e-5) }); // without forces, by height
  assert.deepEqual(shown.touching, { left: true, right: true });
});

test("a sheet lies where its scenario laid it, as the plate has it", () => {
  const shown = new Shown(scenario, lattice), nodes = flat(), pose = [0.01, 0.02, 0.003, 0.1, -0.05, 0.2];
  const frame = frameOf(pose, scenario.motion.height), cos = Math.cos(0.4), sin = Math.sin(0.4);
  for (let k = 0; k < nodes.length; k += 3) {
    const x = nodes[k], y = nodes[k + 1];
    nodes.set(intoWorld(frame, 0.02 + cos * x - sin * y, -0.01 + sin * x + cos * y, 0, [0, 0, 0]), k);
  }
  assert.ok(shown.take({ pose, time: 0, nodes }));
  close(shown.surface.centre[0], 0.02, 1e-7);
  close(shown.surface.centre[1], -0.01, 1e-7);
  close(shown.surface.angle, 0.4, 1e-6);
});

test("the way so far goes back with the time, keeps to its length, and leaves out what is no way", () => {
  const way = new Way(40);
  assert.ok(way.add(0, 0, 0));
  assert.equal(way.add(1e-5, 0, 0.1), false);
  for (let k = 1; k <= 200; k++) way.add(0.001 * k, 0, k);
  assert.ok(way.count <= 41 && way.times[way.count - 1] === 200);
  close(way.places[2 * way.count - 2], 0.2);
  assert.ok(way.backTo(180.5));
  assert.equal(way.times[way.count - 1], 180);
  assert.equal(way.backTo(190), false);
});

test("a lifted sheet's shadow is fainter and further off than that of one that lies", () => {
  const shown = new Shown(scenario, lattice), shadow = new Shadow(shown.surface);
  const darkness = () => {
    let sum = 0, x = 0;
    shadow.dark.forEach((dark, k) => {
      sum += dark;
      x += dark * (shadow.corner[0] + ((k % CELLS) + 0.5) * shadow.grain);
    });
    return { sum, x: x / sum, most: Math.max(...shadow.dark) };
  };
  shown.take({ ...still, nodes: flat() });
  shadow.cast(shown.frame, [0.5, 0, 1]);
  const lying = darkness();
  shown.take({ ...still, nodes: flat(0.01) });
  shadow.cast(shown.frame, [0.5, 0, 1]);
  const lifted = darkness();
  assert.ok(lying.most > 120 && lifted.most < lying.most && lifted.sum < lying.sum);
  close(lying.x, 0, 5e-4);
  close(lifted.x, -0.005, 5e-4); // the light leans along +x, half as far as it goes up
  shown.take({ ...still, nodes: flat(-0.05) });
  shadow.cast(shown.frame, [0.5, 0, 1]);
  assert.equal(darkness().sum, 0); // fallen below the plate
});

test("forces are drawn as large as they are, up to the room there is", () => {
  close((discRadius(4, 1) / discRadius(1, 1)) ** 2, 4);
  close(arrowLength(0.6, 0.8, 1), 2 * arrowLength(0.3, 0.4, 1));
  assert.ok(discRadius(1e6, 1) <= 0.5 && arrowLength(1e6, 0, 1) <= 2.5);
  assert.equal(arrowLength(1e-4, 0, 1), 0);
});

test("scales end in round numbers and say what they mean", () => {
  for (const [value, up] of [[0.7, 0.7], [0.71, 1], [11, 15], [3.2e-3, 5e-3], [96, 100]])
    close(roundedUp(value), up, 1e-9 * up);
  assert.deepEqual(scaleInWords("height", 0.002), ["0", "2 mm high"]);
  assert.deepEqual(scaleInWords("curvature", 7), ["\u22127", "curvature 7 /m"]);
  const marks = marksAlong(0.05, 0.01);
  assert.deepEqual(marks.filter(({ text }) => text).map(({ text }) => text), ["\u221240", "\u221220", "0", "20", "40"]);
  close(marks[0].at, -0.05);
});

test("each view has all of the plate in the picture, wide or narrow, and zooming keeps within limits", () => {
  const corners = [[-0.1, -0.06], [0.1, -0.06], [0.1, 0.06], [-0.1, 0.06]];
  for (const aspect of [0.5, 1, 2.5])
    for (const name of Object.keys(VIEWS)) {
      const view = new ViewCamera();
      view.setAspect(aspect);
      view.frame(corners);
      assert.ok(view.look(name));
      assert.equal(view.riding, name === "plate");
      for (const [x, y] of corners) {
        const seen = view.target.clone().set(x, y, 0).project(view.camera);
        assert.ok(Math.max(Math.abs(seen.x), Math.abs(seen.y), seen.z) <= 1, `${name} at ${aspect}: ${seen.toArray()}`);
      }
      for (let k = 0; k < 200; k++) view.zoomBy(1.5);
      for (let k = 0; k < 200; k++) view.orbit(1, 1);
      assert.ok(view.camera.position.toArray().every(Number.isFinite) && view.distance < 10);
    }
  assert.equal(new ViewCamera().look("nowhere"), false);
});

test("a sheet that wanders stays in the picture, until somebody moves it by hand", () => {
  const view = new ViewCamera();
  view.frame([[0.06, 0.06], [-0.06, -0.06]]);
  assert.equal(view.follow(0.01, 0), false);
  assert.ok(view.follow(0.3, 0));
  assert.ok(view.target.x > 0.2);
  view.pan(0.1, 0);
  assert.equal(view.follow(3, 0), false);
});

test("pictures become coarser where they are late one after the other, and finer again where they are not", () => {
  const pace = new Pace();
  const fine = pace.moving(540e3, 2);
  let now = 0;
  const draw = (took, finished, times) => {
    for (let k = 0; k < times; k++) pace.next((now += took), finished);
    return pace.moving(540e3, 2);
  };
  assert.equal(draw(16, false, 200), fine); // the screen asks more often than a picture takes
  assert.equal(draw(40, true, 200), fine); // slow for other reasons
  assert.equal(draw(2000, false, 50), fine); // paused
  for (let k = 0; k < 100; k++) draw(40, k % 2 === 0, 1); // now and then
  assert.equal(pace.moving(540e3, 2), fine);
  assert.ok(draw(40, false, 10) < fine);
  assert.equal(draw(40, false, 1000), draw(40, false, 1000));
  assert.ok(pace.moving(540e3, 2) > 0.6 && pace.moving(100e3, 2) > 1.4); // a small picture is drawn finer
  assert.ok(pace.moving(10e3, 2) <= 2 && pace.still(540e3, 1) === 2);
  assert.equal(draw(16, true, 2000), fine); // whatever else was going on is over
});
