"""Runs: ensembles, statuses, summaries, labelled data, interruptions and a quick import."""

from __future__ import annotations

import json
import math
import os
import signal
import subprocess
import sys
import time
from dataclasses import replace

import numpy as np
import pytest

from plategait.curve.spin_curve import spin_curve
from plategait.errors import InputError
from plategait.model.outline import Disk, Mask
from plategait.model.presets import preset
from plategait.model.scenario import Plate, Scenario
from plategait.model.scenario_file import read_scenario
from plategait.model.sheet import Sheet
from plategait.simulation.dataset import dataset_of, write_dataset
from plategait.simulation.energy import EnergyLedger
from plategait.simulation.observables import BLOCKS, Failure, SpinRate, spin_rate
from plategait.simulation.observation import Observation, glance
from plategait.simulation.registry import all_observables
from plategait.simulation.result import Simulation
from plategait.simulation.run import START_SPREAD, START_TURN, simulate, simulate_all, starts

CHEESE = preset("cheese").scenario
SHORT = CHEESE.replace(duration=0.5)

REQUIRED = {
    "spin_rate_deg_s", "spin_rate_sd_deg_s", "settled", "gait", "failed", "failure", "failure_time_s", "drift_mm",
    "contact_fraction", "flight_fraction", "dt_s", "steps", "wall_s", "simulated_s_per_wall_s",
}  # fmt: skip


@pytest.fixture(scope="module")
def short() -> Simulation:
    return simulate(SHORT, repeats=3, seed=7, snapshot_interval=0.05)


def without_clock(summary: dict) -> dict:
    return {k: v for k, v in summary.items() if k not in ("wall_s", "simulated_s_per_wall_s")}


# Ensembles


def test_the_first_start_is_the_nominal_one():
    offsets = starts(4, 1)
    assert offsets[0] == (0, 0, 0)
    assert len(set(offsets)) == 4
    assert starts(1, 5) == [(0, 0, 0)]
    assert starts(4, 1) == offsets
    assert starts(4, 2)[1:] != offsets[1:]


def test_more_repeats_keep_the_starts_of_fewer():
    assert starts(8, 3)[:4] == starts(4, 3)


def test_the_starts_spread_as_said():
    spread = np.array(starts(4000, 0))[1:]
    # A standard deviation of 4000 draws is known to 1/√8000 = 1.1 %; four of those.
    np.testing.assert_allclose(spread.std(axis=0), [START_SPREAD, START_SPREAD, START_TURN], rtol=0.045)
    np.testing.assert_allclose(spread.mean(axis=0) / spread.std(axis=0), 0, atol=4 / math.sqrt(4000))


def test_the_first_run_of_an_ensemble_is_the_single_run(short):
    alone = simulate(SHORT)
    np.testing.assert_array_equal(short.recordings[0].positions, alone.recordings[0].positions)
    assert short.observations[0] == alone.observations[0]
    assert (short.recordings[1].positions != alone.recordings[0].positions).any()


def test_an_ensemble_gives_mean_and_spread(short):
    rates = [o.spin.rate for o in short.observations]
    assert len(rates) == 3
    assert short.spin_rate == pytest.approx(np.mean(rates), rel=1e-12)
    assert short.spin_rate_sd == pytest.approx(np.std(rates, ddof=1), rel=1e-12)
    low, high = short.spin_rate_interval
    assert low < short.spin_rate < high


def test_a_seed_makes_it_all_again(short):
    again = simulate(SHORT, repeats=3, seed=7, snapshot_interval=0.05)
    assert without_clock(again.summary()) == without_clock(short.summary())
    for a, b in zip(again.recordings, short.recordings, strict=True):
        np.testing.assert_array_equal(a.positions, b.positions)
        np.testing.assert_array_equal(a.snapshots, b.snapshots)
    other = simulate(SHORT, repeats=3, seed=8)
    assert other.seed == 8
    assert (other.recordings[1].positions != short.recordings[1].positions).any()


@pytest.mark.parametrize("slip_limit", ["20 mm", "0.5 mm"])
def test_a_glance_sees_what_a_long_look_sees(slip_limit):
    run = simulate(SHORT.replace(slip_limit=slip_limit))
    seen, looked = glance(run.scenario, run.recordings[0], ["rim_lift", "drift"]), run.observations[0]
    assert (looked.failure is None) == (slip_limit == "20 mm")
    assert (seen.spin, seen.failure) == (looked.spin, looked.failure)
    assert seen.values == {name: looked[name] for name in ("rim_lift", "drift")}


