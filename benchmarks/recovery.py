"""How well known truths are recovered: ``python -m benchmarks.recovery [--objects 60] [--json FILE]``.

Objects over the source's whole range (ω_n 1.4 to 33π rad/s, evenly in the logarithm; α 24 to 57 deg; β 0.3 to 0.9) are
simulated at A_p = 3 deg at 12 plate frequencies, 5 % noise is laid on the rates, and every method estimates them from
the same points. Two ways of choosing the frequencies: "spread" evenly from 13 to 31 Hz, and "halved": five slow ones,
then seven that halve the interval in which the object begins to run off.
"""

from __future__ import annotations

import argparse
import json
import math
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from plategait.curve.curve import Curve
from plategait.curve.protocol import measured_as
from plategait.curve.spin_curve import fit_curve
from plategait.errors import InputError
from plategait.estimate.linear import Coefficients, Method, estimate_linear
from plategait.estimate.result import estimate_parameters
from plategait.estimate.unknowns import unknowns
from plategait.model.presets import nominal_natural_frequency, preset
from plategait.model.scenario import Scenario
from plategait.simulation.run import START_SPREAD, START_TURN, simulate

NOISE = 0.05
BASE = measured_as(preset("cheese").scenario)
OBJECT = unknowns(BASE, fixed=("bending_damping", "plate_height"))
Outcome = tuple[float, str]


def true_object(number: int) -> tuple[np.ndarray, Scenario]:
    """(ω_n in π rad/s, α in deg, β) of one object, and its scenario."""
    generator = np.random.default_rng(1000 + number)
    omega = 1.4 * (33 / 1.4) ** generator.random()
    truth = np.array([omega, generator.uniform(24, 57), generator.uniform(0.3, 0.9)])
    return truth, OBJECT.scenario(truth * (math.pi, math.radians(1), 1.0))


def measurement(scenario: Scenario, generator: np.random.Generator, noise: float = NOISE) -> Callable[[float], Outcome]:
    """Measures one plate frequency: the object laid down anew each time, its rate read with noise."""

    def measure(frequency: float) -> Outcome:
        x, y = generator.normal(0, START_SPREAD, 2)
        changes = {"motion.frequency": frequency, "start.x": x, "start.y": y,
                   "start.angle": generator.normal(0, START_TURN)}  # fmt: skip
        run = simulate(scenario.replace(**changes))
        rate = math.degrees(run.spin_rate) * (1 + noise * generator.normal())
        return rate, run.failure.kind if run.failure else ""

    return measure


def spread(measure: Callable[[float], Outcome]) -> dict[float, Outcome]:
    """Twelve frequencies evenly from 13 to 31 Hz."""
    return {float(f): measure(float(f)) for f in np.linspace(13, 31, 12)}


def halved(measure: Callable[[float], Outcome]) -> dict[float, Outcome]:
    """Five slow ones, then seven that halve the interval of the run-off."""
    points = {f: measure(f) for f in (13.5, 14.5, 15.5, 17.0, 20.0)}
    low, high = 20.0, 33.0
    for _ in range(7):
        middle = (low + high) / 2
        points[middle] = measure(middle)
        low, high = (low, middle) if points[middle][1] else (middle, high)
    return points


PROTOCOLS = {"spread": spread, "halved": halved}


def curve_of(points: dict[float, Outcome]) -> Curve:
    """Measured points as a curve."""
    n = len(points)
    return Curve("measured", np.array(list(points)), np.array([r for r, _ in points.values()]), np.full(n, math.nan),
                 ("",) * n, tuple(kind for _, kind in points.values()))  # fmt: skip


def recover(number: int, protocol: str) -> list[dict[str, Any]]:
    """Estimates of one object by every method."""
    truth, scenario = true_object(number)
    curve = curve_of(PROTOCOLS[protocol](measurement(scenario, np.random.default_rng([number, len(protocol)]))))
    rows = [
        by_posterior(curve, truth, number, "posterior, β known", friction_ratio=truth[2]),
        by_posterior(curve, truth, number, "posterior, β unknown"),
        by_line(curve, "linear", "published"),
        by_line(curve, "linear", "refitted"),
        by_line(curve, "quadratic", "refitted"),
    ]
    return [{"object": number, "protocol": protocol, "truth": truth.tolist(), **row} for row in rows]


