"""What an answer comes to: what was judged, what was not, and what makes it no answer.

Every face takes its word and its colour from `verdict_of`. What a case may have that its checks do
not look at is one row of `SUBJECTS`: whether the case has it, whether it was judged, and, among the
words (``verdict.NAME_how_WHO``), what to type to have it judged.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Final, Literal, NamedTuple

from catopt.model.kinds import OneOf
from catopt.model.line import line_kind
from catopt.records import Record
from catopt.words import Message, Sentence, Several, is_said
from catopt.words.message import group

if TYPE_CHECKING:
    from catopt.checks.result import CheckReport
    from catopt.model import Case
    from catopt.model.network import Network

Colour = Literal["green", "amber", "red", "none"]
"""Green: all that the case has was judged, and passes. Amber: what was judged passes, and there is
more to judge. Red: a check fails, or the answer is none. None: nothing was judged."""
COLOURS: Final = ("green", "amber", "red", "none")

State = Literal["at_rest", "in_motion"]

Who = Literal["case", "size", "page", "app"]
"""Who is told what to type: whoever has a case file, sizes on a command line, or has the page,
alone or with catopt behind it."""


@dataclass(frozen=True)
class NotJudged(Record):
    """Something that the case has and no check looked at."""

    DOCUMENT = "subject said how"

    subject: str
    """Its name, one of those of `catopt.checks.verdict.SUBJECTS`."""
    said: str
    """The same in words."""
    how: str
    """What to type to have it judged; empty where catopt has no way."""

    @property
    def words(self) -> str:
        """Both in one."""
        if not self.how:
            return self.said
        return Message("verdict.item", said=self.said, how=self.how)


@dataclass(frozen=True)
class Judged(Record):
    """A state in which checks were made."""

    DOCUMENT = "state by checks failed"

    state: Annotated[str, OneOf(("at_rest", "in_motion"))]
    """Under steady loads, or as it moves."""
    by: str
    """The method, where there are several; else empty."""
    checks: int
    """How many were made."""
    failed: int
    """How many of them fail."""


@dataclass(frozen=True)
class Judgement(Record):
    """What an answer comes to."""

    DOCUMENT = "colour said judged not_judged invalid governing"

    colour: Annotated[Colour, OneOf(COLOURS)]
    """Green: all that the case has was judged and passes; amber: what was judged passes, and
    `not_judged` says what else there is; red: a check fails, or the answer is not valid; none:
    nothing was judged."""
    said: str
    """In words: what makes it invalid first, then the checks, then what was not judged."""
    judged: tuple[Judged, ...]
    """States in which checks were made."""
    not_judged: tuple[NotJudged, ...]
    """What the case has beside."""
    invalid: tuple[str, ...]
    """Why it is no answer, whatever its checks say."""
    governing: str
    """The check that governs, with its load case; empty without checks."""

    @property
    def passes(self) -> bool | None:
        """Whether what was judged passes and is valid; None where nothing was judged."""
        return None if self.colour == "none" else self.colour != "red"


@dataclass(frozen=True)
class Matter:
    """What a verdict is on: the case, its checks, and what only its answer knows."""

    case: Case | Network | None = None
    at_rest: CheckReport | None = None
    in_motion: CheckReport | None = None
    who: Who = "case"
    motion_by: str = ""
    """How it was judged in motion, in words; empty: by runs of the full model."""
    moves: bool = False
    """Whether what is moored moves, though the case does not say so."""
    remarks: tuple[str, ...] = ()
    """What was said beside the checks' warnings."""
    deck: Message | None = None
    """Why a buoy's deck is not above water at rest, where it is not."""
    invalid: tuple[str, ...] = ()
    """Why it is no answer."""
    no_way: tuple[str, ...] = ()
    """Subjects that cannot be judged here, whatever is typed."""

    @property
    def reports(self) -> tuple[CheckReport, ...]:
        """All checks that were made, those in motion last: they decide."""
        every = (self.at_rest, self.in_motion)
        return tuple(each for each in every if each is not None and each.results)

    @property
    def moved(self) -> CheckReport | None:
        """Checks in motion, where any were made."""
        return self.in_motion if self.in_motion is not None and self.in_motion.results else None

    def has_said(self, *keys: str) -> bool:
        """Whether one of these messages is among the warnings and remarks."""
        warnings = (each for report in self.reports for each in report.warnings)
        every = [*warnings, *self.remarks]
        # A warning may have been made a sentence.
        bare = (each.words if isinstance(each, Sentence) else each for each in every)
        return any(is_said(each, key) for each in bare for key in keys)

    def has_check(self, *kinds: str) -> bool:
        """Whether a check of one of these kinds was made."""
        return any(each.kind in kinds for report in self.reports for each in report.results)


