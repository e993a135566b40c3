"""Lines of the campaign (tests/campaign, seed 2) that were answered wrongly or not at all.

Each is checked by the campaign's oracle, which shares nothing with the kernel.
"""

from __future__ import annotations

import pytest

from catopt.catenary.solution import Solution
from tests.campaign.evaluation import solved
from tests.campaign.lines import draw
from tests.campaign.oracle import check


def right_answer(index: int) -> Solution:
    trial = draw(2, index)
    solution = solved(trial)
    found = check(solution, trial.known, trial.value)
    assert found.is_right, found
    return solution


@pytest.mark.parametrize("index", [170488, 278211])
def test_a_line_longer_than_its_height_by_a_millionth_of_a_millionth(index: int) -> None:
    """What it is longer by decides the force: it cannot be left over as rounding of the height."""
    weight = draw(2, index).line.submerged_weight
    assert 0.0 < right_answer(index).anchor.vertical_force < 0.1 * weight


@pytest.mark.parametrize("index", [489784, 267712, 350800, 755152])
def test_a_loose_piece_takes_up_what_a_line_is_longer_than_its_height(index: int) -> None:
    """Without weight or force a piece may lean; upright it would not reach the span at any force.

    It takes a lean of sqrt(2 e) to take up the part e of its length, so 1e-12 of it is a span.
    """
    solution = right_answer(index)
    assert solution.regime == "slack"
    assert any(0.0 < abs(stretch.slope) < 1.0 for stretch in solution.stretches)


@pytest.mark.parametrize("index", [60910, 59542, 257206, 145264, 131344, 164272, 197152, 86344])
def test_a_slack_line_whose_force_is_known_to_its_rounding_is_answered(index: int) -> None:
    """V at a buoy is known to its rounding, which is a length of the light line above it.

    The first three were refused by a stricter measure than under 1e-30 N, whose span was given;
    the others, of weightless parts, when V was moved within its rounding before they leaned.
    """
    assert right_answer(index).regime == "slack"


@pytest.mark.parametrize("index", [49198, 170710, 218230, 57238, 240790, 241630])
def test_a_thread_so_light_that_the_last_digit_of_the_chain_below_turns_it(index: int) -> None:
    """Between two neighbouring places of touchdown the thread above the buoy folds over.

    V is moved within its rounding, counted from the thread; what is open of V stays open.
    """
    right_answer(index)


@pytest.mark.parametrize("index", [630487, 680455, 264367, 371311])
def test_a_line_that_lies_loose_before_its_raised_anchor_rests_at_its_span(index: int) -> None:
    """By the force its span jumps; from its anchor, where no force is left, it is longer, too."""
    solution = right_answer(index)
    assert solution.anchor.horizontal_force == 0.0 < solution.horizontal_force
    assert any("slides there" in warning for warning in solution.warnings)


@pytest.mark.parametrize("index", [613735, 636832])
def test_a_single_piece_may_end_loose_and_hang_from_both_ends(index: int) -> None:
    """It lies with tension, without it before the sliding place and behind it: six runs of one.

    Compiled code wrote the last two beyond its room.
    """
    trial = draw(7, index)
    solution = solved(trial)
    assert check(solution, trial.known, trial.value).is_right
    assert len(trial.line.segments) == 1
    assert len(solution.stretches) == 6
