"""The blocks that every answer consists of; values in SI, words as messages, no face.

A renderer (`catopt.render`) knows these blocks and nothing of what they are about. The name of a
block is that of its file or its key within a page, its caption a message above it, and `only` for
whom it is.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, Final, Literal

from catopt.figures.chart import Chart
from catopt.quantities import QUANTITIES, Quantity
from catopt.words import (
    LANGUAGES,
    Language,
    Measure,
    Message,
    Translated,
    heading,
    quantity_name,
    say,
    term,
)

if TYPE_CHECKING:
    import pandas as pd

    from catopt.checks.verdict import Judgement

Value = float | str | None
"""A number in SI, a count, a message, the user's own words, or None where it is not known."""

For = Literal["all", "people", "files", "workbook", "not csv"]
"""People read terminals and pages; files are CSV and workbooks. Columns are of people or files."""


@dataclass(frozen=True)
class Column:
    """A column of a table under its heading, a message; symbol and unit come from the quantity."""

    name: str
    values: tuple[Value, ...]
    quantity: Quantity | None = None
    """What its numbers are; None for words and counts."""
    units: tuple[Quantity, ...] = ()
    """In place of one quantity, that of each row: people read a unit with each value, files have
    a further column with it."""
    priority: int = 0
    """Where a terminal has no room for all, columns above 0 are left out, the highest first."""
    only: For = "all"
    passes: tuple[bool | None, ...] = ()
    """What each row comes to, where the column says so: good and bad look different."""
    formula: tuple[Column, Literal["/", "-"], Column] | None = None
    """``(demand, "/", capacity)``: what a spreadsheet computes it by, of columns beside it."""

    @property
    def is_number(self) -> bool:
        """Whether it holds measured values or counts, which are set flush right."""
        return bool(self.quantity or self.units) or all(
            isinstance(value, int | float) for value in self.values
        )

    @property
    def is_known(self) -> bool:
        """Whether it has a value in any row."""
        return any(value is not None for value in self.values)

    def quantity_of(self, row: int) -> Quantity | None:
        """Return what the number in a row is."""
        return self.units[row] if self.units else self.quantity

    def said_heading(self, language: Language = "en") -> str:
        """In files, in a language: ``Fairlead tension T (kN)``."""
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
    """Rows under headings; its columns are all of the same length."""

    name: str
    columns: tuple[Column, ...]
    caption: str = ""
    shown: tuple[int, ...] | None = None
    """Rows that people see; all of them when None."""
    marked: int | None = None
    """Row that is pointed out."""
    parts: tuple[tuple[str, tuple[int, ...]], ...] = ()
    """Captions and rows of the tables into which it falls for people; one table when empty."""
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

        return pd.DataFrame({each.said_heading(): _series(each) for each in self.for_files()})


@dataclass(frozen=True)
class Fact:
    """One named value, in SI or words; its name is a message."""

    name: str
    value: Value
    quantity: Quantity | None = None
    also: tuple[Quantity, ...] = ()
    """The same in further units."""
    only: For = "all"

    def columns(self) -> Iterator[Column]:
        """Yield it as columns of one row, one a unit."""
        for quantity in (self.quantity, *self.also):
            yield Column(self.name, (self.value,), quantity, only=self.only)


@dataclass(frozen=True)
class Facts:
    """A list of named values."""

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
    """A paragraph, a message; a small one only says how to read what is above it."""

    said: str
    caption: str = ""
    only: For = "all"
    is_small: bool = False


@dataclass(frozen=True)
class Verdict:
    """What an answer comes to: good, bad, or neither where that is None.

    Of the verdict on a mooring `of_judgement` makes it.
    """

    said: str
    passes: bool | None
    is_partial: bool = False
    """Whether it passes as far as it was judged, and that is not all."""

    @classmethod
    def of_judgement(cls, of: Judgement) -> Verdict:
        """Take word and colour."""
        return cls(of.said, of.passes, of.colour == "amber")

    @property
    def kind(self) -> Literal["", "passes", "in-part", "fails"]:
        """How it looks."""
        if self.passes is None:
            return ""
        if self.passes and self.is_partial:
            return "in-part"
        return "passes" if self.passes else "fails"


