"""A mooring that was run in motion: how, which lines were looked at, and what came of it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from catopt.checks.kinds import CHECK_KINDS
from catopt.checks.result import CheckReport, CheckResult
from catopt.design.neighbours import NoFeasibleDesignError
from catopt.design.result import NearMiss
from catopt.documents import figures
from catopt.model import Case
from catopt.model.dynamics import JudgedBy
from catopt.model.kinds import Findings
from catopt.sizing.kinds import usual
from catopt.ties import largest
from catopt.words import Message, Several

LEAST_DURATION = 60.0
"""s, of a run of which a tenth is its ramp."""


@dataclass(frozen=True)
class RunsAfloat:
    """How the lines of a sizing are run with their buoy or ship."""

    seeds: int = field(default_factory=lambda: usual("seeds"))  # runs of each load case
    duration: float = field(default_factory=lambda: usual("run_time"))  # of one, with its ramp, s
    elements: int = 20  # bars of the line; a ship's lines are run by closed form
    judged_by: JudgedBy = "upper"  # what the checks are held against
    # How far the sinker may slide in the storm, m; None: `afloat.MOST_SLIDE` where the code has no
    # factors for dynamic analysis, else its factor on sliding holds
    max_slide: float | None = None
    other_lengths: int = 0  # of the recommended size, that are run beside it
    # Of the peak of the seas that every line is run in, of one height, s; none: that of the place
    periods: tuple[float, ...] = ()

    def __post_init__(self) -> None:
        found = Findings("RunsAfloat")
        found.count("seeds", self.seeds)
        found.count("other_lengths", self.other_lengths)
        found.number("duration", self.duration, "s", at_least=LEAST_DURATION, at_most=36000.0)
        found.count("elements", self.elements)
        found.numbers(self, "m", "max_slide", above=0.0)
        for k, each in enumerate(self.periods):
            found.number(f"periods[{k}]", each, "s", above=0.0, at_most=30.0)
        found.raise_if_any()


@dataclass(frozen=True)
class LineTried:
    """A line that was run in motion."""

    component: str
    diameter: float  # nominal, m
    length: float  # m
    mass: float  # in air, kg
    runs: int  # made of it: it is left at the first load case that fails
    failing: tuple[CheckResult, ...]  # the worst first
    reason: str = ""  # why a run has no answer; else empty

    @property
    def passes(self) -> bool:
        """Whether every check is passed in motion."""
        return not self.failing and not self.reason

    @property
    def words(self) -> str:
        """The check that it fails by the most, or why it has no answer; empty if it passes."""
        return self.reason or (self.failing[0].in_case if self.failing else "")


class Storm(NamedTuple):
    """The tension at the fairlead in the load case where it is largest, of all runs there."""

    load_case: str
    largest: float  # of the runs of every load case, N
    most_probable: float | None  # in the storm, N; None where the runs have too few peaks
    low: float | None  # interval of it, N
    high: float | None
    at_rest: float  # under the steady load of that load case, N

    @property
    def tension(self) -> float:
        """What the storm comes to, N."""
        return self.largest if self.most_probable is None else self.most_probable


class LengthRun(NamedTuple):
    """What a length of the recommended size comes to in motion, every seed of it run."""

    tried: LineTried
    storm: Storm | None  # None where a run has no answer
    sinker: float | None  # kg: the least that stays, or the heaviest


class TightestSea(NamedTuple):
    """The check of a kind that is nearest to its limit, and the period of the waves' peak there."""

    check: CheckResult
    period: float  # s


def tightest_seas(found: Iterable[tuple[CheckResult, float]]) -> tuple[TightestSea, ...]:
    """Find what governs each kind of check, with the peak period, s, that each result is of."""
    every = [TightestSea(*each) for each in found]
    kinds = [kind for kind in CHECK_KINDS if any(each.check.kind == kind for each in every)]
    return tuple(
        largest([e for e in every if e.check.kind == kind], lambda each: each.check.exceedance)
        for kind in kinds
    )


def in_sea(load_case: str, how: RunsAfloat, period: float) -> str:
    """Name a load case with the period of its waves, where it is run in several seas."""
    if len(how.periods) < 2:
        return load_case
    return Message("sizing.in_sea", load_case=load_case, period=period)


