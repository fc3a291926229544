"""Help groups options, says what they are written in, and its examples can be typed."""

from __future__ import annotations

import shlex

import pytest
from typer.main import get_command

from plategait.cli import app
from plategait.cli.help_pages import EXAMPLES

COMMANDS = get_command(app).commands  # type: ignore[attr-defined]
TYPED = [(name, example) for name, examples in EXAMPLES.items() for example in examples]


@pytest.mark.parametrize(("name", "example"), TYPED, ids=[example for _, example in TYPED])
def test_every_example_is_understood(name, example):
    program, command, *arguments = shlex.split(example.partition(" > ")[0])
    assert (program, command) == ("plategait", name)
    COMMANDS[name].make_context(name, arguments)


def test_every_command_has_an_example():
    alone = {name for name, command in COMMANDS.items() if not hasattr(command, "commands")}
    assert alone - set(EXAMPLES) == set()


def test_no_option_is_written_in_a_programmers_word():
    plain = [
        (name, option.opts[0])
        for name, command in COMMANDS.items()
        for option in command.params
        if not hasattr(command, "commands") and option.param_type_name == "option" and option.name != "help"
        and option.metavar is None and "|" not in option.display_type(None)
    ]  # fmt: skip
    assert plain == [], plain


def test_help_has_its_groups_and_examples(called, tmp_path):
    said = called("simulate", "--help", cwd=tmp_path, check=0).stdout
    for group in ("Object", "Motion", "Runs", "Output", "Examples:"):
        assert group in said
    assert "<bool>" not in said
    for group in ((), ("identify",), ("study",)):
        assert "<bool>" not in called(*group, "--help", cwd=tmp_path, check=0).stdout


def test_a_shell_completes_commands(called, monkeypatch, tmp_path):
    monkeypatch.setenv("_PLATEGAIT_COMPLETE", "complete_bash")
    monkeypatch.setenv("COMP_WORDS", "plategait sim")
    monkeypatch.setenv("COMP_CWORD", "1")
    assert called(cwd=tmp_path, check=0).stdout.split() == ["simulate"]
