"""The next size sold: series of masses, and the step up to them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from catopt.errors import NoAnswerError
from catopt.model.validity import Findings
from catopt.shown import Tabled
from catopt.words import Message

SINKER_MASSES: Final = tuple(
    1e3 * tonnes
    for tonnes in (
        *(0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 15.0, 20.0),
        *(25.0, 30.0, 40.0, 50.0, 60.0),
    )
)
"""kg, in air: steps for sinkers, which are cast to order. catopt's own list."""

_ROUNDING = 1e-9


@dataclass(frozen=True, kw_only=True)
class NextSize(Tabled):
    """The next size sold that holds a pull: masses in kg, forces in N."""

    needed_mass: float
    mass: float
    smaller: float | None
    larger: float | None
    """Its neighbours in the series."""
    horizontal_force: float
    safety_factor: float
    """That was wanted."""

    @property
    def held(self) -> float:
        """Horizontal pull that it holds, N."""
        raise NotImplementedError

    @property
    def factor(self) -> float | None:
        """What it holds over the pull; None without a pull."""
        return None if self.horizontal_force == 0.0 else self.held / self.horizontal_force


def next_size(needed: float, series: Sequence[float], what: str) -> float:
    """Pick the smallest of a rising series that is enough, kg; `NoAnswerError` when none is."""
    _check(series)
    for size in series:
        if size >= needed * (1.0 - _ROUNDING):
            return size
    raise NoAnswerError(
        Message(
            "loads.too_small",
            what=what,
            needed=needed / 1e3,
            largest=series[-1] / 1e3,
            missing=(needed - series[-1]) / 1e3,
        )
    )


def neighbours(size: float, series: Sequence[float]) -> tuple[float | None, float | None]:
    """Pick the next smaller and the next larger of a rising series, kg; None beyond its ends."""
    smaller = [each for each in series if each < size]
    larger = [each for each in series if each > size]
    return max(smaller, default=None), min(larger, default=None)


def _check(series: Sequence[float]) -> None:
    found = Findings("series of sizes")
    if not series:
        found.add("series", Message("refused.none"), Message("refused_sizing.one_size_or_more"))
    for index, size in enumerate(series):
        found.number(f"series[{index}]", size, "kg", above=0.0)
    if not found.problems and list(series) != sorted(set(series)):
        found.add("series", "", Message("refused_motion.must_rise"))
    found.raise_if_any()
