"""A hull on its lines: brought to rest in current and wind, then run in the sea, as one system."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Final, NamedTuple

import numpy as np

from catopt.arrays import Array, Codes
from catopt.errors import NoEquilibriumError, NotConvergedError
from catopt.fem.afloat import Afloat, sample_hull
from catopt.fem.banded import eliminate_blocks
from catopt.fem.dynamic_model import LineProperties
from catopt.fem.dynamics import body_at_rest, check_run, line_at_rest, ramped, run_from_rest
from catopt.fem.history import History
from catopt.fem.mesh import LineMesh, end_nodes
from catopt.fem.moving import Blend, BodyNode
from catopt.fem.run_settings import TimeStepping
from catopt.fem.seabed import HeldBed, Seabed
from catopt.fem.simulation import Simulation
from catopt.fem.solve import Leg
from catopt.floater.alone import HullHistory, history_of
from catopt.hydro.build import FloatingHull, record_of, room_of, state_of
from catopt.hydro.hull import Hull, HullRoom, HullState, fill_forces_on_hull, fill_sea
from catopt.waves import Sea
from catopt.waves.kinematics import Flow
from catopt.words import Message

_AT_REST: Final = Blend(0.0, 0.0, 1.0, 0.0, 0.0)
_ROUNDS: Final = 80
"""Of Newton's method for the hull at rest."""
_CLOSED: Final = 1e-7
"""Force left over at rest, over the hull's weight."""
_MOST_MOVE: Final = 0.5
"""Way, over the hull's size, that a step of it may go."""
_SMALL, _WIDE = 1e-5, 0.03
"""Over the hull's size, and in rad: ways over which derivatives are taken, for Newton's steps and
for the motion in waves."""
_LEAST_PULL: Final = 0.02
"""Pull by which the line is first laid out, over its weight from the bed to the eye."""


class AtRest(NamedTuple):
    """A hull at rest on its lines, in the current and the wind.

    Derivatives are over a way as waves move it, not at a point: what a hull that leans has under
    water is summed in columns.
    """

    simulation: Simulation
    hull: Hull
    state: HullState
    line: Array  # (3,): force and moment of the lines on it, N and N m
    stiffness: Array  # (3, 3): of the hull alone, its eyes pulled as by the lines: N/m and N m
    by_surface: Array  # (3, 2): force by a surface that is higher, N/m, or slopes along x, N
    by_acceleration: Array  # (3, slices, 2): by the water's along x and z about each slice, kg


class _Calm(NamedTuple):
    """A hull in the current and the wind without waves; its state is overwritten."""

    hull: Hull
    state: HullState
    flow: Flow
    room: HullRoom

    def pushed(
        self,
        q: Array,
        surface: tuple[float, float] = (0.0, 0.0),
        acceleration: tuple[int, int, float] = (0, 0, 0.0),
    ) -> Array:
        """Force on it where it is held.

        `surface`: how much higher, m, and its slope along x; `acceleration`: of a slice, in a
        direction, m/s2.
        """
        hull, state, flow, room = self
        state.q[:] = q
        state.v[:] = 0.0
        fill_sea(0.0, hull, state.q, flow, room)
        room.sea[:2] = surface
        room.acceleration[acceleration[0], 2 * acceleration[1]] += acceleration[2]
        room.carried[:] = room.by_speed[:] = 0.0
        fill_forces_on_hull(hull, state, flow.depth, room)
        return state.force.copy()

    def stiffness(self, q: Array, step: Array, arms: Array, pulls: Array) -> Array:
        """As `AtRest.stiffness`; `arms` of its eyes, m, `pulls` of the lines there, N."""
        own = -_slope(self.pushed, q, step)
        # Heavier pulls turn the eye in under the hull.
        own[2, 2] += (arms * pulls).sum()
        return own

    def by_surface(self, q: Array, step: Array) -> Array:
        """As `AtRest.by_surface`."""
        out = np.zeros((3, 2))
        for j, (rise, slope) in enumerate(((step[1], 0.0), (0.0, step[2]))):
            change = self.pushed(q, (rise, slope)) - self.pushed(q, (-rise, -slope))
            out[:, j] = change / (2.0 * (rise + slope))
        return out

    def by_acceleration(self, q: Array) -> Array:
        """As `AtRest.by_acceleration`: forces are linear in it."""
        calm, slices = self.pushed(q), self.room.acceleration.shape[0]
        out = np.zeros((3, slices, 2))
        for j in range(slices):
            for i in range(2):
                out[:, j, i] = self.pushed(q, acceleration=(j, i, 1.0)) - calm
        return out


