"""A case's ship on its lines, on two time scales: what its lines carry, and whether they may."""

from __future__ import annotations

import math
import os
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Final

import numpy as np

from catopt.arrays import Array
from catopt.catenary.solution import Solution
from catopt.catenary.solve import solve
from catopt.checks.criteria import Criteria, criteria_of, motion_profile
from catopt.checks.evaluation import evaluate, of_criteria
from catopt.checks.kinds import Place
from catopt.checks.profiles import profiles_of
from catopt.checks.result import CheckReport, CheckResult
from catopt.errors import InputError, Problem
from catopt.fem.extremes import Extreme, weibull_tail
from catopt.floater.ship import ShipInWeather
from catopt.floater.two_scales import (
    MooredShip,
    Scales,
    ShipAtRest,
    ShipHistory,
    sample_step,
    scales_of,
)
from catopt.model import Case
from catopt.model.dynamics import Dynamics, JudgedBy
from catopt.ties import first_largest, largest
from catopt.units import lasting
from catopt.verify.dynamic_setup import Excitation, read_drive
from catopt.verify.motion_file import energy_beyond
from catopt.verify.side_by_side import Progress
from catopt.waves import Waves, breaking_warning
from catopt.waves.random_surface import wave_number
from catopt.words import Message

_LEVELS: Final = 20
"""Over the draught, at which the current is averaged."""
_WIDE: Final = 0.2
"""Breadth over the wave length above which a hull changes the waves."""
_CYCLES: Final = 50
"""Slow cycles from which a deviation is known to some 10 %."""
_LEFT_OUT: Final = 0.01
"""Part of the waves' energy beyond a table of RAOs from which it is remarked on."""


@dataclass(frozen=True)
class LineOfShip:
    """What a line carries: from 1, its scales of tension at both ends, and its MBL, N, if known.

    `storm`: the largest tension at the fairlead in the storm, by the tail of its peaks; None where
    the runs have too few of them.
    """

    number: int
    fairlead: Scales
    anchor: Scales
    MBL: float | None
    storm: Extreme | None = None

    def judged(self, by: JudgedBy) -> float:
        """Tension at the fairlead that the checks are held against, N.

        What is most probable in the storm, or the upper end of its interval; by the largest values,
        and where the runs have no tail, `Scales.judged`.
        """
        if by == "largest" or self.storm is None:
            return self.fairlead.judged
        return self.storm.high if by == "upper" else self.storm.most_probable


@dataclass(frozen=True, eq=False)
class ShipVerification:
    """A case's ship in motion: every run, what they come to, and the checks."""

    case: Case
    moored: MooredShip
    rest: ShipAtRest
    """Of the first run's waves."""
    runs: tuple[ShipHistory, ...]
    lines: tuple[LineOfShip, ...]
    """What every line carries."""
    hanging: tuple[Solution, ...]
    """Each line under the tension that it is judged by."""
    checks: CheckReport
    remarks: tuple[Message, ...]
    directions: Array
    """Of the waves of the first run, where they travel to, rad."""

    @property
    def _storm(self) -> float:
        assert self.case.dynamics is not None
        return self.case.dynamics.duration_of_interest

    def _scales(self, slow: list[Array], whole: list[Array]) -> Scales:
        return scales_of(slow, whole, self.runs[0].time, self._storm)

    @cached_property
    def offset(self) -> Scales:
        """Of the origin from the zero-load position, m."""
        zero = np.array(self.rest.zero)

        def off(path: Array) -> Array:
            return np.asarray(np.hypot(*(path[:, :2] - zero).T))

        return self._scales([off(e.slow) for e in self.runs], [off(e.whole) for e in self.runs])

    @cached_property
    def heading(self) -> float:
        """Mean yaw, rad."""
        return float(np.mean([each.slow[:, 2] for each in self.runs]))

    @cached_property
    def yaw(self) -> Scales:
        """Of the yaw beside its mean, rad, to the side where it is larger."""
        both = [
            self._scales(
                [side * (each.slow[:, 2] - self.heading) for each in self.runs],
                [side * (each.whole[:, 2] - self.heading) for each in self.runs],
            )
            for side in (1.0, -1.0)
        ]
        return max(both, key=lambda each: each.combined)

    @property
    def most_loaded(self) -> int:
        """Line with the largest combined tension, from 0; the first of several alike."""
        return first_largest([each.fairlead.combined for each in self.lines])


