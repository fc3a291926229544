// One sheet's picture on the page: canvas, what it does in words, and whose it is.
import { View } from "../view/view.js";
import { latticeOf } from "../model/scenario.js";
import { make } from "./elements.js";
import { inWords, reading } from "./reading.js";

const READ_EVERY = 100; // ms

export class Scene {
  constructor(parent, desk, index) {
    this.desk = desk;
    this.index = index;
    this.canvas = make("canvas", { tabIndex: 0, role: "img", "aria-label": "The sheet on its plate, in three dimensions" });
    this.word = make("p", { class: "word" });
    this.of = make("p", { class: "of" });
    this.element = make("div", { class: "scene" }, this.canvas, this.word, this.of);
    this.element.addEventListener("pointerdown", () => desk.select(index), true);
    parent.append(this.element);
    this.view = new View(this.canvas, { facts: desk.facts });
    this.view.onPush((kick) => desk.push(index, kick));
    this.read = null;
    this.readAt = 0;
    this.drawn = null;
    this.sheet = null;
  }

  get seat() {
    return this.desk.seats[this.index];
  }

  /** The scenario may be another. */
  changed() {
    const { scenario } = this.seat;
    const shape = JSON.stringify([scenario.sheet, scenario.plate, scenario.slip_limit, scenario.motion.height]);
    if (shape !== this.sheet) {
      this.sheet = shape;
      this.view.setSheet(scenario, latticeOf(scenario.sheet));
      this.drawn = null;
    }
    this.element.classList.toggle("selected", this.desk.seats.length > 1 && this.desk.selected === this.index);
    this.of.textContent = this.desk.seats.length > 1 ? `${"AB"[this.index]}: ${scenario.name}` : "";
  }

  /** Show where the sheet is after so much wall time, s; whether anything was drawn. */
  tick(wall) {
    const { live } = this.seat;
    const frame = live.tick(wall);
    this.look(live);
    if (!frame || frame === this.drawn) return false;
    if (frame.nodes.length !== 3 * latticeOf(this.seat.scenario.sheet).nNodes) return false; // of the sheet before
    this.drawn = frame;
    this.view.show(frame);
    return true;
  }

  /** Draw once more what is shown: a theme, a layer or the viewpoint is another. */
  repaint() {
    this.view.redraw();
  }

  look(live) {
    const now = performance.now();
    if (now - this.readAt < READ_EVERY) return;
    this.readAt = now;
    this.read = reading(live.scenario, live.samples, live.ended === "diverged");
    const text = live.recorded && live.samples.length < 4 ? "as recorded" : inWords(this.read);
    if (this.word.textContent !== text) {
      this.word.textContent = text;
      this.word.classList.toggle("failed", Boolean(this.read.failure));
      this.canvas.setAttribute("aria-label", `The sheet on its plate: ${text}`);
    }
  }

  close() {
    this.view.destroy();
    this.element.remove();
  }
}
