"""Which length has a tension, a horizontal force or a sag over a known span.

The wire of a pipelay barge and the conductor were checked by MoorPy and by brentq over a catenary
of their own; sags by the parabola.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

import catopt
from catopt import InputError, Line, Segment, find_length
from catopt.casefile import parse_case
from catopt.constants import STANDARD_GRAVITY
from catopt.errors import NoAnswerError

WIRE = Line([Segment(610.0, 88.0, EA=110e6)])
CONDUCTOR = Line([Segment(301.0, STANDARD_GRAVITY, EA=22.4e6)])


def test_the_wire_that_is_out_at_a_tension() -> None:
    """603.558 m and H = 194.729 kN by MoorPy."""
    found = find_length(WIRE, height=60.0, span=600.0, fairlead_tension=200e3)
    assert found.value == pytest.approx(603.558, abs=5e-4)
    assert found.solution.horizontal_force == pytest.approx(194.729e3, abs=0.5)
    assert found.solution.fairlead.tension == pytest.approx(200e3, rel=1e-9)
    same = find_length(WIRE, height=60.0, span=600.0, horizontal_force=194.729e3)
    assert same.value == pytest.approx(603.558, abs=5e-4)


def test_a_conductor_is_strung_to_a_tension() -> None:
    """304.104 m at 541.9 kgf, which sags by w L^2/(8 H) to the order of (sag/span)^2."""
    found = find_length(
        CONDUCTOR,
        height=80.0,
        anchor_height=80.0,
        span=300.0,
        fairlead_tension=541.9 * STANDARD_GRAVITY,
    )
    assert found.value == pytest.approx(304.104, abs=5e-4)
    line = found.solution
    sag = STANDARD_GRAVITY * 300.0**2 / (8.0 * line.horizontal_force)
    assert line.sag == pytest.approx(sag, rel=2.0 * (sag / 300.0) ** 2)
    back = find_length(CONDUCTOR, height=80.0, anchor_height=80.0, span=300.0, sag=line.sag)
    assert back.value == pytest.approx(found.value, rel=1e-8)


@pytest.mark.parametrize("wanted", [20e3, 200e3, 2e6, 2e7])
def test_what_is_found_has_what_was_wanted(wanted: float) -> None:
    found = find_length(WIRE, height=60.0, span=600.0, horizontal_force=wanted)
    long = Line([replace(WIRE.segments[0], length=found.value)])
    solved = catopt.solve(long, height=60.0, span=600.0)
    assert solved.horizontal_force == pytest.approx(wanted, rel=1e-8)


def test_less_than_what_hangs_is_no_tension() -> None:
    """The wire that hangs plumb over 60 m pulls with 88 N/m x 60 m = 5.28 kN."""
    with pytest.raises(catopt.CatoptError, match=r"5\.280 kN"):
        find_length(WIRE, height=60.0, span=600.0, fairlead_tension=1e3)


CABLE = """
[line]
fairlead_height = "5 m"
[[line.segments]]
length = "23 m"
submerged_weight = "100 N/m"
EA = "5 MN"
[load]
span = "20 m"
[find]
quantity = "length"
"""


def test_a_case_in_air_is_strung_too() -> None:
    case = parse_case(CABLE + 'fairlead_tension = "3 kN"\n')
    found = catopt.solve_case(case)
    assert found.fairlead.tension == pytest.approx(3e3, rel=1e-9)
    assert found.found is not None
    assert found.found.value < 23.0
    assert found.anchor_height == pytest.approx(0.0, abs=1e-9)


def test_conditions_go_with_a_span_alone() -> None:
    with pytest.raises(InputError, match="exactly one"):
        find_length(WIRE, height=60.0, span=600.0, fairlead_tension=2e5, sag=1.0)
    with pytest.raises(InputError, match="a force above 0 N"):
        find_length(WIRE, height=60.0, span=600.0, fairlead_tension=-2e5)
    with pytest.raises(InputError, match=r"find\.fairlead_tension.*applies with span"):
        parse_case(
            CABLE.replace('span = "20 m"', 'horizontal_force = "2 kN"')
            + 'fairlead_tension = "3 kN"\n'
        )


@pytest.mark.parametrize(("anchor_height", "highest"), [(0.0, 25.0), (40.0, 40.0)])
def test_a_sag_beyond_the_bed_is_refused_as_that(anchor_height: float, highest: float) -> None:
    """A line lies nowhere below the bed, so that it sags by no more than its higher end is high."""
    chain = Line([Segment(110.0, 400.0, EA=2e8)])
    given: dict[str, Any] = {"height": 25.0, "horizontal_force": 150e3}
    given["anchor_height"] = anchor_height
    with pytest.raises(NoAnswerError, match=rf"higher end is {highest:.3f} m above it.*the most"):
        find_length(chain, sag=60.0, **given)
    near = find_length(chain, sag=0.98 * highest, **given)
    assert near.solution.sag == pytest.approx(0.98 * highest, rel=1e-9)
