// The engine's sessions, answers and workers: pieces that add up, lanes that do not touch, and what stops none of them.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Worker } from "node:worker_threads";
import { Answers } from "../src/engine/answers.js";
import { loadEngine } from "../src/engine/module.js";
import { Pool, openLive } from "../src/engine/pool.js";
import { Session } from "../src/engine/session.js";
import { cheese, engineBytes, unbuilt } from "./scenarios.js";

const engine = engineBytes && (await loadEngine(engineBytes));
const near = (got, want, within) => assert.ok(Math.abs(got - want) <= within, `${got} is not ${want} within ${within}`);
const engineTest = (name, body) => test(name, { skip: unbuilt }, body);

const calm = () => cheese({ motion: { ...cheese().motion, angle: 0, stroke: 0 }, duration: 1 });
const waved = () => cheese({
  motion: {
    ...cheese().motion, waves: [{ axis: "y", amplitude: 1e-3, ratio: 2, phase: 1 }],
    samples: { time: [0, 0.05, 0.1, 0.15], z: [0, 1e-3, 0, 5e-4] },
  },
  plate: { length: 0.09, width: 0.09 }, start: { x: 0.02, y: 0, angle: 0.3 },
});

/** Replies of a worker's answers, which refuse by an exception here. */
const asking = (own = engine) => {
  const answers = new Answers(own);
  const ask = (message, report) => {
    const { reply } = answers.to({ id: 7, ...message }, report);
    assert.equal(reply.id, 7);
    if (reply.refused) throw Object.assign(new Error(reply.refused.message), reply.refused);
    return reply;
  };
  return { answers, ask };
};

engineTest("the module has the core's names, and no imports", async () => {
  assert.equal(WebAssembly.Module.imports(engine.module).length, 0);
  assert.equal(engine.lanes, 4);
  assert.ok(engine.names.parameters.includes("shear_ratio"));
  assert.equal(engine.names.channels[0], "time");
});

engineTest("pieces add up to the same bits as one advance", () => {
  const whole = new Session(engine, [waved()]);
  const [all] = whole.advance({ seconds: 0.15 });
  const cut = new Session(engine, [waved()]);
  const pieces = [0.01, 0.0371, 0.05, 0.0529].map((seconds) => cut.advance({ seconds })[0]);
  assert.deepEqual(cut.nodes(), whole.nodes());
  for (const name of ["time", "centre_x", "spin_cross", "plate_work", "left_contact", "plate_z"])
    assert.deepEqual(pieces.flatMap(({ channels }) => [...channels[name]]), [...all.channels[name]], name);
});

engineTest("a run is the same in whatever company", () => {
  const others = [30, 12, 18].map((frequency) => cheese({ motion: { ...cheese().motion, frequency } }));
  const [, together] = new Session(engine, [others[0], waved(), others[1], others[2]]).advance({ seconds: 0.1 });
  // Where a plate ends, the others' are without end: beyond a gigametre.
  const [alone] = new Session(engine, [waved()]).advance({ seconds: 0.1 });
  assert.deepEqual(together.channels.centre_x, alone.channels.centre_x);
});

engineTest("durations add up exactly", () => {
  const session = new Session(engine, [cheese()]);
  for (let k = 0; k < 60; k++) session.advance({ seconds: 1 / 60 });
  near(session.time(), 1, 1e-12);
});

engineTest("shapes are recorded as often as they are asked for, with the plate's pose", () => {
  const [piece] = new Session(engine, [cheese()], { snapshotInterval: 0.02 }).advance({ steps: [2000] });
  assert.equal(piece.snapshots.length, piece.snapshotTime.length * 3 * 52);
  assert.equal(piece.platePose.length, piece.snapshotTime.length * 6);
  near(piece.snapshotTime[1] - piece.snapshotTime[0], 0.0204, 1e-9);
  const which = piece.channels.time.indexOf(piece.snapshotTime[4]);
  assert.equal(piece.platePose[4 * 6 + 3], piece.channels.plate_rx[which]);
});

engineTest("a plate carries the weight of a sheet that lies still", () => {
  const session = new Session(engine, [calm()]);
  session.advance({ seconds: 0.5 });
  const { nodes, plate } = session.forces();
  const weight = 0.0136 * 9.81;
  near(plate[2], -weight, 1e-3 * weight);
  for (const d of [0, 1, 3, 4, 5]) near(plate[d], 0, 1e-5);
  near(nodes.filter((_, k) => k % 3 === 0).reduce((sum, each) => sum + each), weight, 1e-3 * weight);
});

