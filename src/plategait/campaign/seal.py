"""The check sum over a store's metadata: whether they are, to the last bit, what was written."""

from __future__ import annotations

import hashlib
import json
from typing import Any

SEAL = "metadata_checksum"


def hash_of(content: object) -> str:
    """Hash of what JSON can hold, however it is laid out."""
    return hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()


def sealed(root: dict[str, Any]) -> dict[str, Any]:
    """Metadata of a store with their check sum among the attributes."""
    attributes = {name: value for name, value in root["attributes"].items() if name != SEAL}
    return root | {"attributes": attributes | {SEAL: hash_of(root | {"attributes": attributes})}}


def is_sealed(root: dict[str, Any]) -> bool:
    """Whether metadata are as they were sealed."""
    return sealed(root)["attributes"][SEAL] == root["attributes"][SEAL]
