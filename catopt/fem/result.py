"""What the truss model found, as values: forces at ends, joints and touchdowns, off a state."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace

import numpy as np

from catopt.arrays import Array, Flags
from catopt.fem.mesh import LineMesh
from catopt.fem.problem import Problem
from catopt.fem.seabed import ABSENT, HELD, ON_BED, friction_sense
from catopt.fem.settle import Rest
from catopt.fem.sloped_rest import hanging_part
from catopt.model import Line

_NO_TENSION = 1e-9
"""Tension that is rounding, over the largest one."""


@dataclass(frozen=True)
class EndForce:
    """Force between the line and what holds its end: the balance of the end node, not a bar's."""

    tension: float  # N
    horizontal_force: float  # N
    vertical_force: float  # N; positive where the line rises towards the fairlead (at the anchor:
    # where the line pulls the anchor up)
    angle: float  # above the horizontal, rad


@dataclass(frozen=True)
class TrussSolution:
    """One line at rest."""

    mesh: LineMesh  # how the line was cut
    nodes: Array  # (elements + 1, 3): coordinates from the anchor to the fairlead, m
    tension: Array  # (elements,): of each bar, N: that of the line at the bar's middle
    fairlead: EndForce  # nodal reactions
    anchor: EndForce  # after seabed friction
    span: float  # horizontal distance between the ends, m
    lying: Array  # (elements,): part of each bar that lies on the bed; where one touches down
    # follows from the reaction of its node
    bed_reaction: Array  # (elements + 1,): upward force of the bed on each node, N; below 0 only
    # where a `HeldBed` holds a node down
    penetration: float  # largest depth of a node below the bed, m
    residual: float  # largest force left over at an inner node of all lines, over the largest
    # tension
    residual_node: int  # where, counted over all lines; -1 for the body
    iterations: int  # of Newton's method, from the start
    end_tension: Array  # (elements, 2): of the line at both ends of each bar, N, by the balance of
    # half a bar
    rest: Rest = field(repr=False, compare=False)  # whole state, for `start=` of a later solution

    @property
    def horizontal_force(self) -> float:
        """Horizontal force at the fairlead, N."""
        return self.fairlead.horizontal_force

    @property
    def grounded_length(self) -> float:
        """Length on the bed, unstretched, m."""
        return math.fsum(self.mesh.length * self.lying)

    @property
    def arc(self) -> Array:
        """Unstretched arc length of the nodes, m, shape (elements + 1,)."""
        return self.mesh.arc

    @property
    def touchdowns(self) -> int:
        """Number of separate stretches of nodes on the bed, ends not counted."""
        lies = self.bed_reaction[1:-1] > 0.0
        return int(np.count_nonzero(lies[1:] & ~lies[:-1]) + (lies.size > 0 and lies[0]))

    def segment_max_tension(self) -> Array:
        """Largest tension in each segment, N: at the ends of its bars, by the nodes' balance."""
        largest = np.zeros(len(self.mesh.line.segments))
        np.maximum.at(largest, self.mesh.segment, self.end_tension.max(axis=1))
        return largest

    def point_load_reaction(self) -> Array:
        """Return what the bed carries at each point load beyond the line's own weight there, N."""
        node = self.mesh.load_node
        weight = np.array([s.submerged_weight for s in self.mesh.line.segments])
        half = 0.5 * weight[self.mesh.segment] * self.mesh.length
        own = np.maximum(half[node - 1] + half[node], 0.0)
        return np.asarray(np.maximum(self.bed_reaction[node] - own, 0.0))


@dataclass(frozen=True)
class SystemSolution:
    """Several lines and the body in which they meet, at rest."""

    position: tuple[float, float, float]  # of the body's origin, x, y and z, m
    lines: tuple[TrussSolution, ...]  # in the order given
    force: tuple[float, float, float]  # of all lines on the body, N
    residual: float  # these three as for `TrussSolution`
    residual_node: int
    iterations: int
    rest: Rest = field(repr=False, compare=False)  # whole state, for `start=` of a later solution


def read_line(index: int, mesh: LineMesh, problem: Problem, rest: Rest) -> TrussSolution:
    """Solution of one of the lines of a state at rest."""
    first, end = problem.bars.start[index], problem.bars.start[index + 1]
    bars, at = slice(first, end), slice(first + index, end + index + 1)
    state = rest.state
    x, T, half = state.x[at], state.tension[bars], rest.half_loads[bars]
    reaction = state.reaction[at].copy()
    pull = state.balance[at]
    anchor, reaction[0] = _end(pull[0], x[0], x[1] - x[0], problem, -1.0)
    fairlead, reaction[-1] = _end(pull[-1], x[-1], x[-2] - x[-1], problem, 1.0)
    lies = (state.contact[at] == ON_BED) | (state.contact[at] == HELD)
    d = np.diff(x, axis=0)
    size = np.linalg.norm(d, axis=1)
    size = np.where(size > 0.0, size, 1.0)
    part = _hanging_parts(T * d[:, 2] / size, half, lies)
    friction = friction_sense(problem.ground.law) * problem.ground.bed_friction
    return TrussSolution(
        mesh=mesh,
        nodes=x.copy(),
        tension=T.copy(),
        fairlead=fairlead,
        anchor=anchor,
        span=math.hypot(*(x[-1, :2] - x[0, :2])),
        lying=1.0 - part,
        bed_reaction=reaction,
        penetration=float(max(-x[:, 2].min(), 0.0)),
        residual=rest.residual,
        residual_node=rest.node,
        iterations=rest.iterations,
        end_tension=_end_tension(d / size[:, np.newaxis], T, half, lies, part, friction),
        rest=rest,
    )


