"""Tables of values for a study: CSV, a column a key, a row a member."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from io import StringIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from catopt.arrays import Array
from catopt.documents import MOST_BYTES_OF_DATA, read_text
from catopt.errors import InputError, Problem, need_package
from catopt.model.kinds import Kind, Measured, Whole
from catopt.study.base import Base
from catopt.study.member import in_file, kind_of_key
from catopt.study.study import Axis
from catopt.units import as_written, to_si
from catopt.verify.motion_file import few
from catopt.words import Message, Several

if TYPE_CHECKING:
    import pandas as pd

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
                raise InputError([Problem("headings", f'"{key}"', Message("refused_study.twice"))])
            found[key] = _values(_kind(base, key, columns), cells, name, unit)
        except InputError as error:
            problems += error.problems
    known = [str(head).split("(")[0].strip() for head in frame.columns]
    for name in columns:
        if name not in known:
            problems.append(
                Problem("columns", f'"{name}"', Message("refused_study.table_has_no_such_heading"))
            )
    if weight is not None and weight not in known:
        problems.append(
            Problem("weight", f'"{weight}"', Message("refused_study.table_has_no_such_heading"))
        )
    if not problems and not found:
        problems.append(Problem("headings", "", Message("refused_study.none_them_key_varies")))
    if problems:
        raise InputError(problems, str(path))
    return Axis(found, weights)


def _read(path: Path) -> pd.DataFrame:
    frame = _of_parquet(path) if path.suffix.lower() == ".parquet" else _of_csv(path)
    if frame.empty:
        raise InputError(
            [
                Problem(
                    "table",
                    Message("refused_file.no_rows"),
                    Message("refused_study.one_row_member_wanted"),
                )
            ],
            str(path),
        )
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
        raise InputError(
            [Problem("table", "", Message("refused_study.no_table", error=error))], str(path)
        ) from None


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
        raise InputError(
            [Problem("table", "", Message("refused_study.no_table", error=error))], str(path)
        ) from None
    return frame


def _kind(base: Base, key: str, columns: Mapping[str, str]) -> Kind:
    try:
        return kind_of_key(base, key)
    except InputError as error:
        (problem,) = error.problems
        wanted = problem.allowed
        if key not in columns.values():
            further = Message("refused_study.name_key_under_columns_or")
            wanted = Several((wanted, further), "")
        raise InputError([Problem("headings", f'"{key}"', wanted)]) from None


def _values(kind: Kind, cells: pd.Series[Any], name: str, unit: str) -> Sequence[Any] | Array:
    if isinstance(kind, Measured):
        return in_range(kind, _numbers(cells, name) * _size(kind, name, unit), name)
    if unit:
        raise InputError(
            [Problem("headings", f'"{name} ({unit})"', Message("refused_study.has_no_unit"))]
        )
    as_they_are = isinstance(kind, Whole)
    written = (c if as_they_are or isinstance(c, bool) else str(c) for c in cells.tolist())
    return _read_each(kind, written, name)


def _size(kind: Measured, name: str, unit: str) -> float:
    """SI units in one of the unit that a heading names."""
    dimension = kind.dimension
    if not unit and dimension.si_unit:
        wanted = Message(
            "refused_study.unit_brackets_wanted_such", name=name, si_unit=dimension.si_unit
        )
        raise InputError([Problem("headings", f'"{name}"', wanted)])
    if unit in ("", "-"):
        return 1.0
    try:
        return to_si(f"1 {unit}", dimension)
    except InputError as error:
        found = f'"{name} ({unit})"'
        raise InputError([Problem("headings", found, error.problems[0].allowed)]) from None


def _numbers(cells: pd.Series[Any], name: str) -> Array:
    import pandas as pd

    numbers = pd.to_numeric(cells, errors="coerce").to_numpy(dtype=np.float64)
    wrong = np.flatnonzero(~np.isfinite(numbers))
    _refuse(name, wrong.tolist(), cells, "a number is wanted")
    return numbers


def _weights(cells: pd.Series[Any], name: str) -> Array:
    weights = _numbers(cells, name)
    _refuse(name, np.flatnonzero(weights < 0.0).tolist(), cells, "must be 0 or more")
    if not weights.sum() > 0.0:
        raise InputError(
            [Problem(name, "all 0", Message("refused_study.what_each_row_counts_wanted"))]
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
        _read_each(kind, (in_file(kind, value) for value in values.tolist()), name)
    return values


def _read_each(kind: Kind, cells: Iterable[Any], name: str) -> list[Any]:
    """Read cells as the key takes them; the first that it does not take are told."""
    found, problems = [], []
    for row, cell in enumerate(cells):
        try:
            found.append(kind.read(cell))
        except InputError as error:
            problems += [replace(p, key=f"{name}, value {row + 1}") for p in error.problems]
    if problems:
        raise InputError(few(problems, "table"))
    return found


def _refuse(name: str, rows: Sequence[int], cells: pd.Series[Any], allowed: str) -> None:
    if rows:
        found = [
            Problem(f"{name}, value {row + 1}", as_written(cells.iloc[row]), allowed)
            for row in rows
        ]
        raise InputError(few(found, "table"))
