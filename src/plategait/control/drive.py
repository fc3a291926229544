"""What the motors can do next, as numbers from -1 to 1, and the plate motions that they stand for."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from plategait.arrays import Array
from plategait.errors import InputError
from plategait.model.base import Kept, Model
from plategait.model.machine import Machine, machine_of
from plategait.model.motion import AXES, Held, PlateMotion, Wave
from plategait.units import ANGLE, FREQUENCY, PLATE_ANGLE, PLATE_STROKE, STROKE, Quantity

# Amplitudes below this share of the largest are none: so the plate can be told to stand.
DEAD = 0.05
# The slowest plate over the fastest, as where motions are searched (`plategait.optimize.space`).
_SLOWEST = 1 / 8
# Where the plate may be held where the machine sets no limit, rad.
_HELD = math.radians(12)
# What is left of a limit, so that rounding keeps within it.
_ROOM = 1 - 1e-9
# Distance from an axis at which the acceleration of a plate that turns about it counts, m.
EDGE = 0.05
_ACCELERATION = Quantity("m/s^2", "m/s^2", "80 m/s^2", above=0)
_RAMP = Quantity("s", "s", "0.05 s", above=0, at_most=10)
_set = object.__setattr__
_FIELDS: dict[type[Model], set[str]] = {model: set(model.model_fields) for model in (PlateMotion, Held, Wave)}
_X, _RX = AXES.index("x"), AXES.index("rx")


@dataclass(frozen=True)
class Freedom:
    """One number of an action.

    Attributes
    ----------
    name : str
    quantity : Quantity
        What it stands for.
    low, high : float
        What -1 and 1 stand for, SI; of an amplitude where nothing but the position limits it.
    log : bool
        Whether what is between goes by ratios.
    """

    name: str
    quantity: Quantity
    low: float
    high: float
    log: bool = False


class Drive:
    """Actions in [-1, 1]^d, and the plate motions that they stand for: sines of one frequency, and an offset.

    Of a machine that shakes along the bar and rocks about it: ``frequency`` by ratios; ``angle``, the amplitude of the
    rocking, with its sign; ``stroke``, the amplitude of the shaking; ``phase``, by which the shaking is ahead; and
    ``offset``, the angle about the bar at which the plate is held. Of further degrees of freedom a sine and a cosine
    each, such as ``y sine`` and ``y cosine``. An amplitude is a share of the largest that the machine can make at that
    frequency and offset, so that every action is within its limits; below `DEAD` it is 0.

    Parameters
    ----------
    machine : Machine, name of one, or its file
    base : PlateMotion, optional
        What is not free is taken from, amplitudes as far as the machine can: by default a plate that stands level. No
        further sines, no samples.
    free : sequence of str, optional
        Names of the numbers that an action has, of `names`; all that the machine has by default.
    ramp : float or str
        In which one motion is gone over to the next, s: one that changes within 15 ms throws a sheet over.
    acceleration : float or str, optional
        The most that sines may give the middle of the plate, and its surface `EDGE` off the axis it turns about, m/s²:
        a gentler machine, of which more actions leave the sheet on the plate.

    Raises
    ------
    InputError
        For a machine that sets no limit to what it moves, a freedom that it has not, a base of other sines.
    """

    def __init__(
        self,
        machine: Machine | Path | str = "source-robot",
        base: PlateMotion | None = None,
        *,
        free: Sequence[str] | None = None,
        ramp: float | str = "0.05 s",
        acceleration: float | str | None = None,
    ) -> None:
        self.machine, base = machine_of(machine), base or PlateMotion(angle=0.0, stroke=0.0)
        if base.samples is not None or base.waves:
            raise InputError("base", "further sines or samples", "a motion of frequency, angle and stroke", "cheese")
        self.base: PlateMotion = base.with_valid(ramp=_RAMP.read(ramp, "ramp"))
        most = math.inf if acceleration is None else _ACCELERATION.read(acceleration, "acceleration")
        self._gentle = np.where([axis.startswith("r") for axis in AXES], most / EDGE, most)[:, None]
        every = {freedom.name: freedom for freedom in _freedoms_of(self.machine)}
        for name in free or ():
            if name not in every:
                raise InputError("free", name, f"one of {', '.join(every)}, which {self.machine.name} has",
                                 next(iter(every)))  # fmt: skip
        self.freedoms = tuple(f for name, f in every.items() if free is None or name in free)
        # Axes of sine and cosine, in the order of the actions.
        self._pairs = [a for a in ("y", "z", "ry", "rz") if f"{a} sine" in self.names or f"{a} cosine" in self.names]

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the numbers of an action."""
        return tuple(freedom.name for freedom in self.freedoms)

    def __len__(self) -> int:
        """Return how many numbers an action has."""
        return len(self.freedoms)

    def motions(self, actions: Array, heights: Sequence[float] | None = None) -> list[PlateMotion]:
        """Motions of actions; numbers beyond ±1 count as ±1.

        Parameters
        ----------
        actions : (n, d) array
        heights : sequence of float, optional
            Of each plate's surface above the axis that it turns about, m; the base's by default.

        Raises
        ------
        InputError
            For another number of numbers, or one that is not finite.
        """
        values = self.values(actions)
        ramp, heights = self.base.ramp, [self.base.height] * len(actions) if heights is None else heights
        columns = {name: column.tolist() for name, column in values.items()}
        pairs = [(axis, AXES.index(axis), columns[axis], columns[f"{axis} phase"]) for axis in self._pairs]
        held, (x, y, z, _, ry, rz) = self.base.offset, self.base.offset.pose
        tilts, bounds = "offset" in self.names, self._bounds(values)
        made = []
        for i, (frequency, angle, stroke, phase, tilt) in enumerate(
            zip(*(columns[name] for name in ("frequency", "angle", "stroke", "phase", "offset")), strict=True)
        ):
            # What a motion works out of its fields is told with them: it is asked of every one, and known here.
            waves, terms, period = [], [], 1 / frequency
            if stroke and phase:
                waves.append(_made(Wave, {"axis": "x", "amplitude": stroke, "ratio": 1.0, "phase": phase}, {}))
                terms.append((_X, stroke, frequency, phase / (2 * math.pi)))
                stroke = 0.0
            elif stroke:
                terms.append((_X, stroke, frequency, 0.0))
            if angle:
                terms.insert(0 if waves else len(terms), (_RX, -angle, frequency, 0.0))
            for axis, d, amplitudes, phases in pairs:
                if amplitude := amplitudes[i]:
                    wave = {"axis": axis, "amplitude": amplitude, "ratio": 1.0, "phase": phases[i]}
                    waves.append(_made(Wave, wave, {}))
                    terms.append((d, amplitude, frequency, phases[i] / (2 * math.pi)))
            if tilts:
                fields = {"x": x, "y": y, "z": z, "rx": tilt, "ry": ry, "rz": rz}
                held = _made(Held, fields, {"pose": (x, y, z, tilt, ry, rz)})
            fields = {
                "frequency": frequency, "angle": angle, "stroke": stroke, "height": heights[i], "ramp": ramp,
                "offset": held, "waves": tuple(waves), "samples": None,
            }  # fmt: skip
            made.append(_made(PlateMotion, fields, {
                "_terms": tuple(terms), "shortest_period": period if terms else math.inf, "period": period,
                "_most": Kept(bounds[i]),
            }))  # fmt: skip
        return made

    def _bounds(self, values: dict[str, Array]) -> Array:
        """(n, 4, 6) position, speed, acceleration and jerk that motions never exceed, as of `PlateMotion.most`."""
        omega = 2 * math.pi * values["frequency"]
        bounds = np.zeros((len(omega), 4, len(AXES)))
        for name, d in (("stroke", _X), ("angle", _RX), *((axis, AXES.index(axis)) for axis in self._pairs)):
            reached = np.abs(values[name])
            for k in range(4):
                bounds[:, k, d] = reached
                reached = reached * omega
        bounds[:, 0] += np.abs(self.base.offset.pose)
        bounds[:, 0, _RX] += np.abs(values["offset"]) - abs(self.base.offset.rx)
        return bounds

    def values(self, actions: Array) -> dict[str, Array]:
        """What actions stand for, SI: (n,) frequency, angle, stroke, phase, offset; amplitude and phase of other axes.

        Raises
        ------
        InputError
            As of `motions`.
        """
        given = np.asarray(actions, dtype=float)
        if given.ndim != 2 or given.shape[1] != len(self) or not np.isfinite(given).all():
            raise InputError("actions", f"an array of shape {given.shape}", f"(n, {len(self)}) finite numbers: "
                             f"{', '.join(self.names)}", f"np.zeros((1, {len(self)}))")  # fmt: skip
        action = dict(zip(self.names, np.clip(given, -1.0, 1.0).T, strict=True))
        base, every = self.base, np.ones(len(given))

        def of(name: str, otherwise: float) -> Array:
            freedom = next((f for f in self.freedoms if f.name == name), None)
            if freedom is None:
                return otherwise * every
            share = (action[name] + 1) / 2
            if freedom.log:
                return freedom.low * (freedom.high / freedom.low) ** share
            return freedom.low + share * (freedom.high - freedom.low)

        values = {"frequency": of("frequency", base.frequency), "phase": of("phase", 0.0)}
        values["offset"] = of("offset", base.offset.rx)
        most = self._most(values["frequency"], values["offset"])
        values["angle"] = np.clip(base.angle * every, -most[_RX], most[_RX])
        values["stroke"] = np.clip(base.stroke * every, -most[_X], most[_X])
        if "angle" in action:
            values["angle"] = np.sign(action["angle"]) * _lively(np.abs(action["angle"])) * most[_RX]
        if "stroke" in action:
            values["stroke"] = _lively((action["stroke"] + 1) / 2) * most[_X]
        for axis in self._pairs:
            sine, cosine = action.get(f"{axis} sine", 0 * every), action.get(f"{axis} cosine", 0 * every)
            share = np.minimum(np.hypot(sine, cosine), 1.0)
            values[axis], values[f"{axis} phase"] = _lively(share) * most[AXES.index(axis)], np.arctan2(cosine, sine)
        return self._powered(values)

    def _most(self, frequency: Array, offset: Array) -> Array:
        """(6, n) largest amplitude of one sine on each axis, m and rad, about where the plate is held."""
        omega = 2 * math.pi * frequency
        held = np.abs(np.array(self.base.offset.pose))[:, None] * np.ones_like(omega)
        held[_RX] = np.abs(offset)
        limits, loads = self.machine.limits[:, :, None], self.machine.inertial_loads[:, None]
        with np.errstate(invalid="ignore"):
            by_load = np.where(np.isfinite(limits[4]), limits[4] / loads, np.inf) / omega**2
        most = np.minimum(np.maximum(limits[0] - held, 0.0), np.minimum(by_load, self._gentle / omega**2))
        for k in (1, 2, 3):
            most = np.minimum(most, limits[k] / omega**k)
        return np.minimum(most * _ROOM, _largest()[:, None])

    def _powered(self, values: dict[str, Array]) -> dict[str, Array]:
        """Amplitudes made smaller together as far as the drives' power asks for it: it goes by their squares."""
        if self.machine.power is None:
            return values
        axes = {"stroke": _X, "angle": _RX} | {axis: AXES.index(axis) for axis in self._pairs}
        # What one drive gives is at most load A² ω³/2; that of all together no more than the sum.
        power = sum(self.machine.inertial_loads[d] * values[name] ** 2 for name, d in axes.items())
        power = power * (2 * math.pi * values["frequency"]) ** 3 / 2
        share = np.sqrt(np.minimum(self.machine.power * _ROOM / np.maximum(power, 1e-300), 1.0))
        return values | {name: values[name] * share for name in axes}

    def action(self, motion: PlateMotion) -> Array:
        """(d,) action that stands for a motion, up to when its sines begin.

        Raises
        ------
        InputError
            For a motion that no action stands for: of other sines, or beyond the machine.
        """
        amplitude, phase = self._sines(motion)
        # Half a period later all sines have the other sign: the phase that counts is within a quarter turn.
        side = 1.0
        if amplitude["x"] < 0 or not -math.pi / 2 <= phase <= math.pi / 2:
            side = -1.0 if (amplitude["x"] < 0) != (abs(phase) > math.pi / 2) else 1.0
            phase = math.remainder(phase, math.pi)
        most = self._most(np.array([motion.frequency]), np.array([motion.offset.rx]))[:, 0]
        values: dict[str, float] = {"frequency": motion.frequency, "phase": phase, "offset": motion.offset.rx}
        action = []
        for freedom in self.freedoms:
            axis, _, part = freedom.name.partition(" ")
            if freedom.name == "angle":
                action.append(_share(side * motion.angle, most[_RX]))
            elif freedom.name == "stroke":
                action.append(2 * _share(abs(amplitude["x"]), most[_X]) - 1)
            elif part:
                size = math.hypot(amplitude[f"{axis} sine"], amplitude[f"{axis} cosine"])
                own = side * amplitude[freedom.name] / size if size else 0.0
                action.append(own * _share(size, most[AXES.index(axis)]))
            else:
                value, low, high = values[freedom.name], freedom.low, freedom.high
                action.append(2 * (math.log(value / low) / math.log(high / low) if freedom.log
                                   else (value - low) / (high - low)) - 1)  # fmt: skip
        given = np.array(action)
        if not (np.abs(given) <= 1 + 1e-6).all():
            name = self.names[int(np.argmax(np.abs(given)))]
            raise InputError("motion", f"a {name} out of range", f"within what {self.machine.name} can make", "smaller")
        return np.clip(given, -1.0, 1.0)

    def _sines(self, motion: PlateMotion) -> tuple[dict[str, float], float]:
        """Amplitudes of a motion's sines, along the bar and as sine and cosine elsewhere, and the first one's phase."""
        amplitude = {"x": motion.stroke} | {f"{a} {part}": 0.0 for a in self._pairs for part in ("sine", "cosine")}
        phase = 0.0
        for wave in motion.waves:
            if wave.ratio == 1 and wave.axis == "x" and amplitude["x"] == 0:
                amplitude["x"], phase = wave.amplitude, math.remainder(wave.phase, 2 * math.pi)
            elif wave.ratio == 1 and wave.axis in self._pairs:
                amplitude[f"{wave.axis} sine"] += wave.amplitude * math.cos(wave.phase)
                amplitude[f"{wave.axis} cosine"] += wave.amplitude * math.sin(wave.phase)
            else:
                raise InputError("motion.waves", f"a sine on {wave.axis} at {wave.ratio:g} times the frequency",
                                 "one sine on each axis, all of one frequency", "a motion of this drive")  # fmt: skip
        if motion.samples is not None:
            raise InputError("motion.samples", "a sampled trajectory", "left out", "a motion of this drive")
        return amplitude, phase

    @property
    def rest(self) -> Array:
        """(d,) action of a plate that stands level, or as its base holds it."""
        return self.action(self.base.with_valid(angle=0.0, stroke=0.0))


