"""From what is known of a hull to what the kernels step in time."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from functools import cached_property
from typing import Final, Protocol

import numpy as np
import numpy.typing as npt
from scipy.interpolate import CubicSpline

from catopt.arrays import Array, Codes, Flags, without_last_digits
from catopt.constants import SEA_WATER_DENSITY, STANDARD_GRAVITY
from catopt.hydro.coefficients import Coefficients, Memory
from catopt.hydro.cylinder import FloatingCylinder
from catopt.hydro.hull import PARTS, Hull, HullRecord, HullRoom, HullState, rotate_axes
from catopt.model.kinds import Findings
from catopt.waves.kinematics import Flow, water_ends
from catopt.waves.random_surface import wave_numbers
from catopt.words import Message

Complex = npt.NDArray[np.complex128]

Freedoms = tuple[bool, ...]
"""Whether it moves in surge, sway, heave, roll, pitch, yaw."""
IN_PLANE: Final = (True, False, True, False, True, False)
"""Freedoms of a hull that stays in the plane of x and z."""
ALONG: Final = 1e-9
"""Sine of an angle, or speed across, m/s, up to which a direction is along x."""
_SURGE_HEAVE_PITCH: Final = np.array([0, 2, 4])
COLUMNS: Final = 9
"""In which a slice that is cut by the surface is divided across."""
_LOWEST, _HIGHEST, _COUNT = 0.05, 3.6, 60
"""Frequencies of a cylinder's radiation, over sqrt(g/a), and how many."""
_LASTS: Final = 40.0
"""After which its memory is over, over sqrt(a/g)."""


@dataclass(frozen=True, eq=False)
class Radiation:
    """Added mass, damping and excitation about the centre of gravity; surge, heave, pitch.

    `omega` (n,): rising, rad/s; `added_mass`, `damping` (n, 3, 3); `infinite` (3, 3): added mass of
    motion much faster than its waves; `excitation` (n, 3): force for a wave of 1 m,
    exp(i (k x - omega t)), N and N m; None: not known. `longest`: when the memory is over, s.
    """

    omega: Array
    added_mass: Array
    damping: Array
    infinite: Array
    excitation: Complex | None
    longest: float

    @classmethod
    def of_cylinder(cls, of: FloatingCylinder) -> Radiation:
        """Find that of a floating vertical cylinder, pitching about its reference."""
        scale = math.sqrt(of.gravity / of.radius)
        omega = scale * (_LOWEST + (_HIGHEST - _LOWEST) * np.linspace(0.0, 1.0, _COUNT) ** 1.3)
        answer = of.at(omega)
        return cls(
            omega,
            without_last_digits(answer.added_mass),
            without_last_digits(answer.damping),
            without_last_digits(of.at_infinite_frequency()),
            without_last_digits(answer.excitation),
            _LASTS / scale,
        )

    @classmethod
    def none(cls) -> Radiation:
        """Return that of a body that makes no waves."""
        zero, grid = np.zeros((4, 3, 3)), np.linspace(1.0, 4.0, 4)
        return cls(grid, zero, zero, np.zeros((3, 3)), None, 1.0)

    @cached_property
    def memory(self) -> Memory:
        """Its memory as exponentials."""
        if not self.damping.any():
            return Memory.none()
        return Memory.of(self.omega, self.damping, self.longest)


class SteppedHull(Protocol):
    """A body that is stepped in time with its lines; what any has to have.

    `mass`, kg; `inertia`: in pitch, kg m2; `size`: such as its draught, m; `level`: height of its
    reference over still water at rest, m; `above`: how far it reaches above that, m;
    `volume_of_all`: of its slices, m3, 0 without any; `eyes`: place of each mooring eye, m.
    """

    @property
    def mass(self) -> float: ...  # noqa: D102 - as said above
    @property
    def inertia(self) -> float: ...  # noqa: D102
    @property
    def size(self) -> float: ...  # noqa: D102
    @property
    def level(self) -> float: ...  # noqa: D102
    @property
    def above(self) -> float: ...  # noqa: D102
    @property
    def volume_of_all(self) -> float: ...  # noqa: D102
    @property
    def eyes(self) -> tuple[tuple[float, float, float], ...]: ...  # noqa: D102
    @property
    def gravity(self) -> float: ...  # noqa: D102
    @property
    def outline(self) -> Array | None:
        """As it is seen from the side, (k, 2), about its reference, m; None: it is not drawn."""

    def freedoms(self, *, in_plane: bool) -> Freedoms:
        """Which it has; `in_plane`: sea and lines leave one of revolution in that of x and z."""
        ...

    def lay_out(self, flow: Flow, free: Freedoms = (True,) * 6) -> Hull:
        """Arrays for the kernels, in a sea; of its freedoms those that are left `free`."""
        ...


