"""What a body feels of the waves that it made before: Cummins' memory, as a few exponentials.

With radiation damping B and the added mass A of a frequency (Cummins 1962; Ogilvie 1964)

    K(t) = 2/pi integral B(w) cos(w t) dw,    A(w) = A_inf - 1/w integral K(t) sin(w t) dt

and the force is -A_inf a - integral K(s) v(t - s) ds. K is written as a sum of exponentials with
complex rates, found from its samples by the matrix pencil; each then is one number that is carried
from step to step, however long or short these are.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import numpy as np
import numpy.typing as npt
from scipy.interpolate import CubicSpline

from catopt.arrays import Array, Codes
from catopt.model.kinds import Findings
from catopt.words import Message

_FINE: Final = 4000
"""Frequencies over which B is integrated."""
_SAMPLES: Final = 240
"""Of K, from which the exponentials are found."""
_KEPT: Final = 1e-4
"""Singular value, over the largest, below which there is nothing but rounding in a spline."""
_MOST: Final = 12
"""Exponentials of one K, unless more are asked for."""


def retardation(omega: Array, damping: Array, t: Array) -> Array:
    """K at times t, s, of radiation damping B at rising frequencies, rad/s; B(0) = 0.

    Beyond the last frequency B falls with its inverse cube, as that of a wall-sided body does.
    """
    fine, B = _fine(omega, damping)
    weight = np.gradient(fine)
    weight[[0, -1]] *= 0.5
    K: Array = (2.0 / math.pi) * (np.cos(np.outer(t, fine)) @ (weight * B))
    return K


def _fine(omega: Array, damping: Array) -> tuple[Array, Array]:
    """B by a spline at many frequencies, with its tail."""
    last = float(omega[-1])
    spline = CubicSpline(np.concatenate([[0.0], omega]), np.concatenate([[0.0], damping]))
    fine = np.linspace(0.0, 3.0 * last, _FINE)
    B = np.where(fine <= last, spline(fine), damping[-1] * (last / np.maximum(fine, last)) ** 3)
    return fine, B


@dataclass(frozen=True)
class Memory:
    """Exponentials of all K: K_ij(t) is the real part of the sum of strength exp(rate t)."""

    row: Codes  # (n,): i
    column: Codes  # (n,): j
    rate: npt.NDArray[np.complex128]  # (n,), 1/s, with a negative real part
    strength: npt.NDArray[np.complex128]  # (n,)

    @classmethod
    def none(cls) -> Memory:
        """Return that of a body that makes no waves."""
        empty = np.empty(0, dtype=complex)
        return cls(np.empty(0, dtype=np.int64), np.empty(0, dtype=np.int64), empty, empty)

    @classmethod
    def of(cls, omega: Array, damping: Array, longest: float, most: int = _MOST) -> Memory:
        """Find it from B (n, f, f) at rising frequencies, rad/s; K is over after `longest`, s.

        At `most` so many exponentials each: a buoy's K falls at once, a ship's has many waves.
        Raises InputError where frequencies do not rise.
        """
        found = Findings("Memory")
        if not (omega.size > 3 and (np.diff(omega) > 0.0).all() and omega[0] > 0.0):
            found.add("omega", f"{omega.size} values", Message("refused_motion.four_rising"))
        found.number("longest", longest, "s", above=0.0)
        found.raise_if_any()
        t = np.linspace(0.0, longest, _SAMPLES)
        parts: list[tuple[int, int, complex, complex]] = []
        scale = np.abs(damping).max(axis=0)
        for i in range(damping.shape[1]):
            for j in range(damping.shape[2]):
                if scale[i, j] <= 1e-9 * math.sqrt(scale[i, i] * scale[j, j]):
                    continue
                K = retardation(omega, damping[:, i, j], t)
                parts += [(i, j, p, r) for p, r in _exponentials(t, K, most)]
        rows = list(zip(*parts, strict=True)) or [(), (), (), ()]
        return cls(
            np.array(rows[0], dtype=np.int64),
            np.array(rows[1], dtype=np.int64),
            np.array(rows[2], dtype=complex),
            np.array(rows[3], dtype=complex),
        )

    def kernel(self, t: Array, i: int = 0, j: int = 0) -> Array:
        """K_ij at times t, s."""
        which = (self.row == i) & (self.column == j)
        return np.asarray((np.exp(np.outer(t, self.rate[which])) @ self.strength[which]).real)

    def damping(self, omega: Array, i: int = 0, j: int = 0) -> Array:
        """Give B_ij at frequencies, rad/s, back."""
        return np.asarray(self._transform(omega, i, j).real)

    def added_mass(self, omega: Array, i: int = 0, j: int = 0) -> Array:
        """A_ij less A_inf at frequencies, rad/s."""
        return np.asarray(self._transform(omega, i, j).imag / omega)

    def _transform(self, omega: Array, i: int, j: int) -> npt.NDArray[np.complex128]:
        """Integral of K exp(-i w t) from 0 on."""
        which = (self.row == i) & (self.column == j)
        p, r = self.rate[which], self.strength[which]
        s = 1.0j * np.asarray(omega)[:, np.newaxis]
        both: npt.NDArray[np.complex128] = 0.5 * (r / (s - p) + r.conj() / (s - p.conj())).sum(1)
        return both


def _exponentials(t: Array, K: Array, most: int) -> list[tuple[complex, complex]]:
    """Rates and strengths by the matrix pencil; one of each conjugate pair, twice as strong."""
    half = K.size // 2
    hankel = np.lib.stride_tricks.sliding_window_view(K, half + 1)
    _, size, rows = np.linalg.svd(hankel, full_matrices=False)
    rank = int(min((size > _KEPT * size[0]).sum(), most))
    V = rows[:rank]
    z = np.linalg.eigvals(np.linalg.pinv(V[:, :-1].T) @ V[:, 1:].T)
    z = z[(np.abs(z) < 1.0 - 1e-9) & (np.abs(z) > 1e-12)]
    rate = np.log(z) / (t[1] - t[0])
    basis = np.exp(np.outer(t, rate))
    strength = np.linalg.lstsq(basis, K.astype(complex), rcond=None)[0]
    upper = rate.imag > 1e-9
    real = np.abs(rate.imag) <= 1e-9
    pairs = list(zip(rate[upper], 2.0 * strength[upper], strict=True))
    return pairs + list(zip(rate[real], strength[real].real + 0j, strict=True))


def infinite_added_mass(omega: Array, added_mass: Array, memory: Memory) -> Array:
    """A_inf (f, f) from A (n, f, f) and the memory, by Ogilvie's relation; the mean over all."""
    size = added_mass.shape[1]
    off = np.zeros_like(added_mass)
    for i in range(size):
        for j in range(size):
            off[:, i, j] = memory.added_mass(omega, i, j)
    return np.asarray((added_mass - off).mean(axis=0))
