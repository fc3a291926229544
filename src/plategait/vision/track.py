"""From a video to poses and a spin rate: frame by frame, with what is uncertain marked and not guessed."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array, Flags
from plategait.files.plain import plain
from plategait.vision.frames import Frame, open_video
from plategait.vision.lens import straightener, zoomed
from plategait.vision.object.parallax import bending
from plategait.vision.object.pose import Pose
from plategait.vision.plate.swing import PlateSwing, plate_swing
from plategait.vision.plate.view import PlateView, ScalePlate
from plategait.vision.spin import Spin, apparent_frequency, joined, spin_of, strays
from plategait.vision.survey import Eyes, Setup

# A picture that changes by less than this share of the usual change repeats the one before it.
REPEATED = 0.03
# Successive frames at the end without the object that mean that it has gone, s.
GONE = 0.5
# Least turn of a texture that is the object's for sure, rad.
LEAST_TURN = math.radians(10)
# Parallax smaller than this is not worth a note, deg.
NOTED_TURN = 0.5
FollowFrame = Callable[[Frame, PlateView, Pose], object]


@dataclass(frozen=True, eq=False)
class Track:
    """An object's pose in each frame of a clip, and what follows from it.

    Attributes
    ----------
    name : str
    time, x, y : (n,) arrays
        s, and the object's middle in plate coordinates, m; NaN where it was not seen.
    angle : (n,) array
        Orientation, rad, counter-clockwise, joined over whole turns on the sure frames; else as seen, or NaN.
    sure : (n,) bool array
    reason : tuple of str
        Of each frame, why it is uncertain; empty where it is sure.
    method : str
        "markers", "texture" or "outline".
    symmetry : int
        Turns of a full circle over this look the same.
    fps : float
        Frames per second, as they came.
    plate : PlateSwing
    plate_frequency : float
        As given, else as the camera saw it, Hz; NaN where unknown.
    spin : Spin
    notes : tuple of str
        What to know about the clip.
    """

    name: str
    time: Array
    x: Array
    y: Array
    angle: Array
    sure: Flags
    reason: tuple[str, ...]
    method: str
    symmetry: int
    fps: float
    plate: PlateSwing
    plate_frequency: float
    spin: Spin
    notes: tuple[str, ...] = ()

    @property
    def drift(self) -> float:
        """Farthest that the middle, averaged over half a second, came from where it was at first, m."""
        x, y, t = self.x[self.sure], self.y[self.sure], self.time[self.sure]
        if len(t) < 4:
            return math.nan
        bins = ((t - t[0]) / GONE).astype(int)
        count = np.maximum(np.bincount(bins), 1e-9)
        full = count > 1
        mx, my = (np.bincount(bins, v) / count for v in (x, y))
        mx, my = mx[full], my[full]
        return float(np.hypot(mx - mx[0], my - my[0]).max()) if len(mx) else math.nan

    def reasons(self) -> dict[str, int]:
        """Why frames are uncertain, and how many each, the commonest first."""
        found = [r for r in self.reason if r]
        return {r: found.count(r) for r in sorted(set(found), key=lambda r: -found.count(r))}

    def summary(self) -> dict[str, Any]:
        """Plain numbers for `--json`; None where nothing could be measured."""
        spin, n = self.spin, len(self.time)
        numbers: dict[str, Any] = {
            "clip": self.name,
            "spin_rate_deg_s": math.degrees(spin.rate),
            "spin_rate_interval_deg_s": [math.degrees(spin.low), math.degrees(spin.high)],
            "spin_rate_sd_deg_s": math.degrees(spin.sd),
            "settled": spin.settled,
            "no_spin_rate": spin.reason or None,
            "indistinguishable_rates_deg_s": [math.degrees(a) for a in spin.aliases],
            "drift_mm": 1e3 * self.drift,
            "method": self.method,
            "symmetry": self.symmetry,
            "frames": n,
            "sure_frames": int(self.sure.sum()),
            "uncertain": self.reasons(),
            "fps": self.fps,
            "duration_s": float(self.time[-1] - self.time[0]),
            "plate_frequency_hz": self.plate_frequency,
            "plate_frequency_seen_hz": self.plate.frequency,
            "plate_tilt_deg": math.degrees(self.plate.tilt),
            "notes": [*self.notes, *spin.notes],
        }
        return {key: plain(value) for key, value in numbers.items()}


def track(
    source: Path | str,
    setup: Setup | None = None,
    *,
    follow: FollowFrame | None = None,
    progress: Callable[[float], object] | None = None,
) -> Track:
    """Follow the object in a video.

    Memory does not grow with the clip but for some numbers per frame.

    Parameters
    ----------
    source : Path or str
        A video file, or the number of a camera.
    setup : Setup, optional
        How it was filmed.
    follow : callable, optional
        Called with each frame, the plate and the pose seen in it.
    progress : callable, optional
        Called with the fraction done.

    Raises
    ------
    InputError
        When it is no video, shows no plate or no object, or shows several objects.
    """
    setup = setup or Setup()
    eyes = Eyes(source, setup)
    times: list[float] = []
    views: list[Array] = []
    changes: list[float] = []
    poses: dict[str, list[Pose]] = {name: [] for name in eyes.methods}
    with open_video(source, fps=setup.fps, seconds=setup.seconds) as video:
        straight = straightener(setup.calibration, video.width, video.height)
        for frame in video.frames():
            frame = straight(frame)
            view, seen = eyes.see(frame)
            times.append(frame.time)
            changes.append(frame.change)
            views.append(np.full((3, 3), math.nan) if view.homography is None else view.homography)
            for name, pose in seen.items():
                poses[name].append(pose)
            if follow is not None:
                follow(frame, view, next((p for p in seen.values() if not p.reason), next(iter(seen.values()))))
            if progress is not None and video.length and frame.index % 16 == 0:
                progress(min(1.0, frame.index / video.length))
        name, notes = video.name, list(video.notes)
    return _assembled(name, np.array(times), np.array(views), np.array(changes), poses, eyes, setup, notes)


def _assembled(
    name: str, time: Array, views: Array, changes: Array, poses: dict[str, list[Pose]], eyes: Eyes, setup: Setup,
    notes: list[str],
) -> Track:  # fmt: skip
    """Put the track of the better method together."""
    method = setup.object if setup.object in poses else _better(poses)
    chosen = poses[method]
    x, y, angle = (np.array([getattr(p, k) for p in chosen]) for k in ("x", "y", "angle"))
    reason = [p.reason for p in chosen]
    repeated = changes < REPEATED * np.median(changes)
    if repeated.any():
        reason = [r or ("repeated picture" if again else "") for r, again in zip(reason, repeated, strict=True)]
    symmetry = 1
    if eyes.texture is not None:
        symmetry = (eyes.texture.texture if method == "texture" else eyes.texture.outline).symmetry()
        notes.append(f"no markers: followed by its {method}")
    if symmetry > 1:
        notes.append(f"the object looks the same after 1/{symmetry} of a turn")
    interval = float(np.median(np.diff(time))) if len(time) > 1 else math.nan
    fps = 1 / interval if interval > 0 else math.nan
    if len(time) > 2:
        _note_intervals(np.diff(time), interval, notes)
    middle, focal = ((eyes.picture[0] - 1) / 2, (eyes.picture[1] - 1) / 2), None
    if setup.calibration is not None:
        K = zoomed(setup.calibration, eyes.picture[0])
        middle, focal = (float(K[0, 2]), float(K[1, 2])), float(K[0, 0] + K[1, 1]) / 2
    elif eyes.plate.lens is not None:
        focal = float(eyes.plate.lens[0, 0])
    fresh = np.where(repeated[:, None, None], math.nan, views)
    moved = plate_swing(time, fresh, setup.plate_size, middle, focal)
    if isinstance(eyes.plate, ScalePlate):
        moved = PlateSwing(math.nan, math.nan, None, math.nan)
    agree = _note_frequency(setup.plate_frequency, moved.frequency, fps, notes)
    frequency = setup.plate_frequency or moved.frequency
    sure = np.array([not r for r in reason]) & np.isfinite(angle)
    # What is seen decides what the swing does to the frames.
    swing = frequency if agree else moved.frequency
    swing = swing if math.isfinite(swing) else None
    spin = spin_of(time, angle, sure, symmetry=symmetry, fps=fps, plate_frequency=swing)
    if math.isfinite(spin.rate):
        angle, part = _joined(time, angle, sure, spin, symmetry)
        if method == "markers" and moved.eye is not None and swing is not None:
            apart, place = np.array([p.apart for p in chosen]), np.stack([x, y], axis=1)
            bent = bending(time[sure], angle[sure], apart[sure], place[sure], moved.eye[sure], swing)
            if bent is not None:
                angle[sure] -= bent.turn
                most = math.degrees(float(np.abs(bent.turn).max()))
                if most > NOTED_TURN:
                    notes.append(f"angles are freed of the parallax of bending, up to {most:.1f} deg")
        for k in np.nonzero(sure)[0][strays(time[sure], angle[sure], part, swing, fps)]:
            sure[k], reason[k] = False, "out of line with the frames around it"
        spin = spin_of(time, angle, sure, symmetry=symmetry, fps=fps, plate_frequency=swing)
    if method != "markers":
        spin = _turning(spin, float(np.ptp(time)), method, symmetry)
    if len(time) and not sure[time > time[-1] - GONE].any() and sure.any() and time[-1] - time[0] > 2 * GONE:
        notes.append(f"the object is not seen after {time[sure][-1]:.2f} s")
    return Track(
        name, time, x, y, angle, sure, tuple(reason), method, symmetry, fps, moved,
        frequency, spin, tuple(notes),
    )  # fmt: skip


def _turning(spin: Spin, duration: float, method: str, symmetry: int) -> Spin:
    """Spin, unless the object turns too little to be told from light on it and from its bending, which do not turn."""
    least = 2 * math.pi / symmetry if method == "outline" else LEAST_TURN
    if math.isfinite(spin.rate) and abs(spin.rate) * duration < least:
        nan = math.nan
        reason = f"its {method} hardly turns, and may be that of light or of bending rather than its own"
        return Spin(nan, nan, nan, False, nan, (), reason, spin.notes)
    return spin


def _better(poses: dict[str, list[Pose]]) -> str:
    """Method with the most sure frames; the first of those as good."""
    counts = {name: sum(not p.reason for p in series) for name, series in poses.items()}
    return max(counts, key=lambda name: (counts[name] > 0.9 * max(counts.values()), -list(counts).index(name)))


def _joined(time: Array, angle: Array, sure: Flags, spin: Spin, symmetry: int) -> tuple[Array, NDArray[np.intp]]:
    """Angles with those of the sure frames joined over whole turns, and the part of each of these."""
    line, part = joined(time[sure], symmetry * angle[sure], symmetry * spin.rate)
    out = angle.copy()
    out[sure] = line / symmetry
    return out, part


def _note_intervals(intervals: Array, usual: float, notes: list[str]) -> None:
    missing = int(np.sum(np.round(intervals[intervals > 1.5 * usual] / usual) - 1))
    if missing:
        notes.append(f"frames missing by their times: {missing}")
    regular = intervals[(intervals < 1.5 * usual)]
    if len(regular) and np.std(regular) > 0.1 * usual:
        notes.append("the frame rate varies")


def _note_frequency(given: float | None, seen: float, fps: float, notes: list[str]) -> bool:
    """Whether what the plate is said to do agrees with what is seen of it; note what does not, or may be otherwise."""
    if not math.isfinite(seen):
        return True
    shown = seen if given is None else given if seen > 0.5 * fps else apparent_frequency(given, fps)
    if given is None and seen <= 0.5 * fps:
        others = ", ".join(f"{k * fps + s * seen:.4g}" for k in (1, 2) for s in (-1, 1))
        notes.append(f"the plate is seen at {seen:.4g} Hz; on even frames {others} Hz look the same")
    agree = abs(shown - seen) <= max(0.01 * fps, 0.3)
    if not agree:
        notes.append(
            f"the plate was said to swing at {given:.4g} Hz, which would look like {shown:.4g} Hz here, "
            f"but is seen at {seen:.4g} Hz"
        )
    return agree
