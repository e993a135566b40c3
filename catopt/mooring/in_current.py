"""Lines between points at rest in a current: each followed along its length, inside the network.

A line between two places is closed by what is sought at its lower end, F (see
`catenary.in_current`). How its upper end r and the forces on both ends change with F and with the
height of the first end is found by differences; so the forces change with the places of the ends
by dF = (dr/dF)^-1 (dr - dr/dz dz), and Newton's method goes over the freedoms of the network as in
still water. Drag has no energy: a step is cut back while it neither brings down what is left over
nor ends where the forces still pull on.
What the current takes too far at once it takes in parts, from still water on.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import takewhile
from typing import NamedTuple

from catopt.catenary.along_current import Node, solved
from catopt.catenary.in_current import CLOSED, Laid, Shot, SolutionInCurrent, laid_in_current
from catopt.catenary.state import CONVERGED, GROUNDED, SUSPENDED, State
from catopt.errors import InputError, NoAnswerError, NotConvergedError
from catopt.model import CurrentProfile
from catopt.model.network import Network
from catopt.mooring.joints import (
    Ends,
    Freed,
    JointsAtRest,
    Matrix,
    Run,
    Vector,
    check_rest,
    friction_of,
    pose_of,
)
from catopt.mooring.joints import solved as solved_line
from catopt.mooring.net import FORCES, STIFFNESS, TURNS, Known, Net, place_points
from catopt.mooring.rest import (
    HELD_BACK,
    MOST_TURN,
    OVERSHOOT,
    TOLERANCE,
    add_line,
    add_up,
    begin,
    descend,
    go,
    longest,
)
from catopt.words import Message

_STEPS, _ADDING, _CUTS = 60, 30, 12
"""How many steps, of which the first may add to what is left over; and how often one is cut."""
_LEAST_PART = 1.0 / 64.0
"""Of the current, in which it is put on where it cannot be at once."""
_ENOUGH = 20.0
"""Times what the closure of lines leaves open of forces: that is as good as balance."""
_DIFFERENCE, _HIGHER = 1e-6, 1e-6
"""Of a line's forces, and of its length, by which they are changed for derivatives."""
_HARDLY_ANY = 1e-6
"""Of a line's weight and load: the tension where a slack line comes to the bed."""
_LONGEST_STEP = 0.3
"""Of the longest line, that a point moves in one step."""


class Followed(NamedTuple):
    """A line between two places: what is sought of it, and as it lies."""

    sought: list[float]
    laid: Laid


