"""Reads what drives lines: motion, force, surface and current over time, answers of ships."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from catopt.arrays import Array
from catopt.errors import InputError, Problem, refused
from catopt.fem.series import Harmonic, Sampled
from catopt.hydro.coefficient_files import wamit_rows
from catopt.hydro.coefficients import FREEDOMS, Coefficients
from catopt.tables import Column, few, read_numbers, read_sheet
from catopt.units import Dimension
from catopt.waves import CurrentSeries, ElevationRecord, Waves
from catopt.words import Message, given_keys

if TYPE_CHECKING:
    from catopt.model import Motion

_WAYS, _TURNS = FREEDOMS[:3], FREEDOMS[3:]
_TIME, _ANGLE = Column(Dimension.TIME), Column(Dimension.ANGLE)
_PLACE = {
    "t": Column(Dimension.TIME, bare=1.0),
    **dict.fromkeys("xyz", Column(Dimension.LENGTH, bare=1.0)),
}
_FORCE = {"t": _TIME, **dict.fromkeys(("fx", "fy", "fz"), Column(Dimension.FORCE))}
_ELEVATION = {"time": _TIME, "elevation": Column(Dimension.LENGTH)}
_CURRENT = {"time": _TIME, "speed": Column(Dimension.SPEED), "direction": _ANGLE}
_MOST_TURNS = 1e4
"""Largest phase, rad: one that is not brought back into a turn may have many."""
_PER_METRE = {"m/m": 1.0, "ft/ft": 1.0, "-": 1.0}


@dataclass(frozen=True)
class OfTotal(Column):
    """A column of parts of a total, which its heading has: ``occurrences (of 1000)``."""

    def size(self, unit: str) -> float:
        """One of the total; nan where there is none."""
        of, _, total = unit.partition(" ")
        if of == "of" and total.isascii() and total.isdecimal() and int(total) > 0:
            return 1.0 / int(total)
        return math.nan

    @property
    def wanted(self) -> Message:
        """Say how the total is given."""
        return Message("refused_motion.total_part_wanted_brackets_1000")


@dataclass(frozen=True, eq=False)
class Raos:
    """Response amplitude operators of the fairlead itself, by the waves' frequency.

    `omega` (n,): angular frequency, rad/s, rising; `response` (n, 3): along x, y and z in m to a
    wave of 1 m: size, and phase by which it lags behind the crest over the fairlead.
    """

    omega: Array
    response: npt.NDArray[np.complex128]

    def motion(self, waves: Waves, wave_numbers: Array, x: float, y: float = 0.0) -> Harmonic:
        """Answer to waves, each as a harmonic motion a cos(omega t + phase).

        `waves`: with eta = a cos(k x cos b + k y sin b - omega t + phi); `wave_numbers` (waves,):
        k, rad/m; `x`, `y`: of the place over which the crest counts, at rest, m. Between its
        frequencies the response is interpolated as a complex number; beyond the first and the last
        it is held.
        """
        parts = [np.interp(waves.omega, self.omega, self.response[:, k].real) for k in range(3)]
        other = [np.interp(waves.omega, self.omega, self.response[:, k].imag) for k in range(3)]
        answer = np.array(parts).T + 1j * np.array(other).T
        ahead = x * np.cos(waves.direction) + y * np.sin(waves.direction)
        there = wave_numbers * ahead + waves.phase
        # The crest over that place is at omega t = there; the answer comes by its phase later.
        return Harmonic(
            tuple(2.0 * math.pi / waves.omega),
            waves.amplitude[:, np.newaxis] * np.abs(answer),
            -there[:, np.newaxis] - np.angle(answer),
        )


_LEFT_OUT = 0.01
"""Part of the waves' energy beyond a table from which it is remarked on."""


def energy_beyond(omega: Array, waves: Waves) -> float:
    """Part of the waves' energy beyond the frequencies of a table, `omega`, rad/s, rising.

    0 where it is too little to be remarked on.
    """
    energy = waves.amplitude**2
    outside = (waves.omega < omega[0]) | (waves.omega > omega[-1])
    part = float(energy[outside].sum() / energy.sum())
    return part if part > _LEFT_OUT else 0.0


def read_motion(path: str, duration: float) -> Sampled:
    """Read a motion over time; its first row is the start of the run.

    `path`: CSV with a row of headings: ``t``, and any of ``x``, ``y``, ``z``; s and m, or in the
    unit that a heading has in brackets: ``x (cm)``; `duration`: of the run, s; the record may not
    end before it. Raises InputError for a file that cannot be read, wrong headings or cells, times
    that do not rise, a gap, or a record that is too short.
    """
    return _sampled(path, _PLACE, duration)


