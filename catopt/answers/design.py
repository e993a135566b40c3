"""What the front of a design search consists of, and its designs in motion."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from operator import itemgetter, methodcaller
from typing import TYPE_CHECKING, Any

from catopt.answers import blocks
from catopt.answers.blocks import Rows, answered, section, stated, tabulate, texts, yes_or_no
from catopt.answers.check import (
    check_columns,
    governing_sentence,
    tightest_checks,
    tightest_table,
)
from catopt.answers.motion import FORCE, PERCENT, RATIO
from catopt.checks.kinds import QUANTITY_OF
from catopt.checks.verdict import report_sentence
from catopt.design.result import (
    anchor_words,
    clump_weight_words,
    layout_words,
    made_of,
    segment_words,
)
from catopt.figures.sizing import objective
from catopt.quantities import Quantity
from catopt.words import Message, Several, term

if TYPE_CHECKING:
    from catopt.design.result import DesignPoint, DesignResult, Neighbour
    from catopt.notes.front_in_motion import DesignInMotion, FrontInMotion


_MOST = 25
"""Designs of a front that people see all of; of a longer one they see some."""


def design_answer(result: DesignResult) -> blocks.Answer:
    """Lay out a front, its recommended design and how it was found."""
    reference = ", ".join(f"{value:.6g}" for value in result.reference_point)
    listed: dict[str, blocks.Value] = {
        "title": result.case.title,
        "method": result.method,
        "exact_front": yes_or_no(result.is_exact),
        "designs_in_the_space": result.designs,
        "designs_evaluated": result.evaluations,
        "of_these_feasible": result.feasible,
        **({"designs_proved_needless": _bounds(result)} if result.excluded else {}),
        "designs_on_the_front": len(result.front),
        "recommended_design": result.recommended,
        "why": result.recommendation,
        "ends_of_the_front": Several(result.ends),
        "hypervolume": result.hypervolume,
        "reference_point": reference,
        "seed": result.seed,
        "interrupted": yes_or_no(result.interrupted),
        "warnings": Several(result.warnings),
    }
    facts = tuple(stated(name, value) for name, value in listed.items())
    whole = answered(
        "design",
        result.case.title or Message("captions.mooring_line"),
        section("captions.front", *_front(result)),
        section("captions.recommended", *_recommended(result)),
        section("captions.components", _components(result)),
        section("captions.checks", _checks(result)),
        *_loads(result),
        section("captions.search", blocks.Facts("search", facts, only="files")),
    )
    return replace(whole, card=tuple(_card(result)))


_NEAR = 2
"""Designs of the front beside the recommended one that a screen has."""


def _card(result: DesignResult) -> Iterator[blocks.CardBlock]:
    """Say which design is recommended, what it comes to, its neighbours, and how it was found."""
    own, count, number = result.best, len(result.front), result.recommended
    yield blocks.Text(Message("design.card", number=number, count=count, line=made_of(own)))
    yield blocks.Verdict.of_judgement(result.judgement)
    yield blocks.Text(governing_sentence(own.checks))
    yield from _short_in_motion(result)
    of = Rows(result.front)
    near = range(max(number - 1 - _NEAR, 0), min(number + _NEAR, count))
    yield tabulate(
        "front",
        texts("design", range(1, count + 1)),
        *_objectives(result, of),
        *_drawn(of),
        *list(_moved(of))[-1:],
        of.texts("line_from_the_anchor", made_of),
        shown=tuple(sorted({0, *near, count - 1})),
        marked=result.recommended - 1,
    )
    yield blocks.Brief((result.recommendation,), Message("answers.card_why"), 3)
    steps = (each for each in result.neighbours if each.point is None or not each.point.passes)
    worse = (
        Message("design.card_step", change=each.change, why=_short_verdict(each)) for each in steps
    )
    yield from blocks.briefly(worse, Message("answers.card_limits"), 3)
    yield blocks.Brief((_how(result),), Message("answers.card_search"), 2)
    yield from blocks.briefly(result.warnings, blocks.TO_BE_KNOWN, 3)


def _short_verdict(step: Neighbour) -> str:
    """Name the kind of check that a step fails by, and no component again."""
    worst = None if step.point is None else step.point.checks.governing
    if step.point is None or worst is None:
        return step.reason
    if step.point.checks.passes and step.point.draws is not None:
        return Message("design.fails_in_draws", failing=100.0 * step.point.draws.failing)
    return worst.fails_as(Message(f"checks.{worst.kind}_short"))


def listed_designs(count: int, *named: int) -> tuple[int, ...]:
    """Choose the designs of a front that people see: all of few; of many some, evenly.

    Those that are named by their indices are among them in any case, as the two ends are.

    Examples
    --------
    >>> listed_designs(3, 1)
    (0, 1, 2)
    >>> listed_designs(100, 42)[:4], len(listed_designs(100, 42))
    ((0, 4, 8, 12), 27)
    """
    if count <= _MOST:
        return tuple(range(count))
    return tuple(sorted({*range(0, count, -(-count // _MOST)), count - 1, *named}))


# ------------------------------------------------------------------ the front


def _front(result: DesignResult) -> Iterator[blocks.Block]:
    """Tabulate the front, a row each design, with the tightest check of each kind in files."""
    of, count = Rows(result.front), len(result.front)
    shown = listed_designs(count, result.recommended - 1)
    best = [Message("answers.yes") if k == result.recommended else "" for k in range(1, count + 1)]
    caption = Message("captions.front_recommended")
    if len(shown) < count:
        caption = Message("captions.front_of", shown=len(shown), count=count)
    yield blocks.Text(_how(result))
    yield tabulate(
        "front",
        texts("design", range(1, count + 1)),
        texts("recommended", best, only="files"),
        *_objectives(result, of),
        *_drawn(of),
        *_moved(of),
        of.texts("line_from_the_anchor", made_of, only="people"),
        *_of_files(of),
        caption=caption,
        shown=shown,
        marked=result.recommended - 1,
    )
    yield blocks.Graph(Message("captions.front"), "front", x=2, y=(3,), points=True)
    yield from _fails_in_motion(result)


def _how(result: DesignResult) -> Message:
    exact = "design.exact_by_bounds" if result.excluded else "design.exact"
    return Message(
        exact if result.is_exact else "design.found",
        designs=result.designs,
        evaluations=result.evaluations,
        method=term(result.method),
        feasible=result.feasible,
        front=len(result.front),
        excluded=sum(result.excluded.values()),
        bounds=_bounds(result),
    )


def _bounds(result: DesignResult) -> Several:
    said = (Message(f"design.bound_{name}", count=count) for name, count in result.excluded.items())
    return Several(said)


def _objectives(result: DesignResult, of: Rows) -> Iterator[blocks.Column]:
    """Yield a column for each objective: those wanted first, then what else is known."""
    objectives = Rows(of.read("objectives"))
    for key, quantity in _known_objectives(result):
        yield objectives.measured(quantity, methodcaller("get", key), term(quantity.name))


def _drawn(of: Rows) -> Iterator[blocks.Column]:
    """Say in how many of the draws each design fails, where values are drawn."""
    if all(of.read("draws")):
        yield of.texts("fails_in_draws", lambda each: f"{each.draws.failing:.3g}")


def _moved(of: Rows) -> Iterator[blocks.Column]:
    """Say what each design came to in motion, where it has to pass there."""
    if all(of.read("in_motion")):
        yield of.measured(FORCE, "in_motion.largest_tension", "design.largest_in_motion")
        yield of.measured(RATIO, "in_motion.amplification", "motion.front_allowance", priority=1)
        yield of.measured(
            "utilisation", "in_motion.tightest.utilisation", "design.used_in_motion", priority=1
        )


def _short_in_motion(result: DesignResult) -> Iterator[blocks.Text]:
    """Say in one sentence what `_in_motion` says."""
    search, own = result.in_motion, result.best.in_motion
    if search is None or own is None or own.checks is None:
        return
    worst = own.checks.governing
    assert worst is not None
    used = "-" if worst.utilisation is None else f"{worst.utilisation:.3f}"
    values = {"check": worst.name, "used": used, "count": search.run}
    key = "design.short_in_motion" if search.complete else "design.short_of_some"
    yield blocks.Text(Message(key, **values, failing=len(search.failing)))


def _in_motion(result: DesignResult) -> Iterator[blocks.Verdict | blocks.Text]:
    """Say what the recommended design came to in motion, and how many were run."""
    search, own = result.in_motion, result.best.in_motion
    if search is None or own is None or own.checks is None:
        return
    yield blocks.Text(Message("design.passes_in_motion", verdict=report_sentence(own.checks)))
    yield blocks.Text(Message("design.governs_in_motion", said=governing_sentence(own.checks)))
    fails = Message("design.run_of_which_fail", count=search.run, failing=len(search.failing))
    proof = Message("design.run_again" if search.proven else "design.not_run_again")
    yield blocks.Text(Several((fails, proof), " "))
    if not search.complete:
        yield blocks.Verdict(Message("design.more_to_run"), passes=False)


def _fails_in_motion(result: DesignResult) -> Iterator[blocks.Block]:
    """Tabulate the designs that pass at rest and fail in motion."""
    search = result.in_motion
    if search is None:
        return
    yield from _in_motion(result)
    if search.failing:
        of = Rows(search.failing)
        yield tabulate(
            "fails_in_motion",
            *_objectives(result, Rows(of.read("point"))),
            of.texts("line_from_the_anchor", "made"),
            of.texts("verdict", "reason"),
            caption=Message("design.fails_in_motion"),
            shown=listed_designs(len(search.failing)),
        )


def _known_objectives(result: DesignResult) -> list[tuple[str, Quantity]]:
    known = result.front[0].objectives
    keys = dict.fromkeys((*result.objectives, *known))
    of_body = result.case.several_lines
    return [(key, objective(key, of_body=of_body)) for key in keys]


def _of_files(of: Rows) -> Iterator[blocks.Column]:
    """Say of what each design is made, of whole moorings the layout, and what governs.

    Of each kind of check that was made, how far the tightest of each design is used.
    """
    only: dict[str, Any] = {"only": "files"}
    yield of.texts("segments_from_the_anchor", lambda at: Several(segment_words(at.line)), **only)
    yield of.texts("clump_weights", lambda at: Several(clump_weight_words(at.line)), **only)
    yield of.texts("anchor", anchor_words, **only)
    if all(of.read("mooring")):
        yield of.texts("layout", lambda point: Several(layout_words(point)), **only)
        yield of.texts("farthest_in", "mooring.state", **only)
    tightest = Rows(tightest_checks(each) for each in of.read("checks"))
    for kind in QUANTITY_OF:
        checks = Rows(tightest.read(methodcaller("get", kind)))
        if any(checks.rows):
            yield checks.measured("utilisation", "utilisation", f"{kind}_utilisation", **only)
    yield of.texts("governing_check", "checks.nearest", **only)


# ------------------------------------------------------------------ the recommended design


def _recommended(result: DesignResult) -> Iterator[blocks.Block]:
    point = result.best
    said = Message("design.recommended", number=result.recommended)
    yield blocks.Text(said)
    yield blocks.Verdict.of_judgement(result.judgement)
    yield blocks.Text(result.recommendation)
    yield blocks.Facts("recommended", tuple(_made_of(result, point)), only="not csv")
    yield tightest_table(point.checks)
    yield blocks.Text(governing_sentence(point.checks))
    far = point.mooring
    if far is not None:
        yield blocks.Text(Message("design.farthest", offset=far.offset, state=far.state))
    yield from map(blocks.Text, result.ends)
    yield _neighbours(result)
    yield blocks.Warnings(result.warnings)


def _made_of(result: DesignResult, point: DesignPoint) -> Iterator[blocks.Fact]:
    """List the parts of a design and what its objectives come to."""
    for layout in layout_words(point):
        yield stated("layout", layout)
    for number, said in enumerate(segment_words(point.line), start=1):
        yield stated(Message("columns.segment_number", number=number), said)
    for said in clump_weight_words(point.line):
        yield stated("clump_weight", said)
    if point.anchor is not None:
        yield stated("anchor", anchor_words(point))
    for key, quantity in _known_objectives(result):
        yield blocks.Fact(term(quantity.name), point.objectives[key], quantity)


def _neighbours(result: DesignResult) -> blocks.Table:
    """Tabulate what one step of each variable would do to the recommended design.

    The last row is the line in the case file.
    """
    steps = Rows((*result.neighbours, result.present))
    return tabulate(
        "neighbours",
        steps.texts("change_to_the_recommended_design", "change"),
        *_objectives(result, Rows(steps.read("point"))),
        steps.texts("verdict", _verdict),
        caption=Message("captions.neighbours"),
    )


def _verdict(step: Neighbour) -> str:
    """Say whether a changed design is feasible, and by what it fails when it is not."""
    if step.point is None:
        return step.reason
    report = step.point.checks
    worst = report.governing
    if report.passes or worst is None:
        return Message("answers.passes")
    return worst.fails_as(worst.in_case)


# ------------------------------------------------------------------ in files alone


def _components(result: DesignResult) -> blocks.Table:
    """Tabulate the segments of every design, a row each from the anchor to the fairlead."""
    front = Rows(enumerate(result.front, start=1))
    designs, places = front.within(lambda row: enumerate(row[1].line.segments, start=1))
    of = Rows(segment for _, segment in places.rows)
    return tabulate(
        "components",
        designs.texts("design", itemgetter(0)),
        places.texts("segment", itemgetter(0)),
        of.texts("component", lambda each: each.component or each.name),
        *of.own("nominal_diameter", "length", "submerged_weight"),
        of.measured("mass_per_length", "mass"),
        *of.own("EA", "MBL", "proof_load", "price"),
        only="files",
    )


def _checks(result: DesignResult) -> blocks.Table:
    of, checks = Rows(enumerate(result.front, start=1)).within(lambda row: row[1].checks.results)
    columns = check_columns(checks.rows)
    return tabulate("checks", of.texts("design", itemgetter(0)), *columns, only="files")


def _loads(result: DesignResult) -> Iterator[blocks.Section]:
    """Tabulate what a body had to meet, where it is more than one force."""
    loads = () if result.case.design is None else result.case.design.loads
    if loads:
        of, title = Rows(loads), Message("captions.load_cases")
        columns = (
            of.texts("load_case", "name"),
            of.measured("horizontal_force", "force", "force", symbol="F"),
            of.measured("angle", "direction", "direction", symbol=""),
            of.texts("from_so_many_sides", "headings"),
            of.measured("height", "water_level", "water_level", symbol=""),
            of.measured("height", "fairlead_rise", "fairlead_rise", symbol=""),
            of.texts("each_line_out", lambda load: yes_or_no(load.line_out)),
        )
        yield section(title, blocks.Table("loads", columns, title))


def front_in_motion_answer(found: FrontInMotion) -> blocks.Answer:
    """Lay out a front in motion: a row a design, and what is recommended then."""
    title = Message("captions.front")
    return answered("front_in_motion", title, section("motion.front", *_run_designs(found)))


def _run_designs(found: FrontInMotion) -> Iterator[blocks.Block]:
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
    verdict = of.texts("verdict", _verdict_in_motion, passes=tuple(each.passes for each in designs))
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


def _verdict_in_motion(each: DesignInMotion) -> Message:
    if each.found is None:
        return term("NO ANSWER")
    if each.found.verdict == "not converged":
        return Message("motion.front_not_converged")
    return Message("answers.passes" if each.passes else "answers.fails")
