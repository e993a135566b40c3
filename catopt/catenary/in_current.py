"""One line at rest in a current: its equations along the line, by shooting from its lower end.

With the unstretched arc length s from the anchor, the place r, the force F of what is above on what
is below, T = |F| and e = F/T:

    dr/ds = (1 + T/EA) e        dF/ds = w k - f

k being up, w the submerged weight and f the drag, both per unstretched length as in the truss
model, S4 [2.19]-[2.32]:

    f = 0.5 rho D (C_n |u_n| u_n + C_t |u_t| u_t)        u_t = (u.e) e,  u_n = u - u_t

Sought are F at the anchor, or F and how much lies, until the line ends at its fairlead. Where part
of it lies, F has no vertical part at the touchdown; from there to the anchor the line lies straight
on as it came down, without drag, the friction taking off its tension. A clump weight that touches
the bed feels so much of its drag as of its weight is lifted.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Annotated, NamedTuple

from catopt.catenary.along_current import Node, Vector, along, dragged, parts_of, solved
from catopt.catenary.current_sweep import swept
from catopt.catenary.layout import Profile, Stretch
from catopt.catenary.solution import (
    PointLoadState,
    Residual,
    Solution,
    end_state,
    plausibility,
    segment_states,
)
from catopt.catenary.solve import solve
from catopt.catenary.state import Regime
from catopt.errors import InputError, NotConvergedError, refused
from catopt.model import Case, CurrentProfile, Line, Load, Site
from catopt.model.kinds import Force, Speed
from catopt.model.line import drag_missing
from catopt.model.sea import ProfileKind
from catopt.records import From, Record
from catopt.words import Measure, Message

Row = tuple[float, float, float, float, float]
"""Arc length from the anchor, x, y, z (m) and tension (N)."""

CLOSED, ENOUGH = 1e-10, 1e-8
"""How far the line may miss its fairlead, as a part of its length: sought, and where it stalls."""
STATIONS = 200
"""Fewest places at which the line is laid out."""

_STARTS = (-0.95, -0.6, -0.2, 0.2, 0.6, 0.95)
"""Horizontal part of the tension with which other equilibria are sought."""
_APART = 1e-5
"""Part of the line's length by which spans of two equilibria differ."""

_TRIALS, _LEAST_SHARE = 40, 1e-3
_DIFFERENCE = 1e-5
"""Of the forces, by which they are changed for derivatives."""
_SLACK = 0.02
"""Of the line's weight and load: less tension than that at the touchdown is nearly none."""
_LEAST_PART = 1.0 / 16.0
"""Of the current, in which it is put on where it cannot be at once."""


@dataclass(frozen=True)
class CurrentEffect(Record):
    """What a current does to a line; x is the direction from its anchor to its fairlead."""

    DOCUMENT = "profile surface_velocity drag fairlead_force anchor_force"

    profile: ProfileKind
    """How the speed depends on the depth."""
    surface_velocity: Annotated[tuple[Speed, ...], From(2)]
    """Of the water at the surface, along x and y."""
    drag: Annotated[tuple[Force, ...], From(2)]
    """Of the whole line, along x, y and up."""
    fairlead_force: Annotated[tuple[Force, ...], From(2)]
    """That holds the fairlead, along x, y and up."""
    anchor_force: Annotated[tuple[Force, ...], From(2)]
    """With which the line pulls on its anchor, along x, y and up."""


