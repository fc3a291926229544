"""One object of a collection: its estimate as plain numbers, or why there is none."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Literal

from plategait.collection.objects import Item
from plategait.errors import InputError, printable
from plategait.estimate.direct import Direct, estimate_directly
from plategait.estimate.linear import Coefficients
from plategait.estimate.result import EstimateOptions, estimate_parameters
from plategait.estimate.size import sized_by_film
from plategait.model.fragment import fragment_text
from plategait.model.scenario import Scenario
from plategait.model.scenario_file import write_scenario

Way = Literal["posterior"] | Direct


@dataclass(frozen=True)
class Asked:
    """How every object of a collection is estimated.

    Attributes
    ----------
    scenario : Scenario
        The object as far as it is known, and the plate.
    angles : tuple of float
        Angular amplitude of all curves of an object, or of each in turn, rad; the scenario's where there is none.
    method : {"posterior", "linear", "quadratic", "any-size"}
    coefficients : {"published", "refitted"}, optional
        Of the method "linear".
    radius_told : bool
        Whether the scenario's radius was told, so that no film's stands in for it.
    options : EstimateOptions
        Of the posterior.
    """

    scenario: Scenario
    angles: tuple[float, ...] = ()
    method: Way = "posterior"
    coefficients: Coefficients | None = None
    radius_told: bool = False
    options: EstimateOptions = field(default_factory=lambda: EstimateOptions())

    @property
    def identity(self) -> dict[str, Any]:
        """What decides the estimates, as JSON can hold it."""
        options = sorted((name, repr(value)) for name, value in self.options.items())
        rest = [self.angles, self.method, self.coefficients, self.radius_told]
        return {"scenario": write_scenario(self.scenario), "options": options, "rest": rest}


def estimated(
    item: Item, asked: Asked, threads: int | None = None, progress: Callable[[float], object] | None = None
) -> dict[str, Any]:
    """Estimate of an object as JSON can hold it: its summary, and its fragment as text where there is one.

    Instead of both there is a `failure` where it cannot be estimated: bad input, or a `fault` of the program, which is
    not to be kept.
    """
    try:
        return _estimated(item, asked, threads, progress)
    except InputError as error:
        return {"failure": str(error)}
    except Exception as error:  # no object's fault may cost the others
        return {"failure": printable(f"fault of the program: {type(error).__name__}: {error}"), "fault": True}


def _estimated(
    item: Item, asked: Asked, threads: int | None, progress: Callable[[float], object] | None
) -> dict[str, Any]:
    base, curves = sized_by_film(asked.scenario, item.curves, told=asked.radius_told)
    angles = asked.angles * len(curves) if len(asked.angles) == 1 else asked.angles
    if angles and len(angles) != len(curves):
        raise InputError("--angle", f"{len(angles)} of them", f"given once, or once for each of {len(curves)} curves",
                         '"3 deg"')  # fmt: skip
    motions = [base.motion.replace(angle=angle) for angle in angles] or [base.motion] * len(curves)
    if asked.method != "posterior":
        base = base.replace(motion=motions[0])
        linear, curve = estimate_directly(curves, base, asked.method, asked.coefficients)
        fragment = "" if linear.refused else fragment_text(linear.to_fragment(base))
        summary = linear.summary() | {"notes": list(curve.notes), "answered": not linear.refused}
        return {"summary": summary, "fragment": fragment}
    estimate = estimate_parameters(curves, base, motions=motions, threads=threads, progress=progress, **asked.options)
    determined = any(marginal.determined for marginal in estimate.marginals)
    fragment = fragment_text(estimate.to_fragment()) if determined else ""
    return {"summary": estimate.summary() | {"answered": estimate.answered}, "fragment": fragment}
