// Rulers printed along two edges of the plate, in mm.
import { BufferAttribute, BufferGeometry, CanvasTexture, Group, Mesh, ShaderMaterial } from "three";
import { css, mix } from "./colours.js";

const LENGTH = 1024, WIDTH = 56; // px of the picture of a ruler

const VERTEX = /* glsl */ `
  attribute vec2 uv2d;
  varying vec2 vUv;
  void main() {
    vUv = uv2d;
    gl_Position = projectionMatrix * viewMatrix * modelMatrix * vec4(position, 1.0);
  }
`;

const FRAGMENT = /* glsl */ `
  uniform sampler2D uPicture;
  varying vec2 vUv;
  void main() {
    gl_FragColor = texture2D(uPicture, vUv);
  }
`;

/** Marks along a ruler that reaches `half` both ways: places, m, and what is written there, in mm. */
export const marksAlong = (half, pitch) => {
  const marks = [], n = Math.floor(half / pitch + 1e-6), every = n > 8 ? 5 : 2;
  for (let k = -2 * n; k <= 2 * n; k++) {
    const whole = k % 2 === 0, numbered = k % (2 * every) === 0;
    const text = numbered ? String(Number(((500 * k * pitch)).toPrecision(6))).replace("-", "\u2212") : "";
    marks.push({ at: (k * pitch) / 2, length: numbered ? 1 : whole ? 0.66 : 0.4, text });
  }
  return marks;
};

export class Rulers {
  /** @param {number[]} half length and width of the plate as far as it is measured, m @param {number} pitch of its grid, m */
  constructor(half, pitch) {
    this.half = half;
    this.pitch = pitch;
    this.group = new Group();
    const wide = (2 * Math.min(...half) * WIDTH) / LENGTH * 1.25;
    this.sides = half.map((reach, axis) => {
      const canvas = document.createElement("canvas");
      canvas.width = LENGTH;
      canvas.height = Math.round((LENGTH * wide) / (2 * reach));
      const texture = new CanvasTexture(canvas);
      texture.anisotropy = 4;
      const material = new ShaderMaterial({
        vertexShader: VERTEX, fragmentShader: FRAGMENT, uniforms: { uPicture: { value: texture } }, transparent: true,
        depthWrite: false, polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -2,
      });
      const mesh = new Mesh(strip(axis, half, wide), material);
      mesh.frustumCulled = false;
      mesh.renderOrder = 2;
      this.group.add(mesh);
      return { canvas, texture, reach, mesh, free: axis === 0 ? reach - 1.3 * wide : reach };
    });
  }

  recolour({ plate, ink, font, dark }) {
    const colour = css(mix(plate, ink, dark ? 0.72 : 0.62));
    for (const { canvas, texture, reach, free } of this.sides) {
      const { width, height } = canvas, pen = canvas.getContext("2d");
      pen.clearRect(0, 0, width, height);
      pen.fillStyle = pen.strokeStyle = colour;
      pen.lineWidth = 2;
      pen.font = `${Math.round(0.52 * height)}px ${font}`;
      pen.textAlign = "center";
      pen.textBaseline = "alphabetic";
      for (const { at, length, text } of marksAlong(0.985 * reach, this.pitch)) {
        const x = ((at / reach + 1) * width) / 2;
        pen.beginPath();
        pen.moveTo(x, height);
        pen.lineTo(x, height * (1 - 0.3 * length));
        pen.stroke();
        const half = pen.measureText(text).width / 2 + 2;
        if (text && x > half && x < width - half && at < free) // the other ruler has the corner
          pen.fillText(text === "0" ? "0 mm" : text, x, 0.6 * height);
      }
      texture.needsUpdate = true;
    }
  }

  dispose() {
    for (const { texture, mesh } of this.sides) {
      texture.dispose();
      mesh.geometry.dispose();
      mesh.material.dispose();
    }
  }
}

/** A strip of the plate's surface along its edge at low y (axis 0) or high x (axis 1), to be read from outside. */
const strip = (axis, [a, b], wide) => {
  const places = axis === 0
    ? [-a, -b, 0, a, -b, 0, a, wide - b, 0, -a, wide - b, 0]
    : [a, -b, 0, a, b, 0, a - wide, b, 0, a - wide, -b, 0];
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(Float32Array.from(places), 3));
  geometry.setAttribute("uv2d", new BufferAttribute(Float32Array.from([0, 0, 1, 0, 1, 1, 0, 1]), 2));
  return geometry.setIndex([0, 1, 2, 0, 2, 3]);
};
