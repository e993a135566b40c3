"""The loop over many moorings: each proved needless, or solved and checked in every state.

Meant to be compiled; nothing is made anew inside it.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from catopt.catenary.equilibrium import given_force, hang_slack
from catopt.catenary.pieces import LineProblem, Pieces, total_length
from catopt.catenary.span_or_tension import given_span
from catopt.catenary.state import CONVERGED, NOT_CONVERGED, TOO_SHORT, failed
from catopt.checks.kinds import ROUNDING, ratio_exceedance
from catopt.compiled import inlined
from catopt.design.assess import (
    ANCHOR_LOAD,
    LEAST_OFFSET,
    MARGIN,
    NO_DESIGN,
    NO_EQUILIBRIUM,
    NONE,
    OFFSET,
    OFFSET_SO_FAR,
    REACH,
    SLIDING,
    STRENGTH,
    is_beaten,
    is_too_weak,
    largest_exceedance,
    least_forces,
    least_offset,
    pieces_in,
    rounded,
    take_segments,
    take_weights,
    tension_at_anchor,
    weigh,
)
from catopt.design.tables import BodyRoom, MooringTables, Room, Tables
from catopt.model.anchor import sinker_needed
from catopt.mooring.balance import Arrangement, Lines, pull_at
from catopt.mooring.descent import BodyLoad, BodyProblem, Freedom, Rest, freedom_of
from catopt.mooring.static_equilibrium import static_equilibrium


class Search(NamedTuple):
    """What bounds go by."""

    is_bounded: bool  # whether designs are excluded by bounds
    stops_early: bool  # whether a design is left at its first failed check
    best: Any  # shape (n, wanted objectives): what designs known to be feasible are worth
    columns: Any  # shape (wanted objectives,): which objectives are required


def assess_moorings(
    genes: Any,
    tables: MooringTables,
    line: Tables,
    search: Search,
    room: Room,
    body: BodyRoom,
    first: int,
    end: int,
    objectives: Any,
    exceedance: Any,
    excluded: Any,
    unsolved: Any,
) -> None:
    """Solve and check moorings number `first` to `end` (not included), their layout the last genes.

    Written to, as by `catopt.design.assess.assess`: `objectives`, with mass and cost of all lines,
    the largest offset of the body from its zero-load position with all lines and the largest load
    of an anchor; `exceedance`, of
    all lines in all states; `excluded`, shape (n,): the bound that excludes a design, NONE where it
    was solved; `unsolved`, raised by the number of states that did not converge.
    """
    for i in range(first, end):
        objectives[i, :] = math.nan
        excluded[i] = NONE
        segments = take_segments(genes[i], line, room)
        weights, beyond = take_weights(genes[i], line, room, segments)
        if beyond > 0.0:
            exceedance[i] = NO_DESIGN + beyond
            continue
        layout = genes[i, genes.shape[1] - 2]
        pieces = pieces_in(room, segments, weights)
        radius = _radius(genes[i, genes.shape[1] - 1], pieces, tables, line)
        if math.isnan(radius):
            exceedance[i] = NO_EQUILIBRIUM
            continue
        weigh(line, room, segments, genes[i], tables.lines[layout], objectives[i])
        forces = 0.0, 0.0
        if search.is_bounded:
            forces = least_forces(tables, line, room, segments, layout, radius)
            if math.isinf(max(forces[0], forces[1])):
                excluded[i] = REACH
            elif is_too_weak(
                (forces[0] * (1.0 - MARGIN), forces[1] * (1.0 - MARGIN)), line, room, segments
            ):
                excluded[i] = STRENGTH
        if excluded[i] == NONE:
            found = _in_all_states(
                layout,
                radius,
                forces,
                pieces,
                segments,
                tables,
                line,
                search,
                room,
                body,
                objectives[i],
            )
            excluded[i] = found.excluded
            exceedance[i] = found.worst if found.worst > -math.inf else -1.0
            unsolved[0] += found.unsolved
            objectives[i, OFFSET] = rounded(found.largest, line.step[OFFSET])
            objectives[i, ANCHOR_LOAD] = rounded(found.anchor_load, line.step[ANCHOR_LOAD])
        if excluded[i] != NONE:
            exceedance[i] = 1.0
        if math.isnan(objectives[i, OFFSET]):
            objectives[i, :] = math.nan


@inlined
def _radius(anchors: int, pieces: Pieces, tables: MooringTables, line: Tables) -> float:
    """Horizontal distance from the body's origin to the anchors, m; nan where none gives it."""
    if len(tables.pretension) == 0:
        radius: float = tables.radius[anchors]
        return radius
    problem = LineProblem(pieces, line.anchor_height, line.height[0], line.friction)
    state = given_force(tables.pretension[anchors], problem)
    return state.span + tables.fairlead_radius if state.status == CONVERGED else math.nan


