"""What a report of checks consists of."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from catopt.answers import blocks
from catopt.answers.blocks import (
    Rows,
    answered,
    if_known,
    largest,
    measured,
    section,
    tabulate,
    texts,
    yes_or_no,
)
from catopt.answers.solution import force_name
from catopt.checks.kinds import QUANTITY_OF
from catopt.figures.line import Failing
from catopt.words import Measure, Message, Several, term

if TYPE_CHECKING:
    from catopt.checks.kinds import CheckSource
    from catopt.checks.result import CheckReport, CheckResult


def check_answer(report: CheckReport, *, of_points: bool = False) -> blocks.Answer:
    """Lay out a report of checks; `of_points`: of lines between points."""
    tables = checked_body(report) if report.places else checked(report)
    said = (*_confidence(report), *verdict_blocks(report), blocks.Warnings(report.others))
    whole = answered(
        "check",
        report.title or Message("captions.mooring_line"),
        section("captions.checks", *first_blocks(report), *tables, *said),
        section("captions.load_cases", load_case_table(report)),
    )
    in_current = any(solution.method == "shooting" for _, solution in report.solutions)
    following = "check_in_current" if in_current and not report.places else ""
    if of_points:
        following = "check_points"
    return replace(whole, card=tuple(_card(report)), next=following)


def _card(report: CheckReport) -> Iterator[blocks.CardBlock]:
    """Say what the checks come to, the tightest of each kind, and what they rest on."""
    tightest = tightest_checks(report)
    checks = list(tightest.values())
    of = Rows(checks)
    yield from first_blocks(report)
    yield from verdict_blocks(report)
    if checks:
        yield tabulate(
            "card",
            texts("check", map(kind_name, tightest)),
            *_use(checks),
            verdict_column(each.passes for each in checks),
            *(if_known(of.texts("line", "place.line"))),
            of.texts("load_case"),
            of.texts("by", lambda each: _by(each.source)),
        )
    others = [each for each in report.failed if each not in checks]
    cases = (load_case_words(report, k) for k in range(len(report.solutions)))
    by = dict.fromkeys(Several(filter(None, (_by(of.source), of.note)), ": ") for of in checks)
    for label, said in {
        "fails": [each.in_case for each in others],
        "load_cases": () if report.places else cases,
        "assumed": by,
        "to_be_known": report.others,
    }.items():
        yield from blocks.briefly(said, Message(f"answers.card_{label}"), 3)


def first_blocks(report: CheckReport) -> Iterator[blocks.Text]:
    """Say what stands before any answer: what is under water."""
    yield from map(blocks.Text, report.first)


def verdict_blocks(report: CheckReport) -> Iterator[blocks.Verdict | blocks.Text]:
    """Say whether all checks are passed, what was not judged, and which governs."""
    yield blocks.Verdict.of_judgement(report.judgement)
    if report.results:
        yield blocks.Text(governing_sentence(report))


def failing_checks(report: CheckReport) -> tuple[Failing, ...]:
    """List the checks that fail for a drawing, each once, in whichever load case."""
    failing = {
        (each.kind, each.place.segment): Failing(each.kind, each.place.segment, each.name)
        for each in report.results
        if not each.passes
    }
    return tuple(failing.values())


def checked(report: CheckReport) -> tuple[blocks.Table, blocks.Table]:
    """Tabulate the checks of a line by load case, and once each criterion."""
    results, of = report.results, [each.load_case for each in report.results]
    parts = tuple(
        (load_case_words(report, k), tuple(row for row, own in enumerate(of) if own == name))
        for k, (name, _) in enumerate(report.solutions)
    )
    return blocks.Table("checks", check_columns(results), parts=parts), _criteria(results)


def checked_body(report: CheckReport) -> tuple[blocks.Block, ...]:
    """Tabulate what each state of a body comes to, the tightest checks, and their criteria."""
    results, governing = report.results, report.governing
    marked = None if governing is None else results.index(governing)
    shown = sorted({*report.tightest_by_state, *([] if marked is None else [marked])})
    columns = check_columns(results, of_a_body=True)
    return (
        _states(report),
        blocks.Table("checks", columns, shown=tuple(shown), marked=marked),
        blocks.Text(Message("checks.tightest_shown", count=len(results)), is_small=True),
        _criteria([results[row] for row in shown]),
    )


def checks_in_motion(report: CheckReport) -> Iterator[blocks.Block]:
    """Lay out the checks of lines in motion: people see the tightest of a body's, files all."""
    results = report.results
    of_a_body = any(each.place.line is not None for each in results)
    if results:
        shown = report.tightest_by_state if of_a_body else tuple(range(len(results)))
        yield motion_table("dynamic_checks", report, shown, of_a_body=of_a_body)
        yield _criteria([results[row] for row in shown])
        yield from _confidence(report)
    yield from verdict_blocks(report)
    yield blocks.Warnings(report.warnings)


