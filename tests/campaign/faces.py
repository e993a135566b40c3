"""Every shape through every face: an answer with the numbers of its record, or one way out.

A pair is a mooring with a command and a face: the first screen in both languages and all units,
all of it at three widths of the terminal, the document, the tables, the workbook, the note and
its workbook. Each pair must end with the numbers of the answer, none of them zero that is not,
or with a refusal that names what exists.
"""

from __future__ import annotations

import io
import json
import math
import os
import re
import traceback
from bisect import bisect_left
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any
from unittest.mock import patch

import openpyxl
import pandas as pd

from catopt.__main__ import main
from catopt.answers.blocks import Answer, Column, Facts, Table
from catopt.cli.answering import STOPPED
from catopt.cli.output import Printer
from catopt.quantities import Units
from catopt.render.card import card_lines
from catopt.render.files import csv_files
from catopt.render.terminal import show
from catopt.render.values import SEEN, UNITS, as_wanted, cell, is_seen, parts_of
from catopt.render.workbook import workbook
from catopt.words import LANGUAGES, Language, Message, say
from tests.campaign.shapes import SHAPES, Drawn, drawn

WIDTHS = (60, 80, 120)
IN_UNITS: tuple[Units, ...] = ("", "si", "tf")
LINES, WIDTH = 24, 80
ENDED = {0, 2, 3, 4, STOPPED}
"""Statuses that are no fault of the program."""
NOTHING = 1e-9
"""Of the largest of its kind in an answer: less is rounding, and may be printed as zero."""
_OF_RECORD = {"lines", "hung", "joints", "bodies", "segments", "point_loads", "floats"}
_NOT_OF_RECORD = {
    "Utilisation", "Weight in water", "Knocked down by", "Minimum breaking load",
}  # fmt: skip
"""Columns that the document has in another place, or not."""
_NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
_OPTION = re.compile(r"(?<![\w-])--[a-z][a-z-]+")


@dataclass
class Tally:
    """What came of pairs."""

    pairs: Counter[str] = field(default_factory=Counter)
    answered: Counter[str] = field(default_factory=Counter)
    refused: Counter[str] = field(default_factory=Counter)
    faults: list[str] = field(default_factory=list)


def run(count: int, first: int, tell: Callable[[str], None]) -> int:
    """Try so many moorings with all their commands and faces; returns how many pairs failed."""
    tally = Tally()
    for seed in range(first, first + count):
        known = len(tally.faults)
        try_mooring(drawn(seed), seed, tally)
        for each in tally.faults[known:]:
            tell(each)
    tell(table(tally))
    return len(tally.faults)


def table(tally: Tally) -> str:
    """Set the counts of each shape below each other."""
    rows = [f"{'shape':20}{'pairs':>8}{'answered':>10}{'refused':>9}"]
    rows += [
        f"{shape:20}{tally.pairs[shape]:8,}{tally.answered[shape]:10,}{tally.refused[shape]:9,}"
        for shape in SHAPES
        if tally.pairs[shape]
    ]
    total = tally.pairs.total()
    rows.append(
        f"{'all':20}{total:8,}{tally.answered.total():10,}{tally.refused.total():9,}"
        f"   failed: {len(tally.faults)}"
    )
    return "\n".join(rows)


def try_mooring(mooring: Drawn, seed: int, tally: Tally) -> None:
    """Put one mooring through its commands and all their faces."""
    with TemporaryDirectory() as folder:
        place = Path(folder) / "case.toml"
        place.write_text(mooring.text, encoding="utf-8")
        notes = (("report", "--out", str(Path(folder) / "note.html")),)
        for asked in (*mooring.asks, *notes):
            for face, fault in _faces(asked, place):
                tally.pairs[mooring.shape] += 1
                kind = tally.refused if face == "refusal" else tally.answered
                kind[mooring.shape] += 1
                if fault:
                    where = f"{mooring.shape} {seed}: catopt {' '.join(asked)} [{face}]"
                    tally.faults.append(f"{where}: {fault}")


