"""Lines in motion without steps in time: natural frequencies, and the linear answer to waves."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Final, NamedTuple, Protocol

import numpy as np

from catopt.arrays import Array, Codes
from catopt.compiled import compiled, inlined
from catopt.errors import NotConvergedError
from catopt.fem.banded import back_substitute_blocks, eliminate_blocks, invert_3
from catopt.fem.linear_model import Blocks, LinearModel, Rubs
from catopt.fem.mesh import bar_nodes
from catopt.fem.morison import equivalent_drag
from catopt.fem.moving import Equations
from catopt.fem.series import Complex
from catopt.waves import Sea
from catopt.words import Message

_CLOSE: Final = 1e-4
"""Change of the standard deviation of any fairlead's tension from one drag to the next, over the
largest; what friction leaves of it along the bed comes to rest later."""

LEAST_RESERVE: Final = 5.0
"""Standard deviations of a tension that its mean needs: with less, lines went slack in time."""

_LIMIT: Final = 200
_A_BAR: Final = 3e-4
"""Time that a bar takes for one wave as plain Python, s."""


class Afloat(NamedTuple):
    """What floats at the last nodes: three equations for each wave; of no wave where all is led."""

    matrix: Complex  # (waves, 3, 3): N/m and N m, by surge, heave and pitch; overwritten
    push: Complex  # (waves, 3): by the water, N and N m
    arm: Array  # (lines, 3, 3): way of each last node by the body's
    motion: Complex  # (waves, 3): written to, m and rad


class LinearBody(Protocol):
    """What floats at the upper ends of lines."""

    @property
    def arm(self) -> Array:
        """Way of each mooring eye along x, y and z by surge, heave and pitch, (lines, 3, 3)."""
        ...

    def equations(self, motion: Complex) -> tuple[Complex, Complex]:
        """Matrix and push as in `Afloat`, with the drag of a motion (waves, 3)."""
        ...


class Room(NamedTuple):
    """What a sea makes of a model, and room for the equations of one wave."""

    equations: Equations
    spread: Array  # (nodes, 3, 3): covariance of velocities against the water, (m/s)2
    slip: Array  # (nodes,): mean square speed of what slips on the bed, (m/s)2
    tension: Complex  # (waves, bars), N


@dataclass(frozen=True, eq=False)
class LinearMotion:
    """What a sea makes of lines by linear motion.

    Of a chain in 56 m of water the deviation at the fairlead is within 5 % of the run in time in
    seas of 1 to 4 m (tests/fem/test_linear_motion.py). Where a line lies on a bed with friction it
    is not: friction depends on what came before. The largest tensions are above those of a normal
    distribution with this deviation, by 1 % in small seas to a quarter in steep ones.
    """

    mean: Array  # (bars,): tension at rest, N
    omega: Array  # (waves,), rad/s
    tension: Complex  # (waves, bars): what each adds, its real part times exp(-i omega t), N
    start: Codes  # (lines + 1,): first bar of each line
    iterations: int  # until the drag fits the velocities
    change: float  # of the fairleads' deviations in the last of them, over the largest
    motion: Complex  # (waves, 3): surge, heave and pitch of what floats, m and rad; none if led

    def moment(self, order: int) -> Array:
        """Spectral moment of each bar's tension, N2 (rad/s)^order, shape (bars,)."""
        found: Array = 0.5 * self.omega**order @ np.abs(self.tension) ** 2
        return found

    @cached_property
    def deviation(self) -> Array:
        """Standard deviation of each bar's tension, N, shape (bars,)."""
        found: Array = np.sqrt(self.moment(0))
        return found

    @cached_property
    def zero_crossing_period(self) -> Array:
        """2 pi sqrt(m0/m2) of each bar's tension, s; infinite where nothing moves."""
        square = self.moment(2)
        with np.errstate(divide="ignore", invalid="ignore"):
            period = 2.0 * math.pi * self.deviation / np.sqrt(square)
        return np.where(square > 0.0, period, math.inf)

    def reserve(self, line: int) -> float:
        """Least tension at rest over its standard deviation, of a line's bars that bear any."""
        bars = slice(int(self.start[line]), int(self.start[line + 1]))
        mean, deviation = self.mean[bars], self.deviation[bars]
        bears = (mean > 1e-6 * mean.max()) & (deviation > 0.0)
        return float((mean[bears] / deviation[bears]).min(initial=math.inf))

    def series(self, time: Array) -> Array:
        """Tension of each bar over time, N, shape (times, bars): in phase with the run in time."""
        turn = np.exp(-1j * np.outer(time, self.omega))
        found: Array = self.mean + (turn @ self.tension).real
        return found


