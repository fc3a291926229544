"""Where an object is now, from frames that are late, noisy or missing, and from what its plate was told meanwhile."""

from __future__ import annotations

import math

import numpy as np

from plategait.arrays import Array
from plategait.control.camera import Camera
from plategait.control.response import DELAY, LONGEST, TICK, Response, wrapped

# How far a pose that a camera tells without noise may be out, m and rad: an object trembles with its plate.
_LEAST_NOISE = np.array([0.2e-3, 0.2e-3, math.radians(0.3)])
_TREMBLE = np.array([0.8e-3, 0.5e-3, math.radians(1.0)])
# By which an object that rests may move in a tick unseen.
_CREEP = np.array([0.02e-3, 0.02e-3, math.radians(0.02)])
# Squared distance of a frame from what was expected (χ² with three degrees of freedom) that hardly ever is exceeded,
# and how many frames in a row that far mean that the object was moved by something else.
_FAR, _MOVED = 25.0, 2
# Ticks that a frame may be late: without one for as long the filter goes on by itself.
_LONGEST = 30
# Uncertainty of where an object is after it was moved, and of how fast it goes.
_ANYWHERE, _ANY_SPEED = np.array([0.05, 0.05, 1.0]), np.array([0.3, 0.3, 10.0])


class Observer:
    """Kalman filter on an object's pose and velocity, as the response to each motion tells them.

    It lags behind by the newest frame: what the plate was told since is gone through anew whenever it is asked.

    Parameters
    ----------
    camera : Camera
    response : Response
        May be exchanged as the object is learnt.
    pose : (3,) array
        Where the object is first seen.
    """

    def __init__(self, camera: Camera, response: Response, pose: Array) -> None:
        self.response = response
        noise = np.array([camera.position_noise, camera.position_noise, camera.angle_noise])
        self._noise = np.maximum(noise, _LEAST_NOISE)
        self._state = np.array([*pose, 0.0, 0.0, 0.0])
        self._covariance = np.diag([*self._noise**2, *np.zeros(3)])
        # Motions that held, or will hold, tick by tick: those before the filter's own time are forgotten.
        self._held = [0] * DELAY
        self._tick, self._far = 0, 0
        self.newest = 0

    def told(self, motion: int) -> None:
        """Note what the plate is told to do in the tick that begins."""
        self._held.append(motion)
        if len(self._held) > _LONGEST:
            self._go_on()

    def saw(self, pose: Array, taken: float) -> bool:
        """Take in a frame; whether the object was found to be elsewhere than it can have gone by itself.

        Parameters
        ----------
        pose : (3,) array
            x, y, m, and the angle, rad.
        taken : float
            When, s.
        """
        for _ in range(max(round(taken / TICK) - self._tick, 0)):
            self._go_on()
        self.newest = self._tick
        moving = self._held[0] != 0 or bool(np.abs(self._state[3:5]).max() > 5e-3)
        noise = np.diag(self._noise**2 + (_TREMBLE**2 if moving else 0.0))
        error = wrapped(pose - self._state[:3])
        seen = self._covariance[:3, :3] + noise
        far = float(error @ np.linalg.solve(seen, error)) > _FAR
        self._far = self._far + 1 if far else 0
        moved = self._far >= _MOVED
        if moved:
            self._covariance = np.diag([*_ANYWHERE**2, *_ANY_SPEED**2])
            self._far, seen = 0, self._covariance[:3, :3] + noise
        if far and not moved:
            return False
        gain = np.linalg.solve(seen, self._covariance[:3]).T
        self._state = self._state + gain @ error
        self._covariance = self._covariance - gain @ seen @ gain.T
        return moved

    def _go_on(self) -> None:
        """Let the filter's own time go on by a tick."""
        motion = self._held.pop(0)
        step = self.response.slope(motion, self._state)
        self._state = self.response.step(motion, self._state)
        if motion:
            spread = self.response.spread[motion]
            place, speed = spread / math.sqrt(LONGEST), spread / (LONGEST * TICK)
        else:
            place, speed = _CREEP, 0.2 * np.abs(self._state[3:])
        self._covariance = step @ self._covariance @ step.T + np.diag([*place**2, *speed**2])
        self._tick += 1

    def expected(self) -> Array:
        """(6,) the pose and its velocity when what the plate is told next takes hold."""
        state = self._state
        for motion in self._held:
            state = self.response.step(motion, state)
        return state

    @property
    def pose(self) -> Array:
        """(3,) where the object is expected to be when what the plate is told next takes hold."""
        return self.expected()[:3]

    @property
    def since_seen(self) -> float:
        """Time since the newest frame was taken, s."""
        return (self._tick + len(self._held) - DELAY - self.newest) * TICK

    @property
    def deviation(self) -> Array:
        """(3,) standard deviation of the pose at the newest frame."""
        return np.sqrt(np.diag(self._covariance)[:3])
