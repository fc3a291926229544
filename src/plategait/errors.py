"""Errors that say what to type instead."""

from __future__ import annotations

# Letters of each part of a message: enough for a path or a list of names, too few to fill a screen.
MOST_LETTERS = 240


def printable(text: str, most: int = MOST_LETTERS) -> str:
    """Text of one line that a terminal shows as it stands: control characters as escapes, cut in its middle."""
    # Escaped text is never shorter: what is cut from it may be cut before it is made.
    half = most // 2
    shortened = text if len(text) <= most else f"{text[:half]} … {text[-half:]}"
    visible = "".join(c if c.isprintable() else c.encode("unicode_escape").decode("ascii") for c in shortened)
    return visible if len(visible) <= 2 * most else f"{visible[:half]} … {visible[-half:]}"


def check_kind(value: object, kinds: type | tuple[type, ...], field: str, hint: str) -> None:
    """Refuse what is of another kind than a function works on.

    Parameters
    ----------
    kinds : type, or tuple of types
        What it may be.
    field : str
        What the function calls it.
    hint : str
        How one comes by what it may be.

    Raises
    ------
    InputError
        That names both kinds.
    """
    if not isinstance(value, kinds):
        names = " or ".join(kind.__name__ for kind in (kinds if isinstance(kinds, tuple) else (kinds,)))
        plain = value is None or isinstance(value, (str, int, float))
        raise InputError(field, value if plain else f"a {type(value).__name__}", f"a {names}", hint)


class InputError(ValueError):
    """Bad input: names the field, what was got, what is allowed, and a value that works.

    Parameters
    ----------
    field : str
        Name of the field or option, dotted where it is nested ("sheet.pitch").
    got : object
        What was given.
    allowed : str
        What is allowed, as the end of "must be …".
    hint : str
        What to type instead.

    Examples
    --------
    >>> raise InputError("sheet.pitch", -1, "a length above 0", '"10 mm"')
    Traceback (most recent call last):
    ...
    plategait.errors.InputError: sheet.pitch: got -1, must be a length above 0; try "10 mm"
    """

    def __init__(self, field: str, got: object, allowed: str, hint: str) -> None:
        self.field, self.got, self.allowed, self.hint = field, got, allowed, hint
        super().__init__(field, got, allowed, hint)

    def __str__(self) -> str:
        """Give the one-line message, whatever the parts hold."""
        words = isinstance(self.got, str) and self.got.startswith("nothing")
        got = str(self.got) if words else " ".join(repr(self.got).split())
        field, got = printable(self.field), printable(got)
        # What is allowed may be a list of many names.
        allowed, hint = printable(self.allowed, 2 * MOST_LETTERS), printable(self.hint, 2 * MOST_LETTERS)
        return f"{field}: got {got}, must be {allowed}; try {hint}"
