"""What may vary in a motion: each variable with its range, and motions of them that the machine can make."""

from __future__ import annotations

import difflib
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from plategait.arrays import Array, Flags
from plategait.errors import InputError
from plategait.files.ranges import parse_range
from plategait.model.machine import Machine
from plategait.model.motion import AXES, Held, PlateMotion, Wave
from plategait.optimize.within import fitted
from plategait.units import ANGLE, FREQUENCY, PLATE_ANGLE, PLATE_STROKE, STROKE, Quantity, show

Freedom = Literal["phase", "ratio", "harmonics", "offset", "y", "z", "ry", "rz"]
FREEDOMS: tuple[Freedom, ...] = ("phase", "ratio", "harmonics", "offset", "y", "z", "ry", "rz")
"""What may vary beside the frequency and the two amplitudes, where asked for.

phase
    By which the shaking along the bar is ahead of the rocking about it.
ratio
    Frequency of the shaking over that of the rocking, one of `RATIOS`.
harmonics
    Second harmonics of both, as sine and cosine.
offset
    Angle about the bar at which the plate is held.
y, z, ry, rz
    A sine on that degree of freedom at the frequency of the rocking, as sine and cosine.
"""
RATIOS = (1 / 3, 1 / 2, 2 / 3, 1.0, 3 / 2, 2.0, 3.0)
"""Frequency ratios that are tried: the motion repeats after a few periods."""
PLAIN: Mapping[str, Quantity] = {"frequency": FREQUENCY, "angle": PLATE_ANGLE, "stroke": PLATE_STROKE}
"""What always may vary."""

REST = 0.3
"""Share of an amplitude's range that stands for none, where the plate may do without it."""

_RATIO = Quantity("", "", "1", above=0)
# The slowest plate, and the least amplitudes, over the most that the machine can: far below where anything spins.
_SLOWEST, _LEAST = 1 / 8, 1 / 30
# An offset that is tried where the machine sets no limit and the plate does not rock, rad.
_HELD = math.radians(12)


@dataclass(frozen=True)
class Variable:
    """One number that may vary.

    Attributes
    ----------
    name : str
    quantity : Quantity
    low, high : float
        Its range, SI.
    log : bool
        Whether it is searched in its logarithm: in logarithms the ridge of section 4.4 (A_p ω_p² the same) and the
        limits of speed, acceleration and jerk are straight lines.
    steps : tuple of float
        The only values that it takes, where there are such.
    neutral : float, optional
        Value at which it changes nothing.
    freedom : str
        Which freedom it belongs to; none for what always varies.
    rest : float
        Share of the range below which it is 0: an amplitude that may be none at all, which no logarithm reaches.
    """

    name: str
    quantity: Quantity
    low: float
    high: float
    log: bool = False
    steps: tuple[float, ...] = ()
    neutral: float | None = None
    freedom: str = ""
    rest: float = 0.0

    def at(self, share: float) -> float:
        """Value at a share of the range, 0 to 1."""
        if share < self.rest:
            return 0.0
        share = (share - self.rest) / (1 - self.rest)
        if self.steps:
            return self.steps[min(int(share * len(self.steps)), len(self.steps) - 1)]
        if self.log:
            return self.low * (self.high / self.low) ** share
        return self.low + share * (self.high - self.low)

    def share_of(self, value: float) -> float:
        """Share of the range at which a value lies."""
        if self.rest and value == 0:
            return self.rest / 2
        if self.steps:
            return (self.steps.index(value) + 0.5) / len(self.steps)
        if self.log:
            share = math.log(value / self.low) / math.log(self.high / self.low)
        else:
            share = (value - self.low) / (self.high - self.low)
        return self.rest + (1 - self.rest) * share


