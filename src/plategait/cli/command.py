"""A command whose errors name the option that was typed, and which takes no option that changes nothing."""

from __future__ import annotations

import sys
from collections.abc import Collection, Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer
from typer.core import TyperCommand, TyperGroup
from typer.exceptions import TyperException

from plategait.cli.help_pages import complete
from plategait.cli.usage import usage_error
from plategait.errors import InputError, printable

if TYPE_CHECKING:
    from typer.core import TyperArgument, TyperOption

# Fields of scenarios and of functions that an option of another name is laid over.
_LAID_OVER = {
    "motion.frequency": "frequency", "motion.angle": "angle", "motion.stroke": "stroke", "sheet.mass": "mass",
    "friction.static": "mu_s", "friction.kinetic": "mu_k", "friction.law": "friction_law", "friction_ratio": "beta",
    "time_step": "dt", "preset": "preset_name", "marker": "fiducial", "appearance.exposure": "exposure",
    "young_modulus": "young", "poisson_ratio": "poisson", "corners": "outline",
    "appearance.noise": "noise", "appearance.crf": "crf", "appearance.hidden": "hidden",
}  # fmt: skip

# Units that people leave outside quotes.
_UNITS = {
    "deg",
    "rad",
    "m",
    "mm",
    "cm",
    "s",
    "ms",
    "g",
    "kg",
    "hz",
    "khz",
    "pi",
    "rad/s",
    "pa",
    "kpa",
    "mpa",
    "gpa",
    "kg/m^3",
}


class Command(TyperCommand):
    """A command that says `--mu-k` where `friction.kinetic` came from it."""

    def __init__(self, *args: Any, **options: Any) -> None:
        """Make a command with what help says of it (`help_pages`)."""
        super().__init__(*args, **options)
        complete(self)

    def get_help_option(self, ctx: Any) -> Any:
        """`--help`, which takes no value."""
        option = super().get_help_option(ctx)
        if option is not None:
            option.metavar = ""
        return option

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Read the options; whatever is wrong with them is known to belong to this command."""
        try:
            return super().parse_args(ctx, args)
        except TyperException as error:
            if getattr(error, "ctx", None) is None:
                error.ctx = ctx  # type: ignore[attr-defined]
            raise

    def invoke(self, ctx: Any) -> Any:
        """Run the command."""
        try:
            return super().invoke(ctx)
        except InputError as error:
            if quoted := _loose_unit(error.got):
                raise InputError(error.field, error.got, error.allowed, f"quotes: {quoted}") from None
            name = _LAID_OVER.get(error.field, error.field)
            option = next((p for p in self.params if p.name == name and given(ctx, name)), None)
            if option is None or option.param_type_name == "argument":
                raise
            raise InputError(option.opts[0], error.got, error.allowed, error.hint) from None


class Group(TyperGroup):
    """Commands under one name, in whose help a flag is written in nothing."""

    def get_params(self, ctx: Any) -> list[Any]:
        """The options of the group itself, `--help` among them."""
        params = super().get_params(ctx)
        for param in params:
            if getattr(param, "is_flag", False):
                param.metavar = ""  # type: ignore[attr-defined]
        return params


def refuse(context: typer.Context, names: Iterable[str], where: str, hint: str) -> None:
    """Refuse what was typed and would change nothing.

    Parameters
    ----------
    names : iterable of str
        Of the command's parameters, as its function calls them.
    where : str
        Of what else was typed: "with --status".
    hint : str
        What to type instead.

    Raises
    ------
    InputError
        Naming the first of them that was typed.
    """
    for name in names:
        if given(context, name):
            got = context.params[name]
            value = "nothing it would change" if got is True else str(got) if isinstance(got, Path) else got
            raise InputError(_spelt(context, name), value, f"left out {where}", hint)


def take_only(context: typer.Context, names: Collection[str], where: str, hint: str) -> None:
    """Refuse whatever was typed but these, so that a new option is refused until it has an effect here (see `refuse`).

    Raises
    ------
    InputError
        Naming the first other parameter that was typed.
    """
    refuse(context, [p.name for p in context.command.params if p.name and p.name not in names], where, hint)


def usage_line(error: TyperException) -> str:
    """One line for what the parser refuses, with the help of the command that it was typed for."""
    said = printable(" ".join(error.format_message().split()).rstrip(".").replace("Value error, ", ""))
    context = getattr(error, "ctx", None)
    if quoted := _loose_unit(said.rpartition("(")[2].rstrip(")")):
        return f"{said}; try quotes: {quoted}"
    if refused := usage_error(error):
        return str(refused)
    return f"{said}; try {context.command_path if context else 'plategait'} --help"


def _loose_unit(got: object) -> str:
    """Number and unit as they should have been typed, where this is a unit that stands alone behind a number."""
    typed, unit = sys.argv, got.partition(" ")[0] if isinstance(got, str) else ""
    if unit.lower() not in _UNITS or unit not in typed:
        return ""
    place = typed.index(unit)
    first = next((i for i in range(place, 0, -1) if typed[i].lower() not in _UNITS), 0)
    end = next((i for i in range(place, len(typed)) if typed[i].lower() not in _UNITS), len(typed))
    return f'"{" ".join(typed[first:end])}"' if typed[first][-1:].isdigit() else ""


def given(context: typer.Context, name: str) -> bool:
    """Whether a parameter was typed."""
    source = context.get_parameter_source(name)
    return source is not None and source.name == "COMMANDLINE"


def _spelt(context: typer.Context, name: str) -> str:
    """A parameter as people type it."""
    parameter: TyperArgument | TyperOption = next(p for p in context.command.params if p.name == name)  # type: ignore[assignment]
    return parameter.opts[0] if parameter.param_type_name == "option" else str(parameter.metavar or name).strip("[]")
