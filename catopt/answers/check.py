"""What a report of checks consists of."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
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
    Warnings,
    measured,
    texts,
)
from catopt.checks.kinds import QUANTITY_OF
from catopt.figures.line import Failing
from catopt.words import Measure, Message, Several, term

if TYPE_CHECKING:
    from catopt.checks.criterion import CheckSource
    from catopt.checks.result import CheckReport, CheckResult

_LOAD_CASES = {
    "": "checks.load_case",
    "extreme": "checks.extreme_load_case",
    "reference": "checks.reference_load_case",
}


def check_answer(report: CheckReport) -> Answer:
    """Lay out a report of checks."""
    tables = checked_body(report) if report.places else checked(report)
    said: list[Block] = [Verdict(verdict_sentence(report), report.passes)]
    if report.results:
        said.append(Text(governing_sentence(report)))
    return Answer(
        "check",
        report.title or Message("captions.mooring_line"),
        (
            Section(
                Message("captions.checks"),
                (*tables, *_confidence(report), *said, Warnings(report.warnings)),
            ),
            Section(Message("captions.load_cases"), (load_case_table(report),)),
        ),
    )


def failing_checks(report: CheckReport) -> tuple[Failing, ...]:
    """List the checks that fail for a drawing, each once, in whichever load case."""
    failing = {
        (each.kind, each.place.segment): Failing(each.kind, each.place.segment, each.name)
        for each in report.results
        if not each.passes
    }
    return tuple(failing.values())


def checked(report: CheckReport) -> tuple[Table, Table]:
    """Tabulate the checks of a line by load case, and once each criterion."""
    return _checks(report), _criteria(report.results)


def checked_body(report: CheckReport) -> tuple[Block, ...]:
    """Tabulate what each state of a body comes to, the tightest checks, and their criteria."""
    table = _of_body(report)
    said = Message("checks.tightest_shown", count=len(report.results))
    return (
        _states(report),
        table,
        Text(said, is_small=True),
        _criteria([report.results[row] for row in table.shown or ()]),
    )


def checks_in_motion(report: CheckReport) -> Iterator[Block]:
    """Lay out the checks of lines in motion: people see the tightest of a body's, files all."""
    results = report.results
    of_a_body = any(each.place.line is not None for each in results)
    if results:
        shown = report.tightest_by_state if of_a_body else tuple(range(len(results)))
        names = dict.fromkeys(results[row].load_case for row in shown)
        yield Table(
            "dynamic_checks",
            check_columns(results, of_a_body=of_a_body),
            Message("captions.checks_in_motion"),
            shown=shown if of_a_body else None,
            parts=tuple(
                (
                    Message("captions.checks_in_motion_of", name=name),
                    tuple(row for row in shown if results[row].load_case == name),
                )
                for name in (names if len(names) > 1 else ())
            ),
        )
        yield _criteria([results[row] for row in shown])
        yield from _confidence(report)
    yield Verdict(verdict_sentence(report), report.verdict is True)
    if results:
        yield Text(governing_sentence(report))
    yield Warnings(report.warnings)


def check_columns(results: Sequence[CheckResult], *, of_a_body: bool = False) -> tuple[Column, ...]:
    """List checks, a row each: what is wanted, what there is, and by which criterion.

    Of a body with several lines, state and line head each row.
    """
    states = [each.load_case for each in results]
    if of_a_body:
        first: tuple[Column, ...] = (
            texts("where", [_where(each) for each in results], only="people"),
            texts("check", [_short(each) for each in results], only="people"),
            texts("state", states, only="files"),
            texts("line", [each.place.line for each in results], only="files"),
            texts("check", [each.name for each in results], only="files"),
        )
    else:
        first = (
            texts("load_case", states, only="files"),
            texts("check", [each.name for each in results]),
        )
    return (
        *first,
        *_use(results),
        texts("passes", [_yes(each.passes, "yes", "no") for each in results], only="files"),
        Column(
            Message("columns.verdict"),
            tuple(_yes(each.passes, "passes", "fails") for each in results),
            only="people",
            passes=tuple(each.passes for each in results),
        ),
        texts("by", [_by(each.source) for each in results], only="people"),
        texts("code", [term(each.source.code) for each in results], only="files"),
        texts("source", [each.source.text for each in results], only="files"),
        texts("note", [each.note for each in results], only="files"),
    )


