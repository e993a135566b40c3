"""Mean drift of the waves on a ship of given main dimensions, in surge, sway and yaw by heading.

The far-field formula of Maruo (1960), over the waves that the ship's sections send out: each
scatters the wave and radiates by its motion as a rectangle does in two dimensions, and all of them
together as sources and dipoles along the ship. Across the ship it becomes Maruo's formula of a
section. Her ends reflect as Faltinsen, Minsaas, Liapis and Skjordal (1980) have it of a waterline
in short waves, times what a section in the ship's motion reflects of a wave that meets it squarely.
What joins them is catopt's.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import Final

import numpy as np

from catopt.arrays import Array
from catopt.constants import SEA_WATER_DENSITY, STANDARD_GRAVITY
from catopt.hydro.coefficients import Coefficients
from catopt.hydro.cylinder import HEAVE
from catopt.hydro.section import SWAY, TILT, MatchedSection, Section
from catopt.model.kinds import Findings
from catopt.waves.random_surface import depth_factor

_STATIONS: Final = 31
"""Along the ship, at least; one for each rad of the wave."""
_ALL_ROUND: Final = 180
"""Directions in which waves leave, at least; three for each rad of the wave along the ship."""
_AT_AN_END: Final = 24
"""Pieces of a quarter of the waterline at an end."""
_GYRATION: Final = 0.25
"""Radius of gyration in pitch and yaw, over the length."""
_ROLL: Final = 0.37
"""And in roll, over the breadth."""
_HEADINGS: Final = 10
"""From astern to abeam, for the table."""
_FREQUENCIES: Final = 36
_SHORTEST, _LONGEST = 6.0, 0.03
"""Wave number times half the breadth, of the table's ends."""


@dataclass(frozen=True)
class HullForm:
    """A ship's hull by its main dimensions.

    Parameters
    ----------
    length, breadth, draught : float
        Of the waterline, m.
    depth : float
        Of the water, m, above the draught.
    block : float
        Block coefficient.
    waterplane : float, optional
        Waterplane coefficient; without, (1 + 2 block)/3. Ends are half ellipses that leave so much.
    entrance : float, optional
        Half angle between the sides of the waterline at the ends, rad: wedges in place of ellipses,
        as long as breadth and angle ask; a right angle is a barge's.
    roll_period : float, optional
        Natural period, s; without, she does not roll.
    roll_damping : float
        Beside that of her waves, as a part of critical.
    density, gravity : float
        Of the water, kg/m3; m/s2.

    Examples
    --------
    A tanker of 246 m, loaded, in head seas of 8.6 s: over 1/2 rho g a^2 B.

    >>> hull = HullForm(246.0, 46.0, 10.0, 500.0, block=0.816)
    >>> surge, sway, yaw = hull.mean_drift(0.728, math.pi)
    >>> round(surge / (0.5 * hull.density * hull.gravity * 46.0), 1)
    -0.4
    """

    length: float
    breadth: float
    draught: float
    depth: float
    block: float
    waterplane: float | None = None
    entrance: float | None = None
    roll_period: float | None = None
    roll_damping: float = 0.05
    density: float = SEA_WATER_DENSITY
    gravity: float = STANDARD_GRAVITY

    def __post_init__(self) -> None:
        found = Findings("HullForm")
        found.numbers(self, "m", "length", "breadth", "draught", above=0.0)
        found.number("depth", self.depth, "m", above=0.0)
        found.numbers(self, "", "block", "waterplane", above=0.0, at_most=1.0)
        found.numbers(self, "rad", "entrance", above=0.0, at_most=0.5 * math.pi)
        found.numbers(self, "s", "roll_period", above=0.0)
        found.number("roll_damping", self.roll_damping, "", at_least=0.0)
        found.numbers(self, "", "density", "gravity", above=0.0)
        if not found.problems:
            found.number("depth", self.depth, "m", above=self.draught)
        found.raise_if_any()

    @property
    def waterplane_coefficient(self) -> float:
        """Area of the waterline over length and breadth."""
        return (1.0 + 2.0 * self.block) / 3.0 if self.waterplane is None else self.waterplane

    @property
    def end(self) -> float:
        """Length of each end, m."""
        if self.entrance is not None:
            own = 0.5 * self.breadth / math.tan(self.entrance)
        else:
            own = (1.0 - self.waterplane_coefficient) * self.length / (2.0 - 0.5 * math.pi)
        return min(own, 0.5 * self.length)

    def mean_drift(self, omega: float, heading: float) -> tuple[float, float, float]:
        """Surge, sway, N/m2, and yaw about midships, N/m, for a wave of 1 m; as the square of it.

        `omega` in rad/s; `heading`: where the waves travel to, counter-clockwise from ahead, rad.
        """
        found = Findings("HullForm")
        found.number("omega", omega, "rad/s", above=0.0)
        found.number("heading", heading, "rad")
        found.raise_if_any()
        section = Section(self.breadth, self.draught, self.depth, 0.0, self.density, self.gravity)
        return _InWaves(self, section.at(omega)).drift(heading)

    def coefficients(self) -> Coefficients:
        """Tabulate the mean drift all round, for `Coefficients.at`."""
        return _tabulated(self)


