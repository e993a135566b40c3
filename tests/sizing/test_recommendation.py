"""Which line is recommended: by price and swing, within the place, of every size that is sold."""

from __future__ import annotations

import math
from typing import Any

import pytest

import catopt
from catopt.catalogue.choice import chosen
from catopt.design.neighbours import NoFeasibleDesignError
from catopt.errors import InputError
from catopt.model import CatalogueChoice
from catopt.sizing import LineChoice
from catopt.sizing.line_choice import longest_useful
from catopt.sizing.result import Sizing
from catopt.words import say
from tests.sizing.at_rest import size_buoy, size_tanker

SHIP: dict[str, Any] = {"dwt": "50000 t", "depth": "20 m"}
SHOWN = ("loaded", "ballast")
BOTH = ["chain studless R3", "chain studless R4"]
PRICES = {"R3": (-234.0, 5.95e4), "R4": (-312.0, 8.56e4)}
"""USD/m of d in m (engineering facts, section on cost): a d + b d^2."""


def sized(**inputs: Any) -> Sizing:
    return size_tanker(**SHIP, **inputs)


def price_by_hand(of: Sizing) -> float:
    segment = of.point.line.segments[0]
    d = segment.nominal_diameter or 0.0
    a, b = PRICES[(segment.component or "").rpartition(" ")[2]]
    return (a * d + b * d * d) * segment.length


@pytest.fixture(scope="module")
def by_price() -> Sizing:
    return sized(chain=BOTH, prefer="cheapest")


def test_the_cheapest_line_is_not_the_lightest(by_price: Sizing) -> None:
    """A metre of R4 costs some 1.4 times one of R3 and breaks at 1.23 times: R3 is cheaper."""
    assert by_price.cost == pytest.approx(price_by_hand(by_price), rel=1e-9)
    lightest = sized(chain=BOTH, prefer="lightest")
    assert lightest.point.line.segments[0].component == "chain studless R4"
    assert by_price.point.line.segments[0].component == "chain studless R3"
    assert price_by_hand(by_price) < price_by_hand(lightest)
    assert (by_price.point.line.mass or 0.0) > (lightest.point.line.mass or 0.0)


def test_the_answer_says_by_which_prices_and_of_what(by_price: Sizing) -> None:
    dollars = f"{price_by_hand(by_price):.0f} USD"
    assert by_price.why.startswith(f"It is the cheapest line that passes: {dollars} of material")
    assert "OMAE2025" in by_price.why
    assert "[C]" in by_price.why
    assert "anchor, fittings and installation are not priced here" in by_price.why
    assert say(by_price.why, "vi").startswith(f"Đây là dây rẻ nhất đạt yêu cầu: {dollars}")
    document = by_price.to_dict()
    assert document["chain"]["cost_USD"] == by_price.cost
    assert [each["prefer"] for each in document["alternatives"]] == [
        "balanced", "lightest", "least-swing",
    ]  # fmt: skip


@pytest.mark.parametrize(
    "unpriced", [{"chain": ["chain studless R3", "chain studless R3S"]}, {"clump_weight": "5 t"}]
)
def test_without_every_price_none_is_the_cheapest(unpriced: dict[str, object]) -> None:
    sizing = sized(**unpriced, prefer="lightest")
    assert sizing.why == "It is the lightest line that passes."
    assert [each.prefer for each in sizing.alternatives] == ["balanced", "least-swing"]
    assert "clump_weight" in unpriced or sizing.cost is None


def test_a_price_of_swing_is_weighed_against_that_of_the_line() -> None:
    """500 USD/m: of every line of the front, price and 500 times the span are the least."""
    sizing = sized(swing_price=500)
    totals = [
        point.objectives["cost_USD"] + 500.0 * point.objectives["offset_m"]
        for point in sizing.settled.result.front
    ]
    assert sizing.settled.index == totals.index(min(totals)) > 0
    assert "at 500 USD per metre of swing radius" in sizing.why
    free = sized(prefer="cheapest")
    assert free.settled.index == 0
    assert free.swing.total > sizing.swing.total


def test_a_bound_on_the_swing_is_a_check_of_every_design() -> None:
    """The ship is 210 m long: of 400 m the line may span 190 m."""
    sizing = sized(max_swing="400 m")
    spans = [each for each in sizing.point.checks.results if each.kind == "span"]
    storms = {f"{how}, high water{worn}" for how in SHOWN for worn in ("", ", worn chain")}
    assert {each.load_case for each in spans} == {*storms, "everyday"}
    assert {each.capacity for each in spans} == {190.0}
    assert sizing.swing.total <= 400.0 < sized().swing.total
    for point in sizing.settled.result.front:
        assert point.objectives["offset_m"] <= 190.0 * (1.0 + 1e-9)
    assert all(each.swing <= 400.0 for each in sizing.alternatives if each.swing is not None)


def test_a_hawser_takes_its_part_of_the_swing() -> None:
    at_buoy = sized(max_swing="600 m", buoy="mooring buoy 5.0 m", hawser="60 m")
    capacity = next(each.capacity for each in at_buoy.point.checks.results if each.kind == "span")
    assert capacity == pytest.approx(600.0 - 210.0 - 60.0, abs=1e-9)
    assert at_buoy.swing.total <= 600.0


