"""A sizing as a form in a workbook: a row an input, with unit, choices and hint; and read again.

The second sheet takes a fleet, a row a mooring; what a row leaves out is that of the form.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from functools import partial
from io import BytesIO
from pathlib import Path
from typing import Any, Final

from catopt.casefile.reading import Moored
from catopt.cells import Cell, Value, letters, read_workbook
from catopt.errors import InputError, Problem, refused
from catopt.sizing.file import SizingFile, file_of
from catopt.sizing.inputs import Input, inputs_of
from catopt.sizing.kinds import choices_of
from catopt.tables import FLAGS, few, heading
from catopt.units import Dimension, as_written, bare_number, readings, units_like
from catopt.words import Language, Message, say

ENDING: Final = ".xlsx"
MOST_ROWS: Final = 1_000
_FORM, _FLEET, _FIRST = "Form", "Fleet", 4
_WHAT, _VALUE, _UNIT, _HINT, _KEY = range(1, 6)


def is_form(path: object) -> bool:
    """Say whether a path is one of a form."""
    return isinstance(path, str | os.PathLike) and os.fspath(path).lower().endswith(ENDING)


def form(moored: Moored, language: Language = "en") -> bytes:
    """Write an empty form; every input has its key in the last column, by which it is read."""
    import openpyxl
    from openpyxl.styles import Font, PatternFill

    book = openpyxl.Workbook()
    sheet = book.active
    assert sheet is not None
    sheet.title = _FORM
    reported = partial(say, language=language)
    grey, bold = Font(color="808080"), Font(bold=True)
    sheet["A1"], sheet["A2"] = moored, reported(Message(f"left_out.form_{moored}"))
    sheet["A1"].font, sheet["A2"].font = grey, bold
    for column, name in enumerate(("what", "value", "unit", "hint", "key"), start=1):
        sheet.cell(_FIRST - 1, column, reported(Message(f"left_out.form_{name}"))).font = bold
    for row, each in enumerate(_inputs(moored), start=_FIRST):
        sheet.cell(row, _WHAT, reported(Message(f"inputs.{each.name}")))
        sheet.cell(row, _VALUE).fill = PatternFill("solid", fgColor="FFF8DC")
        sheet.cell(row, _HINT, reported(_hint(each, language))).font = grey
        sheet.cell(row, _KEY, each.key).font = grey
        units = _units(each)
        if units:
            sheet.cell(row, _UNIT, units[0])
            _offer(sheet, f"C{row}", units)
        choices = ("yes", "no") if each.takes == "FLAG" else choices_of(each)
        if choices and not each.several:
            _offer(sheet, f"B{row}", choices)
    for letter, width in zip("ABCDE", (46, 24, 9, 60, 26), strict=True):
        sheet.column_dimensions[letter].width = width
    sheet.freeze_panes = f"B{_FIRST}"
    _print_on_pages(sheet, f"A1:D{_FIRST + len(_inputs(moored)) - 1}", f"1:{_FIRST - 1}")
    fleet = book.create_sheet(_FLEET)
    fleet["A1"] = reported(Message("left_out.form_fleet"))
    for column, each in enumerate(_inputs(moored), start=1):
        name = reported(Message(f"inputs.{each.name}"))
        unit = [f"({own})" for own in _units(each)[:1]]
        fleet.cell(2, column, " ".join([name, *unit])).font = bold
        fleet.cell(3, column, each.key).font = grey
    stream = BytesIO()
    book.save(stream)
    return stream.getvalue()


def _print_on_pages(sheet: Any, area: str, rows: str) -> None:
    """Print a sheet on two pages of A4, without its keys, and its first rows on both."""
    from openpyxl.worksheet.properties import PageSetupProperties

    sheet.print_area, sheet.print_title_rows = area, rows
    sheet.page_setup.paperSize = sheet.PAPERSIZE_A4
    sheet.page_setup.fitToWidth, sheet.page_setup.fitToHeight = 1, 2
    sheet.sheet_properties.pageSetUpPr = PageSetupProperties(fitToPage=True)


def read_form(path: str | os.PathLike[str]) -> list[SizingFile]:
    """Read a form that is filled in: what it gives, once, or once for each row of its fleet.

    InputError where it is none, as of `read_workbook`, and with every cell whose value has no key,
    a key twice, no unit where one is needed, or a place that the form does not have.
    """
    source = os.fspath(path)
    book = read_workbook(Path(path), source)
    form_cells = _by_row(book.sheets.get(_FORM, ()))
    moored: Any = form_cells.get(1, {}).get(1)
    if moored not in ("buoy", "tanker"):
        allowed = Message("refused_sizing.form_catopt_new_buoy_out")
        raise refused("A1", f"{moored}", allowed, source)
    reading = _Form({each.key: each for each in _inputs(moored)}, [])
    for name, cells in book.sheets.items():
        if name not in (_FORM, _FLEET) and cells:
            allowed = Message("refused_sizing.two_sheets")
            reading.note(f"{name}!{cells[0].name}", cells[0].value, allowed)
    own = reading.form(form_cells)
    fleet = reading.fleet(_by_row(book.sheets.get(_FLEET, ())))
    if reading.problems:
        raise InputError(few(reading.problems), source)
    folder = str(Path(path).parent)
    return [
        file_of(
            _document({key: value for key, (value, _) in row.items()}),
            moored,
            source,
            folder=folder,
            cells={key: cell for key, (_, cell) in row.items()},
        )
        for row in [own | given for given in fleet] or [own]
    ]


Given = dict[str, tuple[object, str]]
"""What a sheet gives, by key, with the cell that has it."""
Rows = Mapping[int, Mapping[int, Value]]
"""Values by row and column, of those that are not empty."""


def _by_row(cells: tuple[Cell, ...]) -> Rows:
    rows: dict[int, dict[int, Value]] = {}
    for cell in cells:
        rows.setdefault(cell.row, {})[cell.column] = cell.value
    return rows


@dataclass
class _Form:
    """Reads the rows of both sheets; what is wrong with them is noted."""

    inputs: Mapping[str, Input]
    problems: list[Problem]

    def note(self, place: str, found: object, allowed: Message) -> None:
        shown = as_written(found) if found != "" else ""
        self.problems.append(Problem(place, shown, allowed))

    def form(self, rows: Rows) -> Given:
        """Return what the first sheet gives, by key; each of its values has a key beside it."""
        given: Given = {}
        seen: dict[str, int] = {}
        for at, row in rows.items():
            if at < _FIRST:
                continue
            for column in sorted(row.keys() - {*range(_WHAT, _KEY + 1)}):
                place = f"{_FORM}!{letters(column)}{at}"
                self.note(place, row[column], Message("refused_sizing.beyond_columns"))
            key, value = row.get(_KEY, ""), row.get(_VALUE)
            each = self._input(f"{_FORM}!{letters(_KEY)}{at}", key, value is not None)
            if each is None:
                continue
            if each.key in seen:
                twice = Message("refused_sizing.key_twice", row=seen[each.key])
                self.note(f"{_FORM}!{letters(_KEY)}{at}", key, twice)
            seen[each.key] = at
            if value is not None:
                place = f"{_FORM}!{letters(_VALUE)}{at}"
                read = self._given(place, each, value, str(row.get(_UNIT, "")))
                given[each.key] = read, place
        return given

    def fleet(self, rows: Rows) -> list[Given]:
        """List what each row of the fleet gives, by key; a column has its key in the third row."""
        if len(rows.keys() - {1, 2, 3}) > MOST_ROWS:
            allowed = Message("refused_sizing.most_rows", most=MOST_ROWS)
            self.note(_FLEET, len(rows), allowed)
            return []
        heads, keys = rows.get(2, {}), rows.get(3, {})
        below = [rows[at] for at in rows if at > 3]
        filled = {column for row in below for column in row}
        columns: dict[int, tuple[Input, str]] = {}
        for column in sorted(filled | keys.keys()):
            place = f"{_FLEET}!{letters(column)}3"
            each = self._input(place, keys.get(column, ""), column in filled)
            if each is None:
                continue
            if any(each is other for other, _ in columns.values()):
                self.note(place, keys[column], Message("refused_study.twice"))
            unit = heading(str(heads.get(column, "")))[1] if _units(each) else ""
            columns[column] = each, unit
        moorings: list[Given] = []
        for at, row in rows.items():
            if at > 3:
                given: Given = {}
                for column in row.keys() & columns.keys():
                    each, unit = columns[column]
                    place = f"{_FLEET}!{letters(column)}{at}"
                    given[each.key] = self._given(place, each, row[column], unit), place
                moorings.append(given)
        return moorings

    def _input(self, place: str, key: Value, has_value: bool) -> Input | None:
        """Find the input of a key; none is noted, where anything is lost by it."""
        each = self.inputs.get(str(key).strip())
        if each is None and key != "":
            near = next(iter(get_close_matches(str(key), self.inputs, n=1)), "")
            meant = Message("refused.did_you_mean", near=near)
            self.note(place, key, meant if near else Message("refused_sizing.key_of_form"))
        elif each is None and has_value:
            self.note(place, "", Message("refused_sizing.value_without_key"))
        return each

    def _given(self, place: str, each: Input, value: Value, unit: str) -> object:
        """Take a value as a file has it: with the unit beside it, several with a semicolon."""
        unit = unit.strip()
        parts: list[Value] = [value]
        if each.several and isinstance(value, str):
            parts = [part.strip() for part in value.split(";") if part.strip()]
        if each.takes == "FLAG":
            flag = FLAGS.get(str(value).strip().casefold())
            if flag is None:
                self.note(place, value, Message("refused_sizing.yes_or_no"))
            return flag
        if unit and not each.is_measure:
            self.note(place, unit, Message("refused_study.has_no_unit"))
        given = [self._one(place, each, part, unit) for part in parts]
        return given if each.several else given[0]

    def _one(self, place: str, each: Input, value: Value, unit: str) -> object:
        is_number = isinstance(value, int | float) and not isinstance(value, bool)
        if isinstance(value, str):
            is_number = each.is_measure and bool(readings(value.strip()))
        if is_number and _units(each):
            if not unit:
                self.note(place, value, Message("refused_sizing.unit_beside"))
            return f"{value} {unit}"
        if is_number and each.is_measure:  # a pure number, perhaps in per cent
            return f"{value} {unit}" if unit else bare_number(f"{value}")
        is_text = each.takes in ("TEXT", "NAME", "FILE", "WHICH")
        return f"{value}" if is_number and is_text else value


def _document(given: Mapping[str, object]) -> dict[str, Any]:
    """Make the document of a file of what is given by key."""
    document: dict[str, Any] = {}
    for key, value in given.items():
        *section, name = key.split(".")
        place = document
        for part in section:
            place = place.setdefault(part, {})
        place[name] = value
    return document


def _inputs(moored: Moored) -> list[Input]:
    """List the inputs of a form: each key once, what is asked for first."""
    every = {each.key: each for each in inputs_of(moored).values()}
    return sorted(every.values(), key=lambda each: not (each.required or each.asked))


def _units(each: Input) -> tuple[str, ...]:
    if not each.is_measure or Dimension[each.takes] is Dimension.NUMBER:
        return ()
    own = str(each.one_example).partition(" ")[2] or each.bare or Dimension[each.takes].si_unit
    return units_like(own)


def _hint(each: Input, language: Language) -> str:
    every = {**inputs_of("tanker"), **inputs_of("buoy")}
    named = {name: own.key for name, own in every.items()}
    taken = Message(each.left_out, **named) if each.left_out else each.default
    example = each.example
    if isinstance(example, tuple):
        example = "; ".join(map(str, example))
    said = say(Message("left_out.form_such_as", example=example), language)
    return said + (say(Message("left_out.if_left_out", taken=taken), language) if taken else "")


def _offer(sheet: Any, cell: str, choices: tuple[str, ...]) -> None:
    """Let a cell be chosen from a list, of which another value may be typed."""
    from openpyxl.worksheet.datavalidation import DataValidation

    listed = ",".join(choices)
    if len(listed) <= 250 and not any("," in each for each in choices):  # of a spreadsheet
        rule = DataValidation(type="list", formula1=f'"{listed}"', showErrorMessage=False)
        rule.add(cell)
        sheet.add_data_validation(rule)
