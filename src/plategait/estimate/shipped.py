"""Files that come with the estimators: what they were trained on, and the coefficients that came of it."""

from __future__ import annotations

from importlib.resources import files


def shipped(name: str) -> str:
    """Text of a file that `training` or `any_size_training` wrote, such as "fits.csv"."""
    return files("plategait.estimate").joinpath("data", name).read_text(encoding="utf-8")
