"""What the truss refuses: wrong input, no equilibrium, no convergence; each with its numbers."""

from __future__ import annotations

import math
import re
from typing import Any

import pytest

from catopt.errors import InputError, NoEquilibriumError, NotConvergedError
from catopt.fem import Bed, Controls, Leg, RestrainedBed, solve_line, solve_system
from catopt.model import Line, Segment

CHAIN = Line([Segment(100.0, 1000.0)])


def test_no_convergence_names_the_node_and_what_is_left_over() -> None:
    for most in (1, 4, 12):
        with pytest.raises(NotConvergedError) as caught:
            solve_line(CHAIN, height=60.0, span=70.0, controls=Controls(max_iterations=most))
        text = str(caught.value)
        assert re.search(r"[\d.e+-]+ N remain at (the body|node \d+ of line 1)", text)
        # A step that was settled just then is still looked at once more.
        assert any(f"after {n} iterations" in text for n in (most, most + 1))
        assert caught.value.exit_status == 4


def test_a_line_that_is_too_short_says_by_how_much() -> None:
    with pytest.raises(NoEquilibriumError) as caught:
        solve_line(CHAIN, height=60.0, span=90.0)
    assert caught.value.missing == pytest.approx(math.hypot(60.0, 90.0) - 100.0, rel=1e-14)
    with pytest.raises(NoEquilibriumError):
        solve_line(CHAIN, height=100.0, horizontal_force=1e4)
    with pytest.raises(NoEquilibriumError, match="line 2"):
        solve_system(
            [Leg(CHAIN, (70.0, 0.0, 0.0)), Leg(CHAIN, (-90.0, 0.0, 0.0))],
            height=60.0,
            position=(0.0, 0.0),
        )


@pytest.mark.parametrize(
    ("arguments", "key"),
    [
        ({"height": -1.0, "span": 70.0}, "height"),
        ({"height": 60.0}, "load"),
        ({"height": 60.0, "span": 70.0, "horizontal_force": 1e4}, "load"),
        ({"height": 60.0, "span": 0.0}, "span"),
        ({"height": 60.0, "span": 70.0, "seabed_friction": -0.1}, "seabed_friction"),
        ({"height": 60.0, "horizontal_force": math.nan}, "horizontal_force"),
    ],
)
def test_wrong_input_is_named(arguments: dict[str, Any], key: str) -> None:
    with pytest.raises(InputError, match=key):
        solve_line(CHAIN, **arguments)


def test_every_problem_is_told_at_once() -> None:
    with pytest.raises(InputError) as caught:
        solve_line(CHAIN, height=-1.0, anchor_height=-2.0)
    assert len(caught.value.problems) == 3
    with pytest.raises(InputError) as caught:
        solve_system([], height=1.0)
    assert len(caught.value.problems) == 2
    for wrong in (
        lambda: Bed(normal_stiffness=0.0),
        lambda: Bed(friction_law="sticky"),  # type: ignore[arg-type]
        lambda: RestrainedBed(-1.0),
        lambda: RestrainedBed(10.0, EA_multiplier=0.0),
    ):
        with pytest.raises(InputError):
            wrong()
