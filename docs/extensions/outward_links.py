"""Lists what the site points to outside itself, and refuses a page that would fetch anything from there."""

from __future__ import annotations

import re
from pathlib import Path

from sphinx.application import Sphinx
from sphinx.util import logging

_LOG = logging.getLogger(__name__)
# What a browser fetches by itself, whether or not anybody clicks.
_FETCHED = re.compile(r"<(?:script|img|link|iframe)\b[^>]*\b(?:src|href)=[\"'](?:https?:)?//([^\"']+)", re.I)
_FETCHED_BY_STYLE = re.compile(r"@import\s+[\"']?https?:|url\(\s*[\"']?(?:https?:)?//", re.I)
_LINK = re.compile(r"<a\b[^>]*\bhref=\"(https?://[^\"#]+)", re.I)


def fetched(text: str) -> list[str]:
    """Addresses that a page fetches from elsewhere."""
    return _FETCHED.findall(text)


def check(app: Sphinx, error: Exception | None) -> None:
    """Read every page that was written."""
    if error or app.builder.format != "html":
        return
    links: dict[str, set[str]] = {}
    out = Path(app.outdir)
    for page in sorted(out.rglob("*.html")):
        text, name = page.read_text(encoding="utf-8"), str(page.relative_to(out))
        for address in fetched(text):
            _LOG.warning("%s would fetch %s", name, address)
        for address in _LINK.findall(text):
            links.setdefault(address, set()).add(name)
    for style in sorted(out.rglob("*.css")):
        if _FETCHED_BY_STYLE.search(style.read_text(encoding="utf-8")):
            _LOG.warning("%s would fetch something", style.relative_to(out))
    lines = [f"{address}  {', '.join(sorted(names)[:3])}" for address, names in sorted(links.items())]
    (out / "external-links.txt").write_text("\n".join([*lines, ""]), encoding="utf-8")


def setup(app: Sphinx) -> dict[str, bool]:
    """Check when everything is written."""
    app.connect("build-finished", check)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