class LineInCurrent:
    """One line of a network in the current, and what is known of it from before."""

    def __init__(self, network: Network, current: CurrentProfile, run: Run, still: Ends) -> None:
        site = replace(network.site, seabed_friction=friction_of(network, run))
        self.run = run
        self.shot = Shot(run.line, site, current, 0.0, math.hypot(*still.second))
        self.sought, self.still = _sought(run, still), still
        self.is_slack = False
        self.columns: Matrix | None = None
        self.at: Vector | None = None

    def between(self, first: Vector, second: Vector) -> Followed | None:
        """Follow it from place to place, from where it is known; None where that does not close."""
        self._aim(first, second)
        found = None
        if not self.is_slack:
            ahead = self._ahead(first, second)
            found = self._corrected(ahead) or self.shot.newton(ahead)
        if found is None:
            found = self._slack(first, second) or self._from_still(first, second)
        laid = None if found is None else self.shot.laid(found, self.shot.length)
        return None if found is None or laid is None else Followed(found, laid)

    def _slack(self, first: Vector, second: Vector) -> list[float] | None:
        """Find what lies of a line that is slack at the bed; None where it is not.

        There what hangs leaves the bed with hardly any tension, below its upper end but for what
        drag moves it, and the line that lies reaches there loosely.
        """
        shot = self.shot
        if not shot.may_lie:
            return None
        self.is_slack, shot.loose_to = True, (second[0] - first[0], second[1] - first[1])
        few = _HARDLY_ANY * shot.scale
        lying = takewhile(lambda each: each.weight >= 0.0 and each.load >= 0.0, shot.parts)
        heavy = math.fsum(each.weight * each.length + each.load for each in lying)

        def height(lies: float) -> float:
            laid = self._followed([few, 0.0, -lies])
            return math.nan if laid is None else laid.top.z - second[2]

        lies = root_between(height, 1e-12 * heavy, heavy * (1.0 - 1e-12), CLOSED * shot.length)
        laid = None if lies is None else self._followed([few, 0.0, -lies])
        if lies is not None and laid is not None:
            _, foot = laid.bed[-1]
            if math.hypot(foot.x, foot.y) <= foot.stretched:
                return [few, 0.0, -lies]
        self.is_slack, shot.loose_to = False, None
        return None

    def _from_still(self, first: Vector, second: Vector) -> list[float] | None:
        """Close it from where it would be in still water, the current put on in parts."""
        run, part = self.run, self.shot.part
        try:
            at = {run.first: first, run.second: second}
            self.still = solved_line(run, at, self.shot.friction, self.still)
            return self.shot.closed(_sought(run, self.still), part)
        except (InputError, NoAnswerError, NotConvergedError):
            self.shot.part = part
            return None

    def _aim(self, first: Vector, second: Vector, higher: float = 0.0) -> None:
        self.shot.hang_between(first[2] + higher, second[2] + higher)
        x, y = second[0] - first[0], second[1] - first[1]

        def missed(top: Node) -> Vector:
            return top.x - x, top.y - y, top.z - second[2] - higher

        self.shot.missed_by = missed

    def _corrected(self, sought: list[float]) -> list[float] | None:
        """Close it by the last derivatives, as long as that closes in fast; else None."""
        shot, size = self.shot, math.inf
        while self.columns is not None:
            left = shot.missed(sought)
            if left is None or not max(map(abs, left)) < 0.2 * size:
                break
            size = max(map(abs, left))
            if size <= CLOSED * shot.length:
                return sought
            step = solved(self.columns, [-each for each in left])
            if step is None:
                break
            sought = [a + b for a, b in zip(sought, step, strict=True)]
        return None

    def _ahead(self, first: Vector, second: Vector) -> list[float]:
        """Estimate what is sought by the last derivatives."""
        if self.columns is None or self.at is None:
            return self.sought
        moved = [b - a - c for a, b, c in zip(first, second, self.at, strict=True)]
        step = solved(self.columns, moved)
        return (
            self.sought if step is None else [a + b for a, b in zip(self.sought, step, strict=True)]
        )

    def keep(self, first: Vector, second: Vector, found: Followed) -> None:
        """Remember where it is, for what comes next."""
        self.sought = found.sought
        self.at = (second[0] - first[0], second[1] - first[1], second[2] - first[2])

    def stiffness(self, first: Vector, second: Vector, found: Followed) -> Matrix | None:
        """Derive the forces on both ends by the places of both, with the sign of a stiffness."""
        self._aim(first, second)
        base = _forces(found.laid)
        if self.is_slack:
            return self._slack_stiffness(base, found)
        change = _DIFFERENCE * self.shot.scale
        tops, ends = [], []
        for k in range(3):
            moved = [a + change * (i == k) for i, a in enumerate(found.sought)]
            laid = self._followed(moved)
            if laid is None:
                return None
            tops.append(_by(found.laid.top[1:4], laid.top[1:4], change))
            ends.append(_by(base, _forces(laid), change))
        self.columns = tuple(map(tuple, tops))
        # Both ends higher by as much: the water flows otherwise there.
        up, ends_up = (0.0, 0.0, 0.0), [0.0] * 6
        if not found.laid.bed:
            higher = _HIGHER * self.shot.length
            self._aim(first, second, higher)
            laid = self._followed(found.sought)
            self._aim(first, second)
            if laid is not None:
                x, y, z = _by(found.laid.top[1:4], laid.top[1:4], higher)
                up, ends_up = (x, y, z - 1.0), _by(base, _forces(laid), higher)
        rows = [[0.0] * 6 for _ in range(6)]
        for j in range(6):
            way = [float(i == j % 3) * (1.0 if j >= 3 else -1.0) for i in range(3)]
            lift = 1.0 if j == 2 else 0.0
            sides = [a - lift * b for a, b in zip(way, up, strict=True)]
            step = solved(self.columns, sides)
            if step is None:
                return None
            for i in range(6):
                gain = math.fsum(a[i] * b for a, b in zip(ends, step, strict=True))
                rows[i][j] = -(gain + lift * ends_up[i])
        return tuple(map(tuple, rows))

    def _slack_stiffness(self, base: Sequence[float], found: Followed) -> Matrix:
        """Derive the force on the upper end by its height alone."""
        rows = [[0.0] * 6 for _ in range(6)]
        lighter = [*found.sought[:2], found.sought[2] * (1.0 - _DIFFERENCE)]
        laid = self._followed(lighter)
        if laid is not None and laid.top.z != found.laid.top.z:
            rise = laid.top.z - found.laid.top.z
            for i, value in enumerate(_by(base, _forces(laid), rise)):
                rows[i][5] = -value
        return tuple(map(tuple, rows))

    def _followed(self, sought: Sequence[float]) -> Laid | None:
        try:
            return self.shot.laid(sought, self.shot.length)
        except NotConvergedError:
            return None

    def solution(self, first: Vector, second: Vector) -> SolutionInCurrent:
        """Say all of it, x being the direction from its first end to its second in plan."""
        self._aim(first, second)
        x, y = second[0] - first[0], second[1] - first[1]
        direction = math.atan2(y, x)
        return laid_in_current(self.shot, self.sought, direction)


