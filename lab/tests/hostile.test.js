// A thousand questions to a worker, most of them damaged: each is answered soon, by numbers or by a refusal, and no
// frame holds what is no number.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Answers } from "../src/engine/answers.js";
import { loadEngine } from "../src/engine/module.js";
import { stepsOf } from "../src/model/recording.js";
import { checkScenario, latticeOf } from "../src/model/scenario.js";
import { cheese, engineBytes, generator, unbuilt } from "./scenarios.js";

const SEED = 20;
const QUESTIONS = 1000;
const LONGEST = 1500; // ms of a processor that one answer takes
const WILD = [
  NaN, Infinity, -Infinity, 0, -0, 5e-324, 1e-300, 1e-30, 1e-12, 1e-6, 1, 11, 1e6, 1e12, 1e29, 1e300, -1e-9, -1, -1e30,
  null, undefined, true, "", "abc", "12 mm", "1e400", "__proto__", "<b>x</b>", [], {}, [1], [[0, 0]], { length: 1e9 },
  "#".repeat(5000), Number.MAX_SAFE_INTEGER, 2 ** 31, -(2 ** 31), 10n, new Date(0),
];
const MOST_NODE_STEPS = 3e6; // of a run that a test waits for
const ASKS = [
  "run", "observe", "open", "advance", "change", "become", "push", "save", "restore", "close", "nothing", null,
];
const KEYS = ["a", "a", "a", "a", "b", "b", "c", NaN];

const isPart = (value) => typeof value === "object" && value !== null && !ArrayBuffer.isView(value);

/** Places of all values inside, the whole left out. */
const placesIn = (part, path = []) =>
  Object.entries(part).flatMap(([key, value]) =>
    [[...path, key], ...(isPart(value) ? placesIn(value, [...path, key]) : [])]);

/** Whether a scenario is sound and takes long to run: a worker does so, and tells how far it is. */
const isLong = (s) => {
  try {
    checkScenario(s);
    return stepsOf(s) * latticeOf(s.sheet).nNodes > MOST_NODE_STEPS;
  } catch {
    return false;
  }
};

const put = (whole, path, value) => {
  const part = path.slice(0, -1).reduce((inside, key) => inside?.[key], whole);
  if (!isPart(part) || path.at(-1) === "length") return;
  if (value === undefined) delete part[path.at(-1)];
  else part[path.at(-1)] = value;
};

class Draw {
  constructor(seed) {
    this.next = generator(seed);
  }

  uniform(low, high) {
    return low + (high - low) * this.next();
  }

  choice(options) {
    return options[Math.floor(this.next() * options.length)];
  }

  chance(share) {
    return this.next() < share;
  }

  scenario() {
    const s = structuredClone(cheese({ duration: this.uniform(0.001, 0.02) }));
    s.sheet.outline = this.choice([
      { shape: "disk", radius: this.uniform(0.005, 0.06) },
      { shape: "ellipse", length: 0.05, width: this.uniform(0.01, 0.1) },
      { shape: "polygon", corners: [[0, 0], [0.05, 0], [this.uniform(-0.05, 0.05), 0.05]] },
      { shape: "mask", width_of_picture: 0.06, image: null, rows: [".##.", "####", "#.#."] },
    ]);
    s.sheet.pitch = this.uniform(0.004, 0.02);
    Object.assign(s.motion, {
      frequency: this.uniform(1, 60), angle: this.uniform(-0.3, 0.3), stroke: this.uniform(-0.01, 0.01),
      waves: this.chance(0.3) ? [{ axis: this.choice(["x", "z", "ry"]), amplitude: 0.001, ratio: 2, phase: 1 }] : [],
      samples: this.chance(0.2) ? { time: [0, 0.01, 0.05], x: [0, 0.001, 0], rz: [0, 0.2, 0.1] } : null,
    });
    s.plate = this.chance(0.3) ? { length: this.uniform(0.01, 0.2), width: 0.1 } : null;
    s.friction.law = this.choice(["thesis", "adams"]);
    if (this.chance(0.5)) this.damage(s);
    return s;
  }

  /** A scenario of the same lattice, now and then damaged. */
  likeThat(living) {
    const s = structuredClone(living);
    s.friction.static = this.uniform(0.4, 2);
    s.gravity = this.uniform(1, 20);
    if (this.chance(0.3)) this.damage(s);
    return s;
  }

