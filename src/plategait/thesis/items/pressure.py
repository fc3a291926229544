"""Fig. 2.6: pressure and friction under the object, and why it turns."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from plategait.arrays import Array
from plategait.model.presets import preset
from plategait.plots.style import legend_below
from plategait.theory import rigid
from plategait.thesis import draw
from plategait.thesis.item import Cell, Check, Item, Spec, Table
from plategait.thesis.runs import Results

if TYPE_CHECKING:
    from matplotlib.figure import Figure

# Panels of Fig. 2.6: title, Θ̈ as a share of that at which the edge lifts, and slip velocity, of which the sign counts.
_STATES = (("(a) at rest", 0.0, 0.0), ("(b) Ẍ only", 0.0, -1.0), ("(c) Ẍ and Θ̈", 0.8, -1.0))


@dataclass(frozen=True)
class _Disk:
    """The pancake, taken for rigid."""

    radius: float
    mass: float
    friction: float

    @property
    def across(self) -> Array:
        """Places across the bar, m."""
        return np.linspace(-self.radius, self.radius, 201)

    def acceleration(self, share: float) -> float:
        """Θ̈ (rad/s²) as a share of that at which the edge lifts."""
        return share * rigid.full_contact_limit(self.radius)

    def pressure(self, share: float) -> Array:
        """Pressure (2.1) at each place across the bar, Pa."""
        return rigid.pressure(self.across, self.acceleration(share), self.mass, math.pi * self.radius**2)

    def shear(self, share: float, slip: float) -> Array:
        """Friction at each place across the bar, Pa."""
        return self.friction * abs(slip) * self.pressure(share)

    def moment(self, share: float) -> rigid.RotationMoment:
        """Moment (2.3) of a disk that slips, N m."""
        return rigid.disk_rotation_moment(self.radius, self.mass, self.friction, -1.0, self.acceleration(share))

    def summed_moment(self, share: float) -> float:
        """Moment by summing (2.2) over strips along the bar, as the figure draws it, N m."""
        y = self.across
        strip = 2 * np.sqrt(np.maximum(self.radius**2 - y**2, 0)) * self.pressure(share)
        return float(np.trapezoid(self.friction * y * strip, y))


def fig_2_6(spec: Spec, results: Results) -> Item:
    """Pressure and friction along y under a rigid disk, and what bending takes away."""
    scenario = preset("pancake").scenario
    disk = _Disk(0.042, scenario.sheet.mass, scenario.friction.static)
    return spec.item(
        figures=[(spec.name, _draw_pressures(disk))],
        tables=[Table(spec.name, ("state", "y (mm)", "pressure (Pa)", "friction (Pa)"), _pressure_rows(disk))],
        checks=_judge_moments(disk),
        notes=[
            "Closed forms, drawn for the 10 g pancake at 80 % of the Θ̈ at which its edge lifts. The source "
            "prints no numbers here. (d) is not drawn but stands as the moment that is left without the braking half."
        ],
    )


def _pressure_rows(disk: _Disk) -> tuple[tuple[Cell, ...], ...]:
    """Every tenth place of every state."""
    return tuple(
        (title, 1e3 * y, pressure, shear)
        for title, share, slip in _STATES
        for y, pressure, shear in zip(
            disk.across[::10], disk.pressure(share)[::10], disk.shear(share, slip)[::10], strict=True
        )
    )


def _draw_pressures(disk: _Disk) -> Figure:
    figure, panels = draw.panels(3, width=3.6, height=3.2)
    for axes, (title, share, slip) in zip(panels, _STATES, strict=True):
        axes.fill_between(1e3 * disk.across, disk.pressure(share), color=draw.COLOURS[5], alpha=0.5, label="pressure")
        axes.plot(1e3 * disk.across, disk.shear(share, slip), color=draw.COLOURS[3], label="friction")
        axes.set_ylim(-1, 38)
        draw.plain(axes, "$y$ across the bar (mm)", "pressure, friction (Pa)", title)
    legend_below(figure)
    return figure


def _judge_moments(disk: _Disk) -> tuple[Check, ...]:
    moment = disk.moment(0.8)
    whole, contributing = float(moment.total), float(moment.contributing)
    level, summed = float(disk.moment(0.0).total), disk.summed_moment(0.8)
    return (
        Check("no moment without Θ̈ (b)", "0", f"{level:.1e} N·m", abs(level) < 1e-12),
        Check("Ẍ Θ̈ > 0 turns clockwise (c)", "above 0", f"{1e6 * whole:.1f} µN·m", whole > 0),
        Check(
            "moment from (2.3)",
            "that of (2.2) summed over the disk",
            f"{1e6 * summed:.1f} µN·m",
            abs(summed / whole - 1) < 0.01,
        ),
        Check(
            "without the braking half (d)",
            "a larger moment",
            f"{contributing / whole:.1f} times as large",
            contributing > whole,
        ),
    )
