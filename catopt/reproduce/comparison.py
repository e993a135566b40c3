"""Printed numbers beside computed ones, of one published calculation."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, fields
from typing import Any

from catopt.reproduce.items import Heading, Input, Item, Judgement, Printed, Study
from catopt.reproduce.published import Published
from catopt.words import Message, term

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
        **{each.name: getattr(source, each.name) for each in fields(Heading)},
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
