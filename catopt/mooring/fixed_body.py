"""Bodies of a network: held in all six freedoms, or at rest under their loads; and how stiffly."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TypeVar

from catopt.catenary.in_current import ENOUGH
from catopt.catenary.on_float import hung_on_float
from catopt.errors import (
    CatoptError,
    FloatsUpError,
    InputError,
    NoEquilibriumError,
    NotConvergedError,
    Problem,
    refused,
)
from catopt.model import CurrentProfile, Site, System
from catopt.model.network import LineBetween, MooredBody, Network, Point
from catopt.model.plausible_ranges import NAMES
from catopt.mooring.chains import Row, apart, check_floats, in_rows, rows_of
from catopt.mooring.in_current import rest_in_current
from catopt.mooring.joints import (
    UNIT,
    Ends,
    Freed,
    JointsAtRest,
    Matrix,
    Moored,
    Pose,
    Run,
    Vector,
    assembled,
    by_turning,
    freed,
    joints_at_rest,
    moored,
    product,
    pulls_of,
    runs_of,
    solve,
)
from catopt.mooring.network_rest import (
    BodyAtRest,
    FloatingBody,
    FloatsInCurrent,
    HeldBody,
    HeldLine,
    LinesAtRest,
    LinesInCurrent,
    NetworkAtRest,
    Position,
)
from catopt.old_names import old_function
from catopt.words import Message

Answer = TypeVar("Answer")

_LOOSE = 1e-12
"""Of the largest stiffness: what a joint of slack lines is given of its own."""


def at_displacement(
    system: System, *, origin_height: float, displacement: tuple[float, ...] = (0.0,) * 6
) -> HeldBody:
    """Say what the lines do to a body that is held, and the linearised stiffness there.

    `system`: its force and moment play no part, its fairlead heights hold for no displacement;
    `origin_height`: of the point above the bed about which moments and rotations are taken, m, the
    water depth for the waterline; `displacement`: surge, sway, heave (m), roll, pitch, yaw (rad);
    the body is turned by roll first, then pitch, then yaw.

    InputError: a fairlead is straight above its anchor or below the bed, or a line hangs slack.
    NoEquilibriumError, NotConvergedError: as for `solve` of that line.

    Examples
    --------
    >>> from math import radians
    >>> from catopt import Line, Segment, System
    >>> from catopt.mooring.fixed_body import at_displacement
    >>> chain = Line([Segment(902.2, 698.0945, EA=384.243e6)])
    >>> spar = System.around(chain, azimuths=[0.0, radians(120.0), radians(240.0)],
    ...                      anchor_radius=853.87, fairlead_radius=5.2, fairlead_height=250.0)
    >>> body = at_displacement(spar, origin_height=320.0)
    >>> round(body.stiffness[0][0], 1), round(body.load[2] / 1e3, 1)
    (41181.2, -1607.2)
    """
    points, lines = [], []
    for k, leg in enumerate(system.legs):
        anchor = Point(f"anchor {k}", "anchor", *leg.anchor, leg.anchor_height)
        fairlead = Point(f"fairlead {k}", "fairlead", *leg.fairlead, leg.fairlead_height)
        points += [anchor, fairlead]
        lines.append(LineBetween(leg.line, anchor.name, fairlead.name))
    site = Site(origin_height, system.seabed_friction, accept=NAMES)
    return hold(Network(site, tuple(points), tuple(lines)), displacement).body


held_body = old_function("held_body", at_displacement)


def hold(network: Network, displacement: tuple[float, ...] = (0.0,) * 6) -> NetworkAtRest:
    """Hold a body whose lines meet in joints, bring the joints to rest, and say its stiffness.

    A line pulls on a point with (H u, -V), u being the unit vector towards its other end. With
    its end stiffness k = d(H, V)/d(span, height) it resists a small way of the point by
    k_HH u u' + (H / span) t t' in plan (t across u), coupled with height by k_HV and k_VH. The
    stiffness K of all lines over the joints (j) and the body (b) is condensed to that of the body,
    K_bb - K_bj K_jj^-1 K_jb; a fairlead at r off the origin carries forces into moments, and
    turning the force F on it about the origin adds [F][r] (cross-product matrices).

    The origin of the body is at x = y = 0, or where the body of the network has it, on the water
    surface; `displacement` as for `at_displacement`.
    InputError: a fairlead is below the bed, a line hangs slack, or there are several bodies.
    NoEquilibriumError, NotConvergedError, FloatsUpError: as for `joints_at_rest`.

    Examples
    --------
    A buoy of 5 kN where two ropes meet under water, 4 m of 5 m away from each end:

    >>> from catopt import Line, Segment
    >>> from catopt.model import Site
    >>> from catopt.model.network import LineBetween, MooredBody, Network, Point
    >>> from catopt.mooring.fixed_body import hold
    >>> rope = Line([Segment(5.0, 0.01, EA=1e9)])
    >>> points = [Point("port", "anchor", -4.0, 0.0, 10.0),
    ...           Point("buoy", "joint", submerged_weight=-5e3),
    ...           Point("starboard", "anchor", 4.0, 0.0, 10.0)]
    >>> lines = [LineBetween(rope, "port", "buoy"), LineBetween(rope, "starboard", "buoy")]
    >>> found = hold(Network(Site(20.0), points, lines))
    >>> round(found.place_of("buoy")[2], 3), round(found.lines[0].fairlead.tension, 1)
    (13.0, 4166.6)
    """
    network, origin = _with_its_body_held(network)
    return _with_floats(network, lambda rows: _held(network, rows, displacement, origin))


def _with_floats(network: Network, solve: Callable[[tuple[Row, ...]], Answer]) -> Answer:
    """Solve a network in rows, and with floats of rows as joints where they are not under water."""
    rows, floats_apart = rows_of(network), rows_of(network, floats_apart=True)
    try:
        return solve(rows)
    except (NoEquilibriumError, NotConvergedError, FloatsUpError):
        if rows == floats_apart:
            raise
    return solve(floats_apart)


def _held(
    network: Network,
    rows: tuple[Row, ...],
    displacement: tuple[float, ...],
    origin: tuple[float, float],
) -> NetworkAtRest:
    """Hold a body whose lines meet in joints, some of them in rows."""
    whole = in_rows(network, rows)
    arms, runs, found = _in_place(whole, displacement, origin)
    _check_pull(runs, found)
    load, stiffness = [0.0] * 6, _condensed(whole, runs, found, _by_six(arms), 6)
    for at, force in pulls_of(runs, found.ends):
        if at in arms:
            arm = _skew(arms[at])
            _add(load, (*force, *_times(arm, force)))
            for row, turned in zip(stiffness[3:], product(_skew(force), arm), strict=True):
                _add(row, (0.0, 0.0, 0.0, *(-each for each in turned)))
    runs, found = apart(network, rows, whole, found, runs)
    lines = []
    for run, end in zip(runs, found.ends, strict=True):
        place, state = found.places[run.second], end.state
        lines.append(HeldLine(place, state.span, state.H, state.V, state.grounded))
    body = HeldBody(
        tuple(displacement),
        network.site.water_depth,
        tuple(lines),
        tuple(load),
        tuple(tuple(row) for row in stiffness),
    )
    return NetworkAtRest(network, runs, found, body=body)


def _with_its_body_held(network: Network) -> tuple[Network, tuple[float, float]]:
    """Hold the one body that a network has, and say where its origin is; InputError for several."""
    if network.current_at_rest is not None:
        allowed = Message("refused_motion.nothing_is_held_in_a_current")
        raise refused("current", "", allowed, "held body")
    if not network.bodies:
        return network, (0.0, 0.0)
    if len(network.bodies) > 1 or any(p.kind == "fairlead" and not p.body for p in network.points):
        names = ", ".join(body.name for body in network.bodies)
        allowed = Message("refused_motion.held_is_of_one_body")
        raise refused("bodies", names, allowed, "held body")
    (body,) = network.bodies
    points = tuple(replace(point, body="") for point in network.points)
    return replace(network, points=points, bodies=()), (body.x, body.y)


def at_rest(network: Network, displacement: tuple[float, ...] = (0.0,) * 6) -> LinesAtRest:
    """Bring joints and free bodies to rest, what is held displaced; lines may hang slack.

    Bodies are brought to rest under no load first, and from there under their own. Where they do
    not come to rest so, they are under their own at once, and their offsets, which would count from
    there, are nan. Raises what `hold` raises, but for slack lines; NoEquilibriumError, too, where
    the lines cannot carry the moment on a body.

    Examples
    --------
    A barge on two lines of 1 kN/m, pulled along them and turned:

    >>> from catopt import Line, Segment
    >>> from catopt.model import Site
    >>> from catopt.model.network import LineBetween, MooredBody, Network, Point
    >>> from catopt.mooring.fixed_body import at_rest
    >>> chain = Line([Segment(220.0, 1000.0, EA=4e8)])
    >>> points = [Point("east", "anchor", 200.0, 0.0, 0.0),
    ...           Point("west", "anchor", -200.0, 0.0, 0.0),
    ...           Point("bow", "fairlead", 10.0, 0.0, 50.0, body="barge"),
    ...           Point("stern", "fairlead", -10.0, 0.0, 50.0, body="barge")]
    >>> lines = [LineBetween(chain, "east", "bow"), LineBetween(chain, "west", "stern")]
    >>> barge = MooredBody("barge", force=(50e3, 0.0), moment=1e5)
    >>> (body,) = at_rest(Network(Site(50.0), points, lines, bodies=(barge,))).bodies
    >>> round(body.offset[0], 3)
    9.866
    """
    if (current := network.current_at_rest) is not None:
        return _in_current(network, current, displacement)
    try:
        neutral = without_load(network, displacement)
    except (NoEquilibriumError, NotConvergedError) as error:
        rows = rows_of(network, floats_apart=True)
        return _loaded_alone(network, rows, displacement, error)
    return neutral.under(network.bodies)


def _loaded_alone(
    network: Network, rows: tuple[Row, ...], displacement: tuple[float, ...], error: CatoptError
) -> LinesAtRest:
    """Bring bodies to rest under their loads at once; raises the error where they have none."""
    whole = in_rows(network, rows)
    if whole.unloaded() == whole:
        raise error
    try:
        _, runs, found = _in_place(whole, displacement)
    except CatoptError:
        raise error from None
    _, held = _ends_held(whole, displacement)
    nowhere = found._replace(poses=(Pose(*(math.nan,) * 4),) * len(found.poses))
    start = WithoutLoad(network, rows, displacement, whole, runs, held, nowhere)
    return start.apart(network, whole, found)


@dataclass(frozen=True)
class WithoutLoad:
    """A network at rest without load on its bodies: from there every load is followed.

    `whole` is the network in rows, `held` the places of what is held, m.
    """

    network: Network
    rows: tuple[Row, ...]
    displacement: tuple[float, ...]
    whole: Network
    runs: tuple[Run, ...]
    held: dict[int, Vector]
    found: JointsAtRest

    def under(self, loaded: tuple[MooredBody, ...]) -> LinesAtRest:
        """Bring bodies to rest under their loads."""
        return self._with_floats(lambda start: start._under(loaded))

    def _with_floats(self, solve: Callable[[WithoutLoad], LinesAtRest]) -> LinesAtRest:
        """Solve from here; or where floats of rows come up, from where they are joints."""
        try:
            return solve(self)
        except FloatsUpError:
            rows = rows_of(self.network, floats_apart=True)
            if rows == self.rows:
                raise
        return solve(_without_load(self.network, rows, self.displacement))

    def _under(self, loaded: tuple[MooredBody, ...]) -> LinesAtRest:
        network, whole = (replace(each, bodies=loaded) for each in (self.network, self.whole))
        found = self.found
        if any(any(body.force) or body.moment for body in loaded):
            found = joints_at_rest(whole, self.runs, self.held, found)
        return self.apart(network, whole, found)

    def as_numbers(self) -> Freed:
        """Say by which freedoms it moves, from where it is."""
        return freed(self.whole, self.runs, self.held, self.found, pinned=False)

    def held_at(self, x: float, y: float) -> LinesAtRest:
        """Hold its one body off where it rests without load, m; it turns where it is free to."""
        return self._with_floats(lambda start: start._held_at(x, y))

    def _held_at(self, x: float, y: float) -> LinesAtRest:
        (pose,) = self.found.poses
        there = self.found._replace(poses=(pose._replace(x=pose.x + x, y=pose.y + y),))
        whole = self.whole.unloaded()
        found = joints_at_rest(whole, self.runs, self.held, there, pinned=True)
        return self.apart(self.network.unloaded(), whole, found)

    def apart(self, network: Network, whole: Network, found: JointsAtRest) -> LinesAtRest:
        """Part what was found into the network's own points, lines and bodies."""
        poses = zip(moored(whole, 0), found.poses, self.found.poses, strict=True)
        bodies = tuple(
            BodyAtRest(
                body.body,
                body.turns,
                _position(body.body, pose),
                _position(body.body, before),
                _in_plan(whole, self.runs, found, k),
                _floating(network, body, pose, self.runs, found.ends),
                body.arm,
            )
            for k, (body, pose, before) in enumerate(poses)
        )
        parted = apart(network, self.rows, whole, found, self.runs)
        return LinesAtRest(network, *parted, bodies)


