// What the nodes get from the plate: a disc where one touches, its area the normal force; an arrow for the friction.
import {
  BufferAttribute, DynamicDrawUsage, Group, InstancedBufferAttribute, InstancedBufferGeometry, Mesh, ShaderMaterial,
  Vector3,
} from "three";
import { arrowLength, discRadius, nodeShare } from "./loads.js";

const AT = /* glsl */ `
  uniform mat3 uTurn;
  uniform vec3 uEx, uEy, uUp;
  uniform float uLift;
  attribute vec3 node;
  vec4 place(vec2 shift) {
    vec4 at = modelMatrix * vec4(node + uEx * shift.x + uEy * shift.y, 1.0);
    at.xyz += normalize(uTurn * uUp) * uLift;
    return projectionMatrix * viewMatrix * at;
  }
`;

const DISC = /* glsl */ `
  ${AT}
  attribute float radius;
  varying vec2 vPlace;
  varying float vRadius;
  void main() {
    vPlace = position.xy * 1.15;
    vRadius = radius;
    gl_Position = place(vPlace * radius);
  }
`;

const DISC_FRAGMENT = /* glsl */ `
  uniform vec3 uColour, uHalo;
  uniform float uClear;
  varying vec2 vPlace;
  varying float vRadius;
  void main() {
    float r = length(vPlace), px = fwidth(r) + 1e-6;
    float alpha = clamp((1.0 - r) / px + 0.5, 0.0, 1.0);
    float inner = clamp((1.0 - r) / px - 0.8, 0.0, 1.0);
    if (alpha <= 0.0) discard;
    gl_FragColor = vec4(mix(uHalo, uColour, inner), alpha * uClear * mix(0.9, 0.78, inner));
  }
`;

/** Along the arrow in shares of its head, from the tail at -1 by the neck at 0 to the tip at 1; across in widths. */
const ARROW = /* glsl */ `
  ${AT}
  uniform float uPitch;
  attribute vec2 way;
  attribute float grown;
  void main() {
    float length_ = length(way);
    vec2 along = length_ > 0.0 ? way / length_ : vec2(1.0, 0.0);
    float head = min(0.3 * uPitch, 0.6 * length_), neck = length_ - head;
    float s = position.x < -0.5 ? 0.0 : position.x < 0.5 ? neck : length_;
    float out_ = grown * 0.035 * uPitch;
    s += position.x < -0.5 ? -out_ : position.x < 0.5 ? -out_ : 2.2 * out_;
    float width = abs(position.y) > 1.5 ? 0.5 * head + 1.6 * out_ : 0.05 * uPitch + out_;
    gl_Position = place(along * s + vec2(-along.y, along.x) * sign(position.y) * width);
  }
`;

const ARROW_FRAGMENT = /* glsl */ `
  uniform vec3 uColour;
  uniform float uClear;
  void main() {
    gl_FragColor = vec4(uColour, uClear);
  }
`;

export class Marks {
  /** @param {object} scenario @param {number} nNodes @param {object} shared uniforms */
  constructor(scenario, nNodes, shared) {
    const { sheet } = scenario;
    this.nNodes = nNodes;
    this.pitch = sheet.pitch;
    this.share = nodeShare(scenario, nNodes);
    this.node = new InstancedBufferAttribute(new Float32Array(3 * nNodes), 3).setUsage(DynamicDrawUsage);
    this.radius = new InstancedBufferAttribute(new Float32Array(nNodes), 1).setUsage(DynamicDrawUsage);
    this.base = new InstancedBufferAttribute(new Float32Array(3 * nNodes), 3).setUsage(DynamicDrawUsage);
    this.way = new InstancedBufferAttribute(new Float32Array(2 * nNodes), 2).setUsage(DynamicDrawUsage);
    const vectors = { uEx: { value: new Vector3() }, uEy: { value: new Vector3() }, uUp: { value: new Vector3() } };
    this.uniforms = { ...shared, ...vectors, uLift: { value: sheet.thickness }, uPitch: { value: sheet.pitch } };
    this.discColours = { uColour: { value: new Vector3() }, uHalo: { value: new Vector3() } };
    this.arrowColour = { value: new Vector3() };
    this.haloColour = { value: new Vector3() };
    this.discs = this.discMesh();
    this.halos = this.arrowMesh(1, this.haloColour, 7);
    this.arrows = this.arrowMesh(0, this.arrowColour, 8);
    this.group = new Group();
    this.group.add(this.discs, this.halos, this.arrows);
  }

