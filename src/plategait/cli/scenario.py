"""`plategait scenario`: presets and scenario files, listed, printed and checked."""

from __future__ import annotations

from dataclasses import fields
from typing import Annotated

import typer

from plategait.cli import options, report
from plategait.cli.command import refuse
from plategait.cli.groups import grouped
from plategait.cli.material_options import MaterialOptions
from plategait.errors import printable
from plategait.model.parameters import parameters_of, value_of
from plategait.model.presets import PRESETS, as_scenario, preset
from plategait.model.scenario import Scenario
from plategait.model.scenario_file import write_scenario


@grouped
def scenario_command(
    context: typer.Context,
    name: Annotated[str | None, typer.Argument(metavar="[FILE]", help="A scenario file to check.")] = None,
    preset_name: Annotated[
        str | None, typer.Option("--print", help="Print this preset as a commented TOML file.")
    ] = None,
    *,
    made: MaterialOptions,
    plate_size: options.PlateSize = None,
    slip_limit: options.SlipLimit = None,
    as_json: options.Json = False,
) -> None:
    """List the presets, print one as a commented TOML file, or check a scenario file."""
    if preset_name is not None:
        refuse(context, ["name", "as_json"], "with --print", f"plategait scenario --print {preset_name}")
        _print_preset(preset_name, made, plate_size, slip_limit)
        return
    names = [field.name for field in fields(MaterialOptions)]
    refuse(context, [*names, "plate_size", "slip_limit"], "where no preset is printed", "--print cheese beside it")
    if name is not None:
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


def _print_preset(name: str, made: MaterialOptions, plate_size: str | None, slip_limit: str | None) -> None:
    """A preset as a file, or the same motion and contact with another sheet or plate."""
    chosen = preset(name)
    scenario = options.build(name, made=made, plate_size=plate_size, slip_limit=slip_limit)
    told = {
        dotted: remark for dotted, remark in chosen.notes.items() if not _changed(dotted, scenario, chosen.scenario)
    }
    heading = f"the motion, contact and friction of {name}: " if made.makes_a_sheet else ""
    print(f"# {heading}{chosen.summary}\n\n" + write_scenario(scenario, notes=told | made.remarks(scenario)), end="")


def _changed(dotted: str, scenario: Scenario, printed: Scenario) -> bool:
    """Whether a number is no longer the preset's, whose remark would then be false."""
    known = parameters_of(scenario)
    return dotted not in known or value_of(scenario, dotted) != value_of(printed, dotted)
