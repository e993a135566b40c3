"""A drawing as a native chart of a workbook, over cells that hold its values."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import NamedTuple

from catopt.figures.chart import Chart, Level, Place
from catopt.render.looks import LOOKS
from catopt.render.sheet import Chart as Native
from catopt.render.sheet import Number, Series, Sheet, Text, number_pattern
from catopt.render.ticks import axis_title
from catopt.words import Language, Message, say

_SIZE = (680, 420)
"""Pixels."""


class _Curve(NamedTuple):
    """A line or signs at places."""

    role: str
    label: str
    places: list[Place]


def draw(
    chart: Chart, sheet: Sheet, cells: Sheet, row: int, column: int, language: Language
) -> int:
    """Write what a drawing shows as cells, and draw them on another sheet; areas are left out.

    Its upper left corner is at `row` and `column` of `sheet`; returns the first row below it.
    """
    curves = list(_curves(chart))
    top = cells.row
    cells.write(top, 0, Text(say(chart.title, language), "title"))
    made = []
    for index, curve in enumerate(curves):
        label = say(curve.label, language)
        rows = _write(chart, cells, curve, (top + 1, 2 * index), label)
        made.append(
            Series(label, rows, 2 * index, 2 * index + 1, role=curve.role, sheet=cells.name)
        )
    cells.row = top + 3 + max((len(curve.places) for curve in curves), default=0)
    y = chart.y
    said = axis_title(y, language)
    if y.foot is not None:  # a spreadsheet leaves out what is 0 on a logarithmic axis
        said = say(Message("answers.no_zeros", axis=said), language)
    log = None if y.foot is None else (y.quantity.to_field(y.low), y.quantity.to_field(y.high))
    return sheet.chart(
        Native(
            say(chart.title, language),
            axis_title(chart.x, language),
            said,
            tuple(made),
            log,
            _SIZE,
            (0.0, None) if y.low == 0.0 and log is None else (None, None),
            tuple(index for index, curve in enumerate(curves) if not curve.label),
        ),
        row=row,
        column=column,
    )


def _write(
    chart: Chart, cells: Sheet, curve: _Curve, at: tuple[int, int], label: str
) -> tuple[int, int]:
    """Write the places of a curve below its name; return its first and its last row."""
    row, column = at
    cells.write(row, column, Text(label, "text"))
    for place, values in enumerate(curve.places, start=row + 1):
        for offset, (axis, value) in enumerate(zip((chart.x, chart.y), values, strict=True)):
            quantity = axis.quantity
            is_there = math.isfinite(value) and (axis.foot is None or value > 0.0)
            field = quantity.to_field(value) if is_there else None
            cells.write(place, column + offset, Number(field, number_pattern(quantity)))
    return row + 1, row + max(len(curve.places), 1)


def _curves(chart: Chart) -> Iterator[_Curve]:
    """Yield what is drawn, what looks and is called alike together, with gaps between."""
    gap = (math.nan, math.nan)
    found: dict[tuple[str, str], list[Place]] = {}

    def add(role: str, label: str, places: Iterable[Place], *, joined: bool = True) -> None:
        known = found.setdefault((role, label), [])
        known += [gap] if known and joined else []
        known += places

    for series in chart.series:
        add(series.role, series.label, zip(series.x, series.y, strict=True))
    for level in chart.levels:
        add(level.role, level.label, _ends(level, chart))
    for area in chart.areas:
        if area.x:
            add(area.role, area.label, zip(area.x, area.high, strict=True))
            add(area.role, area.label, zip(area.x, area.low, strict=True))
    for arrow in chart.arrows:
        add(arrow.role, arrow.label, (arrow.start, arrow.end))
    for mark in chart.marks:
        if LOOKS[mark.role].sign != "words":
            add(mark.role, mark.label, [(mark.x, mark.y)], joined=False)
    for (role, label), places in found.items():
        yield _Curve(role, label, places)


def _ends(level: Level, chart: Chart) -> tuple[Place, Place]:
    if level.axis == "x":
        return (level.at, chart.y.low), (level.at, chart.y.high)
    start, end = max(level.start, chart.x.low), min(level.end, chart.x.high)
    return (start, level.at), (end, level.at)
