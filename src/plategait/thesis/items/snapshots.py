"""Figs. 4.3 and 4.5: what the sheet looks like as it turns, and in each gait."""

from __future__ import annotations

import math
import tempfile
from pathlib import Path

import numpy as np

from plategait import published
from plategait.simulation.result import Simulation
from plategait.simulation.run import FILM_INTERVAL, simulate_all
from plategait.thesis import draw
from plategait.thesis.cases import Case
from plategait.thesis.item import Check, Comparison, Item, Spec, verdict
from plategait.thesis.runs import Results

SHOWN = {"sliding": 8.0, "walking": 10.5, "running": 13.0, "failed": 15.0}
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
    i = runs.case.frequencies.index(12.0)
    comparisons = (
        Comparison(
            "spin rate (deg/s)",
            published.single("rate_12hz"),
            float(runs.curve.spin_rate_deg_s[i]),
            0.15,
            spread=float(runs.curve.spin_rate_sd_deg_s[i]),
        ),
    )
    notes = (
        "The source's experiment gave 370 deg/s (Fig. 4.2). Rates are 10 to 20 % low throughout: docs/fidelity.md.",
    )
    figures = (("fig4.3", picture),) if picture else ()
    return Item(
        spec.name, spec.title, verdict(comparisons, remark=missing), figures, comparisons=comparisons, notes=notes
    )


def fig_4_5(spec: Spec, results: Results) -> Item:
    """Which leg touches when, in each gait, and what the sheet looks like."""
    simulations = _filmed(list(SHOWN.values()))
    figure, panels = draw.panels(4, width=3.4, height=2.4)
    checks: list[Check] = []
    pictures: list[tuple[str, bytes]] = []
    notes: list[str] = []
    runs = results[Case(12)]
    for axes, (behaviour, frequency), simulation, letter in zip(
        panels, SHOWN.items(), simulations, "abcd", strict=True
    ):
        recording = simulation.recordings[0]
        time, period = recording["time"], 1 / frequency
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
        draw.plain(axes, "plate periods", "", f"({letter}) {behaviour}, {frequency:g} Hz: leg in contact")
        curve = runs.curve
        i = runs.case.frequencies.index(frequency)
        found = "failed" if curve.failed[i] else curve.gait[i]
        checks.append(Check(f"{frequency:g} Hz", behaviour, found or "nothing measured", found == behaviour))
        picture, missing = _strip(simulation) if not math.isnan(np.sum(recording["centre_x"])) else (None, "diverged")
        if picture:
            pictures.append((f"fig4.5{letter}", picture))
        elif missing not in notes:
            notes.append(missing)
    return Item(
        spec.name,
        spec.title,
        verdict(checks=checks),
        (("fig4.5", figure), *pictures),
        checks=tuple(checks),
        notes=(*notes, "The source does not print the frequencies; one is shown for each behaviour."),
    )
