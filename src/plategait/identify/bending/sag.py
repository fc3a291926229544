"""The sagging of a released strip, fitted: by the least squares of (3.5), and by simulating it."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from itertools import product
from typing import Literal

import numpy as np

from plategait.arrays import Array
from plategait.identify.fit import Fit, fit, interval, unbounded
from plategait.identify.series import Smooth, follow, smooth, structure, thin
from plategait.model.measured import Measured
from plategait.theory.two_links import (
    LEAST_ROWS,
    Joints,
    Strip,
    between,
    driven_rate,
    fastest_rates,
    integrate,
    joint_moment,
    two_link_rate,
)

Wall = Literal["measured", "free", "joint"]

# Share of the fastest oscillation that a step takes, in radians: Runge–Kutta is then off by 1e-4 of its period. And of
# the fastest decay, of which nothing is left after a row or two: it must be stable, under 2.8.
_STEP, _DECAY_STEP = 0.35, 1.2
_HEADROOM = 1.3  # by which the fastest rate may grow during a fit before the steps are made anew
_MOST_STEPS = 1500  # under about 10 s of work
_RESOLVED = 2.0  # rad of the second mode from row to row: near its Nyquist limit, π, a spline loses it
_MOST_ROWS = 1000
# Starts tried: shares of the stiffness that the last angles suggest, and damping in sqrt(k_b m l²/4).
_STIFFNESS, _DAMPING = (0.4, 0.7, 1.0, 1.5, 2.5), (0.03, 0.1, 0.3, 1.0, 3.0, 10.0)
_REACH = 50.0  # times the start, up to which stiffness and damping are sought
_BIASED = "regression: camera noise biases c_b; compare with the trajectory fit"


@dataclass(frozen=True, eq=False)
class SagCase:
    """A recording to be fitted.

    Parameters
    ----------
    strip : Strip
    begun : float
        Time of the first row, s.
    t : (n,) array
        Time from there, s.
    phi : (n, 2) array
        φ1 and φ2, rad.
    centripetal : bool
        Whether the term that (3.3) drops is kept.
    """

    strip: Strip
    begun: float
    t: Array
    phi: Array
    centripetal: bool

    @cached_property
    def splines(self) -> tuple[Smooth, Smooth]:
        """Both angles, smoothed."""
        return smooth(self.t, self.phi[:, 0]), smooth(self.t, self.phi[:, 1])

    @property
    def k_static(self) -> float:
        """Stiffness of joint 2 that the last third of the recording suggests."""
        phi_1, phi_2 = self._last
        return 0.5 * self.strip.weight * math.cos(phi_1 + phi_2) / max(phi_2, 0.05 * float(np.ptp(self.phi[:, 1])))

    @property
    def k_1_static(self) -> float:
        """The same of joint 1."""
        phi_1, phi_2 = self._last
        moment = self.strip.weight * (1.5 * math.cos(phi_1) + 0.5 * math.cos(phi_1 + phi_2))
        return moment / max(phi_1, 0.05 * float(np.ptp(self.phi[:, 0])), 1e-3)

    @property
    def _last(self) -> tuple[float, float]:
        phi_1, phi_2 = self.phi[-len(self.phi) // 3 :].mean(axis=0)
        return float(phi_1), float(phi_2)

    def c_unit(self, k: float) -> float:
        """sqrt(k m l²/4), N m s/rad: half of critical damping of link 2 alone."""
        return math.sqrt(k * self.strip.inertia / 4)


def prepare(strip: Strip, used: tuple[Array, ...], centripetal: bool) -> tuple[SagCase, list[str]]:
    """Cut rows (time, φ1, φ2) to a time that can be simulated finely, and thin them; what was done, as notes."""
    notes, (time, *angles) = [], used
    whole = SagCase(strip, time[0], time, np.stack(angles, axis=1), centripetal)
    stiffest = Joints(max(whole.k_static, whole.k_1_static), 0.0)
    end = time[0] + _MOST_STEPS * _STEP / (_HEADROOM * fastest_rates(strip, stiffest)[0])
    if time[-1] > end:
        rows = max(int(np.searchsorted(time, end)), LEAST_ROWS)
        time, angles = time[:rows], [angle[:rows] for angle in angles]
        notes.append(f"only the first {time[-1] - time[0]:.3g} s were used")
    (time, *angles), block = thin(time, *angles, most=_MOST_ROWS)
    if block > 1:
        notes.append(f"thinned: means over {block} rows at a time")
    return SagCase(strip, time[0], time - time[0], np.stack(angles, axis=1), centripetal), notes


@dataclass(frozen=True, eq=False)
class SagFit:
    """Both parameters that were fitted (SI), φ2 reconstructed (n,), notes, and joint 1 where it was fitted."""

    stiffness: Measured
    damping: Measured
    correlation: float
    reconstruction: Array
    notes: tuple[str, ...]
    wall_stiffness: Measured | None = None
    wall_damping: Measured | None = None


@dataclass(frozen=True)
class _Predictor:
    """Both angles (n, 2, batch) from parameters (p, batch), the steps it takes, and whether it should take more."""

    predict: Callable[[Array], Array]
    steps: int
    capped: bool

    def __call__(self, parameters: Array) -> Array:
        return self.predict(parameters)


# The least squares of the source


def regress(case: SagCase) -> SagFit:
    """(3.3) to (3.5) with the derivatives of splines."""
    one, two = case.splines
    t = case.t
    phi = one(t), two(t)
    q = joint_moment(case.strip, phi, (one(t, 2), two(t, 2)), one(t, 1), centripetal=case.centripetal)
    matrix = np.column_stack([two(t, 1), phi[1]])
    (c_b, k_b), *_ = np.linalg.lstsq(matrix, q, rcond=None)
    residual = q - matrix @ (c_b, k_b)
    # Smoothing makes neighbours alike: fewer independent samples than rows.
    alike = min(max(structure(residual), 0.0), 0.99)
    widening = (1 + alike) / (1 - alike)
    dof = (len(t) - 2) / widening
    covariance = np.linalg.pinv(matrix.T @ matrix) * float(residual @ residual) / max(dof, 1.0)
    sd = np.sqrt(np.diag(covariance))
    k, c = (max(float(v), 1e-12) for v in (k_b, c_b))
    start = np.array([[k / case.k_static], [c / case.c_unit(case.k_static)], [phi[1][0]], [two(t, 1)[0]]])
    lines = np.concatenate([start, one.coefficients[:, None]])
    unit = (case.k_static, case.c_unit(case.k_static), 1.0, 1.0)
    reconstruction = _driven_model(case, one, Joints(k, c), unit)(lines)[:, 1, 0]
    correlation = float(covariance[0, 1] / (sd[0] * sd[1])) if sd[0] * sd[1] > 0 else 0.0
    stiffness, damping = interval(float(k_b), sd[1], dof), interval(float(c_b), sd[0], dof)
    return SagFit(stiffness, damping, correlation, reconstruction, (_BIASED,))


# Simulated and fitted


def follow_wall(case: SagCase) -> SagFit:
    """Joint 2 alone, driven by link 1, whose motion is a spline fitted together with it."""
    # A spline that cross-validation picks is too stiff for the first moments after the release, and c_b comes out half
    # as large again; one that is too fine costs nothing, as the motion of link 2 restrains it.
    driver, two = follow(case.t, case.phi[:, 0]), case.splines[1]
    phi_2, rate_2 = float(two(case.t[:1])[0]), float(two(case.t[:1], 1)[0])
    unit = _units(case)

    def start(k: Array, c: Array) -> Array:
        rest = np.concatenate([[phi_2 / unit[2], rate_2 / unit[3]], driver.coefficients])
        return np.concatenate([[k, c], np.repeat(rest[:, None], k.size, axis=1)])

    tries = np.array(list(product(_STIFFNESS, _DAMPING))).T
    largest = Joints(unit[0] * max(_STIFFNESS), unit[1] * max(_DAMPING))
    best = _best(case, _driven_model(case, driver, largest, unit), start(*tries))

    def model(p: Array) -> _Predictor:
        return _driven_model(case, driver, Joints(unit[0] * p[0], unit[1] * p[1]), unit)

    free = np.full(len(best) - 2, np.inf)
    fitted = _converge(case, model, best, np.r_[[1e-3, 0.0], -free], np.r_[[_REACH, _REACH], free])
    return _result(case, "measured", fitted, unit, model(fitted.parameters))


def simulate_both(case: SagCase, wall: Wall) -> SagFit:
    """Both links, joint 1 with stiffness and damping of its own ("free") or as joint 2 ("joint")."""
    unit = _units(case)
    own = wall == "free"
    initial = [s(case.t[:1], d)[0] / unit[2 + d] for d in (0, 1) for s in case.splines]
    k_1 = case.k_1_static / unit[0]
    tries = np.array(list(product(_STIFFNESS, _DAMPING, _STIFFNESS if own else (1.0,)))).T
    walls = [k_1 * tries[2], tries[1]] if own else []
    starts = np.stack([*tries[:2], *walls, *(np.full(tries.shape[1], value) for value in initial)])

    def joints(p: Array) -> Joints:
        return Joints(unit[0] * p[0], unit[1] * p[1], *((unit[0] * p[2], unit[1] * p[3]) if own else ()))

    def model(p: Array) -> _Predictor:
        step, steps, capped = _steps(case, *fastest_rates(case.strip, joints(p)))

        def predict(many: Array) -> Array:
            rate = two_link_rate(case.strip, joints(many), centripetal=case.centripetal)
            state = many[-4:] * np.array([unit[2], unit[2], unit[3], unit[3]])[:, None]
            return between(integrate(rate, state, step, steps), step, case.t)

        return _Predictor(predict, steps, capped)

    best = _best(case, model(starts.max(axis=1)), starts)
    low = np.r_[[1e-3, 0.0] * (1 + own), [-np.inf] * 4]
    high = np.r_[[_REACH * max(1.0, k_1), _REACH] * (1 + own), [np.inf] * 4]
    fitted = _converge(case, model, best, low, high)
    return _result(case, wall, fitted, unit, model(fitted.parameters))


def _units(case: SagCase) -> tuple[float, float, float, float]:
    """Sizes of stiffness, damping, angle and rate, that make the parameters of order 1."""
    k = case.k_static
    size = float(np.abs(case.phi).max())
    return k, case.c_unit(k), size, size * math.sqrt(4 * k / case.strip.inertia)


def _steps(case: SagCase, omega: float, decay: float) -> tuple[float, int, bool]:
    """Time step and number of steps for what swings and decays at these rates, and may still become a little faster.

    Also whether there should be more steps than are affordable.
    """
    wanted = max(math.ceil(case.t[-1] * _HEADROOM * max(omega / _STEP, decay / _DECAY_STEP)), 8)
    steps = min(wanted, 4 * _MOST_STEPS)
    return float(case.t[-1]) / steps, steps, wanted > _HEADROOM * steps


def _driven_model(case: SagCase, driver: Smooth, joints: Joints, unit: tuple[float, float, float, float]) -> _Predictor:
    """Predict both angles (n, 2, batch) from (k_b, c_b, φ2, φ2' at the start, coefficients of `driver`), (p, batch).

    Steps are short enough for joints as stiff and as damped as those given.
    """
    quarter, knots = case.strip.inertia / 4, len(driver.coefficients) / case.t[-1]
    omega = max(math.sqrt(float(np.max(joints.k_b)) / quarter), knots)
    step, count, capped = _steps(case, omega, float(np.max(joints.c_b)) / quarter)
    halves = np.minimum(np.arange(2 * count + 1) * step / 2, case.t[-1])
    value, rate, acceleration = (driver.matrix(halves, d) for d in range(3))
    at_rows = driver.matrix(case.t)

    def predict(many: Array) -> Array:
        spline = many[4:]
        driven = driven_rate(
            case.strip,
            Joints(unit[0] * many[0], unit[1] * many[1]),
            value @ spline,
            rate @ spline,
            acceleration @ spline,
            centripetal=case.centripetal,
        )
        states = integrate(driven, many[2:4] * np.array(unit[2:])[:, None], step, count)
        return np.concatenate([(at_rows @ spline)[:, None], between(states, step, case.t)], axis=1)

    return _Predictor(predict, count, capped)


def _best(case: SagCase, model: _Predictor, starts: Array) -> Array:
    """Start whose prediction misses least."""
    with np.errstate(all="ignore"):  # what diverges misses most
        residual = (model(starts) - case.phi[:, :, None]) / np.ptp(case.phi, axis=0)[:, None]
        squares = np.nan_to_num(np.sum(residual**2, axis=(0, 1)), nan=np.inf)
    return starts[:, int(np.argmin(squares))]


def _converge(case: SagCase, model: Callable[[Array], _Predictor], start: Array, low: Array, high: Array) -> Fit:
    """Fit, with steps made anew for where it arrived."""
    predict = model(start)
    first = fit(predict, case.phi, start, low, high)
    again = model(first.parameters)
    return first if again.steps <= predict.steps * _HEADROOM else fit(again, case.phi, first.parameters, low, high)


def _result(case: SagCase, wall: Wall, fitted: Fit, unit: tuple[float, ...], model: _Predictor) -> SagFit:
    notes, stiffness, damping = [], fitted.measured(0, unit[0]), fitted.measured(1, unit[1])
    if fitted.structured:
        hint = ": is joint 1 as joint 2? try --wall measured" if wall == "joint" else ""
        notes.append(f"{fitted.structure_note}{hint}")
    if model.capped:
        stiffness, damping = unbounded(stiffness.value), unbounded(damping.value)
        notes.append("so stiff or damped that steps fine enough take too long: try --wall measured, or an earlier --to")
    omega = fastest_rates(case.strip, Joints(stiffness.value, 0.0))[0]
    spacing = float(np.median(np.diff(case.t)))
    if wall == "measured" and omega * spacing > _RESOLVED:
        damping = unbounded(damping.value)
        notes.append(
            f"too few rows for the strip's second mode, {omega / math.tau:.0f} Hz: film faster, or --wall free"
        )
    return SagFit(
        stiffness=stiffness,
        damping=damping,
        correlation=fitted.correlation(0, 1),
        reconstruction=model(fitted.parameters[:, None])[:, 1, 0],
        notes=tuple(notes),
        wall_stiffness=fitted.measured(2, unit[0]) if wall == "free" else None,
        wall_damping=fitted.measured(3, unit[1]) if wall == "free" else None,
    )
