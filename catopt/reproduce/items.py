"""The outcome of a reproduction, as values, and printed numbers beside computed ones."""

from __future__ import annotations

import math
import tomllib
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, fields
from decimal import Decimal
from functools import cache, cached_property
from importlib.resources import files
from typing import Annotated, Any, Final, Literal

from catopt.catenary.solution import Solution
from catopt.display import Tabled
from catopt.records import Counted, From, Record
from catopt.units import UNITS, Dimension
from catopt.words import Cited, Language, Message, Several, Translated, term

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

    @cached_property
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


KN: Final = UNITS[Dimension.FORCE]["kN"]
TF: Final = UNITS[Dimension.FORCE]["tf"]

Given = Mapping[str, float | tuple[float, ...]]


@dataclass(frozen=True)
class Published(Heading):
    """One table of ``published.toml`` with its source.

    `inputs`, `series`: numbers that went in, and those that were varied, with the unit in the key;
    `stated`: what is said of them; `printed`: by the source's method, then by quantity with its
    unit.
    """

    inputs: dict[str, float]
    series: dict[str, tuple[float, ...]]
    stated: tuple[Input, ...]
    printed: dict[str, dict[str, Printed]]


@cache
def _data() -> dict[str, Any]:
    text = files("catopt.reproduce").joinpath("published.toml").read_text(encoding="utf-8")
    return tomllib.loads(text)


def _said(text: str | dict[Language, str]) -> str:
    return text if isinstance(text, str) else Translated(text)


def published(name: str) -> Published:
    """Look up a published calculation by the name of its table in ``published.toml``."""
    table = _data()[name]
    source = _data()["sources"][table["source"]]
    inputs = table.get("inputs", {})
    series = {key: tuple(values) for key, values in table.get("series", {}).items()}
    return Published(
        name=name,
        title=_said(table["title"]),
        where=_said(table["where"]),
        source=table["source"],
        source_title=Cited(source["title"]),
        source_where=Cited(source["where"]),
        inputs=inputs,
        series=series,
        stated=tuple(_stated(row, series | inputs) for row in table.get("stated", inputs)),
        printed={
            method: {quantity: Printed(text) for quantity, text in numbers.items()}
            for method, numbers in table["printed"].items()
        },
    )


def _stated(row: str | list[Any], given: Given) -> Input:
    """Say what went in, by a row of ``stated`` as the head of ``published.toml`` describes it."""
    if isinstance(row, str):
        words, unit = _data()["labels"][row]
        row = [words, row, unit]
    words, value, unit, *origin = row
    if isinstance(value, str):
        value = ", ".join(_written(given.get(key, key)) for key in value.split(", "))
    return Input(_said(words), _said(value), unit, *map(_said, origin))


def _written(value: str | float | tuple[float, ...]) -> str:
    """Write numbers with the digits that they have; words stay as they are."""
    if isinstance(value, tuple):
        return ", ".join(map(_written, value))
    return value if isinstance(value, str) else f"{value:.9g}"


_KNOWN = ("m", "m2", "t", "N", "kN", "MN", "tf", "rad", "deg", "s", "kN/m", "MN/rad", "MN*m/rad")
_UNITS = {unit: unit for unit in _KNOWN} | {"percent": "%"}
_PURE_NUMBER = "-"


def compare(
    source: Published,
    method: str,
    computed: Mapping[str, float],
    remarks: Mapping[str, str] | None = None,
    computed_by: str = "closed-form",
    printed: Mapping[str, Printed] | None = None,
) -> tuple[Item, ...]:
    """Judge every number that a source printed in the table of a method, digit for digit.

    `printed`: in place of that table.
    """
    said = remarks or {}
    items = []
    for quantity, number in (printed or source.printed[method]).items():
        value = computed[quantity]
        judgement = by_digits(number, value, _unit(quantity).strip(_PURE_NUMBER))
        remark = said.get(quantity, "")
        items.append(
            item_of(source, method, quantity, number, judgement, value, computed_by, remark)
        )
    return tuple(items)


