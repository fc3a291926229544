"""Models as plain data: numbers in SI, nested as the models are, which each model reads back the same."""

from __future__ import annotations

from typing import Any

from plategait.model.base import Model


def plain_model(value: object) -> Any:
    """Fields of a model by name, tuples as lists. The name of a picture's file is left out: it is nobody's business."""
    if isinstance(value, Model):
        names = type(value).model_fields
        return {name: None if name == "image" else plain_model(getattr(value, name)) for name in names}
    if isinstance(value, tuple):
        return [plain_model(element) for element in value]
    return value
