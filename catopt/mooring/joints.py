"""Joints and bodies of a network at rest: where the pulls of the lines balance what loads them.

The energy of lines that only pull, over a bed that only pushes, is convex in the places of their
ends, so that there is one equilibrium; Newton's method goes down to it. A step is cut back while
the forces at its end push back by more than a part of what they pulled at its start. In the yaw of
a body the energy need not be convex: there the step is turned downhill, and the equilibrium is the
one that the body comes to from where it was.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

from catopt.catenary.equilibrium import BY_SPAN
from catopt.catenary.pieces import Pieces, cut
from catopt.catenary.solution import Solution
from catopt.catenary.solve import refusal, solution_of
from catopt.catenary.state import CONVERGED
from catopt.errors import FloatsUpError, NoEquilibriumError, NotConvergedError
from catopt.model import Line, Load
from catopt.model.network import MooredBody, Network
from catopt.mooring.line_ends import Ends, Matrix, Vector, ends_of
from catopt.words import Message

TOLERANCE = 1e-9
"""Force left over at a joint, over the largest end force of a line."""

ROUNDING = 2e-15
"""Of the longest line, by which rounding moves an end: over the stiffness that is a force."""

WORTH_A_STEP = 1e-3
"""Of what may be left over: more than that is brought down as long as a step halves it."""

_STEPS = 200
_CUTS = 60
_OVERSHOOT = 0.3
"""Of what the forces pulled at the start of a step, what they may push back at its end."""
_SETTLED = 0.02
"""The same once a step has been cut back: a line that comes taut on the way stops it there, and the
next step has to know how stiff it is."""
_HELD_BACK = 1e-9
"""Spring to where a joint is in one step, over the largest stiffness: nothing else may hold it."""

_GENTLE = 1e-6
"""The same, over what the forces would make of it along the longest line."""
_MOST_TURN, _NUDGE = 0.5, 0.01
"""rad: of a body in one step; and off a ridge on which it balances."""
_RIDGE = 1e-9
"""Of the largest stiffness: by so much a pivot may be below 0 from rounding."""


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


class JointsAtRest(NamedTuple):
    """Lines whose joints have come to rest: x, y and height (m) of every point, ends of every line.

    reactions (N) are those with which the bed carries each point, residual the largest force left
    over at a joint or a body (N), steps those of Newton's method, poses how far each free body is
    moved and turned from where it is given (m, m, rad).
    """

    places: tuple[Vector, ...]
    ends: tuple[Ends, ...]
    reactions: tuple[float, ...]
    residual: float
    steps: int
    poses: tuple[Vector, ...] = ()


def runs_of(network: Network) -> tuple[Run, ...]:
    """Lay out the lines of a network, each from its anchor where it has one."""
    runs = []
    for number, given in enumerate(network.lines, start=1):
        line = given.line
        first, second = (network.numbers[end] for end in (given.start, given.end))
        if network.points[second].kind == "anchor" != network.points[first].kind:
            first, second, line = second, first, turned_line(line)
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


def turned_line(line: Line) -> Line:
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
    if len(held) < len(network.points):
        found = _Search(network, runs, held, pinned).rest(known)
    else:
        places = tuple(held[k] for k in range(len(network.points)))
        ends = tuple(solved(run, places, friction_of(network, run)) for run in runs)
        found = JointsAtRest(places, ends, (0.0,) * len(places), 0.0, 0)
    _check(network, runs, found)
    return found


class Moored(NamedTuple):
    """A free body among the freedoms: x and y, and yaw by its longest arm (m) where it turns."""

    body: MooredBody
    arms: Mapping[int, Vector]
    turns: bool
    first: int

    @property
    def freedoms(self) -> int:
        """How many freedoms it has."""
        return 3 if self.turns else 2

    @property
    def arm(self) -> float:
        """From its origin to the farthest fairlead, m; 1 where there is none off it."""
        return max(math.hypot(x, y) for x, y, _ in self.arms.values()) or 1.0

    def turned(self, yaw: float) -> dict[int, Vector]:
        """Turn its arms; heights are those of the fairleads."""
        c, s = math.cos(yaw), math.sin(yaw)
        return {k: (c * x - s * y, s * x + c * y, z) for k, (x, y, z) in self.arms.items()}

    def places(self, pose: Vector) -> dict[int, Vector]:
        """Place its fairleads, m."""
        x, y, yaw = self.body.x + pose[0], self.body.y + pose[1], pose[2]
        return {k: (x + a, y + b, z) for k, (a, b, z) in self.turned(yaw).items()}

    def motions(self, yaw: float) -> dict[int, tuple[int, Matrix]]:
        """Say how each fairlead moves by the freedoms, of which the third is yaw in m."""
        arm, of = self.arm, self.turned(yaw).items()
        if not self.turns:
            return {k: (self.first, ((1.0, 0.0), (0.0, 1.0), (0.0, 0.0))) for k, _ in of}
        return {
            k: (self.first, ((1.0, 0.0, -b / arm), (0.0, 1.0, a / arm), (0.0, 0.0, 0.0)))
            for k, (a, b, _) in of
        }


class _At(NamedTuple):
    """Places of all points, how far each body is moved and turned (m, m, rad), the lines there."""

    places: list[Vector]
    poses: tuple[Vector, ...]
    ends: list[Ends]


class _Search:
    """Newton's method on the places of the joints and of the bodies."""

    def __init__(
        self, network: Network, runs: Sequence[Run], held: dict[int, Vector], pinned: bool
    ) -> None:
        self.network, self.runs, self.held = network, runs, held
        self.joints = [k for k, point in enumerate(network.points) if point.kind == "joint"]
        self.bodies = moored(network, 3 * len(self.joints))
        self.size = 3 * len(self.joints) + sum(body.freedoms for body in self.bodies)
        self.stride = max(run.line.length for run in runs)
        self.pins = [body.first + i for body in self.bodies for i in (0, 1)] if pinned else []

    def rest(self, known: JointsAtRest | None) -> JointsAtRest:
        """Step until the forces are in balance, and as long as that still gets better."""
        at = self.start(known)
        begun, best, nudged = at.poses, math.inf, False
        counts = [3] * len(self.joints) + [body.freedoms for body in self.bodies]
        firsts = [sum(counts[:k]) for k in range(len(counts))]
        for step in range(_STEPS):
            motions = self.motions(at.poses)
            forces, laid = self.forces(at, motions)
            pulls = [math.hypot(*pull) for each in at.ends for pull in (each.first, each.second)]
            left = max(math.hypot(*forces[k : k + n]) for k, n in zip(firsts, counts, strict=True))
            stiffest = max(each.stiffness[i][i] for each in at.ends for i in range(6))
            limit = TOLERANCE * max(pulls) + ROUNDING * self.stride * stiffest
            if left <= limit and not WORTH_A_STEP * limit < left < 0.5 * best:
                if nudged or self.is_stable(at, motions, laid):
                    return self.found(at, laid, left, step)
                nudged, best = True, math.inf
                at = self.moved(at, self.nudge(), 1.0)
                continue
            best = min(best, left)
            before, at = at, self.step(at, motions, forces, laid)
            self.check_turns(at.poses, begun)
            if left > limit and (before.places, before.poses) == (at.places, at.poses):
                break
        if any(laid.values()) and self.network.site.seabed_friction:
            return self.found(at, laid, left, step)  # which is refused: friction holds it
        values = {"left": left, "steps": _STEPS, "part": left / max(pulls)}
        raise NotConvergedError(Message("mooring.joints_not_at_rest", **values))

    def start(self, known: JointsAtRest | None) -> _At:
        """Begin where all is known to be at rest, or with the bodies where they are given."""
        poses = ((0.0, 0.0, 0.0),) * len(self.bodies) if known is None else known.poses
        held = {**self.held}
        for body, pose in zip(self.bodies, poses, strict=True):
            held |= body.places(pose)
        if known is None:
            places = _start(self.network, self.runs, held)
        else:
            places = [held.get(k, place) for k, place in enumerate(known.places)]
        return _At(places, poses, self.ends(places, None if known is None else known.ends))

    def found(self, at: _At, laid: dict[int, float], left: float, step: int) -> JointsAtRest:
        """Say what has come to rest."""
        reactions = [0.0] * len(at.places)
        for k, point in enumerate(self.joints):
            reactions[point] = laid.get(3 * k + 2, 0.0)
        return JointsAtRest(
            tuple(at.places), tuple(at.ends), tuple(reactions), left, step, at.poses
        )

    def is_stable(
        self, at: _At, motions: Mapping[int, tuple[int, Matrix]], laid: Collection[int]
    ) -> bool:
        """Whether no body turns on from where it is in balance."""
        if not any(body.turns for body in self.bodies):
            return True
        matrix = self.stiffness(at, motions)
        stiffest = max(matrix[i][i] for i in range(self.size))
        if not stiffest > 0.0:  # every line is slack
            return True
        _, least = descent(_held_down(matrix, laid), [0.0] * self.size)
        return least >= -_RIDGE * stiffest

    def nudge(self) -> list[float]:
        """Turn every body a little, off a ridge on which it balances."""
        way = [0.0] * self.size
        for body in self.bodies:
            if body.turns:
                way[body.first + 2] = _NUDGE * body.arm
        return way

    def check_turns(self, poses: Sequence[Vector], begun: Sequence[Vector]) -> None:
        """Refuse a moment that turns a body round once."""
        for body, (_, _, yaw), (_, _, before) in zip(self.bodies, poses, begun, strict=True):
            if abs(yaw - before) > math.tau:
                moment = body.body.moment
                said = Message("mooring.body_turns_over", name=body.body.name, moment=moment)
                raise NoEquilibriumError(said, "moment", abs(moment))

    def ends(self, places: Sequence[Vector], known: Sequence[Ends] | None) -> list[Ends]:
        """Solve every line."""
        return [
            solved(run, places, friction_of(self.network, run), None if known is None else known[k])
            for k, run in enumerate(self.runs)
        ]

    def motions(self, poses: Sequence[Vector]) -> dict[int, tuple[int, Matrix]]:
        """Say of every point that moves how it does by the freedoms."""
        found: dict[int, tuple[int, Matrix]] = {p: (3 * k, UNIT) for k, p in enumerate(self.joints)}
        for body, pose in zip(self.bodies, poses, strict=True):
            found |= body.motions(pose[2])
        return found

    def forces(
        self, at: _At, motions: Mapping[int, tuple[int, Matrix]]
    ) -> tuple[list[float], dict[int, float]]:
        """Sum what is left over by freedom; and what the bed carries of joints, by theirs."""
        left = self.of_lines(at, motions)
        for body in self.bodies:
            load = (*body.body.force, body.body.moment / body.arm)
            for i in range(body.freedoms):
                left[body.first + i] += load[i]
        laid = {}
        for k, point in enumerate(self.joints):
            up = 3 * k + 2
            for i, hung in enumerate(self.network.points[point].hung):
                left[3 * k + i] += hung
            if at.places[point][2] <= 0.0 and left[up] <= 0.0:
                laid[up] = -left[up]
                left[up] = 0.0
        for i in self.pins:
            left[i] = laid[i] = 0.0  # what holds a body is no reaction of the bed
        return left, laid

    def of_lines(self, at: _At, motions: Mapping[int, tuple[int, Matrix]]) -> list[float]:
        """Sum what the lines do by freedom."""
        total = [0.0] * self.size
        for point, force in pulls_of(self.runs, at.ends):
            if point in motions:
                first, by = motions[point]
                for i, along in enumerate(zip(*by, strict=True)):
                    total[first + i] += sum(map(float.__mul__, along, force))
        return total

    def stiffness(self, at: _At, motions: Mapping[int, tuple[int, Matrix]]) -> list[list[float]]:
        """Sum the stiffness of the lines, and what their pulls add as a body turns."""
        matrix = assembled(self.runs, at.ends, motions, self.size)
        for body, pose in zip(self.bodies, at.poses, strict=True):
            if body.turns:
                yaw = body.first + 2
                matrix[yaw][yaw] += by_turning(self.runs, at.ends, body, pose[2]) / body.arm**2
        return matrix

    def step(
        self,
        at: _At,
        motions: Mapping[int, tuple[int, Matrix]],
        forces: list[float],
        laid: Collection[int],
    ) -> _At:
        """Take a step of Newton's method, or as much of it as goes down."""
        matrix = self.stiffness(at, motions)
        stiffest = max(matrix[i][i] for i in range(self.size))
        strongest = max(map(abs, forces))
        for i in range(self.size):
            matrix[i][i] += _HELD_BACK * stiffest + _GENTLE * strongest / self.stride
        way, _ = descent(_held_down(matrix, laid), forces)
        if not sum(map(float.__mul__, forces, way)) > 0.0:  # friction's derivatives are lopsided
            even = [
                [0.5 * (a + b) for a, b in zip(row, column, strict=True)]
                for row, column in zip(matrix, zip(*matrix, strict=True), strict=True)
            ]
            way, _ = descent(_held_down(even, laid), forces)
        part = min(1.0, self.stride / max(map(abs, way)))
        for body in self.bodies:
            if body.turns and (turn := abs(way[body.first + 2]) / body.arm):
                part = min(part, _MOST_TURN / turn)
        short, far, pull, push, last = 0.0, math.inf, 0.0, 0.0, part
        for cut_back in range(_CUTS):
            there = self.moved(at, way, part)
            went = self.went(at, there, way, part)
            downhill = math.fsum(map(float.__mul__, forces, went))
            pulling, _ = self.forces(there, self.motions(there.poses))
            slope = math.fsum(map(float.__mul__, pulling, went))
            most = _SETTLED if cut_back else _OVERSHOOT
            if abs(slope) <= most * downhill or (slope > 0.0 and math.isinf(far)):
                break
            # Illinois: regula falsi between where the forces still pull on and where they push
            # back; the end that stays counts half, so that a kink between them is closed in on.
            if short == 0.0:
                pull = downhill / part
            if slope > 0.0:
                push = 0.5 * push if short == last else push
                short, pull = part, slope / part
            else:
                pull = 0.5 * pull if far == last else pull
                far, push = part, slope / part
            last = part
            share = pull / (pull - push)
            part = short + min(max(share, 0.01), 0.99) * (far - short)
        return there

    def moved(self, at: _At, way: Sequence[float], part: float) -> _At:
        """Move joints, none below the bed, and bodies, and solve the lines there."""
        places = list(at.places)
        for k, point in enumerate(self.joints):
            x, y, z = (places[point][i] + part * way[3 * k + i] for i in range(3))
            places[point] = (x, y, max(z, 0.0))
        poses = []
        for body, (x, y, yaw) in zip(self.bodies, at.poses, strict=True):
            along, across, *turn = (part * each for each in way[body.first :][: body.freedoms])
            poses.append((x + along, y + across, yaw + sum(turn) / body.arm))
            for k, place in body.places(poses[-1]).items():
                places[k] = place
        return _At(places, tuple(poses), self.ends(places, at.ends))

    def went(self, at: _At, there: _At, way: Sequence[float], part: float) -> list[float]:
        """Say by how much each freedom changed, m."""
        joints = [there.places[p][i] - at.places[p][i] for p in self.joints for i in range(3)]
        return [*joints, *(part * each for each in way[len(joints) :])]


