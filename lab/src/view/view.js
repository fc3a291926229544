// The picture of sheet and plate: what is shown is told to it, and it draws when there is something new.
import { ViewCamera } from "./camera.js";
import { coloursAt } from "./colours.js";
import { FlatPicture } from "./flat_picture.js";
import { ontoPlate } from "./frame.js";
import { Gestures } from "./gestures.js";
import { contextOf, GlPicture } from "./gl_picture.js";
import { FASTEST, meetPlane, nearestNode, PER_DRAG, pushOf, wayOf } from "./pointing.js";
import { Shown } from "./shown.js";

const LAYERS = { contact: true, forces: true, legs: true, trail: true, bending: "" };
const MOST_EXAGGERATED = 10;
/** How far from a node, in pitches, the sheet is still taken hold of. */
const GRASP = 0.8;
/** After so long without a new one a picture stands still, ms. */
const STILL = 250;
/** Frames that follow each other within so long are a film, ms. */
const LIVELY = 60;

/** All that the picture shows of a scenario. */
const drawnOf = ({ sheet: { outline, pitch, thickness, mass }, plate, motion, start, slip_limit, gravity }) =>
  JSON.stringify([outline, pitch, thickness, mass, plate, motion.height, start, slip_limit, gravity]);

/**
 * @typedef {object} Frame
 * @property {Float32Array} nodes x, y, z of each, world, m
 * @property {ArrayLike<number>} pose of the plate
 * @property {Float32Array} [forces] of each node the normal force and the friction along the plate's x and y, N
 * @property {number} [time] s
 */
export class View {
  /** @param {HTMLCanvasElement} canvas of a size that the page gives it */
  constructor(canvas) {
    this.canvas = canvas;
    this.camera = new ViewCamera();
    this.asked = {
      layers: { ...LAYERS }, exaggerated: 1, goal: null, ghost: null, cloud: [], push: null,
      said: { exaggerated: 1, bent: "", most: 0 },
    };
    this.shown = null;
    this.tellPush = null;
    this.held = null;
    this.waiting = 0;
    this.soon = this.settling = 0;
    this.drawn = 0;
    this.lively = -Infinity;
    this.stand = null;
    if (canvas.tabIndex < 0) canvas.tabIndex = 0;
    this.listen();
    const gl = contextOf(canvas);
    this.picture = gl ? new GlPicture(canvas, gl, this.camera) : new FlatPicture(canvas, this.camera);
    this.recolour();
    this.resize();
  }

  listen() {
    const { canvas } = this;
    this.lost = (event) => this.lose(event);
    this.restored = (event) => this.restore(event);
    canvas.addEventListener("webglcontextlost", this.lost);
    canvas.addEventListener("webglcontextrestored", this.restored);
    this.gestures = new Gestures(canvas, this.hands());
    this.themed = () => this.recolour();
    this.scheme = matchMedia("(prefers-color-scheme: dark)");
    this.scheme.addEventListener("change", this.themed);
    this.attributes = new MutationObserver(this.themed);
    this.attributes.observe(document.documentElement, { attributes: true });
    this.sizes = new ResizeObserver(() => this.resize());
    this.sizes.observe(canvas);
  }

  hands() {
    const seen = (act) => (...values) => {
      act(...values);
      this.redraw();
    };
    return {
      orbit: seen((byAzimuth, byElevation) => this.camera.orbit(byAzimuth, byElevation)),
      pan: seen((right, up) => this.camera.pan(right, up)),
      zoom: seen((factor) => this.camera.zoomBy(factor)),
      look: (name) => this.look(name),
      grasp: (x, y) => this.grasp(x, y),
      drag: (x, y) => this.drag(x, y),
      release: (letGo) => this.release(letGo),
      hover: (x, y) => {
        this.canvas.style.cursor = this.tellPush && this.sheetAt(x, y) ? "grab" : "";
      },
    };
  }

  /**
   * Show another sheet or plate; nothing is made anew where nothing of it that is drawn is another.
   * @param {object} scenario @param {object} lattice of its sheet
   */
  setSheet(scenario, lattice) {
    const before = this.corners?.join(), drawn = drawnOf(scenario);
    if (drawn === this.sheet) return;
    this.sheet = drawn;
    this.shown = new Shown(scenario, lattice);
    this.corners = this.picture.build(this.shown);
    this.picture.recolour(this.colours);
    this.stand?.build(this.shown);
    this.held = this.asked.push = null;
    this.asked.cloud = [];
    if (this.corners.join() !== before) this.camera.frame(this.corners);
    this.redraw();
  }

