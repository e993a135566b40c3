"""A hull on its lines: brought to rest in current and wind, then run in the sea, as one system.

In small motion about rest it is linear: one wave at a time, without steps in time.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Final, NamedTuple

import numpy as np

from catopt.arrays import Array
from catopt.errors import NoEquilibriumError, NotConvergedError
from catopt.fem.afloat import Afloat, sample_hull
from catopt.fem.banded import eliminate_blocks
from catopt.fem.dynamic_model import LineProperties
from catopt.fem.dynamics import body_at_rest, check_run, line_at_rest, ramped, run_from_rest
from catopt.fem.history import History
from catopt.fem.linear_motion import velocities_at
from catopt.fem.mesh import LineMesh, end_nodes
from catopt.fem.morison import equivalent_drag
from catopt.fem.moving import Blend, BodyNode
from catopt.fem.run_settings import TimeStepping
from catopt.fem.seabed import Seabed
from catopt.fem.series import Complex
from catopt.fem.simulation import Break, Simulation
from catopt.fem.solve import Leg
from catopt.floater.alone import HullHistory, freedoms, history_of
from catopt.hydro.build import FloatingHull, SteppedHull, record_of, room_of, state_of
from catopt.hydro.hull import Hull, HullRoom, HullState, fill_forces_on_hull, fill_sea, rotate_axes
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
_LEAST_PART: Final = 1.0 / 32.0
"""Of a step where forces do not get less."""
_SMALL, _WIDE = 1e-5, 0.03
"""Over the hull's size, and in rad: ways over which derivatives are taken, for Newton's steps and
for the motion in waves."""
_LEAST_PULL: Final = 0.02
"""Pull by which the line is first laid out, over its weight from the bed to the eye."""


class _Pose(NamedTuple):
    """Where a hull is: place of its centre of gravity, m, and its axes, in columns."""

    q: Array  # (3,)
    axes: Array  # (3, 3)

    def moved(self, way: Array) -> _Pose:
        """Go on by a way (6,): m, and turned by rad."""
        axes = np.empty((3, 3))
        rotate_axes(way[3:], self.axes, axes)
        return _Pose(self.q + way[:3], axes)


class _Calm(NamedTuple):
    """A hull in the current and the wind without waves; its state is overwritten."""

    hull: Hull
    state: HullState
    flow: Flow
    room: HullRoom

    def pushed(
        self,
        at: _Pose,
        surface: tuple[float, float] = (0.0, 0.0),
        acceleration: tuple[int, int, float] = (0, 0, 0.0),
    ) -> Array:
        """Force on it where it is held.

        `surface`: how much higher, m, and its slope along x; `acceleration`: of a slice, in a
        direction, m/s2.
        """
        hull, state, flow, room = self
        state.q[:], state.axes[:] = at
        state.v[:] = 0.0
        fill_sea(0.0, hull, state, flow, room)
        room.sea[:2] = surface
        of_slice, direction, size = acceleration
        if size != 0.0:
            room.acceleration[of_slice, direction] += size
        room.carried[:] = room.by_speed[:] = 0.0
        fill_forces_on_hull(hull, state, flow.depth, room)
        return state.force.copy()

    def stiffness(self, at: _Pose, step: Array, arms: Array, pulls: Array) -> Array:
        """As `AtRest.stiffness`; `arms` of its eyes, m, `pulls` of the lines there, N."""
        own = np.zeros((6, 6))
        for j, way in enumerate(np.diag(step)):
            change = self.pushed(at.moved(way)) - self.pushed(at.moved(-way))
            own[:, j] = -change / (2.0 * step[j])
        # Heavier pulls turn the eye in under the hull: the moment of F at r turns with r.
        own[3:, 3:] += (arms * pulls).sum() * np.eye(3) - arms.T @ pulls
        return own

    def by_surface(self, at: _Pose, step: Array) -> Array:
        """As `AtRest.by_surface`."""
        out = np.zeros((6, 2))
        for j, (rise, slope) in enumerate(((step[2], 0.0), (0.0, step[4]))):
            change = self.pushed(at, (rise, slope)) - self.pushed(at, (-rise, -slope))
            out[:, j] = change / (2.0 * (rise + slope))
        return out

    def by_acceleration(self, at: _Pose) -> Array:
        """As `AtRest.by_acceleration`: forces are linear in it."""
        calm, slices = self.pushed(at), self.room.acceleration.shape[0]
        out = np.zeros((6, slices, 3))
        for j in range(slices):
            for i in range(3):
                out[:, j, i] = self.pushed(at, acceleration=(j, i, 1.0)) - calm
        return out


@dataclass(frozen=True, eq=False)
class AtRest:
    """A hull at rest on its lines, in the current and the wind.

    `line` (6,): force and moment of the lines on it, N and N m. Derivatives, that linear motion
    takes, are over a way as waves move it, not at a point: what a hull that leans has under water
    is summed in columns.
    """

    simulation: Simulation
    hull: Hull
    state: HullState
    line: Array
    calm: _Calm
    ways: Array  # (6,): that stand for the motion in waves, m and rad
    pulls: Array  # (lines, 3): of the lines at their eyes, N

    @property
    def _at(self) -> _Pose:
        return _Pose(self.state.q, self.state.axes)

    @cached_property
    def stiffness(self) -> Array:
        """Of the hull alone, its eyes pulled as by the lines: (6, 6), N/m and N m."""
        arms = arms_of(self.hull, self.state.axes)
        return self.calm.stiffness(self._at, self.ways, arms, self.pulls)

    @cached_property
    def by_surface(self) -> Array:
        """Force by a surface that is higher, N/m, or slopes along x, N: (6, 2)."""
        return self.calm.by_surface(self._at, self.ways)

    @cached_property
    def by_acceleration(self) -> Array:
        """Force by the water's acceleration about each slice: (6, slices, 3), kg."""
        return self.calm.by_acceleration(self._at)


