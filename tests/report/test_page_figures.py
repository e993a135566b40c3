"""The drawings of the calculation note: to scale, and every point where its value says."""

from __future__ import annotations

import html
import math
import re

import pytest

from catopt.report.page.curve_figure import curve_figure
from catopt.report.page.figure import WIDTH, Figure, Frame, Shape, breadth, tick_words, ticks
from catopt.report.page.line_drawing import line_drawing, touchdowns
from catopt.report.page.note import Note
from catopt.report.page.tension_figure import capacities, tension_figure
from catopt.report.texts import Words
from tests.reports import NOTES

from .page_cases import EVERY, known_note

ROUNDED = 0.01
"""Coordinates are written to a hundredth of a unit."""


@pytest.fixture(params=EVERY)
def note(request: pytest.FixtureRequest) -> Note:
    return known_note(request.param)


def drawn(note: Note) -> Figure:
    figure = line_drawing(note, Words())["figure"]
    assert isinstance(figure, Figure)
    return figure


def of_style(figure: Figure, style: str) -> list[Shape]:
    """Return the shapes of a class."""
    return [shape for shape in figure.shapes if dict(shape.attributes)["class"] == style]


def places(shape: Shape) -> list[tuple[float, float]]:
    """Return the places of a polyline."""
    pairs = dict(shape.attributes)["points"].split()
    return [(float(x), float(y)) for x, y in (pair.split(",") for pair in pairs)]


def of(shape: Shape, *keys: str) -> tuple[float, ...]:
    given = dict(shape.attributes)
    return tuple(float(given[key]) for key in keys)


def test_the_line_is_drawn_to_scale(note: Note) -> None:
    """Every length of the profile, along and up, is the same multiple on the drawing."""
    (mooring,) = of_style(drawn(note), "mooring")
    profile = note.solution.profile(161)
    shown = places(mooring)
    (x0, y0), (x1, _) = shown[0], shown[-1]
    scale = (x1 - x0) / (profile.x[-1] - profile.x[0])
    for (x, y), along, up in zip(shown, profile.x, profile.z, strict=True):
        assert x - x0 == pytest.approx(scale * (along - profile.x[0]), abs=2 * ROUNDED)
        assert y0 - y == pytest.approx(scale * (up - profile.z[0]), abs=2 * ROUNDED)


def test_surface_bed_fairlead_and_anchor_are_where_they_belong(note: Note) -> None:
    figure, solution = drawn(note), note.solution
    (surface,), (bed,) = of_style(figure, "surface"), of_style(figure, "bed-edge")
    (fairlead,) = of_style(figure, "fairlead")
    x, y = places(of_style(figure, "mooring")[0])[-1]
    assert of(fairlead, "cx", "cy") == pytest.approx((x, y), abs=2 * ROUNDED)
    (bed_y,), (surface_y,) = of(bed, "y1"), of(surface, "y1")
    scale = (bed_y - y) / solution.fairlead_height
    assert (bed_y - surface_y) / scale == pytest.approx(note.case.site.water_depth, rel=1e-3)


def test_clump_weights_buoys_and_touchdowns_are_marked(note: Note) -> None:
    figure, solution = drawn(note), note.solution
    weights = [load.submerged_weight for load in solution.line.point_loads]
    assert len(of_style(figure, "clump")) == sum(weight >= 0.0 for weight in weights)
    assert len(of_style(figure, "buoy")) == sum(weight < 0.0 for weight in weights)
    assert len(of_style(figure, "touchdown")) == len(touchdowns(solution))
    lying = solution.grounded_length > 0.0
    assert bool(of_style(figure, "grounded")) == lying


def test_dimensions_say_what_they_span(note: Note) -> None:
    words = [shape.text for shape in of_style(drawn(note), "measure")]
    assert f"S = {note.solution.span:.3f} m" in words
    assert f"{note.solution.fairlead_height:.3f} m" in words
    differs = not math.isclose(note.case.site.water_depth, note.solution.fairlead_height)
    assert (f"{note.case.site.water_depth:.3f} m" in words) or not differs


