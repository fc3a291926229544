"""The lab's page put together: data stay data, the policy names what runs, the same payload gives the same file."""

from __future__ import annotations

import base64
import hashlib
import json
import re
from html.parser import HTMLParser
from pathlib import Path

import pytest

from plategait.errors import InputError
from plategait.lab.page import LARGEST_PAGE, PLACES, SHIPPED, as_text, page

HOSTILE = [
    "</script><img src=x onerror=alert(1)>", "<!--", "<!-- <script>", "-->", "]]>", "<!--csp-->", "<!--scripts-->",
    "\u2028\u2029", "&lt;script&gt;", "\\u003c/script>", "\x00\x1f\x7f", '"}</SCRIPT >',
    "é 漢 \U0001f600", "half \udc80 a letter",
]  # fmt: skip
SCRIPT, STYLE = 'const a = "<b>" && 1;\n', "p { color: red }\n"


@pytest.fixture
def shipped(tmp_path) -> Path:
    """What stands in for what `make lab` builds."""
    html = "<!doctype html><html><head>{}{}</head><body><p id=p></p>{}\n{}</body></html>\n".format(*PLACES)
    parts = dict.fromkeys(SHIPPED, "x") | {"page.html": html, "page.css": STYLE, "page.js": SCRIPT}
    for name, text in parts.items():
        (tmp_path / name).write_text(text)
    (tmp_path / "engine.wasm").write_bytes(bytes(range(256)))
    return tmp_path


class Parts(HTMLParser):
    """Elements of a page as a browser's tokenizer tells them apart: a script ends at the first </script."""

    def __init__(self, html: str) -> None:
        super().__init__(convert_charrefs=False)
        self.elements: list[tuple[str, dict[str, str | None]]] = []
        self.texts: list[tuple[str, str]] = []
        self._open = ""
        self.feed(html)
        self.close()

    def handle_starttag(self, tag, attrs):
        self.elements.append((tag, dict(attrs)))
        self._open = tag

    def handle_endtag(self, tag):
        self._open = ""

    def handle_data(self, data):
        if self._open in ("script", "style"):
            self.texts.append((self._open, data))

    @property
    def scripts(self) -> list[tuple[dict[str, str | None], str]]:
        kinds = [attrs for tag, attrs in self.elements if tag == "script"]
        return list(zip(kinds, [text for tag, text in self.texts if tag == "script"], strict=True))


def data_of(html: str, name: str):
    return json.loads(next(text for attrs, text in Parts(html).scripts if attrs.get("id") == name))


@pytest.mark.parametrize("text", HOSTILE)
def test_hostile_text_stays_text(shipped, text):
    payload = {"kind": "scenario", "name": text, text: [text, {"name": text}]}
    html = page(payload, shipped)
    assert data_of(html, "payload") == payload
    plain = Parts(page({"kind": "scenario"}, shipped))
    assert Parts(html).elements == plain.elements


def test_json_in_the_page_holds_no_markup():
    text = as_text({"text": "".join(HOSTILE)})
    assert not set("<>&\u2028\u2029") & set(text)
    assert json.loads(text)["text"] == "".join(HOSTILE)


def test_numbers_that_json_has_not_are_refused():
    with pytest.raises(ValueError, match="JSON"):
        as_text({"rate": float("nan")})


def test_the_policy_names_every_script_and_style_and_allows_no_network(shipped):
    html = page({"kind": "scenario"}, shipped)
    parts = Parts(html)
    content = next(a["content"] for tag, a in parts.elements if a.get("http-equiv") == "Content-Security-Policy")
    assert content is not None
    rules = {rule.split()[0]: rule.split()[1:] for rule in content.split("; ")}

    def hashed(text: str) -> str:
        return f"'sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()}'"

    run = [text for attrs, text in parts.scripts if "type" not in attrs]
    assert len(run) == 2
    assert rules["script-src"] == [*map(hashed, run), "'wasm-unsafe-eval'"]
    assert rules["style-src"] == [hashed(text) for tag, text in parts.texts if tag == "style"]
    assert rules["default-src"] == ["'none'"]
    assert rules["form-action"] == rules["base-uri"] == ["'none'"]
    assert rules["worker-src"] == ["blob:"]
    assert set(rules) == {"default-src", "script-src", "style-src", "worker-src", "img-src", "form-action", "base-uri"}
    assert "http:" not in content
    assert "unsafe-inline" not in content
    # Before anything that it is to hold back.
    assert html.index("Content-Security-Policy") < min(html.index("<script"), html.index("<style"))


def test_the_engine_travels_byte_by_byte(shipped):
    html = page({"kind": "scenario"}, shipped)
    text = next(text for attrs, text in Parts(html).scripts if attrs.get("id") == "engine")
    assert base64.b64decode(text) == bytes(range(256))


def test_the_same_payload_gives_the_same_page(shipped):
    payload = {"kind": "scenario", "numbers": [0.1, 1e-9]}
    assert page(payload, shipped) == page(json.loads(json.dumps(payload)), shipped)


def test_a_page_of_more_than_two_megabytes_is_refused(shipped):
    with pytest.raises(InputError, match=r"WHAT: got 'data that make a page of 2\.\d MB'"):
        page({"kind": "run", "text": "x" * LARGEST_PAGE}, shipped)


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("page.js", "let a = '</script>';", "page.js with '</script'"),
        ("worker.js", "a <!--b", "worker.js with '<!--'"),
        ("page.css", "</style>", "page.css with '</style'"),
        ("page.js", "let a;\r\n", "page.js with"),
        ("page.html", "<html></html>", "page.html without <!--csp-->"),
        ("page.html", "".join(PLACES) + PLACES[0], "page.html with <!--csp--> twice"),
        ("page.html", "".join(reversed(PLACES)), "page.html"),
    ],
)
def test_parts_that_would_break_the_page_are_refused(shipped, name, text, said):
    (shipped / name).write_bytes(text.encode())
    with pytest.raises(InputError, match=re.escape(said)):
        page({"kind": "scenario"}, shipped)


def test_an_installation_without_the_page_says_what_to_do(shipped):
    (shipped / "engine.wasm").unlink()
    with pytest.raises(InputError, match=r"without engine\.wasm.*make lab"):
        page({"kind": "scenario"}, shipped)
