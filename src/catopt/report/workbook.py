"""Results as an .xlsx workbook with native charts; every heading carries its unit."""

from __future__ import annotations

import math
from collections.abc import Mapping
from io import BytesIO
from typing import TYPE_CHECKING, Any

import pandas as pd
import xlsxwriter

from catopt._version import __version__
from catopt.quantities import QUANTITIES
from catopt.report import tables

if TYPE_CHECKING:
    from xlsxwriter.workbook import Workbook
    from xlsxwriter.worksheet import Worksheet

    from catopt.catenary.case_curve import CaseCurve
    from catopt.catenary.solution import Solution, SwarmReport
    from catopt.model import Case
    from catopt.reproduce import Reproduction

__all__ = ["catalogue_workbook", "curve_workbook", "reproduction_workbook", "solution_workbook"]

_SCIENTIFIC = tuple(q.name.lower() for q in QUANTITIES.values() if q.notation == "scientific")
_DIGITS = {q.field_unit: q.digits for q in sorted(QUANTITIES.values(), key=lambda q: q.digits)}
_DIGITS["tf"] = _DIGITS["kN"] + 1

_COUNT = "General"
_WIDEST = 60
_HEADING_HEIGHT = 33
"""Points: two lines of bold text, to which a heading may fold."""
_CHART = {"width": 620, "height": 380}
_LINES = (
    {"color": "#0072B2", "width": 1.75},
    {"color": "#D55E00", "width": 1.75, "dash_type": "dash"},
)
"""Of the first and of the second curve in a chart."""


def solution_workbook(case: Case, solution: Solution) -> bytes:
    """Lay out a case and its solution.

    Parameters
    ----------
    case : Case
        What was given.
    solution : Solution
        What came out.

    Returns
    -------
    bytes
        An .xlsx file with the sheets Inputs, Results, Line shape and, for a swarm, Swarm.
    """
    book = _Book(solution.title)
    _inputs(book, case, solution)
    _results(book, solution)
    _line_shape(book, solution)
    if solution.swarm is not None:
        _swarm(book, solution.swarm)
    return book.close()


def curve_workbook(result: CaseCurve) -> bytes:
    """Lay out a load curve, its marks, and the case that it belongs to.

    Returns
    -------
    bytes
        An .xlsx file with the sheets Inputs, Results, Curve and Marks.
    """
    book = _Book(result.case.title)
    _inputs(book, result.case, result.reference)
    _results(book, result.reference)
    frame = tables.curve_points(result)
    sheet = book.sheet("Curve")
    sheet.table(frame)
    span, _, force, tension, *_ = frame.columns
    place = (1, len(frame.columns) + 1)
    sheet.chart(frame, span, force, result.case.title, place=place, further=(tension,))
    book.sheet("Marks").table(tables.curve_marks(result))
    return book.close()


def reproduction_workbook(result: Reproduction) -> bytes:
    """Lay out printed numbers beside computed ones, and what was found.

    Returns
    -------
    bytes
        An .xlsx file with the sheets Comparison, Inputs and Findings.
    """
    book = _Book("Published figures beside catopt's")
    book.sheet("Comparison").table(tables.reproduction(result))
    given = book.sheet("Inputs")
    found = book.sheet("Findings")
    given.table(
        pd.DataFrame(
            [
                (study.name, each.quantity, each.value, each.unit, each.origin)
                for study in result.studies
                for each in study.inputs
            ],
            columns=["Study", "Quantity", "Value (unit of the row)", "Unit", "Origin"],
        )
    )
    found.table(
        pd.DataFrame(
            [(study.name, text) for study in result.studies for text in study.findings],
            columns=["Study", "Finding"],
        ),
        wrap=True,
    )
    return book.close()


def catalogue_workbook(frames: Mapping[str, pd.DataFrame]) -> bytes:
    """Lay out an answer out of the catalogue.

    Parameters
    ----------
    frames : mapping of str to DataFrame
        Its tables by name.

    Returns
    -------
    bytes
        An .xlsx file with a sheet for each table.
    """
    book = _Book("Components with the source of every figure")
    for name, frame in frames.items():
        book.sheet(name.capitalize()).table(frame, wrap=True)
    return book.close()


# ------------------------------------------------------------------ sheets


