"""Free vibration as a sum of decaying oscillations, fitted to a recording.

One mode is the solution of y'' + 2 ζ ω y' + ω² y = 0 at any damping: it rings while ζ < 1 and only settles beyond, so
that a strip which sets without ringing is the same model, not a failed fit. All modes ride on a straight line, for a
static deflection that may still drift.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array
from plategait.identify.series import structure

MOST_MODES = 3
_DECAYS = (0.0, 2.0, 5.0, 10.0, 20.0, 40.0, 80.0, 160.0)  # over the recording: decay rates tried for a start
_LARGEST_RATIO = 20.0  # ζ of the slowest settling that is fitted
_GROWTH = 0.05  # ζ may be as much below 0, so that the interval of an undamped mode reaches both ways
_REACH = 2.0  # how far ln ω may move from its start
_PENCIL_ROWS = 150
_EVALUATIONS = 30  # of one refinement: a mode that is there takes about 8, one of noise may wander for long
_PENCIL_SHARE = 1 / 3  # of the rows: the window with the least variance (Y. Hua, T. K. Sarkar, 1990)
_STEP = 1e-5  # of a central difference: the cube root of rounding
_FLAT = 1e-12  # of the values: a spread below is rounding
_RIDGE = 1e-13  # keeps columns that are alike from dividing by zero
_ROUNDING = 1e-20  # share of the squares under which residuals are rounding


def mode_columns(time: Array, omega: float, damping_ratio: float) -> Array:
    """(n, 2) two solutions of y'' + 2 ζ ω y' + ω² y = 0, the second as velocity per ω, steady through ζ = 1."""
    decay, square = damping_ratio * omega, omega**2 * (1 - damping_ratio**2)
    if square >= 0:
        fade, turn = np.exp(-decay * time), math.sqrt(square)
        return np.stack([fade * np.cos(turn * time), fade * omega * time * np.sinc(turn * time / math.pi)], axis=1)
    spread = math.sqrt(-square)
    # The slower rate as quotient of the product ω² and the faster one: no digits are lost.
    fast = np.exp(-(decay + spread) * time)
    slow = np.exp(-(omega**2 / (decay + spread)) * time)
    return np.stack([(slow + fast) / 2, (slow - fast) * omega / (2 * spread)], axis=1)


def matrix_pencil(signal: Array, interval: float, order: int) -> NDArray[np.complex128]:
    """Poles s of a signal Σ c e^{s t} at even intervals, by the matrix pencil (Hua and Sarkar, 1990).

    Parameters
    ----------
    signal : (n,) array
    interval : float
        s.
    order : int
        Number of poles, 2 for each mode, at most n / 3.

    Returns
    -------
    (order,) complex array
        rad/s.
    """
    window = max(order + 1, int(len(signal) * _PENCIL_SHARE))
    hankel = np.lib.stride_tricks.sliding_window_view(signal, window)
    _, _, right = np.linalg.svd(hankel, full_matrices=False)
    basis = right[:order].T
    poles = np.linalg.eigvals(np.linalg.lstsq(basis[:-1], basis[1:], rcond=None)[0])
    exponents: NDArray[np.complex128] = np.log(np.where(poles == 0, 1e-300, poles).astype(np.complex128))
    return exponents / interval


@dataclass(frozen=True, eq=False)
class DecayFit:
    """Modes on a straight line, fitted; modes in order of frequency.

    Attributes
    ----------
    omega, damping_ratio : (k,) arrays
        Undamped natural angular frequency (rad/s) and ζ; 1 and more is no ringing.
    covariance : (2k, 2k) array
        Of ln ω and ζ of each mode in turn.
    amplitude : (k,) array
        Largest deflection of each mode within the recording, in the signal's unit.
    share : (k,) array
        Rms of each mode over that of all.
    fitted, line : (n,) arrays
        Sum of all and the straight line, in the signal's unit.
    noise : float
        Sd of the residuals.
    structure : float
        Correlation of neighbouring residuals; white noise has 0.
    freedom : int
        Degrees of freedom left.
    bic : float
        Bayesian information criterion, corrected for few rows (A. McQuarrie, C.-L. Tsai, 1998).
    """

    omega: Array
    damping_ratio: Array
    covariance: Array
    amplitude: Array
    share: Array
    fitted: Array
    line: Array
    noise: float
    structure: float
    freedom: int
    bic: float


