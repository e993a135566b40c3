"""A body held where somebody puts it, in all six freedoms: what its lines do, and how stiffly."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from catopt.catenary.result import solution_of
from catopt.catenary.root_search import BY_SPAN
from catopt.catenary.solution import Solution
from catopt.errors import InputError, Problem
from catopt.model import Site, System
from catopt.model.network import LineBetween, Network, Point
from catopt.mooring.chains import apart, in_rows, rows_of
from catopt.mooring.joints import (
    UNIT,
    JointsAtRest,
    Run,
    assembled,
    joints_at_rest,
    product,
    runs_of,
    solve,
)
from catopt.mooring.line_ends import Matrix, Vector
from catopt.words import Message

FREEDOMS = ("surge", "sway", "heave", "roll", "pitch", "yaw")
"""Along x, y and z (up), and about them in the sense of the right hand."""


@dataclass(frozen=True)
class HeldLine:
    """One line at that place: fairlead x, y, height above the bed (m), span, length on the bed (m).

    It pulls on the body with horizontal_force towards its anchor and vertical_force down, N.
    """

    fairlead: Vector
    span: float
    horizontal_force: float
    vertical_force: float
    grounded: float

    @property
    def tension(self) -> float:
        """Effective tension at the fairlead, N."""
        return math.hypot(self.horizontal_force, self.vertical_force)


@dataclass(frozen=True)
class HeldBody:
    """What the lines do to a body that is held at a displacement: m and rad, by FREEDOMS.

    `origin_height`: of the body's origin above the bed when nothing is displaced, m; `lines`: in
    the order of `System.legs`; `load`: of the lines on the body, three forces (N) and three moments
    about its origin (N m), its own weight and buoyancy no part of it; `stiffness`: minus the
    derivatives of the load by a small further displacement, N/m, N, N m/rad. Rotations are about
    axes through the origin that stay parallel to x, y and z. It is symmetric where the moment of
    the lines about the origin is zero and no line lies on a bed with friction.
    """

    displacement: tuple[float, ...]
    origin_height: float
    lines: tuple[HeldLine, ...]
    load: tuple[float, ...]
    stiffness: Matrix

    @property
    def by_freedom(self) -> dict[str, float]:
        """The displacement by the name of the freedom; m, rad."""
        return dict(zip(FREEDOMS, self.displacement, strict=True))

    def to_dict(self) -> dict[str, Any]:
        """Lay it out as the documents have it."""
        return {
            "displacement": list(self.displacement),
            "origin_height_m": self.origin_height,
            "load": list(self.load),
            "stiffness": [list(row) for row in self.stiffness],
            "lines": [
                {
                    "fairlead_m": list(line.fairlead),
                    "span_m": line.span,
                    "horizontal_force_N": line.horizontal_force,
                    "vertical_force_N": line.vertical_force,
                    "grounded_length_m": line.grounded,
                }
                for line in self.lines
            ],
        }


@dataclass(frozen=True)
class LinesAtRest:
    """Lines between points with their joints at rest, the body held; `runs` from their anchors."""

    network: Network
    runs: tuple[Run, ...]
    joints: JointsAtRest

    def place_of(self, name: str) -> Vector:
        """X, y and height of a point, m."""
        return self.joints.places[self.network.numbers[name]]

    @property
    def lines(self) -> tuple[Solution, ...]:
        """Every line laid out between its ends, the first of which is its `anchor`."""
        return tuple(
            solution_of(
                end.state,
                run.line,
                end.problem,
                run.segment_of,
                method="closed-form",
                known=BY_SPAN,
            )
            for run, end in zip(self.runs, self.joints.ends, strict=True)
        )

    def is_anchored(self, line: int) -> bool:
        """Whether a line, counted from 0, ends at an anchor: its first end then."""
        return self.network.points[self.runs[line].first].kind == "anchor"


@dataclass(frozen=True)
class NetworkAtRest(LinesAtRest):
    """The same, with what the lines do to the body."""

    body: HeldBody

    def to_dict(self) -> dict[str, Any]:
        """Lay it out as the documents have it."""
        points, found = self.network.points, self.joints
        return {
            "displacement": list(self.body.displacement),
            "points": [
                {
                    "name": point.name,
                    "kind": point.kind,
                    "place_m": list(place),
                    "bed_reaction_N": up,
                }
                for point, place, up in zip(points, found.places, found.reactions, strict=True)
            ],
            "lines": [
                {
                    "name": run.name,
                    "from": points[run.first].name,
                    "to": points[run.second].name,
                    "span_m": line.span,
                    "horizontal_force_N": line.horizontal_force,
                    "from_tension_N": line.anchor.tension,
                    "to_tension_N": line.fairlead.tension,
                    "grounded_length_m": line.grounded_length,
                }
                for run, line in zip(self.runs, self.lines, strict=True)
            ],
            "load": list(self.body.load),
            "stiffness": [list(row) for row in self.body.stiffness],
            "residual_N": found.residual,
            "steps": found.steps,
        }


def network_document(states: Sequence[NetworkAtRest]) -> dict[str, Any]:
    """Build the document of lines that meet in joints, schema catopt.network/1; all in SI."""
    return {
        "schema": "catopt.network/1",
        "title": states[0].network.title,
        "status": "converged",
        "states": [each.to_dict() for each in states],
    }


def held_body(
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
    >>> from catopt.mooring.held import held_body
    >>> chain = Line([Segment(902.2, 698.0945, EA=384.243e6)])
    >>> spar = System.around(chain, azimuths=[0.0, radians(120.0), radians(240.0)],
    ...                      anchor_radius=853.87, fairlead_radius=5.2, fairlead_height=250.0)
    >>> body = held_body(spar, origin_height=320.0)
    >>> round(body.stiffness[0][0], 1), round(body.load[2] / 1e3, 1)
    (41181.2, -1607.2)
    """
    points, lines = [], []
    for k, leg in enumerate(system.legs):
        anchor = Point(f"anchor {k}", "anchor", *leg.anchor, leg.anchor_height)
        fairlead = Point(f"fairlead {k}", "fairlead", *leg.fairlead, leg.fairlead_height)
        points += [anchor, fairlead]
        lines.append(LineBetween(leg.line, anchor.name, fairlead.name))
    site = Site(origin_height, system.seabed_friction)
    return hold(Network(site, tuple(points), tuple(lines)), displacement).body


