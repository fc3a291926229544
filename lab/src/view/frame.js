// Where the plate is: the axes and the middle of its surface, as the world sees them.

/** Numbers of a plate's frame: rotation row by row (its columns are the plate's axes), then the surface's middle, m. */
export const FRAME_SIZE = 12;

/**
 * The frame of a pose, rotation Rx Ry Rz about a point `height` below the middle of the plate's surface.
 * @param {ArrayLike<number>} pose translations, m, and rotations, rad
 * @param {number} height m
 * @param {Float64Array} frame what is written to, `FRAME_SIZE` long
 */
export const plateFrame = (pose, height, frame) => {
  const cx = Math.cos(pose[3]), cy = Math.cos(pose[4]), cz = Math.cos(pose[5]);
  const sx = Math.sin(pose[3]), sy = Math.sin(pose[4]), sz = Math.sin(pose[5]);
  frame[0] = cy * cz;
  frame[1] = -cy * sz;
  frame[2] = sy;
  frame[3] = cx * sz + sx * sy * cz;
  frame[4] = cx * cz - sx * sy * sz;
  frame[5] = -sx * cy;
  frame[6] = sx * sz - cx * sy * cz;
  frame[7] = sx * cz + cx * sy * sz;
  frame[8] = cx * cy;
  frame[9] = pose[0] + height * frame[2];
  frame[10] = pose[1] + height * frame[5];
  frame[11] = pose[2] + height * (frame[8] - 1);
  return frame;
};

/** Points (x, y, z one after the other) of the world as the plate's frame has them. */
export const ontoPlate = (frame, points, into, count = points.length / 3) => {
  const ax = frame[0], bx = frame[1], nx = frame[2], ay = frame[3], by = frame[4], ny = frame[5];
  const az = frame[6], bz = frame[7], nz = frame[8], ox = frame[9], oy = frame[10], oz = frame[11];
  for (let k = 0; k < 3 * count; k += 3) {
    const x = points[k] - ox, y = points[k + 1] - oy, z = points[k + 2] - oz;
    into[k] = ax * x + ay * y + az * z;
    into[k + 1] = bx * x + by * y + bz * z;
    into[k + 2] = nx * x + ny * y + nz * z;
  }
  return into;
};

/** A point of the plate's frame as the world has it. */
export const intoWorld = (frame, x, y, z, into) => {
  for (let d = 0; d < 3; d++) into[d] = frame[3 * d] * x + frame[3 * d + 1] * y + frame[3 * d + 2] * z + frame[9 + d];
  return into;
};

/** Whether all of these are numbers that can be drawn. */
export const allFinite = (values) => {
  for (let k = 0; k < values.length; k++) if (!(Math.abs(values[k]) < 1e6)) return false;
  return true;
};