def read_force(path: str, duration: float) -> Sampled:
    """Read the force on a body over time, without its mean; its first row is the start of the run.

    `path`: CSV with a row of headings: ``t (s)``, and any of ``Fx``, ``Fy``, ``Fz`` with the unit
    of a force; else as `read_motion`.
    """
    return _sampled(path, _FORCE, duration)


def _sampled(path: str, known: Mapping[str, Column], duration: float) -> Sampled:
    key, *axes = known
    columns = read_columns(path, known, needed=(key,), some_of=axes)
    t = columns[key]
    values = np.column_stack([columns.get(axis, np.zeros(t.size)) for axis in axes])
    with _record_of(path, key, t, duration):
        return Sampled(t - t[0], values)


def read_elevation(path: str, duration: float) -> ElevationRecord:
    """Read a recorded surface; its first row is the start of the run.

    `path`: CSV with a row of headings, ``time (s)`` and ``elevation (m)``, or in other units; else
    as `read_motion`.
    """
    columns = read_columns(path, _ELEVATION, needed=tuple(_ELEVATION))
    with _record_of(path, "time", columns["time"], duration):
        return ElevationRecord(columns["time"], columns["elevation"])


def read_current(path: str, duration: float) -> CurrentSeries:
    """Read the current at the surface over time; its first row is the start of the run.

    `path`: CSV with a row of headings, ``time (min)``, ``speed (m/s)`` and, where it turns,
    ``direction (deg)``, or in other units; else as `read_motion`, and gaps are no matter.
    """
    columns = read_columns(path, _CURRENT, needed=("time", "speed"))
    t = columns["time"]
    with _record_of(path, "time", t, duration):
        return CurrentSeries(t - t[0], columns["speed"], columns.get("direction"))


@contextmanager
def _record_of(path: str, key: str, times: Array, duration: float) -> Iterator[None]:
    """Make a record in the body; refuse what is wrong in it, or that it ends before its run, s."""
    try:
        yield
    except InputError as error:
        raise InputError(error.problems, path) from None
    length = float(times[-1] - times[0])
    if length < duration * (1.0 - 1e-9):
        wanted = Message("refused_motion.run_is_longer", duration=duration)
        found = Message("refused_motion.s_from_first_row_last", length=length)
        raise refused(key, found, wanted, path)


def read_raos(path: str) -> Raos:
    """Read a ship's response at the fairlead.

    `path`: CSV with a row of headings: ``period`` (s), any of ``surge``, ``sway``, ``heave`` (m in
    a wave of 1 m), and ``surge_phase`` and so on (deg behind the crest over the fairlead); a unit
    in brackets goes before that one. Raises
    InputError for a file that cannot be read, wrong headings or cells, or a period twice.
    """
    phases = tuple(f"{each}_phase" for each in _WAYS)
    known = {
        "period": Column(Dimension.TIME, bare=1.0),
        **dict.fromkeys(_WAYS, Column(units=_PER_METRE, bare=1.0)),
        **dict.fromkeys(phases, Column(Dimension.ANGLE, bare=math.radians(1.0), most=_MOST_TURNS)),
    }
    columns = read_columns(path, known, needed=("period",), some_of=_WAYS)
    period = columns["period"]
    if not (period > 0.0).all():
        raise refused("period", f"{period.min():g} s", Message("refused_motion.above_0_s"), path)
    order = np.argsort(period)[::-1]
    if (np.diff(period[order]) == 0.0).any():
        wanted = Message("refused_motion.one_row_period")
        raise refused("period", Message("refused_motion.same_twice"), wanted, path)
    response = responses(columns, _WAYS, period.size)
    return Raos(2.0 * math.pi / period[order], response[order])


def responses(
    columns: Mapping[str, Array], motions: Sequence[str], rows: int, lag: float = 1.0
) -> npt.NDArray[np.complex128]:
    """Put sizes and phases of motions together, shape (rows, motions); none where none is given.

    `lag`: 1 where phases count behind the crest, -1 where they count before it.
    """
    zero = np.zeros(rows)
    parts = [
        columns.get(each, zero) * np.exp(1j * lag * columns.get(f"{each}_phase", zero))
        for each in motions
    ]
    return np.column_stack(parts).astype(np.complex128)


