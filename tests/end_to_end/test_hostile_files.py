"""Files that are none of ours, or made to hurt, for every command that reads one: one line, exit status 2, soon."""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import av
import numpy as np
import pytest

from plategait.cli import main
from plategait.errors import InputError
from plategait.files.input import LARGEST_TABLE, LARGEST_TOML
from plategait.files.rows import MOST_COLUMNS
from plategait.model.presets import preset
from plategait.model.scenario_file import write_scenario
from plategait.vision.frames import open_video

COMMAND = str(Path(sys.executable).with_name("plategait"))
SECRET = "hunter2"
# A second is what the slowest takes; several, on a busy machine.
SECONDS = 20
LONGEST_LINE = 1500

CHEESE = write_scenario(preset("cheese").scenario)
HEADING = "frequency_hz,spin_rate_deg_s\n"

# Every way to name a file that is read: the command, and what the file's name ends in.
READERS = {
    "simulate": (["simulate", "FILE"], ".toml"),
    "--sheet": (["simulate", "cheese", "--sheet", "FILE"], ".toml"),
    "--with": (["simulate", "cheese", "--with", "FILE"], ".toml"),
    "scenario": (["scenario", "FILE"], ".toml"),
    "samples of a scenario": (["simulate", "samples.toml"], ".csv"),
    "picture of a scenario": (["simulate", "picture.toml"], ".png"),
    "curve": (["curve", "FILE"], ".toml"),
    "modes": (["modes", "FILE"], ".toml"),
    "fit": (["fit", "FILE"], ".csv"),
    "estimate": (["estimate", "FILE"], ".csv"),
    "estimate --scenario": (["estimate", "curve.csv", "--scenario", "FILE"], ".toml"),
    "sweep": (["sweep", "FILE"], ".toml"),
    "sweep --status": (["sweep", "FILE", "--status"], ".zarr"),
    "plot": (["plot", "FILE"], ".zarr"),
    "identify bending": (["identify", "bending", "FILE", "--mass", "1 g"], ".csv"),
    "identify compression": (["identify", "compression", "FILE"], ".csv"),
    "identify friction": (["identify", "friction", "FILE"], ".csv"),
    "identify modes": (["identify", "modes", "FILE"], ".csv"),
    "shoot": (["shoot", "FILE", "clip.mp4"], ".toml"),
    "track": (["track", "FILE"], ".mp4"),
    "track --calibration": (["track", "clip.mp4", "--calibration", "FILE"], ".json"),
}


def written(content: str | bytes):
    def make(path: Path) -> None:
        path.write_bytes(content if isinstance(content, bytes) else content.encode())

    return make


def linked(to: str):
    return lambda path: path.symlink_to(to)


def sparse(size: int):
    def make(path: Path) -> None:
        with open(path, "wb") as file:
            file.truncate(size)

    return make


HOSTILE = {
    "nothing there": lambda path: None,
    "empty": written(""),
    "a folder": lambda path: path.mkdir(),
    "a pipe": os.mkfifo,
    "zeros without end": linked("/dev/zero"),
    "noise without end": linked("/dev/urandom"),
    "a terminal": linked("/dev/tty"),
    "a dangling link": linked("nowhere"),
    "a link to itself": lambda path: path.symlink_to(path.name),
    "10 GB": sparse(10**10),
    "100 MB": sparse(10**8),
    "noise": written(random.Random(1).randbytes(10_000)),
    "UTF-16": written(CHEESE.encode("utf-16")),
    "passwords": written(f"root:$6${SECRET}:19000:0:99999:7:::\n" * 3),
    "settings": written(f'{SECRET.upper()} = "{SECRET}"\n[{SECRET}]\n{SECRET} = {SECRET}\n'),
    "a key": written(f"-----BEGIN KEY-----\n{SECRET},{SECRET}\n{SECRET},{SECRET}\n"),
    "JSON": written(f'{{"password": "{SECRET}"}}\n'),
    "terminal escapes": written("\x1b]0;owned\x07\x1b[2J,\x1b[31m\n\x1b[1m,\x1b[2m\n"),
    "nested": written("x = " + "[" * 100_000),
    "braces": written("[" * 100_000 + "]" * 100_000),
    "many digits": written("x = " + "9" * 5000),
    "long names": written("a." * 200_000 + "a = 1\n"),
    "one line": written("x" * 500_000),
    "blanks": written(" " * 500_000),
    "line ends": written("\r\n" * 100_000),
    "commas": written("," * 100_000),
    "quotes": written('"' * 300_001),
}

