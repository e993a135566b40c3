"""A mooring that was run in motion: how, which lines were looked at, and what came of it."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from typing import Literal, NamedTuple

from catopt.catalogue.family import chain_words
from catopt.checks.kinds import CHECK_KINDS, ratio_exceedance
from catopt.checks.result import CheckReport, CheckResult
from catopt.design.neighbours import NoFeasibleDesignError
from catopt.design.result import NearMiss
from catopt.largest import largest
from catopt.loads.ship_ranges import Cause
from catopt.model import Case, Line
from catopt.model.dynamics import JudgedBy
from catopt.model.kinds import (
    Angle,
    Factor,
    Findings,
    Force,
    Height,
    Length,
    Positive,
    SomeForce,
    SomeMass,
    Time,
)
from catopt.records import Counted as FromOne
from catopt.records import FromZero, Record, within
from catopt.sizing.kinds import usual
from catopt.verify.convergence_check import Change
from catopt.words import Message, Several

LEAST_DURATION = 60.0
"""s, of a run of which a tenth is its ramp."""


class Sea(NamedTuple):
    """A sea that lines are run in."""

    height: float  # significant, m
    period: float  # of its peak, s


@dataclass(frozen=True)
class RunsAfloat:
    """How the lines of a sizing are run with their buoy or ship."""

    seeds: FromOne = field(default_factory=lambda: usual("seeds"))
    """Runs of each load case."""
    duration: Time = field(default_factory=lambda: usual("run_time"))
    """Of one run, with its ramp."""
    elements: int = 20  # bars of the line; a ship's lines are run by closed form
    judged_by: JudgedBy = "upper"
    """What the checks are held against: largest values of the runs, most probable maxima of the
    storm, or the upper ends of their intervals."""
    # How far the sinker may slide in the storm, m; None: `afloat.MOST_SLIDE` where the code has no
    # factors for dynamic analysis, else its factor on sliding holds
    max_slide: float | None = None
    other_lengths: int = 0  # of the recommended size, that are run beside it
    periods: tuple[Time, ...] = ()
    """Of the peak of the seas that every line is run in; empty: that of the place alone."""
    heights: tuple[Length, ...] = ()
    """Significant, of these seas; empty: all have that of the place."""
    centre_of_gravity: float | None = None  # of a buoy, above the bottom of its hull, m
    # by the fast judgement, in seconds: `catopt.sizing.quick`; by how much it takes tensions larger
    # than its runs say, and a sinker heavier than what stays in them
    quick: bool = False
    margin: float = 1.0
    sinker_margin: float = 1.0
    max_heel: Angle | None = None  # mean heel of a buoy that is allowed, rad; None: not judged
    # of a buoy: of what else damps its pitch than waves and drag, as a part of critical
    pitch_damping: float | None = None

    def __post_init__(self) -> None:
        found = Findings("RunsAfloat")
        found.count("seeds", self.seeds)
        found.count("other_lengths", self.other_lengths)
        found.number("duration", self.duration, "s", at_least=LEAST_DURATION, at_most=36000.0)
        found.count("elements", self.elements)
        found.numbers(self, "m", "max_slide", above=0.0)
        found.numbers(self, "m", "centre_of_gravity")
        for k, each in enumerate(self.periods):
            found.number(f"periods[{k}]", each, "s", above=0.0, at_most=30.0)
        for k, each in enumerate(self.heights):
            found.number(f"heights[{k}]", each, "m", above=0.0)
        if self.heights and len(self.heights) != len(self.periods):
            allowed = Message("refused.height_each_period", periods=len(self.periods))
            found.add("heights", f"{len(self.heights)}", allowed)
        found.raise_if_any()

    def seas(self, height: float, period: float) -> tuple[Sea, ...]:
        """List the seas that every line is run in, at a place with a significant height, m."""
        if not self.periods:
            return (Sea(height, period),)
        heights = self.heights or (height,) * len(self.periods)
        return tuple(map(Sea, heights, self.periods))


@dataclass(frozen=True)
class LineTried(Record):
    """A line that was run in motion."""

    DOCUMENT = "component diameter=nominal_diameter_m length mass runs passes words=fails"

    component: str
    """Family and grade."""
    diameter: Length
    """Nominal."""
    length: Length
    """Unstretched."""
    mass: SomeMass
    """In air."""
    runs: FromZero
    """Made of it: it is left at the first load case that fails."""
    failing: tuple[CheckResult, ...]  # the worst first
    reason: str = ""  # why a run has no answer; else empty

    @classmethod
    def of(
        cls, line: Line, runs: int, failing: tuple[CheckResult, ...], reason: str = ""
    ) -> LineTried:
        """Say which line was tried, and what it fails."""
        segment = line.segments[0]
        size, mass = segment.nominal_diameter or 0.0, line.mass or 0.0
        return cls(segment.component, size, line.length, mass, runs, failing, reason)

    @property
    def passes(self) -> bool:
        """Whether every check is passed in motion."""
        return not self.failing and not self.reason

    def fails_by_margin(self, margin: float) -> bool:
        """Whether it fails by no more than the margin that its runs were given."""
        small = all(each.demand <= margin * each.capacity for each in self.failing)
        return bool(self.failing) and small

    @property
    def words(self) -> str:
        """The check that it fails by the most, or why a run has no answer; empty if it passes."""
        return self.reason or (self.failing[0].in_case if self.failing else "")


class Storm(NamedTuple):
    """The tension at the fairlead in the load case where it is largest, of all runs there."""

    load_case: str
    """That of the largest tension."""
    largest: SomeForce
    """At the fairlead, of the runs of every load case."""
    most_probable: SomeForce | None
    """At the fairlead, in the storm; None where the runs have too few peaks."""
    low: float | None  # interval of it, N
    high: float | None
    at_rest: SomeForce
    """At the fairlead, under the steady load of that load case."""

    @property
    def interval(self) -> tuple[Force, Force] | None:
        """Of the most probable tension, 90 %."""
        return None if self.low is None or self.high is None else (self.low, self.high)

    @property
    def tension(self) -> float:
        """What the storm comes to, N."""
        return self.largest if self.most_probable is None else self.most_probable


STORM = (
    "load_case largest=largest_tension_N most_probable=most_probable_tension_N interval "
    "at_rest=tension_at_rest_N"
)
"""What a document has of one."""


@dataclass(frozen=True)
class SinkerSlide(Record):
    """How far a sinker slides in the storm: a block on its soil under the pull of the runs."""

    DOCUMENT = "mass expected upper"

    mass: SomeMass
    """In air."""
    expected: Height
    """In the storm, by the slides of all runs."""
    upper: Height
    """Upper end of its interval, 90 %, which the check is held against."""


@dataclass(frozen=True)
class LengthRun(Record):
    """What a length of the recommended size comes to in motion, every seed of it run."""

    DOCUMENT = f"{within('tried', LineTried.DOCUMENT)} storm({STORM}) sinker=sinker_mass_kg"

    tried: LineTried
    storm: Storm | None
    """The tension at the fairlead; None where a run has no answer."""
    sinker: SomeMass | None
    """The least that stays, or the heaviest that is cast; None where a run has no answer."""


@dataclass(frozen=True)
class TightestSea(Record):
    """The check of a kind that is nearest to its limit, and the sea in which it is."""

    DOCUMENT = "check.kind check.load_case height period check.utilisation"

    check: CheckResult
    height: Length
    """Significant, of the waves there."""
    period: Time
    """Of the waves' peak there."""


