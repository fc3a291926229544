"""How near a preset comes to the published curves, and the default step to a small one, as the tables of the docs.

``python -m benchmarks.fidelity [--preset cheese] [--part fits vertex typed twelve steps tiles] [--curves FOLDER]``
"""

from __future__ import annotations

import argparse
import itertools
import math
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from plategait import published
from plategait.curve.curve import Curve
from plategait.curve.curve_file import read_curve, write_curve
from plategait.curve.protocol import REGENERATED, measured_as
from plategait.curve.spin_curve import fit_curve, spin_curve
from plategait.engine.engines import Engine
from plategait.model.presets import NOMINAL_NATURAL_FREQUENCY, preset
from plategait.model.scenario import Scenario
from plategait.published import FRICTION_RATIO, REFERENCE_ALPHA, PublishedCurve
from plategait.simulation.run import simulate_all
from plategait.study.aims import PEAKS
from plategait.study.evaluation import FREQUENCIES, is_reference
from plategait.thesis.runs import STRICT_SLIP_LIMIT

CASES = tuple(c for c in published.curves() if is_reference(c))
GRID = {3: "12:34:1Hz", 12: "6:15.5:0.5Hz"}
STEP_GRID = {3: np.arange(12.0, 28.0), 12: np.arange(8.0, 14.0, 0.5)}
SMALL_STEP = 5e-6
LAWS = ("thesis", "adams")


def scenario_of(name: str, case: PublishedCurve) -> Scenario:
    """The preset as the object of a published curve, under its plate motion."""
    base = preset(name).scenario
    sheet = base.sheet.with_natural_frequency(case.omega_pi * math.pi, NOMINAL_NATURAL_FREQUENCY)
    return base.replace(
        sheet=sheet,
        friction=base.friction.with_angle(math.radians(REFERENCE_ALPHA)).with_ratio(FRICTION_RATIO),
        **{"motion.angle": math.radians(case.angle_deg)},
    )


def with_step_halved(scenario: Scenario) -> Scenario:
    """The same at half its time step."""
    return scenario.replace(time_step=0.5 * scenario.dt)


def fits(name: str, cases: Sequence[PublishedCurve]) -> None:
    """Fits against fits, at the default step and at half of it."""
    heads = ["A_p, ω_n", "published f0", "our f0, 95 %", "off", "half step", "published ω_Br max", "ours"]
    print_row([*heads, "published b/f0", "ours", "R²"])
    print_row(["---"] * 10)
    for case in cases:
        scenario = measured_as(scenario_of(name, case))
        made = [spin_curve(s, GRID[case.angle_deg], repeats=4) for s in (scenario, with_step_halved(scenario))]
        fit, half = made[0].fit, made[1].fit
        if fit is None:
            print_row([label(case), made[0].no_fit])
            continue
        low, high = fit.f0_interval
        moved = "no fit" if half is None else f"{100 * (half.f0_hz / fit.f0_hz - 1):+.1f} %"
        print_row([
            label(case), f"{case.f0_hz:.1f} Hz", f"{fit.f0_hz:.1f} Hz, {low:.1f}–{high:.1f}",
            f"{100 * (fit.f0_hz / case.f0_hz - 1):+.1f} %", moved, f"{PEAKS[case.angle_deg, case.omega_pi]:.0f} deg/s",
            f"{fit.peak:.0f}", f"{case.b_over_f0:.3f}", f"{fit.half_width_hz / fit.f0_hz:.3f}", f"{fit.r2:.2f}",
        ])  # fmt: skip


def label(case: PublishedCurve) -> str:
    """Amplitude and object of a curve."""
    return f"{case.angle_deg} deg, {case.omega_pi:g} π"


def print_row(cells: Sequence[str]) -> None:
    """One row of a table."""
    print(f"| {' | '.join(cells)} |")


def vertex_of(curve: Curve) -> float:
    """Vertex of a parabola through the points above 85 % of the highest rate, Hz."""
    used = curve.fitted
    f, rate = curve.frequency_hz[used], curve.spin_rate_deg_s[used]
    near = rate > 0.85 * rate.max()
    a, b, _ = np.polyfit(f[near], rate[near], 2)
    return float(-b / (2 * a))


def vertex(name: str, cases: Sequence[PublishedCurve]) -> None:
    """Vertices, and highest rates and gaits by the source's own limit of slip."""
    print_row(["A_p, ω_n", "vertex", "off", "highest rate", "gaits"])
    print_row(["---"] * 5)
    for case in cases:
        scenario = scenario_of(name, case).replace(duration=4.0, slip_limit=STRICT_SLIP_LIMIT)
        curve = spin_curve(scenario, GRID[case.angle_deg], repeats=4)
        f0 = vertex_of(spin_curve(measured_as(scenario), GRID[case.angle_deg], repeats=4))
        gaits = "".join("!" if failed else g[:1] for g, failed in zip(curve.gait, curve.failed, strict=True))
        rate = np.where(curve.failed, -math.inf, curve.spin_rate_deg_s).max()
        off = f"{100 * (f0 / case.f0_hz - 1):+.1f} %"
        print_row([label(case), f"{f0:.1f} Hz", off, f"{rate:.0f} deg/s", f"`{gaits}`"])