@dataclass(frozen=True)
class Warnings:
    """What is to be known before an answer is used."""

    said: tuple[str, ...]
    only: For = "all"


@dataclass(frozen=True)
class Graph:
    """Columns of a table of the same section, drawn by the spreadsheet program."""

    title: str
    table: str
    """Name of the table."""
    x: int
    """Place of the column that is drawn along, among those of files."""
    y: tuple[int, ...]
    """Places of those that are drawn over it."""
    log: tuple[float, float] | None = None
    """Ends of a logarithmic axis of y."""
    points: bool = False
    """Whether they are points, not lines."""


@dataclass(frozen=True)
class Points:
    """Sentences of equal weight, one below the other."""

    said: tuple[str, ...]
    caption: str = ""


@dataclass(frozen=True)
class Brief:
    """What a card says under a label, as far as there is room; the rest is counted."""

    said: tuple[str, ...]
    label: str = ""
    lines: int = 1
    """That it takes at most."""


TO_BE_KNOWN: Final = Message("answers.card_to_be_known")
"""Label of what decides whether an answer may be used: a card keeps the first of it."""


@dataclass(frozen=True)
class Figure:
    """A drawing of what a chart shows."""

    chart: Chart
    caption: str = ""


@dataclass(frozen=True)
class Step:
    """A step of a calculation by hand: what comes out, a message, and the same in SI."""

    name: str
    value: float | None
    quantity: Quantity
    symbol: str = ""
    formula: str | tuple[str, ...] = ""
    """What it is by others, in braces: ``"{H} / {w}"``; of several that are multiplied each by
    itself. Behind a colon stands how a number is written: ``{t:()}`` in brackets where it is
    negative, ``{b:°}`` with its sign, ``{V:2}`` with its power."""
    numbers: Mapping[str, float] = field(default_factory=dict)
    """What goes into the braces, by symbol."""
    terms: tuple[tuple[float, ...], ...] = ()
    """In place of numbers, products that are added up."""
    stated: float | None = None
    """The same as somebody else has it."""
    equation: str = ""
    """Number of its equation."""
    source: str = ""
    """Where a figure is from."""
    digits: int = 9
    """With how many the numbers are written."""


@dataclass(frozen=True)
class Trail:
    """A calculation by hand, step by step."""

    name: str
    steps: tuple[Step, ...]
    stated: str = ""
    """What stands beside each value, a message; empty where nothing does."""
    caption: str = ""


@dataclass(frozen=True)
class FileText:
    """A file that an answer rests on, in full."""

    name: str
    sha256: str
    text: str


Block = Table | Facts | Text | Verdict | Warnings | Graph | Points | Figure | Trail | FileText


CardBlock = Text | Verdict | Facts | Table | Brief
"""What may stand on a card."""


@dataclass(frozen=True)
class Section:
    """Blocks that belong together: a sheet of a workbook, a part of a page."""

    title: str
    blocks: tuple[Block, ...]
    name: str = ""
    """Its key within a page; none where it is on no page."""


@dataclass(frozen=True)
class PageHead:
    """What stands at the head of every printed page, and the firm's logo."""

    firm: str
    """Client and project."""
    number: str
    """Of the document, with its revision."""
    logo: str = ""
    """As an address that holds it; empty without one."""


@dataclass(frozen=True)
class Answer:
    """All of an answer, under the user's own title or a message; it names document and workbook."""

    name: str
    title: str
    sections: tuple[Section, ...]
    kind: str = ""
    """What kind of note it is, a message; empty where it is none."""
    card: tuple[CardBlock, ...] = ()
    """The same on one screen, for who does not ask for all of it; where it is empty, the screen
    has what the sections say, as far as there is room."""
    next: str = ""
    """Of which answers the text is that says what to type next; empty: of those of its name."""
    head: PageHead | None = None
    """Of a firm's document."""

    @property
    def blocks(self) -> tuple[Block, ...]:
        """Those of all sections."""
        return tuple(block for section in self.sections for block in section.blocks)