def tightest_seas(found: Iterable[tuple[CheckResult, Sea]]) -> tuple[TightestSea, ...]:
    """Find what governs each kind of check, with the sea that each result is of."""
    every = [TightestSea(check, *sea) for check, sea in found]
    kinds = [kind for kind in CHECK_KINDS if any(each.check.kind == kind for each in every)]
    return tuple(
        largest([e for e in every if e.check.kind == kind], lambda each: each.check.exceedance)
        for kind in kinds
    )


def sea_of(case: Case) -> Sea:
    """Return the sea that a case is run in."""
    assert case.waves is not None
    return Sea(case.waves.height or 0.0, case.waves.period or 0.0)


def with_margin(check: CheckResult, how: RunsAfloat) -> CheckResult:
    """Take what hangs on few peaks as much larger as a way of running lines asks for."""
    if how.margin == 1.0 or check.kind not in ("tension", "sliding"):
        return check
    demand = how.margin * check.demand
    beyond = ratio_exceedance(demand, check.capacity)
    return replace(check, demand=demand, exceedance=beyond)


def in_sea(load_case: str, how: RunsAfloat, sea: Sea) -> str:
    """Name a load case with its waves, where it is run in several seas."""
    if len(how.periods) < 2:
        return load_case
    key = "sizing.in_sea_of_height" if how.heights else "sizing.in_sea"
    return Message(key, load_case=load_case, **sea._asdict())


class Counted(NamedTuple):
    """What became of the lines that were looked at: sizes by lengths."""

    considered: FromOne
    """Sizes by lengths."""
    at_rest: FromZero | None
    """That fail at rest without any allowance for motion; None where they were not counted, with a
    ship."""
    excluded: FromZero
    """That were needless to run."""
    run: FromOne
    """That were run in motion."""
    runs: FromOne
    """That this took."""

    @property
    def words(self) -> Message:
        """Say it."""
        key = "sizing.lines_run" if self.at_rest is not None else "sizing.ship_lines_run"
        return Message(key, **self._asdict())


@dataclass(frozen=True)
class Reach(Record):
    """Tension of the most loaded line over the range of one input, others in the middle of theirs.

    None where a line does not reach.
    """

    DOCUMENT = "cause favourable=favourable_tension_N unfavourable=unfavourable_tension_N"

    cause: Cause
    """Input."""
    favourable: SomeForce | None
    """N, at the fairlead, most probable in the storm."""
    unfavourable: SomeForce | None
    """N, likewise; the verdict has every input at this end."""


