// Runs that stay where they are: sheets of one lattice side by side, advanced piece by piece. As the package's
// engine/batch.py.
import { courseOf, goneOver, stillNeeded } from "../model/course.js";
import { AXES } from "../model/motion.js";
import { featuresOf, packCourses, packParameters } from "../model/packing.js";
import { checkScenario, latticeOf, startPositions, strideOf, thinningOf, timeStep } from "../model/scenario.js";

const [TAKEN, , DUE, SAMPLED] = [0, 1, 2, 3]; // places in the core's clock
const AHEAD = 2; // tables of sampled trajectories reach so many times as far as the runs are advanced
const MOST_NUMBERS = 30e6; // that one advance may record
const NODE_NUMBERS = 3;
const PLATE_NUMBERS = 6;
const GONE = -2; // what the edge remembers of nodes that were never over it (native/edge.hpp)

/** A change that a sheet under way cannot be told of: it would want another lattice, or a shorter time step. */
export class LaidDownAnew extends Error {
  constructor(what) {
    super(`${what} must be laid down anew`);
    this.anew = true;
  }
}

export class Session {
  /**
   * @param {import("./module.js").Engine} engine
   * @param {object[]} scenarios of like lattice
   * @param {{offsets?: number[][], snapshotInterval?: number}} [given] what is added to each start, m and rad
   */
  constructor(engine, scenarios, { offsets = [], snapshotInterval = 0 } = {}) {
    scenarios.forEach(checkScenario);
    this.engine = engine;
    this.scenarios = [...scenarios];
    this.lattice = latticeOf(scenarios[0].sheet);
    this.courses = scenarios.map((s) => courseOf(s.motion));
    this.stride = scenarios.map((s) => strideOf(s));
    this.thinning = scenarios.map((s) => thinningOf(s, snapshotInterval));
    this.tabulated = scenarios.map(() => 0);
    const n = scenarios.length;
    const per = 3 * this.lattice.nNodes;
    const starts = scenarios.map((s, j) => startPositions(s, offsets[j]));
    const x = new Float64Array(n * per);
    starts.forEach((start, j) => x.set(start, j * per));
    this.state = {
      x, v: new Float64Array(n * per), edge: this.features()[2] ? new Float64Array(n * per) : new Float64Array(0),
      tally: new Float64Array(n * engine.tallies), clock: new BigInt64Array(n * engine.clocks),
      last: new Float32Array(n * engine.names.channels.length).fill(NaN), diverged: scenarios.map(() => false),
    };
  }

  features() {
    return featuresOf(this.scenarios);
  }

  clockOf(run, which) {
    return Number(this.state.clock[run * this.engine.clocks + which]);
  }

  /** Time of a run, s. */
  time(run = 0) {
    return this.clockOf(run, TAKEN) * timeStep(this.scenarios[run]);
  }

  /**
   * Take steps: so many of each run, or for so many seconds.
   *
   * @param {{seconds?: number, steps?: number[]}} how
   * @returns {{channels: Record<string, Float32Array>, snapshots: Float32Array, snapshotTime: Float64Array, steps: number, diverged: boolean}[]}
   */
  advance({ seconds, steps }) {
    const { engine, scenarios, state, lattice } = this;
    const n = scenarios.length;
    const wanted = (steps ?? scenarios.map((s) => Math.max(1, Math.round(seconds / timeStep(s))))).map((count, j) => (state.diverged[j] ? 0 : count));
    const due = scenarios.map((_, j) => this.#samplesWithin(j, wanted[j]));
    const first = scenarios.map((_, j) => this.clockOf(j, SAMPLED));
    const pictures = scenarios.map((_, j) => multiples(first[j] + due[j], this.thinning[j]) - multiples(first[j], this.thinning[j]));
    const [maxSamples, maxSnapshots] = [Math.max(...due), Math.max(...pictures)];
    const channels = engine.names.channels.length;
    const per = 3 * lattice.nNodes;
    if (n * (maxSamples * channels + maxSnapshots * per) > MOST_NUMBERS) throw new Error("too much to record at once: a shorter run, or fewer at once");
    const before = scenarios.map((_, j) => this.clockOf(j, TAKEN));
    const told = this.#told(wanted);
    const out = engine.with(
      { ...told.counts, max_samples: maxSamples, max_snapshots: maxSnapshots },
      { ...told.arrays, samples: { bytes: 4 * n * maxSamples * channels }, snapshots: { bytes: 4 * n * maxSnapshots * per } },
      (table) => engine.core.plategait_advance(table),
      (view) => ({
        x: view(Float64Array, "x", n * per), v: view(Float64Array, "v", n * per), edge: view(Float64Array, "edge", state.edge.length),
        tally: view(Float64Array, "tally", n * engine.tallies), clock: view(BigInt64Array, "clock", n * engine.clocks),
        last: view(Float32Array, "last", n * channels), samples: view(Float32Array, "samples", n * maxSamples * channels),
        snapshots: view(Float32Array, "snapshots", n * maxSnapshots * per),
      }),
    );
    const { samples, snapshots, ...next } = out;
    this.state = { ...next, diverged: scenarios.map((_, j) => state.diverged[j] || Number(next.clock[j * engine.clocks + TAKEN]) - before[j] < wanted[j]) };
    return scenarios.map((s, j) => {
      const written = Math.min(this.clockOf(j, SAMPLED) - first[j], maxSamples);
      const own = samples.subarray(j * maxSamples * channels, (j * maxSamples + written) * channels);
      const pictured = multiples(first[j] + written, this.thinning[j]) - multiples(first[j], this.thinning[j]);
      const time = own.length ? byChannel(own, engine.names.channels) : byChannel(new Float32Array(0), engine.names.channels);
      return {
        channels: time, steps: this.clockOf(j, TAKEN) - before[j], diverged: this.state.diverged[j],
        snapshots: snapshots.slice(j * maxSnapshots * per, (j * maxSnapshots + pictured) * per),
        ...shownAt(time, first[j], this.thinning[j], pictured),
      };
    });
  }

  #samplesWithin(run, steps) {
    const [due, end] = [this.clockOf(run, DUE), this.clockOf(run, TAKEN) + steps];
    return due <= end && steps > 0 ? Math.floor((end - due) / this.stride[run]) + 1 : 0;
  }

