"""Lines at rest by the truss model, one or several that meet in a body, and what it found."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from catopt.arrays import Array, Flags
from catopt.errors import NoEquilibriumError
from catopt.fem.mesh import (
    LineMesh,
    Problem,
    Water,
    build,
    end_nodes,
    mesh_line,
    one_point,
    straight,
)
from catopt.fem.seabed import ABSENT, HELD, ON_BED, Bed, RestrainedBed, friction_sense
from catopt.fem.sloped_rest import hanging_part
from catopt.fem.static_newton import Controls, Rest, bring_to_rest, follow
from catopt.model import Line
from catopt.model.kinds import Findings
from catopt.words import Message

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
    # where a `RestrainedBed` holds a node down
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


@dataclass(frozen=True)
class Leg:
    """One line of a system."""

    line: Line  # from its anchor to the body
    anchor: tuple[float, float, float]  # x, y and z, m
    fairlead: tuple[float, float, float] = (0.0, 0.0, 0.0)  # m, from the origin of
    # the body, which does not turn


def solve_line(
    line: Line,
    *,
    height: float,
    horizontal_force: float | None = None,
    span: float | None = None,
    seabed_friction: float = 0.0,
    anchor_height: float = 0.0,
    elements: int | Sequence[int] = 100,
    mesh: LineMesh | None = None,
    bed: Bed | RestrainedBed | None = None,
    water: Water | None = None,
    carries_compression: bool = False,
    controls: Controls | None = None,
    start: TrussSolution | None = None,
) -> TrussSolution:
    """Bring one line to rest, from straight.

    Parameters
    ----------
    height, anchor_height : float
        Of the fairlead and of the anchor above the seabed, m.
    horizontal_force, span : float, optional
        One of them: the force that pulls the fairlead, which is held in height and free along x,
        N; or where the fairlead is held, m from the anchor.
    seabed_friction : float
        Coulomb coefficient.
    elements, mesh
        Bars, as for `mesh_line`; or the line cut into them.
    bed : Bed or RestrainedBed, optional
        The seabed; a rigid one that only pushes by default.
    water : Water, optional
        Surface and current; all submerged in still water by default.
    carries_compression : bool
        Whether a bar pushes when it is shorter than its length.
    start : TrussSolution, optional
        Of the same mesh under another force or span, from which to go on; friction with a history
        starts from its springs.

    Raises
    ------
    InputError
        When the arguments do not fit.
    NoEquilibriumError
        When the line does not stretch and is too short.
    NotConvergedError
        With the node and the force left over there.
    """
    _check_line(line, height, horizontal_force, span, seabed_friction, anchor_height)
    _check_water([line], water)
    cut = mesh or mesh_line(line, elements)
    rise = height - anchor_height
    _check_length(line, math.hypot(span or 0.0, rise))
    free_span = math.sqrt(max(line.length**2 - rise**2, 0.01 * line.length**2))
    fairlead = np.array([span if span is not None else free_span, 0.0, height])
    free = np.array([1.0 if span is None else 0.0, 0.0, 0.0])
    body = one_point(free, np.array([horizontal_force or 0.0, 0.0, 0.0]), fairlead, lines=1)
    ends = np.array([[[0.0, 0.0, anchor_height]], [fairlead]])
    under = (bed or Bed(), seabed_friction, water or Water(), carries_compression)
    problem = build([cut], body, *under)
    if height == 0.0:
        # Half of the last bar lies at the fairlead, where its friction takes part of the force.
        rubs = friction_sense(problem.ground.law) * seabed_friction
        rubbed = rubs * 0.5 * max(float(problem.bars.submerged[-1]), 0.0)
        less = body._replace(force=body.force - [rubbed, 0.0, 0.0])
        problem = replace(problem, body=less)
    rest = _at_rest(problem, ends, controls, start)
    return read_line(0, cut, problem, rest)


def solve_system(
    legs: Sequence[Leg],
    *,
    height: float,
    force: tuple[float, float] | None = None,
    position: tuple[float, float] | None = None,
    seabed_friction: float = 0.0,
    elements: int | Sequence[int] = 100,
    meshes: Sequence[LineMesh] | None = None,
    bed: Bed | RestrainedBed | None = None,
    water: Water | None = None,
    carries_compression: bool = False,
    controls: Controls | None = None,
    start: SystemSolution | None = None,
) -> SystemSolution:
    """Bring several lines and the body in which they meet to rest, from straight.

    Parameters
    ----------
    height : float
        Of the body's origin above the seabed, m; held.
    force, position : tuple of float, optional
        One of them: force on the body along x and y, N, under which it moves; or where its origin
        is held, m.
    seabed_friction, elements, bed, water, carries_compression, controls
        As for `solve_line`, for every line; the current's sections are shared by all.
    meshes : sequence of LineMesh, optional
        Instead of `elements`.
    start : SystemSolution, optional
        Of the same meshes under another force or position, from which to go on.

    Raises as `solve_line`.
    """
    _check_system(legs, height, force, position, seabed_friction)
    _check_water([leg.line for leg in legs], water)
    cuts = [mesh_line(leg.line, elements) for leg in legs] if meshes is None else list(meshes)
    origin = np.array([*(position or (0.0, 0.0)), height])
    anchors = np.array([leg.anchor for leg in legs], dtype=float)
    offsets = np.array([leg.fairlead for leg in legs], dtype=float)
    for number, leg in enumerate(legs):
        reach = origin + offsets[number] - anchors[number]
        distance = float(np.linalg.norm(reach if position is not None else reach[2:]))
        _check_length(leg.line, distance, number + 1)
    is_free = 1.0 if position is None else 0.0
    free = np.array([is_free, is_free, 0.0])
    pull = np.array([*(force or (0.0, 0.0)), 0.0])
    body = one_point(free, pull, origin + offsets[0], lines=len(legs))
    under = (bed or Bed(), seabed_friction, water or Water(), carries_compression)
    problem = build(cuts, body, *under)
    rest = _at_rest(problem, np.stack([anchors, origin + offsets]), controls, start)
    _, ends = end_nodes(problem.bars.start)
    x, y, z = map(float, rest.state.x[ends[0]] - offsets[0])
    X, Y, Z = map(float, rest.state.balance[ends].sum(axis=0))
    return SystemSolution(
        position=(x, y, z),
        lines=tuple(read_line(k, cut, problem, rest) for k, cut in enumerate(cuts)),
        force=(X, Y, Z),
        residual=rest.residual,
        residual_node=rest.node,
        iterations=rest.iterations,
        rest=rest,
    )


def _at_rest(
    problem: Problem,
    ends: Array,
    controls: Controls | None,
    start: TrussSolution | SystemSolution | None,
) -> Rest:
    """Go on from a solution, or start from lines straight between their ends, (2, lines, 3), m."""
    if start is not None:
        return follow(problem, start.rest, controls or Controls())
    return bring_to_rest(problem, straight(problem, *ends), controls or Controls())


def _check_line(
    line: Line,
    height: float,
    horizontal_force: float | None,
    span: float | None,
    friction: float,
    anchor_height: float,
) -> None:
    found = Findings("solve_line")
    found.number("height", height, "m", at_least=0.0)
    found.number("anchor_height", anchor_height, "m", at_least=0.0)
    found.number("seabed_friction", friction, "", at_least=0.0)
    if (horizontal_force is None) == (span is None):
        given = Message("refused_motion.neither" if span is None else "refused_motion.both")
        found.add("load", given, Message("refused.exactly_one", ways="horizontal_force and span"))
    if horizontal_force is not None:
        found.number("horizontal_force", horizontal_force, "N", above=0.0)
    if span is not None:
        found.number("span", span, "m", at_least=0.0)
        if span == 0.0 and line.length > height - anchor_height:
            found.add("span", "0 m", Message("refused_motion.above_0_bars_line_slack"))
    found.raise_if_any()


def _check_system(
    legs: Sequence[Leg],
    height: float,
    force: tuple[float, float] | None,
    position: tuple[float, float] | None,
    friction: float,
) -> None:
    found = Findings("solve_system")
    found.number("height", height, "m", at_least=0.0)
    found.number("seabed_friction", friction, "", at_least=0.0)
    if not legs:
        allowed = Message("refused_motion.system_has_at_least_one")
        found.add("legs", Message("refused.none"), allowed)
    if (force is None) == (position is None):
        given = Message("refused_motion.neither" if force is None else "refused_motion.both")
        found.add("load", given, Message("refused.exactly_one", ways="force and position"))
    for name, pair in (("force", force), ("position", position)):
        for axis, value in zip("xy", pair or (), strict=False):
            found.number(f"{name}.{axis}", value, "N" if name == "force" else "m")
    found.raise_if_any()


def _check_water(lines: Sequence[Line], water: Water | None) -> None:
    """See to it that every segment has the mass or the drag that the water asks for."""
    found = Findings("Water")
    if water is not None and math.isfinite(water.surface):
        for i, line in enumerate(lines):
            for j, segment in enumerate(line.segments):
                if segment.mass is None:
                    key = f"lines[{i}].segments[{j}].mass"
                    found.add(key, "", Message("refused_motion.needed_weight_air_above_surface"))
    if water is not None and water.current is not None:
        count = len(water.current.sections)
        if any(len(line.segments) != count for line in lines):
            allowed = Message("refused_motion.one_wanted_each_segment_line")
            found.add("current.sections", str(count), allowed)
    found.raise_if_any()


def _check_length(line: Line, distance: float, number: int | None = None) -> None:
    """Refuse a line that does not stretch and is no longer than the distance between its ends."""
    if all(segment.is_inextensible for segment in line.segments) and line.length <= distance:
        missing = distance - line.length
        key = "truss.too_short" if number is None else "truss.line_too_short"
        values = {"number": number, "length": line.length, "distance": distance}
        said = Message(key, **values, missing=missing)
        raise NoEquilibriumError(said, "length", missing)
