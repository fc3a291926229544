"""Rows of CSV files, as spreadsheets, instruments and people write them.

UTF-8, UTF-16 with a byte order mark (Excel's "Unicode text") or Windows-1252 (its plain "CSV"); any line ends; comma,
semicolon or tab between the cells. Blank lines, lines that begin with `#` and headings that come again are left out.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterator
from itertools import chain
from pathlib import Path

from plategait.errors import InputError
from plategait.files.input import LARGEST_TABLE, kind_of, read_bytes

# More rows than a minute at 10 kHz, more columns than any instrument has.
MOST_ROWS, MOST_COLUMNS = 1_000_000, 1_000

Row = tuple[int, list[str]]
"""Line that a row ends on, and its cells without the blanks around them."""

# "#N/A", "#DIV/0!": what a spreadsheet writes for a number that it could not work out is no comment.
_NO_COMMENT = re.compile(r"#(?:N/A|NV|[A-Z/0]+[!?])")
_TELLS_SEPARATOR = re.compile(r'"?sep=([,;\t])"?\s*', re.IGNORECASE)
_CONTROL = re.compile(r"[\x00-\x08\x0b\x0e-\x1f\x7f]")


def read_rows(path: Path | str, field: str, example: str) -> tuple[list[Row], str]:
    """Rows of a CSV file that hold anything, and what parts their cells.

    The first holds the headings, which may stand in the last comment before rows of nothing but numbers.

    Raises
    ------
    InputError
        When the file cannot be read, or has too many rows or columns.
    """
    allowed = "a CSV file that can be read"
    content = read_bytes(path, LARGEST_TABLE, field, allowed, example)
    kind = kind_of(content)
    if "workbook" in kind:
        hint = f"saving the sheet as {Path(path).with_suffix('.csv').name}, its first line like {example}"
        raise InputError(field, f"{path} ({kind})", allowed, hint)
    try:
        text = _decoded(content)
    except UnicodeDecodeError:
        raise InputError(field, f"{path} ({kind})", allowed, example) from None
    lines, comment, separator = _contents(io.StringIO(text, newline=""))
    reader, rows = csv.reader(lines, delimiter=separator), []
    try:
        for cells in reader:
            row = [cell.strip() for cell in cells]
            if not rows and comment and any(row) and all(map(_is_number, filter(None, row))):
                rows.append((0, [cell.strip() for cell in next(csv.reader([comment], delimiter=separator))]))
            if any(row) and not (rows and row == rows[0][1]):
                rows.append((reader.line_num, row))
            if len(rows) > MOST_ROWS or len(rows[0][1] if rows else ()) > MOST_COLUMNS:
                got = f"{path} (more than {MOST_ROWS} rows or {MOST_COLUMNS} columns)"
                raise InputError(field, got, "a smaller table", "leaving out what is not needed")
    except csv.Error:
        raise InputError(field, f"{path} (no table)", allowed, example) from None
    return rows, separator


def _decoded(content: bytes) -> str:
    """Text in one of the encodings that spreadsheets write.

    Raises
    ------
    UnicodeDecodeError
        When it is none.
    """
    if content.startswith((b"\xff\xfe", b"\xfe\xff")):
        return content.decode("utf-16")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = content.decode("cp1252")
        # Any bytes nearly are some letters of it; those of pictures and programs are control characters as well.
        if _CONTROL.search(text):
            raise
        return text


def _contents(lines: Iterator[str]) -> tuple[Iterator[str], str, str]:
    """Lines with blank ones for comments, the last comment before the first row, and what parts the cells."""
    above, comment, separator, first = 0, "", "", ""
    for line in lines:
        if told := _TELLS_SEPARATOR.fullmatch(line):
            separator = told[1]
        elif _is_comment(line):
            comment = line.strip(' \t\r\n"').lstrip("# ")
        elif line.strip():
            first = line
            break
        above += 1
    rest = ("\n" if _is_comment(line) else line for line in lines)
    # Comma unless the headings have one of the others.
    separator = separator or next((s for s in "\t;" if s in first), ",")
    return chain(["\n"] * above, [first], rest), comment, separator


def _is_comment(line: str) -> bool:
    text = line.lstrip(' \t"')
    return text.startswith("#") and not _NO_COMMENT.match(text)


def _is_number(cell: str) -> bool:
    try:
        float(cell.replace(",", "."))
    except ValueError:
        return False
    return True
