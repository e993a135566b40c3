"""What the designs of a front in motion consist of."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from catopt.answers.blocks import (
    Answer,
    Block,
    Column,
    Section,
    Table,
    Text,
    Verdict,
    measured,
    texts,
    where_known,
)
from catopt.quantities import QUANTITIES, Quantity
from catopt.words import Message, term

if TYPE_CHECKING:
    from catopt.notes.front_in_motion import DesignInMotion, FrontInMotion

_FACTOR = Quantity("ratio", "Ratio", "", "-", "-", 1.0, 2)
_PERCENT = Quantity("change", "Change", "", "-", "%", 0.01, 2)
_FORCE = replace(QUANTITIES["tension"], symbol="")


def front_in_motion_answer(found: FrontInMotion) -> Answer:
    """Lay out a front in motion: a row a design, and what is recommended then."""
    return Answer(
        "front_in_motion",
        Message("captions.front"),
        (Section(Message("motion.front"), tuple(_blocks(found))),),
    )


def _blocks(found: FrontInMotion) -> Iterator[Block]:
    yield _designs(found)
    for each in found.designs:
        if each.failure:
            yield Text(Message("truss.design_failed", number=each.number, why=each.failure))
    if not found.is_complete:
        yield Verdict(Message("motion.front_stopped", count=len(found.designs)), passes=False)
    if any(each.found is not None and each.found.verdict == "not proven" for each in found.designs):
        yield Verdict(Message("motion.not_proven"), passes=False)
    only_in_motion = [each.number for each in found.designs if not each.passes]
    if only_in_motion:
        numbers = _in_ranges(only_in_motion)
        yield Verdict(Message("motion.front_fails", designs=numbers), passes=False)
    yield Verdict(_recommended(found), found.recommended is not None)


def _in_ranges(numbers: list[int]) -> str:
    """Write rising numbers as 1-3, 5."""
    runs: list[list[int]] = []
    for number in numbers:
        if runs and number == runs[-1][-1] + 1:
            runs[-1].append(number)
        else:
            runs.append([number])
    return ", ".join(f"{run[0]}-{run[-1]}" if len(run) > 1 else str(run[0]) for run in runs)


def _recommended(found: FrontInMotion) -> Message:
    values = {"number": found.recommended or 0, "search": found.of_search}
    if found.recommended is None:
        return Message("motion.front_none")
    is_same = found.recommended == found.of_search
    return Message("motion.front_same" if is_same else "motion.front_other", **values)


def _designs(found: FrontInMotion) -> Table:
    designs = found.designs
    parts = [each.governing for each in designs]
    rest = [each.at_rest for each in designs]
    largest = where_known(parts, lambda part: part.of("fairlead_tension").maximum)
    still = where_known(parts, lambda part: part.quasi_static_max)
    changes = where_known(parts, lambda part: part.change_of("fairlead_tension"))
    factors = where_known(parts, lambda part: part.amplification)
    tightest = [each.tightest for each in designs]
    passes = tuple(each.passes for each in designs)
    return Table(
        "front_in_motion",
        (
            texts("design", [each.number for each in designs]),
            Column(Message("motion.front_at_rest"), tuple(rest), _FORCE),
            Column(Message("motion.front_largest"), tuple(largest), _FORCE),
            Column(Message("motion.front_still"), tuple(still), _FORCE),
            Column(Message("motion.front_allowance"), tuple(factors), _FACTOR),
            Column(Message("columns.change"), tuple(changes), _PERCENT),
            measured("utilisation", where_known(tightest, lambda each: each.utilisation)),
            Column(Message("columns.verdict"), tuple(map(_verdict, designs)), passes=passes),
        ),
        marked=next((k for k, e in enumerate(designs) if e.number == found.recommended), None),
    )


def _verdict(each: DesignInMotion) -> Message:
    if each.found is None:
        return term("NO ANSWER")
    if each.found.verdict == "not converged":
        return Message("motion.front_not_converged")
    return Message("answers.passes" if each.passes else "answers.fails")