  /** Some values inside exchanged for others, or left out. */
  damage(whole) {
    const places = placesIn(whole);
    for (let k = 0; k <= this.next() * 3; k++) put(whole, this.choice(places), structuredClone(this.choice(WILD)));
  }

  /** @param {object} saved as a sheet told of itself @param {object} living a scenario of a sheet under way */
  question(saved, living) {
    const scenario = this.scenario();
    const message = {
      id: 1, ask: this.choice(ASKS), key: this.choice(KEYS), scenario, motion: scenario.motion,
      scenarios: this.chance(0.8) ? [scenario, this.scenario()] : [scenario], repeats: 2, seed: 1,
      snapshotInterval: 0.005, offsets: this.chance(0.2) ? [[0.01, 0, 1]] : undefined,
      seconds: this.uniform(0, 0.03), frames: 3, ramp: 0.05,
      velocity: [this.uniform(-1, 1), 0, this.uniform(-1, 1)], spin: 1, at: this.chance(0.5) ? [0, 0] : undefined,
      state: structuredClone(saved),
    };
    if (message.ask === "become" && message.key === "a") message.scenario = this.likeThat(living);
    if (this.chance(0.3)) this.damage(message);
    if (["open", "close"].includes(message.ask) && message.key === "a") message.key = "b";
    if (Array.isArray(message.scenarios) && message.scenarios.some(isLong))
      Object.assign(message, { ask: "open", key: "b" });
    return this.chance(0.02) ? this.choice(WILD) : message;
  }
}

const finite = (values) => Array.from(values).every(Number.isFinite);

/** What an answer may be: a refusal in one line, or numbers with a status where they cease. */
const judge = (reply) => {
  if (reply.refused) {
    const { field, message } = reply.refused;
    assert.equal(typeof message, "string");
    assert.ok(message.length > 0 && message.length < 1000 && !message.includes("\n"), message);
    assert.ok(field === null || typeof field === "string");
    return "refused";
  }
  assert.equal(typeof reply.told, "string");
  for (const { nodes, pose, forces } of reply.frames ?? [])
    assert.ok(finite(nodes) && finite(pose) && finite(forces ?? []));
  for (const { channels, snapshots, diverged } of reply.recordings ?? [])
    assert.ok(diverged || (finite(channels.centre_x) && finite(channels.kinetic_energy) && finite(snapshots)));
  for (const { spin, failure } of (reply.observations ?? []).flat())
    assert.ok(Number.isFinite(spin.rate) || failure || Number.isNaN(spin.rate));
  return reply.told;
};

test("nothing that a worker is asked hangs or ends it, or gives what is no number", { skip: unbuilt }, async () => {
  const draw = new Draw(SEED);
  const answers = new Answers(await loadEngine(engineBytes));
  answers.to({ id: 0, ask: "open", key: "a", scenario: cheese() });
  const { reply: { state: saved } } = answers.to({ id: 0, ask: "save", key: "a" });
  const counts = {};
  let longest = 0;
  for (let k = 0; k < QUESTIONS; k++) {
    const message = draw.question(saved, answers.sessions.get("a")?.scenarios[0] ?? cheese());
    const began = process.cpuUsage();
    const { reply, transfer } = answers.to(message);
    longest = Math.max(longest, process.cpuUsage(began).user / 1000);
    // As a worker sends it.
    const arrived = structuredClone(reply, { transfer });
    const kind = judge(arrived);
    counts[kind] = (counts[kind] ?? 0) + 1;
    assert.ok(longest < LONGEST, `${longest} ms for question ${k}, ${message?.ask}`);
  }
  // Or the test would say less than it seems to.
  const kinds = ["refused", "ran", "observed", "opened", "frames", "changed", "become", "pushed", "saved", "restored"];
  for (const kind of kinds) assert.ok(counts[kind] >= 5, `${kind}: ${counts[kind]}`);
  // And the engine is what it was.
  const { reply } = answers.to({ id: 0, ask: "run", scenarios: [cheese()] });
  const { reply: fresh } = new Answers(await loadEngine(engineBytes)).to({ id: 0, ask: "run", scenarios: [cheese()] });
  assert.deepEqual(reply, fresh);
});
