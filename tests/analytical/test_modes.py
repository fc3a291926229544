"""Modes are the sheet's own: where several have one frequency, whatever basis of them a solver happens to choose."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

from plategait.model.modes import transverse_matrix
from plategait.model.outline import Disk, Ellipse, Mask, Outline, Polygon, Rectangle
from plategait.model.sheet import Sheet

pytestmark = pytest.mark.linear_algebra

OUTLINES: dict[str, Outline] = {
    "disk": Disk(radius=0.04),
    "square": Rectangle(length=0.06, width=0.06),
    "rectangle": Rectangle(length=0.06, width=0.04),
    "upright rectangle": Rectangle(length=0.04, width=0.06),
    "long rectangle": Rectangle(length=0.08, width=0.03),
    "ellipse": Ellipse(length=0.1, width=0.08),
    "long ellipse": Ellipse(length=0.1, width=0.05),
    "right triangle": Polygon(corners=((0, 0), (0.08, 0), (0, 0.08))),
    "regular triangle": Polygon(corners=((0, 0), (0.1, 0), (0.05, 0.0866))),
    "diamond": Polygon(corners=((0.04, 0), (0, 0.04), (-0.04, 0), (0, -0.04))),
    "cross": Mask(width_of_picture=0.07, rows=("..###..", "..###..", "#######", "#######", "..###..", "..###..")),
    "ring": Mask(width_of_picture=0.06, rows=("######", "######", "##..##", "##..##", "######", "######")),
    "strip": Rectangle(length=0.08, width=0.01),
    "four nodes": Rectangle(length=0.02, width=0.02),
    "three nodes": Mask(width_of_picture=0.02, rows=("#.", "##")),
    "a node": Rectangle(length=0.01, width=0.01),
}


TORSIONS = (0.0, 3e-5, 1e-4)


def sheet(outline: Outline, torsion: float, bending: float = 1e-4) -> Sheet:
    return Sheet(
        outline=outline, mass=0.01, axial_stiffness=700.0, bending_stiffness=bending, bending_damping=1e-7,
        torsion_stiffness=torsion, torsion_damping=3e-8,
    )  # fmt: skip


def turned_by_hand(seed: int):
    """An eigensolver that mixes the modes of each frequency by a rotation at random, and flips signs, as it may."""
    solve, rng = np.linalg.eigh, np.random.default_rng(seed)

    def eigh(matrix):
        squared, vectors = solve(matrix)
        apart = np.flatnonzero(np.diff(squared) > 1e-10 * np.abs(squared).max(initial=0)) + 1
        for part in np.split(np.arange(len(squared)), apart):
            vectors[:, part] = vectors[:, part] @ np.linalg.qr(rng.normal(size=(len(part), len(part))))[0]
        return squared, vectors

    return eigh


@pytest.mark.parametrize("name", OUTLINES)
def test_modes_do_not_depend_on_the_solvers_choice(name, monkeypatch):
    for torsion, seed in itertools.product(TORSIONS, range(3)):
        chosen = sheet(OUTLINES[name], torsion).free_modes.modes
        monkeypatch.setattr(np.linalg, "eigh", turned_by_hand(seed))
        again = sheet(OUTLINES[name], torsion).free_modes.modes
        monkeypatch.undo()
        assert [m.name for m in again] == [m.name for m in chosen]
        largest = max((m.omega for m in chosen), default=0.0)
        for one, other in zip(chosen, again, strict=True):
            # Rounding: of ω² beside the largest, and some times more where vectors are chosen among near-equals.
            assert other.omega == pytest.approx(one.omega, rel=1e-9, abs=1e-9 * largest)
            assert other.damping_ratio == pytest.approx(one.damping_ratio, rel=1e-6)
            np.testing.assert_allclose(other.shape, one.shape, atol=1e-6)


@pytest.mark.parametrize("name", OUTLINES)
def test_modes_solve_the_eigenproblem_and_none_is_rigid(name):
    for torsion in TORSIONS:
        s = sheet(OUTLINES[name], torsion)
        matrix = transverse_matrix(s.lattice, s.pitch, s.bending_stiffness, torsion) / s.node_mass
        x, y = s.lattice.rest.T
        rigid = 1 + (np.ptp(x) > 0) + (np.ptp(y) > 0)
        modes = s.free_modes.modes
        assert len(modes) == s.lattice.n_nodes - rigid
        shapes = np.array([m.shape / np.linalg.norm(m.shape) for m in modes]).reshape(-1, s.lattice.n_nodes)
        np.testing.assert_allclose(shapes @ shapes.T, np.eye(len(modes)), atol=1e-9)
        np.testing.assert_allclose(shapes @ np.stack([np.ones_like(x), x, y], axis=1), 0, atol=1e-9)
        squared = np.array([m.omega**2 for m in modes])
        assert np.all(np.diff(squared) >= 0)
        np.testing.assert_allclose(matrix @ shapes.T, squared * shapes.T, atol=1e-9 * np.abs(matrix).max())


def test_the_dish_of_a_square_is_two_beams_across_each_other():
    # Free torsion, or torsion that x² ± y² do not feel: lines along x and along y bend as beams of n nodes, each with
    # half of the motion's mass and stiffness, so the dish and the saddle have the beam's frequency.
    square = OUTLINES["square"]
    beam = sheet(Rectangle(length=0.06, width=0.01), 0.0).replace(mass=0.01 / 6).free_modes.modes[0]
    for torsion in (0.0, 3e-5):
        modes = sheet(square, torsion).free_modes
        assert modes.dish.omega == pytest.approx(beam.omega, rel=1e-9)
        assert modes.saddle.omega == pytest.approx(beam.omega, rel=1e-9)
        along = beam.shape - beam.shape.mean()
        x, y = np.rint(sheet(square, 0.0).lattice.rest + 2.5).astype(int).T
        for mode, sign in ((modes.dish, 1), (modes.saddle, -1)):
            expected = along[x] + sign * along[y]
            likeness = mode.shape @ expected / np.linalg.norm(expected) / np.linalg.norm(mode.shape)
            assert abs(likeness) == pytest.approx(1, abs=1e-9)


@pytest.mark.parametrize("torsion", [0.0, 3e-5])
def test_a_sheet_and_its_quarter_turn_have_the_same_modes(torsion):
    lying = sheet(Rectangle(length=0.06, width=0.04), torsion)
    upright = sheet(Rectangle(length=0.04, width=0.06), torsion)
    for one, other in zip(lying.free_modes.modes, upright.free_modes.modes, strict=True):
        assert one.omega == pytest.approx(other.omega, rel=1e-9, abs=1e-6)
        assert one.name == other.name
    assert lying.natural_frequency == pytest.approx(upright.natural_frequency, rel=1e-9)
    # Its lengthwise bending is as much a dish as a saddle; a beam of the same length rings at the same frequency.
    beam = sheet(Rectangle(length=0.06, width=0.01), 0.0).replace(mass=0.01 / 4).free_modes.modes[0]
    assert lying.natural_frequency == pytest.approx(beam.omega, rel=1e-9)


@pytest.mark.parametrize("name", [n for n in OUTLINES if n not in ("four nodes", "three nodes", "a node")])
def test_every_sheet_that_bends_has_a_natural_frequency(name):
    for torsion in (0.0, 1e-6, 1e-4):
        s = sheet(OUTLINES[name], torsion)
        omega = s.natural_frequency
        assert omega > 0
        assert s.with_natural_frequency(2 * omega).natural_frequency == pytest.approx(2 * omega, rel=1e-9)
        assert omega in [m.omega for m in s.free_modes.modes if m.name != "twist"]


def test_a_limp_sheet_has_modes_without_frequency():
    limp = sheet(OUTLINES["square"], 0.0, bending=0.0)
    assert {m.omega for m in limp.free_modes.modes} == {0.0}
    assert len(limp.free_modes.modes) == 33
    assert {m.name for m in limp.free_modes.modes} == {"dish", "saddle", "twist", ""}
    assert math.isfinite(sum(m.shape.sum() for m in limp.free_modes.modes))
