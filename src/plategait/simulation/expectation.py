"""What gait to expect of a scenario before it is run: Γ at the rim, how soft the sheet is, where gaits change.

Where they change was found by the study `gait` (docs/studies.md), which holds these laws against sheets that they were
not fitted to; how fast a sheet spins at most, by `stroke`.
"""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass

import numpy as np

from plategait.errors import InputError
from plategait.model.scenario import Scenario
from plategait.theory.rigid import half_lift_limit

SPREAD, RUN_OFF_SPREAD = 0.2, 0.27
"""Standard deviation of where gaits change, and of where sheets run off, about the laws, over the value."""
# Fitted to 64 disks: how much longer a sheet stays with each unit of softness, over the rigid limit.
_PER_SOFTNESS = 0.25
# Running begins at this Γ over the rigid limit, times the softness to that power.
_RUNNING, _RUNNING_POWER = 2.04, 0.4
# Run-off over the rigid limit, at this power of the stroke over the rim's distance: fitted to 52 sheets that may slip
# 10 mm within 2.4 s. No stroke is told from one of a hundredth.
_RUN_OFF, _RUN_OFF_POWER, _LEAST_STROKE = 1.09, -0.29, 0.01


@dataclass(frozen=True)
class Expectation:
    """Where a scenario stands among the gaits.

    Attributes
    ----------
    gamma : float
        Γ, the greatest acceleration of the plate under the rim over gravity.
    softness : float
        Λ: f/f_n where bending is undamped, less where damping stiffens the sheet at the plate's frequency.
    rigid_limit : float
        Γ at which a half of a rigid object of this outline lifts.
    sliding_ends, running_begins, runs_off : float
        Γ at which a half lifts clear, nothing touches for a part of the stride, and the sheet runs off its place;
        they scatter by `SPREAD`, the last by `RUN_OFF_SPREAD`.
    top_spin : float
        Spin rate at which the rim is as fast as the plate's greatest speed along the bar, rad/s: none spins faster, and
        most come to 0.8 of it.
    """

    gamma: float
    softness: float
    rigid_limit: float
    sliding_ends: float
    running_begins: float
    runs_off: float
    top_spin: float

    @property
    def gait(self) -> str:
        """Gait that is the likeliest: running beyond its beginning, or what comes before it."""
        if self.gamma >= self.runs_off:
            return "run-off"
        if self.gamma < self.sliding_ends:
            return "sliding"
        return "running" if self.gamma >= self.running_begins else "walking"

    @property
    def words(self) -> str:
        """One line for people."""
        near = {
            "sliding": f"a half lifts near {self.sliding_ends:.2g}",
            "walking": f"nothing touches from {self.running_begins:.2g} on",
            "running": f"it runs off near {self.runs_off:.2g}",
            "run-off": f"near {self.runs_off:.2g} and above it leaves its place",
        }
        nears = {"sliding": self.sliding_ends, "walking": self.running_begins}
        what = "running" if nears.get(self.gait, 0.0) >= self.runs_off else self.gait
        spread = SPREAD if what in nears else RUN_OFF_SPREAD
        spin = f"at most {math.degrees(self.top_spin):.0f} deg/s"
        return f"Γ = {self.gamma:.2g} at the rim: expect {self.gait} ({near[what]}, ± {100 * spread:.0f} %), {spin}"

    def summary(self) -> dict[str, float | str]:
        """Plain numbers for `--json`."""
        numbers = asdict(self)
        top = math.degrees(numbers.pop("top_spin"))
        return {"gait": self.gait, **numbers, "top_spin_deg_s": top}


def softness(scenario: Scenario) -> float:
    """How soft a sheet is at the plate's frequency: Λ = (ω/ω_n)/(1 + (ω c_b/k_b)²)^¼.

    ω over the frequency that its dish mode would have with the magnitude of its complex stiffness, k_b + i ω c_b.
    """
    sheet, omega = scenario.sheet, math.tau * scenario.motion.frequency
    loss = omega * sheet.bending_damping / sheet.bending_stiffness
    return omega / sheet.quick_natural_frequency / (1 + loss**2) ** 0.25


def expect(scenario: Scenario) -> Expectation | None:
    """What gait to expect, or None where the laws say nothing: another motion than the plate's two sines, or
    a sheet without a mode that bends it.

    An object that spins lies at every angle to the bar, so its distances from the bar are taken in the mean over them.

    Source: the end of sliding is the rigid limit, ⟨|y|⟩ Θ̈ = g (`plategait.theory.rigid.half_lift_limit`), and a quarter
    of it more for each unit of softness.
    """
    motion, sheet = scenario.motion, scenario.sheet
    if not motion.angle or not sheet.bending_stiffness or motion.waves or motion.samples is not None:
        return None
    rest = sheet.lattice.rest[:, :2] * sheet.pitch
    # A node stands for its square; the rim is its edge.
    reach = float(np.abs(rest).max()) + sheet.pitch / 2
    across = 2 / math.pi * float(np.hypot(*rest.T).mean())
    acceleration = motion.angle * (math.tau * motion.frequency) ** 2
    rigid = reach * half_lift_limit(across, scenario.gravity) / scenario.gravity
    try:
        soft = softness(scenario)
    except InputError:
        return None
    return Expectation(
        gamma=reach * acceleration / scenario.gravity,
        softness=soft,
        rigid_limit=rigid,
        sliding_ends=rigid * (1 + _PER_SOFTNESS * soft),
        running_begins=rigid * max(1 + _PER_SOFTNESS * soft, _RUNNING * soft**_RUNNING_POWER),
        runs_off=_RUN_OFF * max(motion.stroke / reach, _LEAST_STROKE) ** _RUN_OFF_POWER * rigid,
        top_spin=motion.stroke * math.tau * motion.frequency / reach,
    )