def item_of(
    source: Published,
    method: str,
    quantity: str,
    printed: Printed,
    judgement: Judgement,
    computed: float | None = None,
    computed_by: str = "",
    remark: str = "",
) -> Item:
    """Put a printed number and its judgement together; its unit is the end of the quantity."""
    return Item(
        source.source,
        source.name,
        quantity,
        _unit(quantity),
        method,
        computed_by,
        printed,
        computed,
        judgement,
        term(remark),
    )


def set_aside(source: Published, method: str, reason: str) -> tuple[Item, ...]:
    """Tell of every number in the table of a method that nothing computed can be compared with."""
    return tuple(
        item_of(source, method, quantity, printed, not_reproducible(reason))
        for quantity, printed in source.printed[method].items()
    )


def study_of(
    source: Published,
    items: Iterable[Item],
    findings: Iterable[str] = (),
    ours: Iterable[Input] = (),
    **more: Any,
) -> Study:
    """Put a study together.

    `ours`: what went in beside what the source states; `more`: further fields of the study.
    """
    return Study(
        **{part.name: getattr(source, part.name) for part in fields(Heading)},
        inputs=(*source.stated, *ours),
        items=tuple(items),
        findings=tuple(findings),
        **more,
    )


def _unit(quantity: str) -> str:
    """Read the unit off the end of a quantity's name; a pure number has none."""
    return _UNITS.get(quantity.rpartition("_")[2], _PURE_NUMBER)


# ------------------------------------------------------------------ verdicts


def by_digits(printed: Printed, computed: float, unit: str) -> Judgement:
    """Judge digit for digit: the computed number, rounded as printed, is the printed one or not."""
    text = printed.rounding(computed)
    if text == printed.text:
        return Judgement("reproduces", text)
    difference = computed - printed.value
    relative = f" ({100.0 * difference / printed.value:+.2f} %)" if printed.value else ""
    decimals = max(1 - math.floor(math.log10(abs(difference))), 0)  # two digits, or whole units
    amount = f"{difference:+.{decimals}f} {unit}".rstrip()
    return Judgement("differs", text, Message("reproduce.differs_by", amount=f"{amount}{relative}"))


def by_order(printed: Printed, computed: float, limit: float, unit: str) -> Judgement:
    """Judge a number that is zero but for rounding, so that its digits are chance.

    `computed`: in the same unit, not negative; `limit`: below it a number counts as zero; the
    printed one must lie below it too.
    """
    if max(computed, printed.value) < limit:
        below = Message("reproduce.below", limit=limit)
        return Judgement("reproduces", below, Message("reproduce.zero"))
    value = f"{computed:.2e}"
    reason = Message("reproduce.not_below", value=f"{value} {unit}", limit=f"{limit:g} {unit}")
    return Judgement("differs", value, reason)


def not_reproducible(reason: str) -> Judgement:
    """Judge a number that nothing computed here can be compared with."""
    return Judgement("not reproducible", "", term(reason))


# ------------------------------------------------------------------ inputs that are not printed


@dataclass(frozen=True)
class Interval:
    """All values between two bounds."""

    least: float
    largest: float

    def ends(self, decimals: int) -> tuple[str, str]:
        """Write the bounds, each rounded inwards: every value between them belongs to it."""
        scale = 10.0**decimals
        least = math.ceil(self.least * scale) / scale
        largest = math.floor(self.largest * scale) / scale
        return f"{least:.{decimals}f}", f"{largest:.{decimals}f}"


def interval(
    quantity: Callable[[float], float], printed: Printed, within: tuple[float, float]
) -> Interval:
    """Find the values of an input for which a quantity prints as it did.

    `quantity`: the printed quantity as a monotone function of the input; `within`: where to look;
    the quantity must pass both bounds of the print in between.
    """
    return Interval(*sorted(_where(quantity, bound, within) for bound in printed.bounds))


def _where(quantity: Callable[[float], float], value: float, within: tuple[float, float]) -> float:
    """Bisect for the input at which a monotone quantity takes a value, to double precision."""
    low, high = within
    rising = quantity(high) > quantity(low)
    if not min(quantity(low), quantity(high)) < value < max(quantity(low), quantity(high)):
        raise ValueError(f"the quantity does not pass {value:g} between {low:g} and {high:g}")
    while low < (middle := 0.5 * (low + high)) < high:
        if (quantity(middle) < value) == rising:
            low = middle
        else:
            high = middle
    return low
