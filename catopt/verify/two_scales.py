"""A case's ship on its lines, on two time scales: what its lines carry, and whether they may."""

from __future__ import annotations

import itertools
import math
import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Annotated, Any, Final, TypedDict

import numpy as np

from catopt.arrays import Array
from catopt.catenary.solution import Solution
from catopt.catenary.solve import solve
from catopt.checks.criteria import Criteria, criteria_of, motion_profile
from catopt.checks.evaluation import evaluate, of_criteria
from catopt.checks.kinds import Criterion, Place, State
from catopt.checks.profiles import profiles_of
from catopt.checks.result import CheckReport, CheckResult, ChecksInMotion
from catopt.checks.system import for_line_out, lost_results, of_line_out, state_words
from catopt.errors import InputError, NoAnswerError, Problem
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
from catopt.model import Case, System
from catopt.model.dynamics import Dynamics, JudgedBy
from catopt.model.kinds import Angle, Duration, SomeForce, Strength, Time
from catopt.mooring.zero_load import zero_load_position
from catopt.records import Counted, Record
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
_SAME: Final = 1e-6
"""By which tensions at rest may differ and are the same."""
_LEFT_OUT: Final = 0.01
"""Part of the waves' energy beyond a table of RAOs from which it is remarked on."""


class InStorm(TypedDict):
    """The largest tension of a line in the storm."""

    most_probable_tension_N: SomeForce
    """N, at the fairlead, by the tail of its peaks."""
    interval_N: tuple[float, float]
    """N: its 90 % interval."""


@dataclass(frozen=True)
class LineOfShip(Record):
    """What a line of the ship carries."""

    DOCUMENT = (
        "number=line fairlead=fairlead_tension_N anchor=anchor_tension_N MBL "
        "in_storm=storm judged_tension"
    )

    number: Counted
    """Number, from 1."""
    fairlead: Scales
    """N, at the fairlead."""
    anchor: Scales
    """N, at the anchor."""
    MBL: Strength | None
    """Least of its segments, N; None where none is known."""
    storm: Extreme | None = None
    """The largest tension at the fairlead in the storm, by the tail of its peaks; None where the
    runs have too few of them."""
    judged_by: JudgedBy = "largest"

    @property
    def in_storm(self) -> Annotated[Mapping[str, Any], InStorm] | None:
        """The largest tension in the storm; None where the runs have too few peaks."""
        if self.storm is None:
            return None
        return {
            "most_probable_tension_N": self.storm.most_probable,
            "interval_N": (self.storm.low, self.storm.high),
        }

    @property
    def judged_tension(self) -> SomeForce:
        """At the fairlead, N: what the checks are held against."""
        return self.judged(self.judged_by)

    def judged(self, by: JudgedBy) -> float:
        """Tension at the fairlead that the checks are held against, N.

        What is most probable in the storm, or the upper end of its interval; by the largest values,
        and where the runs have no tail, `Scales.judged`.
        """
        if by == "largest" or self.storm is None:
            return self.fairlead.judged
        return self.storm.high if by == "upper" else self.storm.most_probable


@dataclass(frozen=True, eq=False)
class ShipWithoutLine(Record):
    """A ship that has lost a line and rests anew, in the seas of the runs with all there."""

    DOCUMENT = "missing=missing_line refusal offset=offset_m lines"

    missing: Counted
    """Line that is gone, from 1."""
    lines: tuple[LineOfShip, ...] = ()
    """The others, numbered as with all there; none without an answer."""
    hanging: tuple[Solution, ...] = ()
    """Each of them under the tension that it is judged by."""
    offset: Scales | None = None
    """m: of the origin from the zero-load position with all there."""
    refusal: str = ""
    """Why there is no answer; else empty."""

    @property
    def most_loaded(self) -> int:
        """Which of `lines`, from 0, has the largest combined tension."""
        return first_largest([each.fairlead.combined for each in self.lines])

    @property
    def hardest(self) -> LineOfShip:
        """What that line carries."""
        return self.lines[self.most_loaded]


