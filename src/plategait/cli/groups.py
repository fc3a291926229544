"""Options that come as a group: a command takes one dataclass, and people type its fields as options."""

from __future__ import annotations

import dataclasses
import functools
import inspect
import typing
from collections.abc import Callable


def grouped(command: Callable[..., None]) -> Callable[..., None]:
    """Give a command the options of its groups: each parameter that is a dataclass is typed field by field.

    The fields are annotated and have defaults as options of a command do; help and errors know them by their own names.
    """
    parameters: list[inspect.Parameter] = []
    groups: dict[str, type] = {}
    for name, annotation, default in _parameters(command):
        if dataclasses.is_dataclass(annotation) and isinstance(annotation, type):
            groups[name] = annotation
            parameters += [_keyword(*field) for field in _parameters(annotation)]
        else:
            parameters.append(_keyword(name, annotation, default))

    @functools.wraps(command)
    def with_groups(**options: object) -> None:
        for name, group in groups.items():
            options[name] = group(**{f.name: options.pop(f.name) for f in dataclasses.fields(group)})
        command(**options)

    with_groups.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
    with_groups.__annotations__ = {p.name: p.annotation for p in parameters}
    return with_groups


def _parameters(callee: Callable[..., object]) -> list[tuple[str, object, object]]:
    """Name, annotation and default of each parameter of a function or a dataclass."""
    hints = typing.get_type_hints(callee, include_extras=True)
    return [(p.name, hints[p.name], p.default) for p in inspect.signature(callee).parameters.values()]


def _keyword(name: str, annotation: object, default: object) -> inspect.Parameter:
    return inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=default, annotation=annotation)
