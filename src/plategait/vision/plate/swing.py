"""How the plate moves, from where it was seen: its tilt, its frequency, and where the camera stands."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from plategait.arrays import Array
from plategait.vision.stamps import Stamps

# Frames that the search for a frequency looks at, and what share of the motion a single frequency must hold.
MOST_FRAMES, LEAST_POWER = 4000, 0.5
# No plate shakes an object faster than this, Hz: twice what the source's does.
FASTEST = 80.0
# Another frequency is told from the best where it leaves this many times the squared residual, and is looked for among
# so many of the strongest.
TOLD_APART, RIVALS = 2.0, 12
# A hand or a tripod is slower than this, s.
SLOW = 0.7
# Swings of the plate's corners smaller than this are noise, px, and of its shape.
LEAST_SWING, LEAST_SHAPE = 1.0, 0.3
# Focal lengths over the picture's longer side that a camera has.
SHORTEST_FOCAL, LONGEST_FOCAL = 0.4, 12.0


@dataclass(frozen=True, eq=False)
class PlateSwing:
    """What the plate does in a clip.

    Attributes
    ----------
    frequency : float
        As the camera sees it, Hz: the true one or one that looks the same; NaN where none stands out.
    aliases : tuple of float
        Others up to 80 Hz that these frames do not tell from it, rising, Hz.
    sways : bool
        Whether the plate only moves in the picture, without a change of its shape: it may be the camera that does.
    tilt : float
        Amplitude A_p about the bar, rad; NaN where it cannot be known.
    eye : (n, 3) array or None
        Where the camera stands in the plate's frame at each frame, m; None where its focal length is unknown.
    focal : float
        Focal length, px; NaN where unknown.
    """

    frequency: float
    tilt: float
    eye: Array | None
    focal: float
    aliases: tuple[float, ...] = ()
    sways: bool = False

    @property
    def certain(self) -> bool:
        """Whether the plate's frequency is known from what was seen alone."""
        return math.isfinite(self.frequency) and not self.aliases and not self.sways


UNSEEN = PlateSwing(math.nan, math.nan, None, math.nan)
"""Of a plate whose motion is not seen."""


def plate_swing(
    stamps: Stamps, views: Array, size: tuple[float, float], middle: tuple[float, float], focal: float | None = None
) -> PlateSwing:
    """Motion of the plate from its homographies.

    Parameters
    ----------
    stamps : Stamps
        When the n frames were taken.
    views : (n, 3, 3) array
        From plate coordinates, m, to pixels; NaN where it was not seen.
    size : (length, width)
        Of the plate, m.
    middle : (x, y)
        Of the lens in the picture, px.
    focal : float, optional
        Focal length, px; from the views by default.
    """
    visible = np.isfinite(views).all(axis=(1, 2))
    if visible.sum() < 8:
        return UNSEEN
    time = stamps.time
    H = np.linalg.inv(np.array([[1, 0, middle[0]], [0, 1, middle[1]], [0, 0, 1.0]])) @ views[visible]
    frequency, aliases, sways = _frequency(time[visible], _corners(H, size), stamps)
    focal = focal or focal_of(H, max(middle) * 2)
    if not focal:
        return PlateSwing(frequency, math.nan, None, math.nan, aliases, sways)
    R, t = poses(H, focal)
    eye = np.full((len(time), 3), math.nan)
    eye[visible] = -np.einsum("nji,nj->ni", R, t)
    return PlateSwing(frequency, _tilt(time[visible], R, frequency), eye, focal, aliases, sways)


