"""Charts as pictures for print, by matplotlib.

Nothing here touches pyplot, so that no window, backend or global figure list is involved.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from io import BytesIO
from textwrap import fill
from typing import Any, Literal
from warnings import catch_warnings, filterwarnings

from matplotlib import rc_context
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure, SubFigure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from catopt.figures.chart import Area, Axis, Chart, Dimension, Level, Mark, Place, legend
from catopt.render.svg import COLOURS, LOOKS, SIGNS, Look, Tick, axis_title, scale_ticks, tick_marks
from catopt.render.values import as_wanted
from catopt.words import Language

DPI = 200
WIDTH = 7.2
"""Inches: the text width of an A4 page."""
_POINTS = 0.75
"""Points of a picture in a unit of a look."""
_TALL, _TALLEST = 2.9, 4.6
"""Inches: height of a frame, and the greatest of one that is to scale."""
_TYPE, _LETTER = 9.0, 0.62
"""Points: type of legends; mean width of a letter over it, to choose how many stand in a row."""

STYLE: Any = {
    "font.size": 10,
    "grid.color": COLOURS["rule"][0],
    "grid.linewidth": 0.6,
    "axes.axisbelow": True,
    "axes.edgecolor": COLOURS["quiet"][0],
    "axes.linewidth": 0.8,
    "svg.hashsalt": "catopt",
}


def pictures(
    name: str, charts: Chart | Sequence[Chart], heading: str = "", columns: int = 1
) -> dict[str, bytes]:
    """Make the files of a picture, PNG and SVG, as `picture` draws it.

    Nothing is said of a letter that the font lacks: the empty box in its place says it all.
    """
    with catch_warnings():
        filterwarnings("ignore", "Glyph .* missing from")
        figure = picture(charts, heading, columns=columns)
        return {f"{name}.png": image(figure, "png"), f"{name}.svg": image(figure, "svg")}


def image(figure: Figure, kind: Literal["png", "svg"]) -> bytes:
    """Turn a picture into the bytes of a file, the same for the same picture."""
    stream = BytesIO()
    metadata = {"Date": None} if kind == "svg" else {"Software": None}
    with rc_context(STYLE):
        figure.savefig(stream, format=kind, dpi=DPI, metadata=metadata)
    return stream.getvalue()


class Picture(Figure):
    """A figure that a notebook draws whatever the backend is: it has a picture of its own."""

    def _repr_png_(self) -> bytes:
        return image(self, "png")


def picture(
    charts: Chart | Sequence[Chart], heading: str = "", language: Language = "en", columns: int = 1
) -> Figure:
    """Draw charts in a figure as wide as a page, each with its legend and its notes.

    `columns` charts stand in a row; `heading` is above all of them, such as the title of a case.
    """
    drawn = as_wanted([charts] if isinstance(charts, Chart) else list(charts), language)
    rows = [drawn[k : k + columns] for k in range(0, len(drawn), columns)]
    wide = WIDTH / columns
    heights = [max(_height(chart, wide) for chart in row) for row in rows]
    with rc_context(STYLE):
        above = fill(heading, 78, max_lines=2, placeholder=" ...")
        room = 0.1 + 0.22 * (above.count("\n") + 1) if above else 0.0
        figure = Picture(figsize=(WIDTH, sum(heights) + room), layout="constrained")
        FigureCanvasAgg(figure)
        if above:
            figure.suptitle(above, fontsize=11, parse_math=False)
        parts = figure.subfigures(len(rows), columns, squeeze=False, height_ratios=heights)
        for row, places in zip(rows, parts, strict=True):
            for chart, part in zip(row, places, strict=False):
                _draw(part, chart, wide)
        # Draw to scale what is so, once all has its place: the layout takes such frames as full.
        figure.draw_without_rendering()
        figure.set_layout_engine("none")
        frames = (axes for part in figure.subfigs for axes in part.axes)
        for chart, axes in zip(drawn, frames, strict=True):
            if chart.to_scale is not None:
                x, y = chart.x.quantity.factor, chart.y.quantity.factor
                axes.set_aspect(chart.to_scale * y / x, adjustable="box")
    return figure


def _height(chart: Chart, wide: float) -> float:
    """Return the height of a part with its title, titles of axes and legend, inches."""
    tall = _TALL if wide == WIDTH else 2.2
    if chart.to_scale is not None:
        tall = min((wide - 1.0) * chart.share, _TALLEST)
    labels, columns = _labels(chart, wide)
    lines = sum(label.count("\n") + 1 for label in labels)
    title = _title(chart, wide).count("\n") + 1
    return tall + 0.2 * title + 0.19 * -(-lines // columns) + (1.1 if chart.x.second else 0.7)


def _title(chart: Chart, wide: float) -> str:
    return fill(chart.title, int(12.0 * wide))


def _labels(chart: Chart, wide: float) -> tuple[list[str], int]:
    """Fold the words of the legend and the notes; choose how many are in a row."""
    letters = int(wide * 72.0 / (_TYPE * _LETTER))
    said = [*(label for _, label in legend(chart)), *chart.notes]
    longest = max(map(len, said), default=0) + 8
    columns = max(1, min(3, letters // longest, len(said)))
    return [fill(each, letters - 8) for each in said], columns


def _draw(part: SubFigure, chart: Chart, wide: float) -> None:
    axes = part.add_subplot()
    axes.set_title(_title(chart, wide), fontsize=9.5, loc="left", parse_math=False)
    x, y = chart.x, chart.y
    if y.foot is not None:
        axes.set_yscale("log")
    axes.set_xlim(*_all(x, (x.low, x.high)))
    axes.set_ylim(*_all(y, (y.low, y.high)))
    up = 6 if chart.to_scale is None else max(2, min(6, int(12.0 * chart.share)))
    most = max(2, round(wide))
    axes.set_xticks(*_ticked(x, tick_marks(x, most)))
    axes.set_yticks(*_ticked(y, tick_marks(y, up)))
    axes.minorticks_off()
    axes.grid(visible=chart.to_scale is None)
    axes.set_xlabel(axis_title(x), parse_math=False)
    axes.set_ylabel(axis_title(y), parse_math=False)
    if x.second:
        above = axes.secondary_xaxis("top")
        above.set_xticks(*_ticked(x, scale_ticks(x, most)))
        above.set_xlabel(axis_title(x.second))
    if y.second:
        right = axes.secondary_yaxis("right")
        right.set_yticks(*_ticked(y, scale_ticks(y, up)))
        right.set_ylabel(axis_title(y.second))
    for area in chart.areas:
        _area(axes, area, chart)
    for level in chart.levels:
        _level(axes, level, chart)
    for series in chart.series:
        look, places = LOOKS[series.role], (_all(x, series.x), _all(y, series.y))
        order = 2.5 if look.sign else 2.0
        axes.plot(*places, **_of_line(look), label=f"_{series.role}", zorder=order)
    for arrow in chart.arrows:
        look = LOOKS[arrow.role]
        line = {"color": _colour(look.stroke), "linewidth": look.width * _POINTS}
        _arrow(axes, "-|>", _at(chart, arrow.start), _at(chart, arrow.end), line, zorder=4)
    for mark in chart.marks:
        _mark(axes, mark, chart)
    for dimension in chart.dimensions:
        _dimension(axes, dimension, chart)
    _legend(part, chart, wide)


def _legend(part: SubFigure, chart: Chart, wide: float) -> None:
    labels, columns = _labels(chart, wide)
    handles = [_handle(LOOKS[role]) for role, _ in legend(chart)]
    handles += [Line2D([], [], linestyle="none")] * (len(labels) - len(handles))
    if labels:
        place: Any = {"loc": "outside lower center", "ncols": columns, "frameon": False}
        room: Any = {"handlelength": 2.4, "fontsize": _TYPE, "columnspacing": 1.4}
        for words in part.legend(handles, labels, **place, **room).get_texts():
            words.set_parse_math(False)


def _colour(name: str) -> str:
    return COLOURS[name][0] if name else "none"


def _handle(look: Look) -> Artist:
    if not look.sign and not look.stroke:
        return Patch(facecolor=_colour(look.fill), alpha=look.opacity)
    return Line2D([], [], **_of_line(look._replace(size=min(look.size, 5.0))))


def _of_line(look: Look) -> dict[str, Any]:
    width = look.width * _POINTS
    if look.sign:
        return {
            "linestyle": "none",
            "marker": SIGNS[look.sign]["picture"],
            "markersize": 2.0 * look.size * _POINTS * (0.8 if look.sign == "diamond" else 1.0),
            "markerfacecolor": _colour(look.fill),
            "markeredgecolor": _colour(look.stroke),
            "markeredgewidth": width,
        }
    dashes = (0.0, tuple(each / max(look.width, 1.0) for each in look.dash))
    style = dashes if look.dash else "-"
    return {"color": _colour(look.stroke), "linewidth": width, "linestyle": style}


# ------------------------------------------------------------------ the axes


def _ticked(axis: Axis, marks: Sequence[Tick]) -> tuple[list[float], list[str]]:
    return _all(axis, [value for value, _ in marks]), [words for _, words in marks]


def _all(axis: Axis, values: Iterable[float]) -> list[float]:
    """List values in the field's unit; an exact 0 of a logarithmic axis is at its foot."""
    foot, field = axis.foot, axis.quantity.to_field
    return [field(foot if foot is not None and each <= 0.0 else each) for each in values]