@dataclass(frozen=True, eq=False)
class Space:
    """Motions to choose from.

    Attributes
    ----------
    variables : tuple of Variable
    fixed : mapping of str to float
        Frequency and amplitudes that do not vary, SI.
    base : PlateMotion
        What everything else is taken from: height, smooth start, further sines.
    machine : Machine
        Every motion is within its limits.
    """

    variables: tuple[Variable, ...]
    fixed: Mapping[str, float]
    base: PlateMotion
    machine: Machine

    def values(self, shares: Array) -> dict[str, float]:
        """Values of all variables, by name, at shares (d,) of their ranges."""
        free = {v.name: v.at(float(share)) for v, share in zip(self.variables, shares, strict=True)}
        return {**self.fixed, **free}

    def motion(self, values: Mapping[str, float]) -> PlateMotion:
        """Motion of values by name, made smaller and slower as far as the machine asks for it."""
        return fitted(self._built(values), self.machine)

    def at(self, shares: Array) -> PlateMotion:
        """Motion at shares (d,) of the ranges."""
        return self.motion(self.values(shares))

    @property
    def neutral(self) -> Array:
        """(d,) shares at which the freedoms change nothing; NaN for what always varies."""
        return np.array([math.nan if v.neutral is None else v.share_of(v.neutral) for v in self.variables])

    @property
    def stages(self) -> list[Flags]:
        """(d,) variables that vary with all freedoms at rest, and with one more freedom in turn; the last time all."""
        freedoms = np.array([variable.freedom for variable in self.variables])
        names = dict.fromkeys(filter(None, freedoms.tolist()))
        varies, stages = freedoms == "", [freedoms == ""]
        if not varies.any():
            return [~varies]
        for name in names:
            varies = varies | (freedoms == name)
            stages.append(varies)
        return stages

    def _built(self, values: Mapping[str, float]) -> PlateMotion:
        frequency, waves = values["frequency"], list(self.base.waves)
        ratio = values.get("ratio", 1.0)
        angle, stroke = values["angle"] * values.get("sense", 1.0), values["stroke"]
        if "phase" in values or "ratio" in values:
            waves += _sine("x", stroke, ratio, values.get("phase", 0.0))
            stroke = 0.0
        fastest = self.machine.frequency or math.inf
        for axis, own in (("x", 2 * ratio), ("rx", 2.0)):
            # A harmonic that the machine is too slow for is left out: slower motions may have it.
            if f"{axis} sine" in values and own * frequency <= fastest:
                waves += _sine_and_cosine(axis, own, values)
        for axis in ("y", "z", "ry", "rz"):
            if f"{axis} sine" in values:
                waves += _sine_and_cosine(axis, 1.0, values)
        offset = self.base.offset
        if "offset" in values:
            offset = Held(**{axis: getattr(offset, axis) for axis in AXES} | {"rx": values["offset"]})
        return self.base.replace(
            frequency=frequency, angle=angle, stroke=stroke, offset=offset, waves=tuple(waves), samples=None
        )


def _sine(axis: str, amplitude: float, ratio: float, phase: float) -> list[Wave]:
    return [Wave(axis=axis, amplitude=amplitude, ratio=ratio, phase=phase)] if amplitude else []  # type: ignore[arg-type]


def _sine_and_cosine(axis: str, ratio: float, values: Mapping[str, float]) -> list[Wave]:
    sine, cosine = values[f"{axis} sine"], values[f"{axis} cosine"]
    return _sine(axis, math.hypot(sine, cosine), ratio, math.atan2(cosine, sine))


def space_of(
    base: PlateMotion,
    machine: Machine,
    ranges: Mapping[str, tuple[float, float] | str],
    free: Sequence[Freedom] = (),
    *,
    both_ways: bool = False,
    may_rest: bool = False,
) -> Space:
    """Motions to choose from.

    Parameters
    ----------
    base : PlateMotion
    machine : Machine
    ranges : mapping of str to (low, high)
        Of "frequency", "angle" and "stroke", SI or text ("10:30 Hz"); alike where it is not to vary. All that
        the machine can by default.
    free : sequence of str
        Further freedoms (`FREEDOMS`).
    both_ways : bool
        Whether the rocking may be mirrored, which mirrors the spin.
    may_rest : bool
        Whether the plate may do without rocking or without shaking, where no range is told: what only shakes turns
        nothing, whatever else varies.

    Raises
    ------
    InputError
        For a range that is none or beyond the machine, a freedom that the machine has not, nothing that varies.
    """
    if base.samples is not None:
        raise InputError("scenario", "a sampled trajectory", "one of sines, which can vary", "cheese")
    for name in ranges:
        if name not in PLAIN:
            close = difflib.get_close_matches(name, PLAIN, 1) or ["frequency"]
            raise InputError(name, "nothing known by that name", f"one of {', '.join(PLAIN)}", close[0])
    variables, fixed = [], {}
    for name, quantity in PLAIN.items():
        low, high = _range(name, quantity, machine, ranges)
        if low == high:
            fixed[name] = low
        else:
            rest = REST if may_rest and name != "frequency" and name not in ranges else 0.0
            variables.append(Variable(name, quantity, low, high, log=low > 0, rest=rest))
    if not variables and not free:
        raise InputError("frequency", "nothing that may vary, with frequency, angle and stroke given as one value each",
                         "a range for one of them, or --free", '--frequency "10:30 Hz"')  # fmt: skip
    reach = {v.name: v.high for v in variables} | fixed
    if both_ways and reach["angle"] > 0:
        variables.append(Variable("sense", _RATIO, -1.0, 1.0, steps=(-1.0, 1.0)))
    for freedom in dict.fromkeys(free):
        variables += [replace(variable, freedom=freedom) for variable in _freed(freedom, machine, reach)]
    return Space(tuple(variables), fixed, base, machine)


