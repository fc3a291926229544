// The picture without WebGL: from above and along the bar, drawn on a plain canvas.
import { BENT, HIGH, css, mix } from "./colours.js";
import { intoWorld } from "./frame.js";
import { arrowLength, nodeShare } from "./loads.js";
import { BAR, LINE, WIDTH, drawNotes } from "./notes.js";
import { limitCircle } from "./trail.js";

const MARGIN = 14, GAP = 10; // CSS px
const TOP_SHARE = 0.66; // of the picture, for the view from above
const REACH = 0.82; // of the sheet's size, both ways, where the plate has no end

export class FlatPicture {
  /** @param {HTMLCanvasElement} canvas @param {import("./camera.js").ViewCamera} view */
  constructor(canvas, view) {
    this.canvas = canvas;
    this.view = view;
    this.pen = canvas.getContext("2d");
  }

  build(shown) {
    this.shown = shown;
    this.bent = new Float32Array(shown.surface.nVertices);
    const { plate } = shown.scenario, far = REACH * Math.max(...shown.surface.size);
    this.half = plate ? [plate.length / 2, plate.width / 2] : [far, far];
    this.limit = limitCircle(shown.scenario);
    return [[this.half[0], this.half[1]]];
  }

  recolour(colours) {
    this.colours = colours;
  }

  resize(width, height, pixels) {
    this.ratio = Math.min(pixels, 2);
    this.canvas.width = Math.max(1, Math.round(width * this.ratio));
    this.canvas.height = Math.max(1, Math.round(height * this.ratio));
    this.size = [width, height];
  }

  /** Where both views are: middle, px, and px per m. */
  layOut() {
    const [width, height] = this.size, wide = width > 1.2 * height, [a, b] = this.half;
    const top = wide ? [TOP_SHARE * width, height] : [width, TOP_SHARE * height];
    const fits = Math.max(1, Math.min((top[0] - 2 * MARGIN) / (2 * a), (top[1] - 2 * MARGIN) / (2 * b)));
    const scale = fits / this.view.zoom;
    const rest = wide ? width - top[0] - GAP : width;
    this.above = { x: top[0] / 2, y: top[1] / 2, scale };
    this.beside = {
      x: wide ? top[0] + rest / 2 : width / 2, y: wide ? height / 2 : top[1] + (height - top[1]) / 2,
      scale: Math.max(1, (rest - 2 * MARGIN) / (2 * b)) / this.view.zoom,
    };
  }

  draw(asked) {
    const { pen, colours, shown } = this, [width, height] = this.size;
    this.layOut();
    pen.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    pen.fillStyle = css(colours.panel);
    pen.fillRect(0, 0, width, height);
    const { layers, said } = asked;
    if (layers.bending && shown.there) said.most = shown.bent(layers.bending, this.bent);
    this.drawAbove(asked);
    this.drawBeside(asked);
    this.writeWords(asked);
  }

  writeWords({ layers, said }) {
    const { pen, colours, shown, above, beside, half } = this, [width, height] = this.size;
    const { left, right } = shown.touching;
    pen.fillStyle = css(colours.muted);
    pen.font = `12px ${colours.font}`;
    pen.textAlign = "center";
    pen.textBaseline = "bottom";
    const low = above.y + half[1] * above.scale - 4, flight = shown.there && !left && !right ? ": in flight" : "";
    const off = Math.min(0.5 * half[1] * beside.scale, height / 2 - 60);
    pen.fillText(`from above${flight}`, above.x, low);
    pen.fillText("along the bar", beside.x, beside.y - off);
    pen.fillText("drawn flat: there is no WebGL", beside.x, beside.y + off + 12);
    if (layers.legs) {
      pen.textAlign = "left";
      const far = above.x - half[0] * above.scale + 6;
      for (const [name, touches, y] of [["left", left, -0.6], ["right", right, 0.6]]) {
        pen.fillStyle = css(mix(colours[name], colours.ink, 0.25));
        pen.fillText(`${touches ? "\u25cf" : "\u25cb"} ${name} leg`, far, above.y + y * half[1] * above.scale);
      }
    }
    const tall = (said.exaggerated !== 1 ? LINE : 0) + (said.bent ? BAR : 0);
    pen.save();
    pen.translate(width - WIDTH - 8, height - tall - 8);
    drawNotes(pen, said, colours, WIDTH);
    pen.restore();
  }