def _faces(asked: tuple[str, ...], place: Path) -> Iterator[tuple[str, str]]:
    """Yield each face of a command and what is wrong with it, empty where nothing is."""
    command = [asked[0], str(place), *asked[1:]]
    told: list[Answer] = []

    def keep(_: object, answer: Answer, *__: object, **___: object) -> None:
        told.append(answer)

    with patch("catopt.render.terminal.show", keep):
        status, out, err = typed(command, full=True)
    if status not in ENDED:
        yield "run", f"status {status}: {err[-500:]}"
        return
    if status and not told:
        yield "refusal", _of_refusal(err)
        return
    if asked[0] == "report":
        yield "note", _of_note(Path(asked[2]))
        return
    status, out, err = typed([*command, "--json"])
    yield "json", _guarded(partial(_of_json, told[0], out, err))
    for face, look in _looks(told[0]):
        yield face, _guarded(look)


def _looks(answer: Answer) -> Iterator[tuple[str, Callable[[], str]]]:
    """Yield the faces that are made of an answer, with what finds their faults."""
    for language in LANGUAGES:
        for units in IN_UNITS:
            name = f"screen {language} {units}".strip()
            yield name, partial(_of_screen, answer, language, units)
            yield f"all {name}", partial(_of_all, answer, language, units)
        for width in WIDTHS:
            yield f"{width} columns {language}", partial(_of_width, answer, language, width)
    yield "csv", partial(_of_tables, answer)
    yield "xlsx", partial(_of_workbook, answer)


def _of_json(answer: Answer, out: str, err: str) -> str:
    try:
        document = json.loads(out)
    except ValueError:
        return f"no document: {out[:100]} {err[-300:]}"
    return _of_document(answer, document)


def typed(command: list[str], *, full: bool = False, width: int = 80) -> tuple[int, str, str]:
    """Run a command in this process as it would be typed."""
    out, err = io.StringIO(), io.StringIO()
    environment = {"CATOPT_FULL": "1" if full else "0", "COLUMNS": f"{width}"}
    with patch.dict(os.environ, environment), redirect_stdout(out), redirect_stderr(err):
        status = main(command)
    return status, out.getvalue(), err.getvalue()


def _guarded(look: Callable[[], str]) -> str:
    try:
        return look()
    except Exception:
        return traceback.format_exc(limit=-3)


def _of_refusal(said: str) -> str:
    """Find what is wrong with a refusal: nothing said, or a way out that does not exist."""
    if len(said.split()) < 5:
        return f"says nothing: {said!r}"
    unknown = {each for each in _OPTION.findall(said) if each not in _options()}
    return f"names {sorted(unknown)}" if unknown else ""


def _options() -> set[str]:
    if not _KNOWN:
        for command in (
            "solve",
            "system",
            "check",
            "curve",
            "report",
            "verify",
            "import",
            "design",
        ):
            _KNOWN.update(_OPTION.findall(typed([command, "--help-all"], width=200)[1]))
        _KNOWN.update({"--debug"})
    return _KNOWN


_KNOWN: set[str] = set()


# ------------------------------------------------------------------ numbers


def _tables(answer: Answer) -> Iterator[Table]:
    for block in answer.blocks:
        if isinstance(block, Table):
            yield block
        elif isinstance(block, Facts):
            yield block.as_table()


def _scales(answer: Answer) -> dict[str, float]:
    """Find the largest number of each unit."""
    found: dict[str, float] = {}
    for each in _tables(answer):
        for column in each.columns:
            for row, value in enumerate(column.values):
                quantity = column.quantity_of(row)
                if quantity is not None and isinstance(value, float) and math.isfinite(value):
                    unit = quantity.si_unit
                    found[unit] = max(found.get(unit, 0.0), abs(value))
    return found


