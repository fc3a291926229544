"""What clumsy strangers type: each line is answered by one line that names what they typed and says what to type."""

from __future__ import annotations

import re
import shlex
import sys
from pathlib import Path

import pytest

from plategait.cli import main

SHEET = 'mass = "6 g"\nbending_stiffness = "3e-3 N*mm/deg"\naxial_stiffness = "0.8 N/mm"\n'
FILES = {
    "peak.csv": "frequency_hz,spin_rate_deg_s\n14,90\n18,170\n22,380\n25,520\n28,390\n30,270\n",
    "told.csv": "frequency_hz,spin_rate_deg_s,angle_deg\n14,90,3\n18,170,12\n22,380,3\n25,520,3\n28,390,3\n30,270,3\n",
    "polygon.toml": f'[sheet]\n{SHEET}outline = {{shape = "polygon", corners = [[0, 0], [60, 0], [0, 60]]}}\n',
    "disk.toml": f'[sheet]\n{SHEET}outline = {{shape = "disk", radius = 40}}\n',
    "heavy.toml": f'[sheet]\n{SHEET}outline = {{shape = "disk", radius = 0.04}}\n'.replace('"6 g"', "13.6"),
    "wobble.toml": f'[motion]\nwobble = 3\n[sheet]\n{SHEET}outline = {{shape = "disk", radius = "40 mm"}}\n',
    "deep.toml": "a = " + "[" * 100_000 + "]" * 100_000,
    "deep.json": "[" * 100_000 + "]" * 100_000,
    "digits.toml": "duration = " + "9" * 5000,
    "clip.mp4": "no film",
}  # fmt: skip

