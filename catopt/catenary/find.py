"""The questions turned round: which length, force or clump weight gives what is required.

Each is a search of the whole range (`sought`) over the closed form; each answer carries the line it
belongs to and what is left of its condition, and names the other answers where there are several.
"""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import takewhile
from typing import Any

from catopt.catenary.solution import Solution
from catopt.catenary.solve import solve
from catopt.catenary.unknowns import Condition, Found, Sought, find
from catopt.errors import CatoptError, InputError, NoAnswerError, Problem, refused
from catopt.model import Case, Line, Load, Segment
from catopt.model.kinds import Findings
from catopt.units import plain
from catopt.words import Measure, Message

__all__ = [
    "Found",
    "find_case",
    "find_clump_weight",
    "find_length",
    "find_limit_force",
    "find_touchdown_force",
    "with_segment_length",
]


_UNITS = {
    **dict.fromkeys(("height", "span", "grounded_length", "anchor_height", "sag"), "m"),
    **dict.fromkeys(("horizontal_force", "fairlead_tension"), "N"),
    "anchor_angle": "rad",
}
"""Of what a function is given; what is not there is a pure number."""


def _taken(source: str, **given: Any) -> tuple[Any, ...]:
    """Read text with a unit where it is one; InputError with all that is no number."""
    found = Findings(source)
    read: list[float | None] = []
    for name, value in given.items():
        least = 1.0 if name == "safety_factor" else None
        unit = _UNITS.get(name, "")
        read.append(None if value is None else found.taken(name, value, unit, at_least=least))
    found.raise_if_any()
    return tuple(read)


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
    span: float | None = None,
    sag: float | None = None,
) -> Found:
    """Find the length of one segment that gives an anchor angle, a grounded length or a sag.

    Or, for a known span, a tension or a horizontal force at the fairlead. Point loads keep their
    place on their own segment.

    Parameters
    ----------
    line : Line
        The line; the length of the segment sought is where the search starts.
    height, horizontal_force, fairlead_tension, span, seabed_friction, anchor_height
        As for `solve`; one of the three loads. Beside a span the other two are conditions.
    segment : int
        Which segment, counted from 0 at the anchor; -1 is the one at the fairlead.
    anchor_angle : float, optional
        Inclination at the anchor, rad; 0 brings the touchdown to the anchor.
    grounded_length : float, optional
        Unstretched length on the bed, m, above 0.
    sag : float, optional
        Largest vertical distance below the straight line between the ends, m, above 0.

    Raises
    ------
    InputError
        Unless exactly one condition is given, in range.
    NoAnswerError
        When no length gives it.

    Examples
    --------
    How much wire of 88 N/m is out, from a winch at 200 kN to an anchor 600 m off, in 60 m:

    >>> from catopt import Line, Segment, find_length
    >>> wire = Line([Segment(610.0, 88.0, EA=110e6)])
    >>> round(find_length(wire, height=60.0, span=600.0, fairlead_tension=200e3).value, 3)
    603.558
    """
    height, horizontal_force, fairlead_tension, *on_the_bed = _taken(
        "find_length",
        height=height,
        horizontal_force=horizontal_force,
        fairlead_tension=fairlead_tension,
        anchor_angle=anchor_angle,
        grounded_length=grounded_length,
        seabed_friction=seabed_friction,
        anchor_height=anchor_height,
        span=span,
        sag=sag,
    )
    anchor_angle, grounded_length, seabed_friction, anchor_height, span, sag = on_the_bed
    index = _index("segment", segment, len(line.segments))
    conditions = {"anchor_angle": anchor_angle, "grounded_length": grounded_length, "sag": sag}
    if span is not None:
        conditions |= {"fairlead_tension": fairlead_tension, "horizontal_force": horizontal_force}
        fairlead_tension = horizontal_force = None
    _one_of(**conditions)
    highest = max(height, anchor_height)
    if sag is not None and sag > highest:
        values = {"sag": Measure("height", sag), "most": Measure("height", highest)}
        raise NoAnswerError(Message("catenary.sag_below_bed", **values))

    def at(length: float) -> Solution:
        return solve(
            with_segment_length(line, index, length),
            height=height,
            horizontal_force=horizontal_force,
            span=span,
            fairlead_tension=fairlead_tension,
            seabed_friction=seabed_friction,
            anchor_height=anchor_height,
        )

    if anchor_angle is not None:
        lies = anchor_angle == anchor_height == 0.0
        condition = _angle_of(anchor_angle)._replace(holds_below=lies)
    elif grounded_length is not None:
        condition = _grounded_of(grounded_length)
    else:
        condition = _value_of(*next((k, v) for k, v in conditions.items() if v is not None))
    rise = abs(height - anchor_height)
    shortest = _shortest(line, index, math.hypot(rise, span or 0.0))
    start = max(line.segments[index].length, shortest * (1.0 + 1e-6))
    turns = horizontal_force is None or anchor_height > 0.0 or sag is not None or _floats(line)
    sought = Sought("length", condition, at, turns, number=index + 1)
    return find(sought, start, max(line.length, height, anchor_height), shortest)


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

    Raises
    ------
    InputError, NoEquilibriumError
        As for `solve`: the line is too short, say.

    Examples
    --------
    >>> import catopt
    >>> line = catopt.Line([catopt.Segment(100.0, 900.0)])
    >>> f"{catopt.find_touchdown_force(line, height=60.0).value:.0f} N"  # 450 (100**2 / 60 - 60)
    '48000 N'
    """
    height, seabed_friction = _taken(
        "find_touchdown_force", height=height, seabed_friction=seabed_friction
    )

    def at(force: float) -> Solution:
        return solve(line, height=height, horizontal_force=force, seabed_friction=seabed_friction)

    condition = _angle_of(0.0)._replace(text=Message("catenary.touchdown_at_anchor"))
    weight = math.fsum(
        [abs(part.submerged_weight) * part.length for part in line.segments]
        + [abs(load.submerged_weight) for load in line.point_loads]
    )
    return find(Sought("horizontal_force", condition, at, _floats(line)), weight, weight, 0.0)


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

    Examples
    --------
    >>> import catopt
    >>> hung = catopt.PointLoad(position=20.0, submerged_weight=1e4)
    >>> line = catopt.Line([catopt.Segment(100.0, 900.0)], [hung])
    >>> found = catopt.find_clump_weight(line, height=60.0, horizontal_force=1e5)
    >>> f"{found.value / 1e3:.1f} kN, {found.solution.anchor.angle:.3f} rad"
    '55.3 kN, 0.000 rad'
    """
    height, horizontal_force, span, fairlead_tension, *on_the_bed = _taken(
        "find_clump_weight",
        height=height,
        horizontal_force=horizontal_force,
        span=span,
        fairlead_tension=fairlead_tension,
        anchor_angle=anchor_angle,
        seabed_friction=seabed_friction,
        anchor_height=anchor_height,
    )
    anchor_angle, seabed_friction, anchor_height = on_the_bed
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

    def reading(solution: Solution) -> str:
        angle = math.degrees(solution.anchor.angle)
        height = solution.point_loads[index].z
        return Message("catenary.angle_over_bed", angle=angle, height=height)

    condition = _angle_of(anchor_angle)._replace(reading=reading)
    without = at(0.0)
    if condition.miss(without)[0] <= 0.0:
        angles = (without.anchor.angle, anchor_angle)
        angle, asked = map(math.degrees, angles)
        raise NoAnswerError(Message("catenary.none_needed", angle=angle, asked=asked))
    if horizontal_force is not None:
        _check_heaviest(without, line.point_loads[index].position, condition)
    size = max(abs(line.submerged_weight), 1e-3 * without.fairlead.tension)
    turns = horizontal_force is None or anchor_height > 0.0 or _floats(line)
    return find(Sought("clump_weight", condition, at, turns, number=index + 1), size, size, 0.0)


