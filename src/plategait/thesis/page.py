"""Pages: one self-contained file with tables and pictures, and what lies beside it."""

from __future__ import annotations

import base64
import csv
import io
import math
import os
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING

from plategait.errors import InputError
from plategait.files.output import whole_file
from plategait.thesis.item import Cell, Table

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_DPI = 110
STYLE = """
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


def png(figure: Figure) -> bytes:
    """Picture of a figure."""
    buffer = io.BytesIO()
    figure.savefig(buffer, dpi=_DPI, format="png")
    return buffer.getvalue()


def write_table(table: Table, path: Path) -> None:
    """Write a table as CSV; what is unknown stays empty."""
    with whole_file(path, (".csv",), "--out") as temporary, open(temporary, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(table.columns)
        for row in table.rows:
            writer.writerow(
                ["" if _unknown(cell) else f"{cell:.8g}" if isinstance(cell, float) else cell for cell in row]
            )


def _unknown(cell: Cell) -> bool:
    return cell is None or (isinstance(cell, float) and not math.isfinite(cell))


def _cell(cell: Cell) -> str:
    if _unknown(cell):
        return "<td>–</td>"
    if isinstance(cell, str):
        mark = {"yes": ' class="yes"', "no": ' class="no"'}.get(cell, ' class="text"')
        return f"<td{mark}>{escape(cell)}</td>"
    return f"<td>{cell:.4g}</td>" if isinstance(cell, float) else f"<td>{cell}</td>"


def html_table(table: Table, caption: str = "", whole: bool = True) -> str:
    """Table of a page; one that is not shown `whole` scrolls."""
    head = "".join(f"<th>{escape(column)}</th>" for column in table.columns)
    body = "".join(f"<tr>{''.join(map(_cell, row))}</tr>" for row in table.rows)
    title = f"<caption>{escape(caption)}</caption>" if caption else ""
    kind = "" if whole else ' class="wide"'
    return f"<div{kind}><table>{title}<thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></div>"


def html_picture(picture: bytes, title: str) -> str:
    """Picture of a page, within it."""
    return f'<img alt="{escape(title)}" src="data:image/png;base64,{base64.b64encode(picture).decode("ascii")}">'
