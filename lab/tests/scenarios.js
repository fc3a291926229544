// Scenarios that the tests of the model and the engine share, and the engine itself where it was built.
import { existsSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const built = fileURLToPath(new URL("../../src/plategait/lab/shipped/engine.wasm", import.meta.url));

/** The module, or null where `make lab` was not run. */
export const engineBytes = existsSync(built) ? readFileSync(built) : null;
export const unbuilt = engineBytes ? false : "the engine is not built here: make lab";

/** The dissertation's disk of cheese, under its usual motion. */
export const cheese = (changes = {}) => ({
  name: "cheese",
  sheet: {
    name: "cheese", outline: { shape: "disk", radius: 0.04 }, mass: 0.0136, pitch: 0.01, thickness: 0.0025,
    bending_stiffness: 1.5584452027558393e-4, bending_damping: 1.45e-6, axial_stiffness: 790, axial_damping: 0.49,
    shear_ratio: 1, torsion_stiffness: 0, torsion_damping: 0,
  },
  motion: {
    frequency: 24, angle: Math.PI / 60, stroke: 0.003, height: 0.005, ramp: 0.1,
    offset: { x: 0, y: 0, z: 0, rx: 0, ry: 0, rz: 0 }, waves: [], samples: null,
  },
  contact: { stiffness: 11860, damping: 7.65, damping_ramp: 0, tile_area: 1e-4 },
  friction: { static: 0.75, kinetic: 0.4, transition_speed: 0.06, kinetic_speed_ratio: 10, law: "thesis" },
  start: { x: 0, y: 0, angle: 0 }, plate: null, gravity: 9.81, duration: 0.2, transient: null, slip_limit: 0.01,
  time_step: null,
  ...changes,
});

/** Numbers from a seed, evenly from 0 to 1: Mulberry32. */
export const generator = (seed) => {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
};