def hold(network: Network, displacement: tuple[float, ...] = (0.0,) * 6) -> NetworkAtRest:
    """Hold a body whose lines meet in joints, bring the joints to rest, and say its stiffness.

    A line pulls on a point with (H u, -V), u being the unit vector towards its other end. With
    its end stiffness k = d(H, V)/d(span, height) it resists a small way of the point by
    k_HH u u' + (H / span) t t' in plan (t across u), coupled with height by k_HV and k_VH. The
    stiffness K of all lines over the joints (j) and the body (b) is condensed to that of the body,
    K_bb - K_bj K_jj^-1 K_jb; a fairlead at r off the origin carries forces into moments, and
    turning the force F on it about the origin adds [F][r] (cross-product matrices).

    The origin of the body is at x = y = 0, on the water surface; `displacement` as for `held_body`.
    InputError: a fairlead is below the bed, or a line hangs slack. NoEquilibriumError,
    NotConvergedError, FloatsUpError: as for `joints_at_rest`.

    Examples
    --------
    A buoy of 5 kN where two ropes meet under water, 4 m of 5 m away from each end:

    >>> from catopt import Line, Segment
    >>> from catopt.model import Site
    >>> from catopt.model.network import LineBetween, Network, Point
    >>> from catopt.mooring.held import hold
    >>> rope = Line([Segment(5.0, 0.01, EA=1e9)])
    >>> points = [Point("port", "anchor", -4.0, 0.0, 10.0),
    ...           Point("buoy", "joint", submerged_weight=-5e3),
    ...           Point("starboard", "anchor", 4.0, 0.0, 10.0)]
    >>> lines = [LineBetween(rope, "port", "buoy"), LineBetween(rope, "starboard", "buoy")]
    >>> found = hold(Network(Site(20.0), points, lines))
    >>> round(found.place_of("buoy")[2], 3), round(found.lines[0].fairlead.tension, 1)
    (13.0, 4166.6)
    """
    rows = rows_of(network)
    whole = in_rows(network, rows)
    arms, runs, found = _in_place(whole, displacement)
    _check_pull(runs, found)
    load, stiffness = [0.0] * 6, _condensed(whole, runs, found, arms)
    for run, end in zip(runs, found.ends, strict=True):
        for at, force in ((run.first, end.first), (run.second, end.second)):
            if at in arms:
                _add(load, (*force, *_times(_skew(arms[at]), force)))
                for row, turned in zip(
                    stiffness[3:], product(_skew(force), _skew(arms[at])), strict=True
                ):
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
    return NetworkAtRest(network, runs, found, body)


