"""Estimates of many objects: the same one by one, on a cluster and after a kill, and no failure is hidden."""

from __future__ import annotations

import csv
import io
import math

import pytest

from plategait.campaign.journal import NAME
from plategait.collection import collection as collecting
from plategait.collection.collection import estimate_all
from plategait.collection.one import Asked, estimated
from plategait.collection.table import as_csv
from plategait.curve.protocol import measured_as
from plategait.errors import InputError
from plategait.estimate.result import estimate_parameters
from plategait.model.fragment import read_fragment
from plategait.model.presets import preset

CHEESE = preset("cheese").scenario
LINEAR = Asked(CHEESE, method="linear")
# The least that a posterior takes: three rates, one unknown, a model that is right.
LEAST = Asked(
    measured_as(CHEESE).replace(duration=0.6, transient=0.2),
    options={"noise": 0.1, "friction_ratio": 0.53, "model_error": 0, "seed": 3,
             "fixed": ("natural_frequency", "bending_damping", "plate_height")},
)  # fmt: skip


def lorentzian(f0: float, ratio: float) -> str:
    rows = [f"{f},{520 / (1 + ((f - f0) / (ratio * f0)) ** 2):.6g}" for f in range(14, 31)]
    return "\n".join(["frequency_hz,spin_rate_deg_s", *rows])


@pytest.fixture
def paths(tmp_path):
    """Three objects with a peak, one without, one that is no curve, and one in a folder."""
    folder = tmp_path / "objects"
    folder.mkdir()
    for name, f0 in (("soft", 24.0), ("middle", 25.0), ("hard", 26.5)):
        (folder / f"{name}.csv").write_text(lorentzian(f0, 0.208))
    (folder / "rising.csv").write_text("frequency_hz,spin_rate_deg_s\n14,10\n16,20\n18,30\n20,40\n")
    (folder / "broken.csv").write_text("frequency_hz,spin_rate_deg_s\n14,ten\n")
    (folder / "inside").mkdir()
    (folder / "inside" / "a.csv").write_text(lorentzian(25.5, 0.2))
    return [folder / name for name in ("soft.csv", "broken.csv", "middle.csv", "rising.csv", "gone.csv", "inside",
                                       "hard.csv")]  # fmt: skip


def told(outcomes):
    return [outcome.plain | {"fragment": outcome.fragment} for outcome in outcomes]


def test_each_is_what_it_is_alone_and_what_fails_says_why(paths):
    outcomes = estimate_all(paths, LINEAR)
    assert [o.item.name for o in outcomes] == ["soft", "broken", "middle", "rising", "gone", "inside", "hard"]
    assert [bool(o.failure) for o in outcomes] == [False, True, False, True, True, False, False]
    assert "line 2" in outcomes[1].failure
    assert "without a Lorentz fit" in outcomes[3].failure
    assert "gone.csv" in outcomes[4].failure
    for outcome in outcomes:
        if not outcome.failure:
            assert estimated(outcome.item, LINEAR)["summary"] == outcome.summary
    # (5.6) at f0 = 25 Hz, which an exact Lorentzian gives back to the six digits that were written.
    assert outcomes[2].summary["parameters"]["natural_frequency"]["median"] == pytest.approx(5.30 * 25 - 121.62, 0.01)


def test_the_table_has_a_row_for_each_and_a_cell_for_what_is_known(paths):
    rows = list(csv.DictReader(io.StringIO(as_csv(estimate_all(paths, LINEAR)))))
    assert [row["object"] for row in rows] == ["soft", "broken", "middle", "rising", "gone", "inside", "hard"]
    for row in rows:
        assert (row["natural_frequency_pi_rad_s"] == "") == bool(row["failure"])
        assert row["answered"] == ("no" if row["failure"] else "yes")
    omega = [float(rows[i]["natural_frequency_pi_rad_s"]) for i in (0, 2, 6)]
    assert omega == sorted(omega)
    assert math.isfinite(float(rows[0]["friction_angle_sd_deg"]))