def _at(chart: Chart, place: Place) -> Place:
    """Return a place in the units of the field."""
    return _all(chart.x, place[:1])[0], _all(chart.y, place[1:])[0]


# ------------------------------------------------------------------ what is drawn


def _area(axes: Axes, area: Area, chart: Chart) -> None:
    look = LOOKS[area.role]
    kind: Any = {"color": _colour(look.fill), "alpha": look.opacity, "linewidth": 0.0}
    if area.x:
        low, high = _all(chart.y, area.low), _all(chart.y, area.high)
        axes.fill_between(_all(chart.x, area.x), low, high, zorder=0.4, **kind)
    else:
        ends = (chart.y.clip(each[0]) for each in (area.low, area.high))
        axes.axhspan(*_all(chart.y, ends), zorder=0.4, **kind)


def _level(axes: Axes, level: Level, chart: Chart) -> None:
    kind = _of_line(LOOKS[level.role]) | {"label": f"_{level.role}"}
    if level.axis == "x":
        (x,) = _all(chart.x, [level.at])
        axes.axvline(x, **kind)
        if level.share is not None:
            circle = _box("circle,pad=0.25", edgecolor=_colour("quiet"), linewidth=0.8)
            across = axes.get_xaxis_transform()
            axes.text(x, level.share, level.words, transform=across, fontsize=8, zorder=7, **circle)
        return
    (left, y), (right, _) = (_at(chart, end) for end in level.ends(chart.x, chart.y))
    axes.plot([left, right], [y, y], **kind)
    if level.words:
        _beside(axes, level.words, ((left + right) / 2.0, y), (0.0, -3.0), va="top")


