"""Where the body comes to rest under a load: downhill from where it is, or else round in yaw.

With x and y at rest, the moment left on the body is minus the slope of one potential over the yaw.
Where it passes from turning the body on to turning it back, the body rests and stays. Over a full
turn the moment of the lines has a mean of zero, so that such a heading exists for every moment
between their largest one in either sense. Where it rests under no load is the place from which
every load is followed.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from time import perf_counter
from typing import Final, NamedTuple

from catopt.catenary.state import CONVERGED, NOT_CONVERGED, TOO_SHORT
from catopt.compiled import inlined
from catopt.errors import CatoptError, NoEquilibriumError, NotConvergedError
from catopt.model.system import System
from catopt.mooring.balance import Arrangement, Lines, RestoringForce, arrange, pull_at, room_for
from catopt.mooring.descent import (
    ENOUGH,
    EXACT,
    TURNS_OVER,
    BodyLoad,
    BodyProblem,
    Freedom,
    Rest,
    by_parts,
    freedom_of,
    is_stable,
    newton,
    within_half_a_turn,
    yaw_stiffness,
)
from catopt.progress import expect
from catopt.words import Message

FULL = 2.0 * math.pi
STRIDE, LEAST_STRIDE = FULL / 36.0, 1e-8
"""rad, from one yaw looked at to the next: as a rule, and where lines bar the way."""

ROUGHLY = 1e-4
"""Part of the forces that may be left on the way round when only other headings are looked for."""

FINEST = STRIDE / 24.0
"""rad, below which a stride is not halved for the moment's bends."""

STRIDES = 2000
NARROWINGS = 80
SAME_YAW, CLOSE = 1e-3, 1e-6
"""rad, within which two headings are one, at its largest moment a body being all but loose in yaw;
and how far the last steps to a heading may take it from where it was found."""


class Heading(NamedTuple):
    """The body at one yaw, x and y at rest if the status of `rest` says so.

    `left` is the moment that nothing balances (N m), above 0 where it turns the body on;
    `stiffness` says by how much it falls as the body turns, N m.
    """

    rest: Rest
    left: float
    stiffness: float


def first_heading(x: float, y: float, yaw: float, problem: BodyProblem) -> Rest:
    """Find the first stable heading that the load turns the body to.

    TURNS_OVER, with the least moment left, when no heading stops the body; the status of what
    barred the way where some yaws have no answer.
    """
    pull = pull_at(x, y, yaw, problem.arrangement, problem.lines, True)
    start = newton(x, y, yaw, pull, _at_this_yaw(problem, EXACT))
    if start.status == NOT_CONVERGED:
        start = by_parts(x, y, yaw, _at_this_yaw(problem, EXACT))
    sense = -1.0 if problem.load.moment + start.pull.moment < 0.0 else 1.0
    here = _heading(start, sense, problem)
    # A stride more than a turn: a start that is itself the heading is met at the end.
    way = FULL + STRIDE
    return _go_round(here, sense, way, math.inf, EXACT, problem)


def next_heading(rest: Rest, way: float, problem: BodyProblem) -> Rest:
    """Find the next stable heading counter-clockwise of one, no farther than `way` rad on.

    TURNS_OVER, or what barred the way, when there is none; parameters as for `first_heading`.
    """
    here = _heading(rest, 1.0, problem)._replace(left=0.0)
    return _go_round(here, 1.0, way, 0.0, ROUGHLY, problem)


