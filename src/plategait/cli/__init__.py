"""The command line. Exit status: 0; 1 when it ran and the answer is a failure; 2 for usage or bad input."""

from __future__ import annotations

import os
import sys
from typing import Annotated

import typer
from typer.exceptions import TyperException

from plategait.cli.command import Command, Group, usage_line
from plategait.cli.curve import curve, fit
from plategait.cli.estimate import estimate
from plategait.cli.estimate_all import estimate_all
from plategait.cli.export import export
from plategait.cli.identify.commands import identify
from plategait.cli.lab import lab
from plategait.cli.materials import materials
from plategait.cli.modes import modes
from plategait.cli.moves import moves
from plategait.cli.needs import needs_command
from plategait.cli.optimize import optimize
from plategait.cli.report import INTERRUPTED
from plategait.cli.scenario import scenario_command
from plategait.cli.shoot import shoot
from plategait.cli.simulate import simulate
from plategait.cli.steer import steer
from plategait.cli.study import study
from plategait.cli.sweep import plot_store, sweep
from plategait.cli.target import target
from plategait.cli.thesis import thesis
from plategait.cli.track import track
from plategait.cli.track_folder import track_folder
from plategait.cli.track_strip import track_strip
from plategait.errors import InputError

app = typer.Typer(
    cls=Group, pretty_exceptions_enable=False, context_settings={"help_option_names": ["-h", "--help"]},
    help="Simulates a thin soft object on a vibrating plate: how it slides, walks, runs and spins.",
)  # fmt: skip


@app.callback(invoke_without_command=True)
def root(
    context: typer.Context, version: Annotated[bool, typer.Option("--version", help="Print the version.")] = False
) -> None:
    """Simulates a thin soft object on a vibrating plate: how it slides, walks, runs and spins."""
    if version:
        from plategait.version import __version__

        print(f"plategait {__version__}")
    elif context.invoked_subcommand is None:
        print(context.get_help())


app.command(cls=Command)(simulate)
app.command(cls=Command)(curve)
app.command(cls=Command)(fit)
app.command(cls=Command)(export)
app.command(cls=Command)(modes)
app.command(cls=Command)(lab)
app.command(name="needs", cls=Command)(needs_command)
app.command(cls=Command)(optimize)
app.command(cls=Command)(moves)
app.command(cls=Command)(steer)
app.command(cls=Command)(materials)
app.command(name="scenario", cls=Command)(scenario_command)
app.command(cls=Command)(estimate)
app.command("estimate-all", cls=Command)(estimate_all)
app.add_typer(identify, name="identify")
app.command(cls=Command)(track)
app.command(cls=Command)(track_folder)
app.command(cls=Command)(track_strip)
app.command(cls=Command)(target)
app.command(cls=Command)(shoot)
app.command(cls=Command)(sweep)
app.command(name="plot", cls=Command)(plot_store)
app.command(cls=Command)(thesis)
app.add_typer(study, name="study")


def main() -> None:
    """Run the command line; whatever is wrong is one line on standard error."""
    try:
        # Not standalone, or typer would box its usage errors. An exit status is returned then, 130 for an interrupt.
        status = app(standalone_mode=False, prog_name="plategait")
        sys.stdout.flush()
        if status == INTERRUPTED:
            raise KeyboardInterrupt
    except InputError as error:
        status, message = 2, str(error)
    except TyperException as error:
        status, message = 2, usage_line(error)
    except KeyboardInterrupt:
        status, message = INTERRUPTED, "interrupted, nothing written"
    except MemoryError:
        status, message = 2, "this needs more memory than there is; try a shorter, coarser or smaller one"
    except RecursionError:
        status, message = 2, "a file holds lists or tables nested too deep; try a flat one"
    except ValueError as error:
        if "integer string conversion" not in str(error):
            raise
        status, message = 2, "a number has more digits than can be read; try one of a few digits"
    except OSError as error:
        status, message = 2, f"{error.strerror or error}; try another place with room to write"
        # What could not be printed is not printed again at exit.
        sys.stdout = open(os.devnull, "w")  # noqa: SIM115
    else:
        sys.exit(status or 0)
    print(f"plategait: {message}", file=sys.stderr)
    sys.exit(status)
