// How a run of a scenario begins and is sampled. As the package's engine/recording.py.
import { periodOf, poseAtStart, rotationOf } from "./motion.js";
import { roundHalfEven } from "./rounding.js";
import { latticeOf, staticDepth, timeStep } from "./scenario.js";

// A plate period holds this many samples, and none is further from the next than the longest interval.
const SAMPLES_PER_PERIOD = 24;
const LONGEST_SAMPLE_INTERVAL = 2e-3; // s

/** Steps of a whole run. */
export const stepsOf = (s) => Math.max(1, roundHalfEven(s.duration / timeStep(s)));

/** Steps between samples while the plate moves so. */
export const strideOf = (s, motion = s.motion) => {
  const interval = Math.min(LONGEST_SAMPLE_INTERVAL, periodOf(motion) / SAMPLES_PER_PERIOD);
  return Math.max(1, Math.min(roundHalfEven(interval / timeStep(s)), stepsOf(s)));
};

/** Samples that a whole run leaves. */
export const samplesOf = (s) => Math.floor(stepsOf(s) / strideOf(s)) + 1;

/** Samples between snapshots, 0 for none, where shapes are wanted every so many seconds. */
export const thinningOf = (s, snapshotInterval) => {
  if (!(snapshotInterval > 0)) return 0;
  return Math.max(1, roundHalfEven(Math.min(snapshotInterval / (strideOf(s) * timeStep(s)), samplesOf(s))));
};

/**
 * Node positions at the start, world frame, m, [node][x, y, z]: at rest, flat on the plate, which carries the weight.
 *
 * @param {object} s
 * @param {number[]} [offset] added to the scenario's start: x, y, m, and angle, rad
 */
export const startPositions = (s, offset = [0, 0, 0]) => {
  const { rest, nNodes } = latticeOf(s.sheet);
  const { pitch } = s.sheet;
  const { height } = s.motion;
  const [x, y, angle] = [s.start.x + offset[0], s.start.y + offset[1], s.start.angle + offset[2]];
  const [cosine, sine] = [Math.cos(angle), Math.sin(angle)];
  const pose = poseAtStart(s.motion);
  const moved = pose.some((value) => value !== 0);
  const turned = rotationOf(pose);
  const depth = staticDepth(s);
  const out = new Float64Array(3 * nNodes);
  for (let k = 0; k < nNodes; k++) {
    const [along, across] = [rest[2 * k] * pitch, rest[2 * k + 1] * pitch];
    const laid = [along * cosine - across * sine + x, along * sine + across * cosine + y, -depth];
    const up = [laid[0], laid[1], laid[2] + height];
    for (let d = 0; d < 3; d++) {
      const carried = turned[3 * d] * up[0] + turned[3 * d + 1] * up[1] + turned[3 * d + 2] * up[2];
      out[3 * k + d] = moved ? carried - (d === 2 ? height : 0) + pose[d] : laid[d];
    }
  }
  return out;
};
