"""What in a measured curve's file is probably not meant: columns of unknown names, a frequency that stands apart."""

from __future__ import annotations

import difflib
import math
from collections.abc import Iterable, Mapping

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array
from plategait.curve.outcome import tells_outcomes
from plategait.errors import InputError
from plategait.files.headings import possible_names

# Names are taken for each other's slips when they are as like as "failures" and "failure".
_LIKE = 0.8
# Shorter ones are like too many: "run", the number of a run, is no slip of "runs".
_SHORTEST = 5
# Frequencies that belong together lie within this factor of their neighbours: objects walk over an octave or two.
_APART = 2.5
# A slip of the decimal point among at least this many, which must be most.
_LEAST, _MOST = 3, 2 / 3
_SLIPS = (10.0, 100.0, 1000.0)
# Headings that say the opposite of a failure.
_STAYED = {"ok", "okay", "stable", "stayed", "success", "survived", "passed", "good", "valid"}


def unread_columns(file: str, unread: Mapping[str, Iterable[str]], known: Mapping[str, str], found: set[str]) -> str:
    """Note that names the columns which nothing reads; empty where there are none.

    Parameters
    ----------
    unread : mapping of str to iterable of str
        Their cells by heading.
    known : mapping of str to str
        Column by each of the names that it may have.
    found : set of str
        Columns that the file has.

    Raises
    ------
    InputError
        When one is like the name of a column that is missing, or says how the object moved or failed.
    """
    missing = {name: column for name, column in known.items() if column not in found}
    long = [name for name in missing if len(name) >= _SHORTEST]
    for heading, cells in unread.items():
        said = [name for name in possible_names(heading) if known.get(name) not in found]
        if _STAYED & set(said[:1]) and "failure" not in found:
            raise InputError(f"{file}, {heading}", "a column that may say where the object did not fail",
                             "a column failure, which says where it did", "failure: yes, no")  # fmt: skip
        like = [name for name in said if name in missing]
        like += [match for name in said for match in difflib.get_close_matches(name, long, n=1, cutoff=_LIKE)]
        if like:
            columns = ", ".join(dict.fromkeys(known.values()))
            got = "a column of no known name or unit"
            raise InputError(f"{file}, {heading}", got, f"one of {columns}", missing[like[0]])
        if tells_outcomes(cells, failure_known="failure" in found):
            cell = " and ".join(list(dict.fromkeys(filter(None, cells)))[:4])
            raise InputError(f"{file}, {heading}", f"a column of no known name that says {cell}",
                             "named failure if it says where the object failed, or left out", "failure")  # fmt: skip
    return f"not read from {file}: {', '.join(unread)} (read: {', '.join(sorted(found))})" if unread else ""


def lone_frequencies(file: str, frequency: Array, lines: NDArray[np.int64]) -> list[str]:
    """Notes on frequencies that a shift of the decimal point would bring among the others: 160 among 12 to 20 Hz."""
    different, which = np.unique(frequency, return_inverse=True)
    group = np.cumsum(np.diff(np.log(different), prepend=math.log(different[0])) > math.log(_APART))[which]
    sizes = np.bincount(group)
    together = group == np.argmax(sizes)
    if sizes.max() < max(_LEAST, _MOST * len(frequency)):
        return []
    low, high = float(frequency[together].min()), float(frequency[together].max())
    notes = []
    for line, f in np.column_stack([lines, frequency])[~together].tolist():
        shifted = [g for slip in _SLIPS for g in (f / slip, f * slip)]
        meant = [g for g in shifted if low / _APART**0.5 <= g <= high * _APART**0.5]
        if meant:
            notes.append(f"warning: {file} line {line:.0f}: {f:g} Hz stands apart from the others, {low:g} to {high:g} "
                         f"Hz: is {meant[0]:g} Hz meant?")  # fmt: skip
    return notes
