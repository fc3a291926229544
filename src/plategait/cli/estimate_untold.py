"""What an estimate takes of the object's size and mass for want of anybody's word, and the warning of it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import typer

from plategait.cli.command import given
from plategait.estimate.size import seen_size
from plategait.model.fragment import read_fragment
from plategait.model.outline import Disk
from plategait.model.scenario import Scenario

if TYPE_CHECKING:
    from plategait.cli.estimate_options import Method, SetupOptions
    from plategait.curve.curve import Curve


def warnings_of(
    context: typer.Context, setup: SetupOptions, objects: Sequence[Sequence[Curve]], *, mass_counts: bool
) -> list[str]:
    """Warning of a mass and a radius that are the preset's, as neither an option nor a file tells them.

    Parameters
    ----------
    objects : sequence of sequence of Curve
        Curves of each object; those of a film tell its radius.
    mass_counts : bool
        Whether anything that is asked for goes with the mass.
    """
    if given(context, "scenario"):
        return []
    measured = {name for path in setup.measured or [] for name in read_fragment(path).parameters}
    base, missing = setup.build().sheet, []
    weighed = setup.mass is not None or setup.density is not None or setup.material is not None
    if mass_counts and not weighed and "sheet.mass" not in measured and "mass" not in (context.params["free"] or ()):
        missing.append(("mass", f"{1e3 * base.mass:.4g} g", "--mass"))
    sized = setup.size_told or "sheet.outline.radius" in measured or all(map(seen_size, objects))
    if not sized and isinstance(base.outline, Disk):
        missing.append(("radius", f"{1e3 * base.outline.radius:.4g} mm", "--radius"))
    if not missing:
        return []
    names, values, options = zip(*missing, strict=True)
    told, taken, them = ("was", "is", "it") if len(missing) == 1 else ("were", "are", "them")
    subject = f"the {names[0]}" if len(missing) == 1 else " and ".join(names)
    whose = "that of the preset cut anew," if setup.outline is not None else "the preset's"
    return [f"warning: {subject} {told} not told: {whose} {' and '.join(values)} {taken} taken; "
            f"stiffness and E go with {them}: {', '.join(options)}"]  # fmt: skip


def treated_as(setup: SetupOptions, base: Scenario, method: Method) -> list[str]:
    """Shape that an object of a told radius is taken for, where the method takes others too."""
    if setup.radius is None or method not in ("posterior", "any-size") or not isinstance(base.sheet.outline, Disk):
        return []
    return [f"treated as a disk of {1e3 * base.sheet.outline.radius:.4g} mm; --outline for another shape"]
