"""The loop over many designs: each proved needless, or built, solved and checked."""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

from catopt.catenary.equilibrium import given_force
from catopt.catenary.layout import LineIntervals, runs_of
from catopt.catenary.pieces import LineProblem, Pieces, split
from catopt.catenary.state import CONVERGED, NOT_CONVERGED, TOO_SHORT, State
from catopt.checks.criteria import Limits
from catopt.checks.kinds import (
    ROUNDING,
    grounded_exceedance,
    holding_exceedance,
    least_tension_exceedance,
    ratio_exceedance,
    uplift_angle_exceedance,
    uplift_force_exceedance,
)
from catopt.compiled import inlined
from catopt.design.space import AT_END
from catopt.design.tables import MooringTables, Room, Tables
from catopt.model.anchor import sinker_needed

BOUNDS: Final = ("reach", "strength", "least_offset", "offset_so_far")
"""By what a design is excluded."""
NONE: Final = -1
REACH: Final = 0
STRENGTH: Final = 1
LEAST_OFFSET: Final = 2
OFFSET_SO_FAR: Final = 3

MARGIN: Final = 1e-9
"""Part by which a bound is taken less strictly than proved: a thousand times its rounding."""


def least_forces(
    tables: MooringTables, line: Tables, room: Room, segments: int, layout: int, radius: float
) -> tuple[float, float]:
    """Horizontal force that the hardest loaded line bears at least, N: all there, and one out.

    Infinite where the lines, stretched as far as their checks allow, do not reach their anchors or
    do not pull against the force.
    """
    whole = damaged = 0.0
    for state in range(tables.first[layout], tables.first[layout + 1]):
        missing = tables.missing[state]
        damage = 1 if missing >= 0 else 0
        gap, height = tables.gap[layout, missing + 1], tables.height[state]
        turn = _largest_turn(tables, line, room, segments, radius, gap, height, damage)
        force = math.inf if turn < 0.0 else _least_force(tables, layout, state, turn)
        if damage == 1:
            damaged = max(damaged, force)
        else:
            whole = max(whole, force)
    return whole, damaged


@inlined
def _largest_turn(
    tables: MooringTables,
    line: Tables,
    room: Room,
    segments: int,
    radius: float,
    gap: float,
    height: float,
    damage: int,
) -> float:
    """Largest angle between a line and its azimuth, rad, wherever the body may rest; -1 nowhere."""
    stretched = 0.0
    for s in range(segments):
        strain = 0.0
        if room.compliance[s] > 0.0:
            strain = line.allowed[damage, room.place[s], room.option[s]] * room.compliance[s]
        stretched += room.length[s] * (1.0 + strain)
    if math.isinf(stretched):
        return math.pi
    stretched *= 1.0 + MARGIN
    rise = abs(height - line.anchor_height)
    if stretched <= rise:
        return -1.0
    reach = math.sqrt(stretched * stretched - rise * rise) * (1.0 + MARGIN)
    arm = tables.fairlead_radius
    far = radius if tables.turns else radius - arm
    if tables.turns:
        reach += arm
    square = far * far * (gap * gap - 1.0) + reach * reach
    if square < 0.0:
        return -1.0
    away = math.sqrt(square) - far * gap
    if away < 0.0:
        return -1.0
    if tables.turns:
        away += arm
    return math.asin(away / far) if away < far else math.pi


@inlined
def _least_force(tables: MooringTables, layout: int, state: int, turn: float) -> float:
    """Force over the largest sum of cosines with which the lines can pull against it, N."""
    against = 0.0
    for k in range(tables.lines[layout]):
        if k != tables.missing[state]:
            apart = tables.azimuth[layout, k] - tables.direction[state] - math.pi
            apart -= 2.0 * math.pi * math.floor(apart / (2.0 * math.pi) + 0.5)
            nearest = max(abs(apart) - turn, 0.0)
            against += max(math.cos(min(nearest, math.pi)), 0.0)
    # A cosine of 1e-16 is one of a right angle.
    return tables.force[state] / against if against > MARGIN else math.inf


@inlined
def is_too_weak(forces: Any, line: Tables, room: Room, segments: int) -> bool:
    """Whether the segment at the fairlead breaks its check under the least force that it bears.

    `forces` has that of each load case, N.
    """
    top = segments - 1
    for c in range(len(line.force)):
        allowed = line.allowed[c, room.place[top], room.option[top]]
        if ratio_exceedance(forces[c], allowed) > ROUNDING:
            return True
    return False


