"""The pictures of docs/conventions.md are those of their script, and show what their words say."""

from __future__ import annotations

import importlib.util
import math
import re
from io import BytesIO
from pathlib import Path
from typing import Any

import matplotlib as mpl
import pytest

DOCS = Path(__file__).parents[1] / "docs"


def _script() -> Any:
    spec = importlib.util.spec_from_file_location("drawings", DOCS / "convention_drawings.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


SCRIPT = _script()


def test_every_picture_is_on_the_page() -> None:
    page = (DOCS / "conventions.md").read_text("utf-8")
    assert set(re.findall(r"!\[[^\]]+\]\(([\w-]+\.svg)\)", page)) == set(SCRIPT.DRAWINGS)


NUMBER = re.compile(r"-?\d+\.\d+")


@pytest.mark.parametrize("name", SCRIPT.DRAWINGS)
def test_the_pictures_are_those_of_the_script(name: str) -> None:
    """To a thousandth of a point, where the same matplotlib draws: another may place letters."""
    kept = (DOCS / name).read_text("utf-8")
    stream = BytesIO()
    with mpl.rc_context(SCRIPT.STYLE):
        SCRIPT.DRAWINGS[name]().savefig(stream, format="svg", metadata={"Date": None}, dpi=150)
    drawn = stream.getvalue().decode()
    assert "</svg>" in drawn
    if f"Matplotlib v{mpl.__version__}," in kept:
        anew = "draw it anew: python docs/convention_drawings.py"
        assert NUMBER.sub("", drawn) == NUMBER.sub("", kept), anew
        places = [[float(each) for each in NUMBER.findall(text)] for text in (drawn, kept)]
        assert places[0] == pytest.approx(places[1], abs=1e-3), anew


def test_the_force_at_the_fairlead_goes_on_where_the_line_ends() -> None:
    """The last piece drawn of the line, and the arrow of T: one direction but for the curve."""
    solution = SCRIPT.moored()
    (axes,) = SCRIPT.draw_line().axes
    line = next(each for each in axes.lines if len(each.get_xdata()) > 100)
    (x0, x1), (z0, z1) = line.get_xdata()[-2:], line.get_ydata()[-2:]
    # A step of a 200th of 62 m turns by w ds / H = 0.01 rad at most, half of it at its middle.
    assert math.atan2(z1 - z0, x1 - x0) == pytest.approx(solution.fairlead.angle, abs=0.006)
    arrow = next(each for each in axes.texts if each.arrow_patch and each.xyann == (x1, z1))
    x, z = arrow.xy
    assert math.atan2(z - z1, x - x1) == pytest.approx(solution.fairlead.angle, abs=1e-12)


def test_the_signs_at_the_anchor_are_those_of_the_words() -> None:
    signs = [
        next(text.get_text() for text in axes.texts if "V" in text.get_text())
        for axes in SCRIPT.draw_anchor().axes
    ]
    assert signs == ["V > 0,  θ > 0", "V = 0,  θ = 0", "V < 0,  θ < 0"]
    slopes = []
    for axes in SCRIPT.draw_anchor().axes:
        line = next(each for each in axes.lines if len(each.get_xdata()) > 100)
        slopes.append(line.get_ydata()[1] - line.get_ydata()[0])
    assert slopes[0] > 0.0
    assert slopes[1] == 0.0
    assert slopes[2] < 0.0
