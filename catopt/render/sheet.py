"""A workbook in memory and its sheets: formats, tables, charts, and how they print on A4."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from datetime import datetime
from io import BytesIO
from typing import TYPE_CHECKING, Any, Literal

import xlsxwriter

from catopt._version import __version__
from catopt.quantities import Quantity
from catopt.render.looks import COLOURS, LOOKS, Look, Sign
from catopt.words import Language, say, term

if TYPE_CHECKING:
    from xlsxwriter.workbook import Workbook
    from xlsxwriter.worksheet import Worksheet

Style = Literal["text", "wrapped", "title", "large", "good", "amber", "bad", "grey"]

_COUNT = "General"
_WIDEST = 60
_LINE_HEIGHT = 15.0
"""Points of a row of one line of text."""
_ROW_PIXELS = 20
_PIXELS = 7.0
"""Of one character of a column's width."""
_NO_DATE = datetime(2000, 1, 1)
"""In place of the hour of writing: the same data make the same file."""
_MOST_FOOTER, _MOST_NAME = 120, 31
_COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#7F7F7F")
_DASHES = ("solid", "dash", "long_dash", "dash_dot", "square_dot", "solid")
_RING = 9
"""Size from which a point is a ring."""
_SIGNS: dict[Sign, str] = {
    "circle": "circle", "square": "square", "diamond": "diamond", "triangle": "triangle",
    "cross": "plus", "tick": "short_dash",
}  # fmt: skip
_MARKERS = ("circle", "diamond", "triangle", "square", "x", "plus")


@dataclass(frozen=True)
class Number:
    """A number with its format.

    Attributes
    ----------
    value : float or None
        As it is stored, to 16 digits; None leaves the cell empty.
    pattern : str
        Number format.
    formula : str
        In place of the number where somebody would compute it in the sheet; `value` is what it
        gives.
    is_left : bool
        Set flush left, among texts.
    """

    value: float | None
    pattern: str = _COUNT
    formula: str = ""
    is_left: bool = False


@dataclass(frozen=True)
class Text:
    """A text with its look."""

    text: str
    style: Style = "wrapped"


Cell = str | float | Number | Text | None


@dataclass(frozen=True)
class Series:
    """A curve or a set of points: rows and columns of its cells, the ends among them, from 0.

    Large points are rings: whatever a program draws over them, they stay in sight. A role has its
    own look; cells may be on another sheet.
    """

    name: str
    rows: tuple[int, int]
    x: int
    y: int
    style: Literal["line", "points"] = "line"
    colour: int = 0
    size: int = 7
    role: str = ""
    sheet: str = ""


@dataclass(frozen=True)
class Chart:
    """What a chart shows.

    Attributes
    ----------
    title, x, y : str
        Above it and at its axes.
    series : tuple of Series
        With a legend where there are several.
    log : tuple of float, optional
        Ends of a logarithmic y axis.
    size : tuple of int
        Width and height in pixels.
    y_range : tuple of float or None
        Ends of the y axis; None leaves one to the spreadsheet.
    hidden : tuple of int
        Series that the legend leaves out.
    """

    title: str
    x: str
    y: str
    series: tuple[Series, ...]
    log: tuple[float, float] | None = None
    size: tuple[int, int] = (620, 380)
    y_range: tuple[float | None, float | None] = (None, None)
    hidden: tuple[int, ...] = ()


