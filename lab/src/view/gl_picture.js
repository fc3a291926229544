// The picture in three dimensions, by WebGL.
import { Group, Matrix4, Scene, Vector3, WebGLRenderer } from "three";
import { Cloud, Contour } from "./goal.js";
import { sharedUniforms } from "./light.js";
import { Marks } from "./marks.js";
import { Notes } from "./notes.js";
import { Pace } from "./pace.js";
import { PlateMesh } from "./plate.js";
import { Print } from "./print.js";
import { PushArrow } from "./push.js";
import { Shadow } from "./shadow.js";
import { SheetMesh } from "./sheet_mesh.js";
import { Trail } from "./trail.js";

const MOST_PIXELS_PER_PX = 2;

/** What a canvas gives for drawing, or null where it cannot: edges are smoothed where a graphics card does it. */
export const contextOf = (canvas) =>
  canvas.getContext("webgl2", { alpha: false, antialias: !drawnByProcessor(), stencil: false });

export class GlPicture {
  /**
   * @param {HTMLCanvasElement} canvas
   * @param {WebGL2RenderingContext} gl
   * @param {import("./camera.js").ViewCamera} view
   */
  constructor(canvas, gl, view) {
    this.view = view;
    this.renderer = new WebGLRenderer({ canvas, context: gl, alpha: false, stencil: false });
    this.renderer.sortObjects = true;
    this.gl = gl;
    /** Where the processor draws; a graphics card is fast enough. */
    this.pace = drawnByProcessor() ? new Pace() : null;
    this.fence = null;
    this.scene = new Scene();
    this.shared = sharedUniforms();
    this.world = new Group();
    this.world.matrixAutoUpdate = false;
    this.onPlate = new Group();
    this.onPlate.matrixAutoUpdate = false;
    this.world.add(this.onPlate);
    this.notes = new Notes(this.shared);
    this.scene.add(this.world, this.notes.mesh);
    this.pose = new Matrix4();
    this.back = new Matrix4();
    this.light = new Vector3();
    this.parts = [];
    /** Of the sheet before: let go of when the next is drawn, so that its programs can go on being used. */
    this.past = [];
    this.ratio = 1;
  }

  /** Build what is drawn of a sheet. @param {import("./shown.js").Shown} shown */
  build(shown) {
    this.past.push(...this.parts);
    this.world.clear();
    this.onPlate.clear();
    this.shown = shown;
    const { scenario, surface } = shown, { shared } = this;
    this.shadow = new Shadow(surface);
    this.plate = new PlateMesh(scenario, surface.size, this.shadow, shared);
    this.sheet = new SheetMesh(surface, shared);
    this.marks = new Marks(scenario, shown.nNodes, shared);
    this.trail = new Trail(shown, shared);
    this.goal = new Contour(surface, shared, { width: 4.5, dash: Math.max(...surface.size) / 14 });
    this.ghost = new Contour(surface, shared, { width: 4 });
    this.cloud = new Cloud(scenario, shown.lattice, shared);
    this.arrow = new PushArrow(surface.size, shared);
    this.print = new Print(this.plate.shown, this.plate.pitch);
    this.parts = [this.plate, this.sheet, this.marks, this.trail, this.goal, this.ghost, this.cloud, this.arrow];
    this.parts.push(this.print);
    this.onPlate.add(...this.trail.meshes, this.goal.mesh, this.ghost.mesh, this.arrow.mesh, this.print.group);
    this.world.add(this.onPlate, this.plate.group, this.sheet.group, this.marks.group, this.cloud.group);
    return this.plate.corners;
  }

  recolour(colours) {
    this.colours = colours;
    const [red, green, blue] = colours.panel.map((value) => Math.round(255 * value));
    this.renderer.setClearColor((red << 16) | (green << 8) | blue, 1);
    this.parts.forEach((part) => part.recolour?.(colours));
    this.goal?.colour(colours.failed, colours.paper);
    this.ghost?.colour(colours.accent, colours.paper);
  }

  /** @param {number} width CSS px @param {number} height @param {number} pixels of the screen over CSS px */
  resize(width, height, pixels) {
    this.size = [width, height];
    this.pixels = Math.min(pixels, MOST_PIXELS_PER_PX);
    this.setRatio(this.moving);
  }

  /** Pixels over CSS px while the picture moves. */
  get moving() {
    return this.pace ? this.pace.moving(this.size[0] * this.size[1], this.pixels) : this.pixels;
  }

  setRatio(ratio) {
    const { renderer, shared } = this;
    this.ratio = ratio;
    renderer.setPixelRatio(ratio);
    renderer.setSize(...this.size, false);
    shared.uViewport.value.set(renderer.domElement.width, renderer.domElement.height);
    shared.uRatio.value = ratio;
  }

  /** Where the processor draws, moving pictures have rough edges: one that stands still for a while is drawn finer. */
  get finer() {
    return this.pace !== null && this.ratio === this.moving;
  }

  /** Pixels over CSS px of the picture that comes next. */
  nextRatio(still) {
    if (this.pace === null) return this.moving;
    if (still) return this.pace.still(this.size[0] * this.size[1], this.pixels);
    const { gl, fence } = this, finished = !fence || gl.getSyncParameter(fence, gl.SYNC_STATUS) === gl.SIGNALED;
    this.pace.next(performance.now(), finished);
    return this.moving;
  }

