// What a worker answers to each question. Runs of like lattice go side by side, as many as the core has lanes.
import { Session } from "./session.js";
import { checkScenario, latticeOf, stepsOf, timeStep } from "../model/scenario.js";
import { observe } from "../simulation/observe.js";
import { starts } from "../simulation/ensemble.js";

const MOST_FRAMES = 600; // of one advance
const MOST_RUNS = 400; // of one question

export class Answers {
  constructor(engine) {
    this.engine = engine;
    this.sessions = new Map();
  }

  /** The reply to a question, and what of it is handed over rather than copied. */
  to(message, report = () => {}) {
    const id = message?.id;
    try {
      const work = { run: this.run, observe: this.observe, open: this.open, advance: this.advance, change: this.change,
        become: this.become, push: this.push, save: this.save, restore: this.restore, close: this.close }[message?.ask];
      if (!work) throw new Error(`nothing is known of “${String(message?.ask).slice(0, 20)}”`);
      const [reply, transfer = []] = work.call(this, message, report);
      return { reply: { id, ...reply }, transfer: [...new Set(transfer)] };
    } catch (error) {
      if (error instanceof WebAssembly.RuntimeError || error instanceof RangeError) this.#recover();
      const message_ = error instanceof WebAssembly.RuntimeError ? "the engine stopped: too large a sheet, or numbers beyond it" : String(error?.message ?? error);
      return { reply: { id, refused: { field: error?.field ?? null, message: message_, anew: Boolean(error?.anew) } }, transfer: [] };
    }
  }

  /** After a trap the module's memory cannot be trusted; where sheets are is kept outside of it. */
  #recover() {
    this.engine = this.engine.anew();
    for (const session of this.sessions.values()) session.engine = this.engine;
  }

  run({ scenarios, offsets, snapshotInterval = 0 }, report) {
    const recordings = this.#whole(scenarios, offsets, snapshotInterval, report);
    const transfer = recordings.flatMap((r) => [...Object.values(r.channels).map((c) => c.buffer), r.snapshots.buffer, r.platePose.buffer, r.snapshotTime.buffer]);
    return [{ told: "ran", recordings }, transfer];
  }

  observe({ scenarios, repeats = 1, seed = 0 }, report) {
    const many = scenarios.flatMap((scenario) => starts(repeats, seed).map((offset) => ({ scenario, offset })));
    const recordings = this.#whole(many.map((one) => one.scenario), many.map((one) => one.offset), 0, report);
    const observations = recordings.map((recording, k) => observe(many[k].scenario, recording));
    return [{ told: "observed", observations: scenarios.map((_, k) => observations.slice(k * repeats, (k + 1) * repeats)) }];
  }

  /** Whole runs, in the order of the scenarios. */
  #whole(scenarios, offsets, snapshotInterval, report) {
    if (!Array.isArray(scenarios) || !scenarios.length || scenarios.length > MOST_RUNS) throw new Error(`between 1 and ${MOST_RUNS} scenarios at once`);
    scenarios.forEach(checkScenario);
    const groups = new Map();
    scenarios.forEach((s, k) => {
      const lattice = latticeOf(s.sheet);
      groups.set(lattice, [...(groups.get(lattice) ?? []), k]);
    });
    const recordings = new Array(scenarios.length);
    let done = 0;
    for (const group of groups.values()) {
      // Side by side go runs of like length, so that no lane waits.
      group.sort((a, b) => stepsOf(scenarios[a]) - stepsOf(scenarios[b]) || a - b);
      for (let k = 0; k < group.length; k += this.engine.lanes) {
        const block = group.slice(k, k + this.engine.lanes);
        const session = new Session(this.engine, block.map((i) => scenarios[i]), { offsets: block.map((i) => offsets?.[i]), snapshotInterval });
        const told = session.advance({ steps: block.map((i) => stepsOf(scenarios[i])) });
        block.forEach((i, j) => (recordings[i] = told[j]));
        done += block.length;
        report(done / scenarios.length);
      }
    }
    return recordings;
  }

  open({ scenario, key }) {
    this.sessions.set(key, new Session(this.engine, [scenario]));
    return [{ told: "opened" }];
  }

  #session({ key }) {
    const session = this.sessions.get(key);
    if (!session) throw new Error("no such sheet: open it first");
    return session;
  }

  /** Frames evenly through so many seconds, each with what the plate gives and gets, and the samples on the way. */
  advance({ key, seconds, frames = 1, forces = true }) {
    const session = this.#session({ key });
    const step = timeStep(session.scenarios[0]);
    const total = Math.max(1, Math.round(seconds / step));
    const count = Math.max(1, Math.min(Math.round(frames), MOST_FRAMES, total));
    if (!Number.isFinite(total) || !Number.isFinite(count)) throw new Error("no finite time to go on for");
    const began = performance.now();
    const taken = [];
    const pieces = [];
    for (let k = 1; k <= count; k++) {
      const [piece] = session.advance({ steps: [Math.round((total * k) / count) - Math.round((total * (k - 1)) / count)] });
      pieces.push(piece.channels);
      const frame = { time: session.time(), nodes: session.nodes(), pose: session.platePose() };
      if (forces) {
        const felt = session.forces();
        Object.assign(frame, { forces: felt.nodes, plate: Array.from(felt.plate) });
      }
      taken.push(frame);
      if (piece.diverged) break;
    }
    const samples = joined(pieces);
    const transfer = [...taken.flatMap((f) => [f.nodes.buffer, ...(f.forces ? [f.forces.buffer] : [])]), ...Object.values(samples).map((c) => c.buffer)];
    return [{ told: "frames", frames: taken, samples, diverged: session.state.diverged[0], wall: performance.now() - began }, transfer];
  }

  change({ key, motion, ramp }) {
    this.#session({ key }).change(0, motion, ramp);
    return [{ told: "changed" }];
  }

  become({ key, scenario, ramp }) {
    this.#session({ key }).become(0, scenario, ramp);
    return [{ told: "become" }];
  }

  push({ key, velocity, spin, at, radius }) {
    this.#session({ key }).push(0, { velocity, spin, at, radius });
    return [{ told: "pushed" }];
  }

  save({ key }) {
    return [{ told: "saved", state: this.#session({ key }).save() }];
  }

  restore({ key, state }) {
    this.#session({ key }).restore(state);
    return [{ told: "restored" }];
  }

  close({ key }) {
    this.sessions.delete(key);
    return [{ told: "closed" }];
  }
}

function joined(pieces) {
  const samples = {};
  for (const name of Object.keys(pieces[0])) {
    const length = pieces.reduce((sum, piece) => sum + piece[name].length, 0);
    const whole = (samples[name] = new Float32Array(length));
    let at = 0;
    for (const piece of pieces) {
      whole.set(piece[name], at);
      at += piece[name].length;
    }
  }
  return samples;
}
