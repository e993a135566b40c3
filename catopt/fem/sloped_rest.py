"""Lines at rest on a bed that slopes, and where they touch down."""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np

from catopt.arrays import Array
from catopt.errors import NotConvergedError
from catopt.fem.banded import DIAGONAL
from catopt.fem.seabed import FREE, ON_BED, along_bed
from catopt.fem.simulation import Simulation
from catopt.model.dynamics import InitialFriction
from catopt.words import Message

_NO_SLIP: Final = 10.0
"""Factor on the friction at which springs slip while they are drawn out."""
_SOFT: Final = 1e-2
"""Factor on their stiffness meanwhile."""
_MOST: Final = 200
"""Times that they are drawn out."""
_SAME: Final = 1e-5
"""Change of a pull, over the largest tension, that is none."""


def bring_to_rest_on_slope(simulation: Simulation, initial_friction: InitialFriction) -> None:
    """Bring one line to rest on a bed that slopes, from its shape on a level one.

    Raises NotConvergedError with the node and the force left over there; or when the line slides
    down past its anchor.
    """
    lines = simulation.lines
    friction = lines.friction
    simulation.lines = lines._replace(friction=np.zeros_like(friction))
    simulation.settle()
    _check_slide(simulation)
    if initial_friction != "none" and friction.any():
        simulation.lines = lines._replace(
            friction=_NO_SLIP * friction, drag_spring=_SOFT * lines.drag_spring
        )
        for _ in range(_MOST):
            change = _draw_out(simulation, friction, is_pulled=initial_friction == "pulled")
            simulation.find_rest()
            if change <= _SAME:
                break
        else:
            raise NotConvergedError(Message("truss.friction_changes", part=change))
        # Put the feet of springs as stiff as they are to where they pull as much as the soft ones.
        at = simulation.state
        for n in map(int, np.flatnonzero(at.reaction > 0.0)):
            lies = along_bed(at.x, n, lines), at.x[n, 1]
            at.foot[n] = lies + at.rub[n] / lines.drag_spring[n]
    simulation.lines = lines
    simulation.slip_feet()


def _check_slide(simulation: Simulation) -> None:
    """Refuse a line that lies below its anchor on the slope."""
    at, lines = simulation.state, simulation.lines
    along = at.x[:, 0] * lines.bed_cos + at.x[:, 2] * lines.bed_sin
    way = float(along[0] - along[at.reaction > 0.0].min(initial=along[0]))
    if way > 0.5 * float(lines.length.max()):
        angle = math.degrees(math.asin(lines.bed_sin))
        raise NotConvergedError(Message("truss.slides_down", angle=angle, way=way))


def _draw_out(simulation: Simulation, friction: Array, *, is_pulled: bool) -> float:
    """Draw each spring out to its friction; return the largest change, over the largest tension.

    From the fairlead down. In a line that was pulled friction acts towards the anchor, and takes no
    more than the pull that what is above leaves; in one that was laid it acts the other way.
    """
    at, lines = simulation.state, simulation.lines
    largest, pull = 0.0, math.nan
    for n in range(lines.length.size - 1, -1, -1):
        if at.reaction[n] <= 0.0:
            pull = math.nan
            continue
        if math.isnan(pull):
            pull = at.tension[n]
        below = at.tension[n - 1] if n > 0 else 0.0
        others = along_bed(at.force, n, lines) - at.rub[n, 0] - (at.tension[n] - below)
        most = friction[n] * at.reaction[n]
        rubs = min(max(pull + others, -most), most) if is_pulled else -most
        largest = max(largest, abs(rubs + at.rub[n, 0]))
        at.foot[n] = along_bed(at.x, n, lines) - rubs / lines.drag_spring[n], at.x[n, 1]
        pull = max(pull + others - rubs, 0.0)
    return largest / max(lines.force_scale, float(at.tension.max()))


_LEAST: Final = 1e-14
"""r that is rounding."""


def hanging_part(lift: float, weight: float) -> float:
    """Give the part r of a bar that hangs, from 0 to 1; `lift`, `weight`: V and W, N."""
    if weight <= 0.0 or 2.0 * lift >= weight:
        return 1.0
    return math.sqrt(2.0 * lift / weight) if lift > 0.0 else 0.0


def hanging_node(a: int, contact: Any) -> int:
    """Give the node that hangs of a bar whose other node lies on the bed; -1 for none."""
    if contact[a] == ON_BED and contact[a + 1] == FREE:
        return a + 1
    if contact[a] == FREE and contact[a + 1] == ON_BED:
        return a
    return -1


def share_weight(a: int, hangs: int, rise: float, weight: float, balance: Any) -> None:
    """Shift weight from the hanging node of a bar to the lying one; `rise`: T t_z of it, N."""
    lift = rise if hangs > a else -rise
    shifted = 0.5 * weight * (1.0 - hanging_part(lift, weight)) ** 2
    balance[2 * a + 1 - hangs, 2] -= shifted
    balance[hangs, 2] += shifted


def shift_slope(lift: float, weight: float, left: float) -> float:
    """By how much less weight is shifted as the lift grows: (1 - r)/r, but between two points.

    The square root is followed from the lift there is to the one that ends the imbalance of the
    hanging node, not along its tangent, which is of no use near r = 0. With the shift that node is
    left with W (q - r), where q is the part that has to hang; so what is required is the lift at q.
    r and q go on below 0, as V/W, and above 1, as V/W + 1/2: there nothing more is shifted. `left`:
    upward force left over at the hanging node, N.
    """
    if weight <= 0.0 or 2.0 * lift >= weight:
        return 0.0
    now = lift / weight
    r = math.sqrt(2.0 * now) if now > 0.0 else now
    q = r + left / weight
    if r >= 0.0 and 0.0 <= q <= 1.0:
        return 2.0 / max(r + q, _LEAST) - 1.0
    wanted = q if q < 0.0 else (0.5 * q * q if q <= 1.0 else q - 0.5)
    return (q - r) / (wanted - now) - 1.0 if wanted != now else 0.0


def share_slope(row: int, slope: float, t: Any, across: float, band: Any) -> None:
    """Write the derivatives of `share_weight`; `slope`: of what is shifted (`shift_slope`)."""
    band[row + 3, DIAGONAL - 3] -= slope * t[2]
    band[row - 1, DIAGONAL + 1] += slope * t[2]
    for j in range(3):
        g = slope * across * ((1.0 if j == 2 else 0.0) - t[2] * t[j])
        band[row + 3, DIAGONAL - 2 + j] -= g
        band[row + 3, DIAGONAL - 6 + j] += g
        band[row - 1, DIAGONAL + 2 + j] += g
        band[row - 1, DIAGONAL - 2 + j] -= g


def own_rest(node: int, below: float, above: float, contact: Any) -> float:
    """Weight that keeps lying when a node lifts off, N: half of each bar that lies wholly.

    `below`, `above`: weight of the bars towards the anchor and the fairlead, N.
    """
    rest = 0.0
    if contact[node - 1] == ON_BED:
        rest += 0.5 * max(below, 0.0)
    if contact[node + 1] == ON_BED:
        rest += 0.5 * max(above, 0.0)
    return rest * (1.0 - 1e-9)
