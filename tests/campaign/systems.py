"""A campaign over moored bodies: each answer and each refusal of `solve_system` is checked.

    python -m tests.campaign.systems --count 10000 --seed 1

Nothing of the solver's own is used. An answer is checked at its own position: the place of each
fairlead by own geometry, the force of each line by `solve(span=)`, their sums, and the stiffness by
differences. A refusal, and the count of headings named, is checked by a search over all yaws
(yaw_search); what that finds is brought to the exact forces by scipy before it counts.
"""

from __future__ import annotations

import argparse
import math
import random
import re
import time
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from scipy.optimize import root

from catopt import Line, NoEquilibriumError, System, solve, solve_system
from catopt.errors import CatoptError
from catopt.mooring.solution import SystemSolution
from tests.campaign.random_system import drawn_system
from tests.campaign.yaw_search import Array, stable_headings

__all__ = ["Failure", "Tally", "faults_of_answer", "faults_of_refusal", "run"]

BALANCE = 1e-8
"""Part of the forces that may be left: the solver's own limit is 1e-9 where rounding bars the way;
to it comes what the last digits of a position are worth in force."""

NOTHING = 1e-11
"""Part of the weight of all lines that is no force at all: they hang slack, or as good as."""

LAST_DIGITS = 1e-12
"""Part of a length that its last digits are worth, after the sums of a position and an arm."""

SAME_HEADING = 2e-3
"""rad: twice what yaws in a warning are rounded to, and what the tables cannot tell apart."""

TABLES = 2e-3
"""Part of the moments by which the tables' largest moment may differ from the exact one."""

NEARLY = 1e-3
"""Part of the largest moment by which a body that is to rest carries less."""

MOST_UNRESOLVED = 0.2
"""Part of the yaws at which the search may find no rest: lines that do not stretch may bar some."""

OTHER = re.compile(r"at a yaw of (\S+) deg, its origin at \((\S+), (\S+)\) m")
LIMIT = re.compile(r"moment of (\S+) N m on the body: they resist up to (\S+) N m")


@dataclass(frozen=True)
class Failure:
    """A system with a fault: its number in the campaign, what is wrong, and the system."""

    index: int
    fault: str
    system: System


@dataclass(frozen=True)
class Tally:
    """What became of the systems of a campaign; the counts add up to `count`.

    Attributes
    ----------
    answered, wrong : int
        Answers that pass every check, and that do not.
    refused_rightly, refused_wrongly : int
        Refusals where no stable equilibrium exists, and where one does.
    exceptions : int
        What is neither an answer nor an announced failure.
    with_moment, with_two : int
        Of all systems those with a moment; of the answers those that name another heading.
    failures : tuple of Failure
        All that is wrong.
    """

    answered: int = 0
    wrong: int = 0
    refused_rightly: int = 0
    refused_wrongly: int = 0
    exceptions: int = 0
    with_moment: int = 0
    with_two: int = 0
    failures: tuple[Failure, ...] = ()

    @property
    def count(self) -> int:
        """Systems looked at."""
        refused = self.refused_rightly + self.refused_wrongly
        return self.answered + self.wrong + refused + self.exceptions


def run(count: int, seed: int) -> Tally:
    """Draw systems, solve each and check what comes out."""
    tally = dict.fromkeys(
        ("answered", "wrong", "refused_rightly", "refused_wrongly", "exceptions"), 0
    )
    with_moment = with_two = 0
    failures = []
    for index in range(count):
        system = drawn_system(random.Random(f"system {seed} {index}"))
        with_moment += system.moment != 0.0
        outcome = _solved(system)
        if isinstance(outcome, SystemSolution):
            faults = faults_of_answer(outcome)
            with_two += any(OTHER.search(warning) for warning in outcome.warnings)
            kind = "wrong" if faults else "answered"
        elif isinstance(outcome, CatoptError):
            faults = faults_of_refusal(system, outcome)
            kind = "refused_wrongly" if faults else "refused_rightly"
        else:
            kind, faults = "exceptions", [f"{type(outcome).__name__}: {outcome}"]
        tally[kind] += 1
        if faults:
            failures.append(Failure(index, "; ".join(faults), system))
    return Tally(**tally, with_moment=with_moment, with_two=with_two, failures=tuple(failures))


def _solved(system: System) -> SystemSolution | Exception:
    try:
        return solve_system(system)
    except Exception as error:
        return error


def faults_of_answer(solution: SystemSolution) -> list[str]:
    """Say what is wrong with an answer; empty when nothing is."""
    system, at = solution.system, solution.position
    faults = []
    if not -math.pi < at.yaw <= math.pi:
        faults.append(f"yaw {at.yaw} rad")
    place = (at.x, at.y, at.yaw)
    faults += _faults_at(system, place)
    is_loose = any("do not hold" in warning for warning in solution.warnings)
    if not is_loose and system.turns:
        faults += _faults_of_headings(solution)
    return faults


