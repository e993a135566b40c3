"""A point load as near to an end of its line as the length of the line can tell."""

from __future__ import annotations

import math

import pytest

from catopt.catenary.solve import solve
from catopt.errors import InputError
from catopt.model import Line, PointLoad, Segment

LENGTHS = ([20.0], [7.0, 13.0], [0.1, 0.2], [1.0 / 3.0, 2.0 / 3.0, 0.1], [100.1, 200.3, 0.7])


def line(lengths: list[float], position: float, weight: float) -> Line:
    segments = [Segment(each, 90.0, EA=8e7) for each in lengths]
    return Line(segments, [PointLoad(position, weight)])


@pytest.mark.parametrize("lengths", LENGTHS)
@pytest.mark.parametrize("weight", [500.0, -20.0, 0.0])
@pytest.mark.parametrize("part", [1e-13, 1e-9, 1e-3])
def test_nearly_at_an_end_it_hangs_there(lengths: list[float], weight: float, part: float) -> None:
    """Of so short a piece nothing is seen but the load at the end; 1e-9: half the line's part."""
    total = math.fsum(lengths)
    for position in (total * part, total * (1.0 - part)):
        found = solve(line(lengths, position, weight), height=0.4 * total, span=0.8 * total)
        assert abs(found.residual.height) < 1e-9 * total
        (state,) = found.point_loads
        end = (0.0, 0.0) if position < 0.5 * total else (0.8 * total, 0.4 * total)
        assert math.dist((state.x, state.z), end) < 2.0 * part * total + 1e-9 * total


@pytest.mark.parametrize("lengths", LENGTHS)
def test_nearer_than_the_rounding_of_the_length_it_is_refused(lengths: list[float]) -> None:
    total = math.fsum(lengths)
    for position in (5e-324, 1e-16 * total, math.nextafter(total, 0.0), total, 2.0 * total):
        with pytest.raises(InputError, match=r"point_loads\[0\].position: .* farther from them"):
            line(lengths, position, 500.0)
