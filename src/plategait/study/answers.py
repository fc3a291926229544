"""Answers to the questions of the catalogue, from runs that are kept."""

from __future__ import annotations

import importlib.util
from collections.abc import Sequence
from pathlib import Path

from plategait.errors import InputError
from plategait.study.catalogue import QUESTIONS, find_questions
from plategait.study.claims import Answer
from plategait.study.progress import Progress
from plategait.study.runs import open_runs


def answer_questions(
    names: Sequence[str] = (), folder: Path | None = None, progress: Progress | None = None
) -> list[Answer]:
    """Answer questions, all by default.

    Parameters
    ----------
    names : sequence of str
    folder : Path, optional
        Where runs are kept, so that interrupted work goes on there and gives the same bits; in memory by default.
    progress : callable, optional
        Called with the share that is done.

    Raises
    ------
    InputError
        For an unknown name, films without OpenCV, or a folder that is of something else, held by another process, or
        cannot be written to.
    """
    questions = find_questions(names)
    _check_films([question.name for question in questions if question.films])
    with open_runs(folder, progress, sum(question.simulated for question in questions)) as runs:
        return [question.answer(runs) for question in questions]


def _check_films(names: Sequence[str]) -> None:
    """Refuse before anything is simulated what will not be able to see its films."""
    if names and importlib.util.find_spec("cv2") is None:
        others = next(question.name for question in QUESTIONS if not question.films)
        raise InputError("study", f"nothing to see the films of {', '.join(names)} with", "OpenCV installed",
                         f'pip install "plategait[vision]", or a study without films: {others}')  # fmt: skip
