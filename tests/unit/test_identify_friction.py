"""Tilts and rings that are odd, wrong or long: what is refused in one line, and what is said of the rest."""

from __future__ import annotations

import json
import math
import time as clock

import numpy as np
import pytest
import typer
from legible import assert_legible

from plategait.cli.identify.friction import friction
from plategait.cli.identify.modes import ring
from plategait.errors import InputError
from plategait.identify.friction.figures import plot_tilt
from plategait.identify.friction.recording import TiltRecording, _smoothed, read_tilt
from plategait.identify.friction.result import identify_friction
from plategait.identify.friction.synthetic import tilt_recording, write_tilt
from plategait.identify.modes.figures import plot_ring
from plategait.identify.modes.fit import identify_ring
from plategait.identify.modes.recording import RingRecording, read_ring
from plategait.identify.modes.synthetic import ring_recording, write_ring
from plategait.model.fragment import read_fragment
from plategait.model.presets import preset

CHEESE = preset("cheese").scenario.sheet
PATIENCE = 10.0  # s, for a million rows


def one(*columns):
    return identify_friction([TiltRecording("tilt", *columns)])


def notes_of(*columns):
    return "; ".join(one(*columns).trials[0].notes)


def rung(time, signal, **options):
    return identify_ring(RingRecording("ring", "deflection", time, signal), CHEESE, **options)


# Smoothing


def test_the_smoothed_angle_is_scipy_s_spline_and_a_line_stays_one():
    from scipy.interpolate import make_smoothing_spline

    draw = np.random.default_rng(1)
    time = np.sort(draw.uniform(0, 4, 200))
    angle = 0.7 * np.tanh(time) + 2e-3 * draw.standard_normal(200)
    for penalty in (1e-6, 1e-3, 1.0):
        expected = make_smoothing_spline(time, angle, lam=penalty)(time)
        np.testing.assert_allclose(_smoothed(time, angle, penalty), expected, atol=1e-9)
    # Twenty thousand rows smoothed with all that is asked for, of which scipy's loses a radian by rounding.
    time = np.linspace(0, 80, 20_000)
    line = 0.3 + 0.02 * time
    np.testing.assert_allclose(_smoothed(time, line, 250 * 20**4), line, atol=1e-6)


# Reading


@pytest.mark.parametrize(
    ("text", "field", "allowed"),
    [
        ("time_s,angle_deg\n0,1\n", "TILT.csv", "column position"),
        ("time_s,angle_mm,position_mm\n0,1,2\n", "angle", "a unit of rad"),
        ("time_s,angle_deg,position_mm\n0,1,2\n", "TILT.csv", "at least 8 rows"),
        ("time_s,angle_deg,position_mm\n" + "0,1,2\n" * 9, "time", "above that of the row before"),
        ("time_s,angle_deg,position_mm\n" + "".join(f"{i},nan,2\n" for i in range(9)), "line 2, angle", "a number"),
        ("time_s,angle,position_mm\n" + "".join(f"{i},{i},2\n" for i in range(9)), "angle", "below 90 deg"),
        ("", "TILT.csv", "column time"),
    ],
)
def test_a_tilt_that_is_none_is_refused_in_a_line(tmp_path, text, field, allowed):
    path = tmp_path / "TILT.csv"
    path.write_text(text)
    with pytest.raises(InputError) as caught:
        read_tilt(path)
    assert field in str(caught.value)
    assert allowed in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("text", "allowed"),
    [
        ("time_s\n" + "".join(f"{i}\n" for i in range(20)), "one of the columns deflection, angle, signal"),
        ("time_s,angle_deg,signal\n" + "".join(f"{i},1,2\n" for i in range(20)), "one of the columns"),
        ("time_s,deflection_deg\n" + "".join(f"{i},1\n" for i in range(20)), "a unit of m"),
        ("time_s,deflection_mm\n" + "".join(f"{i},{i if i != 7 else ''}\n" for i in range(20)), "a number"),
        ("time_s,deflection_mm\n" + "".join(f"{i},nan\n" for i in range(20)), "a number"),
        ("time_s,deflection_mm\n0,1\n", "at least 12 rows"),
    ],
)
def test_a_ring_that_is_none_is_refused_in_a_line(tmp_path, text, allowed):
    path = tmp_path / "ring.csv"
    path.write_text(text)
    with pytest.raises(InputError, match=allowed):
        read_ring(path)


def test_recordings_from_python_are_checked_too():
    t = np.arange(20.0)
    with pytest.raises(InputError, match="columns of 8 rows"):
        TiltRecording("x", t, t[:5], t)
    with pytest.raises(InputError, match="finite"):
        TiltRecording("x", t, 0 * t, np.full(20, np.nan))
    with pytest.raises(InputError, match="rising time"):
        RingRecording("x", "signal", t[::-1], t)