def _wrong_cell(column: Column, row: int, scales: dict[str, float]) -> str:
    """Say how what is printed of a value is not the value; empty where it is."""
    value, quantity = column.values[row], column.quantity_of(row)  # noqa: PD011
    if quantity is None or not isinstance(value, float) or not math.isfinite(value):
        return ""
    text = say(cell(column, row), "en")
    found = _NUMBER.match(text)
    if found is None:
        return "" if text.startswith("<") else f"{column.said_heading()}: {text!r} for {value!r}"
    printed, field_value = float(found[0]), quantity.to_field(value)
    least = max(NOTHING * scales.get(quantity.si_unit, 0.0), quantity.rounding, 1e-9)
    if abs(value) <= least * (1.0 + 1e-12):
        return ""
    places = len(found[0].partition(".")[2]) if "e" not in found[0] else 0
    near = 0.5000001 * 10.0**-places if "e" not in found[0] else 0.06 * abs(field_value)
    if quantity.notation == "significant":
        near = max(near, 1e-5 * abs(field_value))
    if printed == 0.0 or abs(printed - field_value) > near:
        return f"{column.said_heading()}: {text!r} for {field_value!r}"
    if abs(printed - field_value) > 0.06 * abs(field_value):
        return f"{column.said_heading()}: {text!r} has too few digits for {field_value!r}"
    return ""


def _first(of: Iterable[str]) -> str:
    return next(filter(None, of), "")


def _of_screen(answer: Answer, language: Language, units: Units) -> str:
    held = UNITS.set(units)
    try:
        lines = [each.text for each in card_lines(answer, language)]
    finally:
        UNITS.reset(held)
    if len(lines) > LINES:
        return f"{len(lines)} lines"
    widest = max(lines, key=len)
    return f"{len(widest)} columns: {widest}" if len(widest) > WIDTH else ""


class _Paper:
    """Keeps what is printed."""

    def __init__(self) -> None:
        self.said: list[str] = []

    def text(self, text: str, *, bold: bool = False) -> None:
        self.said += [text, ""] if bold else [text]

    def line(self) -> None:
        self.said.append("")

    def table(
        self,
        columns: Iterable[str],
        rows: Iterable[Iterable[str]],
        *,
        title: str = "",
        numbers: Iterable[int] = (),
    ) -> None:
        self.said += [title, *columns, *(each for row in rows for each in row), *map(str, numbers)]


def _of_all(answer: Answer, language: Language, units: Units) -> str:
    """Look at every number that people see of an answer, and whether it is printed."""
    held = UNITS.set(units)
    try:
        wanted, paper = as_wanted(answer), _Paper()
        show(paper, answer, language)
    finally:
        UNITS.reset(held)
    printed, scales = "\n".join(paper.said), _scales(answer)
    left_out = [each for each in paper.said if each.startswith(_left_out(language))]
    for each in _tables(wanted):
        if not is_seen(each):
            continue
        rows = sorted({row for _, own in parts_of(each) for row in own})
        for column in each.columns:
            if column.only not in SEEN:
                continue
            for row in rows:
                if wrong := _wrong_cell(column, row, scales):
                    return f"{each.name}: {wrong}"
                text, name = say(cell(column, row), language), say(column.name, language)
                is_named = any(name in each for each in left_out)
                if column.is_number and text not in printed and not is_named:
                    return f"{each.name}: {column.said_heading()}: {text!r} is not printed"
    return ""


def _left_out(language: Language) -> str:
    """Return the words before the columns that a table of 80 columns has no room for."""
    return Message("answers.left_out", columns="").said(language).split(":")[0]


def _of_width(answer: Answer, language: Language, width: int) -> str:
    """Look at all of it on a terminal of so many columns."""
    out = io.StringIO()
    with patch.dict(os.environ, {"COLUMNS": f"{width}"}), redirect_stdout(out):
        show(Printer(), answer, language)
    said = out.getvalue()
    if not said.strip():
        return "nothing is printed"
    widest = max(map(len, said.splitlines()))
    return f"{widest} columns" if widest > max(width, WIDTH) else ""