def part_of(whole: TrussSolution, line: Line, start: float, *, turned: bool) -> TrussSolution:
    """Return a part of a line at rest as one of its own, from the arc length `start` on, m.

    `turned`: whether `line` is counted from the other end. Its ends are joints of the mesh.
    """
    mesh = whole.mesh
    first, last = (mesh.nearest(at) for at in (start, start + line.length))
    bars, nodes = slice(first, last), slice(first, last + 1)
    kept = [k for k, at in enumerate(mesh.joints) if first <= mesh.nearest(at) <= last]
    joints = tuple(mesh.joints[k] - mesh.arc[first] for k in kept)
    counts = tuple(mesh.counts[k] for k in kept[:-1])
    x, ends = whole.nodes[nodes], whole.end_tension[bars]
    part = replace(
        whole,
        mesh=LineMesh(line, joints, counts),
        nodes=x,
        tension=whole.tension[bars],
        anchor=whole.anchor if first == 0 else _cut(whole, first, 0),
        fairlead=whole.fairlead if last == mesh.elements else _cut(whole, last - 1, 1),
        span=math.hypot(*(x[-1, :2] - x[0, :2])),
        lying=whole.lying[bars],
        bed_reaction=whole.bed_reaction[nodes],
        penetration=float(max(-x[:, 2].min(), 0.0)),
        end_tension=ends,
    )
    if not turned:
        return part
    length = joints[-1]
    return replace(
        part,
        mesh=LineMesh(line, tuple(length - at for at in reversed(joints)), counts[::-1]),
        nodes=x[::-1],
        tension=part.tension[::-1],
        anchor=_turned(part.fairlead),
        fairlead=_turned(part.anchor),
        lying=part.lying[::-1],
        bed_reaction=part.bed_reaction[::-1],
        end_tension=ends[::-1, ::-1],
    )


def _cut(whole: TrussSolution, bar: int, side: int) -> EndForce:
    """Force in a line at the first (0) or the second end of a bar."""
    mesh = whole.mesh
    d = whole.nodes[bar + 1] - whole.nodes[bar]
    force = whole.tension[bar] * d / max(float(np.linalg.norm(d)), 1e-300)
    weight = mesh.line.segments[mesh.segment[bar]].submerged_weight * mesh.length[bar]
    size = float(whole.end_tension[bar, side])
    vertical = float(force[2]) + (side - 0.5) * weight
    if whole.lying[bar] > 0.0 and whole.bed_reaction[bar + side] > 0.0:
        vertical = 0.0
    level = math.sqrt(max(size * size - vertical * vertical, 0.0))
    return EndForce(size, level, vertical, math.atan2(vertical, level))


def _turned(end: EndForce) -> EndForce:
    return replace(end, vertical_force=-end.vertical_force, angle=-end.angle)


def _end(
    pull: Array, x: Array, inwards: Array, problem: Problem, side: float
) -> tuple[EndForce, float]:
    """Force on the support of an end node, and what the bed takes of it when it lies there.

    Friction of the half bar there takes something off the pull on an anchor (`side` -1) and adds
    it to what the fairlead (1) has to pull.
    """
    up = float(pull[2])
    level = float(np.hypot(pull[0], pull[1]))
    if float(pull[:2] @ inwards[:2]) < 0.0:
        level = -level
    reaction = 0.0
    has_bed = problem.contact[0] not in (HELD, ABSENT)
    if has_bed and x[2] <= 0.0 and up < 0.0:
        reaction, up = -up, 0.0
        rubs = friction_sense(problem.ground.law) * problem.ground.bed_friction
        level = max(level + side * rubs * reaction, 0.0)
    # The line rises towards the fairlead where it pulls the anchor up and the fairlead down.
    vertical = 0.0 - side * up
    angle = math.atan2(vertical, level) if vertical != 0.0 or level != 0.0 else 0.0
    return EndForce(math.hypot(level, vertical), level, vertical, angle), reaction


def _hanging_parts(rise: Array, half: Array, lies: Flags) -> Array:
    """Part of each bar that hangs, from 0 to 1 (`hanging_part`); `rise`: T t_z, N."""
    part = np.where(lies[:-1] & lies[1:], 0.0, 1.0)
    for e in np.flatnonzero(lies[:-1] ^ lies[1:]):
        lift = float(rise[e] if lies[e] else -rise[e])
        part[e] = hanging_part(lift, float(-2.0 * half[e, 2]))
    return part


def _end_tension(
    axis: Array, T: Array, half: Array, lies: Flags, part: Array, friction: float
) -> Array:
    """Tension of the line at both ends of each bar, N: by the balance of half a bar that hangs.

    Where a bar ends on the bed the line is level there, and friction has taken mu W/2, or mu W
    (1 - r) of a bar that lies in part. Where friction has used up the tension there is none left.
    """
    level = T * np.hypot(axis[:, 0], axis[:, 1])
    weight = -2.0 * half[:, 2]
    rubs = np.where(T > _NO_TENSION * T.max(), friction * weight, 0.0)
    in_part = lies[:-1] ^ lies[1:]
    ends = []
    for side, on_bed in ((1.0, lies[:-1]), (-1.0, lies[1:])):
        force = T[:, np.newaxis] * axis + side * half
        hanging = np.linalg.norm(force, axis=1)
        beside = np.hypot(level, weight * part)
        lying = level - side * rubs * np.where(in_part, 1.0 - part, 0.5)
        touching = in_part & (part < 1.0)
        ends.append(np.where(on_bed & (part < 1.0), lying, np.where(touching, beside, hanging)))
    return np.asarray(np.maximum(np.stack(ends, axis=1), 0.0))
