"""Reads coefficients of floating bodies as WAMIT and capytaine write them."""

from __future__ import annotations

import math
import os
import struct
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, Final

import numpy as np

from catopt.arrays import Array
from catopt.documents import MOST_BYTES_OF_DATA, read_text
from catopt.errors import InputError, Problem, need_package, refused
from catopt.hydro.coefficients import FREEDOMS, Coefficients, Complex
from catopt.model.kinds import Findings
from catopt.units import as_written
from catopt.words import Message

WAMIT: Final = {
    ".1": ("PER", "I", "J", "A", "B"),
    ".2": ("PER", "BETA", "I", "MOD", "PHS", "RE", "IM"),
    ".3": ("PER", "BETA", "I", "MOD", "PHS", "RE", "IM"),
    ".4": ("PER", "BETA", "I", "MOD", "PHS", "RE", "IM"),
    ".8": ("PER", "BETA1", "BETA2", "I", "MOD", "PHS", "RE", "IM"),
    ".hst": ("I", "J", "C"),
}
"""Columns of the files that are read, by their endings."""
SHOWN: Final = 10
"""Faulty lines that are told of one file."""
_DAMAGED: Final = (
    *(OSError, ValueError, ImportError, TypeError, LookupError, AttributeError, AssertionError),
    *(EOFError, MemoryError, ArithmeticError, RuntimeError, struct.error),
)
"""What the readers of netCDF raise for a damaged file."""
_MOST: Final = 1e30
"""Size beyond which a number of a file is none."""
_ALIKE: Final = 2e-3
"""Part of MOD by which RE and IM may miss MOD and PHS: three printed digits."""
_TURN: Final = np.repeat([0, 1], 3)
"""By which power of the length a freedom counts beyond a translation."""


def read_wamit(
    path: str | os.PathLike[str], *, ulen: float, density: float, gravity: float
) -> Coefficients:
    """Read WAMIT's files of one body: ``.1``, ``.3`` or ``.2``, ``.4``, ``.8`` and ``.hst``.

    PER are periods in s (IPEROUT = 1): below 0 stands for zero frequency, 0 for the infinite one.
    Phases lead, as WAMIT has them with exp(i omega t); they are turned into lags. Rows that stand
    at no period are 0. Of the ``.8`` those count whose two headings are one.

    Parameters
    ----------
    path : str or path
        Of one of the files, or their common name without ending; those that are there are read.
    ulen : float
        The length ULEN, m, with which the run was made dimensionless.
    density, gravity : float
        kg/m3 and m/s2, by which it gets its dimensions.

    Raises
    ------
    InputError
        No file at all, and every line of them that is wrong, up to ten of a file.

    Examples
    --------
    >>> from catopt.hydro.coefficient_files import read_wamit
    >>> read_wamit("nowhere/ship", ulen=1.0, density=1025.0, gravity=9.80665)
    Traceback (most recent call last):
    ...
    catopt.errors.InputError: nowhere/ship: 1 error
      files: found none; .1, .2, .3, .4, .8 or .hst is required
    """
    found = Findings("read_wamit")
    for key, value, unit in (("ulen", ulen, "m"), ("density", density, "kg/m3")):
        found.number(key, value, unit, above=0.0)
    found.number("gravity", gravity, "m/s2", above=0.0)
    found.raise_if_any()
    name = Path(path)
    stem = name.with_suffix("") if name.suffix in WAMIT else name
    files = {end: stem.with_name(stem.name + end) for end in WAMIT}
    there = {end: file for end, file in files.items() if file.is_file()}
    if ".3" in there:
        there.pop(".2", None)
    if not there:
        allowed = Message("refused_motion.wamit_files_wanted")
        raise refused("files", Message("refused.none"), allowed, str(path))
    problems: list[Problem] = []
    rows = {end: wamit_rows(file, end, problems) for end, file in there.items()}
    if problems:
        raise InputError(problems, str(stem))
    made = _Wamit(stem.name, ulen, density, gravity, rows, problems).read()
    if problems or made is None:
        raise InputError(problems, str(stem))
    return made