def typed(name: str, cases: Sequence[PublishedCurve]) -> None:
    """What `plategait curve` gives as typed."""
    curve = spin_curve(preset(name).scenario, "12:30:1Hz")
    fit = curve.fit
    print(curve.no_fit if fit is None else f"f0 {fit.f0_hz:.2f} Hz {fit.f0_interval}, {fit.peak:.0f}")


def twelve(name: str, cases: Sequence[PublishedCurve]) -> None:
    """A_p = 12 deg at 12 Hz, at the default step and an eighth of it."""
    one = preset(name).scenario.replace(**{"motion.frequency": 12.0, "motion.angle": math.radians(12)})
    for scenario in (one, one.replace(time_step=one.dt / 8)):
        for repeats in (1, 4):
            (run,) = simulate_all([scenario], repeats=repeats)
            print(f"step {scenario.dt:g} s, {repeats} starts: {math.degrees(run.spin_rate):.0f} deg/s, {run.gait}")


def steps(name: str, cases: Sequence[PublishedCurve]) -> None:
    """Rates at the default step, with either friction law at half of it too, against those at a small one, per cent."""
    for law, (angle, grid) in itertools.product(LAWS, STEP_GRID.items()):
        scenarios = [
            scenario_of(name, case).replace(duration=3.0, **{"friction.law": law, "motion.frequency": float(f)})
            for case in cases if case.angle_deg == angle for f in grid
        ]  # fmt: skip
        small = simulate_all([s.replace(time_step=SMALL_STEP) for s in scenarios], repeats=2, engine="cpu64")
        for title, of in (("default step", lambda s: s), ("half of it", with_step_halved)):
            rates = simulate_all([of(s) for s in scenarios], repeats=2)
            off = np.array([
                math.nan if a.failed or b.failed else 100 * (a.spin_rate / b.spin_rate - 1)
                for a, b in zip(rates, small, strict=True)
            ])  # fmt: skip
            kept = off[np.isfinite(off)]
            rms, worst = np.sqrt((kept**2).mean()), np.abs(kept).max()
            print(f"\n{law}, A_p = {angle} deg, {title}: {len(kept)} points, r.m.s. {rms:.2f} %, worst {worst:.1f} %\n")
            print_row(["Hz", *(f"{f:g}" for f in grid)])
            print_row(["---"] * (len(grid) + 1))
            named = [c for c in cases if c.angle_deg == angle]
            for case, row in zip(named, off.reshape(len(named), -1), strict=True):
                print_row([f"{case.omega_pi:g} π", *("–" if math.isnan(e) else f"{e:.1f}" for e in row)])


def tiles(name: str, cases: Sequence[PublishedCurve], folder: Path) -> None:
    """Fits of the rigid tiles' curves beside the lattice's, from one start each, as the studies measure them."""
    print_row(["A_p, ω_n", "f0 published", "lattice", "tiles", "b/f0 published", "lattice", "tiles",
               "ω_Br max published", "lattice", "tiles"])  # fmt: skip
    print_row(["---"] * 10)
    for case in cases:
        made = [by_engine(name, case, engine, folder).fit for engine in ("cpu", "tiles")]
        rows = (
            (f"{case.f0_hz:.1f} Hz", ["–" if f is None else f"{f.f0_hz:.1f}" for f in made]),
            (f"{case.b_over_f0:.3f}", ["–" if f is None else f"{f.half_width_hz / f.f0_hz:.3f}" for f in made]),
            (
                f"{PEAKS[case.angle_deg, case.omega_pi]:.0f} deg/s",
                ["–" if f is None else f"{f.peak:.0f}" for f in made],
            ),
        )
        print_row([label(case), *(cell for printed, ours in rows for cell in (printed, *ours))])


def by_engine(name: str, case: PublishedCurve, engine: Engine, folder: Path) -> Curve:
    """Curve of a case by an engine, read from the folder where it was made before: tiles take minutes."""
    path = folder / f"{name}-{case.angle_deg}deg-{case.omega_pi:g}pi-{engine}.csv"
    if path.exists():
        return fit_curve(read_curve(path))
    curve = spin_curve(measured_as(scenario_of(name, case), REGENERATED), FREQUENCIES[case.angle_deg], engine=engine)
    folder.mkdir(parents=True, exist_ok=True)
    write_curve(replace(curve, simulations=()), path)
    return curve


PARTS = {"fits": fits, "vertex": vertex, "typed": typed, "twelve": twelve, "steps": steps}


def main() -> None:
    """Print the tables that are asked for."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--preset", default="cheese")
    parser.add_argument("--part", nargs="+", choices=[*PARTS, "tiles"], default=list(PARTS))
    parser.add_argument("--curves", type=Path, default=Path("out/tiles"), help="where part tiles keeps its curves")
    options = parser.parse_args()
    for part in options.part:
        print(f"\n{part}\n", flush=True)
        tiles(options.preset, CASES, options.curves) if part == "tiles" else PARTS[part](options.preset, CASES)


if __name__ == "__main__":
    main()
