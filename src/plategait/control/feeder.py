"""A feeder's work on a plate: sheets spun until their class is told, and sent off the plate to one of four sides."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from plategait.arrays import Array, Flags
from plategait.control.camera import Seen
from plategait.control.menu import Menu, displaced
from plategait.control.plant import Plant
from plategait.control.sorter import Sorter, Verdict
from plategait.control.spinning import PAUSE, SPUN, Spins

SIDES = ("+x", "-x", "+y", "-y")
"""Sides of the plate: along the bar, against it, and across it."""
_OUTWARD = np.array([[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]])
# What being aside of the middle of the side counts beside a way outwards, and what is unsure of it.
_ASIDE, _UNSURE = 0.5, 0.5
# Of the farthest way outwards, what is gone at least: who minds the middle alone gets nowhere.
_LEAST_OUT = 0.5
# Ticks of a pulse that carries a sheet outwards: beyond where responses were measured it is looked at again soon.
_PULSE = 20
# How far from where it was told a pulse may carry a sheet, m, to be made again.
_WRONG = 15e-3


def spin(plant: Plant, sorter: Sorter, sure: float | None = None) -> tuple[list[Verdict], Array]:
    """Spin sheets that rest under one motion after the other, and judge each.

    Parameters
    ----------
    plant : Plant
    sorter : Sorter
    sure : float, optional
        Probability of a class from which a sheet is spun no more; it is spun under all motions by default.

    Returns
    -------
    list of Verdict
        Of each sheet.
    (n,) array
        For how long each was spun, s, until it rested.
    """
    n, motions = len(plant), sorter.plate_motions
    spins, times, spun = Spins.none(n, len(motions)), np.zeros(n), ~plant.failed
    verdicts = [sorter.judge(*(x[i] for x in (spins.rates, spins.sd, spins.places))) for i in range(n)]
    for c, motion in enumerate(motions):
        spins.read(c, plant, motion, spun)
        times[spun] += SPUN
        for i in np.flatnonzero(spun):
            verdicts[i] = sorter.judge(spins.rates[i], spins.sd[i], spins.places[i])
            spun[i] = not plant.failed[i] and (sure is None or verdicts[i].kind(sure) is None)
        if not spun.any():
            break
    for _ in range(PAUSE):
        plant.step(motions[0].replace(angle=0.0, stroke=0.0))
    return verdicts, times + PAUSE * plant.tick


def send_off(
    plant: Plant, sides: Sequence[int | None], menu: Menu, timeout: float = 15.0
) -> tuple[list[int | None], Array]:
    """Send sheets that rest off their plates, by pulses that carry them outwards.

    Parameters
    ----------
    plant : Plant
    sides : sequence of int or None
        Which of `SIDES` each is to leave by; None for one that is left alone.
    menu : Menu
    timeout : float
        Time after which those that are still there are given up, s.

    Returns
    -------
    list of int or None
        Sides by which they left.
    (n,) array
        Times that it took, s.
    """
    n, still = len(plant), menu.motions[0]
    half = np.array([_half(plant, i) for i in range(n)])
    left: list[int | None] = [None] * n
    on = np.array([side is not None for side in sides])
    times, seen = np.zeros(n), plant.seen
    # Near the edge a motion may do other than it was measured to: what went wrong once is not tried again.
    right = np.ones((n, len(menu)), dtype=bool)
    while on.any() and times.max() < timeout:
        before = seen.poses[:, :2]
        moved = np.array([displaced(menu.response, place, _PULSE)[:, :2] for place in before])
        pulses = [_outward(menu, before[i], moved[i], int(sides[i] or 0), right[i]) if on[i] else 0 for i in range(n)]
        for tick in range(_PULSE + PAUSE):
            seen = plant.step([menu.motions[k] if tick < _PULSE else still for k in pulses])
            times[on] += plant.tick
            share = plant.poses[:, :2] @ _OUTWARD.T / np.repeat(half, 2, axis=1)
            for i in np.flatnonzero(on & (share.max(axis=1) > 1)):
                left[i], on[i] = int(share[i].argmax()), False
        for i, pulse in enumerate(pulses):
            right[i, pulse] &= bool(np.linalg.norm(seen.poses[i, :2] - before[i] - moved[i, pulse]) < _WRONG)
    return left, times


def _half(plant: Plant, i: int) -> tuple[float, float]:
    plate = plant.session.scenarios[i].plate
    return (plate.length / 2, plate.width / 2) if plate else (math.inf, math.inf)


def _outward(menu: Menu, place: Array, moved: Array, side: int, allowed: Flags) -> int:
    """Motion, of those that move a sheet (m, 2) from a place, that leaves it outwards, abreast of a side's middle."""
    moved = moved[1:]
    out = np.where(allowed[1:], moved @ _OUTWARD[side], 0.0)
    aside = np.abs((place + moved) @ np.abs(_OUTWARD[side][::-1]))
    unsure = np.linalg.norm(menu.response.spread[1:, :2], axis=1)
    merit = out - _ASIDE * aside - _UNSURE * unsure
    return int(np.where(out >= _LEAST_OUT * out.max(), merit, -np.inf).argmax()) + 1


def from_now(plant: Plant) -> Callable[[Plant], Seen]:
    """What a plant's cameras tell, with times counted from now, for a controller that takes over: `steer(look=…)`."""
    begun = plant.time

    def look(plant: Plant) -> Seen:
        return replace(plant.seen, taken=plant.seen.taken - begun)

    return look