def _lines(moored: MooredShip, runs: tuple[ShipHistory, ...], storm: float) -> Iterator[LineOfShip]:
    for k, leg in enumerate(moored.system.legs):
        fairlead, anchor = (
            scales_of(
                [each.slow_tension[:, k, end] for each in runs],
                [each.tension[:, k, end] for each in runs],
                runs[0].time,
                storm,
            )
            for end in (0, 1)
        )
        known = [each.MBL for each in leg.line.segments if each.MBL is not None]
        time = math.fsum(float(each.time[-1] - each.time[0]) for each in runs)
        tail = weibull_tail([each.tension[:, k, 0] for each in runs], time, storm)
        extreme = None if tail is None else tail.extreme
        yield LineOfShip(k + 1, fairlead, anchor, min(known, default=None), extreme)


def verify_ship(
    case: Case, *, ship: ShipInWeather | None = None, progress: Progress | None = None
) -> ShipVerification:
    """Run the ship of a case on its lines, on two time scales.

    Parameters
    ----------
    case : Case
        With `floater.ship`, `system`, `waves` and `dynamics`, whose duration, ramp, runs and
        duration of interest count; with `motion` for RAOs of its own.
    ship : ShipInWeather, optional
        That of an earlier answer (`moored.ship`) in the same weather, whose tables it shares.
    progress : callable, optional
        Told how many runs are done, of how many.

    Returns
    -------
    ShipVerification

    Raises
    ------
    InputError
        For a case without such a ship, and what is wrong in its files.
    NoEquilibriumError
        Where the lines do not hold the ship, or one does not reach in motion.
    NotConvergedError

    Examples
    --------
    >>> from dataclasses import replace
    >>> from catopt import read_case
    >>> from catopt.verify.two_scales import verify_ship
    >>> case = read_case("cases/fso-rang-dong-ship/loaded.toml")
    >>> short = replace(case.dynamics, duration=120.0, ramp=20.0)
    >>> found = verify_ship(replace(case, dynamics=short))
    >>> round(found.rest.force[0] / 1e3)
    -1433
    """
    moored, drive = moored_ship(case, ship)
    dynamics = drive.dynamics
    criteria = _criteria(case)
    for line in {leg.line for leg in moored.system.legs}:
        criteria.strengths(line, {"extreme"})
    step = sample_step(_waves(drive, 0))

    def run(number: int) -> tuple[ShipHistory, ShipAtRest]:
        waves = _waves(drive, number)
        rest = moored.at_rest(waves)
        seed = 0 if case.waves is None else case.waves.seed
        generator = np.random.default_rng([seed, number, 1])
        return moored.run(waves, dynamics.duration, drive.ramp, generator, rest, step=step), rest

    # The first run by itself: whatever has to be compiled then is.
    found = [run(0)]
    if progress is not None:
        progress(1, dynamics.runs)
    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        later = pool.map if dynamics.runs > 2 else map
        for number, each in enumerate(later(run, range(1, dynamics.runs)), start=2):
            found.append(each)
            if progress is not None:
                progress(number, dynamics.runs)
    histories, rest = tuple(each for each, _ in found), found[0][1]
    lines = tuple(_lines(moored, histories, dynamics.duration_of_interest))
    remarks = (
        *_judged_by(lines, dynamics),
        *_few_cycles(histories, rest),
        *_remarks(case, moored, drive, rest),
    )
    hanging = hang_judged(case, lines, moored)
    checks, directions = check_hanging(case, hanging), _waves(drive, 0).direction
    return ShipVerification(
        case, moored, rest, histories, lines, hanging, checks, remarks, directions
    )


def _waves(drive: Excitation, run: int) -> Waves:
    waves = drive.sea(run).waves
    assert waves is not None
    return waves


def moored_ship(case: Case, ship: ShipInWeather | None = None) -> tuple[MooredShip, Excitation]:
    """Make the ship of a case on its lines, and what drives it; as `verify_ship`."""
    if case.floater is None or case.floater.ship is None or case.system is None:
        allowed = Message("refused_case.ship_wanted")
        raise InputError([Problem("floater.ship", "", allowed)], "--dynamic")
    floater, of, current = case.floater, case.floater.ship, case.current
    if current is not None and current.series_file:
        allowed = Message("refused_case.ship_steady_current")
        raise InputError(
            [Problem("current.series_file", current.series_file, allowed)], "--dynamic"
        )
    drive = read_drive(case)
    if ship is not None and drive.vessel is None:
        return MooredShip(case.system, ship), drive
    depth, flow = case.site.water_depth, (0.0, 0.0)
    if current is not None and of.draught < depth:
        at = current.flow(depth)
        levels = (depth - of.draught * (k + 0.5) / _LEVELS for k in range(_LEVELS))
        parts = [at(level) for level in levels]
        flow = (sum(e[0] for e in parts) / _LEVELS, sum(e[1] for e in parts) / _LEVELS)
    speed, way = floater.wind_speed, of.wind_direction
    wind = (speed * math.cos(way), speed * math.sin(way))
    ship = ShipInWeather(of, depth, case.site.water_density, wind, flow)
    ship.ship  # noqa: B018 - refuses what no hull can be
    vessel = drive.vessel
    if vessel is None:
        return MooredShip(case.system, ship), drive
    return MooredShip(case.system, ship, vessel.coefficients, vessel.reference, vessel.crest), drive


