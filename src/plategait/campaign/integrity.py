"""Whether a store is what it says: its arrays those of its plan and inside its folder, its identity its content's."""

from __future__ import annotations

import json
import math
import os
import stat
from pathlib import Path
from typing import Any

from plategait.campaign.batch import STATUS, array_names
from plategait.campaign.identity import fingerprint_of
from plategait.campaign.layout import CHECKSUM, CODECS, FILL, LARGEST_ROOT, ROOT
from plategait.campaign.plan import Sweep, sweep_of_json
from plategait.campaign.points import described
from plategait.errors import InputError
from plategait.files.input import UnreadableError, plain_bytes


def plan_of(path: Path, root: dict[str, Any]) -> Sweep:
    """Plan of a store, after its metadata were checked against it.

    Raises
    ------
    InputError
        When an attribute, an array or the fingerprint is not what follows from the plan, or an array is not a folder
        inside the store.
    """
    try:
        plan = sweep_of_json(root["attributes"]["sweep"])
        metadata = root["consolidated_metadata"]["metadata"]
        wrong = _wrong_attribute(root["attributes"], plan) or _wrong_array(metadata, plan, root["attributes"])
        wrong = wrong or next((f"{n}, which is no folder in it" for n in metadata if _is_elsewhere(path / n)), "")
        if not wrong:
            return plan
    except InputError as error:  # of the plan, whose picture may be gone
        raise InputError(f"{path.name}, {error.field}", error.got, error.allowed, error.hint) from None
    except (LookupError, TypeError, ValueError, AttributeError, RecursionError):
        wrong = "metadata of another form"
    raise InputError("store", f"{path} with {wrong}", "as plategait wrote it", "another --store")


def strange_arrays(path: Path, root: dict[str, Any]) -> list[str]:
    """Arrays whose own metadata are not those of the root: damaged or edited.

    They may be longer: a campaign that grows lengthens them before the root, which alone counts, says so.
    """
    return [name for name, wanted in root["consolidated_metadata"]["metadata"].items()
            if not _alike(path / name / ROOT, wanted)]  # fmt: skip


def _wrong_attribute(attributes: dict[str, Any], plan: Sweep) -> str:
    whole = {name: attributes[name] for name in ("batch", "refine")}
    if any(type(n) is not int or n < least for n, least in zip(whole.values(), (1, 0), strict=True)):
        return f"batch or refine of {whole}"
    different = [name for name, value in described(plan).items() if attributes[name] != value]
    if different:
        return f"{different[0]} that is not its plan's"
    if fingerprint_of(attributes) != attributes["fingerprint"] or attributes["engine"] != plan.engine:
        return "a fingerprint that is not that of its content"
    return ""


def _wrong_array(metadata: dict[str, Any], plan: Sweep, attributes: dict[str, Any]) -> str:
    expected = {*array_names(plan, attributes["observables"]), CHECKSUM, *(["time"] if plan.record.channels else [])}
    if different := expected ^ set(metadata):
        return f"{min(different)} missing or not expected among its arrays"
    n_points = metadata[STATUS.name]["shape"][0]
    lengths = {"point": n_points, "batch": math.ceil(n_points / attributes["batch"])}
    if not all(type(n) is int and n > 0 for array in metadata.values() for n in array["shape"]):
        return "an array of no size"
    for name, array in metadata.items():
        sound = array["shape"][0] == lengths.get(array["dimension_names"][0], array["shape"][0])
        sound &= array["data_type"] in FILL and {codec["name"] for codec in array["codecs"]} <= CODECS
        if not sound:
            return f"the array {name} in another form"
    return ""


def _is_elsewhere(path: Path) -> bool:
    """Whether something other than a folder stands at a path, such as a link; an array that is missing is damage."""
    return os.path.lexists(path) and not stat.S_ISDIR(path.lstat().st_mode)


def _alike(path: Path, wanted: dict[str, Any]) -> bool:
    try:
        metadata = json.loads(plain_bytes(path, LARGEST_ROOT, links=False))
        length = metadata["shape"][0]
        metadata["shape"][0] = wanted["shape"][0]
        return metadata == wanted and length >= wanted["shape"][0]
    except (UnreadableError, ValueError, LookupError, TypeError, RecursionError):
        return False
