"""The report of the studies: one self-contained page, with figures, tables and JSON of each beside it."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from html import escape
from pathlib import Path

from plategait.files.output import write_whole
from plategait.study.claims import Answer, Claim
from plategait.thesis.item import Table
from plategait.thesis.page import STYLE, html_picture, html_table, png, prepare_folder, write_table
from plategait.version import __version__


def write_answers(answers: Sequence[Answer], folder: Path | str) -> Path:
    """Write report.html, figures (PNG), tables (CSV) and NAME.json of each answer, and say where the page is.

    Raises
    ------
    InputError
        When the folder cannot be made or written to.
    """
    folder = prepare_folder(folder, "studies")
    pictures: dict[str, bytes] = {}
    for answer in answers:
        for stem, figure in answer.figures:
            pictures[stem] = png(figure)
            write_whole(pictures[stem], folder / f"{stem}.png", (".png",), "--out")
        for table in (claims_table(answer), *answer.tables):
            write_table(table, folder / f"{table.name}.csv")
        text = json.dumps(answer.summary(), indent=2, ensure_ascii=False)
        write_whole(text.encode(), folder / f"{answer.name}.json", (".json",), "--out")
    page = folder / "report.html"
    write_whole(_page(answers, pictures).encode(), page, (".html",), "--out")
    return page


def claims_table(answer: Answer) -> Table:
    """Claims of an answer as people read them: the number with its interval and errors."""
    columns = ("claim", "holds", "number", "interval", "change at half the step", "error over the starts", "unit",
               "note")  # fmt: skip
    return Table(f"{answer.name}-claims", columns, tuple(_row(claim) for claim in answer.claims))


def _row(claim: Claim) -> tuple[str, ...]:
    number, interval = claim.number, claim.interval or claim.number.interval
    return (
        claim.claim,
        "yes" if claim.holds else "no",
        _figures(number.value),
        "–" if interval is None else f"{_figures(interval[0])} to {_figures(interval[1])}",
        _figures(number.step_error, signed=True),
        _figures(number.ensemble_error),
        "" if claim.unit == "1" else claim.unit,
        claim.note,
    )


def _figures(value: float, signed: bool = False) -> str:
    return "–" if not math.isfinite(value) else f"{value:{'+' if signed else ''}.3g}"


def _answer(answer: Answer, pictures: dict[str, bytes]) -> str:
    return "\n".join([
        f'<h2 id="{escape(answer.name)}">{escape(answer.question)} <small>{escape(answer.name)}</small></h2>',
        f'<p class="verdict">{escape(answer.verdict)}</p>',
        *(html_picture(pictures[stem], answer.question) for stem, _ in answer.figures),
        html_table(claims_table(answer)),
        *(f'<p class="note">{escape(note)}</p>' for note in answer.notes),
        *(html_table(table, f"{table.name}.csv", whole=False) for table in answer.tables),
    ])  # fmt: skip


def _page(answers: Sequence[Answer], pictures: dict[str, bytes]) -> str:
    claims = [claim for answer in answers for claim in answer.claims]
    index = Table("", ("study", "question", "verdict"), tuple((a.name, a.question, a.verdict) for a in answers))
    links = " · ".join(f'<a href="#{escape(a.name)}">{escape(a.name)}</a>' for a in answers)
    return f"""<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>What the dissertation leaves open</title>
<style>{STYLE}</style></head>
<body>
<h1>What the dissertation leaves open</h1>
<p>Questions of I. G. Ramirez-Alpizar, <i>Nonprehensile Manipulation of Deformable Objects</i>, Osaka University, 2013,
answered with plategait {escape(__version__)}. Of {len(claims)} claims {sum(c.holds for c in claims)} hold; a claim that
does not is refuted, and stays.</p>
<p><b>How far to trust a digit.</b> The change at half the step is what the number does when the time step of all its
runs is halved, from the same starts; the error over the starts is the standard error over starts that differ by a tenth
of a millimetre and a degree. The interval is two of these to either side, and the change with the step on top: it holds
95 % of the time for many starts, 82 % for three, 70 % for two; where a note says of what else it is, 95 %. A dash means
that this was not run, or has no meaning for that number.</p>
<p>{links}</p>
{html_table(index)}
{chr(10).join(_answer(answer, pictures) for answer in answers)}
</body></html>
"""
