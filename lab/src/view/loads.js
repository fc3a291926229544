// How large forces are drawn: by a node's share of the sheet's weight.

/** Radius of a disc and length of an arrow over the pitch, at the node's share of the weight; and the most. */
const RADIUS = 0.15, LEAST_RADIUS = 0.07, MOST_RADIUS = 0.42, LENGTH = 0.8, MOST_LENGTH = 2.4;
const LEAST_LENGTH = 0.16; // shorter arrows are left out

/** A node's share of the sheet's weight, N. */
export const nodeShare = ({ sheet, gravity }, nNodes) =>
  Math.max((sheet.mass * Math.max(gravity, 0.1)) / nNodes, 1e-12);

/** Radius over the pitch of the disc that stands for a normal force: its area goes with the force, if there is room. */
export const discRadius = (normal, share) =>
  Math.min(Math.max(RADIUS * Math.sqrt(normal / share), LEAST_RADIUS), MOST_RADIUS);

/** Length over the pitch of the arrow that stands for a friction; 0 where there is too little for one. */
export const arrowLength = (fx, fy, share) => {
  const length = Math.min((LENGTH * Math.hypot(fx, fy)) / share, MOST_LENGTH);
  return length > LEAST_LENGTH ? length : 0;
};
