"""Coefficients of a floating body by frequency and heading, and the memory that they come to."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import numpy as np
import numpy.typing as npt
from scipy.interpolate import CubicSpline

from catopt.arrays import Array, Codes, without_last_digits
from catopt.model.kinds import Findings
from catopt.words import Message

Complex = npt.NDArray[np.complex128]

FREEDOMS: Final = ("surge", "sway", "heave", "roll", "pitch", "yaw")
_SAME: Final = 1e-9
_ROUNDING: Final = 1e-2
"""Part of the largest of its kind by which panels leave a matrix unsymmetrical, or a damping below
0, without a remark."""


@dataclass(frozen=True, eq=False)
class Coefficients:
    """Coefficients of a floating body, in SI, about one point; x forwards, y to port, z upwards.

    Complex numbers have the size and, as their angle, the phase by which the answer lags behind the
    crest of a wave of 1 m amplitude over that point: time goes as exp(-i omega t). Headings are
    where the waves travel to, counter-clockwise from the body's x axis. None: not known.

    Attributes
    ----------
    omega : ndarray, shape (n,)
        Angular frequencies, rad/s, rising, above 0.
    heading : ndarray, shape (h,)
        rad, rising.
    added_mass, damping : ndarray, shape (n, 6, 6)
        kg, kg m and kg m2; N s/m, N s and N m s.
    added_mass_zero, added_mass_infinite : ndarray, shape (6, 6)
        The limits at zero and infinite frequency.
    excitation : ndarray of complex, shape (n, h, 6)
        Force, N/m, and moment, N.
    response : ndarray of complex, shape (n, h, 6)
        Response amplitude operators of the body afloat, m/m and rad/m.
    mean_drift : ndarray, shape (n, h, 6)
        Mean force and moment over the square of the amplitude, N/m2 and N/m.
    stiffness : ndarray, shape (6, 6)
        Of weight and buoyancy.
    mass : ndarray, shape (6, 6)
    source : str
        Which files it is of.
    """

    omega: Array
    heading: Array
    added_mass: Array | None = None
    damping: Array | None = None
    added_mass_zero: Array | None = None
    added_mass_infinite: Array | None = None
    excitation: Complex | None = None
    response: Complex | None = None
    mean_drift: Array | None = None
    stiffness: Array | None = None
    mass: Array | None = None
    source: str = ""

    def __post_init__(self) -> None:
        found = Findings("Coefficients")
        for key, values in (("omega", self.omega), ("heading", self.heading)):
            if not (np.diff(values) > 0.0).all() or (key == "omega" and (values <= 0.0).any()):
                found.add(key, f"{values.size}", Message("refused_motion.must_rise"))
        n, h = self.omega.size, self.heading.size
        shapes = dict.fromkeys(("added_mass", "damping"), (n, 6, 6))
        shapes |= dict.fromkeys(("excitation", "response", "mean_drift"), (n, h, 6))
        limits = ("added_mass_zero", "added_mass_infinite", "stiffness", "mass")
        for key, shape in (shapes | dict.fromkeys(limits, (6, 6))).items():
            values = getattr(self, key)
            if values is not None and values.shape != shape:
                allowed = Message("refused_motion.shape", shape=shape)
                found.add(key, Message("refused_motion.shape", shape=values.shape), allowed)
            elif values is not None and not np.isfinite(values).all():
                found.add(key, "nan", Message("refused_motion.finite_numbers_are_wanted"))
        found.raise_if_any()

    def at(self, key: str, omega: Array, heading: Array) -> Complex:
        """Interpolate answers to waves, one of `excitation`, `response` and `mean_drift`.

        `omega` (n,), rad/s; `heading` (..., n), rad, any number of turns; returns (..., n, 6), in
        proportion between headings and frequencies. Beyond the first and the last frequency it is
        held. InputError for a heading around which there is nothing, or answers that are not known.
        """
        values, found = getattr(self, key), Findings(self.source or "Coefficients")
        if values is None or self.omega.size == 0:
            found.add(key, "", Message("refused_motion.missing_from_files"))
            found.raise_if_any()
        first, last = float(self.heading[0]), float(self.heading[-1])
        wanted = first + (heading - first + _SAME) % (2.0 * math.pi) - _SAME
        beyond = wanted[wanted > last + _SAME]
        if beyond.size:
            far = math.degrees(float(beyond.flat[0])) % 360.0
            given = Message("refused_motion.waves_travel_deg_from_ship", value=far)
            ends = {"first": math.degrees(first), "last": math.degrees(last)}
            found.add("heading", given, Message("refused_motion.file_has_rows", **ends))
            found.raise_if_any()
        low, part = _between(self.omega, np.broadcast_to(omega, wanted.shape))
        left, aside = _between(self.heading, wanted)
        high = np.minimum(low + 1, self.omega.size - 1)
        right = np.minimum(left + 1, self.heading.size - 1)
        part, aside = part[..., np.newaxis], aside[..., np.newaxis]
        under = (1.0 - aside) * values[low, left] + aside * values[low, right]
        over = (1.0 - aside) * values[high, left] + aside * values[high, right]
        return np.asarray((1.0 - part) * under + part * over, dtype=complex)

    def memory(self, longest: float) -> Memory:
        """Find its memory, as exponentials; the waves that it made have gone after `longest`, s."""
        assert self.damping is not None
        if not self.damping.any():
            return Memory.none()
        return Memory.of(self.omega, self.damping, longest, most=_OF_A_SHIP)

    def infinite(self, memory: Memory) -> Array:
        """Find the added mass of the infinite frequency, (6, 6), by Ogilvie's relation.

        Even where the files give it: from a mesh it is less exact than the table, and the waves are
        where the table is.
        """
        assert self.added_mass is not None
        return infinite_added_mass(self.omega, self.added_mass, memory)

    @property
    def remarks(self) -> tuple[Message, ...]:
        """What of it no body at rest in still water can have: a mesh or units that are wrong."""
        said = []
        for key in ("added_mass", "damping", "stiffness", "mass"):
            values = getattr(self, key)
            if values is None:
                continue
            scale = _scale(values)
            lopsided = values - np.swapaxes(values, -1, -2)
            off = float(np.abs(lopsided / np.multiply.outer(scale, scale)).max())
            if off > _ROUNDING:
                said.append(Message(f"floater.{key}_unsymmetrical", part=off))
        if self.damping is not None:
            both = 0.5 * (self.damping + np.swapaxes(self.damping, -1, -2))
            scale = _scale(self.damping)
            least = float(np.linalg.eigvalsh(both / np.multiply.outer(scale, scale)).min())
            if least < -_ROUNDING:
                said.append(Message("floater.damping_drives", part=-least))
        return tuple(said)


def _scale(values: Array) -> Array:
    """Root of the largest of each diagonal entry, by which entries are made alike."""
    diagonal = np.abs(np.diagonal(values, axis1=-2, axis2=-1)).reshape(-1, 6).max(axis=0)
    scale: Array = np.sqrt(diagonal)
    scale[scale == 0.0] = scale.max() or 1.0
    return scale


def _between(rising: Array, at: Array) -> tuple[npt.NDArray[np.int64], Array]:
    """Find the entry below each value, and its part of the way on; held beyond the ends."""
    if rising.size == 1:
        return np.zeros(at.shape, dtype=np.int64), np.zeros(at.shape)
    below = np.clip(np.searchsorted(rising, at, side="right") - 1, 0, rising.size - 2)
    way = rising[below + 1] - rising[below]
    return below, np.clip((at - rising[below]) / way, 0.0, 1.0)


_FINE: Final = 4000
"""Frequencies over which B is integrated."""
_SAMPLES: Final = 240
"""Of K, from which the exponentials are found."""
_KEPT: Final = 1e-4
"""Singular value, over the largest, below which there is nothing but rounding in a spline."""
_OF_A_SHIP: Final = 24
"""Exponentials of each entry: a hull of 186 m wants some 20 for added mass within 1 %."""
_MOST: Final = 12
"""Exponentials of one K, unless more are asked for."""


def retardation(omega: Array, damping: Array, t: Array) -> Array:
    """K at times t, s, of radiation damping B at rising frequencies, rad/s; B(0) = 0.

    Beyond the last frequency B falls with its inverse cube, as that of a wall-sided body does.
    """
    fine, B = _fine(omega, damping)
    weight = np.gradient(fine)
    weight[[0, -1]] *= 0.5
    return np.asarray((2.0 / math.pi) * (np.cos(np.outer(t, fine)) @ (weight * B)))


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
            values = Message("refused_motion.values", count=omega.size)
            found.add("omega", values, Message("refused_motion.four_rising"))
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
            without_last_digits(np.array(rows[2], dtype=complex)),
            without_last_digits(np.array(rows[3], dtype=complex)),
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
    """Rates and strengths by the matrix pencil; one of each conjugate pair, twice as strong.

    What falls by less than a factor e while K is over is none of it: it would have a part of B at
    the lowest frequencies, even below 0, and so give energy back that it never took.
    """
    half = K.size // 2
    hankel = np.lib.stride_tricks.sliding_window_view(K, half + 1)
    _, size, rows = np.linalg.svd(hankel, full_matrices=False)
    rank = int(min((size > _KEPT * size[0]).sum(), most))
    V = rows[:rank]
    z = np.linalg.eigvals(np.linalg.pinv(V[:, :-1].T) @ V[:, 1:].T)
    z = z[(np.abs(z) < 1.0 - 1e-9) & (np.abs(z) > 1e-12)]
    rate = np.log(z) / (t[1] - t[0])
    rate = rate[rate.real * t[-1] <= -1.0]
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
