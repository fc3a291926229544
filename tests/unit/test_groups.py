"""Groups of options: dataclasses that a command takes, and that are typed as one option for each field."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import pytest
import typer
from typer.testing import CliRunner

from plategait.cli.groups import grouped


@dataclass(frozen=True)
class Plate:
    size: Annotated[str, typer.Option("--size", help="Of the plate.")]
    angles: Annotated[list[str] | None, typer.Option("--angle")] = None
    level: Annotated[bool, typer.Option("--level/--tilted")] = True


@pytest.fixture
def run():
    calls: list[tuple[object, ...]] = []
    app = typer.Typer()

    @app.command()
    @grouped
    def command(
        context: typer.Context,
        name: Annotated[str, typer.Argument(metavar="NAME")],
        *,
        count: Annotated[int, typer.Option("--count")] = 2,
        plate: Plate,
    ) -> None:
        """What it is for."""
        calls.append((name, count, plate, sorted(context.params)))

    def invoke(*arguments: str):
        result = CliRunner().invoke(app, list(arguments))
        return result.exit_code, result.output, calls[-1] if calls else None

    return invoke


def test_a_group_is_typed_as_options_and_comes_as_one(run):
    status, _, call = run("x", "--size", "3 mm", "--angle", "1", "--angle", "2", "--tilted")
    assert status == 0
    assert call == ("x", 2, Plate("3 mm", ["1", "2"], False), ["angles", "count", "level", "name", "size"])


def test_a_field_without_a_default_must_be_typed(run):
    status, output, call = run("x")
    assert status == 2
    assert "--size" in output
    assert call is None


def test_help_says_what_the_command_and_its_groups_say(run):
    _, output, _ = run("--help")
    assert "What it is for." in output
    assert "Of the plate." in output
