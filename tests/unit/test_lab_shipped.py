"""The shipped page is what its sources give: by their hashes, without compiler, node or browser."""

from __future__ import annotations

import importlib.util
import json
from pathlib import Path
from types import ModuleType

import pytest

from plategait.lab.page import LARGEST_PAGE, SHIPPED

ROOT = Path(__file__).parents[2]


def load(root: Path = ROOT) -> ModuleType:
    """`lab/built_from.py`, for a tree."""
    spec = importlib.util.spec_from_file_location("built_from", ROOT / "lab" / "built_from.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    module.ROOT = root  # type: ignore[attr-defined]
    return module


built_from = load()


def test_the_shipped_files_are_what_the_sources_give():
    assert built_from.differences() == []


def test_all_that_a_page_is_made_of_is_shipped_and_small():
    files = {path.name: path.stat().st_size for path in built_from.SHIPPED.iterdir()}
    assert set(files) == {*SHIPPED, built_from.RECORD}
    # A third of a page is left for its data, which `MOST_…` of the payloads keep to.
    assert sum(files.values()) < LARGEST_PAGE * 2 / 3


def test_the_core_is_built_from_the_headers_of_every_engine():
    sources = built_from.native_sources()
    assert {"native/browser.cpp", "native/block.hpp", "native/laws.hpp", "native/step.hpp"} <= set(sources)


@pytest.fixture
def tree(tmp_path) -> ModuleType:
    """A small tree, with its record of what it shipped."""
    built = load(tmp_path)
    texts = {
        "native/browser.cpp": '#include <cmath>\n#include "a.hpp"\n', "native/a.hpp": '  #  include "b.hpp"\n',
        "native/b.hpp": "", "native/other.hpp": "", "lab/src/main.js": "1", "lab/src/view/view.js": "2",
        "out/page.js": "3", **dict.fromkeys(built.MADE_WITH, ""),
    }  # fmt: skip
    for name, text in texts.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    built.write(tmp_path / "out")
    return built


def test_what_was_just_built_is_what_the_sources_give(tree):
    assert tree.differences(tree.ROOT / "out") == []
    assert tree.native_sources() == ["native/a.hpp", "native/b.hpp", "native/browser.cpp"]


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("native/b.hpp", "int a;", "native/b.hpp has changed"),
        ("lab/src/view/view.js", "4", "lab/src/view/view.js has changed"),
        ("lab/src/new.js", "4", "lab/src/new.js is new"),
        ("lab/src/main.js", None, "lab/src/main.js is missing"),
        ("lab/package-lock.json", "{}", "lab/package-lock.json has changed"),
        ("lab/build_engine.py", "-O2", "lab/build_engine.py has changed"),
        ("out/page.js", "5", "page.js has changed"),
        ("out/page.js", None, "page.js is missing"),
        ("out/more.js", "", "more.js is new"),
    ],
)
def test_whatever_changes_is_told(tree, name, text, said):
    path = tree.ROOT / name
    path.unlink() if text is None else path.write_text(text)
    assert tree.differences(tree.ROOT / "out") == [said]


def test_a_header_that_no_longer_counts_changes_nothing(tree):
    (tree.ROOT / "native/other.hpp").write_text("int a;")
    assert tree.differences(tree.ROOT / "out") == []


def test_a_record_that_is_not_there_is_told(tree):
    (tree.ROOT / "out" / tree.RECORD).unlink()
    assert "is missing" in tree.differences(tree.ROOT / "out")[0]


def test_the_record_is_the_same_at_each_writing(tree):
    first = (tree.ROOT / "out" / tree.RECORD).read_bytes()
    tree.write(tree.ROOT / "out")
    assert (tree.ROOT / "out" / tree.RECORD).read_bytes() == first
    assert set(json.loads(first)) == {"sources", "shipped"}
