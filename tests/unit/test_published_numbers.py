"""The dissertation's numbers as data, and how its ω_n is to be read."""

from __future__ import annotations

import math

import pytest

from plategait import published
from plategait.estimate.linear import LinearEstimate, line
from plategait.estimate.training import FREQUENCIES
from plategait.model.presets import nominal_natural_frequency, preset
from plategait.thesis.cases import Case

TABLE_4_1 = preset("cheese").scenario


def test_the_44_curves_are_four_objects_at_each_amplitude_and_every_friction_angle():
    for angle, objects, angles in ((3, 4, 6), (12, 4, 5)):
        curves = [c for c in published.curves() if c.angle_deg == angle]
        assert len({(c.omega_pi, c.alpha_deg) for c in curves}) == len(curves) == objects * angles
    assert set(FREQUENCIES) == set(published.AMPLITUDES)


@pytest.mark.parametrize(
    ("angle", "of", "powers", "sd", "domain"),
    [
        # Section 5.6.1; the spreads worked out by hand from Tables 5.1 to 5.8; section 5.5.
        (3, "omega", (-121.62, 5.30), 1.42, (0, 40)),
        (3, "alpha", (-74.71, 545.02), 3.33, (24, 57)),
        (12, "omega", (-64.51, 5.65), 0.69, (0, 12)),
        (12, "alpha", (-54.10, 379.24), 1.57, (24, 41)),
    ],
)
def test_the_source_s_estimator_is_the_published_one(angle, of, powers, sd, domain):
    calibrated = line("linear", "published", angle, of)
    assert (calibrated.powers, calibrated.sd, (calibrated.low, calibrated.high)) == (powers, sd, domain)


def test_table_4_1_is_called_10_pi():
    sheet = TABLE_4_1.sheet
    assert nominal_natural_frequency(sheet) == published.NOMINAL_NATURAL_FREQUENCY == 10 * math.pi
    assert sheet.natural_frequency == pytest.approx(10.32 * math.pi, rel=1e-3)
    assert Case(3, 10.0).scenario.sheet.bending_stiffness == pytest.approx(sheet.bending_stiffness, rel=1e-12)


def test_what_is_estimated_at_10_pi_is_the_sheet_of_table_4_1():
    estimate = LinearEstimate(10 * math.pi, 0.1, math.atan(0.75), 0.01, "linear", "published", ())
    fragment = estimate.to_fragment(TABLE_4_1)
    assert fragment.parameters["sheet.bending_stiffness"].value == pytest.approx(TABLE_4_1.sheet.bending_stiffness)


def test_reference_friction_is_that_of_table_4_1():
    assert math.degrees(math.atan(TABLE_4_1.friction.static)) == pytest.approx(published.REFERENCE_ALPHA, abs=5e-3)
    assert TABLE_4_1.friction.ratio == pytest.approx(published.FRICTION_RATIO, abs=5e-3)
    assert TABLE_4_1.motion.stroke == published.STROKE
    assert TABLE_4_1.sheet.outline.radius == published.RADIUS  # type: ignore[union-attr]
