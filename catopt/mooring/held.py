"""A body held where somebody puts it, in all six freedoms: what its lines do, and how stiffly."""

from __future__ import annotations

import math
from dataclasses import dataclass

from catopt.catenary.line_problem import LineProblem
from catopt.catenary.pieces import cut
from catopt.catenary.refusal import refusal
from catopt.catenary.span import given_span
from catopt.catenary.state import CONVERGED, State
from catopt.errors import InputError, Problem
from catopt.model import Leg, Load, System

__all__ = ["FREEDOMS", "HeldBody", "HeldLine", "held_body"]

FREEDOMS = ("surge", "sway", "heave", "roll", "pitch", "yaw")
"""Along x, y and z (up), and about them in the sense of the right hand."""

Vector = tuple[float, float, float]
Matrix = tuple[tuple[float, ...], ...]


@dataclass(frozen=True)
class HeldLine:
    """One line at that place.

    Attributes
    ----------
    fairlead : (float, float, float)
        x, y and height above the bed, m.
    span : float
        Horizontal distance from the anchor to the fairlead, m.
    horizontal_force, vertical_force : float
        With which it pulls on the body, towards the anchor and down, N.
    grounded : float
        Unstretched length on the bed, m.
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
    """What the lines do to a body that is held.

    Attributes
    ----------
    displacement : tuple of 6 float
        Surge, sway, heave (m), roll, pitch, yaw (rad).
    origin_height : float
        Of the body's origin above the bed when nothing is displaced, m.
    lines : tuple of HeldLine
        In the order of `System.legs`.
    load : tuple of 6 float
        Of the lines on the body: three forces (N), three moments about its origin (N m). The
        body's own weight and buoyancy are no part of it.
    stiffness : tuple of 6 tuples of 6 float
        Minus the derivatives of the load by a small further displacement: N/m, N, N m/rad.
        Rotations are about axes through the origin that stay parallel to x, y and z. It is
        symmetric where the moment of the lines about the origin is zero and no line lies on a bed
        with friction.
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


def held_body(
    system: System, *, origin_height: float, displacement: tuple[float, ...] = (0.0,) * 6
) -> HeldBody:
    """Say what the lines do to a body that is held, and the linearised stiffness there.

    A fairlead at p pulls with (H u, -V), u being the unit vector towards the anchor. With the
    line's end stiffness k = d(H, V)/d(span, height) it resists a small way of the fairlead by
    k_HH u u' + (H / span) t t' in plan (t across u), coupled with height by k_HV and k_VH; a
    fairlead at r off the origin carries that into moments, and turning the force of the line
    itself about the origin adds [F][r] (cross-product matrices).

    Parameters
    ----------
    system : System
        Its lines; force and moment play no part. Fairlead heights hold for no displacement.
    origin_height : float
        Of the point above the bed about which moments and rotations are taken, m: the water depth
        for the waterline.
    displacement : tuple of 6 float
        Surge, sway, heave (m), roll, pitch, yaw (rad); the body is turned by roll first, then
        pitch, then yaw.

    Returns
    -------
    HeldBody
        Load and stiffness of the lines.

    Raises
    ------
    InputError
        A fairlead is straight above its anchor or below the bed, or a line hangs slack.
    NoEquilibriumError, NotConvergedError
        As for `solve` of that line.

    Examples
    --------
    >>> from math import radians
    >>> from catopt import Line, Segment, System
    >>> from catopt.mooring.held import held_body
    >>> chain = Line([Segment(902.2, 698.0945, EA=384.243e6)])
    >>> spar = System.around(chain, azimuths=[0.0, radians(120.0), radians(240.0)],
    ...                      anchor_radius=853.87, fairlead_radius=5.2, fairlead_height=250.0)
    >>> body = held_body(spar, origin_height=320.0)
    >>> round(body.stiffness[0][0], 1), round(body.load[2])
    (41181.2, -1607184)
    """
    turn = _rotation(*displacement[3:])
    lines, load, stiffness = [], [0.0] * 6, [[0.0] * 6 for _ in range(6)]
    for number, leg in enumerate(system.legs, start=1):
        arm = _times(turn, (*leg.fairlead, leg.fairlead_height - origin_height))
        at = (displacement[0] + arm[0], displacement[1] + arm[1])
        height = origin_height + displacement[2] + arm[2]
        to_x, to_y = leg.anchor[0] - at[0], leg.anchor[1] - at[1]
        span = math.hypot(to_x, to_y)
        state = _hung(leg, number, span, height, system.seabed_friction)
        u = (to_x / span, to_y / span)
        force = (state.H * u[0], state.H * u[1], -state.V)
        _add(load, (*force, *_cross(arm, force)))
        own = _of_line(state, u, span)
        for row, of_line in zip(stiffness, _at_arm(own, arm, force), strict=True):
            _add(row, of_line)
        lines.append(HeldLine((*at, height), span, state.H, state.V, state.grounded))
    return HeldBody(
        tuple(displacement),
        origin_height,
        tuple(lines),
        tuple(load),
        tuple(tuple(row) for row in stiffness),
    )


