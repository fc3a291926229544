// How fine a moving picture can be where the processor draws: coarser when pictures are not finished before the next.

const BUDGETS = [600e3, 420e3, 300e3, 200e3]; // pixels of a moving picture
const STILL = 2.6e6; // pixels of one that stands still
const PATIENCE = 28; // ms; a picture that takes longer is late
const LATE = 8; // so many more late ones than others, and the pictures are made coarser
const GOOD = 150; // so many in a row in time, and they are made finer again; twice as many each time that it was tried

/** Judges pictures by whether the one before was finished when the next was begun. */
export class Pace {
  constructor() {
    this.step = 0;
    this.late = 0;
    this.good = 0;
    this.needed = GOOD;
    this.began = 0;
  }

  /** Pixels over CSS px that a moving picture of so many CSS px should have, on a screen with so many. */
  moving(area, pixels) {
    return Math.min(pixels, Math.sqrt(BUDGETS[this.step] / area));
  }

  /** The same of a picture that stands still: its edges are smoothed by drawing it twice as fine as the screen. */
  still(area, pixels) {
    return Math.min(2 * pixels, Math.sqrt(STILL / area));
  }

  /**
   * A picture is begun.
   * @param {number} now ms
   * @param {boolean} finished whether the one before was
   * @returns {boolean} whether pictures should be coarser or finer from now on
   */
  next(now, finished) {
    const took = now - this.began;
    this.began = now;
    if (took > 20 * PATIENCE) return false; // nothing moved
    this.good = finished ? this.good + 1 : 0;
    if (took >= PATIENCE) this.late = Math.max(0, this.late + (finished ? -1 : 1));
    const coarser = this.late >= LATE && this.step < BUDGETS.length - 1;
    const finer = this.good >= this.needed && this.step > 0;
    if (!coarser && !finer) return false;
    this.step += coarser ? 1 : -1;
    if (finer) this.needed *= 2;
    this.late = this.good = 0;
    return true;
  }
}
