"""How near estimates come to what the data hold: ``python -m benchmarks.bounds [--objects 6] [--design NAME]``.

Objects of `benchmarks.recovery`, c_b and the plate's height unknown, twelve points each: rates evenly from 13 to 31 Hz
at 5 and at 1 % noise, the same with bending amplitudes beside them, and twelve mixed motions, which a plate of A_p 2 to
12 deg, B_p 1 to 5 mm, 0 to 20 mm above its axis and up to 30 Hz makes, chosen once for all objects. Errors are held
against the Cramér–Rao bound of the points that did not fail, chaos counted as noise, the run-off not used. No rate is
read better than to a degree a second. The model is the one that made the data: none of its error is allowed for.
"""

from __future__ import annotations

import argparse
import math
import time
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from benchmarks.recovery import BASE, true_object
from plategait.curve.curve import Curve
from plategait.estimate.candidates import Reach
from plategait.estimate.likelihood import LEAST_NOISE
from plategait.estimate.observations import Condition
from plategait.estimate.result import estimate_parameters
from plategait.estimate.unknowns import Unknowns, unknowns
from plategait.simulation.run import simulate_all

SOUGHT: Unknowns = unknowns(BASE)
SPREAD = tuple(Condition(BASE.motion.angle, BASE.motion.stroke, float(f)) for f in np.linspace(13, 31, 12))
REACH = Reach(
    angle=((math.radians(2), math.radians(12)),),
    stroke=((1e-3, 5e-3),),
    height=((-BASE.motion.height, 20e-3 - BASE.motion.height),),
    phase=((0.0, 0.0), (math.pi / 2, math.pi / 2)),
    frequency=(5.0, 30.0),
    motion=BASE.motion,
)
# Objects for which the motions are chosen: ω_n (π rad/s), α (deg), β. None of those that are estimated.
CHOSEN_FOR = ((3.0, 35.0, 0.5), (9.0, 45.0, 0.7), (25.0, 35.0, 0.5))
# Central differences in shares of the priors, each wide enough that a run's chaos does not hide the slope.
STEP = np.array([0.03, 0.025, 0.06, 0.04, 0.08])
STARTS = 2
PRIOR = 12.0  # information of an even prior, by share


@dataclass(frozen=True)
class Design:
    """What is measured."""

    conditions: tuple[Condition, ...]
    noise: float
    read: tuple[str, ...] = ()


def shares(truth: ArrayLike) -> np.ndarray:
    """Shares (5,) of the priors of an object (ω_n in π rad/s, α in deg, β), c_b and height as the scenario has them."""
    omega, alpha, beta = np.asarray(truth, dtype=float)
    values = (math.pi * omega, math.radians(alpha), beta, 1.0, BASE.motion.height)
    return np.array([p.share(v) for p, v in zip(SOUGHT.parameters, values, strict=True)])


def outcomes(u: np.ndarray, conditions: Sequence[Condition], read: Sequence[str], seed: int = 0) -> np.ndarray:
    """(n, c, 1 + readings, starts) rates and readings from two differing starts; NaN where the object failed."""
    scenarios = []
    for values in SOUGHT.values(u):
        scenario = SOUGHT.scenario(values)
        scenarios += [scenario.replace(motion=c.motion(scenario.motion)) for c in conditions]
    seen = [
        [[math.nan if o.failure else math.degrees(o.spin.rate), *(o[name] for name in read)] for o in run.observations]
        for run in simulate_all(scenarios, repeats=STARTS, seed=seed)
    ]
    return np.reshape(seen, (len(u), len(conditions), STARTS, 1 + len(read))).transpose(0, 1, 3, 2)


def slopes(u: np.ndarray, conditions: Sequence[Condition], read: Sequence[str]) -> tuple[np.ndarray, np.ndarray]:
    """Relative slopes (c, 1 + readings, d) by share of each prior, and relative scatter (c, 1 + readings) beside noise.

    Slopes are 0 where any run of the difference failed.
    """
    moves = np.diag(STEP)
    at = np.clip(np.concatenate([u[None], u + moves, u - moves]), 1e-6, 1 - 1e-6)
    every, d = outcomes(at, conditions, read), len(u)
    seen = every.mean(axis=-1)
    steps = np.diag(at[1 : d + 1] - at[d + 1 :])
    relative = (seen[1 : d + 1] - seen[d + 1 :]) / steps[:, None, None] / seen[0]
    squared = every.var(axis=-1, ddof=1) / seen**2
    known = np.isfinite(squared)
    scatter = np.sqrt(np.where(known, squared, 0.0).sum(axis=0) / np.maximum(known.sum(axis=0), 1))
    return np.nan_to_num(relative.transpose(1, 2, 0)), np.hypot(scatter, _least(seen[0]) / np.abs(seen[0]))


def _least(seen: np.ndarray) -> np.ndarray:
    """(c, 1 + readings) smallest noise of each: of a rate LEAST_NOISE, of a reading none."""
    return np.where(np.arange(seen.shape[-1]) == 0, LEAST_NOISE, 0.0) * np.ones_like(seen)


def information(slope: np.ndarray, scatter: np.ndarray, noise: float) -> np.ndarray:
    """(c, d, d) what each condition tells: chaos counts as noise, in the slopes' differences too."""
    variance = noise**2 + scatter**2
    false = (scatter**2 / STARTS)[:, :, None] * 0.5 / STEP**2  # of the square of each slope, by chaos alone
    slope = np.where(slope**2 > 4 * false, slope, 0.0)
    return np.einsum("cqd,cqe,cq->cde", slope, slope, 1 / variance)


