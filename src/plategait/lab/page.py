"""The page put together: one HTML file with its styles, scripts, engine and data, which asks nothing of any network.

What is shipped beside this module was built by `make lab` from `lab/` and `native/`. Data go in as JSON that cannot end
its element, whatever it holds, and a policy in the page names the scripts and styles that may run by their hashes and
forbids all else: no connection, no frame, no form, no script from anywhere.
"""

from __future__ import annotations

import base64
import hashlib
import json
from collections.abc import Iterator
from importlib.resources import files
from importlib.resources.abc import Traversable
from typing import Any

from plategait.errors import InputError
from plategait.lab.facts import facts

LARGEST_PAGE = 2_000_000
"""Bytes: what can be mailed, and opened at once."""
SHIPPED: tuple[str, ...] = (
    "page.html",
    "page.css",
    "libraries.js",
    "page.js",
    "worker.js",
    "engine.wasm",
    "licences.txt",
)
"""What `make lab` builds."""
PLACES: tuple[str, ...] = ("<!--csp-->", "<!--styles-->", "<!--data-->", "<!--scripts-->")
"""Where page.html is filled in, each once."""

# What could end an element or begin a comment or a line where a script's text must not, and halves of letters, which
# names of files may hold and UTF-8 does not: all as JSON's own escapes.
_ESCAPES = {letter: f"\\u{letter:04x}" for letter in (*map(ord, "<>&\u2028\u2029"), *range(0xD800, 0xE000))}
# What a script or a style cannot hold as it stands.
_MARKUP = ("</script", "</style", "<!--", "\r", "\0")


def shipped_folder() -> Traversable:
    """Folder of what `make lab` built."""
    return files("plategait.lab") / "shipped"


def page(payload: dict[str, Any], folder: Traversable | None = None) -> str:
    """HTML of the page that shows a payload; the same text for the same payload.

    Parameters
    ----------
    payload : dict
        Plain data (`plategait.lab.payload`), without NaN.
    folder : Traversable, optional
        What is put together; by default what is shipped.

    Raises
    ------
    InputError
        When what is shipped is missing, or the page would be too large.
    """
    parts = _read(folder or shipped_folder())
    styles = [_checked("page.css", parts["page.css"].decode())]
    scripts = [_checked(name, parts[name].decode()) for name in ("libraries.js", "page.js")]
    data = [
        _element("application/json", "facts", as_text(facts())),
        _element("application/json", "payload", as_text(payload)),
        _element("application/json", "licences", as_text(parts["licences.txt"].decode())),
        _element("text/plain", "engine", base64.b64encode(parts["engine.wasm"]).decode()),
        _element("text/plain", "worker", _checked("worker.js", parts["worker.js"].decode())),
    ]
    filling = dict(zip(PLACES, (
        f'<meta http-equiv="Content-Security-Policy" content="{policy(scripts, styles)}">',
        "\n".join(f"<style>{style}</style>" for style in styles),
        "\n".join(data),
        "\n".join(f"<script>{script}</script>" for script in scripts),
    ), strict=True))  # fmt: skip
    html = "".join(_filled(parts["page.html"].decode(), filling))
    if (size := len(html.encode())) > LARGEST_PAGE:
        raise InputError("WHAT", f"data that make a page of {size / 1e6:.1f} MB",
                         f"what fits into {LARGEST_PAGE / 1e6:.0f} MB", "a shorter run or a smaller store")  # fmt: skip
    return html


def policy(scripts: list[str], styles: list[str]) -> str:
    """Content-Security-Policy under which these scripts and styles run, the engine is compiled, and nothing else."""
    allowed = {
        "default-src": ["'none'"],
        "script-src": [*map(_hash, scripts), "'wasm-unsafe-eval'"],
        "style-src": [*map(_hash, styles)],
        "worker-src": ["blob:"],
        "img-src": ["data:", "blob:"],
        "form-action": ["'none'"],
        "base-uri": ["'none'"],
    }
    return "; ".join(f"{what} {' '.join(sources)}" for what, sources in allowed.items())


def as_text(data: dict[str, Any] | str) -> str:
    """JSON that a script element may hold: nothing in it is markup, whatever the data say."""
    return json.dumps(data, ensure_ascii=False, allow_nan=False, separators=(",", ":")).translate(_ESCAPES)


def _read(folder: Traversable) -> dict[str, bytes]:
    parts = {}
    for name in SHIPPED:
        try:
            parts[name] = (folder / name).read_bytes()
        except OSError:
            raise InputError("lab", f"an installation without {name}", "one that has the page", "make lab") from None
    return parts


def _element(kind: str, name: str, text: str) -> str:
    return f'<script type="{kind}" id="{name}">{text}</script>'


def _checked(name: str, text: str) -> str:
    """The same, once it is sure that it ends where it seems to; the browser hashes the very same text."""
    if found := next((mark for mark in _MARKUP if mark in text.lower()), None):
        raise InputError("lab", f"{name} with {found!r} in it", "text without markup", "make lab")
    return text


def _hash(text: str) -> str:
    return f"'sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()}'"


def _filled(html: str, filling: dict[str, str]) -> Iterator[str]:
    """page.html with each place filled; what is filled in is not looked through for places again."""
    for place, text in filling.items():
        before, found, html = html.partition(place)
        if not found or place in html:
            raise InputError("lab", f"page.html without {place}" if not found else f"page.html with {place} twice",
                             f"{', '.join(PLACES)}, once each and in this order", "make lab")  # fmt: skip
        yield from (before, text)
    yield html