def _made(model: type[Model], fields: dict[str, Any], worked_out: dict[str, Any]) -> Any:
    """Model of fields that are known to be valid, as `Model.with_valid` but sooner, with what it works out of them."""
    made = model.__new__(model)
    _set(made, "__pydantic_fields_set__", _FIELDS[model])
    _set(made, "__pydantic_extra__", None)
    _set(made, "__pydantic_private__", None)
    _set(made, "__dict__", {**fields, **worked_out})
    return made


def _lively(share: Array) -> Array:
    """Amplitude from 0 to 1 of a share from 0 to 1: none below `DEAD`."""
    return np.maximum(share - DEAD, 0.0) / (1 - DEAD)


def _share(amplitude: float, most: float) -> float:
    """Share that stands for an amplitude, with its sign."""
    if amplitude == 0:
        return 0.0
    return math.copysign(DEAD + (1 - DEAD) * abs(amplitude) / most, amplitude) if most else math.inf


def _largest() -> Array:
    """(6,) amplitudes beyond which no plate is described, m and rad."""
    return np.array([PLATE_ANGLE.at_most if axis.startswith("r") else PLATE_STROKE.at_most for axis in AXES])


def _freedoms_of(machine: Machine) -> list[Freedom]:
    """What a machine's drives can do next."""
    if machine.frequency is None:
        raise InputError("machine", f"{machine.name} without a limit of its frequency", "one that says how fast it is",
                         'frequency = "40 Hz"')  # fmt: skip
    freedoms = [Freedom("frequency", FREQUENCY, machine.frequency * _SLOWEST, machine.frequency, log=True)]
    slowest = 2 * math.pi * machine.frequency * _SLOWEST
    reach = {}
    for d, axis in enumerate(AXES):
        limits = machine.limits[:, d]
        # The largest amplitude at the slowest sine, where anything limits it.
        bounds = [limits[k] / slowest**k for k in range(4)]
        bounds += [limits[4] / machine.inertial_loads[d] / slowest**2] if np.isfinite(limits[4]) else []
        if getattr(machine, axis) is None:
            continue
        if not np.isfinite(min(bounds)):
            raise InputError("machine", f"{machine.name} without a limit on {axis}", "one that says how far it goes",
                             f'{axis} = {{ {"angle" if axis.startswith("r") else "stroke"} = … }}')  # fmt: skip
        reach[axis] = min(float(min(bounds)), float(_largest()[d]))
    if "rx" in reach:
        freedoms.append(Freedom("angle", PLATE_ANGLE, -reach["rx"], reach["rx"]))
    if "x" in reach:
        freedoms.append(Freedom("stroke", PLATE_STROKE, 0.0, reach["x"]))
    if "x" in reach and "rx" in reach:
        freedoms.append(Freedom("phase", ANGLE, -math.pi / 2, math.pi / 2))
    if "rx" in reach:
        limit = float(machine.limits[0, _RX])
        held = min(limit / 2 if math.isfinite(limit) else _HELD, float(_largest()[_RX]))
        freedoms.append(Freedom("offset", ANGLE, -held, held))
    for axis in ("y", "z", "ry", "rz"):
        if axis in reach:
            quantity = ANGLE if axis.startswith("r") else STROKE
            freedoms += [Freedom(f"{axis} {part}", quantity, -reach[axis], reach[axis]) for part in ("sine", "cosine")]
    return freedoms