def without_load(network: Network, displacement: tuple[float, ...] = (0.0,) * 6) -> WithoutLoad:
    """Bring a network to rest without load on its bodies; raises what `at_rest` raises."""
    if network.current_at_rest is not None:
        raise refused("current", "", Message("refused_motion.one_load_in_a_current"), "mooring")
    return _with_floats(network, lambda rows: _without_load(network, rows, displacement))


def _without_load(
    network: Network, rows: tuple[Row, ...], displacement: tuple[float, ...]
) -> WithoutLoad:
    whole = in_rows(network, rows)
    try:
        _, runs, found = _in_place(whole.unloaded(), displacement)
    except NoEquilibriumError as error:
        if whole.unloaded() == whole:
            raise
        said = Message("mooring.refused_without_load", refusal=error.message)
        raise NoEquilibriumError(said, error.quantity, error.missing) from error
    _, held = _ends_held(whole, displacement)
    check_floats(network, rows, whole, found, runs)
    return WithoutLoad(network, rows, displacement, whole, runs, held, found)


def _in_current(
    network: Network, current: CurrentProfile, displacement: tuple[float, ...]
) -> LinesInCurrent:
    """Bring all to rest in still water first, and in the current from there."""
    points = tuple(replace(p, drag_area=None, drag_coefficient=None) for p in network.points)
    still = at_rest(replace(network, points=points, current=None), displacement)
    if network.has_lone_floats:
        return _floats_in_current(network, current, still)
    _, held = _ends_held(network, displacement)
    of = freed(network, still.runs, held, still.joints, pinned=False)
    found, solutions = rest_in_current(network, current, still.runs, of, still.joints)
    bodies = tuple(
        replace(
            body,
            position=_position(each.body, pose),
            stiffness=_in_plan(network, still.runs, found, k),
            floating=_floating(network, each, pose, still.runs, found.ends),
        )
        for k, (body, each, pose) in enumerate(
            zip(still.bodies, moored(network, 0), found.poses, strict=True)
        )
    )
    return LinesInCurrent(
        network, still.runs, found, bodies, solutions=solutions, still=still.joints
    )


