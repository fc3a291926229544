"""Forty misuses of the command line that a newcomer makes: one line each, with field, what was got, and what to type.

`test_command_lines.py` has a hundred more; these are the ones that were found to say too little.
"""

from __future__ import annotations

import re
import shlex
import sys
import zipfile
from pathlib import Path

import pytest

from plategait.cli import main

SHEET = 'mass = "6 g"\nbending_stiffness = "3e-3 N*mm/deg"\naxial_stiffness = "0.8 N/mm"\n'
PEAK = "frequency_hz,spin_rate_deg_s\n14,90\n18,170\n22,380\n25,520\n28,390\n30,270\n"
PLAN = 'scenario = "cheese"\n{}[grid]\n"motion.frequency" = {}\n'
FILES = {
    "peak.csv": PEAK,
    "commas.csv": PEAK.replace("14,90", "14,5,90,25"),
    "words.csv": PEAK.replace("90", "fast"),
    "zero.csv": PEAK.replace("14", "0"),
    "bare.csv": "0,0\n10,0\n0,10\n",
    "crossed.csv": "x_mm,y_mm\n0,0\n80,80\n80,0\n0,80\n",
    "comma.toml": f"duration = 4,5\n[sheet]\n{SHEET}",
    "loose.toml": f'[sheet]\n{SHEET}outline = {{ shape = "disk", radius = 40 mm }}\n',
    "circle.toml": f'[sheet]\n{SHEET}outline = {{ shape = "circle", radius = "40 mm" }}\n',
    "diameter.toml": f'[sheet]\n{SHEET}outline = {{ shape = "disk", diameter = "80 mm" }}\n',
    "steps.toml": PLAN.format("", '{ from = "10 Hz", to = "30 Hz", steps = 5 }'),
    "three.toml": PLAN.format('repeats = "three"\n', '["20 Hz"]'),
    "shaker.toml": 'x = { accel = "50 m/s^2" }\n',
}

