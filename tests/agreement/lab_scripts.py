"""What scripts of the lab answer under node."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path
from typing import Any

NODE = shutil.which("node")
SCRIPTS = Path(__file__).parents[2] / "lab" / "tests" / "agreement"


def asked(script: str, question: dict[str, Any]) -> dict[str, Any]:
    """What a script of the lab answers; its words for numbers that JSON cannot hold are left as they are."""
    assert NODE is not None
    done = subprocess.run(
        [NODE, str(SCRIPTS / script)], input=json.dumps(question), capture_output=True, text=True, check=True
    )
    return json.loads(done.stdout)
