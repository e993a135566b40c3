"""What a ship on her lines came to on two time scales, with all lines there and with one gone."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Annotated, Any, Final, TypedDict

import numpy as np

from catopt.arrays import Array
from catopt.catenary.solution import Solution
from catopt.checks.result import CheckReport, ChecksInMotion
from catopt.fem.extremes import Extreme
from catopt.floater.scales import Scales, scales_of
from catopt.floater.ship_in_weather import ShipInWeather
from catopt.floater.slow_drift import SLOW_STEP
from catopt.floater.two_scales import (
    MooredShip,
    ShipAtRest,
    ShipHistory,
)
from catopt.hydro.coefficients import FREEDOMS
from catopt.largest import first_largest, largest
from catopt.model import Case, Motion
from catopt.model.dynamics import Dynamics, JudgedBy
from catopt.model.kinds import Angle, Duration, SomeForce, Strength, Time
from catopt.records import Counted, Record
from catopt.units import lasting
from catopt.verify.convergence_check import Change
from catopt.verify.motion_file import energy_beyond
from catopt.waves import Sea, Waves, breaking_warning
from catopt.waves.random_surface import wave_number
from catopt.words import Message


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
    is_transient: bool = False
    """Whether another line parts in its runs: it is then judged by what these reach alone."""

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
        if self.is_transient:
            return self.fairlead.seen
        if by == "largest" or self.storm is None:
            return self.fairlead.judged
        return self.storm.high if by == "upper" else self.storm.most_probable


@dataclass(frozen=True)
class Swing(Record):
    """How a ship swings in the mean weather alone, whether that grows or dies away."""

    DOCUMENT = "rate=growth_rate_per_s period yaw=yaw_rad? tension=tension_N?"

    rate: float
    """1/s, of the linearised motion that dies away the slowest: above 0 it grows."""
    period: Time | None
    """Of that motion; of a swing that has grown its own; None: it does not swing."""
    yaw: Angle | None = None
    """rad: largest, of a swing that has grown; None of one that dies away."""
    tension: SomeForce | None = None
    """N: largest at a fairlead in it, likewise."""

    @property
    def grows(self) -> bool:
        """Whether the ship does not stay where she would rest."""
        return self.rate > 0.0

    @property
    def words(self) -> Message:
        """Say it."""
        if not self.grows:
            half = math.log(2.0) / -self.rate / 60.0 if self.rate else math.inf
            return Message("floater.does_not_swing", half=half)
        if self.yaw is None or self.tension is None or self.period is None:
            return Message("floater.swings_not_measured", rate=60.0 * self.rate)
        said = {"yaw": math.degrees(self.yaw), "tension": self.tension / 1e3}
        return Message("floater.swings", period=self.period / 60.0, **said)


@dataclass(frozen=True, eq=False)
class ShipWithoutLine(Record):
    """A ship that has lost a line and rests anew, in the seas of the runs with all there."""

    DOCUMENT = "missing=missing_line refusal offset=offset_m lines parted=parted_at_s?"

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
    parted: tuple[float, ...] = ()
    """s: when it parts in each run in which it does; empty: it is gone from the start."""

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
        "report=checks change swing transient? remarks"
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
    swing: Swing
    """In the mean weather alone."""
    lost: tuple[ShipWithoutLine, ...] = ()
    """With a line gone, of those without which another carries more at rest in the mean weather,
    the hardest first; none of one line, or where no check is on it."""
    change: Change | None = None
    """Of the largest tension at half the step; None where that was not run."""
    transient: ShipWithoutLine | None = None
    """The runs once more, with a line that parts in them, and from then on; None without one."""

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
        return offset_of(self.runs, self.rest.zero, self.storm)

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


def offset_of(runs: tuple[ShipHistory, ...], zero: tuple[float, float], storm: float) -> Scales:
    """Take the way of the origin from a position over all runs, m."""

    def off(path: Array) -> Array:
        return np.asarray(np.hypot(*(path[:, :2] - np.array(zero)).T))

    slow, whole = [off(each.slow) for each in runs], [off(each.whole) for each in runs]
    return scales_of(slow, whole, runs[0].time, storm)


_WIDE: Final = 0.2
"""Breadth over the wave length above which a hull changes the waves."""
_CYCLES: Final = 50
"""Slow cycles from which a deviation is known to some 10 %."""


def remarks_of(case: Case, moored: MooredShip, sea: Sea, rest: ShipAtRest) -> Iterator[Message]:
    """Yield what the answer rests on, and where it does not hold."""
    waves = sea.waves
    assert waves is not None
    breaks = breaking_warning(sea)
    if isinstance(breaks, Message):
        yield breaks
    if rest.others:
        others = ", ".join(f"{math.degrees(each):.0f}" for each in rest.others)
        yield Message("floater.other_headings", others=others)
    yield from _of_waves(moored, waves)
    yield Message("floater.quasi_static_lines")
    yield from _of_slow_motion(moored.ship)
    if any(case.own_system.force):
        given = math.hypot(*case.own_system.force)
        yield Message("floater.own_force", given=given / 1e3, own=math.hypot(*rest.force) / 1e3)


def governing_words(lines: tuple[LineOfShip, ...], dynamics: Dynamics) -> Iterator[Message]:
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


def slow_cycles(runs: tuple[ShipHistory, ...], rest: ShipAtRest) -> int:
    """Count how often the slow way from rest rises through its mean in all runs."""
    count = 0
    for each in runs:
        off = np.hypot(*(each.slow[:, :2] - np.array(rest.zero)).T)
        off -= off.mean()
        count += int(((off[:-1] < 0.0) & (off[1:] >= 0.0)).sum())
    return count


def few_cycles(count: int) -> Iterator[Message]:
    """Yield that slow motion was too short to know its deviation."""
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
        yield Message("floater.drift_by_form")
    else:
        yield Message("floater.drift_by_reflection", part=of.reflection)
    if k * ship.depth < 0.5 * math.pi:
        yield Message("floater.shallow_drift", depth=ship.depth, length=length)
    if moored.response is not None:
        if beyond := energy_beyond(moored.response.omega, waves):
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
        yield from ship.scaled
        yield Message("floater.gusts_npd" if of.gusts == "NPD" else "floater.gusts_none")
    if math.hypot(*ship.current) == 0.0:
        return
    match ship.turned_by:
        case "":
            yield Message("floater.current_of_tables")
        case "Clarke-lever":
            yield Message("floater.current_by_hull", lever=ship.derivatives.lever)
        case _:
            yield Message("floater.current_recalled", hull=ship.turned_by)


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


RAOS: Final = "ship_raos.csv"
DRIFT: Final = "ship_drift.csv"
LONGEST: Final = 1200.0
"""s of the run that the truss model is given: it takes minutes of processor a minute."""
_AROUND: Final = math.radians(5.0)
"""Between headings, and beyond those of the waves."""


def led_case(found: ShipVerification) -> Case:
    """Make the case of its lines in motion, led by RAOs and drift of the first run.

    Its files are those of `raos_csv` and `drift_csv`, by the names `RAOS` and `DRIFT`; its mean
    load is that of the weather, its waves are the same. The slow yaw is not in it.
    """
    case, rest = found.case, found.rest
    assert case.dynamics is not None
    moment = float(np.sum(rest.parts, axis=0)[2]) if case.own_system.turns else 0.0
    _, reference, crest = found.moored.raos
    motion = Motion(
        rao_file=RAOS,
        rao_phase="lag",
        rao_reference=(*_turned(found, reference[0], reference[1]), reference[2]),
        rao_rotation="rad/m",
        rao_per="amplitude",
        rao_crest=_turned(found, crest[0], crest[1]),
        drift_file=DRIFT,
    )
    duration = min(case.dynamics.duration, LONGEST)
    ramp = case.dynamics.ramp if case.dynamics.ramp and case.dynamics.ramp < duration else None
    return replace(
        case,
        system=replace(case.own_system, force=rest.force, moment=moment),
        floater=None,
        motion=motion,
        dynamics=replace(case.dynamics, duration=duration, ramp=ramp, runs=1),
    )


def _axis(found: ShipVerification) -> float:
    """Angle from the axes of the lines' body at rest to the ship's: of one that turns freely."""
    return 0.0 if found.moored.system.turns else found.rest.place[2]


def _turned(found: ShipVerification, x: float, y: float) -> tuple[float, float]:
    turned = complex(x, y) * np.exp(1j * _axis(found))
    return float(turned.real), float(turned.imag)


def raos_csv(found: ShipVerification) -> str:
    """Tabulate the ship's response around the headings of the waves, in the axes of the lines."""
    answer, _, _ = found.moored.raos
    yaw, axis = found.rest.place[2], _axis(found)
    seen = found.directions - yaw
    low, high = float(seen.min()) - _AROUND, float(seen.max()) + _AROUND
    count = max(3, math.ceil((high - low) / _AROUND) + 1)
    omega = answer.omega
    names = [f"{name} ({'m/m' if k < 3 else 'rad/m'})" for k, name in enumerate(FREEDOMS)]
    names += [f"{name}_phase (deg)" for name in FREEDOMS]
    lines = [",".join(["heading (deg)", "frequency (rad/s)", *names])]
    for heading in np.linspace(low, high, count).tolist():
        six = answer.at("response", omega, np.full(omega.size, heading))
        cosine, sine = math.cos(axis), math.sin(axis)
        for first in (0, 3):  # ways, and turns, along x and y
            a, b = six[:, first].copy(), six[:, first + 1].copy()
            six[:, first], six[:, first + 1] = a * cosine - b * sine, a * sine + b * cosine
        for w, row in zip(omega.tolist(), six, strict=True):
            cells = [math.degrees(heading + axis), w]
            cells += [*np.abs(row).tolist(), *np.degrees(np.angle(row)).tolist()]
            lines.append(",".join(f"{each:.8g}" for each in cells))
    return "\n".join(lines) + "\n"


def drift_csv(found: ShipVerification) -> str:
    """Tabulate the slow motion of the first run from where it rests."""
    course, rest = found.runs[0].course, found.rest.place
    lines = ["t (s),x (m),y (m)"]
    for n, (x, y, _) in enumerate(course.tolist()):
        lines.append(f"{n * SLOW_STEP:g},{x - rest[0]:.9g},{y - rest[1]:.9g}")
    return "\n".join(lines) + "\n"
