"""Bending and compression recordings: what is read, refused, gated, drawn and written."""

from __future__ import annotations

import json
import math
import time

import numpy as np
import pytest
import typer
from legible import assert_legible
from typer.testing import CliRunner

from plategait.cli.identify.bending import bending
from plategait.cli.identify.compression import compression
from plategait.errors import InputError
from plategait.identify.bending import sag
from plategait.identify.bending.figures import plot_bending
from plategait.identify.bending.recording import read_angles
from plategait.identify.bending.result import identify_bending
from plategait.identify.bending.synthetic import cantilever_recording
from plategait.identify.compression.figures import plot_compression
from plategait.identify.compression.result import Pressing, identify_compression, read_pressing
from plategait.identify.compression.synthetic import press_recording
from plategait.identify.fit import determined, fit
from plategait.identify.series import Window, smooth, structure, thin
from plategait.model.fragment import read_fragment
from plategait.model.measured import Measured
from plategait.theory.two_links import Angles, Strip

K_B, C_B = 1.558e-4, 2.424e-7
K_S, C_S = 12640.0, 7.84
app = typer.Typer(pretty_exceptions_enable=False)
app.command()(bending)
app.command()(compression)


def run(*arguments):
    return CliRunner().invoke(app, [str(a) for a in arguments])


@pytest.fixture(scope="module")
def strip():
    return cantilever_recording(K_B, C_B, jitter=1e-5, seed=3)


@pytest.fixture(scope="module")
def sagged(strip):
    return identify_bending(strip.angles)


@pytest.fixture(scope="module")
def press():
    made = press_recording(K_S, C_S, rows=40, seed=3)
    return Pressing(made.time, made.displacement, made.force)


@pytest.fixture(scope="module")
def pressed(press):
    return identify_compression(press)


# Series


def test_a_smooth_series_has_the_derivatives_of_what_it_follows():
    t = np.linspace(0, 1, 200)
    spline = smooth(t, np.sin(9 * t) + 1e-3 * np.random.default_rng(0).normal(size=200))
    assert spline.sd == pytest.approx(1e-3, rel=0.2)  # a standard deviation of 200: 5 %, four of them
    # Three of the noise's standard deviations, over √(200/15) samples per coefficient, grown by differentiation.
    np.testing.assert_allclose(spline(t), np.sin(9 * t), atol=1.5e-3)
    np.testing.assert_allclose(spline(t, 1)[5:-5], 9 * np.cos(9 * t)[5:-5], atol=0.15)
    np.testing.assert_allclose(spline.matrix(t, 1) @ spline.coefficients, spline(t, 1), atol=1e-9)  # rounding


def test_a_straight_series_is_not_made_to_wriggle():
    t = np.linspace(0, 1, 10)
    np.testing.assert_allclose(smooth(t, 3 * t)(t, 1), 3.0, rtol=1e-9)  # rounding


def test_thinning_averages_whole_blocks():
    (t, x), block = thin(np.arange(10.0), np.arange(10.0) ** 2, most=4)
    assert block == 3
    np.testing.assert_array_equal(t, [1, 4, 7])
    np.testing.assert_allclose(x, [5 / 3, 50 / 3, 149 / 3])
    assert thin(np.arange(4.0), most=4)[1] == 1


def test_noise_has_no_structure_and_a_swing_has():
    assert abs(structure(np.random.default_rng(0).normal(size=1000))) < 0.13  # four standard errors of 1/√1000
    assert structure(np.sin(np.linspace(0, 6, 1000))) > 0.99