def _go_round(
    here: Heading, sense: float, way: float, least: float, exact: float, problem: BodyProblem
) -> Rest:
    """Turn the body on until a heading stops it.

    `least` is the moment left below which a turning point of the moment is worth a closer look,
    `exact` the part of the forces at which x and y are at rest.
    """
    start_yaw, best = here.rest.yaw, here
    status, line = here.rest.status, here.rest.line
    stride, gap = STRIDE, 0.0
    for _ in range(STRIDES):
        ahead = gap if gap > 0.0 else stride
        there = _onward(here, sense * ahead, sense, exact, problem)
        is_answered = there.rest.status == CONVERGED
        if is_answered and gap == 0.0 and here.rest.status == CONVERGED:
            small = 10.0 * max(exact, CLOSE) * _scale(there, problem)
            if stride > FINEST and _may_hide(here, there, least, small):
                stride *= 0.5
                continue
            here, there = _narrowed(here, there, sense, least, problem)
            if here.left > 0.0 >= there.left:
                return _rest_between(here, there, sense, problem)
            for each in (here, there):
                if each.left < least:
                    least, best = each.left, each
        if is_answered:
            here, stride, gap = there, min(2.0 * stride, STRIDE), 0.0
        elif gap > 0.0 or stride <= LEAST_STRIDE or here.rest.status != CONVERGED:
            status, line, gap = there.rest.status, there.rest.line, gap + STRIDE
        else:
            stride *= 0.25
        if abs(here.rest.yaw - start_yaw) + gap >= way:
            return _unstopped(best, status, line)
    return _unstopped(best, NOT_CONVERGED, -1)


@inlined
def _unstopped(best: Heading, status: int, line: int) -> Rest:
    """Say where the least moment was left, and what barred the way if anything did."""
    why = TURNS_OVER if status == CONVERGED else status
    end = best.rest
    return Rest(
        why, line, end.x, end.y, end.yaw, end.steps, end.force_error, abs(best.left), end.pull
    )


def _may_hide(here: Heading, there: Heading, least: float, small: float) -> bool:
    """Whether the moment bends so much between two yaws that it may turn back in between.

    It bends where a line becomes slack. Above zero what matters is whether it falls below `least`.
    """
    if here.left > 0.0 >= there.left:
        return False
    room = 0.0
    if here.left > 0.0 and there.left > 0.0:
        room = max(min(here.left, there.left) - least, 0.0)
    elif here.left <= 0.0 and there.left <= 0.0:
        room = -max(here.left, there.left)
    width = abs(there.rest.yaw - here.rest.yaw)
    bend = there.left - here.left + 0.5 * width * (here.stiffness + there.stiffness)
    return abs(bend) > 0.5 * room + small


def _narrowed(
    here: Heading, there: Heading, sense: float, least: float, problem: BodyProblem
) -> tuple[Heading, Heading]:
    """Close in on a turning point of the moment between two yaws, where one may matter.

    Above zero it is one at which the moment left is least, below zero one at which it is largest.
    Ends with yaws between which the moment passes through zero, or close to the turning point.
    """
    for _ in range(NARROWINGS):
        is_on = here.left > 0.0
        width = abs(there.rest.yaw - here.rest.yaw)
        if is_on != (there.left > 0.0) or width <= LEAST_STRIDE:
            break
        if (here.stiffness > 0.0) != is_on or (there.stiffness > 0.0) == is_on:
            break
        # The tangents at both ends meet at a level that the moment does not pass where it curves
        # to one side only.
        way = (there.stiffness * width + there.left - here.left) / (
            there.stiffness - here.stiffness
        )
        way = min(max(way, 0.0), width)
        level = here.left - here.stiffness * way
        nearest = min(here.left, there.left)
        if (level >= min(least, nearest - ENOUGH * abs(nearest))) if is_on else (level <= 0.0):
            break
        turn = sense * min(max(way, 0.1 * width), 0.9 * width)
        middle = _onward(here, turn, sense, EXACT, problem)
        if middle.rest.status != CONVERGED:
            break
        if (middle.left > 0.0) != is_on:
            return (here, middle) if is_on else (middle, there)
        if (middle.stiffness > 0.0) == (here.stiffness > 0.0):
            here = middle
        else:
            there = middle
    return here, there


