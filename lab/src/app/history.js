// What a live sheet has shown so far: its frames, to scrub through, and the samples of its channels.

const MOST_BYTES = 64e6;
const MOST_FRAMES = 6000;
const MOST_SAMPLES = 60_000;

/** Frames in the order of their times; the oldest are dropped where they take too much memory. */
export class Frames {
  constructor() {
    this.list = [];
  }

  get first() {
    return this.list[0] ?? null;
  }

  get last() {
    return this.list.at(-1) ?? null;
  }

  add(frames) {
    this.list.push(...frames);
    const each = (this.last?.nodes.byteLength ?? 0) * 2 + 200;
    const most = Math.max(120, Math.min(MOST_FRAMES, Math.floor(MOST_BYTES / each)));
    // Dropped by quarters: a list is moved each time.
    if (this.list.length > 1.25 * most) this.list.splice(0, this.list.length - most);
  }

  /** Number of the last frame that is not after a time. */
  indexAt(time) {
    let [low, high] = [0, this.list.length - 1];
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.list[middle].time <= time + 1e-9) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  /** Forget what comes after a time: the sheet goes on from there. */
  cutAfter(time) {
    this.list.length = Math.min(this.list.length, this.indexAt(time) + 1);
  }
}

// Channels that hold amounts since the sample before: what is forgotten of them is in the next that is kept.
const AMOUNTS = new Set(["joint_loss", "contact_work", "friction_loss", "plate_work"]);

/** Samples of all channels side by side, growing; of a long run the middle is forgotten, and never the first. */
export class Samples {
  constructor() {
    this.length = 0;
    this.channels = {};
  }

  add(samples) {
    const more = samples.time?.length ?? 0;
    for (const [name, values] of Object.entries(samples)) {
      const held = this.channels[name];
      if (!held || held.length < this.length + more) {
        const grown = new Float32Array(Math.max(4096, 2 * (this.length + more)));
        if (held) grown.set(held.subarray(0, this.length));
        this.channels[name] = grown;
      }
      this.channels[name].set(values, this.length);
    }
    this.length += more;
    if (this.length > MOST_SAMPLES) {
      const gone = this.length - MOST_SAMPLES / 2;
      for (const [name, values] of Object.entries(this.channels)) {
        if (AMOUNTS.has(name)) values[1 + gone] += values.subarray(1, 1 + gone).reduce((sum, value) => sum + value, 0);
        values.copyWithin(1, 1 + gone, this.length);
      }
      this.length -= gone;
    }
  }

  /** All channels, as far as there are samples: views, not copies. */
  all() {
    return this.from(0);
  }

  /** All channels from a sample on. */
  from(begin) {
    const views = {};
    for (const [name, values] of Object.entries(this.channels)) views[name] = values.subarray(begin, this.length);
    return views;
  }

  /** Number of the first sample after a time. */
  indexAfter(time) {
    const times = this.channels.time;
    let begin = this.length;
    while (begin > 0 && times[begin - 1] > time) begin--;
    return begin;
  }
}
