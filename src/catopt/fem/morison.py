"""Loads of moving water on a moving bar: Morison's equation with the relative velocity.

Split along (t) and across (n) the bar, per unstretched length, S4 [2.19]-[2.32], [3.2]-[3.12]:

    drag        0.5 rho D (C_n |r_n| r_n + C_t |r_t| r_t)                r = u - v
    inertia     rho A u' + rho A (Ca_n (u' - v')_n + Ca_t (u' - v')_t)   C_M = 1 + Ca

with the water's velocity u and acceleration u', the line's velocity v and acceleration v'. rho A u'
is the force of the undisturbed water's pressure. It acts in all directions because tensions are
effective ones: the weight is submerged along the whole line, ends included.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from catopt.compiled import inlined
from catopt.model.validity import Findings

__all__ = ["MorisonSection", "split_velocity"]


@dataclass(frozen=True)
class MorisonSection:
    """What the water does to one segment.

    Attributes
    ----------
    diameter : float
        Drag diameter D, m. Both drag coefficients refer to the area D per length: a tangential one
        that refers to the circumference pi D (MoorDyn, OrcaFlex) is to be multiplied by pi.
    drag_normal, drag_tangential : float
        C_n and C_t.
    added_mass_normal, added_mass_tangential : float
        Ca_n and Ca_t, on the displaced water; C_M = 1 + Ca.
    """

    diameter: float
    drag_normal: float
    drag_tangential: float = 0.0
    added_mass_normal: float = 1.0
    added_mass_tangential: float = 0.0

    def __post_init__(self) -> None:
        found = Findings("MorisonSection")
        found.number("diameter", self.diameter, "m", above=0.0)
        found.number("drag_normal", self.drag_normal, "", at_least=0.0)
        found.number("drag_tangential", self.drag_tangential, "", at_least=0.0)
        found.number("added_mass_normal", self.added_mass_normal, "", at_least=0.0)
        found.number("added_mass_tangential", self.added_mass_tangential, "", at_least=0.0)
        found.raise_if_any()


@inlined
def split_velocity(
    u: Any, v: Any, node: int, tx: float, ty: float, tz: float
) -> tuple[float, float, float, float, float]:
    """Relative velocity of the water at a node: along the bar, and across it with its size.

    Parameters
    ----------
    u, v : array, shape (nodes, 3)
        Velocities of the water and of the line, m/s.
    node : int
        Where.
    tx, ty, tz : float
        Direction of the bar.

    Returns
    -------
    along, nx, ny, nz, size : float
        m/s.
    """
    rx, ry, rz = u[node, 0] - v[node, 0], u[node, 1] - v[node, 1], u[node, 2] - v[node, 2]
    along = rx * tx + ry * ty + rz * tz
    nx, ny, nz = rx - along * tx, ry - along * ty, rz - along * tz
    return along, nx, ny, nz, math.sqrt(nx * nx + ny * ny + nz * nz)