def _use(results: Sequence[CheckResult]) -> tuple[Column, Column, Column]:
    units = tuple(QUANTITY_OF[each.kind] for each in results)
    demands = tuple(each.demand for each in results)
    capacities = tuple(each.capacity for each in results)
    demand = Column(Message("columns.demand"), demands, units=units)
    capacity = Column(Message("columns.capacity"), capacities, units=units)
    used = measured("utilisation", [each.utilisation for each in results])
    return demand, capacity, replace(used, formula=(demand, "/", capacity))


def kind_name(kind: str) -> Message:
    """Name a kind of check: ``Uplift angle``."""
    return Message(f"kinds.{kind}")


def tightest_checks(report: CheckReport) -> dict[str, CheckResult]:
    """Find the check of each kind that is nearest to its limit, in the order of tables."""
    found = {kind: report.tightest(kind) for kind in QUANTITY_OF}
    return {kind: check for kind, check in found.items() if check is not None}


def tightest_table(report: CheckReport) -> Table:
    """Tabulate the check of each kind that is nearest to its limit."""
    found = tightest_checks(report)
    checks = list(found.values())
    where = [Several((each.load_case, each.source.text)) for each in checks]
    return Table(
        "tightest",
        (
            texts("check", [kind_name(kind) for kind in found]),
            *_use(checks),
            texts("load_case_and_source", where),
        ),
        Message("captions.tightest"),
        only="not csv",
    )


def _yes(passes: bool, yes: str, no: str) -> Message:
    return Message(f"answers.{yes if passes else no}")


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


def _of_body(report: CheckReport) -> Table:
    """Tabulate the checks of a body; people see, intact and with one line out, the tightest."""
    governing = report.governing
    marked = [] if governing is None else [report.results.index(governing)]
    return Table(
        "checks",
        check_columns(report.results, of_a_body=True),
        shown=tuple(sorted({*report.tightest_by_state, *marked})),
        marked=marked[0] if marked else None,
    )


def _states(report: CheckReport) -> Table:
    """Tabulate the largest utilisation of each state by each code, and what the state comes to."""
    by_state: dict[str, list[CheckResult]] = {}
    for each in report.results:
        by_state.setdefault(each.load_case, []).append(each)
    codes = {each.source.code: each.source for each in report.results}
    used = [[_most(of, code) for of in by_state.values()] for code in codes]
    names = (each.text if each.confidence is None else each.code for each in codes.values())
    passes = tuple(all(each.passes for each in of) for of in by_state.values())
    return Table(
        "states",
        (
            texts("state", by_state),
            *(
                replace(measured("utilisation", values), name=Message("checks.by_code", code=name))
                for name, values in zip(names, used, strict=True)
            ),
            Column(
                Message("columns.verdict"),
                tuple(_yes(each, "passes", "fails") for each in passes),
                passes=passes,
            ),
        ),
        Message("captions.states"),
    )


def _most(results: Sequence[CheckResult], code: str) -> float | None:
    """Largest utilisation of the checks by a code."""
    used = (each.utilisation for each in results if each.source.code == code)
    return max((each for each in used if each is not None), default=None)


def _checks(report: CheckReport) -> Table:
    parts = tuple(
        (
            load_case_words(report, index),
            tuple(row for row, each in enumerate(report.results) if each.load_case == name),
        )
        for index, (name, _) in enumerate(report.solutions)
    )
    return Table("checks", check_columns(report.results), parts=parts)


def _by(source: CheckSource) -> str:
    return source.text if source.confidence is None else f"{source.code} [{source.confidence}]"


