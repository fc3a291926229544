"""The `identify` commands: bench recordings become joint and friction parameters."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from plategait.cli import options, report
from plategait.cli.command import Command, Group
from plategait.cli.identify.bending import bending
from plategait.cli.identify.compression import compression
from plategait.cli.identify.friction import friction
from plategait.cli.identify.modes import ring
from plategait.errors import InputError
from plategait.files.output import check_writable

identify = typer.Typer(cls=Group, help="Read joint and friction parameters off bench recordings.")
identify.command(cls=Command)(bending)
identify.command(cls=Command)(compression)
identify.command(cls=Command)(friction)
identify.command(name="modes", cls=Command)(ring)

KINDS = ("bending", "compression", "friction", "modes")


@identify.command(cls=Command)
def example(
    kind: Annotated[str, typer.Argument(metavar="KIND", help=f"One of {', '.join(KINDS)}.")],
    out: Annotated[Path, typer.Argument(metavar="FILE.csv", help="Where to write it.")],
    seed: options.Seed = 0,
    as_json: options.Json = False,
) -> None:
    """Write a recording as a rig would give it, made from Table 4.1's values, to see the format and try a command."""
    if kind not in KINDS:
        raise InputError("KIND", kind, f"one of {', '.join(KINDS)}", "bending")
    check_writable(out, (".csv",), "FILE.csv")
    from plategait.identify import examples

    examples.WRITERS[kind](out, seed)
    if as_json:
        return report.print_json({"out": str(out), "kind": kind, "seed": seed})
    print(f"wrote {out}; try plategait identify {kind} {out}")