def fit_decays(time: Array, signal: Array, modes: int | None = None) -> DecayFit:
    """Fit decaying modes to a recording: as many as the Bayesian information criterion takes, or as said.

    Parameters
    ----------
    time, signal : (n,) arrays
        s, rising, and any unit; at least 4 `modes` + 4 rows.
    modes : int, optional
        How many; by default 0 to `MOST_MODES`.
    """
    time = time - time[0]
    scale = float(np.std(signal))
    if not scale > _FLAT * float(np.abs(signal).max()):
        scale, modes = 1.0, 0
    y = (signal - signal.mean()) / scale
    most = min(MOST_MODES if modes is None else modes, (len(time) - 4) // 4)
    best = latest = _assess(time, y, np.empty(0))
    for count in range(1, most + 1):
        latest = min((_refine(time, y, start) for start in _starts(time, y, latest, count)), key=lambda fit: fit.bic)
        if modes is None and latest.bic > best.bic:
            break
        best = latest
    return _scaled(best, scale, float(signal.mean()))


def _scaled(fit: DecayFit, scale: float, mean: float) -> DecayFit:
    return DecayFit(
        fit.omega, fit.damping_ratio, fit.covariance, fit.amplitude * scale, fit.share, fit.fitted * scale + mean,
        fit.line * scale + mean, fit.noise * scale, fit.structure, fit.freedom, fit.bic,
    )  # fmt: skip


def _starts(time: Array, y: Array, fewer: DecayFit, count: int) -> list[Array]:
    """First guesses (ln ω, ζ of each mode): the modes found so far with one more, and all anew by the matrix pencil."""
    parameters = np.stack([np.log(fewer.omega), fewer.damping_ratio], axis=1).ravel()
    left = y - fewer.fitted if count > 1 else y - y[-max(1, len(y) // 5) :].mean()
    one = _matched(time, left)
    starts = [np.append(parameters, one)]
    # Few rows to each of the pencil's: enough for three modes up to about six times the frequency of the strongest.
    step = max(1, int(2 * math.pi / math.exp(one[0]) / np.median(np.diff(time)) / 16))
    even = np.arange(0.0, time[-1], step * time[-1] / (len(time) - 1))[:_PENCIL_ROWS]
    if len(even) >= 6 * count + 9:
        poles = matrix_pencil(np.interp(even, time, y), float(even[1]), 2 * count + 2)
        poles = poles[poles.imag > 0]
        poles = poles[np.argsort(np.abs(poles))][-count:]
        if len(poles) == count:
            starts.append(np.stack([np.log(np.abs(poles)), -poles.real / np.abs(poles)], axis=1).ravel())
    return starts


def _matched(time: Array, left: Array) -> tuple[float, float]:
    """(ln ω, ζ) of the decaying oscillation that looks most like what is left, over all frequencies and some decays."""
    n, duration = len(time), float(time[-1])
    even = np.linspace(0.0, duration, n)
    left = np.interp(even, time, left)
    size = 1 << (4 * n - 1).bit_length()
    omega = 2 * math.pi * np.fft.rfftfreq(size, duration / (n - 1))
    best = (-1.0, 1.0, 0.0)
    for decay in np.array(_DECAYS) / duration:
        fade = np.exp(-decay * even)
        power = np.abs(np.fft.rfft(left * fade, size)) ** 2 / (fade @ fade)
        # Less than half a cycle in the recording is no oscillation.
        power[omega < math.pi / duration] = 0.0
        i = int(np.argmax(power))
        best = max(best, (float(power[i]), float(omega[i]), decay), key=lambda trial: trial[0])
    _, turn, decay = best
    natural = math.hypot(turn, decay)
    return math.log(natural), decay / natural


def _refine(time: Array, y: Array, start: Array) -> DecayFit:
    """Least squares over ln ω and ζ; amplitudes and line are solved for each (variable projection)."""
    from scipy.optimize import least_squares

    interval, count = float(np.median(np.diff(time))), len(start) // 2
    # A mode stays near its start, and grows by e^10 at most: nothing overflows.
    log, undamped = start[::2], -np.minimum(_GROWTH, 10 / (np.exp(start[::2]) * time[-1]))
    slowest, fastest = math.log(0.5 / time[-1]), math.log(math.pi / interval)
    lower = np.stack([np.clip(log - _REACH, slowest, fastest - 1), undamped], axis=1).ravel()
    upper = np.stack([np.clip(log + _REACH, slowest + 1, fastest), np.full(count, _LARGEST_RATIO)], axis=1).ravel()
    inside = np.clip(start, lower + 1e-6, upper - 1e-6)

    def residual(parameters: Array) -> Array:
        columns = _columns(time, parameters)
        return y - columns @ _weights(columns, y)

    def jacobian(parameters: Array) -> Array:
        # L. Kaufman's form of variable projection: the columns' slopes, less what the columns can make up for.
        columns = _columns(time, parameters)
        weights = _weights(columns, y)
        slopes = np.empty((len(time), len(parameters)))
        for i in range(0, len(parameters), 2):
            omega, zeta, own = math.exp(parameters[i]), parameters[i + 1], weights[i + 2 : i + 4]
            for j, (more, less) in enumerate(_neighbours(omega, zeta)):
                slopes[:, i + j] = (mode_columns(time, *more) - mode_columns(time, *less)) @ own / (2 * _STEP)
        return columns @ _weights(columns, slopes) - slopes

    solution = least_squares(
        residual, inside, jac=cast("Any", jacobian), bounds=(lower, upper), x_scale="jac", max_nfev=_EVALUATIONS
    )
    return _assess(time, y, np.asarray(solution.x), np.asarray(solution.jac))


def _neighbours(omega: float, zeta: float) -> tuple[tuple[tuple[float, float], tuple[float, float]], ...]:
    """Two points to either side in ln ω, and in ζ, for central differences."""
    return (
        ((omega * math.exp(_STEP), zeta), (omega * math.exp(-_STEP), zeta)),
        ((omega, zeta + _STEP), (omega, zeta - _STEP)),
    )


def _weights(columns: Array, y: Array) -> Array:
    """Least-squares weights of the columns, by normal equations with one correction.

    Orthogonalising tall columns would be left to a threaded LAPACK, which takes twenty times longer on a busy machine.
    """
    gram = columns.T @ columns
    size = np.sqrt(np.maximum(np.diag(gram), 1e-300))
    inverse = np.linalg.inv(gram / np.outer(size, size) + _RIDGE * np.eye(len(size))) / np.outer(size, size)
    first = inverse @ (columns.T @ y)
    return first + inverse @ (columns.T @ (y - columns @ first))


def _columns(time: Array, parameters: Array) -> Array:
    pairs = parameters.reshape(-1, 2)
    own = [mode_columns(time, math.exp(log), zeta) for log, zeta in pairs]
    return np.concatenate([np.stack([np.ones_like(time), time / time[-1]], axis=1), *own], axis=1)


def _assess(time: Array, y: Array, parameters: Array, jacobian: Array | None = None) -> DecayFit:
    """The fit at given parameters, with modes in order of frequency."""
    order = np.argsort(parameters[::2])
    parameters = parameters.reshape(-1, 2)[order].ravel()
    columns, n = _columns(time, parameters), len(time)
    weights = _weights(columns, y)
    parts = [columns[:, i : i + 2] @ weights[i : i + 2] for i in range(2, columns.shape[1], 2)]
    line, fitted = columns[:, :2] @ weights[:2], columns @ weights
    left = y - fitted
    freedom = max(1, n - columns.shape[1] - len(parameters))
    squares = max(float(left @ left), _ROUNDING * float(y @ y), 1e-300)
    variance = float(left @ left) / freedom
    covariance: Array = np.zeros((len(parameters), len(parameters)))
    if jacobian is not None:
        places = np.stack([2 * order, 2 * order + 1], axis=1).ravel()
        covariance[:] = variance * np.linalg.pinv((jacobian.T @ jacobian)[np.ix_(places, places)], hermitian=True)
    rms = np.array([math.sqrt(float(p @ p)) for p in parts])
    size = columns.shape[1] + len(parameters) + 1
    bic = n * math.log(squares / n) + size * math.log(n) * n / max(1, n - size - 1)
    return DecayFit(
        np.exp(parameters[::2]), parameters[1::2], covariance, np.array([float(np.abs(p).max()) for p in parts]),
        rms / max(float(np.linalg.norm(fitted - line)), 1e-300), fitted, line, math.sqrt(variance), structure(left),
        freedom, bic,
    )  # fmt: skip
