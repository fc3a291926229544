// What is written into a corner of the picture: how much higher than they are heights are drawn; the scale of colours.
import { BufferAttribute, BufferGeometry, CanvasTexture, LinearFilter, Mesh, ShaderMaterial, Vector2 } from "three";
import { BENT, HIGH, css } from "./colours.js";

/** CSS px: how wide the notes are, how high a line of words is, and the scale of colours. */
export const WIDTH = 220, LINE = 22, BAR = 46;
const MARGIN = 8;

const VERTEX = /* glsl */ `
  uniform vec2 uViewport, uSize;
  uniform float uMargin;
  varying vec2 vUv;
  void main() {
    vUv = position.xy;
    vec2 px = vec2(uViewport.x - uMargin - uSize.x, uMargin) + position.xy * uSize;
    gl_Position = vec4(px / uViewport * 2.0 - 1.0, 0.0, 1.0);
  }
`;

const FRAGMENT = /* glsl */ `
  uniform sampler2D uPicture;
  varying vec2 vUv;
  void main() {
    gl_FragColor = texture2D(uPicture, vUv);
  }
`;

/**
 * What there is to say.
 * @typedef {object} Said
 * @property {number} exaggerated factor of heights
 * @property {"curvature" | "height" | ""} bent what colours mean
 * @property {number} most what the strongest colour means, 1/m or m
 */

/** Both ends of the scale of colours in words. */
export const scaleInWords = (bent, most) =>
  bent === "height" ? ["0", `${plain(1000 * most)} mm high`] : [`\u2212${plain(most)}`, `curvature ${plain(most)} /m`];

const plain = (value) => String(Number(value.toPrecision(3)));

export class Notes {
  constructor(shared) {
    this.canvas = document.createElement("canvas");
    this.texture = null;
    this.uniforms = {
      uViewport: shared.uViewport, uSize: { value: new Vector2() }, uMargin: { value: 0 }, uPicture: { value: null },
    };
    const material = new ShaderMaterial({
      vertexShader: VERTEX, fragmentShader: FRAGMENT, uniforms: this.uniforms, transparent: true, depthTest: false,
      depthWrite: false,
    });
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(Float32Array.from([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]), 3));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    this.mesh = new Mesh(geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 20;
    this.mesh.visible = false;
    this.said = {};
  }

  /** @param {Said} what @param {object} colours of the page @param {number} ratio pixels of the picture over CSS px */
  say(what, colours, ratio) {
    const { said } = this, same = Object.keys(what).every((key) => said[key] === what[key]);
    if (same && said.colours === colours && said.ratio === ratio) return;
    Object.assign(said, what, { colours, ratio });
    const lines = (what.exaggerated !== 1 ? 1 : 0) + (what.bent ? 1 : 0);
    this.mesh.visible = lines > 0;
    if (lines === 0) return;
    const tall = (what.exaggerated !== 1 ? LINE : 0) + (what.bent ? BAR : 0);
    this.canvas.width = Math.round(WIDTH * ratio);
    this.canvas.height = Math.round(tall * ratio);
    const pen = this.canvas.getContext("2d");
    pen.scale(ratio, ratio);
    drawNotes(pen, what, colours, WIDTH);
    this.upload(ratio);
  }

  /** A texture keeps the size it was made with. */
  upload(ratio) {
    this.texture?.dispose();
    this.texture = new CanvasTexture(this.canvas);
    this.texture.minFilter = this.texture.magFilter = LinearFilter;
    this.texture.generateMipmaps = false;
    this.uniforms.uPicture.value = this.texture;
    this.uniforms.uSize.value.set(this.canvas.width, this.canvas.height);
    this.uniforms.uMargin.value = Math.round(MARGIN * ratio);
  }

  dispose() {
    this.texture?.dispose();
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}

/** Write the notes against the right end of a width, CSS px, downwards from 0. */
export const drawNotes = (pen, { exaggerated, bent, most }, { ink, font }, width) => {
  let y = 0;
  pen.font = `13px ${font}`;
  pen.fillStyle = css(ink);
  pen.textBaseline = "middle";
  if (exaggerated !== 1) {
    pen.textAlign = "right";
    pen.fillText(`heights drawn \u00d7 ${exaggerated}`, width - 2, y + LINE / 2);
    y += LINE;
  }
  if (!bent) return;
  const colours = bent === "height" ? HIGH : BENT;
  const fall = pen.createLinearGradient(20, 0, width - 2, 0);
  colours.forEach((colour, k) => fall.addColorStop(k / 2, css(colour)));
  pen.fillStyle = fall;
  pen.fillRect(20, y + 6, width - 22, 10);
  pen.strokeStyle = css(ink, 0.5);
  pen.strokeRect(20.5, y + 6.5, width - 23, 9);
  pen.fillStyle = css(ink);
  const [low, high] = scaleInWords(bent, most);
  pen.textAlign = "left";
  pen.fillText(low, 18, y + 30);
  pen.textAlign = "right";
  pen.fillText(high, width - 2, y + 30);
};