def wamit_rows(path: Path, end: str, problems: list[Problem]) -> Array:
    """Read the rows of one of WAMIT's files by its ending, a key of `WAMIT`: (rows, columns).

    A first line of words is passed over; what is wrong is added to `problems`.
    """
    columns = WAMIT[end]
    text = read_text(path, str(path), kind="table of numbers", most=MOST_BYTES_OF_DATA)
    found, wrong = [], []
    for number, line in enumerate(text.splitlines(), start=1):
        if not line.strip():
            continue
        try:
            found.append(_row(line, columns))
        except ValueError as error:
            if number > 1 or any(cell[:1].isdigit() for cell in line.split()):
                place = Message("refused_motion.file_at_line", file=path.name, number=number)
                # Any other file may be here by mistake: its words are not told.
                said = as_written(line.strip()) if path.suffix.lower() in WAMIT else ""
                wrong.append(Problem(place, said, error.args[0]))
    if not wrong and not found:
        allowed = Message("refused_motion.rows_are_wanted", columns=" ".join(columns))
        wrong.append(Problem(path.name, Message("refused.none"), allowed))
    problems += wrong[:SHOWN]
    if len(wrong) > SHOWN:
        allowed = Message("refused_motion.more_kind", more=len(wrong) - SHOWN)
        problems.append(Problem(path.name, "", allowed))
    return np.array(found, dtype=float).reshape(-1, len(columns))


def _row(line: str, columns: Sequence[str]) -> list[float]:
    """Read a row; ValueError says what is wrong with it."""
    cells = line.upper().replace("D", "E").split()
    try:
        row = [float(cell) for cell in cells]
        if not all(cell.isascii() and "_" not in cell for cell in cells):
            raise ValueError
    except ValueError:
        raise ValueError(Message("refused_motion.numbers_wanted")) from None
    if columns[-1] == "B" and len(row) == len(columns) - 1 and row[0] <= 0.0:
        row.append(0.0)  # at zero and infinite frequency there is no damping
    if len(row) != len(columns):
        said = Message("refused_motion.row_numbers", count=len(columns), columns=" ".join(columns))
        raise ValueError(said)
    if not all(abs(value) < _MOST for value in row):
        raise ValueError(Message("refused_motion.finite_numbers_are_wanted"))
    of = dict(zip(columns, row, strict=True))
    if any(of[key] not in range(1, 7) for key in ("I", "J") if key in of):
        raise ValueError(Message("refused_motion.row_freedom"))
    if "MOD" in of:
        if not of["PER"] > 0.0:
            raise ValueError(Message("refused_motion.row_period"))
        angle, mod = math.radians(of["PHS"]), of["MOD"]
        off = math.hypot(of["RE"] - mod * math.cos(angle), of["IM"] - mod * math.sin(angle))
        if off > _ALIKE * max(abs(mod), math.hypot(of["RE"], of["IM"])):
            raise ValueError(Message("refused_motion.row_kind"))
    return row


