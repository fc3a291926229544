// How the sheet is bent at each node.

/** Mean curvature at the nodes, 1/m: positive where the sheet is a dome seen from its upper side. */
export class Curvature {
  constructor(sheet, lattice) {
    const { squares, nNodes, rows } = lattice;
    const at = new Map();
    for (let k = 0; k < nNodes; k++) at.set(squares[2 * k] * (rows + 2) + squares[2 * k + 1], k);
    const neighbour = (k, di, dj) => at.get((squares[2 * k] + di) * (rows + 2) + squares[2 * k + 1] + dj) ?? -1;
    this.pitch = sheet.pitch;
    this.neighbours = new Int32Array(4 * nNodes);
    for (let k = 0; k < nNodes; k++)
      this.neighbours.set([neighbour(k, -1, 0), neighbour(k, 1, 0), neighbour(k, 0, -1), neighbour(k, 0, 1)], 4 * k);
    this.values = new Float32Array(nNodes);
    /** Largest of them without regard to sign. */
    this.most = 0;
  }

  /** @param {Float32Array} nodes world, m @param {Float64Array} frame of the plate */
  update(nodes, frame) {
    const { neighbours, values } = this;
    this.most = 0;
    for (let k = 0; k < values.length; k++) {
      const a = neighbours[4 * k], b = neighbours[4 * k + 1], c = neighbours[4 * k + 2], d = neighbours[4 * k + 3];
      let nx = frame[2], ny = frame[5], nz = frame[8];
      const along = a >= 0 && b >= 0, across = c >= 0 && d >= 0;
      if (along && across) {
        const i = 3 * a, j = 3 * b, m = 3 * c, n = 3 * d;
        const ux = nodes[j] - nodes[i], uy = nodes[j + 1] - nodes[i + 1], uz = nodes[j + 2] - nodes[i + 2];
        const vx = nodes[n] - nodes[m], vy = nodes[n + 1] - nodes[m + 1], vz = nodes[n + 2] - nodes[m + 2];
        nx = uy * vz - uz * vy;
        ny = uz * vx - ux * vz;
        nz = ux * vy - uy * vx;
        const length = Math.sqrt(nx * nx + ny * ny + nz * nz) || 1;
        nx /= length;
        ny /= length;
        nz /= length;
      }
      let bent = 0;
      if (along) bent += second(nodes, a, k, b, nx, ny, nz);
      if (across) bent += second(nodes, c, k, d, nx, ny, nz);
      values[k] = -bent / (2 * this.pitch * this.pitch);
      this.most = Math.max(this.most, Math.abs(values[k]));
    }
  }
}

const second = (p, a, k, b, nx, ny, nz) =>
  nx * (p[3 * a] - 2 * p[3 * k] + p[3 * b]) + ny * (p[3 * a + 1] - 2 * p[3 * k + 1] + p[3 * b + 1]) +
  nz * (p[3 * a + 2] - 2 * p[3 * k + 2] + p[3 * b + 2]);