@dataclass(frozen=True, repr=False, kw_only=True)
class SolutionInCurrent(Solution):
    """Equilibrium of one line in a current.

    The anchor lies at x = y = 0, x towards the fairlead. `places` are rows of unstretched arc
    length from the anchor, x, y, z (m) and tension (N); `drag` is that of the whole line,
    `fairlead_force` what holds it there, `anchor_force` what it pulls on its anchor with, N along
    x, y and up.
    """

    DOCUMENT = Solution.DOCUMENT + " effect=current"

    current: CurrentProfile
    surface_velocity: tuple[float, float]
    places: tuple[Row, ...]
    drag: Vector
    fairlead_force: Vector
    anchor_force: Vector

    @property
    def effect(self) -> CurrentEffect:
        """Only with method shooting: what the current does to the line."""
        given = (self.surface_velocity, self.drag, self.fairlead_force, self.anchor_force)
        return CurrentEffect(self.current.profile, *given)

    def profile(self, points: int = 101) -> Profile:
        """Sample the shape and the tension at about so many of the places, from the anchor up."""
        last = len(self.places) - 1
        kept = dict.fromkeys((*range(0, last + 1, max(1, last // max(points - 1, 1))), last))
        s, x, y, z, tension = zip(*(self.places[k] for k in kept), strict=True)
        return Profile(s, x, z, tension, y)


class Laid(NamedTuple):
    """The line from its anchor up: the nodes of what lies, and of each part that hangs.

    `bed` has part and node, none where all hangs; `hung` begins with part `first`; `reaction` is
    what the bed carries of a clump weight at the touchdown, N; `pull` that on the anchor.
    """

    bed: tuple[tuple[int, Node], ...]
    hung: tuple[tuple[Node, ...], ...]
    first: int
    reaction: float
    pull: Vector

    @property
    def top(self) -> Node:
        """The upper end."""
        return self.hung[-1][-1]

    def loose(self, to: tuple[float, float]) -> Laid:
        """Move what hangs to where its upper end is, and what lies to below that."""
        x, y = to[0] - self.top.x, to[1] - self.top.y
        last = self.bed[-1][1]
        a, b, length = last.x + x, last.y + y, last.s or 1.0
        bed = ((k, n._replace(x=a * n.s / length, y=b * n.s / length)) for k, n in self.bed)
        hung = (tuple(n._replace(x=n.x + x, y=n.y + y) for n in nodes) for nodes in self.hung)
        return self._replace(bed=tuple(bed), hung=tuple(hung))


def solve_in_current(case: Case) -> SolutionInCurrent:
    """Solve the line of a case at rest in its current, under its load.

    The fairlead is held in its height and across x; a horizontal force is its part along x.
    InputError: a segment without drag, or a state that is not solved in a current.
    NoEquilibriumError: as for `solve` in still water. NotConvergedError.
    """
    assert case.current is not None
    assert case.load is not None
    if lacks := drag_missing(case.line):
        raise InputError(lacks, "current")
    load = case.load
    still = solve(case.line, **vars(load), **case.place)
    shot = Shot(case.line, case.site, case.current, case.anchor_height, still.fairlead.tension)
    shot.is_under_water = case.fairlead_height <= case.site.water_depth

    def missed(top: Node) -> Vector:
        if load.span is not None:
            first = top.x - load.span
        else:
            wanted = load.horizontal_force or load.fairlead_tension or 0.0
            given = top.fx if load.horizontal_force is not None else top.tension
            first = (given - wanted) * shot.per_force
        return first, top.y, top.z - case.fairlead_height

    shot.missed_by = missed
    lifted = still.fairlead.vertical_force - case.line.submerged_weight
    shot.in_still_water = still.horizontal_force
    known, others = _known(shot, load, case.fairlead_height, lifted)
    found = laid_in_current(shot, known)
    highest = max(z for _, _, _, z, _ in found.places)
    if shot.is_under_water and highest > case.site.water_depth + ENOUGH * shot.length:
        shot.is_under_water = False  # a line that floats: above the water nothing flows
        known, others = _known(shot, load, case.fairlead_height, lifted)
        found = laid_in_current(shot, known)
    span = found.span if load.span is None else load.span
    found = replace(found, fairlead_height=case.fairlead_height, span=span)
    spans = [] if load.fairlead_tension is None else _other_spans(shot, others, span)
    if spans:
        said = ", ".join(f"{each:.4g}" for each in spans)
        told = Message("catenary.several_spans", span=span, others=said)
        found = replace(found, warnings=(told, *found.warnings))
    return found


def _known(
    shot: Shot, load: Load, height: float, lifted: float
) -> tuple[list[float], list[list[float]]]:
    """Find what is sought, and from where other equilibria with a tension given are looked for."""
    try:
        known = shot.closed([shot.in_still_water, 0.0, lifted])
    except NotConvergedError:
        first, *others = swept(shot, load, height)
        return first, others
    if load.fairlead_tension is None:
        return known, []
    tension, weight = load.fairlead_tension, shot.line.submerged_weight
    ups = ((each, tension * math.sqrt(1.0 - each * each) - weight) for each in _STARTS)
    tried = (shot.newton([share * tension, 0.0, up]) for share, up in ups)
    return known, [each for each in tried if each is not None]


def _other_spans(shot: Shot, others: Sequence[list[float]], span: float) -> list[float]:
    """List the spans of other equilibria, those that do not come below the bed, m."""
    found: list[float] = []
    for known in others:
        laid = shot.laid(known, shot.length)
        if (
            laid is None
            or laid.top.x < 0.0 < span  # the same on the other side of the anchor
            or min(n.z for ns in laid.hung for n in ns) < -ENOUGH * shot.length
        ):
            continue
        if all(abs(laid.top.x - each) > _APART * shot.length for each in (span, *found)):
            found.append(laid.top.x)
    return sorted(found)


class Shot:
    """What is aimed at: the fairlead under its load.

    Sought are the horizontal force at the lower end of what hangs, along x and y, and what the
    anchor is pulled up with; below 0 that is the weight of what lies, N.
    """

    in_still_water = math.inf
    """The horizontal force without the current, N."""
    loose_to: tuple[float, float] | None = None
    """Where the upper end of a slack line is, m: what lies goes loosely to where it comes up."""
    is_under_water = False
    """Whether the fairlead is: the surface flow then goes on above it, where only trials come."""
    missed_by: Callable[[Node], Vector]
    """By how much an upper end is off: in its place, or in its force as m, by `per_force`."""

    def __init__(
        self, line: Line, site: Site, current: CurrentProfile, anchor_height: float, tension: float
    ) -> None:
        self.line, self.site, self.current = line, site, current
        self.flow = current.flow(site.water_depth)
        self.parts = parts_of(line, site.water_density, site.seabed_friction)
        self.anchor_height = anchor_height
        self.friction, self.length = site.seabed_friction, line.length
        self.may_lie = self.anchor_height == 0.0 and self.parts[0].weight >= 0.0
        self.part = 1.0
        weights = (abs(each.weight * each.length) + abs(each.load) for each in self.parts)
        self.scale = math.fsum(weights) + tension
        self.per_force = self.length / self.scale

    def hang_between(self, first: float, second: float) -> None:
        """Take other heights of its ends, m."""
        self.anchor_height = first
        self.may_lie = first == 0.0 and self.parts[0].weight >= 0.0
        self.is_under_water = max(first, second) <= self.site.water_depth

    def closed(self, known: list[float], whole: float = 1.0) -> list[float]:
        """Find what is sought, the current put on in parts where it cannot be at once.

        `whole`: so much of it as there is.
        """
        done, part = 0.0, 1.0
        while done < 1.0:
            there = min(1.0, done + part)
            self.part = whole * there
            found = self.newton(known)
            if found is not None:
                known, done = found, there
            elif part <= _LEAST_PART:
                self.check_taut(known)
                raise NotConvergedError(Message("catenary.current_not_converged", part=self.part))
            else:
                part *= 0.5
        return known

    def check_taut(self, known: Sequence[float]) -> None:
        """Refuse a line that the current slackens where it comes to the bed."""
        left = math.hypot(known[0], known[1])
        if self.may_lie and known[2] < 0.0 and left < _SLACK * self.scale:
            was_slack = self.in_still_water < _SLACK * self.scale
            key = (
                "refused_case.slack_in_still_water"
                if was_slack
                else "refused_case.current_slackens"
            )
            said = Message(key, left=Measure("tension", self.in_still_water if was_slack else left))
            raise refused("current", "", said, "current")

    def left_open(self, known: Sequence[float]) -> float:
        """Bound what an error of the place of the fairlead leaves open of the forces, N."""
        left = self.missed(known)
        columns = None if left is None else self._columns(known, left)
        if columns is None:
            return math.inf
        open_by = [0.0] * 3
        for k in range(3):
            far = [CLOSED * self.length * (i == k) for i in range(3)]
            step = solved(columns, far) or [math.inf] * 3
            open_by = [a + abs(b) for a, b in zip(open_by, step, strict=True)]
        return max(open_by)

    def water(self, z: float) -> tuple[float, float]:
        """Velocity of the water at a height, so much of it as is put on."""
        u, v = self.flow(min(z, self.site.water_depth) if self.is_under_water else z)
        return self.part * u, self.part * v

    def laid(self, known: Sequence[float], longest: float) -> Laid | None:
        """Follow the line from its anchor up, in steps of no more than `longest` m.

        None where more would lie than there is.
        """
        fx, fy, up = known
        if up >= 0.0 or not self.may_lie:
            start = Node(0.0, 0.0, 0.0, self.anchor_height, fx, fy, up, 0.0)
            hung = self._upwards(start, 0, self.parts[0].length, longest)
            return Laid((), hung, 0, 0.0, (fx, fy, up))
        lies = -up
        for k, part in enumerate(self.parts):
            if part.load < 0.0 or part.weight < 0.0:
                return None  # a buoy does not lie
            if lies < part.load:
                return self._from_bed(k, 0.0, lies, (fx, fy), longest)
            lies -= part.load
            if lies < part.weight * part.length:
                return self._from_bed(k, lies / part.weight, 0.0, (fx, fy), longest)
            lies -= part.weight * part.length
        return None

    def top(self, known: Sequence[float]) -> Node:
        """Return the upper end of what is found."""
        laid = self.laid(known, self.length)
        assert laid is not None
        return laid.top

    def _from_bed(
        self, k: int, lying: float, reaction: float, force: tuple[float, float], longest: float
    ) -> Laid:
        """Lay the line up to a place in part k, or a clump weight on its lower end; and go on."""
        part, (fx, fy), up = self.parts[k], force, 0.0
        if reaction > 0.0:  # it hangs on from a clump weight: with what is lifted of it
            up = part.load - reaction
            u, v = self.water(0.0)
            push = part.load_drag * math.hypot(u, v) * up / part.load
            fx, fy = fx - push * u, fy - push * v
        T = math.hypot(*force)
        way = (force[0] / T, force[1] / T) if T > 0.0 else (1.0, 0.0)
        bed = self._bed(k, lying, reaction, T, way)
        _, last = bed[-1]
        start = last._replace(fx=fx, fy=fy, fz=up)
        hung = self._upwards(start, k, part.length - lying, longest)
        end = bed[0][1]
        laid = Laid(tuple(bed), hung, k, reaction, (end.fx, end.fy, 0.0))
        return laid if self.loose_to is None else laid.loose(self.loose_to)

    def _bed(
        self, k: int, lying: float, reaction: float, T: float, way: tuple[float, float]
    ) -> list[tuple[int, Node]]:
        """Lay parts on the bed from the anchor to a place in part k; T is the tension there."""
        rows: list[tuple[int, float, float, float]] = [(k, 0.0, 0.0, T)]  # down from that place
        if reaction > 0.0:
            T = max(T - self.parts[k].load_friction * reaction, 0.0)
        down = stretched = 0.0
        for j in range(k, -1, -1):
            part = self.parts[j]
            length = lying if j == k else part.length
            if length > 0.0:
                T, longer = dragged(T, length, part, self.friction)
                down, stretched = down + length, stretched + longer
                rows.append((j, down, stretched, T))
            if not (j == k and reaction > 0.0):
                T = max(T - part.load_friction * part.load, 0.0)
        place = sum(part.length for part in self.parts[:k]) + lying
        found = []
        for j, below, longer, tension in reversed(rows):
            along = stretched - longer
            x, y = along * way[0], along * way[1]
            force = (tension * way[0], tension * way[1], 0.0)
            found.append((j, Node(place - below, x, y, 0.0, *force, along)))
        return found

    def _upwards(
        self, start: Node, k: int, length: float, longest: float
    ) -> tuple[tuple[Node, ...], ...]:
        """Follow what is left of part k, and all above it."""
        scales = (self.length, self.scale)
        found = [along(start, length, self.parts[k], self.water, scales, longest)]
        for part in self.parts[k + 1 :]:
            at = found[-1][-1]
            if part.load or part.load_drag:
                u, v = self.water(at.z)
                push = part.load_drag * math.hypot(u, v)
                at = at._replace(fx=at.fx - push * u, fy=at.fy - push * v, fz=at.fz + part.load)
            found.append(along(at, part.length, part, self.water, scales, longest))
        return tuple(found)

    def missed(self, known: Sequence[float]) -> list[float] | None:
        """Say by how much the line misses what is aimed at, m; None for nowhere."""
        try:
            laid = self.laid(known, self.length)
        except NotConvergedError:  # nearly no tension somewhere: its direction is not followed
            return None
        return None if laid is None else list(self.missed_by(laid.top))

    def newton(self, known: Sequence[float]) -> list[float] | None:
        """Seek by differences; None where that does not settle."""
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
        for k in range(3):
            moved = self.missed([a + change * (i == k) for i, a in enumerate(at)])
            if moved is None:
                return None
            columns.append([(b - a) / change for a, b in zip(left, moved, strict=True)])
        return columns


# ------------------------------------------------------------------ the answer


def laid_in_current(
    shot: Shot, known: Sequence[float], direction: float = 0.0
) -> SolutionInCurrent:
    """Say all of a line that is found, with x in a direction (rad)."""
    laid = shot.laid(known, shot.length / STATIONS)
    assert laid is not None
    c, s = math.cos(direction), math.sin(direction)

    def turned(of: Vector) -> Vector:
        return c * of[0] + s * of[1], c * of[1] - s * of[0], of[2]

    line, top = shot.line, laid.top
    pull, fairlead_force = turned(laid.pull), turned((top.fx, top.fy, top.fz))
    lowest = min(node.z for nodes in laid.hung for node in nodes)
    if lowest < -ENOUGH * shot.length:
        allowed = Message("refused_case.current_and_bed", depth=-lowest)
        raise refused("current", "", allowed, "current")
    placed = [*laid.bed, *((laid.first + k, n) for k, ns in enumerate(laid.hung) for n in ns)]
    largest = [0.0] * len(line.segments)
    for k, node in placed:
        segment = shot.parts[k].segment
        largest[segment] = max(largest[segment], node.tension)
    grounded = laid.hung[0][0].s if laid.bed else 0.0
    first, across, height = shot.missed_by(top)
    places = [(n.s, *turned((n.x, n.y, n.z)), n.tension) for _, n in placed]
    below = turned(laid.bed[-1][1][4:7]) if laid.bed else pull
    upper = shot.parts[laid.first :]
    lifted = math.fsum(
        [
            *(p.weight * (ns[-1].s - ns[0].s) for p, ns in zip(upper, laid.hung, strict=True)),
            *(part.load for part in upper[1:]),
            upper[0].load - laid.reaction if laid.reaction > 0.0 else 0.0,
        ]
    )
    solution = SolutionInCurrent(
        line=line,
        method="shooting",
        regime=_regime(laid),
        fairlead_height=top.z,
        anchor_height=shot.anchor_height,
        seabed_friction=shot.friction,
        span=places[-1][1],
        fairlead=end_state(math.hypot(*fairlead_force[:2]), fairlead_force[2]),
        anchor=end_state(math.hypot(*pull[:2]), pull[2]),
        grounded_length=grounded,
        suspended_length=shot.length - grounded,
        stretched_length=top.stretched,
        segments=segment_states(line, largest),
        point_loads=_loads(line, places, laid),
        stretches=tuple(_stretches(shot, laid, placed, places)),
        residual=Residual(
            height=height, span=math.hypot(first, across), force_uncertainty=shot.left_open(known)
        ),
        current=shot.current,
        surface_velocity=shot.flow(shot.site.water_depth),
        places=tuple(places),
        drag=(
            below[0] - fairlead_force[0],
            below[1] - fairlead_force[1],
            below[2] - fairlead_force[2] + lifted,
        ),
        fairlead_force=fairlead_force,
        anchor_force=pull,
    )
    return replace(solution, warnings=(*plausibility(solution), *_warnings(solution)))


def _regime(laid: Laid) -> Regime:
    if laid.bed:
        return "grounded"
    return "below-anchor" if laid.pull[2] < -1e-12 * laid.hung[0][0].tension else "suspended"


def _loads(line: Line, places: Sequence[Row], laid: Laid) -> tuple[PointLoadState, ...]:
    """Place each point load; what the bed carries in one place is shared by weight."""
    found = []
    lies = laid.hung[0][0].s
    for load in line.point_loads:
        _, x, y, z, _ = min(places, key=lambda row: abs(row[0] - load.position))
        carried = 0.0
        if laid.bed and load.position <= lies * (1.0 + 1e-12):
            carried = load.submerged_weight
            if laid.reaction > 0.0 and load.position >= lies * (1.0 - 1e-12):
                here = (o.submerged_weight for o in line.point_loads if o.position == load.position)
                carried *= laid.reaction / math.fsum(here)
        found.append(PointLoadState(load.name, load.position, x, z, carried, y))
    return tuple(found)


def _stretches(
    shot: Shot, laid: Laid, placed: Sequence[tuple[int, Node]], places: Sequence[Row]
) -> Iterator[Stretch]:
    """Cut the line at its nodes, from the anchor up, for pictures."""
    lies = laid.hung[0][0].s
    rows = zip(placed, places, strict=True)
    for ((_, low), (_, x, *_)), ((k, high), _) in pairwise(rows):
        if not high.s > low.s:  # two sides of one place
            continue
        part, on_bed = shot.parts[k], high.s <= lies
        yield Stretch(
            low.s,
            high.s - low.s,
            part.weight,
            part.compliance,
            x,
            low.z,
            math.hypot(low.fx, low.fy),
            low.fz,
            (high.tension - low.tension) / (high.s - low.s) if on_bed else 0.0,
            on_bed=on_bed,
            piece=k,
        )


def _warnings(solution: SolutionInCurrent) -> Iterator[Message]:
    """Say what the current does not act on, and what holds the fairlead across."""
    if solution.grounded_length > 0.0:
        yield Message("catenary.current_not_on_bed", length=solution.grounded_length)
    _, side, _ = solution.fairlead_force
    if abs(side) > CLOSED * solution.fairlead.tension:
        yield Message("catenary.current_across", force=Measure("horizontal_force", side))
