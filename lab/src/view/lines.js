// Lines of one width on the screen, whole or dashed, on the plate and over what lies on it: a quad for each piece.
import { Mesh, ShaderMaterial, Vector3 } from "three";
import { Copies, QUAD } from "./copies.js";

const VERTEX = /* glsl */ `
  uniform vec2 uViewport;
  uniform float uWidth, uRatio;
  attribute vec3 start, end;
  attribute vec2 along;
  varying float vAlong;
  varying float vAcross;
  void main() {
    vec4 a = projectionMatrix * (modelViewMatrix * vec4(start, 1.0));
    vec4 b = projectionMatrix * (modelViewMatrix * vec4(end, 1.0));
    vec2 way = (b.xy / b.w - a.xy / a.w) * uViewport;
    float far = length(way);
    way = far > 1e-6 ? way / far : vec2(1.0, 0.0);
    vec4 at = position.x > 0.5 ? b : a;
    // A pixel more all around, over which the edge softens; and the ends overlap, so that corners are closed.
    float wide = uWidth * uRatio, half_ = 0.5 * wide + 0.75;
    vec2 shift = vec2(-way.y, way.x) * position.y * half_ + way * (2.0 * position.x - 1.0) * 0.4 * wide;
    at.xy += shift / uViewport * 2.0 * at.w;
    vAlong = mix(along.x, along.y, position.x);
    vAcross = position.y * half_;
    gl_Position = at;
  }
`;

const FRAGMENT = /* glsl */ `
  uniform vec3 uColour, uHalo;
  uniform float uWidth, uRatio, uDash, uClear;
  varying float vAlong, vAcross;
  void main() {
    float inwards = 0.5 * uWidth * uRatio + 0.5 - abs(vAcross), alpha = clamp(inwards, 0.0, 1.0);
    float core = clamp(inwards - uRatio, 0.0, 1.0);
    if (uDash > 0.0) {
      float px = fwidth(vAlong) / uDash + 1e-6;
      alpha *= clamp((0.28 - abs(fract(vAlong / uDash) - 0.5)) / px + 0.5, 0.0, 1.0);
    }
    gl_FragColor = vec4(mix(uHalo, uColour, core), alpha * uClear * mix(0.7, 1.0, core));
  }
`;

export class Lines {
  /**
   * @param {number} most pieces
   * @param {object} shared uniforms
   * @param {{width?: number, dash?: number}} [look] width, CSS px; dash, m, or 0 for none
   */
  constructor(most, shared, { width = 4, dash = 0 } = {}) {
    this.most = most;
    this.count = 0;
    this.copies = new Copies([[0, -1], [1, -1], [1, 1], [0, 1]], QUAD, most, { start: 3, end: 3, along: 2 });
    Object.assign(this, this.copies.values);
    this.uniforms = {
      ...shared, uColour: { value: new Vector3() }, uHalo: { value: new Vector3() }, uWidth: { value: width },
      uDash: { value: dash },
    };
    const material = new ShaderMaterial({
      vertexShader: VERTEX, fragmentShader: FRAGMENT, uniforms: this.uniforms, transparent: true, depthWrite: false,
      depthTest: false,
    });
    this.mesh = new Mesh(this.copies.geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 5;
  }

  /** Its colour, and that of a thin edge that sets it off against whatever it lies on. */
  colour(colour, edge) {
    this.uniforms.uColour.value.fromArray(colour);
    this.uniforms.uHalo.value.fromArray(edge);
  }

  clear() {
    this.count = 0;
    this.upload();
  }

  /** Add a piece between two places on the plate, m, and how far along the line they are. */
  add(x0, y0, x1, y1, from, to) {
    if (this.count >= this.most) return;
    const k = this.count++;
    this.put(k, x0, y0, x1, y1, from, to);
  }

  put(k, x0, y0, x1, y1, from, to) {
    this.start[3 * k] = x0;
    this.start[3 * k + 1] = y0;
    this.end[3 * k] = x1;
    this.end[3 * k + 1] = y1;
    this.along[2 * k] = from;
    this.along[2 * k + 1] = to;
  }

  /** Add a line through places, x and y one after the other; a closed one ends where it began. */
  path(places, closed) {
    const n = places.length / 2;
    let along = 0;
    for (let k = 0; k < (closed ? n : n - 1); k++) {
      const a = 2 * k, b = 2 * ((k + 1) % n);
      const length = Math.hypot(places[b] - places[a], places[b + 1] - places[a + 1]);
      this.add(places[a], places[a + 1], places[b], places[b + 1], along, along + length);
      along += length;
    }
    this.upload();
  }

  upload() {
    this.copies.upload(this.count);
  }

  dispose() {
    this.copies.dispose();
    this.mesh.material.dispose();
  }
}
