"""What a recommended line is worth: under motion, once worn, within its scope, among all others."""

from __future__ import annotations

import dataclasses
import itertools
import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import pytest

import catopt
from catopt.catalogue.choice import chosen
from catopt.checks.case import check_case
from catopt.constants import YEAR
from catopt.errors import NoAnswerError
from catopt.loads import SeaState, WaterLevels
from catopt.model import Anchor, Case, Service
from catopt.sizing import (
    BuoyRequest,
    Environment,
    GivenBuoy,
    LineChoice,
    Sizing,
    TankerRequest,
)
from catopt.sizing.converge import ConvergedSizing
from catopt.sizing.kinds import usual
from tests.sizing.alone import alone
from tests.sizing.at_rest import size_buoy, size_tanker
from tests.sizing.test_consistency import LOADED, deep

LOSS = 2e-3
"""m: five years of 0.4 mm, which are taken where nothing is said."""
FACTORS = (1.0, 1.5, 2.7)


def every_settled(of: Sizing) -> list[ConvergedSizing]:
    """List the recommended line and those beside it."""
    beside = [
        *(each.settled for each in of.candidates),
        *(each.settled for each in of.alternatives),
    ]
    return [of.settled, *(each for each in beside if each is not None)]


def diameter(of: Sizing) -> float:
    return of.point.line.segments[0].nominal_diameter or 0.0


# ------------------------------------------------------------------ the allowance for motion


@pytest.fixture(scope="module", params=["buoy", "tanker"])
def by_factor(request: pytest.FixtureRequest) -> list[Sizing]:
    if request.param == "buoy":
        return [size_buoy("pillar 1.8 m", depth="12 m", dynamic_factor=f) for f in FACTORS]
    return [size_tanker(dwt="50000 t", depth="20 m", dynamic_factor=f) for f in FACTORS]


def strengths(of: Sizing) -> tuple[float, float, float]:
    anchor = of.point.anchor
    assert anchor is not None
    return diameter(of), of.point.line.length, anchor.mass or 0.0


def test_a_larger_allowance_gives_a_line_that_holds_more(by_factor: list[Sizing]) -> None:
    for weaker, stronger in itertools.pairwise(by_factor):
        assert any(b > a for a, b in zip(strengths(weaker), strengths(stronger), strict=True))
        # Neither the weaker line nor its anchor is enough for the forces of the larger allowance.
        own = weaker.point
        assert not check_case(
            dataclasses.replace(stronger.case, line=own.line, anchor=own.anchor)
        ).passes


def test_the_allowance_is_on_the_loads_whole(by_factor: list[Sizing]) -> None:
    """Each load case has its loads times the factor, on the new line and on the worn one."""
    for factor, of in zip(FACTORS, by_factor, strict=True):
        loads = {each.load_case: each.horizontal_force for each in of.settled.posed.loads}
        for state in of.case.load_cases:
            if state.kind == "extreme":
                name = state.name.removesuffix(", worn chain")
                wanted = factor * loads[name]
                assert state.horizontal_force == pytest.approx(wanted, rel=1e-12)


def test_no_check_fails_beside_a_recommendation(by_factor: list[Sizing]) -> None:
    for of in by_factor:
        for each in every_settled(of):
            assert each.point.checks.results
            assert not each.point.checks.failed
            assert check_case(each.case).passes


# ------------------------------------------------------------------ the worn line


@pytest.fixture(scope="module")
def worn_buoy() -> Sizing:
    with alone():
        return size_buoy("pillar 2.4 m", depth="12 m", low_water="10 m")


@pytest.fixture(scope="module")
def worn_ship() -> Sizing:
    with alone():
        return size_tanker(dwt="50000 t", depth="20 m", low_water="18 m")


def grounded(of: Sizing, weight: float) -> list[float]:
    """Length on the bed in each storm, m, of a line of a weight: s = sqrt(h (h + 2 H/w)) hang."""
    found = []
    for each in of.case.load_cases:
        if each.kind == "extreme":
            h = of.case.fairlead_height + each.water_level + each.fairlead_rise
            hangs = math.sqrt(h * (h + 2.0 * each.horizontal_force / weight))
            found.append(of.point.line.length - hangs)
    return found


