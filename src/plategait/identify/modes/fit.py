"""Stiffness and damping in bending from a recorded free vibration (section 5.6.2's reference for ω_n).

A cantilever that is clamped level sags by gravity, but vibrates about its sag as it would without: to first order in
the sag, gravity adds a constant. A strip that hangs straight down does not: its own tension makes it ring higher.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import get_args

import numpy as np

from plategait.arrays import Array
from plategait.errors import InputError
from plategait.identify.fit import determined, interval
from plategait.identify.modes.decay import DecayFit, fit_decays
from plategait.identify.modes.recording import LEAST_ROWS, RingRecording, shortened
from plategait.identify.modes.result import RingMode, RingResult, Support
from plategait.identify.series import Window
from plategait.model.measured import CONFIDENCE, Measured
from plategait.model.outline import occupied_squares
from plategait.model.sheet import Sheet
from plategait.theory.rigid import GRAVITY
from plategait.theory.vibration import cantilever_frequencies

_NEAR_NYQUIST = 1 / 3  # of the rows per second: a frequency above may well be another one, folded
_STRUCTURED = 0.3  # correlation of neighbouring residuals that noise does not have
_FAINT = 0.03  # share of the motion below which a mode is not worth a word
_LEAST_NOISE = 1e-3  # of the amplitude: residuals below change nothing
_LARGE_SAG = 0.1  # of the length, from which gravity shifts the frequency noticeably
_AREA_GRID = 200  # squares across the outline to count its area


def identify_ring(
    recording: RingRecording,
    sheet: Sheet,
    *,
    support: Support = "free",
    length: float | None = None,
    length_sd: float = 0.0,
    mass_per_area: float | None = None,
    start: float = -math.inf,
    end: float = math.inf,
    mode: int | None = None,
) -> RingResult:
    """Fit a free vibration, and turn its frequency and damping into k_b and c_b of a sheet.

    Parameters
    ----------
    recording : RingRecording
    sheet : Sheet
        What the result is laid over; its mass, outline and pitch are taken as they are.
    support : {"free", "cantilever"}
        A free sheet rings in its dish mode, ω_n. A strip cut from it and clamped level at one end rings at
        ω = 1.875² √(D / (σ L⁴)), and D = k_b.
    length, length_sd : float
        Free length of the strip L and its sd, m: an L that is 1 % off makes k_b 4 % wrong.
    mass_per_area : float, optional
        σ of the strip, kg/m²; by default the sheet's mass over the area of its outline.
    start, end : float
        Times between which it rings freely, s.
    mode : int, optional
        Which mode of those found, 1 is the slowest; by default the strongest that rings.

    Returns
    -------
    RingResult
        Damping is in proportion to stiffness, as in the joints: ζ = c_b ω / (2 k_b).

    Raises
    ------
    InputError
        For an unknown support, a cantilever without a length, too few rows in between, or no such mode.
    """
    if support not in get_args(Support):
        raise InputError("--support", support, "free or cantilever", "cantilever")
    if support == "cantilever" and length is None:
        raise InputError("--length", "nothing", "the free length of the strip", '--length "20 mm"')
    time, signal, notes = shortened(*Window(start, end).cut(recording.time, recording.signal, least=LEAST_ROWS))
    fit = fit_decays(time, signal)
    modes = tuple(_mode(fit, i, float(time[-1] - time[0])) for i in range(len(fit.omega)))
    index = _pick(modes, mode)
    notes += _oddities(fit, modes, index, time)
    result = RingResult(
        name=recording.name, kind=recording.kind, support=support, sheet=sheet.name, modes=modes, mode_index=None,
        natural_frequency=None, stiffness=None, damping=None, correlation=0.0, torsion_ratio=_torsion_ratio(sheet),
        time=time, signal=signal, fitted=fit.fitted, notes=tuple(notes),
    )  # fmt: skip
    if index is None or not modes[index].rings:
        return replace(result, notes=(*notes, _why_nothing(modes)))
    if length is None or support == "free":
        bending = sheet.with_natural_frequency(modes[index].omega.value).bending_stiffness
        return _with_joints(result, fit, index, sheet, bending)
    mass_per_area = _mass_per_area(sheet) if mass_per_area is None else mass_per_area
    bending = _cantilever_stiffness(modes[index].omega.value, mass_per_area, length)
    sagging = _sagging(mass_per_area * GRAVITY * length**3 / (8 * bending))
    return _with_joints(replace(result, notes=(*notes, *sagging)), fit, index, sheet, bending, 4 * length_sd / length)


def _pick(modes: tuple[RingMode, ...], mode: int | None) -> int | None:
    """Place of the mode asked for, or of the strongest that rings; None where nothing rings."""
    if mode is None or not modes:
        ringing = [i for i, m in enumerate(modes) if m.rings]
        return max(ringing, key=lambda i: modes[i].share, default=None)
    if not 1 <= mode <= len(modes):
        raise InputError("--mode", mode, f"from 1 to the {len(modes)} modes found", "leaving it out")
    return mode - 1


def _cantilever_stiffness(omega: float, mass_per_area: float, length: float) -> float:
    """D = k_b of a strip from its first frequency, ω = 1.875² √(D / (σ L⁴))."""
    return (omega / float(cantilever_frequencies(1.0, mass_per_area, length)[0])) ** 2


def _sagging(sag: float) -> list[str]:
    """Note of a strip that sags by a large share of its length."""
    if sag <= _LARGE_SAG:
        return []
    return [f"it sags by about {100 * sag:.0f} % of its length, which shifts its frequency: a shorter strip"]


def _with_joints(
    result: RingResult, fit: DecayFit, index: int, sheet: Sheet, bending: float, spread: float = 0.0
) -> RingResult:
    """Result with stiffness and damping read off one mode.

    Parameters
    ----------
    bending : float
        k_b, N m/rad.
    spread : float
        Standard deviation of ln k_b that the frequency does not explain.
    """
    mode = result.modes[index]
    omega, zeta = mode.omega.value, mode.damping_ratio.value
    own = slice(2 * index, 2 * index + 2)
    # ln k_b = 2 ln ω + 4 ln L + …, ln c_b = ln ζ + ln ω + 4 ln L + ….
    slopes = np.array([[2.0, 0.0, 1.0], [1.0, 1 / zeta if zeta else 0.0, 1.0]])
    covariance = np.block([
        [_covariance(fit)[own, own], np.zeros((2, 1))], [np.zeros((1, 2)), np.array([[spread**2]])]
    ])  # fmt: skip
    (kk, kc), (_, cc) = slopes @ covariance @ slopes.T
    whole = sheet.replace(bending_stiffness=bending, torsion_stiffness=bending * _torsion_ratio(sheet))
    result = replace(
        result,
        mode_index=index,
        natural_frequency=_logarithmic(whole.natural_frequency, math.sqrt(kk) / 2, fit.freedom),
        stiffness=_logarithmic(bending, math.sqrt(kk), fit.freedom),
    )
    if not determined(mode.damping_ratio):
        note = "the damping is not determined: record longer, or with less noise"
        return replace(result, notes=(*result.notes, note))
    return replace(
        result,
        damping=_logarithmic(2 * zeta * bending / omega, math.sqrt(cc), fit.freedom),
        correlation=float(kc / math.sqrt(kk * cc)) if kk * cc > 0 else 0.0,
    )


def _torsion_ratio(sheet: Sheet) -> float:
    return sheet.torsion_stiffness / sheet.bending_stiffness if sheet.bending_stiffness else 0.0


def _mass_per_area(sheet: Sheet) -> float:
    """Mass over the area within the outline, which the squares of the lattice only come near."""
    square = max(sheet.outline.size()) / _AREA_GRID
    return sheet.mass / (float(occupied_squares(sheet.outline, square).sum()) * square**2)


def _covariance(fit: DecayFit) -> Array:
    """Widened where neighbouring residuals hang together, as for a first-order process."""
    r = min(fit.structure, 0.95)
    return fit.covariance * ((1 + r) / (1 - r) if r > _STRUCTURED else 1.0)


def _mode(fit: DecayFit, i: int, duration: float) -> RingMode:
    sds = np.sqrt(np.diag(_covariance(fit)))
    omega = _logarithmic(float(fit.omega[i]), float(sds[2 * i]), fit.freedom)
    ratio = interval(float(fit.damping_ratio[i]), float(sds[2 * i + 1]), fit.freedom)
    turned = omega.value * math.sqrt(max(0.0, 1 - ratio.value**2)) * duration
    rings = ratio.high < 1 and turned >= 2 * math.pi and omega.high < 2 * omega.low
    return RingMode(omega, ratio, float(fit.amplitude[i]), float(fit.share[i]), bool(rings))


def _logarithmic(value: float, sd: float, freedom: float) -> Measured:
    """What is positive, from the sd of its logarithm."""
    from scipy.special import stdtrit

    reach = math.exp(min(50.0, float(stdtrit(freedom, (1 + CONFIDENCE) / 2)) * sd))
    return Measured(value, value * sd, value / reach, value * reach)


def _oddities(fit: DecayFit, modes: tuple[RingMode, ...], index: int | None, time: Array) -> list[str]:
    notes = []
    rate = (len(time) - 1) / float(time[-1] - time[0])
    if any(m.rings and m.frequency > _NEAR_NYQUIST * rate for m in modes):
        notes.append(f"fewer than three rows to a cycle at {rate:.3g} rows per second: it may be a faster ring, folded")
    ringing = sum(m.rings and m.share > _FAINT for m in modes)
    if index is not None and ringing > 1:
        notes.append(f"{ringing} modes ring: the numbers are of mode {index + 1}; --mode picks another")
    if fit.structure > _STRUCTURED and fit.noise > _LEAST_NOISE * max((m.amplitude for m in modes), default=0.0):
        notes.append(
            "the residuals are no noise, intervals are widened: leave out what comes before the release (--from)"
        )
    return notes


def _why_nothing(modes: tuple[RingMode, ...]) -> str:
    if not modes:
        return "nothing moves beyond the noise: no ringing, not determined"
    strongest = max(modes, key=lambda m: m.share)
    if strongest.damping_ratio.value >= 1 or strongest.damping_ratio.high >= 1:
        return "no ringing, it settles (overdamped or nearly so): not determined"
    return "no ringing that lasts a cycle: not determined; record longer"
