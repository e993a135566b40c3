"""A table as plain values: every number in it carries its value in SI, to the last digit."""

from __future__ import annotations

from dataclasses import dataclass

from catopt.quantities import GREEK, Quantity
from catopt.render.texts import Phrase, Words

__all__ = [
    "Cell",
    "Heading",
    "Table",
    "called",
    "in_unit",
    "label_of",
    "measured",
    "number_heading",
    "said",
    "shown_si",
    "units",
]


@dataclass(frozen=True)
class Cell:
    """One cell.

    Attributes
    ----------
    text : str
        What is shown.
    si : float or None
        The value behind it, in SI; None where it is no number.
    lang : str
        Language of the text where it is not the page's.
    bar : float or None
        Length of the bar that is drawn in it, as a part of the whole; None: no bar.
    style : str
        Class of the cell.
    """

    text: str
    si: float | None = None
    lang: str = ""
    bar: float | None = None
    style: str = ""


@dataclass(frozen=True)
class Heading:
    """Heading of a column; numbers are set flush right."""

    text: str
    is_number: bool = False


@dataclass(frozen=True)
class Table:
    """Rows of cells under headings.

    Attributes
    ----------
    key : str
        Name within the page.
    headings : tuple of Heading
        One a column.
    rows : tuple of tuple of Cell
        The first cell of each is its heading.
    caption : str
        Above it.
    marked : int or None
        Index of a row that is pointed out.
    """

    key: str
    headings: tuple[Heading, ...]
    rows: tuple[tuple[Cell, ...], ...]
    caption: str = ""
    marked: int | None = None


def measured(quantity: Quantity, si: float | None, *, unit: bool = False) -> Cell:
    """Show a value in the field's unit; a dash where it is not known."""
    return Cell("–" if si is None else quantity.format(si, unit=unit), si)


def shown_si(si: float, unit: str) -> str:
    """Write a value in SI with the digits of a hand calculation."""
    return f"{si:.9g} {unit}".rstrip(" -")


def said(phrase: Phrase, style: str = "") -> Cell:
    """Make a cell of a sentence that the code made."""
    return Cell(phrase.text, lang=phrase.lang, style=style)


def label_of(words: Words, quantity: Quantity) -> str:
    """Name a quantity with its symbol, Greek letters as such: ``Span S``."""
    symbol = GREEK.get(quantity.symbol, quantity.symbol)
    return f"{words.sentence(quantity.name).text} {symbol}".rstrip()


def called(words: Words, submerged_weight: float, name: str) -> str:
    """Say what hangs on the line, with its own name where that says more: ``clump weight: A``."""
    kind = words("components.clump" if submerged_weight >= 0.0 else "components.buoy")
    return f"{kind}: {name}" if name and name.casefold() != kind else kind


def in_unit(label: str, quantity: Quantity) -> str:
    """Write a label with the field's unit, no unit for a pure number: ``Offset (m)``."""
    return label if quantity.field_unit == "-" else f"{label} ({quantity.field_unit})"


def number_heading(label: str, quantity: Quantity) -> Heading:
    """Head a column of numbers, in the field's unit of a quantity."""
    return Heading(in_unit(label, quantity), is_number=True)


def units(words: Words, quantity: Quantity) -> Heading:
    """Head a column with a quantity in the field's unit."""
    return number_heading(label_of(words, quantity), quantity)
