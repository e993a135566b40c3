"""What a study reads and keeps: tables of values, and its work on disk."""

from __future__ import annotations

import json
import math
import re
import sqlite3
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Final, NamedTuple
from weakref import finalize

import numpy as np

from catopt.arrays import Array, Flags
from catopt.errors import InputError, Problem, need_package, refused
from catopt.model.kinds import Flag, Kind, Measured, Whole
from catopt.study.member import Base, in_file, kind_of_key
from catopt.study.study import Axis, Study
from catopt.tables import FLAGS, few, heading, number, read_sheet, rows_read
from catopt.units import as_written, to_si
from catopt.words import Message, Several

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
        with self._reported():
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
    def _reported(self) -> Iterator[None]:
        """Refuse in words what the file or its disk does not do: full, held, damaged, gone."""
        try:
            yield
        except (OSError, sqlite3.Error) as error:
            is_whole = isinstance(error, sqlite3.OperationalError)
            key = "refused_study.and_kept" if is_whole else "refused_study.and_anew"
            raise self._refused(Message(key, error=error)) from error

    def _refused(self, allowed: Message) -> InputError:
        return refused("--out", self._file, allowed, "options")

    def _check(self) -> None:
        wanted = (self._study.digest, len(self._study))
        found = self._database.execute("SELECT digest, members FROM study").fetchone()
        if found is None:
            with self._database:
                self._database.execute("INSERT INTO study VALUES (?, ?)", wanted)
        elif tuple(found) != wanted:
            self.close()
            raise self._refused(Message("refused_study.holds_another_study_or_this"))

    def done(self) -> set[int]:
        """Return the numbers of the pieces that are there."""
        with self._reported():
            return {number for (number,) in self._database.execute("SELECT number FROM pieces")}

    def put(self, found: Computed) -> None:
        """Write a piece."""
        row = (
            found.number,
            np.ascontiguousarray(found.numbers, dtype="<f8").tobytes(),
            json.dumps(found.words, ensure_ascii=False),
            json.dumps({str(k): v for k, v in sorted(found.reasons.items())}, ensure_ascii=False),
        )
        with self._reported(), self._database:
            self._database.execute("INSERT OR REPLACE INTO pieces VALUES (?, ?, ?, ?)", row)

    def pieces(self) -> Iterator[Computed]:
        """Yield the pieces that are there, by number; a damaged one is taken out and told."""
        with self._reported():
            rows = self._database.execute("SELECT * FROM pieces ORDER BY number")
            for number, *row in rows:
                try:
                    piece = self._read(number, *row)
                except (TypeError, ValueError, AttributeError) as error:
                    with self._database:
                        self._database.execute("DELETE FROM pieces WHERE number = ?", (number,))
                    allowed = Message("refused_study.piece_was_damaged_taken_out", number=number)
                    raise self._refused(allowed) from error
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
            wanted |= dict(enumerate(piece.words, start=first))
        return [wanted.get(member, ()) for member in members]


_OF_TABLES: Final = (".csv", ".parquet")


def read_table(base: Base, path: Path, columns: Mapping[str, str], weight: str | None) -> Axis:
    """Read a table as an axis.

    `base`: whose keys vary; `path`: CSV with a row of headings, such as ``load.horizontal_force
    (kN)``; where the headings are parted by semicolons, numbers have a decimal comma; or a Parquet
    file of such columns; `columns`: key by heading, for headings that are no keys; `weight`:
    heading of the column that says what each row counts, such as hours. Raises InputError with
    every heading, and the first cells of each column, that are wrong.
    """
    is_parquet = path.suffix.lower() == ".parquet"
    table, skipped = (_of_parquet(path), 0) if is_parquet else _of_csv(path)
    problems: list[Problem] = []
    found: dict[str, Any] = {}
    weights: Array | None = None
    for column in table:
        try:
            if column.name == weight:
                weights = _weights(column)
                continue
            key = columns.get(column.name, column.name)
            if key in found:
                raise refused("headings", f'"{key}"', Message("refused_study.twice"))
            found[key] = _values(_kind(base, key, columns), column)
        except InputError as error:
            problems += error.problems
    known = [column.name for column in table]
    wanted = [("columns", name) for name in columns]
    wanted += [] if weight is None else [("weight", weight)]
    allowed = Message("refused_study.table_has_no_such_heading")
    problems += [Problem(key, f'"{name}"', allowed) for key, name in wanted if name not in known]
    if not found and path.suffix.lower() not in _OF_TABLES:
        problems = []  # any file, named by mistake, whose words are not told
    if not problems and not found:
        problems.append(Problem("headings", "", Message("refused_study.none_them_key_varies")))
    if problems:
        raise InputError(problems, str(path))
    counted = rows_read(path.name, len(table[0].cells), skipped)
    return Axis(found, weights, counted=counted)


class _Cells(NamedTuple):
    """A column of a table: its heading in two parts, and what stands below it."""

    name: str
    unit: str
    cells: Sequence[Any]
    is_decimal_comma: bool = False

    @property
    def numbers(self) -> Array:
        """The cells as numbers; InputError with the first that are none."""
        values = np.array([self._number(cell) for cell in self.cells])
        self.refuse(np.isnan(values), Message("refused.number"))
        return values

    def _number(self, cell: object) -> float:
        if isinstance(cell, str):
            return number(cell, is_decimal_comma=self.is_decimal_comma)
        if isinstance(cell, int | float) and not isinstance(cell, bool) and math.isfinite(cell):
            return float(cell)
        return math.nan

    def refuse(self, wrong: Flags, allowed: Message) -> None:
        """Raise InputError with the first cells of those that are wrong."""
        rows = np.flatnonzero(wrong).tolist()
        place = f"{self.name}, value"
        found = [Problem(f"{place} {k + 1}", as_written(self.cells[k]), allowed) for k in rows]
        if found:
            raise InputError(few(found, "table"))


