"""Curves in files that people, spreadsheets and other programs made: read as they are meant, or refused in a line."""

from __future__ import annotations

import csv
import io
import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from plategait.curve.curve import Curve
from plategait.curve.curve_file import read_curve, write_curve
from plategait.curve.outcome import UNTOLD
from plategait.errors import InputError
from plategait.files.headings import possible_names

HEAD = "frequency_hz,spin_rate_deg_s"


def read(tmp_path, text: str | bytes) -> Curve:
    path = tmp_path / "c.csv"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return read_curve(path)


def refused(tmp_path, text: str) -> InputError:
    with pytest.raises(InputError) as caught:
        read(tmp_path, text)
    assert "\n" not in str(caught.value)
    return caught.value


@pytest.mark.parametrize(
    "text",
    [
        "Hz;rpm\r\n12,5;10\r\n14;25,5\r\n",
        "\ufeffHz;rpm\r\n12,5;10\r\n14;25,5\r\n;\r\n",
        'sep=;\r\n"Hz";"rpm"\r\n"12,5";"10"\r\n"14";"25,5"\r\n',
        "Hz\trpm\r\n12,5\t10\r\n14\t25,5\r\n".encode("utf-16"),
        "Hz\trpm\r\n12,5\t10\r\n14\t25,5\r\n".encode("utf-8-sig"),
        "[Hz];(rpm)\n12,5;10\n14;25,5\n",
        "Frequenz (Hz);Drehzahl (U/min)\n12,5;10\n14;25,5\n",
        "Frequenz (Hz);Drehzahl (1/min)\n12,5;10\n14;25,5\n",
        "Frequenz (Hz);Drehzahl [min⁻¹]\n12,5;10\n14;25,5\n",
        "Frequenz (Hz);Drehzahl in min^-1\n12,5;10\n14;25,5\n",
        "Frequenz (Hz);1/min\n12,5;10\n14;25,5\n",
        "Frequenz (Hz);Drehrate (°/s)\r\n12,5;60\r\n14;153\r\n".encode("cp1252"),
        "freq [Hz],rate (deg/s)\n12.5,60\n14,153\n",
        "f / Hz,rate / rpm\n12.5,10\n14,25.5\n",
        "f/Hz,rate/rpm\n12.5,10\n14,25.5\n",
        "plate frequency in Hz,spin rate in degrees per second\n12.5,60\n14,153\n",
        f"rate (rev/s),freq (Hz)\n{1 / 6},12.5\n0.425,14\n",
        f"f_Hz,omega_rad_s\n12.5,{math.pi / 3}\n14,{0.85 * math.pi}\n",
        "# plate A, 3 May\n#\nfreq (Hz),rate (rpm)\n12.5,10\n#13,500\n14,25.5\n",
        '"# plate A, 3 May",\nfreq (Hz),rate (rpm)\n12.5,10\n14,25.5\n',
        "# freq_hz,rate_rpm\n1.25e1,1e1\n1.4e1,2.55e1\n",
        "freq_hz,rate_rpm\n12.5,10\nfreq_hz,rate_rpm\n14,25.5\n,\n,\n",
        "freq_hz,rate_rpm,,\n12.5,10,,\n14,25.5,,\n",
        "\n\nfreq_hz;rate_rpm\n12.5;10\n14;25.5",
        b"freq_hz,rate_rpm\r12.5,10\r14,25.5\r",
    ],
)
def test_the_same_curve_written_differently(tmp_path, text):
    curve = read(tmp_path, text)
    assert curve.frequency_hz.tolist() == [12.5, 14]
    assert curve.spin_rate_deg_s == pytest.approx([60, 153], rel=1e-12)  # 1 rpm is 6 deg/s
    assert curve.notes == ()


def test_a_heading_that_is_not_understood_is_named(tmp_path):
    error = refused(tmp_path, "Frequenz (Hz);Schnelligkeit (1/min);Fehler\n12,5;10;1\n14;25,5;2\n")
    assert "not understood: Schnelligkeit (1/min), Fehler" in str(error)
    error = refused(tmp_path, "Frequenz (Hz);Drehzahl (1/min);Fehler\n12,5;10;nein\n14;;ja\n")
    assert "Fehler" in str(error)
    (note,) = read(tmp_path, "Frequenz (Hz);Drehzahl (1/min);Fehler\n12,5;10;1\n14;25,5;2\n").notes
    assert "Fehler" in note


