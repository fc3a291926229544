"""What the symmetry of a plate's motion forbids, by the sines that it is made of."""

from __future__ import annotations

import math

import pytest

from plategait.model.motion import Held, PlateMotion, Wave
from plategait.model.symmetry import allowed_velocities, symmetry_in_words

BOTH = PlateMotion(frequency=18.0)
ROCKING = BOTH.replace(stroke=0.0)


@pytest.mark.parametrize(
    ("ratio", "allowed"),
    [(1.0, "turn"), (3.0, "turn"), (1 / 3, "turn"), (5 / 3, "turn"), (2.0, "along"), (2 / 3, "along"), (4.0, "along"),
     (0.5, "across"), (1.5, "across"), (2.5, "across"), (3 / 4, "across"), (1.05, "across")],
)  # fmt: skip
@pytest.mark.parametrize("phase", [0.0, 0.7, 2.0])
def test_the_ratio_of_shaking_to_rocking_decides(ratio, phase, allowed):
    motion = ROCKING.replace(waves=(Wave(axis="x", amplitude=0.003, ratio=ratio, phase=phase),))
    assert allowed_velocities(motion) == (allowed,)
    assert {"turn": "turns:", "along": "along the bar:", "across": "across the bar:"}[allowed] in symmetry_in_words(
        motion
    )


def test_one_sine_alone_carries_nothing_and_the_source_s_motion_goes_without_words():
    assert allowed_velocities(ROCKING) == allowed_velocities(BOTH.replace(angle=0.0)) == ()
    assert allowed_velocities(BOTH) == ("turn",)
    assert symmetry_in_words(BOTH) == ""


def test_what_breaks_a_mirror_allows_what_it_forbade():
    off_level = BOTH.replace(offset=Held(rx=math.radians(2)))
    # Downhill and along the bar, as motions of that kind are known to carry.
    assert allowed_velocities(off_level) == ("along", "across", "turn")
    assert symmetry_in_words(off_level) == ""
    # Shaking alone, off level: downhill only.
    assert allowed_velocities(off_level.replace(angle=0.0)) == ("across",)
    # Shaking and heaving, as a parts feeder: along the way in which it shakes.
    heaving = BOTH.replace(angle=0.0, waves=(Wave(axis="z", amplitude=0.001, phase=1.0),))
    assert allowed_velocities(heaving) == ("along",)
    # No whole numbers, no symmetry.
    other = Wave(axis="x", amplitude=0.003, ratio=math.sqrt(2))
    assert allowed_velocities(ROCKING.replace(waves=(other,))) == (
        "along", "across", "turn")  # fmt: skip
