"""The drawings of the calculation note: what the note hands to them."""

from __future__ import annotations

import html
import re

import pytest

from catopt.notes.line import Note
from catopt.render.svg import WIDTH, Figure, breadth
from catopt.render.texts import Words
from catopt.report.page.curve_figure import curve_figure
from catopt.report.page.figures import capacities, line_drawing, tension_figure
from tests.reports import NOTES

from .page_cases import EVERY, known_note

ROUNDED = 0.01
"""Coordinates are written to a hundredth of a unit."""


@pytest.fixture(params=EVERY)
def note(request: pytest.FixtureRequest) -> Note:
    return known_note(request.param)


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
    assert "off the scale" in figures(known_note("states"))[1].notes[0]
    assert figures(known_note("raised"))[1].notes == ()


WRITTEN = re.compile(
    r'<text class="([\w -]+)" x="([\d.]+)" y="[\d.]+" text-anchor="(\w+)"( transform)?[^>]*>'
    r"([^<]+)<"
)


@pytest.mark.parametrize("name", sorted(path.stem for path in NOTES.glob("*.html")))
def test_words_have_room_in_any_font(name: str) -> None:
    """In the widest letters words along a figure stay in it; titles of axes are never turned."""
    written = WRITTEN.findall((NOTES / f"{name}.html").read_text("utf-8"))
    assert len(written) > 20
    for style, at, anchor, turned, words in written:
        x = float(at)
        room = {"start": WIDTH - x, "end": x, "middle": 2.0 * min(x, WIDTH - x)}[anchor]
        assert turned or breadth(html.unescape(words)) <= room + ROUNDED, words
        assert not (turned and style == "axis"), words
