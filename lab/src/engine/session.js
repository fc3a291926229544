// Runs that stay where they are: sheets of one lattice side by side, advanced piece by piece. As the package's
// engine/batch.py and simulation/session.py.
import { courseOf, goneOver, stillNeeded } from "../model/course.js";
import { AXES, SHORTEST_RAMP, poseAtStart } from "../model/motion.js";
import { featuresOf, packCourses, packParameters } from "../model/packing.js";
import { startPositions, strideOf, thinningOf } from "../model/recording.js";
import { roundHalfEven } from "../model/rounding.js";
import { checkScenario, latticeOf, timeStep } from "../model/scenario.js";
import { areCutAlike } from "../model/sheet.js";
import { LaidDownAnew, checkKick, checkOffset, checkSaved } from "./asked.js";
import { allFinite, byChannel, multiples, shapesOf } from "./piece.js";

const [TAKEN, , DUE, SAMPLED] = [0, 1, 2, 3]; // places in the core's clock
const AHEAD = 2; // tables of sampled trajectories reach so many times as far as the runs are advanced
const MOST_NUMBERS = 30e6; // that one advance may record
const NODE_NUMBERS = 3;
const PLATE_NUMBERS = 6;
const USUAL_RAMP = 0.1; // s: of a change to a motion that has none
// What the edge remembers of nodes that were on a plate that did not end yet (native/edge.hpp).
const ON_THE_PLATE = -2;

export class Session {
  /**
   * @param {import("./module.js").Engine} engine
   * @param {object[]} scenarios of like lattice
   * @param {{offsets?: number[][], snapshotInterval?: number}} [given] x, y, angle added to each start, m and rad; time
   *   between recorded shapes, s, 0 for none
   */
  constructor(engine, scenarios, { offsets = [], snapshotInterval = 0 } = {}) {
    scenarios.forEach(checkScenario);
    this.engine = engine;
    this.scenarios = [...scenarios];
    this.lattice = latticeOf(scenarios[0].sheet);
    if (scenarios.some(({ sheet }) => latticeOf(sheet) !== this.lattice))
      throw new Error("sheets of one lattice go side by side");
    this.courses = scenarios.map(({ motion }) => courseOf(motion));
    this.stride = scenarios.map((s) => strideOf(s));
    this.thinning = scenarios.map((s) => thinningOf(s, snapshotInterval));
    // A sample's time counts from where the stride was last changed.
    this.since = scenarios.map(() => ({ sample: 0, time: 0 }));
    this.wanted = scenarios.map(() => 0); // s asked for so far: durations add up exactly
    this.tabulated = scenarios.map(() => 0); // s that tables of sampled trajectories reach
    this.state = this.#start(offsets);
    this.packed = null;
  }

  #start(offsets) {
    const { engine, scenarios } = this;
    const [n, per] = [scenarios.length, 3 * this.lattice.nNodes];
    const x = new Float64Array(n * per);
    scenarios.forEach((s, j) => x.set(startPositions(s, offsets[j] && checkOffset(offsets[j])), j * per));
    return {
      x,
      v: new Float64Array(n * per),
      edge: new Float64Array(this.#ends() ? n * per : 0),
      tally: new Float64Array(n * engine.tallies),
      clock: new BigInt64Array(n * engine.clocks),
      last: new Float32Array(n * engine.names.channels.length).fill(NaN),
      diverged: scenarios.map(() => false),
    };
  }

