"""Charts as pictures: values on their axes, to scale, nothing cut off, the same bytes each time."""

from __future__ import annotations

from itertools import combinations
from typing import Any

import numpy as np
import pytest
from matplotlib.figure import Figure
from matplotlib.transforms import Bbox

from catopt.figures.chart import Chart, legend
from catopt.render.picture import DPI, WIDTH, image, picture, pictures
from tests.figures.kinds import KINDS, LONG, made

_ROUNDING = 1e-12
"""Relative: a change of unit."""


@pytest.fixture(params=KINDS)
def chart(request: pytest.FixtureRequest) -> Chart:
    return made(request.param)


def frame_of(figure: Figure) -> Any:
    return figure.subfigs[0].axes[0]


def boxes(figure: Figure) -> dict[str, Bbox]:
    """Where the words around the frame are, in pixels."""
    figure.draw_without_rendering()
    renderer: Any = figure.canvas.get_renderer()  # type: ignore[attr-defined]
    axes = frame_of(figure)
    found = {
        "frame": axes.get_window_extent(renderer),
        "x label": axes.xaxis.label.get_window_extent(renderer),
        "y label": axes.yaxis.label.get_window_extent(renderer),
        "title": axes._left_title.get_window_extent(renderer),
        "heading": figure._suptitle.get_window_extent(renderer),  # type: ignore[attr-defined]
    }
    for entries in figure.subfigs[0].legends:
        found["legend"] = entries.get_window_extent(renderer)
    return found


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
        of_role = [line for line in drawn if line.get_label() == f"_{series.role}"]
        wanted = [chart.x.quantity.to_field(x) for x in series.x]
        line = next(each for each in of_role if len(each.get_xdata()) == len(wanted)
                    and np.allclose(each.get_xdata(), wanted, rtol=_ROUNDING))  # fmt: skip
        drawn.remove(line)
        up = [chart.y.quantity.to_field(y or chart.y.foot or 0.0) for y in series.y]
        assert np.allclose(line.get_ydata(), up, rtol=_ROUNDING)
    if chart.to_scale is not None:
        (x0, y0), (x1, y1) = axes.transData.transform([(0.0, 0.0), (1.0, 1.0)])
        across, up_a_metre = (x1 - x0), (y1 - y0)
        # Frames are placed to a pixel.
        assert up_a_metre / across == pytest.approx(chart.to_scale, rel=1e-2)


def test_what_is_said_is_in_the_picture_in_both_languages(chart: Chart) -> None:
    english = picture(chart, "", "en").subfigs[0]
    vietnamese = picture(chart, "", "vi").subfigs[0]
    count = len(list(legend(chart))) + len(chart.notes)
    for part in (english, vietnamese):
        texts = [text for each in part.legends for text in each.get_texts()]
        assert len(texts) == count
    assert english.axes[0].get_title("left") != vietnamese.axes[0].get_title("left")


@pytest.mark.slow
def test_a_picture_is_the_same_bytes_each_time() -> None:
    charts = [made(name) for name in ("plan", "restoring")]
    first, second = (pictures("a", charts, "$T$", columns=2) for _ in range(2))
    assert first == second
    assert list(first) == ["a.png", "a.svg"]
    assert b"<dc:date>" not in first["a.svg"]
    width = int.from_bytes(first["a.png"][16:20], "big")
    assert width == round(WIDTH * DPI)


def test_no_global_state_is_left_behind() -> None:
    import matplotlib as mpl

    before = dict(mpl.rcParams)
    image(picture(made("tension")), "svg")
    assert dict(mpl.rcParams) == before
