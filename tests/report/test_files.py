"""Files are written whole or not at all."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from catopt.errors import InputError
from catopt.report.files import check_directory, write_files

OLD = {"a.csv": b"old a", "b.csv": b"old b"}
NEW = {"a.csv": b"new a", "b.csv": b"new b"}


def contents(directory: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in directory.iterdir()}


def test_files_are_written_and_replaced(tmp_path: Path) -> None:
    directory = tmp_path / "a" / "b"
    assert write_files(directory, OLD) == (directory / "a.csv", directory / "b.csv")
    assert contents(directory) == OLD
    write_files(directory, NEW)
    assert contents(directory) == NEW


@pytest.mark.parametrize("fails_at", [1, 2])
def test_a_disk_that_fills_leaves_what_was_there(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, fails_at: int
) -> None:
    write_files(tmp_path, OLD)
    calls = []

    def sync(_: int) -> None:
        calls.append(1)
        if len(calls) == fails_at:
            raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", sync)
    with pytest.raises(InputError, match="No space left on device"):
        write_files(tmp_path, NEW)
    assert contents(tmp_path) == OLD


def test_a_file_never_stands_there_half_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Whatever is in the directory while files are written, each name shows old or new, whole."""
    write_files(tmp_path, OLD)
    seen = []
    sync = os.fsync

    def look(descriptor: int) -> None:
        sync(descriptor)
        seen.append({name: (tmp_path / name).read_bytes() for name in OLD})

    monkeypatch.setattr(os, "fsync", look)
    write_files(tmp_path, NEW)
    assert seen == [OLD, OLD]
    assert contents(tmp_path) == NEW


def test_a_directory_in_the_place_of_a_file(tmp_path: Path) -> None:
    (tmp_path / "b.csv").mkdir()
    (tmp_path / "b.csv" / "mine").write_bytes(b"mine")
    with pytest.raises(InputError, match=r"b\.csv"):
        write_files(tmp_path, NEW)
    assert (tmp_path / "b.csv" / "mine").read_bytes() == b"mine"
    assert not [path for path in tmp_path.iterdir() if path.suffix == ".tmp"]


@pytest.mark.parametrize("below", ["", "deeper"])
def test_a_file_in_the_way(tmp_path: Path, below: str) -> None:
    path = tmp_path / "file"
    path.write_bytes(b"mine")
    with pytest.raises(InputError, match="--out"):
        check_directory(path / below)
    assert path.read_bytes() == b"mine"


def test_checking_leaves_nothing_behind(tmp_path: Path) -> None:
    check_directory(tmp_path)
    check_directory(tmp_path / "new" / "deeper")
    assert contents(tmp_path) == {}
    assert not list(tmp_path.iterdir())


@pytest.mark.skipif(
    os.name == "nt" or os.geteuid() == 0, reason="nothing is closed to the superuser"
)
def test_a_directory_that_is_closed(tmp_path: Path) -> None:
    tmp_path.chmod(0o500)
    try:
        with pytest.raises(InputError, match="cannot be written"):
            check_directory(tmp_path)
    finally:
        tmp_path.chmod(0o700)