def _criteria(case: Case) -> Criteria:
    """Gather what lines that hang by closed form are to keep: factors for quasi-static analysis.

    In the place of a code without factors for motion those of `checks.motion_code`, if given.
    """
    checks, by = case.checks, motion_profile(case.checks)
    if by is None or checks.motion_code is None:
        return criteria_of(case)
    named = zip(checks.codes, profiles_of(replace(checks, motion_code=None)), strict=True)
    codes = [code for code, each in named if each.is_for_motion]
    if checks.codes and len(codes) == len(checks.codes):
        return criteria_of(case)
    own = replace(checks, codes=tuple(dict.fromkeys((*codes, checks.motion_code))))
    return criteria_of(replace(case, checks=replace(own, motion_code=None)))


def hang_judged(
    case: Case, lines: tuple[LineOfShip, ...], moored: MooredShip
) -> tuple[Solution, ...]:
    """Hang each line under the tension at its fairlead that it is judged by."""
    assert case.dynamics is not None
    by = case.dynamics.judged_by
    return tuple(
        solve(
            leg.line,
            height=leg.fairlead_height,
            fairlead_tension=each.judged(by),
            seabed_friction=moored.system.seabed_friction,
            anchor_height=leg.anchor_height,
        )
        for each, leg in zip(lines, moored.system.legs, strict=True)
    )


def check_hanging(case: Case, hanging: tuple[Solution, ...]) -> CheckReport:
    """Check each line as it hangs under its largest tension, by quasi-static factors."""
    assert case.system is not None
    criteria = _criteria(case)
    results: list[CheckResult] = []
    reported: list[str] = []
    for number, (solution, leg) in enumerate(zip(hanging, case.system.legs, strict=True), start=1):
        strengths = criteria.strengths(leg.line, {"extreme"})
        of_line = evaluate(
            solution,
            criteria,
            strengths,
            case.anchor,
            load_case=Message("checks.intact"),
            kind="extreme",
            place=Place(line=number),
        )
        results += of_line
        reported += of_criteria(criteria, leg.line, strengths)
    return CheckReport(case.title, tuple(results), (), tuple(dict.fromkeys(reported)))


def _remarks(
    case: Case, moored: MooredShip, drive: Excitation, rest: ShipAtRest
) -> Iterator[Message]:
    """Yield what the answer rests on, and where it does not hold."""
    breaks = breaking_warning(drive.sea(0))
    if isinstance(breaks, Message):
        yield breaks
    if rest.others:
        others = ", ".join(f"{math.degrees(each):.0f}" for each in rest.others)
        yield Message("floater.other_headings", others=others)
    yield from _of_waves(moored, _waves(drive, 0))
    yield Message("floater.quasi_static_lines")
    yield from _of_slow_motion(moored.ship)
    assert case.system is not None
    if any(case.system.force):
        given = math.hypot(*case.system.force)
        yield Message("floater.own_force", given=given / 1e3, own=math.hypot(*rest.force) / 1e3)
    yield Message("floater.intact_only")


def _judged_by(lines: tuple[LineOfShip, ...], dynamics: Dynamics) -> Iterator[Message]:
    """Yield by what the most loaded line is judged, where that is not the combined largest."""
    by = dynamics.judged_by
    most = largest(lines, lambda each: each.judged(by))
    seen, judged = most.fairlead.seen / 1e3, most.judged(by) / 1e3
    if by == "largest" or most.storm is None:
        over = [each for each in lines if each.fairlead.seen > each.fairlead.combined]
        if over:
            most = largest(over, lambda each: each.fairlead.seen - each.fairlead.combined)
            seen = most.fairlead.seen / 1e3
            yield Message("floater.seen_more", number=most.number, seen=seen, count=len(over))
        return
    storm = lasting(dynamics.duration_of_interest)
    said = {"number": most.number, "judged": judged, "seen": seen, "storm": storm}
    yield Message(f"floater.judged_{by.replace('-', '_')}", **said)


