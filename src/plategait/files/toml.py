"""TOML files of bounded size and depth."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from typing import Any

from plategait.errors import InputError
from plategait.files.input import LARGEST_TOML, read_text

# Keys of so many parts that the reader, whose time grows with their square, would not end.
_LONG_KEY = re.compile(r"(?<![\w\"'-])[\w\"'-]++(?:[ \t]*+\.[ \t]*+[\w\"'-]++){32}")
# Where in a file its reader stopped.
_PLACE = re.compile(r"(?<=\()at [^()]*(?=\)$)")


# A value that a number with a unit, or with a decimal comma, was left to be without quotes.
_UNQUOTED = re.compile(
    r"=[ \t]*([-+]?\d+(?:[.,]\d+)?(?:e[-+]?\d+)?)[ \t]*([a-zA-Zµμ°][\w/*^²³·()]{0,15})?[ \t]*[,}\]#\n]", re.I
)


def _quoted(text: str, error: str) -> str:
    """Number and unit in quotes, where the line that could not be read holds one without; else nothing."""
    place = re.search(r"at line (\d+)", error)
    line = (text + "\n").splitlines(keepends=True)[int(place[1]) - 1] if place else ""
    for found in _UNQUOTED.finditer(line if len(line) < 1000 else ""):
        number, unit = found[1].replace(",", "."), found[2]
        if unit:
            return f'quotes: "{number} {unit}"'
        if number != found[1]:
            return f"a point: {number}"
    return ""


def read_toml(path: Path | str, field: str, allowed: str, hint: str) -> tuple[dict[str, Any], str]:
    """Contents of a TOML file, and its text.

    Raises
    ------
    InputError
        When the file cannot be read, which must be `allowed`, or is no TOML.
    """
    text = read_text(path, LARGEST_TOML, field, allowed, hint)
    why = "names of too many parts"
    if not _LONG_KEY.search(text):
        try:
            return tomllib.loads(text), text
        except tomllib.TOMLDecodeError as error:
            # The rest of the message may hold some of the file, which need not be one of ours.
            why = " ".join(["no TOML", *_PLACE.findall(str(error))])
            hint = _quoted(text, str(error)) or hint
        except ValueError:
            why = "a number of too many digits"
        except RecursionError:
            why = "lists or tables nested too deep"
    raise InputError(field, f"{path} ({why})", allowed, hint)
