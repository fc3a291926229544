"""Friction from a plate that is slowly tilted until the object slips and slides (section 5.6.2).

The angle at which it begins to slip is the friction angle α, and μ_s = tan α; the slide that follows tells μ_k.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np

from plategait.arrays import Array
from plategait.errors import InputError
from plategait.identify.friction.recording import LEAST_ROWS, Tilt, TiltRecording, noise_of, smooth_tilt
from plategait.identify.friction.slide import Range, SlideFit, Stretch, find_slides, fit_moving, fit_slide
from plategait.identify.series import thin
from plategait.model.fragment import Fragment
from plategait.model.measured import CONFIDENCE, Measured, as_json
from plategait.shown import Shown

_MOST_ROWS = 20_000  # in which slides are sought
_MOST_FITTED = 4_000  # of one slide
_LEAD = 2.0  # s of rest before the slide that are fitted with it
_PAUSE = 0.3  # s between a slide and the next: a bounce at the end of the plate comes sooner
_NORMAL = 1.959964  # half width of a 95 % interval, in sds
_LEAST_SLIDING_ROWS = 4
_WIDEST = 0.5  # of an interval, as a share of its value: wider is not determined
_LEAST_CREEP = 1e-4  # m
_LEAST_NOISE = 1e-6  # m: residuals below are of the arithmetic
_FAST_TILT = math.radians(10)  # per s
_STILL_TILT = math.radians(0.02)


@dataclass(frozen=True, eq=False)
class Trial:
    """What one tilt shows.

    Attributes
    ----------
    name : str
    slip_angle, static, kinetic : Measured or None
        α (rad), μ_s and μ_k; None where not determined.
    reached : float
        Largest tilt before it slipped, or of all where it never did, rad.
    time, angle, position, fitted : (m,) arrays
        Rows about the slide, downhill positive: the smoothed angle, the position, and the model (NaN without one).
    slip_time : float
        t_s, s; NaN where it is not known.
    rate : float
        How fast the plate turned then, rad/s.
    noise : float
        Sd of the positions about the model, m.
    notes : tuple of str
        What to know about it.
    """

    name: str
    slip_angle: Measured | None
    static: Measured | None
    kinetic: Measured | None
    reached: float
    time: Array
    angle: Array
    position: Array
    fitted: Array
    slip_time: float
    rate: float
    noise: float
    notes: tuple[str, ...]

    def summary(self) -> dict[str, Any]:
        """Numbers for programs, angles in deg."""
        from plategait.files.plain import plain

        return {
            "name": self.name,
            "slip_angle_deg": as_json(self.slip_angle, math.degrees(1)),
            "friction_static": as_json(self.static),
            "friction_kinetic": as_json(self.kinetic),
            "tilt_reached_deg": math.degrees(self.reached),
            "tilt_rate_deg_s": plain(math.degrees(self.rate)),
            "slip_time_s": plain(self.slip_time),
            "position_noise_mm": 1e3 * self.noise,
            "notes": list(self.notes),
        }


@dataclass(frozen=True, eq=False, repr=False)
class FrictionResult(Shown):
    """Friction of an object on a plate, from one or more tilts.

    Attributes
    ----------
    static, kinetic : Measured or None
        μ_s and μ_k, of the only trial or their means over all; None where no trial determines them.
    trials : tuple of Trial
    notes : tuple of str
        What to know about the means; each trial has its own.
    """

    static: Measured | None
    kinetic: Measured | None
    trials: tuple[Trial, ...]
    notes: tuple[str, ...]

    @property
    def slip_angle(self) -> Measured | None:
        """Friction angle α = atan μ_s, rad."""
        m = self.static
        if m is None:
            return None
        return Measured(math.atan(m.value), m.sd / (1 + m.value**2), math.atan(m.low), math.atan(m.high))

    def to_fragment(self) -> Fragment:
        """Fragment with friction.static and, where determined, friction.kinetic.

        Raises
        ------
        InputError
            When no trial determines μ_s.
        """
        if self.static is None:
            raise InputError("friction", "nothing determined", "a tilt at which the object slips", "tilting further")
        parameters = {"friction.static": self.static}
        if self.kinetic is not None:
            parameters["friction.kinetic"] = self.kinetic
        return Fragment(parameters, source=f"plategait identify friction, {', '.join(t.name for t in self.trials)}")

    def summary(self) -> dict[str, Any]:
        """Numbers for programs, angles in deg."""
        return {
            "friction_static": as_json(self.static),
            "friction_kinetic": as_json(self.kinetic),
            "slip_angle_deg": as_json(self.slip_angle, math.degrees(1)),
            "confidence": CONFIDENCE,
            "trials": [trial.summary() for trial in self.trials],
            "notes": list(self.notes),
        }


def identify_friction(recordings: Sequence[TiltRecording]) -> FrictionResult:
    """Friction from one tilt or several: the mean over those that determine it, with Student's t over their scatter.

    Parameters
    ----------
    recordings : sequence of TiltRecording
        Of the same object on the same plate.

    Raises
    ------
    InputError
        When there is none.
    """
    if not recordings:
        raise InputError("recordings", "nothing", "one tilt or more", "TILT.csv")
    trials = tuple(map(_trial, recordings))
    static, kinetic = _mean([t.static for t in trials]), _mean([t.kinetic for t in trials])
    notes = []
    slipped = sum(t.static is not None for t in trials)
    if 0 < slipped < len(trials):
        notes.append(f"{len(trials) - slipped} of {len(trials)} tilts show no slip and are left out of the mean")
    if static and kinetic and kinetic.value > static.value:
        notes.append(f"the mean mu_k came out as {kinetic.value:.3f}, above mu_s: held at it")
        kinetic = Measured(static.value, kinetic.sd, min(kinetic.low, static.value), static.value)
    return FrictionResult(static, kinetic, trials, tuple(notes))


def _mean(trials: Sequence[Measured | None]) -> Measured | None:
    """Mean of those determined, no surer than either their scatter or their own uncertainty allows."""
    values = [m for m in trials if m is not None]
    if len(values) < 2:
        return values[0] if values else None
    from scipy.special import stdtrit

    n, centres = len(values), np.array([m.value for m in values])
    own = math.sqrt(sum(m.sd**2 for m in values)) / n
    error = max(float(centres.std(ddof=1)) / math.sqrt(n), own)
    reach = float(stdtrit(n - 1, (1 + CONFIDENCE) / 2)) * error
    mean = float(centres.mean())
    return Measured(mean, reach / _NORMAL, max(0.0, mean - reach), mean + reach)


def _trial(recording: TiltRecording) -> Trial:
    """One tilt: find where it slides, orient it downhill, fit it, and say what is odd about it."""
    (time, angle, position), _ = thin(recording.time, recording.angle, recording.position, most=_MOST_ROWS)
    slides = find_slides(time, position)
    if not slides:
        return _never_slips(recording, time, angle, position)
    first = slides[0]
    turn = math.copysign(1.0, float(np.mean(angle[first.first : first.end])))
    downhill = math.copysign(1.0, float(position[first.end - 1] - position[first.first]))
    angle, position = turn * angle, downhill * position
    (t, tilted, s), block = _about(recording, time[first.first], time[first.end - 1])
    tilt, s = smooth_tilt(t, turn * tilted), downhill * s
    before = slice(0, max(first.first - 2, 0))
    crept = _crept(time[before], position[before])
    fit = _fit(time, first, tilt, s, creeps=abs(crept) > 0)
    static = _measured(fit.slip_angle, math.tan)
    kinetic, why = _kinetic(fit, t)
    notes = [f"thinned to means of {block} rows"] if block > 1 else []
    if crept:
        notes.append(f"it creeps before it slips, by {1e3 * crept:.2g} mm: the angle is that of the fast slide")
    notes += _later_slips(time, angle, position, slides) + _oddities(fit, len(t)) + why
    return Trial(
        name=recording.name,
        slip_angle=_measured(fit.slip_angle),
        static=static,
        kinetic=kinetic,
        reached=float(np.max(angle[: first.end])) if fit.slip_angle is None else fit.slip_angle.value,
        time=t,
        angle=tilt.angle,
        position=s,
        fitted=fit.fitted,
        slip_time=fit.slip_time.value if fit.slip_time else math.nan,
        rate=fit.rate,
        noise=fit.noise,
        notes=tuple(notes),
    )


def _about(recording: TiltRecording, begun: float, ended: float) -> tuple[list[Array], int]:
    """Time, angle and position of a slide with some rest before it, thinned, and the rows in a mean."""
    start, stop = map(int, np.searchsorted(recording.time, (begun - _LEAD, ended + 1e-12)))
    start = min(start, len(recording.time) - LEAST_ROWS)
    rows = slice(start, max(stop, start + LEAST_ROWS))
    return thin(recording.time[rows], recording.angle[rows], recording.position[rows], most=_MOST_FITTED)


def _fit(time: Array, slide: Stretch, tilt: Tilt, position: Array, *, creeps: bool) -> SlideFit:
    """Fit a slide, whose rows count from `time`, to the rows about it."""
    if slide.first == 0:
        return fit_moving(tilt, position)
    begun, ended = time[slide.first], time[slide.end - 1]
    reach = 3 * float(np.median(np.diff(time))) + 0.1 * (ended - begun)
    between = max(float(tilt.time[1]), begun - max(reach, _PAUSE)), float(tilt.time[-3])
    return fit_slide(tilt, position, between, creeps)


def _never_slips(recording: TiltRecording, time: Array, angle: Array, position: Array) -> Trial:
    reached = float(np.abs(recording.angle).max())
    turn = math.copysign(1.0, float(angle[np.argmax(np.abs(angle))]))
    return Trial(
        name=recording.name,
        slip_angle=None,
        static=None,
        kinetic=None,
        reached=reached,
        time=time,
        angle=turn * angle,
        position=position,
        fitted=np.full(len(time), math.nan),
        slip_time=math.nan,
        rate=math.nan,
        noise=noise_of(position),
        notes=(f"no slip up to {math.degrees(reached):.1f} deg: mu_s is at least {math.tan(reached):.3f}",),
    )


def _measured(interval: Range | None, law: Callable[[float], float] = float) -> Measured | None:
    """Value of a monotonic law of a number with its interval."""
    if interval is None or interval.value <= 0:
        return None
    value, low, high = map(law, interval)
    return Measured(value, (high - low) / (2 * _NORMAL), low, high)


def _kinetic(fit: SlideFit, time: Array) -> tuple[Measured | None, list[str]]:
    """μ_k where the slide is long enough to tell, or why not."""
    k = fit.kinetic
    slid = int(np.sum(time > fit.slip_time.value)) if fit.slip_time else len(time)
    if slid < _LEAST_SLIDING_ROWS or k.low <= 0 or k.high - k.low > _WIDEST * k.value:
        reason = f"{k.low:.2g} to {k.high:.2g}" if slid >= _LEAST_SLIDING_ROWS else "too few rows"
        return None, [f"mu_k is not determined by a slide of {slid} rows ({reason})"]
    bound = [f"mu_k came out above mu_s: held at it, {k.value:.3f}"] if fit.at_bound else []
    return _measured(k), bound


def _crept(time: Array, position: Array) -> float:
    """How far it creeps at rest, m; 0 where that may be noise."""
    if len(time) < LEAST_ROWS:
        return 0.0
    centred = time - time.mean()
    slope = float(centred @ position / (centred @ centred))
    sd, travel = noise_of(position) / math.sqrt(centred @ centred), slope * float(np.ptp(time))
    return travel if abs(slope) > 5 * sd and abs(travel) > _LEAST_CREEP else 0.0


def _later_slips(time: Array, angle: Array, position: Array, slides: list[Stretch]) -> list[str]:
    """A note of further slides downhill that begin after a rest."""
    further = [
        math.degrees(angle[this.first])
        for last, this in pairwise(slides)
        if time[this.first] - time[last.end - 1] > _PAUSE and position[this.end - 1] > position[this.first]
    ]
    if not further:
        return []
    angles = ", ".join(f"{a:.1f}" for a in further[:5]) + (", …" if len(further) > 5 else "")
    return [f"it sticks and slips again at {angles} deg: mu_s is that of the first slip, mu_k that of its slide"]


def _oddities(fit: SlideFit, rows: int) -> list[str]:
    """Notes on a fit that is not what the model says."""
    notes = []
    if fit.slip_angle is None:
        notes.append("already moving in the first row: the slip angle is not determined; start recording earlier")
    elif fit.slip_angle.value <= 0:
        notes.append("it slips on a plate that is level: the slip angle is not determined")
    if fit.slip_angle and abs(fit.rate) < _STILL_TILT:
        notes.append("the plate hardly turned when it slipped: it crept or was pushed")
    if abs(fit.rate) > _FAST_TILT:
        notes.append(f"the plate turned at {math.degrees(fit.rate):.0f} deg/s: too fast to be taken for still")
    if fit.noise > _LEAST_NOISE and fit.structure > max(0.3, 4 / math.sqrt(rows)):
        notes.append("the positions do not follow one mu_k: intervals are too narrow")
    return notes
