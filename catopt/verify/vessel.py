"""How a ship answers to waves in six degrees of freedom, by WAMIT's .4 file or a CSV file."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from catopt.arrays import Array
from catopt.errors import InputError, Problem
from catopt.hydro.coefficient_files import wamit_rows
from catopt.hydro.coefficients import FREEDOMS, Coefficients, Complex
from catopt.verify.motion_file import SHOWN, Raos, read_columns, refused, responses
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.model import Motion

_WAYS, _TURNS = FREEDOMS[:3], FREEDOMS[3:]
_ANGLES = {"deg": math.pi / 180.0, "rad": 1.0}
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
        given = self._at(heading)
        x, y, z = (a - b for a, b in zip(point, self.reference, strict=True))
        roll, pitch, yaw = given[:, 3], given[:, 4], given[:, 5]
        turned = np.column_stack([pitch * z - yaw * y, yaw * x - roll * z, roll * y - pitch * x])
        return Raos(self.omega, given[:, :3] + turned)

    @property
    def coefficients(self) -> Coefficients:
        """The same as coefficients."""
        answers = self.response.transpose(1, 0, 2)
        return Coefficients(self.omega, self.heading, response=answers, source=self.path)

    def _at(self, heading: float) -> Complex:
        """Response in a heading, as a complex number in proportion between two of the table."""
        wanted = np.full(self.omega.size, heading)
        return self.coefficients.at("response", self.omega, wanted)


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
        units = {
            "heading": _ANGLES,
            "period": {"s": 1.0},
            "frequency": {"rad/s": 1.0, "Hz": 2.0 * math.pi},
            **{each: {"m/m": 1.0} for each in _WAYS},
            **{each: {motion.rao_rotation: _ANGLES[motion.rao_rotation[:3]]} for each in _TURNS},
            **{f"{each}_phase": _ANGLES for each in FREEDOMS},
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
        raise refused(
            path,
            "period",
            Message("refused_motion.same_twice"),
            Message("refused_motion.one_row_heading_period"),
        )
    if any(not np.array_equal(each, frequencies[0]) for each in frequencies):
        raise refused(
            path,
            "period",
            Message("refused_motion.others_some_heading"),
            Message("refused_motion.every_heading_same"),
        )
    if headings[-1] - headings[0] > 2.0 * math.pi * (1.0 + _SAME):
        raise refused(
            path,
            "heading",
            Message("refused_motion.more_than_full_turn"),
            Message("refused_motion.full_turn_at_most"),
        )
    laid = np.array([response[at] for at in rows], dtype=np.complex128)
    reference = motion.rao_reference
    crest = motion.rao_crest or reference[:2]
    return VesselRaos(headings, frequencies[0], laid, reference, crest, path)


def _frequencies(path: str, columns: dict[str, Array]) -> Array:
    """Angular frequency of each row, rad/s, by its period or its frequency."""
    given = [key for key in ("period", "frequency") if key in columns]
    if len(given) != 1:
        wanted = Message("refused_motion.one_period_frequency_wanted")
        raise InputError([Problem("headings", " and ".join(given), wanted)], path)
    values = columns[given[0]]
    if not (values > 0.0).all():
        raise refused(path, given[0], f"{values.min():g}", Message("refused.above", bound=0))
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
            problems.append(Problem(state, "twice", Message("refused_motion.one_row_each_wanted")))
        size[at], phase[at] = mod, math.radians(phs)
    known = ~np.isnan(size).all(axis=0)  # of a ship with fewer freedoms, the others are still
    for (per, beta), k in place.items():
        for freedom in np.flatnonzero(np.isnan(size[k]) & known).tolist():
            found = f"PER {per:g}, BETA {beta:g}, I {freedom + 1}"
            problems.append(
                Problem(found, "", Message("refused_motion.missing_there_at_other_periods"))
            )
    if problems:
        raise InputError(problems[:SHOWN], path)
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
