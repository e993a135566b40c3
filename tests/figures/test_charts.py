"""What drawings hold: the values of results, each thing in its role, words in both languages."""

from __future__ import annotations

import math
from collections import Counter
from itertools import pairwise
from typing import Any

import pytest

from catopt import size_buoy, size_tanker
from catopt.answers.check import failing_checks
from catopt.catenary.case import solve_case
from catopt.catenary.case_curve import CaseCurve, curve_case
from catopt.checks.case import check_case
from catopt.figures.chart import Chart, legend
from catopt.figures.line import (
    grounded_ends,
    line_in_water,
    load_curve,
    magnified,
    tension_along,
    touchdowns,
)
from catopt.figures.mooring import (
    near,
    network_side,
    plan,
    restoring,
    spread,
    watch_round,
    watch_track,
)
from catopt.figures.sizing import elevation, swing_circle
from catopt.figures.swarm import fitness
from catopt.model import Case, Checks, Line, Load, Segment, Site
from catopt.model.network import LineBetween, Network, Point
from catopt.mooring.fixed_body import at_rest
from catopt.quantities import QUANTITIES
from catopt.render.svg import LOOKS
from catopt.words import Message
from tests.answers.results import CURVED, report_with
from tests.report.notes import BODIES, TURRET, body_note

from .kinds import KINDS, LONG, leg, made, short

NEUTRAL = {"x", "y", LONG, "first"}
"""Letters of axes, and a user's own words."""


@pytest.fixture(params=KINDS)
def chart(request: pytest.FixtureRequest) -> Chart:
    return made(request.param)


def test_every_role_has_a_look(chart: Chart) -> None:
    drawn: list[Any] = [*chart.series, *chart.marks, *chart.levels, *chart.areas, *chart.arrows]
    assert {each.role for each in drawn} <= set(LOOKS)
    assert all(f"{arrow.role}-head" in LOOKS for arrow in chart.arrows)


def test_all_that_is_said_can_be_said_in_another_language(chart: Chart) -> None:
    labels = [label for _, label in legend(chart)]
    said = [chart.title, chart.x.label, chart.y.label, *labels, *chart.notes]
    said += [point.said for point in chart.points]
    assert [each for each in said if not isinstance(each, Message) and each not in NEUTRAL] == []


def test_what_is_drawn_is_within_the_axes(chart: Chart) -> None:
    places = [(mark.x, mark.y) for mark in chart.marks]
    places += [(point.x, point.y) for point in chart.points]
    for series in chart.series:
        places += zip(series.x, series.y, strict=True)
    assert all(0.0 <= chart.x.place(x) <= 1.0 >= chart.y.place(y) >= 0.0 for x, y in places)


def test_the_line_is_that_of_the_solution() -> None:
    solution = leg()
    chart = line_in_water(solution, 56.0)
    profile = solution.profile(161)
    assert chart.series[-1][:3] == ("mooring", profile.x, profile.z)
    assert len(chart.points) == len(profile.s)
    marks = Counter(mark.role for mark in chart.marks)
    assert marks == {"anchor": 1, "fairlead": 1, "clump": 1, "buoy": 1, "touchdown": 1}
    (lying,) = (series for series in chart.series if series.role == "grounded")
    assert [tuple(lying.x)] == grounded_ends(solution)
    (touchdown,) = (mark for mark in chart.marks if mark.role == "touchdown")
    assert touchdown.x == touchdowns(solution)[0][0] == grounded_ends(solution)[0][1]
    assert {area.role: area.high[0] for area in chart.areas} == {"water": 56.0, "bed": 0.0}


def test_dimensions_say_what_they_span() -> None:
    solution = leg()
    chart = line_in_water(solution, 56.0)
    spans = {each.words: math.dist(each.start, each.end) for each in chart.dimensions}
    start, end = grounded_ends(solution)[0]
    assert spans == {
        f"S = {solution.span:.3f} m": pytest.approx(solution.span),
        f"{end - start:.3f} m": pytest.approx(end - start),
        "71.400 m": pytest.approx(71.4),
        "56.000 m": pytest.approx(56.0),
    }