engineTest("a kick gives the sheet its velocity, and one at a place moves what is near", () => {
  const session = new Session(engine, [calm()]);
  session.advance({ steps: [10] });
  session.push(0, { velocity: [0.1, 0, 0], spin: 2 });
  const v = (k, d) => session.state.v[3 * k + d];
  const mean = Array.from({ length: 52 }, (_, k) => v(k, 0)).reduce((sum, each) => sum + each) / 52;
  near(mean, 0.1, 1e-6);
  near(v(51, 0) - v(0, 0), -2 * (session.state.x[3 * 51 + 1] - session.state.x[1]), 1e-5);
  const before = session.state.v.slice();
  session.push(0, { velocity: [0, 0, 1], at: [session.state.x[0], session.state.x[1]], radius: 0.01 });
  near(session.state.v[2] - before[2], 1, 1e-12);
  assert.ok(session.state.v[3 * 51 + 2] - before[3 * 51 + 2] < 1e-6);
});

engineTest("a sheet goes on from where it was saved, to the same bits", () => {
  const session = new Session(engine, [waved()]);
  session.advance({ seconds: 0.05 });
  const saved = session.save();
  session.advance({ seconds: 0.05 });
  const then = session.nodes();
  session.become(0, { ...waved(), gravity: 1 });
  session.advance({ seconds: 0.05 });
  session.restore(saved);
  near(session.time(), 0.05, 1e-12);
  session.advance({ seconds: 0.05 });
  assert.deepEqual(session.nodes(), then);
});

engineTest("a changed motion is gone over to without a jolt", () => {
  const session = new Session(engine, [cheese()]);
  session.advance({ seconds: 0.2 });
  session.change(0, { ...cheese().motion, stroke: 0.001, frequency: 11 }, 0.1);
  const [{ channels }] = session.advance({ seconds: 0.2 });
  const way = channels.plate_x;
  const steps = Array.from(way.slice(1), (x, k) => x - way[k]);
  // No faster than both strokes together ask for, and a half more to go over in 0.1 s.
  assert.ok(Math.max(...steps.map(Math.abs)) < (0.003 * 2 * Math.PI * 24 + 0.004 * 1.875 / 0.1) * 2e-3);
  assert.ok(Math.max(...way.slice(-80)) < 1.05e-3);
});

engineTest("a sheet takes another stiffness where it is, and is laid down anew for another lattice or step", () => {
  const session = new Session(engine, [cheese()]);
  session.advance({ seconds: 0.1 });
  const before = session.nodes();
  session.become(0, { ...cheese(), sheet: { ...cheese().sheet, bending_stiffness: 3e-4 } });
  assert.deepEqual(session.nodes(), before);
  const anew = (scenario) => assert.throws(() => session.become(0, scenario), ({ anew: told }) => told === true);
  anew({ ...cheese(), sheet: { ...cheese().sheet, pitch: 0.012 } });
  anew({ ...cheese(), sheet: { ...cheese().sheet, axial_stiffness: 1e6 } });
  anew({ ...cheese(), motion: { ...cheese().motion, height: 0.02 } });
  assert.throws(() => session.become(0, { ...cheese(), gravity: -1 }), { field: "gravity" });
  session.advance({ seconds: 0.01 });
});

engineTest("a plate may come to end under a sheet, and to end no more", () => {
  const session = new Session(engine, [cheese()]);
  session.advance({ seconds: 0.05 });
  const [{ channels: before }] = session.advance({ seconds: 0.02 });
  session.become(0, { ...cheese(), plate: { length: 0.06, width: 0.06 } });
  const [{ channels }] = session.advance({ seconds: 0.02 });
  // What is beyond the edge hangs down; the middle stays where it is carried.
  near(channels.centre_z.at(-1), before.centre_z.at(-1), 3e-3);
  assert.ok(channels.kinetic_energy.every((energy) => energy < 1e-2));
  session.become(0, cheese());
  const [{ diverged }] = session.advance({ seconds: 0.05 });
  assert.equal(diverged, false);
});

engineTest("a sheet that ceases to be finite says so, and shows no nodes that are no numbers", () => {
  const { ask } = asking();
  ask({ ask: "open", key: "a", scenario: cheese({ gravity: 1e20 }) });
  const frames = [];
  let told = null;
  for (let k = 0; k < 20 && !told?.diverged; k++) {
    told = ask({ ask: "advance", key: "a", seconds: 0.05, frames: 30 });
    frames.push(...told.frames);
  }
  assert.equal(told.diverged, true);
  for (const { nodes, pose } of frames) assert.ok([...nodes, ...pose].every(Number.isFinite));
  const after = ask({ ask: "advance", key: "a", seconds: 0.05, frames: 3 });
  assert.deepEqual([after.frames.length, after.diverged], [0, true]);
});