def faults_of_refusal(system: System, error: CatoptError) -> list[str]:
    """Say what is wrong with a refusal; empty when nothing is."""
    if not isinstance(error, NoEquilibriumError):
        return [str(error)]
    limit = LIMIT.search(str(error))
    if limit is None:
        return [str(error)]
    asked, carried = abs(float(limit[1])), float(limit[2])
    if not 0.0 <= carried <= asked or not error.missing > 0.0:
        return [f"contradicts itself: {error}"]
    found = stable_headings(system)
    if found.unresolved > MOST_UNRESOLVED:
        return [f"not checked, the search comes to rest too seldom: {error}"]
    for place in found.places:
        exact = _exact(system, place)
        if exact is not None and not _faults_at(system, exact):
            return [f"rests at {exact}: {error}"]
    # The largest moment of the lines by the tables.
    left = found.least if system.moment > 0.0 else -found.largest
    more = carried - (abs(system.moment) - left)
    is_near = abs(more) <= TABLES * found.scale
    if is_near or (more > 0.0 and _is_carried(system, (1.0 - NEARLY) * carried)):
        return []
    return [f"carries {abs(system.moment) - left:.6g} N m: {error}"]


def _is_carried(system: System, moment: float) -> bool:
    """Whether a body rests under a moment, which tables of its lines may fall short of."""
    outcome = _solved(replace(system, moment=math.copysign(moment, system.moment)))
    return isinstance(outcome, SystemSolution) and not faults_of_answer(outcome)


def _faults_of_headings(solution: SystemSolution) -> list[str]:
    """Compare the headings that the answer names with those that the search finds."""
    system, faults = solution.system, []
    named = [solution.position.yaw]
    for warning in solution.warnings:
        words = OTHER.search(warning)
        if words is None:
            continue
        place = (float(words[2]), float(words[3]), math.radians(float(words[1])))
        exact = _exact(system, np.array(place))
        if exact is None or _faults_at(system, exact) or _apart(exact[2], place[2]) > SAME_HEADING:
            faults.append(f"does not rest where a warning says: {warning}")
        if any(_apart(place[2], yaw) <= SAME_HEADING for yaw in named):
            faults.append(f"names one heading twice: {warning}")
        named.append(place[2])
    found = stable_headings(system)
    if found.unresolved > MOST_UNRESOLVED:
        faults.append("headings not checked, the search comes to rest too seldom")
    for candidate in found.places:
        if any(_apart(candidate[2], yaw) <= SAME_HEADING for yaw in named):
            continue
        exact = _exact(system, candidate)
        if exact is None or _faults_at(system, exact):
            continue
        if all(_apart(exact[2], yaw) > SAME_HEADING for yaw in named):
            faults.append(f"another heading, {math.degrees(exact[2]):.4f} deg, is not named")
            named.append(exact[2])
    return faults


def _apart(yaw: float, other: float) -> float:
    return abs(math.remainder(yaw - other, 2.0 * math.pi))


@dataclass(frozen=True)
class _Hung:
    """One line at a place of the body: its force over span, to second order."""

    span: float
    H: float
    H_S: float
    H_SS: float

    def at(self, span: float) -> float:
        move = span - self.span
        return self.H + self.H_S * move + 0.5 * self.H_SS * move * move


def _force(system: System, index: int, span: float) -> float:
    leg = system.legs[index]
    return solve(
        leg.line,
        height=leg.fairlead_height,
        anchor_height=leg.anchor_height,
        span=float(span),
        seabed_friction=system.seabed_friction,
    ).horizontal_force


def _geometry(system: System, place: Sequence[float]) -> tuple[Array, Array, Array]:
    """Arms as they are turned, unit vectors from fairleads to anchors, spans."""
    x, y, yaw = place
    turn = np.array([[math.cos(yaw), -math.sin(yaw)], [math.sin(yaw), math.cos(yaw)]])
    arms = np.array([leg.fairlead for leg in system.legs]) @ turn.T
    along = np.array([leg.anchor for leg in system.legs]) - [x, y] - arms
    spans: Array = np.maximum(np.hypot(along[:, 0], along[:, 1]), 1e-9)
    return arms, along / spans[:, None], spans


def _left(system: System, place: Sequence[float], forces: Array) -> Array:
    """Force and moment left on the body when the lines pull with given horizontal forces."""
    arms, along, _ = _geometry(system, place)
    pulls = forces[:, None] * along
    turning = arms[:, 0] * pulls[:, 1] - arms[:, 1] * pulls[:, 0]
    return np.array([*(np.array(system.force) + pulls.sum(axis=0)), system.moment + turning.sum()])


