"""The seabed under the line."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Final, Literal, NamedTuple, get_args

from catopt.arrays import Array
from catopt.compiled import inlined
from catopt.fem.moving import Blend, Equations, Moving, MovingLines
from catopt.model.dynamics import INITIAL_FRICTION, InitialFriction
from catopt.model.kinds import Findings
from catopt.model.load import STEEPEST

FREE: Final = 0  # a node that hangs
ON_BED: Final = 1  # one that the bed pushes
HELD: Final = 2  # one that the bed holds in height both ways
ABSENT: Final = 3  # one under which there is no bed

SHARING: Final = 0  # a line whose bars share their weight where they touch down (`hanging_part`)
HALVING: Final = 1  # one of which half of each bar's weight stays at either end
SLACK: Final = 2  # the same, and it hangs slack: its bars keep next to no tension, and do not rub

NO_FRICTION: Final = 0
PULLED: Final = 1
SPRING: Final = 2
LAID: Final = 3

FrictionLaw = Literal["pulled", "laid", "history"]
FRICTION_LAWS: tuple[str, ...] = get_args(FrictionLaw)


@dataclass(frozen=True)
class Bed:
    """A flat bed at height 0 that only pushes.

    Friction laws: ``"pulled"``: the line was last pulled towards the fairlead, so that friction is
    fully mobilised wherever tension is left, and takes off no more than there is. ``"laid"``: it
    was laid under a greater tension and slackened since, so that friction holds that in it: fully
    mobilised the other way, tension grows towards the anchor. ``"history"``: each node on the bed
    drags a spring that slips at mu R and remembers where it is.
    """

    normal_stiffness: float = math.inf  # force per length of line and per depth of penetration,
    # N/m2; infinite for a rigid bed, which no node passes
    friction_law: FrictionLaw = "pulled"
    tangential_stiffness: float = 1e6  # of the spring of "history", per length of line, N/m2

    def __post_init__(self) -> None:
        found = Findings("Bed")
        found.number("normal_stiffness", self.normal_stiffness, "N/m2", above=0.0, infinite=True)
        found.number("tangential_stiffness", self.tangential_stiffness, "N/m2", above=0.0)
        found.word("friction_law", self.friction_law, FRICTION_LAWS)
        found.raise_if_any()


@dataclass(frozen=True)
class RestrainedBed:
    """The restraint of source S4, for reproducing its figures only: not how a bed works.

    Nodes near the anchor are held at height 0 both ways, so that the bed also pulls; there is no
    bed under the other nodes, and no friction.
    """

    grounded_length: float  # arc length from the anchor up to which nodes are held, m
    EA_multiplier: float = 1.0  # on every segment's EA

    def __post_init__(self) -> None:
        found = Findings("RestrainedBed")
        found.number("grounded_length", self.grounded_length, "m", at_least=0.0)
        found.number("EA_multiplier", self.EA_multiplier, "", above=0.0)
        found.raise_if_any()


class Ground(NamedTuple):
    """The bed as the kernels take it; arrays have the shape (nodes,)."""

    stiffness: Array  # of the bed under each node, normal to it, N/m; infinite where rigid
    friction: Array  # Coulomb coefficient: that of the bed, or of the point load on the node
    beside: Array  # (nodes, 2): what the bars towards the anchor and the fairlead, which rub with
    # the bed's coefficient, add to that where they lie, N; 0 without a point load of its own
    bed_friction: float  # Coulomb coefficient of the line itself
    law: int  # NO_FRICTION, PULLED, LAID or SPRING
    tangential: Array  # stiffness of each node's friction spring, N/m
    spring_foot: Array  # (nodes, 2): where that has its foot, m


def friction_sense(law: int) -> float:
    """Return 1.0 where friction takes tension off towards the anchor, -1.0 where it adds, or 0."""
    return 1.0 if law == PULLED else -1.0 if law == LAID else 0.0


def touches(contact: int, z: float, reaction: float, depth: float) -> int:
    """State of a node at the height z, m, under which a rigid bed would carry `reaction`, N.

    `depth`: penetration that is rounding, m.
    """
    if contact == FREE and z < -depth:
        return ON_BED
    if contact == ON_BED and reaction < 0.0 and z >= -depth:
        return FREE
    return contact


@dataclass(frozen=True)
class Seabed:
    """A plane bed, at height 0 where x is 0.

    Friction at rest is that of a line that was last ``"pulled"`` towards the fairlead, whose
    tension falls towards the anchor; ``"none"``; or that of one that was ``"laid"`` under a greater
    tension and slackened, in which it grows. The last are the bounds, with friction mobilised
    fully.
    """

    normal_stiffness: float | None = None  # k, force per length of line and depth, N/m2; None: the
    # line's own weight presses it 1 cm deep. A figure per area (Pa/m) is to be multiplied by the
    # line's diameter.
    normal_damping: float | None = None  # c, force per length of line and speed, N s/m2; None:
    # critical for the line's mass on k
    friction: float = 0.0  # Coulomb coefficient mu
    tangential_stiffness: float | None = None  # of the spring along the bed, per length, N/m2;
    # None: friction is mobilised after 1 mm
    initial_friction: InitialFriction = "pulled"
    slope: float = 0.0  # angle by which the bed rises along x, rad; up to 45 degrees either way

    def __post_init__(self) -> None:
        found = Findings("Seabed")
        found.numbers(self, "N/m2", "normal_stiffness", above=0.0)
        found.numbers(self, "N s/m2", "normal_damping", at_least=0.0)
        found.number("friction", self.friction, "", at_least=0.0)
        found.numbers(self, "N/m2", "tangential_stiffness", above=0.0)
        found.word("initial_friction", self.initial_friction, INITIAL_FRICTION)
        found.number("slope", self.slope, "rad", at_least=-STEEPEST, at_most=STEEPEST)
        found.raise_if_any()


@inlined
def across_bed(rows: Any, n: int, lines: MovingLines) -> float:
    """Part of the vector of node n across the bed; of a place, its height above it."""
    return float(lines.bed_cos * rows[n, 2] - lines.bed_sin * rows[n, 0])


@inlined
def along_bed(rows: Any, n: int, lines: MovingLines) -> float:
    """Part of the vector of node n along the bed, up its slope."""
    return float(lines.bed_cos * rows[n, 0] + lines.bed_sin * rows[n, 2])


def push_and_rub(
    n: int, lines: MovingLines, now: Moving, before: Moving, blend: Blend, to: Equations
) -> None:
    """Add the bed's force on node n, which is at the bed or about to be, and its derivatives."""
    depth, sinking = -across_bed(now.x, n, lines), -across_bed(now.v, n, lines)
    k = lines.bed_stiffness[n]
    had = max(-across_bed(before.x, n, lines), 0.0)
    c = lines.bed_damping[n] * min(had / lines.bed_depth[n], 1.0)
    c = max(c, 0.5 * blend.step * k)
    R = k * depth + c * sinking
    if R <= 0.0 and not lines.held[n]:
        return
    slope = blend.by_x * k + blend.by_v * c
    now.reaction[n] = R
    cos, sin = lines.bed_cos, lines.bed_sin
    now.force[n, 0] -= sin * R
    now.force[n, 2] += cos * R
    stiff = to.diagonal
    stiff[n, 0, 0] += slope * sin * sin
    stiff[n, 0, 2] -= slope * sin * cos
    stiff[n, 2, 0] -= slope * sin * cos
    stiff[n, 2, 2] += slope * cos * cos
    if lines.friction[n] == 0.0 or math.isnan(now.foot[n, 0]):
        return
    px, py, held = _pull_of_foot(n, lines, now, blend)
    pull, most = math.sqrt(px * px + py * py), lines.friction[n] * R
    if pull <= most:
        _rub_with(n, lines, now, -px, -py)
        _add_along(stiff, n, lines, held, 0.0, held)
        return
    nx, ny = px / pull, py / pull
    _rub_with(n, lines, now, -most * nx, -most * ny)
    turn = most / pull * held
    _add_along(stiff, n, lines, turn * ny * ny, -turn * nx * ny, turn * nx * nx)
    by_R = lines.friction[n] * slope
    stiff[n, 0, 0] += by_R * nx * cos * sin
    stiff[n, 1, 0] += by_R * ny * sin
    stiff[n, 2, 0] += by_R * nx * sin * sin
    stiff[n, 0, 2] -= by_R * nx * cos * cos
    stiff[n, 1, 2] -= by_R * ny * cos
    stiff[n, 2, 2] -= by_R * nx * sin * cos


