"""`plategait modes`: how a sheet vibrates freely."""

from __future__ import annotations

from typing import Annotated

import typer

from plategait.cli import options, report
from plategait.cli.groups import grouped
from plategait.cli.material_options import MaterialOptions
from plategait.files.output import PICTURES, check_outputs
from plategait.model.sheet import Sheet

_MODE_KEYS = {"omega": "omega_rad_s", "frequency": "frequency_hz", "damping_ratio": "damping_ratio", "name": "name"}


@grouped
def modes(
    scenario: options.ScenarioName = "cheese",
    *,
    made: MaterialOptions,
    sheet: options.Sheet = None,
    natural_frequency: options.NaturalFrequency = None,
    count: Annotated[int, typer.Option("--count", help="How many to print and draw.", min=1)] = 8,
    plot: options.Plot = None,
    as_json: options.Json = False,
) -> None:
    """Free-vibration modes of a sheet; the dish mode is the dissertation's natural frequency."""
    check_outputs((plot, PICTURES, "--plot"))
    whole = options.build(scenario, made=made, sheet=sheet, natural_frequency=natural_frequency)
    built = whole.sheet
    name = whole.name if built.name == Sheet.model_fields["name"].default else built.name
    free_modes = built.free_modes
    if plot:
        from plategait.plots.figures import plot_modes
        from plategait.plots.style import save

        save(plot_modes(built, count), plot)
    if not as_json:
        return report.print_modes(name, free_modes, count)
    keys = ("omega", "frequency", "damping_ratio", "name")
    report.print_json(
        {"sheet": name, "modes": [{_MODE_KEYS[k]: getattr(m, k) for k in keys} for m in free_modes.modes[:count]]}
    )
