// Where the plate's work went: the books of a run, and whether they balance. As the package's simulation/energy.py.

// Share of the energy given that a ledger may be out by.
export const LEDGER_TOLERANCE = 0.05;
// Lift of the whole sheet whose energy is too small to matter in a ledger, as a share of its size.
const LEAST_LIFT = 1e-3;
// Energies that a run may begin with; gravity's counts by how far it falls.
const BEGUN = ["kinetic", "axial", "bending", "torsion", "contact"];

/** Energy too small to matter, J, for a sheet of that weight (N) and size (m). */
export const leastEnergy = (weight, size) => weight * LEAST_LIFT * size;

/**
 * Where the plate's work went over a whole recording, J: work, gains of what is stored, losses, what there was to share
 * out (`given`), what none of it accounts for (`residual`), and the furthest that the books were out at any sample.
 *
 * @param least energy too small to matter, J: added to what was given
 */
export const energyLedger = (channels, least = 0) => {
  const [contactEnergy, gravity] = [channels.contact_energy, channels.gravity_energy];
  const sums = { work: 0, contactWork: 0, joint: 0, friction: 0, exchanged: 0 };
  let [largestGap, lowest, at] = [-Infinity, Infinity, null];
  for (let i = 0; i < channels.time.length; i++) {
    sums.work += channels.plate_work[i];
    sums.exchanged += Math.abs(channels.plate_work[i]);
    sums.contactWork += channels.contact_work[i];
    sums.joint += channels.joint_loss[i];
    sums.friction += channels.friction_loss[i];
    at = {
      kinetic: channels.kinetic_energy[i] - channels.kinetic_energy[0],
      gravity: gravity[i] - gravity[0],
      axial: channels.axial_energy[i] - channels.axial_energy[0],
      bending: channels.bending_energy[i] - channels.bending_energy[0],
      torsion: channels.torsion_energy[i] - channels.torsion_energy[0],
      contactStored: contactEnergy[i] - contactEnergy[0],
    };
    at.elastic = at.axial + at.bending + at.torsion;
    const stored = at.kinetic + at.gravity + at.elastic + at.contactStored;
    const contactLoss = sums.contactWork - at.contactStored;
    const lost = sums.joint + contactLoss + sums.friction;
    // Math.max and Math.min give NaN where one of their numbers is.
    largestGap = Math.max(
      largestGap, Math.abs(sums.work - stored - lost), stored - sums.work, -sums.joint, -contactLoss, -sums.friction,
    );
    lowest = Math.min(lowest, at.gravity);
  }
  const begun = BEGUN.reduce((sum, name) => sum + Math.abs(channels[`${name}_energy`][0]), 0);
  const ledger = {
    plateWork: sums.work,
    ...at,
    jointLoss: sums.joint,
    contactLoss: sums.contactWork - at.contactStored,
    frictionLoss: sums.friction,
    given: sums.exchanged + begun - lowest + least,
    largestGap: largestGap + 0,
  };
  return balanced(ledger);
};

/** The same ledger with its residual, that and the largest gap over the energy given, and whether it closes. */
const balanced = (ledger) => {
  const { kinetic, gravity, elastic, contactStored, jointLoss, contactLoss, frictionLoss } = ledger;
  const accounted = kinetic + gravity + elastic + contactStored + jointLoss + contactLoss + frictionLoss;
  const residual = ledger.plateWork - accounted;
  const imbalance = share(ledger.largestGap, ledger.given);
  return {
    ...ledger,
    residual,
    relativeResidual: share(residual, ledger.given),
    imbalance,
    closes: imbalance <= LEDGER_TOLERANCE,
  };
};

const share = (energy, given) => (given !== 0 ? energy / given : energy === 0 ? 0 : NaN);