def _rest_between(here: Heading, there: Heading, sense: float, problem: BodyProblem) -> Rest:
    """Come to rest between a yaw from which the body is turned on and one that turns it back."""
    before, width = math.inf, math.inf
    for _ in range(NARROWINGS):
        near = here if here.left < -there.left else there
        last_width, width = width, abs(there.rest.yaw - here.rest.yaw)
        if abs(near.left) <= ENOUGH * _scale(near, problem) or width <= 1e-14:
            break
        # Newton's step from the nearer end, halving where it leaves the two or is slow.
        way = 0.0
        if near.stiffness > 0.0:
            way = abs(near.rest.yaw - here.rest.yaw) + near.left / near.stiffness
        is_slow = abs(near.left) > 0.25 * before and width > 0.5 * last_width
        if not 0.0 < way < width or is_slow:
            way = 0.5 * width
        before = abs(near.left)
        middle = _onward(here, sense * way, sense, EXACT, problem)
        if middle.rest.status != CONVERGED:
            break
        if middle.left > 0.0:
            here = middle
        else:
            there = middle
    near = here if here.left < -there.left else there
    at = near.rest
    pull = pull_at(at.x, at.y, at.yaw, problem.arrangement, problem.lines, True)
    rest = newton(at.x, at.y, at.yaw, pull, problem)
    is_near = abs(rest.yaw - at.yaw) <= max(width, CLOSE)
    if rest.status == CONVERGED and is_near and is_stable(rest.pull, problem.freedom):
        return rest
    pull = pull_at(at.x, at.y, at.yaw, problem.arrangement, problem.lines, True)
    is_done = abs(near.left) <= ENOUGH * _scale(near, problem)
    status = CONVERGED if is_done else NOT_CONVERGED
    return Rest(status, -1, at.x, at.y, at.yaw, at.steps, at.force_error, abs(near.left), pull)


def _onward(
    here: Heading, turn: float, sense: float, exact: float, problem: BodyProblem
) -> Heading:
    """Turn the body by `turn` rad and let x and y follow."""
    at = here.rest
    x, y = at.x, at.y
    plane = at.pull.xx * at.pull.yy - at.pull.xy * at.pull.xy
    freedom = problem.freedom
    if freedom.in_plane and plane > 0.0:
        move_x = turn * (at.pull.xy * at.pull.ym - at.pull.yy * at.pull.xm) / plane
        move_y = turn * (at.pull.xy * at.pull.xm - at.pull.xx * at.pull.ym) / plane
        x, y = x + move_x, y + move_y
    yaw = at.yaw + turn
    pull = pull_at(x, y, yaw, problem.arrangement, problem.lines, True)
    rest = newton(x, y, yaw, pull, _at_this_yaw(problem, exact))
    return _heading(rest, sense, problem)


@inlined
def _heading(rest: Rest, sense: float, problem: BodyProblem) -> Heading:
    left = sense * (problem.load.moment + rest.pull.moment)
    return Heading(rest, left, yaw_stiffness(rest.pull, problem.freedom.in_plane))


@inlined
def _at_this_yaw(problem: BodyProblem, exact: float) -> BodyProblem:
    load, freedom, arrangement, lines = problem
    held = Freedom(
        freedom.in_plane, False, freedom.arm, freedom.stride, freedom.scale, freedom.floor, exact
    )
    return BodyProblem(load, held, arrangement, lines)


@inlined
def _scale(heading: Heading, problem: BodyProblem) -> float:
    """Moment beside which what is left is small, N m."""
    load, freedom = problem.load, problem.freedom
    force = math.sqrt(load.x * load.x + load.y * load.y)
    return freedom.arm * (heading.rest.pull.total + force + freedom.scale)


NUDGE: Final = 0.01
"""rad by which a body that balances on a ridge is turned off it."""


def static_equilibrium(
    x: float, y: float, yaw: float, pull: RestoringForce, problem: BodyProblem
) -> Rest:
    """Find the place of rest under a load, its yaw within half a turn either way; as `newton`."""
    freedom = problem.freedom
    rest = newton(x, y, yaw, pull, problem)
    if rest.status in (NOT_CONVERGED, TOO_SHORT) and pull.status == CONVERGED:
        rest = by_parts(x, y, yaw, problem)
    if not freedom.in_yaw or pull.status != CONVERGED:
        return rest
    if rest.status == CONVERGED and not is_stable(rest.pull, freedom):
        nudged = rest.yaw + NUDGE
        at = pull_at(rest.x, rest.y, nudged, problem.arrangement, problem.lines, True)
        rest = newton(rest.x, rest.y, nudged, at, problem)
    if rest.status != CONVERGED or not is_stable(rest.pull, freedom):
        rest = first_heading(x, y, yaw, problem)
    return within_half_a_turn(rest)


