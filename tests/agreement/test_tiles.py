"""The lattice against an independent second opinion: rigid tiles hinged at their edges, in plain NumPy."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from plategait.engine.recording import RunRequest
from plategait.engine.tile_group import tile_model
from plategait.engine.tile_runs import run
from plategait.engine.tiles import stable_step, tile_modes
from plategait.errors import InputError
from plategait.model.motion import Samples, Wave
from plategait.model.presets import preset
from plategait.model.scenario import Plate
from plategait.simulation.run import simulate, simulate_all

CHEESE = preset("cheese").scenario
LATTICE = CHEESE.sheet.lattice
SHORT = CHEESE.replace(duration=0.02)


def test_the_dissertation_draws_88_joints_between_52_tiles():
    assert len(LATTICE.rest) == 52
    assert len(LATTICE.axial_edges) == 88


@pytest.mark.parametrize("torsion", [0.0, 1.0])
@pytest.mark.parametrize("name", ["saddle", "dish"])
def test_modes_agree(name, torsion):
    # Two discretisations of one plate: 88 edge hinges with all rotary inertia against 72 node hinges without, torsion
    # free or as stiff as bending. Their difference is of the order of (l/R)²: 4 % measured.
    sheet = CHEESE.sheet.replace(torsion_stiffness=torsion * CHEESE.sheet.bending_stiffness)
    model = replace(tile_model([RunRequest(CHEESE.replace(sheet=sheet))]), rotary_inertia=1.0)
    frequency, shapes = tile_modes(model)
    mode = getattr(sheet.free_modes, name)
    alike = np.abs(shapes @ mode.shape) / np.linalg.norm(shapes, axis=1).clip(1e-9) / np.linalg.norm(mode.shape)
    assert alike.max() > 0.98
    assert frequency[np.argmax(alike)] == pytest.approx(mode.omega, rel=0.05)


@pytest.fixture(scope="module")
def curves():
    """Both engines from sliding to the walking peak: 10 s of tiles, which cannot be had for less."""
    changes = {"duration": 0.3, "transient": 0.15}
    scenarios = [CHEESE.replace(**{"motion.frequency": f, **changes}) for f in (14.0, 18.0, 22.0)]
    return simulate_all(scenarios, engine="tiles"), simulate_all(scenarios)


def test_spin_curves_agree(curves):
    # Tiles of a quarter of their rotary inertia, which (3.3) does not have at all, and the lattice. Halving the tiles'
    # step moves their rates by less than 2 %; the models differ by up to 5 %.
    by_tiles, by_lattice = ([s.spin_rate for s in simulations] for simulations in curves)
    np.testing.assert_allclose(by_tiles, by_lattice, rtol=0.07)
    assert by_lattice[-1] > 5 * by_lattice[0] > 0, "the comparison spans the rise of the curve"


def test_what_the_plate_gives_goes_the_same_ways(curves):
    for tiles, lattice in zip(*curves, strict=True):
        ours, theirs = (s.observations[0].energy for s in (tiles, lattice))
        # Tiles reckon work by the velocity midway in a step: their books close to what rotation leaves, 1e-5.
        assert ours.imbalance < 1e-4
        # As far apart as the spin rates; the small losses twice that.
        assert ours.given == pytest.approx(theirs.given, rel=0.1)
        assert ours.friction_loss == pytest.approx(theirs.friction_loss, rel=0.1)
        assert ours.joint_loss == pytest.approx(theirs.joint_loss, rel=0.3)
        assert ours.contact_loss == pytest.approx(theirs.contact_loss, rel=0.2)


def test_tiles_conserve_what_joints_must():
    # In free fall, with no plate in reach, joints neither push nor turn the sheet as a whole, and never give energy.
    rng = np.random.default_rng(5)
    at = np.column_stack([LATTICE.rest * CHEESE.sheet.pitch, np.ones(52)]) + rng.normal(0, 2e-4, (52, 3))
    changes = {"sheet.torsion_stiffness": 1e-4, "motion.angle": 0.0, "motion.stroke": 0.0, "gravity": 1e-12}
    scenario = SHORT.replace(**changes)
    (recording,) = run([RunRequest(scenario, initial=(at, np.zeros_like(at)))])
    for axis in "xyz":
        np.testing.assert_allclose(np.ptp(recording[f"centre_{axis}"]), 0, atol=1e-12)
    assert not recording.diverged
    assert np.abs(recording.positions - at).max() > 1e-5, "it does ring"
    stored = sum(recording[f"{kind}_energy"] for kind in ("kinetic", "axial", "bending", "torsion"))
    np.testing.assert_allclose(stored[0] - stored, np.cumsum(recording["joint_loss"]), atol=2e-2 * stored[0])
    assert stored[-1] < 0.9 * stored[0]


def test_runs_of_any_kind_come_back_in_their_order():
    # Other sheets, steps, samples and lengths; to rounding the same as each by itself.
    others = [preset("pancake").scenario.replace(duration=0.01), SHORT.replace(**{"motion.frequency": 40.0}), SHORT]
    runs = [RunRequest(s, offset=(1e-4, 0, 0.02), snapshot_interval=5e-3) for s in others]
    together = run(runs)
    for one, recording in zip(runs, together, strict=True):
        (alone,) = run([one])
        assert len(recording["time"]) == one.samples
        assert len(recording.snapshots) == len(recording.plate_pose) == one.pictures
        for name in recording.channels:
            np.testing.assert_allclose(recording[name], alone[name], rtol=1e-6, atol=1e-12, err_msg=name)


@pytest.mark.parametrize("name", ["cheese", "cheese-as-printed", "pancake", "rigid-twin", "dumpling-skin"])
def test_the_stable_step_is_the_longest_at_which_a_sheet_comes_to_rest(name):
    scenario = preset(name).scenario
    model = tile_model([RunRequest(scenario)])
    # Stiffness and damping that grow shorten it; the shear penalty of 8 k_c leaves it far below the lattice's own.
    stiffer = tile_model(
        [RunRequest(scenario.replace(**{"sheet.axial_stiffness": 4 * scenario.sheet.axial_stiffness}))]
    )
    assert stable_step(stiffer) < stable_step(model) < scenario.sheet.stable_time_step


@pytest.mark.parametrize(
    ("change", "field"),
    [
        ({"plate": Plate()}, "plate"),
        ({"motion.waves": (Wave(axis="z", amplitude=1e-3),)}, "motion.waves"),
        ({"motion.samples": Samples(time=(0.0, 0.1), x=(0.0, 1e-3))}, "motion.samples"),
        ({"sheet.shear_ratio": 4.0}, "sheet.shear_ratio"),
    ],
)
def test_what_tiles_cannot_do_is_refused(change, field):
    with pytest.raises(InputError, match=r'"tiles".*"cpu"') as refused:
        simulate(SHORT.replace(**change), engine="tiles")
    assert refused.value.field == field


def test_held_nodes_are_refused():
    with pytest.raises(InputError, match="held"):
        run([RunRequest(SHORT, held=np.arange(52) < 4)])
