"""Many lines in one call: arrays in, arrays out."""

from __future__ import annotations

import math
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import partial
from time import perf_counter
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from catopt.arrays import Array, Codes, Flags
from catopt.catenary.equilibrium import BY_FORCE, BY_SPAN, BY_TENSION
from catopt.catenary.layout import LineIntervals, most_runs
from catopt.catenary.many import COLUMNS, fill
from catopt.catenary.pieces import Pieces
from catopt.catenary.state import CONVERGED, NOT_CONVERGED, REASONS, REGIMES
from catopt.compiled import compiled, is_compiled
from catopt.errors import InputError, Problem, refused
from catopt.model import Line
from catopt.model.array_inputs import array_in_si
from catopt.model.kinds import Findings
from catopt.words import Message

__all__ = ["Solutions", "room_for_runs", "solve_many"]

if TYPE_CHECKING:
    import pandas as pd

_A_PIECE = 2e-4
"""Time that a piece of one line takes as plain Python, s: 6e-5 under a known force, 2e-4 to 1e-3
where the span is known."""
_A_LOOK = 0.1
"""Time after which it is asked anew whether compiling is the sooner done, s."""

Numbers = Any
"""Numbers, text with a unit, quantities, alone or in arrays: what `array_in_si` reads."""
_UNITS = {
    "horizontal_force": "N",
    "span": "m",
    "fairlead_tension": "N",
    "height": "m",
    "anchor_height": "m",
    "seabed_friction": "",
    "lengths": "m",
    "submerged_weights": "N/m",
    "EA": "N",
    "positions": "m",
    "point_weights": "N",
}
"""What is read in."""
Result = TypeVar("Result")


@dataclass(frozen=True)
class Solutions:
    """Answers for many lines; every array has the shape (n,), and nan where there is no answer."""

    status: Codes  # 0 where solved; `reason` puts the others into words
    regime_code: Codes  # index into state.REGIMES, see `regime`
    horizontal_force: Array  # at the fairlead, N
    vertical_force: Array  # at the fairlead, N
    span: Array  # m
    height_error: Array  # residual: computed less wanted height of the fairlead, m
    grounded_length: Array  # m
    anchor_horizontal_force: Array  # N
    anchor_vertical_force: Array  # N
    flexibility: Array  # (n, 2, 2): d(span, height)/d(H, V) at the fairlead, m/N
    force_uncertainty: Array  # what rounding of the input may move the fairlead's forces by, N

    @property
    def converged(self) -> Flags:
        """Which lines have an answer."""
        return np.equal(self.status, CONVERGED)

    @property
    def tension(self) -> Array:
        """Effective tension at the fairlead, N."""
        return np.hypot(self.horizontal_force, self.vertical_force)

    @property
    def angle(self) -> Array:
        """Inclination at the fairlead, rad."""
        return np.arctan2(self.vertical_force, self.horizontal_force)

    @property
    def anchor_tension(self) -> Array:
        """Effective tension at the anchor, N."""
        return np.hypot(self.anchor_horizontal_force, self.anchor_vertical_force)

    @property
    def anchor_angle(self) -> Array:
        """Inclination at the anchor, rad."""
        return np.arctan2(self.anchor_vertical_force, self.anchor_horizontal_force)

    @property
    def stiffness(self) -> Array:
        """End stiffness d(H, V)/d(span, height) in N/m, shape (n, 2, 2); nan where slack."""
        x_H, x_V = self.flexibility[:, 0, 0], self.flexibility[:, 0, 1]
        z_H, z_V = self.flexibility[:, 1, 0], self.flexibility[:, 1, 1]
        with np.errstate(invalid="ignore"):
            inverse = np.array([[z_V, -x_V], [-z_H, x_H]]) / (x_H * z_V - x_V * z_H)
        return np.moveaxis(inverse, 2, 0)

    def to_dataframe(self) -> pd.DataFrame:
        """Return one row a line, in SI, with the unit in each heading."""
        import pandas as pd

        rows = range(len(self.status))
        return pd.DataFrame(
            {
                "regime": [self.regime(k) for k in rows],
                "reason": [self.reason(k) for k in rows],
                "span (m)": self.span,
                "horizontal force (N)": self.horizontal_force,
                "vertical force (N)": self.vertical_force,
                "fairlead tension (N)": self.tension,
                "fairlead angle (rad)": self.angle,
                "anchor tension (N)": self.anchor_tension,
                "anchor angle (rad)": self.anchor_angle,
                "grounded length (m)": self.grounded_length,
            }
        )

    def _repr_html_(self) -> str:
        """Show the first and last rows, for a notebook."""
        html: str = self.to_dataframe().to_html(max_rows=20)
        return html

    def regime(self, index: int) -> str | None:
        """Name of a line's regime; None when it has no answer."""
        return REGIMES[self.regime_code[index]] if self.status[index] == CONVERGED else None

    def reason(self, index: int) -> str | None:
        """Why a line has no answer; None when it has one."""
        return REASONS[int(self.status[index])]


