"""Words for what an object did, as people write them beside a measured point."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass

from plategait.simulation.observables import FAILURES, GAITS

UNTOLD = "failed"
"""Failure of which nothing more is known."""

_ANSWERS = {"yes", "y", "true", "t", "x", "ja", "j", "no", "n", "false", "f", "nein"}
_YES = {"yes", "y", "true", "t", "1", "1.0", "x", "ja", "j", "failed", "fail", "fails", "failure"}
_NO = {
    "", "no", "n", "false", "f", "0", "0.0", "-", "--", "–", "—", "none", "nan", "na", "n/a", "nein", "ok", "okay",
    "good", "fine", "stable", "stayed", "no failure", "not failed", "did not fail",
}  # fmt: skip
_FAILURES = {
    "slipped": ("slip", "slips", "slipped off", "slid off", "slid away", "ran off", "run off", "runs off", "runoff"),
    "left the plate": ("left plate", "fell", "fell off", "fallen", "fell down", "flew off", "jumped off", "off plate",
                       "off the plate"),
    "turned over": ("flipped", "flipped over", "overturned", "tipped over", "toppled"),
    "folded": ("folds", "folded up", "collapsed"),
}  # fmt: skip
_GAITS = {"sliding": ("slide", "slides"), "walking": ("walk", "walks"), "running": ("run", "runs")}
_FAILURE_OF = {word: kind for kind in FAILURES for word in (kind, *_FAILURES.get(kind, ()))}
_GAIT_OF = {word: gait for gait in GAITS for word in (gait, *_GAITS[gait])}


@dataclass(frozen=True)
class Outcome:
    """What an object did at one point: its gait and how it failed; empty where it did not, or nothing is known."""

    gait: str = ""
    failure: str = ""


def read_outcome(cell: str, *, answers: bool = True) -> Outcome | None:
    """What a cell says; None for words of no known meaning.

    Parameters
    ----------
    answers : bool
        Whether yes and no answer if the object failed; else they mean nothing.
    """
    said = _plain(cell)
    if not answers and said in _ANSWERS | {"0", "0.0", "1", "1.0"}:
        return None
    if said in _NO:
        return Outcome()
    if said in _YES:
        return Outcome(failure=UNTOLD)
    if (gait := _GAIT_OF.get(said)) or said in _FAILURE_OF:
        return Outcome(gait or "", _FAILURE_OF.get(said, ""))
    return None


def tells_outcomes(cells: Iterable[str], *, failure_known: bool) -> bool:
    """Whether cells under an unknown heading tell what the object did: a gait, a failure, or answers to yes or no."""
    said = {_plain(cell) for cell in cells} - {""}
    if said & (_GAIT_OF.keys() | _FAILURE_OF.keys() | {"failed", "fail", "failure"}):
        return True
    return bool(said) and said <= _ANSWERS and not failure_known


def _plain(cell: str) -> str:
    """Words with single blanks, in small letters, without a full stop."""
    words = re.sub(r"[\s_]+", " ", cell.casefold()).strip(" .!'\"")
    return words.replace("-", " ") if any(map(str.isalpha, words)) else words
