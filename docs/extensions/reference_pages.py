"""Reference pages made of the package: commands with their options, observables, channels, keys of files, names."""

from __future__ import annotations

import importlib
import inspect
from collections.abc import Iterable, Iterator
from typing import Any, ClassVar

from docutils import nodes
from docutils.parsers.rst import Directive
from docutils.statemachine import StringList
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective
from sphinx.util.nodes import nested_parse_with_titles


class _Written(SphinxDirective):
    """A directive that writes reStructuredText."""

    has_content: ClassVar[bool] = False

    def lines(self) -> Iterator[str]:
        """The text, line by line."""
        raise NotImplementedError

    def run(self) -> list[nodes.Node]:
        """Parse what was written, titles included."""
        here = nodes.section()
        here.document = self.state.document
        nested_parse_with_titles(self.state, StringList(list(self.lines()), source=type(self).__name__), here)
        return here.children


class Commands(_Written):
    """Every command: what it does, how it is typed, its options by group, examples."""

    def lines(self) -> Iterator[str]:
        """A section for each."""
        for path, command in commands():
            yield from _command(path, command)


def commands() -> Iterator[tuple[str, Any]]:
    """Every command by what is typed for it: "identify bending", and what its parser knows of it."""
    import typer

    from plategait.cli import app

    group: Any = typer.main.get_command(app)
    yield from _below("", group)


def _below(path: str, group: Any) -> Iterator[tuple[str, Any]]:
    for name, command in group.commands.items():
        full = f"{path} {name}".strip()
        if hasattr(command, "commands"):
            yield from _below(full, command)
        else:
            yield full, command


def _command(path: str, command: Any) -> Iterator[str]:
    from typer.core import TyperOption

    options = [p for p in command.params if isinstance(p, TyperOption) and not getattr(p, "hidden", False)]
    arguments = [p for p in command.params if not isinstance(p, TyperOption)]
    yield from ("", f".. _command-{path.replace(' ', '-')}:", "", path, "^" * len(path), "")
    yield from inspect.cleandoc(command.help or "").replace("\b", "").splitlines()
    yield from ("", ".. code-block:: sh", "")
    typed = " ".join(["plategait", path, *(_argument(p) for p in arguments), *(["[OPTIONS]"] if options else [])])
    yield f"   {typed}"
    examples = (command.epilog or "").removeprefix("Examples:").strip()
    if examples:
        yield from ("", "Examples:", "", ".. code-block:: sh", "")
        yield from (f"   {line}" for line in examples.splitlines() if line)
    yield ""
    yield from (line for p in arguments if getattr(p, "help", None) for line in _row(_argument(p), p))
    for group in dict.fromkeys(p.rich_help_panel or "" for p in options):
        yield from ("", f".. rubric:: {group or 'Of this command'}", "")
        yield from (line for p in options if (p.rich_help_panel or "") == group for line in _row(_option(p), p))


def _argument(parameter: Any) -> str:
    name = str(parameter.metavar or parameter.name.upper()).strip("[]….")
    return f"[{name}]" if not parameter.required else name


def _option(parameter: Any) -> str:
    names = ", ".join([*parameter.opts, *parameter.secondary_opts])
    if getattr(parameter, "is_flag", False):
        return names
    choices = parameter.type_descriptor.choices or ()
    return f"{names} {parameter.metavar or '|'.join(map(_word, choices)) or 'VALUE'}"


def _word(choice: Any) -> str:
    return str(getattr(choice, "value", choice))


def _row(typed: str, parameter: Any) -> Iterator[str]:
    """One entry of a definition list, which says the default."""
    default = parameter.default
    said = " ".join((parameter.help or "").split()) or "."
    shown = (
        default not in (None, False, (), [], "") and not callable(default) and getattr(parameter, "show_default", True)
    )
    told = f" Default: ``{_word(default)}``." if shown else ""
    several = " May be given several times." if getattr(parameter, "multiple", False) else ""
    yield from (f"``{typed}``", f"    {_escaped(said)}{told}{several}", "")


def _escaped(text: str) -> str:
    """Text of help, in which nothing is markup but backquotes."""
    marked = text.replace("\\", "\\\\").replace("*", "\\*").replace("|", "\\|").replace("_ ", "\\_ ")
    return marked.replace("``", "`").replace("`", "``")


