// What the command was given besides a scenario: a recorded run, a store, tracked poses, an estimated object, a steering
// run. Each kind has a file of its own; here it is found.
import { make } from "./elements.js";
import { cloudOf } from "./exhibits/object.js";
import { posesBeside } from "./exhibits/poses.js";
import { recorded } from "./exhibits/run.js";
import { steered } from "./exhibits/steering.js";
import { stored } from "./exhibits/store.js";

const KINDS = { run: recorded, store: stored, poses: posesBeside, object: cloudOf, steering: steered };

export function exhibit(element, desk, scenes) {
  const { payload } = desk;
  const build = Object.hasOwn(KINDS, payload.kind) ? KINDS[payload.kind] : null;
  if (!build) {
    element.append(make("p", { class: "note" }, `This page knows no ${String(payload.kind).slice(0, 40)}.`));
    return {};
  }
  element.append(make("h2", {}, String(payload.name ?? payload.kind)));
  for (const note of Array.isArray(payload.notes) ? payload.notes : []) element.append(make("p", { class: "note" }, String(note)));
  try {
    return build(element, desk, scenes) ?? {};
  } catch (error) {
    element.append(make("p", { class: "fault", role: "alert" }, `The data in this file are spoilt: ${error.message}`));
    return {};
  }
}
