"""The questions turned round: which length, force or clump weight gives what is wanted.

Each is one bracketed root (Brent, scipy) of a quantity that rises or falls with the unknown, over
the closed form; each answer carries the line it belongs to and what is left of its condition.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Literal

from catopt.catenary.solution import FoundQuantity, Solution
from catopt.catenary.solve import solve
from catopt.errors import (
    InputError,
    NoAnswerError,
    NoEquilibriumError,
    NotConvergedError,
    Problem,
    TouchesTwiceError,
)
from catopt.model import Case, Line, Load, PointLoad

__all__ = [
    "Found",
    "find_case",
    "find_clump_weight",
    "find_length",
    "find_limit_force",
    "find_touchdown_force",
    "with_segment_length",
]

ROUNDING = 4.0 * 2.0**-52
FAR = 1e9
"""How many times its natural size an unknown may grow before it is called out of reach."""


@dataclass(frozen=True)
class Found(FoundQuantity):
    """An unknown that meets a condition, with the line that has it.

    Attributes
    ----------
    solution : Solution
        The line with this value.
    """

    solution: Solution = field(kw_only=True)

    def alone(self) -> FoundQuantity:
        """Return the quantity without its line."""
        return FoundQuantity(self.quantity, self.value, self.condition, self.residual, self.number)


def find_length(
    line: Line,
    *,
    height: float,
    horizontal_force: float | None = None,
    fairlead_tension: float | None = None,
    segment: int = -1,
    anchor_angle: float | None = None,
    grounded_length: float | None = None,
    seabed_friction: float = 0.0,
    anchor_height: float = 0.0,
) -> Found:
    """Find the length of one segment that gives an anchor angle or a grounded length.

    Point loads keep their place on their own segment.

    Parameters
    ----------
    line : Line
        The line; the length of the segment sought is where the search starts.
    height, horizontal_force, fairlead_tension, seabed_friction, anchor_height
        As for `solve`; one of the two loads.
    segment : int
        Which segment, counted from 0 at the anchor; -1 is the one at the fairlead.
    anchor_angle : float, optional
        Inclination at the anchor, rad; 0 brings the touchdown to the anchor.
    grounded_length : float, optional
        Unstretched length on the bed, m, above 0.

    Raises
    ------
    InputError
        Unless exactly one of `anchor_angle` and `grounded_length` is given, in range.
    NoAnswerError
        When no length gives it.
    """
    index = _index("segment", segment, len(line.segments))
    _one_of(anchor_angle=anchor_angle, grounded_length=grounded_length)

    def at(length: float) -> Solution:
        return solve(
            with_segment_length(line, index, length),
            height=height,
            horizontal_force=horizontal_force,
            fairlead_tension=fairlead_tension,
            seabed_friction=seabed_friction,
            anchor_height=anchor_height,
        )

    if anchor_angle is not None:
        condition = f"inclination at the anchor {math.degrees(anchor_angle):.6g} deg"
        miss = _angle_miss(anchor_angle)
    else:
        assert grounded_length is not None
        condition = f"grounded length {grounded_length:.6g} m"
        miss = _grounded_miss(grounded_length)
    shortest = _shortest(line, index, abs(height - anchor_height))
    start = max(line.segments[index].length, shortest * (1.0 + 1e-6))
    sought = _Sought("length", condition, at, miss, falls=True, number=index + 1)
    return _find(sought, start, shortest)


def find_touchdown_force(line: Line, *, height: float, seabed_friction: float = 0.0) -> Found:
    """Find the horizontal force at which the touchdown reaches the anchor.

    Above it the line lifts at the anchor. For a uniform inextensible line it is
    (w/2)(L2/h - h), S2 and S3.

    Parameters
    ----------
    line : Line
        Anchored on the bed.
    height, seabed_friction
        As for `solve`.
    """

    def at(force: float) -> Solution:
        return solve(line, height=height, horizontal_force=force, seabed_friction=seabed_friction)

    sought = _Sought("horizontal_force", "touchdown at the anchor", at, _angle_miss(0.0))
    return _find(sought, abs(line.submerged_weight), 0.0)


def find_clump_weight(
    line: Line,
    *,
    height: float,
    horizontal_force: float | None = None,
    span: float | None = None,
    fairlead_tension: float | None = None,
    point_load: int = 0,
    anchor_angle: float = 0.0,
    seabed_friction: float = 0.0,
    anchor_height: float = 0.0,
) -> Found:
    """Find the submerged weight of a point load that brings the anchor angle down to a value.

    Parameters
    ----------
    line : Line
        With the clump weight in its place; its weight is ignored.
    height, horizontal_force, span, fairlead_tension, seabed_friction, anchor_height
        As for `solve`.
    point_load : int
        Which point load, counted from 0 at the anchor.
    anchor_angle : float
        rad.

    Raises
    ------
    NoAnswerError
        When the angle is no larger without it, or no weight brings it down.
    """
    index = _index("point_load", point_load, len(line.point_loads))

    def at(weight: float) -> Solution:
        loads = list(line.point_loads)
        loads[index] = replace(loads[index], submerged_weight=weight, mass=None)
        return solve(
            Line(line.segments, loads),
            height=height,
            horizontal_force=horizontal_force,
            span=span,
            fairlead_tension=fairlead_tension,
            seabed_friction=seabed_friction,
            anchor_height=anchor_height,
        )

    miss = _angle_miss(anchor_angle)
    condition = f"inclination at the anchor {math.degrees(anchor_angle):.6g} deg"
    without = at(0.0)
    if miss(without)[0] <= 0.0:
        raise NoAnswerError(
            f"no clump weight is needed: without it the inclination at the anchor is "
            f"{math.degrees(without.anchor.angle):.4g} deg, not above the "
            f"{math.degrees(anchor_angle):.4g} deg asked for"
        )
    size = max(abs(line.submerged_weight), 1e-3 * without.fairlead.tension)
    sought = _Sought("clump_weight", condition, at, miss, falls=True, number=index + 1)
    return _find(sought, size, 0.0)


def find_limit_force(
    line: Line,
    *,
    height: float,
    safety_factor: float = 1.0,
    segment: int | None = None,
    seabed_friction: float = 0.0,
    anchor_height: float = 0.0,
) -> Found:
    """Find the horizontal force at which a segment reaches MBL over the safety factor.

    Parameters
    ----------
    line : Line
        With the MBL of the segments in question.
    height, seabed_friction, anchor_height
        As for `solve`.
    safety_factor : float
        At least 1.
    segment : int, optional
        Which segment, counted from 0 at the anchor; whichever reaches its limit first when left
        out.

    Raises
    ------
    NoAnswerError
        When what hangs from the fairlead takes a segment beyond its limit at any force.
    """
    count = len(line.segments)
    chosen = range(count) if segment is None else [_index("segment", segment, count)]
    MBL = {k: line.segments[k].MBL for k in chosen}
    limits = {k: load / safety_factor for k, load in MBL.items() if load is not None}
    if not limits:
        which = "at least one segment" if segment is None else f"segment {segment}"
        raise InputError([Problem("MBL", "none", f"{which} needs its MBL")], "find_limit_force")

    def at(force: float) -> Solution:
        return solve(
            line,
            height=height,
            horizontal_force=force,
            seabed_friction=seabed_friction,
            anchor_height=anchor_height,
        )

    def miss(solution: Solution) -> tuple[float, float]:
        used = [solution.segments[k].max_tension / limit for k, limit in limits.items()]
        return max(used) - 1.0, 1.0

    which = "a segment" if segment is None else f"segment {chosen[0] + 1}"
    sought = _Sought("horizontal_force", f"{which} at MBL / {safety_factor:g}", at, miss)
    return _find(sought, 0.5 * min(limits.values()), 0.0)


def with_segment_length(line: Line, segment: int, length: float) -> Line:
    """Return a line with one segment's length changed; point loads keep their place on theirs.

    Parameters
    ----------
    line : Line
        The line.
    segment : int
        Which, counted from 0 at the anchor.
    length : float
        m.
    """
    segments = list(line.segments)
    change = length - segments[segment].length
    joint = math.fsum(part.length for part in segments[: segment + 1])
    segments[segment] = replace(segments[segment], length=length)
    return Line(segments, [_moved(load, joint, change) for load in line.point_loads])


def _moved(load: PointLoad, joint: float, change: float) -> PointLoad:
    return replace(load, position=load.position + change) if load.position > joint else load


def find_case(case: Case) -> Found:
    """Answer the question of a case's [find].

    Parameters
    ----------
    case : Case
        With `find`.

    Raises
    ------
    InputError
        When the quantity cannot be sought under the case's load.
    """
    assert case.find is not None
    find = case.find
    load = case.load or Load(horizontal_force=1.0)
    ends: dict[str, float] = {"height": case.fairlead_height}
    bed: dict[str, float] = {"seabed_friction": case.site.seabed_friction}
    if find.quantity == "touchdown_force":
        return find_touchdown_force(case.line, **ends, **bed)
    ends["anchor_height"] = case.anchor_height
    if find.quantity == "limit_force":
        factor = case.checks.safety_factor
        which = None if find.segment is None else find.segment - 1
        return find_limit_force(case.line, safety_factor=factor, segment=which, **ends, **bed)
    if find.quantity == "length":
        return find_length(
            case.line,
            horizontal_force=load.horizontal_force,
            fairlead_tension=load.fairlead_tension,
            segment=-1 if find.segment is None else find.segment - 1,
            anchor_angle=find.anchor_angle,
            grounded_length=find.grounded_length,
            **ends,
            **bed,
        )
    assert find.anchor_angle is not None
    return find_clump_weight(
        case.line,
        horizontal_force=load.horizontal_force,
        span=load.span,
        fairlead_tension=load.fairlead_tension,
        point_load=(find.point_load or 1) - 1,
        anchor_angle=find.anchor_angle,
        **ends,
        **bed,
    )


Miss = Callable[[Solution], tuple[float, float]]
"""What is missing of a condition, positive above it, and the size to measure it by."""


def _angle_miss(angle: float) -> Miss:
    """Vertical force at the anchor above the one wanted; below 0, what lies on the bed counts."""

    def miss(solution: Solution) -> tuple[float, float]:
        V = solution.anchor.vertical_force
        if solution.regime in ("grounded", "on-bed", "slack"):
            V = solution.fairlead.vertical_force - solution.line.submerged_weight
        wanted = solution.horizontal_force * math.tan(angle)
        return V - wanted, solution.fairlead.tension

    return miss


def _grounded_miss(length: float) -> Miss:
    """Grounded length short of the one wanted; of a lifted line, what would lift it further."""

    def miss(solution: Solution) -> tuple[float, float]:
        total = solution.line.length
        if solution.grounded_length > 0.0:
            return length - solution.grounded_length, total
        weight = abs(solution.line.submerged_weight) / total
        return length + abs(solution.anchor.vertical_force) / max(weight, 1e-300), total

    return miss


@dataclass(frozen=True)
class _Sought:
    """An unknown, and how the condition put on it depends on it.

    Attributes
    ----------
    quantity, condition, number
        As in `FoundQuantity`.
    at : callable
        The line with a value of the unknown.
    miss : callable
        What is missing of the condition.
    falls : bool
        Whether what is missing falls as the unknown grows.
    """

    quantity: Literal["length", "clump_weight", "horizontal_force"]
    condition: str
    at: Callable[[float], Solution]
    miss: Miss
    falls: bool = False
    number: int | None = None

    def error(self, value: float) -> float:
        """Say what is missing at a value, with the sign that makes it rise with the value."""
        try:
            missing = self.miss(self.at(value))[0]
        except NoEquilibriumError as stop:
            if self.quantity == "horizontal_force":
                raise  # no force mends what is missing
            # Too short a line pulls without bound; too little tension lifts nothing.
            missing = math.inf if stop.quantity == "length" else -math.inf
        except TouchesTwiceError:
            if self.quantity != "horizontal_force":
                raise
            missing = -math.inf  # too little force to lift what lies between the touchdowns
        return -missing if self.falls else missing

    def none(self) -> NoAnswerError:
        """Say that no value meets the condition."""
        return NoAnswerError(f"no {self.quantity.replace('_', ' ')} gives {self.condition}")


def _find(sought: _Sought, start: float, least: float) -> Found:
    """Bracket the root by growing strides away from `least`, then close in on it."""
    from scipy.optimize import brentq

    low, high = _bracket(sought, start, least)
    value = float(brentq(sought.error, low, high, xtol=ROUNDING * high, rtol=ROUNDING))
    solution = sought.at(value)
    left, size = sought.miss(solution)
    if abs(left) > 1e-8 * size:
        raise NotConvergedError(
            f"the search for the {sought.quantity.replace('_', ' ')} stopped where the condition, "
            f"{sought.condition}, is missed by {left / size:.3g}"
        )
    return Found(
        sought.quantity, value, sought.condition, left / size, sought.number, solution=solution
    )


def _bracket(sought: _Sought, start: float, least: float) -> tuple[float, float]:
    """Values with the error below and above 0, both finite."""
    error = sought.error
    high = start
    while error(high) < 0.0:
        high = least + 2.0 * (high - least)
        if high > FAR * max(start, 1.0):
            raise sought.none()
    low = start
    while error(low) > 0.0:
        low = least + 0.5 * (low - least)
        if low - least < start / FAR:
            raise sought.none()
    while math.isinf(error(low)):
        middle = 0.5 * (low + high)
        if not low < middle < high:
            raise sought.none()
        low, high = (middle, high) if error(middle) <= 0.0 else (low, middle)
    return low, high


def _shortest(line: Line, segment: int, rise: float) -> float:
    """Length of a segment below which the line surely does not reach up to its fairlead, m."""
    others = line.length - line.segments[segment].length
    on_it = [load.position for load in line.point_loads]
    before = math.fsum(part.length for part in line.segments[:segment])
    end = before + line.segments[segment].length
    held = max((p - before for p in on_it if before < p <= end), default=0.0)
    is_stiff = all(math.isinf(part.EA) for part in line.segments)
    return max(rise - others, held, 0.0) if is_stiff else held


def _index(key: str, index: int, count: int) -> int:
    if -count <= index < count:
        return index % count
    problem = Problem(key, str(index), f"from 0 to {count - 1}" if count else "the line has none")
    raise InputError([problem], "find")


def _one_of(**given: float | None) -> None:
    chosen = {key: value for key, value in given.items() if value is not None}
    problems = []
    if len(chosen) != 1:
        names = " and ".join(given)
        problems.append(Problem(names, f"{len(chosen)} of them", "exactly one is wanted"))
    for key, value in chosen.items():
        is_angle = key == "anchor_angle"
        if not (0.0 <= value < math.pi / 2 if is_angle else 0.0 < value < math.inf):
            allowed = "from 0 to below pi/2 rad" if is_angle else "a length above 0 m"
            problems.append(Problem(key, repr(value), allowed))
    if problems:
        raise InputError(problems, "find")