  drawAbove({ layers, goal, ghost, cloud, push }) {
    const { pen, colours, above, shown } = this, { x, y, scale } = above, [a, b] = this.half;
    const line = (places, closed) => {
      pen.beginPath();
      for (let k = 0; k < places.length; k += 2) pen.lineTo(x + scale * places[k], y - scale * places[k + 1]);
      if (closed) pen.closePath();
    };
    pen.fillStyle = css(colours.plate);
    pen.fillRect(x - a * scale, y - b * scale, 2 * a * scale, 2 * b * scale);
    pen.strokeStyle = css(mix(colours.plate, colours.ink, 0.5));
    pen.lineWidth = 1;
    line([-a, 0, a, 0], false);
    pen.stroke();
    if (shown.there) this.drawSheet(line, layers);
    if (layers.trail) this.drawTrail(line);
    for (const { nodes } of cloud) this.drawDots(nodes, css(colours.accent, 0.3));
    if (goal) this.drawContour(line, goal, colours.failed);
    if (ghost) this.drawContour(line, ghost, colours.accent);
    if (!push) return;
    pen.strokeStyle = css(colours.accent);
    pen.lineWidth = 4;
    line([push.from[0], push.from[1], push.to[0], push.to[1]], false);
    pen.stroke();
  }

  drawSheet(line, layers) {
    const { pen, colours, shown } = this, { surface, onPlate, nNodes, forces, hasForces } = shown;
    pen.beginPath();
    this.traceEdge();
    pen.fillStyle = css(colours.sheet);
    pen.fill("evenodd");
    pen.strokeStyle = css(mix(colours.sheet, colours.ink, 0.6));
    pen.stroke();
    const { x, y, scale } = this.above;
    for (let k = 0; k < nNodes; k++) {
      const touches = hasForces ? forces[3 * k] > 0 : onPlate[3 * k + 2] <= 0;
      const left = onPlate[3 * k + 1] > surface.centre[1];
      if (layers.bending) {
        this.drawBent(k, layers.bending);
        continue;
      }
      pen.fillStyle = css(layers.legs ? (left ? colours.left : colours.right) : colours.ink, touches ? 1 : 0.25);
      pen.beginPath();
      pen.arc(x + scale * onPlate[3 * k], y - scale * onPlate[3 * k + 1], 0.2 * surface.pitch * scale, 0, 2 * Math.PI);
      if (touches && layers.contact) pen.fill();
      else pen.fillRect(x + scale * onPlate[3 * k] - 1, y - scale * onPlate[3 * k + 1] - 1, 2, 2);
    }
    if (layers.forces && hasForces) this.drawFriction(line);
    const cos = Math.cos(surface.angle), sin = Math.sin(surface.angle), far = 0.4 * surface.size[0];
    pen.lineWidth = 3;
    pen.strokeStyle = css(mix(colours.ink, colours.accent, 0.4));
    const [cx, cy] = surface.centre;
    line([cx + 0.5 * far * cos, cy + 0.5 * far * sin, cx + far * cos, cy + far * sin], false);
    pen.stroke();
    pen.lineWidth = 1;
  }

  /** A square of a node's own, in the colour of how bent or high it is. */
  drawBent(node, kind) {
    const { pen, shown } = this, { x, y, scale } = this.above, { onPlate, surface } = shown;
    const [low, middle, high] = kind === "height" ? HIGH : BENT;
    const value = Math.max(-1, Math.min(1, shown.bentAt(kind, node)));
    pen.fillStyle = css(value < 0 ? mix(middle, low, -value) : mix(middle, high, value));
    const wide = 0.86 * surface.pitch * scale;
    pen.fillRect(x + scale * onPlate[3 * node] - wide / 2, y - scale * onPlate[3 * node + 1] - wide / 2, wide, wide);
  }