@inlined
def least_offset(
    forces: tuple[float, float], tables: MooringTables, problem: LineProblem, longest: float
) -> float:
    """Offset below which no line reaches the least force that one of them bears, m.

    `longest` is the largest span at the zero-load position.
    """
    force = max(forces[0], forces[1]) * (1.0 - MARGIN)
    if not (tables.is_monotone and 0.0 < force < math.inf):
        return 0.0
    state = given_force(force, problem)
    if state.status != CONVERGED:
        return 0.0
    least = state.span - longest - MARGIN * state.span
    if tables.turns:
        least -= 2.0 * tables.fairlead_radius
    return max(least, 0.0)


@inlined
def is_beaten(least: Any, best: Any) -> bool:
    """Whether a known design is as small as the least values of another, and smaller in one."""
    for row in range(len(best)):
        is_smaller = False
        is_beaten_here = True
        for column in range(len(least)):
            if best[row, column] > least[column]:
                is_beaten_here = False
                break
            if best[row, column] < least[column]:
                is_smaller = True
        if is_beaten_here and is_smaller:
            return True
    return False


MASS: Final = 0
OFFSET: Final = 1
EXCURSION: Final = 2
COST: Final = 3
LENGTH: Final = 4
ANCHOR_LOAD: Final = 5
"""Columns of the objectives."""

UPLIFT_ANGLE: Final = Limits._fields.index("uplift_angle")
UPLIFT_FORCE: Final = Limits._fields.index("uplift_force")
GROUNDED: Final = Limits._fields.index("grounded_length")
SPAN: Final = Limits._fields.index("span")
RESERVE: Final = Limits._fields.index("reserve_buoyancy")
SLIDING: Final = Limits._fields.index("sliding_factor")
HOLDING: Final = Limits._fields.index("holding_factor")
LEAST_TENSION: Final = Limits._fields.index("least_tension")
"""Columns of the limits."""

NO_EQUILIBRIUM: Final = 1e3
"""Excess of a line that cannot hang as asked, beyond that of any line that merely breaks."""
NO_DESIGN: Final = 2e3
"""Excess of a design whose clump weight hangs beyond the line; what it is beyond, by length, is
added, so that a search finds back."""


def assess(
    genes: Any,
    tables: Tables,
    room: Room,
    stops_early: bool,
    first: int,
    end: int,
    objectives: Any,
    exceedance: Any,
    sinker: Any,
    unsolved: Any,
) -> None:
    """Build, solve and check designs number `first` to `end` (not included) of shape (n, genes).

    With `stops_early` a design that has failed one check is left: its objectives are nan then, and
    its exceedance is above ROUNDING but not the largest. Written to: `objectives`, shape (n, 6):
    mass, offset, excursion, cost, length and load of the anchor, nan where there is no equilibrium;
    `exceedance`, shape (n,): the largest of all checks, -1 where there is none; `sinker`, shape
    (n,): the lightest that holds, or the heaviest, -1 where there is none; `unsolved`, shape (1,),
    raised by the number of lines that did not converge.
    """
    for i in range(first, end):
        objectives[i, :] = math.nan
        sinker[i] = -1
        segments = take_segments(genes[i], tables, room)
        weights, beyond = take_weights(genes[i], tables, room, segments)
        if beyond > 0.0:
            exceedance[i] = NO_DESIGN + beyond
            continue
        # Even the horizontal force alone may be too much.
        if stops_early and is_too_weak(tables.force, tables, room, segments):
            exceedance[i] = 1.0
            continue
        found = _in_all_load_cases(tables, room, segments, weights, stops_early)
        unsolved[0] += found.unsolved
        sinker[i] = found.sinker
        exceedance[i] = found.worst if found.worst > -math.inf else -1.0
        if not math.isnan(found.largest):
            weigh(tables, room, segments, genes[i], 1, objectives[i])
            objectives[i, OFFSET] = rounded(found.largest, tables.step[OFFSET])
            if found.reference < math.inf:
                excursion = found.largest - found.reference
                objectives[i, EXCURSION] = rounded(excursion, tables.step[EXCURSION])
            objectives[i, ANCHOR_LOAD] = rounded(found.anchor_load, tables.step[ANCHOR_LOAD])


class _Found(NamedTuple):
    """One design in all load cases."""

    worst: float  # the largest excess
    largest: float  # the largest span, m; nan when a load case was left out
    reference: float  # the least span of the reference load cases, m; infinite without
    anchor_load: float  # the largest tension at the anchor, N
    sinker: int
    unsolved: int  # lines that did not converge