def linear_motion(
    model: LinearModel, sea: Sea, prescribed_motion: Complex, body: LinearBody | None = None
) -> LinearMotion:
    """Find the standard deviations of all tensions in a sea with the current of the model.

    `prescribed_motion` (lines, waves, 3): where each wave leads the last node of each line, m
    (`Harmonic.amplitudes`); of no account with a `body`, which floats at the ends of all lines.
    Raises NotConvergedError where the drag does not come to fit the velocities.
    """
    waves = sea.waves
    assert waves is not None
    flow = velocities_at(model.x, sea)
    nodes, count = len(model.x), waves.omega.size
    blocks, rows = np.zeros((3, nodes, 3, 3), complex), np.zeros((2, nodes, 3), complex)
    equations = Equations(*blocks, *rows)
    tension = np.zeros((count, model.tension.size), complex)
    covariance = 0.5 * np.einsum("wni,wnj->nij", flow, flow.conj()).real
    room = Room(equations, covariance, np.zeros(nodes), tension)
    none = np.zeros((0, 3), complex)
    afloat = Afloat(none[:, :, np.newaxis], none, np.eye(3)[np.newaxis], none)
    motion = none if body is None else np.zeros((count, 3), complex)
    solve = compiled(respond_linearly, _A_BAR * tension.size)
    fairleads = model.start[1:] - 1
    last, change = np.full(fairleads.size, np.inf), math.inf
    for iteration in range(1, _LIMIT + 1):
        drag, stiffness = _drag(model, room.spread)
        dashpot = _dashpots(model.rubs, room.slip)
        if body is not None:
            afloat = Afloat(*body.equations(motion), body.arm, motion)
        turned = model._replace(stiffness=stiffness)
        solve(waves.omega, flow, prescribed_motion, turned, drag, dashpot, room, afloat)
        deviation = np.sqrt(0.5 * (np.abs(tension[:, fairleads]) ** 2).sum(axis=0))
        largest = float(deviation.max())
        change = float(np.abs(deviation - last).max()) / largest if largest > 0.0 else 0.0
        if change <= _CLOSE:
            return LinearMotion(
                model.tension, waves.omega, tension, model.start, iteration, change, motion
            )
        last = deviation
    raise NotConvergedError(Message("motion.linear_drag", count=_LIMIT, change=change))


def velocities_at(points: Array, sea: Sea) -> Complex:
    """Velocity of the water at points (n, 3) by each wave, shape (waves, n, 3)."""
    waves, k, depth = sea.waves, sea.wave_numbers[:, np.newaxis], sea.depth
    assert waves is not None
    cos, sin = np.cos(waves.direction)[:, np.newaxis], np.sin(waves.direction)[:, np.newaxis]
    x, y, z = points.T
    angle = k * (x * cos + y * sin) + waves.phase[:, np.newaxis]
    here = np.where(z <= depth, np.exp(1j * angle), 0.0)
    decay = np.exp(-k * (depth - np.clip(z, 0.0, depth)))
    mirror = np.exp(-2.0 * k * depth)
    here = here * (waves.amplitude * waves.omega)[:, np.newaxis] / (1.0 - mirror)
    along, up = here * (decay + mirror / decay), -1j * here * (decay - mirror / decay)
    return np.ascontiguousarray(np.stack([along * cos, along * sin, up], axis=2))