@lru_cache(maxsize=32)
def _tabulated(hull: HullForm) -> Coefficients:
    k = np.geomspace(_LONGEST, _SHORTEST, _FREQUENCIES) / (0.5 * hull.breadth)
    omega = np.sqrt(hull.gravity * k * np.tanh(k * hull.depth))
    section = Section(hull.breadth, hull.draught, hull.depth, 0.0, hull.density, hull.gravity)
    quarter = np.linspace(0.0, 0.5 * math.pi, _HEADINGS)
    found = np.zeros((omega.size, _HEADINGS, 3))
    for n, frequency in enumerate(omega.tolist()):
        waves = _InWaves(hull, section.at(frequency))
        found[n] = [waves.drift(heading) for heading in quarter.tolist()]
    # Fore and aft she is alike, and so are her sides.
    half = np.concatenate([found, found[:, -2::-1] * [-1.0, 1.0, -1.0]], axis=1)
    whole = np.concatenate([half, half[:, -2::-1] * [1.0, -1.0, -1.0]], axis=1)
    table = np.zeros((*whole.shape[:2], 6))
    table[:, :, [0, 1, 5]] = whole
    headings = np.linspace(0.0, 2.0 * math.pi, whole.shape[1])
    return Coefficients(omega, headings, mean_drift=table)


_STEP: Final = 1e-3
"""Part of the frequency, and rad of the heading, over which the drift is differentiated."""


def wave_drift_damping(of: Coefficients, omega: Array, heading: Array) -> Array:
    """Damping of slow surge and sway by the waves, of each wave over the square of its amplitude.

    After Aranha (1994), recalled (R), deep water: with tau = U omega/g, of a motion with the speed
    U in a direction psi, F(U) = (1 - 4 tau cos(beta - psi)) F(omega (1 - tau cos(beta - psi)),
    beta + 2 tau sin(beta - psi)), and the damping is -dF/dU. catopt takes it in no answer of its
    own: it is there for those who give a damping.

    Parameters
    ----------
    of : Coefficients
        With a mean drift, of `HullForm.coefficients` or of a file.
    omega, heading : array, shape (n,)
        rad/s; where the waves travel to, from ahead, rad.

    Returns
    -------
    array, shape (n, 2, 2)
        Force along the first, surge or sway, per speed along the second, N s/m3.
    """

    def force(w: Array, beta: Array) -> Array:
        return np.asarray(of.at("mean_drift", w, beta)[..., :2].real)

    h = _STEP * omega
    by_omega = force(omega + h, heading) - force(omega - h, heading)
    by_omega = by_omega / (2.0 * h[:, np.newaxis])
    by_heading = force(omega, heading + _STEP) - force(omega, heading - _STEP)
    by_heading = by_heading / (2.0 * _STEP)
    still, out = force(omega, heading), np.empty((omega.size, 2, 2))
    for j, along in enumerate((0.0, 0.5 * math.pi)):
        cosine, sine = (
            np.cos(heading - along)[:, np.newaxis],
            np.sin(heading - along)[:, np.newaxis],
        )
        w = omega[:, np.newaxis]
        change = -cosine * (4.0 * still + w * by_omega) + 2.0 * sine * by_heading
        out[:, :, j] = -change * w / STANDARD_GRAVITY
    return out


