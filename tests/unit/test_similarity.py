"""Similarity: groups that size leaves alone, and scenarios of another size with the same ones."""

from __future__ import annotations

import math
from dataclasses import asdict

import pytest

from plategait.errors import InputError
from plategait.model.outline import Disk, Ellipse, Mask, Polygon, Rectangle
from plategait.model.presets import preset
from plategait.model.similarity import (
    bending_over_weight,
    elongation,
    equivalent_radius,
    frequency_at,
    groups,
    similar,
)

CHEESE = preset("cheese").scenario
OUTLINES = (
    Disk(radius=0.04),
    Ellipse(length=0.09, width=0.06),
    Rectangle(length=0.08, width=0.05),
    Polygon(corners=((0.0, 0.0), (0.09, 0.0), (0.0, 0.07))),
    Mask(rows=(".##.", "####", ".##."), width_of_picture=0.08),
)


@pytest.mark.parametrize("outline", OUTLINES, ids=lambda outline: outline.shape)
@pytest.mark.parametrize("factor", [0.2, 3.0])
def test_a_similar_scenario_has_the_same_groups_and_lattice(outline, factor):
    scenario = CHEESE.replace(**{"sheet.outline": outline})
    other = similar(scenario, factor)
    assert other.sheet.lattice.key == scenario.sheet.lattice.key
    # Rounding alone is left.
    assert asdict(groups(other)) == pytest.approx(asdict(groups(scenario)), rel=1e-9)
    assert other.duration == pytest.approx(math.sqrt(factor) * scenario.duration)
    assert other.duration / other.dt == pytest.approx(scenario.duration / scenario.dt)


@pytest.mark.parametrize(
    ("kept", "changed"),
    [("contact", {"depth"}), ("friction", {"transition"}), ("height", {"height"}), ("stroke", {"stroke"}),
     ("gravity", {"acceleration", "stiffness", "transition", "depth"})],
)  # fmt: skip
def test_what_stays_as_it_is_changes_its_own_group(kept, changed):
    before, after = asdict(groups(CHEESE)), asdict(groups(similar(CHEESE, 2.0, keep=[kept])))
    assert {name for name, value in before.items() if after[name] != pytest.approx(value, rel=1e-9)} == changed


def test_without_gravity_nothing_but_gravity_differs():
    """Scaled in no time, it is the same motion under g over the factor: so the joints and the contact take s⁴."""
    other = similar(CHEESE, 2.0, keep=["gravity"])
    assert asdict(groups(other.replace(gravity=2 * 9.81))) == pytest.approx(asdict(groups(CHEESE)), rel=1e-9)


def test_radius_and_elongation_are_those_of_closed_forms():
    # √2 of the radius of gyration: of a rectangle √((a² + b²)/6); the lattice is exact for whole squares.
    sheet = CHEESE.sheet.replace(outline=Rectangle(length=0.08, width=0.05))
    assert equivalent_radius(sheet.lattice, sheet.pitch) == pytest.approx(math.sqrt((0.08**2 + 0.05**2) / 6))
    assert elongation(sheet.lattice) == pytest.approx(1.6)
    # A disk's own radius, within what squares at its edge leave.
    fine = CHEESE.sheet.replace(pitch=0.002)
    assert equivalent_radius(fine.lattice, fine.pitch) == pytest.approx(0.04, rel=0.005)
    assert elongation(CHEESE.sheet.lattice) == pytest.approx(1.0)


def test_bending_over_weight_is_that_of_a_plate():
    sheet = CHEESE.sheet
    radius = equivalent_radius(sheet.lattice, sheet.pitch)
    told = math.sqrt(sheet.bending_stiffness / (sheet.mass / sheet.area * 9.81 * radius**3))
    assert bending_over_weight(sheet, 9.81) == pytest.approx(told)


def test_a_frequency_is_found_for_a_group():
    at = CHEESE.replace(**{"motion.frequency": frequency_at(CHEESE, 4.2)})
    assert groups(at).acceleration == pytest.approx(4.2)


def test_nonsense_is_refused():
    for factor in (0.0, -1.0, math.inf):
        with pytest.raises(InputError, match="factor"):
            similar(CHEESE, factor)
    with pytest.raises(InputError, match="keep"):
        similar(CHEESE, 2.0, keep=["colour"])  # type: ignore[list-item]
    waved = CHEESE.replace(**{"motion.waves": [{"axis": "z", "amplitude": 0.001}]})
    with pytest.raises(InputError, match="motion"):
        similar(waved, 2.0)
    with pytest.raises(InputError, match="gravity"):
        groups(CHEESE.replace(gravity=0.0))