def test_killed_anywhere_it_goes_on_with_what_is_left(paths, tmp_path, monkeypatch):
    whole, store = told(estimate_all(paths, LINEAR)), tmp_path / "store"
    made = []

    def dies(item, *given):
        made.append(item.name)
        if len(made) == 3:
            raise KeyboardInterrupt
        return estimated(item, *given)

    monkeypatch.setattr(collecting, "estimated", dies)
    with pytest.raises(KeyboardInterrupt):
        estimate_all(paths, LINEAR, store=store)
    with open(store / NAME, "ab") as file:
        file.write(b"half a li")  # what a kill leaves of a line
    assert told(estimate_all(paths, LINEAR, store=store)) == whole
    # Two were kept, and the one that was under way is made again.
    assert made == ["soft", "middle", "rising", "rising", "inside", "hard"]
    assert told(estimate_all(paths[::-1], LINEAR, store=store)) == whole[::-1]
    assert len(made) == 6
    with pytest.raises(InputError, match="of another collection"):
        estimate_all(paths, Asked(CHEESE, method="linear", coefficients="refitted"), store=store)


def test_an_object_whose_file_has_changed_is_estimated_again(paths, tmp_path):
    store = tmp_path / "store"
    before = estimate_all(paths[:1], LINEAR, store=store)
    paths[0].write_text(lorentzian(26.0, 0.208))
    after = estimate_all(paths[:1], LINEAR, store=store)
    assert told(after) == told(estimate_all(paths[:1], LINEAR)) != told(before)


def test_a_fault_costs_one_object_and_is_not_kept(paths, tmp_path, monkeypatch):
    whole = told(estimate_all(paths, LINEAR))

    def faulty(curves, *rest):
        if curves[0].name == "middle":
            raise ZeroDivisionError("of all things")
        return real(curves, *rest)

    real = collecting.estimated.__globals__["estimate_directly"]
    monkeypatch.setattr("plategait.collection.one.estimate_directly", faulty)
    outcomes = estimate_all(paths, LINEAR, store=tmp_path / "store")
    assert "ZeroDivisionError: of all things" in outcomes[2].failure
    assert [o["failure"] for i, o in enumerate(told(outcomes)) if i != 2] == [
        o["failure"] for i, o in enumerate(whole) if i != 2
    ]
    monkeypatch.undo()
    assert told(estimate_all(paths, LINEAR, store=tmp_path / "store")) == whole


@pytest.mark.slow
def test_a_cluster_gives_the_same_as_this_machine_and_as_each_alone(tmp_path):
    distributed = pytest.importorskip("distributed")
    for name, factor in (("a", 1.0), ("b", 0.95)):
        rows = [f"{f},{factor * rate:.6g}" for f, rate in ((14, 61), (17.5, 160), (20, 350))]
        (tmp_path / f"{name}.csv").write_text("\n".join(["frequency_hz,spin_rate_deg_s", *rows]))
    (tmp_path / "two.csv").write_text("frequency_hz,spin_rate_deg_s\n14,50\n15,60\n")
    paths = [tmp_path / f"{name}.csv" for name in ("a", "two", "b")]
    # Threads of this process, which pickle what they send all the same.
    with (
        distributed.LocalCluster(
            processes=False, protocol="tcp://", n_workers=2, threads_per_worker=1, dashboard_address=None
        ) as workers,
        distributed.Client(workers) as client,
    ):
        spread = estimate_all(paths, LEAST, dask=client, store=tmp_path / "store")
    assert "at least 3" in spread[1].failure
    # The store goes on here, and what it holds is what this machine makes.
    assert told(estimate_all(paths, LEAST, store=tmp_path / "store")) == told(spread)
    alone = estimate_parameters(paths[2], LEAST.scenario, **LEAST.options)
    assert spread[2].summary == alone.summary() | {"answered": alone.answered}
    (tmp_path / "b.toml").write_text(spread[2].fragment)
    assert read_fragment(tmp_path / "b.toml").parameters


def test_a_path_told_twice_is_refused(paths):
    with pytest.raises(InputError, match="told once"):
        estimate_all([paths[0], paths[0]], LINEAR)
