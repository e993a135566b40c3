"""The note's part of the particle swarm: its numbers, its figure, its words and its sheet."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from io import BytesIO
from typing import Any

import openpyxl
import pytest

from catopt.errors import InputError
from catopt.figures.swarm import fitness
from catopt.quantities import QUANTITIES
from catopt.render.svg import svg
from catopt.render.texts import Words
from catopt.report.page.render import render_page
from catopt.report.page.swarm import MOST_RUNS, swarm
from catopt.report.workbook.note import note_workbook
from tests.cli.vietnamese import gathered, untranslated

from .conftest import buoy_case, report_with
from .further_cases import further_note, further_page, same_words
from .page_cases import known_note, known_page
from .page_reader import read_page

ROUNDING = 1e-15
"""Relative: the workbook keeps 16 significant digits."""


def shown_values(figure_key: str, page: Any) -> list[str]:
    """Read the words of a figure's points."""
    index = next(
        k
        for k, element in enumerate(page.elements)
        if element.attributes.get("data-figure") == figure_key
    )
    words = next(
        e.text for e in page.elements[index:] if e.attributes.get("type") == "application/json"
    )
    found: list[str] = json.loads(words)
    return found


def test_it_is_there_only_where_somebody_asked() -> None:
    assert "swarm" not in known_page("tanker-20m").sections
    assert "swarm" in further_page("swarm").sections
    assert swarm(known_note("tanker-20m"), Words()) is None


def test_what_the_swarm_did_is_what_solve_tells() -> None:
    solution = further_note("swarm").swarm
    assert solution is not None
    document = solution.to_dict()["pso"]
    values = [row[1].value for row in further_page("swarm").table("swarm_outcome").rows]
    flown = len(solution.swarm.best_objective_history)  # type: ignore[union-attr]
    assert values == [
        document["objective"], document["best_run"], flown, document["converged_runs"],
        document["evaluations"], document["span_consistency_m"],
    ]  # fmt: skip


def test_each_result_stands_beside_the_closed_form() -> None:
    note, table = further_note("swarm"), further_page("swarm").table("swarm_results")
    assert note.swarm is not None
    found, exact = note.swarm.to_dict(), note.solution.to_dict()
    for label, key in (("Span S", "span_m"), ("Grounded length", "grounded_length_m")):
        row = table.row(label)
        assert [cell.value for cell in row[1:3]] == [found[key], exact[key]]
    row = table.row("Fairlead tension T")
    assert [cell.value for cell in row[1:3]] == [
        found["fairlead"]["tension_N"], exact["fairlead"]["tension_N"],
    ]  # fmt: skip
    for row in table.rows:
        one, other, difference = (cell.value for cell in row[1:])
        assert one is not None
        assert other is not None
        assert difference == one - other
    told = found["pso"]["closed_form_difference"]
    assert table.row("Span S")[3].value == told["span_m"]
    assert table.row("Grounded length")[3].value == told["grounded_length_m"]
    assert table.row("Fairlead tension T")[3].value == told["tension_N"]


def test_the_closed_form_stays_the_base() -> None:
    plain, with_swarm = further_note("swarm"), further_page("swarm")
    assert plain.solution.method == "closed-form"
    span = with_swarm.table("results").row("Span S")
    assert span[1].value == plain.solution.span


def test_the_runs_and_the_settings() -> None:
    note, page = further_note("swarm"), further_page("swarm")
    assert note.swarm is not None
    report = note.swarm.swarm
    assert report is not None
    table = page.table("swarm_runs")
    assert [cell.value for cell in table.column(1)] == list(report.objectives)
    assert [cell.value for cell in table.column(2)] == list(report.iterations_flown)
    assert table.marked == [report.best_run - 1]
    settings = page.table("swarm_settings")
    for label, value in (("Particles", 40), ("Runs", 3), ("Seed", 7), ("Inertia w", 0.4)):
        assert settings.row(label)[1].value == value
    assert settings.row("Boundary handling")[1].text == "reflective"


def test_the_figure_falls_as_the_history_does() -> None:
    note = further_note("swarm")
    assert note.swarm is not None
    report = note.swarm.swarm
    assert report is not None
    figure = svg(fitness(report))
    words = shown_values("swarm", further_page("swarm"))
    assert words == [point.text for point in figure.points]
    drawn = [f for f in report.best_objective_history if f >= 1e-9]
    assert len(words) == len(drawn) > 10
    for number, (text, f) in enumerate(zip(words, drawn, strict=True), start=1):
        shown = QUANTITIES["objective"].format(f, unit=True)
        assert text.startswith(f"iteration {number}: f = {shown}, T = ")
    heights = [point.y for point in figure.points]
    assert heights == sorted(heights), "the best so far never gets worse"


def test_many_runs_are_left_out_and_none_converged_is_said() -> None:
    note = further_note("swarm")
    assert note.swarm is not None
    many = replace(
        report_with((1.0, 1e-7)), runs=40, objectives=(1e-7,) * 40, converged_runs=0,
        iterations_flown=(2,) * 40,
    )  # fmt: skip
    changed = replace(note, swarm=replace(note.swarm, swarm=many))
    page = read_page(render_page(changed))
    assert len(page.table("swarm_runs").rows) == MOST_RUNS
    assert f"{40 - MOST_RUNS} more runs" in page.sections["swarm"]
    (verdict,) = page.styled("verdict", "swarm")
    assert "fails" in verdict.attributes["class"]
    assert "0 of 40 runs" in verdict.text


def test_a_line_that_the_swarm_refuses_is_refused() -> None:
    from catopt.notes.directory import Asked
    from catopt.notes.line import note_of
    from catopt.notes.origin import SourceFile

    case = replace(buoy_case(), load=type(buoy_case().load)(span=17.4))  # type: ignore[misc]
    source = SourceFile("case.toml", "title = 'x'", "0" * 64)
    with pytest.raises(InputError, match="the swarm method wants one"):
        note_of(case, (source,), asked=Asked(swarm=True))


def test_vietnamese_lacks_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    missing = gathered(monkeypatch)
    assert swarm(further_note("swarm"), Words("vi")) is not None
    assert untranslated(missing) == []
    monkeypatch.undo()
    page, solution = further_page("swarm", "vi"), further_note("swarm").swarm
    assert solution is not None
    assert page.table("swarm_results").row("Độ dạt ngang S")[1].value == solution.span
    assert same_words("swarm", "Swarm", "Bầy đàn") <= {"kN", "m", "deg", "reflective", "f < 1e-9 m"}


def test_the_sheet() -> None:
    note = further_note("swarm")
    assert note.swarm is not None
    report = note.swarm.swarm
    assert report is not None
    book: Any = openpyxl.load_workbook(BytesIO(note_workbook(note)), data_only=True)
    sheet = book["Swarm"]
    assert len(sheet._charts) == 2
    rows = {row[0]: row for row in sheet.iter_rows(values_only=True) if row[0]}
    _, _, found, exact, difference = rows["Span S"][:5]
    assert (found, exact) == pytest.approx((note.swarm.span, note.solution.span), rel=ROUNDING)
    assert difference == note.swarm.span - note.solution.span
    top = next(cell.row for (cell,) in sheet.iter_rows(max_col=1) if cell.value == "Iteration")
    values = [
        sheet.cell(top + n, 3).value for n in range(1, len(report.best_objective_history) + 1)
    ]
    for value, f in zip(values, report.best_objective_history, strict=True):
        assert math.isclose(value, f, rel_tol=ROUNDING)
    assert (
        "Swarm"
        not in openpyxl.load_workbook(BytesIO(note_workbook(known_note("tanker-20m")))).sheetnames
    )
