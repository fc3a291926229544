// What a worker answers to each question. Runs of like lattice go side by side, as many as the core has lanes.
import { checkScenario, latticeOf, timeStep } from "../model/scenario.js";
import { stepsOf } from "../model/recording.js";
import { Refusal } from "../model/refusal.js";
import { starts } from "../simulation/ensemble.js";
import { observe } from "../simulation/observe.js";
import { allFinite, joined } from "./piece.js";
import { Session } from "./session.js";

const MOST_FRAMES = 600; // of one advance
const MOST_RUNS = 400; // of one question
const MOST_SESSIONS = 16;
const MOST_NODE_STEPS = 1e9; // of one run: some minutes
const NODE_STEPS_A_CALL = 2e5; // some 30 ms
const LONGEST_ADVANCE = 400; // ms of a worker's time: what was not reached by then is left for the next question

const QUESTIONS = ["run", "observe", "open", "advance", "change", "become", "push", "save", "restore", "close"];

export class Answers {
  /** @param {import("./module.js").Engine} engine */
  constructor(engine) {
    this.engine = engine;
    this.sessions = new Map();
  }

  /**
   * The reply to a question, and what of it is handed over rather than copied; never an exception.
   *
   * @param {any} message
   * @param {(fraction: number) => void} [report]
   * @returns {{reply: object, transfer: ArrayBuffer[]}}
   */
  to(message, report = () => {}) {
    const id = message?.id;
    try {
      if (!QUESTIONS.includes(message?.ask))
        throw new Error(`nothing is known of "${String(message?.ask).slice(0, 20)}"; try "run"`);
      const { arrays = [], ...reply } = this[message.ask](message, report);
      return { reply: { id, ...reply }, transfer: [...new Set(arrays.map((array) => array.buffer))] };
    } catch (error) {
      const trapped = error instanceof WebAssembly.RuntimeError;
      if (trapped || error instanceof RangeError) this.#recover();
      const said = trapped
        ? "the engine stopped: too large a sheet, or numbers beyond it"
        : String(error?.message ?? error);
      return {
        reply: { id, refused: { field: error?.field ?? null, message: said, anew: Boolean(error?.anew) } },
        transfer: [],
      };
    }
  }