@dataclass(frozen=True, eq=False)
class FloatingHull:
    """A body of revolution at rest: slices from below upwards, heights above its keel, m.

    Parameters
    ----------
    foot, top, radius : array, shape (n,)
        Of each slice: heights of its ends, and radius of the disc that displaces as much, m.
    mass, inertia : float
        kg; in pitch about the centre of gravity, kg m2.
    spin_inertia : float, optional
        About the axis, kg m2; left out: as if the mass were spread over what the slices displace.
    centre, draught : float
        Heights of the centre of gravity and of still water, m.
    radiation : Radiation
        About the centre of gravity.
    drag : array, shape (n,)
        0.5 rho C D across each slice, N s2/m3.
    bottom_drag, bottom_radius : float
        0.5 rho C A along the axis, N s2/m2, of the lowest face; its radius, m.
    wind : tuple of float
        Force, N, and height of where it acts, m.
    wind_direction : float
        Where it blows to, counter-clockwise from x, rad.
    damping : tuple of float
        Linear damping in surge (and sway), heave, pitch (and roll).
    constant : tuple of float
        Constant force in surge, heave, pitch.
    eyes : tuple of tuple of float
        Place of each mooring eye: towards x and y from the axis, height above the keel, m.
    free : tuple of bool
        Whether it moves in surge, sway, heave, roll, pitch, yaw.
    """

    foot: Array
    top: Array
    radius: Array
    mass: float
    inertia: float
    centre: float
    draught: float
    radiation: Radiation = field(default_factory=Radiation.none)
    drag: Array | None = None
    bottom_drag: float = 0.0
    bottom_radius: float = 0.0
    wind: tuple[float, float] = (0.0, 0.0)
    wind_direction: float = 0.0
    damping: tuple[float, float, float] = (0.0, 0.0, 0.0)
    constant: tuple[float, float, float] = (0.0, 0.0, 0.0)
    eyes: tuple[tuple[float, float, float], ...] = ()
    free: tuple[bool, ...] = (True,) * 6
    spin_inertia: float | None = None
    density: float = SEA_WATER_DENSITY
    gravity: float = STANDARD_GRAVITY

    def __post_init__(self) -> None:
        found = Findings("FloatingHull")
        found.number("mass", self.mass, "kg", above=0.0)
        found.number("inertia", self.inertia, "kg m2", at_least=0.0)
        found.number("draught", self.draught, "m", above=0.0)
        if len(self.free) != 6:
            found.add("free", f"{len(self.free)}", Message("refused_motion.shape", shape=(6,)))
        if not (self.foot.size == self.top.size == self.radius.size > 0):
            allowed = Message("refused_motion.foot_top_radius_one_or")
            found.add("slices", f"{self.foot.size}", allowed)
        elif not (self.top > self.foot).all():
            found.add("slices", "", Message("refused_motion.top_each_above_foot"))
        found.raise_if_any()

    @property
    def volume(self) -> float:
        """Under still water at rest, m3."""
        return float((math.pi * self.radius**2 * self._wet).sum())

    @property
    def _wet(self) -> Array:
        """Length of each slice under still water, m."""
        return np.clip(self.draught - self.foot, 0.0, self.top - self.foot)

    @property
    def waterplane(self) -> tuple[float, float]:
        """Area, m2, and its second moment, m4, at the draught."""
        cut = (self.foot < self.draught) & (self.draught <= self.top)
        square = float((self.radius[cut] ** 2).sum())
        fourth = float((self.radius[cut] ** 4).sum())
        return math.pi * square, 0.25 * math.pi * fourth

    @property
    def stiffness(self) -> Array:
        """Of weight and buoyancy at rest, (3, 3): N/m and N m."""
        area, second = self.waterplane
        lever = 0.5 * (self.foot + np.minimum(self.top, self.draught)) - self.centre
        volumes = math.pi * self.radius**2 * self._wet
        unit = self.density * self.gravity
        out = np.zeros((3, 3))
        out[1, 1] = unit * area
        out[2, 2] = unit * (second + float((volumes * lever).sum()))
        return out

    def long_wave(self, omega: Array, k: Array, depth: float) -> Complex:
        """Force (n, 3) that the kernels find on it at rest for a small wave of 1 m."""
        s = 0.5 * (self.foot + np.minimum(self.top, self.draught)) - self.centre
        height = np.minimum(0.5 * (self.foot + self.top) - self.draught, 0.0)
        mass = self.density * math.pi * self.radius**2 * self._wet
        along = self.water_acceleration(omega, k, depth, height)
        rise = self.water_acceleration(omega, k, depth, height, upwards=True)
        area, second = self.waterplane
        unit = self.density * self.gravity
        out = np.zeros((omega.size, 3), dtype=complex)
        out[:, 0] = along @ mass
        out[:, 1] = rise @ mass + unit * area
        out[:, 2] = along @ (mass * s) - 1.0j * k * unit * second
        return out

    @staticmethod
    def water_acceleration(
        omega: Array, k: Array, depth: float, height: Array, *, upwards: bool = False
    ) -> Complex:
        """Of a wave of 1 m, at heights over still water, 0 or below: (frequencies, heights)."""
        up, down = np.exp(np.outer(k, height)), np.exp(-np.outer(k, height + 2.0 * depth))
        over = (omega**2 / -np.expm1(-2.0 * k * depth))[:, np.newaxis]
        found: Complex = -over * (up - down) if upwards else -1.0j * over * (up + down)
        return found + 0j

    @property
    def outline(self) -> Array:
        """Of its slices from below up one side and down the other, about its centre of gravity."""
        heights = np.column_stack([self.foot, self.top]).ravel() - self.centre
        radius = np.repeat(self.radius, 2)
        right, left = np.column_stack([radius, heights]), np.column_stack([-radius, heights])
        return np.concatenate([right, left[::-1]])

    def freedoms(self, *, in_plane: bool) -> Freedoms:
        """All six, or without sway, roll and yaw; only lines off its axis turn it about that."""
        if in_plane and not self.wind_across:
            return IN_PLANE
        yaws = any(math.hypot(x, y) > 0.0 for x, y, _ in self.eyes)
        return (True, True, True, True, True, yaws)

    @property
    def wind_across(self) -> bool:
        """Whether the wind blows in another direction than along x."""
        return self.wind[0] != 0.0 and abs(math.sin(self.wind_direction)) > ALONG

    @property
    def size(self) -> float:
        """Largest of its draught and its breadth, m."""
        return max(self.draught, 2.0 * float(self.radius.max()))

    @property
    def level(self) -> float:
        """Height of its centre of gravity over still water at rest, m."""
        return self.centre - self.draught

    @property
    def above(self) -> float:
        """How far it reaches above its centre of gravity, m."""
        return float(self.top.max() - self.centre)

    @property
    def volume_of_all(self) -> float:
        """Of all its slices, m3."""
        return float((math.pi * self.radius**2 * (self.top - self.foot)).sum())

    def lay_out(self, flow: Flow, free: tuple[bool, ...] = (True,) * 6) -> Hull:
        """Arrays for the kernels, in a sea; of its freedoms those that are left `free`."""
        of, moves = self.radiation, np.logical_and(self.free, free)
        places = np.arange(1, COLUMNS + 1) * math.pi / (COLUMNS + 1)
        x, share = np.cos(places), 2.0 / (COLUMNS + 1) * np.sin(places) ** 2
        mode, rate, strength = _around(of.memory, moves)
        spin = self.spin_inertia
        if spin is None:
            volumes = math.pi * self.radius**2 * (self.top - self.foot)
            spin = 0.5 * self.mass * float(volumes @ self.radius**2 / volumes.sum())
        force, height = self.wind
        wind = force * math.cos(self.wind_direction), force * math.sin(self.wind_direction)
        surge, heave, pitch = self.damping
        constant = np.zeros(6)
        constant[_SURGE_HEAVE_PITCH] = self.constant
        eyes = np.array(self.eyes).reshape(-1, 3)
        return Hull(
            mass=float(self.mass),
            inertia=float(self.inertia),
            spin_inertia=float(spin),
            added=_all_round(of.infinite),
            density=float(self.density),
            gravity=float(self.gravity),
            foot=np.ascontiguousarray(self.foot - self.centre, dtype=float),
            top=np.ascontiguousarray(self.top - self.centre, dtype=float),
            radius=np.ascontiguousarray(self.radius, dtype=float),
            drag=np.zeros(self.foot.size) if self.drag is None else np.array(self.drag, float),
            bottom=float(self.foot.min() - self.centre),
            bottom_drag=float(self.bottom_drag),
            bottom_radius=float(self.bottom_radius),
            column=np.ascontiguousarray(np.stack([x, share], axis=1)),
            wind=np.array([*wind, height - self.centre]),
            damping=np.array([surge, surge, heave, pitch, pitch, 0.0], dtype=float),
            constant=constant,
            stiffness=_all_round(self.stiffness),
            restoring=np.zeros((6, 6)),
            level=np.zeros(3),
            eye=np.ascontiguousarray(eyes - [0.0, 0.0, self.centre]),
            free=moves.astype(float),
            mode=mode,
            rate=_parts(rate),
            strength=_parts(strength),
            excited=self._excited(flow),
        )

    def _excited(self, flow: Flow) -> Array:
        """Diffraction of each wave, beyond what the kernels find by slices.

        A wave pushes along its own way, and turns the hull about the level axis across that.
        """
        of, waves, out = self.radiation, flow.waves, np.zeros((flow.waves.shape[0], 12))
        if of.excitation is None or waves.shape[0] == 0:
            return out
        k = wave_numbers(of.omega, flow.depth)
        beyond = of.excitation - self.long_wave(of.omega, k, flow.depth)
        omega = waves[:, 0]
        at = CubicSpline(of.omega, beyond)(np.clip(omega, of.omega[0], of.omega[-1]))
        # Long waves pass as if there were no hull; beyond the table the whole force fades.
        at[omega < of.omega[0]] *= (omega[omega < of.omega[0], np.newaxis] / of.omega[0]) ** 2
        short = omega > of.omega[-1]
        at[short] = -self.long_wave(omega[short], waves[short, 3], flow.depth)
        push, heave, turn = (at * waves[:, 7, np.newaxis]).T
        cosine, sine = waves[:, 5], waves[:, 6]
        force = cosine * push, sine * push, heave, -sine * turn, cosine * turn, 0.0 * turn
        return _parts(np.stack(force, axis=1)).reshape(-1, 12)


