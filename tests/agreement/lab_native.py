"""The native core at the level that the lab's module is compiled from, and when a run of the two counts as the same.

The module computes the same numbers in single precision, but rounds them otherwise: it has no estimate of a reciprocal
square root, and fuses no multiplication with an addition. A chaotic sheet doubles such a rounding again and again.
"""

from __future__ import annotations

from itertools import chain
from typing import Any

import numpy as np
from lab_sheets import random_groups

import plategait as pg
from plategait.engine.cpu import Session
from plategait.engine.recording import Recording, RunRequest
from plategait.engine.session import advance_once
from plategait.simulation.observation import Observation, observe

# Four of a lattice fill the module's lanes.
GROUPS = random_groups(13, 4, seed=12, duration=0.3)
CHEESE = pg.preset("cheese").scenario
LONG = [CHEESE.replace(**{"motion.frequency": f, "duration": 1.0}) for f in (12.0, 18.0, 24.0, 30.0)]
RUNS = [*chain.from_iterable(GROUPS), *LONG]

# Of what is not chaotic; of what is, results are within what another start by a rounding does.
SAME_RATE = np.radians(0.5)
SAME_ENERGY = 0.01  # of what was given
A_ROUNDING = 1e-8  # m
LEDGER = {
    "plate_work": "plateWork", "friction_loss": "frictionLoss", "joint_loss": "jointLoss",
    "contact_loss": "contactLoss",
}  # fmt: skip


def advanced(requests: list[RunRequest]) -> list[Recording]:
    """Recordings of the native core."""
    return advance_once(Session(requests, ends=True, instruction_set="baseline"), requests)


def is_same(mine: Observation, told: dict[str, Any]) -> bool:
    """Whether failure, rate, gait and energies are those that the lab tells."""
    rate = float(told["spin"]["rate"])
    return (
        (mine.failure and mine.failure.kind) == (told["failure"] and told["failure"]["kind"])
        and mine.gait == told["gait"]
        and np.isnan(rate) == np.isnan(mine.spin.rate)
        and not abs(rate - mine.spin.rate) > SAME_RATE
        and all(
            abs(float(told["energy"][theirs]) - getattr(mine.energy, own)) <= SAME_ENERGY * mine.energy.given
            for own, theirs in LEDGER.items()
        )
    )


def is_within_the_spread(scenario: pg.Scenario, told: dict[str, Any]) -> bool:
    """Whether what the lab tells of a chaotic run is among what the package shows of starts a rounding apart."""
    starts = [(A_ROUNDING * k, -A_ROUNDING * k, 0.0) for k in range(-6, 7)]
    shown = [observe(scenario, r) for r in advanced([RunRequest(scenario, start) for start in starts])]
    rates, rate = np.array([o.spin.rate for o in shown]), float(told["spin"]["rate"])
    low, high = np.nanmin(rates), np.nanmax(rates)
    return (
        (told["failure"] and told["failure"]["kind"]) in {o.failure and o.failure.kind for o in shown}
        and told["gait"] in {o.gait for o in shown}
        and bool(np.isnan(rate) or low - (high - low) <= rate <= high + (high - low))
    )
