"""How an object responds to motions of its plate: velocities that depend on where it lies, each reached with a lag.

Over a second and more a motion carries an object at a steady velocity; over the tenths of a second that a controller
deals in, it is still on its way there, and how fast it goes depends on how far from the bar it lies. Both are linear
enough to be told in a few numbers: of each component of the velocity w' = (V + V_x x + V_y y - w) / lag.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array, Flags
from plategait.engine.engines import Engine
from plategait.model.motion import PlateMotion
from plategait.model.scenario import Scenario
from plategait.simulation.session import Session

TICK = 1 / 60
"""Time between two decisions, s."""
DELAY = 2
"""Ticks after which a new motion takes hold: about half of the time in which the plate goes over to it."""
STOPPING = 0.05
"""Lag with which an object comes to rest on a plate that stands, s: measured, the same for all motions."""
LONGEST = 24
"""Ticks of the longest pulse that responses are fitted to."""
TAIL = 15
"""Ticks after which an object rests on a plate that stands."""

_LAGS = (0.02, 0.05, 0.1, 0.2, 0.4, 0.8)
# Beyond this share of the plate's half sizes what happens at its edge begins.
_EDGE = 0.9
_WATCHED = 0.05  # s
# Share of its area that a sheet shows from above while it is far from folding: half of it counts as folded.
_FLAT = 0.75


@dataclass(frozen=True, eq=False)
class Response:
    """How an object responds to m motions, the first of them a plate that stands.

    Attributes
    ----------
    rates : (m, 3, 3) array
        V, V_x and V_y of each component of the velocity: m/s, m/s, rad/s, and per m.
    lags : (m, 3) array
        Lag of each component, s.
    spread : (m, 3) array
        Root mean square of what remains unexplained where a pulse ends, m, m, rad.
    failed : (m,) bool array
        Motions with which an object was lost, folded or turned over.
    """

    rates: Array
    lags: Array
    spread: Array
    failed: Flags

    def __len__(self) -> int:
        """Return the number of motions."""
        return len(self.rates)

    def of(self, which: Sequence[int] | NDArray[np.int64]) -> Response:
        """Response to some of the motions."""
        chosen = np.asarray(which)
        return Response(self.rates[chosen], self.lags[chosen], self.spread[chosen], self.failed[chosen])

    @property
    def maps(self) -> Array:
        """(m, 7, 7) what a tick makes of (1, x, y, angle, and their velocities), from the left."""
        share = 1 - np.exp(-TICK / self.lags)
        velocity = np.zeros((len(self), 3, 7))
        velocity[:, :, :3] = share[:, :, None] * self.rates
        velocity[:, (0, 1, 2), (4, 5, 6)] = 1 - share
        maps = np.zeros((len(self), 7, 7))
        maps[:, 0, 0] = 1.0
        maps[:, 4:] = velocity
        maps[:, 1:4] = TICK * velocity
        maps[:, (1, 2, 3), (1, 2, 3)] += 1.0
        return maps


def resting(count: int = 1) -> Response:
    """Response to a plate that stands, so many times."""
    zeros = np.zeros((count, 3))
    return Response(np.zeros((count, 3, 3)), np.full((count, 3), STOPPING), zeros, np.zeros(count, dtype=bool))


def wrapped(poses: Array) -> Array:
    """Differences of poses (…, 3), whose angles are brought into ±π."""
    angle = np.remainder(poses[..., 2:] + math.pi, 2 * math.pi) - math.pi
    return np.concatenate([poses[..., :2], angle], axis=-1)


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
    session = Session(placed, engine=engine, threads=threads, keep=_WATCHED)
    session.advance(None, _WATCHED)
    poses, now, sound = [session.poses], np.zeros(len(placed), dtype=np.int64), flat(session)
    for k in range(max(ticks) + TAIL + DELAY):
        wanted = np.where(k < until, asked, 0)
        session.advance([motions[w] if w != n else None for w, n in zip(wanted, now, strict=True)], TICK)
        poses.append(session.poses)
        now, sound = wanted, sound & flat(session)
    tracks = np.array(poses).transpose(1, 0, 2)
    tracks[..., 2] = np.unwrap(tracks[..., 2], axis=1)
    plate = scenarios[0].plate
    room = _EDGE * np.array([plate.length, plate.width]) / 2 if plate else np.full(2, np.inf)
    return PulseRuns(tracks, asked, until, sound, room)


def flat(session: Session) -> Flags:
    """(n,) runs whose sheets are far from being folded or turned over."""
    with np.errstate(invalid="ignore"):
        return ~session.diverged & (session.now("area_z") > _FLAT)


def fitted(run: PulseRuns, count: int) -> Response:
    """Response to so many motions, fitted to pulses of them.

    Of each motion and component the lag among a few that explains the tracks best, with least squares for the rates.
    """
    response = resting(count)
    rates, lags, spread, failed = response.rates, response.lags, response.spread.copy(), response.failed
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
        best = np.full(3, np.inf)
        for lag in _LAGS:
            base = _displacements(tracks, ticks, lag)
            # Of all of a track a few points are enough.
            some = np.arange(base.shape[1] - 1, 0, -4)
            rows = base[:, some].reshape(-1, 3)
            moved = (tracks[:, some] - tracks[:, :1]).reshape(-1, 3)
            found, *_ = np.linalg.lstsq(rows, moved, rcond=None)
            left = (moved - rows @ found).reshape(len(tracks), len(some), 3)
            loss = (left**2).mean(axis=(0, 1))
            # What so few runs explain by chance is counted as unexplained.
            own = np.sqrt((left[:, 0] ** 2).sum(axis=0) / max(len(tracks) - 3, 1))
            for c in np.flatnonzero(loss < best):
                best[c], rates[i, c], lags[i, c], spread[i, c] = loss[c], found[:, c], lag, own[c]
    return Response(rates, lags, spread, failed)


def _displacements(tracks: Array, ticks: NDArray[np.int64], lag: float) -> Array:
    """(n, ticks + 1, 3) displacements that V, V_x and V_y of 1 would give, along tracks as they were."""
    n, points, _ = tracks.shape
    velocity, moved = np.zeros((n, 3)), np.zeros((n, points, 3))
    going, stopping = 1 - math.exp(-TICK / lag), 1 - math.exp(-TICK / STOPPING)
    for k in range(points - 1):
        active = ((k >= DELAY) & (k < ticks + DELAY))[:, None]
        there = np.concatenate([np.ones((n, 1)), tracks[:, k, :2]], axis=1)
        velocity = velocity + np.where(active, going * (there - velocity), -stopping * velocity)
        moved[:, k + 1] = moved[:, k] + TICK * velocity
    return moved
