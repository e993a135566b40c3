"""A moored body by both models."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from catopt.fem import Leg as TrussLeg
from catopt.fem import SystemSolution as TrussSystem
from catopt.fem import mesh_line
from catopt.fem import solve_system as solve_truss
from catopt.model import System
from catopt.mooring.solution import SystemSolution
from catopt.mooring.solve import solve_system
from catopt.verify.compared import Compared
from catopt.verify.line import SLACK, Comparing, bends, on_meshes
from catopt.verify.result import LinePair, Mesh, StaticComparison
from catopt.words import Message

_LEAST_OFFSET = 0.01
"""Offset by which positions are measured at least, over the length of the longest line."""


def verify_system(
    system: System, *, elements: int, tolerance: float, name: str = ""
) -> StaticComparison:
    """Solve a moored body by the truss model on three meshes beside its closed form.

    The truss model's body does not turn: where the system's does, it is held in the closed form's
    yaw, and the moment of its lines is compared with the one that yaw balances.
    """
    closed = solve_system(system)
    legs, height = truss_legs(system, closed.position.yaw)
    trusses = on_meshes(
        elements,
        lambda bars: [
            mesh_line(leg.line, bars, bends=bends(each.solution))
            for leg, each in zip(legs, closed.lines, strict=True)
        ],
        lambda meshes: solve_truss(
            legs,
            height=height,
            force=system.force,
            seabed_friction=system.seabed_friction,
            meshes=meshes,
        ),
    )
    count = len(system.legs)
    return StaticComparison(
        name=name,
        kind="system",
        quantities=(
            *_body(system, closed, trusses, tolerance),
            *(each for k in range(count) for each in _line(k, closed, trusses, tolerance)),
        ),
        meshes=tuple(Mesh.of(truss, truss.lines) for truss in trusses),
        lines=tuple(
            LinePair(closed.lines[k].solution, tuple(truss.lines[k] for truss in trusses))
            for k in range(count)
        ),
        tolerance=tolerance,
        remarks=tuple(_remarks(system, closed)),
    )


def truss_legs(system: System, yaw: float) -> tuple[list[TrussLeg], float]:
    """Lay the lines of a system out for the truss model.

    `yaw`: in which the body is held, rad. Returns: the lines, and the height of the body's origin,
    m: that of the first fairlead.
    """
    height = system.legs[0].fairlead_height
    cosine, sine = math.cos(yaw), math.sin(yaw)
    legs = []
    for leg in system.legs:
        x, y = leg.fairlead
        arm = (cosine * x - sine * y, sine * x + cosine * y, leg.fairlead_height - height)
        legs.append(TrussLeg(leg.line, (*leg.anchor, leg.anchor_height), arm))
    return legs, height


def _remarks(system: System, closed: SystemSolution) -> Iterator[str]:
    for k, line in enumerate(closed.lines):
        if line.solution.regime == "slack":
            yield Message("mooring.of_line", number=k + 1, warning=Message(SLACK))
    if system.turns:
        yield Message("truss.held_yaw", yaw=math.degrees(closed.position.yaw))


def _body(
    system: System, closed: SystemSolution, trusses: Sequence[TrussSystem], tolerance: float
) -> Iterator[Compared]:
    longest = max(leg.line.length for leg in system.legs)
    scale = max(math.hypot(*closed.offset), _LEAST_OFFSET * longest)
    exact = (closed.position.x, closed.position.y)
    for axis, key in enumerate(("position_x", "position_y")):
        values = tuple(truss.position[axis] for truss in trusses)
        yield Compared(key, "m", exact[axis], values, scale, tolerance)
    if system.turns:
        arm = max(leg.fairlead_radius for leg in system.legs)
        scale = arm * max(line.fairlead.tension for line in trusses[-1].lines)
        values = tuple(_moment(truss) for truss in trusses)
        yield Compared("moment_of_lines", "Nm", -system.moment, values, scale, tolerance)


def _moment(truss: TrussSystem) -> float:
    """Moment of the lines on the body about the vertical through its origin, N m."""
    total = 0.0
    for line in truss.lines:
        arm = line.nodes[-1, :2] - np.array(truss.position[:2])
        away = line.nodes[0, :2] - line.nodes[-1, :2]
        pull = line.horizontal_force * away / np.hypot(*away)
        total += float(arm[0] * pull[1] - arm[1] * pull[0])
    return total


def _line(
    k: int, closed: SystemSolution, trusses: Sequence[TrussSystem], tolerance: float
) -> Iterator[Compared]:
    lines = [truss.lines[k] for truss in trusses]
    both = Comparing(closed.lines[k].solution, lines, tolerance, k)
    force, length = both.scales
    yield both.of("fairlead_tension", "N", force, "fairlead.tension")
    yield both.of("anchor_tension", "N", force, "anchor.tension")
    yield from both.of_several(force, length)