def test_units_of_the_headings_do_not_matter(tmp_path):
    time, angle, position = tilt_recording(0.75, 0.4, seed=1)
    write_tilt(tmp_path / "a.csv", time, angle, position)
    rows = np.stack([100 * position, 1e3 * time, angle], axis=1)
    np.savetxt(tmp_path / "b.csv", rows, delimiter=";", header="position (cm);time [ms];angle_rad", comments="")
    a, b = (identify_friction([read_tilt(tmp_path / name)]) for name in ("a.csv", "b.csv"))
    # The search for the slip time ends at steps that are small against its uncertainty: 0.03 sd apart from rounding.
    for one_of_both, other in ((a.static, b.static), (a.kinetic, b.kinetic)):
        assert one_of_both.value == pytest.approx(other.value, abs=0.1 * other.sd)


# Tilts


def test_directions_do_not_matter():
    time, angle, position = tilt_recording(0.75, 0.4, seed=1)
    values = {one(time, a * angle, b * position).static.value for a in (1, -1) for b in (1, -1)}
    assert max(values) - min(values) < 1e-12  # the same numbers with other signs


def test_no_slip_is_said_with_a_bound_for_mu_s():
    time, angle, position = tilt_recording(0.75, 0.4, seed=1)
    before = time < 3.5
    result = one(time[before], angle[before], position[before])
    assert result.static is None
    assert result.trials[0].reached == pytest.approx(angle[before].max())
    assert "mu_s is at least 0.72" in result.trials[0].notes[0]
    with pytest.raises(InputError, match="tilting further"):
        result.to_fragment()
    assert one(time, angle, np.zeros_like(time)).static is None


def test_what_moves_from_the_first_row_tells_only_mu_k():
    result = one(*tilt_recording(0.75, 0.4, rest=-0.1, travel=0.3, seed=2))
    assert result.static is None
    assert result.kinetic.low <= 0.4 <= result.kinetic.high
    assert "already moving" in "; ".join(result.trials[0].notes)


def test_a_slide_too_short_leaves_mu_k_out_and_keeps_mu_s():
    result = one(*tilt_recording(0.75, 0.4, travel=0.004, seed=2))
    assert result.kinetic is None
    assert "not determined" in "; ".join(result.trials[0].notes)
    assert result.static.value == pytest.approx(0.75, abs=5e-3)  # two rows of slide: the frame before or after
    assert list(result.to_fragment().parameters) == ["friction.static"]


def test_creep_is_flagged_and_does_not_move_the_slip():
    columns = tilt_recording(0.75, 0.4, creep=1e-3, seed=2)
    assert "creeps before it slips" in notes_of(*columns)
    assert one(*columns).static.value == pytest.approx(0.75, abs=1e-3)  # as without creep: four sds
    assert not notes_of(*tilt_recording(0.75, 0.4, seed=2))


def test_stick_and_slip_is_flagged_with_its_angles():
    t, a, s = tilt_recording(0.5, 0.3, travel=0.02, seed=3)
    u, b, r = tilt_recording(0.6, 0.3, travel=0.1, seed=4)
    columns = np.r_[t, t[-1] + 1 / 60 + u], np.r_[a, b], np.r_[s, r + 0.02]
    assert "slips again at 30.9 deg" in notes_of(*columns)
    assert one(*columns).static.value == pytest.approx(0.5, abs=2e-3)  # the first slip


def test_a_stop_or_a_bounce_at_the_end_is_no_part_of_the_slide():
    t, a, s = tilt_recording(0.75, 0.4, seed=1)
    end = int(np.argmax(s > 0.149))
    bounced = s.copy()
    bounced[end:] -= 0.03 * np.exp(-(((t[end:] - t[end] - 0.1) / 0.05) ** 2))
    for position in (s, bounced):
        result = one(t, a, position)
        assert result.kinetic.value == pytest.approx(0.4, rel=0.03)  # four sds
        assert not result.trials[0].notes


def test_a_plate_that_turns_fast_is_flagged():
    assert "too fast" in notes_of(*tilt_recording(0.75, 0.4, rate=math.radians(15), rest=1, seed=1))


def test_mu_k_is_never_above_mu_s():
    # A slide that is slower than any μ_k below μ_s would let it be: as if friction rose with speed.
    time = np.arange(0, 6, 1 / 60)
    angle = math.radians(20) + math.radians(2) * time
    position = np.where(time > 4, 0.02 * (time - 4), 0.0) + np.random.default_rng(0).normal(0, 1e-4, len(time))
    result = one(time, angle, position)
    assert result.kinetic is None or result.kinetic.value <= result.static.value
    assert "held at it" in "; ".join(result.trials[0].notes) or "do not follow" in "; ".join(result.trials[0].notes)