def _few_cycles(runs: tuple[ShipHistory, ...], rest: ShipAtRest) -> Iterator[Message]:
    """Yield that slow motion was too short to know its deviation."""
    count = 0
    for each in runs:
        off = np.hypot(*(each.slow[:, :2] - np.array(rest.zero)).T)
        off -= off.mean()
        count += int(((off[:-1] < 0.0) & (off[1:] >= 0.0)).sum())
    if count < _CYCLES:
        yield Message("floater.few_cycles", count=count, wanted=_CYCLES)


def _of_waves(moored: MooredShip, waves: Waves) -> Iterator[Message]:
    """Yield what drift and response in waves rest on."""
    of, ship = moored.ship.of, moored.ship
    k = wave_number(float(waves.omega[np.argmax(_density(waves))]), ship.depth)
    length = 2.0 * math.pi / k
    if of.drift_file:
        yield Message("floater.drift_of_file")
        yield from ship.remarks
    elif of.reflection is None:
        yield Message("floater.drift_above_keel")
    else:
        yield Message("floater.drift_by_reflection", part=of.reflection)
    if k * ship.depth < 0.5 * math.pi:
        yield Message("floater.shallow_drift", depth=ship.depth, length=length)
    if moored.response is not None:
        beyond = energy_beyond(moored.response.omega, waves)
        if beyond > _LEFT_OUT:
            yield Message("floater.beyond_raos", part=beyond)
        return
    yield Message("floater.closed_raos")
    if ship.ship.breadth > _WIDE * length:
        yield Message("floater.wide_hull", breadth=ship.ship.breadth, length=length)
    if of.roll_period is None:
        yield Message("floater.no_roll")
    else:
        yield Message("floater.roll_damping", part=of.roll_damping)


def _of_slow_motion(ship: ShipInWeather) -> Iterator[Message]:
    """Yield what damps slow motion, and what wind and current rest on."""
    of = ship.of
    dampings = {"surge": of.surge_damping, "sway": of.sway_damping, "yaw": of.yaw_damping}
    yield Message("floater.slow_damping", **dampings)
    if math.hypot(*ship.wind) > 0.0:
        yield Message("floater.gusts_npd" if of.gusts == "NPD" else "floater.gusts_none")
    if of.current_yaw:
        yield Message("floater.current_recalled", hull=of.current_yaw)
    elif math.hypot(*ship.current) > 0.0:
        yield Message("floater.current_amidships")


def _density(waves: Waves) -> Array:
    """Energy of the waves over the width between their neighbours, smoothed; for the peak."""
    order = np.argsort(waves.omega)
    energy = waves.amplitude[order] ** 2
    if energy.size < 20:
        return np.asarray(waves.amplitude**2)
    width = np.gradient(waves.omega[order])
    window = np.ones(9)
    smooth = np.convolve(energy, window, "same") / np.convolve(width, window, "same")
    out = np.empty_like(energy)
    out[order] = smooth
    return out


# ------------------------------------------------------------------ as a document


def ship_document(found: ShipVerification) -> dict[str, Any]:
    """Lay a ship in motion out as ``catopt verify --dynamic --json`` has it, in SI."""
    rest, dynamics = found.rest, found.case.dynamics
    assert dynamics is not None
    names = ("wind", "current", "drift")
    return {
        "runs": len(found.runs),
        "duration_s": dynamics.duration,
        "since_s": float(found.runs[0].time[0]),
        "storm_s": dynamics.duration_of_interest,
        "mean_force_N": list(rest.force),
        "mean_loads": {name: part.tolist() for name, part in zip(names, rest.parts, strict=True)},
        "rest": {"x_m": rest.place[0], "y_m": rest.place[1], "yaw_rad": rest.place[2]},
        "heading_rad": found.heading,
        "offset_m": _document(found.offset),
        "yaw_rad": _document(found.yaw),
        "lines": [
            {
                "line": each.number,
                "fairlead_tension_N": _document(each.fairlead),
                "anchor_tension_N": _document(each.anchor),
                "MBL_N": each.MBL,
                "storm": None
                if each.storm is None
                else {
                    "most_probable_tension_N": each.storm.most_probable,
                    "interval_N": [each.storm.low, each.storm.high],
                },
                "judged_tension_N": each.judged(dynamics.judged_by),
            }
            for each in found.lines
        ],
        "checks": found.checks.motion_document(),
        "remarks": [str(each) for each in found.remarks],
    }


def _document(of: Scales) -> dict[str, float]:
    return vars(of) | {"combined": of.combined}
