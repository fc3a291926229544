// What the sheet is compared with: where it should go, where a film saw it, and what else it may be.
import {
  BufferAttribute, BufferGeometry, DoubleSide, DynamicDrawUsage, Group, Mesh, ShaderMaterial, Vector2, Vector3,
} from "three";
import { plateFrame, ontoPlate, FRAME_SIZE } from "./frame.js";
import { HALFWAY, LIT } from "./light.js";
import { Lines } from "./lines.js";
import { markersOn } from "./sheet_mesh.js";
import { SheetSurface } from "./surface.js";

/** The sheet's outline lying flat on the plate, with a line from its middle to where its x points. */
export class Contour {
  constructor(surface, shared, look) {
    const { cut, centroid } = surface;
    let far = 0;
    for (const x of cut.x) far = Math.max(far, x - centroid[0]);
    this.pieces = cut.loops.reduce((sum, loop) => sum + loop.length, 0) + 1;
    this.lines = new Lines(this.pieces, shared, look);
    for (const loop of cut.loops)
      this.lines.path(loop.flatMap((k) => [cut.x[k] - centroid[0], cut.y[k] - centroid[1]]), true);
    this.lines.path([0, 0, far, 0], false);
    this.mesh = this.lines.mesh;
    this.mesh.visible = false;
  }

  /** @param {{x: number, y: number, angle: number} | null} pose on the plate, m and rad; whether it can be drawn */
  place(pose) {
    const there = pose !== null && [pose.x, pose.y, pose.angle].every(Number.isFinite);
    this.mesh.visible = there;
    if (!there) return pose === null;
    this.mesh.position.set(pose.x, pose.y, 0);
    this.mesh.rotation.z = pose.angle;
    return true;
  }

  colour(colour, edge) {
    this.lines.colour(colour, edge);
  }

  dispose() {
    this.lines.dispose();
  }
}

const VERTEX = /* glsl */ `
  ${HALFWAY}
  uniform mat3 uTurn;
  attribute vec2 rest;
  attribute float inner;
  varying vec2 vRest;
  varying float vInner;
  void main() {
    vec4 at = modelMatrix * vec4(position, 1.0);
    vec3 up = normalize(uTurn * normal);
    face(up, at.xyz);
    vRest = rest;
    vInner = inner;
    gl_Position = projectionMatrix * viewMatrix * at;
  }
`;

const FRAGMENT = /* glsl */ `
  ${LIT}
  uniform vec3 uColour;
  uniform vec2 uHalf, uPlace;
  varying vec2 vRest;
  varying float vInner;
  void main() {
    vec3 normal = normalize(gl_FrontFacing ? vNormal : -vNormal);
    float edge = clamp(1.5 - vInner / (fwidth(vInner) + 1e-9), 0.0, 1.0);
    vec2 off = clamp(0.5 - (abs(vRest - uPlace) - uHalf) / (fwidth(vRest) + 1e-9), 0.0, 1.0);
    gl_FragColor = vec4(uColour * matt(normal), max(0.012, max(0.5 * edge, 0.35 * off.x * off.y)));
  }
`;

/** Of a cloud no more are drawn; and how finely. */
const MOST = 24, CELLS = 480;

/** Translucent sheets: what else the object may be, as far as is known. */
export class Cloud {
  constructor({ sheet, motion }, lattice, shared) {
    Object.assign(this, { sheet, lattice, height: motion.height });
    this.group = new Group();
    this.uniforms = {
      ...shared, uColour: { value: new Vector3() }, uHalf: { value: new Vector2() }, uPlace: { value: new Vector2() },
    };
    this.material = new ShaderMaterial({
      vertexShader: VERTEX, fragmentShader: FRAGMENT, uniforms: this.uniforms, transparent: true, depthWrite: false,
      depthTest: false, side: DoubleSide,
    });
    this.surface = null;
    this.frame = new Float64Array(FRAME_SIZE);
  }

  recolour({ accent }) {
    this.uniforms.uColour.value.fromArray(accent);
  }

  /** @param {{nodes: Float32Array, pose: ArrayLike<number>}[]} frames each of as many nodes as this sheet has */
  show(frames) {
    if (frames === this.frames) return;
    this.frames = frames;
    if (frames.length && !this.surface) this.prepare();
    const drawn = frames.filter(({ nodes }) => nodes.length === 3 * this.surface.nNodes).slice(0, MOST);
    while (this.group.children.length < drawn.length) this.group.add(this.another());
    this.group.children.forEach((mesh, k) => {
      mesh.visible = k < drawn.length;
      if (mesh.visible) this.put(drawn[k], mesh.geometry.attributes);
    });
  }

  prepare() {
    this.surface = new SheetSurface(this.sheet, this.lattice, CELLS);
    const { cut, centroid, nVertices } = this.surface, markers = markersOn(this.surface);
    this.uniforms.uHalf.value.set(...markers.half);
    this.uniforms.uPlace.value.set(...markers.outer);
    this.rest = new BufferAttribute(new Float32Array(2 * nVertices), 2);
    for (let k = 0; k < nVertices; k++) this.rest.setXY(k, cut.x[k] - centroid[0], cut.y[k] - centroid[1]);
    this.inner = new BufferAttribute(Float32Array.from(cut.inner, (from, k) => (from === k ? 1 : 0)), 1);
  }

  put({ nodes, pose }, { position, normal }) {
    const { surface } = this;
    plateFrame(pose, this.height, this.frame);
    this.onPlate ??= new Float32Array(nodes.length);
    surface.update(nodes, ontoPlate(this.frame, nodes, this.onPlate), this.frame);
    position.array.set(surface.points);
    normal.array.set(surface.normals);
    position.needsUpdate = normal.needsUpdate = true;
  }

  another() {
    const geometry = new BufferGeometry(), n = 3 * this.surface.nVertices;
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(n), 3).setUsage(DynamicDrawUsage));
    geometry.setAttribute("normal", new BufferAttribute(new Float32Array(n), 3).setUsage(DynamicDrawUsage));
    geometry.setAttribute("rest", this.rest).setAttribute("inner", this.inner);
    geometry.setIndex(new BufferAttribute(Uint16Array.from(this.surface.cut.triangles), 1));
    const mesh = new Mesh(geometry, this.material);
    mesh.frustumCulled = false;
    mesh.renderOrder = 3;
    return mesh;
  }

  dispose() {
    for (const mesh of this.group.children) mesh.geometry.dispose();
    this.material.dispose();
  }
}
