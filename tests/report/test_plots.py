"""Figures: to scale, nothing over anything else, f = 0 in sight, the same bytes each time."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from itertools import combinations
from typing import Any

import numpy as np
import pytest
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.transforms import Bbox

from catopt.catenary.case_curve import STEPPED, CaseCurve, Stepped, curve_case
from catopt.catenary.solution import Solution
from catopt.catenary.solve import solve
from catopt.model import Case, Line, Load, PointLoad, Segment, Site
from catopt.report.plots.common import DPI, SIZE, render
from catopt.report.plots.line import fitness, line_in_water, load_curve, swarm_tension, tension

from .conftest import report_with

LONG = (
    "Phao $dấu hiệu$ luồng số 1, độ sâu 9,5 m: a title that somebody made far longer than any "
    "page is wide, so that it folds twice and is then cut off at its end, which is here"
)


def short(height: float, force: float) -> Solution:
    return solve(Line([Segment(30.0, 1e3)]), height=height, horizontal_force=force)


def many_marks(over: Stepped) -> CaseCurve:
    """Compute the curve of a line on which much happens, with long names."""
    loads = [PointLoad(7.0 + k, 4e4, name=LONG) for k in range(4)]
    line = Line([Segment(55.0, 2100.0, MBL=7.5e6, name=LONG)], loads)
    return curve_case(
        Case(Site(20.0), line, Load(horizontal_force=3e5), 20.0, title=LONG), over=over
    )


def figures(buoy: Solution, leg: Solution) -> Iterator[tuple[str, Figure]]:
    """One of each kind, and the line in the water from flat to upright."""
    report = report_with((1.0, 1e-3, 3.55e-15, 0.0))
    yield "suspended", line_in_water(buoy, 9.5)
    yield "long title", line_in_water(replace(buoy, title=LONG), 9.5)
    yield "flat", line_in_water(leg, 56.0)
    yield "upright", line_in_water(short(28.0, 10.0), 28.0)
    yield "nearly on the bed", line_in_water(short(0.1, 1e3), 3.0)
    yield "tension", tension(replace(buoy, title=LONG))
    yield "tension of a leg", tension(leg)
    yield "fitness", fitness(report)
    yield "swarm tension", swarm_tension(report, 4376.8)
    for over in STEPPED:
        yield f"load curve over {over}", load_curve(many_marks(over))


def boxes(figure: Figure) -> dict[str, Bbox]:
    """Where the words around the frame are, in pixels."""
    figure.canvas.draw()
    renderer: Any = figure.canvas.get_renderer()  # type: ignore[attr-defined]
    axes = figure.axes[0]
    found = {
        "frame": axes.get_window_extent(renderer),
        "x label": axes.xaxis.label.get_window_extent(renderer),
        "y label": axes.yaxis.label.get_window_extent(renderer),
        "legend": figure.legends[0].get_window_extent(renderer),
    }
    title: Any = axes.title if not hasattr(axes, "_left_title") else axes._left_title
    if title.get_text():
        found["title"] = title.get_window_extent(renderer)
    return found


@pytest.mark.slow
def test_nothing_overlaps_and_nothing_is_cut_off(buoy: Solution, leg: Solution) -> None:
    for name, figure in figures(buoy, leg):
        found = boxes(figure)
        for first, second in combinations(found, 2):
            overlap = Bbox.intersection(found[first], found[second])
            assert overlap is None or overlap.width * overlap.height == 0.0, (name, first, second)
        page = figure.bbox
        for part, box in found.items():
            inside = box.x0 >= 0.0 and box.y0 >= 0.0 and box.x1 <= page.x1 and box.y1 <= page.y1
            assert inside, (name, part)


def test_the_line_in_the_water_is_to_scale(buoy: Solution, leg: Solution) -> None:
    """A metre is as many pixels high as wide, to a tenth of a percent of rounding to pixels."""
    for solution, depth in ((buoy, 9.5), (leg, 56.0), (short(28.0, 10.0), 28.0)):
        axes = line_in_water(solution, depth).axes[0]
        (x0, z0), (x1, z1) = axes.transData.transform([(0.0, 0.0), (1.0, 1.0)])
        assert z1 - z0 == pytest.approx(x1 - x0, rel=1e-3)
        shape = solution.profile()
        assert axes.get_xlim()[0] < min(shape.x)
        assert axes.get_xlim()[1] > max(shape.x)
        assert axes.get_ylim()[0] < 0.0 < max(depth, *shape.z) < axes.get_ylim()[1]


def places(line: Line2D) -> list[tuple[float, float]]:
    """Points of a drawn line."""
    x, y = (np.asarray(data, dtype=float).tolist() for data in line.get_data())
    return list(zip(x, y, strict=True))


def labels(figure: Figure) -> list[str]:
    return [text.get_text() for text in figure.legends[0].get_texts()]


def test_what_is_on_the_line_is_marked(buoy: Solution, leg: Solution) -> None:
    always = {"Line", "Still water", "Seabed", "Anchor", "Fairlead"}
    assert set(labels(line_in_water(buoy, 9.5))) == always
    here = {"On the bed", "Touchdown", "Clump weight", "Buoy"}
    assert set(labels(line_in_water(leg, 56.0))) == always | here


def test_marks_stand_where_the_parts_are(leg: Solution) -> None:
    lines = line_in_water(leg, 56.0).axes[0].get_lines()
    drawn = {str(line.get_label()): line for line in lines}
    for label, x in (
        ("Anchor", 0.0),
        ("Fairlead", leg.span),
        ("Clump weight", leg.point_loads[0].x),
        ("Buoy", leg.point_loads[1].x),
    ):
        assert [place[0] for place in places(drawn[label])] == [x]
    ((touchdown, _),) = places(drawn["Touchdown"])
    grounded = [x for x, z in zip(leg.profile().x, leg.profile().z, strict=True) if z == 0.0]
    assert touchdown == pytest.approx(max(grounded), rel=1e-12)


def test_capacity_is_drawn_when_near_and_named_when_far(buoy: Solution, leg: Solution) -> None:
    assert "MBL / 2" in labels(tension(leg))
    assert "MBL / 5: 46 kN, off the scale" in labels(tension(buoy))
    top = tension(buoy).axes[0].get_ylim()[1]
    assert 4.377 < top < 6.0, "the curve fills the frame"


def test_zero_on_a_logarithmic_axis_is_in_sight() -> None:
    figure = fitness(report_with((1.0, 1e-3, 3.55e-15, 0.0, 0.0)))
    axes = figure.axes[0]
    assert "f = 0 exactly" in labels(figure)
    (zeros,) = [line for line in axes.get_lines() if line.get_label() == "f = 0 exactly"]
    (first, place), (second, _) = places(zeros)
    assert (first, second) == (4, 5)
    assert axes.get_ylim()[0] < place < 3.55e-15
    written = dict(zip(axes.get_yticks(), axes.get_yticklabels(), strict=True))
    assert written[place].get_text() == "0"


def test_histories_of_every_kind_are_drawn() -> None:
    for history in ((0.0,), (0.0, 0.0), (1e-3,), (1e-3, 1e-3), (1e-300, 0.0), (1e9, 1.0)):
        figure = fitness(report_with(history))
        assert len(render(figure, "png")) > 1000
        low, high = figure.axes[0].get_ylim()
        assert 0.0 < low < high < math.inf


def test_a_run_that_stopped_early_says_so() -> None:
    early = "Stopped: f cannot fall further"
    assert early in labels(fitness(report_with((1.0, 0.0), iterations=200)))
    assert early not in labels(fitness(report_with((1.0, 0.5), iterations=2)))


def test_bytes_are_the_same_each_time(buoy: Solution) -> None:
    for kind in ("png", "svg"):
        first, second = (render(line_in_water(buoy, 9.5), kind) for _ in range(2))
        assert first == second
    assert b"<dc:date>" not in first


def test_size_of_the_page(leg: Solution) -> None:
    content = render(tension(leg), "png")
    width, height = (int.from_bytes(content[at : at + 4], "big") for at in (16, 20))
    assert (width, height) == (round(SIZE[0] * DPI), round(SIZE[1] * DPI))


def test_no_global_state_is_left_behind(buoy: Solution) -> None:
    import matplotlib as mpl

    before = dict(mpl.rcParams)
    render(line_in_water(buoy, 9.5), "svg")
    assert dict(mpl.rcParams) == before
