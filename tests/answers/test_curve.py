"""The load curve's tables."""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import replace

import pytest

from catopt.answers.curve import marks_table, points_table
from catopt.catenary.case_curve import CaseCurve, curve_case
from catopt.model import Case, Checks, Line, Load, PointLoad, Segment, Site

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
    frame = points_table(result).to_dataframe()
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
    frame = points_table(curve_case(flat, points=3)).to_dataframe()
    assert frame["Stiffness k (kN/m)"].isna().all()


def test_marks(result: CaseCurve) -> None:
    frame = marks_table(result).to_dataframe()
    kinds = Counter(frame["Kind"])
    assert kinds == {"clump_weight": 4, "regime": 1, "limit": 2}
    assert frame["Span S (m)"].is_monotonic_increasing
    assert frame["Horizontal force H (kN)"].is_monotonic_increasing
    none = curve_case(replace(CASE, line=Line([Segment(80.0, 2100.0)])), stop=1e3, start=1e2)
    without = marks_table(none).to_dataframe()
    assert without.empty
    assert list(without.columns) == list(frame.columns)