class _Lines(NamedTuple):
    """Lines that are laid out to where a hull has their eyes: one in its plane, or several."""

    legs: Sequence[Leg]
    meshes: Sequence[LineMesh]
    hull: Hull
    sea: Sea

    def laid_out(self, of: LineProperties, at: _Pose, force: float | None = None) -> Simulation:
        """Bring the lines to rest, the hull at hand; or one under a force, N, in its eye's height.

        A line by itself, in the plane of x and z, by its closed form at first.
        """
        arms = arms_of(self.hull, at.axes)
        if len(self.legs) > 1 or at.q[1] != 0.0:
            simulation = body_at_rest(
                [
                    replace(leg, fairlead=(arm[0], arm[1], arm[2]))
                    for leg, arm in zip(self.legs, arms.tolist(), strict=True)
                ],
                self.meshes,
                height=float(at.q[2]),
                position=(float(at.q[0]), float(at.q[1])),
                properties=of,
                sea=self.sea,
            )
        else:
            (leg,), (mesh,) = self.legs, self.meshes
            x, _, height = (at.q + arms[0]).tolist()
            simulation = line_at_rest(
                mesh,
                height=height,
                span=None if force is not None else x,
                horizontal_force=force,
                anchor_height=leg.anchor[2],
                properties=of,
                sea=self.sea,
            )
        simulation.hold_ends()
        return simulation

    def start(self, of: LineProperties, at: _Pose, drift: Array) -> _Pose:
        """Put a hull to where its line balances its drift (2,), N; on several lines it stays."""
        if len(self.legs) > 1:
            return at
        (leg,), eye = self.legs, at.q + arms_of(self.hull, at.axes)[0]
        weight = float(np.mean([each.submerged_weight for each in leg.line.segments]))
        least = _LEAST_PULL * abs(weight) * max(eye[2] - leg.anchor[2], 1.0)
        ahead, aside = drift.tolist() if self.hull.free[1] else (drift[0], 0.0)
        pull = math.hypot(ahead, aside) if aside else max(ahead, least)
        way = self.laid_out(of, at, max(pull, least)).state.x[-1, 0] - eye[0]
        along = (ahead / pull, aside / pull) if aside else (1.0, 0.0)
        return at.moved(way * np.array([*along, 0.0, 0.0, 0.0, 0.0]))


