"""The blocks that every answer consists of; values in SI, words as messages, no face.

A renderer (`catopt.render`) knows these blocks and nothing of what they are about.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Literal, TypeVar

from catopt.figures.chart import Chart
from catopt.quantities import QUANTITIES, Quantity
from catopt.words import Language, Message, Several, Told, heading, quantity_name, say, term

if TYPE_CHECKING:
    import pandas as pd

_Thing = TypeVar("_Thing")
_Known = TypeVar("_Known")

Value = float | str | None
"""A number in SI, a count, a message, the user's own words, or None where it is not known."""

For = Literal["all", "people", "files", "workbook", "not csv"]
"""People read terminals and pages; files are CSV and workbooks. Columns are of people or files."""


@dataclass(frozen=True)
class Column:
    """A column of a table.

    Attributes
    ----------
    name : str
        Its heading, a message; symbol and unit come from the quantity.
    values : tuple of Value
        One a row.
    quantity : Quantity or None
        What its numbers are; None for words and counts.
    units : tuple of Quantity
        In place of one quantity, that of each row: people read a unit with each value, files have
        a further column with it.
    priority : int
        Columns above 0 are left out, the highest first, where a terminal has no room for them.
    only : For
        For whom it is.
    passes : tuple of bool or None
        What each row comes to, where the column says so: good and bad look different.
    formula : tuple of Column and str, optional
        ``(demand, "/", capacity)``: what a spreadsheet computes it by, of columns beside it.
    """

    name: str
    values: tuple[Value, ...]
    quantity: Quantity | None = None
    units: tuple[Quantity, ...] = ()
    priority: int = 0
    only: For = "all"
    passes: tuple[bool | None, ...] = ()
    formula: tuple[Column, Literal["/", "-"], Column] | None = None

    @property
    def is_number(self) -> bool:
        """Whether it holds measured values or counts, which are set flush right."""
        return bool(self.quantity or self.units) or all(
            isinstance(value, int | float) for value in self.values
        )

    def quantity_of(self, row: int) -> Quantity | None:
        """Return what the number in a row is."""
        return self.units[row] if self.units else self.quantity

    @property
    def heading(self) -> str:
        """In files, in English: ``Fairlead tension T (kN)``."""
        return self.said_heading("en")

    def said_heading(self, language: Language) -> str:
        """In files, in a language."""
        if self.units:
            return say(Message("columns.of_row", name=self.name), language)
        if self.quantity is None:
            return say(self.name, language)
        return heading(self.name, self.quantity, language)

    def in_files(self, row: int) -> Value:
        """Value of a row in the field's unit."""
        value, quantity = self.values[row], self.quantity_of(row)
        if quantity is None or isinstance(value, str):
            return value
        return math.nan if value is None else quantity.in_files(value)


@dataclass(frozen=True)
class Table:
    """Rows under headings.

    Attributes
    ----------
    name : str
        Of its file.
    columns : tuple of Column
        All of the same length.
    caption : str
        Above it, a message.
    shown : tuple of int, optional
        Rows that people see; all of them when None.
    marked : int, optional
        Row that is pointed out.
    parts : tuple of (str, tuple of int)
        Captions and rows of the tables into which it falls for people; one table when empty.
    only : For
        For whom it is.
    """

    name: str
    columns: tuple[Column, ...]
    caption: str = ""
    shown: tuple[int, ...] | None = None
    marked: int | None = None
    parts: tuple[tuple[str, tuple[int, ...]], ...] = ()
    only: For = "all"

    @property
    def length(self) -> int:
        """How many rows it has."""
        return len(self.columns[0].values)

    def for_files(self) -> Iterator[Column]:
        """Yield the columns of files; units of rows stand behind the last that needs them."""
        last = max((k for k, each in enumerate(self.columns) if each.units), default=-1)
        for k, each in enumerate(self.columns):
            if each.only != "people":
                yield each
            if k == last:
                yield texts("unit", [term(quantity.field_unit) for quantity in each.units])

    def to_dataframe(self) -> pd.DataFrame:
        """Return it as it stands in files, in the field's units, with English headings."""
        import pandas as pd

        laid = {each.heading: _series(each) for each in self.for_files()}
        return pd.DataFrame(laid)


@dataclass(frozen=True)
class Fact:
    """One named value.

    Attributes
    ----------
    name : str
        What it is, a message.
    value : Value
        In SI, or words.
    quantity : Quantity or None
        What a number is.
    also : tuple of Quantity
        The same in further units.
    only : For
        For whom it is.
    """

    name: str
    value: Value
    quantity: Quantity | None = None
    also: tuple[Quantity, ...] = ()
    only: For = "all"

    def columns(self) -> Iterator[Column]:
        """Yield it as columns of one row, one a unit."""
        for quantity in (self.quantity, *self.also):
            yield Column(self.name, (self.value,), quantity, only=self.only)


