"""Tables for people, which fit the terminal that they are printed on: no cell is cut, and no number broken."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from textwrap import wrap

from plategait.errors import printable

# Of a pipe, which has no width of its own, unless a table needs more.
_PIPE = 120
# What a table adds to each column, with room and without, and at its edges.
_ROOMY, _TIGHT, _EDGES = 3, 1, 1


def print_table(title: str, columns: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
    """Print a table with a title; where the terminal is too narrow for it, a few lines for each of its rows."""
    from rich import box
    from rich.cells import cell_len
    from rich.console import Console
    from rich.markup import escape
    from rich.table import Table

    columns = [printable(column) for column in columns]
    cells = [[printable(cell) for cell in row] for row in rows]
    widths = _column_widths(columns, cells)
    bare = sum(widths) + _EDGES
    console = Console(width=_width(bare + _ROOMY * len(columns)))
    # A value of two columns may go on in the next line; where there are more, nobody finds its number again.
    if bare + _TIGHT * len(columns) > console.width and len(columns) > 2:
        console.print(f"{escape(printable(title))}\n", highlight=False)
        for row in cells:
            console.print(escape(_record(columns, row, console.width)), highlight=False)
        console.print()
        return
    padding = (0, 1 if bare + _ROOMY * len(columns) <= console.width else 0)
    table = Table(title=escape(printable(title)), title_justify="left", box=box.SIMPLE_HEAD, padding=padding)
    crowded = sum(map(max, widths, map(cell_len, columns))) + _EDGES + _ROOMY * len(columns) > console.width
    for i, (column, width) in enumerate(zip(columns, widths, strict=True)):
        heading = "\n".join(wrap(column, width)) if crowded and column else column
        table.add_column(escape(heading), justify="left" if i == 0 else "right", overflow="fold")
    for row in cells:
        table.add_row(*map(escape, row))
    console.print(table)


def _column_widths(columns: Sequence[str], rows: Sequence[Sequence[str]]) -> list[int]:
    """Widths that hold each cell in one line; a heading may go on in the next line at a space."""
    from rich.cells import cell_len

    headings = [max(map(cell_len, column.split()), default=0) for column in columns]
    return [max([heading, *(cell_len(row[i]) for row in rows)]) for i, heading in enumerate(headings)]


def _width(needed: int) -> int | None:
    """Width to print in: the terminal's; of a pipe what is needed, unless the environment says how wide it is."""
    if sys.stdout.isatty() or os.environ.get("COLUMNS", "").isdigit():
        return None
    return max(_PIPE, needed)


def _record(columns: Sequence[str], row: Sequence[str], width: int) -> str:
    """One row of a table as lines: what it is of, and under it each of its values behind its heading."""
    head = row[0] if not columns[0] or not row[0][:1].isdigit() else f"{columns[0]} {row[0]}"
    if not any(columns[1:]):
        return f"{head}\n  {' '.join(filter(None, row[1:]))}"
    widest = max(map(len, columns[1:]))
    values = [(column, cell) for column, cell in zip(columns[1:], row[1:], strict=True) if cell]
    lines = [f"  {column:<{widest}}  {cell}" for column, cell in values]
    if max(map(len, lines), default=0) > width:
        lines = [f"  {column}\n    {cell}" for column, cell in values]
    return "\n".join((head, *lines))