def _sought(run: Run, still: Ends) -> list[float]:
    """Take what is sought from a line in still water."""
    x, y, down = still.second
    return [-x, -y, -down - run.line.submerged_weight]


def _forces(laid: Laid) -> list[float]:
    """Return the forces of a line on both its ends, N."""
    top = laid.top
    return [*laid.pull, -top.fx, -top.fy, -top.fz]


def _by(before: Sequence[float], after: Sequence[float], change: float) -> list[float]:
    return [(b - a) / change for a, b in zip(before, after, strict=True)]


def root_between(
    of: Callable[[float], float], low: float, high: float, enough: float
) -> float | None:
    """Find where a falling function is 0, by the Illinois method; None where it is nowhere."""
    above, below = of(low), of(high)
    if not above >= 0.0 >= below:
        return None
    for _ in range(100):
        middle = (low * below - high * above) / (below - above)
        value = of(middle)
        if abs(value) <= enough or not low < middle < high:
            return middle
        if value > 0.0:
            low, above, below = middle, value, 0.5 * below
        else:
            high, below, above = middle, value, 0.5 * above
    return None


@dataclass
class _InCurrent:
    """A network on its way to rest in a part of the current."""

    network: Network
    of: Freed
    lines: Sequence[LineInCurrent]
    part: float = 1.0

    @property
    def net(self) -> Net:
        return self.of.net

    @property
    def known(self) -> Known:
        return self.of.room

    def places(self, k: int) -> tuple[Vector, Vector]:
        """Return where the ends of a line are, m."""
        a, b = (3 * of[k] for of in (self.net.first, self.net.second))
        x, y, z, *_ = self.known.place[a : a + 3]
        u, v, w, *_ = self.known.place[b : b + 3]
        return (x, y, z), (u, v, w)

    def hang(self) -> list[Followed] | None:
        """Follow every line between its points, and write its forces; None where one is lost."""
        place_points(self.net, self.known)
        found = []
        for k, line in enumerate(self.lines):
            line.shot.part = self.part
            followed = line.between(*self.places(k))
            if followed is None:
                return None
            found.append(followed)
            self.known.force[FORCES * k : FORCES * (k + 1)] = _forces(followed.laid)
        self._drag()
        return found

    def _drag(self) -> None:
        """Load joints with what hangs there, and their drag."""
        site = self.network.site
        flow = self.lines[0].shot.flow
        for at, k in enumerate(self.of.joints):
            point = self.network.points[k]
            half = 0.5 * site.water_density * point.drag_product
            u, v = (
                self.part * each for each in flow(min(self.known.q[3 * at + 2], site.water_depth))
            )
            speed, (x, y, z) = math.hypot(u, v), point.hung
            self.net.pull[3 * at : 3 * at + 3] = x + half * speed * u, y + half * speed * v, z

    def assembled(self, found: Sequence[Followed]) -> bool:
        """Sum the stiffness; False where one of a line is not to be had."""
        begin(self.net, self.known)
        for k, (line, each) in enumerate(zip(self.lines, found, strict=True)):
            rows = line.stiffness(*self.places(k), each)
            if rows is None:
                return False
            self.known.block[:STIFFNESS] = [value for row in rows for value in row]
            add_line(k, self.net, self.known)
        return True

    def remember(self, found: Sequence[Followed]) -> None:
        """Keep where all is."""
        known = self.known
        known.before[:], known.pulled[:] = known.q, known.left
        for k, (line, each) in enumerate(zip(self.lines, found, strict=True)):
            line.keep(*self.places(k), each)

    def rest(self) -> tuple[float, int] | None:
        """Bring it to rest from where it is: what is left over, N, and steps; None: lost."""
        net, known = self.net, self.known
        found, stride = self.hang(), longest(net)
        for step in range(_STEPS):
            if found is None:
                return None
            left, largest = add_up(net, known)
            self.remember(found)
            if not net.pull:
                return left, step
            if not self.assembled(found):
                return None
            stiffest = max(known.stiffness[i * len(net.pull) + i] for i in range(len(net.pull)))
            limit = TOLERANCE * largest + _ENOUGH * CLOSED * stride * stiffest
            if left <= limit:
                return self._polished(left, stiffest, stride), step
            found = self._step(left, stiffest, stride, may_add=step < _ADDING)
        return None

    def _polished(self, left: float, stiffest: float, stride: float) -> float:
        """Take one more step where that leaves less; what is left over, N."""
        found = self._step(left, stiffest, stride, may_add=False)
        if found is not None and (less := add_up(self.net, self.known)[0]) < left:
            self.remember(found)
            return less
        go(self.net, self.known, 0.0)
        if (again := self.hang()) is not None:
            self.remember(again)
        return add_up(self.net, self.known)[0]

    def _step(
        self, left: float, stiffest: float, stride: float, *, may_add: bool
    ) -> list[Followed] | None:
        """Take so much of a step of Newton's method as brings down what is left over.

        With `may_add` or at whose end the forces hardly push back: as lines come taut more is left.
        """
        net, known = self.net, self.known
        n = len(net.pull)
        for i in range(n):
            known.stiffness[i * n + i] += HELD_BACK * stiffest
        descend(net, known, False)
        part = min(1.0, _LONGEST_STEP * stride / max(max(map(abs, known.way)), 1e-300))
        for i in range(n):
            if net.kind[i] == TURNS and known.way[i] != 0.0:
                part = min(part, MOST_TURN * net.scale[i] / abs(known.way[i]))
        found = None
        for _ in range(_CUTS):
            downhill = go(net, known, part)
            found = self.hang()
            if found is not None:
                now, _ = add_up(net, known)
                moved = zip(known.left, known.q, known.before, strict=True)
                pull = math.fsum(force * (there - here) for force, there, here in moved)
                if now < left or (may_add and pull >= -OVERSHOOT * downhill):
                    return found
            part *= 0.5
        return found