number = st.floats(-1e5, 1e5).map(lambda x: round(x, 3))


@given(
    st.lists(st.tuples(st.floats(1, 99).map(lambda x: round(x, 2)), number | st.none()), min_size=1, max_size=8),
    st.sampled_from([";", "\t"]), st.sampled_from(["utf-8", "utf-8-sig", "utf-16"]), st.sampled_from(["\n", "\r\n"]),
    st.sampled_from([csv.QUOTE_MINIMAL, csv.QUOTE_ALL]),
)  # fmt: skip
def test_what_a_german_spreadsheet_writes_comes_back(tmp_path_factory, points, separator, encoding, end, quoting):
    # With fixed places, as of formatted cells, no comma is taken for a sign between thousands.
    cells = [[f"{f:.2f}".replace(".", ","), "" if r is None else f"{r:.4f}".replace(".", ",")] for f, r in points]
    text = io.StringIO(newline="")
    csv.writer(text, delimiter=separator, lineterminator=end, quoting=quoting).writerows([["Hz", "rpm"], *cells])
    path = tmp_path_factory.getbasetemp() / "excel.csv"
    path.write_bytes(text.getvalue().encode(encoding))
    curve = read_curve(path)
    assert curve.frequency_hz.tolist() == [f for f, _ in points]
    expected = [math.nan if r is None else 6 * r for _, r in points]
    np.testing.assert_allclose(curve.spin_rate_deg_s, expected, rtol=1e-12, atol=1e-12)


# Failures


@pytest.mark.parametrize("name", ["failure", "Failure", "Failure ", "failed", "Failed?", "Failed (y/n)", "status"])
@pytest.mark.parametrize(
    ("stayed", "failed"),
    [("no", "yes"), ("No", "YES"), ("n", "y"), ("false", "true"), ("False", "True"), ("0", "1"), ("0.0", "1.0"),
     ("ok", "failed"), ("OK", "x"), ("-", "Failed."), ("–", "fail"), ("nein", "ja")],
)  # fmt: skip
def test_failures_are_read_as_people_mean_them(tmp_path, name, stayed, failed):
    curve = read(tmp_path, f"{HEAD},{name}\n12,3,{stayed}\n13,3,\n14,3,{failed}\n15,,{failed}\n")
    assert curve.failure == ("", "", UNTOLD, UNTOLD)
    assert curve.failed.tolist() == [False, False, True, True]


@pytest.mark.parametrize(
    ("said", "failure"),
    [("slipped", "slipped"), ("Slip", "slipped"), ("ran off", "slipped"), ("ran-off", "slipped"),
     ("ran_off", "slipped"), ("fell off", "left the plate"), ("Flipped  over", "turned over"), ("folded", "folded")],
)  # fmt: skip
@pytest.mark.parametrize("column", ["failure", "gait"])
def test_what_happened_is_read_in_either_column(tmp_path, column, said, failure):
    assert read(tmp_path, f"{HEAD},{column}\n12,3,{said}\n").failure == (failure,)


@pytest.mark.parametrize("column", ["failure", "gait"])
def test_a_gait_is_no_failure(tmp_path, column):
    curve = read(tmp_path, f"{HEAD},{column}\n12,3,Walking\n13,4,-\n")
    assert (curve.gait, curve.failure) == (("walking", ""), ("", ""))


@pytest.mark.parametrize(("column", "said"), [("failure", "wobbly"), ("failure", "2"), ("failure", "?"),
                                              ("gait", "yes"), ("gait", "1"), ("gait", "hopping")])  # fmt: skip
def test_words_of_no_known_meaning_are_refused(tmp_path, column, said):
    error = refused(tmp_path, f"{HEAD},{column}\n12,3,\n13,3,{said}\n")
    assert (error.field, error.got) == (f"c.csv line 3, {column}", said)
    read(tmp_path, f"{HEAD},{column}\n12,3,\n13,3,{error.hint}\n")


def test_runs_that_failed_tell_a_failure_by_themselves(tmp_path):
    curve = read(tmp_path, f"{HEAD},runs,failed_runs\n12,3,4,0\n13,3,4,1\n14,3,4,3\n")
    assert curve.failure == ("", UNTOLD, UNTOLD)
    assert curve.failed.tolist() == [False, False, True]


