"""Spin curves: frequencies, files and what goes into the fit."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from plategait.curve.curve import Curve
from plategait.curve.curve_file import COLUMNS, read_curve, write_curve
from plategait.curve.spin_curve import fit_curve, spin_curve
from plategait.errors import InputError
from plategait.files.ranges import parse_frequencies
from plategait.model.presets import preset
from plategait.simulation.observables import FAILURES, GAITS

HEAD = "frequency_hz,spin_rate_deg_s\n"


def curve_of(frequency, rate, *, gait=None, failure=None, sd=None) -> Curve:
    n = len(frequency)
    return Curve(
        "test", np.array(frequency, dtype=float), np.array(rate, dtype=float),
        np.full(n, math.nan) if sd is None else np.array(sd, dtype=float), tuple(gait or [""] * n),
        tuple(failure or [""] * n),
    )  # fmt: skip


def line(frequency, peak=300.0, f0=21.0, b=3.0) -> np.ndarray:
    return peak / (1 + ((np.asarray(frequency) - f0) / b) ** 2)


# Frequencies


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("12:15:1Hz", [12, 13, 14, 15]),
        ("12:15:1 Hz", [12, 13, 14, 15]),
        ("12Hz:15Hz:1Hz", [12, 13, 14, 15]),
        (" 12 Hz : 15 Hz : 1 Hz ", [12, 13, 14, 15]),
        ("12:15:1", [12, 13, 14, 15]),
        ("0.012:0.014:0.001kHz", [12, 13, 14]),
        ("1.2e1:1.4e1:1e0 Hz", [12, 13, 14]),
        ("12:15:2Hz", [12, 14]),
        ("12:12:1Hz", [12]),
        ("0.1:0.3:0.1Hz", [0.1, 0.2, 0.3]),
        ("12,14.5,20 Hz", [12, 14.5, 20]),
        ("24 Hz", [24]),
        ("24", [24]),
        ("20,12Hz", [20, 12]),
    ],
)
def test_frequencies_are_read(text, expected):
    assert parse_frequencies(text) == pytest.approx(expected, rel=1e-12)


@given(first=st.integers(1, 50), count=st.integers(1, 60), step=st.sampled_from([0.05, 0.1, 0.25, 0.5, 1, 2]))
def test_both_ends_are_included(first, count, step):
    last = first + (count - 1) * step
    found = parse_frequencies(f"{first}:{last:.10g}:{step}Hz")
    assert len(found) == count
    assert found[0] == first
    assert found[-1] == pytest.approx(last, rel=1e-9)


def test_tiny_frequencies_are_not_rounded_away():
    assert parse_frequencies("1e-10:3e-10:1e-10Hz") == pytest.approx([1e-10, 2e-10, 3e-10], rel=1e-6)


@pytest.mark.parametrize(
    "text",
    ["", " ", "abc", "12:30", "12:", "12::1Hz", "1:2:3:4Hz", "30:12:1Hz", "12:30:0Hz", "12:30:-1Hz", "-12:30:1Hz",
     "0:30:1Hz", "nan:30:1Hz", "12:inf:1Hz", "12:30:1mm", "12:30:1 s", "12:30:1 rad/s", "12,,14Hz", "12,14,", "12;14Hz",
     "12 to 30 Hz", "12-30Hz", "12,abc", "12:30:1e-9Hz", "0", "-5 Hz"],
)  # fmt: skip
def test_what_is_no_frequencies_is_refused(text):
    with pytest.raises(InputError) as caught:
        parse_frequencies(text)
    assert caught.value.field == "frequency"
    assert caught.value.got == text
    assert len(parse_frequencies(caught.value.hint.strip('"'))) > 3


def test_frequencies_that_each_carry_their_unit():
    assert parse_frequencies("12Hz,0.014kHz") == pytest.approx([12, 14], rel=1e-12)


# Files

finite = st.floats(-1e6, 1e6)
points = st.lists(
    st.tuples(
        st.floats(1e-3, 1e5), finite | st.just(math.nan), st.floats(1e-6, 1e6) | st.just(math.nan),
        st.sampled_from(["", *GAITS]), st.sampled_from(["", *FAILURES]),
    ),
    min_size=1,
    max_size=12,
)  # fmt: skip


@given(points=points)
def test_a_curve_comes_back_the_same(points, tmp_path_factory):
    frequency, rate, sd, gait, failure = zip(*points, strict=True)
    curve = curve_of(frequency, rate, sd=sd, gait=gait, failure=failure)
    path = tmp_path_factory.getbasetemp() / "curve.csv"
    write_curve(curve, path)
    back = read_curve(path)
    assert (back.name, back.gait, back.failure) == ("curve", gait, failure)
    for name in ("frequency_hz", "spin_rate_deg_s", "spin_rate_sd_deg_s"):
        np.testing.assert_allclose(getattr(back, name), getattr(curve, name), rtol=1e-9)  # ten digits are written


def test_the_file_has_its_columns(tmp_path):
    write_curve(
        curve_of([12, 13], [1.5, math.nan], gait=["sliding", ""], failure=["", "left the plate"]), tmp_path / "c.csv"
    )
    assert (tmp_path / "c.csv").read_text().splitlines() == [
        ",".join(COLUMNS), "12,1.5,,sliding,,,", "13,,,,left the plate,,",
    ]  # fmt: skip


def test_points_that_failed_in_part_come_back_as_such(tmp_path):
    kinds = ("", "slipped", "slipped", "slipped", "folded")
    rate, walking = np.array([1.0, 2, 3, 4, math.nan]), ("walking",) * 5
    curve = Curve("c", np.arange(12.0, 17), rate, np.full(5, 0.1), walking, kinds,
                  runs=np.array([4.0, 4, 4, 4, 1]), failed_runs=np.array([0.0, 1, 2, 3, 1]))  # fmt: skip
    write_curve(curve, tmp_path / "c.csv")
    back = read_curve(tmp_path / "c.csv")
    for each in (curve, back):
        assert each.failed.tolist() == [False, False, True, True, True]
        assert each.partly_failed.tolist() == [False, True, True, True, False]
        assert each.fitted.tolist() == [True, True, False, False, False]
        assert each.failure_in_words == (
            "", "1 of 4 failed: slipped", "2 of 4 failed: slipped", "3 of 4 failed: slipped", "folded"
        )  # fmt: skip


@pytest.mark.parametrize(
    ("row", "field"),
    [("slipped,4,5", "failed_runs"), ("slipped,4,", "failed_runs"), ("slipped,,1", "failed_runs"),
     ("slipped,4,1.5", "failed_runs"), ("slipped,4,0", "failure"), (",4,1", "failure")],
)  # fmt: skip
def test_runs_that_contradict_each_other_are_refused(tmp_path, row, field):
    with pytest.raises(InputError) as caught:
        read_text(tmp_path, f"frequency_hz,spin_rate_deg_s,failure,runs,failed_runs\n12,3,{row}\n")
    assert caught.value.field == f"c.csv line 2, {field}"


@pytest.mark.parametrize("name", ["c.txt", "c", "missing/c.csv"])
def test_a_curve_goes_only_to_a_csv_file_that_can_be_written(tmp_path, name):
    with pytest.raises(InputError):
        write_curve(curve_of([12], [1]), tmp_path / name)
    assert list(tmp_path.iterdir()) == []


def read_text(tmp_path, text: str | bytes) -> Curve:
    path = tmp_path / "c.csv"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return read_curve(path)


@pytest.mark.parametrize(
    "text",
    [HEAD + "12,3\n", "\ufeff" + HEAD + "12,3\n", HEAD.replace("\n", "\r\n") + "12,3\r\n",
     "gait,spin_rate_deg_s,note,frequency_hz\nwalking,3,hello,12\n", HEAD + "12 , 3 \n", HEAD + "12,3",
     HEAD + "12,3\n\n", "frequency_hz, spin_rate_deg_s\n12, 3\n"],
    ids=["plain", "byte order mark", "CR LF", "other order", "spaces", "no last newline", "blank end", "spaced head"],
)  # fmt: skip
def test_good_files_are_read(tmp_path, text):
    curve = read_text(tmp_path, text)
    assert curve.frequency_hz.tolist() == [12]
    assert curve.spin_rate_deg_s.tolist() == [3]
    assert np.isnan(curve.spin_rate_sd_deg_s).all()


def test_blank_cells_are_points_without_knowledge(tmp_path):
    curve = read_text(tmp_path, ",".join(COLUMNS) + "\n12,,,,\n13,5,1,walking,\n14,,,,slipped\n")
    assert np.isnan(curve.spin_rate_deg_s).tolist() == [True, False, True]
    assert curve.gait == ("", "walking", "")
    assert curve.failure == ("", "", "slipped")
    assert json.dumps(curve.summary(), allow_nan=False)


@pytest.mark.parametrize(
    "text",
    ["", "\n", HEAD, "a,b\n1,2\n", "frequency_hz\n12\n", bytes(range(256)),
     HEAD + '12,"' + "1" * 200_000 + '"\n'],
    ids=["empty", "blank", "no rows", "wrong columns", "a column short", "binary", "endless cell"],
)  # fmt: skip
def test_files_that_are_no_curve_are_refused(tmp_path, text):
    with pytest.raises(InputError) as caught:
        read_text(tmp_path, text)
    assert caught.value.field == "curve"
    assert len(str(caught.value)) < 1000
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("rows", "line", "column"),
    [
        ("12,fast\n", 2, "spin_rate_deg_s"),
        ("12,3\n13,x\n", 3, "spin_rate_deg_s"),
        ("12,inf\n", 2, "spin_rate_deg_s"),
        ("12,1e999\n", 2, "spin_rate_deg_s"),
        ("-12,3\n", 2, "frequency_hz"),
        ("0,3\n", 2, "frequency_hz"),
        (",3\n", 2, "frequency_hz"),
        ("nan,3\n", 2, "frequency_hz"),
        ("inf,3\n", 2, "frequency_hz"),
        ('"12,5",3\n', 2, "frequency_hz"),
        ("12,3\n\n\n13,x\n", 5, "spin_rate_deg_s"),
    ],
)
def test_a_wrong_number_is_named_by_line_and_column(tmp_path, rows, line, column):
    with pytest.raises(InputError) as caught:
        read_text(tmp_path, HEAD + rows)
    assert caught.value.field == f"c.csv line {line}, {column}"
    assert float(caught.value.hint) > 0


def test_other_separators_units_and_orders_are_read(tmp_path):
    curve = read_text(tmp_path, "failure;angle_rad;spin rate (rpm);frequency_mHz\n;0,05;2,5;12500\n")
    assert curve.frequency_hz.tolist() == [12.5]
    assert curve.spin_rate_deg_s == pytest.approx([15.0], rel=1e-12)  # 1 rpm is 6 deg/s
    assert curve.angle_deg == pytest.approx([math.degrees(0.05)], rel=1e-12)


def test_a_negative_spread_is_refused(tmp_path):
    with pytest.raises(InputError, match="spin_rate_sd_deg_s"):
        read_text(tmp_path, "frequency_hz,spin_rate_deg_s,spin_rate_sd_deg_s\n12,3,-1\n")


def test_an_unknown_gait_is_refused(tmp_path):
    with pytest.raises(InputError, match="hopping") as caught:
        read_text(tmp_path, "frequency_hz,spin_rate_deg_s,gait\n12,3,walking\n13,3,hopping\n")
    assert caught.value.hint in GAITS


@pytest.mark.parametrize("spoil", ["missing", "folder"])
def test_a_curve_that_cannot_be_read_is_refused(tmp_path, spoil):
    path = tmp_path / "c.csv"
    if spoil == "folder":
        path.mkdir()
    with pytest.raises(InputError) as caught:
        read_curve(path)
    assert caught.value.field == "curve"


# Fit


def test_failed_points_are_left_out_of_the_fit():
    frequency = np.arange(14.0, 29.0)
    rate = line(frequency)
    spoilt = rate.copy()
    spoilt[[2, 5, 11]] = -900
    failure = ["slipped" if r == -900 else "" for r in spoilt]
    fit = fit_curve(curve_of(frequency, spoilt, failure=failure)).fit
    assert fit is not None
    # Exact points: the fit is exact to the tolerance of its minimiser.
    assert (fit.f0_hz, abs(fit.half_width_hz), fit.peak) == pytest.approx((21, 3, 300), rel=1e-4)
    assert fit.n_points == 12


def test_points_without_a_rate_are_left_out_of_the_fit():
    frequency = np.arange(14.0, 29.0)
    rate = line(frequency)
    rate[4] = math.nan
    curve = fit_curve(curve_of(frequency, rate))
    assert curve.fit is not None
    assert curve.fit.n_points == 14
    assert curve.no_fit == ""


@pytest.mark.parametrize(
    ("frequency", "rate", "failure"),
    [
        ([12, 13], [1, 2], None),
        ([12, 13, 14, 15, 16], [1, 5, 9, 5, 1], ["", "", "slipped", "slipped", "slipped"]),
        ([12, 13, 14, 15], [math.nan] * 4, None),
        ([12, 13, 14, 15, 16, 17], [0.0] * 6, None),
    ],
)
def test_where_there_is_no_fit_the_reason_is_given(frequency, rate, failure):
    curve = fit_curve(curve_of(frequency, rate, failure=failure))
    assert curve.fit is None
    assert curve.no_fit
    summary = json.loads(json.dumps(curve.summary(), allow_nan=False))
    assert summary["f0_hz"] is None
    assert summary["no_fit"] == curve.no_fit
    assert len(summary["points"]) == len(frequency)


def test_a_curve_that_only_rises_has_no_peak_frequency_either():
    frequency, rising = np.arange(12.0, 20.0), np.arange(8.0) ** 0.3
    assert math.isnan(curve_of(frequency, rising).peak_frequency)
    assert math.isnan(curve_of(frequency, rising[::-1]).peak_frequency)
    ran_off = curve_of([*frequency, 20, 21], [*rising, 0, 0], failure=[""] * 8 + ["slipped"] * 2)
    assert ran_off.peak_frequency == pytest.approx(19, abs=1)


def test_a_simulated_curve_has_a_point_for_each_frequency():
    seen: list[float] = []
    scenario = preset("cheese").scenario.replace(duration=0.3)
    curve = spin_curve(scenario, [14, 24, 20], progress=seen.append)
    assert curve.frequency_hz.tolist() == [14, 24, 20]
    assert [s.scenario.motion.frequency for s in curve.simulations] == [14, 24, 20]
    assert all(s.scenario.duration == 0.3 for s in curve.simulations)
    assert seen == sorted(seen)
    summary = json.loads(json.dumps(curve.summary(), allow_nan=False))
    assert [p["frequency_hz"] for p in summary["points"]] == [14, 24, 20]
    assert curve.spin_rate_deg_s[1] == pytest.approx(summary["points"][1]["spin_rate_deg_s"])


@pytest.mark.parametrize("frequencies", [[], [-1.0], [math.nan], [0.0]])
def test_a_curve_over_no_or_bad_frequencies_is_refused(frequencies):
    with pytest.raises(InputError):
        spin_curve(preset("cheese").scenario.replace(duration=0.1), frequencies)
