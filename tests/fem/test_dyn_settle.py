"""A line that hangs free in a current comes to rest where its loads balance, from any start."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from catopt.fem import Fluid, MorisonSection, mesh_line
from catopt.fem.dynamic_model import LineProperties, lay_out_moving
from catopt.fem.moving import BodyNode
from catopt.fem.simulation import Simulation
from catopt.model import Line, Segment
from catopt.waves import Sea, TableCurrent

LENGTH, BARS, TOP, SPEED = 100.0, 100, 150.0, 1.0
D, CN, CT, RHO = 0.038, 2.4, 0.4, 1025.0

STARTS = {
    "hanging": (0.0, -1.0),
    "level, down the current": (1.0, 0.0),
    "level, up the current": (-1.0, 0.0),
    "standing": (0.0, 1.0),
}


def load(angle: float, weight: float) -> tuple[float, float]:
    """Weight and drag per length of a piece that hangs at an angle from the vertical."""
    tx, tz = math.sin(angle), -math.cos(angle)
    along = SPEED * tx
    nx, nz = SPEED - along * tx, -along * tz
    half, normal = 0.5 * RHO * D, math.hypot(nx, nz)
    fx = half * (CN * normal * nx + CT * abs(along) * along * tx)
    fz = half * (CN * normal * nz + CT * abs(along) * along * tz) - weight
    return fx, fz


def hanging_end(weight: float) -> tuple[float, float]:
    """Place of the free end from the upper one: integrated from the free end, inextensible."""

    def off(angle: float) -> float:
        fx, fz = load(angle, weight)
        return fx * math.cos(angle) + fz * math.sin(angle)

    first = brentq(off, 1e-6, math.pi - 1e-6)

    def slope(_: float, y: np.ndarray) -> list[float]:
        angle = math.atan2(y[0], -y[1]) if math.hypot(y[0], y[1]) > 0.0 else first
        return [*load(angle, weight), math.sin(angle), -math.cos(angle)]

    found = solve_ivp(slope, (0.0, LENGTH), [0.0, 0.0, 0.0, 0.0], rtol=1e-9, atol=1e-9)
    return float(found.y[2, -1]), float(found.y[3, -1])


@pytest.mark.slow
@pytest.mark.parametrize("start", list(STARTS))
@pytest.mark.parametrize("weight", [245.0, 10.0])
def test_free_end_in_a_current(weight: float, start: str) -> None:
    line = Line([Segment(LENGTH, weight, EA=5e5 * weight, mass=weight / 9.81 / 0.87)])
    of = LineProperties([MorisonSection(D, CN, CT)], fluid=Fluid(RHO), seabed=None)
    lines = lay_out_moving([mesh_line(line, BARS)], of)
    x = np.zeros((BARS + 1, 3))
    x[:, 0] = STARTS[start][0] * np.linspace(0.0, LENGTH, BARS + 1)
    x[:, 2] = TOP + STARTS[start][1] * np.linspace(0.0, LENGTH, BARS + 1)
    sea = Sea(400.0, None, [TableCurrent([0.0], [SPEED])])
    free = BodyNode(np.ones(3), np.zeros(3), np.zeros(3))
    simulation = Simulation(lines, x, body=free, sea=sea)
    simulation.settle()
    end = simulation.state.x[-1]
    across, down = hanging_end(weight)
    # (1/100)^2 of the line, and its stretch, w L^2/(2 EA) = 1 cm.
    assert (end[0], end[2] - TOP) == pytest.approx((across, down), abs=0.02)
