"""A free vibration as it was recorded: read, and shortened where it is long."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from plategait.arrays import Array
from plategait.errors import InputError
from plategait.files.table import Column, read_table
from plategait.identify.series import thin

EXAMPLE = "time_s,deflection_mm"
LEAST_ROWS = 12
_SIGNALS = {
    "deflection": Column("m", required=False),
    "angle": Column("rad", required=False),
    "signal": Column("", required=False),
}
_MOST_ROWS = 20_000
_ROWS_PER_CYCLE = 24  # kept when a long recording is thinned: four for the second mode of a cantilever


@dataclass(frozen=True, eq=False)
class RingRecording:
    """A free vibration: deflection (m), angle (rad) or any other signal in proportion, over time (s).

    Raises
    ------
    InputError
        Columns of unlike length or too short, numbers that are not finite, or a time that does not rise.
    """

    name: str
    kind: str
    time: Array
    signal: Array

    def __post_init__(self) -> None:
        """Refuse what is no recording."""
        if np.ndim(self.time) != 1 or np.shape(self.time) != np.shape(self.signal) or len(self.time) < LEAST_ROWS:
            got = [np.shape(self.time), np.shape(self.signal)]
            raise InputError(self.name, got, f"two columns of {LEAST_ROWS} rows or more", EXAMPLE)
        if not (np.isfinite(self.time).all() and np.isfinite(self.signal).all() and (np.diff(self.time) > 0).all()):
            raise InputError(self.name, "nothing of that sort", "finite numbers with a rising time", EXAMPLE)


def read_ring(path: Path | str) -> RingRecording:
    """Read the column time and one of deflection, angle and signal.

    Raises
    ------
    InputError
        See `plategait.files.table.read_table`; also for none or several of the three, or an empty cell.
    """
    columns = {"time": Column("s"), **_SIGNALS}
    table = read_table(path, columns, field=Path(path).name, example=EXAMPLE, least_rows=LEAST_ROWS, rising="time")
    present = [name for name in _SIGNALS if name in table]
    if len(present) != 1:
        got = f"columns {', '.join(present)}" if present else "nothing to fit beside the time"
        raise InputError(table.path.name, got, f"one of the columns {', '.join(_SIGNALS)}", EXAMPLE)
    values = table[present[0]]
    if (empty := np.flatnonzero(np.isnan(values))).size:
        where = f"{table.path.name} line {table.lines[empty[0]]}, {present[0]}"
        raise InputError(where, "nothing", "a number", "leaving the row out")
    return RingRecording(table.path.name, present[0], table["time"], values)


def shortened(time: Array, signal: Array) -> tuple[Array, Array, list[str]]:
    """At most `_MOST_ROWS` rows: means of as many as the frequency allows, then the beginning only."""
    n = len(time)
    if n <= _MOST_ROWS:
        return time, signal, []
    power = np.abs(np.fft.rfft(signal - signal.mean())) ** 2
    power[: min(4, len(power) - 1)] = 0.0  # drift, not ringing
    cycles = max(1, int(np.argmax(power)))
    most = min(n, max(_MOST_ROWS, _ROWS_PER_CYCLE * cycles))
    (t, y), block = thin(time, signal, most=most)
    notes = [f"thinned to means of {block} rows"] if block > 1 else []
    if len(t) > _MOST_ROWS:
        t, y = t[:_MOST_ROWS], y[:_MOST_ROWS]
        notes.append(f"only the first {t[-1] - t[0]:.3g} s are fitted")
    return t, y, notes
