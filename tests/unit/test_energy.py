"""The books of a run: what they add up to, and when they do not balance."""

from __future__ import annotations

import math

import numpy as np
import pytest

from plategait.simulation.energy import LEDGER_TOLERANCE, EnergyLedger, energy_ledger


def test_the_ledger_sums():
    n = 50
    rng = np.random.default_rng(5)
    states = ("kinetic", "gravity", "axial", "bending", "torsion", "contact")
    channels = {f"{name}_energy": rng.uniform(0, 1, n) for name in states}
    joint, friction, contact_loss = (np.r_[0.0, rng.uniform(0, 1, n - 1)] for _ in range(3))
    stored = np.diff(channels["contact_energy"], prepend=channels["contact_energy"][0])
    change = sum(np.diff(channels[f"{name}_energy"], prepend=channels[f"{name}_energy"][0]) for name in states)
    channels |= {
        "joint_loss": joint,
        "friction_loss": friction,
        "contact_work": contact_loss + stored,
        "plate_work": change + joint + friction + contact_loss,
    }
    ledger = energy_ledger(channels)
    # Sums of 50 numbers of order one.
    assert ledger.residual == pytest.approx(0, abs=1e-12)
    assert ledger.contact_loss == pytest.approx(contact_loss.sum(), abs=1e-12)
    assert ledger.elastic == pytest.approx(
        sum(channels[f"{name}_energy"][-1] - channels[f"{name}_energy"][0] for name in ("axial", "bending", "torsion"))
    )
    assert ledger.largest_gap == pytest.approx(max(0, np.max(-np.cumsum(joint + friction + contact_loss))), abs=1e-12)
    channels["plate_work"][7] += 0.25
    assert energy_ledger(channels).residual == pytest.approx(0.25, abs=1e-12)
    assert energy_ledger(channels).largest_gap == pytest.approx(0.25, abs=1e-12)
    begun = sum(channels[f"{name}_energy"][0] for name in states if name != "gravity")
    fallen = channels["gravity_energy"][0] - channels["gravity_energy"].min()
    given = np.abs(channels["plate_work"]).sum() + begun + fallen
    assert energy_ledger(channels).given == pytest.approx(given, rel=1e-12)
    assert energy_ledger(channels).relative_residual == pytest.approx(0.25 / given, rel=1e-9)


def balanced(n: int = 100) -> dict[str, np.ndarray]:
    """A plate that gives 1 J by and by, of which friction takes 0.6 J and the contact 0.4 J."""
    names = ("kinetic", "gravity", "axial", "bending", "torsion", "contact")
    channels = {f"{name}_energy": np.zeros(n) for name in names}
    given = np.r_[0.0, np.full(n - 1, 1 / (n - 1))]
    return channels | {
        "plate_work": given, "friction_loss": 0.6 * given, "contact_work": 0.4 * given, "joint_loss": 0 * given,
    }  # fmt: skip


def test_a_balanced_ledger_closes():
    ledger = energy_ledger(balanced())
    assert ledger.closes
    assert ledger.imbalance == pytest.approx(0, abs=1e-12)


@pytest.mark.parametrize("share", [0.5, 2.0])
@pytest.mark.parametrize("sign", [-1, 1])
def test_a_ledger_closes_within_its_tolerance(share, sign):
    channels = balanced()
    channels["plate_work"][50] += sign * share * LEDGER_TOLERANCE
    assert energy_ledger(channels).closes is (share < 1)


def test_absurd_numbers_that_cancel_do_not_close_a_ledger():
    # A node that is suddenly deep in the plate: no work stores the energy, so the contact's loss is as absurd.
    channels = balanced()
    channels["contact_energy"][60:] = 1e11
    ledger = energy_ledger(channels)
    assert abs(ledger.residual) < 1e-4, "float64 at 1e11"
    assert ledger.contact_loss == pytest.approx(-1e11)
    assert not ledger.closes


def test_energy_stored_beyond_what_the_plate_gave_does_not_close_even_when_it_goes_again():
    # A loss that takes it all keeps the sum; it was never given.
    channels = balanced()
    channels["kinetic_energy"][40:50] = 3.0
    channels["friction_loss"][40] -= 3.0
    channels["friction_loss"][50] += 3.0
    ledger = energy_ledger(channels)
    assert ledger.relative_residual == pytest.approx(0, abs=1e-12)
    assert not ledger.closes


def test_a_gain_that_is_gone_at_the_end_is_seen():
    channels = balanced()
    channels["kinetic_energy"][40:50] = 0.2
    assert not energy_ledger(channels).closes
    assert energy_ledger(channels).relative_residual == pytest.approx(0, abs=1e-12)


def test_what_a_run_begins_with_counts_as_given_where_the_plate_rests():
    channels = balanced()
    for name in ("plate_work", "friction_loss", "contact_work"):
        channels[name] = 0 * channels[name]
    channels["gravity_energy"] = np.linspace(1.0, 0.0, 100)
    channels["kinetic_energy"] = 0.5 + np.linspace(0.0, 1.0, 100)
    ledger = energy_ledger(channels)
    assert ledger.given == pytest.approx(1.5)
    assert ledger.closes
    channels["kinetic_energy"] *= 1.2
    assert not energy_ledger(channels).closes


def test_round_off_below_what_matters_opens_no_ledger():
    channels = balanced()
    for name in ("plate_work", "friction_loss", "contact_work"):
        channels[name] = 0 * channels[name]
    channels["kinetic_energy"] += 1e-12 * np.arange(100)
    assert not energy_ledger(channels).closes
    assert energy_ledger(channels, least=1e-8).closes


def test_a_ledger_of_nothing_has_no_residual():
    nothing = EnergyLedger(0, 0, 0, 0, 0, 0, 0, 0, given=0, largest_gap=0)
    assert nothing.relative_residual == 0.0
    assert nothing.closes


def test_a_ledger_without_numbers_claims_no_balance():
    # A diverged run: that nothing was measured must not read as that nothing is missing.
    channels = balanced()
    channels["kinetic_energy"][-1] = math.nan
    ledger = energy_ledger(channels)
    assert math.isnan(ledger.relative_residual)
    assert math.isnan(ledger.imbalance)
    assert not ledger.closes
