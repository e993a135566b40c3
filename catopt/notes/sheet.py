"""What every note states of a mooring beside its answer, whatever kind of note it is."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, ClassVar, Literal, NamedTuple, Protocol

from catopt.catenary.case import solve_case
from catopt.checks.criteria import Criteria, criteria_of
from catopt.checks.kinds import ROUNDING
from catopt.checks.wear import LeastDiameter, least_diameters
from catopt.errors import CatoptError
from catopt.largest import largest
from catopt.model import Anchor, Load
from catopt.model.network import Network
from catopt.mooring.solution import solve_system
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.catenary.solution import Solution
    from catopt.checks.result import CheckReport, CheckResult
    from catopt.model import Case, Line
    from catopt.mooring.solution import SystemSolution
    from catopt.notes.origin import Origin
    from catopt.verify.result import Verification

PART = 0.01
"""By how much of its distance from the fairlead an anchor is put elsewhere."""


@dataclass(frozen=True)
class AnchorMoved:
    """What comes of an anchor that lies `way` (m) farther from the fairlead.

    The largest `tension` at a fairlead (N) and the `offset` of a body (m) from the place under no
    load that was planned are None where there is no equilibrium, for the reason of `refusal`.
    """

    way: float
    tension: float | None = None
    offset: float | None = None
    refusal: str = ""


About = Literal["line", "body"]


class Made(NamedTuple):
    """So many lines that are alike; `is_held` by an anchor."""

    line: Line
    number: int
    is_held: bool = True


@dataclass(frozen=True, kw_only=True)
class Stated:
    """What is stated of any mooring, of so many `lines`, each of which `anchor` holds.

    `report` is by `criteria`; `intact` has every line with all there, in every load case; `made`
    are the lines by how they are made.
    """

    case: Case | Network
    report: CheckReport
    criteria: Criteria
    lines: int
    intact: tuple[Solution, ...]
    made: tuple[Made, ...]
    anchor: Anchor | None = None

    @property
    def break_factor(self) -> float | None:
        """Least MBL over tension of any segment, new and intact; None where one is not known."""
        found = []
        for solution in self.intact:
            for part, each in zip(solution.line.segments, solution.segments, strict=True):
                if each.max_tension == 0.0:
                    found.append(math.inf)
                elif part.MBL is None:
                    return None
                else:
                    found.append(part.MBL / each.max_tension)
        return min(found, default=None)

    @property
    def with_line_out(self) -> tuple[CheckResult, ...]:
        """Every check with one line out."""
        return tuple(each for each in self.report.results if each.place.state != "intact")

    @property
    def nearest_with_line_out(self) -> CheckResult | None:
        """The one of these nearest to its limit, the first of those alike; None without any."""
        made = self.with_line_out
        return largest(made, lambda each: each.exceedance, ROUNDING) if made else None


@dataclass(frozen=True, kw_only=True)
class Sheet(Stated):
    """What is stated of a case with all its load cases.

    `line` is that of the note, of a body one of its lines; `about` says of which it is.
    `pretension` (N) is the largest tension at a fairlead of the body under no load, of a line in
    its reference load case. `moved` is the most loaded line's anchor elsewhere, or that of a line
    whose span is given; empty where the force on the line is given, which does not change by that.
    `least` is how far segments may wear.
    """

    case: Case
    line: Line
    about: About
    pretension: float | None = None
    moved: tuple[AnchorMoved, ...] = ()
    least: tuple[LeastDiameter, ...] = ()


@dataclass(frozen=True, kw_only=True)
class AnyNote:
    """What every note has: its case, what it states, what it rests on, what to know before its use.

    The case of a line is under the load that is drawn.
    """

    case: Case | Network
    sheet: Stated
    origin: Origin
    warnings: tuple[str, ...] = ()

    @property
    def checks(self) -> CheckReport:
        """Of every line and load case, with all lines there and with one out."""
        return self.sheet.report


class Loaded(Protocol):
    """What is stated of lines as they are loaded: of one, or of those of a body."""

    about: ClassVar[About]
    """What the sentences are about."""

    @property
    def intact(self) -> Sequence[Solution]:
        """Solve them with none missing."""

    @property
    def pretension(self) -> float | None:
        """Largest tension at a fairlead without load, N; None where it is not known."""

    def moved(self) -> Iterator[AnchorMoved]:
        """Move the anchor of the most loaded one."""


@dataclass(frozen=True)
class OneLine:
    """One line, under all its load cases."""

    case: Case
    report: CheckReport
    about: ClassVar[About] = "line"

    @property
    def intact(self) -> Sequence[Solution]:
        """In every load case in which the mooring is whole."""
        out = {each.name for each in self.report.load_cases if each.state != "intact"}
        return [solution for name, solution in self.report.solutions if name not in out]

    @property
    def pretension(self) -> float | None:
        """In its reference load case."""
        everyday = {each.name for each in self.report.load_cases if each.kind == "reference"}
        solutions = self.report.solutions
        found = [each.fairlead.tension for name, each in solutions if name in everyday]
        return max(found, default=None)

    def moved(self) -> Iterator[AnchorMoved]:
        """Change the span where that is held; a given force or tension stays what it is."""
        case = self.case
        if case.load is None or case.load.span is None:
            return
        (_, solution), *_ = self.report.solutions
        for way in (-PART * solution.span, PART * solution.span):
            held = replace(case, load=Load(span=solution.span + way))
            try:
                yield AnchorMoved(way, solve_case(held).fairlead.tension)
            except CatoptError as error:
                yield AnchorMoved(way, refusal=error.message)


@dataclass(frozen=True)
class LinesOfABody:
    """The lines of a body under its load."""

    solution: SystemSolution
    about: ClassVar[About] = "body"

    @property
    def intact(self) -> Sequence[Solution]:
        """Every line."""
        return [each.solution for each in self.solution.lines]

    @property
    def pretension(self) -> float | None:
        """Of the body under no load."""
        system = self.solution.system
        unloaded = solve_system(replace(system, force=(0.0, 0.0), moment=0.0))
        return max(each.tension for each in unloaded.lines)

    def moved(self) -> Iterator[AnchorMoved]:
        """Move the most loaded line's anchor; the body comes to rest anew."""
        system, k, start = self.solution.system, self.solution.most_loaded, self.solution.neutral
        leg, span = system.legs[k], self.solution.lines[k].solution.span
        for way in (-PART * span, PART * span):
            moved = replace(leg, anchor_radius=leg.anchor_radius + way)
            legs = (*system.legs[:k], moved, *system.legs[k + 1 :])
            try:
                found = solve_system(replace(system, legs=legs))
            except CatoptError as error:
                yield AnchorMoved(way, refusal=error.message)
                continue
            offset = math.hypot(found.position.x - start.x, found.position.y - start.y)
            yield AnchorMoved(way, max(each.tension for each in found.lines), offset)


