"""Figs. 4.3 and 4.5: what the sheet looks like as it turns, and in each gait."""

from __future__ import annotations

import math
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from plategait import published
from plategait.simulation.result import Simulation
from plategait.simulation.run import FILM_INTERVAL, simulate_all
from plategait.thesis import draw
from plategait.thesis.cases import Case
from plategait.thesis.item import Check, Comparison, Item, Spec
from plategait.thesis.runs import CaseRuns, Results

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

BEHAVIOURS = {"sliding": 8.0, "walking": 10.5, "running": 13.0, "failed": 15.0}
"""Plate frequencies at which Fig. 4.5 shows each behaviour, Hz, at A_p = 12 deg."""
_DURATION = 1.0
_PERIODS = 4


def _filmed(frequencies: list[float]) -> list[Simulation]:
    base = Case(12).scenario.replace(duration=_DURATION, transient=0.4)
    scenarios = [base.replace(**{"motion.frequency": f}) for f in frequencies]
    return simulate_all(scenarios, snapshot_interval=FILM_INTERVAL)


def _strip(simulation: Simulation) -> tuple[bytes | None, str]:
    """Film strip of a run as PNG, or why there is none."""
    try:
        from plategait.render import filmstrip
    except ImportError as error:
        return None, f"No pictures: plategait.render cannot be imported ({error})."
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "strip.png"
        filmstrip(simulation, path)
        return path.read_bytes(), ""


def fig_4_3(spec: Spec, results: Results) -> Item:
    """Snapshots of one plate period at 12 Hz and 12 deg."""
    picture, missing = _strip(_filmed([12.0])[0])
    runs = results[Case(12)]
    at_12_hz = runs.case.frequencies.index(12.0)
    return spec.item(
        figures=[(spec.name, picture)] if picture else [],
        comparisons=[
            Comparison(
                "spin rate (deg/s)",
                published.single("rate_12hz"),
                float(runs.curve.spin_rate_deg_s[at_12_hz]),
                0.15,
                spread=float(runs.curve.spin_rate_sd_deg_s[at_12_hz]),
            )
        ],
        notes=[
            "The source's experiment gave 370 deg/s (Fig. 4.2). Rates are 10 to 20 % low throughout: docs/fidelity.md."
        ],
        remark=missing,
    )


def fig_4_5(spec: Spec, results: Results) -> Item:
    """Which leg touches when, in each gait, and what the sheet looks like."""
    simulations = dict(zip("abcd", _filmed(list(BEHAVIOURS.values())), strict=True))
    strips = {
        letter: (None, "diverged") if _diverged(simulation) else _strip(simulation)
        for letter, simulation in simulations.items()
    }
    missing = dict.fromkeys(reason for picture, reason in strips.values() if not picture)
    return spec.item(
        figures=[
            (spec.name, _draw_contacts(simulations)),
            *((f"{spec.name}{letter}", picture) for letter, (picture, _) in strips.items() if picture),
        ],
        checks=_judge_behaviours(results[Case(12)]),
        notes=[*missing, "The source does not print the frequencies; one is shown for each behaviour."],
    )


def _diverged(simulation: Simulation) -> bool:
    return math.isnan(np.sum(simulation.recordings[0]["centre_x"]))


def _draw_contacts(simulations: dict[str, Simulation]) -> Figure:
    figure, panels = draw.panels(4, width=3.4, height=2.4)
    for axes, (letter, simulation), (behaviour, frequency) in zip(
        panels, simulations.items(), BEHAVIOURS.items(), strict=True
    ):
        _draw_legs(axes, simulation, 1 / frequency)
        draw.plain(axes, "plate periods", "", f"({letter}) {behaviour}, {frequency:g} Hz: leg in contact")
    return figure


def _draw_legs(axes: Axes, simulation: Simulation, period: float) -> None:
    """When each leg touches the plate, over the last periods."""
    recording = simulation.recordings[0]
    time = recording["time"]
    last = time > time[-1] - _PERIODS * period
    for row, channel in enumerate(("left_contact", "right_contact")):
        axes.fill_between(
            (time[last] - time[-1]) / period,
            row,
            row + 0.8 * recording[channel][last],
            color=draw.COLOURS[row],
            lw=0,
            step="pre",
        )
    axes.set_yticks([0.4, 1.4], ["left", "right"])


def _judge_behaviours(runs: CaseRuns) -> list[Check]:
    checks = []
    for behaviour, frequency in BEHAVIOURS.items():
        i = runs.case.frequencies.index(frequency)
        measured = "failed" if runs.curve.failed[i] else runs.curve.gait[i]
        checks.append(Check(f"{frequency:g} Hz", behaviour, measured or "nothing measured", measured == behaviour))
    return checks
