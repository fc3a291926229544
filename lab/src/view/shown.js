// What a picture shows of a sheet at a moment, before anything is drawn: shared by the 3-D picture and the plain one.
import { Curvature } from "./curvature.js";
import { allFinite, FRAME_SIZE, ontoPlate, plateFrame } from "./frame.js";
import { SheetSurface } from "./surface.js";
import { Way } from "./way.js";

/** Scales of colours go up in these steps, so that they seldom change. */
const STEPS = [1, 1.5, 2, 3, 5, 7];
const LEAST_BENT = 0.05; // over what a dome as wide as the sheet and as high as its radius has

export class Shown {
  /** @param {object} scenario @param {object} lattice of its sheet */
  constructor(scenario, lattice) {
    this.scenario = scenario;
    this.lattice = lattice;
    this.surface = new SheetSurface(scenario.sheet, lattice);
    this.curvature = new Curvature(scenario.sheet, lattice);
    this.height = scenario.motion.height;
    this.nNodes = this.surface.nNodes;
    this.nodes = new Float32Array(3 * this.nNodes);
    this.onPlate = new Float32Array(3 * this.nNodes);
    this.forces = new Float32Array(3 * this.nNodes);
    this.hasForces = false;
    this.pose = new Float64Array(6);
    this.frame = new Float64Array(FRAME_SIZE);
    this.time = 0;
    this.way = new Way();
    /** Goes up by one whenever the way changes. */
    this.ways = 0;
    this.touching = { left: false, right: false };
    this.most = { curvature: 0, height: 0 };
    this.there = false;
    plateFrame(this.pose, this.height, this.frame);
  }

  /**
   * Take over a frame; whether it can be drawn: it is of this sheet, and all of it is finite.
   * @param {{nodes: ArrayLike<number>, pose: ArrayLike<number>, forces?: ArrayLike<number>, time?: number}} frame
   */
  take(frame) {
    if (!this.couldTake(frame)) return false;
    const { nodes, pose, forces = null, time = this.time } = frame;
    this.nodes.set(nodes);
    for (let d = 0; d < 6; d++) this.pose[d] = pose[d];
    this.time = time;
    this.hasForces = forces?.length === 3 * this.nNodes && allFinite(forces);
    if (this.hasForces) this.forces.set(forces);
    plateFrame(this.pose, this.height, this.frame);
    ontoPlate(this.frame, this.nodes, this.onPlate);
    this.surface.update(this.nodes, this.onPlate, this.frame);
    this.seeLegs();
    const x = this.surface.centre[0], y = this.surface.centre[1];
    if (this.way.backTo(time) | this.way.add(x, y, time)) this.ways++;
    this.there = true;
    return true;
  }

  couldTake({ nodes, pose, time = 0 }) {
    if (nodes?.length !== 3 * this.nNodes || !(pose?.length >= 6)) return false;
    return allFinite(nodes) && allFinite(pose) && Number.isFinite(time);
  }

  /** Whether the halves on either side of the bar's direction touch, where they are now. */
  seeLegs() {
    const { onPlate, forces, hasForces, touching } = this, middle = this.surface.centre[1];
    touching.left = touching.right = false;
    for (let k = 0; k < this.nNodes; k++) {
      if (hasForces ? !(forces[3 * k] > 0) : onPlate[3 * k + 2] > 0) continue;
      if (onPlate[3 * k + 1] > middle) touching.left = true;
      else touching.right = true;
    }
  }

  /** The same of a node, once `bent` was asked for the kind. */
  bentAt(kind, node) {
    const most = this.most[kind];
    if (kind === "height") return (2 * this.onPlate[3 * node + 2]) / most - 1;
    return this.curvature.values[node] / most;
  }

  /** Forget the way so far. */
  forget() {
    this.way.clear();
    this.ways++;
  }

  /**
   * How bent or high the vertices are, from -1 to 1, into `values`; what 1 stands for, 1/m or m.
   * @param {"curvature" | "height"} kind
   */
  bent(kind, values) {
    const { surface, curvature, frame } = this, { points } = surface;
    if (kind === "curvature") {
      curvature.update(this.nodes, frame);
      surface.spline.spread(curvature.values, values);
      const least = (2 * LEAST_BENT) / Math.min(...surface.size);
      this.most.curvature = roundedUp(Math.max(this.most.curvature, curvature.most, least));
    } else {
      const nx = frame[2], ny = frame[5], nz = frame[8], ox = frame[9], oy = frame[10], oz = frame[11];
      let highest = LEAST_BENT * Math.min(...surface.size);
      for (let k = 0, p = 0; k < values.length; k++, p += 3) {
        values[k] = nx * (points[p] - ox) + ny * (points[p + 1] - oy) + nz * (points[p + 2] - oz);
        highest = Math.max(highest, values[k]);
      }
      this.most.height = roundedUp(Math.max(this.most.height, highest));
    }
    const most = this.most[kind];
    const scale = kind === "height" ? 2 / most : 1 / most, shift = kind === "height" ? -1 : 0;
    for (let k = 0; k < values.length; k++) values[k] = scale * values[k] + shift;
    return most;
  }
}

/** To the next of `STEPS` times a power of ten. */
export const roundedUp = (value) => {
  const ten = 10 ** Math.floor(Math.log10(value) + 1e-9);
  return ten * (STEPS.find((step) => step * ten >= value * (1 - 1e-9)) ?? 10);
};
