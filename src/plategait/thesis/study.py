"""Which figures and tables there are, and how a choice of them is made."""

from __future__ import annotations

import difflib
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from plategait.errors import InputError
from plategait.thesis.cases import GAIT_ANGLES, Case, fitted_cases, reference_cases, with_half_step
from plategait.thesis.item import Item, Spec
from plategait.thesis.items import (
    acceleration,
    choices,
    estimates,
    friction,
    gaits,
    lorentz,
    pressure,
    snapshots,
    softness,
    spin_curves,
    tables,
    targets,
    trends,
)
from plategait.thesis.runs import run_cases


def _by_amplitude_and_stiffness() -> list[Case]:
    return [Case(angle) for angle in GAIT_ANGLES] + [case for case in reference_cases() if case.angle_deg == 3]


def _examples() -> list[Case]:
    return [case for case in with_half_step() if case.angle_deg == 3]


def _at_3_deg() -> list[Case]:
    return [case for case in fitted_cases() if case.angle_deg == 3]


def _at_12_deg() -> list[Case]:
    return [case for case in fitted_cases() if case.angle_deg == 12]


# Of the time, what the runs take, about; the rest goes into fits and figures.
_RUNS = 0.92
_SPECS = (
    Spec("targets", "Targets against what was measured", targets.targets, targets.target_cases),
    Spec("fig2.6", "Pressure and friction under the object", pressure.fig_2_6),
    Spec("fig2.11", "Spin rate of a soft and a rigid object over A_p", softness.fig_2_11, softness.pancake_cases),
    Spec("table4.1", "Parameters of the object", tables.table_4_1),
    Spec("fig4.3", "Snapshots at 12 Hz and 12 deg", snapshots.fig_4_3, lambda: [Case(12)]),
    Spec(
        "fig4.4",
        "Spin rate and gait over ω_p/ω_n at A_p = 12 deg",
        gaits.fig_4_4,
        lambda: [Case(12), Case(12).but("half step")],
    ),
    Spec("fig4.5", "The gaits", snapshots.fig_4_5, lambda: [Case(12)]),
    Spec("fig4.6", "Spin rate over frequency by A_p", gaits.fig_4_6, lambda: [Case(a) for a in GAIT_ANGLES]),
    Spec("fig4.7", "Best acceleration of eight objects", acceleration.fig_4_7, acceleration.stiffness_cases),
    Spec("fig4.8", "Best friction angle of each gait", friction.fig_4_8, friction.friction_cases),
    Spec("fig5.2", "Spin curves by A_p and by ω_n", spin_curves.fig_5_2, _by_amplitude_and_stiffness),
    Spec("fig5.3", "Lorentz distribution", lorentz.fig_5_3),
    Spec("fig5.4", "Three spin curves with their fits", lorentz.fig_5_4, _examples),
    Spec("fig5.5", "The 44 spin curves", spin_curves.fig_5_5, with_half_step),
    Spec("fig5.6", "ω_Br max against ω_n", trends.fig_regression, fitted_cases),
    Spec("fig5.7", "ω_n against f0, (5.6)", trends.fig_regression, fitted_cases),
    Spec("fig5.8", "α against b", trends.fig_regression, fitted_cases),
    Spec("fig5.9", "α against b/f0, (5.7)", trends.fig_regression, fitted_cases),
    Spec("fig5.10", "b/f0 against the damping of the joints", trends.fig_5_10, trends.damping_cases),
    Spec("fig5.11", "Estimated against real ω_n", estimates.fig_estimates, fitted_cases),
    Spec("fig5.12", "Estimated against real α", estimates.fig_estimates, fitted_cases),
    *(
        Spec(f"table5.{i}", f"Estimates, Table 5.{i}", tables.table_estimates, _at_3_deg if i < 5 else _at_12_deg)
        for i in range(1, 9)
    ),
    Spec("table5.9", "Bending and rotation frequency", tables.table_5_9, with_half_step),
    Spec("fig5.15", "Bending and rotation frequency at A_p = 3 deg", trends.fig_5_15, _at_3_deg),
    Spec("tableA.1", "R² of the fits at A_p = 3 deg", tables.table_a, _at_3_deg),
    Spec("tableA.2", "R² of the fits at A_p = 12 deg", tables.table_a, _at_12_deg),
    Spec("appendixB", "t-tests of slope and intercept, Tables B.1 and B.2", estimates.appendix_b, fitted_cases),
    Spec("choices", "Modelling choices that the source leaves open", choices.choices, choices.choice_cases),
)

NAMES = tuple(spec.name for spec in _SPECS)
"""Figures, tables and pages that can be asked for."""


@dataclass(frozen=True, eq=False)
class Study:
    """Items that were made.

    Attributes
    ----------
    items : tuple of Item
    simulated, wall : float
        Simulated time, and time taken, s.
    repeats, seed : int
        Starts of each run.
    """

    items: tuple[Item, ...]
    simulated: float
    wall: float
    repeats: int
    seed: int

    def __getitem__(self, name: str) -> Item:
        """Item by name."""
        return next(item for item in self.items if item.name == name)

    def summary(self) -> dict[str, Any]:
        """Plain numbers for `--json`."""
        return {
            "simulated_s": self.simulated,
            "wall_s": self.wall,
            "repeats": self.repeats,
            "seed": self.seed,
            "items": [item.summary() for item in self.items],
        }


def reproduce(
    names: Sequence[str] | None = None,
    *,
    repeats: int = 4,
    seed: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Study:
    """Make figures and tables of the dissertation, all by default.

    Parameters
    ----------
    names : sequence of str, optional
        Some of `NAMES`.
    repeats : int
        Slightly different starts of each run.
    seed : int
        Of the starts.
    progress : callable, optional
        Called with the fraction done: of the simulations, then of the figures and tables.

    Raises
    ------
    InputError
        For an unknown name.
    """
    begun = time.perf_counter()
    wanted = NAMES if names is None else {item_name(name) for name in names}
    specs = [spec for spec in _SPECS if spec.name in wanted]
    cases = {case for spec in specs for case in spec.cases()}
    runs_of_all = _RUNS if cases else 0.0
    report = None if progress is None else lambda done: progress(runs_of_all * done)
    results = run_cases(cases, repeats=repeats, seed=seed, progress=report)
    items: list[Item] = []
    for spec in specs:
        items.append(spec.make(spec, results))
        if progress is not None:
            progress(runs_of_all + (1 - runs_of_all) * len(items) / len(specs))
    return Study(tuple(items), results.simulated, time.perf_counter() - begun, repeats, seed)


def simulates(names: Sequence[str]) -> bool:
    """Whether any of these items is made from runs; some are closed forms or tables of what was given."""
    return any(spec.name in names and spec.cases() for spec in _SPECS)


def item_name(name: str) -> str:
    """Name of an item as `NAMES` has it, whatever its case.

    Raises
    ------
    InputError
        When there is none of that name.
    """
    by_lower = {n.lower(): n for n in NAMES}
    wanted = name.lower().replace(" ", "").replace("figure", "fig")
    if wanted not in by_lower:
        near = difflib.get_close_matches(wanted, by_lower, 1, 0.0)
        raise InputError("name", name, f"one of {', '.join(NAMES)}", by_lower[near[0]] if near else NAMES[0])
    return by_lower[wanted]
