"""The solution that belongs to a state of the kernel: the line laid out from its anchor."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Literal

from catopt.catenary.layout import Stretch, end_of, lay_out, max_tension, stretched_length
from catopt.catenary.pieces import LineProblem, joints_of
from catopt.catenary.root_search import force_uncertainty
from catopt.catenary.solution import (
    EndState,
    PointLoadState,
    Residual,
    SegmentState,
    Solution,
)
from catopt.catenary.state import BELOW_ANCHOR, REGIMES, SUSPENDED, State
from catopt.catenary.warnings import above_water, plausibility
from catopt.model import Case, Line, PointLoad

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
    stretches = lay_out(state, problem)
    x, z = end_of(stretches[-1], stretches[-1].length)
    solution = Solution(
        line=line,
        method=method,
        regime=REGIMES[state.regime],
        fairlead_height=problem.fairlead_height,
        anchor_height=problem.anchor_height,
        seabed_friction=problem.friction,
        span=state.span,
        fairlead=_end(state.H, state.V),
        anchor=_end(state.H_anchor, state.V_anchor),
        grounded_length=state.grounded,
        suspended_length=line.length - state.grounded,
        stretched_length=math.fsum(stretched_length(stretch) for stretch in stretches),
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
        warnings=(*solution.warnings, *above_water(solution, case.site.water_depth)),
    )


def _end(H: float, V: float) -> EndState:
    return EndState(math.hypot(H, V), H, V, math.atan2(V, H))


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
    return tuple(
        SegmentState(segment.name, segment.length, tension, segment.MBL)
        for segment, tension in zip(line.segments, largest, strict=True)
    )


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
            here = [each.submerged_weight for each in line.point_loads if _at(each, load)]
            # What the line does not lift on its two sides, the bed carries.
            V_below = below.vertical_force + below.submerged_weight * below.length
            lifted = 0.0 if upper is None or upper.on_bed else upper.vertical_force
            carried = math.fsum(here) - lifted + (0.0 if below.on_bed else V_below)
            carried *= load.submerged_weight / math.fsum(max(weight, 0.0) for weight in here)
        states.append(PointLoadState(load.name, load.position, x, z, carried))
    return tuple(states)


def _at(one: PointLoad, other: PointLoad) -> bool:
    return one.position == other.position