class Counted(NamedTuple):
    """What became of the lines that were looked at: sizes by lengths."""

    considered: int
    # fail at rest already, without any allowance for motion; None where that was not counted
    at_rest: int | None
    excluded: int  # needless to run: see `catopt.sizing.motion_search` and `ship_search`
    run: int
    runs: int  # that this took, in all

    @property
    def words(self) -> Message:
        """Say it."""
        key = "sizing.lines_run" if self.at_rest is not None else "sizing.ship_lines_run"
        return Message(key, **self._asdict())


@dataclass(frozen=True)
class InMotion:
    """What the recommended line came to."""

    how: RunsAfloat
    case: Case  # that was run: `catopt verify --dynamic` runs it again
    checks: CheckReport
    storm: Storm
    allowance: float  # for motion that the sizing at rest has, and this replaces
    counted: Counted
    tried: tuple[LineTried, ...]  # in the order of their runs
    by_length: tuple[LengthRun, ...] = ()  # the shortest first, the recommended one among them
    load_cases: int = 1  # that every line was run in
    # the next shorter and the next thinner line, which fail; of a ship
    less: tuple[LineTried, ...] = ()
    seas: tuple[TightestSea, ...] = ()  # what governs each kind of check; of several seas alone

    @property
    def is_of_ship(self) -> bool:
        """Whether lines were run with a ship, by closed form."""
        return self.case.system is not None

    @property
    def factor(self) -> float:
        """Motion's own: the storm's tension over that at rest, as an allowance would be."""
        return self.storm.tension / self.storm.at_rest

    def to_dict(self) -> dict[str, Any]:
        """Lay it out for JSON, in SI."""
        assert self.case.dynamics is not None
        governing = self.checks.governing
        return {
            **figures(self.how, "seeds duration_s judged_by"),
            "elements": None if self.is_of_ship else self.how.elements,
            "duration_of_interest_s": self.case.dynamics.duration_of_interest,
            **_of_storm(self.storm),
            **figures(self, "factor allowance"),
            "checks": [each.to_dict() for each in self.checks.results],
            "governing": "" if governing is None else governing.in_case,
            "periods_s": list(self.how.periods),
            "seas": [
                {
                    "kind": each.check.kind,
                    "load_case": each.check.load_case,
                    "period_s": each.period,
                    "utilisation": each.check.utilisation,
                }
                for each in self.seas
            ],
            "lines": self.counted._asdict(),
            "tried": [_of_line(each) for each in self.tried],
            "by_length": [
                {
                    **_of_line(each.tried),
                    "storm": None if each.storm is None else _of_storm(each.storm),
                    "sinker_mass_kg": each.sinker,
                }
                for each in self.by_length
            ],
            "warnings": list(self.checks.warnings),
        }


def _of_line(of: LineTried) -> dict[str, Any]:
    return {
        "component": of.component,
        "nominal_diameter_m": of.diameter,
        **figures(of, "length_m mass_kg runs passes"),
        "fails": of.words,
    }


def _of_storm(of: Storm) -> dict[str, Any]:
    return {
        "load_case": of.load_case,
        "largest_tension_N": of.largest,
        "most_probable_tension_N": of.most_probable,
        "interval_N": None if of.low is None else [of.low, of.high],
        "tension_at_rest_N": of.at_rest,
    }


class NoLineInMotionError(NoFeasibleDesignError):
    """Lines pass at rest, and none that was run passes in motion."""

    def __init__(self, nearest: NearMiss, chain: str, counted: Counted) -> None:
        self.counted, self.in_motion = counted, counted.words
        said = [
            Message("sizing.none_in_motion"),
            self.in_motion,
            Message("sizing.nearest_in_motion", chain=chain, length=nearest.line.length),
            *(
                Message(
                    "sizing.miss_in_motion",
                    check=each.in_case,
                    times=(each.demand / each.capacity) if each.capacity > 0.0 else 0.0,
                )
                if each.capacity > 0.0
                else each.in_case
                for each in nearest.failing
            ),
            *([nearest.reason] if nearest.reason else []),
        ]
        super().__init__(Several(said, "\n"), nearest)
