"""What a store was made by and of: only the very same goes on in it."""

from __future__ import annotations

import hashlib
import json
import platform
from collections.abc import Mapping, Sequence
from typing import Any

from plategait.campaign.plan import Sweep
from plategait.campaign.points import Point
from plategait.engine import cpu
from plategait.errors import InputError
from plategait.version import __version__

FORMAT = 1


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
    # The nodes too: an outline may come from a picture that has changed.
    content = [sweep.to_json(), points, hashlib.sha256(sweep.scenario.sheet.lattice.key).hexdigest()]
    parts = maker() | {"engine": sweep.engine, "sweep_hash": _hash(content)}
    return parts | {"fingerprint": _hash(parts)}


def check_identity(path: object, found: Mapping[str, Any], wanted: Mapping[str, Any]) -> None:
    """Refuse a store of anything else.

    Raises
    ------
    InputError
        That says in what the two differ.
    """
    if found.get("fingerprint") == wanted["fingerprint"]:
        return
    names = {"sweep_hash": "sweep or scenario"}
    differ = [name for name in wanted if name != "fingerprint" and found.get(name) != wanted[name]]
    said = "; ".join(
        f"another {names[name]}" if name in names else f"{name} {found.get(name)}, not {wanted[name]}"
        for name in differ or ["fingerprint"]
    )
    raise InputError("store", f"{path} with {said}", "a store of this very sweep, by the same plategait and machine",
                     "another --store")  # fmt: skip


def _hash(content: object) -> str:
    return hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()
