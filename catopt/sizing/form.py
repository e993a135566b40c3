"""A sizing as a form in a workbook: a row an input, with unit, choices and hint; and read again.

The second sheet takes a fleet, a row a mooring; what a row leaves out is that of the form.
"""

from __future__ import annotations

import os
import zipfile
from collections.abc import Iterator, Mapping
from functools import partial
from io import BytesIO
from pathlib import Path
from types import MappingProxyType
from typing import Any, Final

from catopt.casefile.reading import Moored
from catopt.errors import InputError, Problem, refused
from catopt.sizing.file import SizingFile, file_of
from catopt.sizing.inputs import Input, inputs_of
from catopt.sizing.kinds import choices_of
from catopt.units import Dimension
from catopt.words import Language, Message, say

UNITS: Final[Mapping[str, tuple[str, ...]]] = MappingProxyType(
    {
        "LENGTH": ("m", "mm", "cm", "km"),
        "FORCE": ("kN", "N", "tf", "kgf", "MN"),
        "MASS": ("t", "kg"),
        "SPEED": ("m/s", "km/hour"),
        "TIME": ("s", "min", "hour", "year"),
        "AREA": ("m^2", "cm^2"),
        "ANGLE": ("deg", "rad"),
        "DENSITY": ("kg/m^3",),
    }
)
"""What may be chosen as the unit of an input; the one of its example comes first."""
ENDING: Final = ".xlsx"
MOST_BYTES: Final = 20_000_000
"""Of a form, packed and unpacked."""
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


def read_form(path: str | os.PathLike[str]) -> list[SizingFile]:
    """Read a form that is filled in: what it gives, once, or once for each row of its fleet.

    InputError where it is none, where a cell holds a formula, and for macros.
    """
    source = os.fspath(path)
    book = _opened(Path(path), source)
    moored = book[_FORM]["A1"].value if _FORM in book.sheetnames else None
    if moored not in ("buoy", "tanker"):
        allowed = Message("refused_sizing.form_catopt_new_buoy_out")
        raise refused("A1", f"{moored}", allowed, source)
    problems = [
        Problem(
            f"{sheet.title}!{cell.coordinate}",
            Message("refused_sizing.a_formula"),
            Message("refused_sizing.value_wanted_place"),
        )
        for sheet in book
        for row in sheet.iter_rows()
        for cell in row
        if cell.data_type == "f"
    ]
    if problems:
        raise InputError(problems, source)
    inputs = {each.key: each for each in _inputs(moored)}
    own: dict[str, object] = {}
    for row in book[_FORM].iter_rows(min_row=_FIRST, max_col=_KEY, values_only=True):
        if row[_KEY - 1] in inputs and row[_VALUE - 1] not in (None, ""):
            each = inputs[str(row[_KEY - 1])]
            own[each.key] = _given(each, row[_VALUE - 1], row[_UNIT - 1])
    rows = [own | given for given in _fleet(book, inputs)] or [own]
    folder = str(Path(path).parent)
    return [file_of(_document(each), moored, source, folder=folder) for each in rows]


def _opened(path: Path, source: str) -> Any:
    """Open a workbook that is small enough, and no program."""
    import openpyxl
    from openpyxl.utils.exceptions import InvalidFileException

    wanted = Message("refused_sizing.workbook_xlsx_at_most_20")
    try:
        with zipfile.ZipFile(path) as packed:
            parts = packed.infolist()
        if sum(part.file_size for part in parts) > MOST_BYTES:
            raise refused("file", Message("refused_sizing.more_than_that"), wanted, source)
        if any("vbaproject" in part.filename.lower() for part in parts):
            allowed = Message("refused_sizing.save_without_catopt_takes_no")
            raise refused("file", Message("refused_sizing.macros"), allowed, source)
        return openpyxl.load_workbook(path)
    except FileNotFoundError:
        raise refused("file", "", Message("refused.no_file"), source) from None
    except (OSError, ValueError, KeyError, zipfile.BadZipFile, InvalidFileException):
        found = Message("refused_sizing.no_workbook")
        raise refused("file", found, wanted, source) from None


def _fleet(book: Any, inputs: Mapping[str, Input]) -> Iterator[dict[str, object]]:
    """Yield what each row of the fleet gives, by key."""
    if _FLEET not in book.sheetnames:
        return
    every: list[tuple[Any, ...]] = [*book[_FLEET].iter_rows(values_only=True), (), (), ()]
    keys = every[2]
    for row in every[3 : 3 + MOST_ROWS]:
        given = {
            inputs[key].key: _given(inputs[key], value, (*_units(inputs[key]), "")[0])
            for key, value in zip(keys, row, strict=False)
            if key in inputs and value not in (None, "")
        }
        if given:
            yield given


def _given(each: Input, value: object, unit: object) -> object:
    """Take a value as a file has it: a number with the unit beside it, several with a semicolon."""
    if each.several and isinstance(value, str):
        return [part.strip() for part in value.split(";") if part.strip()]
    if each.takes == "FLAG":
        return {"yes": True, "no": False}.get(str(value).strip().lower(), value)
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    if each.is_measure and is_number and unit:
        value = f"{value!r} {unit}"
    elif each.takes in ("TEXT", "NAME", "FILE", "WHICH") and is_number:
        value = f"{value}"
    return [value] if each.several else value


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
    return tuple(dict.fromkeys((own, *UNITS.get(each.takes, ()))))


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