def solve_many(
    line: Line,
    *,
    height: Numbers,
    horizontal_force: Numbers | None = None,
    span: Numbers | None = None,
    fairlead_tension: Numbers | None = None,
    seabed_friction: Numbers = 0.0,
    anchor_height: Numbers = 0.0,
    lengths: Numbers | None = None,
    submerged_weights: Numbers | None = None,
    EA: Numbers | None = None,
    positions: Numbers | None = None,
    point_weights: Numbers | None = None,
    workers: int = 1,
) -> Solutions:
    """Solve many lines by one loop, compiled where there is enough to do.

    Everything is a number for all lines or an array with one entry a line; the formulas are those
    of `solve`. A line without an answer is marked with its reason and leaves the others alone.

    Parameters
    ----------
    line : Line
        Gives what the arrays below do not.
    height, seabed_friction, anchor_height : float or array, shape (n,)
        As for `solve`.
    horizontal_force, span, fairlead_tension : float or array, shape (n,)
        Exactly one of them.
    lengths, submerged_weights, EA : array, shape (segments,) or (n, segments), optional
        Instead of the line's: m, N/m, N (infinite: inextensible).
    positions, point_weights : array, shape (loads,) or (n, loads), optional
        Instead of the line's: m from the anchor, rising, and N.
    workers : int
        Threads.

    Raises
    ------
    InputError
        When shapes do not fit, not exactly one load is given, or something is no number: masked
        values, booleans and dates are none. Quantities of pint, astropy and unyt are converted.

    Examples
    --------
    >>> import catopt
    >>> line = catopt.Line([catopt.Segment(100.0, 900.0)])
    >>> many = catopt.solve_many(line, height=60.0, span=[75.0, 79.0, 120.0])
    >>> many.converged.tolist(), f"{many.tension[0] / 1e3:.1f} kN"
    ([True, True, False], '108.0 kN')
    """
    given = _in_si(
        horizontal_force=horizontal_force,
        span=span,
        fairlead_tension=fairlead_tension,
        height=height,
        anchor_height=anchor_height,
        seabed_friction=seabed_friction,
        lengths=lengths,
        submerged_weights=submerged_weights,
        EA=EA,
        positions=positions,
        point_weights=point_weights,
    )
    known, wanted = _known(given["horizontal_force"], given["span"], given["fairlead_tension"])
    places = (given[key] for key in ("height", "anchor_height", "seabed_friction"))
    per_line = [wanted, *(each for each in places if each is not None)]
    tables = _tables(line, given)
    count = _count(per_line, tables)
    columns = [
        np.ascontiguousarray(v) if v.shape == (count,) else np.full(count, v) for v in per_line
    ]
    status = np.empty(count, dtype=np.int64)
    regime = np.empty(count, dtype=np.int64)
    out = np.empty((count, len(COLUMNS)))
    size = tables[0].shape[1] + tables[3].shape[1]
    grips = np.array([-1.0 if p.friction is None else p.friction for p in line.point_loads])

    def run(loop: Callable[..., Any], first: int, end: int) -> None:
        room = Pieces(np.empty(size), np.empty(size), np.empty(size), np.empty(2 * size + 2))
        owner = np.empty(size, dtype=np.int64)
        runs = room_for_runs(size)
        loop(known, *columns, *tables, grips, room, owner, runs, first, end, status, regime, out)

    # Lines differ by a factor of thousands in what they take: those done tell of those to come.
    at, a_line, began = 0, _A_PIECE * size, perf_counter()
    while at < count:
        loop = compiled(fill, a_line * (count - at))
        if is_compiled(fill):
            in_ranges(partial(run, loop), at, count, workers)
            break
        pause = perf_counter() + _A_LOOK
        while at < count and perf_counter() < pause:
            run(loop, at, at + 1)
            at += 1
        a_line = (perf_counter() - began) / at
    # Beyond what a number may be, as 1e308 N, the formulas overflow.
    status[(status == CONVERGED) & ~np.isfinite(out[:, 2])] = NOT_CONVERGED
    return Solutions(
        status,
        regime,
        horizontal_force=out[:, 0],
        vertical_force=out[:, 1],
        span=out[:, 2],
        height_error=out[:, 3],
        grounded_length=out[:, 4],
        anchor_horizontal_force=out[:, 5],
        anchor_vertical_force=out[:, 6],
        flexibility=out[:, 7:11].reshape(count, 2, 2),
        force_uncertainty=out[:, 11],
    )