def _check_heaviest(without: Solution, position: float, condition: Condition) -> None:
    """Refuse where even a clump weight without bound leaves too much angle at the anchor.

    Under a known horizontal force a clump weight at `position` (m from the anchor) draws the line
    above straight down, and the anchor angle falls with its weight. What does not stretch keeps it
    off the bed where it is shorter than the fairlead is high: the part below is then a line of its
    own.
    """
    below, above = _parted(without.line, position)
    over_bed = without.fairlead_height - math.fsum(part.length for part in above)
    if any(not part.is_inextensible for part in above) or over_bed <= 0.0:
        return
    try:
        left = solve(
            below,
            height=over_bed,
            horizontal_force=without.horizontal_force,
            seabed_friction=without.seabed_friction,
            anchor_height=without.anchor_height,
        )
    except CatoptError:
        return  # the part below does not reach up there, or floats: the search itself will tell
    if condition.miss(left)[0] > 0.0:
        length = math.fsum(part.length for part in above)
        values = {"length": length, "over_bed": over_bed, "angle": math.degrees(left.anchor.angle)}
        said = Message("catenary.none_holds", condition=condition.text, **values)
        raise NoAnswerError(said)


def _parted(line: Line, position: float) -> tuple[Line, tuple[Segment, ...]]:
    """Part a line at a place: the line below it, and the segments above."""
    below: list[Segment] = []
    above: list[Segment] = []
    joint = 0.0
    for segment in line.segments:
        start, joint = joint, joint + segment.length
        for part, length in (
            (below, min(joint, position) - start),
            (above, joint - max(start, position)),
        ):
            if length > 0.0:
                part.append(replace(segment, length=length))
    loads = [load for load in line.point_loads if load.position < position]
    return Line(below, loads), tuple(above)


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

    Examples
    --------
    >>> import catopt
    >>> line = catopt.Line([catopt.Segment(100.0, 900.0, MBL=1e6)])
    >>> found = catopt.find_limit_force(line, height=60.0, safety_factor=2.0)
    >>> f"{found.value / 1e3:.1f} kN, {found.solution.fairlead.tension / 1e3:.1f} kN"
    '376.7 kN, 500.0 kN'
    """
    height, safety_factor, seabed_friction, anchor_height = _taken(
        "find_limit_force",
        height=height,
        safety_factor=safety_factor,
        seabed_friction=seabed_friction,
        anchor_height=anchor_height,
    )
    count = len(line.segments)
    chosen = range(count) if segment is None else [_index("segment", segment, count)]
    MBL = {k: line.segments[k].MBL for k in chosen}
    limits = {k: load / safety_factor for k, load in MBL.items() if load is not None}
    if not limits:
        which = Message("refused_motion.at_least_one_segment")
        if segment is not None:
            which = Message("refused_motion.this_segment", segment=segment)
        allowed = Message("refused_motion.needs_mbl", which=which)
        raise refused("MBL", Message("refused.none"), allowed, "find_limit_force")

    def at(force: float) -> Solution:
        return solve(
            line,
            height=height,
            horizontal_force=force,
            seabed_friction=seabed_friction,
            anchor_height=anchor_height,
        )

    def used(solution: Solution) -> float:
        return max(solution.segments[k].max_tension / limit for k, limit in limits.items())

    text = Message("catenary.any_at_MBL", factor=safety_factor)
    if segment is not None:
        text = Message("catenary.segment_at_MBL", number=chosen[0] + 1, factor=safety_factor)
    condition = Condition(
        text,
        lambda solution: (used(solution) - 1.0, 1.0),
        lambda solution: Message("catenary.times_that", used=used(solution)),
    )
    size = 0.5 * min(limits.values())
    turns = anchor_height > 0.0 or _floats(line)
    return find(Sought("horizontal_force", condition, at, turns), size, size, 0.0)


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
    loads = [
        replace(load, position=load.position + change) if load.position > joint else load
        for load in line.point_loads
    ]
    return Line(segments, loads)


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
    if find.quantity == "touchdown_force":
        height, friction = case.fairlead_height, case.site.seabed_friction
        return find_touchdown_force(case.line, height=height, seabed_friction=friction)
    if find.quantity == "limit_force":
        factor = case.checks.safety_factor
        which = None if find.segment is None else find.segment - 1
        return find_limit_force(case.line, safety_factor=factor, segment=which, **case.place)
    if find.quantity == "length":
        return find_length(
            case.line,
            horizontal_force=load.horizontal_force or find.horizontal_force,
            fairlead_tension=load.fairlead_tension or find.fairlead_tension,
            segment=-1 if find.segment is None else find.segment - 1,
            anchor_angle=find.anchor_angle,
            grounded_length=find.grounded_length,
            span=load.span,
            sag=find.sag,
            **case.place,
        )
    assert find.anchor_angle is not None
    return find_clump_weight(
        case.line,
        **vars(load),
        point_load=(find.point_load or 1) - 1,
        anchor_angle=find.anchor_angle,
        **case.place,
    )


def _floats(line: Line) -> bool:
    """Whether any of a line floats: of a heavy one what is missing only rises or falls."""
    weights = [part.submerged_weight for part in line.segments]
    return min(*weights, *(load.submerged_weight for load in line.point_loads), 0.0) < 0.0


def _angle_of(angle: float) -> Condition:
    """Ask for an inclination at the anchor.

    The vertical force above the one wanted is missing; below 0, what lies on the bed counts.
    """

    def miss(solution: Solution) -> tuple[float, float]:
        V = solution.anchor.vertical_force
        if solution.regime in ("grounded", "on-bed", "slack"):
            V = solution.fairlead.vertical_force - solution.line.submerged_weight
        elif solution.stretches[0].on_bed:
            # Less the weight on the bed between the anchor and where the line first leaves it.
            lying = takewhile(lambda stretch: stretch.on_bed, solution.stretches)
            V = -math.fsum(each.submerged_weight * each.length for each in lying)
        # Friction may have taken of the force at the fairlead.
        wanted = solution.anchor.horizontal_force * math.tan(angle)
        # Where friction leaves nothing of the force, the line leans to no side: any V is all of it.
        H = solution.anchor.horizontal_force
        return V - wanted, solution.fairlead.tension if H > 0.0 else abs(V)

    said = Message("catenary.angle_given", angle=math.degrees(angle))
    return Condition(said, miss, lambda solution: f"{math.degrees(solution.anchor.angle):.4g} deg")


def _grounded_of(length: float) -> Condition:
    """Ask for a grounded length; of a lifted line, what would lift it further is missing."""

    def miss(solution: Solution) -> tuple[float, float]:
        total = solution.line.length
        if solution.grounded_length > 0.0:
            return length - solution.grounded_length, total
        weight = abs(solution.line.submerged_weight) / total
        return length + abs(solution.anchor.vertical_force) / max(weight, 1e-300), total

    return Condition(
        Message("catenary.grounded_given", length=length),
        miss,
        lambda solution: f"{solution.grounded_length:.6g} m",
    )


def _value_of(key: str, wanted: float) -> Condition:
    """Ask for a sag, or for a tension or a horizontal force at the fairlead."""

    def own(solution: Solution) -> float:
        if key == "sag":
            return solution.sag
        if key == "fairlead_tension":
            return solution.fairlead.tension
        return solution.horizontal_force

    quantity = {"sag": "height", "fairlead_tension": "tension"}.get(key, key)
    return Condition(
        Message(f"catenary.{key}_given", value=Measure(quantity, wanted)),
        lambda solution: (own(solution) - wanted, wanted),
        lambda solution: f"{Measure(quantity, own(solution))}",
    )


def _shortest(line: Line, segment: int, rise: float) -> float:
    """Length of a segment below which the line surely does not reach up to its fairlead, m."""
    others = line.length - line.segments[segment].length
    on_it = [load.position for load in line.point_loads]
    before = math.fsum(part.length for part in line.segments[:segment])
    end = before + line.segments[segment].length
    held = max((p - before for p in on_it if before < p <= end), default=0.0)
    is_stiff = all(part.is_inextensible for part in line.segments)
    return max(rise - others, held, 0.0) if is_stiff else held


def _index(key: str, index: int, count: int) -> int:
    if -count <= index < count:
        return index % count
    which = "from_index" if count else "line_has_none"
    problem = Problem(key, str(index), Message(f"refused_motion.{which}", last=count - 1))
    raise InputError([problem], "find")


def _one_of(**given: float | None) -> None:
    chosen = {key: value for key, value in given.items() if value is not None}
    problems = []
    if len(chosen) != 1:
        names = " and ".join(given)
        which = Message("refused_motion.of_them", count=len(chosen))
        problems.append(Problem(names, which, Message("refused_motion.exactly_one")))
    for key, value in chosen.items():
        is_angle = key == "anchor_angle"
        if not (0.0 <= value < math.pi / 2 if is_angle else 0.0 < value < math.inf):
            of_length = "force_above_zero" if _UNITS[key] == "N" else "length_above_zero"
            name = "from_zero_to_right_angle" if is_angle else of_length
            allowed = Message(f"refused_motion.{name}")
            problems.append(Problem(key, repr(plain(value)), allowed))
    if problems:
        raise InputError(problems, "find")
