"""Chapter 2: why an object spins on the plate, and how much faster a soft one does."""

from __future__ import annotations

import math

import numpy as np

from plategait import published
from plategait.model.presets import preset
from plategait.theory import rigid as theory
from plategait.thesis import draw
from plategait.thesis.cases import PANCAKE_ANGLES, Case
from plategait.thesis.item import Check, Comparison, Item, Spec, Table, verdict
from plategait.thesis.runs import Results


def fig_2_6(spec: Spec, results: Results) -> Item:
    """Pressure and friction along y under a rigid disk, and what bending takes away."""
    scenario = preset("pancake").scenario
    radius, mass = 0.042, scenario.sheet.mass
    area = math.pi * radius**2
    friction, limit = scenario.friction.static, theory.full_contact_limit(radius)
    y = np.linspace(-radius, radius, 201)
    figure, panels = draw.panels(3, width=3.6, height=3.2)
    states = (("(a) at rest", 0.0, 0.0), ("(b) Ẍ only", 0.0, -1.0), ("(c) Ẍ and Θ̈", 0.8 * limit, -1.0))
    rows = []
    for axes, (title, acceleration, slip) in zip(panels, states, strict=True):
        pressure = theory.pressure(y, acceleration, mass, area)
        shear = friction * abs(slip) * pressure
        axes.fill_between(1e3 * y, pressure, color=draw.COLOURS[5], alpha=0.5, label="pressure")
        axes.plot(1e3 * y, shear, color=draw.COLOURS[3], label="friction")
        axes.set_ylim(-1, 38)
        draw.plain(axes, "y across the bar (mm)", "Pa", title)
        axes.legend(frameon=False, fontsize=8)
        rows += [(title, 1e3 * u, p, s) for u, p, s in zip(y[::10], pressure[::10], shear[::10], strict=True)]
    moment = theory.disk_rotation_moment(radius, mass, friction, -1.0, 0.8 * limit)
    whole, kept = float(moment.total), float(moment.contributing)
    # Equation (2.2) by numbers, as the figure draws it.
    strip = 2 * np.sqrt(np.maximum(radius**2 - y**2, 0)) * theory.pressure(y, 0.8 * limit, mass, area)
    by_hand = float(np.trapezoid(friction * y * strip, y))
    turning = float(theory.disk_rotation_moment(radius, mass, friction, -1.0, 0.0).total)
    checks = (
        Check("no moment without Θ̈ (b)", "0", f"{turning:.1e} N·m", abs(turning) < 1e-12),
        Check("Ẍ Θ̈ > 0 turns clockwise (c)", "above 0", f"{1e6 * whole:.1f} µN·m", whole > 0),
        Check(
            "moment from (2.3)",
            "that of (2.2) summed over the disk",
            f"{1e6 * by_hand:.1f} µN·m",
            abs(by_hand / whole - 1) < 0.01,
        ),
        Check("without the braking half (d)", "a larger moment", f"{kept / whole:.1f} times as large", kept > whole),
    )
    return Item(
        spec.name,
        spec.title,
        verdict(checks=checks),
        (("fig2.6", figure),),
        (Table("fig2.6", ("state", "y (mm)", "pressure (Pa)", "friction (Pa)"), tuple(rows)),),
        checks=checks,
        notes=(
            "Closed forms, drawn for the 10 g pancake at 80 % of the Θ̈ at which its edge lifts. The source "
            "prints no numbers here. (d) is not drawn but stands as the moment that is left without the braking half.",
        ),
    )


def pancake_cases() -> list[Case]:
    """Cases of Fig. 2.11."""
    return [Case(a, thing=thing) for thing in ("pancake", "rigid-twin") for a in PANCAKE_ANGLES]


def fig_2_11(spec: Spec, results: Results) -> Item:
    """Spin rate of the pancake and of its rigid twin over the plate's amplitude."""
    figure, (axes,) = draw.panels(1)
    angles = np.array(PANCAKE_ANGLES, dtype=float)
    rates, failed, rows = {}, {}, []
    for thing, marker, colour in (("pancake", "s", draw.COLOURS[0]), ("rigid-twin", "o", draw.COLOURS[3])):
        runs = [results[Case(a, thing=thing)] for a in PANCAKE_ANGLES]
        rates[thing] = np.array([r.curve.spin_rate_deg_s[0] for r in runs])
        failed[thing] = np.array([r.curve.failed[0] for r in runs])
        ok = ~failed[thing]
        sd = np.nan_to_num([r.curve.spin_rate_sd_deg_s[0] for r in runs])
        axes.errorbar(angles[ok], rates[thing][ok], sd[ok], fmt=f"{marker}-", mfc="white", color=colour, label=thing)
        if not ok.all():
            axes.plot(angles[~ok], np.zeros((~ok).sum()), "x", color=colour, label=f"{thing}: failed")
        rows += [
            (thing, a, c.spin_rate_deg_s[0], c.spin_rate_sd_deg_s[0], c.gait[0], c.failure_in_words[0])
            for a, c in zip(PANCAKE_ANGLES, (r.curve for r in runs), strict=True)
        ]
    known = ((16, "rigid_16"), (16, "soft_16"), (24, "soft_24"))
    axes.plot([a for a, _ in known], [published.single(n).value for _, n in known], **draw.PUBLISHED)
    axes.legend(frameon=False, fontsize=8)
    draw.plain(axes, "amplitude $A_p$ (deg)", "spin rate (deg/s)")

    def at(thing: str, angle: int) -> float:
        return float(rates[thing][PANCAKE_ANGLES.index(angle)])

    def spread(thing: str, angle: int) -> float:
        return float(results[Case(angle, thing=thing)].curve.spin_rate_sd_deg_s[0])

    comparisons = tuple(
        Comparison(
            f"{thing} at {angle} deg (deg/s)",
            published.single(number),
            at(thing, angle),
            0.5,
            spread=spread(thing, angle),
        )
        for thing, angle, number in (
            ("rigid-twin", 16, "rigid_16"),
            ("pancake", 16, "soft_16"),
            ("pancake", 24, "soft_24"),
        )
    )
    soft_over_rigid = at("pancake", 16) / at("rigid-twin", 16)
    rises = max(at("pancake", a) for a in (16, 18, 20)) / at("pancake", 10)
    checks = (
        Check(
            "soft against rigid at 16 deg",
            "more than three times as fast",
            f"{soft_over_rigid:.1f} times",
            soft_over_rigid > 3,
        ),
        Check(
            "the pancake's rate rises steeply above 10 deg",
            "at least doubles by 20 deg",
            f"{rises:.1f} times",
            rises > 2,
        ),
    )
    return Item(
        spec.name,
        spec.title,
        verdict(comparisons, checks),
        (("fig2.11", figure),),
        (Table("fig2.11", ("object", "A_p (deg)", "ω_B (deg/s)", "sd (deg/s)", "gait", "failure"), tuple(rows)),),
        comparisons,
        checks,
        (
            "An experiment: neither the pancake's stiffness nor its friction is printed, and both presets infer "
            "them (ω_n = 7π, μ_s = 0.60).",
        ),
    )
