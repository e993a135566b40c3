"""What a load curve consists of."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from catopt.answers.blocks import (
    Answer,
    Column,
    Facts,
    For,
    Graph,
    Section,
    Table,
    Text,
    measured,
    texts,
)
from catopt.answers.solution import (
    found_facts,
    given_facts,
    given_tables,
    point_loads_table,
    regime_name,
    result_facts,
    segments_table,
)
from catopt.words import Measure, Message

if TYPE_CHECKING:
    from catopt.catenary.case_curve import CaseCurve

_ROWS = 20
_OVER = {"force": "curve.over_force", "span": "curve.over_span", "offset": "curve.over_offset"}


def curve_answer(result: CaseCurve) -> Answer:
    """Lay out a load curve, its marks, and the case that it belongs to."""
    case, reference = result.case, result.reference
    inputs = Facts("inputs", tuple(given_facts(case)), only="workbook")
    summary = Facts("summary", result_facts(reference), only="workbook")
    points, marks = points_table(result), marks_table(result)
    graph = Graph(case.title, points.name, x=0, y=(2, 3))
    given = (_for_files(each) for each in given_tables(case.line))
    carried = [_for_files(segments_table(reference))]
    if reference.point_loads:
        carried.append(_for_files(point_loads_table(reference)))
    none = () if result.curve.marks else (Text(Message("curve.no_marks")),)
    return Answer(
        "curve",
        case.title or Message("captions.mooring_line"),
        (
            Section(Message("captions.curve"), (*_opening(result), points, graph)),
            Section(Message("captions.marks"), (marks, *none)),
            Section(Message("captions.inputs"), (inputs, *given)),
            Section(Message("captions.results"), (summary, *carried)),
        ),
    )


def _for_files(table: Table) -> Table:
    return Table(f"{table.name}_of_case", table.columns, table.caption, only="workbook")


def _opening(result: CaseCurve) -> Iterator[Text]:
    curve, reference = result.curve, result.reference
    yield Text(Message(_OVER[result.over], points=len(curve.span)))
    yield Text(Message("curve.range", range=result.range_words))
    for each in found_facts(reference):
        assert reference.found is not None
        assert each.quantity is not None
        assert isinstance(each.value, float)
        value = Measure(each.quantity.key, each.value)
        condition = reference.found.condition
        yield Text(Message("curve.found", name=each.name, value=value, condition=condition))
    if result.over == "offset":
        yield Text(Message("curve.zero", span=Measure("span", reference.span)))
    regime = Message(f"solution.{curve.regime[0].replace('-', '_')}")
    yield Text(Message("curve.lower_end", regime=regime))


def points_table(result: CaseCurve) -> Table:
    """Tabulate the points of a load curve, by rising span."""
    curve = result.curve
    count = len(curve.span)
    shown = tuple(sorted({round(k * (count - 1) / (_ROWS - 1)) for k in range(_ROWS)}))
    some = len(shown) < count
    caption = Message("captions.some_points", shown=len(shown), points=count)
    return Table(
        "curve",
        (
            *_places(result, curve.span.tolist()),
            measured("horizontal_force", curve.horizontal_force.tolist()),
            measured("tension", curve.fairlead_tension.tolist(), "fairlead_tension"),
            measured("tension", curve.anchor_tension.tolist(), "anchor_tension", symbol="TA"),
            measured(
                "angle", curve.anchor_angle.tolist(), "inclination_at_the_anchor", symbol="theta0"
            ),
            measured("grounded_length", curve.grounded_length.tolist()),
            measured("stiffness", curve.stiffness.tolist()),
            texts("regime", [regime_name(each) for each in curve.regime], only="files"),
        ),
        caption if some else Message("captions.curve_points"),
        shown,
    )


def marks_table(result: CaseCurve) -> Table:
    """Tabulate where something changes along a load curve, by rising span."""
    marks = result.curve.marks
    return Table(
        "curve_marks",
        (
            texts("kind", [Message(f"curve.{mark.kind}") for mark in marks], only="files"),
            texts("what_happens", [mark.event for mark in marks]),
            *_places(result, [mark.span for mark in marks]),
            measured("horizontal_force", [mark.horizontal_force for mark in marks]),
            measured("tension", [mark.fairlead_tension for mark in marks], "fairlead_tension"),
        ),
        Message("captions.marks"),
    )


def _places(result: CaseCurve, spans: list[float]) -> tuple[Column, Column]:
    """List span and offset; people see the one that was not left out by what is stepped."""
    zero = result.reference.span
    of_offset = result.over == "offset"
    span: For = "files" if of_offset else "all"
    offset: For = "all" if of_offset else "files"
    return (
        measured("span", spans, only=span),
        measured("offset", [each - zero for each in spans], only=offset),
    )