def test_scenarios_run_together_as_they_run_alone():
    scenarios = [SHORT, SHORT.replace(**{"motion.frequency": 14}), SHORT.replace(**{"sheet.pitch": 0.02}, duration=0.3)]
    together = simulate_all(scenarios, repeats=2, seed=1)
    for scenario, simulation in zip(scenarios, together, strict=True):
        assert simulation.scenario == scenario
        assert without_clock(simulation.summary()) == without_clock(simulate(scenario, repeats=2, seed=1).summary())


@pytest.mark.parametrize(
    ("options", "field"),
    [({"engine": "gpu"}, "engine"), ({"engine": None}, "engine"), ({"repeats": 0}, "repeats"),
     ({"repeats": -3}, "repeats"), ({"repeats": 2.5}, "repeats"), ({"repeats": "3"}, "repeats"),
     ({"repeats": None}, "repeats"), ({"seed": -1}, "seed"), ({"seed": 1.5}, "seed"), ({"seed": "x"}, "seed"),
     ({"snapshot_interval": math.nan}, "snapshot_interval")],
)  # fmt: skip
def test_options_out_of_range_are_refused(options, field):
    with pytest.raises(InputError) as caught:
        simulate(SHORT.replace(duration=0.01), **options)
    assert caught.value.field == field


def test_no_scenario_is_refused():
    with pytest.raises(InputError, match="at least one scenario"):
        simulate_all([])


# Statistics of an ensemble, on runs made by hand


def made(spins: list[SpinRate], failures: list[Failure | None] | None = None) -> Simulation:
    ledger = EnergyLedger(0, 0, 0, 0, 0, 0, 0, 0, given=1.0, largest_gap=0.0)
    observations = tuple(
        Observation(spin, "walking", failure, ledger, dict.fromkeys(all_observables(), 0.0))
        for spin, failure in zip(spins, failures or [None] * len(spins), strict=True)
    )
    recordings = simulate(SHORT.replace(duration=0.01)).recordings * len(spins)
    return Simulation(SHORT, recordings, observations, "cpu", 0, 0.1)


NOTHING = SpinRate(math.nan, math.nan, math.nan, False)


def test_the_interval_of_a_small_ensemble_covers_what_it_says():
    rng = np.random.default_rng(4)
    for runs in (2, 4, 8):
        base, draws, covered = made([SpinRate(0, 0, 0, True)] * runs), 1000, 0
        for _ in range(draws):
            spins = [SpinRate(r, r - 1, r + 1, True) for r in rng.normal(5, 1, runs)]
            observations = tuple(replace(o, spin=s) for o, s in zip(base.observations, spins, strict=True))
            low, high = replace(base, observations=observations).spin_rate_interval
            covered += low <= 5 <= high
        # Four standard deviations of a binomial count: 2.8 %.
        assert covered / draws == pytest.approx(0.95, abs=4 * math.sqrt(0.95 * 0.05 / draws)), f"{runs} runs"


@pytest.mark.parametrize("periods", [2, 3, 5, 8])
def test_the_spread_of_one_run_is_that_of_its_blocks(periods):
    # One rate in each period: with up to eight periods each is a block.
    period = 1 / 24
    rates = np.array([3.0, 5.0, 4.5, 2.0, 6.0, 3.5, 4.0, 5.5])[:periods]
    steps = np.repeat(rates, 24) * period / 24
    angle = np.concatenate([[0.0], np.cumsum(steps)])
    found = spin_rate(np.arange(len(angle)) * period / 24, angle, period, 0, periods * period)
    assert periods <= BLOCKS
    assert made([found]).spin_rate_sd == pytest.approx(rates.std(ddof=1), rel=1e-6)  # interpolation at the edges


def test_one_failure_in_three_does_not_count():
    good = SpinRate(2.0, 1.9, 2.1, True)
    simulation = made([good, NOTHING, SpinRate(4.0, 3.9, 4.1, True)], [None, Failure("slipped", 0.2), None])
    assert not simulation.failed
    assert simulation.failure == Failure("slipped", 0.2), "a failure in part is told all the same"
    assert not simulation.sound
    assert simulation.spin_rate == 3.0
    assert simulation.settled
    summary = simulation.summary()
    assert (summary["failed_runs"], summary["counted_runs"], summary["runs"]) == (1, 2, 3)
    assert summary["failures"] == {"slipped": 1}


