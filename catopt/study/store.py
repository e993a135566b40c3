"""What a study has computed, piece by piece, in a file that survives being killed at any moment."""

from __future__ import annotations

import json
import sqlite3
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Final
from weakref import finalize

import numpy as np

from catopt.arrays import Array
from catopt.errors import InputError, Problem
from catopt.study.study import Study
from catopt.words import Message

STORE: Final = "study.sqlite"
"""Name of the file within the directory of a study."""

_TABLES = """
CREATE TABLE IF NOT EXISTS study (digest TEXT NOT NULL, members INTEGER NOT NULL);
CREATE TABLE IF NOT EXISTS pieces (
    number INTEGER PRIMARY KEY, numbers BLOB NOT NULL, words TEXT NOT NULL, reasons TEXT NOT NULL
);
"""


@dataclass(frozen=True, eq=False)
class Computed:
    """What came of the members of a piece.

    `number`: of the piece, from 0; `numbers` (members, quantities): in SI, nan where there is none;
    in the order of what is kept; `words`: texts, by member; `reasons`: why there is no answer, by
    member within the piece.
    """

    number: int
    numbers: Array
    words: tuple[tuple[str, ...], ...]
    reasons: dict[int, str]


class Store:
    """Pieces of one study, each written whole or not at all.

    `directory`: where they are kept; in memory when left out; `close` closes the file. Raises
    InputError where the directory has the pieces of another study, and whenever the file cannot be
    written or read: what was computed by then is kept.
    """

    def __init__(self, study: Study, directory: Path | None = None) -> None:
        self._study = study
        self._file = ":memory:" if directory is None else str(directory / STORE)
        with self._told():
            if directory is not None:
                directory.mkdir(parents=True, exist_ok=True)
            self._database = sqlite3.connect(self._file, check_same_thread=False)
            self.close = finalize(self, self._database.close)  # at once, or when nobody needs it
            try:
                self._database.executescript(_TABLES)
                self._check()
            except BaseException:
                self.close()
                raise

    @contextmanager
    def _told(self) -> Iterator[None]:
        """Refuse in words what the file or its disk does not do: full, held, damaged, gone."""
        try:
            yield
        except sqlite3.OperationalError as error:
            way = Message("refused_study.and_kept", error=error)
            raise InputError([Problem("--out", self._file, way)], "options") from error
        except (OSError, sqlite3.Error) as error:
            way = Message("refused_study.and_anew", error=error)
            raise InputError([Problem("--out", self._file, way)], "options") from error

    def _check(self) -> None:
        wanted = (self._study.digest, len(self._study))
        found = self._database.execute("SELECT digest, members FROM study").fetchone()
        if found is None:
            with self._database:
                self._database.execute("INSERT INTO study VALUES (?, ?)", wanted)
        elif tuple(found) != wanted:
            allowed = Message("refused_study.holds_another_study_or_this")
            self.close()
            raise InputError([Problem("--out", self._file, allowed)], "options")

    def done(self) -> set[int]:
        """Return the numbers of the pieces that are there."""
        with self._told():
            return {number for (number,) in self._database.execute("SELECT number FROM pieces")}

    def put(self, found: Computed) -> None:
        """Write a piece."""
        row = (
            found.number,
            np.ascontiguousarray(found.numbers, dtype="<f8").tobytes(),
            json.dumps(found.words, ensure_ascii=False),
            json.dumps({str(k): v for k, v in sorted(found.reasons.items())}, ensure_ascii=False),
        )
        with self._told(), self._database:
            self._database.execute("INSERT OR REPLACE INTO pieces VALUES (?, ?, ?, ?)", row)

    def pieces(self) -> Iterator[Computed]:
        """Yield the pieces that are there, by number; a damaged one is taken out and told."""
        with self._told():
            rows = self._database.execute("SELECT * FROM pieces ORDER BY number")
            for number, *row in rows:
                try:
                    piece = self._read(number, *row)
                except (TypeError, ValueError, AttributeError) as error:
                    with self._database:
                        self._database.execute("DELETE FROM pieces WHERE number = ?", (number,))
                    allowed = Message("refused_study.piece_was_damaged_taken_out", number=number)
                    raise InputError([Problem("--out", self._file, allowed)], "options") from error
                yield piece

    def _read(self, number: int, numbers: bytes, words: str, reasons: str) -> Computed:
        """Read a piece; ValueError where it has not the members and quantities of its study."""
        kept, start = self._study.base.kept, self._study.piece_start
        members, width = start(number + 1) - start(number), sum(1 for e in kept if e.quantity)
        texts = tuple(tuple(each) for each in json.loads(words))
        why = {int(k): str(v) for k, v in json.loads(reasons).items()}
        if len(texts) not in (0, members) or any(not 0 <= k < members for k in why):
            raise ValueError(number)
        values = np.frombuffer(numbers, dtype="<f8").reshape(members, width)
        return Computed(number, values, texts, why)

    def _placed(self) -> Iterator[tuple[int, Computed]]:
        return ((self._study.piece_start(each.number), each) for each in self.pieces())

    def column(self, at: int) -> Array:
        """Return the numbers of one quantity of all members, nan of those not computed yet."""
        column = np.full(len(self._study), np.nan)
        for first, piece in self._placed():
            column[first : first + len(piece.numbers)] = piece.numbers[:, at]
        return column

    def reasons(self) -> dict[int, str]:
        """Return why members have no answer, by their numbers from 0."""
        found: dict[int, str] = {}
        for first, piece in self._placed():
            found |= {first + member: reason for member, reason in piece.reasons.items()}
        return found

    def words(self, members: Sequence[int]) -> list[tuple[str, ...]]:
        """Return the texts of some members."""
        wanted: dict[int, tuple[str, ...]] = {}
        for first, piece in self._placed():
            wanted |= {first + k: words for k, words in enumerate(piece.words)}
        return [wanted.get(member, ()) for member in members]