def read_columns(
    path: str, known: Mapping[str, Column], *, needed: Sequence[str], some_of: Sequence[str] = ()
) -> dict[str, Array]:
    """Read the columns of a file of numbers as arrays in SI; as `catopt.tables.read_numbers`."""
    sheet = read_sheet(Path(path), path, keeps_broken=True)
    columns = read_numbers(sheet, known, needed=needed, some_of=some_of)
    return {key: np.array(values) for key, values in columns.items()}


_SAME = 1e-9


@dataclass(frozen=True, eq=False)
class VesselRaos:
    """Response amplitude operators of a ship, by heading and frequency.

    `heading` (h,): where the waves travel to, counter-clockwise from the ship's x axis, rad,
    rising; `omega` (n,): angular frequency, rad/s, rising; `response` (h, n, 6): surge, sway, heave
    in m and roll, pitch, yaw in rad, right-handed with z upwards, to a wave of 1 m amplitude: size,
    and phase by which it lags behind the crest; `reference`: the point that moves so: along the
    ship's x and y from the body's origin, and above the seabed, m; `crest`: the point over which
    that crest is, along the ship's x and y from the body's origin, m; `path`: of its file, for
    messages.
    """

    heading: Array
    omega: Array
    response: npt.NDArray[np.complex128]
    reference: tuple[float, ...]
    crest: tuple[float, ...]
    path: str = ""

    def of_point(self, heading: float, point: tuple[float, float, float]) -> Raos:
        """Response of a point of the ship, along the ship's axes; rotations are small.

        `heading`: where the waves travel to, counter-clockwise from the ship's x axis, rad;
        `point`: along the ship's x and y from the body's origin, and above the seabed, m. Raises
        InputError when the table has nothing around that heading.
        """
        given = self.coefficients.at("response", self.omega, np.full(self.omega.size, heading))
        x, y, z = (a - b for a, b in zip(point, self.reference, strict=True))
        roll, pitch, yaw = given[:, 3], given[:, 4], given[:, 5]
        turned = np.column_stack([pitch * z - yaw * y, yaw * x - roll * z, roll * y - pitch * x])
        return Raos(self.omega, given[:, :3] + turned)

    @property
    def coefficients(self) -> Coefficients:
        """The same as coefficients."""
        answers = self.response.transpose(1, 0, 2)
        return Coefficients(self.omega, self.heading, response=answers, source=self.path)


def read_vessel_raos(motion: Motion) -> VesselRaos:
    """Read a ship's response in six degrees of freedom.

    `motion`: with the path of WAMIT's .4 file (`read_wamit`), or of a CSV file, and its
    conventions. Columns of the latter, with their units:
    ``heading``, ``period`` or ``frequency``, any of ``surge``, ``sway``, ``heave``, ``roll``,
    ``pitch`` and ``yaw``, and ``surge_phase`` and so on. Raises InputError for a file that cannot
    be read, wrong headings or cells, or headings that do not all have the same periods, each once.
    """
    path = motion.rao_file
    if Path(path).suffix == ".4":
        columns = read_wamit(motion)
    else:
        turn = math.radians(1.0) if motion.rao_rotation.startswith("deg") else 1.0
        phases = [f"{each}_phase" for each in FREEDOMS]
        units = {
            "heading": _ANGLE,
            "period": _TIME,
            "frequency": Column(units={"rad/s": 1.0, "Hz": 2.0 * math.pi}),
            **dict.fromkeys(_WAYS, Column(units=_PER_METRE)),
            **dict.fromkeys(_TURNS, Column(units={motion.rao_rotation: turn})),
            **dict.fromkeys(phases, Column(Dimension.ANGLE, most=_MOST_TURNS)),
        }
        columns = read_columns(path, units, needed=("heading",), some_of=FREEDOMS)
    omega = _frequencies(path, columns)
    lag = 1.0 if motion.rao_phase == "lag" else -1.0
    to_amplitude = 1.0 if motion.rao_per == "amplitude" else 2.0
    response = to_amplitude * responses(columns, FREEDOMS, omega.size, lag)
    headings, of = np.unique(columns["heading"], return_inverse=True)
    rows = []
    for k in range(headings.size):
        (at,) = np.nonzero(of == k)
        rows.append(at[np.argsort(omega[at])])
    frequencies = [omega[at] for at in rows]
    if any((np.diff(each) == 0.0).any() for each in frequencies):
        wanted = Message("refused_motion.one_row_heading_period")
        raise refused("period", Message("refused_motion.same_twice"), wanted, path)
    if any(not np.array_equal(each, frequencies[0]) for each in frequencies):
        wanted = Message("refused_motion.every_heading_same")
        raise refused("period", Message("refused_motion.others_some_heading"), wanted, path)
    if headings[-1] - headings[0] > 2.0 * math.pi * (1.0 + _SAME):
        wanted = Message("refused_motion.full_turn_at_most")
        raise refused("heading", Message("refused_motion.more_than_full_turn"), wanted, path)
    laid = np.array([response[at] for at in rows], dtype=np.complex128)
    reference = motion.rao_reference
    crest = motion.rao_crest or reference[:2]
    return VesselRaos(headings, frequencies[0], laid, reference, crest, path)


