"""Sizings drawn at random: what is recommended passes, and a larger allowance is never weaker."""

from __future__ import annotations

import dataclasses
import random
from typing import Any

import pytest

from catopt.checks.case import check_case
from catopt.checks.profiles import profiles
from catopt.errors import CatoptError, InputError, NoAnswerError
from catopt.loads import buoys
from catopt.loads.drag_anchor import masses_sold
from catopt.loads.ship import ship_dimensions
from catopt.loads.sinker import SOIL_FRICTION
from catopt.model import Case
from catopt.sizing import Sizing
from catopt.sizing.line_choice import PREFERENCES
from tests.sizing.alone import alone
from tests.sizing.at_rest import size_buoy, size_tanker
from tests.sizing.test_recommended_lines import every_settled

CODES = tuple(each.name for each in profiles() if not each.is_recalled)
BUOYS = tuple(each.name for each in buoys() if not each.name.startswith("mooring"))
HALVINGS = 12
MOST = 8.0
"""Times the forces that a line was sized for: more is not tried."""
FOUND = MOST / 2**HALVINGS


def drawn_buoy(draw: random.Random) -> dict[str, Any]:
    depth = draw.uniform(6.0, 40.0)
    return {
        "buoy": draw.choice(BUOYS),
        "depth": depth,
        "low_water": depth * draw.uniform(0.75, 1.0),
        "wind": draw.uniform(5.0, 35.0),
        "current": draw.uniform(0.0, 2.5),
        "hs": draw.uniform(0.0, 3.0),
        "soil": draw.choice((None, *SOIL_FRICTION)),
        "code": draw.choice(CODES),
        "life": draw.choice(("0 s", "5 years", "10 years")),
        "prefer": draw.choice((None, None, *(each for each in PREFERENCES if each != "cheapest"))),
    }


def drawn_ship(draw: random.Random) -> dict[str, Any]:
    kind = draw.choice(("tanker", "bulk carrier", "general cargo"))
    dwt = draw.uniform(1e4, 4e4) if kind == "general cargo" else 10.0 ** draw.uniform(4.0, 5.3)
    depth = ship_dimensions(kind, 1e3 * dwt).draught * draw.uniform(1.3, 3.0)
    return {
        "ship": kind,
        "dwt": f"{dwt:.6g} t",
        "depth": depth,
        "low_water": depth * draw.uniform(0.9, 1.0),
        "wind": draw.uniform(5.0, 35.0),
        "current": draw.uniform(0.0, 1.5),
        "hs": draw.uniform(0.0, 3.0),
        "soil": draw.choice(("sand", "soft clay")),
        "code": draw.choice(CODES),
        "life": draw.choice(("0 s", "5 years", "10 years")),
        "prefer": draw.choice((None, None, *PREFERENCES)),
    }


def sized(given: dict[str, Any], factor: float) -> Sizing | None:
    """Size it; None where nothing that is sold passes, or the buoy is too small for the place."""
    sizer = size_buoy if "buoy" in given else size_tanker
    try:
        return sizer(**given, dynamic_factor=factor)
    except (NoAnswerError, InputError):
        return None


def passes(case: Case, factor: float) -> bool:
    """Whether a case's line keeps every check under its forces times a factor."""
    states = (
        dataclasses.replace(each, horizontal_force=factor * each.horizontal_force)
        for each in case.load_cases
    )
    try:
        return check_case(dataclasses.replace(case, load_cases=tuple(states), design=None)).passes
    except CatoptError:
        return False


def withstands(case: Case) -> float:
    """Find the largest factor on its forces at which a case's line keeps every check."""
    low, high = 0.0, MOST
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if passes(case, middle) else (low, middle)
    return low


def is_kept(of: Sizing) -> bool:
    """Whether the line, and each line beside it, keeps every check of its own case."""
    lines = every_settled(of)
    return all(each.point.checks.passes and passes(each.case, 1.0) for each in lines)


def is_sold(of: Sizing) -> bool:
    """Whether a drag anchor is of a mass that its source has."""
    if of.drag_anchor is None:
        return True
    least, most = masses_sold(of.drag_anchor.anchor)[0], masses_sold(of.drag_anchor.anchor)[-1]
    return least <= of.drag_anchor.mass <= most


def check_any(numbers: range) -> None:
    """Hold both promises of the sizings that are drawn with some seeds."""
    answered = differing = 0
    for number in numbers:
        draw = random.Random(number)
        given = drawn_buoy(draw) if number % 2 else drawn_ship(draw)
        with alone():
            steady, moved = sized(given, 1.0), sized(given, 1.5)
        for of in (steady, moved):
            assert of is None or is_kept(of), (number, given)
            assert of is None or is_sold(of), (number, given)
        if moved is None:
            answered += steady is not None
            continue
        assert steady is not None, (number, given)
        answered += 1
        if steady.point.line != moved.point.line:
            differing += 1
            weaker = dataclasses.replace(
                moved.case, line=steady.point.line, anchor=steady.point.anchor
            )
            own = withstands(moved.case)
            assert own >= 1.0 - FOUND, (number, given)
            assert withstands(weaker) <= own + FOUND, (number, given)
    # It is not for lack of answers, or of lines that differ, that nothing is wrong.
    assert answered >= len(numbers) // 2, answered
    assert differing >= len(numbers) // 5, differing


def test_no_sizing_fails_its_checks_and_no_larger_allowance_weakens_it() -> None:
    check_any(range(15))


@pytest.mark.slow
def test_no_sizing_of_a_hundred_does() -> None:
    check_any(range(15, 115))


@pytest.mark.slow
@pytest.mark.parametrize("number", range(300, 310))
def test_no_line_beside_a_recommended_one_fails_a_check(number: int) -> None:
    draw = random.Random(number)
    of = sized(drawn_buoy(draw) if number % 2 else drawn_ship(draw), 1.0)
    assert of is not None
    assert of.alternatives
    assert is_kept(of)