# What is typed, and words of the answer in their order.
LINES = [
    # Units left out, loose, or of another case
    ("simulate --angle 3", '--angle … 3 rad … bare number is SI … try "3 deg"'),
    ("simulate --angle -12", '--angle … -12 rad … try "-12 deg"'),
    ("curve --angle 12", '--angle … 12 rad … try "12 deg"'),
    ("shoot cheese x.mp4 --angle 3", '--angle … try "3 deg"'),
    ("simulate --stroke 3", '--stroke … 3 m, … try "3 mm"'),
    ("simulate cheese --angle 3 deg --stroke 3 mm", 'try quotes: "3 deg"'),
    ("simulate --frequency 24 Hz", 'try quotes: "24 Hz"'),
    ("simulate cheese --frequency 24 hz", 'try quotes: "24 hz"'),
    ("modes cheese --natural-frequency 10 pi rad/s", 'try quotes: "10 pi rad/s"'),
    ("estimate peak.csv --angle 3 deg", 'try quotes: "3 deg"'),
    ("simulate --frequency '24 mhz'", '--frequency … try "24 Hz"'),
    ("simulate --stroke '3 Mm'", '--stroke … try "3 mm"'),
    ("simulate --natural-frequency '10 pi'", '--natural-frequency … try "10 pi rad/s"'),
    ("estimate peak.csv --mass 13.6", '--mass … 13.6 kg … try "13.6 g"'),
    ("estimate peak.csv --radius 40", '--radius … 40 m, … try "40 mm"'),
    ("estimate peak.csv --slip-limit 20", '--slip-limit … try "20 mm"'),
    ("track clip.mp4 --plate-size 100", '--plate-size … 100 m, … try "100 mm"'),
    ("track clip.mp4 --scale 0.2", '--scale … try "0.2 mm"'),
    ("track-strip clip.mp4 --link-length 10", '--link-length … try "10 mm"'),
    ("target t.pdf --fiducial 16", '--fiducial … try "16 mm"'),
    ("target t.pdf --plate-size '100 mm x'", "--plate-size … '100 mm x' … x between"),
    ("simulate polygon.toml", 'sheet.outline.corners.1.0 … 60 m, … try "60 mm"'),
    ("simulate disk.toml", 'sheet.outline.radius … 40 m, … try "40 mm"'),
    ("simulate heavy.toml", 'sheet.mass … 13.6 kg … try "13.6 g"'),
    ("simulate --mu-s 75%", '--mu-s … try "0.75"'),
    ("estimate peak.csv --height '5 ± 1'", '--height … 5 m … try "5 mm"'),
    ("estimate peak.csv --height '5 ± 1 mm' --fixed plate_height", "--fixed … plate_height"),
    ("estimate peak.csv --thickness '2 mm ± thin'", "--thickness … thin"),
    ("estimate peak.csv --fixed c_b", "--fixed … c_b … bending_damping"),
    ("estimate peak.csv --free bending_damping", "--free … bending_damping … mass"),
    ("estimate peak.csv --next --candidate-angle '6:1 deg'", "--candidate-angle … lower first"),
    ("estimate peak.csv --next --candidate-phase '1:9 mm'", "--candidate-phase … deg"),
    ("estimate peak.csv --candidate-phase '90 deg'", "--candidate-phase … --next"),
    ("estimate peak.csv --next --machine nofile.toml", "--machine … nofile.toml"),
    ("estimate peak.csv --confidence 100%", "--confidence … below 1"),
    # Files that are not there, or are something else
    ("fit nofile.csv", "nofile.csv … file"),
    ("estimate nofile.csv", "nofile.csv … file"),
    ("simulate nofile.toml", "nofile.toml … file"),
    ("simulate --with nofile.toml", "--with … nofile.toml … file"),
    ("simulate --sheet nofile.toml", "--sheet … nofile.toml"),
    ("identify friction nofile.csv", "nofile.csv … file"),
    ("track nofile.mp4", "nofile.mp4 … exists"),
    ("track .", "try plategait track-folder ."),
    ("track-folder nofolder", "nofolder … folder of clips"),
    ("track-strip .", "video file"),
    ("sweep nofile.toml", "nofile.toml"),
    ("sweep nofile.toml --status", "nofile.zarr"),
    ("plot peak.csv", "peak.csv … .zarr"),
    ("sweep /", "sweep … '/ (a folder)'"),
    ("sweep / --status", "store"),
    (f"sweep {'x' * 5000}", "too long … sweep file"),
    (f"sweep {'x' * 5000} --status", "store"),
    (f"plot {'x' * 5000}.zarr", "store"),
    (f"track {'x' * 5000}", "video … exists"),
    (f"track-folder {'x' * 5000}", "FOLDER … folder of clips"),
    ("simulate peak.csv", "peak.csv … TOML"),
    ("simulate deep.toml", "deep"),
    ("simulate digits.toml", "digits"),
    ("simulate --with deep.toml", "deep"),
    ("sweep deep.toml", "deep"),
    ("track clip.mp4 --calibration deep.json", ""),
    # Names
    ("simulate pancak", "'pancak' … try pancake"),
    ("simulate Cheese", "try cheese"),
    ("simulate ''", "try cheese"),
    ("simulate --sheet dumpling", "--sheet … try dumpling-skin"),
    ("scenario --print dumpling", "--print … try dumpling-skin"),
    ("simulat cheese", "simulat … simulate … try plategait simulate"),
    ("simulate wobble.toml", "motion.wobble … one of frequency … try leaving it out"),
    ("simulate --freq 24", "--freq … plategait simulate … try --frequency"),
    ("simulate --weight 3", "--weight … try plategait simulate --help"),
    ("modes --angle 3", "--angle … try plategait modes --help"),
    ("identify foo", "foo … try plategait identify --help"),
    ("identify", "try plategait identify --help"),
    ("x" * 5000, "command … one of simulate … try plategait --help"),
    (f"identify {'x' * 5000}", "command … one of bending … try plategait identify --help"),
    (f"simulate cheese {'é' * 5000}", "try plategait simulate --help"),
    (f"simulate --engine {'x' * 5000}", "--engine … one of cpu … try cpu"),
    ("identify bending --foo", "--foo … try plategait identify bending --help"),
    ("thesis fig5.70", "fig5.70 … try fig5.7"),
    # Values
    ("simulate --repeats many", "--repeats … many … whole number … try 1"),
    ("simulate --repeats", "--repeats … try plategait simulate --help"),
    (f"simulate --repeats {'9' * 5000}", "--repeats"),
    ("simulate --repeats 1000000", "--repeats … 1 to 100000"),
    ("simulate --repeats 0", "--repeats … 0 … whole number"),
    ("simulate --repeats 2 --seed -1", "--seed … -1"),
    ("simulate --engine gpu", "--engine … gpu … one of cpu … try cpu"),
    ("simulate --mu-k 0.9", "--mu-k … 0.9 … 0.75"),
    ("simulate --mu-s 0.3 --mu-k 0.4", "--mu-k … 0.4 … 0.3"),
    ("simulate --friction-law coulomb", "--friction-law … thesis … adams"),
    ("simulate --dt 1", "--dt … 1 s"),
    ("curve --frequency 12-30", '--frequency … 12-30 … try "12:30:1Hz"'),
    ("curve --frequency 30:12:1Hz", "--frequency … last not below first"),
    ("fit", "CURVE.csv … try plategait fit curve.csv"),
    ("identify example", "KIND … try plategait identify example KIND FILE.csv"),
    ("estimate peak.csv --beta 2", "--beta … 2"),
    ("estimate peak.csv --noise 5", "--noise … 0.05"),
    ("estimate peak.csv --method magic", "--method … magic … linear"),
    ("estimate peak.csv --method linear --radius '42 mm'", "--radius … a disk of 42 mm … a disk of 40 mm"),
    ("estimate told.csv --method linear", "3 and 12 deg … one amplitude … try --method posterior"),
    ("estimate peak.csv --method quadratic --coefficients published", "--coefficients … try refitted"),
    ("estimate peak.csv --method any-size --radius '20 mm'", "CURVE.csv … 14 to 30 Hz … or to 40.3 Hz"),
    ("estimate peak.csv --method any-size --coefficients refitted", "--coefficients … any-size"),
    ("identify modes peak.csv --support hanging", "--support … hanging … cantilever"),
    ("shoot cheese x.mp4 --elevation 0", "--elevation … 90"),
    ("shoot cheese x.mp4 --crf 99", "--crf … 99 … 51"),
    ("track clip.mp4 --plate foo", "--plate … foo … outline"),
    ("track 0 --fps 30", "--fps … left out with a camera"),
    # What would change nothing
    ("simulate --seed 3", "--seed … left out where nothing is left to chance … try --repeats"),
    ("simulate --draws 3", "--draws … left out … try --with"),
    ("scenario cheese --print pancake", "FILE … cheese … left out with --print"),
    ("sweep nofile.toml --status --store x.zarr", "--store … try plategait sweep x.zarr --status"),
]  # fmt: skip