class _Found(NamedTuple):
    """One mooring in all states."""

    excluded: int  # the bound that excludes it
    worst: float  # the largest excess
    largest: float  # offset, m; nan where a state has no equilibrium or was left out
    anchor_load: float  # the largest tension at an anchor, N
    unsolved: int  # states that did not converge


def _in_all_states(
    layout: int,
    radius: float,
    forces: tuple[float, float],
    pieces: Pieces,
    segments: int,
    tables: MooringTables,
    line: Tables,
    search: Search,
    room: Room,
    body: BodyRoom,
    objectives: Any,
) -> _Found:
    """Solve and check the mooring of the line in the work space; with all lines first."""
    missing, height = -1, tables.height[tables.first[layout]]
    problem = LineProblem(pieces, line.anchor_height, height, line.friction)
    unloaded = _unloaded(layout, radius, missing, problem, tables, line, body)
    origin = unloaded.rest
    if search.is_bounded and origin.status == CONVERGED:
        far = least_offset(forces, tables, problem, unloaded.known.span.max())
        if _is_needless(far, 0.0, line, search, body.least, objectives):
            return _Found(LEAST_OFFSET, -math.inf, math.nan, 0.0, 0)
    worst, largest, anchor_load = -math.inf, 0.0, 0.0
    for state in range(tables.first[layout], tables.first[layout + 1]):
        if tables.missing[state] != missing or tables.height[state] != height:
            missing, height = tables.missing[state], tables.height[state]
            problem = LineProblem(pieces, line.anchor_height, height, line.friction)
            unloaded = _unloaded(layout, radius, missing, problem, tables, line, body)
            if missing < 0:
                origin = unloaded.rest
        damage = 1 if missing >= 0 else 0
        end = _under_load(unloaded, tables, state)
        status, exceedance, pull = end.status, NO_EQUILIBRIUM, 0.0
        if status == CONVERGED:
            reserve = tables.reserve[damage]
            status, exceedance, pull = _of_lines(
                unloaded.lines, reserve, problem, segments, damage, line, room
            )
        worst = max(worst, exceedance)
        if status != CONVERGED:
            return _Found(NONE, worst, math.nan, 0.0, 1 if status == NOT_CONVERGED else 0)
        if search.stops_early and worst > ROUNDING:
            return _Found(NONE, worst, math.nan, 0.0, 0)
        x, y = end.x - origin.x, end.y - origin.y
        largest = max(largest, math.sqrt(x * x + y * y))
        anchor_load = max(anchor_load, pull)
        if search.is_bounded and _is_needless(
            largest, anchor_load, line, search, body.least, objectives
        ):
            return _Found(OFFSET_SO_FAR, worst, math.nan, 0.0, 0)
    return _Found(NONE, worst, largest, anchor_load, 0)


class _Unloaded(NamedTuple):
    """The body with some lines, without a load; `lines` is work space for those under one."""

    arrangement: Arrangement
    known: Lines
    lines: Lines
    freedom: Freedom
    rest: Rest


def _unloaded(
    layout: int,
    radius: float,
    missing: int,
    problem: LineProblem,
    tables: MooringTables,
    line: Tables,
    body: BodyRoom,
) -> _Unloaded:
    """Find the zero-load position, from the origin with yaw 0."""
    arrangement = _around(body.arrangement, layout, radius, missing, problem, tables, line)
    count = len(arrangement.anchor_x)
    known, lines = _first(body.rest, count), _first(body.under_load, count)
    for k in range(count):
        known.H[k] = known.V[k] = known.span[k] = known.H_S[k] = known.V_S[k] = math.nan
    freedom = freedom_of(arrangement, tables.turns, tables.fairlead_radius)
    pull = pull_at(0.0, 0.0, 0.0, arrangement, known, True)
    nothing = BodyProblem(BodyLoad(0.0, 0.0, 0.0), freedom, arrangement, known)
    rest = static_equilibrium(0.0, 0.0, 0.0, pull, nothing)
    return _Unloaded(arrangement, known, lines, freedom, rest)


def _under_load(unloaded: _Unloaded, tables: MooringTables, state: int) -> Rest:
    """Bring the body to rest under the force of a state; its lines are written to."""
    rest = unloaded.rest
    if rest.status != CONVERGED:
        return rest
    for k in range(len(unloaded.lines)):
        unloaded.lines[k][:] = unloaded.known[k]
    force, direction = tables.force[state], tables.direction[state]
    x, y = force * math.cos(direction), force * math.sin(direction)
    load = BodyLoad(x, y, tables.moment)
    problem = BodyProblem(load, unloaded.freedom, unloaded.arrangement, unloaded.lines)
    return static_equilibrium(rest.x, rest.y, rest.yaw, rest.pull, problem)


