"""Reads how a fairlead moves from CSV files: a record over time, or a ship's response to waves."""

from __future__ import annotations

import csv
import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt

from catopt.errors import InputError, Problem
from catopt.fem.series import Harmonic, Sampled
from catopt.waves import Waves

__all__ = ["Raos", "read_motion", "read_raos"]

Array = npt.NDArray[np.float64]

_AXES = ("x", "y", "z")
_MOTIONS = ("surge", "sway", "heave")
_SHOWN = 10
"""Faulty cells that are told of one file."""


@dataclass(frozen=True, eq=False)
class Raos:
    """Response amplitude operators of the fairlead itself, by the waves' frequency.

    Attributes
    ----------
    omega : ndarray, shape (n,)
        Angular frequency, rad/s, rising.
    response : ndarray of complex, shape (n, 3)
        Along x, y and z in m to a wave of 1 m: size, and phase by which it lags behind the crest
        over the fairlead.
    """

    omega: Array
    response: npt.NDArray[np.complex128]

    def motion(self, waves: Waves, wave_numbers: Array, span: float) -> Harmonic:
        """Answer to waves, each as a harmonic motion a cos(omega t + phase).

        Parameters
        ----------
        waves : Waves
            With eta = a cos(k x cos b + k y sin b - omega t + phi).
        wave_numbers : ndarray, shape (waves,)
            k, rad/m.
        span : float
            Of the fairlead's place at rest from the origin, along x, m.

        Notes
        -----
        Between its frequencies the response is interpolated as a complex number; beyond the first
        and the last it is held.
        """
        parts = [np.interp(waves.omega, self.omega, self.response[:, k].real) for k in range(3)]
        other = [np.interp(waves.omega, self.omega, self.response[:, k].imag) for k in range(3)]
        answer = np.array(parts).T + 1j * np.array(other).T
        there = wave_numbers * span * np.cos(waves.direction) + waves.phase
        # The crest over the fairlead is at omega t = there; the answer comes by its phase later.
        return Harmonic(
            tuple(2.0 * math.pi / waves.omega),
            waves.amplitude[:, np.newaxis] * np.abs(answer),
            -there[:, np.newaxis] - np.angle(answer),
        )

    def energy_beyond(self, waves: Waves) -> float:
        """Part of the waves' energy at frequencies that the table does not have."""
        energy = waves.amplitude**2
        outside = (waves.omega < self.omega[0]) | (waves.omega > self.omega[-1])
        return float(energy[outside].sum() / energy.sum())


def read_motion(path: str, duration: float) -> Sampled:
    """Read a motion over time; its first row is the start of the run.

    Parameters
    ----------
    path : str
        CSV with a row of headings: ``t``, and any of ``x``, ``y``, ``z``; s and m.
    duration : float
        Of the run, s; the record may not end before it.

    Raises
    ------
    InputError
        For a file that cannot be read, wrong headings or cells, times that do not rise, a gap, or
        a record that is too short.
    """
    columns = _read(path, needed=("t",), known=("t", *_AXES), some_of=_AXES)
    t = columns["t"]
    zero = np.zeros(t.size)
    values = np.column_stack([columns.get(axis, zero) for axis in _AXES])
    try:
        sampled = Sampled(t - t[0], values)
    except InputError as error:
        raise InputError(error.problems, path) from None
    if t[-1] - t[0] < duration * (1.0 - 1e-9):
        wanted = f"the run of {duration:g} s is longer: shorten it, or give a longer record"
        raise _refused(path, "t", f"{t[-1] - t[0]:g} s from the first row to the last", wanted)
    return sampled


