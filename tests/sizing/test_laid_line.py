"""The line that is laid for a ship among runs that are made up: hers or near it, by rule."""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import catopt.sizing.ship_search as searching
from catopt.model import Line
from catopt.sizing.input_values import input_values
from catopt.sizing.line_choice import sold
from catopt.sizing.requests import request_of

SHIP: dict[str, Any] = {"dwt": "50000 t", "depth": "20 m"}


def laid(holds: Callable[[float, float], bool]) -> tuple[float, float] | None:
    """Find the line that is laid among runs that are made up: size, mm, and length, m."""
    request = request_of(input_values("tanker", SHIP))
    found: Any = object.__new__(searching._Search)
    found.request = request
    found.lengths = [13.75 * k for k in range(5, 40)]
    found._sizes = sold(request.line, 1025.0)

    def tried(line: Line) -> Any:
        (segment,) = line.segments
        passes = holds(1e3 * (segment.nominal_diameter or 0.0), line.length)
        return SimpleNamespace(tried=SimpleNamespace(passes=passes), line=line)

    found.tried = tried
    line = Line((replace(found._sizes[0], length=200.0),))
    best = searching._Search.laid(found, line)
    if best is None:
        return None
    (segment,) = best.line.segments
    return round(1e3 * (segment.nominal_diameter or 0.0), 6), best.line.length


def needs(weather: float) -> Callable[[float, float], bool]:
    """Make runs of which a line passes whose square by the root of its length is enough."""
    return lambda size, length: size**2 * math.sqrt(length) >= weather


def test_a_line_that_is_laid_is_hers_or_near_it_and_no_shorter_than_the_rule() -> None:
    """Hers is 73 mm; six depths of 20 m are 120 m, in half shots 123.75 m, sixteen 316.25 m."""
    assert laid(lambda size, length: size > 0.0 and length >= 310.0) == (73.0, 316.25)
    assert laid(lambda size, length: size > 0.0 and length >= 320.0) == (73.0, 330.0)
    assert laid(lambda size, length: size > 0.0 and length >= 500.0) is None
    assert laid(lambda *_: True) == (73.0, 123.75)
    assert laid(lambda size, length: size > 0.0 and length >= 200.0) == (73.0, 206.25)
    assert laid(lambda size, length: size >= 80.0 and length >= 150.0) == (81.0, 151.25)
    assert laid(lambda *_: False) is None


def test_a_little_more_weather_takes_a_little_more_line() -> None:
    """200 pairs 1 % apart: no less line in more weather, and never two sizes more.

    As far as the thickest, 120 mm, at twenty-four depths: there hers at those once followed it.
    """
    sizes = sorted({laid(needs(each * 1e3))[0] for each in range(40, 310, 2)})  # type: ignore[index]
    generator = random.Random(4)
    for _ in range(200):
        weather = generator.uniform(50e3, 305e3)
        first, then = laid(needs(weather)), laid(needs(1.01 * weather))
        assert first is not None
        assert then is not None
        assert then >= first or (then[0] == first[0] and then[1] >= first[1])
        assert sizes.index(then[0]) - sizes.index(first[0]) <= 1