@inlined
def _of_lines(
    lines: Lines,
    reserve: float,
    problem: LineProblem,
    segments: int,
    damage: int,
    line: Tables,
    room: Room,
) -> tuple[int, float, float]:
    """Status, the largest excess of all checks of all lines where the body has come to rest.

    With the largest tension at an anchor, N.
    """
    worst, pull_down, anchor_load = -math.inf, 0.0, 0.0
    for k in range(len(lines.H)):
        span = max(lines.span[k], 1e-9)
        H = lines.H[k] if lines.H[k] > 0.0 else math.nan
        V = lines.V[k] if lines.H[k] > 0.0 else math.nan
        state = given_span(span, problem, H, V)
        if state.status != CONVERGED:
            return NOT_CONVERGED, worst, anchor_load
        pull_down += state.V
        anchor_load = max(anchor_load, tension_at_anchor(state))
        worst = max(worst, largest_exceedance(state, problem, line, room, segments, damage))
        if len(line.sinker_weight) > 0:
            factor = line.limit[damage, SLIDING]
            pull = sinker_needed(state.H_anchor, state.V_anchor, line.sinker_friction, factor)
            worst = max(worst, ratio_exceedance(pull, line.sinker_weight[0]))
            worst = max(worst, ratio_exceedance(factor * state.H_anchor, line.sinker_base[0]))
    if reserve < math.inf:
        worst = max(worst, ratio_exceedance(pull_down, reserve))
    return CONVERGED, worst, anchor_load


@inlined
def _is_needless(
    offset: float, anchor_load: float, line: Tables, search: Search, least: Any, objectives: Any
) -> bool:
    """Whether a design of at least some offset and load of an anchor is beaten by a known one."""
    for column in range(len(search.columns)):
        least[column] = objectives[search.columns[column]]
        if search.columns[column] == OFFSET:
            least[column] = rounded(offset, line.step[OFFSET])
        elif search.columns[column] == ANCHOR_LOAD:
            least[column] = rounded(anchor_load, line.step[ANCHOR_LOAD])
    return is_beaten(least, search.best)


def _around(
    room: Arrangement,
    layout: int,
    radius: float,
    missing: int,
    problem: LineProblem,
    tables: MooringTables,
    line: Tables,
) -> Arrangement:
    """Put equal lines around the body, one of them missing."""
    pieces = problem.pieces
    slack = failed(TOO_SHORT)
    if problem.fairlead_height + line.anchor_height < total_length(pieces):
        slack = hang_slack(problem)
    has_slack = slack.status == CONVERGED
    each = len(pieces.length)
    left = 0
    room.first[0] = 0
    for k in range(tables.lines[layout]):
        if k == missing:
            continue
        x, y = math.cos(tables.azimuth[layout, k]), math.sin(tables.azimuth[layout, k])
        room.anchor_x[left], room.anchor_y[left] = radius * x, radius * y
        room.arm_x[left] = tables.fairlead_radius * x
        room.arm_y[left] = tables.fairlead_radius * y
        room.anchor_height[left] = line.anchor_height
        room.fairlead_height[left] = problem.fairlead_height
        room.slack_span[left] = slack.span if has_slack else -1.0
        room.slack_V[left] = slack.V if has_slack else 0.0
        room.slack_V_anchor[left] = slack.V_anchor if has_slack else 0.0
        room.slack_grounded[left] = slack.grounded if has_slack else 0.0
        start = left * each
        for piece in range(each):
            room.length[start + piece] = pieces.length[piece]
            room.weight[start + piece] = pieces.weight[piece]
            room.compliance[start + piece] = pieces.compliance[piece]
        for joint in range(2 * each + 2):
            room.load[2 * (start + left) + joint] = pieces.load[joint]
        left += 1
        room.first[left] = left * each
    return Arrangement(
        room.anchor_x[:left],
        room.anchor_y[:left],
        room.anchor_height[:left],
        room.arm_x[:left],
        room.arm_y[:left],
        room.fairlead_height[:left],
        line.friction,
        room.first[: left + 1],
        room.length[: left * each],
        room.weight[: left * each],
        room.compliance[: left * each],
        room.load[: 2 * left * (each + 1)],
        room.slack_span[:left],
        room.slack_V[:left],
        room.slack_V_anchor[:left],
        room.slack_grounded[:left],
    )


@inlined
def _first(lines: Lines, count: int) -> Lines:
    """Return the room of the first lines."""
    return Lines(
        lines.H[:count],
        lines.V[:count],
        lines.span[:count],
        lines.grounded[:count],
        lines.H_anchor[:count],
        lines.V_anchor[:count],
        lines.H_S[:count],
        lines.V_S[:count],
    )
