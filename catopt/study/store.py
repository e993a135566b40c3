"""What a study reads and keeps: tables of values, and its work on disk."""

from __future__ import annotations

import json
import re
import sqlite3
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from io import StringIO
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final
from weakref import finalize

import numpy as np

from catopt.arrays import Array
from catopt.documents import MOST_BYTES_OF_DATA, read_text
from catopt.errors import InputError, Problem, need_package, refused
from catopt.model.kinds import Kind, Measured, Whole
from catopt.study.member import Base, in_file, kind_of_key
from catopt.study.study import Axis, Study
from catopt.units import as_written, to_si
from catopt.verify.motion_file import few
from catopt.words import Message, Several

if TYPE_CHECKING:
    import pandas as pd

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


_HEADING = re.compile(r"\s*(?P<name>[^()]*?)\s*(\((?P<unit>.*)\))?\s*")


def read_table(base: Base, path: Path, columns: Mapping[str, str], weight: str | None) -> Axis:
    """Read a table as an axis.

    `base`: whose keys vary; `path`: CSV with a row of headings, such as ``load.horizontal_force
    (kN)``; where the headings are parted by semicolons, numbers have a decimal comma; or a Parquet
    file of such columns; `columns`: key by heading, for headings that are no keys; `weight`:
    heading of the column that says what each row counts, such as hours. Raises InputError with
    every heading, and the first cells of each column, that are wrong.
    """
    frame = _read(path)
    problems: list[Problem] = []
    found: dict[str, Any] = {}
    weights: Array | None = None
    for at, head in enumerate(frame.columns):
        match = _HEADING.fullmatch(str(head))
        name, unit = (match["name"], match["unit"] or "") if match else (str(head), "")
        cells = frame.iloc[:, at]
        try:
            if name == weight:
                weights = _weights(cells, name)
                continue
            key = columns.get(name, name)
            if key in found:
                raise refused("headings", f'"{key}"', Message("refused_study.twice"))
            found[key] = _values(_kind(base, key, columns), cells, name, unit)
        except InputError as error:
            problems += error.problems
    known = [str(head).split("(")[0].strip() for head in frame.columns]
    wanted = [("columns", name) for name in columns]
    wanted += [] if weight is None else [("weight", weight)]
    allowed = Message("refused_study.table_has_no_such_heading")
    problems += [Problem(key, f'"{name}"', allowed) for key, name in wanted if name not in known]
    if not problems and not found:
        problems.append(Problem("headings", "", Message("refused_study.none_them_key_varies")))
    if problems:
        raise InputError(problems, str(path))
    return Axis(found, weights)


def _read(path: Path) -> pd.DataFrame:
    frame = _of_parquet(path) if path.suffix.lower() == ".parquet" else _of_csv(path)
    if frame.empty:
        allowed = Message("refused_study.one_row_member_wanted")
        raise refused("table", Message("refused_file.no_rows"), allowed, str(path))
    return frame


def need_parquet() -> None:
    """Refuse Parquet where the package pyarrow is missing; InputError says how to install it."""
    need_package("pyarrow", "tables", "Parquet")


def _of_parquet(path: Path) -> pd.DataFrame:
    import pandas as pd

    need_parquet()
    try:
        return pd.read_parquet(path)
    except (OSError, ValueError) as error:
        raise _no_table(path, error) from None


def _of_csv(path: Path) -> pd.DataFrame:
    import pandas as pd

    text = read_text(path, str(path), kind="table of values", most=MOST_BYTES_OF_DATA)
    is_parted = ";" in text.split("\n", 1)[0]
    try:
        frame: pd.DataFrame = pd.read_csv(
            StringIO(text),
            sep=";" if is_parted else ",",
            decimal="," if is_parted else ".",
            comment="#",
            skipinitialspace=True,
            keep_default_na=False,
        )
    except (pd.errors.ParserError, pd.errors.EmptyDataError) as error:
        raise _no_table(path, error) from None
    return frame


def _no_table(path: Path, error: Exception) -> InputError:
    return refused("table", "", Message("refused_study.no_table", error=error), str(path))


def _kind(base: Base, key: str, columns: Mapping[str, str]) -> Kind:
    try:
        return kind_of_key(base, key)
    except InputError as error:
        allowed: str = error.problems[0].allowed
        if key not in columns.values():
            further = Message("refused_study.name_key_under_columns_or")
            allowed = Several((allowed, further), "")
        raise refused("headings", f'"{key}"', allowed) from None


def _values(kind: Kind, cells: pd.Series[Any], name: str, unit: str) -> Sequence[Any] | Array:
    if isinstance(kind, Measured):
        return in_range(kind, _numbers(cells, name) * _size(kind, name, unit), name)
    if unit:
        raise refused("headings", f'"{name} ({unit})"', Message("refused_study.has_no_unit"))
    as_they_are = isinstance(kind, Whole)
    written = (c if as_they_are or isinstance(c, bool) else str(c) for c in cells.tolist())
    return _read_cells(kind, written, name)


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


def _numbers(cells: pd.Series[Any], name: str) -> Array:
    import pandas as pd

    numbers = pd.to_numeric(cells, errors="coerce").to_numpy(dtype=np.float64)
    wrong = np.flatnonzero(~np.isfinite(numbers))
    _refuse(name, wrong.tolist(), cells, Message("refused.number"))
    return numbers


def _weights(cells: pd.Series[Any], name: str) -> Array:
    weights = _numbers(cells, name)
    _refuse(
        name, np.flatnonzero(weights < 0.0).tolist(), cells, Message("refused.or_more", bound="0")
    )
    if not weights.sum() > 0.0:
        raise refused(
            name,
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


def _refuse(name: str, rows: Sequence[int], cells: pd.Series[Any], allowed: Message) -> None:
    found = [
        Problem(f"{name}, value {row + 1}", as_written(cells.iloc[row]), allowed) for row in rows
    ]
    if found:
        raise InputError(few(found, "table"))
