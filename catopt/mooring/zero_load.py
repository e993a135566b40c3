"""A system at rest under no load: the place from which every load is followed."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from time import perf_counter

from catopt.catenary.state import CONVERGED, NOT_CONVERGED, TOO_SHORT
from catopt.errors import CatoptError, NoEquilibriumError, NotConvergedError
from catopt.model.system import System
from catopt.mooring.balance import Arrangement, Lines, RestoringForce, arrange, pull_at, room_for
from catopt.mooring.descent import (
    TURNS_OVER,
    BodyLoad,
    BodyProblem,
    Freedom,
    Rest,
    freedom_of,
    within_half_a_turn,
    yaw_stiffness,
)
from catopt.mooring.static_equilibrium import SAME_YAW, next_heading, static_equilibrium
from catopt.patience import expect
from catopt.words import Message


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
