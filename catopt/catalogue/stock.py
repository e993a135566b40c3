"""Families from a table, CSV or a workbook: a row for each size that is in stock or sold."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from catopt.catalogue.collection import Catalogue
from catopt.catalogue.components import CONFIDENCES, SPECS, Confidence, Figure, Source, weakest
from catopt.catalogue.family import Family, Sizes, in_mm
from catopt.catalogue.formula import Density, Formula, Polynomial, Rows
from catopt.cells import read_workbook
from catopt.dimensions import Dimension
from catopt.errors import InputError, Problem
from catopt.tables import Column, Row, Sheet, as_text, heading, number, read_sheet, units_of
from catopt.words import Cited, Message

NUMBERS: Final[Mapping[str, Column]] = {
    "diameter": Column(Dimension.LENGTH),
    "mass": Column(Dimension.MASS_PER_LENGTH),
    "density": Column(Dimension.DENSITY),
    "MBL": Column(Dimension.FORCE),
    "proof_load": Column(Dimension.FORCE),
    "EA": Column(Dimension.FORCE),
    "price": Column(units={"USD/m": 1.0}),
}
"""Columns of numbers, by the names of catopt's quantities; the diameter is the nominal one."""
TEXTS: Final = ("family", "source", "grade", "title", "place", "confidence")
"""Columns of text."""
NEEDED: Final = ("family", "diameter", "mass", "density", "source")
"""Columns that have to be there, and in which no cell may be empty."""


@dataclass(frozen=True)
class _Size:
    """A row: one size of one grade."""

    line: int
    texts: Mapping[str, str]
    numbers: Mapping[str, float]  # SI; an empty cell is none of them

    @property
    def diameter(self) -> float:
        return self.numbers["diameter"]


def read_stock(path: Path, source: str) -> Catalogue:
    """Read a table of sizes as families; InputError with every problem of it, by its cells.

    Between sizes value/d^2 is interpolated, as of any printed table. The volume is by the mass and
    the density of the material. A row's confidence is A where the table has no such column: the
    document that it names was at hand.
    """
    sheet = _sheet(path, source)
    names = [_named(cell) for cell in sheet.headings]
    known = {**NUMBERS, **dict.fromkeys(TEXTS)}
    units = units_of(sheet, names, known, needed=NEEDED)
    columns = list(zip(names, units, strict=True))
    problems: list[Problem] = []
    sizes = [_size(row, sheet, columns, problems) for row in sheet.rows]
    if not problems:
        problems += _misfits(sizes)
    if problems:
        raise InputError(problems, source)
    families: dict[str, list[_Size]] = {}
    for each in sizes:
        families.setdefault(each.texts["family"], []).append(each)
    return Catalogue(tuple(_family(name, own, path.name) for name, own in families.items()))


def _sheet(path: Path, source: str) -> Sheet:
    """Read the text file, or the first sheet of the workbook."""
    if path.suffix.lower() != ".xlsx":
        return read_sheet(path, source)
    cells = next(iter(read_workbook(path, source).sheets.values()), ())
    first = min((each.row for each in cells), default=0)
    width = max((each.column for each in cells if each.row == first), default=0)
    rows: dict[int, list[str]] = {}
    outside = []
    for each in cells:
        if each.column > width:
            outside.append(
                Problem(each.name, as_text(f"{each.value}"), Message("refused_file.no_heading"))
            )
            continue
        rows.setdefault(each.row, [""] * width)[each.column - 1] = f"{each.value}"
    if outside:
        raise InputError(outside, source)
    below = tuple(Row(line, cells) for line, cells in rows.items() if line != first)
    return Sheet(source, tuple(rows.get(first, ())), below, 0, False)


def _named(cell: str) -> str:
    """Name a column by its heading, whatever its capitals; unknown ones as they are."""
    said = heading(cell)[0]
    small = said.casefold().replace(" ", "_")
    return next((name for name in (*NUMBERS, *TEXTS) if name.casefold() == small), said)


