"""The loop over many moorings: each proved needless, or solved and checked in every state.

Meant to be compiled; nothing is made anew inside it.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from catopt.catenary.equilibrium import given_force
from catopt.catenary.pieces import LineProblem, Pieces
from catopt.catenary.span_or_tension import given_span
from catopt.catenary.state import CONVERGED, NOT_CONVERGED
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
from catopt.design.tables import MooringTables, Room, Tables
from catopt.model.anchor import sinker_needed
from catopt.mooring.heading import rest_at_heading
from catopt.mooring.net import GUESS, SPAN, STATE, Known, Net, hang, state_of
from catopt.mooring.rest import remember


class Search(NamedTuple):
    """What bounds go by."""

    is_bounded: bool  # whether designs are excluded by bounds
    stops_early: bool  # whether a design is left at its first failed check
    least: Any  # shape (wanted objectives,): work space for what a design is worth at least
    best: Any  # shape (n, wanted objectives): what designs known to be feasible are worth
    columns: Any  # shape (wanted objectives,): which objectives are required


def assess_moorings(
    genes: Any,
    tables: MooringTables,
    line: Tables,
    search: Search,
    room: Room,
    net: Net,
    free: Known,
    loaded: Known,
    first: int,
    end: int,
    objectives: Any,
    exceedance: Any,
    excluded: Any,
    unsolved: Any,
) -> None:
    """Solve and check moorings number `first` to `end` (not included), their layout the last genes.

    `net`, `free` and `loaded` are work space: the lines, and what is known of them without a load
    and under one. Written to, as by `catopt.design.assess.assess`: `objectives`, with mass and cost
    of all lines, the largest offset of the body from its zero-load position with all lines and the
    largest load of an anchor; `exceedance`, of all lines in all states; `excluded`, shape (n,): the
    bound that excludes a design, NONE where it was solved; `unsolved`, raised by the number of
    states that did not converge.
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
                net,
                free,
                loaded,
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
    net: Net,
    free: Known,
    loaded: Known,
    objectives: Any,
) -> _Found:
    """Solve and check the mooring of the line in the work space; with all lines first."""
    missing, height = -1, tables.height[tables.first[layout]]
    problem = LineProblem(pieces, line.anchor_height, height, line.friction)
    status = _unloaded(layout, radius, missing, problem, tables, line, net, free)
    x, y = free.q[0], free.q[1]
    if search.is_bounded and status == CONVERGED:
        far = least_offset(forces, tables, problem, _longest_span(net, free))
        if _prove_needless(far, 0.0, line, search, objectives):
            return _Found(LEAST_OFFSET, -math.inf, math.nan, 0.0, 0)
    worst, largest, anchor_load = -math.inf, 0.0, 0.0
    for state in range(tables.first[layout], tables.first[layout + 1]):
        if tables.missing[state] != missing or tables.height[state] != height:
            missing, height = tables.missing[state], tables.height[state]
            problem = LineProblem(pieces, line.anchor_height, height, line.friction)
            status = _unloaded(layout, radius, missing, problem, tables, line, net, free)
            if missing < 0:
                x, y = free.q[0], free.q[1]
        damage = 1 if missing >= 0 else 0
        end = _under_load(status, tables, state, net, free, loaded)
        exceedance, pull = NO_EQUILIBRIUM, 0.0
        if end == CONVERGED:
            reserve = tables.reserve[damage]
            end, exceedance, pull = _of_lines(
                net, loaded, reserve, problem, segments, damage, line, room
            )
        worst = max(worst, exceedance)
        if end != CONVERGED:
            return _Found(NONE, worst, math.nan, 0.0, 1 if end == NOT_CONVERGED else 0)
        if search.stops_early and worst > ROUNDING:
            return _Found(NONE, worst, math.nan, 0.0, 0)
        off_x, off_y = loaded.q[0] - x, loaded.q[1] - y
        largest = max(largest, math.sqrt(off_x * off_x + off_y * off_y))
        anchor_load = max(anchor_load, pull)
        if search.is_bounded and _prove_needless(largest, anchor_load, line, search, objectives):
            return _Found(OFFSET_SO_FAR, worst, math.nan, 0.0, 0)
    return _Found(NONE, worst, largest, anchor_load, 0)


