"""What an engineer should know of a report of checks beside the checks themselves."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Final, NamedTuple

from catopt.catalogue.figure import RECALLED
from catopt.catenary.solution import Solution
from catopt.checks.criteria import UPLIFT, Criteria
from catopt.checks.criterion import State
from catopt.checks.evaluation import segment_words
from catopt.checks.strength import Strength
from catopt.model import Anchor, Line
from catopt.model.load import LoadCaseKind
from catopt.ties import largest
from catopt.words import Listed, Measure, Message, term

NO_CHECK: Final = "checks.none"
"""Key of the warning that nothing is checked."""

IN_LOAD_CASE: Final = "checks.in_load_case"
"""Key of what is said of one load case."""

_LEVEL = 1e-9
"""rad; an inclination that is rounding."""


def in_load_case(load_case: str, said: str) -> Message:
    """Say of which load case something is said."""
    return Message(IN_LOAD_CASE, name=load_case, said=said)


def of_criteria(criteria: Criteria, line: Line, strengths: Sequence[Strength]) -> Iterator[str]:
    """Say what is to be known of the criteria, and which segments none of them covers."""
    if not criteria.all:
        yield Message(NO_CHECK)
    yield from criteria.warnings
    table = None if criteria.service is None else criteria.service.table
    if table is not None and table.confidence == RECALLED:
        yield Message("checks.wear_table_recalled", source=term(table.source))
    for index, strength in enumerate(strengths):
        covered = any(
            each.check == "tension" and each.is_for(strength.kind) for each in criteria.all
        )
        if criteria.all and not covered:
            words = segment_words(line.segments[index], index)
            yield Message("checks.no_strength_criterion", segment=words)


def of_other_states(criteria: Criteria) -> Iterator[Message]:
    """Say which codes are for one line out, too: a line by itself is not judged by that."""
    yield from _only_for(criteria, "one_line_out", "checks.line_by_itself")
    yield from of_transient(criteria)


def of_transient(criteria: Criteria) -> Iterator[Message]:
    """Say which codes have factors for the transient state: nothing at rest is judged by them."""
    yield from _only_for(criteria, "transient", "checks.transient_not_judged")


def _only_for(criteria: Criteria, state: State, said: str) -> Iterator[Message]:
    """Name the codes that have criteria for one state alone."""
    found = (each.source.code for each in criteria.all if each.states == (state,))
    codes = tuple(dict.fromkeys(found))
    if codes:
        yield Message(said, codes=Listed(codes, "and"))


class Lifted(NamedTuple):
    """A line that may lift its anchor."""

    where: str
    """Load case, or line and state, in words."""
    state: State
    kind: LoadCaseKind
    solution: Solution

    @property
    def angle(self) -> float:
        """Inclination at the anchor, rad."""
        return self.solution.anchor.angle


def of_uplift(
    solved: Iterable[Lifted], criteria: Criteria, anchor: Anchor | None
) -> Iterator[Message]:
    """Say where an anchor is lifted most and no check is on that, or is lifted though it drags.

    Of every line in every state; a sinker's check on sliding covers its uplift.
    """
    lifted = [each for each in solved if each.angle > _LEVEL]
    if not lifted or (anchor is not None and anchor.kind == "sinker"):
        return
    free = [
        each
        for each in lifted
        if not any(True for check in UPLIFT for _ in criteria.of(check, each.kind, each.state))
    ]
    if free or anchor is not None:
        worst = largest(free or lifted, lambda each: each.angle)
        yield Message(
            "checks.uplift_unchecked" if free else "checks.drag_anchor_lifted",
            where=worst.where,
            angle=Measure("angle", worst.angle),
            force=Measure("vertical_force", worst.solution.anchor.vertical_force),
        )