engineTest("after a trap the next question is answered, and sheets go on from where they were", () => {
  const { answers, ask } = asking(engine.anew());
  ask({ ask: "open", key: "a", scenario: cheese() });
  const { nodes } = ask({ ask: "advance", key: "a", seconds: 0.02 }).frames.at(-1);
  const { core } = answers.engine;
  // A table beyond the module's memory.
  answers.engine.core = { ...core, plategait_advance: () => core.plategait_advance(-64) };
  assert.throws(() => ask({ ask: "advance", key: "a", seconds: 0.01 }), /the engine stopped/);
  assert.notEqual(answers.engine.core.memory, core.memory);
  const { frames } = ask({ ask: "advance", key: "a", seconds: 1e-9 });
  frames[0].nodes.forEach((x, k) => near(x, nodes[k], 1e-4));
  near(frames[0].time, 0.0201, 1e-12);
});

engineTest("memory is given back", () => {
  const { ask } = asking();
  const before = engine.core.memory.buffer.byteLength;
  for (let k = 0; k < 200; k++) ask({ ask: "run", scenarios: [cheese({ duration: 0.01 })], snapshotInterval: 1e-3 });
  assert.ok(engine.core.memory.buffer.byteLength - before <= 1 << 20);
});

engineTest("whole runs are observed in their order, over lattices and lanes", () => {
  const { ask } = asking();
  const small = { ...cheese().sheet, outline: { shape: "rectangle", length: 0.03, width: 0.03 } };
  const scenarios = [cheese(), cheese({ sheet: small, duration: 0.1 }), cheese({ gravity: 5 })];
  const told = [];
  const { observations } = ask({ ask: "observe", scenarios, repeats: 3, seed: 1 }, (fraction) => told.push(fraction));
  assert.deepEqual(observations.map((each) => each.length), [3, 3, 3]);
  assert.equal(told.at(-1), 1);
  const [[alone]] = ask({ ask: "observe", scenarios: [scenarios[2]], repeats: 1, seed: 1 }).observations;
  assert.deepEqual(observations[2][0], alone);
});

/** A worker of the engine under node, with a browser's face. */
const makeWorker = (bytes = engineBytes) => {
  const source = `
    const { parentPort } = require("node:worker_threads");
    globalThis.self = { postMessage: (message, transfer) => parentPort.postMessage(message, transfer) };
    const begun = import(${JSON.stringify(new URL("../src/engine/worker.js", import.meta.url).href)});
    parentPort.on("message", async (data) => { await begun; self.onmessage({ data }); });`;
  const thread = new Worker(source, { eval: true });
  const worker = { postMessage: (message) => thread.postMessage(message), terminate: () => thread.terminate() };
  thread.on("message", (data) => worker.onmessage({ data }));
  thread.on("error", (error) => worker.onerror({ error }));
  worker.postMessage({ engine: bytes });
  return worker;
};

engineTest("a pool shares questions over workers, and a stopped one leaves the others whole", async () => {
  const pool = new Pool(makeWorker, 2);
  const observe = (frequency, duration, how) =>
    pool.ask({ ask: "observe", scenarios: [cheese({ duration, motion: { ...cheese().motion, frequency } })] }, how);
  const stopping = new AbortController();
  const long = observe(20, 600, { signal: stopping.signal });
  const progress = [];
  const onProgress = (fraction) => progress.push(fraction);
  const short = [10, 12, 14].map((frequency) => observe(frequency, 0.2, { onProgress }));
  const all = await Promise.all(short);
  assert.deepEqual(all.map(({ observations }) => observations.length), [1, 1, 1]);
  assert.deepEqual(progress, [1, 1, 1]);
  stopping.abort();
  await assert.rejects(long, { name: "AbortError" });
  await assert.rejects(observe(-1, 1), { field: "motion.frequency" });
  // The worker that went on in vain is replaced.
  await new Promise((resolve) => setTimeout(resolve, 500));
  await Promise.all([observe(10, 0.1), observe(10, 0.1)]);
  const waiting = observe(20, 600);
  pool.close();
  await assert.rejects(waiting, { message: "closed" });
});

engineTest("a worker whose module is spoilt says so, and is not waited for", async () => {
  const live = openLive(() => makeWorker(Buffer.from("no module")));
  await assert.rejects(live.ask({ ask: "open", key: 1, scenario: cheese() }), /did not start/);
  await assert.rejects(live.ask({ ask: "open", key: 1, scenario: cheese() }), /did not start/);
  live.close();
});

engineTest("a live worker hands frames over", async () => {
  const live = openLive(makeWorker);
  await live.ask({ ask: "open", key: "left", scenario: waved() });
  const { frames, samples } = await live.ask({ ask: "advance", key: "left", seconds: 0.1, frames: 6 });
  assert.deepEqual(frames.map(({ time }) => Number(time.toFixed(4))), [0.0167, 0.0333, 0.05, 0.0667, 0.0833, 0.1]);
  assert.equal(frames[0].forces.length, 3 * 52);
  assert.equal(frames[0].plate.length, 6);
  assert.ok(samples.time instanceof Float64Array);
  await assert.rejects(live.ask({ ask: "advance", key: "right", seconds: 1 }), /open it first/);
  live.close();
});