  /** Whether some plate ends. */
  #ends() {
    return featuresOf(this.scenarios)[2] === 1;
  }

  #clock(run, which) {
    return Number(this.state.clock[run * this.engine.clocks + which]);
  }

  /** Time of a run, s. */
  time(run = 0) {
    return this.#clock(run, TAKEN) * timeStep(this.scenarios[run]);
  }

  /** Whether a run ceased to be finite: it goes on no further. */
  diverged(run = 0) {
    return this.state.diverged[run];
  }

  /**
   * Let all runs go on: for so many seconds, or by so many steps of each.
   *
   * @param {{seconds?: number, steps?: number[]}} how
   * @returns {import("./piece.js").Piece[]}
   */
  advance({ seconds = 0, steps }) {
    const { engine, scenarios, state } = this;
    const wanted = scenarios.map((s, j) => (steps ? this.time(j) + steps[j] * timeStep(s) : this.wanted[j] + seconds));
    const todo = scenarios.map((s, j) =>
      state.diverged[j] ? 0 : Math.max(0, steps?.[j] ?? roundHalfEven(wanted[j] / timeStep(s)) - this.#clock(j, TAKEN)),
    );
    if (!allFinite(todo)) throw new Error("no finite time to go on for");
    const [n, channels, per] = [scenarios.length, engine.names.channels.length, 3 * this.lattice.nNodes];
    const first = scenarios.map((_, j) => this.#clock(j, SAMPLED));
    const due = todo.map((count, j) => this.#samplesWithin(j, count));
    const maxSamples = Math.max(...due);
    const maxSnapshots = Math.max(...due.map((count, j) => this.#pictures(j, first[j], count)));
    if (n * (maxSamples * channels + maxSnapshots * per) > MOST_NUMBERS)
      throw new Error("more to record at once than a page has room for; try a shorter run, or fewer at once");
    const told = this.#told(todo);
    const before = scenarios.map((_, j) => this.#clock(j, TAKEN));
    const { samples, snapshots, ...next } = engine.with(
      { ...told.counts, max_samples: maxSamples, max_snapshots: maxSnapshots },
      {
        ...told.arrays,
        samples: { bytes: 4 * n * maxSamples * channels },
        snapshots: { bytes: 4 * n * maxSnapshots * per },
      },
      (table) => engine.core.plategait_advance(table),
      (view) => ({
        x: view(Float64Array, "x", n * per),
        v: view(Float64Array, "v", n * per),
        edge: view(Float64Array, "edge", state.edge.length),
        tally: view(Float64Array, "tally", n * engine.tallies),
        clock: view(BigInt64Array, "clock", n * engine.clocks),
        last: view(Float32Array, "last", n * channels),
        samples: view(Float32Array, "samples", n * maxSamples * channels),
        snapshots: view(Float32Array, "snapshots", n * maxSnapshots * per),
      }),
    );
    this.state = { ...next, diverged: state.diverged };
    this.wanted = wanted;
    const taken = before.map((from, j) => this.#clock(j, TAKEN) - from);
    this.state.diverged = scenarios.map(
      (_, j) => state.diverged[j] || taken[j] < todo[j] || !allFinite(next.x.subarray(j * per, (j + 1) * per)),
    );
    return scenarios.map((_, j) => {
      const from = j * maxSamples * channels;
      const written = Math.min(this.#clock(j, SAMPLED) - first[j], maxSamples);
      const own = samples.subarray(from, from + written * channels);
      return this.#piece(j, first[j], own, snapshots.subarray(j * maxSnapshots * per), taken[j]);
    });
  }

  /** @returns {import("./piece.js").Piece} */
  #piece(run, first, samples, snapshots, steps) {
    const channels = byChannel(samples, this.engine.names.channels);
    const { sample, time } = this.since[run];
    const interval = this.stride[run] * timeStep(this.scenarios[run]);
    // Counted in steps: the core's precision does not reach a long run's end.
    channels.time = Float64Array.from(channels.time, (_, k) => time + (first + k - sample) * interval);
    const pictured = this.#pictures(run, first, channels.time.length);
    return {
      channels,
      steps,
      diverged: this.state.diverged[run] || !allFinite(samples),
      snapshots: snapshots.slice(0, pictured * 3 * this.lattice.nNodes),
      ...shapesOf(channels, first, this.thinning[run], pictured),
    };
  }

  #samplesWithin(run, steps) {
    const [due, end] = [this.#clock(run, DUE), this.#clock(run, TAKEN) + steps];
    return due <= end && steps > 0 ? Math.floor((end - due) / this.stride[run]) + 1 : 0;
  }

  #pictures(run, first, samples) {
    return multiples(first + samples, this.thinning[run]) - multiples(first, this.thinning[run]);
  }

  /** Everything that the core reads before it takes steps, by the names of its table. */
  #told(steps) {
    const { lattice, scenarios, state } = this;
    scenarios.forEach((s, j) => {
      const reached = this.time(j) + steps[j] * timeStep(s);
      const needed = stillNeeded(this.courses[j], this.time(j));
      if (needed === this.courses[j] && reached <= this.tabulated[j]) return;
      this.courses[j] = needed;
      // Further than is needed now, or every piece would make them anew.
      if (reached > this.tabulated[j]) this.tabulated[j] = this.tabulated[j] > 0 ? AHEAD * reached : reached;
      this.packed = null;
    });
    this.packed ??= packCourses(scenarios, this.courses, this.tabulated);
    const { packed } = this;
    const [torsion, smooth, edge, ramp] = featuresOf(scenarios);
    const whole = (values) => BigInt64Array.from(values, BigInt);
    return {
      counts: {
        n_nodes: lattice.nNodes,
        n_lines: lattice.lineStart.length - 1,
        n_axial_lines: lattice.axial,
        n_cells: lattice.nCells,
        n_runs: scenarios.length,
        n_layers: packed.nLayers,
        n_terms: packed.termDof.length,
        has_torsion: torsion,
        has_smooth_friction: smooth,
        has_plate_edge: edge,
        has_contact_ramp: ramp,
      },
      arrays: {
        line_start: lattice.lineStart,
        line_nodes: lattice.lineNodes,
        cells: lattice.cells,
        rest: lattice.rest,
        mobility: new Float64Array(lattice.nNodes).fill(1),
        parameters: packParameters(this.engine.names.parameters, scenarios),
        layer_terms: packed.layerTerms,
        term_dof: packed.termDof,
        terms: packed.terms,
        layers: packed.layers,
        steps: whole(steps),
        stride: whole(this.stride),
        thinning: whole(this.thinning),
        x: state.x,
        v: state.v,
        edge: state.edge,
        tally: state.tally,
        clock: state.clock,
        last: state.last,
        ...(packed.knots.length ? { knots: packed.knots, first_knot: packed.firstKnot, n_knots: packed.nKnots } : {}),
      },
    };
  }

  /** Let the plate of a run go over to another motion from now on, within so many seconds. @throws {LaidDownAnew} */
  change(run, motion, ramp = motion?.ramp) {
    this.become(run, { ...this.scenarios[run], motion }, ramp);
  }

  /**
   * Let a run be another of the same lattice from now on, where it is; its plate goes over to the other's motion.
   *
   * @throws {LaidDownAnew} where it would want another lattice, a plate about another axis, or a shorter time step
   */
  become(run, scenario, ramp = scenario.motion?.ramp) {
    const step = timeStep(this.scenarios[run]);
    checkScenario({ ...scenario, time_step: null });
    if (!areCutAlike(scenario.sheet, this.scenarios[run].sheet)) throw new LaidDownAnew("a sheet of another lattice");
    if (scenario.motion.height !== this.scenarios[run].motion.height)
      throw new LaidDownAnew("a plate about another axis");
    const usual = timeStep({ ...scenario, time_step: null });
    if (usual < step * (1 - 1e-9)) throw new LaidDownAnew("what needs a shorter time step");
    const ended = this.#ends();
    if (JSON.stringify(scenario.motion) !== JSON.stringify(this.scenarios[run].motion))
      this.#goOver(run, scenario.motion, ramp);
    this.scenarios[run] = { ...scenario, time_step: step };
    if (this.#ends() && !ended) this.state.edge = this.state.x.map((_, k) => (k % 3 === 2 ? ON_THE_PLATE : 0));
    if (!this.#ends()) this.state.edge = new Float64Array(0);
    this.packed = null;
  }

  #goOver(run, motion, ramp) {
    const duration = Number.isFinite(ramp) && ramp > SHORTEST_RAMP ? ramp : USUAL_RAMP;
    this.courses[run] = goneOver(this.courses[run], motion, this.time(run), duration);
    const step = timeStep(this.scenarios[run]);
    const stride = strideOf({ ...this.scenarios[run], motion, time_step: step });
    if (stride === this.stride[run]) return;
    this.since[run] = { sample: this.#clock(run, SAMPLED), time: this.#clock(run, DUE) * step };
    this.stride[run] = stride;
  }

  /**
   * Add to the velocities of a run's nodes.
   *
   * @param {{velocity?: number[], spin?: number, at?: number[], radius?: number}} kick m/s along x, y, z; rad/s about
   *   the sheet's middle; where it is felt most and how far from there, m: everywhere alike where that is left out
   */
  push(run, kick) {
    const { velocity, spin, at, radius } = checkKick(kick);
    const [n, per] = [this.lattice.nNodes, 3 * this.lattice.nNodes];
    const x = this.state.x.subarray(run * per, (run + 1) * per);
    const v = this.state.v.slice();
    let [middleX, middleY] = [0, 0];
    for (let k = 0; k < n; k++) {
      middleX += x[3 * k] / n;
      middleY += x[3 * k + 1] / n;
    }
    for (let k = 0; k < n; k++) {
      const far = at ? Math.hypot(x[3 * k] - at[0], x[3 * k + 1] - at[1]) / radius : 0;
      const share = Math.exp(-far * far);
      const own = run * per + 3 * k;
      v[own] += share * velocity[0] - spin * (x[3 * k + 1] - middleY);
      v[own + 1] += share * velocity[1] + spin * (x[3 * k] - middleX);
      v[own + 2] += share * velocity[2];
    }
    this.state = { ...this.state, v };
  }

  /** Node positions of a run now, world frame, m: [node][x, y, z]. */
  nodes(run = 0) {
    const per = 3 * this.lattice.nNodes;
    return Float32Array.from(this.state.x.subarray(run * per, (run + 1) * per));
  }

  /** Pose of a run's plate now, m and rad. */
  platePose(run = 0) {
    if (this.#clock(run, TAKEN) === 0) return poseAtStart(this.scenarios[run].motion);
    const at = run * this.engine.names.channels.length;
    return AXES.map((axis) => this.state.last[at + this.engine.channel[`plate_${axis}`]]);
  }

  /**
   * What each node of the first run gets from the plate now, and the plate from them.
   *
   * @returns {{nodes: Float32Array, plate: Float32Array}} [node][normal, along x, along y], N; force, N, and torque
   *   about the middle of the surface, N m, both in the plate's frame
   */
  forces() {
    const n = this.lattice.nNodes;
    const told = this.#told(this.scenarios.map(() => 0));
    return this.engine.with(
      told.counts,
      { ...told.arrays, forces: { bytes: 4 * NODE_NUMBERS * n }, plate: { bytes: 4 * PLATE_NUMBERS } },
      (table, address) => this.engine.core.plategait_show(table, address.forces, address.plate),
      (view) => ({
        nodes: view(Float32Array, "forces", NODE_NUMBERS * n),
        plate: view(Float32Array, "plate", PLATE_NUMBERS),
      }),
    );
  }

  /** Where the runs are, to come back to. */
  save() {
    const { state, scenarios, courses, stride, since, wanted } = this;
    return structuredClone({ state, scenarios, courses, stride, since, wanted });
  }

  /** Go back to where the runs were. */
  restore(saved) {
    checkSaved(saved, this);
    Object.assign(this, structuredClone(saved), { tabulated: this.scenarios.map(() => 0), packed: null });
  }
}