# Files of the right kind with something wrong in them.
SCENARIOS = {
    "a unit of many letters": CHEESE.replace('"24 Hz"', f'"24 {"Hz" * 5000}"'),
    "powers of units": CHEESE.replace('"24 Hz"', f'"24 {"m^9*" * 5000}m"'),
    "many blanks": CHEESE.replace('"24 Hz"', f'"24{" " * 100_000}Hz"'),
    "blanks and a bracket": CHEESE.replace('"24 Hz"', f'"24 {"(" * 50_000}Hz"'),
    "a field of escapes": CHEESE + '\n["\\u001b[2J\\u202e"]\nx = 1\n',
    "a shape of escapes": CHEESE.replace('"disk"', '"\\u001b[2J"'),
    "a field of many letters": f"{'x' * 1_000_000} = 1\n" + CHEESE,
    "a value of many letters": CHEESE.replace('"24 Hz"', f'"{"x" * 1_000_000}"'),
    "a pipe as picture": CHEESE.replace('shape = "disk"', 'shape = "mask"\nimage = "pipe"\nwidth_of_picture = 0.1'),
}
TABLES = {
    "a heading of blanks": f"frequency_hz{' ' * 100_000}(,spin_rate_deg_s\n1,2\n",
    "a heading of brackets": f"frequency{'[(' * 20_000},spin_rate_deg_s\n1,2\n",
    "a heading of pieces": f"frequency{'_a' * 50_000},spin_rate_deg_s\n1,2\n",
    "a heading of escapes": "frequency_hz,spin_rate_\x1b[2J\n1,2\n",
    "a unit of escapes": "frequency_hz,spin_rate (\x1b[2J)\n1,2\n",
    "a cell of escapes": HEADING + "14,\x1b[2J\n",
    "a cell of many letters": HEADING + f"14,{'9' * 200_000}\n",
    "a number of many digits": HEADING + f"14,{'9' * 100_000}\n",
    "many columns": HEADING.strip() + ",x" * MOST_COLUMNS + "\n1,2\n",
    "an open quote": HEADING + '14,"' + "x\n" * 100_000,
    "a gait of escapes": "frequency_hz,spin_rate_deg_s,gait\n14,100,\x1b[2J\n",
}


@pytest.fixture
def folder(tmp_path, monkeypatch) -> Path:
    (tmp_path / "curve.csv").write_text(HEADING + "".join(f"{f},{400 - (f - 21) ** 2}\n" for f in range(12, 30)))
    monkeypatch.chdir(tmp_path)
    return tmp_path


def refused(arguments: list[str], monkeypatch, capsys) -> str:
    """The one line with which a command refuses; a command that waits for something is woken up and fails."""

    def wake(number, frame):
        raise AssertionError(f"still at it after {SECONDS} s")

    monkeypatch.setattr(sys, "argv", [COMMAND, *arguments])
    previous = signal.signal(signal.SIGALRM, wake)
    signal.alarm(SECONDS)
    try:
        with pytest.raises(SystemExit) as status:
            main()
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, previous)
    out, err = capsys.readouterr()
    assert status.value.code == 2, err
    assert out == ""
    assert err.endswith("\n")
    line = err[:-1]
    assert line.isprintable(), "one line, without a control character"
    assert len(line) < LONGEST_LINE
    assert SECRET not in line.lower()
    return line


# Commands that read by the same function as another meet only some of it.
ALIKE = {
    *("--sheet", "scenario", "curve", "modes", "estimate --scenario", "shoot"), "estimate", "plot",
    *("identify compression", "identify friction", "identify modes"),
}  # fmt: skip
SOME = ("nothing there", "empty", "a pipe", "zeros without end", "passwords", "terminal escapes", "100 MB")


@pytest.mark.parametrize(
    ("reader", "harm"), [(reader, harm) for reader in READERS for harm in (SOME if reader in ALIKE else HOSTILE)]
)
def test_a_file_of_another_kind(reader, harm, folder, monkeypatch, capsys):
    arguments, suffix = READERS[reader]
    file = folder / f"hostile{suffix}"
    (folder / "samples.toml").write_text(CHEESE.replace("[motion]", f'[motion]\nsamples = "{file.name}"'))
    (folder / "picture.toml").write_text(
        CHEESE.replace('shape = "disk"', 'shape = "mask"').replace(
            "radius =", f'image = "{file.name}"\nwidth_of_picture ='
        )
    )
    HOSTILE[harm](file)
    before = sorted(os.listdir(folder))
    line = refused([file.name if a == "FILE" else a for a in arguments], monkeypatch, capsys)
    assert sorted(os.listdir(folder)) == before
    # What is TOML but lacks everything is told what it lacks.
    assert "hostile" in line or (suffix == ".toml" and harm in ("empty", "blanks", "line ends"))


