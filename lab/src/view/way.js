// Where the sheet's middle has been on the plate.

const MOST = 1200; // places
const SHORTEST = 2e-4; // m

/** Places on the plate, m, and when they were reached, s. */
export class Way {
  constructor(most = MOST) {
    this.most = most;
    this.places = new Float64Array(2 * (most + 1));
    this.times = new Float64Array(most + 1);
    this.count = 0;
  }

  clear() {
    this.count = 0;
  }

  /** What was reached later than a time is forgotten: the picture went back to it. */
  backTo(time) {
    let n = this.count;
    while (n > 0 && this.times[n - 1] > time) n--;
    const changed = n !== this.count;
    this.count = n;
    return changed;
  }

  /** Whether the place is far enough from the last one to count. */
  add(x, y, time) {
    const n = this.count;
    if (n > 0 && Math.hypot(x - this.places[2 * n - 2], y - this.places[2 * n - 1]) < SHORTEST) return false;
    if (n > this.most) this.forget(n >> 2);
    this.places[2 * this.count] = x;
    this.places[2 * this.count + 1] = y;
    this.times[this.count++] = time;
    return true;
  }

  /** The oldest go first. */
  forget(n) {
    this.places.copyWithin(0, 2 * n, 2 * this.count);
    this.times.copyWithin(0, n, this.count);
    this.count -= n;
  }
}
