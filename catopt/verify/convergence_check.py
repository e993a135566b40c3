"""A line in motion run again, at half the step and then with twice the bars, too."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import TYPE_CHECKING, Final, Literal

from catopt.model.kinds import Findings, NotNegative, Time
from catopt.records import Counted, Record

if TYPE_CHECKING:
    from catopt.checks.fatigue import Cycles
    from catopt.verify.dynamic_run import DynamicRun

LIMIT: Final = 0.05
"""Change of a maximum over itself, or part of the work lost, beyond which nothing is converged."""

OF_MBL: Final = 0.02
"""Change of a tension over the line's MBL up to which it decides nothing."""

LEAST_TENSION: Final = 0.02
"""Part of the largest tension below which a change of another is over that part of it."""

LEAST_CYCLES: Final = 5
"""Peaks of a periodic motion from which their scatter is judged."""

DAMPINGS: Final = (0.5, 2.0)
"""What the damping of a line that snaps is multiplied by, to show what hangs on it."""

REMAINS: Final = 4.0 / 3.0
"""What halving step or bar shows of an error that falls with its square, three quarters, to all."""

TOO_UNCERTAIN: Final = 0.2
"""Chance over the value itself beyond which a change that may be chance proves nothing."""

ConvergenceCheck = Literal["none", "step", "bars"]
"""How a run is proven: not at all (--once); at half the step, and where the line goes slack with
twice the bars; with both in any case."""

Way = Literal["step", "bars"]
"""How it is run again: at half the step, or at half the step with twice the bars."""

FINER: Mapping[Way, tuple[int, int]] = MappingProxyType({"step": (2, 1), "bars": (2, 2)})
"""Steps in place of one, and bars in place of one, by the way in which a run is made again."""


@dataclass(frozen=True)
class Again(Record):
    """One run again."""

    DOCUMENT = "way step=time_step_s elements maxima failure"

    way: Way
    """step: at half the step; bars: so, with twice the bars; a change is from the run before."""
    step: Time
    """Of it."""
    elements: Counted
    """Bars."""
    maxima: Mapping[str, float]
    """N or m, by quantity, as `DynamicRun.maxima`; empty where it failed."""
    failure: str = ""
    """Why it has no answer; empty where it has one."""
    cycles: tuple[Cycles, ...] = ()
    """Of each bar's tension, empty unless they were asked for."""
    run: DynamicRun | None = field(default=None, compare=False, repr=False)
    """Itself, without its samples; None where it failed."""


@dataclass(frozen=True)
class Damped:
    """One run with another damping of the line itself.

    `factor`: of `DAMPINGS`; `maxima`: as `DynamicRun.maxima`; empty where it did not converge.
    """

    factor: float
    maxima: Mapping[str, float]


@dataclass(frozen=True)
class Change(Record):
    """How far a maximum moved when a run was made again, from that of the run before."""

    DOCUMENT = "quantity way size=change"

    quantity: str
    """A key of `DynamicRun.maxima`; largest_tension: anywhere along the line."""
    way: Way | Literal["both"]
    """step: at half the step; bars: so, with twice the bars; both: the changes by the two added,
    and a third more."""
    size: NotNegative
    """Over the maximum of the finer run; of a grounded length over the line's."""
    amount: float
    """Itself, N or m."""
    chance: float | None = None
    """Of a random sea, how far chance alone may move it: of a most probable maximum half its
    interval over seeds; of the mean of the minutes' maxima of a line that snaps (`paired_change`)
    the interval of the difference, each 90 %; None of what has none."""

    is_paired: bool = False
    """Whether it is of the same minutes of the same seas."""

    @property
    def is_by_chance(self) -> bool:
        """Whether other seeds move it as far."""
        return self.chance is not None and self.amount <= self.chance

    @property
    def by_chance(self) -> float:
        """Chance over the maximum; 0 of what has none."""
        over = self.amount / self.size if self.size > 0.0 else math.inf
        return 0.0 if self.chance is None else self.chance / over

    @property
    def is_too_uncertain(self) -> bool:
        """Whether chance moves it so far that its change says nothing, save that it is small."""
        return self.is_paired and self.size > LIMIT and self.by_chance > TOO_UNCERTAIN

    def is_small_beside(self, MBL: float | None) -> bool:
        """Whether a tension moves, with what chance may add, by no more than 2 % of an MBL, N."""
        if MBL is None or not self.quantity.endswith("tension"):
            return False
        return self.amount + (self.chance or 0.0) <= OF_MBL * MBL

    def decides(self, MBL: float | None) -> bool:
        """Whether it is large enough to matter; `MBL`: the line's, N, where 2 % of it may pass."""
        if (self.chance is None or self.is_paired) and self.size <= LIMIT:
            return False
        by_MBL = MBL is not None and self.quantity.endswith("tension")
        return not self.is_by_chance and not (by_MBL and self.amount <= OF_MBL * (MBL or 0.0))


def work_of_check(convergence_check: ConvergenceCheck) -> int:
    """How often the work of a run its check takes at most."""
    if convergence_check == "none":
        return 0
    return len(DAMPINGS) + sum(steps * bars for steps, bars in FINER.values())


def added(changes: Iterable[Change]) -> Iterator[Change]:
    """Yield for each quantity its changes in one run, by all ways together: errors add up.

    Where there are several, a third more than their sum: of an error that falls with the square of
    step and bar, halving them shows three quarters.
    """
    by_quantity: dict[str, list[Change]] = {}
    for each in changes:
        by_quantity.setdefault(each.quantity, []).append(each)
    for quantity, of in by_quantity.items():
        whole = next((each for each in of if each.way == "both"), None)
        if len(of) == 1 or whole is not None:
            yield whole or of[0]
        else:
            sums = sum(each.size for each in of), sum(each.amount for each in of)
            yield Change(quantity, "both", REMAINS * sums[0], REMAINS * sums[1], of[0].chance)


def largest_changes(changes: Iterable[Change]) -> list[Change]:
    """Keep the largest change of each quantity by each way, over several runs."""
    largest: dict[tuple[str, str], Change] = {}
    for each in changes:
        key = (each.quantity, each.way)
        if key not in largest or each.size > largest[key].size:
            largest[key] = each
    return list(largest.values())


ELEMENTS = 200
"""Bars of a line on the coarsest mesh."""

TOLERANCE = 1e-4
"""Of the fairlead tension, of the line's length, in rad."""

_FEWEST, _MOST = 4, 20000
_LOOSEST = 0.1


def check_settings(elements: int, tolerance: float, *, source: str, prefix: str = "") -> None:
    """Refuse settings that are out of range, all at once.

    `tolerance`: largest difference that counts as agreement; `source`, `prefix`: who was given
    them, and what stands before their names there, such as ``"--"``. Raises InputError with every
    one that is wrong.
    """
    found = Findings(source)
    found.number(f"{prefix}elements", elements, "", at_least=_FEWEST, at_most=_MOST)
    found.number(f"{prefix}tolerance", tolerance, "", above=0.0, at_most=_LOOSEST)
    found.raise_if_any()
