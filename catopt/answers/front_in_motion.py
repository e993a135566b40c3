"""The designs of a front in motion."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from catopt.answers import blocks
from catopt.answers.blocks import Rows, answered, section, tabulate
from catopt.answers.motion import FORCE, PERCENT, RATIO
from catopt.words import Message, term

if TYPE_CHECKING:
    from catopt.notes.front_in_motion import DesignInMotion, FrontInMotion


def front_in_motion_answer(found: FrontInMotion) -> blocks.Answer:
    """Lay out a front in motion: a row a design, and what is recommended then."""
    title = Message("captions.front")
    return answered("front_in_motion", title, section("motion.front", *_front(found)))


def _front(found: FrontInMotion) -> Iterator[blocks.Block]:
    yield _designs(found)
    for each in found.designs:
        if each.failure:
            yield blocks.Text(Message("truss.design_failed", number=each.number, why=each.failure))
    if not found.is_complete:
        stopped = Message("motion.front_stopped", count=len(found.designs))
        yield blocks.Verdict(stopped, passes=False)
    once = [each.number for each in found.designs if each.is_run_once]
    chosen = next((e for e in found.designs if e.number == found.recommended), None)
    if once and chosen is not None and not chosen.is_run_once:
        yield blocks.Text(Message("motion.front_proven", number=chosen.number))
    elif once:
        yield blocks.Verdict(Message("motion.not_proven"), passes=False)
    only_in_motion = [each.number for each in found.designs if not each.passes]
    if only_in_motion:
        # Write rising numbers as 1-3, 5.
        runs: list[list[int]] = []
        for number in only_in_motion:
            if runs and number == runs[-1][-1] + 1:
                runs[-1].append(number)
            else:
                runs.append([number])
        numbers = ", ".join(f"{run[0]}-{run[-1]}" if len(run) > 1 else str(run[0]) for run in runs)
        yield blocks.Verdict(Message("motion.front_fails", designs=numbers), passes=False)
    if found.recommended is None:
        yield blocks.Verdict(Message("motion.front_none"), passes=False)
    else:
        key = "front_same" if found.recommended == found.of_search else "front_other"
        values = {"number": found.recommended, "search": found.of_search}
        yield blocks.Verdict(Message(f"motion.{key}", **values), passes=True)


def _designs(found: FrontInMotion) -> blocks.Table:
    designs = found.designs
    of, parts = Rows(designs), Rows(each.governing for each in designs)
    verdict = of.texts("verdict", _verdict, passes=tuple(each.passes for each in designs))
    return tabulate(
        "front_in_motion",
        of.texts("design", "number"),
        parts.texts("runs", lambda part: len(part.runs)),
        of.measured(FORCE, "at_rest", "motion.front_at_rest"),
        parts.measured(
            FORCE, lambda part: part.of("fairlead_tension").maximum, "motion.front_largest"
        ),
        parts.measured(FORCE, "quasi_static_max", "motion.front_still", priority=1),
        parts.measured(RATIO, "dynamic_amplification", "motion.front_allowance"),
        parts.measured(PERCENT, lambda part: part.change_of("fairlead_tension"), "change"),
        of.measured("utilisation", "tightest.utilisation"),
        verdict,
        marked=next((k for k, e in enumerate(designs) if e.number == found.recommended), None),
    )


def _verdict(each: DesignInMotion) -> Message:
    if each.found is None:
        return term("NO ANSWER")
    if each.found.verdict == "not converged":
        return Message("motion.front_not_converged")
    return Message("answers.passes" if each.passes else "answers.fails")
