"""The size of the object as a film saw it, taken for the estimate where nobody told it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from plategait.curve.curve import Curve
from plategait.model.outline import Disk
from plategait.model.scenario import Scenario

# Half of 95 % of a normal distribution, in standard deviations.
HALF_95 = 1.96
# Radii of the clips that differ by more than this share are not those of one object.
ALIKE = 0.03


@dataclass(frozen=True)
class SeenSize:
    """Radius of a circle with the object's area, m: as seen, its standard deviation, least and most of the points."""

    radius: float
    sd: float
    least: float
    most: float


def seen_size(curves: Sequence[Curve]) -> SeenSize | None:
    """Size in the curves' columns radius and radius_sd; None where they have none.

    What is wrong with a radius from film, as the thickness that makes it larger, is alike in all clips: more of them
    make it no surer than the surest one.
    """
    radii, sds = [np.zeros(0)], [np.zeros(0)]
    for curve in curves:
        radius = curve.of_object.get("radius")
        if radius is None:
            continue
        sd = curve.of_object.get("radius_sd", np.full(len(radius), math.nan))
        known = np.isfinite(radius)
        radii.append(radius[known])
        sds.append(np.where(np.isfinite(sd[known]), sd[known], 0.01 * radius[known]))
    radius, sd = np.concatenate(radii), np.concatenate(sds)
    if not len(radius):
        return None
    mean = float(np.average(radius, weights=sd**-2.0))
    return SeenSize(mean, float(max(sd.min(), radius.std())), float(radius.min()), float(radius.max()))


def resized(base: Scenario, radius: float) -> Scenario:
    """Scenario of a disk of another radius, m; the lattice grows with it."""
    outline = base.sheet.outline
    assert isinstance(outline, Disk)
    pitch = base.sheet.pitch * radius / outline.radius
    return base.replace(**{"sheet.outline": Disk(radius=radius), "sheet.pitch": pitch})


def _area(base: Scenario) -> float:
    """Of the scenario's outline, m², to 1 %."""
    length, width = base.sheet.outline.size()
    x, y = ((np.arange(400) + 0.5) / 400 * side - side / 2 for side in (length, width))
    inside = base.sheet.outline.contains(*np.meshgrid(x, y))
    return float(inside.mean()) * length * width


def sized_by_film(base: Scenario, curves: Sequence[Curve], *, told: bool) -> tuple[Scenario, list[Curve]]:
    """Scenario with the size that a film tells, and the curves with a note of what was done.

    Parameters
    ----------
    base : Scenario
    curves : sequence of Curve
    told : bool
        Whether the radius was told for this estimate: then it stands, and a film that contradicts it is noted.
    """
    seen = seen_size(curves)
    if seen is None:
        return base, list(curves)
    said = f"the film shows a radius of {1e3 * seen.radius:.2f} ± {1e3 * HALF_95 * seen.sd:.2g} mm"
    notes = []
    if seen.most - seen.least > ALIKE * seen.radius:
        span = f"{1e3 * seen.least:.1f} to {1e3 * seen.most:.1f} mm"
        notes.append(f"warning: the clips show radii from {span}: is it one object?")
    outline = base.sheet.outline
    own = outline.radius if isinstance(outline, Disk) else math.sqrt(_area(base) / math.pi)
    agrees = abs(own - seen.radius) <= HALF_95 * seen.sd
    if agrees:
        notes.append(f"{said}, which agrees with the {1e3 * own:.4g} mm of {'--radius' if told else base.name}")
    elif told or not isinstance(outline, Disk):
        whose = "of --radius" if told else f"of a circle with the area of {base.name}"
        notes.append(f"warning: {said}, not the {1e3 * own:.4g} mm {whose}, which are taken nevertheless")
    else:
        base = resized(base, seen.radius)
        notes.append(f"{said}, which is taken, not the {1e3 * own:.4g} mm of {base.name}: --radius tells another")
    first, *others = curves
    return base, [replace(first, notes=(*first.notes, *notes)), *others]