def focal_of(H: Array, longest: float) -> float | None:
    """Focal length, px, at which the plate's axes are square and alike in all views (n, 3, 3), or None.

    Pixels count from the middle of the lens. Views from straight above say nothing; a plate that tilts does.
    """
    H = H / np.linalg.norm(H[:, :2, 0], axis=1)[:, None, None] * 1e3
    h1, h2 = H[:, :, 0], H[:, :, 1]
    a = np.concatenate([np.sum(h1[:, :2] * h2[:, :2], axis=1), np.sum(h1[:, :2] ** 2 - h2[:, :2] ** 2, axis=1) / 2])
    b = np.concatenate([h1[:, 2] * h2[:, 2], (h1[:, 2] ** 2 - h2[:, 2] ** 2) / 2])
    # a / f² + b = 0; the noise is in a, so that a is regressed on b.
    square = -float(a @ b) / max(float(b @ b), 1e-30)
    scatter = float(np.std(a + square * b)) / max(math.sqrt(float(b @ b)), 1e-30)
    if square <= 0 or not SHORTEST_FOCAL * longest < math.sqrt(square) < LONGEST_FOCAL * longest:
        return None
    return math.sqrt(square) if scatter < 0.05 * square else None


def poses(H: Array, focal: float) -> tuple[Array, Array]:
    """Rotations (n, 3, 3) and translations (n, 3), m, from the plate's frame to the camera's."""
    M = np.diag([1 / focal, 1 / focal, 1.0]) @ H
    scale = 2 / (np.linalg.norm(M[:, :, 0], axis=1) + np.linalg.norm(M[:, :, 1], axis=1))
    M = M * (scale * np.sign(M[:, 2, 2]))[:, None, None]
    third = np.cross(M[:, :, 0], M[:, :, 1])
    U, _, Vt = np.linalg.svd(np.stack([M[:, :, 0], M[:, :, 1], third], axis=-1))
    return U @ Vt, M[:, :, 2]


def _tilt(time: Array, R: Array, frequency: float) -> float:
    """Amplitude of the turns about the bar, rad: of the swing at a known frequency, else half the range.

    The bar is the plate's x axis or, where only its outline is known, may be y: the one about which it turns more.
    """
    U, _, Vt = np.linalg.svd(R.mean(axis=0))
    relative = (U @ Vt).T @ R
    about = np.stack(
        [np.arctan2(relative[:, 2, 1], relative[:, 1, 1]), np.arctan2(relative[:, 0, 2], relative[:, 0, 0])]
    )
    angle = about[np.argmax(np.ptp(np.percentile(about, [5, 95], axis=1), axis=0))]
    duration, half_rate = float(np.ptp(time)), 0.5 / float(np.median(np.diff(time)))
    # Too slow for a whole swing, or one at every other frame: its phase is not seen.
    if not frequency * duration > 1 or abs(half_rate - frequency) < 1 / duration:
        low, high = np.percentile(angle, [2, 98])
        return float(high - low) / 2
    A = _swing(time, frequency)
    residual = np.abs(angle - A @ np.linalg.lstsq(A, angle, rcond=None)[0])
    inliers = residual <= 4 * 1.48 * np.median(residual) + 1e-9
    return float(np.hypot(*np.linalg.lstsq(A[inliers], angle[inliers], rcond=None)[0][:2]))


def _swing(time: Array, frequency: float) -> Array:
    turn = 2 * math.pi * frequency * time
    return np.column_stack([np.cos(turn), np.sin(turn), np.ones_like(turn)])


def _corners(H: Array, size: tuple[float, float]) -> Array:
    """(n, 8) corners of the plate, px."""
    x, y = size[0] / 2, size[1] / 2
    out = np.array([[-x, -y, 1], [x, -y, 1], [x, y, 1], [-x, y, 1]]) @ H.transpose(0, 2, 1)
    return (out[..., :2] / out[..., 2:]).reshape(len(H), 8)


def aliases_of(frequency: float, fps: float) -> tuple[float, ...]:
    """Frequencies (Hz) up to 80 Hz that even frames, `fps` per second, do not tell from this one, rising."""
    rest = frequency % fps
    rest = min(rest, fps - rest)
    every = {round(k * fps + sign * rest, 6) for k in range(int(FASTEST / fps) + 2) for sign in (-1, 1)}
    return tuple(sorted(f for f in every if 0 < f <= FASTEST and abs(f - frequency) > 1e-3))


