"""What the published numbers ask of a choice: residuals of all aims at once, in units of what each may miss."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from plategait import published
from plategait.arrays import Array, Flags
from plategait.study.evaluation import N_GAITS, OUTPUTS, Evaluation, is_reference

CURVES = published.curves()
MAY_MISS = {"f0_hz": 0.03, "b_over_f0": 0.15, "peak": 0.10, "r2": 0.05, "line": 0.15}
"""Deviation that counts as one: relative, but for R²; of a line's height a share of what it spans."""
NO_FIT = 3.0
"""Deviations that what cannot be measured counts as: f0 and b/f0 of a curve without a fit each, a peak, a rate."""
RATE_AT_12 = 350.0
"""Spin rate at A_p = 12 deg and 12 Hz, deg/s, running (section 4.3)."""
REFERENCE = np.array([is_reference(c) for c in CURVES])
"""Curves at the reference friction angle."""
_ANGLE = np.array([c.angle_deg for c in CURVES])
_OMEGA = np.array([c.omega_pi for c in CURVES])
_ALPHA = np.array([c.alpha_deg for c in CURVES])
PUBLISHED_F0, PUBLISHED_RATIO = (np.array([getattr(c, name) for c in CURVES]) for name in ("f0_hz", "b_over_f0"))
"""Of each curve, Hz and none."""
PEAKS = {(int(row[0]), float(row[1])): float(row[3]) for row in published.numbers()["rotation"]["rows"]}
"""ω_Br max of Table 5.9, deg/s, by A_p (deg) and ω_n (π rad/s)."""


@dataclass(frozen=True, eq=False)
class Residuals:
    """Deviations (n, aims) of choices from what is published, each over what it may miss, in the order of `KIND`."""

    values: Array

    def loss(self, used: Flags | None = None) -> Array:
        """(n,) sums of squares, over all aims or those used."""
        squares = self.values**2
        return squares.sum(axis=1) if used is None else squares[:, used].sum(axis=1)


def residuals(
    fits: Array, at_12: Array, gaits: Array, uncertainty: Array | None = None, missing: Array | None = None
) -> Residuals:
    """Residuals of choices.

    Parameters
    ----------
    fits : (n, curves, outputs) array
        `OUTPUTS` of the fits; NaN where a curve has none.
    at_12 : (n,) array
        Rate at A_p = 12 deg and 12 Hz, deg/s; NaN where it fails.
    gaits : (n, 5) array
        See `plategait.study.evaluation.Evaluation`: each is a deviation.
    uncertainty : (curves, outputs) or (n, curves, outputs) array, optional
        Of the fits, relative, where they come from a surrogate: added in quadrature to what they may miss.
    missing : (n, curves) array, optional
        Chance that a curve has no fit, where a surrogate tells it; by default 1 where `fits` has none.
    """
    error = np.zeros((len(CURVES), len(OUTPUTS))) if uncertainty is None else uncertainty
    f0, ratio, peak = (fits[:, :, i] for i in range(len(OUTPUTS)))
    missing = np.isnan(f0).astype(float) if missing is None else missing
    blocks = [
        np.nan_to_num((f0 / PUBLISHED_F0 - 1) / np.hypot(MAY_MISS["f0_hz"], error[..., 0])),
        np.nan_to_num((ratio / PUBLISHED_RATIO - 1) / np.hypot(MAY_MISS["b_over_f0"], error[..., 1])),
        math.sqrt(2) * NO_FIT * missing,
    ]
    for (angle, omega), printed in PEAKS.items():
        of_object = np.where(np.isfinite(peak), peak, -math.inf)[:, (angle == _ANGLE) & (omega == _OMEGA)].max(axis=1)
        blocks.append((np.where(np.isfinite(of_object), of_object, math.nan) / printed - 1)[:, None] / MAY_MISS["peak"])
    for angle in published.AMPLITUDES:
        members, printed = angle == _ANGLE, published.regression(angle)
        for x, published_x, y, r2, slope, intercept in (
            (f0[:, members], PUBLISHED_F0[members], _OMEGA[members], "r2_f0", "p1", "q1"),
            (ratio[:, members], PUBLISHED_RATIO[members], _ALPHA[members], "r2_ratio", "p2", "q2"),
        ):
            line, middle = _lines(x, y), published_x.mean()
            wanted = printed[slope].value * middle + printed[intercept].value
            # Slope and intercept go together; slope and the height over the middle do not.
            off = (line[:, 1] * middle + line[:, 2] - wanted) / np.ptp(y)
            blocks.append((line[:, :1] - printed[r2].value) / MAY_MISS["r2"])
            blocks.append(np.stack([line[:, 1] / printed[slope].value - 1, off], axis=1) / MAY_MISS["line"])
    blocks.append((at_12 / RATE_AT_12 - 1)[:, None] / MAY_MISS["peak"])
    blocks.append(gaits)
    values = np.concatenate(blocks, axis=1)
    return Residuals(np.where(np.isfinite(values), np.clip(values, -2 * NO_FIT, 2 * NO_FIT), NO_FIT))


def residuals_of(evaluation: Evaluation, fit_from: int) -> Residuals:
    """Residuals of an evaluation's choices where the fit begins at one of `FITS_FROM`."""
    return residuals(evaluation.fits[:, fit_from], evaluation.at_12, evaluation.gaits)


N_CURVES = len(CURVES)
_LINES = [kind for _ in published.AMPLITUDES for kind in ("R² of ω_n", "line", "line", "R² of α", "line", "line")]
_BY_CURVE = [kind for kind in ("f0", "b/f0", "no fit") for _ in CURVES]
KIND = np.array([*_BY_CURVE, *["peak"] * len(PEAKS), *_LINES, "12 Hz", *["gaits"] * N_GAITS])
"""What each aim is about."""
OF_CURVE = (KIND == "f0") | (KIND == "b/f0")
"""Aims of single curves: their numbers."""
HAS_FIT = KIND == "no fit"
"""Aims of single curves: that there is a fit at all."""
AT_REFERENCE = np.append(np.tile(REFERENCE, 2), np.zeros(len(KIND) - 2 * N_CURVES, dtype=bool))
"""Those of `OF_CURVE` at the reference friction angle."""


def _lines(x: Array, y: Array) -> Array:
    """(n, 3) R², slope and intercept of y on each row of x, where it is known."""
    known = np.isfinite(x)
    count = np.maximum(known.sum(axis=1), 1)
    x0 = np.where(known, x, 0.0)
    y0 = np.where(known, y, 0.0)
    mean_x, mean_y = x0.sum(axis=1) / count, y0.sum(axis=1) / count
    dx, dy = np.where(known, x - mean_x[:, None], 0.0), np.where(known, y - mean_y[:, None], 0.0)
    sxx, sxy, syy = (dx**2).sum(axis=1), (dx * dy).sum(axis=1), (dy**2).sum(axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        slope, r2 = sxy / sxx, sxy**2 / (sxx * syy)
    return np.stack([r2, slope, mean_y - slope * mean_x], axis=1)
