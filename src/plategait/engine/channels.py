"""Every channel of a recording: its name, unit, meaning, and how samples of it add up."""

from __future__ import annotations

import difflib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

from plategait.errors import InputError

Kind = Literal["state", "amount", "share"]


@dataclass(frozen=True)
class Channel:
    """One time series of a recording.

    Attributes
    ----------
    name : str
    unit : str
        SI.
    long_name : str
        What it is, in words.
    kind : {"state", "amount", "share"}
        What a sample holds: the state at its time, an amount since the sample before, or a share of the time since
        then. States are interpolated, amounts add up, shares average.
    """

    name: str
    unit: str
    long_name: str
    kind: Kind = "state"


_RECORDED = (
    Channel("time", "s", "time"),
    Channel("centre_x", "m", "centre of mass along the bar, plate frame"),
    Channel("centre_y", "m", "centre of mass across the bar, plate frame"),
    Channel("centre_z", "m", "centre of mass above the plate"),
    Channel("spin_cross", "m^2", "sum of X0 × p over the nodes"),
    Channel("spin_dot", "m^2", "sum of X0 · p over the nodes"),
    Channel("area_x", "1", "area vector over the area at rest, along the bar"),
    Channel("area_y", "1", "area vector over the area at rest, across the bar"),
    Channel("area_z", "1", "area vector over the area at rest, along the plate's normal"),
    Channel("left_contact", "1", "share of the time since the last sample in which the left leg touches", "share"),
    Channel("right_contact", "1", "share of the time since the last sample in which the right leg touches", "share"),
    Channel("flight", "1", "share of the time since the last sample in which nothing touches", "share"),
    Channel("contact", "1", "mean share of the nodes that touch", "share"),
    Channel("bend_rms", "rad", "root-mean-square angle of the bending joints"),
    Channel("height_low", "m", "lowest node above the plate"),
    Channel("height_high", "m", "highest node above the plate"),
    Channel("kinetic_energy", "J", "kinetic energy"),
    Channel("gravity_energy", "J", "potential energy"),
    Channel("axial_energy", "J", "energy of the axial joints"),
    Channel("bending_energy", "J", "energy of the bending joints"),
    Channel("torsion_energy", "J", "energy of the torsion joints"),
    Channel("contact_energy", "J", "energy stored in the contact"),
    Channel("joint_loss", "J", "energy lost in the joints since the last sample", "amount"),
    Channel("contact_work", "J", "energy put into the contact since the last sample", "amount"),
    Channel("friction_loss", "J", "energy lost to friction since the last sample", "amount"),
    Channel("plate_work", "J", "work of the plate since the last sample", "amount"),
    Channel("plate_x", "m", "plate position along the bar"),
    Channel("plate_y", "m", "plate position across the bar"),
    Channel("plate_z", "m", "plate height"),
    Channel("plate_rx", "rad", "plate rotation about the bar"),
    Channel("plate_ry", "rad", "plate rotation about y"),
    Channel("plate_rz", "rad", "plate rotation about z"),
)

CHANNELS: Mapping[str, Channel] = {channel.name: channel for channel in _RECORDED}
"""What an engine records, in the native core's order (`native/parameters.hpp`)."""

ROTATION = Channel("rotation", "rad", "rotation about the plate's normal")
"""Not recorded but worked out from `spin_cross` and `spin_dot`."""

SERIES: Mapping[str, Channel] = {c.name: c for c in (ROTATION, *CHANNELS.values()) if c.name != "time"}
"""What can be asked for as a series over time."""


def check_series(names: Sequence[str], field: str) -> None:
    """Refuse names that are none of `SERIES`.

    Raises
    ------
    InputError
        Under the name `field`, with the nearest that is one.
    """
    for name in names:
        if name not in SERIES:
            close = difflib.get_close_matches(name, SERIES, n=1) or [ROTATION.name]
            raise InputError(field, name, f"of {', '.join(SERIES)}", f'"{close[0]}"')
