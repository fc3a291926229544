// The natural frequency of a sheet: of the mode that the package's model/modes.py takes, with no plate and no gravity.
//
// A shape such as x² + y² is made of modes; Lanczos' method on the inverse of the stiffness, begun from that shape,
// finds how much of it each mode holds, the lowest first. So few steps do what a whole decomposition does there.
import { BandedMatrix, heldModes } from "./lanczos.js";
import { latticeOf, nodeMass } from "./sheet.js";
import { add, dot, scaled, without } from "./vectors.js";

const MOST_NODES = 3000;
const MOSTLY = 0.6; // share of a shape at which a mode is mostly that shape
const PARTLY = 0.3; // and below which it is not it
const ALIKE = 1e-6; // shares that differ by less are one
const FLAT = 1e-9; // share of a shape that is rounding once the rigid motion is taken out of it
const ROUNDING = 1e-11; // of the largest ω²: what is less is none
const MOST_KEPT = 200;

const kept = new WeakMap();

/** First-order natural angular frequency ω_n, rad/s; NaN where no mode bends the sheet, or it has too many nodes. */
export const naturalFrequency = (sheet) => {
  const lattice = latticeOf(sheet);
  const { bending_stiffness: bending, torsion_stiffness: torsion } = sheet;
  if (lattice.nNodes > MOST_NODES) return NaN;
  // In units of the stiffer joint over m l², what remains is the lattice's and the ratio's own.
  const unit = Math.max(bending, torsion);
  const ratios = unit > 0 ? [bending / unit, torsion / unit] : [0, 0];
  return (unitFrequency(lattice, ratios) * Math.sqrt(unit / nodeMass(sheet))) / sheet.pitch;
};

const unitFrequency = (lattice, ratios) => {
  if (!kept.has(lattice)) kept.set(lattice, new Map());
  const found = kept.get(lattice);
  const key = String(ratios);
  if (found.size > MOST_KEPT) found.clear();
  if (!found.has(key)) found.set(key, Math.sqrt(naturalSquared(lattice, ratios)));
  return found.get(key);
};

/** ω² of the dish, or where no mode is one of the lowest that bends the sheet; NaN where none does. */
const naturalSquared = (lattice, [bending, torsion]) => {
  const matrix = stiffness(lattice, bending, torsion);
  const rigid = rigidMotion(lattice);
  const named = namedModes(matrix, rigid, lattice);
  if (named.dish) return named.dish.squared;
  return lowestSquared(matrix, named.twist ? [...rigid, named.twist.direction] : rigid);
};

/** Matrix of the nodes' deflections, of bending joints and of cells that twist. */
const stiffness = ({ nNodes, lineStart, lineNodes, axial, cells }, bending, torsion) => {
  const elements = [];
  for (let i = 0; i < axial; i++)
    for (let k = lineStart[i]; k + 2 < lineStart[i + 1]; k++)
      elements.push({
        nodes: [lineNodes[k], lineNodes[k + 1], lineNodes[k + 2]],
        weights: [1, -2, 1],
        factor: bending,
      });
  for (let c = 0; c < cells.length; c += 4)
    elements.push({ nodes: [...cells.subarray(c, c + 4)], weights: [1, -1, -1, 1], factor: 2 * torsion });
  return new BandedMatrix(
    nNodes,
    elements.filter(({ factor }) => factor > 0),
  );
};

const columnsOf = ({ nNodes, rest }) =>
  [0, 1].map((axis) => Float64Array.from({ length: nNodes }, (_, k) => rest[2 * k + axis]));

/** Heave, roll and pitch, orthonormal. */
const rigidMotion = (lattice) => {
  const basis = [];
  for (const motion of [new Float64Array(lattice.nNodes).fill(1), ...columnsOf(lattice)]) {
    const own = without(motion, basis);
    if (own.size > FLAT * Math.sqrt(dot(motion, motion))) basis.push(own.unit);
  }
  return basis;
};

/**
 * The modes that are x² + y², x² − y² and xy, as far as the sheet has such: ω² and direction.
 *
 * A shape belongs to the lowest mode that holds most of it, or else to the one that holds the largest share, unless
 * that direction has a name already: the surest name goes first.
 */
const namedModes = (matrix, rigid, lattice) => {
  const [x, y] = columnsOf(lattice);
  const shapes = { dish: (a, b) => a * a + b * b, saddle: (a, b) => a * a - b * b, twist: (a, b) => a * b };
  const held = [];
  let inverse = null;
  for (const [name, of] of Object.entries(shapes)) {
    const shape = x.map((a, k) => of(a, y[k]));
    const bent = without(shape, rigid);
    if (rigid.length < 3 || !(bent.size > FLAT * Math.sqrt(dot(shape, shape)))) continue;
    inverse ??= matrix.inverse(0.1 * matrix.quotient(bent.unit));
    const modes = spacesOf(heldModes(inverse, bent.unit, rigid), ROUNDING * matrix.largest);
    held.push({ name, modes, surest: Math.max(...modes.map(({ share }) => share)) });
  }
  const rounded = (share) => Math.round(share / ALIKE);
  held.sort((a, b) => rounded(b.surest) - rounded(a.surest));
  const named = {};
  for (const { name, modes, surest } of held) {
    const taken = Object.values(named).map(({ direction }) => direction);
    const left = modes.map(({ share, direction }) => without(scaled(direction, share), taken));
    const mostly = left.findIndex(({ size }) => size > MOSTLY);
    const which = mostly >= 0 ? mostly : modes.findIndex(({ share }) => share > (1 - ALIKE) * surest);
    if (left[which].size > PARTLY) named[name] = { squared: modes[which].squared, direction: left[which].unit };
  }
  return named;
};

/** Modes of one frequency as one: what they hold of the shape together, of which rounding made several. */
const spacesOf = (modes, rounding) => {
  const spaces = [];
  for (const { squared, share, direction } of modes) {
    const last = spaces.at(-1);
    if (!last || squared - last.upTo > rounding)
      spaces.push({ squared, upTo: squared, held: scaled(direction, share) });
    else {
      last.upTo = squared;
      add(last.held, direction, share);
    }
  }
  return spaces.map(({ squared, held }) => {
    const { unit, size } = without(held, []);
    return { squared: squared > rounding ? squared : 0, share: size, direction: unit };
  });
};

/** Least ω² above 0 of what is not along some directions: begun from a shape that no symmetry keeps from anything. */
const lowestSquared = (matrix, along) => {
  const { unit, size } = without(
    Float64Array.from({ length: matrix.n }, (_, k) => Math.sin(1.3 * k * k + 0.7)),
    along,
  );
  let squared = 1e-6 * matrix.largest;
  // What is found first tells where to look more closely.
  for (let pass = 0; pass < 2 && size > FLAT; pass++) {
    const modes = heldModes(matrix.inverse(squared), unit, along);
    squared = modes.find((mode) => mode.squared > ROUNDING * matrix.largest)?.squared ?? NaN;
    if (Number.isNaN(squared)) break;
  }
  return size > FLAT && matrix.largest > 0 ? squared : NaN;
};