@dataclass(frozen=True, eq=False)
class ShipVerification(Record):
    """A ship on its lines on two time scales: every run, what they come to, and the checks."""

    DOCUMENT = (
        "count=runs duration since storm rest.force=mean_force_N rest.mean_loads "
        "rest.of_document=rest heading offset=offset_m yaw=yaw_rad lines lost=lines_out "
        "report=checks remarks"
    )

    case: Case
    moored: MooredShip
    rest: ShipAtRest
    """Of the first run's waves."""
    runs: tuple[ShipHistory, ...]
    lines: tuple[LineOfShip, ...]
    """Of the mooring, in the order of the case."""
    hanging: tuple[Solution, ...]
    """Each line under the tension that it is judged by."""
    checks: CheckReport
    remarks: tuple[Message, ...]
    """What the answer rests on, and where it does not hold."""
    directions: Array
    """Of the waves of the first run, where they travel to, rad."""
    lost: tuple[ShipWithoutLine, ...] = ()
    """With a line gone, of those without which another carries more at rest in the mean weather,
    the hardest first; none of one line, or where no check is on it."""

    @property
    def count(self) -> Counted:
        """Runs that differ in their seed."""
        return len(self.runs)

    @property
    def duration(self) -> Time:
        """Of each run, s."""
        assert self.case.dynamics is not None
        return self.case.dynamics.duration

    @property
    def since(self) -> Duration:
        """From which statistics are taken, s."""
        return float(self.runs[0].time[0])

    @property
    def report(self) -> ChecksInMotion:
        """Of each line as it hangs under its largest tension, all lines there and with one gone."""
        return self.checks.in_motion

    @property
    def storm(self) -> Time:
        """For which the largest of a normal process is taken, s."""
        assert self.case.dynamics is not None
        return self.case.dynamics.duration_of_interest

    def _scales(self, slow: list[Array], whole: list[Array]) -> Scales:
        return scales_of(slow, whole, self.runs[0].time, self.storm)

    @cached_property
    def offset(self) -> Scales:
        """m: of the origin from the zero-load position."""
        return _offset(self.runs, self.rest.zero, self.storm)

    @cached_property
    def heading(self) -> Angle:
        """Mean yaw in motion, rad."""
        return float(np.mean([each.slow[:, 2] for each in self.runs]))

    @cached_property
    def yaw(self) -> Scales:
        """rad: beside its mean, to the side where it is larger."""
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

    @property
    def hardest_loss(self) -> ShipWithoutLine | None:
        """The loss that leaves the largest combined tension in another line; None without any."""
        known = [each for each in self.lost if each.lines]
        return largest(known, lambda each: each.hardest.fairlead.combined) if known else None


def _offset(runs: tuple[ShipHistory, ...], zero: tuple[float, float], storm: float) -> Scales:
    def off(path: Array) -> Array:
        return np.asarray(np.hypot(*(path[:, :2] - np.array(zero)).T))

    slow, whole = [off(each.slow) for each in runs], [off(each.whole) for each in runs]
    return scales_of(slow, whole, runs[0].time, storm)


def _lines(
    moored: MooredShip, numbers: Sequence[int], runs: tuple[ShipHistory, ...], dynamics: Dynamics
) -> Iterator[LineOfShip]:
    storm, by = dynamics.duration_of_interest, dynamics.judged_by
    for k, (number, leg) in enumerate(zip(numbers, moored.system.legs, strict=True)):
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
        yield LineOfShip(number, fairlead, anchor, min(known, default=None), extreme, by)


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
    dynamics, legs = drive.dynamics, moored.system.legs
    criteria, damaged = _criteria(case), _line_out_criteria(case)
    for line in {leg.line for leg in legs}:
        criteria.strengths(line, {"extreme"}, _states(damaged))
    rest = moored.at_rest(_waves(drive, 0))
    missing, needless = _losses(moored, rest) if damaged else ((), ())
    tell = _counted(progress, dynamics.runs * (1 + len(missing)))
    histories = _histories(moored, drive, tell)
    lines = tuple(_lines(moored, range(1, len(legs) + 1), histories, dynamics))
    lost = tuple(_without(case, moored, drive, number, tell) for number in missing)
    asked = case.system is not None and case.system.judged_line_out
    remarks = (
        *_judged_by(lines, dynamics),
        *_few_cycles(histories, rest),
        *_remarks(case, moored, drive, rest),
        *_of_losses(lost, needless),
        *(
            of_line_out(criteria, damaged, len(legs))
            if asked or len(legs) == 1
            else (Message("checks.line_out_not_asked"),)
        ),
    )
    hanging = hang_judged(case, lines, moored)
    checks, directions = check_hanging(case, hanging, lost), _waves(drive, 0).direction
    return ShipVerification(
        case, moored, rest, histories, lines, hanging, checks, remarks, directions, lost
    )


def _counted(progress: Progress | None, total: int) -> Callable[[], None]:
    """Count runs that are done, of how many."""
    done = itertools.count(1)

    def tell() -> None:
        if progress is not None:
            progress(next(done), total)

    return tell


def _histories(
    moored: MooredShip, drive: Excitation, tell: Callable[[], None]
) -> tuple[ShipHistory, ...]:
    """Run a ship in every seed, from where she rests in it."""
    step, dynamics = sample_step(_waves(drive, 0)), drive.dynamics

    def run(number: int) -> ShipHistory:
        waves = _waves(drive, number)
        seed = 0 if drive.case.waves is None else drive.case.waves.seed
        generator = np.random.default_rng([seed, number, 1])
        return moored.run(waves, dynamics.duration, drive.ramp, generator, step=step)

    # The first run by itself: whatever has to be compiled then is.
    found = [run(0)]
    tell()
    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        later = pool.map if dynamics.runs > 2 else map
        for each in later(run, range(1, dynamics.runs)):
            found.append(each)
            tell()
    return tuple(found)


