"""What a check says: demand, capacity, utilisation and where the criterion comes from."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Annotated, Any, NamedTuple

from catopt.catenary.solution import Solution
from catopt.checks.kinds import CHECK_UNITS, ROUNDING, CheckKind, CheckSource, Place
from catopt.checks.verdict import Judgement, Matter, verdict_of
from catopt.display import Displayable
from catopt.largest import largest
from catopt.model import Case, LoadCase
from catopt.model.kinds import OneOf
from catopt.model.kinds import Place as Along
from catopt.model.load import LoadCaseKind
from catopt.model.network import Network
from catopt.old_names import OldName
from catopt.records import From, FromZero, Record, within
from catopt.words import Message, is_said

__all__ = ["CheckReport", "CheckResult", "CheckSource", "line_in_state"]


def line_in_state(number: int, state: str) -> Message:
    """Say of which line of a body something is, and in which state: ``"line 2, intact"``."""
    line = Message("checks.line_number", number=number)
    return Message("checks.of_line", line=line, name=state)


@dataclass(frozen=True)
class CheckResult(Record):
    """One criterion in one load case."""

    DOCUMENT = (
        "name kind load_case demand capacity unit utilisation exceedance=excess passes "
        "source.text=source source.code source.confidence note place.state* place.line* "
        "place.missing=missing_line*"
    )

    name: str
    """What is checked, with the place, in words."""
    kind: CheckKind
    """Which kind of check."""
    load_case: str
    """Name of the load case; of a body its state, intact or line 1 out."""
    demand: float
    """In unit. Of a least grounded length, what is required; of a sinker, the weight in water that
    it needs."""
    capacity: float
    """In unit. Of a least grounded length, what lies on the bed; of a sinker, its weight in
    water."""
    unit: Annotated[str, OneOf(CHECK_UNITS)]
    """SI unit of demand and capacity; empty where they count lines."""
    exceedance: float
    """By how much the limit is overrun: 0 at the limit, negative inside it; a pure number, of an
    uplift angle in rad."""
    source: CheckSource
    note: str = ""
    """What went into the capacity: factor, strength, diameter at the end of life."""
    place: Place = field(default_factory=Place)

    @property
    def utilisation(self) -> float | None:
        """Demand over capacity, a pure number; None where the capacity is 0 or less."""
        return self.demand / self.capacity if self.capacity > 0.0 else None

    @property
    def in_case(self) -> Message:
        """Its name with that of the load case: ``"tension, segment 1 (storm)"``."""
        return Message("checks.in_case", check=self.name, load_case=self.where)

    def fails_as(self, name: str) -> Message:
        """Say that it fails, under a name, and how far it is used where that is known."""
        if self.utilisation is None:
            return Message("checks.fails", check=name)
        return Message("checks.fails_used", check=name, used=self.utilisation)

    @property
    def where(self) -> str:
        """Its load case; of a line of a body its number and the state: ``"line 2, intact"``."""
        number = self.place.line
        return self.load_case if number is None else line_in_state(number, self.load_case)

    excess = OldName("exceedance")

    @property
    def passes(self) -> bool:
        """Whether the exceedance is at most 1e-9, for rounding."""
        return self.exceedance <= ROUNDING


@dataclass(frozen=True)
class HangingLine(Record):
    """How a line hangs in a load case, or in a state of the body that it holds."""

    DOCUMENT = (
        "name kind water_level solution.horizontal_force solution.fairlead_height solution.span "
        "solution.fairlead.tension=fairlead_tension_N "
        "solution.anchor.horizontal_force=anchor_horizontal_force_N "
        "solution.anchor.vertical_force=anchor_vertical_force_N "
        "solution.anchor.angle=anchor_angle_rad solution.grounded_length "
        "place.state* place.line* place.missing=missing_line*"
    )

    name: str
    """As the case has it; load for a case without load cases; of a body its line and state."""
    kind: LoadCaseKind
    """Which factors of the codes are taken."""
    water_level: Along
    """Above the level of the site's water depth."""
    solution: Solution
    place: Place