def test_two_failures_in_three_do():
    simulation = made(
        [NOTHING, NOTHING, SpinRate(4.0, 3.9, 4.1, True)],
        [Failure("folded", 0.2), Failure("folded", 0.4), None],
    )
    assert simulation.failed
    assert simulation.failure == Failure("folded", pytest.approx(0.3))
    assert not simulation.settled
    assert simulation.spin_rate == 4.0, "over the run that stayed alone"
    json.dumps(simulation.summary(), allow_nan=False)


def test_a_ledger_that_does_not_close_is_not_averaged_away():
    simulation = made([SpinRate(2.0, 1.9, 2.1, True)] * 3)
    wrong = EnergyLedger(0, 0, 0, 0, 0, 0, 0, 0, given=1.0, largest_gap=0.5)
    first, *others = simulation.observations
    simulation = replace(
        simulation,
        observations=(
            replace(first, energy=wrong, values={**first.values, "energy_imbalance": wrong.imbalance}),
            *others,
        ),
    )
    assert not simulation.sound
    assert not simulation.failed
    summary = simulation.summary()
    assert (summary["energy_closed"], summary["open_ledgers"], summary["energy_imbalance"]) == (False, 1, 0.5)
    data = dataset_of(simulation)
    assert data["energy_closed"].values.tolist() == [False, True, True]
    assert data["energy_imbalance"].values.tolist() == [0.5, 0, 0]


# Statuses and summaries


def test_the_summary_has_its_keys_in_plain_json(short):
    summary = json.loads(json.dumps(short.summary(), allow_nan=False))
    assert set(summary) >= REQUIRED
    assert summary["runs"] == 3
    assert summary["seed"] == 7
    assert summary["engine"] == "cpu"
    assert summary["dt_s"] == SHORT.dt
    assert summary["steps"] == round(0.5 / SHORT.dt)
    assert summary["failed"] is False
    assert summary["failure"] is None
    assert summary["failure_time_s"] is None
    assert summary["gait"] in ("sliding", "walking", "running")
    assert 0 <= summary["flight_fraction"] <= summary["contact_fraction"] + summary["flight_fraction"] <= 2
    assert summary["wall_s"] > 0
    assert summary["simulated_s_per_wall_s"] == pytest.approx(3 * summary["steps"] * SHORT.dt / summary["wall_s"])


LIMP = Sheet(outline=Disk(radius=0.04), mass=1e-6, bending_stiffness=0, axial_stiffness=1e-3, pitch=0.02)
STATUSES = {
    "one step": SHORT.replace(duration=1e-9),
    "no whole period": SHORT.replace(duration=0.05),
    "no gravity": SHORT.replace(gravity=0),
    "no friction": SHORT.replace(**{"friction.static": 0, "friction.kinetic": 0}),
    "still plate": SHORT.replace(**{"motion.angle": 0, "motion.stroke": 0}),
    "slips at once": SHORT.replace(slip_limit=1e-6),
    "off the plate": SHORT.replace(plate=Plate(length=0.01, width=0.01), start={"x": 0.02}),
    "starts far away": SHORT.replace(start={"x": "10 m", "y": "-10 m"}),
    "thrown": SHORT.replace(**{"motion.angle": 1.5, "motion.frequency": 60}),
    "hammered": SHORT.replace(**{"motion.stroke": 1.0, "motion.frequency": 600}),
    "hard contact": SHORT.replace(**{"contact.stiffness": 1e30}),
    "heavy damping": SHORT.replace(**{"contact.damping": 1e30}),
    "hellish gravity": SHORT.replace(gravity=1e30),
    "one node": Scenario(sheet=Sheet(outline=Disk(radius=0.004), mass=1e-3, bending_stiffness=1e-4,
                                     axial_stiffness=790.0), duration=0.3),
    "limp": Scenario(sheet=LIMP, duration=0.3),
    "slow plate": SHORT.replace(**{"motion.frequency": 1e-300}),
    "slowest plate": SHORT.replace(**{"motion.frequency": 1e-320}),
}  # fmt: skip


@pytest.mark.parametrize("engine", ["cpu", "cpu64"])
@pytest.mark.parametrize("name", STATUSES)
@pytest.mark.filterwarnings("error")
def test_whatever_happens_is_a_status(name, engine):
    result = simulate(STATUSES[name], engine=engine)
    summary = json.loads(json.dumps(result.summary(), allow_nan=False))
    assert set(summary) >= REQUIRED
    if summary["failed"]:
        assert summary["spin_rate_deg_s"] is None, "what a failed run showed is no rate"
        assert 0 <= summary["failure_time_s"] <= STATUSES[name].duration
        assert summary["settled"] is False
    else:
        assert summary["failure"] is None
    for key in ("contact_fraction", "flight_fraction"):
        assert summary[key] is None or 0 <= summary[key] <= 1


