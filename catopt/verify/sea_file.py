"""Reads the sea from CSV files: a recorded surface, and a current over time."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
import numpy.typing as npt

from catopt.errors import InputError
from catopt.units import UNITS, Dimension
from catopt.verify.motion_file import read_columns, too_short
from catopt.waves import CurrentSeries, ElevationRecord

_SURFACE = {"time": UNITS[Dimension.TIME], "elevation": UNITS[Dimension.LENGTH]}
_CURRENT = {
    "time": UNITS[Dimension.TIME],
    "speed": UNITS[Dimension.SPEED],
    "direction": UNITS[Dimension.ANGLE],
}


def read_elevation(path: str, duration: float) -> ElevationRecord:
    """Read a recorded surface; its first row is the start of the run.

    `path`: CSV with a row of headings, ``time (s)`` and ``elevation (m)``, or in other units;
    `duration`: of the run, s; the record may not end before it. Raises InputError for a file that
    cannot be read, wrong headings or cells, times that do not rise, a gap, or a record that is too
    short.
    """
    columns = _columns(path, _SURFACE, needed=("time", "elevation"))
    try:
        record = ElevationRecord(columns["time"], columns["elevation"])
    except InputError as error:
        raise InputError(error.problems, path) from None
    if record.duration < duration * (1.0 - 1e-9):
        raise too_short(path, "time", record.duration, duration)
    return record


def read_current(path: str, duration: float) -> CurrentSeries:
    """Read the current at the surface over time; its first row is the start of the run.

    `path`: CSV with a row of headings, ``time (min)``, ``speed (m/s)`` and, where it turns,
    ``direction (deg)``, or in other units; `duration`: of the run, s; the series may not end before
    it. Raises InputError for a file that cannot be read, wrong headings or cells, times that do not
    rise, or a series that is too short.
    """
    columns = _columns(path, _CURRENT, needed=("time", "speed"))
    t = columns["time"] - columns["time"][0]
    try:
        series = CurrentSeries(t, columns["speed"], columns.get("direction"))
    except InputError as error:
        raise InputError(error.problems, path) from None
    if t[-1] < duration * (1.0 - 1e-9):
        raise too_short(path, "time", float(t[-1]), duration)
    return series


def _columns(
    path: str, units: Mapping[str, Mapping[str, float]], *, needed: Sequence[str]
) -> dict[str, npt.NDArray[np.float64]]:
    return read_columns(path, needed=needed, known=tuple(units), some_of=needed, units=units)