def _floats_in_current(
    network: Network, current: CurrentProfile, still: LinesAtRest
) -> FloatsInCurrent:
    """Bring floats to rest, each by its own line."""
    places, solutions, left = list(still.joints.places), [], 0.0
    lost = list(still.joints.lost)
    for run in still.runs:
        point, anchor = network.points[run.second], places[run.first]
        used = point.hung[2] - lost[run.second]
        found = hung_on_float(run.line, network.site, current, point, anchor[2], used)
        line, way = found.solution, (math.cos(found.direction), math.sin(found.direction))
        at = (anchor[0] + line.span * way[0], anchor[1] + line.span * way[1])
        places[run.second], lost[run.second] = (*at, line.fairlead_height), found.lost
        above = max(z for _, _, _, z, _ in line.places) - network.site.water_depth
        if point.is_float and above > ENOUGH * run.line.length:
            raise FloatsUpError(Message("mooring.line_floats_up", number=run.name, above=above))
        solutions.append(line)
        left = max(left, line.residual.span * line.fairlead.tension / run.line.length)
    joints = still.joints._replace(places=tuple(places), residual=left, lost=tuple(lost))
    return FloatsInCurrent(
        network, still.runs, joints, solutions=tuple(solutions), still=still.joints
    )


def _position(body: MooredBody, pose: Pose) -> Position:
    """Name a pose by where the origin is, and a yaw above -pi and up to pi rad."""
    yaw = math.nan if math.isnan(pose.yaw) else -math.remainder(-pose.yaw, math.tau)
    return Position(body.x + pose.x, body.y + pose.y, math.pi if yaw == -math.pi else yaw)