class Observables(_Written):
    """Every observable, from the rows that measure it."""

    def lines(self) -> Iterator[str]:
        """A table."""
        from plategait.simulation.registry import BUILT_IN

        heads = ("Name", "Unit", "In tables and files", "What it is", "Several starts show")
        rows = [
            (f"``{o.name}``", o.unit, f"``{o.heading}``, JSON ``{o.key}``", o.long_name,
             "the mean of those that did not fail" if o.over_runs == "mean" else "the one furthest from zero")
            for o in BUILT_IN
        ]  # fmt: skip
        yield from _table(heads, rows)


class Channels(_Written):
    """Every channel of a recording."""

    def lines(self) -> Iterator[str]:
        """A table."""
        from plategait.engine.channels import SERIES

        kinds = {"state": "its state then", "amount": "an amount since the last", "share": "a share of the time since"}
        rows = [(f"``{c.name}``", c.unit, c.long_name, kinds[c.kind]) for c in SERIES.values()]
        yield from _table(("Name", "Unit", "What it is", "A sample holds"), rows)


class Fields(_Written):
    """Every key of a model's file: ``.. fields:: plategait.Scenario``, and of the models inside it."""

    required_arguments = 1

    def lines(self) -> Iterator[str]:
        """A table for each model."""
        module, _, name = self.arguments[0].rpartition(".")
        yield from self._model(getattr(importlib.import_module(module), name), "")

    def _model(self, model: Any, path: str) -> Iterator[str]:
        from plategait.model.described import documented

        text = documented("", model.model_fields).partition("----------\n")[2].partition("\n\nRaises")[0]
        rows = []
        for entry in text.replace("\n    ", "\t").splitlines():
            head, said = entry.split("\t")
            name, kind = head.split(" : ")
            rows.append((f"``{path}{name}``", _escaped(kind), _escaped(said)))
        yield from _table(("Key", "Type", "What it is"), rows)
        for name, field in model.model_fields.items():
            inner = field.annotation
            if inspect.isclass(inner) and hasattr(inner, "model_fields"):
                yield from ("", f".. rubric:: [{path}{name}]", "")
                yield from self._model(inner, f"{path}{name}.")


class Public(_Written):
    """Public names with their docstrings: a group of those that `plategait.__all__` has."""

    has_content: ClassVar[bool] = True

    def lines(self) -> Iterator[str]:
        """A table of what there is, and each one in full."""
        names = [name for line in self.content for name in line.split()]
        yield from (".. autosummary::", "")
        yield from (f"   {name if name.startswith('plategait.') else f'plategait.{name}'}" for name in names)
        for name in names:
            yield from _documented(name if name.startswith("plategait.") else f"plategait.{name}")


def _documented(name: str) -> Iterator[str]:
    module, _, short = name.rpartition(".")
    thing = getattr(importlib.import_module(module), short)
    title = short
    yield from ("", title, "~" * len(title), "")
    if inspect.isclass(thing):
        members = [m for m, value in vars(thing).items() if not m.startswith("_") and _told(thing, m, value)]
        yield f".. autoclass:: {name}"
        if members:
            yield from (f"   :members: {', '.join(members)}",)
    elif inspect.isroutine(thing):
        yield f".. autofunction:: {name}"
    else:
        yield f".. autodata:: {name}"
        yield "   :no-value:"
    yield ""


def _told(owner: type, name: str, value: object) -> bool:
    """Whether a member is one that people call or read, and says what it is."""
    if name.startswith("model_") or name == "also_read":
        return False
    inner = getattr(value, "__func__", value)
    kept = inspect.isfunction(inner) or isinstance(inner, property) or type(inner).__name__ == "cached_property"
    return kept and bool(inspect.getdoc(inner))


def _table(heads: Iterable[str], rows: Iterable[tuple[str, ...]]) -> Iterator[str]:
    yield from ("", ".. list-table::", "   :header-rows: 1", "   :class: longtable", "")
    for row in (tuple(heads), *rows):
        yield from (f"   {'* -' if i == 0 else '  -'} {cell or '–'}" for i, cell in enumerate(row))
    yield ""


def setup(app: Sphinx) -> dict[str, bool]:
    """Make the directives known."""
    directives: dict[str, type[Directive]] = {
        "commands": Commands, "observables": Observables, "channels": Channels, "fields": Fields, "public": Public,
    }  # fmt: skip
    for name, directive in directives.items():
        app.add_directive(name, directive)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