  discMesh() {
    const geometry = new InstancedBufferGeometry();
    const corners = Float32Array.from([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]);
    geometry.setAttribute("position", new BufferAttribute(corners, 3));
    geometry.setAttribute("node", this.node).setAttribute("radius", this.radius).setIndex([0, 1, 2, 0, 2, 3]);
    return overAll(geometry, { ...this.uniforms, ...this.discColours }, DISC, DISC_FRAGMENT, 6);
  }

  arrowMesh(grown, uColour, order) {
    const geometry = new InstancedBufferGeometry();
    const corners = [-1, -1, 0, 0, -1, 0, 0, 1, 0, -1, 1, 0, 0, -2, 0, 1, 0, 0, 0, 2, 0];
    geometry.setAttribute("position", new BufferAttribute(Float32Array.from(corners), 3));
    geometry.setAttribute("grown", new BufferAttribute(new Float32Array(7).fill(grown), 1));
    geometry.setAttribute("node", this.base).setAttribute("way", this.way);
    geometry.setIndex([0, 1, 2, 0, 2, 3, 4, 5, 6]);
    return overAll(geometry, { ...this.uniforms, uColour }, ARROW, ARROW_FRAGMENT, order);
  }

  recolour({ ink, paper, accent, dark }) {
    this.discColours.uColour.value.fromArray(dark ? paper : ink);
    this.discColours.uHalo.value.fromArray(dark ? ink : paper);
    this.arrowColour.value.fromArray(dark ? paper : accent);
    this.haloColour.value.fromArray(dark ? ink : paper);
    if (dark) this.arrowColour.value.set(0.03, 0.3, 0.62);
  }

  /**
   * @param {Float32Array} nodes world, m
   * @param {Float32Array} onPlate the same in the plate's frame
   * @param {Float32Array | null} forces of each node normal force and friction along the plate's axes, N
   * @param {Float64Array} frame of the plate
   * @param {{contact: boolean, forces: boolean}} layers
   */
  update(nodes, onPlate, forces, frame, layers) {
    this.uniforms.uEx.value.set(frame[0], frame[3], frame[6]);
    this.uniforms.uEy.value.set(frame[1], frame[4], frame[7]);
    this.uniforms.uUp.value.set(frame[2], frame[5], frame[8]);
    let discs = 0, arrows = 0;
    for (let k = 0; k < this.nNodes; k++) {
      const normal = forces ? forces[3 * k] : onPlate[3 * k + 2] <= 0 ? this.share : 0;
      if (!(normal > 0)) continue;
      if (layers.contact) {
        copyNode(nodes, k, this.node.array, discs);
        this.radius.array[discs++] = this.pitch * discRadius(layers.forces ? normal : this.share, this.share);
      }
      if (!layers.forces || !forces) continue;
      const fx = forces[3 * k + 1], fy = forces[3 * k + 2], long = this.pitch * arrowLength(fx, fy, this.share);
      if (long === 0) continue;
      copyNode(nodes, k, this.base.array, arrows);
      this.way.array[2 * arrows] = (long * fx) / Math.hypot(fx, fy);
      this.way.array[2 * arrows++ + 1] = (long * fy) / Math.hypot(fx, fy);
    }
    this.discs.geometry.instanceCount = discs;
    this.arrows.geometry.instanceCount = this.halos.geometry.instanceCount = arrows;
    for (const attribute of [this.node, this.radius, this.base, this.way]) attribute.needsUpdate = true;
  }

  dispose() {
    for (const mesh of this.group.children) {
      mesh.geometry.dispose();
      mesh.material.dispose();
    }
  }
}

const copyNode = (nodes, from, into, to) => {
  for (let d = 0; d < 3; d++) into[3 * to + d] = nodes[3 * from + d];
};

const overAll = (geometry, uniforms, vertexShader, fragmentShader, order) => {
  geometry.instanceCount = 0;
  const material = new ShaderMaterial({
    vertexShader, fragmentShader, uniforms, transparent: true, depthTest: false, depthWrite: false,
  });
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  mesh.renderOrder = order;
  return mesh;
};
