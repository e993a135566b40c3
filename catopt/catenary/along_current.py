"""A line in a current, followed along its parts; its equations stand in `in_current`."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import NamedTuple

from catopt.errors import NotConvergedError
from catopt.model import Line
from catopt.words import Message

Vector = tuple[float, float, float]


Flow = Callable[[float], tuple[float, float]]
"""Velocity of the water along x and y, m/s, at a height above the bed, m."""


Slope = tuple[float, float, float, float, float, float, float]
"""Change along the line of the numbers of a `Node` but for its arc length."""

LOCAL = 1e-11
"""Error of a step along the line, as a part of the line's length and of its forces."""


_STEPS = 20_000


class PartInCurrent(NamedTuple):
    """A uniform part of the line, and the point loads on its lower end.

    length (m), submerged weight (N/m), compliance (1/N), 0.5 rho D C across and along (N s2/m3);
    of the loads: weight (N), 0.5 rho Cd A (N s2/m2), Coulomb coefficient.
    """

    length: float
    weight: float
    compliance: float
    across: float
    along: float
    segment: int
    load: float
    load_drag: float
    load_friction: float


class Node(NamedTuple):
    """A place on the line: arc length from the anchor, place from it, force of what is above it.

    `stretched` is the stretched length from the anchor; m and N.
    """

    s: float
    x: float
    y: float
    z: float
    fx: float
    fy: float
    fz: float
    stretched: float

    @property
    def tension(self) -> float:
        """N."""
        return math.sqrt(self.fx * self.fx + self.fy * self.fy + self.fz * self.fz)


def parts_of(line: Line, density: float, friction: float) -> tuple[PartInCurrent, ...]:
    """Cut a line at its segments and point loads, from the anchor up."""
    half, ends, start = 0.5 * density, [0.0], 0.0
    for segment in line.segments:
        start += segment.length
        ends.append(start)
    cuts = sorted({*ends, *(load.position for load in line.point_loads)})
    found = []
    for low, high in pairwise(cuts):
        k = next(k for k in range(len(line.segments)) if high <= ends[k + 1])
        segment = line.segments[k]
        here = [load for load in line.point_loads if load.position == low]
        hold = [friction if each.friction is None else each.friction for each in here]
        area = half * (segment.drag_diameter or 0.0)
        found.append(
            PartInCurrent(
                high - low,
                segment.submerged_weight,
                1.0 / segment.EA,
                area * (segment.drag_normal or 0.0),
                area * (segment.drag_axial or 0.0),
                k,
                math.fsum(each.submerged_weight for each in here),
                half * math.fsum(each.drag_product for each in here),
                max(hold, default=friction),
            )
        )
    return tuple(found)


def along(
    at: Node,
    length: float,
    part: PartInCurrent,
    flow: Flow,
    scales: tuple[float, float],
    longest: float,
) -> tuple[Node, ...]:
    """Follow so much of a part upwards; `scales`: length and force that errors are parts of."""
    nodes, done = [at], 0.0
    stride = min(longest, 0.1 * length)
    slope = _slope(at.z, at.fx, at.fy, at.fz, part, flow)
    for _ in range(_STEPS):
        ahead = length - done
        if not ahead > 0.0:
            return tuple(nodes)
        is_last = stride >= ahead * (1.0 - 1e-12)
        stride = min(stride, ahead)
        there, next_slope, error = _stepped(nodes[-1], slope, stride, part, flow, scales)
        if error > LOCAL:
            stride *= max(0.9 * (LOCAL / error) ** 0.2, 0.1)
            continue
        nodes.append(there)
        slope = next_slope
        done = length if is_last else done + stride
        growth = 0.9 * (LOCAL / error) ** 0.2 if error > 0.0 else 5.0
        stride = min(stride * min(max(growth, 0.2), 5.0), longest)
    raise NotConvergedError(Message("catenary.current_not_converged", part=1.0))