# What is typed: the field, what was got, and what to type instead.
MISUSES = [
    # Units: none, a comma for the point, one of something else
    ("simulate --angle 1", "--angle", "1 rad, as a bare number is SI", '"1 deg"'),
    ("simulate --mass 5", "--mass", "5 kg, as a bare number is SI", '"5 g"'),
    ("simulate --young '0.5 MPa' --thickness 1", "--thickness", "1 m, as", '"1 mm"'),
    ("estimate peak.csv --thickness 2.5", "--thickness", "2.5 m, as", '"2.5 mm"'),
    ("optimize --spin 300", "--spin", "300 rad/s, as", '"300 deg/s"'),
    ("optimize --spin '300 Hz'", "--spin", "300 Hz", '"300 deg/s"'),
    ("moves --cell-along 40", "--cell-along", "40 m/s, as", '"40 mm/s"'),
    ("moves --cell-turn '90 mm/s'", "--cell-turn", "90 mm/s", '"300 deg/s"'),
    ("steer --to '50 mm, 20 mm, 90'", "--to", "90 rad, as", '"90 deg"'),
    ("simulate --frequency '24,5 Hz'", "--frequency", "24,5 Hz", '"24.5 Hz"'),
    ("estimate peak.csv --mass 13,6g", "--mass", "13,6g", '"13.6g"'),
    ("export --out m.csv --rate 0", "--rate", "0", '"1 kHz"'),
    # Ranges and shapes
    ("curve --frequency 10:30", "--frequency", "10:30", '"10:30:1Hz"'),
    ("curve --frequency 0:30:5Hz", "--frequency", "0:30:5Hz", '"1:30:1Hz"'),
    ("optimize --frequency '10-30 Hz'", "--frequency", "10-30 Hz", '"10:30 Hz"'),
    ("optimize --frequency 30:10Hz", "--frequency", "30 Hz to 10 Hz", '--frequency "10:30 Hz"'),
    ("steer --to '0 mm, 0 mm' --dark 2:1s", "--dark", "from 2 s to 1 s", '"1:1.5 s"'),
    ("modes --outline 'disk 40'", "--outline", "40 m, as", '"disk 40 mm"'),
    ("modes --outline 'square 40 mm'", "--outline", "square 40 mm", '"rectangle 40 mm"'),
    ("modes --outline 'rectangle 40 by 60 mm'", "--outline", "40 by 60 mm", '"rectangle 40 x 60 mm"'),
    ("modes --outline crossed.csv", "--outline", "2 separate pieces", "corners in their order around it"),
    ("lab --plate-size '150 mm by 100 mm'", "--plate-size", "150 mm by 100 mm", '"150 mm x 100 mm"'),
    # Files of another kind, or with something wrong in them
    ("fit renamed.csv", "curve", "renamed.csv (a workbook", "saving the sheet as renamed.csv"),
    ("identify friction lab.xlsx", "lab.xlsx", "lab.xlsx (a workbook", "saving the sheet as lab.csv"),
    ("fit picture.csv", "curve", "picture.csv (a picture)", "frequency_hz,spin_rate_deg_s"),
    ("estimate commas.csv", "commas.csv line 2", "4 cells under 2 headings", "a decimal point, or semicolons"),
    ("estimate-all zero.csv --out many.toml", "--out", "many.toml", "many.csv"),
    ("shoot comma.toml clip.mp4", "scenario", "comma.toml (no TOML at line 1", "a point: 4.5"),
    ("simulate loose.toml", "scenario", "loose.toml (no TOML at line 5", 'quotes: "40 mm"'),
    ("simulate circle.toml", "sheet.outline.shape", "circle", '"disk"'),
    ("scenario diameter.toml", "sheet.outline.diameter", "nothing known by that name", "radius, half of it"),
    ("sweep steps.toml", "motion.frequency", "a table of from, to, steps", '{ from = "10 Hz", to = "30 Hz", count'),
    ("sweep three.toml", "repeats", "three", "3"),
    ("needs --machine shaker.toml", "x.accel", "nothing known by that name", "acceleration"),
    # Words that the parser takes first
    ("simulate --repeats 2.5", "--repeats", "2.5", "1"),
    ("modes --count 0", "--count", "0", "8"),
    ("simulate --engine GPU", "--engine", "GPU", "cpu"),
    ("shoot cheese c.mp4 --hidden 40", "--hidden", "40.0", "0.4"),
    ("needs --young '0.5 MPa'", "--young", "nothing that plategait needs knows", "plategait needs --help"),
    ("curve --freq 24", "--freq", "nothing that plategait curve knows", "--frequency"),
    ("export cheese", "--out", "nothing", "plategait export cheese --out motion.csv"),
    ("track_strip film.mp4", "command", "track_strip", "plategait track-strip"),
    ("study sources", "command", "sources", "plategait study source"),
]  # fmt: skip


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("misuse")
    for name, text in FILES.items():
        (folder / name).write_text(text)
    with zipfile.ZipFile(folder / "lab.xlsx", "w") as workbook:
        workbook.writestr("xl/workbook.xml", "<workbook/>")
    (folder / "renamed.csv").write_bytes((folder / "lab.xlsx").read_bytes())
    (folder / "picture.csv").write_bytes(b"\x89PNG\r\n\x1a\n" + bytes(range(256)))
    return folder


@pytest.mark.parametrize(("line", "field", "got", "instead"), MISUSES, ids=[row[0] for row in MISUSES])
def test_a_misuse_is_one_line_that_says_what_to_type(line, field, got, instead, folder, monkeypatch, capsys):
    monkeypatch.chdir(folder)
    monkeypatch.setattr(sys, "argv", ["plategait", *shlex.split(line)])
    before = sorted(folder.iterdir())
    with pytest.raises(SystemExit) as end:
        main()
    out, err = capsys.readouterr()
    assert (end.value.code, out) == (2, ""), err
    told = re.fullmatch(
        r"plategait: (?P<field>.+?): got '?(?P<got>.+?)'?, must be (?P<allowed>.+); try (?P<hint>.+)\n", err
    )
    assert told, err
    assert told["field"] == field
    assert told["got"].startswith(got)
    assert told["hint"].startswith(instead)
    assert sorted(folder.iterdir()) == before