# Columns that nothing reads


def test_further_columns_are_named(tmp_path):
    curve = read(tmp_path, f"{HEAD},note,room (C),run,frequency_sd,empty\n12,3,hello,20,1,0.1,\n")
    (note,) = curve.notes
    assert "note, room (C), run, frequency_sd" in note
    assert "empty" not in note


@pytest.mark.parametrize(
    ("column", "meant"),
    [("failures,0", "failure"), ("Failur,no", "failure"), ("spin_rate_sdev_deg_s,3", "spin_rate_sd"),
     ("rate sd (%),5", "spin_rate_sd"), ("rate_sd (mm),5", "spin_rate_sd"), ("anlge_deg,3", "angle"),
     ("faild_runs,0", "failed_runs"), ("weggelaufen,ja", "failure"), ("comment,fell off", "failure")],
)  # fmt: skip
def test_a_column_that_looks_like_a_known_one_is_not_left_out_unheard(tmp_path, column, meant):
    heading, cell = column.split(",")
    error = refused(tmp_path, f"{HEAD},{heading}\n12,3,{cell}\n")
    assert error.field == f"c.csv, {heading}"
    assert error.hint == meant


def test_a_column_of_what_did_not_fail_is_refused(tmp_path):
    assert "failure" in refused(tmp_path, f"{HEAD},ok\n12,3,1\n13,3,0\n").hint


def test_a_spread_by_other_names_is_read(tmp_path):
    for name in ("rate_sd (rpm)", "sd_rpm", "± (rpm)", "Spin rate std [rpm]"):
        assert read(tmp_path, f"{HEAD},{name}\n12,3,2\n").spin_rate_sd_deg_s == pytest.approx([12], rel=1e-12)


def test_readings_come_with_how_well_they_are_known(tmp_path):
    curve = read(tmp_path, f"{HEAD},bending_amplitude_deg,bending_amplitude_sd_deg,rim lift (mm),rim_lift_std [mm]\n"
                           "14,70,2.5,0.1,1.5,0.05\n18,200,,,2.5,\n")  # fmt: skip
    assert not curve.notes
    np.testing.assert_allclose(np.degrees(curve.values["bending_amplitude"]), [2.5, math.nan])
    np.testing.assert_allclose(np.degrees(curve.value_sds["bending_amplitude"]), [0.1, math.nan])
    np.testing.assert_allclose(curve.value_sds["rim_lift"], [5e-5, math.nan])
    write_curve(curve, tmp_path / "again.csv")
    again = read_curve(tmp_path / "again.csv")
    for name in ("bending_amplitude", "rim_lift"):
        np.testing.assert_allclose(again.values[name], curve.values[name], rtol=1e-9)
        np.testing.assert_allclose(again.value_sds[name], curve.value_sds[name], rtol=1e-9)
    assert "above 0" in str(refused(tmp_path, f"{HEAD},rim_lift_mm,rim_lift_sd_mm\n14,70,1,0\n"))


def test_the_motion_of_each_point_may_stand_beside_it(tmp_path):
    curve = read(tmp_path, f"{HEAD},A_p (deg),stroke_mm,plate height [mm],phase_deg\n14,70,3,2,5,90\n18,200,,,,\n")
    assert not curve.notes
    assert curve.angle_deg is not None
    assert curve.stroke is not None
    np.testing.assert_allclose(curve.stroke, [2e-3, math.nan])
    np.testing.assert_allclose(curve.height, [5e-3, math.nan])
    np.testing.assert_allclose(curve.phase, [math.pi / 2, math.nan])
    write_curve(curve, tmp_path / "again.csv")
    again = read_curve(tmp_path / "again.csv")
    for name in ("angle_deg", "stroke", "height", "phase"):
        np.testing.assert_allclose(getattr(again, name), getattr(curve, name), rtol=1e-9)


def test_a_rate_without_a_unit_is_said_to_be_taken_in_the_usual_one(tmp_path):
    curve = read(tmp_path, "freq,rate\n12,60\n")
    assert curve.spin_rate_deg_s.tolist() == [60]
    assert curve.notes == ("c.csv: taken in deg/s, as its heading tells no unit: rate",)


