"""The lab's model against the package's: what it refuses, and natural frequencies."""

from __future__ import annotations

import base64
import copy
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from lab_scripts import ENGINE, asked, needs_engine
from lab_sheets import plain, random_cuts, random_groups

import plategait as pg
from plategait.errors import InputError

pytestmark = needs_engine

CHEESE = pg.preset("cheese").scenario
SCENARIOS = [group[0] for group in random_groups(20, 1, seed=4)]


def leaves(part: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Where the numbers and words of a plain scenario are."""
    if not isinstance(part, (dict, list)):
        yield path
        return
    for key, value in part.items() if isinstance(part, dict) else enumerate(part[:2]):
        yield from leaves(value, (*path, key))


def spoilt(count: int, seed: int) -> list[tuple[dict[str, Any], str | None]]:
    """Plain scenarios with one value set to another, and the field for which the package refuses them, or None."""
    generator, whole = np.random.default_rng(seed), [plain(s) for s in SCENARIOS]
    values = [0.0, -0.0, -1.0, 1e-31, 1e31, 1e-4, 1e6, 11.0, 1.0, 0.5, None, {}, 1e-9, 1e-13, 5e-324, 2.0]
    found: list[tuple[dict[str, Any], str | None]] = []
    while len(found) < count:
        fields = copy.deepcopy(whole[int(generator.integers(len(whole)))])
        places = [path for path in leaves(fields) if path[-1] not in ("image", "name")]
        *path, last = places[int(generator.integers(len(places)))]
        part = fields
        for key in path:
            part = part[key]
        part[last] = values[int(generator.integers(len(values)))]
        try:
            # A page simulates fewer nodes than the package does.
            if pg.Scenario(**fields).sheet.lattice.n_nodes <= 20_000:
                found.append((fields, None))
        except InputError as error:
            found.append((fields, error.field))
    return found


def cut(**outline: Any) -> pg.Scenario:
    return CHEESE.replace(**{"sheet.outline": outline})


SHEETS = [
    *SCENARIOS, *(CHEESE.replace(**{"sheet.pitch": pitch}) for pitch in (0.01, 0.005, 0.0025)),
    *(cut(shape="rectangle", length=length, width=0.03) for length in (0.03, 0.035, 0.04, 0.05, 0.08, 0.2)),
    *(cut(shape="ellipse", length=length, width=0.05) for length in (0.055, 0.07, 0.09, 0.15)),
    cut(shape="rectangle", length=0.1, width=0.01), cut(shape="polygon", corners=[(0, 0), (0.06, 0), (0, 0.05)]),
    *(CHEESE.replace(**{"sheet.torsion_stiffness": k * CHEESE.sheet.bending_stiffness}) for k in (1e-3, 0.3, 1.0, 4.0)),
    cut(shape="ellipse", length=0.1, width=0.05).replace(**{"sheet.torsion_stiffness": 1e-4}),
]  # fmt: skip


CUTS = random_cuts(400, seed=1)


@pytest.fixture(scope="module")
def damaged() -> list[tuple[dict[str, Any], str | None]]:
    return spoilt(400, seed=3)


@pytest.fixture(scope="module")
def answer(damaged) -> dict[str, Any]:
    """What the lab makes of all of them, in one process."""
    return asked("engine.js", {
        "engine": str(ENGINE), "refused": [fields for fields, _ in damaged],
        "sheets": [plain(s)["sheet"] for s in SHEETS], "cuts": CUTS,
    })  # fmt: skip


def test_scenarios_are_refused_for_the_same_field(answer, damaged):
    refused = [field for _, field in damaged if field]
    assert 100 < len(refused) < 300
    for (_, field), told in zip(damaged, answer["refused"], strict=True):
        if field is None:
            assert told is None
        else:
            # Of a list the page names the whole.
            assert told is not None
            assert field.startswith(told["field"])
            assert "must be" in told["message"]
            assert "try " in told["message"]


def test_natural_frequencies_are_the_same(answer):
    for scenario, told in zip(SHEETS, answer["frequencies"], strict=True):
        assert float(told) == pytest.approx(scenario.sheet.natural_frequency, rel=1e-6), scenario.sheet.outline


def occupied(outline: dict[str, Any], pitch: float) -> np.ndarray | str:
    """Squares of a sheet, or the field that it is refused for."""
    try:
        return CHEESE.replace(**{"sheet.outline": outline, "sheet.pitch": pitch}).sheet.lattice.occupied
    except InputError as error:
        return error.field


def test_outlines_are_cut_to_the_same_squares_or_refused_alike(answer):
    wanted = [occupied(**cut) for cut in CUTS]
    assert 40 < sum(isinstance(want, str) for want in wanted) < 200
    for want, told in zip(wanted, answer["cuts"], strict=True):
        if isinstance(want, str):
            assert told == {"field": want}
        else:
            got = np.frombuffer(base64.b64decode(told["inside"]["bytes"]), dtype=bool)
            assert (told["columns"], told["rows"]) == want.shape
            assert np.array_equal(got, want.ravel())