def motion_table(
    name: str, report: CheckReport, shown: tuple[int, ...], *, of_a_body: bool
) -> blocks.Table:
    """Tabulate checks in motion; people see some rows, by load case where there are several."""
    results = report.results
    names = dict.fromkeys(results[row].load_case for row in shown)
    return blocks.Table(
        name,
        check_columns(results, of_a_body=of_a_body),
        Message("captions.checks_in_motion"),
        shown=shown if of_a_body else None,
        parts=tuple(
            (
                Message("captions.checks_in_motion_of", name=each),
                tuple(row for row in shown if results[row].load_case == each),
            )
            for each in (names if len(names) > 1 else ())
        ),
    )


def check_columns(
    results: Sequence[CheckResult], *, of_a_body: bool = False
) -> tuple[blocks.Column, ...]:
    """List checks, a row each: what is required, what there is, and by which criterion.

    Of a body with several lines, state and line head each row.
    """
    of = Rows(results)
    if of_a_body:
        first: tuple[blocks.Column, ...] = (
            of.texts("where", _where, only="people"),
            of.texts("check", _short, only="people"),
            of.texts("state", "load_case", only="files"),
            of.texts("line", "place.line", only="files"),
            of.texts("check", "name", only="files"),
        )
    else:
        first = (of.texts("load_case", only="files"), of.texts("check", "name"))
    return (
        *first,
        *_use(results),
        of.texts("passes", lambda each: yes_or_no(each.passes), only="files"),
        replace(verdict_column(each.passes for each in results), only="people"),
        of.texts("by", lambda each: _by(each.source), only="people"),
        of.texts("code", lambda each: term(each.source.code), only="files"),
        of.texts("source", "source.text", only="files"),
        of.texts("note", only="files"),
    )


def verdict_column(
    passes: Iterable[bool], good: str = "answers.passes", bad: str = "answers.fails"
) -> blocks.Column:
    """Say of each row whether it passes or fails."""
    every = tuple(passes)
    return texts("verdict", [Message(good if each else bad) for each in every], passes=every)


def _use(results: Sequence[CheckResult]) -> tuple[blocks.Column, blocks.Column, blocks.Column]:
    of = Rows(results)
    units = tuple(QUANTITY_OF[each.kind] for each in results)
    demand, capacity = (of.texts(name, units=units) for name in ("demand", "capacity"))
    used = of.measured("utilisation", "utilisation", formula=(demand, "/", capacity))
    return demand, capacity, used


def kind_name(kind: str) -> Message:
    """Name a kind of check: ``Uplift angle``."""
    return Message(f"checks.{kind}_kind")


def tightest_checks(report: CheckReport) -> dict[str, CheckResult]:
    """Find the check of each kind that is nearest to its limit, in the order of tables."""
    found = {kind: report.tightest(kind) for kind in QUANTITY_OF}
    return {kind: check for kind, check in found.items() if check is not None}


def tightest_table(report: CheckReport) -> blocks.Table:
    """Tabulate the check of each kind that is nearest to its limit."""
    found = tightest_checks(report)
    checks = list(found.values())
    where = [Several((each.load_case, each.source.text)) for each in checks]
    return tabulate(
        "tightest",
        texts("check", map(kind_name, found)),
        *_use(checks),
        texts("load_case_and_source", where),
        caption=Message("captions.tightest"),
        only="not csv",
    )


def _where(result: CheckResult) -> str:
    """Say of which line a check is, or that it is of the body, and in which state."""
    if result.place.line is not None:
        return result.where
    return Message("checks.of_line", line=Message("checks.body"), name=result.load_case)


def _short(result: CheckResult) -> str:
    """Name a check without what its segment is made of."""
    number = result.place.segment
    if number is None:
        return result.name
    return Message("checks.tension", segment=Message("checks.segment", number=number))