def test_several_tilts_give_their_mean_with_student_s_t():
    results = [one(*tilt_recording(s, 0.4, seed=i)) for i, s in enumerate((0.70, 0.75, 0.80))]
    recordings = [TiltRecording(f"{i}", *tilt_recording(s, 0.4, seed=i)) for i, s in enumerate((0.70, 0.75, 0.80))]
    mean = identify_friction(recordings)
    centres = np.array([r.static.value for r in results])
    assert mean.static.value == pytest.approx(centres.mean(), rel=1e-12)
    half = 4.302653 * centres.std(ddof=1) / math.sqrt(3)  # t of two degrees of freedom
    assert mean.static.high - mean.static.value == pytest.approx(half, rel=1e-6)
    still = np.arange(0, 4, 1 / 60)
    with_one_more = identify_friction([*recordings, TiltRecording("still", still, 0.1 * still, 0 * still)])
    assert with_one_more.static.value == pytest.approx(mean.static.value, rel=1e-12)
    assert "1 of 4 tilts show no slip" in with_one_more.notes[0]
    with pytest.raises(InputError, match="one tilt or more"):
        identify_friction([])


# Rings


@pytest.mark.linear_algebra
def test_a_signal_that_rests_or_is_noise_rings_nowhere():
    time = np.arange(0, 2, 1 / 400)
    noise = np.random.default_rng(3).normal(0, 1e-4, len(time))
    for signal in (np.zeros_like(time), np.full_like(time, 0.01), 0.01 + noise, 0.01 + 1e-3 * time + noise):
        result = rung(time, signal)
        assert result.stiffness is None
        assert result.mode_index is None
        assert "not determined" in result.notes[-1]


@pytest.mark.linear_algebra
@pytest.mark.parametrize("ratio", [1.0, 1.5, 4.0])
def test_what_settles_without_ringing_is_not_determined(ratio):
    from plategait.identify.modes.decay import mode_columns

    time = np.arange(0, 2, 1 / 400)
    noise = np.random.default_rng(5).normal(0, 5e-5, len(time))
    result = rung(time, 5e-3 * mode_columns(time, 30.0, ratio) @ [1, ratio] + noise)
    assert result.stiffness is None
    assert "no ringing" in result.notes[-1]
    with pytest.raises(InputError, match="a recording that rings"):
        result.to_fragment()


def test_slow_cameras_are_warned_of_folded_frequencies():
    assert any("folded" in n for n in rung(*ring_recording([12], [0.02], rate=30, duration=2)).notes)
    assert not rung(*ring_recording([5], [0.02], rate=30, duration=2)).notes


def test_rows_before_the_release_are_left_out_when_told():
    time, y = ring_recording([5], [0.03], seed=1)
    held = np.arange(-0.4, 0, 1 / 400)
    time, y = np.r_[held, time], np.r_[np.full(len(held), y[0]), y]
    windowed = rung(time, y, start=0.0)
    assert windowed.mode.omega.low <= 10 * math.pi <= windowed.mode.omega.high
    assert any("--from" in n for n in rung(time, y).notes)


@pytest.mark.linear_algebra
def test_a_length_that_is_not_sure_makes_k_b_four_times_less_sure():
    time, y = ring_recording([25], [0.03], seed=1)
    sure, unsure = (rung(time, y, support="cantilever", length=0.02, length_sd=sd) for sd in (0.0, 2e-4))
    assert sure.stiffness.value == unsure.stiffness.value
    assert unsure.stiffness.sd / unsure.stiffness.value == pytest.approx(0.04, rel=0.01)
    assert unsure.correlation > 0.9  # both go as the length's fourth power
    assert unsure.damping.sd > 2 * sure.damping.sd


def test_bad_options_are_refused_in_a_line():
    time, y = ring_recording([5], [0.03])
    for options, allowed in (
        ({"support": "glued"}, "free or cantilever"),
        ({"support": "cantilever"}, "the free length"),
        ({"start": 50.0}, "at least 12 rows"),
        ({"mode": 9}, "from 1 to the 1 modes"),
    ):
        with pytest.raises(InputError, match=allowed):
            rung(time, y, **options)


@pytest.mark.linear_algebra
def test_torsion_keeps_its_ratio_to_bending():
    twisted = CHEESE.replace(torsion_stiffness=CHEESE.bending_stiffness / 2)
    recording = RingRecording("ring", "deflection", *ring_recording([6], [0.03]))
    result = identify_ring(recording, twisted)
    sheet = result.to_fragment().apply(preset("cheese").scenario.replace(sheet=twisted)).sheet
    assert sheet.torsion_stiffness == pytest.approx(sheet.bending_stiffness / 2)
    assert sheet.natural_frequency == pytest.approx(result.mode.omega.value, rel=1e-9)


