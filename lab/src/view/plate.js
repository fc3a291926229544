// The plate on its bar: of its size, or one that goes on further than is drawn; grid, axis, and the sheet's shadow.
import {
  BufferAttribute, BufferGeometry, DataTexture, Group, LinearFilter, Mesh, RedFormat, ShaderMaterial,
  UnsignedByteType, Vector2, Vector3,
} from "three";
import { mix } from "./colours.js";
import { HALFWAY, LIT, MATT } from "./light.js";
import { CELLS } from "./shadow.js";

/** Thickness of the plate and radius of the bar over the plate's width. */
const SLAB = 0.035, BAR = 0.03;
/**
 * How far a plate without end is drawn, over the sheet's size; how much of that is measured, and how far a sheet may
 * wander before what is drawn goes along; where the bar ends, over the plate's half length.
 */
const WITHOUT_END = 1.1, SHOWN = 0.6, WANDERED = 0.3, BAR_ENDS = 3.4;

const VERTEX = /* glsl */ `
  ${HALFWAY}
  varying vec2 vPlace;
  void main() {
    vec4 at = modelMatrix * vec4(position, 1.0);
    face(normalize(transpose(inverse(mat3(modelMatrix))) * normal), at.xyz);
    vPlace = position.xy;
    gl_Position = projectionMatrix * viewMatrix * at;
  }
`;

/** The surface is flat: all of it is lit alike. */
const SURFACE_VERTEX = /* glsl */ `
  uniform vec3 uLight;
  uniform vec2 uShift;
  varying vec2 vPlace;
  varying float vMatt;
  void main() {
    vec3 up = normalize(transpose(inverse(mat3(modelMatrix))) * normal);
    vMatt = ${MATT("up")};
    vPlace = position.xy + uShift;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(vPlace, 0.0, 1.0);
  }
`;

const SURFACE = /* glsl */ `
  uniform vec3 uColour, uGrid, uAxis, uDark;
  uniform vec2 uHalf, uCorner, uShift;
  uniform float uPitch, uWindow, uFade;
  uniform sampler2D uShadow;
  varying vec2 vPlace;
  varying float vMatt;
  void main() {
    vec2 px = fwidth(vPlace) + 1e-9;
    vec2 off = abs(fract(vPlace / uPitch + 0.5) - 0.5) * uPitch / px;
    float line = clamp(1.2 - min(off.x, off.y), 0.0, 1.0) * clamp(uPitch / (6.0 * max(px.x, px.y)), 0.0, 1.0);
    vec3 colour = uColour * vMatt;
    colour = mix(colour, uGrid, line);
    colour = mix(colour, uAxis, clamp(1.4 - abs(vPlace.y) / px.y, 0.0, 1.0));
    vec2 window = (vPlace - uCorner) / uWindow - 0.5;
    if (max(abs(window.x), abs(window.y)) < 0.5) colour = mix(colour, uDark, texture2D(uShadow, window + 0.5).r);
    vec2 share = abs(vPlace - uShift) / uHalf, cubes = share * share * share;
    gl_FragColor = vec4(colour, 1.0 - uFade * smoothstep(0.24, 1.0, cubes.x + cubes.y));
  }
`;

const SOLID = /* glsl */ `
  ${LIT}
  uniform vec3 uColour;
  uniform float uFade;
  varying vec2 vPlace;
  void main() {
    vec3 normal = normalize(vNormal);
    float alpha = 1.0 - smoothstep(0.45 * uFade, uFade, abs(vPlace.x));
    gl_FragColor = vec4(uColour * matt(normal) + 0.12 * shine(normal), alpha);
  }
`;

export class PlateMesh {
  /**
   * @param {object} scenario
   * @param {number[]} size of the sheet, m
   * @param {import("./shadow.js").Shadow} shadow
   * @param {object} shared uniforms
   */
  constructor({ plate }, size, shadow, shared) {
    this.shadow = shadow;
    this.endless = plate === null || plate === undefined;
    const far = WITHOUT_END * Math.max(...size);
    /** Half the length and width of what is drawn, m; of what is measured; and what the camera should show of it. */
    this.half = this.endless ? [far, far] : [plate.length / 2, plate.width / 2];
    this.shown = this.endless ? [SHOWN * far, SHOWN * far] : this.half;
    this.corners = cornersOf(this.shown, this.endless);
    this.slab = 2 * SLAB * Math.min(...this.shown);
    this.bar = 2 * BAR * Math.min(...this.shown);
    /** Between lines of the grid, m. */
    this.pitch = 10 ** Math.round(Math.log10((2 * Math.max(...this.shown)) / 8));
    this.texture = new DataTexture(shadow.dark, CELLS, CELLS, RedFormat, UnsignedByteType);
    this.texture.minFilter = this.texture.magFilter = LinearFilter;
    this.uniforms = this.makeUniforms(shared);
    this.group = new Group();
    this.group.matrixAutoUpdate = false;
    const surface = this.add(rectangle(this.half), SURFACE, this.uniforms, this.endless, SURFACE_VERTEX);
    surface.renderOrder = 1;
    this.bodies = new Group();
    this.group.add(this.bodies);
    this.metal = { ...shared, uColour: { value: new Vector3() }, uFade: { value: BAR_ENDS * this.half[0] } };
    const depth = this.endless ? this.bar : this.slab + this.bar;
    this.bodies.add(this.add(cylinder(this.half[0], this.bar, depth), SOLID, this.metal, true));
    if (this.endless) return;
    this.body = { ...shared, uColour: { value: new Vector3() }, uFade: { value: 1e6 } };
    this.bodies.add(this.add(slab(this.half, this.slab), SOLID, this.body, false));
  }