def figures(note: Note) -> list[Figure]:
    words = Words()
    built = [line_drawing(note, words), tension_figure(note, words), curve_figure(note, words)]
    return [each["figure"] for each in built if each is not None]


def test_every_point_that_answers_is_on_the_paper_and_says_something(note: Note) -> None:
    for figure in figures(note):
        assert len(figure.points) >= 100
        for point in figure.points:
            assert -ROUNDED <= point.x <= WIDTH + ROUNDED
            assert -ROUNDED <= point.y <= figure.height + ROUNDED
            assert point.text


def test_points_of_the_line_say_what_the_profile_has(note: Note) -> None:
    profile = note.solution.profile(161)
    for figure in figures(note)[:2]:
        for index in (0, len(profile.s) // 2, len(profile.s) - 1):
            assert figure.points[index].text == (
                f"s = {profile.s[index]:.3f} m, x = {profile.x[index]:.3f} m, "
                f"z = {round(profile.z[index], 3) + 0.0:.3f} m, "
                f"tension T = {profile.tension[index] / 1e3:.3f} kN"
            )


def test_tension_is_drawn_where_its_axis_says(note: Note) -> None:
    """By the labels of the axis: two round values give the scale."""
    figure = figures(note)[1]
    labels = [
        (float(shape.text), *of(shape, "x", "y"))
        for shape in figure.shapes
        if shape.tag == "text" and dict(shape.attributes).get("text-anchor") == "end"
    ]
    (low, _, low_y), (high, _, high_y) = labels[0], labels[-1]
    (curve,) = of_style(figure, "curve first")
    profile = note.solution.profile(161)
    for (_, y), tension in zip(places(curve), profile.tension, strict=True):
        value = low + (high - low) * (low_y - 5 - y) / (low_y - high_y)
        assert value == pytest.approx(tension / 1e3, abs=1e-3 * high)


def test_allowed_tensions_are_those_of_the_checks() -> None:
    note = known_note("states")
    tensions = [
        check.capacity
        for check in note.checks.results
        if check.kind == "tension" and check.load_case == note.load_case
    ]
    assert len(tensions) == 2  # by the code, and by the case's own factor, which is stricter
    assert capacities(note) == [min(tensions)]
    assert capacities(known_note("leg")) == [6140e3 / 2.0, 2500e3 / 2.0]
    assert capacities(known_note("slack")) == [None]


def test_a_capacity_off_the_scale_is_told_below() -> None:
    figure = figures(known_note("states"))[1]
    assert not of_style(figure, "capacity")
    assert "off the scale" in figure.notes[0]
    figure = figures(known_note("raised"))[1]
    assert len(of_style(figure, "capacity")) == 1
    assert figure.notes == ()


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


def test_a_frame_places_its_corners() -> None:
    frame = Frame(10.0, 110.0, 20.0, 70.0, (0.0, 2.0), (-1.0, 1.0))
    assert frame.at(0.0, -1.0) == (10.0, 70.0)
    assert frame.at(2.0, 1.0) == (110.0, 20.0)


WRITTEN = re.compile(
    r'<text class="(\w+)" x="([\d.]+)" y="[\d.]+" text-anchor="(\w+)"( transform)?[^>]*>([^<]+)<'
)


@pytest.mark.parametrize("name", sorted(path.stem for path in NOTES.glob("*.html")))
def test_words_have_room_in_any_font(name: str) -> None:
    """In the widest letters words along a figure stay in it; titles of axes are never turned."""
    written = WRITTEN.findall((NOTES / f"{name}.html").read_text("utf-8"))
    assert len(written) > 20
    for style, at, anchor, turned, words in written:
        x = float(at)
        room = {"start": WIDTH - x, "end": x, "middle": 2.0 * min(x, WIDTH - x)}[anchor]
        assert turned or breadth(html.unescape(words)) <= room, words
        assert not (turned and style == "axis"), words
