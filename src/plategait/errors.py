"""Errors that say what to type instead."""

from __future__ import annotations


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
        """Give the one-line message."""
        shown = (
            self.got
            if isinstance(self.got, str) and self.got.startswith("nothing")
            else " ".join(repr(self.got).split())
        )
        return f"{self.field}: got {shown}, must be {self.allowed}; try {self.hint}"
