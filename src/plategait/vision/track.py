"""From a video to poses and a spin rate: frame by frame, with what is uncertain marked and not guessed."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from itertools import chain
from pathlib import Path
from typing import Any

import numpy as np

from plategait.arrays import Array, Flags
from plategait.camera.fiducials import CENTRE_MARKER, RIM_MARKER
from plategait.files.plain import plain
from plategait.shown import Shown
from plategait.vision.departure import hidden_after
from plategait.vision.findings import Findings, findings, whereabouts
from plategait.vision.frames import Frame, open_video, repeats
from plategait.vision.lens import scaled_matrix
from plategait.vision.object.pose import Pose
from plategait.vision.object.tracker import ObjectTracker
from plategait.vision.plate.fiducials import BLURRED_FIDUCIALS
from plategait.vision.plate.swing import UNSEEN, PlateSwing, plate_swing
from plategait.vision.plate.view import PlateView, ScalePlate
from plategait.vision.pose_reader import PoseReader, learnt
from plategait.vision.pose_series import PoseSeries
from plategait.vision.setup import Setup
from plategait.vision.spin import Spin, apparent_frequency
from plategait.vision.stamps import Stamps, stamps_of
from plategait.vision.survey import straight_frames

# Least turn of a texture that is the object's for sure, rad.
LEAST_TURN = math.radians(10)
# Why no frame is sure of a clip whose orientation gives no rate.
NO_RATE = "no spin rate agrees with it"
# Markers are like ours where the scales of both agree within this, of the logarithm; another scale than 1 is noted.
LIKE_OURS, OTHER_SCALE = 0.12, 0.13
CHECK_SIZE = "if they are those, check --plate-size"
# Share of the frames whose fiducials are blurred that is worth a note.
LEAST_BLURRED = 0.1
FrameCallback = Callable[[Frame, PlateView, Pose], object]


@dataclass(frozen=True, eq=False, repr=False)
class Track(Shown):
    """An object's pose in each frame of a clip, and what follows from it.

    Attributes
    ----------
    name : str
    time, x, y : (n,) arrays
        s, and the object's middle in plate coordinates, m; NaN where it was not seen.
    angle : (n,) array
        Orientation, rad, counter-clockwise, joined over whole turns on the sure frames; else as seen, or NaN.
    sure : (n,) bool array
        Whether the orientation is; nowhere in a clip whose orientation gives no rate.
    placed : (n,) bool array
        Whether the middle is where it was seen.
    reason : tuple of str
        Of each frame, why its orientation is uncertain; empty where it is sure.
    method : str
        "markers", "texture" or "outline".
    symmetry : int
        Turns of a full circle over this look the same.
    fps : float
        Frames per second, as they came.
    plate : PlateSwing
    plate_frequency : float
        As given, else as the camera saw it where nothing else looks the same, Hz; NaN where unknown.
    spin : Spin
    findings : Findings
        What it shows beside its turning.
    notes : tuple of str
        What to know about the clip.
    """

    name: str
    time: Array
    x: Array
    y: Array
    angle: Array
    sure: Flags
    placed: Flags
    reason: tuple[str, ...]
    method: str
    symmetry: int
    fps: float
    plate: PlateSwing
    plate_frequency: float
    spin: Spin
    findings: Findings
    notes: tuple[str, ...] = ()

    def told(self) -> list[tuple[str, str]]:
        """What a person asks first."""
        spin, n = self.spin, len(self.time)
        rate = (
            f"{math.degrees(spin.rate):.1f} deg/s (95 % {math.degrees(spin.low):.1f} to {math.degrees(spin.high):.1f})"
        )
        return [
            ("clip", self.name), ("frames", f"{n} at {self.fps:.4g} a second, {int(self.sure.sum())} sure"),
            ("followed by", self.method), ("spin rate", rate if math.isfinite(spin.rate) else spin.reason or "none"),
            ("drift", f"{1e3 * self.drift:.3g} mm"), ("failure", self.failure or "none"),
            ("plate", f"{self.plate_frequency:.4g} Hz" if math.isfinite(self.plate_frequency) else "frequency unknown"),
            *(("note", note) for note in self.notes[:3]),
        ]  # fmt: skip

    @property
    def drift(self) -> float:
        """Farthest that the outline's middle came from where it was at first, m."""
        return self.findings.departure.drift

    @property
    def true_to_scale(self) -> bool:
        """Whether nothing speaks against the plate's size that was told, by which lengths are measured."""
        return not any(note.endswith(CHECK_SIZE) for note in self.notes)

    @property
    def failure(self) -> str:
        """What happened to the object: "slipped", "left the plate"; empty where it stayed."""
        return self.findings.departure.kind

    def reasons(self) -> dict[str, int]:
        """Why frames are uncertain, and how many each, the commonest first."""
        reasons = [r for r in self.reason if r]
        return {r: reasons.count(r) for r in sorted(set(reasons), key=lambda r: -reasons.count(r))}

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
            **self.findings.summary(),
            "method": self.method,
            "symmetry": self.symmetry,
            "frames": n,
            "sure_frames": int(self.sure.sum()),
            "uncertain": self.reasons(),
            "fps": self.fps,
            "duration_s": float(self.time[-1] - self.time[0]),
            "plate_frequency_hz": self.plate_frequency,
            "plate_frequency_seen_hz": self.plate.frequency,
            "plate_frequency_aliases_hz": list(self.plate.aliases),
            "plate_tilt_deg": math.degrees(self.plate.tilt),
            "notes": [*self.notes, *spin.notes],
        }
        return {key: plain(value) for key, value in numbers.items()}


