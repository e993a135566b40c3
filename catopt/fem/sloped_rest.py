"""A line that comes to rest on a bed that is not level.

From its shape on a level bed it lies down without friction first. Friction is then brought in as
the pull of springs that do not slip and are soft, so that it hardly changes as the line stretches:
each is drawn out to what friction takes there, the lines come to rest again, and so on until no
pull changes.
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from catopt.arrays import Array
from catopt.errors import NotConvergedError
from catopt.fem.seabed import along_bed
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


def settle_on_slope(simulation: Simulation, initial_friction: InitialFriction) -> None:
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
        is_pulled = initial_friction == "pulled"
        for _ in range(_MOST):
            change = _draw_out(simulation, friction, is_pulled=is_pulled)
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