  /**
   * Show a moment, at once.
   * @param {Frame} frame
   * @returns {boolean} whether it could be drawn: it is of this sheet, and every number of it finite
   */
  show(frame) {
    if (!this.shown?.take(frame)) return false;
    this.lively = performance.now();
    this.camera.follow(this.shown.surface.centre[0], this.shown.surface.centre[1]);
    this.frame();
    return true;
  }

  /** Draw what there is, at once. */
  frame() {
    cancelAnimationFrame(this.waiting);
    clearTimeout(this.soon);
    this.waiting = this.soon = 0;
    if (!this.shown || this.gone || !this.canvas.clientWidth || !this.canvas.clientHeight) return;
    (this.stand ?? this.picture).draw(this.asked);
    this.drawn = performance.now();
    if (this.picture.finer) this.settling ||= setTimeout(() => this.settle(), STILL);
  }

  /** Nothing has moved for a while: draw it once more, finer. */
  settle() {
    const left = this.drawn + STILL - performance.now();
    this.settling = left > 5 ? setTimeout(() => this.settle(), left) : 0;
    if (!this.settling && !this.stand && !this.gone) this.picture.draw(this.asked, true);
  }

  /** Draw with the screen's next picture, or with the next frame that is shown where they follow each other. */
  redraw() {
    if (this.waiting || this.soon || this.gone) return;
    if (performance.now() - this.lively < LIVELY) this.soon = setTimeout(() => this.frame(), LIVELY);
    else this.waiting = requestAnimationFrame(() => this.frame());
  }

  /**
   * What is drawn besides the sheet.
   * @param {{forces?: boolean, contact?: boolean, legs?: boolean, trail?: boolean,
   *     bending?: boolean | "curvature" | "height"}} layers
   */
  setLayers(layers) {
    Object.assign(this.asked.layers, layers);
    const { bending } = this.asked.layers;
    this.asked.layers.bending = this.asked.said.bent = bending === true ? "curvature" : bending || "";
    this.redraw();
  }

  /** @param {number} factor 1 to 10, by which heights are drawn higher than they are; the picture says so */
  setExaggeration(factor) {
    const kept = Math.min(MOST_EXAGGERATED, Math.max(1, Number(factor) || 1));
    this.asked.exaggerated = this.asked.said.exaggerated = kept;
    this.redraw();
  }

  /** @param {{x: number, y: number, angle: number} | null} pose on the plate that the sheet should reach, m and rad */
  setGoal(pose) {
    this.asked.goal = pose;
    this.redraw();
  }

  /** @param {{x: number, y: number, angle: number} | null} pose on the plate at which a film saw the sheet */
  setGhost(pose) {
    this.asked.ghost = pose;
    this.redraw();
  }

  /** @param {Frame[]} frames of other sheets with the same nodes, drawn translucent */
  setCloud(frames) {
    this.asked.cloud = (frames ?? []).filter((frame) => this.shown?.couldTake(frame));
    this.redraw();
  }

  /** Forget where the sheet has been. */
  clearTrail() {
    this.shown?.forget();
    this.redraw();
  }

  /** @param {"default" | "above" | "bar" | "plate"} name @returns {boolean} whether there is such a view */
  look(name) {
    const known = this.camera.look(name);
    this.redraw();
    return known;
  }

  /** @param {(push: {at: number[], velocity: number[]}) => void} tell where the sheet is pushed, m, and how, m/s */
  onPush(tell) {
    this.tellPush = tell;
  }

  /**
   * A push without a pointer, for keys and buttons.
   * @param {{direction?: "left" | "right" | "away" | "towards" | "up", speed?: number, velocity?: number[],
   *     at?: number[]}} push a direction as the picture shows it and a speed, m/s, or a velocity; at the sheet's middle
   *     where no place is given
   * @returns {boolean} whether there was anything to push
   */
  pushWith({ direction, speed = 0.15, velocity, at }) {
    if (!this.shown?.there) return false;
    const way = velocity ?? wayOf(direction, this.camera.azimuth)?.map((v) => v * speed);
    const place = at ?? this.middle();
    if (!way || ![...way, ...place].every(Number.isFinite)) return false;
    this.tellPush?.({ at: [place[0], place[1]], velocity: way });
    return true;
  }

  middle() {
    const { nodes, nNodes } = this.shown, sum = [0, 0];
    for (let k = 0; k < nNodes; k++) for (let d = 0; d < 2; d++) sum[d] += nodes[3 * k + d] / nNodes;
    return sum;
  }

