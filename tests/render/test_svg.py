"""Charts on a page: every place where its value says, to scale, and words on the paper."""

from __future__ import annotations

import math

import pytest

from catopt.figures.chart import Axis, Chart, Series
from catopt.quantities import QUANTITIES
from catopt.render.looks import COLOURS, LOOKS, stylesheet
from catopt.render.svg import WIDTH, Figure, Shape, breadth, svg
from catopt.render.ticks import tick_words, ticks
from catopt.render.units import in_language
from tests.figures.kinds import KINDS, made

ROUNDED = 0.02
"""Coordinates are written to a hundredth of a unit; a difference of two is off by two halves."""


@pytest.fixture(params=KINDS)
def name(request: pytest.FixtureRequest) -> str:
    return str(request.param)


def of_role(figure: Figure, role: str) -> list[Shape]:
    """Return the shapes of a role."""
    return [shape for shape in figure.shapes if dict(shape.attributes)["class"] == role]


def places(shape: Shape) -> list[tuple[float, float]]:
    """Return the places of a polyline."""
    pairs = dict(shape.attributes)["points"].split()
    return [(float(x), float(y)) for x, y in (pair.split(",") for pair in pairs)]


def test_lines_are_where_the_frame_has_their_values(name: str) -> None:
    chart = made(name)
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


def test_points_and_words_are_on_the_paper(name: str) -> None:
    """In the widest letters."""
    figure = svg(in_language(made(name), "vi"))
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


def test_words_are_in_the_language_that_is_asked_for(name: str) -> None:
    chart = made(name)
    english, vietnamese = svg(chart), svg(in_language(chart, "vi"))
    assert english.title != vietnamese.title
    assert len(english.shapes) == len(vietnamese.shapes)
    assert [(p.x, p.y) for p in english.points] == [(p.x, p.y) for p in vietnamese.points]
    assert len(english.notes) == len(vietnamese.notes) == len(chart.notes)


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