@pytest.mark.parametrize(("name", "wanted"), [("worn_buoy", 0.0), ("worn_ship", 27.4)])
def test_the_worn_line_lies_on_the_bed_as_long_as_its_code_wants(
    name: str, wanted: float, request: pytest.FixtureRequest
) -> None:
    """A step shorter would do for the new line, and not for the worn one.

    By hand, of a line that does not stretch: the ship's, of steel, by 0.2 % under its pull.
    """
    of: Sizing = request.getfixturevalue(name)
    segment, d = of.point.line.segments[0], diameter(of)
    weight = segment.submerged_weight * ((d - LOSS) / d) ** 2
    stretch = 2e-3 * of.point.line.length if name == "worn_ship" else 0.0
    least = min(grounded(of, weight))
    told = [s.grounded_length for n, s in of.point.checks.solutions if n.endswith("worn chain")]
    assert min(told) == pytest.approx(least, abs=stretch + 1e-6)
    assert least >= wanted - stretch
    assert {solution.anchor.angle for _, solution in of.point.checks.solutions} == {0.0}
    assert of.case.design is not None
    first, second, *_ = of.case.design.segments[0].lengths
    assert least - (second - first) < wanted


def test_a_line_that_does_for_the_new_chain_alone_is_not_taken(worn_buoy: Sizing) -> None:
    """A step shorter: it is tangent at the sinker when new, and lifted in five years."""
    segment = worn_buoy.point.line.segments[0]
    shorter = catopt.Line([dataclasses.replace(segment, length=segment.length - 0.5)])
    report = check_case(dataclasses.replace(worn_buoy.case, line=shorter))
    assert min(grounded(worn_buoy, segment.submerged_weight)) > 0.5
    failed = {each.load_case: each.kind for each in report.failed}
    assert set(failed.values()) == {"uplift_angle"}
    assert all(name.endswith("worn chain") for name in failed)


# ------------------------------------------------------------------ the life of the chain


def first_failure(of: Sizing, step: float) -> float:
    """Return the first service life, in steps, at which the worn line fails a check, s."""
    states = tuple(each for each in of.case.load_cases if each.condition == "worn")
    rate = 0.4e-3 / YEAR
    for k in itertools.count(1):
        worn = dataclasses.replace(
            of.case, load_cases=states, service=Service(k * step, rate), design=None
        )
        try:
            if not check_case(worn).passes:
                return k * step
        except NoAnswerError:
            return k * step
    raise AssertionError


@pytest.mark.parametrize("name", ["worn_buoy", "worn_ship"])
def test_the_chain_is_changed_before_the_first_check_is_overrun(
    name: str, request: pytest.FixtureRequest
) -> None:
    of: Sizing = request.getfixturevalue(name)
    step = 0.05 * YEAR
    assert of.chain_life is not None
    failed = first_failure(of, step)
    assert failed - step <= of.chain_life <= failed
    assert of.chain_life >= 5.0 * YEAR  # what it was sized for
    assert failed < 0.2 * diameter(of) / (0.4e-3 / YEAR)  # before a fifth of it is gone
    assert any("thinner it is not known to pass" in each for each in of.advice)


def test_a_chain_that_no_check_stops_is_changed_when_a_fifth_of_it_is_gone() -> None:
    """NAVFAC MO-124 discards it at 80 % of its size: of 50 mm 10 mm wear off in 25 years."""
    line = LineChoice(usual("chain"), usual("code"), diameters=(0.05,), scope=(4.0, 4.0))
    still = Environment(WaterLevels.steady(12.0))
    with alone():
        of = size_buoy(BuoyRequest(GivenBuoy(2e3, 60e3), still, line))
    assert of.chain_life == pytest.approx(25.0 * YEAR, rel=1e-9)
    assert first_failure(of, YEAR) > 25.0 * YEAR
    assert any("40.0 mm, 80 % of its size" in each for each in of.advice)