def at_rest(network: Network, displacement: tuple[float, ...] = (0.0,) * 6) -> LinesAtRest:
    """Hold a body and bring the joints to rest; lines may hang slack, for no stiffness is asked.

    Raises what `hold` raises, but for slack lines.
    """
    rows = rows_of(network)
    whole = in_rows(network, rows)
    _, runs, found = _in_place(whole, displacement)
    return LinesAtRest(network, *apart(network, rows, whole, found, runs))


def _in_place(
    network: Network, displacement: tuple[float, ...]
) -> tuple[dict[int, Vector], tuple[Run, ...], JointsAtRest]:
    """Place the ends of lines, and bring the joints to rest: arms of fairleads, lines, joints."""
    arms, held = _ends_held(network, displacement)
    runs = runs_of(network)
    return arms, runs, joints_at_rest(network, runs, held)


def _ends_held(
    network: Network, displacement: tuple[float, ...]
) -> tuple[dict[int, Vector], dict[int, Vector]]:
    """Place fairleads off the body's origin, turned with it; and these and anchors in space."""
    depth = network.site.water_depth
    turn = _rotation(*displacement[3:])
    arms, held = {}, {}
    for k, point in enumerate(network.points):
        if point.kind == "anchor":
            held[k] = point.place
        elif point.kind == "fairlead":
            x, y, height = point.place
            arms[k] = a, b, c = _times(turn, (x, y, height - depth))
            surge, sway, heave = displacement[:3]
            held[k] = (surge + a, sway + b, depth + heave + c)
            if not held[k][2] >= 0.0:
                found = f"{point.name} at {held[k][2]:.6g} m"
                allowed = Message("refused_motion.fairlead_must_not_be_below")
                raise InputError([Problem("displacement", found, allowed)], "held body")
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


def _condensed(
    network: Network, runs: Sequence[Run], found: JointsAtRest, arms: Mapping[int, Vector]
) -> list[list[float]]:
    """Build the 6 x 6 stiffness of the body, the joints free to follow it."""
    joints = [k for k, point in enumerate(network.points) if point.kind == "joint"]
    free = 3 * len(joints)
    motions = {point: (3 * k, UNIT) for k, point in enumerate(joints)}
    for k, arm in arms.items():
        across = _skew(arm)
        by_body = ((*UNIT[i], *(-each for each in across[i])) for i in range(3))
        motions[k] = (free, tuple(by_body))
    matrix = assembled(runs, found.ends, motions, free + 6)
    own = [row[free:] for row in matrix[free:]]
    if not joints:
        return own
    inner, coupled = [row[:free] for row in matrix[:free]], [row[free:] for row in matrix[:free]]
    for k, point in enumerate(joints):
        if found.reactions[point] > 0.0:  # it stays on the bed
            inner[3 * k + 2] = [float(i == 3 * k + 2) for i in range(free)]
            coupled[3 * k + 2] = [0.0] * 6
    follow = solve(inner, coupled)
    for i, row in enumerate(product([row[:free] for row in matrix[free:]], follow)):
        for j in range(6):
            own[i][j] -= row[j]
    return own


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
