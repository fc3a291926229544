// What the nodes get from the plate: a disc where one touches, its area the normal force; an arrow for the friction.
import { Group, Mesh, ShaderMaterial, Vector3 } from "three";
import { Copies, QUAD } from "./copies.js";
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
  uniform float uPitch, uGrown;
  attribute vec2 way;
  void main() {
    float length_ = length(way);
    vec2 along = length_ > 0.0 ? way / length_ : vec2(1.0, 0.0);
    float head = min(0.3 * uPitch, 0.6 * length_), neck = length_ - head;
    float s = position.x < -0.5 ? 0.0 : position.x < 0.5 ? neck : length_;
    float out_ = uGrown * 0.035 * uPitch;
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
    const disc = [[-1, -1], [1, -1], [1, 1], [-1, 1]];
    const arrow = [[-1, -1], [0, -1], [0, 1], [-1, 1], [0, -2], [1, 0], [0, 2]];
    this.touches = new Copies(disc, QUAD, nNodes, { node: 3, radius: 1 });
    this.drags = new Copies(arrow, [...QUAD, 4, 5, 6], nNodes, { node: 3, way: 2 });
    const vectors = { uEx: { value: new Vector3() }, uEy: { value: new Vector3() }, uUp: { value: new Vector3() } };
    this.uniforms = { ...shared, ...vectors, uLift: { value: sheet.thickness }, uPitch: { value: sheet.pitch } };
    this.discColours = { uColour: { value: new Vector3() }, uHalo: { value: new Vector3() } };
    this.arrowColour = { value: new Vector3() };
    this.haloColour = { value: new Vector3() };
    const inDiscs = { ...this.uniforms, ...this.discColours };
    const inArrows = { ...this.uniforms, uColour: this.arrowColour, uGrown: { value: 0 } };
    const inHalos = { ...this.uniforms, uColour: this.haloColour, uGrown: { value: 1 } };
    this.group = new Group();
    this.group.add(
      overAll(this.touches, inDiscs, DISC, DISC_FRAGMENT, 6), overAll(this.drags, inHalos, ARROW, ARROW_FRAGMENT, 7),
      overAll(this.drags, inArrows, ARROW, ARROW_FRAGMENT, 8),
    );
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
    const disc = this.touches.values, arrow = this.drags.values;
    let discs = 0, arrows = 0;
    for (let k = 0; k < this.nNodes; k++) {
      const normal = forces ? forces[3 * k] : onPlate[3 * k + 2] <= 0 ? this.share : 0;
      if (!(normal > 0)) continue;
      if (layers.contact) {
        copyNode(nodes, k, disc.node, discs);
        disc.radius[discs++] = this.pitch * discRadius(layers.forces ? normal : this.share, this.share);
      }
      if (!layers.forces || !forces) continue;
      const fx = forces[3 * k + 1], fy = forces[3 * k + 2], long = this.pitch * arrowLength(fx, fy, this.share);
      if (long === 0) continue;
      copyNode(nodes, k, arrow.node, arrows);
      arrow.way[2 * arrows] = (long * fx) / Math.hypot(fx, fy);
      arrow.way[2 * arrows++ + 1] = (long * fy) / Math.hypot(fx, fy);
    }
    this.touches.upload(discs);
    this.drags.upload(arrows);
  }

  dispose() {
    this.touches.dispose();
    this.drags.dispose();
    for (const mesh of this.group.children) mesh.material.dispose();
  }
}

const copyNode = (nodes, from, into, to) => {
  for (let d = 0; d < 3; d++) into[3 * to + d] = nodes[3 * from + d];
};

const overAll = ({ geometry }, uniforms, vertexShader, fragmentShader, order) => {
  const material = new ShaderMaterial({
    vertexShader, fragmentShader, uniforms, transparent: true, depthTest: false, depthWrite: false,
  });
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  mesh.renderOrder = order;
  return mesh;
};
