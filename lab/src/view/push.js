// A push by hand: the arrow that shows it while the pointer is down, on the plate.
import { Lines } from "./lines.js";

const HEAD = 0.28; // of the arrow's length, at most of a third of the sheet

export class PushArrow {
  constructor(size, shared) {
    this.most = Math.max(...size) / 9;
    this.lines = new Lines(3, shared, { width: 8 });
    this.mesh = this.lines.mesh;
    this.mesh.renderOrder = 9;
    this.mesh.visible = false;
  }

  recolour({ ink, paper }) {
    this.lines.colour(ink, paper);
  }

  /** From one place to another, in the plate's frame. */
  show(from, to) {
    const dx = to[0] - from[0], dy = to[1] - from[1], length = Math.hypot(dx, dy);
    this.mesh.visible = length > 1e-4;
    if (!this.mesh.visible) return;
    const head = Math.min(HEAD * length, this.most), ux = (head * dx) / length, uy = (head * dy) / length;
    this.mesh.position.z = from[2];
    this.lines.count = 0;
    this.lines.add(from[0], from[1], to[0], to[1], 0, 1);
    this.lines.add(to[0], to[1], to[0] - ux - 0.55 * uy, to[1] - uy + 0.55 * ux, 0, 1);
    this.lines.add(to[0], to[1], to[0] - ux + 0.55 * uy, to[1] - uy - 0.55 * ux, 0, 1);
    this.lines.upload();
  }

  hide() {
    this.mesh.visible = false;
  }

  dispose() {
    this.lines.dispose();
  }
}
