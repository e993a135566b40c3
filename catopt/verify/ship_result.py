"""What a ship on her lines came to on two time scales, with all lines there and with one gone."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Annotated, Any, TypedDict

import numpy as np

from catopt.arrays import Array
from catopt.catenary.solution import Solution
from catopt.checks.result import CheckReport, ChecksInMotion
from catopt.fem.extremes import Extreme
from catopt.floater.two_scales import MooredShip, Scales, ShipAtRest, ShipHistory, scales_of
from catopt.model import Case
from catopt.model.dynamics import JudgedBy
from catopt.model.kinds import Angle, Duration, SomeForce, Strength, Time
from catopt.records import Counted, Record
from catopt.ties import first_largest, largest
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
