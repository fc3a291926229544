"""A scenario as the page has it: plain numbers in SI, nested as the model is. A picture travels as rows of text."""

from __future__ import annotations

import tomllib
from typing import Any

import numpy as np
from numpy.typing import NDArray

from plategait.model.motion import AXES, Samples
from plategait.model.outline import Mask, occupied_squares
from plategait.model.plain import plain_model
from plategait.model.scenario import Scenario

# Pixels of a picture and samples of a trajectory that travel as they are: some hundred kilobytes each.
MOST_PIXELS = 250_000
MOST_SAMPLES = 5_000


def plain_scenario(scenario: Scenario) -> tuple[dict[str, Any], list[str]]:
    """Scenario for the page, and what of it had to be thinned, a sentence each.

    Numbers are those of the model, bit for bit. A mask's picture comes as `rows`, and no name of a file goes along.
    """
    plain = plain_model(scenario)
    notes: list[str] = []
    if isinstance(scenario.sheet.outline, Mask):
        plain["sheet"]["outline"], note = _rows(scenario.sheet.outline, scenario.sheet.pitch)
        notes += note
    samples = scenario.motion.samples
    if samples is not None and len(samples.time) > MOST_SAMPLES:
        plain["motion"]["samples"], every = _thinned(samples)
        notes.append(f"of the plate's trajectory one sample in {every} is shown, of {len(samples.time)}")
    return plain, notes


def told_scenario(text: str) -> Scenario:
    """Scenario of the text that files of ours hold; a trajectory is in it, and no other file is read for one.

    Raises
    ------
    InputError, ValueError
        When it is none.
    """
    told = tomllib.loads(text)
    if isinstance(told.get("motion"), dict) and isinstance(told["motion"].get("samples"), str):
        raise ValueError("a trajectory in another file")
    return Scenario(**told)


def flat(plain: dict[str, Any], prefix: str = "") -> dict[str, Any]:
    """Numbers and words of a plain scenario by their dotted names; elements of lists by their place."""
    found: dict[str, Any] = {}
    for name, value in plain.items():
        dotted = f"{prefix}{name}"
        if isinstance(value, list) and value and isinstance(value[0], dict):
            value = {str(i): element for i, element in enumerate(value)}
        if isinstance(value, dict):
            found |= flat(value, f"{dotted}.")
        else:
            found[dotted] = value
    return found


def _rows(mask: Mask, pitch: float) -> tuple[dict[str, Any], list[str]]:
    """A mask as rows of text that give the same lattice."""
    # (columns, rows) of the sheet alone, row 0 at the bottom.
    pixels, (length, _) = mask.pixels(), mask.size()
    if pixels.size <= MOST_PIXELS:
        return _mask(pixels, length), []
    fewer = _coarser(pixels)
    told = (
        f"the picture is shown in {fewer.shape[0]} × {fewer.shape[1]} pixels of {pixels.shape[0]} × {pixels.shape[1]}"
    )
    coarse = _mask(fewer, length)
    squares = occupied_squares(mask, pitch)
    try:
        same = bool(np.array_equal(occupied_squares(Mask(**coarse), pitch), squares))
    except ValueError:
        same = False
    if same:
        return coarse, [told]
    return _mask(squares, squares.shape[0] * pitch), ["the picture is shown in squares of the pitch"]


def _mask(pixels: NDArray[np.bool_], length: float) -> dict[str, Any]:
    rows = ["".join("#" if dark else "." for dark in row) for row in pixels.T[::-1]]
    return {"shape": "mask", "width_of_picture": length, "image": None, "rows": rows}


def _coarser(pixels: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """What the middles of fewer, larger pixels see, as near to square as those were."""
    shrink = (pixels.size / MOST_PIXELS) ** 0.5
    places = [
        ((np.arange(max(1, int(n / shrink))) + 0.5) * n / max(1, int(n / shrink))).astype(int) for n in pixels.shape
    ]
    return pixels[np.ix_(*places)]


def _thinned(samples: Samples) -> tuple[dict[str, Any], int]:
    every = -(-len(samples.time) // MOST_SAMPLES)
    kept = sorted({*range(0, len(samples.time), every), len(samples.time) - 1})
    told = {name: [getattr(samples, name)[i] for i in kept] if getattr(samples, name) else [] for name in AXES}
    return {"time": [samples.time[i] for i in kept], **told}, every
