"""Estimates straight from one curve, without the engine: by the source's lines, or regressed for any size."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from plategait.curve.curve import Curve
from plategait.estimate.any_size import estimate_any_size
from plategait.estimate.linear import (
    Coefficients,
    LinearEstimate,
    alone,
    at_amplitude_of,
    estimate_linear,
    fitted_alone,
    lorentz_of,
)
from plategait.model.scenario import Scenario

Direct = Literal["linear", "quadratic", "any-size"]


def estimate_directly(
    curves: Sequence[Curve], base: Scenario, method: Direct, coefficients: Coefficients | None = None
) -> tuple[LinearEstimate, Curve]:
    """Estimate by a method other than the posterior.

    Parameters
    ----------
    curves : sequence of Curve
        One.
    base : Scenario
        The object's size and the plate, as far as the curve does not tell them itself.
    method : {"linear", "quadratic", "any-size"}
    coefficients : {"published", "refitted"}, optional
        Of the linear method.

    Returns
    -------
    The estimate, and the curve that it was read from.

    Raises
    ------
    InputError
        For several curves, a curve without a peak, or one that the method is not made for.
    """
    if method == "any-size":
        curve = alone(curves, method)
        return estimate_any_size(curve, at_amplitude_of(curve, base, method)), curve
    curve = fitted_alone(curves, method)
    base = at_amplitude_of(curve, base, method)
    return estimate_linear(lorentz_of(curve, method), base, method=method, coefficients=coefficients), curve
