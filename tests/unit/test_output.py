"""Files going out: refused early, whole or not at all."""

from __future__ import annotations

import errno
import os
import stat

import pytest

from plategait.errors import InputError
from plategait.files.output import check_writable, whole_file, write_whole


def test_a_file_is_written_whole(tmp_path):
    path = tmp_path / "a.csv"
    with whole_file(path, (".csv",)) as temporary:
        assert temporary.parent == tmp_path, "the same file system, so that it can take the place at once"
        assert temporary.suffix == ".csv"
        assert temporary != path
        temporary.write_text("new")
        assert not path.exists()
    assert path.read_text() == "new"
    assert list(tmp_path.iterdir()) == [path]


@pytest.mark.parametrize("old", ["old", None])
@pytest.mark.parametrize("error", [RuntimeError, KeyboardInterrupt, SystemExit, OSError])
def test_an_exception_leaves_what_was_there(tmp_path, old, error):
    path = tmp_path / "a.csv"
    if old is not None:
        path.write_text(old)

    def spoilt():
        with whole_file(path, (".csv",)) as temporary:
            temporary.write_text("half")
            raise error

    with pytest.raises(error):
        spoilt()
    assert [p.name for p in tmp_path.iterdir()] == ([] if old is None else ["a.csv"])
    assert old is None or path.read_text() == old


@pytest.mark.parametrize("code", [errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO])
def test_a_place_without_room_is_one_line(tmp_path, code):
    path = tmp_path / "a.csv"
    path.write_text("old")

    def full():
        with whole_file(path, (".csv",), "--out") as temporary:
            temporary.write_text("half")
            raise OSError(code, os.strerror(code))

    with pytest.raises(InputError, match="with room to write") as caught:
        full()
    assert caught.value.field == "--out"
    assert os.strerror(code) in str(caught.value)
    assert [p.name for p in tmp_path.iterdir()] == ["a.csv"]
    assert path.read_text() == "old"


def test_a_disk_that_is_found_full_only_as_the_file_is_closed_is_one_line(tmp_path, monkeypatch):
    def full(handle):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(InputError, match="with room to write"):
        write_whole(b"x", tmp_path / "a.csv", (".csv",))
    assert list(tmp_path.iterdir()) == []


def test_the_mask_of_permissions_holds(tmp_path):
    previous = os.umask(0o027)
    try:
        with whole_file(tmp_path / "a.csv", (".csv",)) as temporary:
            temporary.write_text("x")
        assert stat.S_IMODE((tmp_path / "a.csv").stat().st_mode) == 0o640
        assert os.umask(0o027) == 0o027, "and is as it was"
    finally:
        os.umask(previous)


def test_a_path_may_be_text_or_relative_or_in_capitals(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for name in ("a.csv", "./b.csv", "C.CSV"):
        with whole_file(name, (".csv",)) as temporary:
            temporary.write_text("x")
    assert sorted(p.name for p in tmp_path.iterdir()) == ["C.CSV", "a.csv", "b.csv"]


@pytest.mark.parametrize("name", ["a.txt", "a", "a.csv.txt", ".csv"])
def test_a_wrong_suffix_is_refused_with_a_name_that_works(tmp_path, name):
    with pytest.raises(InputError, match=r"\.csv or \.tsv") as caught:
        check_writable(tmp_path / name, (".csv", ".tsv"), "--out")
    assert caught.value.field == "--out"
    check_writable(caught.value.hint, (".csv", ".tsv"))


@pytest.mark.parametrize("name", ["", ".", "..", "/"])
def test_a_path_without_a_name_is_refused(tmp_path, monkeypatch, name):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(InputError) as caught:
        check_writable(name, (".csv",), "--out")
    assert caught.value.field == "--out"


@pytest.mark.parametrize("name", ["missing/a.csv", "missing/deeper/a.csv", "file/a.csv", "folder.csv"])
def test_a_place_that_cannot_be_written_is_refused(tmp_path, name):
    (tmp_path / "file").write_text("a file, no folder")
    (tmp_path / "folder.csv").mkdir()
    before = sorted(tmp_path.iterdir())
    with pytest.raises(InputError) as caught, whole_file(tmp_path / name, (".csv",), "--out"):
        pytest.fail("the work must not begin")
    assert caught.value.field == "--out"
    assert name in str(caught.value.got)
    assert sorted(tmp_path.iterdir()) == before


def test_the_suggestion_for_a_missing_folder_works(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(InputError) as caught:
        check_writable("missing/a.csv", (".csv",))
    command, name = caught.value.hint.split(", or ")
    check_writable(name, (".csv",))
    assert command == "mkdir -p missing"


@pytest.mark.parametrize("name", ["file/a.csv", "folder.csv"])
def test_no_folder_is_suggested_where_none_can_be_made_or_is_missing(tmp_path, monkeypatch, name):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "file").write_text("a file, no folder")
    (tmp_path / "folder.csv").mkdir()
    with pytest.raises(InputError) as caught:
        check_writable(name, (".csv",))
    assert "mkdir" not in caught.value.hint
    check_writable(caught.value.hint, (".csv",))


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="permissions do not bind root")
def test_a_folder_without_permission_is_refused(tmp_path):
    folder = tmp_path / "closed"
    folder.mkdir(mode=0o555)
    with pytest.raises(InputError, match="a file that can be written"):
        check_writable(folder / "a.csv", (".csv",))


def test_a_name_as_long_as_the_file_system_allows(tmp_path):
    longest = os.pathconf(tmp_path, "PC_NAME_MAX")
    path = tmp_path / ("x" * (longest - 4) + ".csv")
    with whole_file(path, (".csv",)) as temporary:
        temporary.write_text("x")
    assert path.read_text() == "x"


def test_a_name_longer_than_the_file_system_allows_is_refused(tmp_path):
    with pytest.raises(InputError) as caught:
        check_writable(tmp_path / ("x" * 1000 + ".csv"), (".csv",), "--out")
    assert caught.value.field == "--out"