  /** A line from each node along its friction, as long as in the other picture. */
  drawFriction(line) {
    const { pen, colours, shown } = this, { onPlate, forces, nNodes, surface, scenario } = shown;
    const share = nodeShare(scenario, nNodes);
    pen.strokeStyle = css(colours.accent);
    pen.lineWidth = 2;
    for (let k = 0; k < nNodes; k++) {
      const x = onPlate[3 * k], y = onPlate[3 * k + 1];
      const long = arrowLength(forces[3 * k + 1], forces[3 * k + 2], share) * surface.pitch;
      if (!(forces[3 * k] > 0 && long > 0)) continue;
      const size = Math.hypot(forces[3 * k + 1], forces[3 * k + 2]);
      line([x, y, x + (long * forces[3 * k + 1]) / size, y + (long * forces[3 * k + 2]) / size], false);
      pen.stroke();
    }
  }

  /** The sheet's edge as the plate sees it. */
  traceEdge() {
    const { pen, shown, above } = this, { surface, frame: f } = shown, p = surface.points;
    for (const loop of surface.cut.loops) {
      loop.forEach((vertex, k) => {
        const x = p[3 * vertex] - f[9], y = p[3 * vertex + 1] - f[10], z = p[3 * vertex + 2] - f[11];
        const at = [f[0] * x + f[3] * y + f[6] * z, f[1] * x + f[4] * y + f[7] * z];
        pen[k ? "lineTo" : "moveTo"](above.x + above.scale * at[0], above.y - above.scale * at[1]);
      });
      pen.closePath();
    }
  }

  drawTrail(line) {
    const { pen, colours, shown } = this, { places, count } = shown.way;
    pen.lineWidth = 1.75;
    pen.strokeStyle = css(colours.failed);
    pen.setLineDash([6, 5]);
    line(this.limit, true);
    pen.stroke();
    pen.setLineDash([]);
    pen.strokeStyle = css(colours.dark ? colours.paper : colours.ink);
    line(places.subarray(0, 2 * count), false);
    pen.stroke();
  }

  drawContour(line, { x, y, angle }, colour) {
    const { pen, shown } = this, { cut, centroid } = shown.surface, cos = Math.cos(angle), sin = Math.sin(angle);
    pen.strokeStyle = css(colour);
    pen.lineWidth = 2;
    const placed = (k) => {
      const u = cut.x[k] - centroid[0], v = cut.y[k] - centroid[1];
      return [x + cos * u - sin * v, y + sin * u + cos * v];
    };
    for (const loop of cut.loops) {
      line(loop.flatMap(placed), true);
      pen.stroke();
    }
    const far = shown.surface.size[0] / 2;
    line([x, y, x + far * cos, y + far * sin], false);
    pen.stroke();
  }

  drawDots(nodes, colour) {
    const { pen, above: { x, y, scale } } = this;
    pen.fillStyle = colour;
    for (let k = 0; k < nodes.length; k += 3)
      pen.fillRect(x + scale * nodes[k] - 1, y - scale * nodes[k + 1] - 1, 2, 2);
  }

  /** From the bar's free end: y to the right, heights exaggerated as asked. */
  drawBeside({ exaggerated }) {
    const { pen, colours, beside, shown } = this, { frame, nodes, nNodes, surface } = shown, b = this.half[1];
    const to = (y, z) => [beside.x + beside.scale * y, beside.y - beside.scale * exaggerated * z];
    const end = [0, 0, 0];
    pen.strokeStyle = css(colours.plate);
    pen.lineWidth = 5;
    pen.beginPath();
    for (const y of [-b, b]) {
      intoWorld(frame, 0, y, 0, end);
      const [px, py] = to(end[1], end[2]);
      pen.lineTo(px, py + 3);
    }
    pen.stroke();
    pen.lineWidth = 1;
    if (!shown.there) return;
    for (let k = 0; k < nNodes; k++) {
      const [px, py] = to(nodes[3 * k + 1], nodes[3 * k + 2]);
      pen.fillStyle = css(shown.onPlate[3 * k + 1] > surface.centre[1] ? colours.left : colours.right);
      pen.fillRect(px - 1.5, py - 3, 3, 3);
    }
  }

  /** Straight down. */
  rayAt(x, y) {
    const { above } = this;
    return { from: [(x - above.x) / above.scale, (above.y - y) / above.scale, 10], way: [0, 0, -1] };
  }

  dispose() {}
}