def _states(report: CheckReport) -> blocks.Table:
    """Tabulate the largest utilisation of each state by each code, and what the state comes to."""
    by_state: dict[str, list[CheckResult]] = {}
    for each in report.results:
        by_state.setdefault(each.load_case, []).append(each)
    codes = {each.source.code: each.source for each in report.results}
    used = (
        measured(
            "utilisation",
            [
                largest(each.utilisation for each in results if each.source.code == code)
                for results in by_state.values()
            ],
            Message("checks.by_code", code=source.text if source.confidence is None else code),
        )
        for code, source in codes.items()
    )
    return tabulate(
        "states",
        texts("state", by_state),
        *used,
        verdict_column(all(each.passes for each in checks) for checks in by_state.values()),
        caption=Message("captions.states"),
    )


def _by(source: CheckSource) -> str:
    return source.text if source.confidence is None else f"{source.code} [{source.confidence}]"


def _criteria(results: Sequence[CheckResult]) -> blocks.Table:
    """Say once how each capacity comes about, and where the criterion stands."""
    rows = dict.fromkeys(
        (each.name, _by(each.source), each.note, each.source.text) for each in results
    )
    sources = [
        Several(part for part in (note, text if text != by else "") if part)
        for _, by, note, text in rows
    ]
    return tabulate(
        "criteria",
        texts("check", [row[0] for row in rows]),
        texts("by", [row[1] for row in rows]),
        texts("capacity_and_source", sources),
        caption=Message("captions.criteria"),
        only="people",
    )


def _confidence(report: CheckReport) -> Iterator[blocks.Text]:
    if any(each.source.confidence for each in report.results):
        yield blocks.Text(Message("answers.confidence"))


def load_case_table(report: CheckReport) -> blocks.Table:
    """Tabulate how the line hangs in each load case."""
    of, places = Rows(solution for _, solution in report.solutions), Rows(report.places)
    kinds = [state.kind for state in report.load_cases] or ["extreme"] * len(of.rows)
    at_place = (places.texts("line"), places.texts("line_out", "missing"))
    return tabulate(
        "load_cases",
        texts("load_case", [name for name, _ in report.solutions]),
        *(at_place if report.places else ()),
        texts("kind", [Message(f"answers.{kind}") for kind in kinds]),
        *of.own("fairlead_height"),
        of.measured("horizontal_force", "horizontal_force", force_name(of.rows)),
        *of.own("span"),
        of.measured("tension", "fairlead.tension", "fairlead_tension"),
        of.measured("vertical_force", "fairlead.vertical_force", "fairlead_vertical_force"),
        of.measured("horizontal_force", "anchor.horizontal_force", "anchor_horizontal_force"),
        of.measured("vertical_force", "anchor.vertical_force", "anchor_vertical_force"),
        of.measured("angle", "anchor.angle", "inclination_at_the_anchor"),
        *of.own("grounded_length"),
        only="files",
    )


# ------------------------------------------------------------------ sentences


def governing_sentence(report: CheckReport) -> str:
    """Say which check governs, and how far it is used; empty when nothing was checked."""
    found = report.governing
    if found is None:
        return ""
    of_a_body = bool(report.places) or found.place.line is not None
    return Message(
        "checks.governing_of_body" if of_a_body else "checks.governing",
        check=found.name,
        load_case=_where(found) if of_a_body else found.load_case,
        how=_used(found),
        source=found.source.text,
    )


def _used(result: CheckResult) -> str:
    """Say how far a check is used; its demand beside its capacity where that is no ratio."""
    if result.kind == "equilibrium":
        return result.note
    if result.utilisation is not None:
        return Message("checks.utilisation", used=result.utilisation)
    return Message("checks.beside", **demand_and_capacity(result))


def demand_and_capacity(result: CheckResult) -> dict[str, Measure]:
    """Say what is required and what there is, each with its unit."""
    key = QUANTITY_OF[result.kind].key
    return {name: Measure(key, getattr(result, name)) for name in ("demand", "capacity")}


def load_case_words(report: CheckReport, index: int) -> Message:
    """Name a load case with its force: ``"storm (extreme), horizontal force 450.000 kN"``."""
    name, solution = report.solutions[index]
    kind = report.load_cases[index].kind if report.load_cases else ""
    key = f"checks.{kind}_load_case" if kind else "checks.load_case"
    force: Any = Measure("horizontal_force", solution.horizontal_force)
    if solution.force_varies:
        force = Message("checks.at_the_fairlead", force=force)
    return Message(key, name=name, force=force, height=solution.fairlead_height)
