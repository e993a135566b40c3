"""A line in a current whose upper end a joint pulls: a float under water, or at the surface."""

from __future__ import annotations

import math
from typing import NamedTuple

from catopt.catenary.along_current import Node, Vector
from catopt.catenary.in_current import Shot, SolutionInCurrent, laid_in_current
from catopt.model import CurrentProfile, Line, Site
from catopt.model.network import Point

_NOTHING = 1e-12
"""Of the line's weight and load: a tension at the touchdown that is rounding."""


class OnFloat(NamedTuple):
    """A line whose upper end a float pulls, x in a direction (rad) from its anchor to that end.

    `lost`: of the pull of the float upwards, because it is out of the water, N.
    """

    solution: SolutionInCurrent
    direction: float
    lost: float


def hung_on_float(
    line: Line, site: Site, current: CurrentProfile, hung: Point, anchor_height: float, used: float
) -> OnFloat:
    """Solve a line whose upper end a joint pulls, and the current with it.

    `used`: of the pull of the joint upwards in still water, N.

    A float is under water with all its pull. Where that would take it out it is at the surface, and
    loses so much as holds it there: all of it at once, or in proportion over its height.
    """
    pull, surface, height = hung.hung, site.water_depth, hung.float_height or 0.0
    half = 0.5 * site.water_density * hung.drag_product

    def drag(z: float) -> tuple[float, float]:
        u, v = shot.water(z)
        push = half * math.hypot(u, v)
        return push * u, push * v

    def missed(top: Node) -> Vector:
        x, y = drag(top.z)
        off = (top.fx - pull[0] - x, top.fy - pull[1] - y, top.fz - pull[2])
        x, y, z = (each * shot.per_force for each in off)
        return x, y, z

    def missed_at_surface(top: Node) -> Vector:
        x, y, _ = missed(top)
        out = (pull[2] - top.fz) / hung.lost_above
        return x, y, top.z - surface + height * (1.0 - out)

    shot = Shot(line, site, current, anchor_height, math.hypot(*pull))
    shot.is_under_water, shot.missed_by = True, missed
    known = shot.closed([pull[0], pull[1], pull[2] - line.submerged_weight])
    top = shot.top(known)
    if hung.is_float and top.z + height > surface:
        shot = Shot(line, site, current, anchor_height, used)
        shot.is_under_water, shot.missed_by = True, missed_at_surface
        x, y = drag(surface)
        still = [pull[0] + x, pull[1] + y, used - line.submerged_weight]
        known = shot.newton(still) or shot.closed(known)
        top = shot.top(known)
    if known[2] < 0.0 and math.hypot(*known[:2]) <= _NOTHING * shot.scale:
        shot.loose_to = (0.0, 0.0)  # nothing takes it anywhere
        top = shot.top(known)
    direction = math.atan2(top.y, top.x)
    lost = max(pull[2] - top.fz, 0.0) if shot.missed_by is missed_at_surface else 0.0
    return OnFloat(laid_in_current(shot, known, direction), direction, lost)