  /** After a trap the module's memory cannot be trusted; where sheets are is kept outside of it. */
  #recover() {
    this.engine = this.engine.anew();
    for (const session of this.sessions.values()) session.engine = this.engine;
  }

  run({ scenarios, offsets = [], snapshotInterval = 0 }, report) {
    const recordings = this.#whole(listed(scenarios), offsets, snapshotInterval, report);
    const arrays = recordings.flatMap((r) => [...Object.values(r.channels), r.snapshots, r.platePose, r.snapshotTime]);
    return { told: "ran", recordings, arrays };
  }

  observe({ scenarios, repeats = 1, seed = 0 }, report) {
    if (!Number.isInteger(repeats) || repeats < 1 || repeats > MOST_RUNS)
      throw new Error(`repeats: a whole number from 1 to ${MOST_RUNS}; try 4`);
    const offsets = starts(repeats, seed);
    const many = listed(scenarios).flatMap((scenario) => offsets.map((offset) => ({ scenario, offset })));
    const recordings = this.#whole(
      many.map(({ scenario }) => scenario),
      many.map(({ offset }) => offset),
      0,
      report,
    );
    const observations = recordings.map((recording, k) => observe(many[k].scenario, recording));
    return {
      told: "observed",
      observations: scenarios.map((_, k) => observations.slice(k * repeats, (k + 1) * repeats)),
    };
  }

  /** Whole runs, in the order of the scenarios. */
  #whole(scenarios, offsets, snapshotInterval, report) {
    if (scenarios.length > MOST_RUNS) throw new Error(`${scenarios.length} runs at once; try at most ${MOST_RUNS}`);
    scenarios.forEach(checkRun);
    const groups = new Map();
    scenarios.forEach(({ sheet }, k) => groups.set(latticeOf(sheet), [...(groups.get(latticeOf(sheet)) ?? []), k]));
    const recordings = new Array(scenarios.length);
    let done = 0;
    for (const group of groups.values()) {
      // Side by side go runs of like length, so that no lane waits.
      group.sort((a, b) => stepsOf(scenarios[a]) - stepsOf(scenarios[b]) || a - b);
      for (let k = 0; k < group.length; k += this.engine.lanes) {
        const block = group.slice(k, k + this.engine.lanes);
        const session = new Session(
          this.engine,
          block.map((i) => scenarios[i]),
          { offsets: block.map((i) => offsets[i]), snapshotInterval },
        );
        const pieces = session.advance({ steps: block.map((i) => stepsOf(scenarios[i])) });
        block.forEach((i, j) => (recordings[i] = pieces[j]));
        done += block.length;
        report(done / scenarios.length);
      }
    }
    return recordings;
  }

  open({ scenario, key }) {
    if (!this.sessions.has(key) && this.sessions.size >= MOST_SESSIONS)
      throw new Error(`at most ${MOST_SESSIONS} sheets at once; close one first`);
    this.sessions.set(key, new Session(this.engine, [scenario]));
    return { told: "opened" };
  }

  #session({ key }) {
    const session = this.sessions.get(key);
    if (!session) throw new Error("no such sheet; open it first");
    return session;
  }

  /**
   * Frames evenly through so many seconds, each with what the plate gives and gets, and the samples on the way. Fewer
   * frames where they take too long: `seconds` tells how far the sheet has come.
   */
  advance({ key, seconds, frames = 1, forces = true }) {
    const session = this.#session({ key });
    const [began, from, shown, pieces] = [performance.now(), session.time(), [], []];
    const steps = Math.max(1, Math.round(seconds / timeStep(session.scenarios[0])));
    const count = Math.max(1, Math.min(Math.round(frames), MOST_FRAMES, steps));
    if (!Number.isFinite(steps) || !Number.isFinite(count))
      throw new Error("no finite time to go on for; try seconds: 0.1");
    for (let k = 0; k < count && !session.diverged(); k++) {
      const own = Math.round((steps * (k + 1)) / count) - Math.round((steps * k) / count);
      pieces.push(...stepped(session, own, began));
      const frame = { time: session.time(), nodes: session.nodes(), pose: session.platePose() };
      if (forces) {
        const { nodes, plate } = session.forces();
        Object.assign(frame, { forces: nodes, plate: Array.from(plate) });
      }
      // What is no number is told by `diverged`, and not shown.
      if (!session.diverged() && allFinite(frame.nodes)) shown.push(frame);
      if (performance.now() - began > LONGEST_ADVANCE) break;
    }
    const samples = pieces.length ? joined(pieces) : {};
    const arrays = [
      ...shown.flatMap(({ nodes, forces: felt }) => (felt ? [nodes, felt] : [nodes])),
      ...Object.values(samples),
    ];
    const [gone, wall] = [session.time() - from, performance.now() - began];
    return { told: "frames", frames: shown, samples, diverged: session.diverged(), seconds: gone, wall, arrays };
  }

  change({ key, motion, ramp }) {
    this.#session({ key }).change(0, motion, ramp);
    return { told: "changed" };
  }

  become({ key, scenario, ramp }) {
    this.#session({ key }).become(0, scenario, ramp);
    return { told: "become" };
  }

  push({ key, ...kick }) {
    this.#session({ key }).push(0, kick);
    return { told: "pushed" };
  }

  save({ key }) {
    return { told: "saved", state: this.#session({ key }).save() };
  }

  restore({ key, state }) {
    this.#session({ key }).restore(state);
    return { told: "restored" };
  }

  close({ key }) {
    this.sessions.delete(key);
    return { told: "closed" };
  }
}

const listed = (scenarios) => {
  if (!Array.isArray(scenarios) || !scenarios.length) throw new Error("scenarios: a list of one at least");
  return scenarios;
};

/** A scenario that a page can run to its end. */
const checkRun = (s) => {
  checkScenario(s);
  const nodeSteps = stepsOf(s) * latticeOf(s.sheet).nNodes;
  if (nodeSteps <= MOST_NODE_STEPS) return;
  const most = Number(((s.duration * MOST_NODE_STEPS) / nodeSteps).toPrecision(2));
  throw new Refusal(
    "duration",
    `${s.duration} s`,
    `at most ${most} s of such a sheet in a page`,
    `${Math.min(4, most)} s`,
  );
};

/** Samples of some steps of a session, in calls short enough to look at the clock between them. */
const stepped = (session, steps, began) => {
  const most = Math.max(1, Math.floor(NODE_STEPS_A_CALL / session.lattice.nNodes));
  const pieces = [];
  for (let left = steps; left > 0 && !session.diverged(); left -= most) {
    pieces.push(session.advance({ steps: [Math.min(left, most)] })[0].channels);
    if (performance.now() - began > LONGEST_ADVANCE) break;
  }
  return pieces;
};
