"""Lines that were refused wrongly, answered wrongly or answered by half, each by its name.

Every answer is checked by the campaign's oracle, which shares nothing with the kernel: the line is
followed from both ends with the answer's own forces (tests/campaign/walks.py).
"""

from __future__ import annotations

import math
import re
from dataclasses import replace
from functools import partial
from typing import Any

import pytest

from catopt import solve
from catopt.catenary.solution import Solution
from catopt.errors import NoEquilibriumError
from catopt.model import Line, PointLoad, Segment
from tests.campaign.evaluation import ANSWERED, evaluate
from tests.campaign.lines import Trial
from tests.campaign.oracle import check
from tests.campaign.refusals import RIGHT, hung_without_force
from tests.catenary.random_lines import random_setting


def trial(
    line: Line,
    height: float,
    known: str,
    value: float,
    anchor_height: float = 0.0,
    friction: float = 0.0,
) -> Trial:
    return Trial(line, height, anchor_height, friction, known, value)


# Where nothing pulls sideways, a line hangs straight: no small force in its place.
SLACK_CHAIN_UNDER_LIGHT_ROPE = trial(
    Line([Segment(500.0, 3000.0), Segment(30.0, 1.0)]), 10.0, "span", 400.0
)
LIGHT_ROPE_AT_A_RAISED_ANCHOR = trial(
    Line([Segment(20.0, 1.0), Segment(400.0, 3000.0)]), 50.0, "horizontal_force", 1e5, 5.0, 0.8
)
NEARLY_WEIGHTLESS_ROPE_UNDER_CHAIN = trial(
    Line([Segment(100.0, 1e-4), Segment(100.0, 1000.0)]), 150.0, "fairlead_tension", 9e4
)

# solve refused them as missing the fairlead, solve_many answered them.
SLACK_LIGHT_ROPE = trial(
    Line([Segment(1000.0, 1000.0), Segment(3000.0, 0.004)]), 3000.0, "span", 500.0
)
SLACK_ROPE_OVER_CHAIN = trial(Line([Segment(10.0, 100.0), Segment(20.0, 0.06)]), 6.0, "span", 2.0)
SLACK_HEAVY_TOP = trial(Line([Segment(600.0, 2e-4), Segment(400.0, 0.4)]), 600.0, "span", 300.0)
WEIGHTLESS_ROPE_NEAR_THE_BED = trial(
    Line([Segment(0.3586675818245485, 0.28768), Segment(0.06819737118411565, 0.0, EA=64677.6)]),
    1.3466524333365185e-06,
    "span",
    0.4232863447591041,
)

# Nearly weightless segments: ZeroDivisionError.
NEARLY_WEIGHTLESS_WITH_POINT_LOADS = trial(
    Line(
        [
            Segment(365.93, 4.3e-8, EA=2.1e10),
            Segment(26.615, 0.0236, EA=7.1e8),
            Segment(24.062, 0.0181, EA=1.3e4),
        ],
        [PointLoad(365.93, 4.31), PointLoad(365.93, 29.5)],
    ),
    267.574,
    "span",
    126.504,
    friction=0.828,
)

# Refused as touching the bed twice with nothing that floats.
NOTHING_BUOYANT = trial(
    Line([Segment(7.4, 21.0), Segment(4.6, 41.0, EA=9.6e6), Segment(150.9, 1.7e-6, EA=18400.0)]),
    61.36,
    "span",
    87.9,
    61.5,
    1.4,
)

# Not converged.
CLUMP_ON_A_THREAD = trial(Line([Segment(4.8, 4.9e-8)], [PointLoad(3.3, 6.1)]), 1.8, "span", 1.1)

# Two point loads at one place, the touchdown at them: each was given the reaction of both.
TWO_LOADS_AT_THE_TOUCHDOWN = trial(
    Line([Segment(50.0, 20.0)], [PointLoad(30.0, 400.0), PointLoad(30.0, 300.0)]),
    15.0,
    "horizontal_force",
    400.0,
    friction=0.6,
)

ANSWERABLE = {
    name.lower().replace("_", " "): value
    for name, value in list(globals().items())
    if isinstance(value, Trial) and name != "NEARLY_WEIGHTLESS_ROPE_UNDER_CHAIN"
}


@pytest.mark.parametrize("case", ANSWERABLE.values(), ids=ANSWERABLE.keys())
def test_there_is_an_answer_and_both_ways_give_it(case: Trial) -> None:
    """By solve, followed from both ends, and by solve_many, which must agree."""
    (outcome,) = evaluate([case])
    assert (outcome.verdict, outcome.reason) == (ANSWERED, "")


def test_slack_line_pulls_by_what_hangs_alone() -> None:
    """10 m of rope of 1 N/m hang: 10 N, whatever the chain beyond them weighs."""
    case = SLACK_CHAIN_UNDER_LIGHT_ROPE
    answer = solve(case.line, height=case.height, span=case.value)
    assert answer.fairlead.vertical_force == pytest.approx(10.0, rel=1e-12)
    assert answer.grounded_length == pytest.approx(520.0, rel=1e-12)
    assert answer.fairlead.horizontal_force == 0.0


def test_too_small_a_tension_says_how_much_is_missing() -> None:
    """The whole chain, 100 m, and 50 m of rope hang from the fairlead at least."""
    case = NEARLY_WEIGHTLESS_ROPE_UNDER_CHAIN
    least = hung_without_force(case)
    assert least is not None
    # 100 kN of chain and 5 mN of rope.
    assert least == pytest.approx(100.0 * 1000.0 + 50.0 * 1e-4, rel=1e-12)
    with pytest.raises(NoEquilibriumError) as caught:
        solve(case.line, height=case.height, fairlead_tension=case.value)
    assert caught.value.quantity == "force"
    assert caught.value.missing == pytest.approx(least - case.value, rel=1e-9)
    assert "nan" not in str(caught.value)
    (outcome,) = evaluate([case])
    assert (outcome.verdict, outcome.reason) == (RIGHT, "tension too small")


