"""One line put through solve and solve_many, and what is to be said of both."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from catopt import solve, solve_many
from catopt.catenary.batch import Solutions
from catopt.catenary.solution import Solution
from catopt.errors import CatoptError
from catopt.model import Line
from tests.campaign.kernel import compiled_kernel
from tests.campaign.lines import Trial
from tests.campaign.oracle import Finding, check
from tests.campaign.refusals import RIGHT, judge, larger_force, status_of
from tests.campaign.walks import FORCE, LENGTH

ANSWERED = "answered"
BAD = "wrong"
EXCEPTION = "exceptions"
VERDICTS = (ANSWERED, BAD, RIGHT, "refused wrongly", "unexplained", EXCEPTION)
HARMLESS = (ANSWERED, RIGHT)

UNDECIDED = 0.1
"""Part of the length: where double precision leaves so much open nothing can be said of it."""

PLAIN = 25
"""One line of so many is also solved by the kernel as plain Python."""

LOOSE = 1e-6
"""Part of the length: answers whose place double precision leaves more open are counted apart."""


@dataclass(frozen=True)
class Outcome:
    """What became of one line.

    Attributes
    ----------
    trial : Trial
        The line.
    verdict, reason : str
        One of VERDICTS, and why in a few words.
    size : float
        How far off, as a part of what is allowed; 0 where that says nothing.
    is_loose : bool
        Whether double precision leaves more than LOOSE open.
    """

    trial: Trial
    verdict: str
    reason: str = ""
    size: float = 0.0
    is_loose: bool = False

    @property
    def failed(self) -> bool:
        return self.verdict not in HARMLESS


@dataclass(frozen=True)
class _Single:
    """What solve said of a line."""

    outcome: Outcome
    status: int
    solution: Solution | None = None
    finding: Finding | None = None


def evaluate(trials: Sequence[Trial]) -> list[Outcome]:
    """Judge lines; the order of the outcomes is that of the lines.

    `catopt.solve` runs with its kernel compiled, for time, and as it stands on one line in PLAIN.
    """
    with compiled_kernel(len(trials)):
        singles = [_single(trial) for trial in trials]
    for number, trial in enumerate(trials):
        if trial.index % PLAIN == 0 and not singles[number].outcome.failed:
            singles[number] = _single(trial)
    outcomes = [single.outcome for single in singles]
    groups: dict[tuple[int, int, str], list[int]] = {}
    for number, trial in enumerate(trials):
        groups.setdefault(trial.shape, []).append(number)
    for numbers in groups.values():
        many = _many([trials[number] for number in numbers])
        for row, number in enumerate(numbers):
            if not outcomes[number].failed:
                outcomes[number] = _compared(singles[number], many, row)
    return outcomes


def _single(trial: Trial) -> _Single:
    try:
        solution = solved(trial)
    except CatoptError as error:
        verdict, reason = judge(trial, error)
        return _Single(Outcome(trial, verdict, reason), status_of(error))
    except Exception as error:
        return _Single(Outcome(trial, EXCEPTION, type(error).__name__), -1)
    found = check(solution, trial.known, trial.value)
    is_loose = found.open_place > LOOSE * trial.line.length
    if not found.is_right and found.open_place < UNDECIDED * trial.line.length:
        return _Single(Outcome(trial, BAD, found.condition, found.ratio, is_loose), 0)
    may_have_two = trial.known == "fairlead_tension" and (
        trial.is_buoyant or trial.anchor_height > 0.0
    )
    if may_have_two and larger_force(trial, solution.horizontal_force) is not None:
        return _Single(Outcome(trial, BAD, "a larger force has the same tension"), 0)
    outcome = Outcome(trial, ANSWERED, size=found.ratio, is_loose=is_loose)
    return _Single(outcome, 0, solution, found)


def solved(trial: Trial) -> Solution:
    """Answer of `catopt.solve`."""
    return solve(
        trial.line,
        height=trial.height,
        seabed_friction=trial.friction,
        anchor_height=trial.anchor_height,
        **{trial.known: trial.value},
    )


def _many(trials: Sequence[Trial]) -> Solutions:
    """Answers of `catopt.solve_many` for lines of one shape."""
    lines = [trial.line for trial in trials]

    def table(rows: list[list[float]]) -> Any:
        return np.array(rows, dtype=np.float64)

    points = {
        "positions": table([[p.position for p in line.point_loads] for line in lines]),
        "point_weights": table([[p.submerged_weight for p in line.point_loads] for line in lines]),
    }
    given: dict[str, Any] = points if lines[0].point_loads else {}
    given[trials[0].known] = table([[t.value for t in trials]])[0]
    return solve_many(
        Line(lines[0].segments, lines[0].point_loads),
        height=table([[t.height for t in trials]])[0],
        anchor_height=table([[t.anchor_height for t in trials]])[0],
        seabed_friction=table([[t.friction for t in trials]])[0],
        lengths=table([[s.length for s in line.segments] for line in lines]),
        submerged_weights=table([[s.submerged_weight for s in line.segments] for line in lines]),
        EA=table([[s.EA for s in line.segments] for line in lines]),
        **given,
    )


def _compared(single: _Single, many: Solutions, row: int) -> Outcome:
    """Compare one line of solve_many with what solve said, which is right."""
    status = int(many.status[row])
    outcome = single.outcome
    if status != single.status:
        # Without weight a line is refused as an input by solve; solve_many has no such word.
        if single.status == 5:
            return outcome
        reason = f"solve_many: status {status}, solve {single.status}"
        return replace(outcome, verdict=BAD, reason=reason)
    if single.solution is None or single.finding is None:
        return outcome
    name, size = _difference(outcome.trial, single.solution, single.finding, many, row)
    if size <= 1.0:
        return outcome
    return replace(outcome, verdict=BAD, reason=f"solve_many: {name}", size=size)


def _difference(
    trial: Trial, one: Solution, found: Finding, many: Solutions, row: int
) -> tuple[str, float]:
    """Name of the quantity that differs the most, and by how much as a part of what is allowed.

    Both may be off by what double precision leaves open; friction passes forces on to the anchor.
    """
    force = FORCE * max(one.fairlead.tension, one.anchor.tension)
    H = force + 2.0 * found.open_H
    V = force + 2.0 * (found.open_V + found.open_H)
    if trial.known == "fairlead_tension":
        H = V = H + V
    far = LENGTH * max(trial.line.length, one.span) + 2.0 * found.open_place
    anchor = (1.0 + trial.friction) * (H + V)
    pairs = {
        "H": (one.horizontal_force, many.horizontal_force[row], H),
        "V": (one.fairlead.vertical_force, many.vertical_force[row], V),
        "span": (one.span, many.span[row], far),
        "anchor H": (one.anchor.horizontal_force, many.anchor_horizontal_force[row], anchor),
        "anchor V": (one.anchor.vertical_force, many.anchor_vertical_force[row], anchor),
    }
    ratios = {name: _ratio(abs(a - b), allowed) for name, (a, b, allowed) in pairs.items()}
    worst = max(ratios, key=lambda name: ratios[name])
    return worst, ratios[worst]


def _ratio(miss: float, allowed: float) -> float:
    if math.isnan(miss):
        return math.inf
    return float(miss / allowed) if allowed > 0.0 else math.inf if miss > 0.0 else 0.0
