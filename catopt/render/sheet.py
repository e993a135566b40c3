"""A workbook in memory and its sheets: formats, tables, charts, and how they print on A4."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from datetime import datetime
from io import BytesIO
from typing import Any, Literal, NamedTuple

from xlsxwriter.workbook import Workbook
from xlsxwriter.worksheet import Worksheet

from catopt._version import identity
from catopt.quantities import Quantity
from catopt.words import Language, say, term

Style = Literal["heading", "text", "wrapped", "title", "good", "fair", "bad", "grey", "beside"]

GENERAL = "General"
"""Format of counts, and of what has no fixed digits."""
_WIDEST = 60
_LINE_HEIGHT, _BOLDER = 15.0, 1.1
"""Points of a row of one line of text; how much larger a line over several columns is."""
_ROW_PIXELS = 20
_PIXELS = 7.0
"""Of one character of a column's width."""
_NO_DATE = datetime(2000, 1, 1)
"""In place of the hour of writing: the same data make the same file."""
_MOST_FOOTER, _MOST_NAME = 120, 31

_PLAIN = {"valign": "top", "indent": 1}
_FOLDED = _PLAIN | {"text_wrap": True}
_STYLES: Mapping[Style, Mapping[str, Any]] = {
    "heading": {"bold": True, "text_wrap": True, "bottom": 1, "valign": "bottom"},
    "text": _PLAIN,
    "wrapped": _FOLDED,
    "title": {"bold": True, "font_size": 12},
    "good": _FOLDED | {"bold": True, "font_color": "#006100"},
    "fair": _FOLDED | {"bold": True, "font_color": "#7F4F00", "bg_color": "#FFEB9C"},
    "bad": _FOLDED | {"bold": True, "font_color": "#9C0006", "bg_color": "#FFC7CE"},
    "grey": _FOLDED | {"font_color": "#595959"},
    "beside": {"valign": "top", "align": "right"},
}


class Number(NamedTuple):
    """A number with its format; a formula, if any, gives this number; flush left among texts."""

    value: float
    pattern: str = GENERAL
    formula: str = ""
    is_left: bool = False


class Text(NamedTuple):
    """A text with its look."""

    text: str
    style: Style = "wrapped"


Cell = Number | Text | None


class Series(NamedTuple):
    """A curve or points: first and last row and columns of its cells, from 0, and its look."""

    name: str
    rows: tuple[int, int]
    x: int
    y: int
    look: dict[str, Any]
    sheet: str = ""
    """Name of another sheet that has the cells."""


class Chart(NamedTuple):
    """Series with their titles, in pixels; several have a legend, which leaves `hidden` out."""

    title: str
    x: str
    y: str
    series: Sequence[Series]
    log: tuple[float, float] | None = None
    """Ends of a logarithmic y axis."""
    from_zero: bool = False
    size: tuple[int, int] = (620, 380)
    hidden: Sequence[int] = ()


class Book:
    """A workbook in memory; its title is in its properties and at the foot of every page."""

    def __init__(self, title: str, language: Language) -> None:
        self.language = language
        self.title = self.say(title)
        self.stream = BytesIO()
        self.workbook = Workbook(self.stream, {"in_memory": True})
        self.workbook.set_properties(
            {"title": self.title, "comments": f"catopt {identity()}", "created": _NO_DATE}
        )
        self.styles = {name: self.workbook.add_format(look) for name, look in _STYLES.items()}
        self._numbers: dict[tuple[str, bool], Any] = {}
        self._sheets: list[WorkbookSheet] = []

    def say(self, said: str) -> str:
        """Say a message in the language of the workbook."""
        return say(said, self.language)

    def number(self, pattern: str, *, is_left: bool) -> Any:
        """Return the cell format of a number format, made once."""
        key = pattern, is_left
        if key not in self._numbers:
            align = "left" if is_left else "center" if pattern == GENERAL else "right"
            look = {"num_format": pattern, "valign": "top", "align": align}
            self._numbers[key] = self.workbook.add_format(look)
        return self._numbers[key]

    def sheet(self, name: str) -> WorkbookSheet:
        """Add a sheet whose first row stays in sight; its tab has the name, made short and free."""
        said, used = self.say(name), {sheet.name.casefold() for sheet in self._sheets}
        tab, number = _whole_words(said, _MOST_NAME), 1
        while tab.casefold() in used:
            number += 1
            tab = f"{_whole_words(said, _MOST_NAME - 3)} {number}"
        worksheet = self.workbook.add_worksheet(tab)
        worksheet.freeze_panes(1, 0)
        worksheet.set_landscape()
        worksheet.set_paper(9)  # A4
        worksheet.set_margins(left=0.5, right=0.5, top=0.6, bottom=0.7)
        worksheet.fit_to_pages(1, 0)
        worksheet.repeat_rows(0)
        title = self.title[:_MOST_FOOTER].replace("&", "&&")
        worksheet.set_footer(f"&L{title}&C&A&Rcatopt {identity()}   &P / &N")
        self._sheets.append(WorkbookSheet(self, worksheet))
        return self._sheets[-1]

    def close(self) -> bytes:
        """Finish the file."""
        for sheet in self._sheets:
            sheet.set_printed()
        self.workbook.close()
        return self.stream.getvalue()


