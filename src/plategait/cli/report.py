"""What the commands print of runs and curves, one JSON object for programs, progress for the patient."""

from __future__ import annotations

import json
import math
import sys
import time
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from plategait.cli.tables import print_table as print_table
from plategait.curve.curve import Curve
from plategait.curve.doubts import doubts
from plategait.errors import printable
from plategait.model.modes import Modes
from plategait.simulation.energy import LEDGER_TOLERANCE
from plategait.simulation.registry import Observable, all_observables
from plategait.simulation.result import Simulation

INTERRUPTED = 130
"""Exit status of what was interrupted from the keyboard, as shells have it."""

ALLOW_MORE = "; --slip-limit to allow more"

# Work shorter than this shows no progress bar, s.
_PATIENCE = 1.0


@contextmanager
def going_on_in(store: Path | None) -> Iterator[None]:
    """Tell whoever interrupts the work where it goes on; without a store there is nothing to go on with."""
    try:
        yield
    except KeyboardInterrupt:
        if store is None:
            raise
        print(f"plategait: interrupted; the same command goes on where {store} ends", file=sys.stderr)
        sys.exit(INTERRUPTED)


def print_json(numbers: dict[str, Any]) -> None:
    """Print one JSON object."""
    text = json.dumps(numbers, indent=2, ensure_ascii=False, allow_nan=False)
    # JSON itself escapes only the control characters of ASCII.
    print("".join(c if c.isprintable() or c == "\n" else json.dumps(c)[1:-1] for c in text))


def print_notes(notes: Iterable[str]) -> None:
    """Print a line for each thing to know of what was read."""
    for note in notes:
        print(printable(note, 1000))


def _number(value: float | None, unit: str = "", digits: int = 1) -> str:
    """A number with its unit; a dash where nothing was measured."""
    return "–" if value is None or not math.isfinite(value) else f"{value:.{digits}f} {unit}".rstrip()


def _interval(low: float | None, high: float | None, unit: str) -> str:
    return "–" if low is None or high is None else f"{_number(low)} to {_number(high, unit)}"


def _observable(observable: Observable, value: float | None) -> str:
    """Value of an observable as JSON has it, in the unit that people read."""
    if value is not None and observable.read_in == "%":
        value *= 100
    return _number(value, observable.read_in.removeprefix("1"))


def print_simulation(simulation: Simulation, drawn: dict[str, Any] | None = None) -> None:
    """Print what one simulation shows, and what draws of measured parameters make of its spin rate."""
    s, o = simulation.summary(), simulation.scenario
    low, high = s["spin_rate_interval_deg_s"]
    counted = f"{s['counted_runs']} of {s['runs']}" if s["failed_runs"] else str(s["runs"])
    spread = f" ± {_number(s['spin_rate_sd_deg_s'])} over {counted} runs" if s["runs"] > 1 and s["counted_runs"] else ""
    rows = [
        ["spin rate", _number(s["spin_rate_deg_s"], "deg/s") + spread],
        ["95 % interval", _interval(low, high, "deg/s")],
        *_drawn_row(drawn),
        ["settled", "yes" if s["settled"] else "no"],
        ["gait", s["gait"] or "–"],
        ["failure", _failures(simulation) or f"none in {simulation.scenario.duration:g} s"],
        *([o.label, _observable(o, s[o.key])] for o in all_observables().values() if o.label),
        *_velocity_spread(simulation),
        ["energy unaccounted for", _energy(simulation)],
        ["time step", f"{s['dt_s']:.3g} s, {s['steps']} steps"],
        ["speed", _number(s["simulated_s_per_wall_s"], "simulated seconds per second")],
    ]
    motion = o.motion
    print_table(
        f"{o.name}: {motion.frequency:g} Hz, {math.degrees(motion.angle):.3g} deg, {1e3 * motion.stroke:.3g} mm",
        ["", ""],
        rows,
    )


def _velocity_spread(simulation: Simulation) -> list[list[str]]:
    """How the velocity along, across and turning differs from stride to stride, and from start to start."""
    ways = [("strides", simulation.stride_covariance), ("starts", simulation.start_covariance)]
    rows = []
    for over, covariance in ways:
        if np.isfinite(covariance).all():
            x, y, w = np.sqrt(np.diag(covariance)).tolist()
            rows.append(
                [f"sd of the velocity over {over}", f"{1e3 * x:.1f}, {1e3 * y:.1f} mm/s, {math.degrees(w):.1f} deg/s"]
            )
    return rows


