"""A case in motion without steps in time: standard deviations of tension, lines being linear."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from catopt.errors import InputError, Problem, refused
from catopt.fem.linear_model import LinearModel, linear_model
from catopt.fem.linear_motion import LEAST_RESERVE, linear_motion
from catopt.fem.series import Harmonic
from catopt.floater.alone import current_across, unmirrored, waves_across
from catopt.floater.moored import AtRest, linear_hull
from catopt.hydro.build import FloatingHull
from catopt.model import Case, WaveState
from catopt.verify.dynamic_lines import LinesOfABody, LinesOfAFloater, OneLine, lines_at_rest
from catopt.verify.dynamic_setup import check_for_motion, read_drive
from catopt.words import Message


@dataclass(frozen=True)
class LinearLine:
    """What a random sea makes of the tension at a line's fairlead, by linear motion.

    `line`: of a body with several lines, which one, from 1; `mean`: at rest, N; `deviation`:
    standard deviation, N; `period`: zero-crossing period, s; `anchor_mean`, `anchor_deviation`:
    likewise at the lower end; `reserve`: least tension of any of the line's bars at rest over its
    standard deviation; `buoy`: standard deviations of surge and heave, m, and pitch, rad, of the
    buoy that floats at its end, if one does.
    """

    line: int | None
    mean: float
    deviation: float
    period: float
    anchor_mean: float
    anchor_deviation: float
    reserve: float
    buoy: tuple[float, float, float] | None = None

    @property
    def holds(self) -> bool:
        """Whether the line has the reserve with which led lines stay taut in time.

        A buoy's may go slack all the same, and then nothing here holds: run it in time.
        """
        return self.reserve >= LEAST_RESERVE

    def most_probable(self, duration: float) -> float:
        """Most probable largest tension in a storm, N, if tensions were normally distributed.

        They are not: the largest in time are above it, by a quarter in steep seas. `duration`: s.
        """
        if not self.deviation > 0.0:
            return self.mean
        peaks = max(duration / self.period, 1.0)
        return self.mean + self.deviation * math.sqrt(2.0 * math.log(peaks))


def linear_lines(case: Case) -> tuple[LinearLine, ...]:
    """Find the standard deviation of the tension at every fairlead in the sea of a case.

    `case`: with `waves`, `dynamics`, and a `motion` by `rao_file` or none; with `system`, all lines
    of the body, which is led by its RAOs; with a buoy in `floater`, which floats at their ends.
    InputError for what a line in motion lacks, and what has no linear form: a body that moves
    under forces, a motion over time, a line that is lost; else what `verify_dynamic` raises.

    Examples
    --------
    >>> import catopt
    >>> from catopt.verify.linear import linear_lines
    >>> (line,) = linear_lines(catopt.read_case("cases/dynamic-chain-56m/case.toml"))
    >>> round(line.mean / 1e3), round(line.deviation / 1e3), line.holds
    (555, 66, True)
    """
    check_for_motion(case)
    if problems := list(_not_linear(case)):
        raise InputError(problems, "linear motion")
    lines = lines_at_rest(read_drive(case))
    sea, body = lines.drive.sea(0), None
    assert sea.waves is not None
    calm = replace(case, waves=WaveState("regular", 1.0, 10.0), title="")
    if isinstance(lines, LinesOfAFloater):
        if not isinstance(lines.hull, FloatingHull):
            allowed = Message("refused_motion.linear_hull")
            assert case.floater is not None
            raise refused(f"floater.{case.floater.kind}", "", allowed, "linear motion")
        if problems := list(_out_of_plane(lines, lines.hull)):
            raise InputError(problems, "linear motion")
        rest, model = _afloat(calm)
        body = linear_hull(lines.hull, rest, sea)
    else:
        model = _model(calm)
    prescribed_motion = np.zeros((model.start.size - 1, sea.waves.omega.size, 3), dtype=complex)
    if case.motion is not None:
        for k, series in enumerate(lines.driven_by(sea)):
            assert isinstance(series, Harmonic)
            prescribed_motion[k] = series.amplitudes
    found = linear_motion(model, sea, prescribed_motion, body)
    deviation, period = found.deviation, found.zero_crossing_period
    moved = np.sqrt(0.5 * (np.abs(found.motion) ** 2).sum(axis=0)).tolist()
    return tuple(
        LinearLine(
            k + 1 if case.several_lines else None,
            float(found.mean[last]),
            float(deviation[last]),
            float(period[last]),
            float(found.mean[first]),
            float(deviation[first]),
            found.reserve(k),
            None if body is None else (moved[0], moved[1], moved[2]),
        )
        for k, (first, last) in enumerate(
            zip(model.start[:-1].tolist(), (model.start[1:] - 1).tolist(), strict=True)
        )
    )


@lru_cache(maxsize=8)
def _model(case: Case) -> LinearModel:
    """Linearise the lines of a case; that its sea is another one makes no difference."""
    lines = lines_at_rest(read_drive(case))
    assert isinstance(lines, OneLine | LinesOfABody)  # points are refused by `check_for_motion`
    return linear_model(lines.simulation())


@lru_cache(maxsize=8)
def _afloat(case: Case) -> tuple[AtRest, LinearModel]:
    """Bring a buoy and its lines to rest, and linearise these; as `_model`."""
    lines = lines_at_rest(read_drive(case))
    assert isinstance(lines, LinesOfAFloater)
    rest = lines.moored_at_rest()
    return rest, linear_model(rest.simulation)


def _out_of_plane(of: LinesOfAFloater, hull: FloatingHull) -> Iterator[Problem]:
    """Yield what takes a buoy out of the plane of x and z, in which alone it is linear."""
    sea, allowed = of.drive.sea(0), Message("refused_motion.linear_along_x")
    if waves_across(sea):
        yield Problem("waves.direction", "", allowed)
    if current_across(sea):
        yield Problem("current.direction", "", allowed)
    if hull.wind_across:
        found = f"{math.degrees(hull.wind_direction):.4g} deg"
        yield Problem("floater.wind_direction", found, allowed)
    for number in unmirrored(hull, of.legs):
        mirrored = Message("refused_motion.mirrored_lines_of_a_buoy", number=number + 1)
        yield Problem(f"system.lines[{number}].azimuth", "", mirrored)


def _not_linear(case: Case) -> Iterator[Problem]:
    """Yield what has no linear form."""
    motion, dynamics = case.motion, case.dynamics
    assert dynamics is not None
    if case.waves is None or not (case.waves.is_random or case.waves.elevation_file):
        yield Problem("waves", "", Message("refused_motion.random_sea_wanted_spectrum_or"))
    if motion is not None and not motion.rao_file:
        yield Problem("motion", "", Message("refused_motion.rao_file_wanted_or_no"))
    if motion is not None and motion.drift_file:
        allowed = Message("refused_motion.leave_out_drift_mean_offset")
        yield Problem("motion.drift_file", "", allowed)
    if case.anchor_motion is not None:
        yield Problem("anchor_motion", "", Message("refused_motion.leave_out_lower_end_held"))
    if case.body is not None:
        yield Problem("body", "", Message("refused_motion.leave_out_body_led_by"))
    if case.current is not None and case.current.series_file:
        yield Problem("current.series_file", "", Message("refused_motion.leave_out_current_steady"))
    if dynamics.broken_line is not None:
        yield Problem("dynamics.broken_line", "", Message("refused_motion.leave_out_no_line_lost"))
