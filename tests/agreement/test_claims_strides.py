"""The study of strides, small: what it claims of run-off and of rigid disks fails here if it fails there."""

from __future__ import annotations

import numpy as np

from plategait.simulation.strobe import POSE, SHAPE, advance, at_rest, coordinates, partings, stroboscopic
from plategait.study.questions.gait import at_gamma, body
from plategait.study.questions.strides import alternation


def test_strides_double_at_run_off_and_rigid_disks_bounce():
    points = [("soft", 4.5), ("soft", 6.0), ("rigid", 4.25)]
    scenarios = [stroboscopic(at_gamma(body(name, 3.0), gamma)) for name, gamma in points]
    states = advance(scenarios, [at_rest(s) for s in scenarios], 60)
    slid, doubled, bounced = partings(scenarios, states, 1e-2, periods=16, series=1)
    # -0.4 and 1.0 are found, with errors of 0.05 and 0.15 over so few strides.
    assert slid.growth < -0.2
    assert bounced.growth > 0.4
    assert doubled.growth < bounced.growth
    seen = []
    for _ in range(16):
        states = advance(scenarios, states)
        seen.append([coordinates(s, state) for s, state in zip(scenarios, states, strict=True)])
    series = np.array(seen).transpose(1, 0, 2)
    once, twice, never = (alternation(each[:, SHAPE]) for each in series)
    assert twice > 0.8
    assert max(once, never) < 0.6
    # The doubled stride has stepped aside, 0.24 of the radius.
    assert np.abs(series[1, -1, POSE][1]) > 0.12
