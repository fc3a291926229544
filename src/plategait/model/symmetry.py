"""What the symmetry of a plate's motion forbids: a mirror that it goes over into, some time later."""

from __future__ import annotations

import numpy as np

from plategait.model.motion import AXES, PlateMotion

# What changes its sign in the mirror across the bar (y to -y), in that along it, and in half a turn about z.
_FLIPPED = (("y", "rx", "rz"), ("x", "ry", "rz"), ("x", "y", "rx", "ry"))
# And what of an object's velocity along the bar, across it and about z does: that is none in the mean.
_FORBIDDEN = (("across", "turn"), ("along", "turn"), ("along", "across"))
VELOCITIES = ("along", "across", "turn")
# Of a period: two phases that differ by less are the same.
_SAME = 1e-6
# Periods of the slowest sine within which it is looked for.
_LONGEST = 60
_WORDS = {"along": "goes along the bar", "across": "goes across the bar", "turn": "turns"}


def allowed_velocities(motion: PlateMotion) -> tuple[str, ...]:
    """Which of "along", "across" and "turn" a motion's symmetry leaves to an object as symmetric as a disk.

    A motion that some time later is its own mirror image can carry an object only where the mirror leaves the velocity
    as it is. Shaking along the bar at p/q of the frequency of rocking about it turns the object where p and q are odd,
    carries it along the bar where p is even, and across it where q is even. No law of contact or friction comes in.
    What strides by a period of its own, as walking does, is not bound by it.

    Source: the study `phases` (docs/studies.md), which holds it against the engine.
    """
    if motion.samples is not None or not motion.terms():
        return VELOCITIES
    forbidden = {name for flipped, names in zip(_FLIPPED, _FORBIDDEN, strict=True)
                 if _goes_over(motion, flipped) for name in names}  # fmt: skip
    return tuple(name for name in VELOCITIES if name not in forbidden)


def symmetry_in_words(motion: PlateMotion) -> str:
    """What to expect of a motion by its symmetry, in a line; empty where it forbids nothing, or for (4.1), (4.2)."""
    allowed = allowed_velocities(motion)
    if allowed == VELOCITIES or not (motion.waves or any(motion.offset.pose)):
        return ""
    does = " and ".join(_WORDS[name] for name in allowed) or "stays where it is"
    never = " nor ".join(_WORDS[name] for name in VELOCITIES if name not in allowed)
    return f"by the motion's symmetry a round object {does}: in the mean it never {never}"


def _goes_over(motion: PlateMotion, flipped: tuple[str, ...]) -> bool:
    """Whether a motion is, some time later, itself with these degrees of freedom turned about."""
    if any(value for axis, value in zip(AXES, motion.offset.pose, strict=True) if axis in flipped):
        return False
    sines = [(frequency, 0.5 if AXES[axis] in flipped else 0.0) for axis, _, frequency, _ in motion.terms()]
    slowest, turn = min(sines)
    # Times that turn the slowest sine as asked for.
    times = (np.arange(_LONGEST) + turn) / slowest
    off = np.array([(frequency * times - other + 0.5) % 1 - 0.5 for frequency, other in sines])
    return bool((np.abs(off) < _SAME).all(axis=0).any())