def test_a_fit_weights_each_channel_by_its_own_scatter():
    rng = np.random.default_rng(5)
    t = np.linspace(0, 1, 400)
    data = np.stack([2 * t + 0.01 * rng.normal(size=400), 2 * t + 1.0 * rng.normal(size=400)], axis=1)
    fitted = fit(lambda p: np.stack([t[:, None] * p[0]] * 2, axis=1), data, np.ones(1), -np.full(1, 9), np.full(1, 9))
    # As the sharp channel alone: 0.01/√(Σt²) = 0.01/√133; unweighted it would be seventy times as much.
    assert fitted.measured(0, 1.0).sd == pytest.approx(0.01 / math.sqrt(np.sum(t**2)), rel=0.1)
    assert abs(fitted.parameters[0] - 2) < 4 * fitted.measured(0, 1.0).sd


def test_what_moves_nothing_is_not_known():
    t = np.linspace(0, 1, 50)
    data = (t + 0.01 * np.random.default_rng(0).normal(size=50))[:, None]
    fitted = fit(lambda p: t[:, None, None] * p[0], data, np.ones(2), -np.full(2, 9.0), np.full(2, 9.0))
    assert determined(fitted.measured(0, 1.0))
    assert fitted.measured(1, 1.0).sd == math.inf
    assert not determined(fitted.measured(1, 1.0))


@pytest.mark.parametrize(
    ("low", "high", "expected"), [(0.6, 1.4, True), (0.4, 1.6, False), (-0.1, 0.5, False), (-math.inf, math.inf, False)]
)
def test_the_gate(low, high, expected):
    assert determined(Measured(1.0, 0.1, low, high)) is expected


# What is read


def test_markers_and_angles_in_any_unit_are_the_same_recording(strip, tmp_path):
    strip.write_markers(tmp_path / "markers.csv")
    strip.write_angles(tmp_path / "angles.csv")
    one, two = read_angles(tmp_path / "markers.csv"), read_angles(tmp_path / "angles.csv")
    table = np.column_stack([1e3 * two.time, two.phi_2, two.phi_1])
    np.savetxt(tmp_path / "rad.csv", table, delimiter=";", header="time (ms);phi2 [rad];phi1 [rad]", comments="")
    pixels = np.column_stack([one.time, (strip.markers * (1e4, -1e4) + 300).reshape(-1, 6)])
    heading = "time_s," + ",".join(f"{axis}{i}_px" for i in range(3) for axis in "xy")
    np.savetxt(tmp_path / "pixels.csv", pixels, delimiter=",", header=heading, comments="")
    others = [two, read_angles(tmp_path / "rad.csv"), read_angles(tmp_path / "pixels.csv", y_down=True)]
    for other in others:
        # Ten digits are written.
        np.testing.assert_allclose(other.time, one.time, atol=1e-9)
        np.testing.assert_allclose(other.phi_1, one.phi_1, atol=1e-8)
        np.testing.assert_allclose(other.phi_2, one.phi_2, atol=1e-8)


def bending_csv(path, rows=20, heading="time_s,phi1_deg,phi2_deg", spoil=None):
    lines = [f"{i / 480:.6f},{i},{0.4 * i}" for i in range(rows)]
    if spoil is not None:
        lines[5] = spoil
    path.write_text("\n".join([heading, *lines]) + "\n")
    return path


@pytest.mark.parametrize(
    ("change", "field"),
    [
        ({"heading": "time_s,angle1_deg,angle2_deg"}, "column phi1"),
        ({"heading": "time_s,phi1_mm,phi2_deg"}, "a unit of rad"),
        ({"heading": "time_s,x0_mm,y0_mm"}, "column x1"),
        ({"heading": "t,phi1_deg,phi2_deg"}, "column time"),
        ({"spoil": "0.0001,1,1"}, "line 7, time"),
        ({"spoil": "0.0104,nan,1"}, "line 7, phi1"),
        ({"spoil": "0.0104,,1"}, "line 7, phi1"),
        ({"rows": 1}, "recording"),
        ({"rows": 0}, "recording"),
    ],
)
def test_a_bad_bending_file_is_refused(change, field, tmp_path):
    with pytest.raises(InputError) as refused:
        read_angles(bending_csv(tmp_path / "bad.csv", **change))
    assert field in str(refused.value)
    assert "\n" not in str(refused.value)