def _hung(leg: Leg, number: int, span: float, height: float, friction: float) -> State:
    """Solve a line between its ends; raise where it has no answer, or no stiffness."""
    if not (span > 0.0 and height >= 0.0):
        where = f"line {number}: {span:.6g} m from its anchor in plan, {height:.6g} m above the bed"
        allowed = "its fairlead must be off its anchor and not below the bed"
        raise InputError([Problem("displacement", where, allowed)], "held body")
    pieces, _ = cut(leg.line)
    problem = LineProblem(pieces, float(leg.anchor_height), height, friction)
    state = given_span(span, problem, math.nan, math.nan)
    if state.status != CONVERGED:
        raise refusal(state.status, leg.line, Load(span=span), problem)
    if state.H == 0.0:
        allowed = "without a horizontal force it has no linear stiffness"
        raise InputError(
            [Problem("displacement", f"line {number} hangs slack", allowed)], "held body"
        )
    return state


def _of_line(state: State, u: tuple[float, float], span: float) -> Matrix:
    """Build the 3 x 3 stiffness of one line at its fairlead, N/m."""
    determinant = state.x_H * state.z_V - state.x_V * state.z_H
    HH, HV = state.z_V / determinant, -state.x_V / determinant
    VH, VV = -state.z_H / determinant, state.x_H / determinant
    across = state.H / span
    x, y = u
    return (
        (HH * x * x + across * y * y, (HH - across) * x * y, -HV * x),
        ((HH - across) * x * y, HH * y * y + across * x * x, -HV * y),
        (-VH * x, -VH * y, VV),
    )


def _at_arm(own: Matrix, arm: Vector, force: Vector) -> list[list[float]]:
    """Carry the stiffness of a line from its fairlead to the origin: 6 x 6."""
    r = _skew(arm)
    own_r, r_own = _product(own, r), _product(r, own)
    turned = _product(_skew(force), r)
    about = _product(r_own, r)
    upper = [[*own[i], *(-each for each in own_r[i])] for i in range(3)]
    lower = [[*r_own[i], *(-about[i][j] - turned[i][j] for j in range(3))] for i in range(3)]
    return upper + lower


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


def _skew(v: Vector) -> Matrix:
    """Build the matrix that crosses v with what it multiplies."""
    return ((0.0, -v[2], v[1]), (v[2], 0.0, -v[0]), (-v[1], v[0], 0.0))


def _cross(a: Vector, b: Vector) -> Vector:
    return _times(_skew(a), b)


def _times(matrix: Matrix, v: Vector) -> Vector:
    x, y, z = (math.fsum(map(float.__mul__, row, v)) for row in matrix)
    return x, y, z


def _product(a: Matrix, b: Matrix) -> Matrix:
    columns = tuple(zip(*b, strict=True))
    return tuple(tuple(sum(map(float.__mul__, row, each)) for each in columns) for row in a)


def _add(total: list[float], more: tuple[float, ...] | list[float]) -> None:
    for i, each in enumerate(more):
        total[i] += each