def by_posterior(
    curve: Curve, truth: np.ndarray, seed: int, method: str, friction_ratio: float | None = None
) -> dict[str, Any]:
    """Estimate with the engine in the loop: median, spread, whether 90 % intervals hold the truth, and time."""
    begun = time.perf_counter()
    estimate = estimate_parameters(curve, BASE, noise=NOISE, friction_ratio=friction_ratio, model_error=0, seed=seed)
    values = estimate.posterior.values / [p.scale for p in estimate.posterior.unknowns.parameters]
    low, middle, high = np.quantile(values, [0.05, 0.5, 0.95], axis=0)
    return {
        "method": method,
        "estimate": middle.tolist(),
        "sd": values.std(axis=0).tolist(),
        "covered": ((low <= truth[: len(low)]) & (truth[: len(low)] <= high)).tolist(),
        "verdicts": [m.verdict for m in estimate.marginals],
        "explained": estimate.goodness.explained,
        "seconds": time.perf_counter() - begun,
    }


def by_line(curve: Curve, method: Method, coefficients: Coefficients) -> dict[str, Any]:
    """Estimate by the source's method; none without a fit, or where the method does not apply."""
    row: dict[str, Any] = {"method": f"{method}, {coefficients}", "estimate": None}
    fit = fit_curve(curve).fit
    if fit is None:
        return row
    try:
        guess = estimate_linear(fit, BASE, method=method, coefficients=coefficients)
    except InputError:
        return row
    dish = BASE.sheet.natural_frequency / nominal_natural_frequency(BASE.sheet)
    omega, alpha = dish * guess.natural_frequency / math.pi, math.degrees(guess.friction_angle)
    return row | {"estimate": [omega, alpha], "refused": bool(guess.refused)}


def table(rows: list[dict[str, Any]]) -> str:
    """Median errors, coverage and time by protocol and method."""
    lines = ["| frequencies | method | objects | median error of ω_n (π rad/s) | of α (deg) | 90 % intervals cover ω_n "
             "| α | median time (s) |", "|---|---|---|---|---|---|---|---|"]  # fmt: skip
    for protocol in PROTOCOLS:
        for method in dict.fromkeys(row["method"] for row in rows):
            of_method = [r for r in rows if (r["protocol"], r["method"]) == (protocol, method)]
            answers = [r for r in of_method if r["estimate"] is not None and not r.get("refused")]
            if not answers:
                continue
            error = np.abs([np.subtract(r["estimate"], r["truth"][: len(r["estimate"])])[:2] for r in answers])
            omega, alpha = np.median(error, axis=0)
            cover = [
                f"{100 * np.mean([r['covered'][i] for r in answers]):.0f} %" if "covered" in answers[0] else "–"
                for i in (0, 1)
            ]
            seconds = f"{np.median([r['seconds'] for r in answers]):.1f}" if "seconds" in answers[0] else "–"
            lines.append(f"| {protocol} | {method} | {len(answers)} of {len(of_method)} | {omega:.2f} | {alpha:.2f} "
                         f"| {cover[0]} | {cover[1]} | {seconds} |")  # fmt: skip
    return "\n".join(lines)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--objects", type=int, default=60)
    parser.add_argument("--first", type=int, default=0, help="number of the first object")
    parser.add_argument("--protocol", choices=PROTOCOLS, help="only this one")
    parser.add_argument("--json", type=Path, help="write every estimate here")
    arguments = parser.parse_args()
    rows: list[dict[str, Any]] = []
    for number in range(arguments.first, arguments.first + arguments.objects):
        for protocol in [arguments.protocol] if arguments.protocol else PROTOCOLS:
            rows += recover(number, protocol)
        if arguments.json:
            arguments.json.write_text(json.dumps(rows))
    print(table(rows))


if __name__ == "__main__":
    main()
