"""One line at rest in a current: its equations along the line, by shooting from the fairlead.

With the unstretched arc length s down from the fairlead, the place r, the force F of what is above
on what is below, T = |F| and e = F/T:

    dr/ds = -(1 + T/EA) e        dF/ds = f - w k

k being up, w the submerged weight and f the drag, both per unstretched length as in the truss
model, S4 [2.19]-[2.32]:

    f = 0.5 rho D (C_n |u_n| u_n + C_t |u_t| u_t)        u_t = (u.e) e,  u_n = u - u_t

What is not known of F at the fairlead is sought until the line ends at its anchor. Where nothing
is left of the vertical force, the line lies on the bed from there on: straight on as it came down,
without drag, the friction taking off its tension.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any, NamedTuple

from catopt.catenary.layout import Profile, Stretch
from catopt.catenary.solution import EndState, PointLoadState, Residual, SegmentState, Solution
from catopt.catenary.solve import solve
from catopt.catenary.state import Regime
from catopt.catenary.warnings import plausibility
from catopt.errors import InputError, NotConvergedError, Problem
from catopt.model import Case, CurrentProfile, Line, Load
from catopt.words import Measure, Message

Vector = tuple[float, float, float]
Flow = Callable[[float], tuple[float, float]]
"""Velocity of the water along x and y, m/s, at a height above the bed, m."""

LOCAL = 1e-11
"""Error of a step along the line, as a part of the line's length and of its forces."""
CLOSED, ENOUGH = 1e-10, 1e-8
"""How far the line may miss its anchor, as a part of its length: sought, and where it stalls."""
STATIONS = 200
"""Fewest places at which the line is laid out."""

_STEPS, _TRIALS, _LEAST_SHARE = 20_000, 40, 1e-4
_DIFFERENCE = 1e-5
"""Of the forces, by which they are changed for derivatives."""
_SLACK = 0.02
"""Of the line's weight and load: less tension than that at the touchdown is nearly none."""
_LEAST_PART = 1.0 / 64.0
"""Of the current, in which it is put on where it cannot be at once."""


