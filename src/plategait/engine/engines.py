"""Engines by name, behind one contract: runs in, sessions that advance them out.

An engine is a module with a class that keeps the contract of `plategait.engine.session.Session`, a name in `Engine`
and a row in `ENGINES`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Literal

from plategait.engine.recording import Recording, RunRequest
from plategait.engine.session import Opener, advance_once
from plategait.errors import InputError

Engine = Literal["cpu", "cpu64", "tiles"]


@dataclass(frozen=True)
class EngineEntry:
    """One engine.

    Attributes
    ----------
    summary : str
        What it is, in a few words.
    precision : {"float32", "float64"}
        Of its numbers.
    load : callable
        Gives what opens a session; not before it is wanted, since that takes time.
    """

    summary: str
    precision: Literal["float32", "float64"]
    load: Callable[[], Opener]

    def run(
        self,
        runs: Sequence[RunRequest],
        *,
        threads: int | None = None,
        progress: Callable[[float], object] | None = None,
    ) -> list[Recording]:
        """Advance runs to their ends, a session advanced once, and give a recording of each, in their order."""
        return advance_once(self.load()(runs, ends=True), runs, threads=threads, progress=progress)


def _cpu(precision: Literal["float32", "float64"]) -> Opener:
    from plategait.engine import cpu

    return partial(cpu.Session, precision=precision)


def _tiles() -> Opener:
    from plategait.engine import tile_runs

    return tile_runs.Session


ENGINES: Mapping[Engine, EngineEntry] = {
    "cpu": EngineEntry("single precision", "float32", lambda: _cpu("float32")),
    "cpu64": EngineEntry("double precision", "float64", lambda: _cpu("float64")),
    "tiles": EngineEntry("rigid tiles, a slow second opinion", "float64", _tiles),
}


def engine(name: Engine) -> EngineEntry:
    """Engine of a name.

    Raises
    ------
    InputError
        When there is none.
    """
    if name not in tuple(ENGINES):
        raise InputError("engine", name, f"one of {', '.join(ENGINES)}", next(iter(ENGINES)))
    return ENGINES[name]
