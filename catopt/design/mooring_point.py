"""One mooring in full, in plain closed form: every state that differs, and what governs it."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Annotated, NamedTuple

from catopt.checks.criteria import criteria_of
from catopt.checks.kinds import Place, State
from catopt.checks.result import CheckReport, CheckResult
from catopt.checks.system import InState, check_state
from catopt.largest import first_largest
from catopt.model import DesignLoad, System
from catopt.model.kinds import Angle, Length, Strength
from catopt.mooring.solution import SystemSolution, solution_at
from catopt.mooring.zero_load import ZeroLoadPosition, zero_load_position
from catopt.records import From
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.design.mooring import MooringProblem


SAME_ANGLE = 1e-9
"""rad within which two directions are one: what rounding may add, and nothing that is meant."""


class BodyState(NamedTuple):
    """One state of a mooring under one heading of its force."""

    missing: int  # the line that is gone, from 0; -1 while all are there
    heading: int  # index of the direction of the force


class LoadedState(NamedTuple):
    """One state of a mooring: which line is gone, -1 for none, under which load, towards where."""

    missing: int
    load: DesignLoad
    direction: float


def states_of(
    loads: Sequence[DesignLoad], azimuths: Sequence[float], *, turns: bool
) -> tuple[LoadedState, ...]:
    """List the states of a layout that differ: height by height, with all lines first."""
    states = [
        LoadedState(state.missing, load, load.directions[state.heading])
        for load in loads
        for state in distinct_states(
            azimuths, load.directions, with_line_out=load.line_out, mirrors=not turns
        )
    ]
    heights = list(dict.fromkeys(load.lift for load in loads))
    return tuple(sorted(states, key=lambda each: (heights.index(each.load.lift), each.missing)))


def distinct_states(
    azimuths: Sequence[float], directions: Sequence[float], *, with_line_out: bool, mirrors: bool
) -> tuple[BodyState, ...]:
    """List the states that differ: of those that a turn of the whole pattern brings to one, one.

    Of equal lines about a body and of directions of a force of one size, rad; with each line gone
    in turn, too, where `with_line_out`. Where the body does not turn and nothing turns it, mirror
    images count as one: `mirrors`.

    Examples
    --------
    >>> from math import radians
    >>> six, twelve = ([radians(360.0 / n * k) for k in range(n)] for n in (6, 12))
    >>> len(distinct_states(six, twelve, with_line_out=True, mirrors=False))
    14
    >>> len(distinct_states(six, twelve, with_line_out=True, mirrors=True))
    9
    """
    maps = list(_maps(azimuths, directions, mirrors))
    missing = range(-1, len(azimuths) if with_line_out and len(azimuths) > 1 else 0)
    found: list[BodyState] = []
    known: set[BodyState] = set()
    for state in itertools.starmap(BodyState, itertools.product(missing, range(len(directions)))):
        if state not in known:
            found.append(state)
            for lines, headings in maps:
                gone = -1 if state.missing < 0 else lines[state.missing]
                reached = headings[state.heading]
                if reached is not None:
                    known.add(BodyState(gone, reached))
    return tuple(found)


def _maps(
    azimuths: Sequence[float], directions: Sequence[float], mirrors: bool
) -> Iterator[tuple[list[int], list[int | None]]]:
    """Yield each turn (and mirroring) that leaves the pattern as it is, as where things go."""
    for sign in (1.0, -1.0) if mirrors else (1.0,):
        for target in azimuths:
            by = target - sign * azimuths[0]
            lines = [_place(sign * angle + by, azimuths) for angle in azimuths]
            if None not in lines and len(set(lines)) == len(lines):
                headings = [_place(sign * angle + by, directions) for angle in directions]
                yield [each for each in lines if each is not None], headings


def _place(angle: float, among: Sequence[float]) -> int | None:
    """Return the index of a direction among others, None where it is none of them."""
    apart = (abs(math.remainder(angle - other, 2.0 * math.pi)) for other in among)
    return next((k for k, each in enumerate(apart) if each <= SAME_ANGLE), None)


def widest_gap(azimuths: Sequence[float]) -> float:
    """Return the largest angle between two neighbouring lines, rad; a full turn of one line."""
    around = sorted(angle % (2.0 * math.pi) for angle in azimuths)
    beside = [*around[1:], around[0] + 2.0 * math.pi]
    return max(after - before for before, after in zip(around, beside, strict=True))


@dataclass(frozen=True)
class MooringPoint:
    """A mooring, checked."""

    system: System  # with all lines, under the force of the case or its first load
    checks: (
        CheckReport  # of each check the hardest: over all lines, headings and states of its kind
    )
    offset: float  # the largest, from the zero-load position with all lines, m
    anchor_load: float  # the largest tension at an anchor, of any line in any state, N
    farthest: SystemSolution  # the body with all lines under the force of that heading
    state: Message
    """State and heading, in words."""
    load: DesignLoad  # of which load
    pretension: Strength | None = None
    """Horizontal force in each line with the body at its origin, where the search chose it."""

    @property
    def azimuths(self) -> Annotated[tuple[Angle, ...], From(1)]:
        """Of each line, counter-clockwise from x."""
        return tuple(leg.azimuth for leg in self.system.legs)

    @property
    def anchor_radius(self) -> Length:
        """From the body's origin to the anchors."""
        return self.system.legs[0].anchor_radius


