"""The installed command draws: plots, a film, a filmstrip, each a file that opens."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import av
import pytest
from PIL import Image

COMMAND = str(Path(sys.executable).with_name("plategait"))


def run(*arguments: str, cwd: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run([COMMAND, *arguments], capture_output=True, text=True, cwd=cwd, timeout=120, check=False)


def test_simulate_writes_every_picture_and_the_data(tmp_path):
    done = run(
        "simulate", "cheese", "--duration", "0.15 s", "--frequency", "12 Hz", "--angle", "12 deg", "--plot", "run.png",
        "--film", "run.mp4", "--filmstrip", "strip.png", "--out", "run.nc", cwd=tmp_path,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert sorted(path.name for path in tmp_path.iterdir()) == ["run.mp4", "run.nc", "run.png", "strip.png"]
    for name in ("run.png", "strip.png"):
        with Image.open(tmp_path / name) as picture:
            assert picture.width > 800
            assert len(picture.convert("L").getcolors(100_000)) > 20, "not blank"
    with av.open(str(tmp_path / "run.mp4")) as film:
        assert film.streams.video[0].codec_context.name == "h264"
        assert sum(1 for _ in film.decode(video=0)) > 10


@pytest.mark.parametrize("suffix", ["png", "pdf", "svg"])
def test_curve_and_modes_plot(called, tmp_path, suffix):
    # Too short and coarse for a Lorentz fit: status 1, and drawn all the same.
    curve = ("curve", "--duration", "0.2 s", "--frequency", "14:26:4Hz")
    called(*curve, "--plot", f"c.{suffix}", cwd=tmp_path, check=1)
    called("modes", "--plot", f"m.{suffix}", cwd=tmp_path, check=0)
    for name in ("c", "m"):
        assert (tmp_path / f"{name}.{suffix}").stat().st_size > 3000


@pytest.mark.parametrize(("option", "name"), [("--film", "a.gif"), ("--plot", "a.txt"), ("--filmstrip", "gone/a.png")])
def test_a_picture_that_cannot_be_written_is_refused_before_any_work(called, tmp_path, option, name):
    done = called("simulate", "--duration", "1000 s", option, name, cwd=tmp_path, check=2)
    assert len(done.stderr.strip().splitlines()) == 1
    assert option in done.stderr
    assert not list(tmp_path.iterdir())