def _box(style: str, **look: Any) -> Any:
    """Set words in the middle of a white box."""
    box = {"boxstyle": style, "facecolor": "white"} | look
    return {"ha": "center", "va": "center", "bbox": box}


def _beside(axes: Axes, words: str, place: Place, away: Place, **look: Any) -> None:
    """Write words at some points' distance from a place."""
    kind: dict[str, Any] = {"textcoords": "offset points", "fontsize": 8, "ha": "center"} | look
    axes.annotate(words, place, xytext=away, **kind)


def _mark(axes: Axes, mark: Mark, chart: Chart) -> None:
    x, y = _at(chart, (mark.x, mark.y))
    look = LOOKS[mark.role]
    if look.sign == "words":
        halo = _box("square,pad=0.1", edgecolor="none", alpha=0.7)
        axes.text(x, y, mark.words, fontsize=9, color=_colour(look.fill), zorder=6, **halo)
    else:
        axes.plot([x], [y], **_of_line(look), label=f"_{mark.role}", clip_on=False, zorder=5)


def _arrow(
    axes: Axes, style: str, start: Place, end: Place, line: dict[str, Any], **order: Any
) -> None:
    ends = {"arrowstyle": style, "shrinkA": 0.0, "shrinkB": 0.0}
    axes.annotate("", end, xytext=start, arrowprops=ends | line, **order)


def _dimension(axes: Axes, dimension: Dimension, chart: Chart) -> None:
    (x1, y1), (x2, y2) = _at(chart, dimension.start), _at(chart, dimension.end)
    thin = _of_line(LOOKS["thin"]) | {"label": "_thin", "zorder": 1.5}
    is_upright = x1 == x2
    for place in dimension.measured:
        x, y = _at(chart, place)
        end = (x1, y) if is_upright else (x, y1)
        axes.plot([x, end[0]], [y, end[1]], **thin)
    line = {"linewidth": 0.8, "color": _colour("ink"), "mutation_scale": 8.0}
    _arrow(axes, "<|-|>", (x1, y1), (x2, y2), line)
    words, middle = dimension.words, ((x1 + x2) / 2.0, (y1 + y2) / 2.0)
    tall = abs(y2 - y1) / (chart.x.high - chart.x.low) * (WIDTH - 1.0) * 72.0
    if is_upright and tall > _LETTER * 8.0 * len(words):
        turned: Any = {"rotation": 90.0, "ha": "right", "va": "center"}
        _beside(axes, words, middle, (-2.0, 0.0), **turned, zorder=6)
        return
    side = "center"
    if is_upright:
        middle = (middle[0], max(y1, y2))
        side = "right" if x1 > (chart.x.low + chart.x.high) / 2.0 else "left"
    _beside(axes, words, middle, (0.0, 2.0), ha=side, va="bottom", zorder=6)