def _floating(
    network: Network, body: Moored, pose: Pose, runs: Sequence[Run], ends: Sequence[Ends]
) -> FloatingBody:
    """Say what lines pull a body down with, and how it floats under that."""
    pull = math.fsum(-force[2] for k, force in pulls_of(runs, ends) if k in body.arms)
    reserve = network.reserve_of(body.body)
    if not body.body.floats:
        return FloatingBody(pull, reserve)
    _, draught, freeboard = body.body.afloat
    left, per_metre = freeboard + pose.rise, network.per_metre(body.body)
    wet = min(max(draught - pose.rise, 0.0), draught + freeboard)
    laid = max(pull - per_metre * (wet - draught), 0.0) if body.is_on_bed(pose) else 0.0
    return FloatingBody(pull, reserve, draught - pose.rise, left, laid)


def _in_place(
    network: Network, displacement: tuple[float, ...], origin: tuple[float, float] = (0.0, 0.0)
) -> tuple[dict[int, Vector], tuple[Run, ...], JointsAtRest]:
    """Place the ends of lines, and bring the rest to rest: arms of fairleads, lines, joints."""
    arms, held = _ends_held(network, displacement, origin)
    runs = runs_of(network)
    return arms, runs, joints_at_rest(network, runs, held)


def _ends_held(
    network: Network, displacement: tuple[float, ...], origin: tuple[float, float] = (0.0, 0.0)
) -> tuple[dict[int, Vector], dict[int, Vector]]:
    """Place fairleads off the body's origin, turned with it; and these and anchors in space."""
    depth = network.site.water_depth
    turn = _rotation(*displacement[3:])
    arms, held = {}, {}
    for k, point in enumerate(network.points):
        if point.kind == "anchor":
            held[k] = point.place
        elif point.kind == "fairlead" and not point.body:
            x, y, height = point.place
            arms[k] = a, b, c = _times(turn, (x - origin[0], y - origin[1], height - depth))
            surge, sway, heave = displacement[:3]
            held[k] = (origin[0] + surge + a, origin[1] + sway + b, depth + heave + c)
            if not held[k][2] >= 0.0:
                found = f"{point.name} at {held[k][2]:.6g} m"
                allowed = Message("refused_motion.fairlead_must_not_be_below")
                raise refused("displacement", found, allowed, "held body")
    return arms, held


