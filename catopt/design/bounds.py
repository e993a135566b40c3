"""What a mooring cannot do, without solving it; docs/theory.md has the proofs.

Each bound supposes that a design passes its checks and finds a contradiction, or a design already
known that is better in every objective. Meant to be compiled.
"""

from __future__ import annotations

import math
from typing import Any, Final

from catopt.catenary.equilibrium import given_force
from catopt.catenary.pieces import LineProblem
from catopt.catenary.state import CONVERGED
from catopt.checks.excess import ROUNDING, ratio_excess
from catopt.compiled import inlined
from catopt.design.tables import MooringTables, Room, Tables

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
        if ratio_excess(forces[c], allowed) > ROUNDING:
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
