// The sheet: its lattice, the mass of a node, and the time step at which its joints are stable. As model/sheet.py.
import { lattice } from "./lattice.js";
import { checkOutline, occupiedSquares } from "./outline.js";
import {
  AXIAL_DAMPING,
  AXIAL_STIFFNESS,
  BENDING_DAMPING,
  BENDING_STIFFNESS,
  LENGTH,
  MASS,
  RATIO,
  checkNumbers,
} from "./quantity.js";
import { Refusal, checkTable } from "./refusal.js";

const MOST_NODES = 20_000; // that a page simulates
const MOST_KEPT = 12;

// Scenarios are never written to: a lattice is found by its outline, or else by what the outline holds.
const byOutline = new WeakMap();
const byText = new Map();

const cutOf = ({ outline, pitch }) => JSON.stringify([outline, pitch]);

/** Whether two sheets have the same nodes. */
export const areCutAlike = (one, other) => cutOf(one) === cutOf(other);

/** Lattice of a sheet, the same for sheets of like outline and pitch. @returns {import("./lattice.js").Lattice} */
export const latticeOf = ({ outline, pitch }) => {
  const known = byOutline.get(outline);
  if (known?.pitch === pitch) return known.lattice;
  const text = cutOf({ outline, pitch });
  const found = byText.get(text) ?? lattice(occupiedSquares(outline, pitch));
  byText.delete(text);
  byText.set(text, found);
  if (byText.size > MOST_KEPT) byText.delete(byText.keys().next().value);
  byOutline.set(outline, { pitch, lattice: found });
  return found;
};

export const nodeMass = (sheet) => sheet.mass / latticeOf(sheet).nNodes;

const NUMBERS = {
  mass: MASS,
  pitch: LENGTH,
  thickness: LENGTH,
  bending_stiffness: BENDING_STIFFNESS,
  bending_damping: BENDING_DAMPING,
  axial_stiffness: AXIAL_STIFFNESS,
  axial_damping: AXIAL_DAMPING,
  shear_ratio: RATIO,
  torsion_stiffness: BENDING_STIFFNESS,
  torsion_damping: BENDING_DAMPING,
};

/** @throws {Refusal} */
export const checkSheet = (sheet) => {
  checkTable(sheet, "sheet");
  checkOutline(sheet.outline);
  checkNumbers(sheet, "sheet", NUMBERS);
  const { nNodes } = latticeOf(sheet);
  if (nNodes > MOST_NODES) {
    const coarser = Number((1e3 * sheet.pitch * Math.sqrt(nNodes / MOST_NODES) * 1.05).toPrecision(3));
    throw new Refusal(
      "sheet.pitch",
      `${nNodes} nodes`,
      `coarse enough for at most ${MOST_NODES} in a page`,
      `${coarser} mm`,
    );
  }
};

/** Largest time step at which the joints are stable, s: the root of a cubic, by Newton's rule from above. */
export const stableTimeStep = (sheet) => {
  const mass = nodeMass(sheet);
  const perPitch = 32 / sheet.pitch ** 2;
  const wholeAxial = (8 * sheet.axial_damping) / mass;
  const wholeBending = (perPitch * (sheet.bending_damping + sheet.torsion_damping)) / mass;
  const inPlane = 4 * (1 + sheet.shear_ratio) * sheet.axial_stiffness;
  const wholeSquared = (inPlane + perPitch * (sheet.bending_stiffness + sheet.torsion_stiffness)) / mass;
  // In steps of the limit that explicit dampers would have, all coefficients are of the order of 1.
  const unit = 4 / (wholeAxial + wholeBending + Math.sqrt((wholeAxial + wholeBending) ** 2 + 4 * wholeSquared));
  const [axial, bending, squared] = [wholeAxial * unit, wholeBending * unit, wholeSquared * unit ** 2];
  const cubic = [(axial * squared) / 4, squared + (axial * bending) / 2, axial + 2 * bending, -4];
  let x = 2;
  for (let k = 0; k < 8; k++) {
    const value = ((cubic[0] * x + cubic[1]) * x + cubic[2]) * x + cubic[3];
    x -= value / ((3 * cubic[0] * x + 2 * cubic[1]) * x + cubic[2]);
  }
  return unit * x;
};
