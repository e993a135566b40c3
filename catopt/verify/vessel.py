"""How a ship answers to waves in six degrees of freedom, and what that is at a fairlead."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from catopt.errors import InputError, Problem
from catopt.verify.motion_file import Raos, read_columns, refused
from catopt.verify.wamit_file import FREEDOMS, is_wamit, read_wamit

if TYPE_CHECKING:
    from catopt.model import Motion

Array = npt.NDArray[np.float64]

_WAYS, _TURNS = FREEDOMS[:3], FREEDOMS[3:]
_ANGLES = {"deg": math.pi / 180.0, "rad": 1.0}
_SAME = 1e-9


@dataclass(frozen=True, eq=False)
class VesselRaos:
    """Response amplitude operators of a ship, by heading and frequency.

    Attributes
    ----------
    heading : ndarray, shape (h,)
        Where the waves travel to, counter-clockwise from the ship's x axis, rad, rising.
    omega : ndarray, shape (n,)
        Angular frequency, rad/s, rising.
    response : ndarray of complex, shape (h, n, 6)
        Surge, sway, heave in m and roll, pitch, yaw in rad, right-handed with z upwards, to a wave
        of 1 m amplitude: size, and phase by which it lags behind the crest.
    reference : tuple of float
        The point that moves so: along the ship's x and y from the body's origin, and above the
        seabed, m.
    crest : tuple of float
        The point over which that crest is, along the ship's x and y from the body's origin, m.
    path : str
        Of its file, for messages.
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

    def _at(self, heading: float) -> npt.NDArray[np.complex128]:
        """Response in a heading, as a complex number in proportion between two of the table."""
        first, last = float(self.heading[0]), float(self.heading[-1])
        wanted = first + (heading - first + _SAME) % (2.0 * math.pi) - _SAME
        if wanted > last + _SAME:
            found = f"waves travel to {math.degrees(wanted) % 360.0:.4g} deg from the ship's x axis"
            rows = f"{math.degrees(first):.4g} to {math.degrees(last):.4g} deg"
            raise refused(self.path, "heading", found, f"the file has {rows}; give rows around it")
        above = min(int(np.searchsorted(self.heading, wanted)), self.heading.size - 1)
        below = max(above - 1, 0)
        gap = float(self.heading[above] - self.heading[below])
        part = (wanted - float(self.heading[below])) / gap if gap > 0.0 else 0.0
        lower, upper = self.response[below], self.response[above]
        mixed: npt.NDArray[np.complex128] = lower + part * (upper - lower)
        return mixed


def read_vessel_raos(motion: Motion) -> VesselRaos:
    """Read a ship's response in six degrees of freedom.

    `motion`: with the path of WAMIT's .4 file (`read_wamit`), or of a CSV file, and its
    conventions. Columns of the latter, with their units:
    ``heading``, ``period`` or ``frequency``, any of ``surge``, ``sway``, ``heave``, ``roll``,
    ``pitch`` and ``yaw``, and ``surge_phase`` and so on. Raises InputError for a file that cannot
    be read, wrong headings or cells, or headings that do not all have the same periods, each once.
    """
    path, motions = motion.rao_file, FREEDOMS
    phases = tuple(f"{each}_phase" for each in motions)
    units = {
        "heading": _ANGLES, "period": {"s": 1.0}, "frequency": {"rad/s": 1.0, "Hz": 2.0 * math.pi},
        **{each: {"m/m": 1.0} for each in _WAYS},
        **{each: {motion.rao_rotation: _ANGLES[motion.rao_rotation[:3]]} for each in _TURNS},
        **dict.fromkeys(phases, _ANGLES),
    }  # fmt: skip
    if is_wamit(path):
        columns = read_wamit(motion)
    else:
        columns = read_columns(
            path, needed=("heading",), known=tuple(units), some_of=motions, units=units
        )
    omega = _frequencies(path, columns)
    zero = np.zeros(omega.size)
    sign = 1.0 if motion.rao_phase == "lag" else -1.0
    to_amplitude = 1.0 if motion.rao_per == "amplitude" else 2.0
    response = np.column_stack(
        [
            to_amplitude * columns.get(each, zero) * np.exp(1j * sign * columns.get(phase, zero))
            for each, phase in zip(motions, phases, strict=True)
        ]
    )
    headings, of = np.unique(columns["heading"], return_inverse=True)
    rows = []
    for k in range(headings.size):
        (at,) = np.nonzero(of == k)
        rows.append(at[np.argsort(omega[at])])
    frequencies = [omega[at] for at in rows]
    if any((np.diff(each) == 0.0).any() for each in frequencies):
        raise refused(path, "period", "the same twice", "one row a heading and period is wanted")
    if any(not np.array_equal(each, frequencies[0]) for each in frequencies):
        raise refused(path, "period", "others in some heading", "every heading has the same ones")
    if headings[-1] - headings[0] > 2.0 * math.pi * (1.0 + _SAME):
        raise refused(path, "heading", "more than a full turn", "360 deg at most are wanted")
    laid = np.array([response[at] for at in rows], dtype=np.complex128)
    reference = motion.rao_reference
    crest = motion.rao_crest or reference[:2]
    return VesselRaos(headings, frequencies[0], laid, reference, crest, path)


def _frequencies(path: str, columns: dict[str, Array]) -> Array:
    """Angular frequency of each row, rad/s, by its period or its frequency."""
    given = [key for key in ("period", "frequency") if key in columns]
    if len(given) != 1:
        wanted = "one of period and frequency is wanted"
        raise InputError([Problem("headings", " and ".join(given), wanted)], path)
    values = columns[given[0]]
    if not (values > 0.0).all():
        raise refused(path, given[0], f"{values.min():g}", "must be above 0")
    return 2.0 * math.pi / values if given[0] == "period" else values