# Words that only the makers understand.
INTERNAL = re.compile(r"Traceback|shape='|PosixPath|object at 0x|<class|pydantic|Value error|NoneType|\bself\b")


@pytest.fixture(scope="module")
def files(tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("files")
    for name, text in FILES.items():
        (folder / name).write_text(text)
    return folder


@pytest.mark.parametrize(("line", "answer"), LINES, ids=[line[:60] for line, _ in LINES])
def test_a_wrong_line_is_answered_by_one_that_helps(line, answer, files, monkeypatch, capsys):
    monkeypatch.chdir(files)
    monkeypatch.setattr(sys, "argv", ["plategait", *shlex.split(line)])
    with pytest.raises(SystemExit) as end:
        main()
    out, err = capsys.readouterr()
    assert end.value.code == 2, err
    assert out == ""
    assert len(err.splitlines()) == 1, err
    assert err.startswith("plategait: ")
    assert re.search(".*?".join(re.escape(words.strip()) for words in answer.split("…")), err), err
    assert not INTERNAL.search(err)
    assert "; try " in err
    assert len(err) < 1000
    assert sorted(p.name for p in files.iterdir()) == sorted(FILES)


@pytest.mark.parametrize("line", ["-h", "simulate -h", "identify bending -h", "track-folder --help"])
def test_help_is_asked_for_in_two_ways(line, monkeypatch, capsys):
    monkeypatch.setattr(sys, "argv", ["plategait", *shlex.split(line)])
    with pytest.raises(SystemExit) as end:
        main()
    assert end.value.code == 0
    assert "Usage" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("raised", "words"),
    [(MemoryError(), "memory"), (RecursionError("maximum recursion depth exceeded"), "deep"),
     (ValueError("Exceeds the limit (4300 digits) for integer string conversion"), "digits")],
    ids=["memory", "recursion", "digits"],
)  # fmt: skip
def test_what_escapes_a_command_is_one_line(raised, words, monkeypatch, capsys):
    def fail(*given, **named):
        raise raised

    monkeypatch.setattr("plategait.simulation.run.simulate", fail)
    monkeypatch.setattr(sys, "argv", ["plategait", "simulate"])
    with pytest.raises(SystemExit) as end:
        main()
    out, err = capsys.readouterr()
    assert (end.value.code, out) == (2, "")
    assert len(err.splitlines()) == 1
    assert words in err
    assert "; try " in err