def test_a_slip_is_reported_with_its_time():
    result = simulate(STATUSES["slips at once"])
    assert result.failed
    assert result.failure is not None
    assert result.failure.kind == "slipped"
    assert 0 < result.failure.time < 0.5
    assert result.summary()["failure"] == "slipped"


def test_an_object_off_the_plate_has_left_it():
    result = simulate(STATUSES["off the plate"])
    assert result.failure == Failure("left the plate", 0.0)
    assert result.summary()["spin_rate_deg_s"] is None


def test_a_plate_that_stands_still_turns_nothing():
    summary = simulate(STATUSES["still plate"]).summary()
    assert summary["gait"] == "sliding"
    assert summary["spin_rate_deg_s"] == pytest.approx(0, abs=1e-6)
    assert summary["drift_mm"] == pytest.approx(0, abs=1e-6)
    assert summary["contact_fraction"] == 1
    assert summary["flight_fraction"] == 0


def test_turning_the_motion_around_turns_the_spin_around():
    # A mirror image: the rotation of the plate reversed, the slide kept. The lattice is its own mirror image.
    scenario = CHEESE.replace(duration=1.5)
    there = simulate(scenario, engine="cpu64").spin_rate
    back = simulate(scenario.replace(**{"motion.angle": -scenario.motion.angle}), engine="cpu64").spin_rate
    assert abs(there) > math.radians(20)
    # Round-off grows in a motion that bounces, so the mirror image is not exact: a tenth is far above its scatter.
    assert back == pytest.approx(-there, rel=0.1)


# Labelled data


def test_the_dataset_has_units_runs_and_samples(short):
    data = dataset_of(short)
    assert data.sizes["run"] == 3
    assert data.sizes["time"] == len(short.recordings[0]["time"])
    assert data.sizes["node"] == 52
    for name, variable in data.variables.items():
        if variable.dtype.kind == "f" and name != "plate_pose":  # whose columns differ in unit
            assert variable.attrs["units"], name
    assert data["centre_x"].attrs["units"] == "m"
    np.testing.assert_array_equal(data["centre_x"].sel(run=1), short.recordings[1]["centre_x"])
    np.testing.assert_allclose(data["spin_rate"], [o.spin.rate for o in short.observations])
    assert data.attrs["seed"] == 7
    assert data.attrs["engine"] == "cpu"
    assert json.loads(data.attrs["summary"]) == short.summary()


def scenario_of(attributes: dict, folder) -> Scenario:
    path = folder / "from-attribute.toml"
    path.write_text(attributes["scenario"], encoding="utf-8")
    return read_scenario(path)


def test_the_dataset_says_which_scenario_it_is(short, tmp_path):
    assert scenario_of(dataset_of(short).attrs, tmp_path) == SHORT


@pytest.mark.filterwarnings("error")
def test_the_file_opens_with_xarray(short, tmp_path):
    import xarray

    path = tmp_path / "run.nc"
    write_dataset(short, path)
    assert list(tmp_path.iterdir()) == [path]
    with xarray.open_dataset(path) as data:
        xarray.testing.assert_allclose(data, dataset_of(short))
        assert data["centre_x"].attrs["units"] == "m"
        assert scenario_of(data.attrs, tmp_path) == SHORT
        assert data["gait"].values.tolist() == [o.gait for o in short.observations]


def test_runs_of_unequal_length_are_filled_up(monkeypatch):
    with monkeypatch.context() as patch:
        patch.setattr(Sheet, "stable_time_step", property(lambda sheet: 1.0))
        wild = SHORT.replace(time_step=2.2e-4)  # 1.6 times the stable one
    result = simulate(wild, repeats=3, snapshot_interval=0.01)
    lengths = [len(r["time"]) for r in result.recordings]
    assert all(r.diverged for r in result.recordings)
    data = dataset_of(result)
    assert data.sizes["time"] == max(lengths)
    for run, length in enumerate(lengths):
        assert np.isnan(data["centre_x"][run, length:]).all()
    assert json.loads(data.attrs["summary"])["failed"]


