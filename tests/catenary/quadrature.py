"""The equilibrium of a line checked by quadrature of its differential equations.

Nothing of the closed form is used. From the forces that a solution claims at the fairlead the
hanging part is followed down to the touchdown it claims, by Gauss-Legendre quadrature of

    dx/ds = H/T + H/EA,    dz/ds = V/T + V/EA,    dV/ds = w,

then the part on the bed, where dx/ds = 1 + T/EA and friction takes mu times the bed's reaction off
the tension, then the part between the bed and a raised anchor.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from catopt.catenary.solution import Solution

NODES, WEIGHTS = np.polynomial.legendre.leggauss(30)


@dataclass(frozen=True)
class Part:
    """A uniform part of the line; `load` hangs on its top, `reaction` from the bed."""

    start: float
    end: float
    weight: float
    compliance: float
    load: float
    reaction: float
    on_bed: bool


@dataclass(frozen=True)
class Misfit:
    """How far a solution is from the equilibrium: lengths over L, forces over the largest force."""

    x: float
    z: float
    vertical: float
    horizontal: float
    below_bed: float

    @property
    def worst(self) -> float:
        return max(self.x, self.z, self.vertical, self.horizontal, self.below_bed)


def misfit(solution: Solution) -> Misfit:
    """Follow a solution from its fairlead to its anchor."""
    x, z = solution.span, solution.fairlead_height
    H, V = solution.fairlead.horizontal_force, solution.fairlead.vertical_force
    low = z
    landing = 0.0
    lifted = True
    parts = list(_parts(solution))
    for index in range(len(parts) - 1, -1, -1):
        part = parts[index]
        V -= part.load - part.reaction
        H = max(H - solution.seabed_friction * part.reaction, 0.0)
        if part.on_bed:
            if lifted:
                landing = max(landing, abs(V))
            low = min(low, z)
            V, lifted = 0.0, False
            x -= _on_bed(part, H, solution.seabed_friction)
            H = max(H - solution.seabed_friction * part.weight * (part.end - part.start), 0.0)
        else:
            dx, dz, low_part = _hanging(part, max(H, 1e-12 * abs(solution.anchor.tension)), V)
            x, z, low = x - dx, z - dz, min(low, z - dz + low_part)
            V -= part.weight * (part.end - part.start)
            lifted = True
    force = max(solution.fairlead.tension, abs(solution.line.submerged_weight))
    length = max(solution.line.length, solution.span)
    return Misfit(
        x=abs(x) / length,
        z=abs(z - solution.anchor_height) / length,
        vertical=max(abs(V - solution.anchor.vertical_force), landing) / force,
        horizontal=abs(H - solution.anchor.horizontal_force) / force,
        below_bed=max(0.0, -low / length),
    )


def _parts(solution: Solution) -> Iterator[Part]:
    """Cut the line at joints, point loads and touchdowns."""
    ground = [(s.start, s.start + s.length) for s in solution.stretches if s.on_bed]
    low = min((a for a, _ in ground), default=math.inf)
    high = max((b for _, b in ground), default=-math.inf)
    joints = [0.0]
    for segment in solution.line.segments:
        joints.append(joints[-1] + segment.length)
    positions = [load.position for load in solution.line.point_loads]
    snap = 1e-12 * joints[-1]
    exact = [*joints, *positions]
    touchdowns = [
        m for m in (low, high) if math.isfinite(m) and all(abs(m - p) > snap for p in exact)
    ]
    places = sorted({*exact, *touchdowns})
    for a, b in pairwise(places):
        middle = 0.5 * (a + b)
        index = max(i for i, joint in enumerate(joints[:-1]) if joint <= middle)
        segment = solution.line.segments[index]
        load = reaction = 0.0
        for point, state in zip(solution.line.point_loads, solution.point_loads, strict=True):
            if point.position == b:
                load += point.submerged_weight
                reaction += state.seabed_reaction
        yield Part(
            a, b, segment.submerged_weight, 1.0 / segment.EA, load, reaction, low < middle < high
        )


def _on_bed(part: Part, T: float, friction: float) -> float:
    """Length along x of a part on the bed: the tension falls linearly to 0 and stays there."""
    length = part.end - part.start
    loss = friction * part.weight
    held = length if loss * length <= T else T / loss
    return length + part.compliance * held * (T - 0.5 * loss * held)


def _hanging(part: Part, H: float, V_top: float) -> tuple[float, float, float]:
    """Reach of a hanging part and its lowest point; panels graded towards V = 0."""
    length = part.end - part.start
    V = V_top - part.weight * length
    edges = {0.0, length}
    if part.weight != 0.0:
        centre = -V / part.weight
        edges.add(centre)
        radius = H / abs(part.weight)
        while radius < abs(centre) + length:
            edges |= {centre - radius, centre + radius}
            radius *= 1.5
    cuts = np.array(sorted(e for e in edges if 0.0 <= e <= length))
    half = 0.5 * np.diff(cuts)[:, None]
    s = cuts[:-1, None] + half * (1.0 + NODES)
    v = V + part.weight * s
    T = np.hypot(H, v)
    stretch = 1.0 / T + part.compliance
    dz = ((v * stretch * half) @ WEIGHTS).cumsum()
    dx = ((H * stretch * half) @ WEIGHTS).sum()
    return float(dx), float(dz[-1]), float(min(0.0, dz.min()))