class Book:
    """A workbook in memory with its formats.

    Its title stands in its properties and at the foot of every page.
    """

    def __init__(self, title: str, language: Language = "en") -> None:
        self.language = language
        self.title = title
        self.stream = BytesIO()
        self.workbook: Workbook = xlsxwriter.Workbook(self.stream, {"in_memory": True})
        self.workbook.set_properties(
            {"title": title, "comments": f"catopt {__version__}", "created": _NO_DATE}
        )
        self.heading = self._format(bold=True, text_wrap=True, bottom=1, valign="bottom")
        self.styles: dict[Style, Any] = {
            "text": self._format(valign="top", indent=1),
            "wrapped": self._format(valign="top", indent=1, text_wrap=True),
            "title": self._format(bold=True, font_size=12),
            "large": self._format(bold=True, font_size=16),
            "good": self._format(
                valign="top", indent=1, font_color="#006100", bold=True, text_wrap=True
            ),
            "amber": self._format(
                valign="top",
                indent=1,
                font_color="#7F6000",
                bg_color="#FFEB9C",
                bold=True,
                text_wrap=True,
            ),
            "bad": self._format(
                valign="top",
                indent=1,
                font_color="#9C0006",
                bg_color="#FFC7CE",
                bold=True,
                text_wrap=True,
            ),
            "grey": self._format(valign="top", indent=1, font_color="#595959", text_wrap=True),
        }
        self.beside_numbers = self._format(valign="top", align="right")
        self._numbers: dict[str, Any] = {}
        self._sheets: list[Sheet] = []

    def _format(self, **properties: Any) -> Any:
        return self.workbook.add_format(properties)

    def number(self, pattern: str, *, is_left: bool = False) -> Any:
        """Return the cell format of a number format, made once."""
        key = f"{pattern}|{is_left}"
        if key not in self._numbers:
            side = "center" if pattern == _COUNT else "right"
            look = {"align": "left" if is_left else side}
            self._numbers[key] = self._format(num_format=pattern, valign="top", **look)
        return self._numbers[key]

    def sheet(self, name: str) -> Sheet:
        """Add a sheet whose first row stays in sight; its tab has the name, made short and free."""
        worksheet = self.workbook.add_worksheet(self._free(name))
        worksheet.freeze_panes(1, 0)
        worksheet.set_landscape()
        worksheet.set_paper(9)  # A4
        worksheet.set_margins(left=0.5, right=0.5, top=0.6, bottom=0.7)
        worksheet.fit_to_pages(1, 0)
        worksheet.repeat_rows(0)
        title = self.title[:_MOST_FOOTER].replace("&", "&&")
        worksheet.set_footer(f"&L{title}&C&A&Rcatopt {__version__}   &P / &N")
        sheet = Sheet(self, worksheet)
        self._sheets.append(sheet)
        return sheet

    def _free(self, name: str) -> str:
        """Shorten a name for a tab; with a number where another one is so called."""
        used = {sheet.name.casefold() for sheet in self._sheets}
        short, number = name[:_MOST_NAME], 1
        while short.casefold() in used:
            number += 1
            short = f"{name[: _MOST_NAME - 3]} {number}"
        return short

    def close(self) -> bytes:
        """Finish the file."""
        for sheet in self._sheets:
            sheet.finish()
        self.workbook.close()
        return self.stream.getvalue()


