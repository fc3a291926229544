// Marks of gaits, told apart by shape and colour, as in the source's Figs. 4.4 and 4.7.
import { colours } from "./colours.js";

const square = (path, x, y, r) => path.rect(x - 0.9 * r, y - 0.9 * r, 1.8 * r, 1.8 * r);
const circle = (path, x, y, r) => {
  path.moveTo(x + r, y);
  path.arc(x, y, r, 0, 2 * Math.PI);
};
const corners = (points) => (path, x, y, r) => {
  points.forEach(([dx, dy], i) => (i ? path.lineTo(x + r * dx, y + r * dy) : path.moveTo(x + r * dx, y + r * dy)));
  path.closePath();
};
const cross = (path, x, y, r) => {
  for (const side of [-1, 1]) {
    path.moveTo(x - r, y - side * r);
    path.lineTo(x + r, y + side * r);
  }
};

/** By gait, "" where none is known, "failed" for a point that failed: shape, colour's name, letter. */
export const MARKS = {
  sliding: { shape: square, colour: "sliding", letter: "s" },
  walking: { shape: corners([[0, -1.15], [1.05, 0.8], [-1.05, 0.8]]), colour: "walking", letter: "w" },
  running: { shape: circle, colour: "running", letter: "r" },
  "": { shape: corners([[0, -1.1], [1.1, 0], [0, 1.1], [-1.1, 0]]), colour: "muted", letter: "?" },
  failed: { shape: cross, colour: "failed", letter: "×" },
};

/** Draw a mark: white inside, or half filled where some of its runs failed. */
export const drawMark = (ctx, kind, x, y, r, partly = false) => {
  const { shape, colour } = MARKS[kind] ?? MARKS[""];
  const path = new Path2D();
  shape(path, x, y, r);
  ctx.save();
  ctx.lineWidth = Math.max(1.5, r / 3);
  ctx.strokeStyle = colours[colour];
  if (kind !== "failed") {
    ctx.fillStyle = colours.paper;
    ctx.fill(path);
    if (partly) {
      ctx.save();
      ctx.clip(path);
      ctx.fillStyle = colours[colour];
      ctx.fillRect(x - 2 * r, y - 2 * r, 2 * r, 4 * r);
      ctx.restore();
    }
  }
  ctx.stroke(path);
  ctx.restore();
};

/** A small picture of a mark beside its word, for legends. */
export const markInLegend = (kind, text, partly = false) => {
  const item = document.createElement("span");
  item.className = "mark";
  const canvas = document.createElement("canvas");
  const scale = Math.max(1, Math.round(devicePixelRatio || 1));
  canvas.width = canvas.height = 16 * scale;
  canvas.setAttribute("aria-hidden", "true");
  item.append(canvas, text);
  const draw = () => {
    const ctx = canvas.getContext("2d");
    ctx.clearRect(0, 0, canvas.width, canvas.height);
    drawMark(ctx, kind, 8 * scale, 8 * scale, 5 * scale, partly);
  };
  draw();
  return { item, draw };
};
