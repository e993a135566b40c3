"""Radiation and scattering of a ship's section: a rectangle in the surface of water of some depth.

Potentials are matched in eigenfunctions at the sides, as those of `catopt.hydro.cylinder`, with
exponentials in place of Bessel's functions. Waves meet the section abeam, or obliquely: crests then
move along the ship with the wave number k_s, and all varies as exp(i k_s s).
"""

from __future__ import annotations

import math
from copy import copy
from dataclasses import dataclass, replace
from typing import Any, Final

import numpy as np

from catopt.arrays import Array
from catopt.constants import SEA_WATER_DENSITY, STANDARD_GRAVITY
from catopt.hydro.cylinder import HEAVE, Complex, Matched, check_floating
from catopt.waves.random_surface import depth_factor, wave_number

SWAY, TILT, SIDES = 0, 2, 3
"""Modes beside HEAVE: the turn about the section's origin, from the vertical to the horizontal
axis; both sides outwards at the same speed."""
_GRAZING: Final = 1e-3
"""Least part of the wave number that is left across the section."""


@dataclass(frozen=True)
class Section:
    """A rectangular section afloat, per metre of the ship.

    Parameters
    ----------
    breadth, draught, depth : float
        m; the depth of the water is above the draught.
    reference : float
        Height above still water of the point about which it rolls, m.
    density, gravity : float
        Of the water, kg/m3; m/s2.

    Examples
    --------
    A wave is reflected or passes: nothing else becomes of it.

    >>> reflected, passed = Section(0.4, 0.2, 1.0).scattered(7.0)
    >>> round(abs(reflected) ** 2 + abs(passed) ** 2, 9)
    1.0
    """

    breadth: float
    draught: float
    depth: float
    reference: float = 0.0
    density: float = SEA_WATER_DENSITY
    gravity: float = STANDARD_GRAVITY

    def __post_init__(self) -> None:
        check_floating(self, "breadth")

    @property
    def radius(self) -> float:
        """Half the breadth, m."""
        return 0.5 * self.breadth

    @property
    def terms(self) -> int:
        """Eigenfunctions that are matched on either side."""
        finest = min(self.draught, self.depth - self.draught)
        return int(min(max(_TERMS, 6.0 * self.depth / finest), _MOST))

    def at(self, omega: float, along: float = 0.0) -> MatchedSection:
        """Match its potentials at a frequency, rad/s; `along`: cosine between wave and ship.

        Water deeper than waves and section reach is cut off: the eigenfunctions left are finer.
        """
        k = wave_number(omega * math.sqrt(STANDARD_GRAVITY / self.gravity), self.depth)
        reach = max(_REACH / k, _DRAUGHTS * self.draught)
        return MatchedSection(replace(self, depth=min(self.depth, reach)), omega, along)

    def scattered(self, omega: float, along: float = 0.0) -> tuple[complex, complex]:
        """Reflected and transmitted part of a wave of 1 m on the section held fast.

        As `at`. Both are of where the wave would be at the section's axis.
        """
        even, odd = self.at(omega, along).phases
        return 0.5 * (even + odd), 0.5 * (even - odd)

    def drift(
        self,
        omega: float,
        mass: Array | None = None,
        stiffness: Array | None = None,
        damping: Array | None = None,
    ) -> float:
        """Mean drift of a wave abeam of 1 m, N/m: Longuet-Higgins' (1977), Maruo's (1960) in 2D.

        rho g/4 (1 + |R|^2 - |T|^2) (1 + 2 k h/sinh 2 k h) of what is reflected and what passes;
        without damping that is rho g/2 |R|^2 (1 + ...). `mass`, `stiffness` and `damping` (3, 3) of
        a metre's length, of sway, heave and roll about the reference, beside those of the waves;
        without a mass it is held fast.
        """
        of = self.at(omega)
        even, odd = of.phases
        if mass is not None:
            zero = np.zeros((3, 3))
            own = stiffness if stiffness is not None else zero
            own = own - omega**2 * (mass + of.added_mass.real)
            own = own - 1j * omega * ((zero if damping is None else damping) + of.damping)
            motion = np.linalg.solve(own, of.forces)
            waves = -2j * omega * of.waves * motion
            even, odd = even + waves[HEAVE], odd + waves[SWAY] + waves[TILT]
        reflected, passed = 0.5 * abs(even + odd), 0.5 * abs(even - odd)
        unit = 0.25 * self.density * self.gravity * depth_factor(of.k, self.depth)
        return unit * (1.0 + reflected**2 - passed**2)


