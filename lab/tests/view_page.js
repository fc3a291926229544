// Shows frames in the picture alone, as a test tells it to: bundled with view.js into view_page.html.
import { latticeOf } from "../src/model/scenario.js";
import { View } from "../src/view/view.js";

const numbers = (text) => new Float32Array(Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer);

const unpack = (run) => {
  const nodes = numbers(run.nodes), pose = numbers(run.pose), forces = numbers(run.forces);
  const part = (values, k) => values.subarray((k * values.length) / run.count, ((k + 1) * values.length) / run.count);
  const frame = (time, k) => ({ time, nodes: part(nodes, k), pose: part(pose, k), forces: part(forces, k) });
  return { ...run, frames: run.time.map(frame) };
};

globalThis.harness = {
  view: null,
  pushes: [],
  open() {
    this.view = new View(document.getElementById("picture"));
    this.view.onPush((push) => this.pushes.push(push));
    return this.view;
  },
  lay(run) {
    this.run = unpack(run);
    this.view.setSheet(this.run.scenario, latticeOf(this.run.scenario.sheet));
  },
  show(k) {
    return this.view.show(this.run.frames[k]);
  },
  /** Show a frame with the way up to it; only the last is drawn. */
  play(last) {
    for (let k = 0; k < last; k++) if (!this.view.shown.take(this.run.frames[k])) return false;
    return this.show(last);
  },
  /** Draw as a picture that stands still, without waiting for it. */
  still() {
    this.view.frame();
    this.view.drawn = 0;
    this.view.settle();
  },
  /** Milliseconds a picture, until its pixels can be read, and those that the main thread is busy with it. */
  measure(pictures) {
    const gl = this.view.canvas.getContext("webgl2"), pixel = new Uint8Array(4), times = [], busy = [];
    for (let k = 0; k < pictures; k++) {
      const began = performance.now();
      this.show(k % this.run.frames.length);
      busy.push(performance.now() - began);
      gl?.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
      times.push(performance.now() - began);
    }
    const part = (list, share) => list.slice(5).sort((a, b) => a - b)[Math.floor((list.length - 5) * share)];
    return { picture: part(times, 0.5), least: part(times, 0.1), busy: part(busy, 0.5) };
  },
  /** Pictures a second that the screen gets, one shown each time that it asks. */
  pace(seconds) {
    return new Promise((resolve) => {
      const began = performance.now();
      let shown = 0;
      const next = () => {
        this.show(shown++ % this.run.frames.length);
        const past = (performance.now() - began) / 1000;
        if (past < seconds) requestAnimationFrame(next);
        else resolve(shown / past);
      };
      requestAnimationFrame(next);
    });
  },
};