def _of_tables(answer: Answer) -> str:
    made = csv_files(answer)
    for block in as_wanted(answer).blocks:
        if not isinstance(block, Table | Facts) or block.only not in {"all", "files"}:
            continue
        of = block.as_table() if isinstance(block, Facts) else block
        frame = pd.read_csv(io.BytesIO(made[f"{block.name}.csv"]))
        for k, column in enumerate(of.for_files()):
            for row, value in enumerate(column.values):
                quantity = column.quantity_of(row)
                if quantity is None or not isinstance(value, float) or not math.isfinite(value):
                    continue
                found = float(str(frame.iloc[row, k]))
                if not math.isclose(quantity.to_si(found), value, rel_tol=1e-11, abs_tol=1e-300):
                    return f"{block.name}: {column.said_heading()}: {found} for {value}"
    return ""


def _of_workbook(answer: Answer) -> str:
    """Look for every number of the main tables in a cell, where it does not show as zero."""
    book = openpyxl.load_workbook(io.BytesIO(workbook(answer, "en")))
    cells = (each for sheet in book for row in sheet for each in row)
    formats: dict[float, str] = {}
    for each in cells:
        held: Any = each.value
        if isinstance(held, int | float):
            formats[float(held)] = str(each.number_format)
    every, scales = sorted(formats), _scales(answer)
    for column, row, value in _of_main_tables(answer, Table.for_files):
        inside = column.in_files(row)
        assert isinstance(inside, float)
        if not _is_among(inside, every, 0.0):
            return f"{column.said_heading()}: {inside} is in no cell"
        quantity = column.quantity_of(row)
        least = math.inf
        if quantity:
            least = max(NOTHING * scales[quantity.si_unit], quantity.rounding)
        shows = re.fullmatch(r"0(?:\.(0+))?", formats.get(inside, ""))
        if shows and abs(value) > least and abs(inside) < 0.5 * 10.0 ** -len(shows[1] or ""):
            return f"{column.said_heading()}: {inside} is shown as {shows[0]}"
    return ""


def _of_main_tables(
    answer: Answer, columns: Callable[[Table], Iterable[Column]]
) -> Iterator[tuple[Column, int, float]]:
    """Yield every measured number of the tables that hold what was found."""
    for of in _tables(answer):
        for column in columns(of) if of.name in _OF_RECORD else ():
            for row, value in enumerate(column.values):
                is_number = isinstance(value, float) and math.isfinite(value)
                if is_number and column.quantity_of(row) is not None:
                    yield column, row, float(value or 0.0)


def _of_document(answer: Answer, document: object) -> str:
    """Look for every number of the main tables in the record."""
    every = sorted(abs(each) for each in _numbers(document))
    scales = _scales(answer)
    for column, _, value in _of_main_tables(answer, lambda of: of.columns):
        if column.quantity is None or str(column.name) in _NOT_OF_RECORD:
            continue
        if not _is_among(abs(value), every, NOTHING * scales[column.quantity.si_unit]):
            return f"{column.said_heading()}: {value} is not in the record"
    return ""


def _numbers(of: object) -> Iterator[float]:
    if isinstance(of, dict):
        for each in of.values():
            yield from _numbers(each)
    elif isinstance(of, list):
        for each in of:
            yield from _numbers(each)
    elif isinstance(of, int | float) and not isinstance(of, bool):
        yield float(of)


def _is_among(value: float, every: list[float], rounding: float) -> bool:
    if abs(value) <= rounding:
        return True
    near = bisect_left(every, value)
    return any(
        math.isclose(each, value, rel_tol=1e-9, abs_tol=1e-300)
        for each in every[max(near - 1, 0) : near + 1]
    )


def _of_note(note: Path) -> str:
    text = note.read_text("utf-8")
    if len(text) < 2000 or "</html>" not in text:
        return "no page"
    return _first(
        f"{word} on the page" for word in (">nan<", ">None<", "Traceback") if word in text
    )
