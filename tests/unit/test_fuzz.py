"""A small share of the fuzzer's cases, and the fuzzer's own eyes."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from pathlib import Path

import pytest

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="limits memory as Linux does")
ROOT = Path(__file__).parents[2]


def fuzz(*arguments: str, **environment: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "benchmarks.fuzz", *arguments], cwd=ROOT, env={**os.environ, **environment},
        capture_output=True, text=True, timeout=120, check=False,
    )  # fmt: skip


@pytest.mark.slow
def test_random_scenarios_and_commands_neither_crash_nor_answer_with_nonsense():
    done = fuzz("--scenarios", "60", "--commands", "8", "--edges", "12", "--seed", "3")
    assert done.returncode == 0, done.stdout + done.stderr
    assert "60 of scenario" in done.stdout
    assert " 0 problems" in " " + done.stdout.splitlines()[-1]


SPOILT = """
import os, signal, time
from benchmarks.fuzz_trials import TRIALS, Case
def spoilt(seed, index, tell):
    tell(f"number {index}")
    if index == 1:
        os.kill(os.getpid(), signal.SIGSEGV)
    if index == 2:
        time.sleep(60)
    return Case("ran", "wrong" if index == 3 else "")
TRIALS["scenario"] = spoilt
"""


@pytest.mark.slow
def test_the_fuzzer_sees_a_crash_a_hang_and_nonsense(tmp_path):
    # The worker is a new interpreter: it takes the spoilt trial from where it is started.
    (tmp_path / "sitecustomize.py").write_text(f"import sys\nsys.path.insert(0, {str(ROOT)!r})\n" + SPOILT)
    begun = time.monotonic()
    few = ("--scenarios", "5", "--commands", "0", "--edges", "0", "--limit", "3", "--workers", "1")
    done = fuzz(*few, PYTHONPATH=str(tmp_path))
    assert done.returncode == 1, done.stderr
    assert "scenario:1 of seed 1: lost; the process ended with status -11\nnumber 1" in done.stdout
    assert "scenario:2 of seed 1: lost; no answer within 3 s\nnumber 2" in done.stdout
    assert "scenario:3 of seed 1: ran; wrong\nnumber 3" in done.stdout
    assert "5 of scenario: 2 lost, 3 ran\n3 problems" in done.stdout
    assert time.monotonic() - begun < 60