def test_a_flat_line_is_magnified_and_a_steep_one_is_not() -> None:
    assert magnified(short(28.0, 10.0), 28.0) is None
    flat = magnified(leg(), 71.4)
    assert flat is not None
    assert f"heights exaggerated {flat.to_scale:g} times" in flat.title


def test_a_capacity_is_drawn_near_the_curve_and_said_when_far_above_or_not_known() -> None:
    solution = leg()
    largest = max(solution.profile(161).tension)
    chart = tension_along(solution, (2.0 * largest, None))
    (level,) = (each for each in chart.levels if each.role == "capacity")
    assert (level.at, level.start, level.end) == (2.0 * largest, 0.0, 750.0)
    assert level.words == QUANTITIES["tension"].format(2.0 * largest, unit=True)
    assert [note.split(":")[0] for note in chart.notes] == ["Segment 2"]
    far = tension_along(solution, (3.0 * largest, 3.0 * largest), "MBL / 2")
    assert not any(each.role == "capacity" for each in far.levels)
    assert all("MBL / 2" in note and "off the scale" in note for note in far.notes)
    assert far.y.high < 1.2 * largest, "the curve fills the frame"


@pytest.fixture(scope="module")
def curve() -> CaseCurve:
    return curve_case(CURVED)


def test_the_load_curve_has_both_forces_the_case_and_every_mark(curve: CaseCurve) -> None:
    chart = load_curve(curve)
    spans, forces, tensions = curve.outline()
    assert [list(each.y) for each in chart.series] == [forces, tensions]
    assert all(list(each.x) == spans for each in chart.series)
    reference = curve.reference
    assert {mark.x for mark in chart.marks} == {reference.span}
    held = [reference.horizontal_force, reference.fairlead.tension]
    assert [mark.y for mark in chart.marks] == held
    assert [level.at for level in chart.levels] == [mark.span for mark in curve.curve.marks]
    for number, (mark, note) in enumerate(zip(curve.curve.marks, chart.notes, strict=True), 1):
        assert note.startswith(f"{number}: {mark.event}: H = ")
    assert chart.x.second is not None
    assert chart.x.second.zero == reference.span


def test_the_numbers_of_marks_are_clear_of_each_other_and_of_the_curves(curve: CaseCurve) -> None:
    chart = load_curve(curve)
    places = [(chart.x.place(level.at), level.share) for level in chart.levels]
    for index, (x, share) in enumerate(places):
        assert share is not None
        for across, other in places[:index]:
            assert other is not None
            assert abs(x - across) > 0.04 or abs(share - other) > 0.06
        for series in chart.series:
            near_it = [
                chart.y.place(force)
                for span, force in zip(series.x, series.y, strict=True)
                if abs(chart.x.place(span) - x) < 0.01
            ]
            assert all(abs(share - up) > 0.03 for up in near_it)


def test_a_case_outside_the_range_of_its_curve_is_not_drawn() -> None:
    assert load_curve(curve_case(CURVED, stop=1e5)).marks == ()


def test_what_rounding_decides_is_not_drawn() -> None:
    """A run on two processors: alike but for the last digits and for all below 1e-9 m."""
    one = report_with((1.0, 1e-4, 1e-8, 3.55e-15, 0.0, 0.0))
    other = report_with((1.0, 1e-4 * (1 + 1e-13), 1e-8, 0.0))
    assert fitness(one) == fitness(other)
    assert fitness(one).series[0].y == [1.0, 1e-4, 1e-8]
    steps = [b - a for a, b in pairwise(fitness(one).y.place(f) for f in (1.0, 1e-4, 1e-8))]
    assert steps == pytest.approx([steps[0]] * 2, rel=1e-9)  # logarithms


