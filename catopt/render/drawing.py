"""A drawing as a native chart of a workbook, over cells that hold its values."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

from catopt.figures.chart import Chart, Place
from catopt.render.sheet import Chart as Native
from catopt.render.sheet import Number, Series, Text, WorkbookSheet, number_pattern
from catopt.render.svg import COLOURS, LOOKS, SIGNS, axis_title
from catopt.words import Message

_SIZE = (680, 420)
"""Pixels."""


def draw(chart: Chart, sheet: WorkbookSheet, cells: WorkbookSheet, row: int) -> int:
    """Write what a drawing shows as cells, and draw them on another sheet; areas are left out.

    It begins in a row of `sheet`; returns the first row below it.
    """
    book, curves, top = sheet.book, _curves(chart), cells.row
    cells.write(top, 0, Text(chart.title, "title"))
    made = []
    for column, ((role, label), places) in enumerate(curves.items()):
        rows = (top + 2, top + 1 + max(len(places), 1))
        cells.write(top + 1, 2 * column, Text(label, "text"))
        for place, values in enumerate(places, start=top + 2):
            # Write a place in the units of the axes.
            for k, (axis, value) in enumerate(zip((chart.x, chart.y), values, strict=True)):
                is_there = math.isfinite(value) and (axis.foot is None or value > 0.0)
                field = axis.quantity.to_field(value) if is_there else math.nan
                cells.write(place, 2 * column + k, Number(field, number_pattern(axis.quantity)))
        made.append(Series(label, rows, 2 * column, 2 * column + 1, _look(role), cells.name))
    cells.row = top + 3 + max(map(len, curves.values()), default=0)
    y, title = chart.y, axis_title(chart.y)
    log = None
    if y.foot is not None:  # a spreadsheet leaves out what is 0 on a logarithmic axis
        title = book.say(Message("answers.no_zeros", axis=title))
        log = y.quantity.to_field(y.low), y.quantity.to_field(y.high)
    native = Native(
        chart.title,
        axis_title(chart.x),
        title,
        made,
        log,
        from_zero=y.low == 0.0 and log is None,
        size=_SIZE,
        hidden=[index for index, (_, label) in enumerate(curves) if not label],
    )
    return sheet.chart(native, row)


def _curves(chart: Chart) -> dict[tuple[str, str], list[Place]]:
    """List what is drawn by role and label: what is alike together, with gaps between."""
    found: dict[tuple[str, str], list[Place]] = {}

    def add(role: str, label: str, places: Iterable[Place], *, joined: bool = True) -> None:
        known = found.setdefault((role, label), [])
        known += [(math.nan, math.nan)] if known and joined else []
        known += places

    for series in chart.series:
        add(series.role, series.label, zip(series.x, series.y, strict=True))
    for level in chart.levels:
        add(level.role, level.label, level.ends(chart.x, chart.y))
    for area in chart.areas:
        if area.x:
            add(area.role, area.label, zip(area.x, area.high, strict=True))
            add(area.role, area.label, zip(area.x, area.low, strict=True))
    for arrow in chart.arrows:
        add(arrow.role, arrow.label, (arrow.start, arrow.end))
    for mark in chart.marks:
        if LOOKS[mark.role].sign != "words":
            add(mark.role, mark.label, [(mark.x, mark.y)], joined=False)
    return found


def _look(role: str) -> dict[str, Any]:
    """Say how a spreadsheet draws a role."""
    look = LOOKS[role]
    colour = COLOURS[look.stroke or look.fill][0]
    if look.sign in SIGNS:
        marker = {
            "type": SIGNS[look.sign]["workbook"],
            "size": max(5, round(look.size)),
            "border": {"color": COLOURS["ink"][0] if look.stroke == "paper" else colour},
            "fill": {"color": COLOURS[look.fill][0]} if look.fill else {"none": True},
        }
        return {"line": {"none": True}, "marker": marker}
    dash = "dash" if look.dash else "solid"
    line = {"color": colour, "width": 0.75 * look.width, "dash_type": dash}
    return {"line": line, "marker": {"type": "none"}}