class _Wamit:
    """Puts the rows of WAMIT's files together."""

    def __init__(
        self,
        name: str,
        ulen: float,
        density: float,
        gravity: float,
        rows: dict[str, Array],
        problems: list[Problem],
    ) -> None:
        self.name, self.rows, self.problems = name, rows, problems
        self.ulen, self.density, self.gravity = ulen, density, gravity
        if ".8" in rows:
            rows[".8"] = rows[".8"][rows[".8"][:, 1] == rows[".8"][:, 2]]
        periods = {
            end: set(table[table[:, 0] > 0.0, 0]) for end, table in rows.items() if end != ".hst"
        }
        self.periods = sorted(set().union(*periods.values()), reverse=True) if periods else []
        self._check_periods(periods)
        waves = {end: table for end, table in rows.items() if "MOD" in WAMIT[end]}
        self.headings = sorted(set().union(*(set(table[:, 1]) for table in waves.values()), set()))

    def _check_periods(self, of_files: dict[str, set[float]]) -> None:
        """Note files that have other periods than the first."""
        for end, own in of_files.items():
            missing = set(self.periods) - own
            if missing and own:
                allowed = Message("refused_motion.every_file_same_periods")
                found = f"PER {min(missing):g}"
                self.problems.append(Problem(f"{self.name}{end}", found, allowed))

    def read(self) -> Coefficients | None:
        unit = self.density * self.gravity
        to = self._waves
        excitation = to(".3" if ".3" in self.rows else ".2", unit * self.ulen ** (2 + _TURN))
        if ".4" in self.rows and self.ulen != 1.0:
            allowed = Message("refused_motion.n_4_file_with_ulen_1")
            self.problems.append(Problem("ulen", f"{self.ulen:g} m", allowed))
        response = to(".4", np.ones(6))
        drift = to(".8", unit * self.ulen ** (1 + _TURN))
        added, damping, limits = self._radiation()
        stiffness = self._stiffness(unit)
        if self.problems:
            return None
        return Coefficients(
            2.0 * math.pi / np.array(self.periods),
            np.radians(np.array(self.headings, dtype=float)),
            added,
            damping,
            limits.get(-1),
            limits.get(0),
            excitation,
            response,
            None if drift is None else drift.real.copy(),
            stiffness,
            source=", ".join(self.name + end for end in self.rows),
        )

    def _waves(self, end: str, scale: Array) -> Complex | None:
        """Return answers to waves, (periods, headings, 6), in SI and as lags."""
        if end not in self.rows:
            return None
        rows, columns = self.rows[end], WAMIT[end]
        at = columns.index("I")
        places = [
            (self.periods.index(row[0]), self.headings.index(row[1]), int(row[at]) - 1)
            for row in rows.tolist()
        ]
        values = rows[:, columns.index("RE")] - 1j * rows[:, columns.index("IM")]
        filled = self._filled(end, (len(self.periods), len(self.headings), 6), places, values)
        out: Complex = filled * scale
        return out

    def _filled(
        self, end: str, shape: tuple[int, ...], places: Sequence[tuple[int, ...]], values: Any
    ) -> Any:
        """Put values in their places; one twice, or at some periods alone, is noted."""
        out = np.full(shape, np.nan, dtype=np.result_type(values, float))
        file = f"{self.name}{end}"
        for place, value in zip(places, values, strict=True):
            if not np.isnan(out[place]):
                wanted = Message("refused_motion.one_row_each_wanted")
                self.problems.append(Problem(file, self._state(end, place), wanted))
            out[place] = value
        somewhere = ~np.isnan(out).all(axis=tuple(range(len(shape) - (2 if end == ".1" else 1))))
        out[..., ~somewhere] = 0.0
        lacking = np.argwhere(np.isnan(out)).tolist()
        for lacks in lacking[:SHOWN]:
            said = Message("refused_motion.missing_there_at_other_periods")
            self.problems.append(Problem(file, self._state(end, lacks), said))
        return out

    def _state(self, end: str, place: Sequence[int]) -> str:
        period, second, third = place
        way = f"I {second + 1}, J" if end == ".1" else f"BETA {self.headings[second]:g}, I"
        return f"PER {self.periods[period]:g}, {way} {third + 1}"

    def _radiation(self) -> tuple[Array | None, Array | None, dict[int, Array]]:
        if ".1" not in self.rows:
            return None, None, {}
        rows = self.rows[".1"]
        scale = self.density * self.ulen ** (3.0 + np.add.outer(_TURN, _TURN))
        places = {key: (rows[:, 1 + k] - 1).astype(int) for k, key in enumerate("IJ")}
        finite = rows[:, 0] > 0.0
        columns = (rows[finite, 0], places["I"][finite], places["J"][finite])
        cells = zip(*(column.tolist() for column in columns), strict=True)
        at = [(self.periods.index(per), i, j) for per, i, j in cells]
        shape = (len(self.periods), 6, 6)
        limits: dict[int, Array] = {}
        for sign in (-1, 0):
            own = np.sign(rows[:, 0]) == sign
            if own.any():
                limit = np.zeros((6, 6))
                limit[places["I"][own], places["J"][own]] = rows[own, 3]
                limits[sign] = limit * scale
        if not at:
            return None, None, limits
        added = self._filled(".1", shape, at, rows[finite, 3]) * scale
        omega = 2.0 * math.pi / np.array(self.periods)
        damping = self._filled(".1", shape, at, rows[finite, 4]) * scale
        return added, damping * omega[:, np.newaxis, np.newaxis], limits

    def _stiffness(self, unit: float) -> Array | None:
        if ".hst" not in self.rows:
            return None
        rows = self.rows[".hst"]
        out = np.zeros((6, 6))
        out[rows[:, 0].astype(int) - 1, rows[:, 1].astype(int) - 1] = rows[:, 2]
        out *= unit * self.ulen ** (2.0 + np.add.outer(_TURN, _TURN))
        return out


# ------------------------------------------------------------------ capytaine


