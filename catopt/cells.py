"""Reads the cells of a workbook: what is there and nothing else, within a budget of bytes.

A workbook is a ZIP of XML files (ECMA-376, part 1, 18). Time and memory grow with the cells that
stand in it, wherever they are, and not with the area that it says it has.
"""

from __future__ import annotations

import posixpath
import re
import struct
import zipfile
import zlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Final, NamedTuple
from xml.etree import ElementTree

from catopt.errors import InputError, Problem, refused
from catopt.tables import few, number
from catopt.words import Message

MOST_BYTES: Final = 5 * 2**20
"""Of a form, packed and unpacked; one that is filled in has 0.1 MB."""
_FAULTS: Final = (
    *(OSError, ValueError, KeyError, IndexError, EOFError, RuntimeError, NotImplementedError),
    *(zipfile.BadZipFile, zlib.error, struct.error, ElementTree.ParseError, UnicodeError),
)
"""What readers of ZIP and XML raise for a damaged file."""
_REFERENCE: Final = re.compile(r"([A-Z]{1,3})([1-9]\d{0,6})", re.ASCII)
_DATES: Final = frozenset((*range(14, 23), *range(27, 37), *range(45, 48), *range(50, 59)))
"""Numbers of built-in formats that show dates and times (18.8.30)."""
_QUOTED: Final = re.compile(r'"[^"]*"|\[[^\]]*\]|\\.')

Value = str | int | float | bool


class Cell(NamedTuple):
    """A value with its place; columns and rows count from 1."""

    row: int
    column: int
    value: Value

    @property
    def name(self) -> str:
        """The place as spreadsheets write it: ``B12``."""
        return f"{letters(self.column)}{self.row}"


@dataclass(frozen=True)
class Workbook:
    """The cells that hold something, by sheet, in the order of rows."""

    sheets: Mapping[str, tuple[Cell, ...]]


def letters(column: int) -> str:
    """Write the number of a column as letters.

    Examples
    --------
    >>> letters(1), letters(27), letters(16384)
    ('A', 'AA', 'XFD')
    """
    text = ""
    while column > 0:
        column, rest = divmod(column - 1, 26)
        text = chr(65 + rest) + text
    return text


def read_workbook(path: Path, source: str) -> Workbook:
    """Read a workbook.

    InputError where it is none, damaged or larger than `MOST_BYTES`; for macros; and for cells that
    hold no plain value: formulas, errors, dates, and two in one place, all at once.
    """
    wanted = Message("refused_sizing.workbook_wanted", most=MOST_BYTES / 2**20)
    try:
        if path.stat().st_size > MOST_BYTES:
            raise refused("file", Message("refused_sizing.more_than_that"), wanted, source)
        with zipfile.ZipFile(path) as packed:
            parts = packed.infolist()
            if sum(part.file_size for part in parts) > MOST_BYTES:
                raise refused("file", Message("refused_sizing.more_than_that"), wanted, source)
            if any("vbaproject" in part.filename.lower() for part in parts):
                allowed = Message("refused_sizing.save_without_catopt_takes_no")
                raise refused("file", Message("refused_sizing.macros"), allowed, source)
            if len({part.filename for part in parts}) < len(parts):
                raise zipfile.BadZipFile
            problems: list[Problem] = []
            sheets = dict(_sheets(packed, problems))
    except FileNotFoundError:
        raise refused("file", "", Message("refused.no_file"), source) from None
    except _FAULTS:
        found = Message("refused_sizing.no_workbook")
        raise refused("file", found, wanted, source) from None
    if problems:
        raise InputError(few(problems), source)
    return Workbook(sheets)