def _size(
    row: Row, sheet: Sheet, columns: Sequence[tuple[str, float]], problems: list[Problem]
) -> _Size:
    texts, numbers = {}, {}
    for (name, unit), cell in zip(columns, row.cells, strict=True):
        place, said = f"line {row.line}, {name}", cell.strip()
        if not said and name in NEEDED:
            problems.append(
                Problem(place, Message("refused_motion.empty_cell"), Message("refused.text"))
            )
        elif name in TEXTS:
            texts[name] = said
        elif said:
            value = number(said, is_decimal_comma=sheet.is_decimal_comma) * unit
            if not value > 0.0:
                problems.append(Problem(place, as_text(said), Message("refused_file.above_0")))
            numbers[name] = value
    if texts.get("confidence", "") not in ("", *CONFIDENCES):
        allowed = Message("refused.one_of", words=", ".join(CONFIDENCES))
        problems.append(
            Problem(f"line {row.line}, confidence", as_text(texts["confidence"]), allowed)
        )
    return _Size(row.line, texts, numbers)


def _misfits(sizes: Sequence[_Size]) -> Iterator[Problem]:
    """Yield sizes that are there twice, and densities of one grade that differ."""
    seen: dict[tuple[str, str, float], int] = {}
    densities: dict[tuple[str, str], float] = {}
    for each in sizes:
        kind = each.texts["family"], each.texts.get("grade", "")
        first = seen.setdefault((*kind, each.diameter), each.line)
        if first != each.line:
            said = Message("refused_file.size_twice", line=first)
            yield Problem(f"line {each.line}, diameter", in_mm(each.diameter), said)
        density = densities.setdefault(kind, each.numbers["density"])
        if each.numbers["density"] != density:
            said = Message("refused_file.one_density", density=density)
            yield Problem(f"line {each.line}, density", f"{each.numbers['density']:g} kg/m3", said)


def _family(name: str, sizes: Sequence[_Size], file: str) -> Family:
    """Make a family of its rows."""
    grades = tuple(dict.fromkeys(filter(None, (each.texts.get("grade") for each in sizes))))
    diameters = tuple(sorted({each.diameter for each in sizes}))
    figures = [
        figure
        for grade in grades or ("",)
        for figure in _figures(
            name,
            grade,
            [each for each in sizes if each.texts.get("grade", "") in ("", grade)],
            file,
        )
    ]
    title = next(filter(None, (each.texts.get("title") for each in sizes)), name)
    lists = Sizes(diameters, *_cited(sizes, file))
    return Family(
        name=name,
        title=Cited(title),
        also=(),
        grades=grades,
        range=(diameters[0], diameters[-1]),
        sizes=lists,
        figures=tuple(figures),
        note="",
    )


def _figures(name: str, grade: str, sizes: Sequence[_Size], file: str) -> Iterator[Figure]:
    """Yield the quantities of a grade, each over the rows that have it."""
    for quantity in SPECS:
        column = "density" if quantity == "volume_diameter" else quantity
        rows = sorted(
            (each for each in sizes if column in each.numbers), key=lambda each: each.diameter
        )
        if not rows:
            continue
        sources, place, confidence = _cited(rows, file)
        yield Figure(
            quantity=quantity,
            variant="",
            families=(name,),
            grades=(grade,) if grade else (),
            formula=_formula(column, rows),
            range=(rows[0].diameter, rows[-1].diameter),
            sources=sources,
            place=place,
            confidence=confidence,
        )


def _formula(column: str, rows: Sequence[_Size]) -> Formula:
    if column == "density":
        return Density(rows[0].numbers["density"])
    values = tuple(each.numbers[column] for each in rows)
    if len(rows) == 1:
        return Polynomial(((2, values[0] / rows[0].diameter ** 2),))
    return Rows(tuple(each.diameter for each in rows), values)


def _cited(rows: Sequence[_Size], file: str) -> tuple[tuple[Source, ...], str, Confidence]:
    """Say where rows come from: their documents, the lines of the table, the weakest grade."""
    titles = dict.fromkeys(each.texts["source"] for each in rows)
    sources = tuple(Source(title, Cited(title), Cited(file)) for title in titles)
    places = dict.fromkeys(filter(None, (each.texts.get("place", "") for each in rows)))
    lines = sorted(each.line for each in rows)
    place = ", ".join(places) or f"{file}:{lines[0]}-{lines[-1]}"
    said = {each.texts.get("confidence") or CONFIDENCES[0] for each in rows}
    return sources, Cited(place), weakest(each for each in CONFIDENCES if each in said)