def rest_in_current(
    network: Network, current: CurrentProfile, runs: Sequence[Run], of: Freed, still: JointsAtRest
) -> tuple[JointsAtRest, tuple[SolutionInCurrent, ...]]:
    """Bring a network to rest in a current, from where it is at rest in still water.

    Raises NotConvergedError where it is lost on the way, and what `joints_at_rest` does.
    """
    lines = [
        LineInCurrent(network, current, run, ends)
        for run, ends in zip(runs, still.ends, strict=True)
    ]
    on_way = _InCurrent(network, of, lines)
    left, steps = _put_on(on_way)
    ends, solutions = [], []
    place_points(of.net, of.room)
    for k, line in enumerate(lines):
        one, other = on_way.places(k)
        solution = line.solution(one, other)
        laid = line.shot.laid(line.sought, line.shot.length)
        assert laid is not None
        rows = line.stiffness(one, other, Followed(line.sought, laid))
        ends.append(_ends(solution, laid, still.ends[k], rows))
        solutions.append(solution)
    places = [tuple(of.room.place[at : at + 3]) for at in range(0, len(of.room.place), 3)]
    reactions, lost = [0.0] * len(places), [0.0] * len(places)
    for k, point in enumerate(of.joints):
        reactions[point], lost[point] = of.room.laid[3 * k + 2], of.room.lost[3 * k + 2]
    found = JointsAtRest(
        tuple(places),
        tuple(ends),
        tuple(reactions),
        left,
        still.steps + steps,
        tuple(pose_of(body, of.room.q) for body in of.bodies),
        tuple(lost),
    )
    check_rest(network, runs, found)
    return found, tuple(solutions)


def _put_on(on_way: _InCurrent) -> tuple[float, int]:
    """Put the current on, in parts where it cannot be at once; what is left over, N, and steps."""
    done, part, steps = 0.0, 1.0, 0
    q = list(on_way.known.q)
    sought = [line.sought for line in on_way.lines]
    while True:
        on_way.part = min(1.0, done + part)
        try:
            found = on_way.rest()
        except NoAnswerError:
            found = None
        if found is not None:
            steps += found[1]
            done = on_way.part
            if done == 1.0:
                return found[0], steps
            q, sought = list(on_way.known.q), [line.sought for line in on_way.lines]
            part *= 2.0
            continue
        if part <= _LEAST_PART:
            for line in on_way.lines:
                line.shot.check_taut(line.sought)
            raise NotConvergedError(Message("catenary.current_not_converged", part=on_way.part))
        part *= 0.5
        on_way.known.q[:] = q
        for line, own in zip(on_way.lines, sought, strict=True):
            line.sought, line.at = own, None


def _ends(solution: SolutionInCurrent, laid: Laid, still: Ends, rows: Matrix | None) -> Ends:
    """Say what a line in the current does to its points, as one in still water."""
    forces = tuple(_forces(laid))
    H, V = solution.fairlead.horizontal_force, solution.fairlead.vertical_force
    anchor = solution.anchor
    state = State(
        CONVERGED,
        GROUNDED if solution.grounded_length > 0.0 else SUSPENDED,
        0,
        H,
        V,
        solution.span,
        0.0,
        solution.grounded_length,
        anchor.horizontal_force,
        anchor.vertical_force,
        math.nan,
        math.nan,
        math.nan,
        math.nan,
    )
    nothing = ((math.nan,) * 6,) * 6
    return Ends(state, still.problem, forces[:3], forces[3:], nothing if rows is None else rows)
