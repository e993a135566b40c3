"""What a computed number says about a printed one."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

from catopt.reproduce.printed import Printed
from catopt.words import Message, term

Verdict = Literal["reproduces", "differs", "not reproducible"]


@dataclass(frozen=True)
class Judgement:
    """A verdict, the computed number as it is compared, and the reason where one is due."""

    verdict: Verdict
    computed_text: str
    reason: str = ""


def by_digits(printed: Printed, computed: float, unit: str) -> Judgement:
    """Judge digit for digit: the computed number, rounded as printed, is the printed one or not."""
    text = printed.rounding(computed)
    if text == printed.text:
        return Judgement("reproduces", text)
    difference = computed - printed.value
    relative = f" ({100.0 * difference / printed.value:+.2f} %)" if printed.value else ""
    amount = f"{_two_digits(difference)} {unit}".rstrip()
    return Judgement("differs", text, Message("reproduce.differs_by", amount=f"{amount}{relative}"))


def _two_digits(difference: float) -> str:
    """Write a difference with its sign and two digits, or to whole units where it has more."""
    decimals = 1 - math.floor(math.log10(abs(difference)))
    return f"{difference:+.{max(decimals, 0)}f}"


def by_order(printed: Printed, computed: float, limit: float, unit: str) -> Judgement:
    """Judge a number that is zero but for rounding, so that its digits are chance.

    `computed`: in the same unit, not negative; `limit`: below it a number counts as zero; the
    printed one must lie below it too.
    """
    if max(computed, printed.value) < limit:
        return Judgement(
            "reproduces", Message("reproduce.below", limit=limit), Message("reproduce.zero")
        )
    return Judgement(
        "differs",
        f"{computed:.2e}",
        Message("reproduce.not_below", value=f"{computed:.2e} {unit}", limit=f"{limit:g} {unit}"),
    )


def not_reproducible(reason: str) -> Judgement:
    """Judge a number that nothing computed here can be compared with."""
    return Judgement("not reproducible", "", term(reason))
