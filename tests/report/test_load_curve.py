"""The load curve's tables and figure."""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import replace
from itertools import combinations
from typing import Any

import pytest
from matplotlib.figure import Figure

from catopt.catenary.case_curve import CaseCurve, curve_case
from catopt.model import Case, Checks, Line, Load, PointLoad, Segment, Site
from catopt.report.plots.common import render
from catopt.report.plots.line import load_curve
from catopt.report.tables import solution as tables

LINE = Line(
    [Segment(55.0, 2100.0, MBL=7.5e6, name="chain")],
    [
        PointLoad(7.0, 200e3, name="a sinker with a name far longer than any legend is wide"),
        PointLoad(9.0, 5e4),
    ],
)
CASE = Case(
    Site(20.0),
    LINE,
    Load(horizontal_force=4.5e5),
    20.0,
    checks=Checks(5.0, math.radians(3.0)),
    title="Bến phao $20$ m",
)


@pytest.fixture(scope="module", params=["force", "span", "offset"])
def result(request: pytest.FixtureRequest) -> CaseCurve:
    return curve_case(CASE, over=request.param, points=20)


def test_points_in_the_field_s_units(result: CaseCurve) -> None:
    frame = tables.curve_points(result)
    curve = result.curve
    assert list(frame["Span S (m)"]) == curve.span.tolist()
    assert list(frame["Horizontal force H (kN)"]) == (curve.horizontal_force / 1e3).tolist()
    assert frame["Inclination at the anchor theta0 (deg)"].to_numpy() == pytest.approx(
        [math.degrees(angle) for angle in curve.anchor_angle], rel=1e-15
    )
    assert frame["Stiffness k (kN/m)"].to_numpy() == pytest.approx(curve.stiffness / 1e3, rel=1e-15)
    zero = result.reference.span
    assert frame["Offset (m)"].to_numpy() == pytest.approx(curve.span - zero, abs=1e-12)
    assert list(frame["Regime"]) == list(curve.regime)


def test_a_stiffness_without_end_is_empty() -> None:
    flat = replace(CASE, line=Line(LINE.segments), fairlead_height=0.0)
    frame = tables.curve_points(curve_case(flat, points=3))
    assert frame["Stiffness k (kN/m)"].isna().all()


def test_marks(result: CaseCurve) -> None:
    frame = tables.curve_marks(result)
    kinds = Counter(frame["Kind"])
    assert kinds == {"clump_weight": 4, "regime": 1, "limit": 2}
    assert frame["Span S (m)"].is_monotonic_increasing
    assert frame["Horizontal force H (kN)"].is_monotonic_increasing
    none = curve_case(replace(CASE, line=Line([Segment(80.0, 2100.0)])), stop=1e3, start=1e2)
    assert tables.curve_marks(none).empty
    assert list(tables.curve_marks(none).columns) == list(frame.columns)


def drawn(figure: Figure) -> dict[str, Any]:
    """Lines of the frame by their labels."""
    return {str(line.get_label()): line for line in figure.axes[0].lines}


def test_the_figure_shows_both_forces_the_case_and_every_mark(result: CaseCurve) -> None:
    figure = load_curve(result)
    lines = drawn(figure)
    spans, forces, tensions = result.outline()
    zero = result.reference.span if result.over == "offset" else 0.0
    curve = lines["Horizontal force H"]
    assert list(curve.get_xdata()) == [span - zero for span in spans]
    assert list(curve.get_ydata()) == [force / 1e3 for force in forces]
    assert list(lines["Fairlead tension T"].get_ydata()) == [t / 1e3 for t in tensions]
    case = lines["The case: H 450.000 kN"]
    assert list(case.get_xdata()) == pytest.approx([result.reference.span - zero] * 2)
    assert list(case.get_ydata()) == pytest.approx([450.0, result.reference.fairlead.tension / 1e3])
    numbered = [label for label in lines if ": H " in label and not label.startswith("The case")]
    assert len(numbered) == len(result.curve.marks)
    expected = "Offset (m)" if result.over == "offset" else "Span S (m)"
    assert figure.axes[0].get_xlabel() == expected


def test_the_numbers_of_marks_do_not_hide_each_other_or_the_curves(result: CaseCurve) -> None:
    figure = load_curve(result)
    figure.canvas.draw()
    axes = figure.axes[0]
    boxes = [
        line.get_transform().transform(line.get_xydata())[0]
        for line in axes.lines
        if line.get_marker() == "s"
    ]
    side = 12 * figure.dpi / 72  # of the squares, in pixels
    for one, other in combinations(boxes, 2):
        assert max(abs(one - other)) >= 0.9 * side
    for label in ("Horizontal force H", "Fairlead tension T"):
        line = drawn(figure)[label]
        places = line.get_transform().transform(line.get_xydata())
        for box in boxes:
            assert (abs(places - box).max(axis=1) > 0.5 * side).all(), label


def test_a_case_outside_the_range_is_not_drawn() -> None:
    beyond = curve_case(CASE, stop=1e5)
    assert not any(label.startswith("The case") for label in drawn(load_curve(beyond)))


def test_the_figure_is_the_same_each_time(result: CaseCurve) -> None:
    assert render(load_curve(result), "svg") == render(load_curve(result), "svg")