@dataclass(frozen=True)
class _Solved:
    """One state with the way of the body from its zero-load position with all lines, m."""

    state: InState
    solution: SystemSolution
    offset: float
    load: DesignLoad


def mooring_point(problem: MooringProblem, genes: tuple[int, ...]) -> MooringPoint:
    """Solve and check a mooring in every state that differs; errors as for `solve_system`."""
    case, system = problem.case, problem.system(genes)
    criteria = criteria_of(case)
    states: tuple[State, ...] = ("intact", "one_line_out")
    if len(problem.states) == 1:
        states = ("intact",)
    line = system.legs[0].line
    strengths = {line: criteria.strengths(line, {"extreme"}, states)}
    solved = tuple(_solved(problem, genes))
    results = [
        each for one in solved for each in check_state(one.state, criteria, strengths, case.anchor)
    ]
    far = solved[first_largest([each.offset for each in solved])]
    loaded = problem.system(genes, far.load.lift)
    zero = zero_load_position(loaded.under(far.solution.system.force, system.moment))
    rest, lines = zero.under(zero.system.force, system.moment)
    report = CheckReport(
        title=case.title,
        results=tuple(hardest_of(results)),
        solutions=((far.state.name, far.solution.lines[far.solution.most_loaded].solution),),
        warnings=tuple(dict.fromkeys(said for each in solved for said in each.solution.warnings)),
        case=case,
    )
    farthest = solution_at(zero, rest, lines)
    return MooringPoint(
        system,
        report,
        far.offset,
        max(leg.solution.anchor.tension for each in solved for leg in each.solution.lines),
        farthest,
        far.state.name,
        far.load,
        problem.pretension(genes),
    )


def _solved(problem: MooringProblem, genes: tuple[int, ...]) -> Iterator[_Solved]:
    """Solve each state, those of one height and missing line together."""
    system = problem.system(genes)
    positions: dict[tuple[float, int], ZeroLoadPosition] = {}
    numbers = range(1, len(system.legs) + 1)
    azimuths = [leg.azimuth for leg in system.legs]
    for missing, load, angle in states_of(problem.loads, azimuths, turns=system.turns):
        key = load.lift, missing
        if key not in positions:
            lifted = problem.system(genes, load.lift)
            left = lifted if missing < 0 else lifted.without([missing])
            positions[key] = zero_load_position(left)
        zero, force = positions[key], load.towards(angle)
        zero = replace(zero, system=zero.system.under(force, system.moment))
        rest, lines = zero.under(force, system.moment)
        solution = solution_at(zero, rest, lines, looks_round=False)
        gone = None if missing < 0 else missing + 1
        state = InState(
            Place() if gone is None else Place("one_line_out", missing=gone),
            solution,
            tuple(number for number in numbers if number != gone),
            under=under(load, angle),
        )
        neutral = positions[load.lift, -1].neutral
        yield _Solved(state, solution, math.hypot(rest.x - neutral.x, rest.y - neutral.y), load)


def under(load: DesignLoad, direction: float) -> Message:
    """Say which load it is and towards where its force acts."""
    heading = Message("checks.heading", heading=math.degrees(direction) % 360.0)
    return Message("checks.state_under", state=load.name, load=heading) if load.name else heading


def hardest_of(results: Iterable[CheckResult]) -> Iterator[CheckResult]:
    """Keep of each check, by source and kind of state, the one that is nearest to its limit."""
    worst: dict[tuple[object, ...], CheckResult] = {}
    for each in results:
        key = (each.place.state, each.kind, each.name, each.source)
        known = worst[key].exceedance if key in worst else -math.inf
        # The first of several that rounding alone tells apart.
        if key not in worst or each.exceedance > known + 1e-9 * abs(known):
            worst[key] = each
    return iter(worst.values())