def read_capytaine(path: str | os.PathLike[str]) -> Coefficients:
    """Read a dataset of one body that capytaine wrote, a netCDF file; time goes as there.

    Complex values are those of `capytaine.io.xarray.separate_complex_values`. Needs the package
    xarray and h5netcdf, ``pip install "catopt[tables]"``.

    Raises
    ------
    InputError
        No xarray, a file that it cannot open, several bodies or other freedoms than the six, and
        what is missing; all of the file's at once.
    """
    need_package("xarray", "tables", "read_capytaine")
    import xarray

    if not Path(path).is_file():
        raise refused("file", str(path), Message("refused_motion.no_such_file"))
    try:
        with xarray.open_dataset(path) as opened:
            return _Capytaine(opened.load(), str(path)).read()
    except _DAMAGED as error:
        allowed = Message("refused_motion.netcdf_not_opened", error=str(error).split("\n")[0])
        raise refused("file", "", allowed, str(path)) from None


class _Capytaine:
    """Takes coefficients out of a dataset, by the names of its dimensions."""

    def __init__(self, data: Any, path: str) -> None:
        self.data, self.path = data, path
        self.problems: list[Problem] = []

    def read(self) -> Coefficients:
        data = self.data
        order = list(self._freedoms())
        lacks = [key for key in ("omega", "wave_direction") if key not in data.variables]
        lacks += [key for key in ("added_mass", "radiation_damping") if key not in data]
        allowed = Message("refused_motion.missing_from_dataset")
        self.problems += [Problem(key, "", allowed) for key in lacks]
        if self.problems:
            raise InputError(self.problems, self.path)
        omega = np.atleast_1d(data["omega"].values).astype(float)
        heading = np.atleast_1d(data["wave_direction"].values).astype(float)
        finite = np.flatnonzero((omega > 0.0) & np.isfinite(omega))
        finite = finite[np.argsort(omega[finite])]
        turns = np.argsort(heading)
        pairs = ("influenced_dof", "radiating_dof")
        added = self._of("added_mass", ("omega", *pairs), order)
        damping = self._of("radiation_damping", ("omega", *pairs), order)
        assert added is not None
        assert damping is not None
        limits = {float(w): added[k] for k, w in enumerate(omega) if w in (0.0, math.inf)}

        def of_waves(*keys: str) -> Complex | None:
            ways = ("omega", "wave_direction", "influenced_dof")
            parts = [self._of(key, ways, order) for key in keys]
            known = [part for part in parts if part is not None]
            if len(known) < len(keys):
                return None
            total: Complex = np.sum(known, axis=0)[finite][:, turns].astype(complex)
            return total

        excitation = of_waves("excitation_force")
        if excitation is None:
            excitation = of_waves("diffraction_force", "Froude_Krylov_force")
        return Coefficients(
            omega[finite],
            heading[turns],
            added[finite],
            damping[finite],
            limits.get(0.0),
            limits.get(math.inf),
            excitation,
            stiffness=self._of("hydrostatic_stiffness", pairs, order),
            mass=self._of("inertia_matrix", pairs, order),
            source=Path(self.path).name,
        )

    def _freedoms(self) -> Iterator[int]:
        """Yield where each of the six stands among the file's."""
        for key in ("influenced_dof", "radiating_dof"):
            if key not in self.data.variables:
                allowed = Message("refused_motion.missing_from_dataset")
                self.problems.append(Problem(key, "", allowed))
                return
        names = [_text(value) for value in np.atleast_1d(self.data["influenced_dof"].values)]
        short = [name.rpartition("__")[2].casefold() for name in names]
        if sorted(short) != sorted(FREEDOMS):
            allowed = Message("refused_motion.six_freedoms", words=", ".join(FREEDOMS))
            found = as_written(", ".join(names), longest=200)
            self.problems.append(Problem("influenced_dof", found, allowed))
            return
        yield from (short.index(freedom) for freedom in FREEDOMS)

    def _of(self, key: str, ways: Sequence[str], order: list[int]) -> Any:
        """Return a variable along some dimensions, freedoms in our order; None: not there."""
        if key not in self.data:
            return None
        values = self.data[key]
        if "complex" in values.dims:
            parts = [_text(value) for value in np.atleast_1d(self.data["complex"].values)]
            re, im = (values.isel(complex=parts.index(part)) for part in ("re", "im"))
            values = re + 1j * im
        for way in ways:
            if way not in values.dims:
                values = values.expand_dims(way)
        out = values.squeeze(set(values.dims) - set(ways), drop=True).transpose(*ways).values
        for axis, way in enumerate(ways):
            if way.endswith("_dof"):
                out = np.take(out, order, axis=axis)
        return out


def _text(value: object) -> str:
    return value.decode() if isinstance(value, bytes) else str(value)