def _stepped(
    at: Node,
    k1: Slope,
    h: float,
    part: PartInCurrent,
    flow: Flow,
    scales: tuple[float, float],
) -> tuple[Node, Slope, float]:
    """Take one step up the line from where it slopes so: the node, its slope, error by the scales.

    Runge and Kutta's method of Dormand and Prince, order 5 (4), J. Comp. Appl. Math. 6 (1980): the
    last slope of a step is the first of the next, and slopes depend on height and force alone.
    """
    _, _, _, z, fx, fy, fz, _ = at
    k2 = _slope(
        z + h * (1 / 5 * k1[2]),
        fx + h * (1 / 5 * k1[3]),
        fy + h * (1 / 5 * k1[4]),
        fz + h * (1 / 5 * k1[5]),
        part,
        flow,
    )
    k3 = _slope(
        z + h * (3 / 40 * k1[2] + 9 / 40 * k2[2]),
        fx + h * (3 / 40 * k1[3] + 9 / 40 * k2[3]),
        fy + h * (3 / 40 * k1[4] + 9 / 40 * k2[4]),
        fz + h * (3 / 40 * k1[5] + 9 / 40 * k2[5]),
        part,
        flow,
    )
    k4 = _slope(
        z + h * (44 / 45 * k1[2] + -56 / 15 * k2[2] + 32 / 9 * k3[2]),
        fx + h * (44 / 45 * k1[3] + -56 / 15 * k2[3] + 32 / 9 * k3[3]),
        fy + h * (44 / 45 * k1[4] + -56 / 15 * k2[4] + 32 / 9 * k3[4]),
        fz + h * (44 / 45 * k1[5] + -56 / 15 * k2[5] + 32 / 9 * k3[5]),
        part,
        flow,
    )
    k5 = _slope(
        z
        + h
        * (
            19372 / 6561 * k1[2] + -25360 / 2187 * k2[2] + 64448 / 6561 * k3[2] + -212 / 729 * k4[2]
        ),
        fx
        + h
        * (
            19372 / 6561 * k1[3] + -25360 / 2187 * k2[3] + 64448 / 6561 * k3[3] + -212 / 729 * k4[3]
        ),
        fy
        + h
        * (
            19372 / 6561 * k1[4] + -25360 / 2187 * k2[4] + 64448 / 6561 * k3[4] + -212 / 729 * k4[4]
        ),
        fz
        + h
        * (
            19372 / 6561 * k1[5] + -25360 / 2187 * k2[5] + 64448 / 6561 * k3[5] + -212 / 729 * k4[5]
        ),
        part,
        flow,
    )
    k6 = _slope(
        z
        + h
        * (
            9017 / 3168 * k1[2]
            + -355 / 33 * k2[2]
            + 46732 / 5247 * k3[2]
            + 49 / 176 * k4[2]
            + -5103 / 18656 * k5[2]
        ),
        fx
        + h
        * (
            9017 / 3168 * k1[3]
            + -355 / 33 * k2[3]
            + 46732 / 5247 * k3[3]
            + 49 / 176 * k4[3]
            + -5103 / 18656 * k5[3]
        ),
        fy
        + h
        * (
            9017 / 3168 * k1[4]
            + -355 / 33 * k2[4]
            + 46732 / 5247 * k3[4]
            + 49 / 176 * k4[4]
            + -5103 / 18656 * k5[4]
        ),
        fz
        + h
        * (
            9017 / 3168 * k1[5]
            + -355 / 33 * k2[5]
            + 46732 / 5247 * k3[5]
            + 49 / 176 * k4[5]
            + -5103 / 18656 * k5[5]
        ),
        part,
        flow,
    )
    new = [
        a + h * (35 / 384 * p + 500 / 1113 * q + 125 / 192 * r - 2187 / 6784 * s + 11 / 84 * t)
        for a, p, q, r, s, t in zip(at[1:], k1, k3, k4, k5, k6, strict=True)
    ]
    _, _, z, fx, fy, fz, _ = new
    k7 = _slope(z, fx, fy, fz, part, flow)
    off = [
        71 / 57600 * p
        - 71 / 16695 * q
        + 71 / 1920 * r
        - 17253 / 339200 * s
        + 22 / 525 * t
        - 1 / 40 * u
        for p, q, r, s, t, u in zip(k1, k3, k4, k5, k6, k7, strict=True)
    ]
    error = max(max(map(abs, off[:3])) / scales[0], max(map(abs, off[3:6])) / scales[1])
    return Node(at.s + h, *new), k7, h * error


def _slope(z: float, fx: float, fy: float, fz: float, part: PartInCurrent, flow: Flow) -> Slope:
    """Say how place, force and stretched length change along the line, going up."""
    T = math.sqrt(fx * fx + fy * fy + fz * fz)
    ex, ey, ez = (fx / T, fy / T, fz / T) if T > 0.0 else (0.0, 0.0, 1.0)
    u, v = flow(z)
    _, weight, compliance, drag_across, drag_along, *_ = part
    along = u * ex + v * ey
    nx, ny, nz = u - along * ex, v - along * ey, -along * ez
    across = drag_across * math.sqrt(nx * nx + ny * ny + nz * nz)
    pull = drag_along * abs(along) * along
    longer = 1.0 + T * compliance
    return (
        longer * ex,
        longer * ey,
        longer * ez,
        -across * nx - pull * ex,
        -across * ny - pull * ey,
        weight - across * nz - pull * ez,
        longer,
    )


def dragged(T: float, length: float, part: PartInCurrent, friction: float) -> tuple[float, float]:
    """Tension at the far end of a part on the bed, and its stretched length."""
    loss = friction * part.weight
    taut = min(length, T / loss) if loss > 0.0 else length
    end = max(T - loss * length, 0.0)
    return end, length + part.compliance * 0.5 * (T + end) * taut


def solved(columns: Sequence[Sequence[float]], sides: Sequence[float]) -> list[float] | None:
    """Solve up to three linear equations with exchange of rows; None where they are singular."""
    size = len(sides)
    rows = [[*(columns[j][i] for j in range(size)), sides[i]] for i in range(size)]
    for j in range(size):
        pivot = max(range(j, size), key=lambda r: abs(rows[r][j]))
        rows[j], rows[pivot] = rows[pivot], rows[j]
        if rows[j][j] == 0.0:
            return None
        for r in range(size):
            if r != j:
                factor = rows[r][j] / rows[j][j]
                rows[r] = [a - factor * b for a, b in zip(rows[r], rows[j], strict=True)]
    return [rows[i][size] / rows[i][i] for i in range(size)]
