"""What a code asks of a ship's mooring by its service type, and what steady forces leave out.

The types are of table 2-2 of UFC 4-150-08 (2001), which is that of UFC 4-159-03; what they ask for
is of UFC 4-159-03 (2005), 3-2.6, 8-2 and 11-4.2 (all A, read on a public mirror).
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final, Literal, get_args

from catopt.sizing.environment import Environment, mean_over
from catopt.units import UNITS, Dimension
from catopt.words import Message

ServiceType = Literal["I", "II", "III", "IV"]
"""I: in mild weather; II: left before a storm; III: up to two years, not left; IV: longer."""

SERVICE_TYPES: Final[tuple[ServiceType, ...]] = get_args(ServiceType)

DYNAMIC: Final = ("III", "IV")
"""Types that dynamic methods are wanted for."""

_KNOT: Final = UNITS[Dimension.SPEED]["kn"]
_MILD_WIND: Final = 34.0 * _KNOT
_MILD_CURRENT: Final = 2.0 * _KNOT
"""m/s: type I is for less than these."""

_MEAN: Final = 30.0
_GUST: Final = 3.0
"""s: over which the wind of the loads is a mean, and over which a gust is."""


def demands(of: ServiceType, env: Environment) -> Iterator[Message]:
    """Say what the code asks for: whether a steady calculation is enough."""
    name = Message(f"sizing.service_{of}")
    key = "sizing.service_dynamic" if of in DYNAMIC else "sizing.service_steady"
    yield Message(key, type=of, name=name)
    is_mild = env.wind.speed < _MILD_WIND and env.current.speed < _MILD_CURRENT
    if of == "I" and not is_mild:
        yield Message("sizing.service_beyond", wind=env.wind.speed, current=env.current.speed)
    yield Message("sizing.fishtailing")


def left_out(env: Environment) -> Message:
    """Say which motions no allowance here stands for, with what a gust adds to the wind's part."""
    speed = env.wind.speed
    gust = (mean_over(speed, _MEAN, _GUST) / speed) ** 2 - 1.0 if speed else 0.0
    return Message("sizing.motions_left_out", share=100.0 * gust)
