"""A line pulled by next to nothing hangs straight down; no force is too small to be solved."""

from __future__ import annotations

import pytest

from catopt import Line, PointLoad, Segment, solve

LINE = Line([Segment(1054.5169472807493, 1640.5), Segment(703.0112981871662, 449.47)])
CLUMP = PointLoad(966.4201668544445, 151492.0)
HEIGHT = 296.589234338383


@pytest.mark.parametrize("force", [10.0**k for k in range(-12, 3)])
@pytest.mark.parametrize("loads", [[], [CLUMP]], ids=["plain", "clump weight"])
def test_what_hangs_is_as_long_as_the_height(force: float, loads: list[PointLoad]) -> None:
    """From the bed up, h = (T - H)/w of a uniform piece; the upper segment alone hangs here."""
    solution = solve(Line(LINE.segments, loads), height=HEIGHT, horizontal_force=force)
    hung = solution.line.length - solution.grounded_length
    # L^2 = h (h + 2 H / w): so much longer than the height
    assert hung == pytest.approx((HEIGHT * (HEIGHT + 2.0 * force / 449.47)) ** 0.5, rel=1e-9)
