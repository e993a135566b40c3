"""Lines in motion without steps in time: natural frequencies, and the linear answer to waves."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Final, NamedTuple, Protocol

import numpy as np

from catopt.arrays import Array, Codes
from catopt.compiled import compiled, inlined
from catopt.errors import NotConvergedError
from catopt.fem.banded import back_substitute_blocks, eliminate_blocks, invert_3
from catopt.fem.dynamic_model import LineProperties
from catopt.fem.dynamics import line_at_rest
from catopt.fem.mesh import LineMesh, bar_nodes, end_nodes
from catopt.fem.morison import equivalent_drag
from catopt.fem.moving import Blend, Equations
from catopt.fem.series import Complex
from catopt.fem.simulation import Simulation
from catopt.model.kinds import Findings
from catopt.waves import Sea
from catopt.words import Message


def line_frequencies(
    mesh: LineMesh,
    count: int = 10,
    *,
    height: float,
    span: float | None = None,
    horizontal_force: float | None = None,
    anchor_height: float = 0.0,
    properties: LineProperties | None = None,
    sea: Sea | None = None,
) -> Array:
    """Lowest natural frequencies of a line with both ends held, rad/s, rising.

    Two of them with one damping ratio give Rayleigh's factors (`rayleigh_factors`), as in S4.

    Parameters
    ----------
    count : int
        How many.
    height, span, horizontal_force, anchor_height, properties, sea
        As for `run_dynamics`.
    """
    simulation = line_at_rest(
        mesh,
        height=height,
        span=span,
        horizontal_force=horizontal_force,
        anchor_height=anchor_height,
        properties=properties,
        sea=sea,
    )
    return natural_frequencies(simulation, count)


def natural_frequencies(simulation: Simulation, count: int = 10) -> Array:
    """Lowest natural frequencies, rad/s, rising: of K - omega^2 M at the present state at rest.

    K is the tangent of bars, bed and friction springs, M the mass with the water's added mass.
    Drag and damping do not count, nor does friction that slips.

    Parameters
    ----------
    simulation : Simulation
        Lines at rest (`Simulation.settle`).
    count : int
        How many, at most; frequencies of 0 (a line that can swing freely without weight) are 0.
    """
    from scipy.linalg import eigh

    K = _matrix(simulation, Blend(0.0, 0.0, 1.0, 0.0, 0.0))
    M = _matrix(simulation, Blend(0.0, 0.0, 0.0, 0.0, 1.0))
    lowest = [0, min(count, K.shape[0]) - 1]
    squares = eigh(0.5 * (K + K.T), 0.5 * (M + M.T), eigvals_only=True, subset_by_index=lowest)
    frequencies: Array = np.sqrt(np.maximum(squares, 0.0))
    return frequencies


def _matrix(simulation: Simulation, blend: Blend) -> Array:
    """Whole matrix of the unknowns: inner nodes of all lines, then the body's free directions."""
    simulation.assemble(blend)
    blocks, lines, body = simulation.equations, simulation.lines, simulation.body
    firsts, lasts = end_nodes(lines.start)
    unknowns = 3 * int((lasts - firsts - 1).sum())
    full = np.zeros((unknowns + 3, unknowns + 3))
    body_rows = slice(unknowns, unknowns + 3)
    full[body_rows, body_rows] = np.diag(blend.by_a * body.mass)
    row = 0
    for first, last in zip(firsts, lasts, strict=True):
        for n in range(first + 1, last):
            here = slice(row, row + 3)
            after = slice(row + 3, row + 6) if n + 1 < last else body_rows
            full[here, here] += blocks.diagonal[n]
            full[here, after] += blocks.upper[n]
            full[after, here] += blocks.lower[n + 1]
            row += 3
        full[body_rows, body_rows] += blocks.diagonal[last]
    kept = np.concatenate([np.ones(unknowns, bool), body.free == 1.0])
    matrix: Array = full[np.ix_(kept, kept)]
    return matrix


_CLOSE: Final = 1e-4
"""Change of the standard deviation of any fairlead's tension from one drag to the next, over the
largest; what friction leaves of it along the bed comes to rest later."""