@pytest.mark.parametrize(
    "history", [(0.0,), (0.0, 0.0), (1e-3,), (1e-3, 1e-3), (1e-300, 0.0), (1e9, 1.0)]
)
def test_histories_of_every_kind_have_their_place(history: tuple[float, ...]) -> None:
    chart = fitness(report_with(history))
    assert 0.0 < chart.y.low < chart.y.high < math.inf
    assert list(chart.series[0].y) == [f for f in history if f > 1e-9]
    assert all(0.0 <= chart.y.place(f) <= 1.0 for f in chart.series[0].y)


def test_where_a_run_has_converged_is_said() -> None:
    early = fitness(report_with((1.0, 0.0), iterations=200)).notes
    assert any("from iteration 2 of 200 on" in note for note in early)
    assert fitness(report_with((1.0, 0.5), iterations=2)).notes == ()


# ------------------------------------------------------------------ a moored body


@pytest.mark.parametrize("name", BODIES)
def test_the_plan_has_every_line_with_its_number_and_the_force(name: str) -> None:
    solution = body_note(name).solution
    chart = plan(solution)
    legs = [series for series in chart.series if series.role == "leg"]
    for series, line in zip(legs, solution.lines, strict=True):
        drawn = list(zip(series.x, series.y, strict=True))
        assert drawn == [line.leg.anchor, line.fairlead]
    numbers = [mark.words for mark in chart.marks if mark.words and mark.role != "beside"]
    assert numbers == [str(k) for k in range(1, len(solution.lines) + 1)]
    (loaded,) = (mark.words for mark in chart.marks if mark.role == "most-loaded")
    assert loaded == str(solution.most_loaded + 1)
    lying = sum(line.solution.grounded_length > 0.0 for line in solution.lines)
    assert sum(series.role == "lying" for series in chart.series) == lying
    assert len(chart.arrows) == int(any(solution.system.force))
    for arrow in chart.arrows:
        fx, fy = solution.system.force
        dx, dy = arrow.end[0] - arrow.start[0], arrow.end[1] - arrow.start[1]
        away = math.remainder(math.atan2(dy, dx) - math.atan2(fy, fx), 2.0 * math.pi)
        assert away == pytest.approx(0.0, abs=1e-9)


def test_the_surroundings_show_a_small_offset_and_only_that() -> None:
    solution = body_note(TURRET).solution
    chart = near(solution)
    assert chart is not None
    (way,) = (series for series in chart.series if series.role == "offset-mark")
    length = math.hypot(way.x[1] - way.x[0], way.y[1] - way.y[0])
    assert length == pytest.approx(math.hypot(*solution.offset), rel=1e-12)
    assert near(body_note("idle").solution) is None


def test_the_watch_circle_closes_and_holds_every_place() -> None:
    note = body_note(TURRET)
    circle = note.report.circle
    assert circle is not None
    (track,) = (s for s in watch_track(note.solution, circle).series if s.role == "first")
    places = list(zip(track.x, track.y, strict=True))
    assert places == [(each.x, each.y) for each in (*circle.responses, circle.responses[0])]
    chart = watch_round(note.solution, circle, 1e5)
    values = [each.largest_tension for each in circle.responses]
    assert list(chart.series[0].y) == [*values, values[0]]
    assert [level.at for level in chart.levels] == [1e5]
    far = watch_round(note.solution, circle, 1e9)
    assert far.levels == ()
    assert "off the scale" in far.notes[0]


def test_restoring_curves_are_those_of_the_report_up_to_a_multiple_of_the_force() -> None:
    note = body_note("pulled")
    curves, force = note.report.curves, math.hypot(*note.solution.system.force)
    whole = restoring(curves, note.solution)
    assert [tuple(each.y) for each in whole.series] == [curve.force for curve in curves]
    assert whole.notes == ()
    part = restoring(curves, note.solution, 4.0)
    drawn = [y for series in part.series for y in series.y]
    assert max(map(abs, drawn)) <= 4.0 * force < max(map(abs, curves[0].force))
    assert "4 times" in part.notes[0]