@pytest.mark.parametrize("harm", SCENARIOS)
@pytest.mark.parametrize("reader", ["simulate", "--sheet", "scenario", "shoot"])
def test_a_scenario_with_something_odd_in_it(reader, harm, folder, monkeypatch, capsys):
    assert SCENARIOS[harm] != CHEESE
    os.mkfifo(folder / "pipe")
    (folder / "odd.toml").write_text(SCENARIOS[harm])
    refused(["odd.toml" if a == "FILE" else a for a in READERS[reader][0]], monkeypatch, capsys)


@pytest.mark.parametrize("harm", TABLES)
@pytest.mark.parametrize("reader", ["fit", "estimate", "identify modes"])
def test_a_table_with_something_odd_in_it(reader, harm, folder, monkeypatch, capsys):
    (folder / "odd.csv").write_text(TABLES[harm])
    refused(["odd.csv" if a == "FILE" else a for a in READERS[reader][0]], monkeypatch, capsys)


@pytest.mark.parametrize(
    "content",
    [
        'uncertainty = "x"\n[sheet]\nmass = "1 g"\n',
        '[sheet]\nmass = "1 g"\n[uncertainty]\nsd = [1]\n',
        '[sheet]\nmass = "1 g"\n[uncertainty]\ninterval = 3\n',
        '[sheet]\nmass = "1 g"\n[uncertainty]\nconfidence = "much"\n',
        '[sheet]\nmass = "1 g"\n[uncertainty]\nconfidence = []\n',
        '[sheet]\nmass = "1 g"\n[uncertainty.sd]\n"sheet.mass" = "-1 g"\n',
        '[sheet]\nmass = "1 g"\nthickness = "1 mm"\n[uncertainty]\ncorrelation = [[1, nan], [nan, 1]]\n',
        '[sheet]\nmass = "1 g"\npitch = "9 mm"\nthickness = "1 mm"\n[uncertainty]\n'
        "correlation = [[1, 0.9, -0.9], [0.9, 1, 0.9], [-0.9, 0.9, 1]]\n",
        "[sheet]\nmass = { x = 1 }\n",
        "[[sheet]]\nmass = 1\n",
    ],
)
def test_a_fragment_with_something_odd_in_it(content, folder, monkeypatch, capsys):
    (folder / "odd.toml").write_text(content)
    refused(["simulate", "cheese", "--with", "odd.toml", "--draws", "2"], monkeypatch, capsys)


@pytest.mark.parametrize("number", ["1e999", "-1e999", "NaN", '"x"', "[]", "[[1]]", "null", "9" * 5000, "true"])
def test_a_calibration_with_something_odd_in_it(number, folder, monkeypatch, capsys):
    (folder / "odd.json").write_text(
        f'{{"width": {number}, "height": 720, "matrix": [[900, 0, 640], [0, 900, 360], [0, 0, 1]], "distortion": [0]}}'
    )
    assert "odd.json" in (line := refused(["track", "clip.mp4", "--calibration", "odd.json"], monkeypatch, capsys)) or (
        "width" in line
    )


@pytest.mark.parametrize("content", ["", "clip\n", "clip,frequency_hz\n", "clip,frequency_hz\na,\x1b[2J\n", SECRET])
def test_frequencies_with_something_odd_in_them(content, folder, monkeypatch, capsys):
    (folder / "clips").mkdir()
    (folder / "clips" / "24Hz.mp4").write_text("")
    (folder / "odd.csv").write_text(content)
    refused(["track", "clips", "--curve", "c.csv", "--frequencies", "odd.csv"], monkeypatch, capsys)


def test_names_with_escapes_are_printed_as_text(folder, monkeypatch, capsys):
    (folder / "\x1b[2J.toml").write_text(CHEESE.replace('name = "', 'name = "\\u001b]0;owned\\u0007\\u202e', 1))
    for arguments in (["scenario"], ["scenario", "--json"], ["simulate", "--duration", "0.1 s"], ["modes"]):
        monkeypatch.setattr(sys, "argv", [COMMAND, arguments[0], "\x1b[2J.toml", *arguments[1:]])
        with pytest.raises(SystemExit) as status:
            main()
        out, err = capsys.readouterr()
        assert (status.value.code, err) == (0, "")
        assert out.replace("\n", "").isprintable()