def _failures(simulation: Simulation) -> str:
    """Which failures there were, and the option that permits more slip."""
    return simulation.failures_in_words + ALLOW_MORE * ("slipped" in simulation.failures)


def _energy(simulation: Simulation) -> str:
    """Share of the energy given that is unaccounted for at worst, and whether that is too much."""
    s = simulation.summary()
    if s["energy_imbalance"] is None:
        return "all of it: the motion ceased to be finite"
    share = f"{100 * s['energy_imbalance']:.2g} % of what was given"
    which = f" in {s['open_ledgers']} of {s['runs']} runs" if s["runs"] > 1 else ""
    return share + ("" if s["energy_closed"] else f": DOES NOT BALANCE{which}, above {100 * LEDGER_TOLERANCE:g} %")


def _drawn_row(drawn: dict[str, Any] | None) -> list[list[str]]:
    if drawn is None:
        return []
    interval = _interval(drawn["low"], drawn["high"], "deg/s")
    failed = f", {drawn['failed']} of {drawn['runs']} fail" if drawn["failed"] else ""
    return [[f"over {drawn['runs']} draws of what was measured", interval + failed]]


def print_curve(curve: Curve) -> None:
    """Print a curve point by point, and its fit."""
    rows = []
    for i, frequency in enumerate(curve.frequency_hz):
        rows.append([
            f"{frequency:g}", _number(curve.spin_rate_deg_s[i]), _number(curve.spin_rate_sd_deg_s[i]),
            curve.gait[i] or "–", curve.failure_in_words[i] or "–",
        ])  # fmt: skip
    print_table(f"{curve.name}: spin rate over plate frequency", ["Hz", "deg/s", "sd, deg/s", "gait", "failure"], rows)
    if "slipped" in curve.failure and curve.slip_limit is not None:
        print(f"slipped: by more than {1e3 * curve.slip_limit[0]:.3g} mm{ALLOW_MORE}\n")
    open_at = [f"{s.scenario.motion.frequency:g}" for s in curve.simulations if s.open_ledgers]
    if open_at:
        print(f"THE ENERGY DOES NOT BALANCE within {100 * LEDGER_TOLERANCE:g} % at {', '.join(open_at)} Hz\n")
    print_fit(curve)


def print_fit(curve: Curve) -> None:
    """Print a curve's Lorentz fit beside the fastest point, and what speaks against it; or why there is none."""
    fit, fastest = curve.fit, curve.fastest
    at = f"{abs(fastest[1]):.1f} deg/s at {fastest[0]:g} Hz" if fastest else "none"
    if fit is None:
        print(f"no Lorentz fit: {curve.no_fit}\nfastest measured: {at}")
        return
    rows = [
        [name, f"{value:.2f} {unit}", f"{low:.2f} to {high:.2f}"]
        for name, value, unit, (low, high) in (
            ("f0", fit.f0_hz, "Hz", fit.f0_interval),
            ("half width b", fit.half_width_hz, "Hz", fit.half_width_interval),
            ("peak", fit.peak, "deg/s", fit.peak_interval),
        )
    ]
    print_table(f"Lorentz fit of {fit.n_points} points, R² = {fit.r2:.3f}", ["", "value", "95 % interval"], rows)
    print(f"fastest measured: {at}")
    print_notes(doubts(curve))


def print_modes(title: str, modes: Modes, count: int) -> None:
    """Print free-vibration modes."""
    rows = [
        [str(i), m.name or "–", f"{m.omega / math.pi:.2f} π", f"{m.frequency:.2f}", f"{m.damping_ratio:.3f}"]
        for i, m in enumerate(modes.modes[:count], start=1)
    ]
    print_table(f"{title}: free-vibration modes", ["mode", "shape", "rad/s", "Hz", "damping ratio"], rows)


@contextmanager
def progress_bar(what: str) -> Iterator[Any]:
    """Yield a callable that takes the fraction done, and shows a bar on a terminal once the work has taken a second."""
    begun = time.monotonic()
    bar: Any = None
    task: Any = None

    def report(fraction: float) -> None:
        nonlocal bar, task
        if bar is None and sys.stderr.isatty() and time.monotonic() - begun > _PATIENCE:
            from rich.console import Console
            from rich.progress import Progress

            bar = Progress(console=Console(stderr=True), transient=True)
            task = bar.add_task(what, total=1.0)
            bar.start()
        if bar is not None:
            bar.update(task, completed=fraction)

    try:
        yield report
    finally:
        if bar is not None:
            bar.stop()