def need_parquet() -> None:
    """Refuse Parquet where the package pyarrow is missing; InputError says how to install it."""
    need_package("pyarrow", "tables", "Parquet")


def _of_parquet(path: Path) -> list[_Cells]:
    import pandas as pd

    need_parquet()
    try:
        frame = pd.read_parquet(path)
    except (OSError, ValueError) as error:
        allowed = Message("refused_study.no_table", error=error)
        raise refused("table", "", allowed, str(path)) from None
    if frame.empty:
        allowed = Message("refused_study.one_row_member_wanted")
        raise refused("table", Message("refused_file.no_rows"), allowed, str(path))
    heads = [heading(str(head)) for head in frame.columns]
    return [_Cells(*head, frame.iloc[:, k].tolist()) for k, head in enumerate(heads)]


def _of_csv(path: Path) -> tuple[list[_Cells], int]:
    """Read a text; returns its columns, and how many lines were passed over."""
    sheet = read_sheet(path, str(path), kind="table of values")
    columns = zip(*(row.cells for row in sheet.rows), strict=True)
    heads = [heading(head) for head in sheet.headings]
    table = [
        _Cells(*head, cells, sheet.is_decimal_comma)
        for head, cells in zip(heads, columns, strict=True)
    ]
    return table, sheet.skipped


def _kind(base: Base, key: str, columns: Mapping[str, str]) -> Kind:
    try:
        return kind_of_key(base, key)
    except InputError as error:
        allowed: str = error.problems[0].allowed
        if key not in columns.values():
            further = Message("refused_study.name_key_under_columns_or")
            allowed = Several((allowed, further), "")
        raise refused("headings", f'"{key}"', allowed) from None


def _values(kind: Kind, column: _Cells) -> Sequence[Any] | Array:
    name, unit, cells, _ = column
    if isinstance(kind, Measured):
        return in_range(kind, column.numbers * _size(kind, name, unit), name)
    if unit:
        raise refused("headings", f'"{name} ({unit})"', Message("refused_study.has_no_unit"))
    return _read_cells(kind, (_as_in_file(kind, cell) for cell in cells), name)


def _as_in_file(kind: Kind, cell: Any) -> Any:
    """Return what a case file would have for a cell: words as they stand, counts and flags."""
    if isinstance(cell, bool) or (isinstance(kind, Whole) and not isinstance(cell, str)):
        return cell
    text = str(cell).strip()
    if isinstance(kind, Whole) and _WHOLE.fullmatch(text):
        return int(text)
    return FLAGS.get(text.casefold(), text) if isinstance(kind, Flag) else text


_WHOLE: Final = re.compile(r"[+-]?\d{1,20}", re.ASCII)


def _size(kind: Measured, name: str, unit: str) -> float:
    """SI units in one of the unit that a heading names."""
    dimension = kind.dimension
    if not unit and dimension.si_unit:
        key = "refused_study.unit_brackets_wanted_such"
        wanted = Message(key, name=name, si_unit=dimension.si_unit)
        raise refused("headings", f'"{name}"', wanted)
    if unit in ("", "-"):
        return 1.0
    try:
        return to_si(f"1 {unit}", dimension)
    except InputError as error:
        allowed = error.problems[0].allowed
        raise refused("headings", f'"{name} ({unit})"', allowed) from None


def _weights(column: _Cells) -> Array:
    weights = column.numbers
    column.refuse(weights < 0.0, Message("refused.or_more", bound="0"))
    if not weights.sum() > 0.0:
        raise refused(
            column.name,
            Message("refused_study.all_0"),
            Message("refused_study.what_each_row_counts_wanted"),
        )
    return weights


def in_range(kind: Measured, values: Array, name: str) -> Array:
    """Return values in SI that a key takes; all that are out of its range are told."""
    sizes = np.abs(values[values != 0.0])
    ends = [values.min(), values.max(), *([sizes.min()] if sizes.size else [])]
    try:
        for end in ends:
            kind.read(in_file(kind, float(end)))
    except InputError:
        _read_cells(kind, (in_file(kind, value) for value in values.tolist()), name)
    return values


def _read_cells(kind: Kind, cells: Iterable[Any], name: str) -> list[Any]:
    """Read cells as the key takes them; the first that it does not take are told."""
    found, problems = read_each(kind, cells, lambda row: f"{name}, value {row + 1}")
    if problems:
        raise InputError(few(problems, "table"))
    return found


def read_each(
    kind: Kind, values: Iterable[Any], place: Callable[[int], str]
) -> tuple[list[Any], list[Problem]]:
    """Read values as their key takes them; `place` names them by their number, from 0."""
    found, problems = [], []
    for at, value in enumerate(values):
        try:
            found.append(kind.read(value))
        except InputError as error:
            problems += [replace(each, key=place(at)) for each in error.problems]
    return found, problems
