"""Whether the samples of a curve show the peak that a fit claims."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from plategait.arrays import Array

LEAST_SAMPLES = 3
"""Frequencies that must lie within the half width of a peak: it has a height, a place and a width."""


def anywhere(low: float, high: float, *, digits: int) -> str:
    """Where something lies that the samples leave open, Hz; an end that they do not bound at all goes without words."""
    start, end = (f"{value:.{digits}g}" for value in (low, high))
    if not np.isfinite(low):
        return f"anywhere up to {end} Hz" if np.isfinite(high) else "at any frequency"
    return f"anywhere from {start} to {end} Hz" if np.isfinite(high) else f"anywhere from {start} Hz on"


def unseen_top(frequency: ArrayLike, rate: ArrayLike, *, ends_in_failure: bool = False) -> str | None:
    """Why the samples show no top, whatever its shape; None where they do.

    They show one where they rise to their highest rate and fall after it. A curve may stop at its highest where the
    object ran off at the next frequency, as the source's do at A_p = 12 deg.

    Parameters
    ----------
    frequency, rate : (n,) array_like
        Hz, in any order, repeats allowed; rates in any unit, of either sense of rotation. At least one.
    ends_in_failure : bool
        Whether the object ran off at the next higher frequency.
    """
    f, height = _heights(frequency, rate)
    if height[0] == height.max():
        return f"rates that are highest at the first frequency, {f[0]:g} Hz"
    if height[-1] == height.max() and not ends_in_failure:
        return f"rates that are highest at the last frequency, {f[-1]:g} Hz"
    return None


def unseen_peak(
    frequency: ArrayLike, rate: ArrayLike, f0: float, half_width: float, *, ends_in_failure: bool = False
) -> str | None:
    """Why the samples do not show a fitted peak, though a line through them may have it; None where they do.

    A peak is seen where the samples show a top (`unseen_top`), f0 lies among their frequencies, and at least
    `LEAST_SAMPLES` of these are within the half width of it. Where the object ran off, the last sample counts for half
    an interval more.

    Parameters
    ----------
    frequency, rate, ends_in_failure
        See `unseen_top`.
    f0, half_width : float
        Of the peak, Hz.
    """
    if fault := unseen_top(frequency, rate, ends_in_failure=ends_in_failure):
        return fault
    f = np.unique(np.asarray(frequency, dtype=float))
    beyond = (f[-1] - f[-2]) / 2 if ends_in_failure else 0.0
    if not f[0] <= f0 <= f[-1] + beyond:
        return f"a line that peaks at {f0:.4g} Hz, where nothing was measured"
    within = int(np.sum(np.abs(f - f0) <= half_width))
    if within < LEAST_SAMPLES:
        samples = "none" if within == 0 else f"only {within}"
        return f"a peak of half width {half_width:.2g} Hz at {f0:.4g} Hz with {samples} of the frequencies within it"
    return None


def _heights(frequency: ArrayLike, rate: ArrayLike) -> tuple[Array, Array]:
    """Distinct frequencies, rising, and the mean rate at each, positive where it has the sense of the largest."""
    f, which = np.unique(np.asarray(frequency, dtype=float), return_inverse=True)
    y = np.asarray(rate, dtype=float)
    mean = np.bincount(which, y) / np.bincount(which)
    return f, mean * np.sign(y[np.argmax(np.abs(y))])