def moored_at_rest(
    hull: SteppedHull,
    legs: Sequence[Leg],
    meshes: Sequence[LineMesh],
    *,
    sea: Sea,
    properties: LineProperties,
    lost: int | None = None,
) -> AtRest:
    """Find where hull and lines are at rest, without waves.

    `legs`: one line from an anchor at x = y = 0, or several about the origin; their fairleads are
    the hull's eyes. `meshes`: of them. In the freedoms of `freedoms.freedoms`; `lost`: a line, from
    0, that parts later.
    Raises NoEquilibriumError where lines draw the hull under, NotConvergedError.
    """
    flow = sea.flow_at_rest
    free = freedoms(hull, legs, sea, lost)
    laid = hull.lay_out(sea.flow, free)
    state = state_of(laid, (0.0, 0.0, flow.depth + hull.level))
    calm = _Calm(hull.lay_out(flow, free), state, flow, room_of(laid))
    pushed, lines = calm.pushed, _Lines(legs, meshes, laid, sea)
    at = _Pose(state.q.copy(), state.axes.copy())
    drift = pushed(at)[:2]
    # First without friction of the bed, whose springs would be all of the stiffness.
    smooth = properties
    if isinstance(properties.seabed, Seabed):
        smooth = replace(properties, seabed=replace(properties.seabed, friction=0.0))
    at = lines.start(smooth, at, drift)
    scale = hull.mass * hull.gravity
    long = math.sqrt(max(hull.inertia, 1e-12) / hull.mass)
    size = hull.size
    ways = np.array([size, size, size, 1.0, 1.0, 1.0])
    is_rubbed, matrix, last, part = False, np.eye(6), math.inf, 1.0
    for _ in range(_ROUNDS):
        arms = arms_of(laid, at.axes)
        simulation = lines.laid_out(properties if is_rubbed else smooth, at)
        if is_rubbed:
            pulls = simulation.state.force[end_nodes(simulation.lines.start)[1]].copy()
        else:
            pulls, stiffness = _of_lines(simulation)
            eyes = ways_of_eyes(arms)
            matrix = np.einsum("kia,kij,kjb->ab", eyes, stiffness, eyes)
            matrix += calm.stiffness(at, _SMALL * ways, arms, pulls)
            matrix[laid.free == 0.0] = 0.0
            matrix[:, laid.free == 0.0] = 0.0
            matrix += np.diag(1.0 - laid.free)
            matrix += 1e-6 * scale * np.diag([1.0 / size] * 3 + [size] * 3)
        line = np.concatenate([pulls.sum(axis=0), np.cross(arms, pulls).sum(axis=0)])
        left = (pushed(at) + line) * laid.free
        worst = float(np.abs(left / ([scale] * 3 + [scale * long] * 3)).max())
        if worst <= _CLOSED and is_rubbed:
            found = HullState(*(each.copy() for each in state))
            return AtRest(simulation, laid, found, line, calm, _WIDE * ways, pulls)
        is_rubbed = is_rubbed or worst <= _CLOSED
        # To and fro over the place where a node of a coarse line comes off the bed: half as far.
        part = min(2.0 * part, 1.0) if worst < last else max(0.5 * part, _LEAST_PART)
        last = worst
        move = part * np.linalg.solve(matrix, left)
        far = max(float(np.linalg.norm(move[:3])), float(np.linalg.norm(move[3:])) * size)
        at = at.moved(move * min(1.0, _MOST_MOVE * size / max(far, 1e-300)))
        if at.q[2] + hull.above < flow.depth - 3.0 * size:
            raise NoEquilibriumError(Message("floater.drawn_under"), "force", 0.0)
    raise NotConvergedError(Message("floater.not_at_rest", rounds=_ROUNDS))


def arms_of(hull: Hull, axes: Array) -> Array:
    """From its centre of gravity to each mooring eye, (lines, 3), m."""
    return np.asarray(hull.eye @ axes.T)


