"""Charts on a page and as pictures: every place where its value says, to scale, nothing cut off."""

from __future__ import annotations

import math
from itertools import combinations
from typing import Any

import matplotlib as mpl
import pytest
from matplotlib.figure import Figure
from matplotlib.transforms import Bbox

from catopt.figures.chart import Axis, Chart, Series, legend
from catopt.quantities import QUANTITIES
from catopt.render.picture import image, picture, pictures
from catopt.render.svg import (
    COLOURS,
    LOOKS,
    WIDTH,
    Shape,
    breadth,
    stylesheet,
    svg,
    tick_words,
    ticks,
)
from catopt.render.svg import Figure as Drawn
from catopt.render.values import in_language
from catopt.words import LANGUAGES
from tests.figures.kinds import KINDS, LONG, made

ROUNDED = 0.02
"""Coordinates are written to a hundredth of a unit; a difference of two is off by two halves."""
_ROUNDING = 1e-12
"""Relative: a change of unit."""


@pytest.fixture(params=KINDS)
def chart(request: pytest.FixtureRequest) -> Chart:
    return made(request.param)


def of_role(figure: Drawn, role: str) -> list[Shape]:
    """Return the shapes of a role."""
    return [shape for shape in figure.shapes if dict(shape.attributes)["class"] == role]


def places(shape: Shape) -> list[tuple[float, float]]:
    """Return the places of a polyline."""
    pairs = dict(shape.attributes)["points"].split()
    return [(float(x), float(y)) for x, y in (pair.split(",") for pair in pairs)]


def test_lines_are_where_the_frame_has_their_values(chart: Chart) -> None:
    figure = svg(chart)
    (frame,) = of_role(figure, "frame")
    left, top, wide, tall = (
        float(dict(frame.attributes)[k]) for k in ("x", "y", "width", "height")
    )
    drawn: dict[str, list[Shape]] = {}
    for series in chart.series:
        own = drawn.setdefault(series.role, of_role(figure, series.role))
        shown = places(own.pop(0))
        for (x, y), a, b in zip(shown, series.x, series.y, strict=True):
            assert x == pytest.approx(left + wide * chart.x.place(a), abs=ROUNDED)
            assert y == pytest.approx(top + tall * (1.0 - chart.y.place(b)), abs=ROUNDED)
    if chart.to_scale is not None:
        across = wide / (chart.x.high - chart.x.low)
        up = tall / (chart.y.high - chart.y.low)
        # The edges of the frame are written to a hundredth.
        assert up / across == pytest.approx(chart.to_scale, rel=1e-3)


def test_points_and_words_are_on_the_paper(chart: Chart) -> None:
    """In the widest letters."""
    figure = svg(in_language(chart, "vi"))
    for point in figure.points:
        assert 0.0 <= point.x <= WIDTH
        assert 0.0 <= point.y <= figure.height
        assert point.said
    for shape in figure.shapes:
        given = dict(shape.attributes)
        if shape.tag != "text" or "transform" in given:
            continue
        x = float(given["x"])
        room = {"start": WIDTH - x, "end": x, "middle": 2.0 * min(x, WIDTH - x)}
        assert breadth(shape.text) <= room[given["text-anchor"]] + ROUNDED, shape.text
        assert 0.0 < float(given["y"]) < figure.height


def test_words_are_in_the_language_that_is_asked_for(chart: Chart) -> None:
    english, vietnamese = svg(chart), svg(in_language(chart, "vi"))
    assert english.title != vietnamese.title
    assert len(english.shapes) == len(vietnamese.shapes)
    assert [(p.x, p.y) for p in english.points] == [(p.x, p.y) for p in vietnamese.points]
    assert len(english.notes) == len(vietnamese.notes) == len(chart.notes)
    drawn = [picture(chart, "", language).subfigs[0] for language in LANGUAGES]
    for part in drawn:
        said = [text for each in part.legends for text in each.get_texts()]
        assert len(said) == len(list(legend(chart))) + len(chart.notes)
    assert len({part.axes[0].get_title("left") for part in drawn}) == len(LANGUAGES)


def test_the_values_along_an_axis_are_where_they_say() -> None:
    figure = svg(made("tension"))
    (curve,) = of_role(figure, "first")
    labels = [
        (float(shape.text), float(dict(shape.attributes)["y"]) - 5.0)
        for shape in of_role(figure, "tick")
        if dict(shape.attributes)["text-anchor"] == "end"
    ]
    (low, low_y), *_, (high, high_y) = labels
    series = made("tension").series[0]
    for (_, y), tension in zip(places(curve), series.y, strict=True):
        value = low + (high - low) * (low_y - y) / (low_y - high_y)
        assert value == pytest.approx(tension / 1e3, abs=1e-3 * high)


