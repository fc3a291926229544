"""What is written into the pictures."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING

from plategait.model.scenario import Scenario

if TYPE_CHECKING:
    from PIL.Image import Image
    from PIL.ImageDraw import ImageDraw
    from PIL.ImageFont import FreeTypeFont

_INK = (38, 46, 56)


def motion_in_words(scenario: Scenario) -> str:
    """What the plate does."""
    motion = scenario.motion
    if motion.samples is not None or motion.waves:
        return f"own plate motion at {motion.frequency:g} Hz"
    amplitudes = f"Aₚ = {math.degrees(motion.angle):.4g} deg,  Bₚ = {1e3 * motion.stroke:.4g} mm"
    return f"plate {motion.frequency:g} Hz,  {amplitudes}"


def caption(picture: Image, scenario: Scenario, time: float, slower: float) -> None:
    """Write the object, the plate's motion, the time and how far the film is slowed."""
    from PIL import ImageDraw

    draw, (width, height) = ImageDraw.Draw(picture), picture.size
    unit = height / 720
    # Away from the bar, which leaves the picture at the top left.
    write_text(draw, (width - 32 * unit, 28 * unit), scenario.name, 34 * unit, "rt", width / 2, bold=True)
    write_text(draw, (width - 32 * unit, 76 * unit), motion_in_words(scenario), 22 * unit, "rt", width * 0.55)
    write_text(draw, (32 * unit, height - 30 * unit), f"{1e3 * time:7.1f} ms", 26 * unit, "ls")
    speed = "real time" if math.isclose(slower, 1) else f"slowed {slower:.3g} ×"
    write_text(draw, (width - 32 * unit, height - 30 * unit), speed, 22 * unit, "rs")


def write_text(
    draw: ImageDraw,
    place: tuple[float, float],
    text: str,
    size: float,
    anchor: str,
    room: float = math.inf,
    bold: bool = False,
) -> None:
    """Write text no wider than the room there is."""
    font = _font(size, bold)
    if (wide := font.getlength(text)) > room:
        font = _font(size * room / wide, bold)
    draw.text(place, text, _INK, font, anchor)


def _font(size: float, bold: bool) -> FreeTypeFont:
    from matplotlib import get_data_path
    from PIL import ImageFont

    return ImageFont.truetype(
        Path(get_data_path()) / "fonts" / "ttf" / f"DejaVuSans{'-Bold' if bold else ''}.ttf", max(8, round(size))
    )
