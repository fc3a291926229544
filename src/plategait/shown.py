"""Results that show themselves: a few lines for a terminal, a small table and a picture for a notebook, never arrays.

A result says what a person asks first (`told`); its picture is made by whoever draws it, which stands on a higher floor
and is found by name, when it is asked for.
"""

from __future__ import annotations

import html
import importlib
import io
from collections.abc import Mapping, Sequence
from dataclasses import fields, is_dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from matplotlib.figure import Figure

# Who draws a result, by the name of its class: a module and its function of the result alone.
_DRAWN_BY = {
    "Atlas": ("moves.figures", "plot_atlas"),
    "Campaign": ("campaign.figures", "plot_campaign"),
    "Curve": ("plots.figures", "plot_curve"),
    "Estimate": ("estimate.figures", "plot_estimate"),
    "Optimum": ("optimize.figures", "plot_optimum"),
    "Simulation": ("plots.figures", "plot_run"),
    "Following": ("control.figures", "plot_following"),
    "Steering": ("control.figures", "plot_steering"),
    "Track": ("vision.figures", "plot_track"),
    "BendingResult": ("identify.bending.figures", "plot_bending"),
    "CompressionResult": ("identify.compression.figures", "plot_compression"),
    "FrictionResult": ("identify.friction.figures", "plot_tilt"),
    "RingResult": ("identify.modes.figures", "plot_ring"),
}

MOST_LINES = 11
_WIDEST = 96
_LEFT = 'style="text-align:left"'
# Of a picture in a notebook, dots to an inch.
_DOTS = 80


class Shown:
    """A result that shows itself. `told` may be replaced by what a person asks first."""

    def told(self) -> Sequence[tuple[str, str]]:
        """What it shows, in pairs of a name and a few words: by default every field, arrays by their shape."""
        assert is_dataclass(self)
        return [
            (field.name, in_short(getattr(self, field.name)))
            for field in fields(self)
            if not field.name.startswith("_")
        ]

    def __repr__(self) -> str:
        """What it shows, in a few lines."""
        rows = _within(self.told(), MOST_LINES)
        widest = max((len(name) for name, _ in rows), default=0)
        lines = [type(self).__name__, *(f"  {name:<{widest}}  {value}" for name, value in rows)]
        return "\n".join(line if len(line) <= _WIDEST else f"{line[: _WIDEST - 1]}…" for line in lines)

    def _repr_html_(self) -> str:
        """Table and small picture for a notebook."""
        rows = "".join(
            f"<tr><th {_LEFT}>{html.escape(name)}</th><td {_LEFT}>{html.escape(value)}</td></tr>"
            for name, value in _within(self.told(), 3 * MOST_LINES)
        )
        title = html.escape(type(self).__name__)
        return f"<table><caption>{title}</caption><tbody>{rows}</tbody></table>{self._small_picture()}"

    def _small_picture(self) -> str:
        if type(self).__name__ not in _DRAWN_BY:
            return ""
        try:
            picture = io.BytesIO()
            self.plot().savefig(picture, format="png", dpi=_DOTS)
        except Exception:  # what cannot be drawn, such as a curve without points, is told by its table
            return ""
        from base64 import b64encode

        return (
            f'<img alt="" style="max-width:100%" src="data:image/png;base64,{b64encode(picture.getvalue()).decode()}">'
        )

    def plot(self, **options: Any) -> Figure:
        """Picture of it, as a Matplotlib figure; a notebook shows it, ``figure.savefig("a.png")`` writes it.

        Parameters
        ----------
        **options
            Of whoever draws it: `plategait.plots.figures`, and `figures` of each room.

        Raises
        ------
        AttributeError
            Where nobody draws what it is.
        """
        drawn = _DRAWN_BY.get(type(self).__name__)
        if drawn is None:
            raise AttributeError(f"{type(self).__name__} has no picture")
        module, name = drawn
        return getattr(importlib.import_module(f"plategait.{module}"), name)(self, **options)


def in_short(value: object) -> str:
    """A value in a few words: arrays and long lists by their size."""
    if isinstance(value, np.ndarray):
        return f"{value.dtype} array {value.shape}" if value.size > 6 else np.array2string(value, precision=4)
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, Mapping):
        names = ", ".join(map(str, value))
        return f"{len(value)}: {names}" if len(names) < 60 else f"{len(value)} by name"
    if isinstance(value, (tuple, list)) and (len(value) > 4 or any(map(is_dataclass, value))):
        kinds = {type(each).__name__ for each in value}
        return f"{len(value)} × {kinds.pop()}" if len(kinds) == 1 else f"{len(value)} items"
    if isinstance(value, Shown) or (is_dataclass(value) and not isinstance(value, type)):
        return f"a {type(value).__name__}"
    text = " ".join(repr(value).split()) if not isinstance(value, str) else value or "–"
    return text if len(text) <= 70 else f"{text[:69]}…"


def _within(rows: Sequence[tuple[str, str]], most: int) -> list[tuple[str, str]]:
    if len(rows) <= most:
        return list(rows)
    left = len(rows) - most + 1
    return [*rows[: most - 1], ("…", f"{left} more")]
