// A run that was recorded elsewhere, played in a scene as a live sheet is.
import { Live } from "./live.js";
import { Frames, Samples } from "./history.js";

const NOBODY = { ask: async () => ({}), close: () => {} };

/** Has the face of `Live`, and what is there is all there is: nothing changes it, and at its end it begins again. */
export class Replay extends Live {
  /**
   * @param {object} scenario that it was a run of
   * @param {import("./live.js").Frame[]} frames in the order of their times
   * @param {Record<string, ArrayLike<number>>} channels
   * @param {{changed: () => void, refused: (message: string) => void}} told
   */
  constructor(scenario, frames, channels, told) {
    super(NOBODY, "replay", told);
    this.scenario = scenario;
    this.frames = new Frames();
    this.frames.list = frames;
    this.samples = new Samples();
    this.samples.add(channels);
    this.ended = "recorded";
    this.clock = frames[0]?.time ?? 0;
    this.recorded = true;
  }

  start() {
    this.clock = this.frames.first?.time ?? 0;
    this.told.changed();
  }

  become() {
    this.told.refused("A recorded run cannot be changed: change the sheet beside it");
  }

  push() {
    this.told.refused("A recorded run cannot be kicked: kick the sheet beside it");
  }

  tick(wall) {
    const frame = super.tick(wall);
    if (this.playing && frame && frame === this.frames.last) this.clock = this.frames.first.time;
    return frame;
  }
}
