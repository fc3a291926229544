"""Where the plate's work went: the books of a run, and whether they balance."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from plategait.arrays import Array

# Share of the energy given that a ledger may be out by. The presets at their default step stay below 2.5 % over the
# source's whole range (docs/numerics.md); what is out by more has a step too large for it, or a law that makes energy.
LEDGER_TOLERANCE = 0.05

# Lift of the whole sheet whose energy is too small to matter in a ledger, as a share of its size: a tenth of a
# millimetre. Round-off over minutes of a plate that hardly moves stays below a hundredth of it.
LEAST_LIFT = 1e-3

# Energies that a run may begin with; gravity's counts by how far it falls.
_BEGUN = ("kinetic", "axial", "bending", "torsion", "contact")


@dataclass(frozen=True)
class EnergyLedger:
    """Where the plate's work went over a run, J. `residual` is what the time step made or lost: it shrinks with it.

    Attributes
    ----------
    plate_work, kinetic, gravity, elastic, contact_stored, joint_loss, contact_loss, friction_loss : float
        Work of the plate, gains of what is stored, and losses, over the whole run.
    given : float
        Energy that there was to share out: what the plate gave and took from sample to sample, what the run began with,
        and what its fall released. Every share is of this.
    largest_gap : float
        Furthest that the books were out at any sample: energy unaccounted for, energy that a loss had given back, or
        energy stored beyond what the plate had given. The last two let no sum pass in which absurd numbers cancel.
    """

    plate_work: float
    kinetic: float
    gravity: float
    elastic: float
    contact_stored: float
    joint_loss: float
    contact_loss: float
    friction_loss: float
    given: float
    largest_gap: float

    @property
    def residual(self) -> float:
        """Work that none of the others accounts for."""
        return self.plate_work - (
            self.kinetic + self.gravity + self.elastic + self.contact_stored
            + self.joint_loss + self.contact_loss + self.friction_loss
        )  # fmt: skip

    @property
    def relative_residual(self) -> float:
        """Residual at the end over the energy given; NaN where the run has no numbers."""
        return _share(self.residual, self.given)

    @property
    def imbalance(self) -> float:
        """Largest gap over the energy given; NaN where the run has no numbers."""
        return _share(self.largest_gap, self.given)

    @property
    def closes(self) -> bool:
        """Whether the books stayed within `LEDGER_TOLERANCE` all the time; not for a run without numbers."""
        return self.imbalance <= LEDGER_TOLERANCE


def _share(energy: float, given: float) -> float:
    return energy / given if given != 0 else (0.0 if energy == 0 else math.nan)


def energy_ledger(channels: Mapping[str, Array], least: float = 0.0) -> EnergyLedger:
    """Where the plate's work went over a whole recording, from its energy channels.

    Parameters
    ----------
    channels : mapping
        Energies, and work and losses since the sample before, J.
    least : float
        Energy too small to matter, J: added to what was given, so that round-off makes no gap where little moves.
    """

    def gained(name: str) -> Array:
        return channels[name] - channels[name][0]

    with np.errstate(invalid="ignore", over="ignore"):
        contact, work = gained("contact_energy"), np.cumsum(channels["plate_work"])
        elastic = gained("axial_energy") + gained("bending_energy") + gained("torsion_energy")
        stored = gained("kinetic_energy") + gained("gravity_energy") + elastic + contact
        contact_loss = np.cumsum(channels["contact_work"]) - contact
        joint_loss, friction_loss = np.cumsum(channels["joint_loss"]), np.cumsum(channels["friction_loss"])
        lost = joint_loss + contact_loss + friction_loss
        gaps = (np.abs(work - stored - lost), stored - work, -joint_loss, -contact_loss, -friction_loss)
        begun = sum(abs(float(channels[f"{name}_energy"][0])) for name in _BEGUN)
        fallen = float(-gained("gravity_energy").min())
        given = float(np.abs(channels["plate_work"]).sum()) + begun + fallen + least
        return EnergyLedger(
            plate_work=float(work[-1]),
            kinetic=float(gained("kinetic_energy")[-1]),
            gravity=float(gained("gravity_energy")[-1]),
            elastic=float(elastic[-1]),
            contact_stored=float(contact[-1]),
            joint_loss=float(joint_loss[-1]),
            contact_loss=float(contact_loss[-1]),
            friction_loss=float(friction_loss[-1]),
            given=given,
            largest_gap=float(np.max(gaps)) + 0.0,  # no −0
        )


def least_energy(weight: float, size: float) -> float:
    """Energy too small to matter, J, for a sheet of that weight (N) and size (m)."""
    return weight * LEAST_LIFT * size
