// The shadow that the sheet casts on the plate: sharp where it touches, soft where it is lifted. Worked out on the
// processor on a small grid that goes along with the sheet, as the films' painter does it.

export const CELLS = 96;
/** Room around the sheet, over its longer side. */
const ROOM = 1.7;
const NEAR = 3e-3; // m; as high as this a sheet casts a soft shadow

export class Shadow {
  /** @param {import("./surface.js").SheetSurface} surface */
  constructor(surface) {
    this.surface = surface;
    this.grain = (ROOM * Math.max(...surface.size)) / CELLS;
    /** Darkness, 0 to 255, row by row; and the window's corner in the plate's frame, m. */
    this.dark = new Uint8Array(CELLS * CELLS);
    this.corner = new Float64Array(2);
    this.sharp = new Float32Array(CELLS * CELLS);
    this.soft = new Float32Array(CELLS * CELLS);
    this.spare = new Float32Array(CELLS * CELLS);
    const cells = (length) => Math.max(1, Math.round(length / this.grain));
    this.reach = [cells(1.2e-3), cells(0.045 * Math.max(...surface.size))];
  }

  /**
   * @param {Float64Array} frame of the plate
   * @param {ArrayLike<number>} light towards it, plate frame
   */
  cast(frame, light) {
    const { surface, sharp, soft, dark, grain, corner } = this, { points, area } = surface;
    for (let d = 0; d < 2; d++) corner[d] = (Math.round(surface.centre[d] / grain) - CELLS / 2) * grain;
    sharp.fill(0);
    soft.fill(0);
    const ax = frame[0], bx = frame[1], nx = frame[2], ay = frame[3], by = frame[4], ny = frame[5];
    const az = frame[6], bz = frame[7], nz = frame[8], ox = frame[9], oy = frame[10], oz = frame[11];
    const leanX = light[0] / light[2], leanY = light[1] / light[2], cell = 1 / (grain * grain);
    for (let k = 0, p = 0; p < points.length; k++, p += 3) {
      const x = points[p] - ox, y = points[p + 1] - oy, z = points[p + 2] - oz;
      const height = nx * x + ny * y + nz * z;
      if (height < -5e-3) continue; // it has left the plate
      const up = Math.max(height, 0);
      const u = (ax * x + ay * y + az * z - up * leanX - corner[0]) / grain - 0.5;
      const v = (bx * x + by * y + bz * z - up * leanY - corner[1]) / grain - 0.5;
      const i = Math.floor(u), j = Math.floor(v);
      if (!(i >= 2 && j >= 2 && i < CELLS - 3 && j < CELLS - 3)) continue;
      const close = Math.exp(-up / NEAR), whole = area[k] * cell;
      spread(sharp, i, j, u - i, v - j, whole * close);
      spread(soft, i, j, u - i, v - j, whole * (1 - close));
    }
    blur(sharp, this.spare, this.reach[0]);
    blur(soft, this.spare, this.reach[1]);
    for (let k = 0; k < dark.length; k++)
      dark[k] = 255 * Math.min(0.7, 0.55 * Math.min(1, sharp[k]) + 0.42 * Math.min(1, soft[k]));
    clearEdge(dark);
  }
}

/** A weight over the four cells around a place. */
const spread = (grid, i, j, s, t, weight) => {
  const k = j * CELLS + i;
  grid[k] += weight * (1 - s) * (1 - t);
  grid[k + 1] += weight * s * (1 - t);
  grid[k + CELLS] += weight * (1 - s) * t;
  grid[k + CELLS + 1] += weight * s * t;
};

/** Nearly a Gaussian: two running means each way. */
const blur = (grid, spare, reach) => {
  for (let pass = 0; pass < 2; pass++) {
    for (let line = 0; line < CELLS; line++) runningMean(grid, spare, line * CELLS, 1, reach);
    for (let line = 0; line < CELLS; line++) runningMean(spare, grid, line, CELLS, reach);
  }
};

const runningMean = (from, to, start, stride, reach) => {
  const width = 2 * reach + 1;
  let sum = 0;
  for (let k = 0; k <= reach; k++) sum += from[start + k * stride];
  for (let k = 0; k < CELLS; k++) {
    to[start + k * stride] = sum / width;
    if (k + reach + 1 < CELLS) sum += from[start + (k + reach + 1) * stride];
    if (k - reach >= 0) sum -= from[start + (k - reach) * stride];
  }
};

/** Nothing on the border, which is taken for all that lies beyond. */
const clearEdge = (dark) => {
  for (let k = 0; k < CELLS; k++)
    dark[k] = dark[(CELLS - 1) * CELLS + k] = dark[k * CELLS] = dark[k * CELLS + CELLS - 1] = 0;
};