def _inputs(book: _Book, case: Case, solution: Solution) -> None:
    sheet = book.sheet("Inputs")
    sheet.list_of(tables.inputs(case))
    sheet.table(tables.segment_inputs(case.line), title="Segments, from the anchor to the fairlead")
    if case.line.point_loads:
        sheet.table(tables.point_load_inputs(case.line), title="Point loads")
    if solution.swarm is not None:
        sheet.table(tables.swarm_settings(case), title="Swarm")


def _results(book: _Book, solution: Solution) -> None:
    sheet = book.sheet("Results")
    sheet.list_of(tables.summary(solution))
    sheet.table(tables.segments(solution), title="Segments, from the anchor to the fairlead")
    if solution.point_loads:
        sheet.table(tables.point_loads(solution), title="Point loads")


def _line_shape(book: _Book, solution: Solution) -> None:
    frame = tables.profile(solution)
    sheet = book.sheet("Line shape")
    sheet.table(frame)
    s, x, z, tension = (QUANTITIES[key].heading for key in ("s", "x", "z", "tension"))
    sheet.chart(frame, x, z, "Line shape", place=(1, 5))
    sheet.chart(frame, s, tension, "Tension along the line", place=(21, 5))


def _swarm(book: _Book, swarm: SwarmReport) -> None:
    history, runs = tables.swarm_history(swarm), tables.swarm_runs(swarm)
    sheet = book.sheet("Swarm")
    sheet.table(history)
    sheet.table(runs, column=len(history.columns) + 1)
    iteration, objective, tension, _ = history.columns
    place = len(history.columns) + len(runs.columns) + 2
    # Excel leaves out what is 0 on a logarithmic axis; the title says so.
    title = f"{objective}; exact zeros are not drawn"
    decades = _decades(history[objective])
    sheet.chart(history, iteration, objective, title, place=(1, place), log=decades)
    sheet.chart(history, iteration, tension, tension, place=(21, place))


# ------------------------------------------------------------------ the workbook itself


class _Book:
    """A workbook in memory with its formats."""

    def __init__(self, title: str) -> None:
        self.stream = BytesIO()
        self.workbook: Workbook = xlsxwriter.Workbook(self.stream, {"in_memory": True})
        self.workbook.set_properties({"title": title, "comments": f"catopt {__version__}"})
        self.heading = self._format(bold=True, text_wrap=True, bottom=1, valign="bottom")
        self.title = self._format(bold=True, font_size=12)
        self.text = self._format(valign="top", indent=1)
        self.wrapped = self._format(valign="top", indent=1, text_wrap=True)
        self.beside_numbers = self._format(valign="top", align="right")
        self._numbers: dict[str, Any] = {}

    def _format(self, **properties: Any) -> Any:
        return self.workbook.add_format(properties)

    def number(self, heading: str) -> Any:
        """Choose the number format that goes with the unit in a heading."""
        pattern = _pattern(heading)
        if pattern not in self._numbers:
            side = "center" if pattern == _COUNT else "right"
            self._numbers[pattern] = self._format(num_format=pattern, valign="top", align=side)
        return self._numbers[pattern]

    def sheet(self, name: str) -> _Sheet:
        """Add a sheet whose first row stays in sight."""
        worksheet = self.workbook.add_worksheet(name)
        worksheet.freeze_panes(1, 0)
        worksheet.set_landscape()
        worksheet.set_paper(9)  # A4
        worksheet.fit_to_pages(1, 0)
        worksheet.repeat_rows(0)
        return _Sheet(self, worksheet)

    def close(self) -> bytes:
        """Finish the file."""
        self.workbook.close()
        return self.stream.getvalue()


