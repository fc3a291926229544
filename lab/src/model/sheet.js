// The sheet: its lattice, the mass of a node, and the time step at which its joints are stable. As model/sheet.py.
import { lattice } from "./lattice.js";
import { occupiedSquares } from "./outline.js";

const KEPT = 12;
const held = new Map();

/** Lattice of a sheet, kept by its outline and pitch. @returns {import("./lattice.js").Lattice} */
export function latticeOf(sheet) {
  const key = JSON.stringify([sheet.outline, sheet.pitch]);
  let found = held.get(key);
  if (!found) {
    found = lattice(occupiedSquares(sheet.outline, sheet.pitch));
    if (held.size >= KEPT) held.delete(held.keys().next().value);
    held.set(key, found);
  }
  return found;
}

export const nodeMass = (sheet) => sheet.mass / latticeOf(sheet).nNodes;

/** Largest time step at which the joints are stable, s: the root of a cubic, by Newton's rule from above. */
export function stableTimeStep(sheet) {
  const m = nodeMass(sheet);
  const perPitch = 32 / sheet.pitch ** 2;
  const axial = (8 * sheet.axial_damping) / m;
  const bending = (perPitch * (sheet.bending_damping + sheet.torsion_damping)) / m;
  const inPlane = 4 * (1 + sheet.shear_ratio) * sheet.axial_stiffness;
  const squared = (inPlane + perPitch * (sheet.bending_stiffness + sheet.torsion_stiffness)) / m;
  const unit = 4 / (axial + bending + Math.sqrt((axial + bending) ** 2 + 4 * squared));
  const [a, b, s] = [axial * unit, bending * unit, squared * unit ** 2];
  const [c3, c2, c1] = [(a * s) / 4, s / 2 + a * b, a + 2 * b];
  // As Python writes it: squared/2 + axial · bending.
  let x = 2;
  for (let k = 0; k < 8; k++) x -= (((c3 * x + c2) * x + c1) * x - 4) / ((3 * c3 * x + 2 * c2) * x + c1);
  return unit * x;
}