# ------------------------------------------------------------------ what may not be judged


MOST_FRICTION: Final = 0.70
"""tan(delta) of concrete cast on clean sound rock: NAVFAC DM 7.02, table 1 of chapter 3; no soil
has more."""


class Subject(NamedTuple):
    """What may be there to be judged beside the checks that are made."""

    is_there: Callable[[Matter], bool]
    """Whether the case has it."""
    is_judged: Callable[[Matter], bool] = lambda _: False
    ways: tuple[Who, ...] = ()
    """To whom there is something to say of how to have it judged."""
    words: Callable[[Matter], Message] | None = None
    """What it is, where that is more than its own word."""


def _moves(of: Matter) -> bool:
    case = of.case
    return of.moves or (case is not None and case.dynamics is not None)


def _is_buoy_in_motion(of: Matter) -> bool:
    case = of.case
    has_buoy = case is not None and case.floater is not None and case.floater.kind == "buoy"
    return has_buoy and of.moved is not None


def _is_run(of: Matter) -> bool:
    return of.moved is not None


def _is_proven(of: Matter) -> bool:
    return of.moved is not None and of.moved.is_proven


def _wears(of: Matter) -> bool:
    """Whether there is chain."""
    case = of.case
    if case is None:
        return False
    lines = set(case.every_line)
    names = (each.name or each.component for line in lines for each in line.segments)
    return any(line_kind(name) == "chain" for name in names)


def _is_worn(of: Matter) -> bool:
    return of.case is not None and of.case.service is not None


def _slides(of: Matter) -> bool:
    """Whether a sinker has more friction than any soil has."""
    anchor = None if of.case is None else of.case.anchor
    return anchor is not None and (anchor.friction or 0.0) > MOST_FRICTION


def _soil_words(of: Matter) -> Message:
    assert of.case is not None
    assert of.case.anchor is not None
    return Message("verdict.soil", friction=of.case.anchor.friction)


def _has_free_bodies(of: Matter) -> bool:
    return any(getattr(of.case, "bodies", ()))


def _floats_enough(of: Matter) -> bool:
    """Whether of each free body of a network it is known what takes it under."""
    return all(body.floats or body.reserve_buoyancy for body in getattr(of.case, "bodies", ()))


def _deck_words(of: Matter) -> Message:
    assert of.deck is not None
    return of.deck


def _accepted_words(of: Matter) -> Message:
    assert of.case is not None
    return Message("verdict.plausible", names=", ".join(of.case.accept))


SUBJECTS: Final[dict[str, Subject]] = {
    "motion": Subject(_moves, _is_run, ("case", "size", "page", "app")),
    "strength": Subject(
        lambda of: of.has_said("checks.no_strength_criterion") and not of.has_check("tension"),
        ways=("case", "size"),
    ),
    "directions": Subject(lambda of: of.has_said("checks.other_directions")),
    "breaking": Subject(
        lambda of: of.has_said(
            *("loads.calmar_stops", "loads.departs_breaking", "loads.breaks"),
            "loads.breaks_above",
            *("loads.breaks_beyond_drift", "motion.waves_break", "motion.wave_breaks"),
        )
    ),
    "deck": Subject(lambda of: of.deck is not None, ways=("size",), words=_deck_words),
    "grounding": Subject(lambda of: of.has_said("sizing.touches_bed")),
    "soil": Subject(_slides, ways=("case", "size", "page"), words=_soil_words),
    "reserve": Subject(_has_free_bodies, _floats_enough, ("case",)),
    "heel": Subject(_is_buoy_in_motion, lambda of: of.has_check("heel"), ways=("case", "size")),
    "plausible": Subject(
        lambda of: of.case is not None and bool(of.case.accept), words=_accepted_words
    ),
    "convergence": Subject(_is_run, _is_proven, ("case", "size", "page")),
    "wear": Subject(_wears, _is_worn, ("case", "size", "page")),
}
"""What a case may have beside its checks, by what decides most; each has its words."""


