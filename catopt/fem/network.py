"""Lines between points at rest by the truss model: joints, bodies that do not turn, held ends."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from catopt.arrays import Array, Flags
from catopt.fem.mesh import LineMesh, Problem, Water, build, end_nodes, straight
from catopt.fem.seabed import Bed, RestrainedBed
from catopt.fem.solve import TrussSolution, read_line
from catopt.fem.static_model import Body
from catopt.fem.static_newton import Controls, Rest, bring_to_rest, follow

Vector = tuple[float, float, float]

_LAID_ANEW, _STAYS = 8, 1e-9
"""How often at most; and part of the longest line by which ends then move at most."""
_LEAST_HEIGHT = 1e-3
"""Of the longest line, in which a joint begins above the bed."""


@dataclass(frozen=True)
class LineEnd:
    """One end of a line."""

    place: Vector  # where it is held, m; or how far it is off the point with which it moves
    point: int | None = None  # with which it moves, from 0


@dataclass(frozen=True)
class MeetingPoint:
    """A joint, or the origin of a body that does not turn and keeps its height."""

    force: Vector  # on it, beside the lines, N
    place: Vector | None = None  # of a body: where it begins, m; None: a joint, free to move in all
    # directions, above a bed that carries it


@dataclass(frozen=True)
class NetworkSolution:
    """Lines and the points in which they meet, at rest."""

    places: tuple[Vector, ...]  # of the points, m
    reactions: tuple[float, ...]  # of the bed on them, N
    lines: tuple[TrussSolution, ...]  # each from its first end, its `anchor`
    residual: float  # these three as for `TrussSolution`; points count down from -1
    residual_node: int
    iterations: int
    rest: Rest = field(repr=False, compare=False)


def solve_network(
    meshes: Sequence[LineMesh],
    ends: Sequence[tuple[LineEnd, LineEnd]],
    points: Sequence[MeetingPoint],
    *,
    bed: Bed | RestrainedBed | None = None,
    seabed_friction: float = 0.0,
    controls: Controls | None = None,
) -> NetworkSolution:
    """Bring lines and the points in which they meet to rest, from straight lines.

    `ends`: first and last of each line; `bed`: rigid by default. Friction takes off tension towards
    the first end.

    Raises NotConvergedError with the node or point and the force left over there.
    """
    of_end = np.array([[-1 if e.point is None else e.point for e in pair] for pair in ends])
    off = np.array([[end.place for end in pair] for pair in ends], dtype=float)
    free = np.array([[1.0, 1.0, float(point.place is None)] for point in points]).reshape(-1, 3)
    force = np.array([point.force for point in points], dtype=float).reshape(-1, 3)
    lies = np.array([int(point.place is None) for point in points], dtype=np.int64)
    held = Body(free, force, np.zeros_like(free), of_end.astype(np.int64), lies)
    under = bed or Bed()
    problem = build(meshes, held, under, seabed_friction, Water(), False)
    start = _start(problem, off, points)
    there = off + np.where(of_end[:, :, np.newaxis] >= 0, _at(start, of_end), 0.0)
    place = np.zeros_like(free)
    for p in range(len(points)):
        place[p] = there[of_end == p][0]
    problem = build(meshes, held._replace(place=place), under, seabed_friction, Water(), False)
    rest = bring_to_rest(
        problem, straight(problem, there[:, 0], there[:, 1]), controls or Controls()
    )
    if seabed_friction > 0.0:
        rest = _laid_towards_ends(problem, rest, controls or Controls())
    nodes = np.stack(end_nodes(problem.bars.start), axis=1)
    of_point = [of_end == p for p in range(len(points))]
    return NetworkSolution(
        places=tuple(_vector(rest.state.x[nodes[at][0]] - off[at][0]) for at in of_point),
        reactions=tuple(float(rest.state.reaction[nodes[at]].sum()) for at in of_point),
        lines=tuple(read_line(k, mesh, problem, rest) for k, mesh in enumerate(meshes)),
        residual=rest.residual,
        residual_node=rest.node,
        iterations=rest.iterations,
        rest=rest,
    )


def _laid_towards_ends(problem: Problem, rest: Rest, controls: Controls) -> Rest:
    """Lay lines anew between where their ends have come to rest, until these stay.

    Where friction has used up what pulls at a line, it stays where it lay without friction, which
    is not in line with where its ends have moved since. As laid anew it is in one plane.
    """
    longest = float(np.add.reduceat(problem.bars.length, problem.bars.start[:-1]).max())
    first, last = end_nodes(problem.bars.start)
    for _ in range(_LAID_ANEW):
        before = rest.state.x[np.concatenate([first, last])]
        x = rest.state.x.copy()
        for a, b in zip(first, last, strict=True):
            from_first = x[a : b + 1, :2] - x[a, :2]
            span = float(np.hypot(*from_first[-1]))
            if span > 0.0:
                away = np.hypot(from_first[:, 0], from_first[:, 1])[:, np.newaxis]
                x[a : b + 1, :2] = x[a, :2] + away * from_first[-1] / span
        anew = follow(problem, replace(rest, state=rest.state._replace(x=x)), controls)
        rest = replace(anew, iterations=rest.iterations + anew.iterations)
        if np.abs(rest.state.x[np.concatenate([first, last])] - before).max() <= _STAYS * longest:
            break
    return rest


def _vector(values: Array) -> Vector:
    x, y, z = map(float, values)
    return x, y, z


def _at(places: Array, of_end: Array) -> Array:
    """Place of the point of each end; of no point that of any."""
    if not len(places):
        return np.zeros((*of_end.shape, 3))
    return np.asarray(places[np.maximum(of_end, 0)])


def _start(problem: Problem, off: Array, points: Sequence[MeetingPoint]) -> Array:
    """Place points where they would rest if lines were springs without a length of their own.

    Half of what a line weighs pulls on either end.
    """
    bars, body = problem.bars, problem.body
    places = np.array([point.place or (0.0, 0.0, 0.0) for point in points]).reshape(-1, 3)
    is_free: Flags = body.free > 0.0
    size = len(points)
    matrix, sides = np.zeros((size, size)), body.force.copy()
    longest = 0.0
    for k, (a, b) in enumerate(body.of_end):
        inner = slice(bars.start[k], bars.start[k + 1])
        length = float(bars.length[inner].sum())
        longest = max(longest, length)
        spring, half = problem.soft / length, 0.5 * float(bars.submerged[inner].sum())
        for p, q, own, other in ((a, b, off[k, 0], off[k, 1]), (b, a, off[k, 1], off[k, 0])):
            if p >= 0:
                matrix[p, p] += spring
                sides[p] += spring * (other - own)
                sides[p, 2] -= half
                if q >= 0:
                    matrix[p, q] -= spring
    for i in range(3):
        at, held = np.flatnonzero(is_free[:, i]), np.flatnonzero(~is_free[:, i])
        known = sides[at, i] - matrix[np.ix_(at, held)] @ places[held, i]
        places[at, i] = np.linalg.solve(matrix[np.ix_(at, at)], known)
    joints = body.lies == 1
    places[joints, 2] = np.maximum(places[joints, 2], _LEAST_HEIGHT * longest)
    return places