@inlined
def _pull_of_foot(
    n: int, lines: MovingLines, now: Moving, blend: Blend
) -> tuple[float, float, float]:
    """Pull of spring and dashpot along the bed and along y, N, and its derivative, N/m."""
    stiffness = lines.drag_spring[n]
    dashpot = max(lines.drag_dashpot[n], 0.5 * blend.step * stiffness)
    px = stiffness * (along_bed(now.x, n, lines) - now.foot[n, 0])
    px += dashpot * along_bed(now.v, n, lines)
    py = stiffness * (now.x[n, 1] - now.foot[n, 1]) + dashpot * now.v[n, 1]
    return px, py, blend.by_x * stiffness + blend.by_v * dashpot


@inlined
def _rub_with(n: int, lines: MovingLines, now: Moving, along: float, aside: float) -> None:
    """Add a friction along the bed and along y."""
    now.rub[n, 0], now.rub[n, 1] = along, aside
    now.force[n, 0] += along * lines.bed_cos
    now.force[n, 1] += aside
    now.force[n, 2] += along * lines.bed_sin


@inlined
def _add_along(stiff: Any, n: int, lines: MovingLines, xx: float, xy: float, yy: float) -> None:
    """Add a symmetric derivative along the bed and along y."""
    cos, sin = lines.bed_cos, lines.bed_sin
    stiff[n, 0, 0] += xx * cos * cos
    stiff[n, 0, 1] += xy * cos
    stiff[n, 0, 2] += xx * cos * sin
    stiff[n, 1, 0] += xy * cos
    stiff[n, 1, 1] += yy
    stiff[n, 1, 2] += xy * sin
    stiff[n, 2, 0] += xx * cos * sin
    stiff[n, 2, 1] += xy * sin
    stiff[n, 2, 2] += xx * sin * sin