def read_raos(path: str) -> Raos:
    """Read a ship's response at the fairlead.

    Parameters
    ----------
    path : str
        CSV with a row of headings: ``period`` (s), any of ``surge``, ``sway``, ``heave`` (m in a
        wave of 1 m), and ``surge_phase`` and so on (deg behind the crest over the fairlead).

    Raises
    ------
    InputError
        For a file that cannot be read, wrong headings or cells, or a period twice.
    """
    phases = tuple(f"{each}_phase" for each in _MOTIONS)
    columns = _read(
        path, needed=("period",), known=("period", *_MOTIONS, *phases), some_of=_MOTIONS
    )
    period = columns["period"]
    if not (period > 0.0).all():
        raise _refused(path, "period", f"{period.min():g} s", "must be above 0 s")
    order = np.argsort(period)[::-1]
    if (np.diff(period[order]) == 0.0).any():
        raise _refused(path, "period", "the same twice", "one row a period is wanted")
    zero = np.zeros(period.size)
    response = np.column_stack(
        [
            columns.get(each, zero) * np.exp(1j * np.radians(columns.get(phase, zero)))
            for each, phase in zip(_MOTIONS, phases, strict=True)
        ]
    )
    return Raos(2.0 * math.pi / period[order], response[order].astype(np.complex128))


def _read(
    path: str, *, needed: Sequence[str], known: Sequence[str], some_of: Sequence[str]
) -> dict[str, Array]:
    """Read the columns of a file of numbers; every problem at once."""
    rows = _rows(path)
    if len(rows) < 2:
        raise _refused(path, "rows", f"{len(rows)}", "a row of headings and rows of numbers")
    heads = [cell.split("(")[0].strip().casefold() for cell in rows[0][1]]
    problems = [
        Problem("headings", each or "an empty one", f"one of {', '.join(known)} is wanted")
        for each in heads
        if each not in known
    ]
    problems += [
        Problem("headings", "", f"{each} is missing") for each in needed if each not in heads
    ]
    problems += [
        Problem("headings", each, "twice")
        for each in sorted({h for h in heads if heads.count(h) > 1})
    ]
    if not any(each in heads for each in some_of):
        problems.append(Problem("headings", "", f"one of {', '.join(some_of)} is missing"))
    if problems:
        raise InputError(problems, path)
    values = np.full((len(rows) - 1, len(heads)), np.nan)
    for at, (line, cells) in enumerate(rows[1:]):
        problems += _fill(values[at], line, cells, heads)
    if problems:
        more = len(problems) - _SHOWN
        shown = problems[:_SHOWN]
        if more > 0:
            shown.append(Problem("file", "", f"{more} more of the kind"))
        raise InputError(shown, path)
    return {head: values[:, column] for column, head in enumerate(heads)}


def _fill(row: Array, line: int, cells: list[str], heads: list[str]) -> list[Problem]:
    if len(cells) != len(heads):
        return [Problem(f"line {line}", f"{len(cells)} cells", f"{len(heads)} are wanted")]
    problems = []
    for column, cell in enumerate(cells):
        try:
            row[column] = float(cell)
        except ValueError:
            row[column] = math.nan
        if not math.isfinite(row[column]):
            found = cell.strip() or "an empty cell"
            problems.append(Problem(f"line {line}, {heads[column]}", found, "a number is wanted"))
    return problems


def _rows(path: str) -> list[tuple[int, list[str]]]:
    """Rows with their line numbers, without empty lines and comments."""
    try:
        text = Path(path).read_text(encoding="utf-8-sig")
    except FileNotFoundError:
        raise _refused(path, "file", "", "there is no such file") from None
    except (OSError, UnicodeDecodeError, ValueError) as error:
        reason = getattr(error, "strerror", None) or "it is no text in UTF-8"
        raise _refused(path, "file", "", f"it cannot be read: {reason}") from None
    lines = text.splitlines()
    return [
        (number, next(csv.reader([line])))
        for number, line in enumerate(lines, start=1)
        if line.strip() and not line.lstrip().startswith("#")
    ]


def _refused(path: str, key: str, found: str, allowed: str) -> InputError:
    return InputError([Problem(key, found, allowed)], path)