LEAST_RESERVE: Final = 5.0
"""Standard deviations of a tension that its mean needs: with less, lines went slack in time."""

_SHEARED: Final = 0.05
"""Way up and down over which the current's gain is taken, m."""

_LIMIT: Final = 200
_A_BAR: Final = 3e-4
"""Time that a bar takes for one wave as plain Python, s."""

_DISPLACEMENT, _VELOCITY, _ACCELERATION = (
    Blend(0.0, 0.0, 1.0, 0.0, 0.0),
    Blend(0.0, 0.0, 0.0, 1.0, 0.0),
    Blend(0.0, 0.0, 0.0, 0.0, 1.0),
)


class Blocks(NamedTuple):
    """A matrix that couples neighbours, shapes (nodes, 3, 3): as of `moving.Equations`."""

    diagonal: Array
    lower: Array
    upper: Array


class Drags(NamedTuple):
    """Places of drag |r| r: of half bars across and along themselves, and of point loads."""

    node: Codes  # (n,)
    coefficient: Array  # (n,): 0.5 rho C A, N s2/m2
    onto: Array  # (n, 3, 3): the part of the velocity that counts
    bar: Codes  # (n,): that of a half bar; -1 for a point load
    turn: Array  # (n, 3, 3): what that part gains in the steady stream as the bar's direction turns


class Rubs(NamedTuple):
    """Friction of the bed under the nodes."""

    spring: Array  # (nodes,), N/m
    most: Array  # (nodes,): mu N, N
    along: Array  # (2, 3): directions along the bed


class LinearModel(NamedTuple):
    """Lines linearised about rest, their last nodes led; made by `linear_model`."""

    start: Codes  # (lines + 1,): first bar of each line
    x: Array  # (nodes, 3): places at rest, m
    stream: Array  # (nodes, 3): steady velocity of the water there, m/s
    shear: Array  # (nodes, 3): and what it gains upwards, 1/s
    stiffness: Blocks  # K, without drag
    damping: Blocks  # C
    mass: Blocks  # M
    water_mass: Blocks  # M_w
    drags: Drags
    rubs: Rubs
    axis: Array  # (bars, 3): directions
    tension: Array  # (bars,): at rest, N
    by_stretch: Array  # (bars,): what a stretch adds to it, N/m; nothing where it is slack
    by_rate: Array  # (bars,): what its rate adds, N s/m


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


def linear_model(simulation: Simulation) -> LinearModel:
    """Linearise lines at rest (`Simulation.settle`), their first nodes held and the last ones led.

    Raises InputError for drag along a bar that hangs on the velocity across it, and for bars that
    Rayleigh's damping turns.
    """
    lines, at = simulation.lines, simulation.state
    _check(simulation)
    water = simulation.water_at_rest()
    none = np.zeros_like(lines.length)
    still = lines._replace(
        drag_normal=none,
        drag_tangential=none,
        load_drag=np.zeros_like(lines.load_drag),
        friction=np.zeros_like(lines.friction),
    )
    wet = water.wet.mean(axis=1)
    displaced = np.bincount(lines.load_node, lines.load_displaced, at.x.shape[0]).astype(float)
    pushed = still._replace(mass=lines.displaced * wet, node_mass=displaced)
    K, C, M = (_blocks(simulation, still, by) for by in (_DISPLACEMENT, _VELOCITY, _ACCELERATION))
    return LinearModel(
        lines.start,
        at.x.copy(),
        water.velocity.copy(),
        _shear(simulation),
        K,
        C,
        M,
        _blocks(simulation, pushed, _ACCELERATION),
        _drags(simulation, water.wet, water.velocity),
        _rubs(simulation),
        at.axis.copy(),
        at.tension.copy(),
        np.where(at.tension > 0.0, lines.EA / lines.length, 0.0),
        np.where(at.tension > 0.0, lines.damping / lines.length, 0.0),
    )


def _check(simulation: Simulation) -> None:
    lines, found = simulation.lines, Findings("linear motion")
    if lines.drag_by_speed.any() or lines.drag_by_across.any():
        allowed = Message("refused_motion.drag_along_bar_by_flow")
        found.add("drag_method", "roughness", allowed)
    if lines.stiffness_factor > 0.0:
        found.add(
            "stiffness_factor", f"{lines.stiffness_factor:g} s", Message("refused_motion.zero")
        )
    found.raise_if_any()