  /** To be asked of later: whether what was drawn is finished. */
  setFence() {
    const { gl } = this;
    if (this.pace === null) return;
    if (this.fence) gl.deleteSync(this.fence);
    this.fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  }

  /**
   * @param {object} asked what of it is wanted: layers, exaggerated, goal, ghost, cloud, push
   * @param {boolean} [still] whether it will stand for a while
   */
  draw(asked, still = false) {
    const { shown, view, renderer } = this, ratio = this.nextRatio(still);
    if (ratio !== this.ratio) this.setRatio(ratio);
    this.placeWorld(asked.exaggerated);
    this.sheet.group.visible = this.marks.group.visible = shown.there;
    if (shown.there) this.updateSheet(asked);
    else this.shadow.dark.fill(0);
    this.plate.update(this.pose, asked.exaggerated, shown.surface.centre);
    for (const mesh of this.trail.meshes) mesh.visible = asked.layers.trail;
    this.goal.place(asked.goal);
    this.ghost.place(asked.ghost);
    this.cloud.show(asked.cloud);
    if (asked.push) this.arrow.show(asked.push.from, asked.push.to);
    else this.arrow.hide();
    this.notes.say(asked.said, this.colours, this.ratio);
    this.shared.uEye.value.copy(view.camera.position);
    this.shared.uClear.value = clearness(view.elevation);
    renderer.render(this.scene, view.camera);
    while (this.past.length) this.past.pop().dispose();
    this.setFence();
  }

  updateSheet({ layers, exaggerated, said }) {
    const { shown, sheet } = this, { touching, frame } = shown;
    // Towards the light as the plate sees it, with heights as they are drawn.
    const { x: lx, y: ly, z } = this.shared.uLight.value, lz = z / exaggerated;
    this.light.set(
      frame[0] * lx + frame[3] * ly + frame[6] * lz, frame[1] * lx + frame[4] * ly + frame[7] * lz,
      frame[2] * lx + frame[5] * ly + frame[8] * lz,
    );
    this.shadow.cast(frame, this.light.toArray(this.towards ??= [0, 0, 1]));
    sheet.showBent(layers.bending);
    if (layers.bending) said.most = shown.bent(layers.bending, sheet.bent);
    const on = layers.legs && !layers.bending;
    this.print.names.visible = on;
    this.print.showLegs(touching);
    sheet.showLegs(on, touching);
    sheet.update(frame, this.leastSlope(exaggerated));
    this.marks.group.visible = layers.contact || layers.forces;
    if (this.marks.group.visible)
      this.marks.update(shown.nodes, shown.onPlate, shown.hasForces ? shown.forces : null, frame, layers);
    this.trail.update();
  }

  /** From above, cosine of the slopes whose lower faces come to be seen: the lower the eye, the flatter they may be. */
  leastSlope(exaggerated) {
    const seen = this.view.elevation - 0.3;
    return seen > 0 && exaggerated === 1 ? Math.cos(seen) : 2;
  }

  /** The plate's pose, and how the world is drawn: heights exaggerated, or the plate at rest and the world moving. */
  placeWorld(exaggerated) {
    const f = this.shown.frame;
    this.pose.set(f[0], f[1], f[2], f[9], f[3], f[4], f[5], f[10], f[6], f[7], f[8], f[11], 0, 0, 0, 1);
    this.onPlate.matrix.copy(this.pose);
    const { matrix } = this.world;
    matrix.makeScale(1, 1, exaggerated);
    if (this.view.riding) matrix.multiply(this.back.copy(this.pose).invert());
    this.world.updateMatrixWorld(true);
    this.shared.uTurn.value.getNormalMatrix(matrix);
  }

  /** The ray that a place of the picture, CSS px, shows: in the data's world. */
  rayAt(x, y) {
    const { camera } = this.view, [width, height] = this.size;
    this.back.copy(this.world.matrix).invert();
    const far = new Vector3((2 * x) / width - 1, 1 - (2 * y) / height, 0.5).unproject(camera).applyMatrix4(this.back);
    const from = camera.position.clone().applyMatrix4(this.back);
    return { from: from.toArray(), way: far.sub(from).normalize().toArray() };
  }

  dispose() {
    for (const part of [...this.parts, ...this.past]) part.dispose();
    this.notes.dispose();
    this.renderer.dispose();
    this.gl.getExtension("WEBGL_lose_context")?.loseContext(); // a browser has few, and keeps them for long
  }
}

/** What lies flat can be read from above and not along the plate: it fades, and has gone before it is in the way. */
const clearness = (elevation) => Math.min(1, Math.max(0, (Math.abs(Math.sin(elevation)) - 0.1) / 0.12));

/** Whether the processor draws, and no graphics card: then every pixel counts. */
const drawnByProcessor = () => {
  if (byProcessor === null) {
    const gl = new OffscreenCanvas(1, 1).getContext("webgl2");
    const firefox = navigator.userAgent.includes("Firefox"); // which warns of asking for more
    const name = firefox ? gl?.RENDERER : gl?.getExtension("WEBGL_debug_renderer_info")?.UNMASKED_RENDERER_WEBGL;
    byProcessor = /swiftshader|llvmpipe|software|basic render/i.test(name ? String(gl.getParameter(name)) : "");
  }
  return byProcessor;
};
let byProcessor = null;