@dataclass(frozen=True, eq=False)
class HullOfCoefficients:
    """A body whose coefficients are known, about their point, which is in still water at rest.

    Parameters
    ----------
    coefficients : Coefficients
        With added mass, damping and excitation.
    mass_matrix, stiffness : array, shape (6, 6)
        Of the body alone; of weight and buoyancy.
    memory : Memory
        Of its coefficients.
    infinite : array, shape (6, 6)
        Added mass of motion much faster than its waves.
    displacement : float
        Of the water at the draught of the coefficients, kg.
    force : tuple of float
        Steady, along x and y at the point, N.
    damping : tuple of float
        Linear, N s/m and N m s.
    eyes : tuple of tuple of float
        Place of each mooring eye, m.
    """

    coefficients: Coefficients
    mass_matrix: Array
    stiffness: Array
    memory: Memory
    infinite: Array
    displacement: float
    force: tuple[float, float] = (0.0, 0.0)
    damping: tuple[float, ...] = (0.0,) * 6
    eyes: tuple[tuple[float, float, float], ...] = ()
    density: float = SEA_WATER_DENSITY
    gravity: float = STANDARD_GRAVITY

    @property
    def mass(self) -> float:
        """Of the body, kg."""
        return float(self.mass_matrix[0, 0])

    @property
    def inertia(self) -> float:
        """In pitch about the point, kg m2."""
        return float(self.mass_matrix[4, 4])

    @property
    def outline(self) -> None:
        """None is known."""

    def freedoms(self, *, in_plane: bool) -> Freedoms:  # noqa: ARG002 - as of others
        """All six."""
        return (True,) * 6

    @property
    def size(self) -> float:
        """Edge of a cube that displaces as much, m."""
        return float((self.displacement / self.density) ** (1.0 / 3.0))

    @property
    def level(self) -> float:
        """Height of the point over still water at rest, m."""
        return 0.0

    @property
    def above(self) -> float:
        """Taken as how far it reaches above the point, m."""
        return self.size

    @property
    def volume_of_all(self) -> float:
        """None is known: it has no slices."""
        return 0.0

    def lay_out(self, flow: Flow, free: tuple[bool, ...] = (True,) * 6) -> Hull:
        """Arrays for the kernels, in a sea."""
        of, memory = self.coefficients, self.memory
        # What a body of revolution has of it the kernels add themselves.
        turns = self.inertia
        plain = np.diag([self.mass, self.mass, self.mass, turns, turns, turns])
        own = self.mass_matrix - plain
        waves, none = flow.waves, np.zeros(0)
        excited = np.zeros((waves.shape[0], 12))
        if waves.shape[0] > 0:
            direction = np.arctan2(waves[:, 6], waves[:, 5])
            at = of.at("excitation", waves[:, 0], direction) * waves[:, 7, np.newaxis]
            excited = _parts(at).reshape(-1, 12)
        mode = np.stack([memory.row, memory.column], axis=1).reshape(-1, 2)
        lift = self.displacement * self.gravity
        return Hull(
            mass=self.mass,
            inertia=turns,
            spin_inertia=turns,
            added=np.ascontiguousarray(self.infinite + own),
            density=float(self.density),
            gravity=float(self.gravity),
            foot=none,
            top=none,
            radius=none,
            drag=none,
            bottom=0.0,
            bottom_drag=0.0,
            bottom_radius=0.0,
            column=np.zeros((0, 2)),
            wind=np.zeros(3),
            damping=np.array(self.damping, dtype=float),
            constant=np.array([*self.force, lift, 0.0, 0.0, 0.0]),
            stiffness=np.ascontiguousarray(self.stiffness, dtype=float),
            restoring=np.ascontiguousarray(self.stiffness, dtype=float),
            level=np.array([0.0, 0.0, flow.depth]),
            eye=np.array(self.eyes, dtype=float).reshape(-1, 3),
            free=np.array(free, dtype=float),
            mode=np.ascontiguousarray(mode),
            rate=_parts(memory.rate),
            strength=_parts(memory.strength),
            excited=excited,
        )