@inlined
def _in_all_load_cases(
    tables: Tables, room: Room, segments: int, weights: int, stops_early: bool
) -> _Found:
    """Solve and check the line that lies in the work space."""
    pieces = pieces_in(room, segments, weights)
    is_worn = 0
    worst = -math.inf
    needed = -math.inf
    pushed = 0.0
    largest = 0.0
    reference = math.inf
    anchor_load = 0.0
    unsolved = 0
    for c in range(len(tables.force)):
        if tables.is_worn[c] != is_worn:
            is_worn = tables.is_worn[c]
            wear(tables, room, segments, is_worn)
            pieces = pieces_in(room, segments, weights)
        problem = LineProblem(pieces, tables.anchor_height, tables.height[c], tables.friction)
        state = given_force(tables.force[c], problem)
        if state.status != CONVERGED:
            unsolved = 1 if state.status == NOT_CONVERGED else 0
            worst = max(worst, _no_equilibrium(state, tables, room, segments, c))
            largest = math.nan
            break
        worst = max(worst, largest_exceedance(state, problem, tables, room, segments, c))
        if len(tables.sinker_weight) > 0:
            factor = tables.limit[c, SLIDING]
            pull = sinker_needed(state.H_anchor, state.V_anchor, tables.sinker_friction, factor)
            needed = max(needed, pull)
            pushed = max(pushed, factor * state.H_anchor)
        if stops_early and worst > ROUNDING:
            largest = math.nan
            break
        largest = max(largest, state.span)
        anchor_load = max(anchor_load, tension_at_anchor(state))
        if tables.is_reference[c] == 1:
            reference = min(reference, state.span)
    sinker = -1
    if needed > -math.inf:
        sinker = _lightest(needed, pushed, tables.sinker_weight, tables.sinker_base)
        worst = max(worst, ratio_exceedance(needed, tables.sinker_weight[sinker]))
        worst = max(worst, ratio_exceedance(pushed, tables.sinker_base[sinker]))
    return _Found(worst, largest, reference, anchor_load, sinker, unsolved)


@inlined
def tension_at_anchor(state: State) -> float:
    """Pull of a line on its anchor, N."""
    return math.sqrt(state.H_anchor * state.H_anchor + state.V_anchor * state.V_anchor)


@inlined
def pieces_in(room: Room, segments: int, weights: int) -> Pieces:
    """Cut the line that lies in the work space."""
    count = segments + weights
    pieces = Pieces(
        room.piece_length[:count],
        room.piece_weight[:count],
        room.piece_compliance[:count],
        room.piece_load[: 2 * count + 2],
    )
    split(
        room.length[:segments],
        room.weight[:segments],
        room.compliance[:segments],
        room.position[:weights],
        room.point_weight[:weights],
        room.point_friction[:weights],
        pieces,
        room.owner,
    )
    return pieces


@inlined
def take_segments(genes: Any, tables: Tables, room: Room) -> int:
    """Put the segments that are there into the work space; return how many there are."""
    count = 0
    for s in range(len(tables.segment_optional)):
        option = genes[2 * s] - tables.segment_optional[s]
        if option >= 0:
            room.length[count] = tables.length[s, genes[2 * s + 1]]
            room.weight[count] = tables.weight[s, option]
            room.compliance[count] = tables.compliance[s, option]
            room.place[count] = s
            room.option[count] = option
            count += 1
    return count


@inlined
def wear(tables: Tables, room: Room, segments: int, is_worn: int) -> None:
    """Give the segments in the work space what they weigh worn, or new again."""
    for s in range(segments):
        row = room.place[s]
        option = room.option[s]
        left = tables.left[row, option] if is_worn == 1 else 1.0
        room.weight[s] = left * tables.weight[row, option]
        room.compliance[s] = tables.compliance[row, option] / left


@inlined
def take_weights(genes: Any, tables: Tables, room: Room, segments: int) -> tuple[int, float]:
    """Put the clump weights that are there into the work space, by rising position; count them.

    With by how much one hangs beyond the line, as a part of its length; 0 when none does.
    """
    total = 0.0
    for s in range(segments):
        total += room.length[s]
    first = 2 * len(tables.segment_optional)
    count = 0
    beyond = 0.0
    for c in range(len(tables.clump_optional)):
        mass = genes[first + 2 * c] - tables.clump_optional[c]
        if mass < 0:
            continue
        position = tables.position[c, genes[first + 2 * c + 1]]
        if tables.joint[c] > 0:
            position = 0.0
            for s in range(segments):
                if room.place[s] < tables.joint[c]:
                    position += room.length[s]
        if not AT_END * total < position <= (1.0 - AT_END) * total:
            beyond = max(beyond, AT_END + max(position / total - 1.0, 0.0))
        k = count
        while k > 0 and room.position[k - 1] > position:
            room.position[k] = room.position[k - 1]
            room.point_weight[k] = room.point_weight[k - 1]
            room.point_friction[k] = room.point_friction[k - 1]
            k -= 1
        room.position[k] = position
        room.point_weight[k] = tables.clump_weight[c, mass]
        room.point_friction[k] = tables.clump_friction[c]
        count += 1
    return count, beyond


