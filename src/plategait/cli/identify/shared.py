"""What the identify commands share: options, checks before the work, and what is written and printed after it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Protocol, TypeVar

import typer

from plategait.cli import options, report
from plategait.files.output import PICTURES, check_outputs
from plategait.units import Quantity

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from plategait.identify.series import Window
    from plategait.model.fragment import Fragment

LENGTH = Quantity("m", "mm", "10 mm", above=0, at_most=1)
TIME = Quantity("s", "s", "0.05 s")


class Result(Protocol):
    """What every identification gives."""

    def to_fragment(self) -> Fragment:
        """Scenario fragment of what was determined."""
        ...

    def summary(self) -> dict[str, Any]:
        """Plain numbers for `--json`."""
        ...


R = TypeVar("R", bound=Result)


def between(start: str | None, end: str | None) -> Window:
    """Times of --from and --to, s; open where left out."""
    from plategait.identify.series import Window

    low = -float("inf") if start is None else TIME.read(start, "--from")
    return Window(low, float("inf") if end is None else TIME.read(end, "--to"))


@dataclass(frozen=True)
class OutputOptions:
    """What is written and printed."""

    out: Annotated[Path | None, typer.Option("--out", help="Write the result to lay over a scenario: .toml.")] = None
    plot: options.Plot = None
    as_json: options.Json = False

    def check(self) -> None:
        """Refuse a fragment or a picture that cannot be written before any work is done."""
        check_outputs((self.out, (".toml",), "--out"), (self.plot, PICTURES, "--plot"))

    def deliver(
        self,
        result: R,
        *,
        determined: bool,
        answered: bool,
        draw: Callable[[R], Figure],
        show: Callable[[R], object],
    ) -> None:
        """Write the fragment, if anything is determined, and the picture; print; leave with 0, or 1 if not answered."""
        if self.out and determined:
            from plategait.model.fragment import write_fragment

            write_fragment(result.to_fragment(), self.out)
        if self.plot:
            from plategait.plots.style import save

            save(draw(result), self.plot)
        report.print_json(result.summary()) if self.as_json else show(result)
        raise typer.Exit(0 if answered else 1)