def ways_of_eyes(arms: Array) -> Array:
    """How each eye goes when the hull moves by 1 m or turns by 1 rad, (lines, 3, 6)."""
    turned = [np.cross(each, arms) for each in np.eye(3)]
    straight = np.broadcast_to(np.eye(3), (len(arms), 3, 3))
    return np.concatenate([straight, np.stack(turned, axis=2)], axis=2)


def _of_lines(simulation: Simulation) -> tuple[Array, Array]:
    """Force of each line on its upper end, (lines, 3) N, and its stiffness there, N/m."""
    firsts, lasts = end_nodes(simulation.lines.start)
    simulation.assemble(_AT_REST)
    to = simulation.equations
    pulls = simulation.state.force[lasts].copy()
    for first, last in zip(firsts.tolist(), lasts.tolist(), strict=True):
        eliminate_blocks(to, first + 1, last)
    return pulls, to.diagonal[lasts].copy()


def run_moored(
    hull: SteppedHull,
    legs: Sequence[Leg],
    meshes: Sequence[LineMesh],
    stepping: TimeStepping,
    *,
    sea: Sea,
    properties: LineProperties,
    broken: Break | None = None,
    progress: Callable[[float], None] | None = None,
) -> tuple[History, HullHistory]:
    """Run a hull and its lines in a sea, from rest, by one Newton iteration a step for all.

    Parameters
    ----------
    hull : SteppedHull
        With a mooring eye for each line.
    legs, meshes
        The lines, as for `moored_at_rest`.
    stepping, sea, properties, progress
        As for `run_dynamics`.
    broken : Break, optional
        A line that parts.

    Raises
    ------
    InputError, NoEquilibriumError, NotConvergedError
        As `run_dynamics`, and where lines draw the hull under.
    """
    in_sea = ramped(sea, stepping)
    assert in_sea is not None
    warnings = check_run(stepping, sea=in_sea)
    lost = None if broken is None else broken.line
    rest = moored_at_rest(hull, legs, meshes, sea=in_sea, properties=properties, lost=lost)
    simulation, laid = rest.simulation, rest.hull
    simulation.start()
    none = np.zeros(3)
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
    simulation.body = BodyNode(np.ones(3), none, none)
    sample_hull(0, body)
    history = run_from_rest(simulation, stepping, meshes, warnings, progress, broken)
    return history, history_of(body, history.time, in_sea.depth, hull.volume_of_all)


_PLANE: Final = [0, 2, 4]
"""Surge, heave and pitch of the six freedoms."""


@dataclass(frozen=True, eq=False)
class LinearHull:
    """A hull at rest on its lines, in a sea; about its centre of gravity.

    `matrix` (waves, 3, 3) and `push` (waves, 3): without drag, as `linear_motion.Afloat` has them;
    `arm` (lines, 3, 3): way of its eyes; `way` (n, 3): motion that counts for each place of drag
    |r| r; `coefficient` (n,): 0.5 rho C A, N s2/m2; `stream` (n,): steady velocity of the water
    there, m/s; `flow` (waves, n): its velocity by each wave.
    """

    omega: Array
    matrix: Complex
    push: Complex
    arm: Array
    way: Array
    coefficient: Array
    stream: Array
    flow: Complex

    def equations(self, motion: Complex) -> tuple[Complex, Complex]:
        """Matrix and push with linear drag in the place of |r| r, for a motion (waves, 3)."""
        turn = 1j * self.omega
        against = self.flow + turn[:, np.newaxis] * (motion @ self.way.T)
        mean, covariance = np.zeros((self.stream.size, 3)), np.zeros((self.stream.size, 3, 3))
        mean[:, 0] = self.stream
        covariance[:, 0, 0] = 0.5 * (np.abs(against) ** 2).sum(axis=0)
        drag = self.coefficient * equivalent_drag(mean, covariance)[:, 0, 0]
        damping = (self.way.T * drag) @ self.way
        matrix = self.matrix - turn[:, np.newaxis, np.newaxis] * damping
        return matrix, self.push + (self.flow * drag) @ self.way


