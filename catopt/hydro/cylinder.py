"""Radiation and excitation of a floating vertical cylinder in water of finite depth.

Potentials are matched in eigenfunctions at the cylinder's side (Yeung, Applied Ocean Research 3,
1981, for heave; surge and pitch in the same way). With the bed at z = 0, the surface at h, the
bottom of the cylinder of radius a at d, and exp(-i omega t):

    outside  phi = cos(m theta) sum C_n R_n(r) Z_n(z),   Z_0 = cosh(k z)/N_0, Z_n = cos(k_n z)/N_n
    below    phi = phi_p + cos(m theta) sum D_l e_l P_l(r) cos(l pi z/d)

phi_p has the body's own speed at its bottom; R_n has the slope 1 at r = a, P_l the value 1. The
speed is continuous over the depth, the potential over the gap below. m = 0 in heave, 1 in surge
and pitch. Without its waves, at an infinite frequency, phi = 0 at the surface.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from copy import copy
from dataclasses import dataclass
from typing import Any, Final, NamedTuple

import numpy as np
import numpy.typing as npt
from scipy.special import h1vp, hankel1, ive, jv, kve

from catopt.arrays import Array
from catopt.constants import SEA_WATER_DENSITY, STANDARD_GRAVITY
from catopt.model.kinds import Findings
from catopt.waves.random_surface import depth_factor, wave_number
from catopt.words import Message

Complex = npt.NDArray[np.complex128]

SURGE, HEAVE, PITCH = 0, 1, 2
_TERMS: Final = 60
"""Eigenfunctions on either side, at least; more where the gap is many draughts high."""
_MOST: Final = 240
_ROUND: Final = 8
"""Waves round the cylinder, beyond k a."""


class CylinderAnswer(NamedTuple):
    """Surge, heave and pitch of a cylinder at some frequencies, about a point on its axis."""

    omega: Array  # (n,), rad/s
    added_mass: Array  # (n, 3, 3): kg, kg m, kg m2
    damping: Array  # (n, 3, 3): N s/m and so on
    excitation: Complex  # (n, 3): N/m and N, for 1 m of exp(i (k x - omega t)) at the axis
    froude_krylov: Complex  # (n, 3): what of it the pressure of the wave itself makes


@dataclass(frozen=True)
class FloatingCylinder:
    """A vertical cylinder afloat.

    Parameters
    ----------
    radius, draught, depth : float
        m; the depth of the water is above the draught.
    reference : float
        Height above still water of the point about which it pitches, m.
    density, gravity : float
        Of the water, kg/m3; m/s2.

    Examples
    --------
    >>> answer = FloatingCylinder(0.9, 0.5, 12.0, density=1.0, gravity=9.81).at([2.0])
    >>> round(float(answer.added_mass[0, 1, 1]), 2), round(float(answer.damping[0, 1, 1]) / 2.0, 2)
    (1.45, 0.48)
    """

    radius: float
    draught: float
    depth: float
    reference: float = 0.0
    density: float = SEA_WATER_DENSITY
    gravity: float = STANDARD_GRAVITY

    def __post_init__(self) -> None:
        check_floating(self, "radius")

    @property
    def terms(self) -> int:
        """Eigenfunctions that are matched on either side."""
        finest = min(self.radius, self.draught, self.depth - self.draught)
        return int(min(max(_TERMS, 12.0 * self.depth / finest), _MOST))

    def at(self, omega: Array | list[float]) -> CylinderAnswer:
        """Answer at some frequencies, rad/s, above 0."""
        given = np.atleast_1d(np.asarray(omega, dtype=float))
        size = given.size
        mass, damping = np.zeros((2, size, 3, 3))
        excited, wave = np.zeros((2, size, 3), dtype=complex)
        for i, w in enumerate(given):
            own = Matched(self, float(w))
            mass[i], damping[i] = own.added_mass.real, own.added_mass.imag * w
            excited[i], wave[i] = own.excitation(), own.froude_krylov()
        return CylinderAnswer(given, mass, damping, excited, wave)

    def drift(
        self,
        omega: float,
        mass: Array | None = None,
        stiffness: Array | None = None,
        damping: Array | None = None,
    ) -> float:
        """Mean drift along a wave of 1 m, N/m2: momentum far away (Maruo 1960), in finite depth.

        Of each wave round the cylinder, cos(m theta), S_m leaves for 1 that comes in; fixed, |S_m|
        is 1 and follows from radiation. The force is rho g/(2 k) (1 + 2 k h/sinh 2 k h) times the
        sum of 1 - Re(S_m S*_m+1). `omega` in rad/s; `mass`, `stiffness` and `damping` (3, 3) of
        surge, heave and pitch about the reference, beside those of the waves; it is held fast
        without a mass.
        """
        of, speeds = Matched(self, omega), [0j, 0j, 0j]
        if mass is not None:
            zero = np.zeros((3, 3))
            own = (zero if stiffness is None else stiffness) - omega**2 * (mass + of.added_mass)
            own = own - 1j * omega * (zero if damping is None else damping)
            speeds = (-1j * omega * np.linalg.solve(own, of.excitation())).tolist()
        sent = of.sent(speeds)
        unit = 0.5 * self.density * self.gravity * depth_factor(of.k, self.depth) / of.k
        return unit * float((1.0 - (sent[:-1] * sent[1:].conj()).real).sum())

    def at_infinite_frequency(self) -> Array:
        """Give the added mass (3, 3) of motion much faster than its waves."""
        return np.ascontiguousarray(Matched(self, math.inf).added_mass.real)


def check_floating(of: Any, width: str) -> None:
    """Raise InputError unless a body can float in the water; `width`: key of its breadth or radius.

    `of` has the fields of a `FloatingCylinder`, but for its width.
    """
    found = Findings(type(of).__name__)
    found.numbers(of, "m", width, "draught", "depth", above=0.0)
    found.number("reference", of.reference, "m")
    found.number("density", of.density, "kg/m3", above=0.0)
    found.number("gravity", of.gravity, "m/s2", above=0.0)
    if not found.problems and not of.draught < of.depth:
        allowed = Message("refused_motion.must_be_below_m_depth", depth=of.depth)
        found.add("draught", f"{of.draught:g} m", allowed)
    found.raise_if_any()


class Matched:
    """The potentials of one frequency, with unit speeds of the body."""

    def __init__(self, of: FloatingCylinder, omega: float) -> None:
        self.of, self.omega = of, omega
        self.d = of.depth - of.draught
        self._eigenvalues()
        count = of.terms
        self.below = np.arange(count) * math.pi / self.d
        self.G = self._overlap()
        self.C: dict[int, Complex] = {}
        self.D: dict[int, Complex] = {}
        self._solve()

    def _solve(self) -> None:
        """Match the potentials of every mode."""
        self._match(0, HEAVE)
        self._match(1, SURGE, PITCH)
        self.added_mass = self._masses()

    # ------------------------------------------------------------------ outside

    def _eigenvalues(self) -> None:
        """Wave number k (0 without waves), the k_n, and the squares of the norms N."""
        of, h = self.of, self.of.depth
        n = np.arange(1.0, of.terms + 1.0)
        if math.isinf(self.omega):
            self.k, self.k_n = 0.0, (n - 0.5) * math.pi / h
        else:
            nu = self.omega**2 / of.gravity
            self.k = wave_number(self.omega * math.sqrt(STANDARD_GRAVITY / of.gravity), h)
            self.k_n = _evanescent(nu, h, n)
        self.N = 0.5 * (1.0 + np.sin(2.0 * self.k_n * h) / (2.0 * self.k_n * h))

    def _integral_Z(self, low: float, high: float) -> Array:
        """Integral of all Z from one height to another; the wave's first, if there is one."""
        own = (np.sin(self.k_n * high) - np.sin(self.k_n * low)) / self.k_n / np.sqrt(self.N)
        if self.k == 0.0:
            return own
        return np.concatenate([[self._sinh(high) / self.k - self._sinh(low) / self.k], own])

    def _integral_zZ(self, low: float, high: float, about: float) -> Array:
        """Integral of (z - about) Z."""
        k_n, root = self.k_n, np.sqrt(self.N)

        def own(z: float) -> Array:
            found: Array = ((z - about) * np.sin(k_n * z) / k_n + np.cos(k_n * z) / k_n**2) / root
            return found

        def wave(z: float) -> float:
            return (z - about) * self._sinh(z) / self.k - self._cosh(z) / self.k**2

        if self.k == 0.0:
            return own(high) - own(low)
        return np.concatenate([[wave(high) - wave(low)], own(high) - own(low)])

    def _cosh(self, z: float) -> float:
        """Z of the wave: cosh(k z)/N_0, scaled so that nothing overflows."""
        return _scaled(self.k, z, self.of.depth, 1.0) / self._norm

    def _sinh(self, z: float) -> float:
        return _scaled(self.k, z, self.of.depth, -1.0) / self._norm

    @property
    def _norm(self) -> float:
        """Root of N_0 over the scale of `_scaled`, cosh(k h)."""
        kh = self.k * self.of.depth
        # N_0 = (1 + sinh(2 kh)/(2 kh))/2, over cosh(kh)^2.
        over = 4.0 * math.exp(-2.0 * kh) / (1.0 + math.exp(-2.0 * kh)) ** 2
        return math.sqrt(0.5 * (over + math.tanh(kh) / kh))

    def _radial(self, m: int) -> Complex:
        """R at r = a of all outside functions, whose slope there is 1."""
        a = self.of.radius
        x = self.k_n * a
        K, K_next = kve(m, x), kve(m + 1, x)
        slope = m / x * K - K_next
        own: Complex = K / (self.k_n * slope) + 0j
        if self.k == 0.0:
            return own
        y = self.k * a
        wave = hankel1(m, y) / (self.k * h1vp(m, y))
        return np.asarray(np.concatenate([np.array([wave], dtype=complex), own]))

    # ------------------------------------------------------------------ below

    def _overlap(self) -> Array:
        """Mean over the gap of Z_n cos(l pi z/d): (outside, below)."""
        d, m_l, k = self.d, self.below, self.k_n[:, np.newaxis]
        minus, plus = (k - m_l) * d, (k + m_l) * d
        near = np.sinc(minus / math.pi) + np.sinc(plus / math.pi)
        own = 0.5 * near / np.sqrt(self.N)[:, np.newaxis]
        if self.k == 0.0:
            return own
        wave = self._signs() * self.k * self._sinh(d) / (self.k**2 + m_l**2) / d
        return np.concatenate([wave[np.newaxis], own])

    def _signs(self) -> Array:
        """cos(l pi): 1 and -1 in turn."""
        return np.where(np.arange(self.below.size) % 2 == 0, 1.0, -1.0)

    def _square(self) -> Array:
        """Mean over the gap of z^2 cos(l pi z/d)."""
        rest = 2.0 * self._signs()[1:] / self.below[1:] ** 2
        return np.concatenate([[self.d * self.d / 3.0], rest])

    def _slopes(self, m: int) -> Array:
        """Slopes at r = a of the functions below, with e_l."""
        a, x = self.of.radius, self.below[1:] * self.of.radius
        at_side, above = ive(m, x), ive(m + 1, x)
        rest = 2.0 * self.below[1:] * (above / at_side + m / x)
        return np.concatenate([[m / a], rest])

    def _match(self, m: int, *modes: int) -> None:
        """Find C and D of modes of the same m.

        Of the functions outside the wave alone is complex. What it adds to the matrix is a product
        of two vectors, so that real equations are solved for it and the rest (Sherman, Morrison).
        """
        radial, slopes = self._radial(m), self._slopes(m)
        speeds, held = map(np.stack, zip(*map(self._own, modes), strict=True))
        over = self.d / self.of.depth
        waves = 0 if self.k == 0.0 else 1
        G, R = self.G[waves:], radial[waves:].real
        matrix = np.eye(self.below.size) - over * ((G.T * R) @ G) * slopes
        right = G.T @ (R * speeds[:, waves:]).T - held.T
        solved = np.linalg.solve(matrix, np.hstack([right, self.G[:waves].T]))
        D = solved[:, : len(modes)].T + 0j
        if waves:
            x, turned = solved[:, -1], self.G[0] * slopes
            D = D + np.outer(radial[0] * speeds[:, 0], x)
            share = over * radial[0] / (1.0 - over * radial[0] * (turned @ x))
            D = D + np.outer(share * (D @ turned), x)
        for k, mode in enumerate(modes):
            self.C[mode] = speeds[k] + over * (self.G @ (slopes * D[k]))
            self.D[mode] = D[k]

    def _own(self, mode: int) -> tuple[Array, Array]:
        """Speed of the body and of phi_p at r = a by Z, over h; and phi_p by cos(l pi z/d)."""
        a, d, h = self.of.radius, self.d, self.of.depth
        p, square = np.zeros(self.below.size), self._square()
        if mode == SURGE:
            return self._integral_Z(d, h) / h, p
        if mode == HEAVE:
            p = square / (2.0 * d)
            p[0] -= a * a / (4.0 * d)
            return self._integral_Z(0.0, d) * (-a / (2.0 * d)) / h, p
        p = -a * square / (2.0 * d)
        p[0] += a**3 / (8.0 * d)
        about = h + self.of.reference
        speed = self._integral_zZ(d, h, about)
        gap = self._mean_square_Z()
        # d phi_p/dr at a: -(z^2 - 3 a^2/4)/(2 d)
        speed -= (gap - 0.75 * a * a * self._integral_Z(0.0, d)) / (2.0 * d)
        return speed / h, p

    def _mean_square_Z(self) -> Array:
        """Integral of z^2 Z over the gap."""
        d, k = self.d, self.k_n
        s, c = np.sin(k * d), np.cos(k * d)
        own = (d * d * s / k + 2.0 * d * c / k**2 - 2.0 * s / k**3) / np.sqrt(self.N)
        if self.k == 0.0:
            return own
        q = self.k
        wave = d * d * self._sinh(d) / q - 2.0 * d * self._cosh(d) / q**2
        return np.concatenate([[wave + 2.0 * self._sinh(d) / q**3], own])

    # ------------------------------------------------------------------ far away

    def _ring(self, mode: int, m: int) -> complex:
        """Wave of a unit speed, as the potential that goes with H_m."""
        return complex(self.C[mode][0] / (self.k * h1vp(m, self.k * self.of.radius)))

    def sent(self, speeds: Sequence[complex] = (0.0, 0.0, 0.0)) -> Complex:
        """S_m for m from 0 to where nothing is scattered any more.

        A potential of real speeds on the hull less its conjugate has none there. `speeds`: of
        surge, heave and pitch, for a wave of 1 m; without, the cylinder is held fast.
        """
        out = []
        for m in range(math.ceil(self.k * self.of.radius) + _ROUND):
            of = self
            if m > 1:
                of = copy(self)
                of.C, of.D = {}, {}
                of._match(m, SURGE)
            ring = of._ring(SURGE if m else HEAVE, m)
            out.append(-ring / ring.conjugate())
        wave = self.of.gravity / (1j * self.omega) / self._cosh(self.of.depth)
        out[0] += 2.0 * speeds[HEAVE] * self._ring(HEAVE, 0) / wave
        turning = speeds[SURGE] * self._ring(SURGE, 1) + speeds[PITCH] * self._ring(PITCH, 1)
        out[1] += turning / (1j * wave)
        return np.array(out)

    # ------------------------------------------------------------------ forces

    def _masses(self) -> Complex:
        """Give A + i B/omega, (3, 3)."""
        of, out = self.of, np.zeros((3, 3), dtype=complex)
        a, d, h, rho = of.radius, self.d, of.depth, of.density
        about = h + of.reference
        side, arm = self._integral_Z(d, h), self._integral_zZ(d, h, about)
        radial = self._radial(1)
        for mode in (SURGE, PITCH):
            on_side = self.C[mode] * radial
            out[SURGE, mode] = -rho * math.pi * a * (on_side @ side)
            out[PITCH, mode] = -rho * math.pi * a * (on_side @ arm)
            out[PITCH, mode] -= rho * self._below_turning(mode)
        out[HEAVE, HEAVE] = rho * self._below_heave()
        # Both are the same by Green's theorem; what truncation leaves between them is shared.
        out[SURGE, PITCH] = out[PITCH, SURGE] = 0.5 * (out[SURGE, PITCH] + out[PITCH, SURGE])
        return out

    def _below_heave(self) -> complex:
        """Integral of the potential over the bottom."""
        a, d, m_l = self.of.radius, self.d, self.below
        x = m_l[1:] * a
        parts = 2.0 * ive(1, x) / ive(0, x) / m_l[1:] * a
        D, signs = self.D[HEAVE], self._signs()[1:]
        held = 0.5 * a * a * D[0] + (D[1:] * parts * signs).sum()
        own = 0.25 * d * a * a - a**4 / (16.0 * d)
        return complex(2.0 * math.pi * (held + own))

    def _below_turning(self, mode: int) -> complex:
        """Integral of the potential times r cos(theta) over the bottom."""
        a, d, m_l = self.of.radius, self.d, self.below
        x = m_l[1:] * a
        parts = 2.0 * a * a / m_l[1:] * ive(2, x) / ive(1, x)
        D, signs = self.D[mode], self._signs()[1:]
        held = 0.25 * a**3 * D[0] + (D[1:] * parts * signs).sum()
        own = 0.0
        if mode == PITCH:
            own = -(d * d * a**4 / 4.0 - a**6 / 24.0) / (2.0 * d)
        return complex(math.pi * (held + own))

    def excitation(self) -> Complex:
        """Force for a wave of 1 m, by the radiated wave (Haskind)."""
        of, k, h = self.of, self.k, self.of.depth
        out = np.zeros(3, dtype=complex)
        for mode, m in ((SURGE, 1), (HEAVE, 0), (PITCH, 1)):
            far = 4.0j * h * 1j**m / (k * h1vp(m, k * of.radius) * self._cosh(h))
            out[mode] = -of.density * of.gravity * far * self.C[mode][0]
        return out

    def froude_krylov(self) -> Complex:
        """Give what of it the pressure of the undisturbed wave makes, on the hull at rest."""
        of, k = self.of, self.k
        a, d, h = of.radius, self.d, of.depth
        top, y = self._cosh(h), k * a
        scale = of.density * of.gravity / top
        side = (self._sinh(h) - self._sinh(d)) / k
        arm = self._integral_zZ(d, h, h + of.reference)[0]
        out = np.zeros(3, dtype=complex)
        out[SURGE] = -2.0j * math.pi * a * jv(1, y) * scale * side
        out[HEAVE] = 2.0 * math.pi * a * jv(1, y) / k * scale * self._cosh(d)
        # Moment: of the side, and of the bottom, where the pressure's part in cos(theta) turns.
        out[PITCH] = -2.0j * math.pi * a * jv(1, y) * scale * arm
        out[PITCH] -= 2.0j * math.pi * a * a * jv(2, y) / k * scale * self._cosh(d)
        return out


def _evanescent(nu: float, h: float, n: Array) -> Array:
    """Solve k tan(k h) = -nu in (n - 1/2, n) pi/h by Newton's method: x = n pi - atan(nu h/x)."""
    y = nu * h
    x = n * math.pi - np.arctan2(y, n * math.pi)
    for _ in range(60):
        step = (x - n * math.pi + np.arctan2(y, x)) / (1.0 - y / (x * x + y * y))
        x = x - step
        if float(np.abs(step).max()) <= 1e-14 * float(x[0]):
            break
    return np.asarray(x / h)


def _scaled(k: float, z: float, h: float, sign: float) -> float:
    """Give cosh(k z)/cosh(k h), or with the sign -1 sinh(k z)/cosh(k h)."""
    grown = math.exp(k * (z - h))
    return grown * (1.0 + sign * math.exp(-2.0 * k * z)) / (1.0 + math.exp(-2.0 * k * h))