# ------------------------------------------------------------------ making them


def answered(name: str, title: str, *sections: Section) -> Answer:
    """Make an answer of its sections."""
    return Answer(name, title, sections)


def section(title: str, *blocks: Block) -> Section:
    """Make a section under a message, or under the key of one."""
    return Section(title if isinstance(title, Message) else Message(title), blocks)


def tabulate(name: str, *columns: Column, **how: Any) -> Table:
    """Make a table of its columns; `how` are the other fields of `Table`."""
    return Table(name, columns, **how)


def named(key: str, symbol: str | None = None) -> Quantity:
    """Take a quantity of the table, under another symbol where one is given."""
    quantity = QUANTITIES[key]
    return quantity if symbol is None else replace(quantity, symbol=symbol)


_DIGITS = 4
"""Of a number that people decide by: more than what it rests on is known to."""


def rounded(key: str, value: float) -> Quantity:
    """Take a quantity with the digits that a value of it, in SI, is known to."""
    quantity = named(key, "")
    if not value or not math.isfinite(value):
        return quantity
    before = 1 + math.floor(math.log10(abs(quantity.to_field(value))))
    return replace(quantity, digits=min(quantity.digits, max(0, _DIGITS - before)))


def about(key: str, value: float) -> Measure:
    """Say a value in SI with the digits that it is known to."""
    return Measure(key, value, digits=rounded(key, value).digits)


def in_si(quantity: Quantity, digits: int) -> Quantity:
    """Take a quantity in its SI unit."""
    return replace(quantity, field_unit=quantity.si_unit, factor=1.0, digits=digits)


def bare(quantity: Quantity) -> Quantity:
    """Take a quantity whose unit stands in another place than behind its value."""
    return replace(quantity, field_unit="-")


def exact(unit: str) -> Quantity:
    """Take what is written in SI with the digits of a hand calculation."""
    return Quantity("exact", "", "", unit or "-", unit or "-", 1.0, 9, "significant")


def column_name(name: str) -> Message:
    """Take a heading: a message, the key of one, or its name in the group ``columns``."""
    if isinstance(name, Message):
        return name
    return Message(name if "." in name else f"columns.{name}")


def measured(
    quantity: str | Quantity,
    values: Iterable[float | None],
    name: str = "",
    *,
    symbol: str | None = None,
    **how: Any,
) -> Column:
    """Make a column of a quantity, or of the key of one; values are in SI.

    `name` as `column_name` takes it; the quantity's own name, and its symbol, where they are left
    out. `how` are the other fields of `Column`.
    """
    known = named(quantity, symbol) if isinstance(quantity, str) else quantity
    said = column_name(name) if name else quantity_name(known.key)
    numbers = tuple(None if value is None else float(value) for value in values)
    return Column(said, numbers, known, **how)


def texts(name: str, values: Iterable[Value], **how: Any) -> Column:
    """Make a column of words or counts; `name` as `column_name` takes it."""
    return Column(column_name(name), tuple(values), **how)


def if_known(*columns: Column) -> Iterator[Column]:
    """Yield the columns that have a value in any row."""
    return (column for column in columns if column.is_known)


def largest(values: Iterable[float | None]) -> float | None:
    """Find the largest of the values that are known; None where none is."""
    return max((value for value in values if value is not None), default=None)


def stacked(tables: Sequence[Table]) -> Iterator[Column]:
    """Yield the columns of tables that have the same ones, one table below the other."""
    for same in zip(*(each.columns for each in tables), strict=True):
        _, values = Rows(same).within("values")
        yield replace(same[0], values=values.rows)


