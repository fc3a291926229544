"""A command that takes a group of options is typed as if it took each of them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import typer
from typer.testing import CliRunner

from plategait.cli.groups import grouped

Size = Annotated[float, typer.Option("--size", help="Of it.")]


@dataclass(frozen=True)
class Shape:
    size: Size = 2.0
    name: Annotated[str, typer.Option("--name")] = "square"


@grouped
def draw(
    where: Annotated[str, typer.Argument()],
    shape: Shape,
    twice: Annotated[bool, typer.Option("--twice")] = False,
) -> None:
    """Draw a shape."""
    print(where, shape.name, shape.size, twice)


def typed(*arguments: str) -> str:
    app = typer.Typer()
    app.command()(draw)
    return CliRunner().invoke(app, list(arguments)).output


def test_fields_are_typed_as_options_and_keep_their_defaults() -> None:
    assert typed("here") == "here square 2.0 False\n"
    assert typed("here", "--size", "3", "--twice", "--name", "disk") == "here disk 3.0 True\n"


def test_help_and_errors_know_the_fields_by_their_own_names() -> None:
    text = typed("--help")
    assert "Draw a shape." in text
    assert "--size" in text
    assert "Of it." in text
    assert "--shape" not in text
    assert "--size" in typed("here", "--size", "large")
