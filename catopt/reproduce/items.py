"""The outcome of a reproduction, as values."""

from __future__ import annotations

from dataclasses import dataclass
from decimal import Decimal
from typing import TYPE_CHECKING, Any, Literal

from catopt.documents import figures
from catopt.shown import Tabled
from catopt.words import Message, Several, term

if TYPE_CHECKING:
    from catopt.catenary.solution import Solution

Verdict = Literal["reproduces", "differs", "not reproducible"]


@dataclass(frozen=True)
class Printed:
    """A number as printed, such as ``"17.430"``; the closing zero is a claim."""

    text: str

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
    def digits(self) -> int:
        """Significant digits: 5 in ``17.430``. A printed zero counts its decimals, or one."""
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
    reason: str = ""


@dataclass(frozen=True)
class Item:
    """One printed number and what became of it."""

    source: str
    """Short name of the source, such as ``"S1"``."""
    name: str
    quantity: str
    """With its unit, such as ``"offset_m"``."""
    unit: str
    """As shown to a reader; ``"-"`` for a pure number."""
    method: str
    """How the source came by it, or which of its tables it is in: ``"pso"``, ``"pso against fem"``,
    ``"Table 1"``."""
    computed_by: str
    """How catopt did, such as ``"pso"`` or ``"closed-form"``; empty when it did not."""
    printed: Printed
    computed: float | None
    """Unrounded, in the unit of the print; None when nothing was computed."""
    judgement: Judgement
    remark: str = ""
    """What a reader should know beside the verdict."""

    @property
    def verdict(self) -> Verdict:
        """``"reproduces"``, ``"differs"`` or ``"not reproducible"``."""
        return self.judgement.verdict

    @property
    def published(self) -> float:
        """The printed number."""
        return self.printed.value

    @property
    def note(self) -> str:
        """The reason for the verdict and the remark, in one line."""
        return Several(part for part in (self.judgement.reason, self.remark) if part)

    def to_dict(self) -> dict[str, Any]:
        """Build this item's part of the document catopt.reproduction/1."""
        return figures(self, "source name quantity method published") | {
            "published_text": self.printed.text,
            "computed": self.computed,
            "computed_text": self.judgement.computed_text,
            "computed_by": self.computed_by,
            "unit": self.unit,
            "printed_digits": self.printed.digits,
            "verdict": self.verdict,
            "note": self.note,
        }


@dataclass(frozen=True)
class Input:
    """What went into a study: a quantity in words, its value and unit, and where it comes from."""

    quantity: str
    value: str
    unit: str
    origin: str = "printed"

    def __post_init__(self) -> None:
        for key in ("quantity", "value", "origin"):
            object.__setattr__(self, key, term(getattr(self, key)))


@dataclass(frozen=True)
class SideBySide:
    """Several answers to the same questions, as a table of words: what each column holds, rows."""

    title: str
    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]

    def __post_init__(self) -> None:
        object.__setattr__(self, "title", term(self.title))
        object.__setattr__(self, "header", tuple(map(term, self.header)))
        object.__setattr__(self, "rows", tuple(tuple(map(term, row)) for row in self.rows))

    def to_dict(self) -> dict[str, Any]:
        """Build this table's part of the document."""
        rows = [list(row) for row in self.rows]
        return {"title": self.title, "header": list(self.header), "rows": rows}


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
    """By which `reproduce` knows it."""
    title: str
    source: str
    source_title: str
    source_where: str
    where: str
    """Short name and title of the source, its publication, and the place in it."""


@dataclass(frozen=True)
class Study(Heading):
    """One published calculation, recomputed."""

    inputs: tuple[Input, ...]
    items: tuple[Item, ...]
    """Every printed number, in the source's order."""
    findings: tuple[str, ...]
    """What the recomputation showed beyond the verdicts; a paragraph each."""
    by_swarm: Solution | None = None
    """The swarm's answer with its history, for figures; None when the study has no swarm."""
    side_by_side: tuple[SideBySide, ...] = ()
    """Answers by several models beside the printed ones."""
    moorings: tuple[Mooring, ...] = ()
    """The same body by several models, for a plan and an elevation."""
    loaded_line: int = 0
    """Which line of these the elevation shows, from 0."""
    drawn: tuple[Drawn, ...] = ()
    """Lines to be drawn to scale in one figure, in water as deep as their fairleads are high."""

    def to_dict(self) -> dict[str, Any]:
        """Build this study's part of the document: everything but its items."""
        return figures(self, "name title source source_title source_where where") | {
            "inputs": [dict(vars(given)) for given in self.inputs],
            "findings": list(self.findings),
            "side_by_side": [table.to_dict() for table in self.side_by_side],
        }


@dataclass(frozen=True)
class Reproduction(Tabled):
    """The outcome of one or more studies."""

    studies: tuple[Study, ...]

    @property
    def items(self) -> tuple[Item, ...]:
        """Every item of every study."""
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

    def to_dict(self) -> dict[str, Any]:
        """Build the document that ``catopt reproduce --json`` prints (catopt.reproduction/1)."""
        return {
            "schema": "catopt.reproduction/1",
            "items": [item.to_dict() for item in self.items],
            "studies": [study.to_dict() for study in self.studies],
        }