_FIRST = ("mooring.bodies_under", "mooring.floats_under")


@dataclass(frozen=True, repr=False)
class CheckReport(Displayable, Record):
    """Checks of one line in all its load cases, or of the lines of a body in all its states.

    By closed form. A unit may stand in the key unit beside it. Heights are above the seabed.
    """

    SCHEMA = "catopt.check/1"
    DOCUMENT = (
        "title verdict=passes _governing_index=governing hanging=load_cases results=checks "
        "warnings judgement=verdict~"
    )

    title: str
    """Title of the case; empty when it has none."""
    results: tuple[CheckResult, ...]
    """By load case or state, then by line and kind of check; tensions from the anchor to the
    fairlead."""
    solutions: tuple[tuple[str, Solution], ...]
    """The equilibrium in each load case, by its name; of a body, of each line in each state."""
    warnings: tuple[str, ...] = ()
    """What an engineer should know before using the answer."""
    load_cases: tuple[LoadCase, ...] = ()
    """Those of the case, in the order of `solutions`; empty when its load alone was checked."""
    places: tuple[Place, ...] = ()
    """Of a body: line and state of each of the `solutions`."""
    is_doubted: bool = False
    """Whether the demands are in doubt: of a run in time that was stopped or did not converge."""
    case: Case | Network | None = field(default=None, compare=False)  # that was checked
    is_in_motion: bool = False  # whether the lines were run in time
    is_proven: bool = False  # whether they were run again at a finer step or with more bars

    @property
    def first(self) -> tuple[str, ...]:
        """Those of the warnings that stand before any answer: what is under water."""
        return tuple(each for each in self.warnings if any(is_said(each, key) for key in _FIRST))

    @property
    def others(self) -> tuple[str, ...]:
        """The warnings beside these."""
        return tuple(each for each in self.warnings if each not in self.first)

    @property
    def judgement(self) -> Judgement:
        """What it comes to: its checks, what was not judged, what makes it invalid."""
        return verdict_of(self.matter)

    @property
    def matter(self) -> Matter:
        """What that is of, for who knows more."""
        if self.is_in_motion:
            return Matter(self.case, in_motion=self)
        return Matter(self.case, at_rest=self)

    @property
    def passes(self) -> bool:
        """Whether every check is passed; true when none was made."""
        return all(result.passes for result in self.results)

    @property
    def verdict(self) -> bool | None:
        """Whether every check is passed; None where there is none, or all are but in doubt."""
        if not self.results or (self.passes and self.is_doubted):
            return None
        return self.passes

    @property
    def governing(self) -> CheckResult | None:
        """The failed check that is furthest beyond its limit, else the one nearest to it.

        Nearness is the utilisation: of a limit of 0 that is just kept, such as no uplift, nothing
        can be said, so that it governs only where there is no other check. None without checks.
        """
        if self.failed:
            return self.failed[0]
        if not self.results:
            return None
        return largest(self.results, lambda result: result.utilisation or 0.0, ROUNDING)

    @property
    def nearest(self) -> str:
        """The check nearest to its limit, with its load case; empty without checks."""
        return "" if self.governing is None else self.governing.in_case

    @property
    def failed(self) -> tuple[CheckResult, ...]:
        """The checks that are failed, the worst first; those alike as they come."""
        failed = [result for result in self.results if not result.passes]
        return tuple(sorted(failed, key=lambda result: -round(result.exceedance, 9)))

    def tightest(self, kind: str) -> CheckResult | None:
        """Return the check of a kind nearest to its limit, over segments and load cases."""
        made = [result for result in self.results if result.kind == kind]
        return largest(made, lambda result: result.exceedance, ROUNDING) if made else None

    @property
    def tightest_by_state(self) -> tuple[int, ...]:
        """Which results are nearest to their limit, by state, kind and criterion, from 0."""
        found: dict[tuple[object, ...], int] = {}
        for index, each in enumerate(self.results):
            key = (each.place.state, each.kind, each.source)
            best = found.setdefault(key, index)
            if each.exceedance > self.results[best].exceedance + ROUNDING:
                found[key] = index
        return tuple(sorted(found.values()))

    def used(self, *, line: int | None = None, missing: int | None = None) -> float | None:
        """Return the largest utilisation of a tension; None where none is limited.

        `line`: of one line of a body, from 1; of any when left out; `missing`: the line that is
        gone, from 1; with all there when left out.
        """
        known = [
            each.demand / each.capacity
            for each in self.results
            if each.kind == "tension"
            and each.place.missing == missing
            and line in (None, each.place.line)
        ]
        return max(known, default=None)

    @property
    def _governing_index(self) -> FromZero | None:
        """Which of checks, counted from 0, governs; None without checks.

        It is the failed one furthest beyond its limit, else that with the highest utilisation.
        """
        return None if self.governing is None else self.results.index(self.governing)

    @property
    def hanging(self) -> Annotated[tuple[HangingLine, ...], From(1)]:
        """How the line hangs in each; of a body each line, with all there and with each one out."""
        # A load that is none of several is an extreme one, at the level of the site's depth.
        cases = self.load_cases or (LoadCase("load", 1.0),) * len(self.solutions)
        places = self.places or (Place(),) * len(cases)
        return tuple(
            HangingLine(name, case.kind, case.water_level, solution, place)
            for (name, solution), case, place in zip(self.solutions, cases, places, strict=True)
        )

    def to_dict(self) -> dict[str, Any]:
        """Build the document that ``catopt check --json`` prints (schema catopt.check/1)."""
        document = super().to_dict()
        if self.places:
            # With state and line, as documents of moored bodies have it.
            document["load_cases"] = [e.to_dict() | e.place.to_dict() for e in self.hanging]
            document["checks"] = [e.to_dict() | e.place.to_dict() for e in self.results]
        return document

    @property
    def in_motion(self) -> ChecksInMotion:
        """What ``catopt verify --dynamic --json`` has of them."""
        return ChecksInMotion(self)

    @property
    def brief(self) -> ChecksInBrief:
        """The verdict of a body, as ``catopt system`` has it."""
        return ChecksInBrief(self)