def _all_round(of: Array) -> Array:
    """Spread a matrix of surge, heave and pitch of a body of revolution over all six freedoms.

    It sways and rolls as it surges and pitches; what goes to +y as surge to +x turns against roll.
    """
    out = np.zeros((6, 6))
    out[np.ix_(_SURGE_HEAVE_PITCH, _SURGE_HEAVE_PITCH)] = of
    out[1, 1], out[3, 3] = of[0, 0], of[2, 2]
    out[1, 3], out[3, 1] = -of[0, 2], -of[2, 0]
    return out


def _around(memory: Memory, free: Flags) -> tuple[Codes, Complex, Complex]:
    """Modes, rates and strengths of a memory in all freedoms that are free, as `_all_round`."""
    rows = []
    places = memory.row.tolist(), memory.column.tolist()
    for freedom, by, rate, strength in zip(*places, memory.rate, memory.strength, strict=True):
        rows.append((2 * freedom, 2 * by, rate, strength))
        if freedom != 1 and by != 1:
            sign = 1.0 if freedom == by else -1.0
            rows.append(((1, 0, 3)[freedom], (1, 0, 3)[by], rate, sign * strength))
    kept = [row for row in rows if free[row[0]] and free[row[1]]]
    mode = np.array([row[:2] for row in kept], dtype=np.int64).reshape(-1, 2)
    rates, strengths = (np.array([row[i] for row in kept], dtype=complex) for i in (2, 3))
    return mode, rates, strengths


