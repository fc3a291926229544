// One sheet that lives: a worker advances it a little ahead of what is shown, at the pace that was asked for.
import { Frames, Samples } from "./history.js";
import { wayTo } from "./change.js";

const PICTURES = 60; // a second at most
const MANY_NODES_PICTURES = 16; // a second, of a sheet of many nodes
const AHEAD = 0.15; // s of wall time that are kept ready
const A_PERIOD = 8; // frames that a plate period leaves to scrub through, of a sheet of few nodes
const FEW_NODES = 200;
const LEAST_CHUNK = 1e-3; // s of simulated time
const LONGEST_CHUNK = 0.06; // s of a worker's time in one go, so that changes are heard

/**
 * @typedef {{time: number, nodes: Float32Array, pose: number[], forces?: Float32Array, plate?: number[]}} Frame
 */
export class Live {
  /**
   * @param {{ask: (message: object) => Promise<any>, close: () => void}} worker
   * @param {string} key by which the worker knows the sheet
   * @param {{changed: () => void, refused: (message: string) => void}} told what happens is told to
   */
  constructor(worker, key, told) {
    Object.assign(this, { worker, key, told });
    this.speed = 1;
    this.playing = true;
    this.clock = 0;
    this.capacity = Infinity; // simulated seconds per second of the worker
    this.pace = { wall: 0, from: 0, speed: 0 };
    this.run = 0;
    this.ended = "";
    this.plan = [];
    this.script = [];
    this.frames = new Frames();
    this.samples = new Samples();
    this.queue = Promise.resolve();
    this.pending = false;
  }

  /**
   * Lay a sheet down, at rest, at time 0.
   *
   * @param {object} scenario
   * @param {{time: number, motion: object, within: number}[]} [told] what its plate will be told, in the order of times
   */
  start(scenario, told = []) {
    const run = ++this.run;
    this.scenario = scenario;
    this.plan = told;
    this.script = [...told];
    this.order(async () => {
      if (run !== this.run) return; // another was laid down meanwhile
      this.frames = new Frames();
      this.samples = new Samples();
      this.clock = 0;
      this.ended = "";
      this.pending = false;
      await this.worker.ask({ ask: "open", key: this.key, scenario });
      if (run === this.run) await this.advance(1e-9, 1);
    });
  }

  /** Let the sheet be told of a change where it is; laid down anew only where it cannot be. */
  become(scenario) {
    const way = wayTo(this.scenario, scenario);
    if (way === "anew" || this.ended) return this.start(scenario);
    this.scenario = scenario;
    this.plan = [];
    this.script = [];
    if (way === "motion")
      this.order(() => this.worker.ask({ ask: "change", key: this.key, motion: scenario.motion, ramp: scenario.motion.ramp }));
    if (way === "become") this.order(() => this.worker.ask({ ask: "become", key: this.key, scenario }));
    return undefined;
  }

  /** A kick: node velocities added to, m/s. */
  push(kick) {
    this.toTheEnd();
    this.order(() => this.worker.ask({ ask: "push", key: this.key, ...kick }));
  }

  /** One thing after the other; what the worker refuses is said and loses nothing. */
  order(work) {
    this.queue = this.queue.then(work).catch((error) => {
      this.pending = false;
      if (error.anew) this.start(this.scenario);
      else this.told.refused(error.message ?? String(error));
    });
    return this.queue;
  }

  /** Tell the plate what it is to be told by now; how long it is until it is told more, s. */
  async prompted() {
    const now = this.frames.last?.time ?? 0;
    while (this.script.length && this.script[0].time <= now + 1e-6) {
      const { motion, within } = this.script.shift();
      await this.worker.ask({ ask: "change", key: this.key, motion, ramp: within });
    }
    return this.script.length ? this.script[0].time - now : Infinity;
  }

