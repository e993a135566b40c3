"""The lines that another preference would have recommended, and what each gives for what."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from catopt.errors import InputError, NoAnswerError
from catopt.quantities import QUANTITIES
from catopt.sizing.candidates import why_none
from catopt.sizing.line_choice import PREFERENCES, Prefer
from catopt.sizing.settle import Settled
from catopt.words import Measure, Message


@dataclass(frozen=True)
class Alternative:
    """A line by another preference, under its own loads.

    Attributes
    ----------
    prefer : {"cheapest", "lightest", "balanced", "least-swing"}
        Which one it is of its front.
    settled : Settled or None
        The line and its loads; None where none passes under those.
    swing : float
        Swing radius at low water, m; 0 without a line.
    reason : str
        Why there is none; else empty.
    """

    prefer: Prefer
    settled: Settled | None
    swing: float = 0.0
    reason: str = ""

    @property
    def mass(self) -> float:
        """Of the line in air, kg; 0 without a line."""
        return self.settled.point.objectives["mass_kg"] if self.settled else 0.0

    @property
    def cost(self) -> float | None:
        """Of the line's material, USD; None without a line, or where a price is not known."""
        return self.settled.point.objectives.get("cost_USD") if self.settled else None


def alternatives(
    own: Prefer, sized: Callable[[Prefer], tuple[Settled, float]], *, priced: bool
) -> tuple[Alternative, ...]:
    """Settle the lines of the preferences other than that of the recommended line.

    `sized` settles a line by a preference, and gives its swing radius, m; where not every price is
    known, none is the cheapest.
    """
    others = (each for each in PREFERENCES if each != own)
    return tuple(_alternative(each, sized) for each in others if priced or each != "cheapest")


def _alternative(prefer: Prefer, sized: Callable[[Prefer], tuple[Settled, float]]) -> Alternative:
    try:
        return Alternative(prefer, *sized(prefer))
    except (NoAnswerError, InputError) as error:
        return Alternative(prefer, None, reason=why_none(error))


def trade(swing: float, mass: float, own_swing: float, own_mass: float) -> Message:
    """Say what a line gives and takes beside the recommended one.

    Parameters
    ----------
    swing, mass : float
        Swing radius, m, and mass of the line in air, kg.
    own_swing, own_mass : float
        Those of the recommended line.

    Examples
    --------
    >>> print(trade(369.0, 19.45e3, 382.0, 11.05e3))
    13 m less swing, 3.4 %, for 8.4 t more chain, 76 %
    """
    if (swing, mass) == (own_swing, own_mass):
        return Message("sizing.same_line")
    return Message(
        "sizing.trade",
        swing=_change("swing", "length", swing, own_swing),
        chain=_change("chain", "mass", mass, own_mass),
    )


def _change(what: str, quantity: str, own: float, other: float) -> Message:
    """Say a change in two digits or so, and its share of what changes."""
    way, change = "more" if own > other else "less", abs(own - other)
    digits = _digits(QUANTITIES[quantity].to_field(change))
    share = 100.0 * change / other
    amount = Measure(quantity, change, digits=digits)
    return Message(f"sizing.{way}_{what}", amount=amount, share=f"{share:.{_digits(share)}f}")


def _digits(value: float) -> int:
    return 0 if value >= 10.0 else 1