def test_the_largest_files_are_read(folder, monkeypatch, capsys):
    # A minute at 1 kHz, and a comment as long as allowed.
    rows = "".join(f"{i / 1000:.3f},{np.sin(i / 50):.6f}\n" for i in range(60_000))
    (folder / "samples.csv").write_text("time_s,x_mm\n" + rows)
    text = CHEESE.replace("[motion]", '[motion]\nsamples = "samples.csv"')
    (folder / "long.toml").write_text(text + "#" * (LARGEST_TOML - len(text.encode())))
    monkeypatch.setattr(sys, "argv", [COMMAND, "scenario", "long.toml"])
    with pytest.raises(SystemExit) as status:
        main()
    assert status.value.code == 0, capsys.readouterr().err
    assert "cheese" in capsys.readouterr().out


@pytest.mark.parametrize("pixels", [9400, 11_000])
def test_a_large_picture_is_read_once_in_bounded_memory(pixels, folder):
    from PIL import Image

    picture = Image.new("1", (pixels, pixels), 1)
    picture.paste(0, (1000, 1000, 8000, 8000))
    picture.save(folder / "large.png")
    program = (
        "import resource, sys; from pathlib import Path; from plategait.errors import InputError\n"
        "import plategait.model.outline as o, plategait.files.input as i\n"
        "read, o.read_bytes = [], lambda *a: (read.append(a), i.read_bytes(*a))[1]\n"
        "try:\n    m = o.Mask(width_of_picture='94 mm', image=Path('large.png')); print(m.size(), len(read))\n"
        "    print(o.occupied_squares(m, 0.01).sum())\n"
        "except InputError as error:\n    sys.exit(str(error))\n"
        "print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024)"
    )
    done = subprocess.run([sys.executable, "-c", program], cwd=folder, capture_output=True, text=True,
                          timeout=60, check=False)  # fmt: skip
    if pixels > 10_000:
        assert done.returncode == 1
        assert "million pixels" in done.stderr
        assert len(done.stderr.splitlines()) == 1
        return
    size, squares, megabytes = done.stdout.splitlines()
    assert size == "(0.07, 0.07) 1"
    assert squares == "49"
    # Two bytes a pixel as they are decoded, and a few flags of one.
    assert int(megabytes) < 1000


@pytest.mark.parametrize("reader", ["simulate", "fit", "track", "picture of a scenario"])
@pytest.mark.parametrize("harm", ["a pipe", "zeros without end"])
def test_the_installed_command_waits_for_nothing(reader, harm, folder):
    arguments, suffix = READERS[reader]
    HOSTILE[harm](folder / f"hostile{suffix}")
    (folder / "picture.toml").write_text(
        CHEESE.replace('shape = "disk"', 'shape = "mask"').replace(
            "radius =", 'image = "hostile.png"\nwidth_of_picture ='
        )
    )
    begun = time.monotonic()
    done = subprocess.run([COMMAND, *[f"hostile{suffix}" if a == "FILE" else a for a in arguments]], cwd=folder,
                          capture_output=True, text=True, timeout=SECONDS, check=False)  # fmt: skip
    assert time.monotonic() - begun < SECONDS
    assert (done.returncode, done.stdout, len(done.stderr.splitlines())) == (2, "", 1)
    assert "hostile" in done.stderr


def test_a_table_as_large_as_allowed_takes_bounded_memory(folder):
    with open(folder / "large.csv", "w", encoding="utf-8") as file:
        file.write(HEADING)
        file.write(("10,20" + "," * 20 + "\n") * (LARGEST_TABLE // 27))
    limit = "import resource; resource.setrlimit(resource.RLIMIT_AS, (3 << 30, 3 << 30))"
    code = f"{limit}; from plategait.cli import main; main()"
    done = subprocess.run([sys.executable, "-c", code, "fit", "large.csv"], cwd=folder, capture_output=True, text=True,
                          timeout=60, check=False)  # fmt: skip
    assert done.returncode == 2
    assert "more than" in done.stderr


def test_a_playlist_that_calls_itself_a_film_opens_nothing_else(tmp_path):
    """To FFmpeg a playlist is a video: it would open what stands in it."""
    (tmp_path / "clip.mp4").write_text("ffconcat version 1.0\nfile other.ts\n")
    with av.open(str(tmp_path / "other.ts"), "w", format="mpegts") as container:
        stream = container.add_stream("mpeg2video", rate=25)
        stream.width = stream.height = 64
        for _ in range(25):
            container.mux(stream.encode(av.VideoFrame.from_ndarray(np.zeros((64, 64, 3), np.uint8))))
        container.mux(stream.encode())
    with pytest.raises(InputError, match="a video that can be read"), open_video(tmp_path / "clip.mp4"):
        pass
    with open_video(tmp_path / "other.ts") as video:
        assert (video.width, video.height) == (64, 64)
