// What a run recorded in one advance, from the core's samples. As the package's engine/piece.py.
import { AXES } from "../model/motion.js";

/**
 * @typedef {{channels: Record<string, Float32Array | Float64Array>, snapshotTime: Float64Array,
 *   snapshots: Float32Array, platePose: Float32Array, steps: number, diverged: boolean}} Piece channels by name, SI,
 *   their times in double precision; snapshots [n][node][x, y, z] in the world, m; poses [n][6] of the plate, m and rad
 */

/** Series by name, each [n], of samples [n][channel]. */
export const byChannel = (samples, names) => {
  const count = samples.length / names.length;
  return Object.fromEntries(
    names.map((name, c) => {
      const series = new Float32Array(count);
      for (let k = 0; k < count; k++) series[k] = samples[k * names.length + c];
      return [name, series];
    }),
  );
};

/** When shapes were taken, and where the plate was then: at every `thinning`-th sample since the start. */
export const shapesOf = (channels, first, thinning, pictured) => {
  const at = [];
  for (let k = 0; at.length < pictured; k++) if ((first + k) % thinning === 0) at.push(k);
  return {
    snapshotTime: Float64Array.from(at, (k) => channels.time[k]),
    platePose: Float32Array.from(at.flatMap((k) => AXES.map((axis) => channels[`plate_${axis}`][k]))),
  };
};

/** Pieces of one run that follow each other, as one. @param {Record<string, Float32Array | Float64Array>[]} pieces */
export const joined = (pieces) =>
  Object.fromEntries(
    Object.keys(pieces[0]).map((name) => {
      const whole = new pieces[0][name].constructor(pieces.reduce((sum, piece) => sum + piece[name].length, 0));
      let at = 0;
      for (const piece of pieces) {
        whole.set(piece[name], at);
        at += piece[name].length;
      }
      return [name, whole];
    }),
  );

/** How many whole multiples there are below a count, 0 among them; none of 0. */
export const multiples = (count, of) => (of > 0 ? Math.ceil(count / of) : 0);

export const allFinite = (numbers) => {
  for (let k = 0; k < numbers.length; k++) if (!Number.isFinite(numbers[k])) return false;
  return true;
};