def refusal(rest: Rest, system: System) -> CatoptError:
    """Say what stops the body from coming to rest."""
    if rest.line < 0 or rest.status == NOT_CONVERGED:
        key = "mooring.not_at_rest" if rest.line < 0 else "mooring.not_at_rest_for_line"
        values = {"steps": rest.steps, "x": rest.x, "y": rest.y, "number": rest.line + 1}
        return NotConvergedError(Message(key, **values))
    leg = system.legs[rest.line]
    fairlead = leg.fairlead
    cosine, sine = math.cos(rest.yaw), math.sin(rest.yaw)
    span = math.hypot(
        leg.anchor[0] - rest.x - cosine * fairlead[0] + sine * fairlead[1],
        leg.anchor[1] - rest.y - sine * fairlead[0] - cosine * fairlead[1],
    )
    assert rest.status == TOO_SHORT
    missing = math.hypot(span, leg.fairlead_height - leg.anchor_height) - leg.line.length
    values = {"number": rest.line + 1, "span": span, "missing": missing}
    return NoEquilibriumError(Message("mooring.too_short", **values), "length", missing)


def turns_over(moment: float, rest: Rest) -> CatoptError:
    """Say that the lines cannot carry a moment (N m), and the largest that they carry."""
    missing = rest.moment_error
    # Over a full turn the moment of the lines has a mean of zero: below that is rounding.
    largest = max(abs(moment) - missing, 0.0)
    values = {"moment": moment, "largest": largest, "missing": missing}
    return NoEquilibriumError(Message("mooring.turns_over", **values), "moment", missing)


SHORT_OF_TAUT = 0.999
"""Part of its length over which a line that does not stretch may reach at the start."""

PULLS_OF_A_TURN = 300
"""How often the lines are solved as a body goes round, roughly: 36 strides, some steps in each."""

NOTHING = BodyLoad(0.0, 0.0, 0.0)


@dataclass(frozen=True)
class ZeroLoadPosition:
    """A system (its load plays no part), its lines and freedom as numbers, at rest in `neutral`."""

    system: System
    arrangement: Arrangement
    freedom: Freedom
    neutral: Rest
    lines: Lines

    def under(self, force: Sequence[float], moment: float = 0.0) -> tuple[Rest, Lines]:
        """Bring the body to rest under a load, N and N m; errors as for `solve_system`."""
        lines = copied(self.lines)
        start = self.neutral
        load = BodyLoad(float(force[0]), float(force[1]), float(moment))
        problem = BodyProblem(load, self.freedom, self.arrangement, lines)
        rest = static_equilibrium(start.x, start.y, start.yaw, start.pull, problem)
        if rest.status == TURNS_OVER:
            raise turns_over(moment, rest)
        if rest.status != CONVERGED:
            raise refusal(rest, self.system)
        return rest, lines

    def other_headings(
        self, rest: Rest, lines: Lines, force: Sequence[float], moment: float = 0.0
    ) -> tuple[Rest, ...]:
        """Find where else the body would rest, at another yaw, under the load it rests under.

        None is looked for where the lines do not hold the body.
        """
        if not self.freedom.in_yaw or not is_held(rest.pull, self.freedom):
            return ()
        load = BodyLoad(float(force[0]), float(force[1]), float(moment))
        problem = BodyProblem(load, self.freedom, self.arrangement, copied(lines))
        total = len(self.system.legs)
        began = perf_counter()
        pull_at(rest.x, rest.y, rest.yaw, self.arrangement, problem.lines, True)
        seconds = PULLS_OF_A_TURN * (perf_counter() - began)
        expect(Message("words.other_headings", total=total), seconds)
        found: list[Rest] = []
        at, end = rest, rest.yaw + 2.0 * math.pi - SAME_YAW
        while True:
            at = next_heading(at, end - at.yaw, problem)
            if at.status != CONVERGED or at.yaw >= end:
                return tuple(found)
            if at.yaw > rest.yaw + SAME_YAW and is_held(at.pull, self.freedom):
                found.append(within_half_a_turn(at))

    def held(self, x: float, y: float) -> tuple[Rest, Lines]:
        """Hold the body at a place, m; it still turns where it is free to, under no moment.

        An error when a line does not reach there, or has no answer.
        """
        lines = copied(self.lines)
        pull = pull_at(x, y, self.neutral.yaw, self.arrangement, lines, True)
        freedom = self.freedom._replace(in_plane=False)
        problem = BodyProblem(NOTHING, freedom, self.arrangement, lines)
        rest = static_equilibrium(x, y, self.neutral.yaw, pull, problem)
        if rest.status != CONVERGED:
            raise refusal(rest, self.system)
        return rest, lines


