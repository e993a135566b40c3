"""The outcome of a reproduction, as values."""

from __future__ import annotations

from dataclasses import dataclass
from decimal import Decimal
from typing import Annotated, Literal

from catopt.catenary.solution import Solution
from catopt.records import Counted, From, Record
from catopt.shown import Tabled
from catopt.words import Message, Several, term

Verdict = Literal["reproduces", "differs", "not reproducible"]


@dataclass(frozen=True)
class Printed:
    """A number as printed, such as ``"17.430"``; the closing zero is a claim."""

    text: str
    """Digit for digit as printed."""

    @property
    def value(self) -> float:
        """The number."""
        return float(self.text)

    @property
    def decimals(self) -> int:
        """Digits after the point; of ``3.55e-15`` they are 17."""
        exponent = Decimal(self.text).as_tuple().exponent
        assert isinstance(exponent, int), f"{self.text} is not a finite number"
        return -exponent

    @property
    def digits(self) -> Counted:
        """Significant digits of the printed number.

        They are 5 in ``17.430``. A printed zero counts its decimals, or one.
        """
        number = Decimal(self.text)
        return len(number.as_tuple().digits) if number else max(self.decimals, 1)

    def rounding(self, value: float, *, further: int = 0) -> str:
        """Write a value to the decimals of this print."""
        return f"{value:.{self.decimals + further}f}"

    @property
    def bounds(self) -> tuple[float, float]:
        """The least and the largest value that prints so."""
        half = Decimal(5).scaleb(-self.decimals - 1)
        number = Decimal(self.text)
        return float(number - half), float(number + half)


@dataclass(frozen=True)
class Judgement:
    """A verdict, the computed number as it is compared, and the reason where one is due."""

    verdict: Verdict
    computed_text: str
    """Rounded as it was compared; empty when nothing was computed."""
    reason: str = ""


@dataclass(frozen=True)
class Item(Record):
    """One printed number and what became of it."""

    DOCUMENT = (
        "source name quantity method published printed.text=published_text computed "
        "judgement.computed_text computed_by unit printed.digits=printed_digits verdict note"
    )

    source: str
    """Short name of the source, such as S1."""
    name: str
    """Of the study."""
    quantity: str
    """What was printed, with its unit, such as offset_m."""
    unit: str
    """Of published and computed, such as m, rad, tf or %; - for a pure number."""
    method: str
    """How the source came by it, or which of its tables it is in: pso, pso against fem, Table 1."""
    computed_by: str
    """How catopt computed it, such as pso or closed-form; empty when it did not."""
    printed: Printed
    computed: float | None
    """Unrounded, in unit; None when nothing was computed."""
    judgement: Judgement
    remark: str = ""
    """What a reader should know beside the verdict."""

    @property
    def verdict(self) -> Verdict:
        """Reproduces: the computed number, rounded as printed, has every printed digit."""
        return self.judgement.verdict

    @property
    def published(self) -> float:
        """The printed number, in unit."""
        return self.printed.value

    @property
    def note(self) -> str:
        """The reason for the verdict and what else to know, in one line; may be empty."""
        return Several(part for part in (self.judgement.reason, self.remark) if part)


@dataclass(frozen=True)
class Input(Record):
    """What went into a study."""

    DOCUMENT = "quantity value unit origin"

    quantity: str
    """In words."""
    value: str
    """As used, in unit."""
    unit: str
    """Empty for a pure number."""
    origin: str = "printed"
    """Whether it was printed, or how it was found."""

    def __post_init__(self) -> None:
        for key in ("quantity", "value", "origin"):
            object.__setattr__(self, key, term(getattr(self, key)))


@dataclass(frozen=True)
class SideBySide(Record):
    """Several answers to the same questions, as a table of words."""

    DOCUMENT = "title header rows"

    title: str
    """What the table shows."""
    header: tuple[str, ...]
    """What each column holds, with its unit."""
    rows: tuple[tuple[str, ...], ...]
    """Cells."""

    def __post_init__(self) -> None:
        object.__setattr__(self, "title", term(self.title))
        object.__setattr__(self, "header", tuple(map(term, self.header)))
        object.__setattr__(self, "rows", tuple(tuple(map(term, row)) for row in self.rows))


def in_unit(quantity: str, unit: str) -> Message:
    """Say what a row or a column of numbers is: ``"turret offset (m)"``."""
    return Message("words.heading", label=term(quantity), unit=unit)


@dataclass(frozen=True)
class MooredLine:
    """Where one line of a moored body lies, from its anchor; m.

    `x`, `y`, `z`: places along it, z above the seabed; `on_bed`: whether the line lies on the bed
    there, or is held down to it.
    """

    x: tuple[float, ...]
    y: tuple[float, ...]
    z: tuple[float, ...]
    on_bed: tuple[bool, ...]


@dataclass(frozen=True)
class Mooring:
    """A moored body at rest, for a plan and an elevation: what it is called, and its lines."""

    name: str
    lines: tuple[MooredLine, ...]


@dataclass(frozen=True)
class Drawn:
    """A line of a study that is drawn: what it is called, how it hangs, and the water's depth (m).

    Without a depth the fairlead is at the surface.
    """

    name: str
    solution: Solution
    depth: float = 0.0


@dataclass(frozen=True)
class Heading:
    """What a calculation is about, and where it was published."""

    name: str
    """By which the command knows it."""
    title: str
    """What it is about."""
    source: str
    """Short name of the source."""
    source_title: str
    """Its title."""
    source_where: str
    """Where it was published."""
    where: str
    """Place in the source."""


@dataclass(frozen=True)
class Study(Heading, Record):
    """One published calculation, recomputed."""

    DOCUMENT = "name title source source_title source_where where inputs findings side_by_side~"

    inputs: tuple[Input, ...]
    """What went in."""
    items: tuple[Item, ...]
    """Every printed number, in the source's order."""
    findings: tuple[str, ...]
    """What the recomputation showed beyond the verdicts."""
    by_swarm: Solution | None = None
    """The swarm's answer with its history, for figures; None when the study has no swarm."""
    side_by_side: tuple[SideBySide, ...] = ()
    """Answers by several models beside the printed ones, as tables of words."""
    moorings: tuple[Mooring, ...] = ()
    """The same body by several models, for a plan and an elevation."""
    loaded_line: int = 0
    """Which line of these the elevation shows, from 0."""
    drawn: tuple[Drawn, ...] = ()
    """Lines to be drawn to scale in one figure, in water as deep as their fairleads are high."""


@dataclass(frozen=True)
class Reproduction(Tabled, Record):
    """Published figures beside catopt's own.

    A number is in the unit that its unit key names.
    """

    SCHEMA = "catopt.reproduction/1"
    DOCUMENT = "items studies"

    studies: Annotated[tuple[Study, ...], From(1)]
    """The published calculations that the items belong to."""

    @property
    def items(self) -> Annotated[tuple[Item, ...], From(1)]:
        """Every printed number, in the sources' order."""
        return tuple(item for study in self.studies for item in study.items)

    @property
    def tally(self) -> str:
        """How many numbers have which verdict, as a sentence."""
        verdicts = [item.verdict for item in self.items]
        return (
            f"Of {len(verdicts)} printed numbers {verdicts.count('reproduces')} reproduce, "
            f"{verdicts.count('differs')} differ and {verdicts.count('not reproducible')} cannot "
            "be reproduced."
        )