  /** The node and the ray at a place of the picture, CSS px, where the sheet is there. */
  sheetAt(x, y) {
    const picture = this.stand ?? this.picture;
    if (!this.shown?.there || !picture.size) return null;
    const ray = picture.rayAt(x, y), { node, off } = nearestNode(ray.from, ray.way, this.shown.nodes);
    return off <= GRASP * this.shown.surface.pitch ? { node, ...ray } : null;
  }

  grasp(x, y) {
    const there = this.tellPush ? this.sheetAt(x, y) : null;
    if (!there) return false;
    const height = Math.max(0, this.shown.onPlate[3 * there.node + 2]);
    const at = meetPlane(there.from, there.way, this.shown.frame, height);
    if (!at) return false;
    this.held = { at, to: at, height };
    this.canvas.style.cursor = "grabbing";
    return true;
  }

  drag(x, y) {
    if (!this.held) return;
    const { from, way } = (this.stand ?? this.picture).rayAt(x, y);
    const to = meetPlane(from, way, this.shown.frame, this.held.height);
    if (!to) return;
    const { at } = this.held, far = Math.hypot(to[0] - at[0], to[1] - at[1], to[2] - at[2]);
    const share = Math.min(1, FASTEST / PER_DRAG / Math.max(far, 1e-9));
    this.held.to = at.map((v, d) => v + share * (to[d] - v));
    const ends = ontoPlate(this.shown.frame, [...at, ...this.held.to], new Float64Array(6));
    this.asked.push = { from: [...ends.subarray(0, 3)], to: [...ends.subarray(3)] };
    this.redraw();
  }

  release(letGo) {
    const { held } = this;
    this.held = this.asked.push = null;
    this.canvas.style.cursor = "";
    this.redraw();
    if (!held || !letGo) return;
    const push = pushOf(held.at, held.to);
    if (Math.hypot(...push.velocity) > 1e-3) this.tellPush?.(push);
  }

  /** The canvas may have another size. */
  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas, pixels = window.devicePixelRatio || 1;
    if (!width || !height) return;
    const key = `${width} ${height} ${pixels}`;
    if (key === this.size) return;
    this.size = key;
    this.picture.resize(width, height, pixels);
    this.stand?.resize(width, height, pixels);
    this.camera.setAspect(width / height);
    this.frame();
  }

  /** The page's colours may be others. */
  recolour() {
    this.colours = coloursAt(this.canvas);
    this.picture.recolour(this.colours);
    this.stand?.recolour(this.colours);
    this.redraw();
  }

  /** The graphics card is gone: until it is back, a plain picture lies over this one. */
  lose(event) {
    event.preventDefault();
    event.stopImmediatePropagation();
    if (this.stand) return;
    const { canvas } = this, over = document.createElement("canvas"), { style } = over;
    style.position = "absolute";
    style.left = `${canvas.offsetLeft}px`;
    style.top = `${canvas.offsetTop}px`;
    style.width = `${canvas.clientWidth}px`;
    style.height = `${canvas.clientHeight}px`;
    style.pointerEvents = "none";
    over.setAttribute("aria-hidden", "true");
    canvas.after(over);
    this.stand = new FlatPicture(over, this.camera);
    this.stand.recolour(this.colours);
    this.stand.resize(canvas.clientWidth, canvas.clientHeight, window.devicePixelRatio || 1);
    if (this.shown) this.stand.build(this.shown);
    this.redraw();
  }

  restore(event) {
    event.stopImmediatePropagation();
    this.picture = new GlPicture(this.canvas, contextOf(this.canvas), this.camera);
    if (this.shown) this.picture.build(this.shown);
    this.picture.recolour(this.colours);
    this.size = "";
    this.stand?.canvas.remove();
    this.stand = null;
    this.resize();
  }

  /** What is seen now as a PNG. @returns {Promise<Blob | null>} */
  snapshot() {
    this.frame();
    if (!this.stand && this.shown) this.picture.draw(this.asked, true);
    const { canvas } = this.stand ?? this;
    return new Promise((resolve) => canvas.toBlob(resolve, "image/png"));
  }

  destroy() {
    this.gone = true;
    cancelAnimationFrame(this.waiting);
    clearTimeout(this.settling);
    clearTimeout(this.soon);
    this.gestures.destroy();
    this.sizes.disconnect();
    this.attributes.disconnect();
    this.scheme.removeEventListener("change", this.themed);
    this.canvas.removeEventListener("webglcontextlost", this.lost);
    this.canvas.removeEventListener("webglcontextrestored", this.restored);
    this.stand?.canvas.remove();
    this.picture.dispose();
  }
}
