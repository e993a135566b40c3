"""Solve one line in closed form, also with ropes whose strain follows a table.

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
from itertools import accumulate, pairwise
from typing import Any, Final, Literal

from catopt.catenary.equilibrium import (
    BY_FORCE,
    BY_SPAN,
    BY_TENSION,
    force_uncertainty,
    given_force,
)
from catopt.catenary.layout import (
    Stretch,
    end_of,
    lay_out,
    listed_runs,
    max_tension,
    runs_misfit,
    stretched_length,
    tension_at,
)
from catopt.catenary.many import RESIDUAL_LIMIT
from catopt.catenary.pieces import (
    GREATEST_FORCE,
    LEAST_FORCE,
    LineProblem,
    cut,
    is_plain,
    joints_of,
)
from catopt.catenary.solution import (
    PointLoadState,
    Residual,
    SegmentState,
    Solution,
    above_water,
    end_state,
    plausibility,
    segment_states,
    weighs_as_in_water,
)
from catopt.catenary.span_or_tension import given_span, given_tension, least_tension, other_forces
from catopt.catenary.state import (
    BELOW_ANCHOR,
    CONVERGED,
    LOOSE,
    NOT_CONVERGED,
    REGIMES,
    SUSPENDED,
    TOO_HEAVY,
    TOO_SHORT,
    TURNED,
    State,
)
from catopt.errors import CatoptError, NoEquilibriumError, NotConvergedError, TableEndsError
from catopt.model import Case, Line, Load, PointLoad, Segment
from catopt.model.kinds import Findings
from catopt.model.line import StrainTable
from catopt.model.plausible_ranges import NAMES
from catopt.words import Measure, Message

PARTS: Final = 32
"""Parts that a rope with a table is cut into, at least; each ends where a point load hangs."""
_AT_END: Final = 1e-9
"""Of a part: nearer to its end a point load hangs there."""
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
    owner, lengths = _cut(line)
    laws = [(0.0, 1.0 / _stiffness(line.segments[k])) for k in owner]
    for _ in range(ROUNDS):
        parts = _in_parts(line, owner, lengths, laws)
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
    return replace(
        segment,
        length=(1.0 + e) * length,
        submerged_weight=segment.submerged_weight / (1.0 + e),
        EA=EA,
        accept=NAMES,  # the segment itself was looked at
    )


def _cut(line: Line) -> tuple[list[int], list[float]]:
    """Cut a line into parts: of each its segment and its length, m."""
    owner, lengths, start = [], [], 0.0
    for k, segment in enumerate(line.segments):
        end, cuts = start + segment.length, [start]
        if isinstance(segment.EA, StrainTable):
            near = _AT_END * segment.length
            for place in sorted({load.position for load in line.point_loads}):
                if cuts[-1] + near < place < end - near:
                    cuts.append(place)
        for low, high in pairwise([*cuts, end]):
            whole = high - low if len(cuts) > 1 else segment.length
            has_table = isinstance(segment.EA, StrainTable)
            count = math.ceil(PARTS * whole / segment.length) if has_table else 1
            owner += [k] * count
            lengths += [whole / count] * count
        start = end
    return owner, lengths


def _stiffness(segment: Segment) -> float:
    """Axial stiffness of a segment to begin with, N."""
    return 1.0 / segment.EA.slope(0) if isinstance(segment.EA, StrainTable) else segment.EA


def _in_parts(
    line: Line,
    owner: Sequence[int],
    lengths: Sequence[float],
    laws: Sequence[tuple[float, float]],
) -> Line:
    """Cut a line into its parts with their natural lengths, each by its strain e + c T."""
    segments, places, ends = [], [0.0], [0.0]
    for k, length, (e, c) in zip(owner, lengths, laws, strict=True):
        segments.append(grown(line.segments[k], length, e, c))
        places.append(places[-1] + length)
        ends.append(ends[-1] + segments[-1].length)
    loads = [replace(each, position=_moved(each, places, ends)) for each in line.point_loads]
    return Line(segments, loads)


def _moved(load: PointLoad, places: Sequence[float], ends: Sequence[float]) -> float:
    """Where a point load is along the parts with their natural lengths."""
    k = max(1, next((k for k, s in enumerate(places) if s >= load.position), len(places) - 1))
    part = (load.position - places[k - 1]) / (places[k] - places[k - 1])
    if min(part, 1.0 - part) < _AT_END:
        return ends[k if part > 0.5 else k - 1]
    return ends[k - 1] + part * (ends[k] - ends[k - 1])


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


AT_BED = 1e-9
"""Height at which a point load counts as on the bed, as a part of the line's length."""