@dataclass(frozen=True)
class Band(Record):
    """Tensions in the load case of the largest, by the same seas and gusts throughout."""

    DOCUMENT = "middle=middle_tension_N reaches"

    middle: SomeForce | None
    """N, at the fairlead: every input in the middle of its range; None where a line does not
    reach."""
    reaches: tuple[Reach, ...]
    """Of each input alone."""


@dataclass(frozen=True)
class InMotion(Record):
    """What the recommended line came to in runs with its buoy or ship afloat.

    None where it is sized at rest alone.
    """

    DOCUMENT = (
        "how.seeds how.duration how.judged_by elements case.dynamics.duration_of_interest "
        f"{within('storm', STORM)} factor allowance heel? mean_heel~ slides~ proof~ changes~ "
        "checks.results=checks "
        "checks.nearest=governing how.periods~ how.heights~ seas~ directions~ "
        "counted=lines(considered at_rest excluded run runs) tried fast? by_length "
        "checks.warnings band? own? basis?"
    )

    how: RunsAfloat
    case: Case  # that was run: `catopt verify --dynamic` runs it again
    checks: CheckReport
    storm: Storm
    allowance: Factor
    """For motion, that a sizing at rest has and this replaces."""
    counted: Counted
    """How many lines were looked at, and what became of them."""
    tried: tuple[LineTried, ...]
    """The lines that were run, in their order."""
    by_length: tuple[LengthRun, ...] = ()
    """Lengths of the recommended size that were run beside it, and itself, the shortest first;
    empty where none was asked for."""
    load_cases: int = 1  # that every line was run in
    directions: FromOne = 1
    """Sets of directions of wind, current and waves that every line was run in."""
    # the next shorter and the next thinner line, which fail; of a ship
    less: tuple[LineTried, ...] = ()
    seas: tuple[TightestSea, ...] = ()
    """What decides each kind of check, where periods are given."""
    heel: Angle | None = None
    """Largest heel of the buoy in its runs; None of a ship."""
    own: LineTried | None = None
    """Of a ship on one line: a line of the size of her own cable; None where it was not run."""
    mean_heel: Angle | None = None
    """The largest mean of a load case; None of a ship."""
    slides: tuple[SinkerSlide, ...] = ()
    """Of the sinker and of the sizes beside it that were looked at, the lighter first; empty where
    it may not slide."""
    basis: tuple[str, ...] = ()
    """What the runs of a ship stand on, with numbers; empty of a buoy."""
    band: Band | None = None
    """Of a ship, over what is known of her motion to no better than a range; None of a buoy."""
    proof: Literal["converged", "not converged", "not proven"] = "not proven"
    """Whether its runs come to the same at half the step and with twice the bars."""
    changes: tuple[Change, ...] = ()
    """Largest of each judged value there, by all ways together; empty where nothing ran again."""
    fast: tuple[LineTried, ...] = ()
    """Lines that the fast judgement ran before; of the nearest, which fails by its margin alone,
    the size was run in full. Empty where its answer stands, or where it was not asked."""

    @property
    def own_slide(self) -> SinkerSlide | None:
        """That of its sinker; None where it may not slide."""
        own = None if self.case.anchor is None else self.case.anchor.mass
        return next((each for each in self.slides if each.mass == own), None)

    @property
    def worst_change(self) -> Change | None:
        """Of a tension the largest; None where nothing was run again."""
        of = [each for each in self.changes if each.quantity.endswith("tension")]
        return largest(of, lambda each: each.size) if of else None

    @property
    def is_of_ship(self) -> bool:
        """Whether lines were run with a ship, by closed form."""
        return self.case.several_lines

    @property
    def elements(self) -> FromOne | None:
        """Bars of the line; None where it is run by closed form, with a ship."""
        return None if self.is_of_ship else self.how.elements

    @property
    def factor(self) -> Positive:
        """Motion's own: the storm's tension over that at rest, as an allowance would be."""
        return self.storm.tension / self.storm.at_rest


class NoLineInMotionError(NoFeasibleDesignError):
    """Lines pass at rest, and none that was run passes in motion.

    `tried` has every line with what it came to, of which the one is named that fails by the least.
    """

    def __init__(self, tried: Iterable[tuple[Line, LineTried]], counted: Counted) -> None:
        def miss(one: tuple[Line, LineTried]) -> float:
            failing = one[1].failing
            return failing[0].exceedance if failing else math.inf

        self.counted, self.in_motion = counted, counted.words
        line, nearest = min(tried, key=miss)
        chain = chain_words(line.segments[0].component, line.segments[0].nominal_diameter)
        misses = [
            Message("sizing.miss_in_motion", check=each.in_case, times=each.demand / each.capacity)
            if each.capacity > 0.0
            else each.in_case
            for each in nearest.failing
        ]
        said = [
            Message("sizing.none_in_motion"),
            self.in_motion,
            Message("sizing.nearest_in_motion", chain=chain, length=line.length),
            *misses,
            *([nearest.reason] if nearest.reason else []),
        ]
        super().__init__(Several(said, "\n"), NearMiss(line, nearest.failing, nearest.reason))