def zero_load_position(system: System) -> ZeroLoadPosition:
    """Find the zero-load position, starting from the origin with yaw 0.

    NoEquilibriumError when lines that do not stretch are too short to reach the body together.
    """
    arrangement = arrange(system)
    arm = max(leg.fairlead_radius for leg in system.legs)
    freedom = freedom_of(arrangement, system.turns, arm)
    lines = room_for(len(system.legs))
    x, y = _reachable(system)
    pull = pull_at(x, y, 0.0, arrangement, lines, True)
    problem = BodyProblem(NOTHING, freedom, arrangement, lines)
    neutral = static_equilibrium(x, y, 0.0, pull, problem)
    if neutral.status != CONVERGED:
        raise refusal(neutral, system)
    return ZeroLoadPosition(system, arrangement, freedom, neutral, lines)


def copied(lines: Lines) -> Lines:
    """Copy what is known of the lines."""
    return Lines(*(list(column) for column in lines))


def _reachable(system: System) -> tuple[float, float]:
    """Find a place that every line which does not stretch can reach, at or near the origin; m.

    The reach of each is a disc round its anchor; projecting on one after the other leads into
    what they share, if they share anything.
    """
    discs = []
    for index, leg in enumerate(system.legs):
        if all(segment.is_inextensible for segment in leg.line.segments):
            rise = leg.fairlead_height - leg.anchor_height
            left = leg.line.length**2 - rise**2
            if left <= 0.0:
                length, missing = leg.line.length, abs(rise) - leg.line.length
                values = {"length": length, "rise": abs(rise), "missing": missing}
                said = Message("mooring.too_short_to_hang", number=index + 1, **values)
                raise NoEquilibriumError(said, "length", missing)
            centre = (leg.anchor[0] - leg.fairlead[0], leg.anchor[1] - leg.fairlead[1])
            discs.append((index, centre, math.sqrt(left)))
    x, y = 0.0, 0.0
    for _ in range(1000):
        worst, worst_line = 0.0, -1
        for index, (cx, cy), reach in discs:
            distance = math.hypot(x - cx, y - cy)
            if distance >= reach:
                if distance - reach >= worst:
                    worst, worst_line = distance - reach, index
                share = SHORT_OF_TAUT * reach / distance
                x, y = cx + share * (x - cx), cy + share * (y - cy)
        if worst_line < 0:
            return x, y
    said = Message("mooring.none_reach", number=worst_line + 1, missing=worst)
    raise NoEquilibriumError(said, "length", worst)


def is_held(pull: RestoringForce, freedom: Freedom) -> bool:
    """Whether the lines hold the body against a push from any side, and a turn if it is free."""
    least = 1e-9 * max(pull.xx + pull.yy, 1e-300)
    if pull.xx * pull.yy - pull.xy * pull.xy <= least * (pull.xx + pull.yy):
        return False
    if not freedom.in_yaw:
        return True
    return yaw_stiffness(pull, freedom.in_plane) > least * freedom.arm * freedom.arm