  makeUniforms(shared) {
    return {
      ...shared, uColour: { value: new Vector3() }, uGrid: { value: new Vector3() }, uAxis: { value: new Vector3() },
      uDark: { value: new Vector3() }, uHalf: { value: new Vector2(...this.half) }, uCorner: { value: new Vector2() },
      uPitch: { value: this.pitch }, uWindow: { value: CELLS * this.shadow.grain }, uShift: { value: new Vector2() },
      uFade: { value: this.endless ? 1 : 0 },
      uShadow: { value: this.texture },
    };
  }

  add(geometry, fragmentShader, uniforms, transparent, vertexShader = VERTEX) {
    const material = new ShaderMaterial({ vertexShader, fragmentShader, uniforms, transparent });
    const mesh = new Mesh(geometry, material);
    mesh.frustumCulled = false;
    this.group.add(mesh);
    return mesh;
  }

  recolour({ plate, ink, paper, dark }) {
    this.uniforms.uColour.value.fromArray(plate);
    this.uniforms.uGrid.value.fromArray(mix(plate, dark ? paper : ink, dark ? 0.28 : 0.13));
    this.uniforms.uAxis.value.fromArray(mix(plate, ink, 0.5));
    this.uniforms.uDark.value.fromArray(dark ? [0.02, 0.03, 0.05] : [0.14, 0.18, 0.24]);
    this.metal.uColour.value.fromArray(mix(plate, dark ? ink : [0.42, 0.45, 0.5], 0.3));
    this.body?.uColour.value.fromArray(plate);
  }

  /**
   * @param {import("three").Matrix4} pose of the plate
   * @param {number} exaggerated how much higher than they are heights are drawn
   * @param {ArrayLike<number>} centre of the sheet on the plate, m
   */
  update(pose, exaggerated, centre) {
    if (this.endless) this.uniforms.uShift.value.set(beyond(centre[0], this.half[0]), beyond(centre[1], this.half[1]));
    this.group.matrix.copy(pose);
    this.group.matrixWorldNeedsUpdate = true;
    // Heights grow about the plate's surface, but neither slab nor bar gets thicker by it.
    this.bodies.scale.set(1, 1, 1 / exaggerated);
    this.texture.needsUpdate = true;
    this.uniforms.uCorner.value.set(this.shadow.corner[0], this.shadow.corner[1]);
  }

  dispose() {
    this.texture.dispose();
    this.group.traverse((object) => {
      object.geometry?.dispose();
      object.material?.dispose();
    });
  }
}

/** How far out of the middle a place is that has wandered. */
const beyond = (at, half) => at - Math.min(Math.max(at, -WANDERED * half), WANDERED * half);

/** Of a plate with an end its corners; of one without as much around the middle. */
const cornersOf = ([a, b], endless) => {
  if (!endless) return [[-a, -b], [a, -b], [a, b], [-a, b]];
  const around = Array.from({ length: 8 }, (_, k) => (k * Math.PI) / 4);
  return around.map((angle) => [1.2 * a * Math.cos(angle), 1.2 * b * Math.sin(angle)]);
};

const geometryOf = (positions, normals, index) => {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(Float32Array.from(positions), 3));
  geometry.setAttribute("normal", new BufferAttribute(Float32Array.from(normals), 3));
  return geometry.setIndex(index);
};

const rectangle = ([a, b]) =>
  geometryOf([-a, -b, 0, a, -b, 0, a, b, 0, -a, b, 0], [0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1], [0, 1, 2, 0, 2, 3]);

/** Sides and bottom of the plate. */
const slab = ([a, b], depth) => {
  const corners = [[-a, -b], [a, -b], [a, b], [-a, b]], outward = [[0, -1], [1, 0], [0, 1], [-1, 0]];
  const positions = [], normals = [], index = [];
  const face = (points, normal) => {
    const first = positions.length / 3;
    for (const point of points) {
      positions.push(...point);
      normals.push(...normal);
    }
    index.push(first, first + 1, first + 2, first, first + 2, first + 3);
  };
  corners.forEach((corner, k) => {
    const next = corners[(k + 1) % 4];
    face([[...corner, -depth], [...next, -depth], [...next, 0], [...corner, 0]], [...outward[k], 0]);
  });
  face([...corners].reverse().map((corner) => [...corner, -depth]), [0, 0, -1]);
  return geometryOf(positions, normals, index);
};

const AROUND = 24;

/** The bar, from under the plate's edge on. */
const cylinder = (from, radius, depth) => {
  const positions = [], normals = [], index = [];
  for (let k = 0; k <= AROUND; k++) {
    const y = Math.cos((2 * Math.PI * k) / AROUND), z = Math.sin((2 * Math.PI * k) / AROUND);
    for (const x of [0, -BAR_ENDS * from]) {
      positions.push(x, radius * y, radius * z - depth);
      normals.push(0, y, z);
    }
    if (k > 0) index.push(2 * k - 2, 2 * k, 2 * k - 1, 2 * k - 1, 2 * k, 2 * k + 1);
  }
  return geometryOf(positions, normals, index);
};