def best_motions(count: int = 12, noise: float = 0.01) -> tuple[Condition, ...]:
    """Motions chosen one after the other, each that leaves the least of ω_n and α over the objects together."""
    conditions = REACH.grid()
    told = [information(*slopes(shares(truth), conditions, ()), noise) for truth in CHOSEN_FOR]
    now = [PRIOR * np.eye(5) for _ in CHOSEN_FOR]
    chosen: list[int] = []
    for _ in range(count):
        left = sum(
            np.sum(np.log(np.diagonal(np.linalg.inv(n + t), axis1=1, axis2=2)[:, :2]), axis=1)
            for n, t in zip(now, told, strict=True)
        )
        best = int(np.argmin(np.where(np.isin(np.arange(len(conditions)), chosen), np.inf, left)))
        chosen.append(best)
        now = [n + t[best] for n, t in zip(now, told, strict=True)]
    return tuple(conditions[i] for i in chosen)


def measured(truth: np.ndarray, design: Design, generator: np.random.Generator) -> Curve:
    """Curve of an object, its spreads told."""
    # The second start: laid down beside the nominal one.
    seen = outcomes(shares(truth)[None], design.conditions, design.read, int(generator.integers(1000)))[0, :, :, 1]
    sd = np.hypot(design.noise * seen, _least(seen))
    noisy = seen + sd * generator.normal(size=seen.shape)
    n, c = len(noisy), design.conditions
    return Curve(
        "measured", np.array([x.frequency for x in c]), noisy[:, 0], sd[:, 0], ("",) * n,
        tuple("slipped" if math.isnan(rate) else "" for rate in seen[:, 0]),
        angle_deg=np.degrees([x.angle for x in c]), stroke=np.array([x.stroke for x in c]),
        height=np.array([BASE.motion.height + x.height for x in c]), phase=np.array([x.phase for x in c]),
        values={name: noisy[:, 1 + k] for k, name in enumerate(design.read)},
        value_sds={name: sd[:, 1 + k] for k, name in enumerate(design.read)},
    )  # fmt: skip


def recover(number: int, name: str, design: Design) -> np.ndarray:
    """(2, 3) of ω_n (π rad/s) and α (deg): error, bound and the posterior's own sd."""
    truth, _ = true_object(number)
    curve = measured(truth, design, np.random.default_rng([number, 77]))
    u = shares(truth)
    stayed = [c for c, failed in zip(design.conditions, curve.failed, strict=True) if not failed]
    told = information(*slopes(u, stayed, design.read), design.noise).sum(axis=0) + PRIOR * np.eye(len(u))
    per_share = [math.pi**-1 * _slope(0, u[0]), math.degrees(_slope(1, u[1]))]
    bound = np.sqrt(np.diag(np.linalg.inv(told)))[:2] * per_share
    heights = [BASE.motion.height + c.height for c in design.conditions]
    begun, busy = time.perf_counter(), time.process_time()
    base = BASE if not name.startswith("mixed") else BASE.replace(**{"motion.height": float(np.median(heights))})
    estimate = estimate_parameters(curve, base, model_error=0.0, ramp=BASE.motion.ramp, seed=number)
    wall, busy = time.perf_counter() - begun, time.process_time() - busy
    values = estimate.posterior.values[:, :2] / (math.pi, math.radians(1))
    error = np.median(values, axis=0) - truth[:2]
    low, high = np.quantile(values, [0.05, 0.95], axis=0)
    inside = ((low <= truth[:2]) & (truth[:2] <= high)).tolist()
    print(f"{name} {number} truth {truth.round(2)} error {error.round(3)} bound {bound.round(3)} "
          f"sd {values.std(axis=0).round(3)} 90 % {inside} explained {estimate.goodness.explained} rated {len(stayed)} "
          f"sets {len(estimate.posterior.runs.u)} {busy:.1f} CPU s, {wall:.1f} s", flush=True)  # fmt: skip
    return np.stack([error, bound, values.std(axis=0)], axis=1)


def _slope(i: int, u: float) -> float:
    """SI of a parameter by share of its prior."""
    p = SOUGHT.parameters[i]
    return float(p.value(u + 1e-5) - p.value(u - 1e-5)) / 2e-5


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--objects", type=int, default=6)
    parser.add_argument("--design", choices=("rates-5", "rates-1", "bending-5", "mixed-1"), action="append")
    arguments = parser.parse_args()
    designs = {
        "rates-5": Design(SPREAD, 0.05), "rates-1": Design(SPREAD, 0.01),
        "bending-5": Design(SPREAD, 0.05, ("bending_amplitude",)), "mixed-1": Design((), 0.01),
    }  # fmt: skip
    lines = []
    for name in arguments.design or designs:
        design = designs[name]
        if name == "mixed-1":
            design = replace(design, conditions=best_motions())
            print("\n".join(f"{c.frequency:.2f} Hz, {c.text}" for c in design.conditions), flush=True)
        rows = np.array([recover(number, name, design) for number in range(arguments.objects)])
        error, bound = np.abs(rows[:, :, 0]), rows[:, :, 1]
        ratio = np.sqrt(np.mean((error / bound) ** 2, axis=0))
        median, least = np.median(error, axis=0), np.median(bound, axis=0)
        lines.append(f"| {name} | {len(rows)} | {median[0]:.2f} | {median[1]:.2f} | {least[0]:.2f} | {least[1]:.2f} "
                     f"| {ratio[0]:.1f} | {ratio[1]:.1f} |")  # fmt: skip
    print("| design | objects | median error of ω_n (π rad/s) | of α (deg) | bound on ω_n | on α | r.m.s. of error "
          "over bound, ω_n | α |\n|---|---|---|---|---|---|---|---|")  # fmt: skip
    print("\n".join(lines))


if __name__ == "__main__":
    main()
