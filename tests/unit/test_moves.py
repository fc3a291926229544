"""The atlas of what an object does: mirrors, cells and certainty against closed forms, a small one of the engine."""

import json
import math
from types import SimpleNamespace

import numpy as np
import pytest
from legible import assert_legible

from plategait import InputError, PlateMotion, preset
from plategait.model.machine import MACHINES, Machine
from plategait.moves import atlas as making
from plategait.moves.atlas import anywhere, atlas, prepared
from plategait.moves.cells import Archive, cell_of, quality
from plategait.moves.certainty import CHI2, covariance, distances_left_out, widening
from plategait.moves.figures import plot_atlas
from plategait.moves.primitives import candidates, in_turn
from plategait.moves.report import motion_fields, reached_in, summary
from plategait.moves.settling import settling_time
from plategait.moves.vary import children
from plategait.optimize.space import freedoms_of, space_of
from plategait.optimize.spread import scattered
from plategait.optimize.symmetry import mirrored
from plategait.optimize.trials import Trial
from plategait.simulation.run import simulate_all

SIZES = np.array([50e-3, 20e-3, math.radians(100)])
ROBOT = MACHINES["source-robot"]
CHEESE = preset("cheese").scenario


def space(machine=ROBOT):
    return space_of(CHEESE.motion, machine, {}, freedoms_of(machine), both_ways=True)


def trial(twists, acceleration=10.0, failed=0):
    """Trial of runs with these velocities."""
    n = len(twists)
    rows = np.column_stack([twists, np.full(n, 0.1), np.ones(n), np.zeros(n)])
    rows[:failed, -1] = 1
    costs = {"acceleration": acceleration, "torque": 0.0, "power": 0.0}
    return Trial(np.zeros(3), CHEESE.motion, costs, rows)


def test_each_machine_frees_what_it_moves():
    assert freedoms_of(ROBOT) == ("phase", "harmonics", "offset")
    assert freedoms_of(MACHINES["planar"]) == ("harmonics", "y", "rz")
    assert freedoms_of(MACHINES["six-axis"]) == ("phase", "harmonics", "offset", "y", "z", "ry", "rz")


@pytest.mark.parametrize(("machine", "signs"), [
    ("source-robot", [(1, -1, -1), (-1, 1, -1)]),
    # In its plane a plate drags the sheet along, which takes longer to forget its start than these runs are.
    ("planar", [(1, -1, -1)]),
])  # fmt: skip
def test_mirrored_motions_carry_a_disk_the_mirrored_way(machine, signs):
    """In exact arithmetic: a mirror image of the plate's motion moves the mirror image of the sheet."""
    over = space(MACHINES[machine])
    shares = scattered(over, 16, seed=3)
    images = np.concatenate([shares[None], mirrored(over, shares)])
    scenario = CHEESE.replace(duration=0.4, transient=0.1, slip_limit=10.0)
    motions = [over.at(row) for row in images.reshape(-1, shares.shape[1])]
    runs = simulate_all([scenario.replace(motion=motion.replace(ramp=0.03)) for motion in motions], engine="cpu64")
    twists = np.array([run.twist for run in runs]).reshape(3, len(shares), 3)
    scale = np.nanmax(np.abs(twists[0]), axis=0)
    # The image along the bar starts half a period later, and wild motions are chaotic: half of them stay together.
    for image, turned in enumerate(signs, start=1):
        assert np.nanmedian(np.abs(twists[image] * turned - twists[0]) / scale) < 0.02
        off = np.nanmean(np.abs(twists[image] - twists[0]) / scale, axis=0)
        assert (off[np.array(turned) < 0] > 0.2).all()


def test_children_stay_within_the_ranges_and_near_their_parents():
    over = space()
    parents = scattered(over, 16, seed=0)
    made = children(over, parents, 400, np.random.default_rng(0))
    assert made.min() >= 0
    assert made.max() <= 1
    steps = [i for i, v in enumerate(over.variables) if v.steps]
    assert set(np.unique(made[:, steps])) <= set(np.unique(np.concatenate([parents, 1 - parents])[:, steps]))


def test_an_archive_keeps_the_least_effort_and_spread_of_each_cell():
    archive, still = Archive(SIZES), np.zeros((2, 3))
    heavy, light, spread_out = (
        trial(still, 40.0),
        trial(still, 10.0),
        trial([[0.01, 0, 0], [-0.01, 0, 0]], 10.0),
    )
    lost = trial(still, 1.0, failed=1)
    assert archive.add([heavy, spread_out, light, lost]) == 1
    assert archive.best[0, 0, 0] == [light, spread_out, heavy]
    assert quality(lost, SIZES) == math.inf
    assert cell_of(np.array([0.12, -0.031, 2.0]), SIZES) == (2, -2, 1)


def test_the_regions_hold_what_they_say_of_normal_velocities():
    """From 12 starts each, 400 motions: 90 % of fresh runs, within what 400 × 4 of them can tell."""
    rng = np.random.default_rng(1)
    scale = np.diag([0.01, 0.004, 0.3]) @ (np.eye(3) + 0.5)
    runs = rng.normal(size=(400, 16, 3)) @ scale.T
    known = [trial(each[:12]) for each in runs]
    wide = widening(known, SIZES)
    inside = []
    for each, one in zip(runs, known, strict=True):
        off = each[12:] - one.twist
        inside += (
            np.einsum("ij,jk,ik->i", off, np.linalg.inv(wide * covariance(one.twists, SIZES)), off) < CHI2
        ).tolist()
    assert 0.87 < np.mean(inside) < 0.93
    assert len(distances_left_out(known[0].twists, SIZES)) == 12


