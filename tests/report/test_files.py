"""Files are written whole or not at all."""

from __future__ import annotations

import json
import os
import signal
from hashlib import sha256
from pathlib import Path

import pytest

from catopt.errors import InputError
from catopt.report.bundle import check_directory, write_files

OLD = {"a.csv": b"old a", "b.csv": b"old b"}
NEW = {"a.csv": b"new a", "b.csv": b"new b"}


def contents(directory: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in directory.iterdir()}


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


def test_files_are_written_and_replaced_and_never_stand_there_half_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Whatever is in the directory while files are written, each name shows old or new, whole."""
    directory = tmp_path / "a" / "b"
    assert write_files(directory, OLD) == (directory / "a.csv", directory / "b.csv")
    assert contents(directory) == OLD
    seen = []
    sync = os.fsync

    def look(descriptor: int) -> None:
        sync(descriptor)
        seen.append({name: (directory / name).read_bytes() for name in OLD})

    monkeypatch.setattr(os, "fsync", look)
    write_files(directory, NEW)
    assert seen == [OLD, OLD]
    assert contents(directory) == NEW


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


# ------------------------------------------------------------------ one answer


CASE = b'title = "one"\n'
OTHER = b'title = "another"\n'
DOCUMENT = b'{\n  "schema": "catopt.solution/1",\n  "title": ""\n}\n'


def answer(case: bytes) -> dict[str, bytes]:
    return {"solution.json": DOCUMENT, "case.toml": case, "summary.csv": case}


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_waits_until_all_files_have_their_place(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, number: signal.Signals
) -> None:
    write_files(tmp_path, answer(CASE))
    before = signal.getsignal(number)
    replace, moved = Path.replace, []

    def interrupted(self: Path, target: Path) -> Path:
        moved.append(target.name)
        if len(moved) <= 2:  # pressed twice, by somebody in a hurry
            signal.raise_signal(number)
        return replace(self, target)

    def stop(number: int, _: object) -> None:
        raise KeyboardInterrupt(number)

    monkeypatch.setattr(Path, "replace", interrupted)
    signal.signal(number, stop)
    try:
        with pytest.raises(KeyboardInterrupt):
            write_files(tmp_path, answer(OTHER))
        assert signal.getsignal(number) is stop
    finally:
        signal.signal(number, before)
    assert moved == ["case.toml", "summary.csv", "solution.json"]
    found = contents(tmp_path)
    assert found["case.toml"] == found["summary.csv"] == OTHER
    assert sha256(OTHER).hexdigest().encode() in found["solution.json"]


def test_files_that_a_killed_run_left_are_swept(tmp_path: Path) -> None:
    stale, fresh, own = (tmp_path / name for name in (".a.csv.17.tmp", ".b.csv.18.tmp", ".my.tmp"))
    for place in (stale, fresh, own):
        place.write_bytes(b"half")
    for place in (stale, own):
        os.utime(place, (0.0, 0.0))
    write_files(tmp_path, OLD)
    assert [place.exists() for place in (stale, fresh, own)] == [False, True, True]


def test_a_document_carries_the_digest_of_its_case_and_nothing_else_does(tmp_path: Path) -> None:
    foreign = b'{\n  "schema": "other/1"\n}\n'
    write_files(tmp_path, answer(CASE) | {"other.json": foreign})
    found = json.loads((tmp_path / "solution.json").read_text("utf-8"))
    assert list(found) == ["schema", "case_sha256", "title"]
    assert found["case_sha256"] == sha256(CASE).hexdigest()
    assert (tmp_path / "other.json").read_bytes() == foreign
    write_files(tmp_path / "none", {"solution.json": DOCUMENT})
    assert (tmp_path / "none" / "solution.json").read_bytes() == DOCUMENT