def _check_pull(runs: Sequence[Run], found: JointsAtRest) -> None:
    """Refuse a line that hangs slack."""
    allowed = Message("refused_motion.without_horizontal_force_has_no")
    problems = [
        Problem("displacement", Message("refused_file.line_hangs_slack", name=run.name), allowed)
        for run, each in zip(runs, found.ends, strict=True)
        if each.state.H == 0.0
    ]
    if problems:
        raise InputError(problems, "held body")


def _by_six(arms: Mapping[int, Vector]) -> dict[int, Matrix]:
    """Say how fairleads move by the six freedoms of the body that they are off by their arms."""
    return {
        k: tuple((*UNIT[i], *(-each for each in across)) for i, across in enumerate(_skew(arm)))
        for k, arm in arms.items()
    }


def _in_plan(network: Network, runs: Sequence[Run], found: JointsAtRest, number: int) -> Matrix:
    """Build the 3 x 3 stiffness of a free body in x, y and yaw, all else free to follow."""
    bodies = moored(network, 3 * sum(point.kind == "joint" for point in network.points))
    own, yaw = bodies[number]._replace(turns=True, first=0), found.poses[number].yaw
    scale = (1.0, 1.0, own.arm, 1.0)
    # Its height is free to follow as joints are, and comes before what it moves by.
    follows = {
        k: tuple((*row[3:], *map(float.__mul__, row[:3], scale)) for row in by)
        for k, (_, by) in own.motions(yaw).items()
    }
    others = [body for k, body in enumerate(bodies) if k != number]
    up = [_stiffness_afloat(network, own, found.poses[number])] if own.body.floats else []
    rows = _condensed(network, runs, found, follows, 3, others, up)
    rows[2][2] += by_turning(runs, found.ends, own, yaw)
    return tuple(tuple(row) for row in rows)