@dataclass(frozen=True)
class Facts:
    """A list of named values.

    Attributes
    ----------
    name : str
        Of its file.
    facts : tuple of Fact
        In their order.
    caption : str
        Above it, a message.
    only : For
        For whom it is.
    """

    name: str
    facts: tuple[Fact, ...]
    caption: str = ""
    only: For = "all"

    def as_table(self) -> Table:
        """Lay it out as a table of one row, as files have it."""
        columns = tuple(column for fact in self.facts for column in fact.columns())
        return Table(self.name, columns, self.caption, only=self.only)

    def to_dataframe(self) -> pd.DataFrame:
        """Return it as one row, in the field's units, with English headings."""
        return self.as_table().to_dataframe()


@dataclass(frozen=True)
class Text:
    """A paragraph.

    Attributes
    ----------
    said : str
        A message.
    caption : str
        Above it.
    only : {"all", "people", "files", "workbook"}
        For whom it is.
    is_small : bool
        Whether it only says how to read what is above it.
    """

    said: str
    caption: str = ""
    only: For = "all"
    is_small: bool = False


@dataclass(frozen=True)
class Verdict:
    """What an answer comes to: good, bad, neither where that is None, or good with a reserve.

    Attributes
    ----------
    said : str
        In words.
    passes : bool or None
        Whether it is good.
    reserve : str
        What is not good beside it, which is then said with it; empty where nothing is.
    """

    said: str
    passes: bool | None
    reserve: str = ""

    @property
    def words(self) -> str:
        """All that is said."""
        return Several((self.said, self.reserve), " ") if self.reserve else self.said

    @property
    def kind(self) -> Literal["", "passes", "reserve", "fails"]:
        """How it looks."""
        if self.passes is None:
            return ""
        return "fails" if not self.passes else "reserve" if self.reserve else "passes"


@dataclass(frozen=True)
class Warnings:
    """What is to be known before an answer is used."""

    said: tuple[str, ...]
    only: For = "all"


@dataclass(frozen=True)
class Graph:
    """Columns of a table of the same section, drawn by the spreadsheet program.

    Attributes
    ----------
    title : str
        Above it.
    table : str
        Name of the table.
    x : int
        Place of the column that is drawn along, among those of files.
    y : tuple of int
        Places of those that are drawn over it.
    log : tuple of float, optional
        Ends of a logarithmic axis of y.
    points : bool
        Whether they are points, not lines.
    """

    title: str
    table: str
    x: int
    y: tuple[int, ...]
    log: tuple[float, float] | None = None
    points: bool = False


@dataclass(frozen=True)
class Points:
    """Sentences of equal weight, one below the other.

    Attributes
    ----------
    said : tuple of str
        Messages.
    caption : str
        Above them.
    """

    said: tuple[str, ...]
    caption: str = ""


@dataclass(frozen=True)
class Figure:
    """A drawing.

    Attributes
    ----------
    chart : Chart
        What it shows.
    caption : str
        Above it, a message.
    """

    chart: Chart
    caption: str = ""


@dataclass(frozen=True)
class Step:
    """A step of a calculation by hand.

    Attributes
    ----------
    name : str
        What comes out, a message.
    value : float or None
        The same in SI.
    quantity : Quantity
        What it is.
    symbol : str
        Its symbol.
    formula : str, or tuple of str
        What it is by others, in braces: ``"{H} / {w}"``; of several that are multiplied each by
        itself. Behind a colon stands how a number is written: ``{t:()}`` in brackets where it is
        negative, ``{b:°}`` with its sign, ``{V:2}`` with its power.
    numbers : mapping of str to float
        What goes into the braces, by symbol.
    terms : tuple of tuple of float
        In place of numbers, products that are added up.
    stated : float or None
        The same as somebody else has it.
    equation, source : str
        Number of its equation, and where a figure is from.
    digits : int
        With how many the numbers are written.
    """

    name: str
    value: float | None
    quantity: Quantity
    symbol: str = ""
    formula: str | tuple[str, ...] = ""
    numbers: Mapping[str, float] = field(default_factory=dict)
    terms: tuple[tuple[float, ...], ...] = ()
    stated: float | None = None
    equation: str = ""
    source: str = ""
    digits: int = 9


@dataclass(frozen=True)
class Trail:
    """A calculation by hand, step by step.

    Attributes
    ----------
    name : str
        Its key within a page.
    steps : tuple of Step
        In their order.
    stated : str
        What stands beside each value, a message; empty where nothing does.
    caption : str
        Above it.
    """

    name: str
    steps: tuple[Step, ...]
    stated: str = ""
    caption: str = ""