def test_a_missing_file_is_refused(tmp_path):
    for read in (read_angles, read_pressing):
        with pytest.raises(InputError, match="recording"):
            read(tmp_path / "none.csv")


@pytest.mark.parametrize(
    ("heading", "field"),
    [("time_s,displacement_mm,load_N", "column force"), ("time_s,displacement_N,force_N", "a unit of m")],
)
def test_a_bad_compression_file_is_refused(heading, field, tmp_path):
    (tmp_path / "bad.csv").write_text("\n".join([heading, *(f"{i},{i},{i}" for i in range(10))]))
    with pytest.raises(InputError, match=field):
        read_pressing(tmp_path / "bad.csv")


def test_a_recording_made_by_hand_must_be_whole():
    t = np.arange(20) / 480
    with pytest.raises(InputError, match="phi_1"):
        Angles(t, t[:5], t)
    with pytest.raises(InputError, match="phi_2"):
        Angles(t, t, np.where(t > 0.01, np.nan, t))
    with pytest.raises(InputError, match="time"):
        Angles(t[::-1], t, t)


# What is refused once it is read


def test_a_strip_that_does_not_move_is_refused():
    t = np.arange(50) / 480
    with pytest.raises(InputError, match="every row"):
        identify_bending(Angles(t, np.full(50, 0.3), np.full(50, 0.1)))


def test_a_strip_that_rises_is_refused(strip):
    up = Angles(strip.time, -strip.angles.phi_1, -strip.angles.phi_2)
    with pytest.raises(InputError, match="y-down"):
        identify_bending(up)


@pytest.mark.parametrize("options", [{"method": "guess"}, {"wall": "soft"}, {"window": Window(0.199)}])
def test_unknown_ways_and_empty_windows_are_refused(strip, options):
    with pytest.raises(InputError):
        identify_bending(strip.angles, **options)


def test_a_press_that_does_not_move_or_push_is_refused(press):
    t, s, f = press.time, press.displacement, press.force
    for bad in (Pressing(t, s * 0, f), Pressing(t, s, f * 0), Pressing(t, s, -f), Pressing(t, s * np.nan, f)):
        with pytest.raises(InputError):
            identify_compression(bad)
    with pytest.raises(InputError, match="method"):
        identify_compression(press, method="guess")  # type: ignore[arg-type]


# What is found


def test_what_a_strip_shows(sagged):
    assert sagged.stiffness.low < K_B < sagged.stiffness.high
    assert sagged.damping.low < C_B < sagged.damping.high
    assert set(sagged.parameters) == {"sheet.bending_stiffness", "sheet.bending_damping"}
    # sd of φ2 from markers of 0.01 mm: √6 × 0.01/10 rad; of 97 values good to 7 %, four of them.
    assert sagged.residual_rms == pytest.approx(math.sqrt(6) * 1e-3, rel=0.28)


def test_a_wider_strip_has_a_softer_tile(strip, sagged):
    wide = identify_bending(strip.angles, width=0.02)
    assert wide.stiffness.value == pytest.approx(sagged.stiffness.value / 2)
    assert wide.damping.high == pytest.approx(sagged.damping.high / 2)


def test_stiffness_goes_with_the_assumed_mass(strip, sagged):
    heavy = identify_bending(strip.angles, strip=Strip(mass=2 * 0.285e-3))
    # The equations are homogeneous in m, k_b and c_b; the fit stops at 1e-9 of the cost, 3e-5 of a standard deviation.
    assert heavy.stiffness.value == pytest.approx(2 * sagged.stiffness.value, rel=1e-5)