def solution_of(
    state: State,
    line: Line,
    problem: LineProblem,
    segment_of: tuple[int, ...],
    *,
    method: Literal["closed-form", "pso"],
    known: int,
) -> Solution:
    """Lay out a line from its anchor and say by how much it misses its fairlead.

    The shape, and what follows from it, is made when it is read.

    The state is a converged one with the span wanted; `known` is what was given of the load, as for
    `force_uncertainty`.
    """
    runs, count = listed_runs(state, problem)
    height, along = runs_misfit(state, problem, runs, count, state.span)
    later: dict[str, Callable[[Solution], Any]] = {
        "stretches": lambda _: lay_out(state, problem, runs, count),
        "stretched_length": lambda solution: _stretched_length(solution.stretches),
        "segments": lambda solution: _segments(line, segment_of, solution.stretches),
        "point_loads": lambda solution: _point_loads(line, solution.stretches, touches),
        "warnings": lambda solution: tuple(plausibility(solution)),
    }
    touches = state.regime not in (SUSPENDED, BELOW_ANCHOR)
    return Solution.with_later(
        later,
        line=line,
        method=method,
        regime=REGIMES[state.regime],
        fairlead_height=problem.fairlead_height,
        anchor_height=problem.anchor_height,
        seabed_friction=problem.friction,
        span=state.span,
        fairlead=end_state(state.H, state.V),
        anchor=end_state(state.H_anchor, state.V_anchor),
        grounded_length=state.grounded,
        suspended_length=line.length - state.grounded,
        residual=Residual(height, along, force_uncertainty(state, problem, known)),
    )


def _stretched_length(stretches: Sequence[Stretch]) -> float:
    """Length of a laid-out line under its tension, m."""
    last = stretches[-1]
    ends = [*(stretch.x for stretch in stretches[1:]), end_of(last, last.length)[0]]
    return math.fsum(map(stretched_length, stretches, ends))


def under_case(solution: Solution, case: Case) -> Solution:
    """Return the same answer under a case's title, safety factor and water depth."""
    return replace(
        solution,
        title=case.title,
        safety_factor=case.checks.safety_factor,
        warnings=(
            *solution.warnings,
            *above_water(solution, case.site.water_depth),
            *weighs_as_in_water(solution.fairlead_height, case.site.water_depth),
        ),
    )


def _segments(
    line: Line, segment_of: tuple[int, ...], stretches: tuple[Stretch, ...]
) -> tuple[SegmentState, ...]:
    largest = [0.0] * len(line.segments)
    for stretch in stretches:
        # A point load on the upper joint of a segment leaves a stretch of no length above it,
        # which bears the tension of the next segment.
        if stretch.length > 0.0:
            index = segment_of[stretch.piece]
            largest[index] = max(largest[index], max_tension(stretch))
    return segment_states(line, largest)


def _point_loads(
    line: Line, stretches: tuple[Stretch, ...], touches: bool
) -> tuple[PointLoadState, ...]:
    """State of each point load; what the bed carries in one place is shared by weight."""
    states = []
    hung = [stretch for stretch in stretches if stretch.length > 0.0]
    for load, joint in zip(line.point_loads, joints_of(line), strict=True):
        below = [stretch for stretch in hung if stretch.piece < joint][-1]
        upper = next((stretch for stretch in hung if stretch.piece >= joint), None)
        x, z = end_of(below, below.length) if upper is None else (upper.x, upper.z)
        carried = 0.0
        if abs(z) <= AT_BED * line.length and touches and load.submerged_weight > 0.0:
            loads = (each for each in line.point_loads if each.position == load.position)
            here = [each.submerged_weight for each in loads]
            # What the line does not lift on its two sides, the bed carries.
            V_below = below.vertical_force + below.submerged_weight * below.length
            lifted = 0.0 if upper is None or upper.on_bed else upper.vertical_force
            carried = math.fsum(here) - lifted + (0.0 if below.on_bed else V_below)
            carried *= load.submerged_weight / math.fsum(max(weight, 0.0) for weight in here)
        states.append(PointLoadState(load.name, load.position, x, z, carried))
    return tuple(states)


def solve(
    line: Line,
    *,
    height: float | str,
    horizontal_force: float | str | None = None,
    span: float | str | None = None,
    fairlead_tension: float | str | None = None,
    seabed_friction: float | str = 0.0,
    anchor_height: float | str = 0.0,
) -> Solution:
    """Solve one line in closed form.

    Exactly one of `horizontal_force`, `span` and `fairlead_tension` is given. Numbers are SI; text
    with a unit, ``"0.343 tf"``, is read.

    Parameters
    ----------
    line : Line
        Segments from the anchor to the fairlead, with point loads.
    height : float
        Height of the fairlead above the seabed, m.
    horizontal_force : float, optional
        N.
    span : float, optional
        Horizontal distance from the anchor to the fairlead, m.
    fairlead_tension : float, optional
        Effective tension at the fairlead, N.
    seabed_friction : float
        Coulomb coefficient.
    anchor_height : float
        Height of the anchor above the seabed, m. Above 0 the line may hang below its anchor.

    Returns
    -------
    Solution
        With its residuals.

    Raises
    ------
    InputError
        When arguments are missing, contradictory or out of range; all of them at once.
    NoEquilibriumError
        When no line hangs so; it says how much length or force is missing.
    NotConvergedError
        When the solver stopped short of its tolerance.

    Examples
    --------
    >>> from catopt import Line, Segment, solve
    >>> buoy = solve(Line([Segment(20.0, 93.163)]), height=9.5, horizontal_force=3363.68)
    >>> round(buoy.span, 2)
    17.43
    """
    load = Load(horizontal_force, span, fairlead_tension)
    found = Findings("solve")
    height = found.taken("height", height, "m", at_least=0.0)
    anchor_height = found.taken("anchor_height", anchor_height, "m", at_least=0.0)
    seabed_friction = found.taken("seabed_friction", seabed_friction, "", at_least=0.0)
    place = (anchor_height, height, seabed_friction)
    _check(line, load, height - anchor_height, found)
    if has_table(line):
        return solve_by_table(line, lambda of: _closed(of, load, place))[0]
    return _closed(line, load, place)