def test_primitives_go_the_right_way_for_sure():
    rng = np.random.default_rng(0)
    fast = trial([0.2, 0, 0] + 0.003 * rng.normal(size=(12, 3)))
    turning = trial([0.2, 0, 3.0] + 0.003 * rng.normal(size=(12, 3)))
    unsure = trial([0.4, 0, 0] + np.array([0.3, 0, 0]) * rng.normal(size=(12, 1)))
    assert candidates([turning, fast], SIZES)["forward"][0] is fast
    assert candidates([fast], SIZES)["back"] == []
    assert in_turn("forward", [unsure, turning, fast], SIZES) == [fast, turning]
    assert in_turn("back", [fast], SIZES) == []


@pytest.fixture(scope="module")
def small():
    """An atlas of two generations of 16 motions, runs of 0.4 s (a second or two)."""
    with pytest.MonkeyPatch.context() as patched:
        for name, value in (("POPULATION", 16), ("_FIRST", 48), ("VERIFIED", 8), ("CONFIRMED", 6)):
            patched.setattr(making, name, value)
        yield atlas(duration=0.4, generations=2), patched


def test_a_small_atlas_of_the_engine_tells_velocities_and_motions(small, tmp_path):
    made, _ = small
    told = json.loads(json.dumps(summary(made), allow_nan=False))
    assert len(told["cells"]) == len(made.cells) > 10
    for cell, trial in zip(told["cells"], made.cells.values(), strict=True):
        assert PlateMotion(**cell["motion"]) == trial.motion
        assert np.linalg.eigvalsh(cell["covariance"]).min() > 0
        assert 0 < cell["chance_of_failure"] < 0.5
    hold = told["primitives"][-1]
    assert hold["name"] == "hold"
    assert np.abs(hold["velocity_mm_s"]).max() < 0.1
    (tmp_path / "atlas.json").write_text(json.dumps(told))
    machine, twists = reached_in(tmp_path / "atlas.json")
    assert machine == "source-robot"
    figure = plot_atlas(made, [(machine, twists)])
    assert len(figure.axes) == 4
    assert_legible(figure)
    numbered = " ".join(text.get_text() for text in figure.axes[0].texts if text.get_gid() == "primitives").split()
    assert sorted(map(int, numbered)) == list(range(1, 1 + len(made.primitives))), "each primitive once"
    assert f"{len(made.primitives)} hold" in figure.get_suptitle()


def test_a_store_goes_on_where_it_was_and_ends_with_the_same_bits(small, tmp_path):
    made, _ = small
    first = atlas(duration=0.4, generations=2, store=tmp_path / "store")
    lines = (tmp_path / "store" / "runs.jsonl").read_bytes().splitlines(keepends=True)
    (tmp_path / "store" / "runs.jsonl").write_bytes(b"".join(lines[:3]) + lines[3][:40])
    again = atlas(duration=0.4, generations=2, store=tmp_path / "store")
    assert json.dumps(summary(again)) == json.dumps(summary(first)) == json.dumps(summary(made))


@pytest.mark.slow
def test_a_dask_cluster_makes_the_same_atlas(small):
    distributed = pytest.importorskip("distributed")
    made, _ = small
    # Threads of this process, which pickle what they send all the same.
    options = {"n_workers": 2, "threads_per_worker": 1, "processes": False, "protocol": "tcp://"}
    with (
        distributed.LocalCluster(**options, dashboard_address=None) as workers,
        distributed.Client(workers) as client,
    ):
        spread = atlas(duration=0.4, generations=2, dask=client)
    assert json.dumps(summary(spread)) == json.dumps(summary(made))


def test_poses_fill_the_plate():
    poses = np.array(anywhere(0.02)(200, 5))
    assert np.abs(poses[:, :2]).max() <= 0.02
    assert np.ptp(poses, axis=0) == pytest.approx([0.04, 0.04, math.tau], rel=0.05)


@pytest.mark.parametrize(
    ("wrong", "match"),
    [
        (lambda: prepared(CHEESE.replace(plate={"length": "100 mm", "width": "100 mm"}), 3.0, 0.02), "reach \"10 mm\""),
        (lambda: prepared(CHEESE, 3.0, -1.0), "reach"),
        (lambda: atlas(cell=(0.0, 1.0, 1.0)), "cell_along"),
        (lambda: atlas(generations=0), "generations"),
        (lambda: atlas(machine=Machine(x={"stroke": "3 mm"}, frequency="40 Hz"), free=("offset",)), "hold the plate"),
    ],
)  # fmt: skip
def test_what_cannot_be_is_refused_with_what_to_change(wrong, match):
    with pytest.raises(InputError, match=match):
        wrong()


def test_fields_of_a_motion_make_it_again():
    motion = PlateMotion(frequency=20.0, offset={"rx": "2 deg"}, waves=[{"axis": "x", "amplitude": "1 mm", "ratio": 2}])
    assert PlateMotion(**json.loads(json.dumps(motion_fields(motion)))) == motion


def test_a_run_settles_when_it_moves_as_it_will():
    """After 0.4 s at rest, from a standstill to 1 rad/s at once: half a window early or late."""
    time = np.linspace(0, 2, 2001)
    angle = np.maximum(time - 0.4, 0)
    channels = {"time": time, "centre_x": 0 * time, "centre_y": 0 * time,
                "spin_cross": np.sin(angle), "spin_dot": np.cos(angle)}  # fmt: skip
    observed = {"velocity_x": 0.0, "velocity_y": 0.0}

    class Observed(dict):
        spin = SimpleNamespace(rate=1.0)

    run = SimpleNamespace(recordings=[SimpleNamespace(channels=channels)], scenario=CHEESE,
                          observations=[Observed(observed)])  # fmt: skip
    assert settling_time(run) == pytest.approx(0.4, abs=0.07)
