"""Films by a ray caster that shares no code with the package, of plates and objects as strangers have them."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from ray_caster import Film, shot

from plategait.vision.setup import Setup
from plategait.vision.track import Track, track

pytestmark = pytest.mark.slow
Tracker = Callable[[Film], Track]


@pytest.fixture(scope="module")
def tracked(tmp_path_factory: pytest.TempPathFactory) -> Tracker:
    """Track of each film; each is cast once."""
    folder = tmp_path_factory.mktemp("films")

    @cache
    def followed(film: Film) -> Track:
        path: Path = folder / f"{len(list(folder.iterdir()))}.mp4"
        return track(shot(film, path), Setup(plate_size=(film.side, film.side), plate_frequency=film.frequency))

    return followed


def error_of(result: Track, film: Film) -> float:
    """Scatter of the sure orientations about the true ones, deg, but for where the object's mark points."""
    off = np.exp(1j * (result.angle - film.angle(film.time))[result.sure])
    return math.degrees(float(np.std(np.angle(off / off.mean()))))


@pytest.mark.parametrize(
    "film",
    [
        pytest.param(Film(fold=8e-3, rate=250.0, seconds=1.5), id="markers that lift, steel"),
        pytest.param(Film(plate="dark", thickness=6e-3, rate=-320.0, flicker=0.15, seconds=1.5), id="thick, dark"),
        pytest.param(Film(plate="wood", look="toppings", rate=-90.0, seconds=1.5), id="toppings, wood"),
        pytest.param(
            Film(plate="glossy", look="grain", stretch=0.8, rate=70.0, shake=2e-3, seconds=1.5), id="oval, held by hand"
        ),
        pytest.param(Film(plate="wood", hand=(0.0, 0.8), rate=200.0), id="a hand at first"),
    ],
)
def test_rates_hold(film: Film, tracked: Tracker) -> None:
    result = tracked(film)
    assert result.spin.low <= math.radians(film.rate) <= result.spin.high
    # The target of the films of our own is 1 %.
    assert math.degrees(result.spin.rate) == pytest.approx(film.rate, rel=0.01)
    # A degree is the target, and half as much again of what is lifted.
    assert error_of(result, film) < 1.5
