// What the core is told of runs, as plain arrays: the numbers of each, and the courses of their plates. As the
// package's engine/packing.py, by the core's own names.
import { finestStep, offsetOf, termsOf } from "./motion.js";
import { nodeMass } from "./sheet.js";
import { knotsOf } from "./spline.js";
import { timeStep } from "./scenario.js";

const ENDLESS = 1e9; // a plate that never ends, m

/** Every number that the core wants of a scenario, by the core's names, SI. */
export function parametersOf(s) {
  const { sheet, contact, friction } = s;
  const share = sheet.pitch ** 2 / contact.tile_area;
  return {
    pitch: sheet.pitch,
    node_mass: nodeMass(sheet),
    axial_stiffness: sheet.axial_stiffness,
    axial_damping: sheet.axial_damping,
    shear_ratio: sheet.shear_ratio,
    bending_stiffness: sheet.bending_stiffness,
    bending_damping: sheet.bending_damping,
    torsion_stiffness: sheet.torsion_stiffness,
    torsion_damping: sheet.torsion_damping,
    contact_stiffness: contact.stiffness * 1e-3 * share,
    contact_damping: contact.damping * share,
    contact_ramp: contact.damping_ramp,
    static_friction: friction.static,
    kinetic_friction: friction.kinetic,
    static_speed: friction.transition_speed,
    kinetic_speed: friction.transition_speed * friction.kinetic_speed_ratio,
    smooth_friction: friction.law === "adams" ? 1 : 0,
    gravity: s.gravity,
    plate_half_length: s.plate ? s.plate.length / 2 : ENDLESS,
    plate_half_width: s.plate ? s.plate.width / 2 : ENDLESS,
    plate_height: s.motion.height,
    time_step: timeStep(s),
  };
}

/** Parameters of runs in the core's order: [parameter][run]. */
export function packParameters(names, scenarios) {
  const rows = scenarios.map(parametersOf);
  const packed = new Float64Array(names.length * rows.length);
  names.forEach((name, p) => rows.forEach((row, j) => (packed[p * rows.length + j] = row[name])));
  return packed;
}

/** Phases that some run needs: torsion, smooth friction, an edge of the plate, a ramp of the contact's damping. */
export function featuresOf(scenarios) {
  return [
    scenarios.some((s) => s.sheet.torsion_stiffness !== 0 || s.sheet.torsion_damping !== 0),
    scenarios.some((s) => s.friction.law === "adams"),
    scenarios.some((s) => Boolean(s.plate)),
    scenarios.some((s) => s.contact.damping_ramp !== 0),
  ].map(Number);
}

/** Time between knots, s: a number that single precision holds. */
export function tableStep(s, motion) {
  if (!motion.samples) return 1;
  return Math.fround(Math.max(Math.min(finestStep(motion.samples) / 2, s.duration), 2 * timeStep(s)));
}

/**
 * Courses side by side: the last layers of all are one, and so on down; where a course has fewer layers than the
 * longest, layers of a plate that stands where it begins lie beneath.
 *
 * @param {object[]} scenarios
 * @param {import("./course.js").Layer[][]} courses
 * @param {number[]} ends how far each sampled trajectory is followed, s
 */
export function packCourses(scenarios, courses, ends) {
  const n = courses.length;
  const most = Math.max(...courses.map((course) => course.length));
  const missing = courses.map((course) => most - course.length);
  const layerTerms = [0];
  const termDof = [];
  const terms = [];
  const layers = [];
  const followed = [];
  for (let i = 0; i < most; i++) {
    const row = courses.map((course, j) => (i > missing[j] ? course[i - missing[j]] : course[0]));
    const gone = missing.map((each) => each > i);
    const packed = packTerms(row.map((layer, j) => (gone[j] ? [] : termsOf(layer.motion))));
    termDof.push(...packed.dofs);
    terms.push(...packed.numbers);
    layerTerms.push(termDof.length);
    const numbers = row.map((layer, j) =>
      gone[j]
        ? [0, 0, 0, 1, ...offsetOf(layer.motion)]
        : [
            layer.begin,
            layer.duration,
            layer.tableBegin,
            tableStep(scenarios[j], layer.motion),
            ...offsetOf(layer.motion),
          ],
    );
    for (let k = 0; k < numbers[0].length; k++) for (let j = 0; j < n; j++) layers.push(numbers[j][k]);
    row.forEach((layer, j) =>
      followed.push(
        !gone[j] && layer.motion.samples
          ? {
              samples: layer.motion.samples,
              step: tableStep(scenarios[j], layer.motion),
              end: ends[j] - layer.tableBegin,
            }
          : null,
      ),
    );
  }
  return {
    nLayers: most,
    layerTerms: Int32Array.from(layerTerms),
    termDof: Int32Array.from(termDof),
    terms: Float64Array.from(terms),
    layers: Float64Array.from(layers),
    ...tables(followed),
  };
}

/** Sines of every run in shared slots: the degree of freedom of each slot, and [slot][3][run] numbers. */
function packTerms(byRun) {
  const most = Array.from({ length: 6 }, (_, d) =>
    Math.max(...byRun.map((terms) => terms.filter((term) => term[0] === d).length)),
  );
  const dofs = most.flatMap((count, d) => Array(count).fill(d));
  const numbers = new Array(dofs.length * 3 * byRun.length).fill(0);
  byRun.forEach((terms, j) => {
    const free = most.map((_, d) => most.slice(0, d).reduce((sum, count) => sum + count, 0));
    for (const [d, ...values] of terms) {
      const slot = free[d]++;
      values.forEach((value, k) => (numbers[(3 * slot + k) * byRun.length + j] = value));
    }
  });
  return { dofs, numbers };
}

/** Knots of sampled trajectories one after the other, and where those of each begin; none where nothing is sampled. */
function tables(followed) {
  if (!followed.some(Boolean))
    return { knots: new Float64Array(0), firstKnot: new BigInt64Array(0), nKnots: new BigInt64Array(0) };
  const made = new Map();
  const keyOf = (one) => (one ? `${identity(one.samples)} ${one.step}` : "");
  const ends = new Map();
  for (const one of followed) ends.set(keyOf(one), Math.max(ends.get(keyOf(one)) ?? 0, one?.end ?? 0));
  let length = 0;
  for (const one of followed) {
    const key = keyOf(one);
    if (made.has(key)) continue;
    const knots = one ? knotsOf(one.samples, one.step, ends.get(key)) : new Float64Array(24);
    made.set(key, { first: length, count: knots.length / 12, knots });
    length += knots.length / 12;
  }
  const knots = new Float64Array(12 * length);
  for (const { first, knots: own } of made.values()) knots.set(own, 12 * first);
  return {
    knots,
    firstKnot: BigInt64Array.from(followed, (one) => BigInt(made.get(keyOf(one)).first)),
    nKnots: BigInt64Array.from(followed, (one) => BigInt(made.get(keyOf(one)).count)),
  };
}

const identities = new WeakMap();
let given = 0;
const identity = (object) => {
  if (!identities.has(object)) identities.set(object, ++given);
  return identities.get(object);
};
