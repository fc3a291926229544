// What lies inside an outline, as `plategait.model.outline` has it: points are about the middle of its bounding box.

/** Length along x and width along y, m. */
export const sizeOf = (outline) => {
  switch (outline.shape) {
    case "disk":
      return [2 * outline.radius, 2 * outline.radius];
    case "polygon": {
      const [low, high] = bounds(outline.corners);
      return [high[0] - low[0], high[1] - low[1]];
    }
    case "mask": {
      const { columns, rows, pixel } = pixelsOf(outline);
      return [columns * pixel, rows * pixel];
    }
    default:
      return [outline.length, outline.width];
  }
};

/**
 * A test of points.
 * @returns {(x: number, y: number) => boolean}
 */
export const insideOf = (outline) => {
  const [length, width] = sizeOf(outline);
  switch (outline.shape) {
    case "disk":
    case "ellipse":
      return (x, y) => Math.hypot((2 * x) / length, (2 * y) / width) <= 1;
    case "polygon": {
      const [low, high] = bounds(outline.corners);
      const middle = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2];
      return insidePolygon(outline.corners.map(([x, y]) => [x - middle[0], y - middle[1]]));
    }
    case "mask": {
      const { columns, rows, dark } = pixelsOf(outline);
      return (x, y) => dark(Math.floor((x / length + 0.5) * columns), Math.floor((y / width + 0.5) * rows));
    }
    default:
      return (x, y) => Math.abs(x) <= length / 2 && Math.abs(y) <= width / 2;
  }
};

const bounds = (corners) => {
  const low = [Infinity, Infinity], high = [-Infinity, -Infinity];
  for (const corner of corners)
    for (let d = 0; d < 2; d++) {
      low[d] = Math.min(low[d], corner[d]);
      high[d] = Math.max(high[d], corner[d]);
    }
  return [low, high];
};

/** By the even-odd rule. */
const insidePolygon = (corners) => (x, y) => {
  let odd = false;
  for (let k = 0, l = corners.length - 1; k < corners.length; l = k++) {
    const [x0, y0] = corners[k], [x1, y1] = corners[l];
    if (y0 > y !== y1 > y && x < x0 + ((y - y0) * (x1 - x0)) / (y1 - y0)) odd = !odd;
  }
  return odd;
};

/** The picture of a mask, cropped to the sheet; row 0 at the bottom. */
const pixelsOf = ({ rows: text, width_of_picture: width }) => {
  const used = [...text.keys()].filter((j) => text[j].includes("#"));
  const first = Math.min(...used.map((j) => text[j].indexOf("#")));
  const last = Math.max(...used.map((j) => text[j].lastIndexOf("#")));
  const top = used[0], bottom = used.at(-1);
  return {
    columns: last - first + 1,
    rows: bottom - top + 1,
    pixel: width / text[0].length,
    dark: (i, j) => i >= 0 && i <= last - first && (text[bottom - j]?.[first + i] ?? " ") === "#" && bottom - j >= top,
  };
};
