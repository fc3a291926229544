"""What the parser of the command line refuses, told as everything else is: field, got, allowed, what to type."""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable
from typing import Any

from typer.exceptions import TyperException

from plategait.cli.help_pages import EXAMPLES
from plategait.errors import InputError, printable

# What pydantic calls what is wrong with a number, and what is meant.
_KINDS = {"int": "a whole number", "float": "a number", "bool": "true or false"}
_BOUNDS = {"ge": "at least", "gt": "above", "le": "at most", "lt": "below"}
_UNKNOWN_COMMAND = re.compile(r"No such command '(.*?)'")
_EXTRA = re.compile(r"unexpected extra arguments? ?\(?s?\)? ?\((.*)\)", re.S)


def usage_error(error: TyperException) -> InputError | None:
    """Error of our own for what the parser refused; None where there is more to read in its own words."""
    kind, context, parameter = type(error).__name__, getattr(error, "ctx", None), getattr(error, "param", None)
    path = context.command_path if context else "plategait"
    if kind == "NoSuchOption":
        return _no_such_option(error, context, path)
    if kind == "MissingParameter" and parameter is not None:
        return InputError(_name_of(parameter), "nothing", "given", _example(context, parameter, path))
    if kind == "BadOptionUsage":
        return InputError(str(getattr(error, "option_name", "")), "nothing", "given a value", f"{path} --help")
    if kind == "BadParameter" and parameter is not None:
        return _bad_value(error, parameter)
    said = error.format_message()
    if found := _UNKNOWN_COMMAND.search(said):
        known = list(getattr(context.command if context else None, "commands", {}))
        close = _nearest(found[1], known)
        return InputError("command", found[1], f"one of {', '.join(known)}", f"{path} {close or '--help'}")
    if found := _EXTRA.search(said):
        return InputError(found[1], "nothing that is asked for here", f"as in {path} {_usage_of(context)}",
                          f"{path} --help")  # fmt: skip
    if said.startswith("Missing command"):
        known = list(getattr(context.command if context else None, "commands", {}))
        return InputError("command", "nothing", f"one of {', '.join(known)}", f"{path} --help")
    return None


def _no_such_option(error: TyperException, context: Any, path: str) -> InputError:
    typed = printable(str(getattr(error, "option_name", "")))
    known = [name for p in (context.command.params if context else ()) for name in p.opts if name.startswith("--")]
    close = _nearest(typed, known)
    return InputError(typed, f"nothing that {path} knows", f"one of {', '.join(known)}", close or f"{path} --help")


def _bad_value(error: TyperException, parameter: Any) -> InputError | None:
    name = _name_of(parameter)
    choices = [str(getattr(choice, "value", choice)) for choice in parameter.type_descriptor.choices or ()]
    if choices:
        got = next(iter(re.findall(r"'([^']*)' is not one of", error.format_message())), "nothing that is a choice")
        close = _nearest(got, choices) or choices[0]
        return InputError(name, got, f"one of {', '.join(choices)}", close)
    details = getattr(error.__cause__, "errors", list)()
    if not details:
        return None
    detail, bound = details[0], ""
    default = parameter.default
    kind = _KINDS.get(detail["type"].partition("_")[0], _KINDS["float" if isinstance(default, float) else "int"])
    for sign, words in _BOUNDS.items():
        if sign in detail.get("ctx", {}):
            bound = f" {words} {detail['ctx'][sign]}"
    works = default if isinstance(default, (int, float)) and not isinstance(default, bool) and default else 1
    return InputError(name, detail["input"], f"{kind}{bound}", str(works))


def _nearest(typed: str, known: Iterable[str]) -> str:
    """Name that may be meant: alike, or begun; nothing where none is."""
    small = typed.lower().lstrip("-").replace("_", "-")
    bare = {name.lstrip("-"): name for name in known}
    begun = [name for name in bare if len(small) > 1 and name.startswith(small)]
    return next((bare[name] for name in begun or difflib.get_close_matches(small, bare, 1, cutoff=0.65)), "")


def _name_of(parameter: Any) -> str:
    if parameter.param_type_name == "option":
        return str(parameter.opts[0])
    return str(parameter.metavar or parameter.name).strip("[]")


def _example(context: Any, parameter: Any, path: str) -> str:
    """A command line of the help that has what is missing."""
    name, examples = _name_of(parameter), EXAMPLES.get(context.command.name or "", ()) if context else ()
    if parameter.param_type_name == "option":
        examples = [example for example in examples if name in example]
    return next(iter(examples), f"{path} {_usage_of(context)}" if context else f"{path} --help")


def _usage_of(context: Any) -> str:
    """Words that a command takes, as its help has them."""
    if context is None:
        return "options alone"
    words = [str(p.metavar or p.name) for p in context.command.params if p.param_type_name == "argument"]
    return " ".join([*words, "[OPTIONS]"])