# ------------------------------------------------------------------ with a line out


def run_without(
    case: Case, number: int, *, ship: ShipInWeather | None = None
) -> tuple[ShipWithoutLine, MooredShip]:
    """Run the ship of a case without one of its lines, from 1, alone; as `verify_ship`."""
    moored, drive = moored_ship(case, ship)
    return _without(case, moored, drive, number, _counted(None, 0)), moored


def _without(
    case: Case, moored: MooredShip, drive: Excitation, number: int, tell: Callable[[], None]
) -> ShipWithoutLine:
    left = replace(moored, system=moored.system.without([number - 1]))
    numbers = [each for each in range(1, len(moored.system.legs) + 1) if each != number]
    storm, neutral = drive.dynamics.duration_of_interest, moored.zero_load.neutral
    try:
        histories = _histories(left, drive, tell)
        lines = tuple(_lines(left, numbers, histories, drive.dynamics))
        hanging = hang_judged(case, lines, left)
    except NoAnswerError as error:
        return ShipWithoutLine(number, refusal=error.args[0])
    offset = _offset(histories, (neutral.x, neutral.y), storm)
    return ShipWithoutLine(number, lines, hanging, offset)


def _losses(moored: MooredShip, rest: ShipAtRest) -> tuple[tuple[int, ...], tuple[int, ...]]:
    """Find the lines without which another carries more at rest in the mean weather; the others.

    By number, the one whose loss is the hardest first.
    """
    moment = float(np.sum(rest.parts, axis=0)[2]) if moored.system.turns else 0.0

    def most(of: System) -> float:
        try:
            _, lines = zero_load_position(of).under(rest.force, moment if of.turns else 0.0)
        except NoAnswerError:
            return math.inf
        return max(map(math.hypot, lines.H, lines.V))

    whole, count = most(moored.system), len(moored.system.legs)
    left = {k + 1: most(moored.system.without([k])) for k in range(count)}
    harder = [number for number, each in left.items() if each > whole * (1.0 + _SAME)]
    order = sorted(harder, key=lambda number: -left[number])
    return tuple(order), tuple(number for number in left if number not in harder)


def _line_out_criteria(case: Case) -> tuple[Criterion, ...]:
    """List the criteria for one line out; none where the case does not ask for it."""
    assert case.system is not None
    if len(case.system.legs) == 1 or not case.system.judged_line_out:
        return ()
    return for_line_out(_criteria(case), len(case.system.legs))


def _states(damaged: tuple[Criterion, ...]) -> tuple[State, ...]:
    return ("intact", "one_line_out") if damaged else ("intact",)


def _of_losses(lost: tuple[ShipWithoutLine, ...], needless: tuple[int, ...]) -> Iterator[Message]:
    """Yield what was run with a line out, and what was not."""
    if lost:
        yield Message("floater.lines_out", numbers=", ".join(f"{each.missing}" for each in lost))
        for each in lost:
            if each.refusal:
                yield Message("floater.line_out_refused", number=each.missing, why=each.refusal)
    if needless:
        yield Message("floater.lines_out_needless", numbers=", ".join(map(str, needless)))


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


def check_hanging(
    case: Case, hanging: tuple[Solution, ...], lost: tuple[ShipWithoutLine, ...] = ()
) -> CheckReport:
    """Check each line as it hangs under its largest tension, by quasi-static factors.

    With all there, unless none hang, and by the factors for one line out with each that was lost.
    """
    assert case.system is not None
    legs, criteria, damaged = case.system.legs, _criteria(case), _line_out_criteria(case)
    results: list[CheckResult] = []
    reported: list[str] = []
    known = {
        line: criteria.strengths(line, {"extreme"}, _states(damaged))
        for line in {leg.line for leg in legs}
    }

    def check(place: Place, numbers: Sequence[int], solutions: tuple[Solution, ...]) -> None:
        for number, solution in zip(numbers, solutions, strict=True):
            results.extend(
                evaluate(
                    solution,
                    criteria,
                    known[legs[number - 1].line],
                    case.anchor,
                    load_case=state_words(place),
                    kind="extreme",
                    place=replace(place, line=number),
                )
            )

    check(Place(), range(1, len(hanging) + 1), hanging)
    for each in lost:
        place = Place("one_line_out", missing=each.missing)
        if each.refusal:
            results += lost_results(place, each.refusal, damaged)
        check(place, [line.number for line in each.lines], each.hanging)
    for line, strengths in known.items():
        reported += of_criteria(criteria, line, strengths)
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
