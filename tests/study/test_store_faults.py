"""A store whose disk is full, that another program holds, or that is damaged: told, and gone on."""

from __future__ import annotations

import sqlite3
from pathlib import Path

import pytest

from catopt.errors import InputError
from catopt.study.file import read_study
from catopt.study.run import run_into
from catopt.study.store import STORE, Store
from catopt.study.study import Study
from tests.study.test_reliability import CASE, FORCE

PIECES = 4
MEMBERS = 40 * PIECES


@pytest.fixture
def study(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Study:
    """160 members in 4 pieces, of a line that is solved in bulk."""
    monkeypatch.setattr("catopt.study.study.PIECE", {"statics": MEMBERS // PIECES})
    case = CASE.replace("[[line", "[line]\n\n[[line", 1)
    (tmp_path / "case.toml").write_text(case, encoding="utf-8")
    head = f'case = "case.toml"\ncompute = "statics"\nsamples = {MEMBERS}\n[[vary]]\n'
    (tmp_path / "study.toml").write_text(head + FORCE.format(kind="normal"), encoding="utf-8")
    return read_study(tmp_path / "study.toml")


def rows_of(store: Store) -> list[tuple[object, ...]]:
    return list(store._database.execute("SELECT * FROM pieces ORDER BY number"))


@pytest.fixture
def whole(study: Study) -> list[tuple[object, ...]]:
    """Run it where nothing fails."""
    store = Store(study)
    run_into(study, store)
    return rows_of(store)


def test_a_full_disk_is_told_and_gone_on_from(
    study: Study, whole: list[tuple[object, ...]], tmp_path: Path
) -> None:
    store = Store(study, tmp_path / "out")
    (pages,) = store._database.execute("PRAGMA page_count").fetchone()
    store._database.execute(f"PRAGMA max_page_count = {pages + 1}")
    with pytest.raises(InputError, match=r"disk is full.*are kept"):
        run_into(study, store)
    assert 0 < len(store.done()) < PIECES
    store.close()
    again = Store(study, tmp_path / "out")
    run_into(study, again)
    assert rows_of(again) == whole


def test_a_file_that_another_program_holds(
    study: Study, whole: list[tuple[object, ...]], tmp_path: Path
) -> None:
    store = Store(study, tmp_path / "out")
    store._database.execute("PRAGMA busy_timeout = 10")
    other = sqlite3.connect(tmp_path / "out" / STORE)
    other.execute("BEGIN EXCLUSIVE")
    with pytest.raises(InputError, match="locked"):
        run_into(study, store)
    other.rollback()
    other.close()
    run_into(study, store)
    assert rows_of(store) == whole


@pytest.mark.parametrize(
    "harm",
    ["numbers = x'0011'", "words = '[['", "reasons = '[]'",
     "reasons = '{\"900\": \"\"}'"],
)  # fmt: skip
def test_a_damaged_piece_is_taken_out_and_computed_anew(
    study: Study, whole: list[tuple[object, ...]], tmp_path: Path, harm: str
) -> None:
    store = Store(study, tmp_path / "out")
    run_into(study, store)
    with store._database:
        store._database.execute(f"UPDATE pieces SET {harm} WHERE number = 2")
    with pytest.raises(InputError, match="piece 2 was damaged"):
        list(store.pieces())
    run_into(study, store)
    assert rows_of(store) == whole


def test_a_file_that_is_no_store(study: Study, tmp_path: Path) -> None:
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / STORE).write_bytes(b"no database" * 1000)
    with pytest.raises(InputError, match=r"not a database.*delete the file"):
        Store(study, tmp_path / "out")