def _drag(model: LinearModel, spread: Array) -> tuple[Array, Blocks]:
    """Linear drag of each node, N s/m, from the covariance of its relative velocity.

    And K with the steady drag, which goes with the bars' directions and with the water's height.
    """
    node, coefficient, onto, bar, turn = model.drags
    mean = np.einsum("nij,nj->ni", onto, model.stream[node])
    covariance = onto @ spread[node] @ onto
    by_flow = coefficient[:, np.newaxis, np.newaxis] * equivalent_drag(mean, covariance)
    # Across a bar, what its matrix has along it is no force.
    own = onto @ by_flow @ onto
    drag = np.zeros((len(model.x), 3, 3))
    np.add.at(drag, node, own)
    if not model.stream.any():
        return drag, model.stiffness
    diagonal, lower, upper = (each.copy() for each in model.stiffness)
    np.add.at(diagonal[:, :, 2], node, -np.einsum("nij,nj->ni", own, model.shear[node]))
    of = bar >= 0
    n, e = node[of], bar[of]
    first = bar_nodes(model.start)[e]
    by_way = by_flow[of] @ turn[of]
    at_first = n == first
    np.add.at(diagonal, n, np.where(at_first, 1.0, -1.0)[:, np.newaxis, np.newaxis] * by_way)
    np.add.at(upper, n[at_first], -by_way[at_first])
    np.add.at(lower, n[~at_first], by_way[~at_first])
    return drag, Blocks(diagonal, lower, upper)


def _dashpots(rubs: Rubs, slip: Array) -> Array:
    """Dashpot of each node behind its spring, N s/m; infinite where nothing slips."""
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(slip > 0.0, rubs.most / np.sqrt(slip), math.inf)


def respond_linearly(
    omega: Any,
    flow: Any,
    prescribed_motion: Any,
    model: LinearModel,
    drag: Any,
    dashpot: Any,
    room: Room,
    afloat: Afloat,
) -> None:
    """Solve for each wave; write tensions, and the squares of velocities against water and bed."""
    equations, spread, slip, tension = room
    start, rubs = model.start, model.rubs
    spread[:] = 0.0
    slip[:] = 0.0
    y = equations.rest
    floats = afloat.motion.shape[0] > 0
    for w in range(omega.shape[0]):
        _set_up(omega[w], model.stiffness, model.damping, model.mass, drag, equations)
        _rub(omega[w], rubs, dashpot, equations.diagonal)
        _push(omega[w], start, model.water_mass, drag, flow[w], equations)
        for k in range(start.shape[0] - 1):
            first, last = start[k] + k, start[k + 1] + k
            eliminate_blocks(equations, first + 1, last)
            for i in range(3):
                y[first, i] = 0.0
            if floats:
                _hand_over(w, k, last, equations, afloat)
        if floats:
            _float(w, afloat)
        for k in range(start.shape[0] - 1):
            first, last = start[k] + k, start[k + 1] + k
            for i in range(3):
                y[last, i] = _way(w, k, i, afloat) if floats else prescribed_motion[k, w, i]
            back_substitute_blocks(equations, first + 1, last)
            _stretch(w, k, model, y, omega[w], tension)
        _add_squares(omega[w], y, flow[w], rubs, dashpot, spread, slip)


def _hand_over(w: int, k: int, last: int, equations: Equations, afloat: Afloat) -> None:
    """Add what a line, its inner nodes eliminated, has at its end to what floats there."""
    matrix, push, arm = afloat.matrix, afloat.push, afloat.arm[k]
    at_end, y = equations.diagonal, equations.rest
    for i in range(3):
        for p in range(3):
            push[w, i] += arm[p, i] * y[last, p]
            for j in range(3):
                for q in range(3):
                    matrix[w, i, j] += arm[p, i] * at_end[last, p, q] * arm[q, j]


def _float(w: int, afloat: Afloat) -> None:
    """Solve for what floats."""
    matrix, push, motion = afloat.matrix, afloat.push, afloat.motion
    invert_3(matrix, w)
    for i in range(3):
        motion[w, i] = (
            matrix[w, i, 0] * push[w, 0]
            + matrix[w, i, 1] * push[w, 1]
            + matrix[w, i, 2] * push[w, 2]
        )


@inlined
def _way(w: int, k: int, i: int, afloat: Afloat) -> complex:
    """How far what floats takes the end of a line in a direction, m."""
    arm, motion = afloat.arm[k, i], afloat.motion[w]
    return complex(arm[0] * motion[0] + arm[1] * motion[1] + arm[2] * motion[2])


