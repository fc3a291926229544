"""What a store was made by and of: only the very same goes on in it."""

from __future__ import annotations

import hashlib
import platform
from collections.abc import Mapping, Sequence
from typing import Any

from plategait.campaign.plan import Sweep
from plategait.campaign.points import Point
from plategait.campaign.seal import hash_of
from plategait.engine import cpu
from plategait.errors import InputError
from plategait.simulation.registry import all_observables
from plategait.version import __version__

FORMAT = 3
# What decides the bits of a store: who made it, and of what.
_PARTS = ("plategait_version", "store_format", "instruction_set", "machine", "engine", "observables", "sweep_hash",
          "points_hash")  # fmt: skip


def maker() -> dict[str, Any]:
    """What decides the bits of a run on this machine, beside the run itself."""
    return {
        "plategait_version": __version__,
        "store_format": FORMAT,
        "instruction_set": cpu.instruction_sets()[0],
        "machine": platform.machine(),
    }


def identity(sweep: Sweep, points: Sequence[Point]) -> dict[str, Any]:
    """Attributes that a store must have to be this sweep's."""
    text = sweep.to_json()
    # The nodes too: an outline may come from a picture that has changed.
    content = [points, hashlib.sha256(sweep.scenario.sheet.lattice.key).hexdigest()]
    parts = maker() | {"engine": sweep.engine, "sweep": text, "points_hash": hash_of(content)}
    parts["observables"] = list(all_observables())
    parts["sweep_hash"] = hash_of(text)
    return parts | {"fingerprint": fingerprint_of(parts)}


def fingerprint_of(attributes: Mapping[str, Any]) -> str:
    """Fingerprint that a store of such attributes must have, from its plan itself and not from what is said of it."""
    return hash_of({name: attributes[name] for name in _PARTS} | {"sweep_hash": hash_of(attributes["sweep"])})


def check_identity(path: object, attributes: Mapping[str, Any], wanted: Mapping[str, Any]) -> None:
    """Refuse a store of anything else.

    Raises
    ------
    InputError
        That says in what the two differ.
    """
    if attributes.get("fingerprint") == wanted["fingerprint"]:
        return
    names = {"sweep_hash": "sweep or scenario", "points_hash": "picture, or way to lay out sheets and samples"}
    differ = [name for name in _PARTS if attributes.get(name) != wanted[name]]
    said = "; ".join(
        f"another {names[name]}" if name in names else f"{name} {attributes.get(name)}, not {wanted[name]}"
        for name in differ or ["fingerprint"]
    )
    raise InputError("store", f"{path} with {said}", "a store of this very sweep, by the same plategait and machine",
                     "another --store")  # fmt: skip
