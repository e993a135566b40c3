"""Joints and bodies of a network at rest: where the pulls of the lines balance what loads them."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

from catopt.catenary.equilibrium import BY_SPAN
from catopt.catenary.pieces import LineProblem, Pieces, cut
from catopt.catenary.solution import Solution
from catopt.catenary.solve import refusal, solution_of
from catopt.catenary.state import CONVERGED, State
from catopt.errors import CatoptError, FloatsUpError, NoEquilibriumError, NotConvergedError
from catopt.model import Line, Load
from catopt.model.network import MooredBody, Network
from catopt.mooring.net import (
    FORCES,
    FREE,
    GUESS,
    OVER_THE_BED,
    PINNED,
    TURNS,
    Known,
    Net,
    by_end,
    hang,
    problem_of,
    room_for,
    state_of,
    stiffen,
)
from catopt.mooring.rest import TURNS_OVER
from catopt.mooring.under_loads import Under, as_lists, rested
from catopt.words import Message

Vector = tuple[float, float, float]
Matrix = tuple[tuple[float, ...], ...]


class Ends(NamedTuple):
    """A line between two points at rest.

    `first` and `second` are the forces of the line on either point (N), `stiffness` (6 x 6) minus
    the derivatives of both by the places of both points, N/m.
    """

    state: State
    problem: LineProblem
    first: tuple[float, ...]
    second: tuple[float, ...]
    stiffness: Matrix


class Run(NamedTuple):
    """A line as the kernel takes it, with the numbers of its points.

    It runs from an anchor, where it has one; else as it was given.
    """

    name: str
    first: int
    second: int
    line: Line
    pieces: Pieces
    segment_of: tuple[int, ...]


class Pose(NamedTuple):
    """How far a body is moved and turned from where it is given, and is higher; m, m, rad, m."""

    x: float = 0.0
    y: float = 0.0
    yaw: float = 0.0
    rise: float = 0.0


class JointsAtRest(NamedTuple):
    """Lines whose joints have come to rest: x, y and height (m) of every point, ends of every line.

    reactions (N) are those with which the bed carries each point, residual the largest force left
    over at a joint or a body (N), steps those of Newton's method, poses how each free body is moved
    from where it is given, lost what each float loses of its pull upwards because it is out of the
    water (N).
    """

    places: tuple[Vector, ...]
    ends: tuple[Ends, ...]
    reactions: tuple[float, ...]
    residual: float
    steps: int
    poses: tuple[Pose, ...] = ()
    lost: tuple[float, ...] = ()


def runs_of(network: Network) -> tuple[Run, ...]:
    """Lay out the lines of a network, each from its anchor where it has one."""
    runs = []
    for number, given in enumerate(network.lines, start=1):
        line = given.line
        first, second = (network.numbers[end] for end in (given.start, given.end))
        if network.points[second].kind == "anchor" != network.points[first].kind:
            first, second, line = second, first, reversed_line(line)
        runs.append(run_of(given.name or f"{number}", first, second, line))
    return tuple(runs)


def run_of(name: str, first: int, second: int, line: Line) -> Run:
    """Lay out a line from one point to another."""
    return Run(name, first, second, line, *cut(line))


def laid_out(run: Run, ends: Ends) -> Solution:
    """Lay a line at rest out between its points."""
    return solution_of(
        ends.state, run.line, ends.problem, run.segment_of, method="closed-form", known=BY_SPAN
    )


def pulls_of(runs: Iterable[Run], ends: Iterable[Ends]) -> Iterator[tuple[int, tuple[float, ...]]]:
    """Yield for both ends of each line the number of the point there, and the force on it, N."""
    for run, each in zip(runs, ends, strict=True):
        yield run.first, each.first
        yield run.second, each.second


def is_anchored(network: Network, run: Run) -> bool:
    """Whether a line ends at an anchor: its first end then."""
    return network.points[run.first].kind == "anchor"


def friction_of(network: Network, run: Run) -> float:
    """Return the friction of the bed on a line: 0 without an anchor, where it must not lie.

    Which way friction acts on it is open: with it, the forces of what is sought would have no
    energy, and what is refused in the end might not be found.
    """
    return network.site.seabed_friction if is_anchored(network, run) else 0.0


def reversed_line(line: Line) -> Line:
    """Return a line counted from its other end."""
    loads = [replace(load, position=line.length - load.position) for load in line.point_loads]
    return Line(line.segments[::-1], loads)


def joints_at_rest(
    network: Network,
    runs: Sequence[Run],
    held: dict[int, Vector],
    known: JointsAtRest | None = None,
    *,
    pinned: bool = False,
) -> JointsAtRest:
    """Bring the joints and the free bodies of a network to rest, from where they are `known` to be.

    `held` has the place of its anchors and of the fairleads of what is held, m. Bodies that are
    `pinned` stay in x and y where they are known to be, and turn where they are free to.

    Raises NoEquilibriumError where friction leaves open where a joint lies, the lines cannot carry
    the moment on a body, or a line that does not stretch is too short; FloatsUpError; or
    NotConvergedError with the force left over.
    """
    found = _brought_to_rest(network, runs, freed(network, runs, held, known, pinned=pinned))
    check_rest(network, runs, found)
    return found


class Moored(NamedTuple):
    """A free body among the freedoms: x and y, yaw by its longest arm where it turns, and height.

    One that floats is as high as its lowest point is over the bed: at its `level` without lines, m;
    else it keeps its height, at a level of 0. `arms` are those of its fairleads, m.
    """

    body: MooredBody
    arms: Mapping[int, Vector]
    turns: bool
    first: int
    level: float = 0.0

    @property
    def freedoms(self) -> int:
        """How many freedoms it has."""
        return 2 + self.turns + self.body.floats

    @property
    def turn(self) -> int:
        """Which freedom is its yaw; -1: none."""
        return self.first + 2 if self.turns else -1

    @property
    def up(self) -> int:
        """Which freedom is its height; -1: none."""
        return self.first + self.freedoms - 1 if self.body.floats else -1

    def is_on_bed(self, pose: Pose) -> bool:
        """Whether it has sunk so far, or the water fallen, that it lies on the bed."""
        return self.body.floats and self.level + pose.rise <= 0.0

    @property
    def arm(self) -> float:
        """From its origin to the farthest fairlead, m; 1 where there is none off it."""
        return max(math.hypot(x, y) for x, y, _ in self.arms.values()) or 1.0

    def turned(self, yaw: float) -> dict[int, Vector]:
        """Turn its arms; heights are those of the fairleads."""
        c, s = math.cos(yaw), math.sin(yaw)
        return {k: (c * x - s * y, s * x + c * y, z) for k, (x, y, z) in self.arms.items()}

    def places(self, pose: Pose) -> dict[int, Vector]:
        """Place its fairleads, m."""
        x, y = self.body.x + pose.x, self.body.y + pose.y
        return {k: (x + a, y + b, z + pose.rise) for k, (a, b, z) in self.turned(pose.yaw).items()}

    def motions(self, yaw: float) -> dict[int, tuple[int, Matrix]]:
        """Say how each fairlead moves by its freedoms, of which yaw is in m."""
        found = {}
        for k, (a, b, _) in self.turned(yaw).items():
            ways = [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0)]
            ways += [(-b / self.arm, a / self.arm, 0.0)] if self.turns else []
            ways += [(0.0, 0.0, 1.0)] if self.body.floats else []
            found[k] = (self.first, tuple(zip(*ways, strict=True)))
        return found


class Freed(NamedTuple):
    """A network as numbers, with where it is known to be; its joints by number, and its bodies."""

    net: Net
    room: Known
    joints: Sequence[int]
    bodies: Sequence[Moored]


def freed(
    network: Network,
    runs: Sequence[Run],
    held: dict[int, Vector],
    known: JointsAtRest | None,
    *,
    pinned: bool,
) -> Freed:
    """Say by which freedoms a network moves, and where to begin."""
    joints = [k for k, point in enumerate(network.points) if point.kind == "joint"]
    bodies = moored(network, 3 * len(joints))
    poses = (Pose(),) * len(bodies) if known is None else known.poses
    fixed = {**held}
    for body, pose in zip(bodies, poses, strict=True):
        fixed |= body.places(pose)
    places = _start(network, runs, fixed) if known is None else known.places
    net = _net(network, runs, held, joints, bodies, pinned)
    room = room_for(net)
    room.q[:] = [each for k in joints for each in _in_water(network, k, places[k])]
    for body, (x, y, yaw, rise) in zip(bodies, poses, strict=True):
        room.q.extend((x, y, *([yaw * body.arm] if body.turns else [])))
        room.q.extend([max(body.level + rise, 0.0)] if body.body.floats else [])
    for k, ends in enumerate(() if known is None else known.ends):
        _guess(k, ends, room)
    return Freed(net, room, joints, bodies)


def _in_water(network: Network, number: int, place: Vector) -> Vector:
    """Put a joint that would begin below the bed, or a float above the surface, on it."""
    x, y, z = place
    afloat = network.points[number].is_float
    return x, y, max(min(z, network.site.water_depth) if afloat else z, 0.0)


def _brought_to_rest(network: Network, runs: Sequence[Run], of: Freed) -> JointsAtRest:
    if not of.net.pull:
        hung(of.net, of.room, runs)
        return _found(of, Under([CONVERGED, -1, 0], [0.0], [], [], [], []))
    room, under = map(as_lists, rested(of.net, of.room, of.net.pull, 1))
    of = of._replace(room=room)
    _check_found(network, runs, of, under)
    return _found(of, under)


def _net(
    network: Network,
    runs: Sequence[Run],
    held: Mapping[int, Vector],
    joints: Sequence[int],
    bodies: Sequence[Moored],
    pinned: bool,
) -> Net:
    """Say what moves of a network, and by which freedoms."""
    frictions = [friction_of(network, run) for run in runs]
    net = fixed_net(
        runs, [held.get(k, (0.0, 0.0, 0.0)) for k in range(len(network.points))], frictions
    )
    for point in joints:
        net.freedom[4 * point : 4 * point + 3] = range(len(net.pull), len(net.pull) + 3)
        net.pull.extend(network.points[point].hung)
        net.kind.extend((FREE, FREE, OVER_THE_BED))
        net.scale.extend((1.0,) * 3)
        of_joint = network.points[point]
        most = of_joint.lost_above if of_joint.is_float else 0.0
        net.surface.extend((math.inf, math.inf, network.site.water_depth))
        net.buoyancy.extend((0.0, 0.0, most))
        net.height.extend((0.0, 0.0, of_joint.float_height or 0.0))
        net.group.append(len(net.pull))
    for moves in bodies:
        of, first = moves.body, len(net.pull)
        for k, (x, y, height) in moves.arms.items():
            net.base[3 * k : 3 * k + 3] = of.x, of.y, height - moves.level
            net.arm[2 * k : 2 * k + 2] = x, y
            net.freedom[4 * k : 4 * k + 4] = first, first + 1, moves.up, moves.turn
        in_plan, in_yaw = PINNED if pinned else FREE, int(moves.turns)
        net.pull.extend((*of.force, *[of.moment / moves.arm] * in_yaw))
        net.kind.extend((in_plan, in_plan, *[TURNS] * in_yaw))
        net.scale.extend((1.0, 1.0, *[moves.arm] * in_yaw))
        net.surface.extend((math.inf,) * (2 + in_yaw))
        net.buoyancy.extend((0.0,) * (2 + in_yaw))
        net.height.extend((0.0,) * (2 + in_yaw))
        if of.floats:
            _float_body(network, moves, net)
        net.group.append(len(net.pull))
    return net


def _float_body(network: Network, moves: Moored, net: Net) -> None:
    """Let a body float: all of it under water pulls up with its reserve, and loses that above."""
    _, draught, freeboard = moves.body.afloat
    per_metre = network.per_metre(moves.body)
    net.pull.append(per_metre * freeboard)
    net.kind.append(OVER_THE_BED)
    net.scale.append(1.0)
    net.surface.append(moves.level + draught)
    net.buoyancy.append(per_metre * (draught + freeboard))
    net.height.append(draught + freeboard)


def fixed_net(runs: Sequence[Run], places: Sequence[Vector], frictions: Sequence[float]) -> Net:
    """Lay out lines between points of which none moves."""
    piece, columns = [0], Pieces([], [], [], [])
    for run in runs:
        piece.append(piece[-1] + len(run.pieces.length))
        for column, own in zip(columns, run.pieces, strict=True):
            column.extend(own)
    count = len(places)
    return Net(
        used=[len(runs)],
        first=[run.first for run in runs],
        second=[run.second for run in runs],
        piece=piece,
        length=columns.length,
        weight=columns.weight,
        compliance=columns.compliance,
        load=columns.load,
        friction=list(frictions),
        base=[each for place in places for each in place],
        freedom=[-1] * (4 * count),
        arm=[0.0] * (2 * count),
        pull=[],
        scale=[],
        kind=[],
        group=[0],
        surface=[],
        buoyancy=[],
        height=[],
    )


def _guess(k: int, ends: Ends, room: Known) -> None:
    """Seek a line from where it is known near by."""
    state, of = ends.state, ends.problem
    rise = of.fairlead_height - of.anchor_height
    room.guess[GUESS * k : GUESS * (k + 1)] = [
        *(state.H, state.V, state.span, rise),
        *by_end(state, of),
    ]


def hung(net: Net, room: Known, runs: Sequence[Run]) -> Known:
    """Solve lines between their points; an error where one has no answer."""
    status, line = hang(net, room, False)
    if status != CONVERGED:
        raise _refused(status, line, net, room, runs)
    return room


def _refused(status: int, line: int, net: Net, room: Known, runs: Sequence[Run]) -> CatoptError:
    """Say why a line has no answer between its points."""
    problem, (a, b) = problem_of(line, net, room), (net.first[line], net.second[line])
    span = math.dist(*(room.place[3 * k : 3 * k + 2] for k in (a, b)))
    return refusal(status, runs[line].line, Load(span=max(span, 1e-9)), problem)


def ends_of(k: int, net: Net, room: Known) -> Ends:
    """Say what a line that hangs does to its points."""
    stiffen(k, net, room)
    force = tuple(room.force[FORCES * k : FORCES * (k + 1)])
    rows = tuple(tuple(room.block[6 * i : 6 * i + 6]) for i in range(6))
    problem = problem_of(k, net, room)
    return Ends(state_of(k, room), problem, force[:3], force[3:], rows)


def _check_found(network: Network, runs: Sequence[Run], of: Freed, under: Under) -> None:
    """Refuse what found no rest."""
    (status, number, steps), (left,) = under.codes, under.left
    if status == CONVERGED:
        return
    if status == TURNS_OVER:
        (turned,) = (each.body for each in of.bodies if each.turn == number)
        said = Message("mooring.body_turns_over", name=turned.name, moment=turned.moment)
        raise NoEquilibriumError(said, "moment", abs(turned.moment))
    if number >= 0:
        raise _refused(status, number, of.net, of.room, runs)
    if not (any(of.room.held) and network.site.seabed_friction):  # else refused: friction holds it
        force = of.room.force
        largest = max(math.hypot(*force[k : k + 3]) for k in range(0, len(force), 3))
        values = {"left": left, "steps": steps, "part": left / largest}
        raise NotConvergedError(Message("mooring.joints_not_at_rest", **values))


def _found(of: Freed, under: Under) -> JointsAtRest:
    """Say what has come to rest."""
    room = of.room
    places = [tuple(room.place[at : at + 3]) for at in range(0, len(room.place), 3)]
    reactions, lost = [0.0] * len(places), [0.0] * len(places)
    for k, point in enumerate(of.joints):
        reactions[point], lost[point] = room.laid[3 * k + 2], room.lost[3 * k + 2]
    poses = tuple(pose_of(body, room.q) for body in of.bodies)
    ends = tuple(ends_of(k, of.net, room) for k in range(len(of.net.first)))
    left, steps = float(under.left[0]), int(under.codes[2])
    return JointsAtRest(tuple(places), ends, tuple(reactions), left, steps, poses, tuple(lost))


def pose_of(body: Moored, q: Sequence[float]) -> Pose:
    """Say how far a body is moved and turned from where it is given."""
    yaw = q[body.turn] / body.arm if body.turns else 0.0
    rise = q[body.up] - body.level if body.body.floats else 0.0
    return Pose(q[body.first], q[body.first + 1], yaw, rise)


def moored(network: Network, first: int) -> tuple[Moored, ...]:
    """Lay out the free bodies of a network after so many freedoms of its joints."""
    found: list[Moored] = []
    for body in network.bodies:
        arms, level = network.arms_of(body), 0.0
        if body.floats:
            bottom = network.site.water_depth - body.afloat[1]
            level = min(bottom, *(height for _, _, height in arms.values()))
        found.append(Moored(body, arms, network.turns(body), first, level))
        first += found[-1].freedoms
    return tuple(found)


def by_turning(runs: Sequence[Run], ends: Sequence[Ends], body: Moored, yaw: float) -> float:
    """Return what the pulls on a body add to its stiffness in yaw as its arms turn, N m."""
    arms = body.turned(yaw)
    return math.fsum(
        arms[point][i] * force[i]
        for point, force in pulls_of(runs, ends)
        if point in arms
        for i in (0, 1)
    )


UNIT: Matrix = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


def solved(run: Run, at: Mapping[int, Vector], friction: float, known: Ends) -> Ends:
    """Solve a line between its points from near by; an error where it has no answer."""
    alone = run._replace(first=0, second=1)
    net = fixed_net([alone], [at[run.first], at[run.second]], [friction])
    room = room_for(net)
    _guess(0, known, room)
    return ends_of(0, net, hung(net, room, [alone]))


def assembled(
    runs: Sequence[Run], ends: Sequence[Ends], motions: Mapping[int, tuple[int, Matrix]], size: int
) -> list[list[float]]:
    """Sum the stiffness of lines over the freedoms of their points.

    `motions`: of a point its first freedom, and how it moves by that and those after it (3 rows).
    """
    total = [[0.0] * size for _ in range(size)]
    for run, each in zip(runs, ends, strict=True):
        points = (run.first, run.second)
        for k, p in enumerate(points):
            for m, q in enumerate(points):
                if p not in motions or q not in motions:
                    continue
                (row, by_p), (column, by_q) = motions[p], motions[q]
                own = [line[3 * m : 3 * m + 3] for line in each.stiffness[3 * k : 3 * k + 3]]
                half = product(own, by_q)
                for i, values in enumerate(product(tuple(zip(*by_p, strict=True)), half)):
                    for j, value in enumerate(values):
                        total[row + i][column + j] += value
    return total


def product(a: Sequence[Sequence[float]], b: Sequence[Sequence[float]]) -> Matrix:
    """Multiply two matrices."""
    columns = tuple(zip(*b, strict=True))
    return tuple(
        tuple(sum(map(float.__mul__, row, each)) for each in columns) for row in map(tuple, a)
    )


def solve(matrix: Sequence[Sequence[float]], sides: Sequence[Sequence[float]]) -> list[list[float]]:
    """Solve linear equations for several right hand sides (columns), with exchange of rows."""
    size = len(matrix)
    rows = [[*row, *side] for row, side in zip(matrix, sides, strict=True)]
    for j in range(size):
        pivot = max(range(j, size), key=lambda r: abs(rows[r][j]))
        rows[j], rows[pivot] = rows[pivot], rows[j]
        for r in range(j + 1, size):
            if factor := rows[r][j] / rows[j][j]:
                rows[r] = [a - factor * b for a, b in zip(rows[r], rows[j], strict=True)]
    for j in reversed(range(size)):
        rows[j] = [each / rows[j][j] for each in rows[j]]
        for r in range(j):
            if factor := rows[r][j]:
                rows[r] = [a - factor * b for a, b in zip(rows[r], rows[j], strict=True)]
    return [row[size:] for row in rows]


def _start(network: Network, runs: Sequence[Run], held: dict[int, Vector]) -> list[Vector]:
    """Put joints where lines would hold them that are springs without a length of their own.

    What ends one line alone stands off by its length, the way it is pulled.
    """
    joints = [k for k in range(len(network.points)) if k not in held]
    order = {point: k for k, point in enumerate(joints)}
    matrix = [[0.0] * len(joints) for _ in joints]
    sides = [[0.0] * 3 for _ in joints]
    for run in runs:
        stiffness = 1.0 / run.line.length
        for p, q in ((run.first, run.second), (run.second, run.first)):
            if p in order:
                row = order[p]
                matrix[row][row] += stiffness
                if q in order:
                    matrix[row][order[q]] -= stiffness
                else:
                    sides[row] = [
                        a + stiffness * b for a, b in zip(sides[row], held[q], strict=True)
                    ]
    for k, point in enumerate(joints):
        if sum(point in (run.first, run.second) for run in runs) == 1:
            hung = network.points[point].hung
            if not any(hung):  # a free end is pulled by its line
                (own,) = (run.line for run in runs if point in (run.first, run.second))
                hung = (0.0, 0.0, -own.submerged_weight)
            pull = math.hypot(*hung) or 1.0
            sides[k] = [side + force / pull for side, force in zip(sides[k], hung, strict=True)]
    found = zip(joints, solve(matrix, sides), strict=True)
    places = held | {point: (x, y, z) for point, (x, y, z) in found}
    return [places[k] for k in range(len(network.points))]


def check_rest(network: Network, runs: Sequence[Run], found: JointsAtRest) -> None:
    """Refuse what lies where friction leaves it open, and floats lifted out of the water."""
    site = network.site
    for body, pose in zip(moored(network, 0), found.poses, strict=True):
        if site.seabed_friction > 0.0 and body.is_on_bed(pose):
            said = Message("mooring.body_on_bed", name=body.body.name)
            raise NoEquilibriumError(said, "force", 0.0)
    for point, reaction in zip(network.points, found.reactions, strict=True):
        if reaction > 0.0 and site.seabed_friction > 0.0:
            said = Message("mooring.joint_on_bed", name=point.name, reaction=reaction)
            raise NoEquilibriumError(said, "force", reaction)
    for point, place in zip(network.points, found.places, strict=True):
        above = place[2] - site.water_depth
        if point.is_float and point.mass is None and above > 0.0:
            raise FloatsUpError(Message("mooring.float_lifted", name=point.name, above=above))
    for run, each in zip(runs, found.ends, strict=True):
        length = each.state.grounded if each.state.H > 0.0 else 0.0  # what is slack does not rub
        if length > 0.0 and site.seabed_friction > 0.0 and not is_anchored(network, run):
            said = Message("mooring.drags_both_ways", number=run.name, length=length)
            raise NoEquilibriumError(said, "force", length)
