"""Stores that were damaged, edited, moved or made to mislead: each is noticed, in one line."""

from __future__ import annotations

import json
import os
import random
import shutil
from pathlib import Path

import numpy as np
import pytest
import xarray

from plategait.campaign.identity import fingerprint_of
from plategait.campaign.opened import open_sweep
from plategait.campaign.run import sweep
from plategait.campaign.seal import sealed
from plategait.errors import InputError

PLAN = {
    "name": "small",
    "scenario": "cheese",
    "batch": 1,
    "set": {"duration": "0.2 s"},
    "grid": {"motion.frequency": ["14 Hz", "24 Hz"]},
    "record": {"channels": ["rotation"], "interval": "20 ms"},
}
FLIPS, SEED = 250, 20


@pytest.fixture(scope="module")
def whole(tmp_path_factory) -> Path:
    path = tmp_path_factory.mktemp("whole") / "s.zarr"
    assert sweep(PLAN, path).complete
    return path


@pytest.fixture
def store(whole, tmp_path) -> Path:
    return Path(shutil.copytree(whole, tmp_path / "s.zarr"))


def contents(path: Path) -> dict[str, list]:
    """Every array of a store, and what it says of itself."""
    with xarray.open_zarr(path, chunks=None) as data:
        found = {str(name): [values.dims, values.values, dict(values.attrs)] for name, values in data.variables.items()}
        return found | {"attributes": [dict(data.attrs)]}


def assert_same(one: dict[str, list], two: dict[str, list]) -> None:
    for name in one.keys() | two.keys():
        for a, b in zip(one[name], two[name], strict=True):
            np.testing.assert_equal(a, b, err_msg=name)


def edit(path: Path, reseal: bool, **attributes) -> None:
    root = json.loads((path / "zarr.json").read_text())
    root["attributes"] |= attributes
    (path / "zarr.json").write_text(json.dumps(sealed(root) if reseal else root))


def refused(path: Path) -> str:
    """Message with which a store is refused, by every way to use it."""
    said = set()
    for attempt in (
        lambda: open_sweep(path),
        lambda: open_sweep(path, damaged=True),
        lambda: sweep(PLAN, path),
    ):
        with pytest.raises(InputError) as caught:
            attempt()
        said.add(str(caught.value))
    assert all("\n" not in line and len(line) < 1000 for line in said)
    return min(said)


@pytest.mark.slow
def test_every_flipped_bit_is_noticed_or_changes_nothing(store):
    whole = contents(store)
    files = sorted(path for path in store.rglob("*") if path.is_file() and path.stat().st_size)
    generator = random.Random(SEED)
    noticed = 0
    for file in generator.choices(files, weights=[path.stat().st_size for path in files], k=FLIPS):
        good = file.read_bytes()
        bad = bytearray(good)
        bad[generator.randrange(len(bad))] ^= 1 << generator.randrange(8)
        file.write_bytes(bad)
        try:
            found = open_sweep(store)
        except InputError:
            noticed += 1
        else:
            assert found.complete, file
            assert_same(contents(store), whole)
        file.write_bytes(good)
    assert noticed > 0.9 * FLIPS, "what JSON and the codecs let pass is rare"


@pytest.mark.slow
@pytest.mark.parametrize(
    "which", ["zarr.json", "spin_rate/zarr.json", "motion.frequency/c.1", "time/c.0", "checksum/c.0"]
)
@pytest.mark.parametrize("harm", ["flip", "remove", "link", "pipe"])
def test_a_damaged_file_is_mended_on_request(store, whole, tmp_path, which, harm):
    file = store / which
    good = file.read_bytes()
    file.unlink()
    if harm == "flip":
        file.write_bytes(good[:-3] + bytes([good[-3] ^ 4]) + good[-2:])
    elif harm == "link":  # even to the very same content: it is not followed
        (tmp_path / "elsewhere").write_bytes(good)
        file.symlink_to(tmp_path / "elsewhere")
    elif harm == "pipe":
        os.mkfifo(file)
    lost = (which, harm) == ("checksum/c.0", "remove")  # as if that batch had never been finished
    if lost:
        assert not open_sweep(store).complete
    else:
        with pytest.raises(InputError):
            sweep(PLAN, store)
    assert sweep(PLAN, store, repair=True).complete
    assert_same(contents(store), contents(whole))
    if harm == "link":
        assert (tmp_path / "elsewhere").read_bytes() == good


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("plategait_version", "9.9.9"),
        ("instruction_set", "none"),
        ("machine", "abacus"),
        ("engine", "cpu64"),
        ("store_format", 4),
        ("observables", []),
        ("points_hash", "0"),
        ("batch", 0),
        ("batch", "many"),
        ("refine", -1),
        ("refine", None),
        ("base_points", 1),
        ("seed", 1),
        ("title", "another"),
        ("sweep", "[]"),
        ("sweep", "{"),
        ("sweep", 7),
        ("sweep", "[" * 100_000),
        ("fingerprint", "x"),
    ],
)
@pytest.mark.parametrize("reseal", [False, True])
def test_an_edited_attribute_is_noticed(store, name, value, reseal):
    edit(store, reseal, **{name: value})
    assert "s.zarr" in refused(store)