  async advance(wanted, frames) {
    const run = this.run;
    this.pending = true;
    const seconds = Math.min(wanted, await this.prompted());
    const began = performance.now();
    const reply = await this.worker.ask({ ask: "advance", key: this.key, seconds, frames });
    this.pending = false;
    if (run !== this.run) return;
    const wall = (reply.wall ?? performance.now() - began) / 1000;
    const gone = reply.seconds ?? seconds; // less than was asked for where it took too long
    if (gone > 1e-6 && wall > 0) this.capacity = smoothed(this.capacity, gone / wall);
    this.samples.add(reply.samples);
    this.frames.add(reply.frames.filter((frame) => finite(frame.nodes)));
    if (reply.diverged || reply.frames.some((frame) => !finite(frame.nodes))) this.ended = "diverged";
    this.told.changed();
  }

  /** The pace that is possible, simulated seconds per second. */
  get possible() {
    return Math.min(this.speed, 0.85 * this.capacity);
  }

  /** Go on by what a picture takes; the frame to show. */
  tick(wall) {
    if (!this.frames.last) return null;
    if (this.playing) {
      this.clock = Math.min(this.clock + this.possible * Math.min(wall, 0.1), this.frames.last.time);
      const ready = this.frames.last.time - this.clock;
      if (!this.pending && !this.ended && ready < this.possible * AHEAD) {
        // However slow it seemed: of a few steps the pace is mostly that of asking for them.
        const chunk = Math.max(LEAST_CHUNK, LONGEST_CHUNK * this.capacity);
        const seconds = Math.max(1e-5, Math.min(this.speed * AHEAD, chunk));
        this.pending = true;
        this.order(() => this.advance(seconds, Math.max(1, Math.round(seconds * this.framesPerSecond))));
      }
    }
    this.measurePace();
    return this.frame;
  }

  /** Frames of a simulated second: those that are shown, and for few nodes more, to scrub through. */
  get framesPerSecond() {
    const few = (this.frames.last?.nodes.length ?? 0) <= 3 * FEW_NODES;
    // Of many nodes each picture costs as much as many steps: where all time went into pictures, no step would be taken.
    if (!few) return MANY_NODES_PICTURES / this.possible;
    return Math.max(PICTURES / this.possible, A_PERIOD * this.scenario.motion.frequency);
  }

  get frame() {
    return this.frames.list[this.frames.indexAt(this.clock)] ?? null;
  }

  /** What pace was reached, over a second. */
  measurePace() {
    const now = performance.now();
    if (now - this.pace.wall > 1000) {
      this.pace = { wall: now, from: this.clock, speed: Math.max(0, this.clock - this.pace.from) / ((now - this.pace.wall) / 1000) };
    }
  }

  /** A picture forward or back; at the end the sheet goes on by one sample of its plate's period. */
  step(by) {
    this.playing = false;
    const index = this.frames.indexAt(this.clock) + by;
    if (index < 0) return;
    if (index < this.frames.list.length) {
      this.clock = this.frames.list[index].time;
      this.told.changed();
    } else if (!this.pending && !this.ended) {
      this.order(async () => {
        await this.advance(1 / (24 * this.scenario.motion.frequency), 1);
        this.clock = this.frames.last?.time ?? 0;
        this.told.changed();
      });
    }
  }

  seek(time) {
    this.playing = false;
    this.clock = Math.min(Math.max(time, this.frames.first?.time ?? 0), this.frames.last?.time ?? 0);
    this.told.changed();
  }

  toTheEnd() {
    this.clock = this.frames.last?.time ?? 0;
  }

  close() {
    this.run++;
    this.order(() => this.worker.ask({ ask: "close", key: this.key }));
    this.worker.close();
  }
}

const smoothed = (before, now) => (Number.isFinite(before) ? 0.7 * before + 0.3 * now : now);

function finite(values) {
  for (let k = 0; k < values.length; k += 3) if (!Number.isFinite(values[k])) return false;
  return true;
}
