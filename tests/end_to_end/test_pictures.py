"""The installed command draws: plots, a film, a filmstrip, each a file that opens."""

from __future__ import annotations

import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path

import av
import pytest
from PIL import Image

from plategait.cli import report

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


@pytest.fixture
def bars(monkeypatch) -> dict[str, list[float]]:
    """What bars of progress there were, and which fractions they were told."""
    told: dict[str, list[float]] = {}

    @contextmanager
    def bar(what: str):
        yield told.setdefault(what, []).append

    monkeypatch.setattr(report, "progress_bar", bar)
    return told


@pytest.mark.parametrize("typed", [
    ("simulate", "cheese", "--duration", "0.04 s", "--film", "f.mp4"),
    ("shoot", "cheese", "f.mp4", "--seconds", "0.2", "--size", "320x240"),
])  # fmt: skip
def test_progress_is_told_while_a_film_is_drawn(called, bars, tmp_path, typed):
    called(*typed, cwd=tmp_path, check=0)
    for what in ("simulating", "filming"):
        assert bars[what][-1] == pytest.approx(1.0)
        assert bars[what] == sorted(bars[what])
    assert len(bars["filming"]) > 3


def test_progress_is_told_while_the_dissertation_s_figures_are_made_and_drawn(called, bars, tmp_path):
    called("thesis", "fig2.6", "fig5.3", cwd=tmp_path, check=0)
    assert bars == {"simulating": [0.5, 1.0], "drawing": [0.5, 1.0]}


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
