"""Reads tables of numbers and words: rows, headings with units, cells; one gate for all of them.

A row of headings comes first, each a name with its unit in brackets: ``x (cm)``, ``Fx [kN]``.
Lines above it that begin with ``#`` are comments. Below it such a line is a row like any other,
unless it has no separator where the headings have one.
"""

from __future__ import annotations

import csv
import math
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Final, NamedTuple

from catopt.dimensions import UNITS, Dimension
from catopt.documents import MOST_BYTES_OF_DATA, read_text
from catopt.errors import InputError, Problem, refused
from catopt.units import as_written, implausible, readings, to_si
from catopt.words import Message

MOST_CELLS: Final = 3_000_000
"""Of a table: three hours at 50 rows a second have 2.2 million."""
SHOWN: Final = 10
"""Faulty cells that are told of one table."""
_BRACKETS: Final = {")": "(", "]": "["}


FLAGS: Final[Mapping[str, bool]] = MappingProxyType(
    {
        **dict.fromkeys(("true", "yes", "có"), True),
        **dict.fromkeys(("false", "no", "không"), False),
    }
)
"""Words of a cell that say yes or no, in small letters."""


class Row(NamedTuple):
    """A row of cells, with its line in the file."""

    line: int
    cells: list[str]


@dataclass(frozen=True)
class Sheet:
    """What stands in a table.

    `headings`: as they stand; `rows`: below them; `skipped`: how many comments are among them;
    `is_decimal_comma`: whether the headings are parted by semicolons, so that numbers may have
    decimal commas; `broken`: lines that are no rows of it, each with what is wrong, which whoever
    reads the cells tells with what is wrong in those.
    """

    path: str
    headings: tuple[str, ...]
    rows: tuple[Row, ...]
    skipped: int
    is_decimal_comma: bool
    broken: tuple[tuple[int, Problem], ...] = ()

    def refuse(self, found: Iterable[tuple[int, Problem]] = ()) -> None:
        """Raise InputError with what is wrong in its lines, and in cells of its rows, in order."""
        every = sorted((*self.broken, *found), key=lambda each: each[0])
        if every:
            raise InputError(few([problem for _, problem in every]), self.path)


@dataclass(frozen=True)
class Column:
    """What a column may have: numbers of a dimension, or in units of its own with their sizes.

    `bare`: SI units in one of the unit of a heading without brackets; 0 where it has to name one.
    `most`: largest size of a number in SI; that of the dimension when left out.
    """

    dimension: Dimension = Dimension.NUMBER
    units: Mapping[str, float] | None = None
    bare: float = 0.0
    most: float = 0.0

    def size(self, unit: str) -> float:
        """SI units in one of a unit, which is empty for none; nan for what is no such unit."""
        if not unit:
            return self.bare or (self.units or {}).get("", math.nan)
        if self.units is not None:
            return self.units.get(unit, math.nan)
        if unit == "-" and self.dimension is Dimension.NUMBER:
            return 1.0
        try:
            return to_si(f"1 {unit}", self.dimension)
        except InputError:
            return math.nan

    @property
    def wanted(self) -> Message:
        """Say which units there are."""
        own = UNITS[self.dimension] if self.units is None else self.units
        pure = ["-"] if self.units is None and self.dimension is Dimension.NUMBER else []
        names = ", ".join([*pure, *filter(None, own)])
        return Message("refused_motion.unit_brackets_wanted_one", value=names)


def read_sheet(
    path: Path, source: str, *, kind: str = "table of numbers", keeps_broken: bool = False
) -> Sheet:
    """Read a text file as a table; every line of it is a heading, a row, a comment or blank.

    `keeps_broken`: lines that are no rows are told with what is wrong in the cells of the others,
    by `Sheet.refuse`. InputError for a file that cannot be read, has more cells than any or no row
    below its headings and, without that, for such a line.
    """
    text = read_text(path, source, kind=kind, most=MOST_BYTES_OF_DATA)
    lines = text.replace("\r\n", "\n").replace("\r", "\n").split("\n")
    cells = text.count(",") + text.count(";") + len(lines)
    if cells > MOST_CELLS:
        allowed = Message("refused_table.most_cells", most=MOST_CELLS)
        raise refused("file", Message("refused_table.cells_of", count=cells), allowed, source)
    rows: list[Row] = []
    broken: list[tuple[int, Problem]] = []
    skipped, mark = 0, ","
    for number, line in enumerate(lines, start=1):
        is_comment = line.lstrip().startswith("#")
        if is_comment and (not rows or (mark not in line and len(rows[0].cells) > 1)):
            skipped += bool(rows)
            continue
        if not rows:
            mark = ";" if ";" in line else ","
        if not line.strip(f"{mark} \t"):
            continue
        try:
            found = next(csv.reader([line], delimiter=mark, skipinitialspace=True, strict=True))
        except csv.Error as error:
            said = Message("refused_motion.no_table_of_numbers", error=f"{error}")
            broken.append((number, Problem(f"line {number}", "", said)))
            continue
        if rows and len(found) != len(rows[0].cells):
            wanted = Message("refused_motion.are_wanted", heads=len(rows[0].cells))
            count = Message("refused_motion.cells", count=len(found))
            broken.append((number, Problem(f"line {number}", count, wanted)))
            continue
        rows.append(Row(number, found))
    if not broken and len(rows) < 2:
        wanted = Message("refused_motion.headings_and_rows")
        broken.append((0, Problem("rows", f"{len(rows)}", wanted)))
    headings = tuple(rows[0].cells) if rows else ()
    sheet = Sheet(source, headings, tuple(rows[1:]), skipped, mark == ";", tuple(broken))
    if len(rows) < 2 or not keeps_broken:
        sheet.refuse()
    return sheet