def test_an_edited_plan_is_noticed_behind_a_new_seal(store):
    text = open_sweep(store).attributes["sweep"].replace('\\"cheese\\"', '\\"cheddar\\"')
    edit(store, True, sweep=text)
    assert "fingerprint" in refused(store)


def test_a_store_of_another_version_can_be_read_but_not_gone_on_with(store):
    attributes = open_sweep(store).attributes | {"plategait_version": "0.0.0"}
    edit(store, True, **attributes | {"fingerprint": fingerprint_of(attributes)})
    assert open_sweep(store).complete
    with pytest.raises(InputError, match=r"plategait_version 0\.0\.0"):
        sweep(PLAN, store)


@pytest.mark.parametrize("name", ["../outside", "/etc", "spin_rate/../../outside", "strange", ""])
def test_only_the_arrays_of_the_plan_are_opened(store, name):
    root = json.loads((store / "zarr.json").read_text())
    arrays = root["consolidated_metadata"]["metadata"]
    arrays[name] = arrays["spin_rate"]
    (store / "zarr.json").write_text(json.dumps(sealed(root)))
    assert "not expected" in refused(store)


@pytest.mark.parametrize(
    ("key", "value"),
    [
        ("shape", [0, 1]),
        ("shape", [3, 1]),
        ("shape", []),
        ("shape", "x"),
        ("data_type", "object"),
        ("data_type", {"name": "float64"}),
        ("codecs", [{"name": "numcodecs.pickle"}]),
        ("dimension_names", None),
    ],
)
def test_an_array_of_another_form_is_refused(store, key, value):
    root = json.loads((store / "zarr.json").read_text())
    root["consolidated_metadata"]["metadata"]["spin_rate"][key] = value
    (store / "zarr.json").write_text(json.dumps(sealed(root)))
    refused(store)


def test_a_folder_that_is_a_link_is_not_followed(store, tmp_path):
    (store / "gait").rename(tmp_path / "gait")
    (store / "gait").symlink_to(tmp_path / "gait")
    assert "gait, which is no folder" in refused(store)
    assert len(list((tmp_path / "gait").iterdir())) == 3


def test_a_link_in_the_way_of_a_new_file_is_not_followed(store, tmp_path):
    victim = tmp_path / "victim"
    victim.write_text("precious")
    (store / "zarr.json.partial").symlink_to(victim)
    assert sweep(PLAN, store, refine=1).complete
    assert victim.read_text() == "precious"


def test_a_lock_that_is_a_link_is_not_followed(store, tmp_path):
    (store / ".lock").unlink()
    (store / ".lock").symlink_to(tmp_path / "made")
    with pytest.raises(InputError, match="lock"):
        sweep(PLAN, store)
    assert not (tmp_path / "made").exists()


@pytest.mark.parametrize("fate", ["renamed", "deleted", "replaced"])
def test_a_folder_that_goes_away_under_a_campaign_is_one_line(tmp_path, fate):
    path = tmp_path / "s.zarr"

    def take_away(fraction: float) -> None:
        if 0 < fraction < 1 and path.exists():
            path.rename(tmp_path / "t.zarr")
            if fate != "renamed":
                shutil.rmtree(tmp_path / "t.zarr")
            if fate == "replaced":
                path.mkdir()

    with pytest.raises(InputError, match="moved") as caught:
        sweep(PLAN, path, progress=take_away)
    assert "\n" not in str(caught.value)
    assert list(path.iterdir() if fate == "replaced" else tmp_path.glob("s.zarr")) == []
    if fate == "renamed":
        assert sweep(PLAN, tmp_path / "t.zarr").complete
