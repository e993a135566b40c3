"""A line with ropes whose strain follows a table, as a line of parts that stretch in proportion.

Between two rows of its table a rope has strain e + c T, which is a rope of (1 + e) times the length
with a compliance c / (1 + e): the closed form holds for it. So a rope is cut into parts, each with
the e and c of its own tensions, which are found by solving again with those of the last answer;
this is Newton's method. Only a part whose tension passes a row is not exact: with `PARTS` parts
what is left of a rope's reach beside the quadrature over its length is below 1e-8 of it.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from itertools import accumulate
from typing import Final

from catopt.catenary.layout import Stretch, tension_at
from catopt.catenary.solution import Solution, plausibility, segment_states
from catopt.errors import NotConvergedError, TableEndsError
from catopt.model import Line, PointLoad, Segment
from catopt.model.line import StrainTable
from catopt.words import Measure, Message

PARTS: Final = 32
"""Parts that a rope with a table is cut into."""
ROUNDS: Final = 60
_SAME: Final = 1e-13
"""Change of a part's strain at which it is found."""


def has_table(line: Line) -> bool:
    """Whether a rope of the line stretches by a table."""
    return any(isinstance(segment.EA, StrainTable) for segment in line.segments)


def solve_by_table(line: Line, solve: Callable[[Line], Solution]) -> tuple[Solution, Line]:
    """Solve a line with such ropes by a solver of lines that stretch in proportion.

    Returns the line of parts that hangs and gives way as it does, too. NotConvergedError where the
    strains of the parts are not found, TableEndsError where a table ends below its tension.
    """
    owner = [k for k, segment in enumerate(line.segments) for _ in range(_count(segment))]
    laws = [(0.0, 1.0 / _stiffness(line.segments[k])) for k in owner]
    for _ in range(ROUNDS):
        parts = _in_parts(line, owner, laws)
        found = solve(parts)
        newer = list(_laws(line, owner, laws, found))
        moved = max(abs(e - old) for (e, _), (old, _) in zip(newer, laws, strict=True))
        if moved <= _SAME:
            return _as_one(line, owner, laws, found), parts
        laws = newer
    raise NotConvergedError(Message("catenary.not_converged"))


def by_first_rows(line: Line) -> Line:
    """Return the line whose ropes keep to the first rows of their tables."""
    return Line(
        (replace(segment, EA=_stiffness(segment)) for segment in line.segments), line.point_loads
    )


def grown(segment: Segment, length: float, e: float, c: float) -> Segment:
    """Make the part of a segment, of a length, m, whose strain e + c T is in proportion to T."""
    EA = (1.0 + e) / c if c else math.inf
    weight = segment.submerged_weight / (1.0 + e)
    return replace(segment, length=(1.0 + e) * length, submerged_weight=weight, EA=EA)


def _count(segment: Segment) -> int:
    return PARTS if isinstance(segment.EA, StrainTable) else 1


def _stiffness(segment: Segment) -> float:
    """Axial stiffness of a segment to begin with, N."""
    return 1.0 / segment.EA.slope(0) if isinstance(segment.EA, StrainTable) else segment.EA


def _in_parts(line: Line, owner: Sequence[int], laws: Sequence[tuple[float, float]]) -> Line:
    """Cut a line into its parts with their natural lengths, each by its strain e + c T."""
    segments, places, ends = [], [0.0], [0.0]
    for k, (e, c) in zip(owner, laws, strict=True):
        own = line.segments[k]
        length = own.length / _count(own)
        segments.append(grown(own, length, e, c))
        places.append(places[-1] + length)
        ends.append(ends[-1] + segments[-1].length)
    loads = [replace(each, position=_moved(each, places, ends)) for each in line.point_loads]
    return Line(segments, loads)


def _moved(load: PointLoad, places: Sequence[float], ends: Sequence[float]) -> float:
    """Where a point load is along the parts with their natural lengths."""
    k = max(1, next((k for k, s in enumerate(places) if s >= load.position), len(places) - 1))
    part = (load.position - places[k - 1]) / (places[k] - places[k - 1])
    return ends[k] if part >= 1.0 else ends[k - 1] + part * (ends[k] - ends[k - 1])


def _part_of(stretches: Sequence[Stretch], ends: Sequence[float]) -> Iterator[tuple[int, Stretch]]:
    """Yield the stretches that have a length with the part that each is of."""
    k = 0
    for each in stretches:
        if each.length > 0.0:
            while each.start + 0.5 * each.length > ends[k]:
                k += 1
            yield k, each


def _laws(
    line: Line, owner: Sequence[int], laws: Sequence[tuple[float, float]], found: Solution
) -> Iterator[tuple[float, float]]:
    """Yield e and c of every part by the tensions that it has."""
    ends = list(accumulate(segment.length for segment in found.line.segments))
    tensions: list[list[float]] = [[] for _ in owner]
    for k, each in _part_of(found.stretches, ends):
        tensions[k] += [tension_at(each, 0.0), tension_at(each, each.length)]
    for k, law, of in zip(owner, laws, tensions, strict=True):
        table = line.segments[k].EA
        yield table.law(min(of), max(of)) if isinstance(table, StrainTable) else law


def _as_one(
    line: Line, owner: Sequence[int], laws: Sequence[tuple[float, float]], found: Solution
) -> Solution:
    """Turn an answer for parts into that of the line that they are of."""
    largest = [0.0] * len(line.segments)
    for k, state in zip(owner, found.segments, strict=True):
        largest[k] = max(largest[k], state.max_tension)
    _check_ends(line, largest)
    ends = list(accumulate(segment.length for segment in found.line.segments))
    stretches, start = [], 0.0
    for k, each in _part_of(found.stretches, ends):
        natural = 1.0 + laws[k][0]
        stretches.append(
            replace(
                each,
                start=start,
                length=each.length / natural,
                submerged_weight=each.submerged_weight * natural,
                compliance=each.compliance * natural,
                friction=each.friction * natural,
                natural=natural,
            )
        )
        start += stretches[-1].length
    grounded = math.fsum(each.length for each in stretches if each.on_bed)
    loads = zip(found.point_loads, line.point_loads, strict=True)
    others = found.warnings[len(tuple(plausibility(found))) :]
    whole = replace(
        found,
        line=line,
        grounded_length=grounded,
        suspended_length=line.length - grounded,
        segments=segment_states(line, largest),
        point_loads=tuple(replace(state, position=load.position) for state, load in loads),
        stretches=tuple(stretches),
        warnings=(),
    )
    return whole.with_warnings((*plausibility(whole), *others))


def _check_ends(line: Line, largest: Sequence[float]) -> None:
    """Refuse tensions, N, of a line's segments beyond the ends of their tables."""
    for k, (segment, tension) in enumerate(zip(line.segments, largest, strict=True), start=1):
        if isinstance(segment.EA, StrainTable) and tension > (last := segment.EA.tension[-1]):
            values = {"tension": Measure("tension", tension), "last": Measure("tension", last)}
            reported = Message("catenary.table_ends", number=k, **values)
            raise TableEndsError(reported, "force", tension - last)
