"""What scripts of the lab answer under node."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest

import plategait

NODE = shutil.which("node")
ENGINE = Path(plategait.__file__).parent / "lab" / "shipped" / "engine.wasm"
SCRIPTS = Path(__file__).parents[2] / "lab" / "tests" / "agreement"

needs_engine = [
    pytest.mark.skipif(NODE is None, reason="node is not installed: the lab's engine is not compared"),
    pytest.mark.skipif(not ENGINE.exists(), reason="the lab's engine is not built here: make lab"),
]
"""Marks of a file that asks the engine's module."""


def asked(script: str, question: dict[str, Any]) -> dict[str, Any]:
    """What a script of the lab answers; its words for numbers that JSON cannot hold are left as they are."""
    assert NODE is not None
    done = subprocess.run(
        [NODE, str(SCRIPTS / script)], input=json.dumps(question), capture_output=True, text=True, check=True
    )
    return json.loads(done.stdout)