def _frequency(time: Array, corners: Array, stamps: Stamps) -> tuple[float, tuple[float, ...], bool]:
    """Frequency of the main swing of the corners, Hz, NaN where there is none; those that fit about as well; whether
    it may be the camera's.

    Up to half the frame rate where frames come evenly. Where they do not, faster swings may be told from slow ones.
    """
    time, corners = time[:MOST_FRAMES], corners[:MOST_FRAMES]
    # A camera that sways moves the plate in the picture; a plate that tilts changes its shape there.
    shapes = _shapes(corners)
    signals = (shapes - shapes.mean(axis=0), corners - _smoothed(time, corners), corners - np.median(corners, axis=0))
    found: list[tuple[float, float]] = []
    for k, signal in enumerate(signals):
        swing = signal @ np.linalg.svd(signal, full_matrices=False)[2][0]
        swing -= swing.mean()
        if np.std(swing) >= (LEAST_SHAPE if k == 0 else LEAST_SWING):
            found = _peaks(time, swing, stamps)
        if found:
            break
    else:
        return math.nan, (), False
    (best, left), *others = found
    alike = tuple(sorted(f for f, rest in others if rest < TOLD_APART * left))
    return best, aliases_of(best, stamps.fps) if stamps.even else alike, k > 0


def _shapes(corners: Array) -> Array:
    """(n, 8) corners without their shift, size and turn in the picture: laid over their mean."""
    z = corners[:, 0::2] + 1j * corners[:, 1::2]
    z = z - z.mean(axis=1, keepdims=True)
    laid, mean = z, z.mean(axis=0)
    for _ in range(3):
        laid = z * (z.conj() @ mean / np.sum(np.abs(z) ** 2, axis=1))[:, None]
        mean = laid.mean(axis=0)
    return np.concatenate([laid.real, laid.imag], axis=1)


def _peaks(time: Array, swing: Array, stamps: Stamps) -> list[tuple[float, float]]:
    """Frequencies, Hz, that a swing may be of, and the share of its square that each leaves, the best first.

    Empty where none holds the least share of it.
    """
    duration = float(np.ptp(time))
    fastest = min(0.5 * stamps.fps, FASTEST) if stamps.even else FASTEST
    grid = np.arange(1 / duration, fastest * 1.0001, 0.2 / duration)
    if len(grid) < 3:
        return []
    few = slice(None, None, max(1, len(time) // 1000)) if stamps.even else slice(1000)
    sums = np.array([abs(np.exp(-2j * math.pi * f * time[few]) @ swing[few]) for f in grid])
    best = float(grid[int(np.argmax(sums))])
    padded = np.pad(sums, 1)
    tops = np.nonzero((sums >= padded[:-2]) & (sums >= padded[2:]))[0]
    tops = tops[np.argsort(-sums[tops])][: 1 if stamps.even else RIVALS]
    refined = sorted((_refined(float(f), time, swing, fastest) for f in (best, *grid[tops])), key=lambda peak: peak[1])
    apart: list[tuple[float, float]] = []
    for f, left in refined:
        if all(abs(f - g) > 1 / duration for g, _ in apart):
            apart.append((f, left))
    return apart if apart[0][1] < 1 - LEAST_POWER else []


def _refined(frequency: float, time: Array, swing: Array, fastest: float) -> tuple[float, float]:
    """Best frequency about one, Hz, and the share of the squared swing that it leaves."""
    duration = float(np.ptp(time))
    fine = frequency + np.linspace(-0.25, 0.25, 41) / duration
    fine = fine[(fine > 0) & (fine <= fastest * 1.0001)]
    left = []
    for f in fine:
        A = _swing(time, f)
        left.append(float(np.var(swing - A @ np.linalg.lstsq(A, swing, rcond=None)[0])) / float(np.var(swing)))
    k = int(np.argmin(left))
    return float(fine[k]), left[k]


def _smoothed(time: Array, corners: Array) -> Array:
    """(n, k) slow part of series: their mean over a window."""
    total = np.concatenate([np.zeros((1, corners.shape[1])), np.cumsum(corners, axis=0)])
    low = np.searchsorted(time, time - SLOW / 2, "left")
    high = np.searchsorted(time, time + SLOW / 2, "right")
    return (total[high] - total[low]) / (high - low)[:, None]