class Rows:
    """The rows of a table; makes a column of what it reads of each.

    That is a path of attributes, such as ``"fairlead.tension"``, or what a function makes of a row.
    It is None where the row is None, or what the path goes through.
    """

    def __init__(self, rows: Iterable[Any]) -> None:
        self.rows = tuple(rows)

    def read(self, what: str | Callable[[Any], Any]) -> list[Any]:
        """Read of each row."""
        if not isinstance(what, str):
            return [None if row is None else what(row) for row in self.rows]
        found: Iterable[Any] = self.rows
        for part in what.split("."):
            found = [None if each is None else getattr(each, part) for each in found]
        return list(found)

    def measured(
        self,
        quantity: str | Quantity,
        what: str | Callable[[Any], Any],
        name: str = "",
        **how: Any,
    ) -> Column:
        """Make a column of a quantity, as `measured` does."""
        return measured(quantity, self.read(what), name, **how)

    def own(self, *keys: str, **how: Any) -> Iterator[Column]:
        """Yield columns of what each row has under a key: of a quantity's a measured one."""
        for key in keys:
            yield self.measured(key, key, **how) if key in QUANTITIES else self.texts(key, **how)

    def texts(self, name: str, what: str | Callable[[Any], Any] = "", **how: Any) -> Column:
        """Make a column of words or counts, under the name of the attribute where none is given."""
        return texts(name, self.read(what or name), **how)

    def within(self, what: str | Callable[[Any], Any]) -> tuple[Rows, Rows]:
        """Take the rows that each has within it: its own, as often as needed, and these."""
        pairs = [
            (row, each)
            for row, inner in zip(self.rows, self.read(what), strict=True)
            for each in inner
        ]
        return Rows(row for row, _ in pairs), Rows(each for _, each in pairs)

    def of_row(self, name: str, what: str | Callable[[Any], Any] = "", **how: Any) -> Column:
        """Make a column of values in the units of a column beside it, as they are."""
        said = Message("columns.of_row", name=column_name(name))
        return Column(said, tuple(self.read(what or name)), **how)


def fact(
    key: str,
    value: float | None,
    name: str = "",
    *,
    symbol: str | None = None,
    **how: Any,
) -> Fact:
    """Make a fact of the key of a quantity, named as `measured` names a column; in SI."""
    own = measured(key, (), name, symbol=symbol)
    return Fact(own.name, value, own.quantity, **how)


def stated(name: str, value: Value, **how: Any) -> Fact:
    """Make a fact of words or a count; `name` as `column_name` takes it."""
    return Fact(column_name(name), value, **how)


def briefly(said: Iterable[str], label: str = "", lines: int = 1) -> Iterator[Brief]:
    """Say on a card what there is to say under a label; nothing where that is nothing."""
    if every := tuple(said):
        yield Brief(every, label, lines)


def in_words(each: Fact) -> Message:
    """Say a fact in a sentence: ``"Water depth 20.000 m"``."""
    value: object = each.value
    if each.quantity is not None and isinstance(each.value, int | float):
        value = Measure(each.quantity.key, each.value)
    return Message("words.label", name=each.name, symbol="-" if value is None else value)


def labelled(name: str, symbol: str) -> str:
    """Put a symbol behind a name, where there is one."""
    return Message("words.label", name=name, symbol=symbol) if symbol else name


def keyed(key: str, name: str) -> Message:
    """Take a key of documents, which English files have as it is; other languages have its name."""
    return Translated({each: key if each == "en" else say(name, each) for each in LANGUAGES})


def yes_or_no(is_so: bool) -> Message:
    """Say whether something is so."""
    return Message("answers.yes" if is_so else "answers.no")


def _series(column: Column) -> pd.Series:
    import pandas as pd

    values = [column.in_files(row) for row in range(len(column.values))]
    if column.quantity is None and not column.units:
        return pd.Series(values, dtype="object" if not column.is_number else None)
    return pd.Series(values, dtype="float64")