def test_a_value_that_is_not_known_is_a_gap() -> None:
    axis = Axis("x", QUANTITIES["length"], 0.0, 3.0)
    gap = Series("first", (0.0, 1.0, 2.0, 3.0), (0.0, 1.0, math.nan, 2.0))
    figure = svg(Chart("gap", "a gap", axis, axis, series=(gap,)))
    assert [len(places(shape)) for shape in of_role(figure, "first")] == [2, 1]


def test_the_style_sheet_has_every_role_and_every_colour_twice() -> None:
    sheet = stylesheet()
    assert all(f"svg .{role}{{" in sheet for role in LOOKS)
    assert all(sheet.count(f"--{colour}:") == 2 for colour in COLOURS)
    used = {colour for look in LOOKS.values() for colour in (look.stroke, look.fill) if colour}
    assert used <= set(COLOURS)


@pytest.mark.parametrize(
    ("low", "high", "most", "expected"),
    [
        (0.0, 10.0, 6, [0, 2, 4, 6, 8, 10]),
        (0.0, 1.0, 5, [0, 0.2, 0.4, 0.6, 0.8, 1.0]),
        (-0.6, 0.9, 6, [-0.5, 0.0, 0.5]),
        (24.9, 26.5, 6, [25.0, 25.5, 26.0, 26.5]),
        (0.0, 123456.0, 6, [0, 50000, 100000]),
        (3.0, 3.0, 6, [3.0]),
    ],
)
def test_ticks_are_round(low: float, high: float, most: int, expected: list[float]) -> None:
    assert ticks(low, high, most) == pytest.approx(expected, abs=1e-12)


def test_ticks_are_written_with_the_digits_they_need() -> None:
    assert tick_words([0.0, 0.5, 1.0]) == ["0.0", "0.5", "1.0"]
    assert tick_words([-0.02, 0.0, 0.02]) == ["-0.02", "0.00", "0.02"]
    assert tick_words([0.0, 200.0]) == ["0", "200"]


# ------------------------------------------------------------------ pictures


def frame_of(figure: Figure) -> Any:
    return figure.subfigs[0].axes[0]


def boxes(figure: Figure) -> dict[str, Bbox]:
    """Where the words around the frame are, in pixels."""
    figure.draw_without_rendering()
    axes = frame_of(figure)
    parts: dict[str, Any] = {
        "frame": axes,
        "x label": axes.xaxis.label,
        "y label": axes.yaxis.label,
        "title": axes._left_title,
        "heading": figure._suptitle,  # type: ignore[attr-defined]
    }
    parts |= {f"legend {k}": each for k, each in enumerate(figure.subfigs[0].legends)}
    return {name: part.get_window_extent() for name, part in parts.items()}


@pytest.mark.slow
def test_nothing_overlaps_and_nothing_is_cut_off(chart: Chart) -> None:
    figure = picture(chart, LONG)
    found = boxes(figure)
    for first, second in combinations(found, 2):
        overlap = Bbox.intersection(found[first], found[second])
        assert overlap is None or overlap.width * overlap.height < 1.0, (first, second)
    page = figure.bbox
    for part, box in found.items():
        inside = box.x0 >= 0.0 and box.y0 >= 0.0 and box.x1 <= page.x1 and box.y1 <= page.y1
        assert inside, (part, box)


def test_values_are_drawn_in_the_units_of_the_axes(chart: Chart) -> None:
    figure = picture(chart)
    figure.draw_without_rendering()
    axes = frame_of(figure)
    drawn = list(axes.get_lines())
    for series in chart.series:
        with_role = [line for line in drawn if line.get_label() == f"_{series.role}"]
        across = [chart.x.quantity.to_field(x) for x in series.x]
        wanted = pytest.approx(across, rel=_ROUNDING)
        line = next(each for each in with_role if list(each.get_xdata()) == wanted)
        drawn.remove(line)
        up = [chart.y.quantity.to_field(y or chart.y.foot or 0.0) for y in series.y]
        assert list(line.get_ydata()) == pytest.approx(up, rel=_ROUNDING)
    if chart.to_scale is not None:
        (x0, y0), (x1, y1) = axes.transData.transform([(0.0, 0.0), (1.0, 1.0)])
        # Frames are placed to a pixel.
        assert (y1 - y0) / (x1 - x0) == pytest.approx(chart.to_scale, rel=1e-2)


@pytest.mark.slow
def test_a_picture_is_the_same_bytes_each_time() -> None:
    charts = [made(name) for name in ("plan", "restoring")]
    first, second = (pictures("a", charts, "$T$", columns=2) for _ in range(2))
    assert first == second
    assert b"<dc:date>" not in first["a.svg"]


def test_no_global_state_is_left_behind() -> None:
    before = dict(mpl.rcParams)
    image(picture(made("tension")), "svg")
    assert dict(mpl.rcParams) == before


def test_the_number_of_the_most_loaded_line_is_red() -> None:
    """Of rules of one weight the last counts, and its words have the class `beside`, too."""
    rules = stylesheet()
    assert rules.index("svg .beside{") < rules.index("svg .most-loaded{fill:var(--bad)")
