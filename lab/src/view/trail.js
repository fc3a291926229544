// Where the sheet's middle has been on the plate, and how far it may slip.
import { Lines } from "./lines.js";

const CORNERS = 96;

/** The circle that the middle must not leave, as a line. */
export const limitCircle = ({ start, slip_limit: limit }) => {
  const circle = new Float64Array(limit > 0 ? 2 * CORNERS : 0);
  for (let k = 0; k < circle.length / 2; k++) {
    circle[2 * k] = start.x + limit * Math.cos((2 * Math.PI * k) / CORNERS);
    circle[2 * k + 1] = start.y + limit * Math.sin((2 * Math.PI * k) / CORNERS);
  }
  return circle;
};

export class Trail {
  /** @param {import("./shown.js").Shown} shown @param {object} shared uniforms */
  constructor(shown, shared) {
    this.shown = shown;
    this.line = new Lines(shown.way.most, shared, { width: 4 });
    this.limit = new Lines(CORNERS, shared, { width: 4, dash: (2 * Math.PI * shown.scenario.slip_limit) / 24 || 0 });
    this.limit.path(limitCircle(shown.scenario), true);
    this.meshes = [this.limit.mesh, this.line.mesh];
    this.drawn = -1;
  }

  recolour({ ink, paper, failed }) {
    this.line.colour(ink, paper);
    this.limit.colour(failed, paper);
  }

  update() {
    if (this.drawn === this.shown.ways) return;
    this.drawn = this.shown.ways;
    const { places, count } = this.shown.way, { line } = this;
    line.count = 0;
    for (let k = 2; k < 2 * count; k += 2) line.add(places[k - 2], places[k - 1], places[k], places[k + 1], 0, 0);
    line.upload();
  }

  dispose() {
    this.line.dispose();
    this.limit.dispose();
  }
}
