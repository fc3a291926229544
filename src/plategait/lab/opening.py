"""The page opened: the file itself, in the user's browser. Nothing is served, and nothing listens."""

from __future__ import annotations

import webbrowser
from pathlib import Path


def open_page(path: Path) -> bool:
    """Open a page in the browser that the system has for them; whether it has one."""
    try:
        return webbrowser.open(path.absolute().as_uri())
    except webbrowser.Error:
        return False
