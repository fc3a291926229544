// Something painted on the plate: a picture that a 2-D canvas draws.
import { BufferAttribute, BufferGeometry, CanvasTexture, Mesh, ShaderMaterial } from "three";

const VERTEX = /* glsl */ `
  attribute vec2 place;
  varying vec2 vPlace;
  void main() {
    vPlace = place;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }
`;

const FRAGMENT = /* glsl */ `
  uniform sampler2D uPicture;
  varying vec2 vPlace;
  void main() {
    gl_FragColor = texture2D(uPicture, vPlace);
  }
`;

export class Decal {
  /**
   * @param {number} width px of the picture
   * @param {number} height
   * @param {number[]} corners x and y of lower left, lower right, upper right, upper left, m
   */
  constructor(width, height, corners) {
    this.canvas = document.createElement("canvas");
    this.canvas.width = width;
    this.canvas.height = height;
    this.texture = new CanvasTexture(this.canvas);
    this.texture.anisotropy = 4;
    const geometry = new BufferGeometry(), at = [0, 1, 2, 3].flatMap((k) => [corners[2 * k], corners[2 * k + 1], 0]);
    geometry.setAttribute("position", new BufferAttribute(Float32Array.from(at), 3));
    geometry.setAttribute("place", new BufferAttribute(Float32Array.from([0, 0, 1, 0, 1, 1, 0, 1]), 2));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    const material = new ShaderMaterial({
      vertexShader: VERTEX, fragmentShader: FRAGMENT, uniforms: { uPicture: { value: this.texture } },
      transparent: true, depthWrite: false, polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -2,
    });
    this.mesh = new Mesh(geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 2;
  }

  /** @param {(pen: CanvasRenderingContext2D, width: number, height: number) => void} draw onto what is clear */
  paint(draw) {
    const { width, height } = this.canvas, pen = this.canvas.getContext("2d");
    pen.clearRect(0, 0, width, height);
    draw(pen, width, height);
    this.texture.needsUpdate = true;
  }

  dispose() {
    this.texture.dispose();
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}
