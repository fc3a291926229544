"""The lab's file in a browser, with hostile data and scripts: its policy lets nothing out and nothing in."""

from __future__ import annotations

import json
from importlib.resources import files
from pathlib import Path

import pytest

from plategait.lab.page import PLACES, SHIPPED, page

pytestmark = pytest.mark.browser

# What a page may do: compile the engine, in the page and in a worker made of its own text.
MAY = """
const text = (id) => document.getElementById(id).textContent;
const bytes = Uint8Array.from(atob(text("engine")), (c) => c.charCodeAt(0));
const worker = new Worker(URL.createObjectURL(new Blob([text("worker")], { type: "text/javascript" })));
window.told = { payload: JSON.parse(text("payload")), images: document.images.length };
window.told.scripts = document.scripts.length;
worker.onmessage = ({ data }) => { window.told.worker = data; };
worker.postMessage(bytes);
window.told.here = WebAssembly.Module.exports(new WebAssembly.Module(bytes)).length;
"""
WORKER = """
onmessage = ({ data }) => postMessage(WebAssembly.Module.imports(new WebAssembly.Module(data)).length);
"""
# What it may not: each way out or in, and what came of it.
MAY_NOT = """
window.told = {};
const tried = (name, attempt) => Promise.resolve().then(attempt).then(
  () => { window.told[name] = "done"; }, (error) => { window.told[name] = "refused"; });
const loads = (element, address) => new Promise((done, refused) => {
  element.onload = done; element.onerror = refused;
  element[element.href === undefined || element.tagName === "IFRAME" ? "src" : "href"] = address;
  document.head.append(element);
});
const made = (name) => document.createElement(name);
const script = (text) => { const it = made("script"); it.textContent = text; document.head.append(it); };
Promise.all([
  tried("fetch", () => fetch("https://example.org/")),
  // It says yes even where nothing is sent.
  tried("beacon", () => new Promise((done, refused) => {
    const ofBeacon = ({ blockedURI }) => { if (blockedURI.includes("beacon")) refused(); };
    document.addEventListener("securitypolicyviolation", ofBeacon);
    navigator.sendBeacon("https://example.org/beacon", "a"); setTimeout(done, 1000); })),
  tried("socket", () => new Promise((done, refused) => {
    const socket = new WebSocket("wss://example.org/"); socket.onopen = done; socket.onerror = refused; })),
  tried("image", () => loads(made("img"), "https://example.org/a.png")),
  tried("source", () => loads(made("script"), "https://example.org/a.js")),
  tried("sheet", () => loads(Object.assign(made("link"), { rel: "stylesheet" }), "https://example.org/a.css")),
  tried("inline", () => { script("window.ran = 1"); if (!window.ran) throw new Error(); }),
  tried("handler", () => {
    const it = made("p"); it.setAttribute("onclick", "window.clicked = 1"); document.body.append(it); it.click();
    if (!window.clicked) throw new Error(); }),
  tried("eval", () => eval("1")),
  tried("function", () => new Function("return 1")()),
  tried("style", () => {
    const it = made("style"); it.textContent = "p { position: fixed }"; document.head.append(it);
    if (getComputedStyle(document.querySelector("p")).position !== "fixed") throw new Error(); }),
  tried("worker", () => new Promise((done, refused) => {
    const it = new Worker("data:text/javascript,postMessage(1)"); it.onmessage = done; it.onerror = refused; })),
]).then(() => { window.told.over = true; });
"""
HOSTILE = "</script><img src=x onerror=\"document.title='taken'\"><script>document.title='taken'</script><!--"


@pytest.fixture
def written(tmp_path):
    """A page with scripts of our own in the place of those that are shipped."""

    def write(script: str, payload: dict) -> Path:
        folder = tmp_path / "shipped"
        folder.mkdir()
        html = "<!doctype html><html lang=en><head><title>mine</title>{}{}</head><body><p>p</p>{}{}</body></html>"
        texts = {"page.html": html.format(*PLACES), "page.js": script, "worker.js": WORKER, "page.css": "p { left: 0 }"}
        for name in SHIPPED:
            (folder / name).write_text(texts.get(name, "0"))
        # The smallest module that exports something: an empty memory.
        (folder / "engine.wasm").write_bytes(b"\0asm\1\0\0\0\5\3\1\0\1\7\5\1\1m\2\0")
        (tmp_path / "page.html").write_text(page(payload, folder))
        return tmp_path / "page.html"

    return write


def test_engine_worker_and_hostile_data_load_from_the_disk(written, new_tab):
    tab = new_tab(offline=True)
    payload = {"kind": "scenario", "name": HOSTILE, HOSTILE: [HOSTILE]}
    tab.open(written(MAY, payload))
    tab.until("window.told.worker !== undefined")
    told = tab.page.evaluate("window.told")
    assert told == {"payload": payload, "images": 0, "scripts": 7, "worker": 0, "here": 1}
    assert tab.page.title() == "mine"
    tab.check()


def test_nothing_gets_out_and_no_other_script_runs(written, new_tab):
    tab, answered = new_tab(), []
    tab.page.context.on("requestfinished", lambda request: answered.append(request.url))
    tab.open(written(MAY_NOT, {"kind": "scenario"}))
    tab.until("window.told.over")
    told = tab.page.evaluate("window.told")
    assert {name for name, end in told.items() if end == "done"} == set()
    assert len(told) == 13
    assert [address for address in answered if address.startswith(("http", "ws"))] == []


def test_the_policy_itself_keeps_what_is_shipped_to_its_bytes(written, new_tab):
    """Whoever changes a script in the file, but not its hash, has a page that does nothing."""
    path = written("window.told = 'mine'", {"kind": "scenario"})
    path.write_text(path.read_text().replace("window.told = 'mine'", "window.told = 'hers'"))
    tab = new_tab()
    tab.open(path)
    assert tab.page.evaluate("window.told") is None
    assert any("Content Security Policy" in message for message in tab.messages)


def test_the_shipped_worker_and_engine_are_plain_text_and_whole():
    folder = files("plategait.lab") / "shipped"
    if not (folder / "built_from.json").is_file():
        pytest.skip("the page is not built here: make lab")
    assert (folder / "engine.wasm").read_bytes()[:8] == b"\0asm\1\0\0\0"
    assert set(json.loads((folder / "built_from.json").read_text())["shipped"]) == set(SHIPPED)
