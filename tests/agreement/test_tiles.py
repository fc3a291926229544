"""The lattice against an independent second opinion: rigid tiles hinged at their edges, in plain NumPy."""

from __future__ import annotations

import math

import numpy as np
import pytest

from plategait.engine.tiles import TileModel, run_tiles, tile_modes
from plategait.observables import rotation, spin_rate
from plategait.presets import PLATE_HEIGHT, preset
from plategait.simulation import simulate_all

CHEESE = preset("cheese").scenario
LATTICE = CHEESE.sheet.lattice


def tiles(**changes) -> TileModel:
    sheet = CHEESE.sheet
    numbers = {
        "node_mass": sheet.node_mass, "k_b": sheet.bending_stiffness, "c_b": sheet.bending_damping,
        "k_c": sheet.axial_stiffness, "c_c": sheet.axial_damping,
    }  # fmt: skip
    return TileModel(LATTICE.rest, LATTICE.axial_edges, **{**numbers, **changes})


def test_the_dissertation_draws_88_joints_between_52_tiles():
    assert len(LATTICE.rest) == 52
    assert len(LATTICE.axial_edges) == 88


@pytest.mark.parametrize("name", ["saddle", "dish"])
def test_modes_agree(name):
    # Two discretisations of one plate: 88 edge hinges with rotary inertia against 72 node hinges without. Their
    # difference is of the order of (l/R)²: 4 % measured.
    frequency, shapes = tile_modes(tiles())
    mode = getattr(CHEESE.sheet.free_modes, name)
    alike = np.abs(shapes @ mode.shape) / np.linalg.norm(shapes, axis=1).clip(1e-9) / np.linalg.norm(mode.shape)
    assert alike.max() > 0.98
    assert frequency[np.argmax(alike)] == pytest.approx(mode.omega, rel=0.05)


def test_spin_curves_agree():
    # Tiles of a quarter of their rotary inertia, which (3.3) does not have at all, and the lattice, from sliding to the
    # walking peak. Halving the tiles' step moves their rates by less than 2 %; the models differ by up to 5 %.
    frequencies, duration, start = np.array([14.0, 18.0, 20.0, 22.0]), 1.2, 0.5
    recorded = run_tiles(
        tiles(rotary_inertia=0.25), CHEESE.motion.angle, CHEESE.motion.stroke, frequencies,
        mu_s=CHEESE.friction.static, mu_k=CHEESE.friction.kinetic,
        duration=duration, time_step=2e-5, plate_height=PLATE_HEIGHT,
    )  # fmt: skip
    tilt, position = recorded["plate_angle"][..., None], recorded["position"]
    x = position[..., 0] - recorded["plate_shift"][..., None]
    y = np.cos(tilt) * position[..., 1] + np.sin(tilt) * (position[..., 2] + PLATE_HEIGHT)
    x0, y0 = LATTICE.rest.T * CHEESE.sheet.pitch
    by_tiles = [
        spin_rate(
            recorded["time"], rotation(x0 @ y[i].T - y0 @ x[i].T, x0 @ x[i].T + y0 @ y[i].T), 1 / f, start, duration
        ).rate
        for i, f in enumerate(frequencies)
    ]
    runs = [CHEESE.replace(**{"motion.frequency": f, "duration": duration, "transient": start}) for f in frequencies]
    by_lattice = [s.spin_rate for s in simulate_all(runs)]
    np.testing.assert_allclose(by_tiles, by_lattice, rtol=0.07)
    assert by_lattice[-1] > 5 * by_lattice[0] > 0, "the comparison spans the rise of the curve"


def test_tiles_conserve_what_joints_must():
    # In free fall, with no plate in reach, joints neither push nor turn the sheet as a whole.
    model = tiles(k_t=1e-4)
    rng = np.random.default_rng(5)
    offset = np.column_stack([rng.normal(0, 2e-4, (52, 2)), 1.0 + rng.normal(0, 2e-4, 52)])
    recorded = run_tiles(model, 0.0, 0.0, 10.0, duration=0.02, offset=offset, gravity=0.0)
    centre = recorded["position"][0].mean(axis=1)
    np.testing.assert_allclose(centre - centre[0], 0, atol=1e-12)
    assert math.isfinite(recorded["position"].sum())
    assert np.abs(recorded["position"][0, -1] - recorded["position"][0, 0]).max() > 1e-5, "it does ring"