def linear_hull(hull: FloatingHull, rest: AtRest, sea: Sea) -> LinearHull:
    """Linearise a hull that is at rest on its lines, in the waves of a sea along x or against it.

    Forces are those of the run in time for small motion: pressure of the undisturbed wave by
    slices, what the hull diffracts beyond that, memory of radiation, drag by slices.
    """
    waves, depth, laid = sea.waves, sea.depth, rest.hull
    assert waves is not None
    omega, k, ahead = waves.omega, sea.wave_numbers, np.cos(waves.direction)
    x, _, z = rest.state.q.tolist()
    sine, cosine = rest.state.axes[[0, 2], 2].tolist()
    by_acceleration = rest.by_acceleration[_PLANE][:, :, [0, 2]]
    middle = 0.5 * (laid.foot + laid.top)
    places = np.stack([x + middle * sine, 0.0 * middle, np.minimum(z + middle * cosine, depth)], 1)
    flow = velocities_at(places, sea)
    shape = np.stack([np.ones_like(k), 1j * k * ahead], axis=1)  # of the surface: height and slope
    here = waves.amplitude * np.exp(1j * (k * x * ahead + waves.phase))
    push = (shape @ rest.by_surface[_PLANE].T + 0j) * here[:, np.newaxis]
    accelerates = -1j * omega[:, np.newaxis, np.newaxis] * flow[:, :, [0, 2]]
    push += np.einsum("wjk,ijk->wi", accelerates, by_acceleration)
    diffracted = hull.lay_out(sea.flow).excited
    diffraction = (diffracted[:, 0::2] + 1j * diffracted[:, 1::2])[:, _PLANE]
    push += diffraction * (here / waves.amplitude)[:, np.newaxis]

    memory = hull.radiation.memory
    damping, free = laid.damping[_PLANE], laid.free[_PLANE]
    inertia = np.diag([hull.mass, hull.mass, hull.inertia]) + hull.radiation.infinite
    square, turn = omega[:, np.newaxis, np.newaxis] ** 2, 1j * omega
    stiffness = rest.stiffness[np.ix_(_PLANE, _PLANE)]
    matrix: Complex = (stiffness - square * inertia).astype(np.complex128)
    for i in range(3):
        matrix[:, i, i] -= turn * damping[i]
        for j in range(3):
            matrix[:, i, j] -= omega**2 * memory.added_mass(omega, i, j)
            matrix[:, i, j] -= turn * memory.damping(omega, i, j)

    arm = ways_of_eyes(arms_of(laid, rest.state.axes))[:, :, _PLANE]
    arm[:, 1] = 0.0
    held = free == 0.0
    matrix[:, held, :] = matrix[:, :, held] = 0.0
    matrix[:, held, held] = 1.0
    push[:, held] = arm[:, :, held] = 0.0

    carried = by_acceleration[0, :, 0]
    wet = carried / (laid.density * math.pi * laid.radius**2)
    # The water pulls where what is wet of a slice is: along the axis, from its moments.
    moment = by_acceleration[2, :, 0] * cosine - by_acceleration[2, :, 1] * sine
    lever = np.divide(moment, carried, out=np.zeros_like(middle), where=carried > 0.0)
    stream = replace(sea, waves=None).kinematics(0.0, places).velocity
    seen = [np.stack([np.full_like(middle, cosine), np.full_like(middle, -sine), lever], axis=1)]
    coefficient, at = [laid.drag * wet], [np.arange(middle.size)]
    if laid.bottom_drag > 0.0:
        face = laid.column[:, 0] * laid.bottom_radius
        seen.append(np.stack([np.full_like(face, sine), np.full_like(face, cosine), -face], axis=1))
        coefficient.append(laid.bottom_drag * laid.column[:, 1])
        at.append(np.zeros(face.size, dtype=int))
    way, of = np.concatenate(seen), np.concatenate(at)
    there = flow[:, of]
    flow = there[:, :, 0] * way[:, 0] + there[:, :, 2] * way[:, 1]
    mean = stream[of, 0] * way[:, 0] + stream[of, 2] * way[:, 1]
    way = way * free
    return LinearHull(omega, matrix, push, arm, way, np.concatenate(coefficient), mean, flow)
