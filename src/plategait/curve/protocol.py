"""How a spin curve is measured: how long each point runs, what of it is left out, how far the object may slip."""

from __future__ import annotations

from dataclasses import dataclass

from plategait.model.scenario import Scenario


@dataclass(frozen=True)
class Protocol:
    """How each point of a spin curve is measured.

    The source does not say how long it measured. Its own limit of slip is 10 mm (section 4.3), at which objects that
    wander as they spin would count as failed; twice that tells running off from wandering, and its own curves want 15
    mm (docs/studies.md).

    Attributes
    ----------
    duration : float
        Of a run or a clip, s.
    transient : float
        Time at its beginning that is not measured, s; at most half the duration.
    slip_limit : float
        Failed once the centre has slipped this far, m.
    """

    duration: float = 2.0
    transient: float = 0.6
    slip_limit: float = 0.02


USUAL = Protocol()
"""Where a measurement's own duration and limit are not told."""

REGENERATED = Protocol(duration=1.6, slip_limit=0.015)
"""Of the dissertation's curves as they are regenerated here."""


def measured_as(scenario: Scenario, protocol: Protocol = USUAL) -> Scenario:
    """Scenario run for as long, and failing at the same slip, as the measurement."""
    return scenario.replace(
        duration=protocol.duration,
        transient=min(protocol.transient, 0.5 * protocol.duration),
        slip_limit=protocol.slip_limit,
    )