def _condensed(
    network: Network,
    runs: Sequence[Run],
    found: JointsAtRest,
    follows: Mapping[int, Matrix],
    size: int,
    others: Sequence[Moored] = (),
    own_up: Sequence[float] = (),
) -> list[list[float]]:
    """Build the stiffness of a body, the joints and the other bodies free to follow it.

    `follows`: how its fairleads move by its freedoms, of which there are `size`, after its height
    where that is free to follow, too: of water it is as stiff as `own_up`, N/m.
    """
    motions, added, free = _following(network, runs, found, others)
    motions |= {k: (free, by) for k, by in follows.items()}
    added |= dict(enumerate(own_up, start=free))
    free += len(own_up)
    matrix = assembled(runs, found.ends, motions, free + size)
    own = [row[free:] for row in matrix[free:]]
    if not free:
        return own
    inner, coupled = [row[:free] for row in matrix[:free]], [row[free:] for row in matrix[:free]]
    for k, more in added.items():
        if math.isinf(more):
            inner[k] = [float(i == k) for i in range(free)]
            coupled[k] = [0.0] * size
        else:
            inner[k][k] += more
    least = _LOOSE * max(
        matrix[i][i] + added.get(i, 0.0) for i in range(free + size) if added.get(i) != math.inf
    )
    for i in range(free):
        inner[i][i] += least  # where slack lines meet
    follow = solve(inner, coupled)
    for i, row in enumerate(product([row[:free] for row in matrix[free:]], follow)):
        for j in range(size):
            own[i][j] -= row[j]
    return own


def _following(
    network: Network, runs: Sequence[Run], found: JointsAtRest, others: Sequence[Moored]
) -> tuple[dict[int, tuple[int, Matrix]], dict[int, float], int]:
    """Say how points move by the freedoms of joints and of other bodies, and how many these are.

    In between, what their stiffness has beside that of lines: as arms turn, of the surface and of
    the bed, N/m by freedom.
    """
    joints = [k for k, point in enumerate(network.points) if point.kind == "joint"]
    motions = {point: (3 * k, UNIT) for k, point in enumerate(joints)}
    free, added = 3 * len(joints), dict[int, float]()
    for point, k in zip(joints, range(2, free, 3), strict=True):
        at = network.points[point]
        added[k] = _stiffness_up(at, found.reactions[point], found.lost[point])
    for each in others:
        body, pose = each._replace(first=free), found.poses[network.bodies.index(each.body)]
        motions |= body.motions(pose.yaw)
        if body.turns:
            added[body.turn] = by_turning(runs, found.ends, body, pose.yaw) / body.arm**2
        if body.up >= 0:
            added[body.up] = _stiffness_afloat(network, body, pose)
        free += body.freedoms
    return motions, added, free


def _stiffness_up(point: Point, reaction: float, lost: float) -> float:
    """Say how stiffly bed and surface hold a joint, N/m: inf where it stays on one of them."""
    if not 0.0 < lost < point.lost_above:
        return math.inf if reaction > 0.0 else 0.0
    return point.lost_above / point.float_height if point.float_height else math.inf


def _stiffness_afloat(network: Network, body: Moored, pose: Pose) -> float:
    """Say how stiffly water holds a body that floats, N/m: inf where it lies on the bed."""
    _, draught, freeboard = body.body.afloat
    is_partly_wet = -freeboard < pose.rise < draught
    water = network.per_metre(body.body) if is_partly_wet else 0.0
    return math.inf if body.is_on_bed(pose) else water


def _rotation(roll: float, pitch: float, yaw: float) -> Matrix:
    """Turn by roll about x, then pitch about y, then yaw about z."""
    cr, sr = math.cos(roll), math.sin(roll)
    cp, sp = math.cos(pitch), math.sin(pitch)
    cy, sy = math.cos(yaw), math.sin(yaw)
    return (
        (cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr),
        (sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr),
        (-sp, cp * sr, cp * cr),
    )


def _skew(v: Sequence[float]) -> Matrix:
    """Build the matrix that crosses v with what it multiplies."""
    return ((0.0, -v[2], v[1]), (v[2], 0.0, -v[0]), (-v[1], v[0], 0.0))


def _times(matrix: Matrix, v: Sequence[float]) -> Vector:
    x, y, z = (math.fsum(map(float.__mul__, row, v)) for row in matrix)
    return x, y, z


def _add(total: list[float], more: tuple[float, ...] | list[float]) -> None:
    for i, each in enumerate(more):
        total[i] += each
