"""Model-predictive control by sampling (MPPI): pulses rolled forward by the engine itself, weighed, and averaged.

G. Williams, A. Aldrich and E. A. Theodorou, Model Predictive Path Integral Control, J. Guid. Control Dyn. 40(2), 2017:
futures about a nominal action are weighed by exp(-cost / temperature), and their mean is what is done.
"""

from __future__ import annotations

import math

import numpy as np

from plategait.arrays import Array
from plategait.control.blend import REST, BlendingController
from plategait.control.futures import HORIZON, Futures
from plategait.control.goal import WITHIN, WITHIN_ANGLE
from plategait.control.menu import Menu
from plategait.control.observer import Observer
from plategait.control.pulse import Pulses
from plategait.control.response import stopped
from plategait.model.motion import PlateMotion

FUTURES = 64
"""Futures that are rolled forward for each decision."""
THINKING = 6
"""Ticks that a decision takes, and that the object is left resting for: 0.1 s."""
# Pulses that futures are spread about, and by how much: shares of what each motor can do, and of the ticks.
_NOMINAL = 8
_SPREAD, _LONGER = 0.04, 0.15
# Cost at which a future weighs 1/e of the best, s.
_TEMPERATURE = 0.05
# Standard deviation of what the engine tells of a pulse, where the pose that it begins from is not certain: m, m, rad.
_UNSURE = np.array([0.5e-3, 0.5e-3, math.radians(0.7)])


class SamplingController(BlendingController):
    """Weighs pulses, and variations of them, by what the engine tells of each, and makes the mean of the best ones.

    Parameters
    ----------
    menu, pulses, goal, within
        As of `BlendingController`.
    futures : Futures
        Of the object as it is believed to be.
    """

    def __init__(
        self,
        menu: Menu,
        pulses: Pulses,
        goal: Array,
        futures: Futures,
        within: tuple[float, float] = (WITHIN, WITHIN_ANGLE),
        seed: int = 0,
    ) -> None:
        super().__init__(menu, pulses, goal, within=within)
        self._futures, self._generator = futures, np.random.default_rng(seed)
        self._thought: tuple[int, PlateMotion, int, Array] | None = None
        self._made: PlateMotion | None = None

    def aim(self, goal: Array) -> None:
        """Go for another goal from now on."""
        super().aim(goal)
        self._thought = None

    def told(self, motions: tuple[PlateMotion, ...]) -> PlateMotion:
        """Motion that the plate is told, of a menu's motions at its height."""
        if self.motion == 0 or self._made is None:
            return motions[0]
        return self._made.with_valid(height=motions[0].height)

    def _begin(self, observer: Observer) -> None:
        if self._rested == REST or self._thought is None:
            state = observer.expected()
            pulse, _ = self.plan(state)
            self._rested = REST
            self._thought = self._decided(state, pulse) if pulse else None
        elif self._rested >= REST + THINKING:
            self.motion, self._made, self._planned, self._target = self._thought
            self._going, self._rested, self._thought = 0, 0, None
            self.made += 1

    def _over(self, observer: Observer) -> bool:
        return self._going >= self._planned

    def _decided(self, state: Array, best: int) -> tuple[int, PlateMotion, int, Array]:
        """Motion of the menu, its variation, ticks, and where the pulse ends."""
        pose, pulses = stopped(state), self.pulses
        gains = self.gains(pose)
        nominal = np.unique(np.concatenate([[best], np.argsort(-gains)[: _NOMINAL - 1]]))
        of = np.resize(nominal, len(self._futures))
        varied = np.arange(len(of)) >= len(nominal)
        shake = self._generator.standard_normal((len(of), len(self.menu.drive))) * varied[:, None]
        stretch = self._generator.standard_normal(len(of)) * varied
        actions = np.clip(self.menu.actions[pulses.motion[of]] + _SPREAD * shake, -1, 1)
        ticks = np.clip(np.rint(pulses.ticks[of] * np.exp(_LONGER * stretch)), 2, HORIZON - 4).astype(np.int64)
        ends, sound = self._futures.ends(pose, self.menu.drive.motions(actions), ticks)
        costs = np.where(sound, ticks / 60 + self.left(ends) + self.outside(ends, _UNSURE), math.inf)
        winner = of[int(costs.argmin())]
        family = np.flatnonzero(of == winner)
        weights = np.exp(-(costs[family] - costs.min()) / _TEMPERATURE)
        weights /= weights.sum()
        motion = self.menu.drive.motions((weights @ actions[family])[None])[0]
        return int(pulses.motion[winner]), motion, round(float(weights @ ticks[family])), weights @ ends[family]