_TERMS: Final = 40
"""Eigenfunctions on either side, at least; more where the gap is many draughts high."""
_MOST: Final = 160
_REACH: Final = 4.0
"""Depth times wave number below which there is no wave: tanh is 0.9993."""
_DRAUGHTS: Final = 6.0


class MatchedSection(Matched):
    """The potentials of one frequency; waves come from positive x, where the ship's side is."""

    def __init__(self, of: Section, omega: float, along: float = 0.0) -> None:
        self.half = of.radius
        self._turn(along)
        alike: Any = of  # in all that its cylinder is asked for
        super().__init__(alike, omega)

    def obliquely(self, along: float) -> MatchedSection:
        """Match them anew for waves that meet the ship at another angle."""
        other = copy(self)
        other.C, other.D = {}, {}
        other._turn(along)
        other._solve()
        return other

    def _turn(self, along: float) -> None:
        self.across = max(math.sqrt(max(1.0 - along * along, 0.0)), _GRAZING)
        self.along = math.sqrt(1.0 - self.across**2)

    def _solve(self) -> None:
        self.k_s, self.k_x = self.k * self.along, self.k * self.across
        self.under = np.hypot(self.below, self.k_s)
        if self.k_s:
            self._match(0, SIDES)
            self._match(1, SWAY)
            return
        self._match(0, HEAVE, SIDES)
        self._match(1, SWAY, TILT)
        self.added_mass = self._masses()

    def _radial(self, _: int) -> Complex:
        """Values at the side of the outside functions, whose slope there is 1."""
        own = -1.0 / np.hypot(self.k_n, self.k_s) + 0j
        return np.asarray(np.concatenate([np.array([-1j / self.k_x]), own]))

    def _slopes(self, m: int) -> Array:
        """Slopes at the side of the functions below, with e_l."""
        b, mu = self.half, self.under
        size = np.where(mu > 0.0, mu, 1.0)
        rise = np.tanh(size * b)
        slope = np.where(mu > 0.0, size * (rise if m == 0 else 1.0 / rise), m / b)
        return np.asarray(np.concatenate([slope[:1], 2.0 * slope[1:]]))

    def _own(self, mode: int) -> tuple[Array, Array]:
        """Speed of the section and of phi_p at its side by Z, over h; phi_p by cos(l pi z/d)."""
        b, d, h = self.half, self.d, self.of.depth
        p = np.zeros(self.below.size)
        if mode in (SWAY, SIDES):
            return self._integral_Z(d, h) / h, p
        square = self._square()
        if mode == HEAVE:  # phi_p = (z^2 - x^2)/(2 d)
            p = square / (2.0 * d)
            p[0] -= b * b / (2.0 * d)
            return self._integral_Z(0.0, d) * (-b / d) / h, p
        p = -b * square / (2.0 * d)  # phi_p = -(x z^2 - x^3/3)/(2 d)
        p[0] += b**3 / (6.0 * d)
        speed = self._integral_zZ(d, h, h + self.of.reference)
        gap = self._mean_square_Z() - b * b * self._integral_Z(0.0, d)
        return (speed - gap / (2.0 * d)) / h, p

    def _masses(self) -> Complex:
        """Give A + i B/omega of sway, heave and tilt, (3, 3)."""
        b, d, h, rho = self.half, self.d, self.of.depth, self.of.density
        side, arm = self._integral_Z(d, h), self._integral_zZ(d, h, h + self.of.reference)
        radial, out = self._radial(1), np.zeros((3, 3), dtype=complex)
        m_l, signs = self.below[1:], self._signs()[1:]
        tanh = np.tanh(m_l * b)
        D = self.D[HEAVE]
        below = 2.0 * b * D[0] + (D[1:] * signs * tanh / m_l).sum() * 4.0
        out[HEAVE, HEAVE] = rho * (below + b * d - b**3 / (3.0 * d))
        for mode in (SWAY, TILT):
            on_side, D = self.C[mode] * radial, self.D[mode]
            out[SWAY, mode] = -2.0 * rho * (on_side @ side)
            turning = D[0] * 2.0 * b * b / 3.0
            turning += 4.0 * (D[1:] * signs * (b / tanh / m_l - 1.0 / m_l**2)).sum()
            if mode == TILT:
                turning -= d * b**3 / 3.0 - b**5 / (15.0 * d)
            out[TILT, mode] = -2.0 * rho * (on_side @ arm) - rho * turning
        out[SWAY, TILT] = out[TILT, SWAY] = 0.5 * (out[SWAY, TILT] + out[TILT, SWAY])
        return out

    # ------------------------------------------------------------------ far away

    def _far(self, mode: int) -> complex:
        """Wave on the side of positive x for unit speed, as potential at the axis."""
        turn = np.exp(-1j * self.k_x * self.half) / (1j * self.k_x)
        return complex(self.C[mode][0] * turn)

    @property
    def damping(self) -> Array:
        """Radiation damping of sway, heave and tilt, (3, 3)."""
        return self.added_mass.imag * self.omega

    @property
    def waves(self) -> Complex:
        """Surface of the waves on the side of positive x for unit speeds, s."""
        scale = 1j * self.omega / self.of.gravity * self._cosh(self.of.depth)
        return np.array([scale * self._far(mode) for mode in (SWAY, HEAVE, TILT)])

    @property
    def phases(self) -> tuple[complex, complex]:
        """What leaves over what comes, of waves alike and of waves opposite on the two sides.

        Fixed, the section sends all of it back. It follows from radiation: a potential of real
        speeds on the hull less its conjugate has none there (Newman, J. Fluid Mech. 71, 1975).
        """
        even, odd = self._far(SIDES), self._far(SWAY)
        return -even / even.conjugate(), -odd / odd.conjugate()

    @property
    def forces(self) -> Complex:
        """Force of sway, heave, tilt for a wave of 1 m from positive x, by Haskind's relation."""
        return np.array([self.excited(mode) for mode in (SWAY, HEAVE, TILT)])

    def excited(self, mode: int) -> complex:
        """Force of one mode likewise."""
        of = self.of
        scale = -2j * of.density * of.gravity * self.k_x * of.depth / self._cosh(of.depth)
        return complex(scale * self._far(mode))

    def heaved(self, across: float) -> complex:
        """Force in heave for a wave of 1 m, a part of whose wave number is across the section.

        By strips (Salvesen, Tuck and Faltinsen 1970): of the potential of waves abeam, and of the
        wave's own pressure and speed on the hull; equals Haskind's where all of it is across.
        """
        of, b, d, k = self.of, self.half, self.d, self.k
        q = max(across, _GRAZING) * k
        crest = of.gravity / (1j * self.omega) / self._cosh(of.depth)
        m_l, D, signs = self.below[1:], self.D[HEAVE], self._signs()[1:]
        cos, sin = math.cos(q * b), math.sin(q * b)
        plain = 2.0 * sin / q
        curved = b * b * plain + 4.0 * (b * cos / q**2 - sin / q**3)
        ripple = 2.0 * (m_l * np.tanh(m_l * b) * cos + q * sin) / (m_l**2 + q**2)
        below = D[0] * plain + 2.0 * (D[1:] * signs * ripple).sum()
        below += 0.5 * d * plain - 0.5 * curved / d
        at_gap = 2.0 * (D + self._own(HEAVE)[1])
        at_gap[0] *= 0.5
        side = self.C[HEAVE][0] * self._radial(0)[0] * of.depth - d * (self.G[0] @ at_gap)
        push = self._cosh(d) * plain - k * self._sinh(d) * below - 2.0 * q * sin * side
        return complex(1j * self.omega * of.density * crest * push)