  /** Everything that the core reads before it takes steps, by the names of its table. */
  #told(steps) {
    const { lattice, scenarios, state } = this;
    scenarios.forEach((s, j) => {
      const time = this.time(j);
      this.courses[j] = stillNeeded(this.courses[j], time);
      const reached = time + steps[j] * timeStep(s);
      if (reached > this.tabulated[j]) this.tabulated[j] = AHEAD * reached;
    });
    const course = packCourses(scenarios, this.courses, this.tabulated);
    const [torsion, smooth, edge, ramp] = this.features();
    const whole = (values) => BigInt64Array.from(values, BigInt);
    return {
      counts: {
        n_nodes: lattice.nNodes, n_lines: lattice.lineStart.length - 1, n_axial_lines: lattice.axial, n_cells: lattice.nCells,
        n_runs: scenarios.length, n_layers: course.nLayers, n_terms: course.termDof.length,
        has_torsion: torsion, has_smooth_friction: smooth, has_plate_edge: edge, has_contact_ramp: ramp,
      },
      arrays: {
        line_start: lattice.lineStart, line_nodes: lattice.lineNodes, cells: lattice.cells, rest: lattice.rest,
        mobility: new Float64Array(lattice.nNodes).fill(1),
        parameters: packParameters(this.engine.names.parameters, scenarios),
        layer_terms: course.layerTerms, term_dof: course.termDof, terms: course.terms, layers: course.layers,
        steps: whole(steps), stride: whole(this.stride), thinning: whole(this.thinning),
        x: state.x, v: state.v, edge: state.edge, tally: state.tally, clock: state.clock, last: state.last,
        ...(course.knots.length ? { knots: course.knots, first_knot: course.firstKnot, n_knots: course.nKnots } : {}),
      },
    };
  }

  /** Let the plate of a run go over to another motion from now on, within so many seconds. */
  change(run, motion, ramp = 0.1) {
    const step = timeStep(this.scenarios[run]);
    const scenario = { ...this.scenarios[run], motion: { ...motion, height: this.scenarios[run].motion.height } };
    checkScenario({ ...scenario, time_step: null });
    if (timeStep({ ...scenario, time_step: null }) < step * (1 - 1e-9)) throw new LaidDownAnew("a plate as fast");
    this.courses[run] = goneOver(this.courses[run], motion, this.time(run), ramp);
    this.scenarios[run] = { ...scenario, time_step: step };
    this.stride[run] = strideOf(this.scenarios[run], motion);
  }

  /** Let a run be another of the same lattice from now on, where it is; its plate goes over to the other's motion. */
  become(run, scenario, ramp = 0.1) {
    const step = timeStep(this.scenarios[run]);
    checkScenario(scenario);
    if (latticeOf(scenario.sheet) !== this.lattice) throw new LaidDownAnew("a sheet of another lattice");
    if (timeStep({ ...scenario, time_step: null }) < step * (1 - 1e-9)) throw new LaidDownAnew("a sheet as stiff");
    const hadEdge = this.features()[2];
    this.courses[run] = goneOver(this.courses[run], scenario.motion, this.time(run), ramp);
    this.scenarios[run] = { ...scenario, time_step: step };
    this.stride[run] = strideOf(this.scenarios[run], scenario.motion);
    if (this.features()[2] && !hadEdge) this.state.edge = forgotten(this.state.x.length);
    if (!this.features()[2]) this.state.edge = new Float64Array(0);
  }

  /**
   * Add to the velocities of a run's nodes.
   *
   * @param {{velocity?: number[], spin?: number, at?: number[], radius?: number}} kick m/s along x, y, z; rad/s about the
   *   sheet's middle; where it is felt most and how far, m: everywhere alike where that is left out
   */
  push(run, { velocity = [0, 0, 0], spin = 0, at = null, radius = 0.02 }) {
    const numbers = [...velocity, spin, radius, ...(at ?? [])];
    if (!numbers.every((value) => Number.isFinite(value) && Math.abs(value) < 100)) throw new Error("a kick of no finite, sensible speed");
    const per = 3 * this.lattice.nNodes;
    const x = this.state.x.subarray(run * per, (run + 1) * per);
    const v = this.state.v.subarray(run * per, (run + 1) * per);
    const n = this.lattice.nNodes;
    const [mx, my] = [0, 1].map((a) => {
      let sum = 0;
      for (let k = 0; k < n; k++) sum += x[3 * k + a];
      return sum / n;
    });
    for (let k = 0; k < n; k++) {
      const far = at ? Math.hypot(x[3 * k] - at[0], x[3 * k + 1] - at[1]) / radius : 0;
      const share = Math.exp(-far * far);
      v[3 * k] += share * (velocity[0] ?? 0) - spin * (x[3 * k + 1] - my);
      v[3 * k + 1] += share * (velocity[1] ?? 0) + spin * (x[3 * k] - mx);
      v[3 * k + 2] += share * (velocity[2] ?? 0);
    }
  }

  /** Node positions of a run now, world frame, m: [node][x, y, z]. */
  nodes(run = 0) {
    const per = 3 * this.lattice.nNodes;
    return Float32Array.from(this.state.x.subarray(run * per, (run + 1) * per));
  }

  /** Pose of a run's plate at its last sample or end, m and rad. */
  platePose(run = 0) {
    const at = run * this.engine.names.channels.length;
    const pose = AXES.map((axis) => this.state.last[at + this.engine.channel[`plate_${axis}`]]);
    return pose.every(Number.isFinite) ? pose : [0, 0, 0, 0, 0, 0];
  }

  /** What each node gets from the plate now, [node][normal, along x, along y], N, and the plate: force, N, and torque, N m. */
  forces(run = 0) {
    const only = run === 0 && this.scenarios.length === 1 ? this : this.#alone(run);
    const n = this.lattice.nNodes;
    const told = only.#told([0]);
    return this.engine.with(
      told.counts,
      { ...told.arrays, forces: { bytes: 4 * NODE_NUMBERS * n }, plate: { bytes: 4 * PLATE_NUMBERS } },
      (table, address) => this.engine.core.plategait_show(table, address.forces, address.plate),
      (view) => ({ nodes: view(Float32Array, "forces", NODE_NUMBERS * n), plate: view(Float32Array, "plate", PLATE_NUMBERS) }),
    );
  }

  #alone(run) {
    const other = Object.create(Session.prototype);
    const pick = (values, per) => values.slice(run * per, (run + 1) * per);
    const per = 3 * this.lattice.nNodes;
    const { x, v, edge, tally, clock, last } = this.state;
    return Object.assign(other, {
      engine: this.engine, scenarios: [this.scenarios[run]], lattice: this.lattice, courses: [this.courses[run]],
      stride: [this.stride[run]], thinning: [0], tabulated: [this.tabulated[run]],
      state: { x: pick(x, per), v: pick(v, per), edge: edge.length ? pick(edge, per) : edge, tally: pick(tally, this.engine.tallies),
        clock: pick(clock, this.engine.clocks), last: pick(last, this.engine.names.channels.length), diverged: [this.state.diverged[run]] },
    });
  }

  /** Where the runs are, to come back to. */
  save() {
    return structuredClone({ state: this.state, scenarios: this.scenarios, courses: this.courses, stride: this.stride });
  }

  restore(saved) {
    Object.assign(this, structuredClone(saved));
  }
}

const multiples = (count, of) => (of > 0 ? Math.ceil(count / of) : 0);

const forgotten = (length) => Float64Array.from({ length }, (_, k) => (k % 3 === 2 ? GONE : 0));

function byChannel(samples, names) {
  const n = samples.length / names.length;
  return Object.fromEntries(names.map((name, c) => [name, Float32Array.from({ length: n }, (_, k) => samples[k * names.length + c])]));
}

/** When the shapes of a piece were taken, and where its plate was then: they are those of samples. */
function shownAt(channels, first, thinning, pictured) {
  const at = [];
  if (thinning > 0) for (let k = 0; at.length < pictured; k++) if ((first + k) % thinning === 0) at.push(k);
  return {
    snapshotTime: Float64Array.from(at, (k) => channels.time[k]),
    platePose: Float32Array.from(at.flatMap((k) => AXES.map((axis) => channels[`plate_${axis}`][k]))),
  };
}