@pytest.mark.linear_algebra
def test_rows_before_the_release_are_cut_off(strip, sagged):
    angles = strip.angles
    held = np.arange(40) / 480
    late = Angles(np.r_[held, angles.time + 40 / 480], np.r_[0 * held, angles.phi_1], np.r_[0 * held, angles.phi_2])
    whole, cut = identify_bending(late), identify_bending(late, window=Window(40 / 480))
    assert cut.stiffness.value == pytest.approx(sagged.stiffness.value, rel=1e-6)
    assert abs(whole.stiffness.value / K_B - 1) > 5 * abs(cut.stiffness.value / K_B - 1)
    assert any("misses" in note for note in whole.notes)


def test_a_recording_too_noisy_for_damping_says_so():
    noisy = identify_bending(cantilever_recording(K_B, C_B, jitter=2e-4, seed=1).angles)
    assert "sheet.bending_damping" not in noisy.parameters
    assert any("damping not determined" in note for note in noisy.notes)
    assert noisy.summary()["bending_damping_n_mm_s_per_deg"] is None


@pytest.mark.slow
def test_a_second_mode_too_fast_for_the_camera_leaves_damping_open():
    # Ten times as stiff, the second mode is 245 Hz, beyond the 240 Hz that 480 pictures per second can show.
    fast = identify_bending(cantilever_recording(10 * K_B, C_B, jitter=2e-6, seed=1).angles)
    assert list(fast.parameters) == ["sheet.bending_stiffness"]
    assert any("film faster" in note for note in fast.notes)


@pytest.mark.slow
def test_a_strip_that_creeps_is_followed_by_the_measured_wall_alone(monkeypatch):
    creeping = cantilever_recording(K_B, 20 * C_B, jitter=1e-5, seed=1).angles
    measured = identify_bending(creeping)
    assert measured.damping.low < 20 * C_B < measured.damping.high
    assert "sheet.bending_damping" in measured.parameters
    monkeypatch.setattr(sag, "_MOST_STEPS", 40)  # affordable ones, so that the test need not wait for too many
    creeping = cantilever_recording(K_B, 100 * C_B, rows=60, jitter=1e-5, seed=1).angles
    joint = identify_bending(creeping, wall="joint")
    assert not joint.parameters
    assert any("--wall measured" in note for note in joint.notes)


@pytest.mark.slow
def test_a_free_wall_is_reported(strip):
    result = identify_bending(strip.angles, wall="free")
    assert result.wall_stiffness is not None
    assert result.wall_stiffness.low < K_B < result.wall_stiffness.high
    assert identify_bending(strip.angles, wall="joint").wall_stiffness is None


def test_what_a_press_shows(pressed):
    assert pressed.surface_stiffness.low < K_S < pressed.surface_stiffness.high
    assert pressed.surface_damping.low < C_S < pressed.surface_damping.high
    assert pressed.stiffness.value == pytest.approx(pressed.surface_stiffness.value / 16)
    assert pressed.damping.high == pytest.approx(pressed.surface_damping.high / 16)


def test_an_offset_takes_up_preload_and_touch():
    made = press_recording(K_S, C_S, rows=60, touch=2e-5, preload=0.3, seed=4)
    shifted = Pressing(made.time, made.displacement, made.force)
    result, wrong = identify_compression(shifted, offset=True), identify_compression(shifted)
    assert result.surface_stiffness.low < K_S < result.surface_stiffness.high
    assert result.offset is not None
    assert result.offset.low < 0.3 - K_S * 2e-5 < result.offset.high
    assert any("misses" in note for note in wrong.notes)


def test_a_slow_press_tells_no_damping():
    made = press_recording(K_S, C_S, duration=10.0, rows=200, seed=5)
    result = identify_compression(Pressing(made.time, made.displacement, made.force))
    assert list(result.parameters) == ["sheet.axial_stiffness"]
    assert any("damping c_s not determined" in note for note in result.notes)
    fragment = result.to_fragment()
    assert fragment.correlation is None


