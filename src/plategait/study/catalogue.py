"""The catalogue of questions: each study's name, what it asks, and who answers."""

from __future__ import annotations

import importlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from plategait.errors import InputError

if TYPE_CHECKING:
    from plategait.study.claims import Answer
    from plategait.study.runs import Runs


@dataclass(frozen=True)
class Question:
    """One question that the source leaves open.

    Attributes
    ----------
    name : str
        What people type, and the module of `plategait.study.questions` whose function `answer` takes `Runs` and this
        question, and gives an `Answer`.
    asks : str
        The question in a sentence.
    simulated : float
        About how much it simulates, s, for the progress.
    films : bool
        Whether it makes films and tracks them, for which OpenCV is needed.
    """

    name: str
    asks: str
    simulated: float
    films: bool = False

    def answer(self, runs: Runs) -> Answer:
        """Answer it from runs, those that are kept and those that are missing."""
        function: Callable[[Runs, Question], Answer]
        function = importlib.import_module(f"plategait.study.questions.{self.name}").answer
        return function(runs, self)


QUESTIONS = (
    Question("gait", "Why does it look like a biped, in appearance or in dynamics?", 6700.0),
    Question("sizes", "Do objects of any size, shape and thickness spin alike, and can one estimator read them all?",
             7000.0),
    Question("strides", "Which strides hold, and how do they lose their hold at each change of gait and at run-off?",
             3600.0),
    Question("friction", "What does dynamic friction do, what tells the friction angle better than (5.7), and what "
             "does an angle that wanders cost?", 7200.0),
    Question("viscosity", "What is the mark of the bending's viscosity over four decades, and can it be read off a "
             "spin experiment?", 4700.0),
    Question("identifiability", "Which of mass, elasticity, viscosity and friction does a spin experiment tell, from "
             "what, and what do higher modes add?", 3900.0),
    Question("torsion", "Does an isotropic plate behave otherwise than the source's free torsion, and does refining "
             "the pitch converge?", 1400.0),
    Question("phases", "What do the phase and the periods of rocking and shaking decide?", 1600.0),
    Question("stroke", "What would have to be true for the spin rate not to depend on the stroke B_p?", 4300.0),
    Question("freshness", "Do films tell two batches of an ageing food apart, of which one is 20 % stiffer, and how "
             "surely?", 9700.0, films=True),
)  # fmt: skip
NAMES = tuple(question.name for question in QUESTIONS)


def find_questions(names: Sequence[str]) -> list[Question]:
    """Questions by name, in the order of the catalogue; all of them for none.

    Raises
    ------
    InputError
        For a name that none has.
    """
    for name in names:
        if name not in NAMES:
            raise InputError("study", name, f"one of {', '.join(NAMES)}", NAMES[0])
    return [question for question in QUESTIONS if not names or question.name in names]