def test_the_dataset_of_a_picture_reads_back(tmp_path, monkeypatch):
    from PIL import Image

    Image.new("L", (6, 6), 0).save(tmp_path / "leaf.png")
    monkeypatch.chdir(tmp_path)
    scenario = SHORT.replace(duration=0.05, **{"sheet.outline": Mask(width_of_picture="60 mm", image="leaf.png")})
    attributes = dataset_of(simulate(scenario)).attrs
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    assert scenario_of(attributes, elsewhere).sheet.lattice.n_nodes == 36


# Interruption

LONG = CHEESE.replace(duration=1000.0)


class EnoughError(Exception):
    pass


@pytest.mark.parametrize("error", [EnoughError, KeyboardInterrupt])
@pytest.mark.parametrize("after", [0.0, 0.2])
def test_an_exception_from_the_progress_stops_the_run(error, after):
    begun = time.monotonic()

    def progress(fraction: float) -> None:
        assert 0 <= fraction <= 1
        if time.monotonic() - begun > after:
            raise error

    with pytest.raises(error):
        simulate(LONG, progress=progress)
    # Asked for about 20 times a second; the rest is for a busy machine.
    assert time.monotonic() - begun < after + 3


def test_progress_rises_to_the_end():
    seen: list[float] = []
    simulate_all([SHORT.replace(duration=2), SHORT.replace(duration=2, **{"sheet.pitch": 0.02})], progress=seen.append)
    assert seen == sorted(seen)
    assert all(0 <= f <= 1 for f in seen)
    assert seen[-1] == pytest.approx(1)


def test_a_run_after_an_interrupted_one_is_the_same(short):
    def stop(fraction: float) -> None:
        raise EnoughError

    with pytest.raises(EnoughError):
        spin_curve(LONG, [12, 24], progress=stop)
    again = simulate(SHORT, repeats=3, seed=7)
    np.testing.assert_array_equal(again.recordings[2].positions, short.recordings[2].positions)


INTERRUPTED = """
import sys, time
import plategait as pg
scenario = pg.preset("cheese").scenario.replace(duration=2000.0)
told = []
def progress(fraction):
    if not told:
        told.append(True)
        print("running", flush=True)
try:
    pg.simulate(scenario, progress=progress if "told" in sys.argv else None)
except KeyboardInterrupt:
    print("interrupted", flush=True)
    sys.exit(7)
"""


@pytest.mark.skipif(not hasattr(signal, "SIGINT") or os.name == "nt", reason="needs POSIX signals")
def test_ctrl_c_stops_a_run():
    # A suite that runs in the background passes its deaf ear for Ctrl-C on.
    process = subprocess.Popen(
        [sys.executable, "-c", INTERRUPTED, "told"], stdout=subprocess.PIPE, text=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )  # fmt: skip
    try:
        assert process.stdout is not None
        assert process.stdout.readline() == "running\n"
        begun = time.monotonic()
        process.send_signal(signal.SIGINT)
        rest, _ = process.communicate(timeout=20)
    finally:
        process.kill()
    assert rest == "interrupted\n"
    assert process.returncode == 7
    assert time.monotonic() - begun < 3  # a twentieth of a second, and a busy machine


# Import


def test_the_import_loads_nothing_heavy():
    heavy = ("scipy", "xarray", "matplotlib", "pydantic", "pint", "numpy", "lmfit", "av", "rich", "typer")
    code = f"import sys, plategait; print([m for m in {heavy!r} if m in sys.modules])"
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert found.stdout.strip() == "[]"


def test_a_first_result_needs_none_of_the_slow_libraries():
    code = (
        "import sys, plategait as pg; pg.simulate(pg.preset('cheese').scenario.replace(duration=0.01)).summary();"
        "print([m for m in ('scipy', 'xarray', 'matplotlib', 'pint', 'lmfit', 'av') if m in sys.modules])"
    )
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert found.stdout.strip() == "[]"


def test_the_commands_load_none_of_the_slow_libraries():
    slow = ("scipy", "xarray", "matplotlib", "pint", "lmfit", "av", "rich", "dask", "cma", "emcee")
    code = f"import sys, plategait.cli; print([m for m in {slow!r} if m in sys.modules])"
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert found.stdout.strip() == "[]"


def test_every_public_name_is_there():
    import plategait

    for name in plategait.__all__:
        assert getattr(plategait, name) is not None
        assert name in dir(plategait)
    with pytest.raises(AttributeError, match="nonsense"):
        _ = plategait.nonsense
