"""Tables coming in: headings, units, separators, and what is no table."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from plategait.errors import InputError
from plategait.files.table import Column, read_table

COLUMNS = {"time": Column("s"), "phi": Column("rad"), "phi_sd": Column("rad", required=False)}
EXAMPLE = "time_s,phi_deg"


def read(tmp_path, text: str, **options):
    path = tmp_path / "t.csv"
    path.write_text(text, encoding="utf-8")
    return read_table(path, COLUMNS, field="recording", example=EXAMPLE, **options)


@pytest.mark.parametrize(
    "text",
    [
        "time_s,phi_deg\n0,90\n1,180\n",
        "phi_rad,time_ms\n1.5707963267948966,0\n3.141592653589793,1000\n",
        "Time [ms];note;Phi (deg)\n0;x;90\n1000;y;180\n",
        "time\tphi_deg\n0\t90\n1,0\t180,0\n",
        "\ufefftime_s,phi_deg\r\n0,90\r\n\r\n1,180\r\n",
    ],
    ids=["plain", "other units and order", "semicolons and a further column", "tabs and decimal commas", "spreadsheet"],
)
def test_the_same_table_written_differently(tmp_path, text):
    table = read(tmp_path, text, rising="time")
    assert table["time"] == pytest.approx([0, 1], abs=1e-15)
    assert table["phi"] == pytest.approx([math.pi / 2, math.pi], rel=1e-15)
    assert "phi_sd" not in table


def test_a_longer_name_is_another_column(tmp_path):
    table = read(tmp_path, "time_s,phi_sd_deg,phi_deg\n0,1,90\n1,,180\n")
    assert table["phi"][0] == pytest.approx(math.pi / 2)
    assert np.isnan(table["phi_sd"][1])


@pytest.mark.parametrize(
    ("text", "named"),
    [
        ("time_s,angle_deg\n0,1\n", "phi"),
        ("time_s,phi_N\n0,1\n", "phi_N"),
        ("time_s,phi_deg,phi_rad\n0,1,1\n", "phi_deg, phi_rad"),
        ("time_s,phi_deg\n0,nan\n", "line 2, phi_deg"),
        ("time_s,phi_deg\n0,1\n1,\n", "line 3, phi_deg"),
        ("time_s,phi_deg\n0,inf\n", "line 2"),
        ("time_s,phi_deg\n0,1\n\n0,2\n", "line 4, time"),
        ("time_s,phi_deg\n", "0 rows"),
        ("", "columns none"),
    ],
)
def test_what_is_wrong_is_named(tmp_path, text, named):
    with pytest.raises(InputError, match=named) as caught:
        read(tmp_path, text, rising="time")
    assert "\n" not in str(caught.value)


def test_too_few_rows_are_refused(tmp_path):
    with pytest.raises(InputError, match="at least 3 rows"):
        read(tmp_path, "time_s,phi_deg\n0,1\n1,2\n", least_rows=3)


@given(st.lists(st.floats(-1e6, 1e6), min_size=1, max_size=20))
def test_numbers_come_back(tmp_path_factory, values):
    path = tmp_path_factory.mktemp("t") / "t.csv"
    path.write_text("time_s,phi_rad\n" + "".join(f"{i},{v!r}\n" for i, v in enumerate(values)))
    assert read_table(path, COLUMNS, field="recording", example=EXAMPLE)["phi"].tolist() == values