# Long recordings


@pytest.mark.slow
def test_a_million_rows_of_tilt_are_thinned_in_time():
    columns = tilt_recording(0.75, 0.4, fps=20_000.0, rate=math.radians(0.5), rest=50.0, seed=1)
    assert len(columns[0]) > 1e6
    begun = clock.perf_counter()
    result = one(*columns)
    assert clock.perf_counter() - begun < PATIENCE
    assert any("thinned" in note for note in result.trials[0].notes)
    assert result.static.value == pytest.approx(0.75, abs=1e-3)
    # A slow recorder leaves the slide in few of the coarse rows; the fine ones are fitted.
    slow = one(*tilt_recording(0.4, 0.2, fps=1000.0, rate=math.radians(0.05), rest=400.0, seed=1))
    assert slow.kinetic.value == pytest.approx(0.2, rel=0.02)


def test_a_million_rows_of_ring_are_thinned_in_time():
    time, y = ring_recording([5], [0.01], rate=5000.0, duration=200.0)
    assert len(time) == 1_000_000
    begun = clock.perf_counter()
    result = rung(time, y)
    assert clock.perf_counter() - begun < PATIENCE
    assert any("thinned" in note for note in result.notes)
    assert result.mode.frequency == pytest.approx(5, rel=1e-4)
    assert result.mode.damping_ratio.value == pytest.approx(0.01, rel=0.02)


# Commands


def call(command, *arguments, capsys):
    app = typer.Typer()
    app.command()(command)
    status = app(list(map(str, arguments)), standalone_mode=False)
    return status or 0, capsys.readouterr().out


def test_the_friction_command_writes_prints_and_says_how_it_went(tmp_path, capsys):
    paths = [tmp_path / f"{i}.csv" for i in range(2)]
    for i, path in enumerate(paths):
        write_tilt(path, *tilt_recording(0.75, 0.4, seed=i))
    out, plot = tmp_path / "f.toml", tmp_path / "f.png"
    status, text = call(friction, *paths, "--out", out, "--plot", plot, "--json", capsys=capsys)
    numbers = json.loads(text)
    assert status == 0
    assert read_fragment(out).parameters["friction.static"].value == pytest.approx(numbers["friction_static"]["value"])
    assert plot.stat().st_size > 5000
    assert [t["name"] for t in numbers["trials"]] == ["0.csv", "1.csv"]
    status, text = call(friction, *paths, capsys=capsys)
    assert "mean of all" in text
    t = np.arange(0, 4, 0.01)
    write_tilt(paths[0], t, 0.1 * t, 0 * t)
    out.unlink()
    status, text = call(friction, paths[0], "--out", out, "--json", capsys=capsys)
    assert (status, json.loads(text)["friction_static"], out.exists()) == (1, None, False)
    with pytest.raises(InputError, match=r"ending in \.toml"):
        call(friction, paths[0], "--out", tmp_path / "f.txt", capsys=capsys)


def test_the_modes_command_writes_prints_and_says_how_it_went(tmp_path, capsys):
    path, out, plot = tmp_path / "r.csv", tmp_path / "r.toml", tmp_path / "r.svg"
    write_ring(path, *ring_recording([5, 31], [0.03, 0.05], amplitudes=[5e-3, 1e-3]))
    status, text = call(ring, path, "--out", out, "--plot", plot, "--json", capsys=capsys)
    numbers = json.loads(text)
    assert status == 0
    # Noise of 1 % of the amplitude over ten cycles: 0.05 %.
    assert numbers["natural_frequency_rad_s"]["value"] == pytest.approx(10 * math.pi, rel=2e-3)
    assert set(read_fragment(out).parameters) == {"sheet.bending_stiffness", "sheet.bending_damping"}
    assert plot.stat().st_size > 5000
    status, text = call(ring, path, "--mode", 2, "--support", "cantilever", "--length", "15 mm", capsys=capsys)
    assert "from mode 2" in text
    t = np.arange(0, 2, 0.01)
    write_ring(path, t, 0 * t)
    assert call(ring, path, "--json", capsys=capsys)[0] == 1
    assert "not determined" in call(ring, path, capsys=capsys)[1]


def test_pictures_are_drawn_of_what_is_not_determined_too():
    t = np.arange(0, 4, 0.01)
    assert_legible(plot_tilt(one(t, 0.1 * t, 0 * t)))
    assert_legible(plot_tilt(one(*tilt_recording(0.75, 0.4, rest=-0.1, travel=0.3, seed=2))))
    assert_legible(plot_ring(rung(t, 0 * t)))