@dataclass(frozen=True)
class FileText:
    """A file that an answer rests on, in full."""

    name: str
    sha256: str
    text: str


Block = Table | Facts | Text | Verdict | Warnings | Graph | Points | Figure | Trail | FileText


@dataclass(frozen=True)
class Section:
    """Blocks that belong together: a sheet of a workbook, a part of a page.

    Attributes
    ----------
    title : str
        A message.
    blocks : tuple of Block
        In their order.
    name : str
        Its key within a page; none where it is on no page.
    """

    title: str
    blocks: tuple[Block, ...]
    name: str = ""


@dataclass(frozen=True)
class Answer:
    """All of an answer.

    Attributes
    ----------
    name : str
        Of its document and its workbook.
    title : str
        The user's own, or a message.
    sections : tuple of Section
        In their order.
    kind : str
        What kind of note it is, a message; empty where it is none.
    """

    name: str
    title: str
    sections: tuple[Section, ...]
    kind: str = ""

    @property
    def blocks(self) -> tuple[Block, ...]:
        """Those of all sections."""
        return tuple(block for section in self.sections for block in section.blocks)


# ------------------------------------------------------------------ making them


def named(key: str, symbol: str | None = None) -> Quantity:
    """Take a quantity of the table, under another symbol where one is given."""
    quantity = QUANTITIES[key]
    return quantity if symbol is None else replace(quantity, symbol=symbol)


def in_si(quantity: Quantity, digits: int) -> Quantity:
    """Take a quantity in its SI unit."""
    return replace(quantity, field_unit=quantity.si_unit, factor=1.0, digits=digits)


def bare(quantity: Quantity) -> Quantity:
    """Take a quantity whose unit stands in another place than behind its value."""
    return replace(quantity, field_unit="-")


def exact(unit: str) -> Quantity:
    """Take what is written in SI with the digits of a hand calculation."""
    return Quantity("exact", "", "", unit or "-", unit or "-", 1.0, 9, "significant")


def measured(
    key: str,
    values: Iterable[float | None],
    name: str = "",
    *,
    symbol: str | None = None,
    priority: int = 0,
    only: For = "all",
) -> Column:
    """Make a column of a quantity.

    `key` is one of `catopt.quantities.QUANTITIES`, values are in SI, `name` is a key of the group
    ``columns``; the quantity's own name and symbol where they are left out.
    """
    said = Message(f"columns.{name}") if name else quantity_name(key)
    known = tuple(None if value is None else float(value) for value in values)
    return Column(said, known, named(key, symbol), priority=priority, only=only)


def fact(
    key: str,
    value: float | None,
    name: str = "",
    *,
    symbol: str | None = None,
    said: str = "",
    only: For = "all",
) -> Fact:
    """Make a fact of a quantity.

    `key` is one of `catopt.quantities.QUANTITIES`, the value is in SI, `name` a key of the group
    ``columns``, or `said` says what it is; left out, they are the quantity's own name and symbol.
    """
    known = said or (Message(f"columns.{name}") if name else quantity_name(key))
    return Fact(known, value, named(key, symbol), only=only)


def texts(
    name: str, values: Sequence[Value] | Iterable[Value], *, priority: int = 0, only: For = "all"
) -> Column:
    """Make a column of words or counts, by the key of its heading in the group ``columns``."""
    return Column(Message(f"columns.{name}"), tuple(values), priority=priority, only=only)


def keyed(key: str, name: str) -> Message:
    """Take a key of documents, which English files have as it is; other languages have its name."""
    return Told({"en": key, "vi": say(name, "vi")})


def of_row(name: str, values: Iterable[Value], *, only: For = "all") -> Column:
    """Make a column of values in the units of a column beside it, as they are."""
    heading = Message("columns.of_row", name=Message(f"columns.{name}"))
    return Column(heading, tuple(values), only=only)


def yes_or_no(is_so: bool) -> Message:
    """Say whether something is so."""
    return Message("answers.yes" if is_so else "answers.no")


def where_known(
    things: Iterable[_Thing | None], value: Callable[[_Thing], _Known]
) -> list[_Known | None]:
    """Take a value of each thing; None where there is none."""
    return [None if each is None else value(each) for each in things]


def _series(column: Column) -> pd.Series:
    import pandas as pd

    values = [column.in_files(row) for row in range(len(column.values))]
    if column.quantity is None and not column.units:
        return pd.Series(values, dtype="object" if not column.is_number else None)
    return pd.Series(values, dtype="float64")
