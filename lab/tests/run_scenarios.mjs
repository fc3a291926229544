// Runs scenarios through the module under node: JSON lines in on standard input, JSON lines out.
//
// node run_scenarios.mjs ENGINE.wasm < [{scenario, offset}] > [{packed, observation, channels}]
import { readFileSync } from "node:fs";
import { Answers } from "../src/engine/answers.js";
import { loadEngine } from "../src/engine/module.js";
import { courseOf } from "../src/model/course.js";
import { packCourses, packParameters } from "../src/model/packing.js";
import { checkScenario, latticeOf, startPositions, stepsOf, strideOf, timeStep } from "../src/model/scenario.js";
import { observe } from "../src/simulation/observe.js";

const engine = await loadEngine(readFileSync(process.argv[2]));
const wanted = JSON.parse(readFileSync(0, "utf8"));
const answers = new Answers(engine);

const numbers = (values) => Array.from(values, Number);

/** What the core is told of a run, as Python's packing tells it. */
function told(s) {
  const lattice = latticeOf(s.sheet);
  const course = packCourses([s], [courseOf(s.motion)], [stepsOf(s) * timeStep(s)]);
  return {
    line_start: numbers(lattice.lineStart), line_nodes: numbers(lattice.lineNodes), cells: numbers(lattice.cells),
    rest: numbers(lattice.rest), parameters: numbers(packParameters(engine.names.parameters, [s])),
    layer_terms: numbers(course.layerTerms), term_dof: numbers(course.termDof), terms: numbers(course.terms),
    layers: numbers(course.layers), knots: numbers(course.knots), start: numbers(startPositions(s)),
    steps: stepsOf(s), stride: strideOf(s), dt: timeStep(s), n_axial_lines: lattice.axial,
  };
}

const out = [];
for (const { scenario, refuse } of wanted) {
  try {
    checkScenario(scenario);
  } catch (error) {
    out.push({ refused: error.field ?? String(error) });
    continue;
  }
  if (refuse) {
    out.push({ refused: null });
    continue;
  }
  const { reply } = answers.to({ id: 1, ask: "run", scenarios: [scenario] });
  if (reply.refused) {
    out.push({ trouble: reply.refused.message });
    continue;
  }
  const [recording] = reply.recordings;
  const observation = observe(scenario, recording);
  out.push({ told: told(scenario), observation, steps: recording.steps, diverged: recording.diverged });
}
process.stdout.write(JSON.stringify(out, (_, value) => (typeof value === "number" && !Number.isFinite(value) ? null : value)));