def track(
    source: Path | str,
    setup: Setup | None = None,
    *,
    follow: FrameCallback | None = None,
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
    reader, readings = _read_frames(source, setup, follow, progress)
    notes = list(readings.notes)
    method = setup.object if setup.object in readings.poses else _better(readings.poses)
    stamps, repeated = stamps_of(np.array(readings.time)), repeats(np.array(readings.changes))
    notes += stamps.notes
    time, fps = stamps.time, stamps.fps
    poses = PoseSeries.of(time, readings.poses[method], repeated)
    symmetry = _symmetry(reader.object, method, notes)
    _note_marker_size(reader.object, notes)
    plate = _plate_swing(stamps, np.array(readings.views), repeated, reader, setup)
    agree = _note_frequency(setup.plate_frequency, plate, stamps, notes)
    frequency = setup.plate_frequency or (plate.frequency if plate.certain else math.nan)
    # What is seen decides what the swing does to the frames.
    swing = setup.plate_frequency or plate.frequency if agree else plate.frequency
    eye = plate.eye if method == "markers" else None
    wave = swing if math.isfinite(swing) else None

    _, _, gone = whereabouts(time, poses.seen, poses.sure, poses.rim, setup.plate_size)
    poses.leave(gone)
    spin = poses.spin(symmetry, fps, wave, eye, notes)
    if method != "markers":
        spin = _turning(spin, float(np.ptp(time)), method, symmetry)
    placed, last = poses.sure, hidden_after(time, poses.sure)
    seen = findings(
        time, poses.seen, poses.angle, poses.sure, poses.rim, eye=plate.eye, swing=wave, fps=fps,
        plate=setup.plate_size, pixel=reader.grid.pitch, marked=method == "markers", no_edge=reader.object.no_edge,
    )  # fmt: skip
    if math.isnan(spin.rate):
        left = f"{gone.kind} at {gone.time:.2f} s: " if gone.kind else ""
        spin = replace(spin, reason=left + spin.reason + _mostly(poses.reason))
        poses.reason = [reason or NO_RATE for reason in poses.reason]
    if readings.blurred > LEAST_BLURRED * len(time):
        notes.append(f"in {readings.blurred} frames the fiducials are blurred: a shorter exposure would make them sure")
    if not gone.kind and math.isfinite(last):
        notes.append(f"the object is not seen after {last:.2f} s")
    return Track(
        readings.name, time, poses.x, poses.y, poses.angle, poses.sure, placed, tuple(poses.reason), method, symmetry,
        fps, plate, frequency, spin, seen, tuple(notes),
    )  # fmt: skip


@dataclass(eq=False)
class _Readings:
    """What is read off a clip, frame by frame: poses by method, and views of the plate, NaN where it was not seen."""

    name: str
    time: list[float]
    changes: list[float]
    views: list[Array]
    poses: dict[str, list[Pose]]
    notes: list[str]
    blurred: int = 0


def _read_frames(
    source: Path | str,
    setup: Setup,
    follow: FrameCallback | None,
    progress: Callable[[float], object] | None,
) -> tuple[PoseReader, _Readings]:
    """Read every frame of a clip once: the first ones in memory, to learn from, all others one by one."""
    with open_video(source, fps=setup.fps, seconds=setup.seconds) as video:
        frames = straight_frames(video, setup.calibration)
        reader, survey, passed = learnt(frames, setup)
        readings = _Readings(video.name, [], [], [], {name: [] for name in reader.object.methods}, video.notes)
        early = PlateView(None, "before plate and object were found")
        known = [*((frame, early) for frame in passed), *zip(survey.frames, survey.views, strict=True)]
        for frame, found in chain(known, ((frame, None) for frame in frames)):
            view, poses = reader.read(frame, found)
            readings.time.append(frame.time)
            readings.changes.append(frame.change)
            H = view.homography
            readings.views.append(np.full((3, 3), math.nan) if H is None or view.reason else H)
            readings.blurred += view.reason == BLURRED_FIDUCIALS
            for name, pose in poses.items():
                readings.poses[name].append(pose)
            if follow is not None and frame.luma.size:
                follow(frame, view, next((p for p in poses.values() if not p.reason), next(iter(poses.values()))))
            if progress is not None and video.length and frame.index % 16 == 0:
                progress(min(1.0, frame.index / video.length))
    return reader, readings


def _symmetry(tracker: ObjectTracker, method: str, notes: list[str]) -> int:
    """Turns of a full circle over this look the same; an object without markers is noted."""
    notes += tracker.notes
    if tracker.texture is None:
        return 1
    symmetry = (tracker.texture.texture if method == "texture" else tracker.texture.outline).symmetry()
    notes.append(f"no markers: followed by its {method}")
    if symmetry > 1:
        notes.append(f"the object looks the same after 1/{symmetry} of a turn")
    return symmetry


def _note_marker_size(tracker: ObjectTracker, notes: list[str]) -> None:
    """Note markers shaped like ours but of another size: the plate may not be as large as was typed."""
    if tracker.markers is None or not tracker.markers.appearance.long:
        return
    ours = np.array([math.prod(CENTRE_MARKER), math.prod(RIM_MARKER)])
    scale = np.sqrt(tracker.markers.appearance.areas / ours)
    if abs(math.log(scale[0] / scale[1])) < LIKE_OURS and abs(math.log(scale.mean())) > OTHER_SCALE:
        notes.append(
            f"the object's markers look {scale.mean():.2f} times as large as those of plategait target: " + CHECK_SIZE
        )


def _plate_swing(stamps: Stamps, views: Array, repeated: Flags, reader: PoseReader, setup: Setup) -> PlateSwing:
    """What the plate does, before the lens that is known of the camera; nothing of a plate that is not followed."""
    if isinstance(reader.plate, ScalePlate):
        return UNSEEN
    middle, focal = ((reader.picture[0] - 1) / 2, (reader.picture[1] - 1) / 2), None
    if setup.calibration is not None:
        K = scaled_matrix(setup.calibration, reader.picture[0])
        middle, focal = (float(K[0, 2]), float(K[1, 2])), float(K[0, 0] + K[1, 1]) / 2
    elif reader.plate.lens is not None:
        focal = float(reader.plate.lens[0, 0])
    fresh = np.where(repeated[:, None, None], math.nan, views)
    return plate_swing(stamps, fresh, setup.plate_size, middle, focal)


def _turning(spin: Spin, duration: float, method: str, symmetry: int) -> Spin:
    """Spin, unless the object turns too little to be told from light on it and from its bending, which do not turn."""
    least = 2 * math.pi / symmetry if method == "outline" else LEAST_TURN
    if math.isfinite(spin.rate) and abs(spin.rate) * duration < least:
        nan = math.nan
        reason = f"its {method} hardly turns, and may be that of light or of bending rather than its own"
        return Spin(nan, nan, nan, False, nan, (), reason, spin.notes)
    return spin


def _mostly(reasons: list[str]) -> str:
    """Why most frames are uncertain, where half of them or more are."""
    doubts = [r for r in reasons if r]
    if len(doubts) < len(reasons) / 2:
        return ""
    commonest = max(sorted(set(doubts)), key=doubts.count)
    return f"; most often: {commonest}"


def _better(poses: dict[str, list[Pose]]) -> str:
    """Method with the most sure frames; the first of those as good."""
    counts = {name: sum(not p.reason for p in series) for name, series in poses.items()}
    return max(counts, key=lambda name: (counts[name] > 0.9 * max(counts.values()), -list(counts).index(name)))


def _note_frequency(nominal: float | None, plate: PlateSwing, stamps: Stamps, notes: list[str]) -> bool:
    """Whether the plate's nominal frequency agrees with the observed one; note what does not, or may be otherwise."""
    seen = plate.frequency
    if not math.isfinite(seen) or (plate.sways and nominal is not None):
        return True
    if nominal is None:
        if plate.sways:
            notes.append(
                f"the plate moves in the picture at {seen:.4g} Hz without tilting, as with a camera that sways"
            )
        if plate.aliases:
            others = ", ".join(f"{f:.4g}" for f in plate.aliases)
            notes.append(f"the plate is seen at {seen:.4g} Hz; {others} Hz look the same in these frames")
        return True
    # A clip tells a frequency to a part of one swing over its length.
    near = max(0.01 * stamps.fps, 0.3, 0.3 / float(np.ptp(stamps.time)))
    if stamps.even:
        nominal_seen = apparent_frequency(nominal, stamps.fps)
        agree = abs(nominal_seen - seen) <= near
        looks = f", which would look like {nominal_seen:.4g} Hz here"
    else:
        agree, looks = any(abs(nominal - f) <= near for f in (seen, *plate.aliases)), ""
    if not agree:
        notes.append(f"the plate was said to swing at {nominal:.4g} Hz{looks}, but is seen at {seen:.4g} Hz")
    return agree
