"""Loads of moving water on a moving bar: Morison's equation with the relative velocity.

Split along (t) and across (n) the bar, per unstretched length, S4 [2.19]-[2.32], [3.2]-[3.12]:

    drag        0.5 rho D (C_n |r_n| r_n + (C_t |r_t| + C_n (m |r| + n |r_n|)) r_t)     r = u - v
    inertia     rho A u' + rho A (Ca_n (u' - v')_n + Ca_t (u' - v')_t)   C_M = 1 + Ca

with the water's velocity u and acceleration u', the line's velocity v and acceleration v'. m and n
are those of the drag C_n (m + n sin g) cos g |r|² along the line, S4 [2.32], g being the angle
between the line and r: sin g = |r_n|/|r|, cos g = r_t/|r|. rho A u'
is the force of the undisturbed water's pressure. It acts in all directions because tensions are
effective ones: the weight is submerged along the whole line, ends included.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from catopt.compiled import inlined
from catopt.model.validity import Findings


@dataclass(frozen=True)
class MorisonSection:
    """What the water does to one segment.

    Both drag coefficients refer to the area D per length: a tangential one that refers to the
    circumference pi D (MoorDyn, OrcaFlex) is to be multiplied by pi.
    """

    diameter: float  # drag diameter D, m
    drag_normal: float  # C_n
    drag_tangential: float = 0.0  # C_t
    added_mass_normal: float = 1.0  # Ca_n, on the displaced water; C_M = 1 + Ca
    added_mass_tangential: float = 0.0  # Ca_t
    oblique: tuple[float, float] = (0.0, 0.0)  # m and n, as parts of C_n; they add to C_t

    def __post_init__(self) -> None:
        found = Findings("MorisonSection")
        found.number("diameter", self.diameter, "m", above=0.0)
        found.number("drag_normal", self.drag_normal, "", at_least=0.0)
        found.number("drag_tangential", self.drag_tangential, "", at_least=0.0)
        found.number("added_mass_normal", self.added_mass_normal, "", at_least=0.0)
        found.number("added_mass_tangential", self.added_mass_tangential, "", at_least=0.0)
        for i, part in enumerate(self.oblique):
            found.number(f"oblique[{i}]", part, "", at_least=0.0)
        found.raise_if_any()


@inlined
def axial_drag(
    along: float, across: float, by_along: float, by_speed: float, by_across: float
) -> tuple[float, float, float, float]:
    """Drag along the bar over the velocity along it, with its derivatives.

    `along`, `across`: relative velocity along the bar, and size of that across it, m/s; `by_along`,
    `by_speed`, `by_across`: 0.5 rho D times C_t, C_n m and C_n n, times a length, N s2/m2. Returns:
    drag: A, N s/m; the force is A times `along`; by_turn: of the force, by the turn of the bar over
    `across`; by_itself: of the force, by `along`; by_crossing: of the force, by the velocity
    across, over `across`.
    """
    speed = math.sqrt(along * along + across * across)
    own = by_along * abs(along)
    A = own + by_speed * speed + by_across * across
    over_speed = 1.0 / speed if speed > 0.0 else 0.0
    over_across = 1.0 / across if across > 0.0 else 0.0
    square = along * along
    return (
        A,
        A + own - by_across * square * over_across,
        A + own + by_speed * square * over_speed,
        along * (by_speed * over_speed + by_across * over_across),
    )


@inlined
def split_velocity(
    u: Any, v: Any, node: int, tx: float, ty: float, tz: float
) -> tuple[float, float, float, float, float]:
    """Relative velocity of the water at a node: along the bar, and across it with its size.

    `u`, `v` (nodes, 3): velocities of the water and of the line, m/s. Returns: along, nx, ny, nz,
    size: m/s.
    """
    rx, ry, rz = u[node, 0] - v[node, 0], u[node, 1] - v[node, 1], u[node, 2] - v[node, 2]
    along = rx * tx + ry * ty + rz * tz
    nx, ny, nz = rx - along * tx, ry - along * ty, rz - along * tz
    return along, nx, ny, nz, math.sqrt(nx * nx + ny * ny + nz * nz)