def drag_feet(lines: MovingLines, now: Moving, h: float) -> None:
    """Bring the feet of the friction springs up to date after a step of h, s.

    The foot of a slipping node follows so that spring and dashpot together pull with mu R; a node
    that has come down sets its foot where it lies, and one that hangs has none.
    """
    foot: Any = now.foot
    for n in range(foot.shape[0]):
        if now.reaction[n] <= 0.0:
            foot[n, 0] = foot[n, 1] = math.nan
            continue
        if math.isnan(foot[n, 0]):
            foot[n, 0], foot[n, 1] = along_bed(now.x, n, lines), now.x[n, 1]
            continue
        stiffness = lines.drag_spring[n]
        dashpot = max(lines.drag_dashpot[n], 0.5 * h * stiffness)
        along, speed = along_bed(now.x, n, lines), along_bed(now.v, n, lines)
        px = stiffness * (along - foot[n, 0]) + dashpot * speed
        py = stiffness * (now.x[n, 1] - foot[n, 1]) + dashpot * now.v[n, 1]
        pull, most = math.sqrt(px * px + py * py), lines.friction[n] * now.reaction[n]
        if pull > most:
            part = most / pull
            foot[n, 0] = along - (part * px - dashpot * speed) / stiffness
            foot[n, 1] = now.x[n, 1] - (part * py - dashpot * now.v[n, 1]) / stiffness