def test_a_line_that_stays_new_has_no_life() -> None:
    line = LineChoice(usual("chain"), usual("code"), diameters=(0.05,), life=0.0)
    still = Environment(WaterLevels.steady(12.0))
    with alone():
        of = size_buoy(BuoyRequest(GivenBuoy(2e3, 60e3), still, line))
    assert of.chain_life is None
    assert {each.condition for each in of.case.load_cases} == {None}


# ------------------------------------------------------------------ what a buoy is laid on


def test_a_buoy_lies_on_chain_that_she_is_made_for(worn_buoy: Sizing) -> None:
    """A pillar of 2.4 m has 20 to 50 mm; two to three depths are laid, 2.5 where it can be."""
    (segment,) = worn_buoy.case.design.segments  # type: ignore[union-attr]
    assert (segment.diameter_min, segment.diameter_max) == (0.02, 0.05)
    assert 0.02 <= diameter(worn_buoy) <= 0.05
    assert (segment.lengths[0], segment.lengths[-1]) == (24.0, 36.0)


def test_sizes_of_one_s_own_are_taken_in_their_place() -> None:
    """Those of the buoy end at 30 mm."""
    with alone():
        own = size_buoy("pillar 1.8 m", depth="12 m", diameter_min="32 mm", scope_max=4)
    assert diameter(own) >= 0.032
    assert not any("depths" in each for each in own.defaults)


def test_a_line_beyond_its_scope_is_one_where_none_within_it_passes() -> None:
    """Of 20 mm alone: it hangs over s = sqrt(h (h + 2 H/w)), more than 36 m, once worn."""
    with alone():
        of = size_buoy("pillar 1.8 m", depth="12 m", diameter_max="20 mm")
    assert of.point.line.length > 36.0
    assert "no line within 3 depths passes: longer ones were considered" in of.defaults
    w = of.point.line.segments[0].submerged_weight * (18.0 / 20.0) ** 2
    length = of.point.line.length
    assert length - min(grounded(of, w)) > 36.0
    assert 0.0 <= min(grounded(of, w)) < 0.5  # the next step is too short: it is the shortest
    for shorter in (24.0, 36.0):
        line = catopt.Line([dataclasses.replace(of.point.line.segments[0], length=shorter)])
        assert not check_case(dataclasses.replace(of.case, line=line)).passes


def test_nothing_is_said_of_a_scope_that_is_kept(worn_buoy: Sizing) -> None:
    assert worn_buoy.point.line.length <= 36.0
    assert not any("depths" in each for each in worn_buoy.defaults)


# ------------------------------------------------------------------ preferences, of all designs


class Tried(NamedTuple):
    """A line that passes every check."""

    mass: float  # kg
    length: float  # m
    span: float  # the largest, m
    diameter: float  # m


def every_line(case: Case) -> list[Tried]:
    """Check every line of a case by itself, on an anchor that holds whatever pulls."""
    assert case.design is not None
    (choice,), sinker = case.design.segments, case.design.sinker
    anchor = case.anchor
    if sinker is not None:
        anchor = Anchor("sinker", 1e9, sinker.friction, safety_factor=sinker.safety_factor)
    passing = []
    for component, d in itertools.product(choice.components, choice.diameters):
        metre = chosen(case.catalogue, 1025.0).component(component, d).segment(1.0)
        for length in choice.lengths:
            line = catopt.Line([dataclasses.replace(metre, length=length)])
            tried = dataclasses.replace(case, line=line, anchor=anchor, design=None)
            try:
                report = check_case(tried)
            except NoAnswerError:
                continue
            if report.passes:
                span = max(solution.span for _, solution in report.solutions)
                passing.append(Tried(length * (metre.mass or 0.0), length, span, d))
    return passing


def recommended(of: Sizing) -> tuple[float, float]:
    return diameter(of), of.point.line.length


def is_best(of: Sizing, lines: Sequence[Tried], *key: float) -> bool:
    """Whether the recommended line is the first of some by a key of each."""
    best = min(zip(key, lines, strict=True), key=lambda each: each[0])[1]
    return recommended(of) == pytest.approx((best.diameter, best.length), rel=1e-12)


SEA = Environment(WaterLevels(10.0, 12.0), sea=SeaState(6.0, 1.2))
"""The crest is 1.11 m: it is 13.11 m deep under it."""