def moored(network: Network, first: int) -> tuple[Moored, ...]:
    """Lay out the free bodies of a network after so many freedoms of its joints."""
    found: list[Moored] = []
    for body in network.bodies:
        found.append(Moored(body, network.arms_of(body), network.turns(body), first))
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


def _held_down(matrix: list[list[float]], laid: Collection[int]) -> list[list[float]]:
    """Let what lies on the bed, or is pinned, stay there."""
    for i in laid:
        matrix[i] = [float(i == j) for j in range(len(matrix))]
    return matrix


def descent(
    matrix: Sequence[Sequence[float]], forces: Sequence[float]
) -> tuple[list[float], float]:
    """Solve for a step that goes down: pivots are kept above 0; and return the least of them.

    A symmetric matrix has as many pivots below 0 as directions in which the forces push on.
    """
    size = len(forces)
    rows = [[*row, force] for row, force in zip(matrix, forces, strict=True)]
    floor = _HELD_BACK * max(matrix[i][i] for i in range(size))
    least = math.inf
    for j in range(size):
        least = min(least, rows[j][j])
        if rows[j][j] < floor:
            rows[j][j] = max(-rows[j][j], floor)
        for r in range(j + 1, size):
            if factor := rows[r][j] / rows[j][j]:
                rows[r] = [a - factor * b for a, b in zip(rows[r], rows[j], strict=True)]
    way = [0.0] * size
    for j in reversed(range(size)):
        known = math.fsum(rows[j][k] * way[k] for k in range(j + 1, size))
        way[j] = (rows[j][size] - known) / rows[j][j]
    return way, least