def _sheets(
    packed: zipfile.ZipFile, problems: list[Problem]
) -> Iterator[tuple[str, tuple[Cell, ...]]]:
    """Yield the cells of each sheet, by its name."""
    names = set(packed.namelist())
    related = {
        each.get("Id", ""): posixpath.normpath(
            posixpath.join("/xl", each.get("Target", ""))
        ).removeprefix("/")
        for each in _tree(packed, "xl/_rels/workbook.xml.rels")
    }
    texts, dates = [], set()
    if "xl/sharedStrings.xml" in names:
        texts = [_text(each) for each in _tree(packed, "xl/sharedStrings.xml")]
    if "xl/styles.xml" in names:
        dates = set(_date_styles(_tree(packed, "xl/styles.xml")))
    for each in _tree(packed, "xl/workbook.xml").iter():
        if _tag(each) != "sheet":
            continue
        part = related[next(value for key, value in each.items() if key.endswith("}id"))]
        title, cells, seen = each.get("name", ""), [], set()
        if part.startswith("xl/chartsheets"):
            continue
        for cell, fault in _cells(_tree(packed, part), texts, dates):
            if not fault and (cell.row, cell.column) in seen:
                raise ValueError(cell.name)
            seen.add((cell.row, cell.column))
            if fault:
                allowed = Message("refused_sizing.value_wanted_place")
                problems.append(Problem(f"{title}!{cell.name}", fault, allowed))
            elif not isinstance(cell.value, str) or cell.value.strip():
                cells.append(cell)
        yield title, tuple(cells)


def _tree(packed: zipfile.ZipFile, name: str) -> ElementTree.Element:
    data = packed.read(name)
    if b"<!DOCTYPE" in data:
        raise ValueError(name)  # no program writes one here
    return ElementTree.fromstring(data)


def _tag(element: ElementTree.Element) -> str:
    return element.tag.rpartition("}")[2]


def _text(element: ElementTree.Element) -> str:
    """Join the texts of an item, without how they are pronounced."""
    if _tag(element) == "rPh":
        return ""
    own = (element.text or "") if _tag(element) == "t" else ""
    return own + "".join(_text(each) for each in element)


def _date_styles(styles: ElementTree.Element) -> Iterator[int]:
    """Yield the numbers of the styles that show a date or a time."""
    formats = {
        int(each.get("numFmtId", "0")): _QUOTED.sub("", each.get("formatCode", "")).lower()
        for each in styles.iter()
        if _tag(each) == "numFmt"
    }
    of_cells = next((each for each in styles if _tag(each) == "cellXfs"), ())
    for number_of, style in enumerate(of_cells):
        code = int(style.get("numFmtId", "0"))
        shown = formats.get(code, "")
        if any(mark in shown for mark in "dmyhs") if shown else code in _DATES:
            yield number_of


def _cells(
    sheet: ElementTree.Element, texts: list[str], dates: set[int]
) -> Iterator[tuple[Cell, str]]:
    """Yield each cell that is not empty, and what is wrong with it."""
    row = 0
    for line in sheet.iter():
        if _tag(line) != "row":
            continue
        row, column = int(line.get("r", row + 1)), 0
        for each in line:
            at = _REFERENCE.fullmatch(each.get("r", f"{letters(column + 1)}{row}"))
            if _tag(each) != "c" or at is None or int(at[2]) != row:
                raise ValueError(each.get("r"))
            column = 0
            for letter in at[1]:
                column = 26 * column + ord(letter) - 64
            kind, inner = each.get("t", "n"), {_tag(part): part for part in each}
            said = inner["v"].text or "" if "v" in inner else ""
            if "f" in inner:
                yield Cell(row, column, ""), Message("refused_sizing.a_formula")
            elif kind == "inlineStr" or said:
                yield _cell(row, column, kind, _text(each) or said, each, texts, dates)


def _index(said: str) -> int:
    if not said.isdecimal():
        raise ValueError(said)
    return int(said)


def _cell(
    row: int,
    column: int,
    kind: str,
    said: str,
    element: ElementTree.Element,
    texts: list[str],
    dates: set[int],
) -> tuple[Cell, str]:
    """Read a cell by its kind."""
    value: Value = said
    if kind == "e":
        return Cell(row, column, ""), said
    if kind == "s":
        value = texts[_index(said)]
    elif kind == "b":
        value = {"1": True, "0": False, "true": True, "false": False}[said]
    elif kind == "d" or (kind == "n" and _index(element.get("s", "0")) in dates):
        return Cell(row, column, ""), Message("refused_sizing.a_date")
    elif kind == "n":
        found = number(said)
        value = int(found) if found.is_integer() and abs(found) < 1e15 else found
        if found != found:
            raise ValueError(said)
    elif kind not in ("str", "inlineStr"):
        raise ValueError(kind)
    return Cell(row, column, value), ""