def test_a_buoy_s_swing_is_bounded_too() -> None:
    """Of the sizes that the buoy is made for, up to 30 mm, none spans as little."""
    place: dict[str, Any] = {"buoy": "pillar 1.8 m", "depth": "12 m", "wind": "25 m/s"}
    place |= {"prefer": "lightest", "diameter_max": "60 mm"}
    free = size_buoy(**place)
    bound = size_buoy(**place, max_swing="30 m")
    assert bound.swing.total <= 30.0 < free.swing.total
    assert (bound.point.line.mass or 0.0) > (free.point.line.mass or 0.0)


def test_where_no_line_keeps_the_bound_the_key_and_ways_out_are_told() -> None:
    with pytest.raises(NoFeasibleDesignError) as caught:
        sized(max_swing="300 m")
    assert "span in load case" in str(caught.value)
    assert "allowable 90 m" in str(caught.value)
    assert "What may help: " in str(caught.value)
    assert "more room to swing (max_swing), a clump weight" in str(caught.value)
    assert "a larger size (diameter_max)" in str(caught.value)  # beyond 120 mm some are sold
    assert "vùng quay rộng hơn (max_swing)" in say(caught.value.message, "vi")


@pytest.mark.parametrize(
    ("inputs", "told"),
    [
        (
            {"max_swing": "210 m"},
            {
                "max_swing": "ship and hawser alone are 210 m long: "
                "more is required, or several lines"
            },
        ),
        (
            {"max_swing": "400 m", "swing_price": 10, "lines": 6},
            dict.fromkeys(
                ("max_swing", "swing_price"),
                "leave it out: it applies to one line, and several hold the ship in position",
            ),
        ),
        (
            {"prefer": "least-swing", "lines": 6},
            {
                "prefer": "leave it out: it applies to one line, and several hold the ship "
                "in position"
            },
        ),
        (
            {"swing_price": 10, "prefer": "balanced"},
            {
                "swing_price": 'leave it out: only prefer = "cheapest" uses it, and needs known '
                "prices"
            },
        ),
        (
            {"swing_price": 10, "prefer": "cheapest", "chain": "chain studless R3S"},
            {
                "prefer": "the price of chain studless R3S is not known: use lightest",
                "swing_price": "the price of chain studless R3S is not known: leave it out",
            },
        ),
        (
            {"prefer": "cheapest", "clump_weight": "5 t"},
            {"prefer": "the price of clump weights is not known: use lightest"},
        ),
    ],
)
def test_what_cannot_be_weighed_or_kept_is_refused(
    inputs: dict[str, object], told: dict[str, str]
) -> None:
    with pytest.raises(InputError) as caught:
        sized(**inputs)
    assert {each.key: each.allowed for each in caught.value.problems} == told


def test_of_several_lines_none_is_looked_for_by_its_own_swing() -> None:
    """What six lines let a ship swing is no sum of what each spans."""
    assert [each.prefer for each in sized(lines=6).alternatives] == ["balanced"]


@pytest.mark.parametrize("ship", [SHIP, {"dwt": "3000 t", "depth": "7 m"}])
def test_the_lightest_line_is_at_no_edge_of_what_is_looked_at(ship: dict[str, Any]) -> None:
    sizing = size_tanker(**ship, prefer="lightest")
    assert sizing.case.design is not None
    lengths = sizing.case.design.segments[0].lengths
    sizes = [
        each.nominal_diameter
        for each in chosen(CatalogueChoice(), 1025.0).sold("chain studless R3")
    ]
    segment = sizing.point.line.segments[0]
    assert lengths[0] < segment.length < lengths[-1]
    assert min(sizes) < (segment.nominal_diameter or 0.0) < 0.12
    smaller = sizing.candidates[0]
    assert smaller.role == "smaller"
    assert smaller.settled is None


def test_no_line_is_wanted_longer_than_what_hangs_at_its_breaking_load() -> None:
    """At T = MBL the line leaves the bed with H = MBL - w h, and s^2 = h^2 + 2 h H/w."""
    choice = LineChoice(("chain studless R3",), "break/5", diameters=(), diameter_min=0.0359)
    metre = chosen(CatalogueChoice(), 1025.0).component("chain studless R3", 0.036).segment(1.0)
    assert metre.MBL is not None
    h, w = 24.0, metre.submerged_weight
    hangs = math.sqrt(h * h + 2.0 * h * (metre.MBL - w * h) / w)
    line = catopt.Line([catopt.Segment(length=1000.0, submerged_weight=w, MBL=metre.MBL)])
    solved = catopt.solve(line, height=h, fairlead_tension=metre.MBL)
    assert solved.suspended_length == pytest.approx(hangs, rel=1e-9)
    # The smallest of these sizes is the strongest for its weight: 44 - 0.08 d falls with d.
    assert longest_useful(choice, 1025.0, h) == pytest.approx(hangs + 30.0, rel=1e-9)