@dataclass(frozen=True, repr=False, kw_only=True)
class SolutionInCurrent(Solution):
    """Equilibrium of one line in a current.

    The anchor lies at x = y = 0, x towards the fairlead. `places` are rows of unstretched arc
    length from the anchor, x, y, z (m) and tension (N); `drag` is that of the whole line,
    `fairlead_force` what holds it there, `anchor_force` what it pulls on its anchor with, N along
    x, y and up.
    """

    current: CurrentProfile
    surface_velocity: tuple[float, float]
    places: tuple[tuple[float, float, float, float, float], ...]
    drag: Vector
    fairlead_force: Vector
    anchor_force: Vector

    def profile(self, points: int = 101) -> Profile:
        """Sample the shape and the tension at about so many of the places, from the anchor up."""
        s, x, _, z, tension = zip(*self._sampled(points), strict=True)
        return Profile(s, x, z, tension)

    def _sampled(self, points: int) -> list[tuple[float, float, float, float, float]]:
        every = max(1, (len(self.places) - 1) // max(points - 1, 1))
        kept = [*range(0, len(self.places), every)]
        return [self.places[k] for k in dict.fromkeys((*kept, len(self.places) - 1))]

    def to_dict(self, *, profile: bool = False) -> dict[str, Any]:
        """Build the document that ``catopt solve --json`` prints (schema catopt.solution/1)."""
        document = super().to_dict(profile=profile)
        document["current"] = {
            "profile": self.current.profile,
            "surface_velocity_m_per_s": list(self.surface_velocity),
            "drag_N": list(self.drag),
            "fairlead_force_N": list(self.fairlead_force),
            "anchor_force_N": list(self.anchor_force),
        }
        if profile:
            document["profile"]["y_m"] = [row[2] for row in self._sampled(101)]
        return document


class Part(NamedTuple):
    """A uniform part of the line and the point loads on its lower end.

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
    """A place on the line: arc length down from the fairlead, x, y, z and the force there."""

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


class Laid(NamedTuple):
    """The line followed down from its fairlead: the nodes of each part that hangs, and its end.

    `lies` is how far down the last part hangs before the rest of the line lies on the bed, `None`
    where all hangs; then `reaction` is what the bed carries of a clump weight there, N.
    """

    parts: tuple[tuple[Node, ...], ...]
    end: Node
    lies: float | None
    reaction: float


def check_for_current(line: Line) -> None:
    """Refuse segments without what their drag is found from, with all that they lack."""
    problems = []
    for k, segment in enumerate(line.segments):
        key = f"line.segments[{k}]"
        if segment.drag_method != "given":
            allowed = Message("refused_case.current_wants_given_drag")
            problems.append(Problem(f"{key}.drag_method", f'"{segment.drag_method}"', allowed))
        elif segment.drag_normal is None:
            allowed = Message("refused_case.current_wants_drag")
            problems.append(Problem(f"{key}.drag_normal", "", allowed))
        elif segment.drag_diameter is None and (segment.drag_normal or segment.drag_axial):
            allowed = Message("refused_motion.missing_drag_refers")
            problems.append(Problem(f"{key}.drag_diameter", "", allowed))
    if problems:
        raise InputError(problems, "current")


def solve_in_current(case: Case) -> SolutionInCurrent:
    """Solve the line of a case at rest in its current, under its load.

    The fairlead is held in its height and across x, and along x under a given force or tension
    there is no hold; of a horizontal force that is its part along x. InputError: a segment without
    drag. NoEquilibriumError: as for `solve` in still water, or the line touches the bed where that
    is not solved; NotConvergedError.
    """
    current, load, site = case.current, case.load, case.site
    assert current is not None
    assert load is not None
    check_for_current(case.line)
    still = solve(
        case.line,
        horizontal_force=load.horizontal_force,
        span=load.span,
        fairlead_tension=load.fairlead_tension,
        **case.place,
    )
    flow = current.flow(site.water_depth)
    parts = parts_of(case.line, site.water_density, site.seabed_friction)
    shot = _Shot(case, parts, flow, load, still.fairlead.tension)
    known = [0.0, still.fairlead.vertical_force]
    if load.span is not None:
        known.insert(0, still.fairlead.horizontal_force)
    known = shot.closed(known)
    return _solution(case, shot, shot.laid(known), shot.left_open(known))


def parts_of(line: Line, density: float, friction: float) -> tuple[Part, ...]:
    """Cut a line at its segments and point loads, from the fairlead down."""
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
            Part(
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
    return tuple(found[::-1])


class _Shot:
    """What is aimed at: the anchor, from a fairlead of which some is known."""

    def __init__(
        self, case: Case, parts: Sequence[Part], flow: Flow, load: Load, tension: float
    ) -> None:
        self.parts, self.flow, self.load = parts, flow, load
        self.height, self.anchor_height = case.fairlead_height, case.anchor_height
        self.friction, self.length = case.site.seabed_friction, case.line.length
        self.span = load.span or 0.0
        self.is_plain = self.anchor_height == 0.0 and all(
            each.weight >= 0.0 and each.load >= 0.0 for each in parts
        )
        self.part = 1.0
        weights = (abs(each.weight * each.length) + abs(each.load) for each in parts)
        self.scale = math.fsum(weights) + tension

    def closed(self, known: list[float]) -> list[float]:
        """Find the forces under which the line ends at its anchor, the current put on in parts."""
        done, part = 0.0, 1.0
        while done < 1.0:
            self.part = min(1.0, done + part)
            found = self._newton(known)
            if found is not None:
                known, done = found, self.part
            elif part <= _LEAST_PART:
                self.check_taut(known)
                raise NotConvergedError(Message("catenary.current_not_converged", part=self.part))
            else:
                part *= 0.5
        return known

    def check_taut(self, known: Sequence[float]) -> None:
        """Refuse a line that the current slackens where it comes to the bed."""
        end = self._down(known, self.length)
        left = math.hypot(end.end.fx, end.end.fy)
        if end.lies is not None and left < _SLACK * self.scale:
            said = Message("refused_case.current_slackens", left=Measure("tension", left))
            raise InputError([Problem("current", "", said)], "current")

    def left_open(self, known: Sequence[float]) -> float:
        """Bound what an error of the place of the anchor leaves open of the forces, N."""
        left = self.missed(known)
        columns = None if left is None else self._columns(known, left)
        if columns is None:
            return math.inf
        open_by = [0.0] * len(known)
        for k in range(len(known)):
            far = [CLOSED * self.length * (i == k) for i in range(len(known))]
            step = solved(columns, far) or [math.inf] * len(known)
            open_by = [a + abs(b) for a, b in zip(open_by, step, strict=True)]
        return max(open_by)

    def laid(self, known: Sequence[float]) -> Laid:
        """Follow the line down at all its stations."""
        return self._down(known, self.length / STATIONS)

    def water(self, z: float) -> tuple[float, float]:
        """Velocity of the water at a height, so much of it as is put on."""
        u, v = self.flow(z)
        return self.part * u, self.part * v

    def top(self, known: Sequence[float]) -> Vector | None:
        """Complete the force at the fairlead; None where none is so."""
        *along, fy, fz = known
        if along:
            return along[0], fy, fz
        if self.load.horizontal_force is not None:
            return self.load.horizontal_force, fy, fz
        assert self.load.fairlead_tension is not None
        left = self.load.fairlead_tension**2 - fy * fy - fz * fz
        return (math.sqrt(left), fy, fz) if left > 0.0 else None

    def _down(self, known: Sequence[float], longest: float) -> Laid:
        force = self.top(known)
        assert force is not None
        start = Node(0.0, self.span, 0.0, self.height, *force, 0.0)
        scales = (self.length, self.scale)
        return followed(start, self.parts, self.water, scales, longest, self.is_plain)

    def missed(self, known: Sequence[float]) -> list[float] | None:
        """Say by how much the line misses its anchor where that is sought, m; None for nowhere."""
        if self.top(known) is None:
            return None
        x, y, z = self.missed_by(self._down(known, self.length))
        return [x, y, z] if self.load.span is not None else [y, z]

    def missed_by(self, laid: Laid) -> Vector:
        """Say by how much a line that is laid misses its anchor, m."""
        bed = lying(laid, self.parts, self.friction)
        if bed:
            return bed[-1].x, bed[-1].y, laid.end.z
        return laid.end.x, laid.end.y, laid.end.z - self.anchor_height

    def _newton(self, known: Sequence[float]) -> list[float] | None:
        """Seek the forces by differences; None where that does not settle."""
        at, left = list(known), self.missed(known)
        if left is None:
            return None
        for _ in range(_TRIALS):
            size = max(map(abs, left))
            if size <= CLOSED * self.length:
                return at
            columns = self._columns(at, left)
            step = None if columns is None else solved(columns, [-each for each in left])
            share = 1.0 if step is not None else 0.0
            while step is not None and share >= _LEAST_SHARE:
                there = [a + share * b for a, b in zip(at, step, strict=True)]
                new = self.missed(there)
                if new is not None and max(map(abs, new)) < (1.0 - 0.1 * share) * size:
                    at, left = there, new
                    break
                share *= 0.5
            else:
                return at if size <= ENOUGH * self.length else None
        return None

    def _columns(self, at: Sequence[float], left: Sequence[float]) -> list[list[float]] | None:
        """Return how what is missed changes with each force, m/N; None where one leads nowhere."""
        columns = []
        change = _DIFFERENCE * self.scale
        for k in range(len(at)):
            moved = self.missed([a + change * (i == k) for i, a in enumerate(at)])
            if moved is None:
                return None
            columns.append([(b - a) / change for a, b in zip(left, moved, strict=True)])
        return columns


def followed(
    start: Node,
    parts: Sequence[Part],
    flow: Flow,
    scales: tuple[float, float],
    longest: float,
    may_lie: bool,
) -> Laid:
    """Follow a line down from a node, in steps of no more than `longest` m, to its end or the bed.

    `scales`: a length and a force beside which errors are small.
    """
    found, at = [], start
    for part in parts:
        nodes, lies = _part_down(at, part, flow, scales, longest, may_lie)
        found.append(nodes)
        at = nodes[-1]
        if lies:
            return Laid(tuple(found), at, at.s, 0.0)
        if part.load or part.load_drag:
            u, v = flow(at.z)
            push = part.load_drag * math.hypot(u, v)
            at = at._replace(fx=at.fx + push * u, fy=at.fy + push * v, fz=at.fz - part.load)
            if may_lie and at.fz <= 0.0:
                return Laid(tuple(found), at._replace(fz=0.0), at.s, -at.fz)
    return Laid(tuple(found), at, None, 0.0)


def _part_down(
    at: Node,
    part: Part,
    flow: Flow,
    scales: tuple[float, float],
    longest: float,
    may_lie: bool,
) -> tuple[tuple[Node, ...], bool]:
    """Follow one part down; and say whether it comes to lie."""
    nodes, done = [at], 0.0
    stride = min(longest, 0.1 * part.length)
    for _ in range(_STEPS):
        if done >= part.length:
            return tuple(nodes), False
        ahead = part.length - done
        last = stride >= ahead * (1.0 - 1e-12)
        stride = min(stride, ahead)
        there, error = _stepped(nodes[-1], stride, part, flow, scales)
        if error > LOCAL:
            stride *= max(0.9 * (LOCAL / error) ** 0.2, 0.1)
            continue
        if may_lie and there.fz <= 0.0:
            nodes.append(_touchdown(nodes[-1], there, stride, part, flow, scales))
            return tuple(nodes), True
        nodes.append(there)
        done = part.length if last else done + stride
        growth = 0.9 * (LOCAL / error) ** 0.2 if error > 0.0 else 5.0
        stride = min(stride * min(max(growth, 0.2), 5.0), longest)
    raise NotConvergedError(Message("catenary.current_not_converged", part=1.0))


def _touchdown(
    at: Node, there: Node, stride: float, part: Part, flow: Flow, scales: tuple[float, float]
) -> Node:
    """Close in on where a step loses the last of the vertical force."""
    low, high, above, below = 0.0, stride, at.fz, there.fz
    for _ in range(60):
        if above - below <= 0.0 or high - low <= 1e-15 * stride or below == 0.0:
            break
        way = low + (high - low) * min(max(above / (above - below), 0.01), 0.99)
        there, _ = _stepped(at, way, part, flow, scales)
        if abs(there.fz) <= 1e-15 * scales[1]:
            break
        if there.fz > 0.0:
            low, above = way, there.fz
        else:
            high, below = way, there.fz
    return there._replace(fz=0.0)


_STAGES = (
    (1 / 5,),
    (3 / 40, 9 / 40),
    (44 / 45, -56 / 15, 32 / 9),
    (19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729),
    (9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656),
    (35 / 384, 0.0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84),
)
_FIFTH_LESS_FOURTH = (71 / 57600, 0.0, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40)
"""Runge and Kutta's method of Dormand and Prince, order 5 (4), J. Comp. Appl. Math. 6 (1980)."""


def _stepped(
    at: Node, stride: float, part: Part, flow: Flow, scales: tuple[float, float]
) -> tuple[Node, float]:
    """Take one step along the line; its error by the scales."""
    y: tuple[float, ...] = at[1:]
    slopes, new = [_slope(y, part, flow)], y
    for row in _STAGES:
        moved = [sum(map(float.__mul__, row, of)) for of in zip(*slopes, strict=True)]
        new = tuple(a + stride * b for a, b in zip(y, moved, strict=True))
        slopes.append(_slope(new, part, flow))
    off = [sum(map(float.__mul__, _FIFTH_LESS_FOURTH, of)) for of in zip(*slopes, strict=True)]
    error = max(max(map(abs, off[:3])) / scales[0], max(map(abs, off[3:6])) / scales[1])
    return Node(at.s + stride, *new), stride * error


def _slope(y: Sequence[float], part: Part, flow: Flow) -> tuple[float, ...]:
    """Say how place, force and stretched length change along the line, going down."""
    _, _, z, fx, fy, fz, _ = y
    T = math.sqrt(fx * fx + fy * fy + fz * fz)
    ex, ey, ez = (fx / T, fy / T, fz / T) if T > 0.0 else (0.0, 0.0, 1.0)
    u, v = flow(z)
    along = u * ex + v * ey
    nx, ny, nz = u - along * ex, v - along * ey, -along * ez
    across = part.across * math.sqrt(nx * nx + ny * ny + nz * nz)
    pull = part.along * abs(along) * along
    longer = 1.0 + T * part.compliance
    return (
        -longer * ex,
        -longer * ey,
        -longer * ez,
        across * nx + pull * ex,
        across * ny + pull * ey,
        across * nz + pull * ez - part.weight,
        longer,
    )


class OnBed(NamedTuple):
    """A place of what lies: arc length down from the fairlead, x and y, tension, stretched length.

    `part` is the one above it.
    """

    s: float
    x: float
    y: float
    tension: float
    stretched: float
    part: int


def lying(laid: Laid, parts: Sequence[Part], friction: float) -> list[OnBed]:
    """Lay the rest of a line on the bed, to its anchor; nothing where all of it hangs."""
    if laid.lies is None:
        return []
    end, k = laid.end, len(laid.parts) - 1
    T = math.hypot(end.fx, end.fy)
    way = (-end.fx / T, -end.fy / T) if T > 0.0 else (-1.0, 0.0)
    left = parts[k].length - (end.s - laid.parts[k][0].s)
    if laid.reaction > 0.0:  # from a clump weight on, at the lower end of the part
        T, left = max(T - parts[k].load_friction * laid.reaction, 0.0), 0.0
    rows = [OnBed(end.s, end.x, end.y, T, end.stretched, k)]
    while True:
        s, x, y, T, stretched, _ = rows[-1]
        if left > 0.0:
            T, longer = _dragged(T, left, parts[k], friction)
            place = (x + way[0] * longer, y + way[1] * longer)
            rows.append(OnBed(s + left, *place, T, stretched + longer, k))
            T = max(T - parts[k].load_friction * parts[k].load, 0.0)
            rows[-1] = rows[-1]._replace(tension=T)
        k += 1
        if k == len(parts):
            return rows
        left = parts[k].length


def _dragged(T: float, length: float, part: Part, friction: float) -> tuple[float, float]:
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


# ------------------------------------------------------------------ the answer


def _solution(case: Case, shot: _Shot, laid: Laid, left_open: float) -> SolutionInCurrent:
    """Say all of a line that is laid, counted from its anchor up."""
    assert case.current is not None
    parts, length, end, top = shot.parts, shot.length, laid.end, laid.parts[0][0]
    bed = lying(laid, parts, shot.friction)
    missed = shot.missed_by(laid)
    ax, ay = (bed[-1].x, bed[-1].y) if bed else (end.x, end.y)
    anchor_force = (end.fx, end.fy, end.fz)
    if bed:
        T = math.hypot(end.fx, end.fy)
        share = bed[-1].tension / T if T > 0.0 else 0.0
        anchor_force = (end.fx * share, end.fy * share, 0.0)
    rows = [(length - n.s, n.x - ax, n.y - ay, n.z, n.tension) for n in _nodes(laid)]
    rows += [(length - each.s, each.x - ax, each.y - ay, 0.0, each.tension) for each in bed[1:]]
    _check_clear(min(row[3] for row in rows), length)
    largest = [0.0] * len(case.line.segments)
    for k, tension in (
        *((k, n.tension) for k, nodes in enumerate(laid.parts) for n in nodes),
        *((each.part, each.tension) for each in bed),
    ):
        largest[parts[k].segment] = max(largest[parts[k].segment], tension)
    lifted = _lifted(laid, parts)
    span = -ax if case.load is None or case.load.span is None else case.load.span
    solution = SolutionInCurrent(
        line=case.line,
        method="shooting",
        regime=_regime(laid),
        fairlead_height=shot.height,
        anchor_height=shot.anchor_height,
        seabed_friction=shot.friction,
        span=span,
        fairlead=_end((top.fx, top.fy, top.fz)),
        anchor=_end(anchor_force),
        grounded_length=0.0 if laid.lies is None else length - laid.lies,
        suspended_length=length if laid.lies is None else laid.lies,
        stretched_length=bed[-1].stretched if bed else end.stretched,
        segments=tuple(
            SegmentState(segment.name, segment.length, tension, segment.MBL)
            for segment, tension in zip(case.line.segments, largest, strict=True)
        ),
        point_loads=_loads(case.line, rows, laid),
        stretches=_stretches(shot, laid, bed, (ax, ay)),
        residual=Residual(
            height=missed[2],
            span=math.hypot(missed[0] if case.load and case.load.span else 0.0, missed[1]),
            force_uncertainty=left_open,
        ),
        current=case.current,
        surface_velocity=shot.flow(case.site.water_depth),
        places=tuple(rows[::-1]),
        drag=(end.fx - top.fx, end.fy - top.fy, end.fz - top.fz + lifted),
        fairlead_force=(top.fx, top.fy, top.fz),
        anchor_force=anchor_force,
    )
    return replace(solution, warnings=(*plausibility(solution), *_warnings(solution)))


def _nodes(laid: Laid) -> list[Node]:
    """List the nodes of what hangs; both sides of a point load."""
    return [node for nodes in laid.parts for node in nodes]


def _lifted(laid: Laid, parts: Sequence[Part]) -> float:
    """Weight of what hangs, N."""
    last = len(laid.parts) - 1
    passed = last + (laid.lies is None or laid.reaction > 0.0)
    hung = (
        part.weight * (nodes[-1].s - nodes[0].s)
        for part, nodes in zip(parts, laid.parts, strict=False)
    )
    return math.fsum([*hung, *(part.load for part in parts[:passed]), -laid.reaction])


def _end(force: Vector) -> EndState:
    H = math.hypot(force[0], force[1])
    return EndState(math.hypot(H, force[2]), H, force[2], math.atan2(force[2], H))


def _regime(laid: Laid) -> Regime:
    if laid.lies is not None:
        return "grounded"
    return "below-anchor" if laid.end.fz < -1e-12 * laid.end.tension else "suspended"


def _check_clear(lowest: float, length: float) -> None:
    """Refuse a line that would pass through the bed."""
    if lowest < -ENOUGH * length:
        allowed = Message("refused_case.current_and_bed", depth=-lowest)
        raise InputError([Problem("current", "", allowed)], "current")


def _loads(
    line: Line, rows: Sequence[tuple[float, float, float, float, float]], laid: Laid
) -> tuple[PointLoadState, ...]:
    """Place each point load; what the bed carries in one place is shared by weight."""
    found = []
    for load in line.point_loads:
        down = line.length - load.position
        _, x, _, z, _ = min(rows, key=lambda row: abs(row[0] - load.position))
        carried = 0.0
        if laid.lies is not None and down > laid.lies * (1.0 - 1e-12):
            carried = load.submerged_weight
            if laid.reaction > 0.0 and down <= laid.lies * (1.0 + 1e-12):
                here = (o.submerged_weight for o in line.point_loads if o.position == load.position)
                carried *= laid.reaction / math.fsum(here)
        found.append(PointLoadState(load.name, load.position, x, z, carried))
    return tuple(found)


def _stretches(
    shot: _Shot, laid: Laid, bed: Sequence[OnBed], anchor: tuple[float, float]
) -> tuple[Stretch, ...]:
    """Cut the line at its nodes, from the anchor up, for pictures."""
    found = []
    for k, nodes in enumerate(laid.parts):
        part, piece = shot.parts[k], len(shot.parts) - 1 - k
        for upper, lower in pairwise(nodes):
            found.append(
                Stretch(
                    shot.length - lower.s,
                    lower.s - upper.s,
                    part.weight,
                    part.compliance,
                    lower.x - anchor[0],
                    lower.z,
                    math.hypot(lower.fx, lower.fy),
                    lower.fz,
                    0.0,
                    on_bed=False,
                    piece=piece,
                )
            )
    for one, other in pairwise(bed):
        part = shot.parts[other.part]
        found.append(
            Stretch(
                shot.length - other.s,
                other.s - one.s,
                part.weight,
                part.compliance,
                other.x - anchor[0],
                0.0,
                other.tension,
                0.0,
                (one.tension - other.tension) / (other.s - one.s),
                on_bed=True,
                piece=len(shot.parts) - 1 - other.part,
            )
        )
    return tuple(sorted(found, key=lambda each: each.start))


def _warnings(solution: SolutionInCurrent) -> list[Message]:
    """Say what the current does not act on, and what holds the fairlead across."""
    found = []
    if solution.grounded_length > 0.0:
        found.append(Message("catenary.current_not_on_bed", length=solution.grounded_length))
    _, side, _ = solution.fairlead_force
    if abs(side) > CLOSED * solution.fairlead.tension:
        force = Measure("horizontal_force", side)
        found.append(Message("catenary.current_across", force=force))
    return found
