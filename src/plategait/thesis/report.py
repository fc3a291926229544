"""The report: one self-contained page, with a folder of figures and CSV beside it."""

from __future__ import annotations

import math
from collections.abc import Callable
from html import escape
from pathlib import Path

from plategait import published
from plategait.files.output import write_whole
from plategait.thesis.item import Check, Comparison, Item, Table
from plategait.thesis.page import STYLE, html_picture, html_table, png, prepare_folder, write_table
from plategait.thesis.study import Study
from plategait.version import __version__


def write_report(study: Study, folder: Path | str, progress: Callable[[float], object] | None = None) -> Path:
    """Write report.html, figures (PNG) and tables (CSV) of a study into a folder, and say where the page is.

    `progress` is called with the fraction done.

    Raises
    ------
    InputError
        When the folder cannot be made or written to.
    """
    folder = prepare_folder(folder)
    pictures: dict[str, bytes] = {}
    for number, item in enumerate(study.items, start=1):
        for stem, figure in item.figures:
            pictures[stem] = figure if isinstance(figure, bytes) else png(figure)
            write_whole(pictures[stem], folder / f"{stem}.png", (".png",), "--out")
        for table in item.tables:
            write_table(table, folder / f"{table.name}.csv")
        if item.comparisons:
            write_table(_comparison_table(item), folder / f"{item.name}-comparison.csv")
        if progress is not None:
            progress(number / len(study.items))
    page = folder / "report.html"
    write_whole(_page(study, pictures).encode(), page, (".html",), "--out")
    return page


def _comparison_table(item: Item) -> Table:
    columns = (
        "quantity",
        "published",
        "where",
        "measured",
        "deviation",
        "allowed",
        "sd over the starts",
        "change at half the step",
        "holds",
    )
    rows = tuple(
        (
            c.quantity,
            c.published.value,
            c.published.where,
            c.measured,
            _deviation(c),
            _allowed(c),
            c.spread,
            c.half_step,
            "yes" if c.holds else "no",
        )
        for c in item.comparisons
    )
    return Table(f"{item.name}-comparison", columns, rows)


def _deviation(c: Comparison) -> str:
    if not math.isfinite(c.deviation):
        return "–"
    return f"{c.deviation:+.3g}" if c.absolute else f"{100 * c.deviation:+.1f} %"


def _allowed(c: Comparison) -> str:
    return f"±{c.allowed:g}" if c.absolute else f"±{100 * c.allowed:g} %"


def _checks(checks: tuple[Check, ...]) -> str:
    rows = tuple((c.what, c.target, c.measured, "yes" if c.holds else "no") for c in checks)
    return html_table(Table("", ("finding", "target", "measured", "holds"), rows))


def _item(item: Item, pictures: dict[str, bytes]) -> str:
    kind = "" if not (item.comparisons or item.checks) else "yes" if item.reproduced else "no"
    parts = [
        f'<h2 id="{escape(item.name)}">{escape(item.title)} <small>{escape(item.name)}</small></h2>',
        f'<p class="verdict {kind}">{escape(item.verdict)}</p>',
    ]
    for stem, _ in item.figures:
        parts.append(html_picture(pictures[stem], item.title))
    if item.comparisons:
        parts.append(html_table(_comparison_table(item)))
    if item.checks:
        parts.append(_checks(item.checks))
    parts += [f'<p class="note">{escape(note)}</p>' for note in item.notes]
    for table in item.tables:
        parts.append(html_table(table, f"{table.name}.csv", whole=False))
    return "\n".join(parts)


def _page(study: Study, pictures: dict[str, bytes]) -> str:
    count = sum(item.reproduced for item in study.items if item.comparisons or item.checks)
    judged = sum(bool(item.comparisons or item.checks) for item in study.items)
    index = Table("", ("item", "what", "verdict"), tuple((item.name, item.title, item.verdict) for item in study.items))
    slips = Table(
        "",
        ("where", "the source says", "but", "used here"),
        tuple((s.where, s.says, s.implies, s.used) for s in published.errata()),
    )
    links = " · ".join(f'<a href="#{escape(item.name)}">{escape(item.name)}</a>' for item in study.items)
    return f"""<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>The dissertation, regenerated</title><style>{STYLE}</style></head>
<body>
<h1>The dissertation, regenerated</h1>
<p>I. G. Ramirez-Alpizar, <i>Nonprehensile Manipulation of Deformable Objects</i>, Osaka University, 2013. Every
simulated figure and table, made again by plategait {escape(__version__)} and set beside what was printed.
{count} of {judged} items that can be judged hold in every number and finding.</p>
<p>{len(study.items)} items, {study.simulated:.0f} simulated seconds in {study.wall:.0f} s; {study.repeats} slightly
different starts of each run, seed {study.seed}.</p>
<p><b>How far to trust a digit.</b> Above its peak the motion is chaotic. "sd over the starts" is the standard deviation
of the number over starts that differ by a tenth of a millimetre and a degree, each start fitted by itself; differences
below it mean nothing. It is large where one start's curve catches an island of stability beyond its run-off, which the
mean over the starts leaves out. "Change at half the step" is what the number does when the time step is halved, from
the same starts; a dash means that this was not run for that number: it was for the curves at α = 36.87 deg.</p>
<p>{links}</p>
{html_table(index)}
{chr(10).join(_item(item, pictures) for item in study.items)}
<h2 id="slips">Slips in the source</h2>
{html_table(slips)}
</body></html>
"""
