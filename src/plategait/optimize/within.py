"""The nearest motion of a kind that a machine can make: its sines made smaller, and all of it slower."""

from __future__ import annotations

import math

import numpy as np

from plategait.arrays import Array
from plategait.model.machine import Machine
from plategait.model.motion import AXES, Held, PlateMotion
from plategait.model.needs import needs

# What is left of a limit, so that rounding keeps within it.
_ROOM = 1 - 1e-9


def fitted(motion: PlateMotion, machine: Machine) -> PlateMotion:
    """Motion of sines within a machine's limits, the smooth start included.

    The frequency comes down to the fastest that the machine's fastest sine allows; then the sines of each degree of
    freedom shrink together until all limits are kept, which needs no search: position, speed, acceleration, jerk and
    load are proportional to them, and power to their squares. The offset stays, and takes its part of the reach.
    """
    fastest = 1 / motion.shortest_period if motion.terms() else 0.0
    if machine.frequency is not None and fastest > machine.frequency:
        motion = motion.replace(frequency=motion.frequency * machine.frequency / fastest * _ROOM)
    needed = needs(motion.replace(offset=Held()), machine)
    room = machine.limits.copy()
    room[0] = np.maximum(room[0] - np.abs(motion.offset.pose), 0.0)
    with np.errstate(divide="ignore", invalid="ignore"):
        # No motion needs nothing; a load that is not told has no limit.
        shares = np.where(needed.peaks > 0, room / needed.peaks, math.inf)
    share = np.minimum(np.min(shares, axis=0), 1.0)
    if machine.power is not None:
        shrunk = needs(_scaled(motion, share), machine)
        if shrunk.power > machine.power:
            share = share * math.sqrt(machine.power / shrunk.power)
    return motion if (share == 1).all() else _scaled(motion, share)


def _scaled(motion: PlateMotion, share: Array) -> PlateMotion:
    """Motion with the sines of each degree of freedom at a share (6,) of themselves."""
    share = np.where(share < 1, share * _ROOM, 1.0)
    waves = tuple(
        wave.replace(amplitude=float(wave.amplitude * share[AXES.index(wave.axis)]))
        for wave in motion.waves
        if share[AXES.index(wave.axis)] > 0
    )
    x, rx = float(share[AXES.index("x")]), float(share[AXES.index("rx")])
    return motion.replace(angle=motion.angle * rx, stroke=motion.stroke * x, waves=waves)