@given(st.text(max_size=30))
def test_any_heading_beside_the_two_is_read_named_or_refused(tmp_path_factory, heading):
    assume(not heading.startswith(("#", "sep=", "\ufeff")))
    text = io.StringIO(newline="")
    csv.writer(text).writerows([["frequency_hz", "spin_rate_deg_s", heading], ["12", "60", "1"]])
    path = tmp_path_factory.getbasetemp() / "any.csv"
    path.write_bytes(text.getvalue().encode("utf-8", "replace"))
    try:
        curve = read_curve(path)
    except InputError:
        return
    assert curve.spin_rate_deg_s.tolist() == [60]
    known = curve.angle_deg is not None or curve.runs is not None or curve.failure != ("",)
    assert curve.notes or known or curve.values or not possible_names(heading) or not heading.strip()


# Numbers


@pytest.mark.parametrize(
    ("text", "line", "hint"),
    [
        (f"{HEAD}\n12,5,100,2\n", 2, "a decimal point, or semicolons between the cells"),
        (f"{HEAD},,\n12,60,,\n12,5,100,2\n", 3, "a decimal point, or semicolons between the cells"),
        (f'{HEAD}\n"12,5","100,2"\n', 2, "12.5"),
        (f'{HEAD}\n12.5,"1,200"\n', 2, "1200"),
        ("Hz;deg/s\n12,5;950\n13;1.200\n", 3, "1200 or 1,2, as is meant"),
        ("Hz\tdeg/s\n12.5\t950\n13\t1,200.5\n", 3, "1200 or 1,2, as is meant"),
        ("Hz\tdeg/s\n12\t950\n13\t1,200\n", 3, "1200 or 1,2, as is meant"),
        ("Hz;deg/s\n12.5;950\n13;12,5\n", 3, "1200 or 1,2, as is meant"),
        ("frequency,rate\nHz,deg/s\n12,100\n", 2, "the unit in the heading: frequency [Hz]"),
        (f"{HEAD}\n#DIV/0!,60\n", 2, "1.0"),
        (f"{HEAD},spin_rate_sd_deg_s\n12,60,0\n", 2, "an empty cell where it is not known"),
    ],
)
def test_a_number_that_may_mean_two_things_is_refused(tmp_path, text, line, hint):
    error = refused(tmp_path, text)
    assert error.field.startswith(f"c.csv line {line}")
    assert error.hint == hint


def test_rates_that_nobody_measured(tmp_path):
    curve = read(tmp_path, f"{HEAD},sd_deg_s\n12,NaN,-\n13,n/a,nan\n14,–,\n15,\N{MINUS SIGN}60,2\n")
    assert np.isnan(curve.spin_rate_deg_s).tolist() == [True, True, True, False]
    assert curve.spin_rate_deg_s[3] == -60


def test_a_spread_of_nothing_is_written_as_unknown(tmp_path):
    curve = Curve("c", np.array([12.0]), np.array([3.0]), np.array([0.0]), ("",), ("",))
    write_curve(curve, tmp_path / "c.csv")
    assert np.isnan(read_curve(tmp_path / "c.csv").spin_rate_sd_deg_s).all()


@pytest.mark.parametrize(("slip", "meant"), [(160, 16), (1.6, 16), (16000, 16), (0.18, 18), (130, 13), (200, 20)])
def test_a_slipped_decimal_point_stands_out(tmp_path, slip, meant):
    frequencies = [12, 13, 14, slip, 17, 18.5, 20]
    (note,) = read(tmp_path, f"{HEAD}\n" + "".join(f"{f},{3 * i}\n" for i, f in enumerate(frequencies))).notes
    assert note.startswith("warning: c.csv line 5")
    assert f"{slip:g} Hz" in note
    assert note.endswith(f"is {meant} Hz meant?")


@pytest.mark.parametrize(
    "frequencies", [[12, 160], [1, 2, 5, 10, 20, 50, 100, 200], [12, 14, 16, 35], [12, 13, 14, 120, 130, 140], [5]]
)
def test_frequencies_that_lie_far_apart_are_no_slips(tmp_path, frequencies):
    assert read(tmp_path, f"{HEAD}\n" + "".join(f"{f},60\n" for f in frequencies)).notes == ()
