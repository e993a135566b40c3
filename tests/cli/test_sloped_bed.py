"""The drawing of a line in motion on a bed that slopes."""

from __future__ import annotations

import math

import pytest

from catopt.casefile import read_case
from catopt.figures.motion import on_slope
from catopt.verify.dynamic import verify_dynamic

from .conftest import OWN


def test_the_drawing_has_the_slope_and_the_line_on_it() -> None:
    case = read_case(OWN / "sloped.toml")
    (part,) = verify_dynamic(case, convergence_check="none").parts
    chart = on_slope(part, 60.0, case.site.seabed_slope)
    bed, line = chart.series
    rise = math.tan(math.radians(5.0))
    assert [z / x for x, z in zip(bed.x, bed.y, strict=True)] == pytest.approx([rise, rise])
    above = [z - rise * x for x, z in zip(line.x, line.y, strict=True)]
    # Own weight presses the bed 1 cm deep; half of the line lies.
    assert min(above) > -0.02
    assert sum(each < 0.02 for each in above) > 20
    assert chart.to_scale == 1.0
