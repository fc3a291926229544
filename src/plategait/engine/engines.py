"""Engines by name, behind one contract: runs in, recordings out.

An engine is a module with a function that keeps `Runner`'s contract, a name in `Engine` and a row in `ENGINES`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Literal, Protocol

from plategait.engine.recording import Recording, RunRequest
from plategait.errors import InputError

Engine = Literal["cpu", "cpu64", "tiles"]


class Runner(Protocol):
    """What every engine does."""

    def __call__(
        self,
        runs: Sequence[RunRequest],
        *,
        threads: int | None = None,
        progress: Callable[[float], object] | None = None,
    ) -> list[Recording]:
        """Advance runs that may differ in everything, and give a recording of each, in their order.

        A recording holds every one of `plategait.engine.channels`, sampled when its request says (`stride` steps of
        the scenario's `dt`, whatever steps the engine itself takes), and the same in whatever company the run was made:
        the same bits by the native core, to rounding by others. A run that diverges is told by its recording; what the
        engine cannot do, or has not the memory for, is refused with an `InputError` before it starts. `threads` are
        cores to use at most, all by default; `progress` is called with the fraction done, and what it raises stops the
        runs.
        """
        ...


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
        Gives the engine itself; not before it is wanted, since that takes time.
    """

    summary: str
    precision: Literal["float32", "float64"]
    load: Callable[[], Runner]


def _cpu(precision: Literal["float32", "float64"]) -> Runner:
    from plategait.engine import cpu

    return partial(cpu.run, precision=precision)


def _tiles() -> Runner:
    from plategait.engine import tile_runs

    return tile_runs.run


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
