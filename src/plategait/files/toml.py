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
        except ValueError:
            why = "a number of too many digits"
        except RecursionError:
            why = "lists or tables nested too deep"
    raise InputError(field, f"{path} ({why})", allowed, hint)