class _Lines(NamedTuple):
    """Lines that are laid out to where a hull has their eyes: one in its plane, or several."""

    legs: Sequence[Leg]
    meshes: Sequence[LineMesh]
    hull: Hull
    sea: Sea

    def laid_out(self, at: LineProperties, q: Array, force: float | None = None) -> Simulation:
        """Bring the lines to rest, the hull at q; or one under a force, N, in its eye's height."""
        arms = arms_of(self.hull, q)
        if len(self.legs) > 1:
            simulation = body_at_rest(
                [
                    replace(leg, fairlead=(arm[0], leg.fairlead[1], arm[1]))
                    for leg, arm in zip(self.legs, arms.tolist(), strict=True)
                ],
                self.meshes,
                height=float(q[1]),
                position=(float(q[0]), 0.0),
                properties=at,
                sea=self.sea,
            )
        else:
            (leg,), (mesh,) = self.legs, self.meshes
            x, height = (q[:2] + arms[0]).tolist()
            simulation = line_at_rest(
                mesh,
                height=height,
                span=None if force is not None else x,
                horizontal_force=force,
                anchor_height=leg.anchor[2],
                properties=at,
                sea=self.sea,
            )
        simulation.hold_ends()
        return simulation

    def start(self, at: LineProperties, q: Array, drift: float) -> None:
        """Put a hull to where its line balances its drift, N; on several lines it stays."""
        if len(self.legs) == 1:
            (leg,), eye = self.legs, q[:2] + arms_of(self.hull, q)[0]
            weight = float(np.mean([each.submerged_weight for each in leg.line.segments]))
            least = _LEAST_PULL * abs(weight) * max(eye[1] - leg.anchor[2], 1.0)
            simulation = self.laid_out(at, q, max(drift, least))
            q[0] += simulation.state.x[-1, 0] - eye[0]


def moored_at_rest(
    hull: FloatingHull,
    legs: Sequence[Leg],
    meshes: Sequence[LineMesh],
    *,
    sea: Sea,
    properties: LineProperties,
) -> AtRest:
    """Find where hull and lines are at rest, without waves.

    `legs`: one line from an anchor at x = y = 0, or several about the origin, mirrored by its x
    axis: of their fairleads y counts, x and height are those of the hull's eyes. `meshes`: of them.
    Raises NoEquilibriumError where lines draw the hull under, NotConvergedError.
    """
    flow = sea.flow_at_rest
    laid = hull.lay_out(sea.flow)
    state = state_of(laid, 0.0, flow.depth - hull.draught + hull.centre)
    calm = _Calm(hull.lay_out(flow), state, flow, room_of(laid))
    pushed, lines = calm.pushed, _Lines(legs, meshes, laid, sea)
    q = state.q.copy()
    drift = pushed(q)[0]
    # First without friction of the bed, whose springs would be all of the stiffness.
    smooth = replace(properties, seabed=_without_friction(properties.seabed))
    lines.start(smooth, q, drift)
    scale = hull.mass * hull.gravity
    long = math.sqrt(max(hull.inertia, 1e-12) / hull.mass)
    size = max(hull.draught, 2.0 * float(hull.radius.max()))
    ways = np.array([size, size, 1.0])
    is_rubbed, matrix = False, np.eye(3)
    for _ in range(_ROUNDS):
        arms = arms_of(laid, q)
        # How each eye moves with the hull: (lines, 2, 3).
        turned = np.array([[[1.0, 0.0, z], [0.0, 1.0, -x]] for x, z in arms.tolist()])
        simulation = lines.laid_out(properties if is_rubbed else smooth, q)
        if is_rubbed:
            pulls = simulation.state.force[_last_nodes(simulation)][:, [0, 2]].copy()
        else:
            pulls, stiffness = _of_lines(simulation)
            matrix = np.einsum("kia,kij,kjb->ab", turned, stiffness, turned)
            matrix += calm.stiffness(q, _SMALL * ways, arms, pulls)
            matrix[laid.free == 0.0] = 0.0
            matrix[:, laid.free == 0.0] = 0.0
            matrix += np.diag(1.0 - laid.free)
            matrix += 1e-6 * scale * np.diag([1.0 / size, 1.0 / size, size])
        line = np.einsum("kia,ki->a", turned, pulls)
        left = (pushed(q) + line) * laid.free
        worst = float(np.abs(left / [scale, scale, scale * long]).max())
        if worst <= _CLOSED and is_rubbed:
            state.q[:] = q
            own = calm.stiffness(q, _WIDE * ways, arms, pulls)
            of_water = calm.by_surface(q, _WIDE * ways), calm.by_acceleration(q)
            pushed(q)
            return AtRest(simulation, laid, state, line, own, *of_water)
        is_rubbed = is_rubbed or worst <= _CLOSED
        move = np.linalg.solve(matrix, left)
        far = max(float(np.hypot(move[0], move[1])), abs(float(move[2])) * size)
        q = q + move * min(1.0, _MOST_MOVE * size / max(far, 1e-300))
        top = q[1] + float(hull.top.max() - hull.centre)
        if top < flow.depth - 3.0 * size:
            raise NoEquilibriumError(Message("floater.drawn_under"), "force", 0.0)
    raise NotConvergedError(Message("floater.not_at_rest", rounds=_ROUNDS))