@pytest.mark.parametrize("share", [0.0, 0.5, 1.0 - 1e-6])
def test_no_force_gives_less_than_what_hangs(share: float) -> None:
    """With extreme weights, too: a tension below what hangs upright is named so."""
    thread = Line([Segment(4.8, 4.9e-8), Segment(10.0, 30.0)], [PointLoad(3.3, 6.1)])
    weight = 7.0 * 30.0
    with pytest.raises(NoEquilibriumError) as caught:
        solve(thread, height=7.0, fairlead_tension=max(share * weight, 1e-6))
    assert caught.value.quantity == "force"
    missing = weight - max(share * weight, 1e-6)
    assert caught.value.missing == pytest.approx(missing, rel=1e-9)


# --- what is just enough, and just too little ----------------------------------------------------


@pytest.mark.parametrize("seed", range(60))
def test_existence_is_decided_at_the_length_itself(seed: int) -> None:
    """Inextensible: a hair longer than the distance hangs, a hair shorter says what is missing."""
    s = random_setting(seed, raised=True)
    line = Line([replace(part, EA=math.inf) for part in s.line.segments], s.line.point_loads)
    rise = abs(s.height - s.anchor_height)
    span = math.sqrt(line.length**2 - rise**2)
    at = partial(solve, line, height=s.height, anchor_height=s.anchor_height)
    reached = at(span=span * (1 - 1e-7))
    assert reached.horizontal_force > 0.0
    with pytest.raises(NoEquilibriumError) as caught:
        at(span=span * (1 + 1e-7))
    assert 0.0 < caught.value.missing < 1e-6 * line.length


def test_least_tension_from_both_sides() -> None:
    """Just above the weight of what must hang there is an answer; just below there is none."""
    line = Line([Segment(30.0, 100.0), Segment(25.0, 2100.0)])
    weight = 20.0 * 2100.0
    just_enough = solve(line, height=20.0, fairlead_tension=weight * (1.0 + 1e-6))
    assert 0.0 < just_enough.horizontal_force < 1e-5 * weight
    with pytest.raises(NoEquilibriumError) as caught:
        solve(line, height=20.0, fairlead_tension=weight * (1.0 - 1e-6))
    assert caught.value.missing == pytest.approx(1e-6 * weight, rel=1e-9)


@pytest.mark.parametrize("force", [1.0, 1e4, 1e8])
def test_length_against_the_height_from_both_sides(force: float) -> None:
    """Inextensible: any force has an answer as soon as the line is longer than the height."""
    assert solve(Line([Segment(20.0, 100.0)]), height=20.0 - 1e-6, horizontal_force=force).span > 0
    with pytest.raises(NoEquilibriumError) as caught:
        solve(Line([Segment(20.0, 100.0)]), height=20.0 + 1e-6, horizontal_force=force)
    assert caught.value.missing == pytest.approx(1e-6, rel=1e-6)


# --- two forces with the same tension ------------------------------------------------------------

# Lines with buoyant parts that have the tension asked for at two horizontal forces.
BUOY_ABOVE_ITS_FAIRLEAD = trial(
    Line([Segment(1.5, 20.0), Segment(0.2, 600.0)], [PointLoad(1.14, -500.0)]),
    0.5,
    "fairlead_tension",
    200.0,
)
FLOATING_LINE = trial(Line([Segment(20.0, -0.2), Segment(2.8, -2.7)]), 9.0, "fairlead_tension", 8.0)


def other_force(case: Trial, force: float) -> float:
    """Largest horizontal force below `force` with the tension asked for, by halving; N."""

    def excess(H: float) -> float:
        answer = solve(case.line, height=case.height, horizontal_force=H)
        assert check(answer, "horizontal_force", H).is_right
        return answer.fairlead.tension - case.value

    high = force * (1.0 - 1e-3)
    assert excess(high) < 0.0
    low = high
    while excess(low) < 0.0:
        low *= 0.9
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if excess(middle) > 0.0 else (low, middle)
    return 0.5 * (low + high)


def numbers_in(text: str) -> list[float]:
    """Every number of a text, in N where kN stands behind it."""
    found = re.findall(r"(-?\d+(?:[.,]\d+)*(?:e[+-]?\d+)?)\s*(kN|MN|N)?", text)
    scale = {"kN": 1e3, "MN": 1e6}
    return [float(number.replace(",", "")) * scale.get(unit, 1.0) for number, unit in found]


@pytest.mark.parametrize(
    "case", [BUOY_ABOVE_ITS_FAIRLEAD, FLOATING_LINE], ids=["buoy", "floating line"]
)
def test_of_two_forces_the_larger_is_the_answer_and_the_other_is_named(case: Trial) -> None:
    answer: Solution = solve(case.line, height=case.height, fairlead_tension=case.value)
    (outcome,) = evaluate([case])
    assert (outcome.verdict, outcome.reason) == (ANSWERED, "")
    other = other_force(case, answer.horizontal_force)
    assert other < answer.horizontal_force
    warnings = [each for each in answer.warnings if "other" in each]
    assert len(warnings) == 1
    assert any(math.isclose(n, other, rel_tol=1e-2) for n in numbers_in(warnings[0]))
    document: dict[str, Any] = answer.to_dict()
    assert warnings[0] in document["warnings"]