def _criteria(results: Sequence[CheckResult]) -> Table:
    """Say once how each capacity comes about, and where the criterion stands."""
    rows = tuple(
        dict.fromkeys(
            (each.name, _by(each.source), each.note, each.source.text) for each in results
        )
    )
    sources = [
        Several(part for part in (note, text if text != by else "") if part)
        for _, by, note, text in rows
    ]
    return Table(
        "criteria",
        (
            texts("check", [row[0] for row in rows]),
            texts("by", [row[1] for row in rows]),
            texts("capacity_and_source", sources),
        ),
        Message("captions.criteria"),
        only="people",
    )


def _confidence(report: CheckReport) -> Iterator[Text]:
    if any(each.source.confidence for each in report.results):
        yield Text(Message("answers.confidence"))


def load_case_table(report: CheckReport) -> Table:
    """Tabulate how the line hangs in each load case."""
    solved = [solution for _, solution in report.solutions]
    kinds = [state.kind for state in report.load_cases] or ["extreme"] * len(solved)
    return Table(
        "load_cases",
        (
            texts("load_case", [name for name, _ in report.solutions]),
            *_places(report),
            texts("kind", [Message(f"answers.{kind}") for kind in kinds]),
            measured("fairlead_height", (each.fairlead_height for each in solved)),
            measured("horizontal_force", (each.horizontal_force for each in solved)),
            measured("span", (each.span for each in solved)),
            measured("tension", (each.fairlead.tension for each in solved), "fairlead_tension"),
            measured(
                "vertical_force",
                (each.fairlead.vertical_force for each in solved),
                "fairlead_vertical_force",
            ),
            measured(
                "horizontal_force",
                (each.anchor.horizontal_force for each in solved),
                "anchor_horizontal_force",
            ),
            measured(
                "vertical_force",
                (each.anchor.vertical_force for each in solved),
                "anchor_vertical_force",
            ),
            measured("angle", (each.anchor.angle for each in solved), "inclination_at_the_anchor"),
            measured("grounded_length", (each.grounded_length for each in solved)),
        ),
        only="files",
    )


def _places(report: CheckReport) -> Iterator[Column]:
    if report.places:
        yield texts("line", [each.line for each in report.places])
        yield texts("line_out", [each.missing for each in report.places])


# ------------------------------------------------------------------ sentences


def verdict_sentence(report: CheckReport) -> Message:
    """Say whether all checks are passed: ``"2 of 9 checks fail."``."""
    count, failed = len(report.results), len(report.failed)
    if not count:
        return Message("checks.nothing")
    if failed:
        return Message("checks.some_fail", count=failed, checks=count)
    return Message("checks.all_pass", count=count)


def governing_sentence(report: CheckReport) -> str:
    """Say which check governs, and how far it is used; empty when nothing was checked."""
    found = report.governing
    if found is None:
        return ""
    values = {
        "check": found.name,
        "load_case": found.load_case,
        "how": _used(found),
        "source": found.source.text,
    }
    if not report.places:
        return Message("checks.governing", **values)
    return Message("checks.governing_of_body", **(values | {"load_case": _where(found)}))


def _used(result: CheckResult) -> str:
    """Say how far a check is used; its demand beside its capacity where that is no ratio."""
    if result.kind == "equilibrium":
        return result.note
    if result.utilisation is not None:
        return Message("checks.utilisation", used=result.utilisation)
    key = QUANTITY_OF[result.kind].key
    demand, capacity = (Measure(key, value) for value in (result.demand, result.capacity))
    return Message("checks.beside", demand=demand, capacity=capacity)


def load_case_words(report: CheckReport, index: int) -> Message:
    """Name a load case with its force: ``"storm (extreme), horizontal force 450.000 kN"``."""
    name, solution = report.solutions[index]
    key = _LOAD_CASES[report.load_cases[index].kind if report.load_cases else ""]
    force = Measure("horizontal_force", solution.horizontal_force)
    return Message(key, name=name, force=force, height=solution.fairlead_height)