def _unloaded(
    layout: int,
    radius: float,
    missing: int,
    problem: LineProblem,
    tables: MooringTables,
    line: Tables,
    net: Net,
    free: Known,
) -> int:
    """Find the zero-load position, from the origin with yaw 0; status."""
    _around(net, layout, radius, missing, problem, tables, line)
    for i in range(3):
        net.pull[i] = free.q[i] = 0.0
    for i in range(GUESS * net.used[0]):
        free.guess[i] = math.nan
    found = rest_at_heading(net, free, hang(net, free, False))
    remember(net, free)
    return found.status


def _under_load(
    status: int, tables: MooringTables, state: int, net: Net, free: Known, loaded: Known
) -> int:
    """Bring the body to rest under the force of a state; its lines are written to. Status.

    That without a load, where it has none.
    """
    if status != CONVERGED:
        return status
    for i in range(3):
        loaded.q[i] = free.q[i]
    loaded.place[:], loaded.lever[:] = free.place, free.lever
    loaded.state[:], loaded.guess[:], loaded.force[:] = free.state, free.guess, free.force
    force, direction = tables.force[state], tables.direction[state]
    net.pull[0], net.pull[1] = force * math.cos(direction), force * math.sin(direction)
    net.pull[2] = tables.moment / net.scale[2]
    return rest_at_heading(net, loaded, (CONVERGED, -1)).status


@inlined
def _longest_span(net: Net, known: Known) -> float:
    longest = 0.0
    for k in range(net.used[0]):
        longest = max(longest, known.state[STATE * k + SPAN])
    return longest


@inlined
def _of_lines(
    net: Net,
    known: Known,
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
    for k in range(net.used[0]):
        there = state_of(k, known)
        H = there.H if there.H > 0.0 else math.nan
        V = there.V if there.H > 0.0 else math.nan
        state = given_span(max(there.span, 1e-9), problem, H, V)
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
def _prove_needless(
    offset: float, anchor_load: float, line: Tables, search: Search, objectives: Any
) -> bool:
    """Write the least that a design has, by its offset and anchor load; whether that is beaten."""
    least = search.least
    for column in range(len(search.columns)):
        least[column] = objectives[search.columns[column]]
        if search.columns[column] == OFFSET:
            least[column] = rounded(offset, line.step[OFFSET])
        elif search.columns[column] == ANCHOR_LOAD:
            least[column] = rounded(anchor_load, line.step[ANCHOR_LOAD])
    return is_beaten(least, search.best)


def _around(
    net: Net,
    layout: int,
    radius: float,
    missing: int,
    problem: LineProblem,
    tables: MooringTables,
    line: Tables,
) -> None:
    """Put equal lines around the body, one of them missing."""
    pieces, left = problem.pieces, 0
    each = len(pieces.length)
    for k in range(tables.lines[layout]):
        if k == missing:
            continue
        x, y = math.cos(tables.azimuth[layout, k]), math.sin(tables.azimuth[layout, k])
        net.base[6 * left], net.base[6 * left + 1] = radius * x, radius * y
        net.base[6 * left + 2] = line.anchor_height
        net.base[6 * left + 5] = problem.fairlead_height
        net.arm[4 * left + 2] = tables.fairlead_radius * x
        net.arm[4 * left + 3] = tables.fairlead_radius * y
        start = left * each
        for piece in range(each):
            net.length[start + piece] = pieces.length[piece]
            net.weight[start + piece] = pieces.weight[piece]
            net.compliance[start + piece] = pieces.compliance[piece]
        for joint in range(2 * each + 2):
            net.load[2 * (start + left) + joint] = pieces.load[joint]
        left += 1
        net.piece[left] = left * each
    net.used[0] = left