class _Sheet:
    """A sheet that is filled from the top down."""

    def __init__(self, book: _Book, worksheet: Worksheet) -> None:
        self.book = book
        self.worksheet = worksheet
        self.row = 0
        self.widths: dict[int, float] = {}

    def list_of(self, frame: pd.DataFrame) -> None:
        """Write the one row of a table as a list: heading with unit, value."""
        self._heading(0, "Quantity (unit)", 44)
        self._heading(1, "Value (unit of the row)", 24)
        for row, (heading, value) in enumerate(frame.iloc[0].items(), start=1):
            self.worksheet.write_string(row, 0, str(heading), self.book.text)
            self._value(row, 1, str(heading), "-" if pd.isna(value) else value)
        self.row = len(frame.columns) + 2

    def table(
        self, frame: pd.DataFrame, *, title: str = "", column: int = 0, wrap: bool = False
    ) -> None:
        """Write a table below what is there; beside it, from the top, when a column is given."""
        top = 0 if column else self.row
        if title:
            self.worksheet.write_string(top, column, title, self.book.title)
            top += 1
        for index, name in enumerate(frame.columns):
            place = column + index
            self._heading(place, str(name), _width(frame[name], str(name)), top)
            for row, value in enumerate(frame[name], start=top + 1):
                self._value(row, place, str(name), value, wrap=wrap)
        if not column:
            self.row = top + len(frame) + 2

    def chart(
        self,
        frame: pd.DataFrame,
        x: str,
        y: str,
        title: str,
        *,
        place: tuple[int, int],
        log: tuple[float, float] | None = None,
        further: tuple[str, ...] = (),
    ) -> None:
        """Draw a column of a table that starts in the first row and column over another.

        Parameters
        ----------
        frame : DataFrame
            The table, as it stands on the sheet.
        x, y : str
            Headings of its columns.
        title : str
            Above the chart.
        place : tuple of int
            Row and column of its upper left corner.
        log : tuple of float, optional
            Ends of a logarithmic y axis.
        further : tuple of str
            Headings of more columns for the same y axis; a legend then tells which is which.
        """
        chart = self.book.workbook.add_chart({"type": "scatter", "subtype": "straight"})
        for name, line in zip((y, *further), _LINES, strict=False):
            columns = [frame.columns.get_loc(each) for each in (x, name)]
            cells = [[self.worksheet.name, 1, column, len(frame), column] for column in columns]
            chart.add_series(
                {"name": name, "categories": cells[0], "values": cells[1], "line": line}
            )
        y_axis: dict[str, Any] = {
            "name": " and ".join((y, *further)),
            "major_gridlines": {"visible": True},
        }
        if log is not None:
            y_axis |= {"log_base": 10, "min": log[0], "max": log[1], "crossing": log[0]}
            y_axis |= {"num_format": "0E+00"}
        chart.set_title({"name": title, "name_font": {"size": 12}})
        chart.set_x_axis({"name": x, "label_position": "low"})
        chart.set_y_axis(y_axis)
        chart.set_legend({"position": "bottom"} if further else {"none": True})
        chart.set_size(_CHART)
        self.worksheet.insert_chart(*place, chart)

    def _heading(self, column: int, name: str, width: float, row: int = 0) -> None:
        self.worksheet.set_row(row, _HEADING_HEIGHT)
        self.worksheet.write_string(row, column, name, self.book.heading)
        self.widths[column] = max(self.widths.get(column, 0.0), width)
        self.worksheet.set_column(column, column, self.widths[column])

    def _value(
        self, row: int, column: int, heading: str, value: object, *, wrap: bool = False
    ) -> None:
        text = self.book.wrapped if wrap else self.book.text
        if isinstance(value, str):
            # Never as a formula or a link, whatever a name in a case file looks like.
            self.worksheet.write_string(row, column, value, text)
        elif value is None or (isinstance(value, float) and math.isnan(value)):
            self.worksheet.write_blank(row, column, None, text)
        elif isinstance(value, float) and math.isinf(value):
            self.worksheet.write_string(row, column, "inextensible", self.book.beside_numbers)
        else:
            self.worksheet.write_number(row, column, value, self.book.number(heading))


def _pattern(heading: str) -> str:
    if any(name in heading.lower() for name in _SCIENTIFIC):
        return "0.00E+00"
    unit = heading.rpartition("(")[2].rstrip(")")
    digits = _DIGITS.get(unit) if heading.endswith(")") else None
    if digits is None:
        return _COUNT
    return f"0.{'0' * digits}" if digits else "0"


def _decades(values: pd.Series[float]) -> tuple[float, float] | None:
    """Find the powers of ten around the positive values; None when there are none."""
    positive = values[values > 0.0]
    if positive.empty:
        return None
    low, high = math.floor(math.log10(positive.min())), math.ceil(math.log10(positive.max()))
    return 10.0**low, 10.0 ** max(high, low + 1)


def _width(values: pd.Series[Any], heading: str) -> float:
    """Choose a column width, in characters: a heading may fold, a value may not."""
    longest = max((len(value) for value in values if isinstance(value, str)), default=0)
    return float(min(max(longest, 12, math.ceil(len(heading) / 2) + 3), _WIDEST))
