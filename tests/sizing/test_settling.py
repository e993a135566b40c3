"""How loads and line settle on each other, with lines that are made up."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import pytest

from catopt.design.neighbours import NoFeasibleDesignError
from catopt.errors import NotConvergedError
from catopt.sizing import LineChoice
from catopt.sizing.converge import Assumed, ConvergedSizing, converge

CHOICE = LineChoice(("chain studless R3",), "break/5")
Needs = Callable[[float], float | None]
"""From the pull, in N, that the loads are for, to that of the line; None: no line passes."""


def settled(
    needs: Needs, patched: pytest.MonkeyPatch, start: Assumed | None = None
) -> tuple[ConvergedSizing, list[float]]:
    """Settle a line, and list the pulls that were assumed on the way."""
    tried: list[float] = []

    def best(case: float, _choice: LineChoice) -> float:
        tried.append(case)
        found = needs(case)
        if found is None:
            raise NoFeasibleDesignError("none", None)
        return found

    patched.setattr("catopt.sizing.converge._best", best)

    def pose(assumed: Assumed) -> Any:
        return SimpleNamespace(case=assumed.pull)

    def needed(_posed: object, point: Any) -> Assumed:
        return Assumed(pull=point)

    return converge(pose, needed, CHOICE, start), tried


def test_a_line_that_needs_what_was_assumed_is_the_answer(monkeypatch: pytest.MonkeyPatch) -> None:
    """From nothing it comes to 10 N, and with 10 N to 10 N."""
    found, tried = settled(lambda _: 10.0, monkeypatch)
    assert tried == [0.0, 10.0]
    assert (found.assumed.pull, found.needed.pull, found.rounds) == (10.0, 10.0, 2)


def test_the_loads_of_just_that_line_are_tried_where_those_assumed_were_larger(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """With 10 N it comes to 8 N, and with 8 N to 7 N, which hold themselves."""
    steps = {0.0: 10.0, 10.0: 8.0, 8.0: 7.0}
    found, tried = settled(lambda pull: steps[pull], monkeypatch)
    assert tried == [0.0, 10.0, 8.0]
    assert (found.assumed.pull, found.needed.pull, found.rounds) == (8.0, 7.0, 3)


@pytest.mark.parametrize("then", [9.0, None])
def test_they_are_not_taken_where_they_need_more_or_no_line_passes(
    then: float | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    steps = {0.0: 10.0, 10.0: 8.0, 8.0: then}
    found, tried = settled(lambda pull: steps[pull], monkeypatch)
    assert tried == [0.0, 10.0, 8.0]
    assert (found.assumed.pull, found.needed.pull, found.rounds) == (10.0, 8.0, 2)


def test_what_is_assumed_only_rises_until_it_is_enough(monkeypatch: pytest.MonkeyPatch) -> None:
    """With 10 N it comes to 12, with 12 N to 11: that holds, and so does 11 N by itself."""
    steps = {0.0: 10.0, 10.0: 12.0, 12.0: 11.0, 11.0: 11.0}
    found, tried = settled(lambda pull: steps[pull], monkeypatch)
    assert tried == [0.0, 10.0, 12.0, 11.0]
    assert (found.assumed.pull, found.rounds) == (11.0, 4)


def test_it_begins_where_it_is_told_to(monkeypatch: pytest.MonkeyPatch) -> None:
    found, tried = settled(lambda _: 10.0, monkeypatch, Assumed(pull=10.0))
    assert tried == [10.0]
    assert found.rounds == 1


def test_after_forty_rounds_it_is_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    tried: list[float] = []

    def more(pull: float) -> float:
        tried.append(pull)
        return pull + 1.0

    with pytest.raises(NotConvergedError, match="40"):
        settled(more, monkeypatch)
    assert tried == [float(k) for k in range(40)]
