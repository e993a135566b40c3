"""Plain lines for tests of motion: strings, chains and pendulums without water."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from catopt.fem import mesh_line
from catopt.fem.dynamic_model import Fluid, LineProperties, MassMatrix, lay_out_moving
from catopt.fem.moving import BodyNode
from catopt.fem.newmark import LineDamping, Scheme
from catopt.fem.run_settings import TimeStepping
from catopt.fem.sampling import Record
from catopt.fem.simulation import Simulation
from catopt.model import Line, Segment

Array = npt.NDArray[np.float64]

G = 9.81
FREE = np.ones(3)


def plain_simulation(
    ends: tuple[Any, Any],
    length: float,
    elements: int,
    *,
    EA: float,
    mass: float = 1.0,
    weight: float = 0.0,
    mass_matrix: MassMatrix = "consistent",
    pushes: bool = False,
    body: BodyNode | None = None,
    damping: LineDamping | None = None,
) -> Simulation:
    """Lay out a straight line between two points, without water or bed; the second end may move."""
    line = Line([Segment(length, weight, EA=EA, mass=mass)])
    of = LineProperties(None, damping or LineDamping(), Fluid(1025.0, G), None, mass_matrix)
    lines = lay_out_moving([mesh_line(line, elements)], of)._replace(pushes=pushes)
    part = np.linspace(0.0, 1.0, elements + 1)[:, np.newaxis]
    x = (1.0 - part) * np.asarray(ends[0], float) + part * np.asarray(ends[1], float)
    return Simulation(lines, x) if body is None else Simulation(lines, x, body=body)


def run(
    simulation: Simulation,
    samples: int,
    every: int,
    step: float,
    *,
    scheme: Scheme | None = None,
    since: float = 0.0,
    **asked: Any,
) -> Record:
    """Step to so many samples after the first, by average acceleration unless asked otherwise."""
    interval, scheme = every * step, scheme or Scheme.average_acceleration()
    stepping = TimeStepping(
        samples * interval, step, output_interval=interval, since=since, scheme=scheme, **asked
    )
    record, is_complete = simulation.run(stepping)
    assert is_complete
    return record


def free_body(mass: float = 0.0) -> BodyNode:
    """Give an end that nothing holds, with a mass of its own."""
    return BodyNode(FREE.copy(), np.full(3, mass), np.zeros(3))


def orders(errors: Any) -> Array:
    """Observed order of errors of which each has half the step of the one before."""
    values = np.abs(np.asarray(errors, dtype=float))
    result: Array = np.log2(values[:-1] / values[1:])
    return result