def _without_friction(seabed: Seabed | HeldBed | None) -> Seabed | HeldBed | None:
    return replace(seabed, friction=0.0) if isinstance(seabed, Seabed) else seabed


def arms_of(hull: Hull, q: Array) -> Array:
    """From its centre of gravity to each mooring eye, along x and z, (lines, 2), m."""
    sine, cosine = math.sin(q[2]), math.cos(q[2])
    across, along = hull.eye.T
    return np.stack([across * cosine + along * sine, along * cosine - across * sine], axis=1)


def _slope(pushed: Callable[[Array], Array], q: Array, steps: Array) -> Array:
    """Find the derivative of the forces on the hull by its place, by differences."""
    out = np.zeros((3, 3))
    for j, step in enumerate(steps.tolist()):
        way = np.zeros(3)
        way[j] = step
        out[:, j] = (pushed(q + way) - pushed(q - way)) / (2.0 * step)
    return out


def _last_nodes(simulation: Simulation) -> Codes:
    return end_nodes(simulation.lines.start)[1]


def _of_lines(simulation: Simulation) -> tuple[Array, Array]:
    """Force of each line on its upper end, (lines, 2) N, and its stiffness there, N/m."""
    firsts, lasts = end_nodes(simulation.lines.start)
    simulation.assemble(_AT_REST)
    to = simulation.equations
    pulls = simulation.state.force[lasts][:, [0, 2]].copy()
    for first, last in zip(firsts.tolist(), lasts.tolist(), strict=True):
        eliminate_blocks(to, first + 1, last)
    return pulls, to.diagonal[lasts][:, [0, 2]][:, :, [0, 2]].copy()


def run_moored(
    hull: FloatingHull,
    legs: Sequence[Leg],
    meshes: Sequence[LineMesh],
    stepping: TimeStepping,
    *,
    sea: Sea,
    properties: LineProperties,
    progress: Callable[[float], None] | None = None,
) -> tuple[History, HullHistory]:
    """Run a hull and its lines in a sea, from rest, by one Newton iteration a step for all.

    Parameters
    ----------
    hull : FloatingHull
        With a mooring eye for each line.
    legs, meshes
        The lines, as for `moored_at_rest`. The hull moves in surge, heave and pitch: of lines that
        its x axis mirrors, the forces across it cancel.
    stepping, sea, properties, progress
        As for `run_dynamics`; waves and current go along x or against it.

    Raises
    ------
    InputError, NoEquilibriumError, NotConvergedError
        As `run_dynamics`, and where lines draw the hull under.
    """
    in_sea = ramped(sea, stepping)
    assert in_sea is not None
    warnings = check_run(stepping, sea=in_sea)
    rest = moored_at_rest(hull, legs, meshes, sea=in_sea, properties=properties)
    simulation, laid = rest.simulation, rest.hull
    simulation.start()
    ones, none = np.ones(3), np.zeros(3)
    before = rest.state._replace(line=rest.line)
    now = HullState(*(each.copy() for each in before))
    body = Afloat(
        laid,
        now,
        before,
        room_of(laid),
        record_of(stepping.samples + 1),
        BodyNode(none, none, none),
    )
    simulation.afloat = body
    simulation.body = BodyNode(ones, none, none)
    sample_hull(0, body)
    history = run_from_rest(simulation, stepping, meshes, warnings, progress)
    of = history_of(body, history.time, in_sea.depth, 0.0)
    return history, of
