"""The main job, end to end: a disk that spins on a vibrating plate. ``make demo`` runs this.

Writes into ``out/``: a film and a filmstrip of the slice of cheese, the plot of that run, its spin curve with the
Lorentz fit, and its free-vibration modes.
"""

from __future__ import annotations

import math
import time
from pathlib import Path

import plategait as pg
from plategait import render
from plategait.plots.figures import plot_curve, plot_modes, plot_run
from plategait.plots.style import save
from plategait.simulation.run import FILM_INTERVAL

OUT = Path("out")


def main() -> None:
    """Simulate, measure, draw, and say where the pictures are."""
    OUT.mkdir(exist_ok=True)
    begun = time.perf_counter()

    cheese = pg.preset("cheese").scenario
    lively = cheese.replace(**{"motion.frequency": "12 Hz", "motion.angle": "12 deg"})
    run = pg.simulate(lively, snapshot_interval=FILM_INTERVAL)
    print(f"At 12 Hz and 12 deg the cheese spins at {math.degrees(run.spin_rate):.0f} deg/s, {run.gait}.")

    curve = pg.spin_curve(cheese, range(12, 31), repeats=4)
    assert curve.fit is not None
    print(f"At 3 deg it spins fastest at {curve.fit.f0_hz:.1f} Hz, {curve.fit.peak:.0f} deg/s by the Lorentz fit.")
    simulated = run.simulated + sum(s.simulated for s in curve.simulations)
    wall = run.wall + sum(s.wall for s in curve.simulations)
    print(f"That was {simulated:.0f} s of motion in {wall:.1f} s.")

    pg.write_curve(curve, OUT / "curve.csv")
    save(plot_curve(curve), OUT / "curve.png")
    save(plot_run(run), OUT / "run.png")
    save(plot_modes(cheese.sheet), OUT / "modes.png")
    render.filmstrip(run, OUT / "filmstrip.png")
    render.film(run, OUT / "run.mp4")

    print(f"\nDone in {time.perf_counter() - begun:.0f} s. The pictures are in {OUT.resolve()}:")
    for path in sorted(OUT.iterdir()):
        print(f"  {path.name}")


if __name__ == "__main__":
    main()