def room_for_runs(pieces: int) -> LineIntervals:
    """Make work space for the runs of a line.

    Parameters
    ----------
    pieces : int
        How many pieces it has.
    """
    rows = most_runs(pieces)
    whole = [np.zeros(rows, dtype=np.int64) for _ in range(2)]
    columns = [np.zeros(rows) for _ in range(5)]
    return LineIntervals(*whole, *columns)


def _in_si(**given: Any) -> dict[str, Array | None]:
    """Read everything as numbers in SI; all that is wrong at once."""
    found = Findings("solve_many")
    in_si = {
        key: None if values is None else array_in_si(found, key, values, _UNITS[key])
        for key, values in given.items()
    }
    found.raise_if_any()
    return in_si


def _known(*given: Array | None) -> tuple[int, Array]:
    codes = (BY_FORCE, BY_SPAN, BY_TENSION)
    found = [(code, value) for code, value in zip(codes, given, strict=True) if value is not None]
    if len(found) != 1:
        said = Message("refused_motion.of_them", count=len(found))
        raise refused("load", said, Message("refused.one_load"), "solve_many")
    return found[0]


def _tables(line: Line, given: dict[str, Array | None]) -> list[Array]:
    """Per-line tables with one row for all lines or a row a line."""
    segments, loads = line.segments, line.point_loads
    own = {
        "lengths": [s.length for s in segments],
        "submerged_weights": [s.submerged_weight for s in segments],
        "EA": [s.EA for s in segments],
        "positions": [p.position for p in loads],
        "point_weights": [p.submerged_weight for p in loads],
    }
    problems, tables = [], []
    for key, default in own.items():
        values = given[key]
        table = np.array(default, dtype=np.float64) if values is None else values
        table = table[np.newaxis] if table.ndim == 1 else np.atleast_2d(table)
        if table.ndim != 2 or table.shape[1] != len(default):
            wanted = Message("refused_motion.shape_of_line", count=len(default))
            shape = Message("refused_motion.shape", shape=np.shape(table))
            problems.append(Problem(key, shape, wanted))
        tables.append(np.ascontiguousarray(table))
    if problems:
        raise InputError(problems, "solve_many")
    with np.errstate(divide="ignore"):
        tables[2] = 1.0 / tables[2]
    return tables


def _count(per_line: list[Array], tables: list[Array]) -> int:
    """Return the number of lines on which all arrays agree."""
    sizes = {np.shape(values)[0] for values in per_line if np.ndim(values) == 1}
    sizes |= {table.shape[0] for table in tables if table.shape[0] > 1}
    sizes.discard(1)
    if len(sizes) > 1 or any(np.ndim(values) > 1 for values in per_line):
        lengths = ", ".join(map(str, sorted(sizes)))
        found = Message("refused_motion.lengths_of_arrays", lengths=lengths)
        problem = Problem("arrays", found, Message("refused_motion.per_line"))
        raise InputError([problem], "solve_many")
    return sizes.pop() if sizes else 1


def in_ranges(
    run: Callable[[int, int], Result], first: int, end: int, workers: int, least: int = 2
) -> list[Result]:
    """Run ranges of `least` or more by several threads; compiled loops free the interpreter."""
    if workers <= 1 or end - first < least * workers:
        return [run(first, end)]
    step = math.ceil((end - first) / workers)
    ranges = [(start, min(start + step, end)) for start in range(first, end, step)]
    with ThreadPoolExecutor(workers) as pool:
        return list(pool.map(lambda each: run(*each), ranges))
