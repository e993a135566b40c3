"""Reads a ship's response in six degrees of freedom from WAMIT's .4 file."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Final

import numpy as np
import numpy.typing as npt

from catopt.documents import MOST_BYTES_OF_DATA, read_text
from catopt.errors import InputError, Problem
from catopt.units import as_written

if TYPE_CHECKING:
    from catopt.model import Motion

Array = npt.NDArray[np.float64]

FREEDOMS: Final = ("surge", "sway", "heave", "roll", "pitch", "yaw")

_COLUMNS: Final = ("PER", "BETA", "I", "MOD", "PHS", "RE", "IM")
_SHOWN: Final = 10
"""Faulty lines that are told of one file."""
_ALIKE: Final = 2e-3
"""Part of MOD by which RE and IM may miss MOD and PHS: three printed digits."""


def is_wamit(path: str) -> bool:
    """Whether a path is of such a file."""
    return Path(path).suffix == ".4"


def read_wamit(motion: Motion) -> dict[str, Array]:
    """Read the columns that a table of RAOs has: heading and period, sizes and phases (rad).

    Rows have PER (s), BETA (deg, where the waves go), I, MOD, PHS (deg), RE and IM; a first line of
    words is passed over. Rotations are in rad for a wave of 1 m: of a file whose ULEN is 1, for
    another one sources disagree whether to multiply or divide by it. Which way phases count is
    what `motion` says.

    Raises
    ------
    InputError
        For a file that cannot be read, lines that are wrong, a row that is missing or there twice,
        or conventions that no such file has.
    """
    path = motion.rao_file
    _check_conventions(motion)
    rows = list(_rows(path))
    states = list(dict.fromkeys((per, beta) for per, beta, *_ in rows))
    place = {state: k for k, state in enumerate(states)}
    size, phase = np.full((2, len(states), 6), np.nan)
    problems = []
    for per, beta, freedom, mod, phs in rows:
        at = place[per, beta], int(freedom) - 1
        if not math.isnan(size[at]):
            state = f"PER {per:g}, BETA {beta:g}, I {freedom:g}"
            problems.append(Problem(state, "twice", "one row for each is wanted"))
        size[at], phase[at] = mod, math.radians(phs)
    known = ~np.isnan(size).all(axis=0)  # of a ship with fewer freedoms, the others are still
    for (per, beta), k in place.items():
        for freedom in np.flatnonzero(np.isnan(size[k]) & known).tolist():
            found = f"PER {per:g}, BETA {beta:g}, I {freedom + 1}"
            problems.append(Problem(found, "", "is missing, and there at other periods"))
    if problems:
        raise InputError(problems[:_SHOWN], path)
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
        allowed = 'a .4 file with ULEN 1 has "rad/m"; run WAMIT with ULEN 1, or give a CSV file'
        problems.append(Problem("motion.rao_rotation", f'"{motion.rao_rotation}"', allowed))
    if motion.rao_per != "amplitude":
        allowed = 'a .4 file is for a wave of 1 m "amplitude"'
        problems.append(Problem("motion.rao_per", f'"{motion.rao_per}"', allowed))
    if not motion.rao_crest:
        allowed = (
            "missing; phases of a .4 file count from the crest over the origin of WAMIT's global "
            'axes: ["0 m", "0 m"] where that is above the body\'s origin'
        )
        problems.append(Problem("motion.rao_crest", "", allowed))
    if problems:
        raise InputError(problems, motion.rao_file)


_Row = tuple[float, float, float, float, float]


def _rows(path: str) -> Iterator[_Row]:
    text = read_text(Path(path), path, kind="table of numbers", most=MOST_BYTES_OF_DATA)
    problems: list[Problem] = []
    found: list[_Row] = []
    for number, line in enumerate(text.splitlines(), start=1):
        if not line.strip():
            continue
        try:
            found.append(_row(line))
        except ValueError as error:
            if number > 1 or any(cell[:1].isdigit() for cell in line.split()):
                problems.append(Problem(f"line {number}", as_written(line.strip()), str(error)))
    if not problems and not found:
        problems.append(Problem("rows", "none", f"rows of {' '.join(_COLUMNS)} are wanted"))
    if problems:
        more = len(problems) - _SHOWN
        rest = [Problem("file", "", f"{more} more of the kind")] if more > 0 else []
        raise InputError([*problems[:_SHOWN], *rest], path)
    return iter(found)


def _row(line: str) -> _Row:
    """Read a row; ValueError says what is wrong with it."""
    cells = line.replace("D", "E").replace("d", "e").split()
    if len(cells) != len(_COLUMNS):
        raise ValueError(f"{len(_COLUMNS)} numbers are wanted: {' '.join(_COLUMNS)}")
    try:
        per, beta, freedom, mod, phs, re, im = map(float, cells)
    except ValueError:
        raise ValueError("numbers are wanted") from None
    if not all(map(math.isfinite, (per, beta, freedom, mod, phs, re, im))):
        raise ValueError("finite numbers are wanted")
    if not per > 0.0:
        raise ValueError("PER must be above 0 s: take the rows of zero and infinite frequency out")
    if freedom not in range(1, 7):
        raise ValueError("I must be 1 to 6: one body, no generalised modes")
    angle = math.radians(phs)
    off = math.hypot(re - mod * math.cos(angle), im - mod * math.sin(angle))
    if off > _ALIKE * max(mod, math.hypot(re, im)):
        raise ValueError("RE and IM are not those of MOD and PHS: this is another kind of file")
    return per, beta, freedom, mod, phs
