"""Lines at rest by the truss model: one line, or several that meet in a body."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from catopt.arrays import Array
from catopt.errors import NoEquilibriumError
from catopt.fem.mesh import LineMesh, end_nodes, mesh_line
from catopt.fem.problem import Problem, Water, build, one_point, straight
from catopt.fem.result import SystemSolution, TrussSolution, read_line
from catopt.fem.seabed import Bed, HeldBed, friction_sense
from catopt.fem.settle import Controls, Rest, follow, settle
from catopt.model import Line
from catopt.model.kinds import Findings
from catopt.words import Message


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
    bed: Bed | HeldBed | None = None,
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
    bed : Bed or HeldBed, optional
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
    bed: Bed | HeldBed | None = None,
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
    return settle(problem, straight(problem, *ends), controls or Controls())


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
