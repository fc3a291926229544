"""What the identify commands share: options, checks before the work, and what is written and printed after it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Protocol

import typer

from plategait.cli import report
from plategait.files.output import PICTURES, check_outputs
from plategait.units import Quantity

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from plategait.model.fragment import Fragment

LENGTH = Quantity("m", "mm", "10 mm", above=0, at_most=1)
TIME = Quantity("s", "s", "0.05 s")

Out = Annotated[Path | None, typer.Option("--out", help="Write the result to lay over a scenario: .toml.")]


class Result(Protocol):
    """What every identification gives."""

    def to_fragment(self) -> Fragment:
        """Scenario fragment of what was determined."""
        ...

    def summary(self) -> dict[str, Any]:
        """Plain numbers for `--json`."""
        ...


def check_files(out: Path | None, plot: Path | None) -> None:
    """Refuse a fragment or a picture that cannot be written before any work is done."""
    check_outputs((out, (".toml",), "--out"), (plot, PICTURES, "--plot"))


def between(start: str | None, end: str | None) -> tuple[float, float]:
    """Times of --from and --to, s; infinite where left out."""
    low = TIME.read(start, "--from") if start is not None else -float("inf")
    return low, TIME.read(end, "--to") if end is not None else float("inf")


def deliver(
    result: Result,
    determined: bool,
    *,
    out: Path | None,
    plot: Path | None,
    as_json: bool,
    draw: Callable[[], Figure],
    show: Callable[[], object],
    answered: bool | None = None,
) -> None:
    """Write the fragment, if there is one, and the picture; print; leave with 0, or 1 where there is no answer."""
    if out and determined:
        from plategait.model.fragment import write_fragment

        write_fragment(result.to_fragment(), out)
    if plot:
        from plategait.plots.style import save

        save(draw(), plot)
    report.print_json(result.summary()) if as_json else show()
    raise typer.Exit(0 if (determined if answered is None else answered) else 1)