def buoy_by(prefer: str, scope: float = 2.5) -> Sizing:
    sizes = (0.026, 0.03, 0.036, 0.042, 0.05)
    choice: Any = {"diameters": sizes, "length_step": 1.0, "prefer": prefer}
    line = LineChoice(usual("chain"), usual("code"), **choice)
    with alone():
        return size_buoy(BuoyRequest(GivenBuoy(9e3, 60e3, 1.2), SEA, line, scope=scope))


@pytest.fixture(scope="module")
def buoy_s_lines() -> list[Tried]:
    return every_line(buoy_by("lightest").case)


def test_a_buoy_s_lines_differ_in_length_and_mass(buoy_s_lines: list[Tried]) -> None:
    """So that the preferences below are told apart."""
    lightest, shortest = min(buoy_s_lines), min(buoy_s_lines, key=lambda each: each.length)
    assert lightest.length > 2.5 * 13.11 > shortest.length
    assert shortest.mass > lightest.mass


@pytest.mark.parametrize("scope", [2.5, 3.0, 4.0])
def test_practice_is_the_lightest_line_within_the_length_that_is_laid(
    scope: float, buoy_s_lines: list[Tried]
) -> None:
    short = [each for each in buoy_s_lines if each.length <= scope * 13.11]
    assert short
    assert is_best(buoy_by("practice", scope), short, *(each.mass for each in short))


def test_where_none_is_as_short_practice_is_the_shortest(buoy_s_lines: list[Tried]) -> None:
    of = buoy_by("practice", 1.5)
    assert not [each for each in buoy_s_lines if each.length <= 1.5 * 13.11]
    assert recommended(of) == recommended(buoy_by("shortest"))


def test_the_shortest_line_is_the_lightest_of_those(buoy_s_lines: list[Tried]) -> None:
    least = min(each.length for each in buoy_s_lines)
    short = [each for each in buoy_s_lines if each.length == least]
    assert is_best(buoy_by("shortest"), short, *(each.mass for each in short))


def test_the_lightest_line_is_so_of_all(buoy_s_lines: list[Tried]) -> None:
    assert is_best(buoy_by("lightest"), buoy_s_lines, *(each.mass for each in buoy_s_lines))


def ship_by(prefer: str, *sizes: float) -> Sizing:
    choice: Any = {"diameters": sizes or SIZES, "length_step": 27.5, "prefer": prefer}
    line = LineChoice(usual("chain", "tanker"), "UFC-4-159-03", **choice)
    with alone():
        return size_tanker(TankerRequest((LOADED,), deep(), line=line))


SIZES = (0.04, 0.05, 0.06, 0.07, 0.08)
THIN = (0.036, 0.04)


@pytest.fixture(scope="module")
def ship_s_lines() -> list[Tried]:
    return every_line(ship_by("lightest").case)


def test_a_balanced_line_is_the_lightest_that_spans_no_more_than_the_ship(
    ship_s_lines: list[Tried],
) -> None:
    """She is 234 m long, more than six depths of 22 m."""
    near = [each for each in ship_s_lines if each.span <= 234.0]
    assert 0 < len(near) < len(ship_s_lines)
    assert is_best(ship_by("balanced"), near, *(each.mass for each in near))


def test_where_none_spans_as_little_the_swept_area_counts_with_the_mass() -> None:
    thin = every_line(ship_by("lightest", *THIN).case)
    assert thin
    assert min(each.span for each in thin) > 234.0
    swept = [each.mass * (each.span + 234.0) ** 2 for each in thin]
    assert is_best(ship_by("balanced", *THIN), thin, *swept)


def test_the_least_swing_and_the_least_price_are_so_of_all(ship_s_lines: list[Tried]) -> None:
    """USD/m of R3, d in m: -234 d + 5.95e4 d^2 (engineering facts, section on cost)."""
    spans = [each.span for each in ship_s_lines]
    assert is_best(ship_by("least-swing"), ship_s_lines, *spans)
    prices = [
        (-234.0 * each.diameter + 5.95e4 * each.diameter**2) * each.length for each in ship_s_lines
    ]
    assert is_best(ship_by("cheapest"), ship_s_lines, *prices)