def freedoms_of(machine: Machine) -> tuple[Freedom, ...]:
    """What may vary on a machine beside frequency and amplitudes, degrees of freedom among it."""
    moves = dict(zip(("x", "y", "z", "rx", "ry", "rz"), machine.limits[0] > 0, strict=True))
    free: list[Freedom] = []
    if moves["x"] and moves["rx"]:
        free.append("phase")
    if moves["x"] or moves["rx"]:
        free.append("harmonics")
    if moves["rx"]:
        free.append("offset")
    further: tuple[Freedom, ...] = ("y", "z", "ry", "rz")
    return (*free, *(axis for axis in further if moves[axis]))


def _range(
    name: str, quantity: Quantity, machine: Machine, ranges: Mapping[str, tuple[float, float] | str]
) -> tuple[float, float]:
    """Range of what always varies, within what the machine can."""
    axis = {"angle": "rx", "stroke": "x"}.get(name)
    limit = (machine.frequency or math.inf) if axis is None else float(machine.limits[0, AXES.index(axis)])

    def said(value: float) -> str:
        return show(value, quantity.unit, quantity.display)

    if name not in ranges:
        if math.isinf(limit):
            raise InputError(name, "nothing", f"given as a range, as {machine.name} has no limit of it",
                             f'--{name} "{quantity.example}"')  # fmt: skip
        return limit * (_SLOWEST if axis is None else _LEAST), limit
    low, high = _told(ranges[name], quantity, name)
    if not (low <= high and math.isfinite(high) and low >= 0 and (low > 0 or axis is not None)):
        turned = f"{said(high).split()[0]}:{said(low)}" if 0 < high < low else quantity.example
        raise InputError(name, f"{said(low)} to {said(high)}", "from a least to a most, neither below 0",
                         f'--{name} "{turned}"')  # fmt: skip
    if high > limit * (1 + 1e-9):
        what = (
            f"at most {said(limit)}, which {machine.name} can"
            if limit > 0
            else f"0, as {machine.name} does not move {axis}"
        )
        raise InputError(name, said(high), what, f'--{name} "{said(limit)}"')
    return low, high


def _told(told: object, quantity: Quantity, name: str) -> tuple[float, float]:
    """Ends of a range as it was told, SI: two numbers, or text."""
    if isinstance(told, str):
        return parse_range(told, quantity, name)
    if not isinstance(told, Sequence) or len(told) != 2:
        raise InputError(name, told, "a least and a most", f'("{quantity.example}", "{quantity.example}")')
    low, high = (quantity.read(end, name) for end in told)
    return low, high


def _freed(freedom: str, machine: Machine, reach: Mapping[str, float]) -> list[Variable]:
    """Variables of one freedom."""
    if freedom not in FREEDOMS:
        raise InputError("free", freedom, f"one of {', '.join(FREEDOMS)}", "phase")
    rocks, shakes = reach["angle"] > 0, reach["stroke"] > 0
    if freedom in ("phase", "ratio") and not (rocks and shakes):
        raise InputError("free", freedom, "left out where the plate does not both shake and rock", "a range for both")
    if freedom == "phase":
        return [Variable("phase", ANGLE, -math.pi / 2, math.pi / 2, neutral=0.0)]
    if freedom == "ratio":
        return [Variable("ratio", _RATIO, RATIOS[0], RATIOS[-1], steps=RATIOS, neutral=1.0)]
    if freedom == "harmonics":
        return [v for axis, name, moves in (("x", "stroke", shakes), ("rx", "angle", rocks)) if moves
                for v in _pair(axis, reach[name] / 2)]  # fmt: skip
    axis = "rx" if freedom == "offset" else freedom
    limit = float(machine.limits[0, AXES.index(axis)])
    if limit == 0:
        what = "hold the plate off level" if freedom == "offset" else f"move {axis}"
        raise InputError("free", freedom, f"left out, as {machine.name} cannot {what}",
                         f"a machine with a limit for {axis}, or --free phase")  # fmt: skip
    if freedom == "offset":
        held = limit / 2 if math.isfinite(limit) else max(reach["angle"], _HELD)
        return [Variable("offset", ANGLE, -held, held, neutral=0.0)]
    return _pair(axis, limit if math.isfinite(limit) else reach["angle" if axis.startswith("r") else "stroke"])


def _pair(axis: str, most: float) -> list[Variable]:
    quantity = ANGLE if axis.startswith("r") else STROKE
    return [Variable(f"{axis} {part}", quantity, -most, most, neutral=0.0) for part in ("sine", "cosine")]