def sheet_of(
    case: Case,
    line: Line,
    report: CheckReport,
    loaded: Loaded | None = None,
    *,
    anchor: Anchor | None = None,
    moved: CheckReport | None = None,
) -> Sheet:
    """Work out what is stated of a line, or of a body on several.

    `case` has all its load cases; `line` is that of the note, and `anchor` stands in the place of
    the case's own. `loaded`: the lines under load; that of the case when left out. `moved` are its
    checks in motion.
    """
    loaded = loaded or OneLine(case, report)
    anchor = anchor or case.anchor
    criteria = criteria_of(replace(case, anchor=anchor))
    intact = tuple(loaded.intact)
    count = len(intact) if loaded.about == "body" else 1
    return Sheet(
        case=case,
        line=line,
        report=report,
        criteria=criteria,
        lines=count,
        intact=intact,
        made=(Made(line, count),),
        anchor=anchor,
        about=loaded.about,
        pretension=loaded.pretension,
        moved=tuple(loaded.moved()),
        least=least_diameters(report, criteria, line, case, moved),
    )


# ------------------------------------------------------------------ the truss model


def both_models(case: Case | Network, load_case: str = "") -> tuple[Verification | None, str]:
    """Solve a body, lines between points, or a line under its load, by both models.

    Says why where there is no answer.

    `load_case` is the name of the load case that is the load of a line.
    """
    from catopt.verify.case import LOAD, verify_case

    try:
        found = verify_case(case.without_load_cases())
    except CatoptError as error:
        return None, error.message
    (part,) = found.parts
    return replace(found, parts=(replace(part, name=load_case or LOAD),)), ""


def doubts_of_models(found: Verification | None, failure: str, what: str) -> Iterator[str]:
    """Yield what the truss model leaves in doubt, of a "line" or a "body"."""
    if found is not None and not found.is_settled:
        differ = found.verdict == "differs"
        yield Message("notes.models_differ" if differ else "notes.models_unresolved")
    if failure:
        yield Message(f"notes.{what}_not_verified", why=failure)
