// The course of a plate: the motions that it was given one after the other, each gone over to without a jolt. As the
// package's model/course.py.
import { SHORTEST_RAMP } from "./motion.js";

// So many times its duration after its begin, a layer has been gone over to in single precision too.
const OVER = 1 + 1e-5;

/**
 * @typedef {{motion: object, begin: number, duration: number, tableBegin: number}} Layer since when the plate goes over
 *   to a motion and how long that takes, and when its sampled trajectory begins, s
 */

/** Course of a plate that is given one motion at the start. @returns {Layer[]} */
export const courseOf = (motion) => [{ motion, begin: 0, duration: motion.ramp, tableBegin: 0 }];

/** Course without the layers that no longer matter; the first left also tells where the plate stood before it. */
export const stillNeeded = (course, time) => {
  for (let i = course.length - 1; i > 0; i--) {
    const { begin, duration } = course[i];
    if (time - begin > duration * OVER + SHORTEST_RAMP) return course.slice(i);
  }
  return course;
};

/** Course that goes over to another motion from a time on; a sampled trajectory that stays the same goes on. */
export const goneOver = (course, motion, time, duration) => {
  const before = course.at(-1);
  const same = motion.samples && JSON.stringify(motion.samples) === JSON.stringify(before.motion.samples);
  return [...stillNeeded(course, time), { motion, begin: time, duration, tableBegin: same ? before.tableBegin : time }];
};