@dataclass
class WorkbookSheet:
    """A sheet that is filled from the top down."""

    book: Book
    worksheet: Worksheet
    row: int = 0
    """The next row that is free below the tables."""
    widths: dict[int, float] = field(default_factory=dict)
    """Of columns, in characters."""
    _last: tuple[int, int] = (0, 0)
    _charts: list[tuple[int, int, tuple[int, int]]] = field(default_factory=list)

    @property
    def name(self) -> str:
        """As it is on its tab."""
        return str(self.worksheet.get_name())

    @property
    def beside(self) -> int:
        """Column of charts: one to the right of the tables stays empty."""
        return max(self.widths, default=-2) + 2

    def grid(
        self,
        headings: Sequence[str],
        rows: Sequence[Sequence[Cell]],
        title: str = "",
        widths: Sequence[float] = (),
    ) -> int:
        """Write rows under headings; return the row of the headings.

        `widths` are in characters; those left out follow from what the columns hold.
        """
        if title:
            self.write(self.row, 0, Text(title, "title"))
            self.row += 1
        top = self.row
        for column, name in enumerate(headings):
            cells = [each[column] for each in rows]
            width = widths[column] if column < len(widths) else _width(cells, name)
            self.widths[column] = max(self.widths.get(column, 0.0), width)
            self.worksheet.set_column(column, column, self.widths[column])
            self.write(top, column, Text(name, "heading"))
            for place, cell in enumerate(cells, start=top + 1):
                self.write(place, column, cell)
        lines = [_lines(name, self.widths[column]) for column, name in enumerate(headings)]
        self.worksheet.set_row(top, _LINE_HEIGHT * max(2, *lines) + 3.0)
        for place, row in enumerate(rows, start=top + 1):
            self._fold(place, row)
        self.row = top + len(rows) + 2
        return top

    def widen(self, least: float) -> None:
        """Give texts across the sheet room, by an empty column where the others are narrow."""
        missing = least - sum(self.widths.values())
        if missing > 0.0:
            column = max(self.widths, default=-1) + 1
            self.widths[column] = missing
            self.worksheet.set_column(column, column, missing)

    def across(self, text: str, style: Style) -> None:
        """Write a text over all columns whose widths are set, folded to them."""
        last, width = max(self.widths), sum(self.widths.values())
        self.worksheet.set_row(self.row, _LINE_HEIGHT * _BOLDER * _lines(text, width / _BOLDER))
        if last:
            self.worksheet.merge_range(self.row, 0, self.row, last, "", self.book.styles[style])
        self._reach(self.row, last)
        self.write(self.row, 0, Text(text, style))
        self.row += 1

    def write(self, row: int, column: int, cell: Cell) -> None:
        """Write one cell; text never becomes a formula or a link, whatever it looks like."""
        self._reach(row, column)
        sheet, styles = self.worksheet, self.book.styles
        if isinstance(cell, Text):
            sheet.write_string(row, column, cell.text, styles[cell.style])
        elif cell is None or math.isnan(cell.value):
            sheet.write_blank(row, column, None, styles["text"])
        elif math.isinf(cell.value):
            sheet.write_string(row, column, self.book.say(term("inextensible")), styles["beside"])
        else:
            look = self.book.number(cell.pattern, is_left=cell.is_left)
            if cell.formula:
                sheet.write_formula(row, column, cell.formula, look, cell.value)
            else:
                sheet.write_number(row, column, cell.value, look)

    def chart(self, chart: Chart, row: int) -> int:
        """Draw cells beside the tables, from a row down; return the first row below."""
        drawn = self.book.workbook.add_chart({"type": "scatter", "subtype": "straight"})
        # A name is text, also one with !A1 in it, which would be taken for a reference.
        drawn._process_names = lambda name, formula: (name, formula)
        for series in chart.series:
            first, last = series.rows
            place = series.sheet or self.name
            ranges: dict[str, Any] = {
                "name": series.name,
                "categories": [place, first, series.x, last, series.x],
                "values": [place, first, series.y, last, series.y],
            }
            drawn.add_series(ranges | series.look)
        up: dict[str, Any] = {"name": chart.y, "major_gridlines": {"visible": True}}
        up |= {"label_position": "low", "num_format": GENERAL}
        if chart.from_zero:
            up["min"] = 0.0
        if chart.log is not None:
            low, high = chart.log
            up |= {"log_base": 10, "min": low, "max": high, "crossing": low, "num_format": "0E+00"}
        drawn.set_title({"name": chart.title, "name_font": {"size": 12}})
        drawn.set_x_axis({"name": chart.x, "label_position": "low", "num_format": GENERAL})
        drawn.set_y_axis(up)
        legend = {"position": "bottom", "delete_series": list(chart.hidden)}
        drawn.set_legend(legend if len(chart.series) > 1 else {"none": True})
        width, height = chart.size
        drawn.set_size({"width": width, "height": height})
        self.worksheet.insert_chart(row, self.beside, drawn)
        self._charts.append((row, self.beside, chart.size))
        return row + height // _ROW_PIXELS + 2

    def set_printed(self) -> None:
        """Print all cells and charts."""
        for row, column, (width, height) in self._charts:
            while width > 0:
                width -= round(self.widths.get(column, 8.43) * _PIXELS) + 5
                column += 1
            self._reach(row + height // _ROW_PIXELS + 1, column - 1)
        self.worksheet.print_area(0, 0, *self._last)

    def _reach(self, row: int, column: int) -> None:
        self._last = max(self._last[0], row), max(self._last[1], column)

    def _fold(self, row: int, cells: Sequence[Cell]) -> None:
        """Make a row as high as its longest folded text; not every program does so itself."""
        lines = [
            _lines(cell.text, self.widths[column])
            for column, cell in enumerate(cells)
            if isinstance(cell, Text) and cell.style != "text"
        ]
        if max(lines, default=1) > 1:
            self.worksheet.set_row(row, _LINE_HEIGHT * max(lines))


def _whole_words(name: str, most: int) -> str:
    """Cut a name to so many letters, after a whole word where it has several."""
    if len(name) <= most:
        return name
    return name[: most + 1].rpartition(" ")[0].rstrip(" ,:-(") or name[:most]


def number_pattern(quantity: Quantity | None, si: float = 0.0) -> str:
    """Choose the number format of a value of a quantity."""
    if quantity is None or quantity.notation == "significant":
        return GENERAL
    if quantity.notation == "scientific":
        return "0.00E+00"
    digits = quantity.places(si) if quantity.notation == "fixed" else quantity.digits
    return f"0.{'0' * digits}" if digits else "0"


def _lines(text: str, width: float) -> int:
    """Count the lines to which a bold text folds at its spaces."""
    room, lines, used = max(width / 1.12, 1.0), 1, 0
    for word in text.split():
        if used and used + 1 + len(word) > room:
            lines, used = lines + 1, 0
        used += len(word) + (1 if used else 0)
        while used > room:
            lines, used = lines + 1, used - int(room)
    return lines


def _width(cells: Sequence[Cell], heading: str) -> float:
    """Choose a column width, in characters: a heading may fold, a value may not."""
    longest = max((len(each.text) + 2 for each in cells if isinstance(each, Text)), default=0)
    word = max((len(part) for part in heading.split()), default=0) + 2
    return float(min(max(longest, 12, word, math.ceil(len(heading) / 2) + 3), _WIDEST))
