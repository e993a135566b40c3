"""A hull on its lines in small motion about rest: one wave at a time, without steps in time."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from catopt.arrays import Array
from catopt.fem.linear_motion import velocities_at
from catopt.fem.morison import equivalent_drag
from catopt.fem.series import Complex
from catopt.floater.moored import AtRest, arms_of
from catopt.hydro.build import FloatingHull
from catopt.waves import Sea


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
    x, z, turned = rest.state.q.tolist()
    sine, cosine = math.sin(turned), math.cos(turned)
    middle = 0.5 * (laid.foot + laid.top)
    places = np.stack([x + middle * sine, 0.0 * middle, np.minimum(z + middle * cosine, depth)], 1)
    flow = velocities_at(places, sea)
    shape = np.stack([np.ones_like(k), 1j * k * ahead], axis=1)  # of the surface: height and slope
    here = waves.amplitude * np.exp(1j * (k * x * ahead + waves.phase))
    push = (shape @ rest.by_surface.T + 0j) * here[:, np.newaxis]
    accelerates = -1j * omega[:, np.newaxis, np.newaxis] * flow[:, :, [0, 2]]
    push += np.einsum("wjk,ijk->wi", accelerates, rest.by_acceleration)
    diffracted = hull.lay_out(sea.flow).excited
    diffraction = diffracted[:, 0::2] + 1j * diffracted[:, 1::2]
    push += diffraction * (here / waves.amplitude)[:, np.newaxis]

    memory = hull.radiation.memory
    inertia = np.diag([hull.mass, hull.mass, hull.inertia]) + laid.added
    square, turn = omega[:, np.newaxis, np.newaxis] ** 2, 1j * omega
    matrix: Complex = (rest.stiffness - square * inertia).astype(np.complex128)
    for i in range(3):
        matrix[:, i, i] -= turn * laid.damping[i]
        for j in range(3):
            matrix[:, i, j] -= omega**2 * memory.added_mass(omega, i, j)
            matrix[:, i, j] -= turn * memory.damping(omega, i, j)

    arm = np.zeros((len(laid.eye), 3, 3))
    arms = arms_of(laid, rest.state.q)
    arm[:, 0, 0] = arm[:, 2, 1] = 1.0
    arm[:, 0, 2], arm[:, 2, 2] = arms[:, 1], -arms[:, 0]
    held = laid.free == 0.0
    matrix[:, held, :] = matrix[:, :, held] = 0.0
    matrix[:, held, held] = 1.0
    push[:, held] = arm[:, :, held] = 0.0

    carried = rest.by_acceleration[0, :, 0]
    wet = carried / (laid.density * math.pi * laid.radius**2)
    # The water pulls where what is wet of a slice is: along the axis, from its moments.
    moment = rest.by_acceleration[2, :, 0] * cosine - rest.by_acceleration[2, :, 1] * sine
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
    way = way * laid.free
    return LinearHull(omega, matrix, push, arm, way, np.concatenate(coefficient), mean, flow)
