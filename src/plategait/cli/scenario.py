"""`plategait scenario`: presets and scenario files, listed, printed and checked."""

from __future__ import annotations

from typing import Annotated

import typer

from plategait.cli import options, report
from plategait.cli.command import refuse
from plategait.errors import printable
from plategait.model.presets import PRESETS, as_scenario, preset
from plategait.model.scenario_file import write_scenario


def scenario_command(
    context: typer.Context,
    name: Annotated[str | None, typer.Argument(metavar="[FILE]", help="A scenario file to check.")] = None,
    preset_name: Annotated[
        str | None, typer.Option("--print", help="Print this preset as a commented TOML file.")
    ] = None,
    as_json: options.Json = False,
) -> None:
    """List the presets, print one as a commented TOML file, or check a scenario file."""
    if preset_name is not None:
        refuse(context, ["name", "as_json"], "with --print", f"plategait scenario --print {preset_name}")
        chosen = preset(preset_name)
        print(f"# {chosen.summary}\n\n" + write_scenario(chosen.scenario, chosen.notes), end="")
    elif name is not None:
        checked = as_scenario(name)
        facts = {
            "scenario": checked.name,
            "nodes": checked.sheet.lattice.n_nodes,
            "dt_s": checked.dt,
            "duration_s": checked.duration,
        }
        sizes = f"{facts['nodes']} nodes, step {checked.dt:.3g} s"
        report.print_json(facts) if as_json else print(f"{printable(name)}: {printable(checked.name)}, {sizes}")
    elif as_json:
        report.print_json(
            {
                n: {"summary": preset(n).summary, "published": preset(n).published, "inferred": preset(n).inferred}
                for n in PRESETS
            }
        )
    else:
        for each in PRESETS:
            print(f"{each:18}{preset(each).summary}")