def _parts(values: Complex) -> Array:
    """Put real and imaginary parts beside one another, (..., 2)."""
    return np.ascontiguousarray(np.stack([values.real, values.imag], axis=-1))


def state_of(hull: Hull, place: tuple[float, float, float], pitch: float = 0.0) -> HullState:
    """At rest with its centre of gravity at a place, m, its height above the bed; pitch in rad."""
    axes = np.empty((3, 3))
    rotate_axes((0.0, pitch, 0.0), np.eye(3), axes)
    return HullState(
        q=np.array(place, dtype=float),
        axes=axes,
        turn=np.zeros(3),
        v=np.zeros(6),
        a=np.zeros(6),
        force=np.zeros(6),
        parts=np.zeros((PARTS, 6)),
        memory=np.zeros((hull.mode.shape[0], 2)),
        wet=np.zeros(1),
        line=np.zeros(6),
    )


def room_of(hull: Hull) -> HullRoom:
    """Work space of a hull."""
    slices, modes = hull.foot.size, hull.mode.shape[0]
    return HullRoom(
        points=np.zeros((slices, 3)),
        velocity=np.zeros((slices, 3)),
        acceleration=np.zeros((slices, 3)),
        surface=np.zeros(slices),
        sea=np.zeros(9),
        ends=water_ends(slices),
        sea_ends=np.zeros((2, 9)),
        carried=np.zeros((modes, 2)),
        by_speed=np.zeros((modes, 2)),
        matrix=np.zeros((6, 6)),
        rest=np.zeros(6),
        by_v=np.zeros((6, 6)),
    )


def record_of(samples: int) -> HullRecord:
    """Room for so many samples."""
    return HullRecord(
        q=np.zeros((samples, 6)),
        v=np.zeros((samples, 6)),
        wet=np.zeros(samples),
        surface=np.zeros(samples),
        line=np.zeros((samples, 6)),
        extreme=np.array([[np.inf, -np.inf]] * 7),
        works=np.zeros(PARTS + 2),
    )