def _hung(system: System, place: Sequence[float]) -> list[_Hung]:
    known: dict[Any, _Hung] = {}
    lines = []
    for k, span in enumerate(_geometry(system, place)[2]):
        leg = system.legs[k]
        key = (leg.line, leg.anchor_height, leg.fairlead_height, span)
        if key not in known:
            step = 1e-6 * span
            reach = leg.line.length**2 - (leg.fairlead_height - leg.anchor_height) ** 2
            if all(math.isinf(segment.EA) for segment in leg.line.segments):
                step = min(step, 0.01 * (math.sqrt(reach) - span))
            low, middle, high = (_force(system, k, span + d) for d in (-step, 0.0, step))
            known[key] = _Hung(
                span,
                middle,
                (high - low) / (2.0 * step),
                (high - 2.0 * middle + low) / (step * step),
            )
        lines.append(known[key])
    return lines


def _faults_at(system: System, place: Sequence[float]) -> list[str]:
    """Check that the forces balance at a place and that the body stays there."""
    arm = max(leg.fairlead_radius for leg in system.legs) or 1.0
    hung = _hung(system, place)
    far = float(np.abs([leg.anchor for leg in system.legs]).max())
    total = math.hypot(*system.force) + sum(line.H for line in hung)
    nothing = NOTHING * sum(leg.line.length * _heaviest(leg.line) for leg in system.legs)
    limit = nothing + BALANCE * total + LAST_DIGITS * far * sum(abs(line.H_S) for line in hung)
    left = _left(system, place, np.array([line.H for line in hung]))
    faults = []
    if math.hypot(left[0], left[1]) > limit:
        faults.append(f"{math.hypot(left[0], left[1]):.3g} N left of {total:.3g} N")
    if system.turns and abs(left[2]) > arm * limit:
        faults.append(f"{abs(left[2]):.3g} N m left")
    if total <= nothing:
        return faults
    least, largest = _stiffness_range(system, place, hung, arm)
    # Differences of forces good to 1e-12 over steps of 1e-6 tell a stiffness to some 1e-6.
    if least < -1e-6 * largest:
        faults.append(f"not stable: stiffnesses {least:.3g} to {largest:.3g} N/m")
    return faults


def _heaviest(line: Line) -> float:
    return max(segment.submerged_weight for segment in line.segments)


def _stiffness_range(
    system: System, place: Sequence[float], hung: list[_Hung], arm: float
) -> tuple[float, float]:
    """Least and largest eigenvalue of the stiffness, yaw taken times the arm; by differences."""
    scales = np.array([1.0, 1.0, 1.0 / arm])
    count = 3 if system.turns else 2
    shortest = min(line.span for line in hung)
    step = 1e-6 * min(shortest, arm if system.turns else shortest)
    # Lines close to their ends: a step within which their force stays the parabola it is taken for.
    for line in hung:
        if line.H_S * step > 1e-3 * line.H > 0.0:
            step = 1e-3 * line.H / line.H_S
    stiffness = np.empty((count, count))
    for k in range(count):
        ends = []
        for side in (-1.0, 1.0):
            moved = np.array(place, dtype=float)
            moved[k] += side * step * scales[k]
            spans = _geometry(system, tuple(moved))[2]
            forces = np.array([line.at(span) for line, span in zip(hung, spans, strict=True)])
            ends.append(_left(system, tuple(moved), forces) * scales)
        stiffness[:, k] = ((ends[0] - ends[1]) / (2.0 * step))[:count]
    values = np.linalg.eigvalsh(0.5 * (stiffness + stiffness.T))
    return float(values[0]), float(values[-1])


def _exact(system: System, place: Array) -> tuple[float, float, float] | None:
    """Bring a place of rest by the tables to one by the lines' own forces, if there is one."""
    arm = max(leg.fairlead_radius for leg in system.legs) or 1.0
    scales = np.array([1.0, 1.0, 1.0 / arm])
    size = math.hypot(*system.force) + abs(system.moment) / arm + 1e-300
    size += sum(line.H for line in _hung(system, tuple(place)))

    def left(at: Array) -> Array:
        there = tuple(at * scales)
        spans = _geometry(system, there)[2]
        try:
            forces = np.array([_force(system, k, span) for k, span in enumerate(spans)])
        except CatoptError:
            return np.full(3, 1e3)
        out: Array = _left(system, there, forces) * scales / size
        return out

    found = root(left, place / scales, method="hybr", options={"xtol": 1e-14})
    x, y, yaw = found.x * scales
    return (float(x), float(y), float(yaw)) if np.abs(found.fun).max() <= 1e-7 else None


def main() -> None:
    """Run a campaign and print its table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=10_000)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    start = time.process_time()
    tally = run(arguments.count, arguments.seed)
    for failure in tally.failures:
        print(f"{failure.index}: {failure.fault}")  # noqa: T201 - it is a command
    rows = [(name, value) for name, value in vars(tally).items() if name != "failures"]
    lines = [f"| {name.replace('_', ' ')} | {value:,} |" for name, value in rows]
    print("\n".join(["| systems | count |", "|---|---|", *lines]))  # noqa: T201
    print(f"{time.process_time() - start:.0f} s of one core")  # noqa: T201


if __name__ == "__main__":
    main()