def _stretch(w: int, k: int, model: LinearModel, y: Any, omega: float, tension: Any) -> None:
    """Write the tension of a line's bars by a wave."""
    for e in range(model.start[k], model.start[k + 1]):
        stretch = y[0, 0] * 0.0
        for i in range(3):
            stretch += model.axis[e, i] * (y[e + k + 1, i] - y[e + k, i])
        tension[w, e] = (model.by_stretch[e] - 1j * omega * model.by_rate[e]) * stretch


def _add_squares(
    omega: float, y: Any, u: Any, rubs: Rubs, dashpot: Any, spread: Any, slip: Any
) -> None:
    """Add what one wave adds to the covariance of velocities, and to the square of the slip's."""
    spring, along = rubs.spring, rubs.along
    for n in range(y.shape[0]):
        for i in range(3):
            r_i = u[n, i] + 1j * omega * y[n, i]
            for j in range(3):
                r_j = u[n, j] + 1j * omega * y[n, j]
                spread[n, i, j] += 0.5 * (r_i.real * r_j.real + r_i.imag * r_j.imag)
        if spring[n] > 0.0:
            part = 1.0  # the first time
            if dashpot[n] < math.inf:
                ratio = omega * dashpot[n] / spring[n]
                part = 1.0 / (1.0 + ratio * ratio)
            for d in range(2):
                way = along[d, 0] * y[n, 0] + along[d, 1] * y[n, 1] + along[d, 2] * y[n, 2]
                speed = omega * omega * (way.real * way.real + way.imag * way.imag)
                slip[n] += 0.5 * part * speed


def _rub(omega: float, rubs: Rubs, dashpot: Any, diagonal: Any) -> None:
    """Add the friction of the bed: a spring, and a dashpot behind it."""
    spring, along = rubs.spring, rubs.along
    for n in range(diagonal.shape[0]):
        if spring[n] > 0.0:
            stiff = spring[n] + 0.0j
            if dashpot[n] < math.inf:
                k, c = spring[n], dashpot[n]
                slower = k / omega
                stiff = (c - 1j * slower) * (k * c / (c * c + slower * slower))
            for i in range(3):
                for j in range(3):
                    level = along[0, i] * along[0, j] + along[1, i] * along[1, j]
                    diagonal[n, i, j] += stiff * level


def _set_up(
    omega: float, stiffness: Blocks, damping: Blocks, mass: Blocks, drag: Any, room: Equations
) -> None:
    """Write the matrix of one wave."""
    square, turn = omega * omega, 1j * omega
    K, C, M = stiffness.diagonal, damping.diagonal, mass.diagonal
    K_l, C_l, M_l = stiffness.lower, damping.lower, mass.lower
    K_u, C_u, M_u = stiffness.upper, damping.upper, mass.upper
    diagonal, lower, upper = room.diagonal, room.lower, room.upper
    for n in range(K.shape[0]):
        for i in range(3):
            for j in range(3):
                diagonal[n, i, j] = (
                    K[n, i, j] - square * M[n, i, j] - turn * (C[n, i, j] + drag[n, i, j])
                )
                lower[n, i, j] = K_l[n, i, j] - square * M_l[n, i, j] - turn * C_l[n, i, j]
                upper[n, i, j] = K_u[n, i, j] - square * M_u[n, i, j] - turn * C_u[n, i, j]


def _push(omega: float, start: Any, water_mass: Blocks, drag: Any, u: Any, room: Equations) -> None:
    """Write what the water of one wave pushes with."""
    D, L, U, rest = water_mass.diagonal, water_mass.lower, water_mass.upper, room.rest
    turn = -1j * omega
    for k in range(start.shape[0] - 1):
        first, last = start[k] + k, start[k + 1] + k
        for n in range(first, last + 1):
            for i in range(3):
                total = turn * 0.0
                for j in range(3):
                    total += (turn * D[n, i, j] + drag[n, i, j]) * u[n, j]
                    if n > first:
                        total += turn * L[n, i, j] * u[n - 1, j]
                    if n < last:
                        total += turn * U[n, i, j] * u[n + 1, j]
                rest[n, i] = total
