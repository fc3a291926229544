"""Letters and figures of straight strokes, as a pen plotter draws them: what a word's path is made of."""

from __future__ import annotations

import numpy as np

from plategait.arrays import Array
from plategait.errors import InputError

# Strokes apart by "/", their corners as two digits: x from 0 to 8, y from 0 to c (12), which is the height.
_GLYPHS = {
    "A": "00 4c 80/14 74", "B": "00 0c 5c 7b 7a 78 67 56 06/56 75 84 82 71 50 00",
    "C": "8a 7b 5c 3c 1b 09 03 11 30 50 71 82", "D": "00 0c 4c 6b 89 83 61 40 00", "E": "8c 0c 00 80/06 66",
    "F": "8c 0c 00/06 66", "G": "8a 7b 5c 3c 1b 09 03 11 30 50 71 83 86 56", "H": "0c 00/06 86/8c 80", "I": "4c 40",
    "J": "7c 73 61 40 30 11 03", "K": "0c 00/8c 05/38 80", "L": "0c 00 80", "M": "00 0c 44 8c 80", "N": "00 0c 80 8c",
    "O": "3c 1b 09 03 11 30 50 71 83 89 7b 5c 3c", "P": "00 0c 5c 7b 8a 88 77 56 06",
    "Q": "3c 1b 09 03 11 30 50 71 83 89 7b 5c 3c/53 80", "R": "00 0c 5c 7b 8a 88 77 56 06/46 80",
    "S": "8a 7b 5c 3c 1b 0a 08 17 36 56 75 84 82 71 50 30 11 02", "T": "0c 8c/4c 40", "U": "0c 03 11 30 50 71 83 8c",
    "V": "0c 40 8c", "W": "0c 20 48 60 8c", "X": "0c 80/8c 00", "Y": "0c 46 8c/46 40", "Z": "0c 8c 00 80",
    "0": "3c 1b 09 03 11 30 50 71 83 89 7b 5c 3c", "1": "29 4c 40", "2": "0a 1b 3c 5c 7b 8a 88 00 80",
    "3": "0c 8c 37 57 76 84 82 71 50 30 11 02", "4": "60 6c 03 83", "5": "7c 1c 17 57 76 84 82 71 50 30 11 02",
    "6": "7b 5c 3c 1b 09 03 11 30 50 71 82 84 75 56 36 15 04", "7": "0c 8c 30",
    "8": "36 17 08 0a 1b 3c 5c 7b 8a 88 77 56 36 15 04 02 11 30 50 71 82 84 75 56 36",
    "9": "11 30 50 71 83 89 7b 5c 3c 1b 0a 08 17 36 56 77 88", "-": "16 76",
}  # fmt: skip
_HEIGHT, _GAP, _SPACE = 12, 4, 6


def strokes_of(word: str, height: float, field: str = "path") -> list[Array]:
    """Strokes (n, 2) of a word about its middle, in the unit of the height.

    Parameters
    ----------
    word : str
        Letters A to Z, small or large, figures, hyphens and blanks.
    height : float
        Of a letter.
    field : str
        What errors call it.

    Raises
    ------
    InputError
        For a letter that there is not, or nothing but blanks.
    """
    strokes: list[Array] = []
    left = 0
    for letter in word.upper():
        if letter == " ":
            left += _SPACE
            continue
        if letter not in _GLYPHS:
            raise InputError(field, word, "a word of A to Z, 0 to 9, - and blanks, figure of eight, or a .csv file",
                             '"figure of eight"')  # fmt: skip
        glyph = [np.array([[int(c, 16) for c in corner] for corner in stroke.split()], dtype=float)
                 for stroke in _GLYPHS[letter].split("/")]  # fmt: skip
        every = np.concatenate(glyph)
        strokes += [stroke + np.array([left - every[:, 0].min(), 0.0]) for stroke in glyph]
        left += int(np.ptp(every[:, 0])) + _GAP
    if not strokes:
        raise InputError(field, word, "a word with letters in it", '"figure of eight"')
    every = np.concatenate(strokes)
    middle = (every.min(axis=0) + every.max(axis=0)) / 2
    return [(stroke - (middle[0], _HEIGHT / 2)) * (height / _HEIGHT) for stroke in strokes]