@dataclass
class Sheet:
    """A sheet that is filled from the top down.

    Attributes
    ----------
    row : int
        The next row that is free below the tables on the left.
    widths : dict
        Of columns, in characters.
    """

    book: Book
    worksheet: Worksheet
    row: int = 0
    widths: dict[int, float] = field(default_factory=dict)
    _heights: dict[int, float] = field(default_factory=dict)
    _last: tuple[int, int] = (0, 0)
    _charts: list[tuple[int, int, tuple[int, int]]] = field(default_factory=list)

    @property
    def name(self) -> str:
        """As it stands on its tab."""
        return str(self.worksheet.get_name())

    def grid(
        self,
        headings: Sequence[str],
        rows: Sequence[Sequence[Cell]],
        *,
        title: str = "",
        column: int = 0,
        row: int | None = None,
        widths: Sequence[float | None] = (),
    ) -> int:
        """Write rows under headings; return the row of the headings.

        The upper left corner is at `column` and `row`, from the top when only the column is given.
        `widths` are in characters; what is None or left out follows from what the columns hold.
        """
        top = row if row is not None else 0 if column else self.row
        if title:
            self.write(top, column, Text(title, "title"))
            top += 1
        for index, name in enumerate(headings):
            given = widths[index] if index < len(widths) else None
            width = given or _width([each[index] for each in rows], name)
            self._heading(column + index, name, width, top)
            for place, cells in enumerate(rows, start=top + 1):
                self.write(place, column + index, cells[index])
        for place, cells in enumerate(rows, start=top + 1):
            self._fold(place, column, cells)
        if not column:
            self.row = top + len(rows) + 2
        return top

    def widen(self, least: float) -> None:
        """Give texts across the sheet room, by an empty column where the others are narrow."""
        missing = least - sum(self.widths.values())
        if missing > 0.0:
            column = max(self.widths, default=-1) + 1
            self.widths[column] = missing
            self.worksheet.set_column(column, column, missing)

    def across(self, text: str, style: Style = "wrapped") -> None:
        """Write a text over all columns whose widths are set, folded to them."""
        last = max(self.widths)
        width = sum(self.widths[column] for column in range(last + 1))
        scale = {"large": 1.6, "title": 1.2}.get(style, 1.1)
        height = _LINE_HEIGHT * scale * _lines(text, width / scale)
        self.worksheet.set_row(self.row, height)
        look = self.book.styles[style]
        if last:
            self.worksheet.merge_range(self.row, 0, self.row, last, "", look)
        self.worksheet.write_string(self.row, 0, text, look)
        self._last = (max(self._last[0], self.row), max(self._last[1], last))
        self.row += 1

    def write(self, row: int, column: int, cell: Cell) -> None:
        """Write one cell; text never becomes a formula or a link, whatever it looks like."""
        self._last = (max(self._last[0], row), max(self._last[1], column))
        sheet, book = self.worksheet, self.book
        if isinstance(cell, str):
            cell = Text(cell)
        if cell is None:
            sheet.write_blank(row, column, None, book.styles["text"])
        elif isinstance(cell, Text):
            sheet.write_string(row, column, cell.text, book.styles[cell.style])
        else:
            number = cell if isinstance(cell, Number) else Number(float(cell))
            self._number(row, column, number)

    def _fold(self, row: int, column: int, cells: Sequence[Cell]) -> None:
        """Make a row as high as its longest folded text; not every program does so itself."""
        lines = 1
        for index, cell in enumerate(cells, start=column):
            if isinstance(cell, str) or (isinstance(cell, Text) and cell.style != "text"):
                text = cell if isinstance(cell, str) else cell.text
                lines = max(lines, _lines(text, self.widths[index]))
        height = _LINE_HEIGHT * lines
        if lines > 1 and height > self._heights.get(row, 0.0):
            self._heights[row] = height
            self.worksheet.set_row(row, height)

    def _number(self, row: int, column: int, number: Number) -> None:
        sheet, value = self.worksheet, number.value
        if value is None or math.isnan(value):
            sheet.write_blank(row, column, None, self.book.styles["text"])
        elif math.isinf(value):
            said = say(term("inextensible"), self.book.language)
            sheet.write_string(row, column, said, self.book.beside_numbers)
        else:
            look = self.book.number(number.pattern, is_left=number.is_left)
            if number.formula:
                sheet.write_formula(row, column, number.formula, look, value)
            else:
                sheet.write_number(row, column, value, look)

    def chart(self, chart: Chart, *, row: int, column: int) -> int:
        """Draw cells of this sheet over others, from a cell down; return the first row below."""
        drawn = self.book.workbook.add_chart({"type": "scatter", "subtype": "straight"})
        for series in chart.series:
            first, last = series.rows
            place = series.sheet or self.name
            drawn.add_series(
                {
                    "name": series.name,
                    "categories": [place, first, series.x, last, series.x],
                    "values": [place, first, series.y, last, series.y],
                    **(_look_of(LOOKS[series.role]) if series.role else _look(series)),
                }
            )
        axis: dict[str, Any] = {"name": chart.y, "major_gridlines": {"visible": True}}
        axis |= {
            end: value
            for end, value in zip(("min", "max"), chart.y_range, strict=True)
            if value is not None
        }
        if chart.log is not None:
            low, high = chart.log
            axis |= {"log_base": 10, "min": low, "max": high, "crossing": low}
            axis |= {"num_format": "0E+00"}
        drawn.set_title({"name": chart.title, "name_font": {"size": 12}})
        drawn.set_x_axis({"name": chart.x, "label_position": "low", "num_format": _COUNT})
        drawn.set_y_axis({"num_format": _COUNT, "label_position": "low"} | axis)
        legend = {"position": "bottom", "delete_series": list(chart.hidden)}
        drawn.set_legend(legend if len(chart.series) > 1 else {"none": True})
        width, height = chart.size
        drawn.set_size({"width": width, "height": height})
        self.worksheet.insert_chart(row, column, drawn)
        self._charts.append((row, column, chart.size))
        return row + height // _ROW_PIXELS + 2

    def finish(self) -> None:
        """Set what is printed: all cells and charts."""
        rows, columns = self._last
        for row, column, (width, height) in self._charts:
            rows = max(rows, row + height // _ROW_PIXELS + 1)
            end = column
            while width > 0:
                width -= round(self.widths.get(end, 8.43) * _PIXELS) + 5
                end += 1
            columns = max(columns, end - 1)
        self.worksheet.print_area(0, 0, rows, columns)

    def _heading(self, column: int, said: str, width: float, row: int) -> None:
        self.widths[column] = max(self.widths.get(column, 0.0), width)
        self.worksheet.set_column(column, column, self.widths[column])
        lines = max(2, _lines(said, self.widths[column]))
        self._heights[row] = max(self._heights.get(row, 0.0), _LINE_HEIGHT * lines + 3.0)
        self.worksheet.set_row(row, self._heights[row])
        self.worksheet.write_string(row, column, said, self.book.heading)
        self._last = (max(self._last[0], row), max(self._last[1], column))


def number_pattern(quantity: Quantity) -> str:
    """Choose the number format of a quantity."""
    if quantity.notation == "scientific":
        return "0.00E+00"
    if quantity.notation == "significant":
        return _COUNT
    return f"0.{'0' * quantity.digits}" if quantity.digits else "0"


def _look(series: Series) -> dict[str, Any]:
    colour, place = _COLOURS[series.colour], series.colour
    if series.style == "line":
        line = {"color": colour, "width": 1.75, "dash_type": _DASHES[place]}
        return {"line": line, "marker": {"type": "none"}}
    marker = {
        "type": _MARKERS[place],
        "size": series.size,
        "border": {"color": colour, "width": 1.75 if series.size >= _RING else 0.75},
        "fill": {"none": True} if series.size >= _RING else {"color": colour},
    }
    return {"line": {"none": True}, "marker": marker}


def _look_of(look: Look) -> dict[str, Any]:
    colour = COLOURS[look.stroke or look.fill][0]
    fill = {"color": COLOURS[look.fill][0]} if look.fill else {"none": True}
    if look.sign in _SIGNS:
        border = {"color": COLOURS["ink"][0] if look.stroke == "paper" else colour}
        size = max(5, round(look.size))
        marker = {"type": _SIGNS[look.sign], "size": size, "border": border, "fill": fill}
        return {"line": {"none": True}, "marker": marker}
    dash = "dash" if look.dash else "solid"
    line = {"color": colour, "width": 0.75 * look.width, "dash_type": dash}
    return {"line": line, "marker": {"type": "none"}}


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
    texts = [cell.text if isinstance(cell, Text) else cell for cell in cells]
    longest = max((len(text) + 2 for text in texts if isinstance(text, str)), default=0)
    word = max((len(part) for part in heading.split()), default=0) + 2
    return float(min(max(longest, 12, word, math.ceil(len(heading) / 2) + 3), _WIDEST))
