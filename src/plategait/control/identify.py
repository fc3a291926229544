"""A response identified: pulses of motions run from rest to rest, and the polynomials and lags that explain them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array, Flags
from plategait.control.response import DELAY, LONGEST, STOPPING, TICK, Field, Response, resting
from plategait.control.room import room_of
from plategait.engine.engines import Engine
from plategait.model.motion import PlateMotion
from plategait.model.scenario import Scenario
from plategait.simulation.session import Session

TAIL = 15
"""Ticks after which an object rests on a plate that stands."""
_LAGS = (0.02, 0.05, 0.1, 0.2, 0.4, 0.8)
_WATCHED = 0.05  # s
# Ticks, all but one, that a pulse may begin late: a period of the slowest plates.
_WAITS = 12
# Share of its area that a sheet shows from above while it is far from folding: half of it counts as folded.
_FLAT = 0.75


@dataclass(frozen=True, eq=False)
class PulseRuns:
    """Runs of motions for some ticks each, from rest to rest.

    Attributes
    ----------
    tracks : (n, ticks + 1, 3) array
        Pose at each tick, with angles that do not jump; NaN from where a run ceased to be finite.
    which, ticks : (n,) int arrays
        Which motion, and for how many ticks.
    sound : (n,) bool array
        Runs in which the object was flat enough at every tick.
    room : (2,) array
        Where poses stay clear of the plate's edges, m.
    """

    tracks: Array
    which: NDArray[np.int64]
    ticks: NDArray[np.int64]
    sound: Flags
    room: Array


def pulses(
    scenarios: Sequence[Scenario],
    motions: Sequence[PlateMotion],
    ticks: Sequence[int],
    starts: int,
    seed: int,
    reach: float,
    *,
    engine: Engine = "cpu",
    threads: int | None = None,
) -> PulseRuns:
    """Run each motion but the first, from rest to rest, for each number of ticks and from so many poses.

    Parameters
    ----------
    scenarios : sequence of Scenario
        The object as it may be: taken in turn.
    motions : sequence of PlateMotion
        The first a plate that stands.
    ticks : sequence of int
    starts : int
    seed : int
    reach : float
        How far from the middle of the plate runs start each way, m; at any angle.
    """
    generator, still = np.random.default_rng(seed), motions[0]
    placed, which, lasting = [], [], []
    for i in range(1, len(motions)):
        for ticked in ticks:
            for _ in range(starts):
                x, y, turn = generator.uniform(-1, 1, 3).tolist()
                scenario = scenarios[len(placed) % len(scenarios)]
                start = {"start.x": reach * x, "start.y": reach * y, "start.angle": math.pi * turn}
                placed.append(scenario.replace(motion=still, **start))
                which.append(i)
                lasting.append(ticked)
    asked, until = np.array(which, dtype=np.int64), np.array(lasting, dtype=np.int64)
    # Sines count from the start of a run, so that a pulse that begins later begins at another phase.
    begun = generator.integers(_WAITS, size=len(placed))
    session = Session(placed, engine=engine, threads=threads, keep=_WATCHED)
    session.advance(None, _WATCHED)
    poses, now, sound = [session.poses], np.zeros(len(placed), dtype=np.int64), flat(session)
    count = max(ticks) + TAIL + DELAY
    for k in range(count + _WAITS - 1):
        wanted = np.where((k >= begun) & (k < begun + until), asked, 0)
        session.advance([motions[w] if w != n else None for w, n in zip(wanted, now, strict=True)], TICK)
        poses.append(session.poses)
        now, sound = wanted, sound & flat(session)
    tracks = np.array(poses)[np.arange(count + 1) + begun[:, None], np.arange(len(placed))[:, None]]
    tracks[..., 2] = np.unwrap(tracks[..., 2], axis=1)
    return PulseRuns(tracks, asked, until, sound, np.min([room_of(scenario) for scenario in scenarios], axis=0))


def flat(session: Session) -> Flags:
    """(n,) runs whose sheets are far from being folded or turned over."""
    with np.errstate(invalid="ignore"):
        return ~session.diverged & (session.now("area_z") > _FLAT)


def fitted(run: PulseRuns, count: int, field: Field) -> Response:
    """Response to so many motions, fitted to pulses of them.

    Of each motion and component the lag among a few that explains the tracks best, with least squares for the rates.
    """
    response = resting(count, field)
    rates, lags, spread, failed = response.rates, response.lags, response.spread, response.failed
    for i in range(1, count):
        chosen = run.which == i
        tracks, ticks = run.tracks[chosen], run.ticks[chosen]
        with np.errstate(invalid="ignore"):
            inside = (np.abs(tracks[:, :, :2]) < run.room).all(axis=(1, 2)) & np.isfinite(tracks).all(axis=(1, 2))
        failed[i] = not run.sound[chosen][inside].all() or 2 * inside.sum() < chosen.sum()
        tracks, ticks = tracks[inside], ticks[inside]
        if not len(tracks):
            spread[i] = np.inf
            continue
        longer = np.sqrt(LONGEST / ticks)[:, None]
        best = np.full(3, np.inf)
        for lag in _LAGS:
            base = _displacements(tracks, ticks, lag, field)
            # Of all of a track a few points are enough.
            some = np.arange(base.shape[1] - 1, 0, -4)
            rows = base[:, some].reshape(-1, len(field))
            moved = (tracks[:, some] - tracks[:, :1]).reshape(-1, 3)
            found, *_ = np.linalg.lstsq(rows, moved, rcond=None)
            left = (moved - rows @ found).reshape(len(tracks), len(some), 3)
            loss = (left**2).mean(axis=(0, 1))
            # What so few runs explain by chance is counted as unexplained.
            own = np.sqrt(((left[:, 0] * longer) ** 2).sum(axis=0) / max(len(tracks) - len(field), 1))
            for c in np.flatnonzero(loss < best):
                best[c], rates[i, c], lags[i, c], spread[i, c] = loss[c], found[:, c], lag, own[c]
    return response


def _displacements(tracks: Array, ticks: NDArray[np.int64], lag: float, field: Field) -> Array:
    """(n, ticks + 1, p) displacements that each rate of 1 would give, along tracks as they were."""
    n, points, _ = tracks.shape
    velocity, moved = np.zeros((n, len(field))), np.zeros((n, points, len(field)))
    going, stopping = 1 - math.exp(-TICK / lag), 1 - math.exp(-TICK / STOPPING)
    there = field.at(tracks[:, :, :2])
    for k in range(points - 1):
        active = ((k >= DELAY) & (k < ticks + DELAY))[:, None]
        velocity = velocity + np.where(active, going * (there[:, k] - velocity), -stopping * velocity)
        moved[:, k + 1] = moved[:, k] + TICK * velocity
    return moved
