"""Pretensions measured in a basin, at full scale: OC5 DeepCwind's three lines.

Robertson and others, Definition of the OC5 DeepCwind Semisubmersible Floating System (v1.5), Table
3-13; MARIN 2013. What is said of each line differs by some tenths of a per cent.
"""

from __future__ import annotations

import math

import pytest

from catopt import Line, Segment, solve

MEASURED = (1.107e6, 1.148e6)
"""N: the least and the largest of three lines."""
LINES = ((125.4, 7.46e8, 0.137), (125.8, 7.52e8, 0.140))
"""Mass, kg/m, EA, N, and volume-equivalent diameter, m: the ends of what is said."""


def pretensions() -> list[float]:
    """Compute the tension at the fairlead of each: 835.5 m, ends at radii of 837.6 and 40.868 m.

    The fairlead is 14 m deep in 200 m of water.
    """
    found = []
    for mass, EA, diameter in LINES:
        weight = (mass - 1025.0 * 0.25 * math.pi * diameter**2) * 9.80665
        line = Line([Segment(835.5, weight, EA=EA)])
        found.append(solve(line, height=186.0, span=837.6 - 40.868).fairlead.tension)
    return found


@pytest.mark.parametrize("tension", pretensions())
def test_the_pretension_of_oc5_is_within_what_was_measured(tension: float) -> None:
    assert MEASURED[0] < tension < MEASURED[1]
