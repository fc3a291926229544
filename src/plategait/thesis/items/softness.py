"""Fig. 2.11: how much faster a soft object spins than a rigid one."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from plategait import published
from plategait.arrays import Array
from plategait.curve.curve import Curve
from plategait.plots.failures import Failures
from plategait.thesis import draw
from plategait.thesis.cases import PANCAKE_ANGLES, Case
from plategait.thesis.item import Cell, Check, Comparison, Item, Spec, Table
from plategait.thesis.runs import Results

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_OBJECTS = ("pancake", "rigid-twin")
# Printed rates of Fig. 2.11: object, A_p in deg, name of the number.
_PRINTED = (("rigid-twin", 16, "rigid_16"), ("pancake", 16, "soft_16"), ("pancake", 24, "soft_24"))


def pancake_cases() -> list[Case]:
    """Cases of Fig. 2.11."""
    return [Case(a, preset=name) for name in _OBJECTS for a in PANCAKE_ANGLES]


@dataclass(frozen=True, eq=False)
class _AmplitudeSweep:
    """What one object does over A_p, at one plate frequency.

    Attributes
    ----------
    curves : tuple of Curve
        By `PANCAKE_ANGLES`, each of one point.
    """

    curves: tuple[Curve, ...]

    @property
    def rate(self) -> Array:
        """Spin rates, deg/s."""
        return np.array([c.spin_rate_deg_s[0] for c in self.curves])

    @property
    def sd(self) -> Array:
        """Their spread over the starts, deg/s; NaN of a single one."""
        return np.array([c.spin_rate_sd_deg_s[0] for c in self.curves])

    @property
    def failed(self) -> np.ndarray:
        """Whether it failed."""
        return np.array([c.failed[0] for c in self.curves])

    def rate_at(self, angle: int) -> float:
        """Spin rate at one A_p (deg), deg/s."""
        return float(self.rate[PANCAKE_ANGLES.index(angle)])

    def sd_at(self, angle: int) -> float:
        """Its spread, deg/s."""
        return float(self.sd[PANCAKE_ANGLES.index(angle)])


def fig_2_11(spec: Spec, results: Results) -> Item:
    """Spin rate of the pancake and of its rigid twin over the plate's amplitude."""
    sweeps = {
        name: _AmplitudeSweep(tuple(results[Case(a, preset=name)].curve for a in PANCAKE_ANGLES)) for name in _OBJECTS
    }
    columns = ("object", "A_p (deg)", "ω_B (deg/s)", "sd (deg/s)", "gait", "failure")
    return spec.item(
        figures=[(spec.name, _draw_amplitudes(sweeps))],
        tables=[Table(spec.name, columns, _amplitude_rows(sweeps))],
        comparisons=[
            Comparison(
                f"{name} at {angle} deg (deg/s)",
                published.single(number),
                sweeps[name].rate_at(angle),
                0.5,
                spread=sweeps[name].sd_at(angle),
            )
            for name, angle, number in _PRINTED
        ],
        checks=_judge_softness(sweeps["pancake"], sweeps["rigid-twin"]),
        notes=[
            "An experiment: neither the pancake's stiffness nor its friction is printed, and both presets infer "
            "them (ω_n = 7π, μ_s = 0.60)."
        ],
    )


def _amplitude_rows(sweeps: dict[str, _AmplitudeSweep]) -> tuple[tuple[Cell, ...], ...]:
    return tuple(
        (name, angle, c.spin_rate_deg_s[0], c.spin_rate_sd_deg_s[0], c.gait[0], c.failure_in_words[0])
        for name, sweep in sweeps.items()
        for angle, c in zip(PANCAKE_ANGLES, sweep.curves, strict=True)
    )


def _draw_amplitudes(sweeps: dict[str, _AmplitudeSweep]) -> Figure:
    figure, (axes,) = draw.panels(1, width=6)
    angles, failures = np.array(PANCAKE_ANGLES, dtype=float), []
    for (name, sweep), marker, colour in zip(sweeps.items(), "so", (draw.COLOURS[0], draw.COLOURS[3]), strict=True):
        ok, sd = ~sweep.failed, np.nan_to_num(sweep.sd)
        axes.errorbar(angles[ok], sweep.rate[ok], sd[ok], fmt=f"{marker}-", mfc="white", color=colour, label=name)
        kinds = [kind for c in sweep.curves for kind, fails in zip(c.failure, c.failed, strict=True) if fails]
        failures.append(Failures(angles[~ok], kinds, colour, "-"))
    axes.plot([a for _, a, _ in _PRINTED], [published.single(n).value for _, _, n in _PRINTED], **draw.PUBLISHED)
    draw.plain(axes, "angular amplitude $A_p$ (deg)", draw.RATE)
    draw.finish(axes, failures)
    return figure


def _judge_softness(soft: _AmplitudeSweep, rigid_twin: _AmplitudeSweep) -> tuple[Check, ...]:
    over_rigid = soft.rate_at(16) / rigid_twin.rate_at(16)
    rise = max(soft.rate_at(a) for a in (16, 18, 20)) / soft.rate_at(10)
    return (
        Check(
            "soft against rigid at 16 deg", "more than three times as fast", f"{over_rigid:.1f} times", over_rigid > 3
        ),
        Check(
            "the pancake's rate rises steeply above 10 deg", "at least doubles by 20 deg", f"{rise:.1f} times", rise > 2
        ),
    )
