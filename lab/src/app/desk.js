// The desk: the sheets that live on the page, which of them the controls are about, and what happens to them.
import { checkScenario } from "../model/scenario.js";
import { naturalFrequency } from "../model/modes.js";
import { withValue } from "./change.js";
import { Live } from "./live.js";
import { openLive } from "../engine/pool.js";

const MOST_SHEETS = 2;

/** @typedef {{live: Live, scenario: object}} Seat */
export class Desk {
  /**
   * @param {{facts: object, payload: object, pool: object, makeWorker: () => Worker}} given
   */
  constructor({ facts, payload, pool, makeWorker }) {
    Object.assign(this, { facts, payload, pool, makeWorker });
    /** @type {Seat[]} */
    this.seats = [];
    this.selected = 0;
    this.speed = 1;
    this.playing = true;
    this.listeners = {};
    this.before = []; // scenarios to go back to
  }

  on(event, listener) {
    (this.listeners[event] ??= []).push(listener);
  }

  tell(event, ...what) {
    for (const listener of this.listeners[event] ?? []) listener(...what);
  }

  /** Scenario that the controls are about. */
  scenario() {
    return this.seats[this.selected].scenario;
  }

  lives() {
    return this.seats.map((seat) => seat.live);
  }

  /** One sheet more, beside those there are. */
  add(scenario) {
    if (this.seats.length >= MOST_SHEETS) return;
    const key = `sheet ${this.seats.length}`;
    const live = new Live(openLive(this.makeWorker), key, {
      changed: () => this.tell("frame"),
      refused: (message) => this.tell("notice", message),
    });
    live.start(scenario);
    this.sit(live, scenario);
  }

  /** A sheet that moves by itself, on the last seat: in the place of the second where there are two. */
  sit(live, scenario) {
    if (this.seats.length >= MOST_SHEETS) this.drop();
    live.speed = this.speed;
    live.playing = this.playing;
    this.seats.push({ live, scenario });
    this.tell("seats");
    this.tell("change");
  }

  /** Take the second sheet away. */
  drop() {
    if (this.seats.length < 2) return;
    this.seats.pop().live.close();
    this.selected = 0;
    this.tell("seats");
    this.tell("change");
  }

  select(index) {
    if (index === this.selected || index >= this.seats.length) return;
    this.selected = index;
    this.tell("select");
    this.tell("change");
  }

  /** Change one value; why it cannot be in one line, or null. */
  change(name, value) {
    try {
      this.put(withValue(this.scenario(), name, value));
      return null;
    } catch (error) {
      return `${error.field ? `${error.field}: ` : ""}${error.message}`;
    }
  }

  naturalFrequency() {
    try {
      return naturalFrequency(this.scenario().sheet);
    } catch {
      return NaN;
    }
  }

  /** Another scenario for the selected sheet, kept to be undone. Throws where it cannot be. */
  put(scenario) {
    checkScenario(scenario);
    const seat = this.seats[this.selected];
    if (this.before.at(-1)?.[1] !== seat.scenario) this.before.push([this.selected, seat.scenario]);
    if (this.before.length > 100) this.before.shift();
    seat.scenario = scenario;
    seat.live.become(scenario);
    this.tell("change");
  }

  /** Another scenario, laid down anew, and what its plate will be told; what is wrong with it is said. */
  set(scenario, told = []) {
    try {
      checkScenario(scenario);
    } catch (error) {
      this.tell("notice", `${error.field ? `${error.field}: ` : ""}${error.message}`);
      return false;
    }
    const seat = this.seats[this.selected];
    this.before.push([this.selected, seat.scenario]);
    seat.scenario = scenario;
    seat.live.start(scenario, told);
    this.play(true);
    this.tell("change");
    return true;
  }

  /** Show a motion that somebody pointed at. */
  watch(scenario) {
    if (this.set(scenario)) this.tell("watch");
  }

  undo() {
    const [index, scenario] = this.before.pop() ?? [];
    if (scenario === undefined || index >= this.seats.length) return;
    this.seats[index].scenario = scenario;
    this.seats[index].live.become(scenario);
    this.tell("change");
  }

  play(playing) {
    this.playing = playing;
    for (const live of this.lives()) live.playing = playing;
    this.tell("frame");
  }

  setSpeed(speed) {
    this.speed = speed;
    for (const live of this.lives()) live.speed = speed;
    this.tell("frame");
  }

  step(by) {
    this.playing = false;
    for (const live of this.lives()) live.step(by);
    this.tell("frame");
  }

  /** To a share of what is kept of the sheets' time. */
  seek(share) {
    this.playing = false;
    for (const live of this.lives()) {
      const { first, last } = live.frames;
      if (first && last) live.seek(first.time + share * (last.time - first.time));
    }
    this.tell("frame");
  }

  restart() {
    for (const { live, scenario } of this.seats) live.start(scenario, live.plan);
    this.play(true);
  }

  push(index, kick) {
    this.seats[index].live.push(kick);
    this.play(true);
  }
}