def _closed(line: Line, load: Load, place: tuple[float, float, float]) -> Solution:
    """Solve a line whose segments have an axial stiffness each."""
    pieces, segment_of = cut(line)
    problem = LineProblem(pieces, *place)
    if load.horizontal_force is not None:
        known, state = BY_FORCE, given_force(load.horizontal_force, problem)
    elif load.span is not None:
        known, state = BY_SPAN, given_span(load.span, problem, math.nan, math.nan)
    else:
        assert load.fairlead_tension is not None
        known, state = BY_TENSION, given_tension(load.fairlead_tension, problem)
    if state.status != CONVERGED:
        raise refusal(state.status, line, load, problem)
    if load.span is not None:
        # The solver's own span misses the one asked for by rounding: the residual keeps that.
        state = state._replace(span=load.span)
    solution = solution_of(state, line, problem, segment_of, method="closed-form", known=known)
    worst = max(abs(solution.residual.height), abs(solution.residual.span))
    if not worst <= RESIDUAL_LIMIT * max(line.length, solution.span):
        raise NotConvergedError(Message("catenary.misses_fairlead", missing=worst))
    return solution.with_warnings(_other_answers(solution, state, load, problem))


def _other_answers(
    solution: Solution, state: State, load: Load, problem: LineProblem
) -> tuple[str, ...]:
    """Warn of the other equilibria that the line has under the same load."""
    if state.touchdown in (TURNED, LOOSE):
        # Held at its span it stays; under a held force it would slide to another one.
        elsewhere = given_force(state.H, problem).span
        return (Message("catenary.slides", friction=solution.seabed_friction, span=elsewhere),)
    if load.fairlead_tension is None or is_plain(problem):
        return ()
    forces = other_forces(load.fairlead_tension, problem, state)
    others = ", ".join(f"{force:.6g} N" for force in forces)
    said = Message("catenary.other_force", others=others, largest=solution.horizontal_force)
    return (said,) if forces else ()


def _check(line: Line, load: Load, rise: float, found: Findings) -> None:
    for value in (load.horizontal_force, load.fairlead_tension):
        if value is not None and not LEAST_FORCE <= value <= GREATEST_FORCE:
            bounds = {"least_force": LEAST_FORCE, "greatest_force": GREATEST_FORCE}
            found.add("load", f"{value:g} N", Message("refused_motion.from_n", **bounds))
    weights = [*(each.submerged_weight for each in line.segments)]
    weights += [each.submerged_weight for each in line.point_loads]
    if not any(weights) and load.span is not None:
        chord = math.hypot(load.span, rise)
        if chord <= line.length:  # else its stretch says the force
            allowed = Message(
                "refused_motion.slack_without_weight", length=line.length, chord=chord
            )
            found.add("segments", Message("refused_motion.weightless"), allowed)
    found.raise_if_any()


def refusal(status: int, line: Line, load: Load, problem: LineProblem) -> CatoptError:
    """Say what stops a line, and by how much."""
    if status == TOO_SHORT:
        rise = problem.fairlead_height - problem.anchor_height
        distance = math.hypot(load.span or 0.0, rise)
        missing = distance - line.length
        way = Message("catenary.way_up" if load.span is None else "catenary.way_across")
        key = "catenary.too_short" if missing > 0.0 else "catenary.just_as_long"
        reported = Message(key, length=line.length, way=way, distance=distance, missing=missing)
        return NoEquilibriumError(reported, "length", missing)
    if status == TOO_HEAVY:
        tension = load.fairlead_tension
        assert tension is not None
        least = least_tension(problem, tension)
        missing = least - tension
        rise = problem.fairlead_height - problem.anchor_height
        values = {"tension": tension, "missing": missing, "least": least}
        reported = Message("catenary.too_heavy", **values)
        if rise > line.length:  # no part of it is spare: the tension is that of its stretch
            reported = Message("catenary.too_taut", length=line.length, rise=rise, **values)
        return NoEquilibriumError(reported, "force", missing)
    assert status == NOT_CONVERGED
    return NotConvergedError(Message("catenary.not_converged"))
