"""A floating body in six degrees of freedom, linear: natural frequencies, response, and time.

In time by Cummins' equation: the waves that the body made before act on it by `Memory`.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Final

import numpy as np
from scipy.linalg import eig, expm

from catopt.arrays import Array
from catopt.errors import NotConvergedError
from catopt.hydro.coefficients import FREEDOMS, Coefficients, Complex, Memory
from catopt.model.kinds import Findings
from catopt.waves import Waves
from catopt.words import Message

_ROUNDS: Final = 50
_SAME: Final = 1e-6
"""Change of a natural frequency, over itself, at which it is found."""
_SHIFTED: Final = 0.5
"""Part of the way to the next frequency that an iteration goes: A may change quickly."""


@dataclass(frozen=True, eq=False)
class LinearBody:
    """A body afloat on its lines, about the point of its coefficients.

    Parameters
    ----------
    coefficients : Coefficients
        Added mass and damping, and excitation for a response.
    mass : ndarray, shape (6, 6)
        Of the body alone.
    stiffness : ndarray, shape (6, 6)
        Of weight and buoyancy, and of its lines, such as
        `catopt.mooring.network_rest.HeldBody.stiffness`.
    damping : ndarray, shape (6, 6), optional
        Linear, beyond the waves that it makes.

    Raises
    ------
    InputError
        Shapes that are not (6, 6), and coefficients without added mass or damping.
    """

    coefficients: Coefficients
    mass: Array
    stiffness: Array
    damping: Array | None = None

    def __post_init__(self) -> None:
        found = Findings("LinearBody")
        for key in ("mass", "stiffness", "damping"):
            values = getattr(self, key)
            if values is not None and np.shape(values) != (6, 6):
                shape = Message("refused_motion.shape", shape=np.shape(values))
                found.add(key, shape, Message("refused_motion.shape", shape=(6, 6)))
        for key in ("added_mass", "damping"):
            if getattr(self.coefficients, key) is None:
                found.add(f"coefficients.{key}", "", Message("refused_motion.missing_from_files"))
        found.raise_if_any()

    def added_mass(self, omega: Array) -> Array:
        """Give it at frequencies, (n, 6, 6): linear between those of the table, held beyond."""
        return self._at(omega, self.coefficients.added_mass)

    def radiation_damping(self, omega: Array) -> Array:
        """Give it likewise."""
        return self._at(omega, self.coefficients.damping)

    def _at(self, omega: Array, values: Array | None) -> Array:
        assert values is not None
        known = self.coefficients.omega
        below = np.clip(np.searchsorted(known, omega) - 1, 0, max(known.size - 2, 0))
        above = np.minimum(below + 1, known.size - 1)
        way = np.where(above > below, known[above] - known[below], 1.0)
        part = np.clip((omega - known[below]) / way, 0.0, 1.0)[:, np.newaxis, np.newaxis]
        return np.asarray((1.0 - part) * values[below] + part * values[above])

    @cached_property
    def _extra(self) -> Array:
        return np.zeros((6, 6)) if self.damping is None else self.damping

    # ------------------------------------------------------------------ by frequency

    def natural_frequencies(self) -> dict[str, float]:
        """Undamped natural frequencies, rad/s, by the freedom that moves most in each mode.

        The added mass is that at the frequency itself. Freedoms without stiffness are left out.
        NotConvergedError where an iteration does not close.
        """
        return {
            name: self._natural(freedom)
            for freedom, name in enumerate(FREEDOMS)
            if self.stiffness[freedom, freedom] > 0.0
        }

    def _natural(self, freedom: int) -> float:
        inertia = self.mass + self.added_mass(self.coefficients.omega[:1])[0]
        omega = float(np.sqrt(self.stiffness[freedom, freedom] / inertia[freedom, freedom]))
        for _ in range(_ROUNDS):
            inertia = self.mass + self.added_mass(np.array([omega]))[0]
            squares, modes = eig(self.stiffness, inertia)
            # How much of the mode's kinetic energy is in the freedom.
            scaled = np.abs(modes) ** 2 * np.diag(inertia)[:, np.newaxis]
            mode = int(np.argmax(scaled[freedom] / scaled.sum(axis=0)))
            found = float(np.sqrt(max(squares[mode].real, 0.0)))
            if abs(found - omega) <= _SAME * found:
                return found
            omega += _SHIFTED * (found - omega)
        raise NotConvergedError(Message("floater.no_natural_frequency", freedom=FREEDOMS[freedom]))

    def response(self, omega: Array, heading: Array) -> Complex:
        """Response amplitude operators, (n, h, 6), m/m and rad/m, as of `Coefficients.response`.

        InputError where the excitation is not known around a heading.
        """
        M, B = self.mass + self.added_mass(omega), self.radiation_damping(omega) + self._extra
        w = omega[:, np.newaxis, np.newaxis]
        dynamic = self.stiffness - w**2 * M - 1j * w * B
        force = np.stack(
            [
                self.coefficients.at("excitation", omega, np.full(omega.size, each))
                for each in np.asarray(heading).tolist()
            ],
            axis=-1,
        )
        return np.asarray(np.linalg.solve(dynamic, force).transpose(0, 2, 1), dtype=complex)

    # ------------------------------------------------------------------ in time

    def wave_force(self, waves: Waves, time: Array) -> Array:
        """Force and moment of waves over time, (n, 6); phases count at the body's point."""
        excitation = self.coefficients.at("excitation", waves.omega, waves.direction)
        sized = excitation * (waves.amplitude * np.exp(1j * waves.phase))[:, np.newaxis]
        return np.asarray((np.exp(-1j * np.outer(time, waves.omega)) @ sized).real)

    def run(
        self, force: Array, step: float, *, longest: float, start: tuple[float, ...] = (0.0,) * 6
    ) -> Array:
        """Move it in time from rest at `start` under a force, (n, 6), by Cummins' equation.

        `step`, s: between samples of the force, which is linear between them; then the motion is
        exact. `longest`, s: after which the memory is over. Returns places, (n, 6).
        """
        memory = self.coefficients.memory(longest)
        limit = self.coefficients.infinite(memory)
        return self.run_with(memory, limit, force, step, start)

    def run_with(
        self,
        memory: Memory,
        infinite: Array,
        force: Array,
        step: float,
        start: tuple[float, ...] = (0.0,) * 6,
    ) -> Array:
        """Do it with a memory, and the added mass of the infinite frequency, that are known."""
        states = 12 + 2 * memory.rate.size
        A, into = np.zeros((states, states)), np.zeros((states, 6))
        inverse = np.linalg.inv(self.mass + infinite)
        A[:6, 6:12] = np.eye(6)
        A[6:12, :6], A[6:12, 6:12] = -inverse @ self.stiffness, -inverse @ self._extra
        for m in range(memory.rate.size):
            at, p, r = 12 + 2 * m, memory.rate[m], memory.strength[m]
            A[at : at + 2, at : at + 2] = [[p.real, -p.imag], [p.imag, p.real]]
            A[at, 6 + memory.column[m]] = 1.0
            A[6:12, at] -= inverse[:, memory.row[m]] * r.real
            A[6:12, at + 1] += inverse[:, memory.row[m]] * r.imag
        into[6:12] = inverse
        both = np.zeros((states + 12, states + 12))
        both[:states, :states], both[:states, states : states + 6] = A * step, into * step
        both[states : states + 6, states + 6 :] = np.eye(6)
        whole = expm(both)
        ahead, by_end = whole[:states, :states], whole[:states, states + 6 :]
        by_start = whole[:states, states : states + 6] - by_end
        x = np.zeros(states)
        x[:6] = start
        out = np.empty((force.shape[0], 6))
        out[0] = x[:6]
        for n in range(force.shape[0] - 1):
            x = ahead @ x + by_start @ force[n] + by_end @ force[n + 1]
            out[n + 1] = x[:6]
        return out