class AtLevels(NamedTuple):
    """Checks of a mooring at its own water level and at others."""

    whole: CheckReport
    """Of all levels; those of others name theirs."""
    others: tuple[CheckReport, ...]
    """Of each other level alone."""


@dataclass(frozen=True)
class CheckOfBody(Record):
    """A check of a moored body or of one of its lines, as in catopt.check/1."""

    DOCUMENT = within("result", CheckResult.DOCUMENT).replace("*", "")

    result: CheckResult


@dataclass(frozen=True)
class ChecksInMotion(Record):
    """In motion, by the numbers of the case and the codes' factors for dynamic analysis."""

    DOCUMENT = "passes governing checks report.warnings report.judgement=verdict~"

    report: CheckReport

    @property
    def passes(self) -> bool | None:
        """Whether every check is passed; None where there is none, or none fails in doubt."""
        return self.report.verdict

    @property
    def governing(self) -> FromZero | None:
        """Index of the check that governs, from 0; None where there is none."""
        return self.report._governing_index

    @property
    def checks(self) -> tuple[CheckOfBody, ...]:
        """By load case or line, then by kind, tensions by segment from the anchor."""
        return tuple(CheckOfBody(each) for each in self.report.results)


@dataclass(frozen=True)
class ChecksInBrief(Record):
    """Only of the command: what the checks of the case come to, intact and with each line out.

    The command catopt check has them all.
    """

    DOCUMENT = (
        "checks failed report.verdict=passes governing report.warnings report.judgement=verdict~"
    )

    report: CheckReport

    @property
    def checks(self) -> FromZero:
        """How many were made."""
        return len(self.report.results)

    @property
    def failed(self) -> FromZero:
        """How many of them fail."""
        return len(self.report.failed)

    @property
    def governing(self) -> CheckOfBody | None:
        """The one that governs; None without checks."""
        found = self.report.governing
        return None if found is None else CheckOfBody(found)