def test_the_regressions_of_the_source_are_near(strip, press, sagged, pressed):
    assert identify_bending(strip.angles, method="regression").stiffness.value == pytest.approx(
        sagged.stiffness.value, rel=0.05
    )  # its own scatter is 1 % at this noise
    result = identify_compression(press, method="regression", offset=True)
    assert result.surface_stiffness.value == pytest.approx(K_S, rel=0.05)
    assert result.surface_damping.value == pytest.approx(C_S, rel=0.3)


@pytest.mark.slow
def test_a_million_rows_take_seconds():
    n = 1_000_000
    rng = np.random.default_rng(6)
    base = cantilever_recording(K_B, C_B, rows=480, jitter=0.0).angles
    slow, fast = np.arange(n) / 480, np.arange(n) * 8e-7
    for t in (slow, fast):
        phi = [np.interp(t, base.time, angles) + 0.01 * rng.normal(size=n) for angles in (base.phi_1, base.phi_2)]
        begun = time.process_time()
        result = identify_bending(Angles(t, *phi))
        assert time.process_time() - begun < 20  # s of both cores; found: 3
        assert result.stiffness.value == pytest.approx(K_B, rel=0.05)
        assert any("thinned" in note or "only the first" in note for note in result.notes)
    made = press_recording(K_S, C_S, rows=n, seed=7)
    begun = time.process_time()
    result = identify_compression(Pressing(made.time, made.displacement, made.force))
    assert time.process_time() - begun < 20  # found: 2
    assert result.surface_damping.value == pytest.approx(C_S, rel=0.02)
    assert any("thinned" in note for note in result.notes)


# What comes out


def test_pictures(sagged, pressed):
    figure = plot_bending(sagged)
    assert_legible(figure)
    recorded, fitted = figure.axes[0].get_lines()
    np.testing.assert_allclose(recorded.get_ydata(), np.degrees(sagged.phi_2))
    np.testing.assert_allclose(fitted.get_ydata(), np.degrees(sagged.reconstruction))
    assert len(plot_compression(pressed).axes) == 2
    assert_legible(plot_compression(pressed))


def test_the_bending_command(strip, tmp_path):
    strip.write_markers(tmp_path / "strip.csv")
    out, plot = tmp_path / "bending.toml", tmp_path / "bending.png"
    done = run("bending", tmp_path / "strip.csv", "--out", out, "--plot", plot)
    assert done.exit_code == 0
    assert "0.285 g and 10 mm" in done.stdout
    fragment = read_fragment(out)
    assert fragment.parameters["sheet.bending_stiffness"].value == pytest.approx(K_B, rel=0.02)
    assert fragment.correlation is not None
    assert plot.stat().st_size > 10_000
    numbers = json.loads(run("bending", tmp_path / "strip.csv", "--json", "--no-centripetal").stdout)
    low, high = numbers["bending_stiffness_n_mm_per_deg"]["interval"]
    assert low < 2.72e-3 < high * 1.02


def test_the_compression_command(press, tmp_path):
    made = press_recording(K_S, C_S, rows=40, seed=3)
    made.write(tmp_path / "press.csv")
    out = tmp_path / "compression.toml"
    done = run("compression", tmp_path / "press.csv", "--out", out, "--plot", tmp_path / "press.svg")
    assert done.exit_code == 0
    assert read_fragment(out).parameters["sheet.axial_stiffness"].value == pytest.approx(790, rel=0.02)
    numbers = json.loads(run("compression", tmp_path / "press.csv", "--json", "--thickness", "5 mm").stdout)
    assert numbers["axial_stiffness_n_per_mm"]["value"] == pytest.approx(12.64 / 4, rel=0.02)


@pytest.mark.parametrize(
    "options", [("--mass", "0 g"), ("--length", "10 g"), ("--width", "wide"), ("--from", "1 mm"), ("--out", "x.csv")]
)
def test_bad_options_are_refused_before_anything_is_read(options, tmp_path):
    done = run("bending", bending_csv(tmp_path / "strip.csv"), *options)
    assert isinstance(done.exception, InputError)
    assert options[0] in str(done.exception)