def heading(cell: str) -> tuple[str, str]:
    """Part a heading into its name and its unit, which is empty where none is in brackets.

    Examples
    --------
    >>> heading("x (cm)"), heading("Fx [kN]"), heading("share"), heading("x (m) y")
    (('x', 'cm'), ('Fx', 'kN'), ('share', ''), ('x (m) y', ''))
    """
    text = cell.strip()
    opening = _BRACKETS.get(text[-1:], "")
    name, found, unit = text.rpartition(opening) if opening else (text, "", "")
    return (name.strip(), unit[:-1].strip()) if found else (text, "")


def number(cell: str, *, is_decimal_comma: bool = False) -> float:
    """Read a number of a cell: digits as a file of catopt has them; nan for what is none.

    Examples
    --------
    >>> number("1e3"), number("1_0"), number("8,5", is_decimal_comma=True), number("")
    (1000.0, nan, 8.5, nan)
    """
    if is_decimal_comma:
        cell = cell.strip()
        found = readings(cell)
        if "," in cell and len(found) == 2:
            found = found[:1]  # a decimal comma, as the headings say
        return float(found[0]) if len(found) == 1 else math.nan
    try:
        value = float(cell)
    except ValueError:
        return math.nan
    return value if cell.isascii() and "_" not in cell and math.isfinite(value) else math.nan


def rows_read(name: str, count: int, skipped: int) -> Message:
    """Say how many rows of a table were read, and how many lines below its headings were not."""
    return Message("refused_table.rows_read", name=name, count=count, skipped=skipped)


def units_of(
    sheet: Sheet,
    names: Sequence[str],
    known: Mapping[str, Column | None],
    *,
    needed: Sequence[str],
    some_of: Sequence[str] = (),
) -> list[float]:
    """Return how many SI units one of each column's unit is; 1 for a column of text, None.

    `names`: of the columns, by their headings; the rest as for `read_numbers`. InputError for
    headings that are unknown, missing or there twice, and units that are none.
    """
    problems = list(_of_headings(sheet.headings, names, known, needed, some_of or needed))
    sizes = [1.0] * len(names)
    for k, (name, cell) in enumerate(zip(names, sheet.headings, strict=True)):
        column = known.get(name)
        if column is not None:
            sizes[k] = column.size(heading(cell)[1])
            if math.isnan(sizes[k]):
                problems.append(Problem("headings", as_text(cell), column.wanted))
    if problems:
        raise InputError(problems, sheet.path)
    return sizes


def read_numbers(
    sheet: Sheet, known: Mapping[str, Column], *, needed: Sequence[str], some_of: Sequence[str] = ()
) -> dict[str, list[float]]:
    """Read a table of numbers by its headings, in SI; every problem at once.

    `known`: columns that may be there, by the names of their headings in small letters; `needed`,
    `some_of`: those that have to be there, and of which one at least has to, else of the needed.
    InputError for wrong headings, cells that are no numbers, and numbers beyond what is plausible.
    """
    names = [heading(cell)[0].casefold() for cell in sheet.headings]
    sizes = units_of(sheet, names, known, needed=needed, some_of=some_of)
    columns: list[list[float]] = [[] for _ in names]
    wrong: list[tuple[int, Problem]] = []
    for row in sheet.rows:
        for k, cell in enumerate(row.cells):
            value = number(cell, is_decimal_comma=sheet.is_decimal_comma) * sizes[k]
            columns[k].append(value)
            column = known[names[k]]
            # One test passes nearly all: nan is not below anything.
            if not abs(value) <= (column.most or column.dimension.largest):
                is_none = math.isnan(value)
                allowed = Message("refused.number") if is_none else _too_much(column, value)
                found = as_text(cell) or Message("refused_motion.empty_cell")
                place = f"line {row.line}, {names[k]}"
                wrong.append((row.line, Problem(place, found, allowed)))
    sheet.refuse(wrong)
    return dict(zip(names, columns, strict=True))


def _too_much(column: Column, value: float) -> str:
    if column.most:
        return Message("refused.or_less", bound=f"{column.most:g} {column.dimension.si_unit}")
    return implausible(column.dimension, value)


def _of_headings(
    cells: Sequence[str],
    names: Sequence[str],
    known: Collection[str],
    needed: Sequence[str],
    some: Sequence[str],
) -> Iterator[Problem]:
    """Yield headings that are unknown, missing or there twice."""
    one_of = Message("refused.one_of", words=", ".join(known))
    if not any(name in known for name in names):  # another file, whose words are not told
        yield Problem("headings", "", one_of)
        return
    for cell, name in zip(cells, names, strict=True):
        if name not in known:
            yield Problem("headings", as_text(cell) or Message("refused_file.an_empty_one"), one_of)
    for each in needed:
        if each not in names:
            yield Problem("headings", "", Message("refused_motion.missing", each=each))
    for each in sorted({name for name in names if names.count(name) > 1}):
        yield Problem("headings", as_text(each), Message("refused_study.twice"))
    if not any(each in names for each in some):
        missing = Message("refused_motion.one_missing", some=", ".join(some))
        yield Problem("headings", "", missing)


def few(problems: Sequence[Problem], of: str = "file", most: int = SHOWN) -> list[Problem]:
    """Keep the first problems of a file or a table, and say how many more there are."""
    more = len(problems) - most
    rest = [Problem(of, "", Message("refused_motion.more_kind", more=more))] if more > 0 else []
    return [*problems[:most], *rest]


def as_text(cell: str) -> str:
    """Show a cell, whatever is in it."""
    return as_written(cell.strip())[1:-1]
