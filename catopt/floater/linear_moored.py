"""A hull on its lines in small motion about rest: one wave at a time, without steps in time."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from catopt.arrays import Array
from catopt.fem.linear_motion import velocities_at
from catopt.fem.morison import equivalent_drag
from catopt.fem.series import Complex
from catopt.floater.moored import AtRest, arms_of, ways_of_eyes
from catopt.hydro.build import FloatingHull
from catopt.waves import Sea

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
