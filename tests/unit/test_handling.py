"""What differs from point to point of a measurement, and what the curve's file tells of it."""

from __future__ import annotations

import math
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from plategait.curve.curve import Curve
from plategait.curve.curve_file import read_curve, write_curve
from plategait.curve.protocol import USUAL, measured_as
from plategait.errors import InputError
from plategait.estimate import runs as runs_module
from plategait.estimate.emulator import fit_run_off
from plategait.estimate.handling import OFFSET, SLOWEST_RAMP, Handling, handling_of
from plategait.estimate.observations import Condition, observe_curves
from plategait.estimate.result import estimate_parameters
from plategait.estimate.runs import run_engine
from plategait.estimate.unknowns import unknowns
from plategait.model.presets import preset
from plategait.vision.folder import Clip, curve_of_clips

pytestmark = pytest.mark.linear_algebra

CHEESE = measured_as(preset("cheese").scenario)
TWO = unknowns(CHEESE, fixed=("natural_frequency", "bending_damping", "plate_height"))


def test_each_point_is_laid_down_anew_and_each_object_has_one_plate():
    drawn = Handling().drawn(300, 4, np.random.default_rng(0))
    x = np.array([d["start.x"] for d in drawn])
    assert len(np.unique(x)) == 1200
    assert x.std() == pytest.approx(OFFSET, rel=0.07)  # three standard errors of 1200
    ramps = np.array([d["motion.ramp"] for d in drawn]).reshape(300, 4)
    assert (ramps == ramps[:, :1]).all()
    assert ramps.min() >= 0
    assert 0.9 * SLOWEST_RAMP < ramps.max() <= SLOWEST_RAMP


def test_a_ramp_that_is_told_is_used():
    assert {d["motion.ramp"] for d in Handling(ramp=0.2).drawn(3, 2, np.random.default_rng(0))} == {0.2}


@pytest.mark.parametrize(("ramp", "low", "high"), [(None, 0.6, 1.2), (0.1, 0.2, 0.35)])
def test_how_sharp_the_run_off_is_follows_from_what_is_not_known(monkeypatch, ramp, low, high):
    """An object that runs off 10 Hz later for each second of ramp: 3 Hz, evenly spread, have an sd of 0.87 Hz."""

    def seen(scenario, _recording, _names):
        failed = scenario.motion.frequency > 20 + 10 * scenario.motion.ramp
        return SimpleNamespace(spin=SimpleNamespace(rate=1.0), failure="slipped" if failed else None, values={})

    monkeypatch.setattr(runs_module, "engine", lambda _: SimpleNamespace(run=lambda runs, **_: runs))
    monkeypatch.setattr(runs_module, "glance", seen)
    conditions = [Condition(0.05, 0.003, f) for f in np.arange(19, 25, 0.25).tolist()]
    u = np.random.default_rng(0).random((80, 2))
    runs = run_engine(TWO, u, conditions, handling=Handling(ramp=ramp), seed=1)
    run_off = fit_run_off(u, *runs.brackets(conditions[0].amplitude), np.ones(80, bool))
    assert run_off is not None
    # With the ramp told it is the least that is claimed, 1 % of the frequency. Ten coefficients learnt of eighty runs
    # take a little of the scatter for their own.
    assert low < run_off.width < high


def curve(**told) -> Curve:
    f = np.array([14.0, 18.0, 22.0])
    return Curve("c", f, 10 * f, np.full(3, math.nan), ("",) * 3, ("",) * 3, **told)


def test_a_file_keeps_how_each_point_was_measured(tmp_path):
    told = curve(duration=np.array([1.0, 3.0, math.nan]), slip_limit=np.full(3, 0.015))
    write_curve(told, tmp_path / "c.csv")
    assert "duration_s,slip_limit_mm" in (tmp_path / "c.csv").read_text(encoding="utf-8").splitlines()[0]
    back = read_curve(tmp_path / "c.csv")
    np.testing.assert_allclose(np.array(back.duration), [1.0, 3.0, math.nan])
    np.testing.assert_allclose(np.array(back.slip_limit), 0.015)
    assert not back.notes


@pytest.mark.parametrize("cell", ["0", "-1", "long"])
def test_a_duration_that_is_none_is_refused(tmp_path, cell):
    (tmp_path / "c.csv").write_text(f"frequency_hz,spin_rate_deg_s,duration_s\n14,140,2\n18,180,{cell}\n")
    with pytest.raises(InputError, match="duration"):
        read_curve(tmp_path / "c.csv")


def test_points_run_as_long_as_they_were_observed():
    data = observe_curves([curve(duration=np.array([0.966, 0.98, math.nan]), slip_limit=np.full(3, 0.015))],
                          [CHEESE.motion])  # fmt: skip
    assert [c.duration for c in data.conditions] == [0.97, 0.98, 0.0]
    first, last = (data.conditions[i].applied(CHEESE) for i in (0, 2))
    assert (first.duration, first.measured_from, first.slip_limit) == (0.97, 0.485, 0.015)
    assert (last.duration, last.slip_limit) == (CHEESE.duration, 0.015)
    assert Condition(0.05, 0.003, 20.0).applied(CHEESE).duration == CHEESE.duration


def test_an_estimate_takes_the_duration_of_the_film(monkeypatch):
    seen = []

    def stop(unknowns, u, conditions, **_):
        seen.append(unknowns.base)
        raise KeyboardInterrupt

    monkeypatch.setattr("plategait.estimate.posterior.run_engine", stop)
    for told in (curve(duration=np.full(3, 1.03)), curve()):
        with pytest.raises(KeyboardInterrupt):
            estimate_parameters(told, CHEESE)
    assert [(s.duration, s.measured_from) for s in seen] == [(1.0, 0.5), (CHEESE.duration, CHEESE.measured_from)]
    with pytest.raises(InputError, match="ramp"):
        estimate_parameters(curve(), CHEESE, ramp=-0.1)


def test_clips_tell_how_long_they_are():
    spin = SimpleNamespace(rate=1.0, low=0.9, high=1.1, reason="")
    unknown = SimpleNamespace(x=math.nan, y=math.nan, x_half=math.nan, y_half=math.nan)
    nothing = (math.nan, math.nan)
    seen = SimpleNamespace(velocity=unknown, rim_lift=nothing, radius=nothing, area=nothing)
    track = SimpleNamespace(
        spin=spin, drift=0.0, time=np.linspace(0.5, 1.5, 31), failure="", findings=seen, true_to_scale=True
    )
    clips = [Clip(Path("a.mp4"), 14.0, "given", track), Clip(Path("b.mp4"), 16.0, "given", None, "dark")]  # pyright: ignore[reportArgumentType]
    of_clips = curve_of_clips(clips, "clips")
    np.testing.assert_allclose(np.array(of_clips.duration), [1.0, math.nan])
    assert (np.array(of_clips.slip_limit) == USUAL.slip_limit).all()


def test_friction_cannot_scatter_about_an_angle_that_is_not_sought():
    assert handling_of(None, "3 deg", ()).friction_scatter == pytest.approx(math.radians(3))
    with pytest.raises(InputError, match="friction_scatter"):
        handling_of(None, "3 deg", ("friction_angle",))
    with pytest.raises(InputError, match="friction_scatter"):
        handling_of(None, "-3 deg", ())
