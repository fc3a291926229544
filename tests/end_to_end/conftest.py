"""What all tests of commands share."""

from __future__ import annotations

import functools

import pytest
import typer


@pytest.fixture(scope="session", autouse=True)
def commands_built_once():
    """Build the tree of commands once, as a process that runs one command does, and not for each of a thousand."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(typer.main, "get_command", functools.cache(typer.main.get_command))
        yield
