"""The lab's worker in a browser, under the page's own policy, against the native core."""

from __future__ import annotations

import shutil
from importlib.resources import files
from pathlib import Path

import numpy as np
import pytest
from lab_native import RUNS, advanced, is_same, is_within_the_spread
from lab_sheets import plain

from plategait.engine.recording import RunRequest
from plategait.lab.page import SHIPPED, page
from plategait.simulation.observation import observe

BUILT = Path(str(files("plategait.lab") / "shipped"))
pytestmark = [
    pytest.mark.browser,
    pytest.mark.skipif(not all((BUILT / name).exists() for name in SHIPPED), reason="the lab is not built: make lab"),
]
ASK = """async (scenarios) => {
  const text = (id) => document.getElementById(id).textContent;
  const bytes = Uint8Array.from(atob(text("engine")), (letter) => letter.charCodeAt(0));
  const worker = new Worker(URL.createObjectURL(new Blob([text("worker")], { type: "text/javascript" })));
  const replied = new Promise((done) => {
    worker.onmessage = ({ data }) => { if (data.told !== "progress") done(data); };
  });
  worker.postMessage({ engine: bytes.buffer });
  worker.postMessage({ id: 1, ask: "observe", scenarios, repeats: 1, seed: 0 });
  return replied;
}"""


@pytest.fixture
def silent_page(tmp_path) -> Path:
    """The page with its engine and worker, and nothing that begins by itself."""
    folder = tmp_path / "shipped"
    shutil.copytree(BUILT, folder)
    for name in ("page.js", "libraries.js"):
        (folder / name).write_text("")
    path = tmp_path / "lab.html"
    path.write_text(page({"kind": "none"}, folder), encoding="utf-8")
    return path


def test_rates_failures_gaits_and_energies_agree(new_tab, silent_page):
    assert len(RUNS) >= 50
    tab = new_tab()
    tab.open(silent_page)
    replied = tab.page.evaluate(ASK, [plain(s) for s in RUNS])
    tab.check()
    assert "refused" not in replied, replied
    told = [of_its_runs[0] for of_its_runs in replied["observations"]]
    native = advanced([RunRequest(s) for s in RUNS])
    unlike = [i for i, (s, r) in enumerate(zip(RUNS, native, strict=True)) if not is_same(observe(s, r), told[i])]
    # Chaotic ones: of random sheets a few in a hundred.
    assert len(unlike) <= 0.2 * len(RUNS)
    assert all(is_within_the_spread(RUNS[i], told[i]) for i in unlike)
    assert np.isfinite([float(each["spin"]["rate"]) for each in told]).sum() > 20
