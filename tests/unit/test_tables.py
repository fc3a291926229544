"""Tables on terminals: what is narrow is told in other lines, and no number is cut or broken."""

from __future__ import annotations

import re

import pytest

from plategait.cli.tables import print_table

COLUMNS = ["", "position", "acceleration", "load"]
ROWS = [["x", "3 mm of 3", "1.076e+04 m/s²", "3.726 N"], ["rx", "3 deg of 24", "6.899e+04 deg/s²", ""]]


@pytest.fixture
def printed(monkeypatch, capsys):
    def at(width: int | None, *table) -> list[str]:
        monkeypatch.delenv("COLUMNS", raising=False)
        if width is not None:
            monkeypatch.setenv("COLUMNS", str(width))
        print_table(*table)
        return capsys.readouterr().out.splitlines()

    return at


@pytest.mark.parametrize("width", [30, 45, 60, 80, 200])
def test_every_cell_is_whole_and_in_one_line(printed, width):
    lines = printed(width, "what it needs [of x]", COLUMNS, ROWS)
    assert max(map(len, lines)) <= width
    for cell in (cell for row in ROWS for cell in row if cell):
        assert any(cell in line for line in lines), cell
    assert "…" not in "".join(lines)
    assert "what it needs [of x]" in " ".join(lines)


def test_a_row_too_wide_becomes_lines_under_what_it_is_of(printed):
    lines = printed(30, "t", ["mode", "shape", "rate"], [["1", "twist", "a rate of 0.00 rad/s"]])
    assert lines == ["t", "", "mode 1", "  shape  twist", "  rate   a rate of 0.00 rad/s", ""]


def test_headings_go_on_in_the_next_line_before_any_cell_does(printed):
    columns, row = ["", "goal", "turned off by", "number of pulses"], ["1", "5 mm, 0 mm, any angle", "2.1 deg", "4"]
    lines = printed(46, "t", columns, [row])
    assert [line for line in lines if all(cell in line for cell in row)]


def test_without_headings_a_row_s_values_stand_in_one_line(printed):
    lines = printed(48, "t", ["", "", ""], [["bending stiffness", "0.00279 (0.0027 to 0.0029)", "N*mm/deg"]])
    assert lines[2:4] == ["bending stiffness", "  0.00279 (0.0027 to 0.0029) N*mm/deg"]


def test_values_of_two_columns_go_on_in_the_next_line_at_a_space(printed):
    lines = printed(40, "t", ["", ""], [["fastest spin", "589.0 deg/s at motion.frequency 27 Hz and more of it"]])
    body = " ".join(" ".join(lines[3:]).replace("fastest spin", "").split())
    assert body.endswith("589.0 deg/s at motion.frequency 27 Hz and more of it")


def test_a_pipe_is_as_wide_as_the_table_needs(printed):
    wide = ["x" * 60, "y" * 60, "z" * 60]
    lines = printed(None, "t", ["a", "b", "c"], [wide])
    assert any(re.search(r"x{60}\s+y{60}\s+z{60}", line) for line in lines)
