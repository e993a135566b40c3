"""Lines linearised about rest: their natural frequencies, and what linear motion is made of."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Final, NamedTuple

import numpy as np

from catopt.arrays import Array, Codes
from catopt.fem.dynamic_model import LineProperties
from catopt.fem.dynamics import line_at_rest
from catopt.fem.mesh import LineMesh, bar_nodes, end_nodes
from catopt.fem.moving import Blend
from catopt.fem.simulation import Simulation
from catopt.model.kinds import Findings
from catopt.waves import Sea
from catopt.words import Message

_SHEARED: Final = 0.05
"""Way up and down over which the current's gain is taken, m."""


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
    return np.asarray(np.sqrt(np.maximum(squares, 0.0)))


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
    return np.asarray(full[np.ix_(kept, kept)])


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
    turn: Array  # (n, 3, 3): what that part of the steady stream gains as the bar's upper end moves
    # and turns it, 1/s


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
        found.add("drag_method", "roughness", Message("refused_motion.drag_along_bar_by_flow"))
    if lines.stiffness_factor > 0.0:
        allowed = Message("refused_motion.zero")
        found.add("stiffness_factor", f"{lines.stiffness_factor:g} s", allowed)
    found.raise_if_any()


def _blocks(simulation: Simulation, lines: Any, blend: Blend) -> Blocks:
    """Take the derivatives of the balance of other lines in the place of a simulation's."""
    simulation.assemble_as(lines, blend)
    blocks = simulation.equations
    return Blocks(blocks.diagonal.copy(), blocks.lower.copy(), blocks.upper.copy())


def _drags(simulation: Simulation, wet: Array, stream: Array) -> Drags:
    lines, axis, x = simulation.lines, simulation.state.axis, simulation.state.x
    first, each, loads = bar_nodes(lines.start), np.arange(len(axis)), lines.load_node.size
    along = axis[:, :, np.newaxis] * axis[:, np.newaxis, :]
    across = np.eye(3) - along
    half = 0.5 * lines.length[:, np.newaxis] * wet
    node = np.concatenate([first, first + 1, first, first + 1, lines.load_node])
    normal, axial = (
        half * lines.drag_normal[:, np.newaxis],
        half * lines.drag_tangential[:, np.newaxis],
    )
    coefficient = np.concatenate([*normal.T, *axial.T, lines.load_drag])
    whole = np.broadcast_to(np.eye(3), (loads, 3, 3))
    onto = np.concatenate([across, across, along, along, whole])
    # Of u the part along a bar is t (t u): it gains dt (t u) + t (u dt), and that across loses it;
    # with dt = (1 - t t) dx / l.
    u = stream[node[: -loads or None]].reshape(4, -1, 3)
    gain = axis[:, :, np.newaxis] * u[:, :, np.newaxis, :]
    gain += np.einsum("ei,kei->ke", axis, u)[:, :, np.newaxis, np.newaxis] * np.eye(3)
    long = np.linalg.norm(x[first + 1] - x[first], axis=1)
    gain = gain @ across / long[:, np.newaxis, np.newaxis]
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
