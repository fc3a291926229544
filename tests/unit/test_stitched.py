"""Trajectories of plates told one motion after the other: what a session's plate did, sample by sample."""

import numpy as np
import pytest

from plategait.control.plant import at_rest
from plategait.errors import InputError
from plategait.export.stitched import stitched
from plategait.model.motion import AXES
from plategait.model.presets import preset
from plategait.simulation.session import Session

CHEESE = preset("cheese").scenario


def test_a_plate_goes_the_way_that_a_sessions_plate_went():
    still = at_rest(CHEESE)
    first = CHEESE.motion.replace(ramp=0.06)
    second = first.replace(frequency=17.0, angle=0.05, **{"offset.rx": 0.02})
    session = Session([still], machine="source-robot", snapshot_interval=0.01)
    told, time = [], 0.0
    for motion in (still.motion, first, second, still.motion):
        told.append((time, motion))
        session.advance(motion, 0.3)
        time += 0.3
    recording = session.recording(0)
    made = stitched(told, still.motion, 0.9, "2 kHz", "source-robot")
    assert made.duration >= 0.9
    assert set(made.axes) == {"x", "rx"}
    for axis in made.axes:
        plate = np.interp(recording["time"], made.time, made.position[AXES.index(axis)])
        # Straight lines between samples miss (2 pi 24 Hz / 2 kHz)^2 / 8 of an amplitude, 0.0007.
        np.testing.assert_allclose(recording[f"plate_{axis}"], plate, atol=1e-3 * np.abs(plate).max())


def test_a_rate_too_low_for_a_motion_that_was_told_is_refused():
    with pytest.raises(InputError, match="rate"):
        stitched([(0.0, CHEESE.motion)], at_rest(CHEESE).motion, 0.5, "100 Hz")