def _frequencies(path: str, columns: dict[str, Array]) -> Array:
    """Angular frequency of each row, rad/s, by its period or its frequency."""
    given = [key for key in ("period", "frequency") if key in columns]
    if len(given) != 1:
        wanted = Message("refused_motion.one_period_frequency_wanted")
        raise refused("headings", given_keys(given), wanted, path)
    values = columns[given[0]]
    if not (values > 0.0).all():
        raise refused(given[0], f"{values.min():g}", Message("refused.above", bound=0), path)
    return 2.0 * math.pi / values if given[0] == "period" else values


# ------------------------------------------------------------------ WAMIT's .4 file


def read_wamit(motion: Motion) -> dict[str, Array]:
    """Read the columns that a table of RAOs has: heading and period, sizes and phases (rad).

    Rows have PER (s), BETA (deg, where the waves go), I, MOD, PHS (deg), RE and IM; a first line of
    words is passed over. Rotations are in rad for a wave of 1 m: of a file whose ULEN is 1, for
    another one sources disagree whether to multiply or divide by it. Which way phases count is
    what `motion` says. Raises InputError for a file that cannot be read, lines that are wrong, a
    row that is missing or there twice, or conventions that no such file has.
    """
    path = motion.rao_file
    _check_conventions(motion)
    wrong: list[Problem] = []
    rows = wamit_rows(Path(path), ".4", wrong)[:, :5].tolist()
    if wrong:
        raise InputError(wrong, path)
    states = list(dict.fromkeys((per, beta) for per, beta, *_ in rows))
    place = {state: k for k, state in enumerate(states)}
    size, phase = np.full((2, len(states), 6), np.nan)
    problems = []
    for per, beta, freedom, mod, phs in rows:
        at = place[per, beta], int(freedom) - 1
        if not math.isnan(size[at]):
            state = f"PER {per:g}, BETA {beta:g}, I {freedom:g}"
            problems.append(
                Problem(
                    state,
                    Message("refused_study.twice"),
                    Message("refused_motion.one_row_each_wanted"),
                )
            )
        size[at], phase[at] = mod, math.radians(phs)
    known = ~np.isnan(size).all(axis=0)  # of a ship with fewer freedoms, the others are still
    for (per, beta), k in place.items():
        for freedom in np.flatnonzero(np.isnan(size[k]) & known).tolist():
            state = f"PER {per:g}, BETA {beta:g}, I {freedom + 1}"
            wanted = Message("refused_motion.missing_there_at_other_periods")
            problems.append(Problem(state, "", wanted))
    if problems:
        raise InputError(few(problems), path)
    columns = {
        "period": np.array([per for per, _ in states]),
        "heading": np.radians([beta for _, beta in states]),
    }
    for k in np.flatnonzero(known).tolist():
        columns |= {FREEDOMS[k]: size[:, k], f"{FREEDOMS[k]}_phase": phase[:, k]}
    return columns


def _check_conventions(motion: Motion) -> None:
    problems = []
    if motion.rao_rotation != "rad/m":
        allowed = Message("refused_motion.n_4_file_with_ulen_1")
        problems.append(Problem("motion.rao_rotation", f'"{motion.rao_rotation}"', allowed))
    if motion.rao_per != "amplitude":
        allowed = Message("refused_motion.n_4_file_wave_1_m")
        problems.append(Problem("motion.rao_per", f'"{motion.rao_per}"', allowed))
    if not motion.rao_crest:
        allowed = Message("refused_motion.missing_phases_4_file_count")
        problems.append(Problem("motion.rao_crest", "", allowed))
    if problems:
        raise InputError(problems, motion.rao_file)
