// What the lab's model and engine make of scenarios that the package sends as JSON on standard input.
import { readFileSync } from "node:fs";
import { Answers } from "../../src/engine/answers.js";
import { loadEngine } from "../../src/engine/module.js";
import { Session } from "../../src/engine/session.js";
import { courseOf } from "../../src/model/course.js";
import { naturalFrequency } from "../../src/model/modes.js";
import { featuresOf, packCourses, packParameters } from "../../src/model/packing.js";
import { checkOutline, occupiedSquares } from "../../src/model/outline.js";
import { startPositions, stepsOf, strideOf } from "../../src/model/recording.js";
import { checkScenario, latticeOf, timeStep } from "../../src/model/scenario.js";
import { observe } from "../../src/simulation/observe.js";

const { engine: bytes, told = [], runs = [], refused = [], sessions = [], sheets = [], cuts = [] } =
  JSON.parse(readFileSync(0, "utf8"));
const engine = await loadEngine(readFileSync(bytes));
const answers = new Answers(engine);

/** Numbers as they are, of any kind. */
const coded = (array) => ({
  kind: array.constructor.name.replace("Big", "").replace("Array", "").toLowerCase(),
  bytes: Buffer.from(array.buffer, array.byteOffset, array.byteLength).toString("base64"),
});

/** What the core is told of runs of one lattice, by the names of the package's packing. */
const toldOf = (runs) => {
  const lattice = latticeOf(runs[0].sheet);
  const ends = runs.map((s) => stepsOf(s) * timeStep(s));
  const course = packCourses(runs, runs.map(({ motion }) => courseOf(motion)), ends);
  return {
    numbers: {
      steps: runs.map(stepsOf), stride: runs.map((s) => strideOf(s)), dt: runs.map(timeStep),
      n_axial_lines: lattice.axial,
    },
    arrays: Object.fromEntries(Object.entries({
      line_start: lattice.lineStart, line_nodes: lattice.lineNodes, cells: lattice.cells, rest: lattice.rest,
      parameters: packParameters(engine.names.parameters, runs), features: Int32Array.from(featuresOf(runs)),
      layer_terms: course.layerTerms, term_dof: course.termDof, terms: course.terms, layers: course.layers,
      knots: course.knots, first_knot: course.firstKnot, n_knots: course.nKnots,
      start: Float64Array.from(runs.flatMap((s) => Array.from(startPositions(s)))),
    }).map(([name, array]) => [name, coded(array)])),
  };
};

/** The field that a scenario is refused for, or null. */
const fieldRefused = (s) => {
  try {
    checkScenario(s);
    return null;
  } catch (error) {
    return { field: error.field ?? "", message: error.message };
  }
};

/** The squares that a sheet is cut to, or the field that it is refused for. */
const cutOf = ({ outline, pitch }) => {
  try {
    checkOutline(outline);
    const { columns, rows, inside } = occupiedSquares(outline, pitch);
    return { columns, rows, inside: coded(inside) };
  } catch (error) {
    return { field: error.field };
  }
};

const asked = (message) => {
  const { reply } = answers.to({ id: 0, ...message });
  if (reply.refused) throw new Error(`${reply.refused.field}: ${reply.refused.message}`);
  return reply;
};

const channelsOf = ({ channels, diverged, steps }) => ({
  diverged, steps, channels: Object.fromEntries(Object.entries(channels).map(([name, array]) => [name, coded(array)])),
});

/** A sheet that is told of changes on its way, each as {seconds, change?, become?, push?}. */
const lived = ({ scenario, ways }) => {
  const session = new Session(engine, [scenario]);
  return ways.map(({ seconds, change, become, push }) => {
    if (change) session.change(0, change.motion, change.ramp);
    if (become) session.become(0, become.scenario, become.ramp);
    if (push) session.push(0, push);
    return channelsOf(session.advance({ seconds })[0]);
  });
};

const recordings = runs.length ? asked({ ask: "run", scenarios: runs }).recordings : [];

// Numbers that JSON cannot hold go as words.
const worded = (_, value) => (typeof value === "number" && !Number.isFinite(value) ? String(value) : value);
process.stdout.write(JSON.stringify({
  told: told.map(toldOf),
  recordings: recordings.map(channelsOf),
  observations: recordings.map((recording, k) => observe(runs[k], recording)),
  refused: refused.map(fieldRefused),
  sessions: sessions.map(lived),
  frequencies: sheets.map(naturalFrequency),
  cuts: cuts.map(cutOf),
}, worded));