@inlined
def _no_equilibrium(state: State, tables: Tables, room: Room, segments: int, c: int) -> float:
    """Excess of a line without equilibrium: what a line that is too short lacks is added."""
    if state.status != TOO_SHORT:
        return NO_EQUILIBRIUM
    total = 0.0
    for s in range(segments):
        total += room.length[s]
    rise: float = abs(tables.height[c] - tables.anchor_height)
    return NO_EQUILIBRIUM + max(1.0 - total / rise, 0.0)


@inlined
def largest_exceedance(
    state: State, problem: LineProblem, tables: Tables, room: Room, segments: int, c: int
) -> float:
    """Largest excess of all checks in one load case, save that of a sinker."""
    segment_tensions(state, problem, room.runs, room.owner, segments, room.tension)
    worst = -math.inf
    for s in range(segments):
        allowed = tables.allowed[c, room.place[s], room.option[s]]
        if allowed < math.inf:
            worst = max(worst, ratio_exceedance(room.tension[s], allowed))
    limit = tables.limit[c]
    if limit[UPLIFT_ANGLE] < math.inf:
        lifts = state.V_anchor != 0.0
        angle = math.atan2(state.V_anchor, state.H_anchor) if lifts else 0.0
        worst = max(worst, uplift_angle_exceedance(angle, limit[UPLIFT_ANGLE]))
    if limit[UPLIFT_FORCE] < math.inf:
        V, H = state.V_anchor, state.H_anchor
        worst = max(worst, uplift_force_exceedance(V, H, limit[UPLIFT_FORCE]))
    if limit[GROUNDED] > 0.0:
        worst = max(worst, grounded_exceedance(state.grounded, limit[GROUNDED]))
    if limit[SPAN] < math.inf:
        worst = max(worst, ratio_exceedance(state.span, limit[SPAN]))
    if limit[RESERVE] < math.inf:
        worst = max(worst, ratio_exceedance(state.V, limit[RESERVE]))
    if limit[HOLDING] > 0.0:
        capacity = tables.holding_capacity
        worst = max(worst, holding_exceedance(state.H_anchor, limit[HOLDING], capacity))
    if limit[LEAST_TENSION] > 0.0:
        tension = math.sqrt(state.H * state.H + state.V * state.V)
        worst = max(worst, least_tension_exceedance(tension, limit[LEAST_TENSION]))
    return worst


@inlined
def _lightest(needed: float, pushed: float, weights: Any, bases: Any) -> int:
    """Index of the lightest sinker that holds by its weight and on its base, or of the heaviest."""
    for k in range(len(weights)):
        by_base = ratio_exceedance(pushed, bases[k])
        if max(ratio_exceedance(needed, weights[k]), by_base) <= ROUNDING:
            return k
    return len(weights) - 1


@inlined
def weigh(
    tables: Tables, room: Room, segments: int, genes: Any, lines: int, objectives: Any
) -> None:
    """Write mass, cost and length of a number of equal lines."""
    mass = 0.0
    cost = 0.0
    length = 0.0
    for s in range(segments):
        mass += room.length[s] * tables.mass[room.place[s], room.option[s]]
        cost += room.length[s] * tables.price[room.place[s], room.option[s]]
        length += room.length[s]
    first = 2 * len(tables.segment_optional)
    for c in range(len(tables.clump_optional)):
        k = genes[first + 2 * c] - tables.clump_optional[c]
        if k >= 0:
            mass += tables.clump_mass[c, k]
    objectives[MASS] = rounded(lines * mass, tables.step[MASS])
    objectives[COST] = rounded(lines * cost, tables.step[COST])
    objectives[LENGTH] = rounded(lines * length, tables.step[LENGTH])


@inlined
def rounded(value: float, step: float) -> float:
    """Round to a multiple of a step; nan stays nan."""
    if math.isnan(value):
        return value
    return float(math.floor(value / step + 0.5)) * step


def segment_tensions(
    state: State, problem: LineProblem, runs: LineIntervals, owner: Any, segments: int, largest: Any
) -> None:
    """Write the largest tension of each segment (N) to `largest`, with the runs as work space.

    Tension is convex along a uniform run: it is largest at one of the ends.
    """
    for segment in range(segments):
        largest[segment] = 0.0
    for row in range(runs_of(state, problem, runs)):
        length = runs.length[row]
        if length > 0.0:
            k = runs.piece[row]
            H = runs.H[row]
            V = runs.V[row]
            upper = V + problem.pieces.weight[k] * length
            H_upper = H + runs.friction[row] * length
            if runs.on_bed[row] == 1:
                V = upper = 0.0
            tension = max(math.sqrt(H * H + V * V), math.sqrt(H_upper * H_upper + upper * upper))
            segment = owner[k]
            largest[segment] = max(largest[segment], tension)
