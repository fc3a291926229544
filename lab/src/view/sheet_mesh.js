// The sheet as it is drawn: both faces and the rim, with markers that show how it turns, its legs, or how it is bent.
import {
  BufferAttribute, BufferGeometry, DynamicDrawUsage, Group, Mesh, ShaderMaterial, Vector2, Vector3,
} from "three";
import { BENT, HIGH } from "./colours.js";
import { HALFWAY, LIT } from "./light.js";

/** How much of a leg's colour is left while it is lifted. */
const LIFTED = 0.42;

const VERTEX = /* glsl */ `
  ${HALFWAY}
  uniform mat3 uTurn;
  uniform float uThickness;
  uniform vec3 uCentre, uAcross;
  attribute vec2 rest;
  attribute float bent;
  #ifdef RIM
    attribute vec3 outward;
    attribute float lift;
  #else
    uniform float uLift;
  #endif
  varying vec2 vRest;
  varying float vSide, vBent;
  void main() {
    vec3 up = normalize(uTurn * normal);
    vec4 at = modelMatrix * vec4(position, 1.0);
    #ifdef RIM
      at.xyz += up * (uThickness * lift);
      face(normalize(uTurn * outward), at.xyz);
    #else
      at.xyz += up * (uThickness * uLift);
      face(up * (2.0 * uLift - 1.0), at.xyz);
    #endif
    vRest = rest;
    vSide = dot(position - uCentre, uAcross);
    vBent = bent;
    gl_Position = projectionMatrix * viewMatrix * at;
  }
`;

const FRAGMENT = /* glsl */ `
  ${LIT}
  uniform vec3 uSheet, uMarker, uLeft, uRight, uColours[3];
  uniform vec2 uHalf, uTouch, uPlace;
  uniform float uLegs, uBent, uSquare;
  varying vec2 vRest;
  varying float vSide, vBent;
  float box(vec2 p, vec2 size, vec2 px) {
    vec2 edge = clamp(0.5 - (abs(p) - size) / px, 0.0, 1.0);
    return edge.x * edge.y;
  }
  void main() {
    vec2 px = fwidth(vRest) + 1e-9;
    #ifdef RIM
      vec2 check = vec2(0.0);
    #else
      vec2 square = abs(fract(vRest / (2.0 * uSquare)) * 2.0 - 1.0) * 2.0 - 1.0;
      vec2 check = clamp(square * uSquare / (2.0 * px), -1.0, 1.0);
    #endif
    float side = clamp(vSide / (fwidth(vSide) + 1e-9) + 0.5, 0.0, 1.0);
    vec3 leg = mix(uRight, uLeft, side);
    leg = mix(vec3(0.96), leg, mix(uTouch.y, uTouch.x, side)); // a lifted leg is paler
    vec3 colour = mix(uSheet, leg, uLegs);
    float t = clamp(vBent, -1.0, 1.0);
    vec3 scale = t < 0.0 ? mix(uColours[1], uColours[0], -t) : mix(uColours[1], uColours[2], t);
    colour = mix(colour, scale, uBent);
    colour *= 1.0 + 0.045 * check.x * check.y * (1.0 - 0.6 * uBent);
    float marker = box(vRest, uHalf, px) + box(vRest - uPlace, uHalf, px);
    colour = mix(colour, uMarker, min(marker, 1.0) * (1.0 - 0.75 * uBent));
    vec3 normal = normalize(vNormal);
    gl_FragColor = vec4(colour * matt(normal) + 0.1 * shine(normal), 1.0);
  }
`;

export class SheetMesh {
  /**
   * @param {import("./surface.js").SheetSurface} surface
   * @param {object} shared uniforms
   */
  constructor(surface, shared) {
    this.surface = surface;
    this.group = new Group();
    this.own = uniformsOf(surface);
    this.bent = new Float32Array(surface.nVertices);
    this.faces = attributesOf(surface, this.bent);
    const uniforms = { ...shared, ...this.own };
    const { triangles } = surface.cut;
    this.add(faceOf(this.faces, triangles), { ...uniforms, uLift: { value: 1 } });
    this.low = this.add(faceOf(this.faces, turnedOver(triangles)), { ...uniforms, uLift: { value: 0 } });
    this.rim = new Rim(surface);
    this.add(this.rim.geometry, uniforms, { RIM: "" });
  }

  add(geometry, uniforms, defines = {}) {
    const material = new ShaderMaterial({ vertexShader: VERTEX, fragmentShader: FRAGMENT, uniforms, defines });
    const mesh = new Mesh(geometry, material);
    mesh.frustumCulled = false;
    mesh.matrixAutoUpdate = false;
    this.group.add(mesh);
    return mesh;
  }

  recolour(colours) {
    this.own.uSheet.value.fromArray(colours.sheet);
    this.own.uLeft.value.fromArray(colours.left);
    this.own.uRight.value.fromArray(colours.right);
    this.own.uMarker.value.fromArray(colours.dark ? [0.1, 0.16, 0.26] : [0.094, 0.259, 0.455]);
  }

  /** Colour each half as a leg. @param {boolean} on @param {{left: boolean, right: boolean}} touching */
  showLegs(on, { left, right }) {
    this.own.uLegs.value = on ? 0.9 : 0;
    this.own.uTouch.value.set(left ? 1 : LIFTED, right ? 1 : LIFTED);
  }

  /** Colour by how bent or high the sheet is; `values` of the vertices, -1 to 1, are in `bent`. */
  showBent(kind) {
    this.own.uBent.value = kind ? 0.9 : 0;
    (kind === "height" ? HIGH : BENT).forEach((colour, k) => this.own.uColours.value[k].fromArray(colour));
  }

