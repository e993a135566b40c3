"""Extremes of a line in motion: what they rest on as a table, and peaks beside the tail fitted."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from catopt.render.texts import Words
from catopt.report.page.table import Cell, Heading, Table, label_of, measured
from catopt.report.tables.dynamic import DYNAMIC_QUANTITY_OF
from catopt.units import lasting

if TYPE_CHECKING:
    from catopt.verify.dynamic_result import DynamicPart, OverRuns

__all__ = ["extreme_headings", "extreme_rows", "extremes_table"]


def extreme_rows(part: DynamicPart) -> list[tuple[str, list[Cell]]]:
    """List what extremes are and what they rest on, each with a cell for each random quantity.

    Empty where nothing is random, or for too few peaks.

    Parameters
    ----------
    part : DynamicPart
        One load case.
    """
    found = [_cells(each) for each in _with_tail(part)]
    return [(key, [cells[key] for cells in found]) for key in found[0]] if found else []


def extreme_headings(part: DynamicPart, words: Words) -> list[str]:
    """Name the quantities that `extreme_rows` has, with their units."""
    quantities = [DYNAMIC_QUANTITY_OF[each.quantity] for each in _with_tail(part)]
    return [f"{label_of(words, each)} ({each.field_unit})" for each in quantities]


def extremes_table(part: DynamicPart, words: Words) -> Table | None:
    """Lay the extremes out; None where there are none."""
    rows = extreme_rows(part)
    if not rows:
        return None
    numbers = (Heading(each, is_number=True) for each in extreme_headings(part, words))
    laid = tuple((Cell(words(key)), *cells) for key, cells in rows)
    caption = words("in_motion.extremes", time=lasting(part.duration_of_interest))
    return Table("motion_extremes", (Heading(words("table.what")), *numbers), laid, caption)


def _with_tail(part: DynamicPart) -> Sequence[OverRuns]:
    return [each for each in part.quantities if each.tail is not None]


def _cells(each: OverRuns) -> dict[str, Cell]:
    quantity, tail, runs = DYNAMIC_QUANTITY_OF[each.quantity], each.tail, each.gumbel
    assert tail is not None
    cells = {
        "in_motion.probable": measured(quantity, tail.extreme.most_probable),
        "in_motion.interval_from": measured(quantity, tail.extreme.low),
        "in_motion.interval_to": measured(quantity, tail.extreme.high),
        "in_motion.expected": measured(quantity, tail.extreme.expected),
        "in_motion.threshold": measured(quantity, tail.threshold),
        "in_motion.peaks_above": Cell(str(len(tail.clusters)), len(tail.clusters)),
        "in_motion.weibull_scale": measured(quantity, tail.scale),
        "in_motion.weibull_shape": Cell(f"{tail.shape:.3f}", tail.shape),
    }
    if runs is None:
        return cells
    return cells | {
        "in_motion.by_gumbel": measured(quantity, runs.extreme.most_probable),
        "in_motion.gumbel_from": measured(quantity, runs.extreme.low),
        "in_motion.gumbel_to": measured(quantity, runs.extreme.high),
    }
