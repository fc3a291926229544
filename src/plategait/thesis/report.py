"""The report: one self-contained page, with a folder of figures and CSV beside it."""

from __future__ import annotations

import base64
import csv
import io
import math
import os
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING

from plategait import published
from plategait.errors import InputError
from plategait.files.output import whole_file, write_whole
from plategait.thesis.item import Cell, Check, Comparison, Item, Table
from plategait.thesis.study import Study
from plategait.version import __version__

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_DPI = 110
_STYLE = """
body { font: 15px/1.5 system-ui, sans-serif; color: #1a1a1a; max-width: 68rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.7rem; margin-bottom: .2rem; } h2 { font-size: 1.25rem; margin-top: 2.5rem; }
h2 small { color: #666; font-weight: normal; }
table { border-collapse: collapse; margin: .8rem 0; font-size: .85rem; } caption { text-align: left; color: #666; }
th, td { padding: .2rem .7rem .2rem 0; text-align: right; border-bottom: 1px solid #ddd; vertical-align: top; }
th, td:first-child, td.text, td.yes, td.no { text-align: left; } th { vertical-align: bottom; }
.wide { overflow-x: auto; max-height: 30rem; overflow-y: auto; }
img { max-width: 100%; } .verdict { font-weight: 600; } .yes { color: #00704f; } .no { color: #b04a00; }
.note { color: #444; } nav td { border: 0; }
"""


def prepare_folder(folder: Path | str, example: str = "thesis") -> Path:
    """Make the folder that the report goes to, before any work is done.

    Raises
    ------
    InputError
        When it cannot be made or written to.
    """
    folder = Path(folder)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except (OSError, ValueError):
        raise InputError("--out", str(folder), "a folder that can be made", example) from None
    if not os.access(folder, os.W_OK | os.X_OK):
        raise InputError("--out", str(folder), "a folder that can be written to", example)
    return folder


def write_report(study: Study, folder: Path | str) -> Path:
    """Write report.html, figures (PNG) and tables (CSV) of a study into a folder, and say where the page is.

    Raises
    ------
    InputError
        When the folder cannot be made or written to.
    """
    folder = prepare_folder(folder)
    pictures: dict[str, bytes] = {}
    for item in study.items:
        for stem, figure in item.figures:
            pictures[stem] = figure if isinstance(figure, bytes) else _png(figure)
            write_whole(pictures[stem], folder / f"{stem}.png", (".png",), "--out")
        for table in item.tables:
            _write_table(table, folder / f"{table.name}.csv")
        if item.comparisons:
            _write_table(_comparison_table(item), folder / f"{item.name}-comparison.csv")
    page = folder / "report.html"
    write_whole(_page(study, pictures).encode(), page, (".html",), "--out")
    return page


def _png(figure: Figure) -> bytes:
    buffer = io.BytesIO()
    figure.savefig(buffer, dpi=_DPI, format="png")
    return buffer.getvalue()


def _write_table(table: Table, path: Path) -> None:
    with whole_file(path, (".csv",), "--out") as temporary, open(temporary, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(table.columns)
        for row in table.rows:
            writer.writerow(
                ["" if _unknown(cell) else f"{cell:.8g}" if isinstance(cell, float) else cell for cell in row]
            )


def _unknown(cell: Cell) -> bool:
    return cell is None or (isinstance(cell, float) and not math.isfinite(cell))


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


def _cell(cell: Cell) -> str:
    if _unknown(cell):
        return "<td>–</td>"
    if isinstance(cell, str):
        mark = {"yes": ' class="yes"', "no": ' class="no"'}.get(cell, ' class="text"')
        return f"<td{mark}>{escape(cell)}</td>"
    return f"<td>{cell:.4g}</td>" if isinstance(cell, float) else f"<td>{cell}</td>"


def _html_table(table: Table, caption: str = "", whole: bool = True) -> str:
    head = "".join(f"<th>{escape(column)}</th>" for column in table.columns)
    body = "".join(f"<tr>{''.join(map(_cell, row))}</tr>" for row in table.rows)
    title = f"<caption>{escape(caption)}</caption>" if caption else ""
    kind = "" if whole else ' class="wide"'
    return f"<div{kind}><table>{title}<thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></div>"


def _checks(checks: tuple[Check, ...]) -> str:
    rows = tuple((c.what, c.target, c.measured, "yes" if c.holds else "no") for c in checks)
    return _html_table(Table("", ("finding", "target", "measured", "holds"), rows))


def _item(item: Item, pictures: dict[str, bytes]) -> str:
    kind = "" if not (item.comparisons or item.checks) else "yes" if item.reproduced else "no"
    parts = [
        f'<h2 id="{escape(item.name)}">{escape(item.title)} <small>{escape(item.name)}</small></h2>',
        f'<p class="verdict {kind}">{escape(item.verdict)}</p>',
    ]
    for stem, _ in item.figures:
        data = base64.b64encode(pictures[stem]).decode("ascii")
        parts.append(f'<img alt="{escape(item.title)}" src="data:image/png;base64,{data}">')
    if item.comparisons:
        parts.append(_html_table(_comparison_table(item)))
    if item.checks:
        parts.append(_checks(item.checks))
    parts += [f'<p class="note">{escape(note)}</p>' for note in item.notes]
    for table in item.tables:
        parts.append(_html_table(table, f"{table.name}.csv", whole=False))
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
<html lang="en"><head><meta charset="utf-8"><title>The dissertation, regenerated</title><style>{_STYLE}</style></head>
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
{_html_table(index)}
{chr(10).join(_item(item, pictures) for item in study.items)}
<h2 id="slips">Slips in the source</h2>
{_html_table(slips)}
</body></html>
"""
