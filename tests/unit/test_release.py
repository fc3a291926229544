"""What a release is cut from: one version everywhere, and the same tools in the hooks as in `make lint`."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import plategait

ROOT = Path(__file__).parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
VERSION = PROJECT["version"]


def first(pattern: str, file: str) -> str | None:
    found = re.search(pattern, (ROOT / file).read_text(), flags=re.MULTILINE)
    return found and found.group(1)


def test_the_version_is_semantic_and_the_package_tells_it():
    assert re.fullmatch(r"\d+\.\d+\.\d+((a|b|rc)\d+)?", VERSION)
    assert plategait.__version__ == VERSION


def test_citation_and_changelog_name_the_version():
    assert first(r"^version: (.*)$", "CITATION.cff") == VERSION
    # The newest section of the changelog is this version's, not yet released or with its day.
    assert first(r"^## \[(.*)\] - (?:unreleased|\d{4}-\d{2}-\d{2})$", "CHANGELOG.md") == VERSION
    assert first(r"^## (.*)$", "CHANGELOG.md").startswith(f"[{VERSION}]")


def test_the_hooks_run_what_lint_runs():
    pinned = {need for need in PROJECT["optional-dependencies"]["lint"] if "==" in need}
    assert {need.split("==")[0] for need in pinned} == {"ruff", "clang-format"}
    hooks = re.findall(r"additional_dependencies: \[(.*)\]", (ROOT / ".pre-commit-config.yaml").read_text())
    assert set(hooks) == pinned