UNIT: Matrix = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


def solved(
    run: Run,
    at: Mapping[int, Vector] | Sequence[Vector],
    friction: float,
    known: Ends | None = None,
) -> Ends:
    """Solve a line between its points; an error where it has no answer."""
    a, b = at[run.first], at[run.second]
    ends = ends_of(run.pieces, a, b, friction, known)
    if ends.state.status != CONVERGED:
        load = Load(span=max(math.dist(a[:2], b[:2]), 1e-9))
        raise refusal(ends.state.status, run.line, load, ends.problem)
    return ends


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
            pull = math.hypot(*hung)
            sides[k] = [side + force / pull for side, force in zip(sides[k], hung, strict=True)]
    found = zip(joints, solve(matrix, sides), strict=True)
    places = held | {point: (x, y, z) for point, (x, y, z) in found}
    return [places[k] for k in range(len(network.points))]


def _check(network: Network, runs: Sequence[Run], found: JointsAtRest) -> None:
    """Refuse what lies where friction leaves it open, and buoys above the surface."""
    site = network.site
    for point, reaction in zip(network.points, found.reactions, strict=True):
        if reaction > 0.0 and site.seabed_friction > 0.0:
            said = Message("mooring.joint_on_bed", name=point.name, reaction=reaction)
            raise NoEquilibriumError(said, "force", reaction)
    check_afloat(network, found.places)
    for run, each in zip(runs, found.ends, strict=True):
        length = each.state.grounded
        if length > 0.0 and site.seabed_friction > 0.0 and not is_anchored(network, run):
            said = Message("mooring.drags_both_ways", number=run.name, length=length)
            raise NoEquilibriumError(said, "force", length)


def check_afloat(network: Network, places: Sequence[Vector]) -> None:
    """Refuse buoys above the surface."""
    depth = network.site.water_depth
    for point, place in zip(network.points, places, strict=True):
        above = place[2] - depth
        if point.submerged_weight < 0.0 and above > 1e-9 * depth:
            values = {"name": point.name, "above": above, "lift": -point.submerged_weight}
            raise FloatsUpError(Message("mooring.joint_floats_up", **values))