def _blocks(simulation: Simulation, lines: Any, blend: Blend) -> Blocks:
    """Take the derivatives of the balance of other lines in the place of a simulation's."""
    simulation.assemble_as(lines, blend)
    blocks = simulation.equations
    return Blocks(blocks.diagonal.copy(), blocks.lower.copy(), blocks.upper.copy())


def _drags(simulation: Simulation, wet: Array, stream: Array) -> Drags:
    lines, axis = simulation.lines, simulation.state.axis
    first, each, loads = bar_nodes(lines.start), np.arange(len(axis)), lines.load_node.size
    along = axis[:, :, np.newaxis] * axis[:, np.newaxis, :]
    across = np.eye(3) - along
    half = 0.5 * lines.length[:, np.newaxis] * wet
    node = np.concatenate([first, first + 1, first, first + 1, lines.load_node])
    normal, axial = (
        half * drag[:, np.newaxis] for drag in (lines.drag_normal, lines.drag_tangential)
    )
    coefficient = np.concatenate([*normal.T, *axial.T, lines.load_drag])
    whole = np.broadcast_to(np.eye(3), (loads, 3, 3))
    onto = np.concatenate([across, across, along, along, whole])
    # Of u the part along a bar is t (t u): it gains dt (t u) + t (u dt), and that across loses it.
    u = stream[node[: -loads or None]].reshape(4, -1, 3)
    gain = axis[:, :, np.newaxis] * u[:, :, np.newaxis, :]
    gain += np.einsum("ei,kei->ke", axis, u)[:, :, np.newaxis, np.newaxis] * np.eye(3)
    turn = np.concatenate([-gain[0], -gain[1], gain[2], gain[3], np.zeros((loads, 3, 3))])
    bar = np.concatenate([each, each, each, each, np.full(loads, -1)])
    acts = coefficient > 0.0
    return Drags(node[acts], coefficient[acts], onto[acts], bar[acts], turn[acts])


def _shear(simulation: Simulation) -> Array:
    """Give what the steady velocity of the water gains upwards at each node, 1/s."""
    x, sea = simulation.state.x, simulation.sea
    if sea is None:
        return np.zeros_like(x)
    calm = replace(sea, waves=None)
    up = np.clip(x[:, 2], 0.0, sea.depth)
    low, high = (np.clip(up + way, 0.0, sea.depth) for way in (-_SHEARED, _SHEARED))
    points = [np.column_stack([x[:, :2], z]) for z in (low, high)]
    below, above = (calm.kinematics(0.0, each).velocity for each in points)
    return np.asarray((above - below) / (high - low)[:, np.newaxis])


def _rubs(simulation: Simulation) -> Rubs:
    lines, at = simulation.lines, simulation.state
    lies = (at.reaction > 0.0) & (lines.friction > 0.0)
    return Rubs(
        np.where(lies, lines.drag_spring, 0.0),
        np.where(lies, lines.friction * at.reaction, 0.0),
        np.array([[lines.bed_cos, 0.0, lines.bed_sin], [0.0, 1.0, 0.0]]),
    )


def linear_motion(
    model: LinearModel, sea: Sea, led: Complex, body: LinearBody | None = None
) -> LinearMotion:
    """Find the standard deviations of all tensions in a sea with the current of the model.

    `led` (lines, waves, 3): where each wave leads the last node of each line, m
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
        solve(waves.omega, flow, led, turned, drag, dashpot, room, afloat)
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
    long = np.linalg.norm(model.x[first + 1] - model.x[first], axis=1)
    axis = model.axis[e]
    turned = np.eye(3) - axis[:, :, np.newaxis] * axis[:, np.newaxis, :]
    by_way = by_flow[of] @ turn[of] @ turned / long[:, np.newaxis, np.newaxis]
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
    led: Any,
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
                y[last, i] = _way(w, k, i, afloat) if floats else led[k, w, i]
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
