"""Compile the core for a browser: a WebAssembly module without imports, from the headers that every engine shares.

Run by `make lab` with a Python that has the package `ziglang` in the version below, whose clang makes the same bytes on
every machine: `python lab/build_engine.py OUT.wasm`.
"""

from __future__ import annotations

import importlib.metadata
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
COMPILER = "0.15.2"
SOURCE = "native/browser.cpp"
EXPORTS = ("allocate", "release", "names", "count", "advance", "show")
FLAGS = (
    "-target", "wasm32-wasi", "-mexec-model=reactor", "-std=c++20", "-O3", "-ffp-contract=off", "-msimd128",
    "-fno-exceptions", "-fno-rtti", "-DNDEBUG", "-Wall", "-Wextra", "-s",
    *(f"-Wl,--export=plategait_{name}" for name in EXPORTS),
)  # fmt: skip


def compile_engine(out: Path) -> None:
    """Compile the module, whole or not at all."""
    found = importlib.metadata.version("ziglang")
    if found != COMPILER:
        sys.exit(f"ziglang: got {found}, must be {COMPILER}; try pip install ziglang=={COMPILER}")
    unfinished = out.with_suffix(".unfinished.wasm")
    # Names in the working folder are the same everywhere, so that nothing of this machine gets into the module.
    subprocess.run(
        [sys.executable, "-m", "ziglang", "c++", *FLAGS, SOURCE, "-o", str(unfinished)], cwd=ROOT, check=True
    )
    unfinished.chmod(0o644)
    unfinished.replace(out)


if __name__ == "__main__":
    compile_engine(Path(sys.argv[1]).absolute())
