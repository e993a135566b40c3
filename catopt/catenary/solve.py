"""Solve one line in closed form."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Literal

from catopt.catenary.by_table import has_table, solve_by_table
from catopt.catenary.equilibrium import given_force
from catopt.catenary.layout import Stretch, end_of, lay_out, max_tension, stretched_length
from catopt.catenary.many import RESIDUAL_LIMIT
from catopt.catenary.pieces import (
    GREATEST_FORCE,
    LEAST_FORCE,
    LineProblem,
    cut,
    is_plain,
    joints_of,
)
from catopt.catenary.root_search import BY_FORCE, BY_SPAN, BY_TENSION, force_uncertainty
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
from catopt.errors import CatoptError, NoEquilibriumError, NotConvergedError
from catopt.model import Case, Line, Load
from catopt.model.kinds import Findings
from catopt.words import Message

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

    The state is a converged one with the span wanted; `known` is what was given of the load, as for
    `force_uncertainty`.
    """
    stretches, (x, z) = lay_out(state, problem)
    ends = [*[stretch.x for stretch in stretches[1:]], x]
    solution = Solution(
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
        stretched_length=math.fsum(map(stretched_length, stretches, ends)),
        segments=_segments(line, segment_of, stretches),
        point_loads=_point_loads(line, stretches, state.regime not in (SUSPENDED, BELOW_ANCHOR)),
        stretches=stretches,
        residual=Residual(
            height=z - problem.fairlead_height,
            span=x - state.span,
            force_uncertainty=force_uncertainty(state, problem, known),
        ),
    )
    return solution.with_warnings(tuple(plausibility(solution)))


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
    _check(line, load, found)
    place = (anchor_height, height, seabed_friction)
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


def _check(line: Line, load: Load, found: Findings) -> None:
    for value in (load.horizontal_force, load.fairlead_tension):
        if value is not None and not LEAST_FORCE <= value <= GREATEST_FORCE:
            bounds = {"least_force": LEAST_FORCE, "greatest_force": GREATEST_FORCE}
            found.add("load", f"{value:g} N", Message("refused_motion.from_n", **bounds))
    weightless = all(segment.submerged_weight == 0.0 for segment in line.segments)
    if weightless and not line.point_loads and load.horizontal_force is None:
        allowed = Message("refused_motion.line_without_weight_needs_load")
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