@pytest.mark.parametrize(
    "degrees",
    [[0.0, 90.0, 180.0], [-3.0, 0.0, 3.0, 117.0, 120.0, 123.0], [359.0, 0.5, 2.0], [10.0], []],
)
def test_numbers_are_spread_as_far_as_they_need_and_no_further(degrees: list[float]) -> None:
    given = [math.radians(each) for each in degrees]
    room = 0.1
    found = spread(given, room)
    turns = sorted(angle % (2.0 * math.pi) for angle in found)
    for index, angle in enumerate(turns[1:]):
        assert angle - turns[index] >= room * (1.0 - 1e-9)
    for before, after in zip(given, found, strict=True):
        moved = abs(math.remainder(after - before, 2.0 * math.pi))
        assert moved <= room * (len(given) - 1) / 2.0 + 1e-9
    apart = min(
        (abs(math.remainder(a - b, 2.0 * math.pi)) for a in given for b in given if a != b),
        default=math.inf,
    )
    if apart >= room:
        turned = [math.remainder(a - b, 2.0 * math.pi) for a, b in zip(found, given, strict=True)]
        assert turned == pytest.approx([0.0] * len(given), abs=1e-12)


def test_a_check_that_fails_is_marked_where_it_fails() -> None:
    """A line of two chains, of which the upper one breaks first, held as no anchor may be."""
    line = Line([Segment(60.0, 180.0, EA=80e6, MBL=700e3), Segment(20.0, 80.0, EA=35e6, MBL=330e3)])
    checks = Checks(safety_factor=3.0, max_anchor_uplift_angle=0.0, max_span=70.0)
    case = Case(Site(20.0), line, Load(150e3), fairlead_height=20.0, checks=checks)
    solution, report = solve_case(case), check_case(case)
    marks = {
        (round(mark.x, 9), round(mark.y, 9))
        for mark in line_in_water(solution, 20.0, failing_checks(report)).marks
        if mark.role == "failing"
    }
    failing = {each.kind for each in report.results if not each.passes}
    assert failing == {"tension", "uplift_angle", "span"}
    # Both ends: the tension is largest, and the span measured, at the fairlead.
    assert marks == {(0.0, 0.0), (round(solution.span, 9), 20.0)}
    assert not [each for each in line_in_water(solution, 20.0).marks if each.role == "failing"]


def test_numbers_of_lines_behind_each_other_are_one_mark() -> None:
    """Four equal legs at 45 degrees: from the side two and two lie behind each other."""
    chain = Line([Segment(80.0, 300.0)])
    points = [Point("body", "fairlead", 0.0, 0.0, 20.0)]
    points += [
        Point(f"anchor {k}", "anchor", 45.0 * x, 45.0 * y)
        for k, (x, y) in enumerate(((1, 1), (-1, 1), (-1, -1), (1, -1)))
    ]
    lines = tuple(LineBetween(chain, f"anchor {k}", "body") for k in range(4))
    drawn = network_side(at_rest(Network(Site(20.0), tuple(points), lines)), 2)
    numbers = {mark.words: mark.role for mark in drawn.marks if mark.words}
    assert numbers == {"1, 4": "number", "2, 3": "most-loaded"}


def test_a_sinker_is_a_block_and_an_anchor_a_triangle() -> None:
    """Tankers hang on drag anchors, buoys on sinkers; from the side and from above."""
    buoy = size_buoy("pillar 1.8 m", depth="12 m", at_rest=True)
    ship = size_tanker(dwt="50000 t", depth="20 m", at_rest=True)
    for sizing, wanted, other in ((buoy, "sinker", "anchor"), (ship, "anchor", "sinker")):
        roles = [mark.role for mark in elevation(sizing).marks]
        assert (roles.count(wanted), roles.count(other)) == (1, 0)
    assert [mark.role for mark in swing_circle(buoy).marks] == ["sinker"]
    assert [mark.role for mark in swing_circle(ship).marks] == ["anchor-spot"]
    assert (LOOKS["sinker"].sign, LOOKS["anchor"].sign) == ("square", "triangle")
