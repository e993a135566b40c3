"""What a load curve consists of."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from catopt.answers import blocks
from catopt.answers.blocks import Rows, answered, measured, section, tabulate, texts
from catopt.answers.solution import (
    found_facts,
    given_facts,
    given_tables,
    point_loads_table,
    result_facts,
    segments_table,
)
from catopt.words import Measure, Message, term

if TYPE_CHECKING:
    from catopt.catenary.case_curve import CaseCurve

_ROWS = 20


def curve_answer(result: CaseCurve) -> blocks.Answer:
    """Lay out a load curve, its marks, and the case that it belongs to."""
    case, reference = result.case, result.reference
    inputs = blocks.Facts("inputs", tuple(given_facts(case)), only="workbook")
    summary = blocks.Facts("summary", result_facts(reference), only="workbook")
    points, marks = points_table(result), marks_table(result)
    graph = blocks.Graph(case.title, points.name, x=0, y=(2, 3))
    carried = [segments_table(reference)]
    if reference.point_loads:
        carried.append(point_loads_table(reference))
    none = () if result.curve.marks else (blocks.Text(Message("curve.no_marks")),)
    return answered(
        "curve",
        case.title or Message("captions.mooring_line"),
        section("captions.curve", *_opening(result), points, graph),
        section("captions.marks", marks, *none),
        section("captions.inputs", inputs, *map(_for_files, given_tables(case.line))),
        section("captions.results", summary, *map(_for_files, carried)),
    )


def _for_files(table: blocks.Table) -> blocks.Table:
    return replace(table, name=f"{table.name}_of_case", only="workbook")


def _opening(result: CaseCurve) -> Iterator[blocks.Text]:
    curve, reference = result.curve, result.reference
    yield blocks.Text(Message(f"curve.over_{result.over}", points=len(curve.span)))
    yield blocks.Text(Message("curve.range", range=result.range_words))
    found = reference.found
    if found is not None:
        (each,), condition = found_facts(reference), found.condition
        assert each.quantity is not None
        value = Measure(each.quantity.key, found.value)
        yield blocks.Text(Message("curve.found", name=each.name, value=value, condition=condition))
    if result.over == "offset":
        yield blocks.Text(Message("curve.zero", span=Measure("span", reference.span)))
    regime = Message(f"solution.{curve.regime[0].replace('-', '_')}")
    yield blocks.Text(Message("curve.lower_end", regime=regime))


def points_table(result: CaseCurve) -> blocks.Table:
    """Tabulate the points of a load curve, by rising span."""
    curve = result.curve
    count = len(curve.span)
    shown = tuple(sorted({round(k * (count - 1) / (_ROWS - 1)) for k in range(_ROWS)}))
    caption = Message("captions.some_points", shown=len(shown), points=count)
    return tabulate(
        "curve",
        *_places(result, curve.span.tolist()),
        measured("horizontal_force", curve.horizontal_force),
        measured("tension", curve.fairlead_tension, "fairlead_tension"),
        measured("tension", curve.anchor_tension, "anchor_tension", symbol="TA"),
        measured("angle", curve.anchor_angle, "inclination_at_the_anchor", symbol="theta0"),
        measured("grounded_length", curve.grounded_length),
        measured("stiffness", curve.stiffness),
        texts("regime", map(term, curve.regime), only="files"),
        caption=caption if len(shown) < count else Message("captions.curve_points"),
        shown=shown,
    )


def marks_table(result: CaseCurve) -> blocks.Table:
    """Tabulate where something changes along a load curve, by rising span."""
    of = Rows(result.curve.marks)
    return tabulate(
        "curve_marks",
        of.texts("kind", lambda mark: Message(f"curve.{mark.kind}"), only="files"),
        of.texts("what_happens", "event"),
        *_places(result, of.read("span")),
        *of.own("horizontal_force"),
        of.measured("tension", "fairlead_tension", "fairlead_tension"),
        caption=Message("captions.marks"),
    )


def _places(result: CaseCurve, spans: Sequence[float]) -> tuple[blocks.Column, blocks.Column]:
    """List span and offset; people see the one that was not left out by what is stepped."""
    zero, of_offset = result.reference.span, result.over == "offset"
    return (
        measured("span", spans, only="files" if of_offset else "all"),
        measured("offset", [each - zero for each in spans], only="all" if of_offset else "files"),
    )
