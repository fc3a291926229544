// How fine a moving picture can be where the processor draws: coarser when pictures are not finished before the next.

const RATIOS = [1, 0.85, 0.72, 0.6]; // pixels over CSS px
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

  /** Pixels over CSS px that moving pictures should have. */
  get ratio() {
    return RATIOS[this.step];
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
    const coarser = this.late >= LATE && this.step < RATIOS.length - 1, finer = this.good >= this.needed && this.step > 0;
    if (!coarser && !finer) return false;
    this.step += coarser ? 1 : -1;
    if (finer) this.needed *= 2;
    this.late = this.good = 0;
    return true;
  }
}