def not_judged(of: Matter) -> tuple[NotJudged, ...]:
    """List what the case has and was not judged, in the order of `SUBJECTS`."""
    found = []
    for name, subject in SUBJECTS.items():
        if subject.is_there(of) and not subject.is_judged(of):
            words = subject.words
            said = Message(f"verdict.{name}") if words is None else words(of)
            own = f"{name}_how_{of.who}"
            who = "page" if of.who == "app" and own not in group("verdict") else of.who
            has_way = who in subject.ways and name not in of.no_way
            how = Message(f"verdict.{name}_how_{who}") if has_way else ""
            found.append(NotJudged(name, said, how))
    return tuple(found)


# ------------------------------------------------------------------ the verdict


def verdict_of(of: Matter, said: str = "") -> Judgement:
    """Say what an answer comes to; `said` has the checks in words, where they are not the usual.

    Examples
    --------
    >>> from catopt.checks.verdict import Matter, verdict_of
    >>> verdict_of(Matter()).colour
    'none'
    """
    reports = of.reports
    doubted = any(each.is_doubted and each.passes for each in reports)
    failed = any(not each.passes for each in reports)
    invalid = of.invalid
    if failed and any(each.is_doubted for each in reports):
        invalid = (*invalid, Message("checks.motion_doubted"))
    # Of what fails, or of nothing, there is no more to judge.
    is_open = bool(reports) and not failed and not doubted and not invalid
    left = not_judged(of) if is_open else ()
    colour: Colour = "amber" if left else "green"
    if not is_open:
        colour = "red" if reports or invalid else "none"
    checks = said or _checks_sentence(of, rests=any(each.subject == "motion" for each in left))
    sentences = [*(Message("verdict.invalid", why=each) for each in invalid), checks]
    if left:
        items = Several(each.words for each in left)
        sentences.append(Message("verdict.not_judged", items=items))
    decides = next((each for each in reversed(reports) if not each.passes), None)
    decides = decides or (reports[-1] if reports else None)
    return Judgement(
        colour,
        Several(sentences, " ") if len(sentences) > 1 else checks,
        tuple(
            Judged(state, by, len(each.results), len(each.failed))
            for state, by, each in (
                ("at_rest", "", of.at_rest),
                ("in_motion", of.motion_by, of.in_motion),
            )
            if each is not None and each.results
        ),
        left,
        invalid,
        "" if decides is None else decides.nearest,
    )


def _checks_sentence(of: Matter, *, rests: bool) -> Message:
    """Say of the checks that decide how many there are, and how many fail."""
    if not of.reports:
        return Message("checks.nothing")
    failing = [each for each in of.reports if not each.passes]
    report = failing[-1] if failing else of.reports[-1]
    return report_sentence(report, rests=rests)


def report_sentence(report: CheckReport, *, rests: bool = False) -> Message:
    """Say whether all checks are passed: ``"2 of 9 checks fail."``; `rests`: at rest alone."""
    count, failed = len(report.results), len(report.failed)
    if failed:
        return Message("checks.some_fail", count=failed, checks=count)
    if count and report.is_doubted:
        return Message("checks.pass_in_doubt", count=count)
    key = "checks.all_pass_at_rest" if rests else "checks.all_pass"
    return Message(key, count=count) if count else Message("checks.nothing")
