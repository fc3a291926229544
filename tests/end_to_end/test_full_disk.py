"""A disk that is full, or too little memory: one line, exit status 2, nothing left behind."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

resource = pytest.importorskip("resource", reason="limits of a process are Unix's")

COMMAND = str(Path(sys.executable).with_name("plategait"))
CURVE = "frequency_hz,spin_rate_deg_s\n" + "".join(f"{f},{400 - (f - 21) ** 2}\n" for f in range(12, 30))
RUN = ("simulate", "cheese", "--duration", "0.1 s")


def limited(limit: int, *arguments: str, cwd: Path, of: int = resource.RLIMIT_FSIZE) -> str:
    """The one line of a command that may write files of so many bytes only, which fail like those on a full disk."""
    done = subprocess.run(
        [COMMAND, *arguments], cwd=cwd, capture_output=True, text=True, timeout=120, check=False,
        env=os.environ | {"PYTHONDONTWRITEBYTECODE": "1"},
        preexec_fn=lambda: resource.setrlimit(of, (limit, limit)),
    )  # fmt: skip
    assert done.returncode == 2, done.stderr
    assert len(done.stderr.splitlines()) == 1, done.stderr
    return done.stderr


@pytest.mark.parametrize(
    "arguments",
    [
        (*RUN, "--out", "run.nc"),
        (*RUN, "--plot", "run.png"),
        ("simulate", "cheese", "--duration", "0.05 s", "--film", "run.mp4"),
        (*RUN, "--filmstrip", "run.png"),
        ("curve", "cheese", "--duration", "0.2 s", "--frequency", "14:44:1Hz", "--out", "curve.csv"),
        ("identify", "example", "bending", "example.csv"),
        ("target", "target.pdf"),
        ("shoot", "cheese", "clip.mp4", "--seconds", "0.2"),
    ],
    ids=lambda arguments: f"{arguments[0]} {arguments[-1]}",
)
def test_a_full_disk_is_one_line_and_leaves_nothing(called, arguments, tmp_path, monkeypatch):
    # Python keeps compiled modules of which only the beginning could be written, and fails on them ever after.
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    limit = 1000 if arguments[-1].endswith("csv") else 4096
    # Here, and not in a process of its own, which loads what draws and films for seconds.
    was = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (limit, was[1]))
    try:
        done = called(*arguments, cwd=tmp_path, check=2)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, was)
    assert len(done.stderr.splitlines()) == 1, done.stderr
    assert "with room to write" in done.stderr
    assert os.listdir(tmp_path) == []


def test_a_file_that_was_there_stays_when_the_disk_is_full(tmp_path):
    (tmp_path / "run.nc").write_text("precious")
    limited(100_000, *RUN, "--out", "run.nc", cwd=tmp_path)
    assert (tmp_path / "run.nc").read_text() == "precious"
    assert os.listdir(tmp_path) == ["run.nc"]


def test_a_store_on_a_full_disk_is_one_line_and_goes_on_later(tmp_path):
    (tmp_path / "s.toml").write_text(
        'scenario = "cheese"\nbatch = 1\nset = { duration = "0.2 s" }\n[grid]\nmotion.frequency = ["14 Hz", "24 Hz"]\n'
        '[record]\nsnapshots = "1 ms"\n'
    )
    # Room for the metadata, not for the shapes.
    assert "s.zarr" in limited(60_000, "sweep", "s.toml", cwd=tmp_path)
    done = subprocess.run([COMMAND, "sweep", "s.toml", "--json"], cwd=tmp_path, capture_output=True, text=True,
                          timeout=120, check=False)  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert '"complete": true' in done.stdout


def test_a_dataset_that_memory_does_not_hold_is_refused_before_the_run(tmp_path):
    # Three hours of shapes every 2 ms take some hundred times the memory that the process may have.
    line = limited(4 << 30, "simulate", "cheese", "--duration", "10000 s", "--out", "run.nc", cwd=tmp_path,
                   of=resource.RLIMIT_AS)  # fmt: skip
    assert "of memory" in line
    assert "--duration" in line
    assert os.listdir(tmp_path) == []