class _InWaves:
    """A ship in waves of one frequency."""

    def __init__(self, hull: HullForm, own: MatchedSection) -> None:
        self.hull, self.own = hull, own
        self.k, self.omega = own.k, own.omega
        self.floats = hull.waterplane_coefficient * hull.length
        long = self.k * self.floats
        stations = max(_STATIONS, math.ceil(long))
        self.x = np.linspace(-0.5 * self.floats, 0.5 * self.floats, stations)
        self.weight = np.full(stations, self.x[1] - self.x[0])
        self.weight[[0, -1]] *= 0.5
        self.directions = max(_ALL_ROUND, math.ceil(3.0 * long))
        angle = np.arange(self.directions) * (2.0 * math.pi / self.directions)
        self.cos, self.sin = np.cos(angle), np.sin(angle)
        # Two directions of one cosine, to starboard and to port, share a row.
        each = np.arange(self.directions)
        self.row = np.minimum(each, self.directions - each)
        rows = self.cos[: self.directions // 2 + 1]
        self.leaving = np.exp(-1j * self.k * np.outer(rows, self.x)) * self.weight

    def drift(self, heading: float) -> tuple[float, float, float]:
        """Surge, sway and yaw; waves come from starboard here, from port they are mirrored."""
        cosine, sine = math.cos(heading), math.sin(heading)
        along = math.copysign(1.0, sine)
        of = _Meeting(self, cosine, abs(sine))
        surge, sway, yaw = (a + b for a, b in zip(of.by_sections(), of.by_ends(), strict=True))
        return surge, along * sway, along * yaw


class _Meeting:
    """Waves that travel along the ship by their cosine, and from starboard to port by their sine.

    A section has its positive side to starboard, where they come from: it sways to there.
    """

    def __init__(self, of: _InWaves, cosine: float, sine: float) -> None:
        self.of, self.cosine, self.sine = of, cosine, sine
        k, hull = of.k, of.hull
        self.crest = np.exp(1j * k * cosine * of.x)
        # Waves along a ship spread aside over her length, as far as so much across them goes; what
        # is not alike on both sides is in proportion to what is left of that.
        self.least = math.sqrt(min(1.0, sine * sine + 1.0 / (k * hull.length)))
        self.spread = of.own.obliquely(math.sqrt(1.0 - self.least**2))
        self.odd = sine / self.least
        self._move()

    def _move(self) -> None:
        """Find the motions by strips: heave, pitch, sway, yaw, roll, and surge with the water."""
        of, hull, own = self.of, self.of.hull, self.of.own
        x, weight, crest, square = of.x, of.weight, self.crest, of.omega**2
        displaced = hull.density * hull.breadth * hull.draught
        mass, long = displaced * hull.block * hull.length, of.floats
        about, third = mass * (_GYRATION * hull.length) ** 2, long**3 / 12.0
        water = own.added_mass * square  # A + i B/omega, times omega^2
        float_ = hull.density * hull.gravity * hull.breadth - water[HEAVE, HEAVE]
        push = own.heaved(self.sine) * crest
        self.heave = (weight @ push) / (float_ * long - square * mass)
        self.pitch = -(weight @ (x * push)) / (float_ * third - square * about)
        sideways = self.spread.excited(SWAY) * self.odd
        aside = sideways * crest
        self.yaw = (weight @ (x * aside)) / (-water[SWAY, SWAY] * third - square * about)
        matrix = -water[np.ix_([SWAY, TILT], [SWAY, TILT])] * long
        matrix[0, 0] -= square * mass
        pushed = (weight @ crest) * np.array([sideways, 0.0])
        if hull.roll_period is None:
            self.sway, self.tilt = pushed[0] / matrix[0, 0], 0.0
            return
        # Her centre of gravity is taken for as high as the surface; her stiffness is by her period.
        pushed[1] = own.excited(TILT) * self.sine * (weight @ crest)
        inertia = mass * (_ROLL * hull.breadth) ** 2
        natural = 2.0 * math.pi / hull.roll_period
        whole = inertia + own.added_mass[TILT, TILT].real * long
        spring = whole * natural * (natural - 2j * hull.roll_damping * of.omega)
        matrix[1, 1] += spring - square * inertia
        self.sway, self.tilt = np.linalg.solve(matrix, pushed)

    def by_sections(self) -> tuple[float, float, float]:
        """Far-field drift of what all sections send out."""
        of, hull, waves = self.of, self.of.hull, self.of.own.waves * (-1j * self.of.omega)
        phases = self.spread.phases
        even = self.least * 0.5 * (phases[0] - 1.0) * self.crest
        even = even + waves[HEAVE] * (self.heave - of.x * self.pitch)
        odd = self.odd * 0.5 * (phases[1] + 1.0) * self.crest
        odd = odd + waves[SWAY] * (self.sway + of.x * self.yaw) + waves[TILT] * self.tilt
        starboard = -of.sin  # part of a dipole that a direction sees
        parts = np.column_stack([even, odd, of.x * even, of.x * odd])
        summed = (of.leaving @ parts)[of.row]
        sent = summed[:, 0] + starboard * summed[:, 1]
        moment = summed[:, 2] + starboard * summed[:, 3]
        unit = 0.25 * hull.density * hull.gravity * depth_factor(of.k, hull.depth)
        unit *= of.k / of.directions
        energy = np.abs(sent) ** 2
        surge = unit * float(energy @ (self.cosine - of.cos))
        sway = unit * float(energy @ (self.sine - of.sin))
        yaw = unit * float((moment * sent.conj()).real @ (self.sine - of.sin))
        return surge, sway, yaw

    def by_ends(self) -> tuple[float, float, float]:
        """Drift along the ship of the waterline at her ends, where waves meet it."""
        of, hull = self.of, self.of.hull
        half, end = 0.5 * hull.breadth, hull.end
        angle = (np.arange(_AT_AN_END) + 0.5) * (0.5 * math.pi / _AT_AN_END)
        surge = yaw = 0.0
        for fore in (1.0, -1.0):
            for port in (1.0, -1.0):
                if hull.entrance is None:
                    ahead, aside = end * np.cos(angle), half * np.sin(angle)
                    n_x, n_y = half * np.cos(angle), end * np.sin(angle)
                    step = 0.5 * math.pi / _AT_AN_END
                else:
                    part = 2.0 * angle / math.pi
                    ahead, aside = end * (1.0 - part), half * part
                    n_x, n_y, step = half, end, 1.0 / _AT_AN_END
                n_x, n_y = fore * n_x, port * n_y + 0.0 * angle
                piece = np.hypot(n_x, n_y)
                met = np.maximum(-(n_x * self.cosine + n_y * self.sine) / piece, 0.0)
                x = fore * (0.5 * hull.length - end + ahead)
                push = self._reflected(x, n_x / piece, n_y / piece) * met**2 * step * -n_x
                surge += float(push.sum())
                yaw -= float((push * port * aside).sum())
        unit = 0.5 * hull.density * hull.gravity * depth_factor(of.k, hull.depth)
        return unit * surge, 0.0, unit * yaw

    def _reflected(self, x: Array, n_x: Array, n_y: Array) -> Array:
        """Square of what an end sends back, moving with her: as a section that is met squarely."""
        of, own = self.of, self.of.own
        crest = np.exp(1j * of.k * self.cosine * x)
        upwards = self.heave - x * self.pitch
        outwards = self._surge() * n_x - (self.sway + x * self.yaw) * n_y
        even, odd = own.phases
        waves = -1j * of.omega * own.waves
        scattered = 0.5 * (even + odd) + (waves[HEAVE] * upwards + waves[SWAY] * outwards) / crest
        return np.asarray(np.minimum(np.abs(scattered) ** 2, 1.0))

    def _surge(self) -> complex:
        """She goes with the water along her, as the mean over her place."""
        k, hull, section = self.of.k, self.of.hull, self.of.own.of
        below = np.expm1(-2.0 * k * (section.depth - hull.draught))
        below *= math.exp(-k * hull.draught) / np.expm1(-2.0 * k * section.depth)
        along = np.sinc(k * self.cosine * hull.length / (2.0 * math.pi))
        return complex(1j * self.cosine * along * (1.0 - below) / (k * hull.draught))
