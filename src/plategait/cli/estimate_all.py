"""The command that estimates many objects alike, each from the spin curves of its own."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from plategait.cli import options, report
from plategait.cli.command import refuse
from plategait.cli.estimate import idle_without_file, refuse_redundant
from plategait.cli.estimate_options import (
    Coefficients,
    CoefficientsName,
    MeasurementOptions,
    Method,
    MethodName,
    SetupOptions,
)
from plategait.cli.estimate_untold import treated_as, warnings_of
from plategait.cli.groups import grouped
from plategait.curve.protocol import measured_as
from plategait.errors import InputError
from plategait.files.output import check_outputs, write_whole

if TYPE_CHECKING:
    from plategait.collection.collection import Outcome
    from plategait.collection.one import Asked

# Options that say something of a posterior alone.
_OF_POSTERIOR = (
    "beta", "free", "fixed", "noise", "duration", "slip_limit", "ramp", "model_error", "any_law", "confidence", "seed",
    "friction_scatter",
    "height", "thickness",
)  # fmt: skip


@grouped
def estimate_all(
    context: typer.Context,
    objects: Annotated[
        list[Path],
        typer.Argument(metavar="OBJECT...", help="An object each: CURVE.csv, or a folder of several curves of it."),
    ],
    *,
    setup: SetupOptions,
    method: MethodName = "posterior",
    coefficients: CoefficientsName = None,
    measurement: MeasurementOptions,
    seed: options.Seed = 0,
    store: Annotated[
        Path | None, typer.Option("--store", help="Folder that keeps each estimate: killed, it goes on from there.")
    ] = None,
    dask: options.Dask = None,
    out: Annotated[Path | None, typer.Option("--out", help="Write a table, a row for each object: .csv.")] = None,
    fragments: Annotated[
        Path | None, typer.Option("--fragments", help="Folder for a scenario fragment of each object, for --with.")
    ] = None,
    as_json: options.Json = False,
) -> None:
    """Read stiffness and friction of many objects off their spin curves, all alike.

    Exit status 1 where an object cannot be estimated, or its curves are not explained or determine nothing.
    """
    check_outputs((out, (".csv",), "--out"))
    if method == "posterior":
        refuse(context, ["coefficients"], "with --method posterior", "--method linear")
    else:
        idle = [name for name in _OF_POSTERIOR if (method, name) != ("any-size", "beta")]
        refuse(context, [*idle, *(["coefficients"] if method == "any-size" else [])], f"with --method {method}",
               "--method posterior")  # fmt: skip
        if fragments is None:
            # Only the stiffness that is written is that of an object of a certain mass.
            refuse(context, idle_without_file(method), f"with --method {method} and no --fragments",
                   "--fragments objects")  # fmt: skip
    asked = _asked(setup, method, coefficients, measurement, seed)
    from plategait.collection.collection import estimate_all as run
    from plategait.collection.objects import read_items

    read = [item.curves for item in read_items(objects) if item.curves]
    if read:
        refuse_redundant(context, [curve for curves in read for curve in curves])
    mass_counts = method == "posterior" or fragments is not None
    warnings, notes = (
        warnings_of(context, setup, read, mass_counts=mass_counts),
        treated_as(setup, asked.scenario, method),
    )
    with report.going_on_in(store), report.progress_bar("estimating") as progress:
        outcomes = run(objects, asked, store=store, dask=dask, progress=progress)
    _write(outcomes, out, fragments)
    counted = {"objects": len(outcomes), "answered": sum(o.answered for o in outcomes),
               "failed": sum(bool(o.failure) for o in outcomes)}  # fmt: skip
    if as_json:
        told = {"warnings": warnings, "notes": notes}
        report.print_json(counted | told | {"estimates": [outcome.plain for outcome in outcomes]})
    else:
        report.print_notes([*warnings, *notes])
        _print(outcomes)
    raise typer.Exit(0 if counted["answered"] == len(outcomes) else 1)


def _asked(
    setup: SetupOptions, method: Method, coefficients: Coefficients | None, measurement: MeasurementOptions, seed: int
) -> Asked:
    from plategait.collection.one import Asked

    base, angles = setup.build(), tuple(setup.amplitudes)
    if method != "posterior":
        beta = measurement.friction_ratio
        base = base.replace(friction=base.friction.with_ratio(beta)) if beta is not None else base
        return Asked(base, angles, method, coefficients, setup.size_told)
    scenario = measured_as(base, measurement.protocol)
    told = measurement.options(setup, seed)
    return Asked(scenario, angles, radius_told=setup.size_told, options=told)


def _write(outcomes: tuple[Outcome, ...], out: Path | None, fragments: Path | None) -> None:
    from plategait.collection.table import as_csv

    if out:
        write_whole(as_csv(outcomes).encode(), out, (".csv",), "--out")
    if fragments:
        try:
            fragments.mkdir(exist_ok=True)
        except OSError as error:
            raise InputError("--fragments", f"{fragments} ({error.strerror})", "a folder that can be written",
                             "--fragments objects") from None  # fmt: skip
        for outcome in (o for o in outcomes if o.fragment):
            name = "_".join(Path(outcome.item.name).parts[-2:]).replace("/", "_")
            write_whole(outcome.fragment.encode(), fragments / f"{Path(name).stem}.toml", (".toml",), "--fragments")


def _print(outcomes: tuple[Outcome, ...]) -> None:
    from plategait.estimate.result import LABELS

    names = dict.fromkeys(name for o in outcomes for name in (o.summary or {}).get("parameters", {}))
    rows = []
    for outcome in outcomes:
        summary = outcome.summary or {}
        told = summary.get("parameters", {})
        said = [outcome.failure, *summary.get("complaints", []), *summary.get("refused", [])]
        rows.append([outcome.item.name, *(_number(told.get(name)) for name in names), "; ".join(filter(None, said))])
    columns = ["object", *(LABELS[name] for name in names), "not explained, or failed"]
    report.print_table(f"{len(outcomes)} objects, ± one sd", columns, rows)


def _number(told: dict[str, object] | None) -> str:
    if told is None:
        return "–"
    unit = f" {told['unit']}" if told["unit"] else ""
    if told["median"] is not None:
        return f"{told['median']:.3g} ± {told['sd']:.2g}{unit}"
    verdict = str(told.get("verdict", ""))
    side = {"at most": "high", "at least": "low"}.get(verdict)
    return f"{verdict} {told[side]:.3g}{unit}" if side else "–"
