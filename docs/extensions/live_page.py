"""The lab's page beside the page that tells of it: written by the package itself, as `plategait lab` writes it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from sphinx.application import Sphinx

NAME = "lab-cheese.html"


def _write(app: Sphinx, error: Exception | None) -> None:
    if error is not None or app.builder.format != "html":
        return
    from plategait.lab.page import page
    from plategait.lab.payload import named
    from plategait.model.presets import as_scenario

    html = page(named("cheese").payload(as_scenario("cheese")))
    (Path(app.outdir) / NAME).write_text(html, encoding="utf-8")


def setup(app: Sphinx) -> dict[str, Any]:
    """Write the page once all others are."""
    app.connect("build-finished", _write)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