  /**
   * What the surface has is drawn next.
   * @param {Float64Array} frame of the plate @param {number} least cosine of a slope at which the lower face is seen
   */
  update(frame, least) {
    this.low.visible = this.surface.steepest < least;
    const { centre } = this.surface, { uCentre, uAcross } = this.own;
    uAcross.value.set(frame[1], frame[4], frame[7]);
    uCentre.value.set(frame[9], frame[10], frame[11]).addScaledVector(uAcross.value, centre[1]);
    this.faces.position.needsUpdate = true;
    this.faces.normal.needsUpdate = true;
    if (this.own.uBent.value > 0) this.faces.bent.needsUpdate = true;
    this.rim.update(this.bent);
  }

  dispose() {
    for (const mesh of this.group.children) {
      mesh.geometry.dispose();
      mesh.material.dispose();
    }
  }
}

/** Markers form a radial line: half their size, and where the outer one is from the middle, m. */
export const markersOn = ({ cut, centroid, size, nVertices }) => {
  const half = Math.min(...size) / 2;
  let far = 0;
  for (let k = 0; k < nVertices; k++)
    if (Math.abs(cut.y[k] - centroid[1]) < 0.1 * half) far = Math.max(far, cut.x[k] - centroid[0]);
  return { half: [0.17 * half, 0.085 * half], outer: [0.78 * far, 0] };
};

const uniformsOf = (surface) => {
  const { size } = surface, markers = markersOn(surface);
  return {
    uThickness: { value: surface.thickness }, uCentre: { value: new Vector3() }, uAcross: { value: new Vector3() },
    uSheet: { value: new Vector3() }, uMarker: { value: new Vector3() }, uLeft: { value: new Vector3() },
    uRight: { value: new Vector3() }, uColours: { value: [new Vector3(), new Vector3(), new Vector3()] },
    uHalf: { value: new Vector2(...markers.half) }, uTouch: { value: new Vector2() },
    uPlace: { value: new Vector2(...markers.outer) }, uLegs: { value: 0 }, uBent: { value: 0 },
    uSquare: { value: Math.max(...size) / 8 },
  };
};

const dynamic = (array, size) => new BufferAttribute(array, size).setUsage(DynamicDrawUsage);

/** What both faces share. */
const attributesOf = ({ points, normals, cut, centroid, nVertices }, bent) => {
  const rest = new Float32Array(2 * nVertices);
  for (let k = 0; k < nVertices; k++) rest.set([cut.x[k] - centroid[0], cut.y[k] - centroid[1]], 2 * k);
  return {
    position: dynamic(points, 3), normal: dynamic(normals, 3), bent: dynamic(bent, 1),
    rest: new BufferAttribute(rest, 2),
  };
};

const faceOf = (attributes, triangles) => {
  const geometry = new BufferGeometry();
  for (const [name, attribute] of Object.entries(attributes)) geometry.setAttribute(name, attribute);
  return geometry.setIndex(new BufferAttribute(Uint16Array.from(triangles), 1));
};

const turnedOver = (triangles) => triangles.map((_, t) => triangles[t % 3 === 0 ? t : t + 3 - 2 * (t % 3)]);

/** The strip between the faces, along every edge. */
class Rim {
  constructor(surface) {
    this.surface = surface;
    this.loops = surface.cut.loops;
    const n = 2 * this.loops.reduce((sum, loop) => sum + loop.length, 0);
    const arrays = { position: 3, normal: 3, outward: 3, bent: 1, lift: 1, rest: 2 };
    this.geometry = new BufferGeometry();
    for (const [name, size] of Object.entries(arrays)) {
      this[name] = new Float32Array(size * n);
      this.geometry.setAttribute(name, dynamic(this[name], size));
    }
    const index = [];
    let first = 0;
    for (const loop of this.loops) {
      loop.forEach((vertex, k) => {
        const a = first + 2 * k, b = first + 2 * ((k + 1) % loop.length);
        index.push(a, b, b + 1, a, b + 1, a + 1);
        this.lift[a + 1] = 1;
        const rest = [surface.cut.x[vertex] - surface.centroid[0], surface.cut.y[vertex] - surface.centroid[1]];
        this.rest.set([...rest, ...rest], 2 * a);
      });
      first += 2 * loop.length;
    }
    this.geometry.setIndex(index);
  }

  update(bent) {
    const { points: p, normals: n } = this.surface, { position, normal, outward } = this;
    let at = 0;
    for (const loop of this.loops)
      for (let k = 0; k < loop.length; k++, at += 2) {
        const { length } = loop, from = 3 * loop[k];
        const before = 3 * loop[(k + 2 * length - 2) % length], after = 3 * loop[(k + 2) % length];
        const tx = p[after] - p[before], ty = p[after + 1] - p[before + 1], tz = p[after + 2] - p[before + 2];
        const nx = n[from], ny = n[from + 1], nz = n[from + 2];
        const x = ty * nz - tz * ny, y = tz * nx - tx * nz, z = tx * ny - ty * nx;
        for (let to = 3 * at; to < 3 * at + 6; to += 3) {
          for (let d = 0; d < 3; d++) {
            position[to + d] = p[from + d];
            normal[to + d] = n[from + d];
          }
          outward[to] = x;
          outward[to + 1] = y;
          outward[to + 2] = z;
        }
        this.bent[at] = this.bent[at + 1] = bent[loop[k]];
      }
    for (const name of ["position", "normal", "outward", "bent"]) this.geometry.attributes[name].needsUpdate = true;
  }
}
