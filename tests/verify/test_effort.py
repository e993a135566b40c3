"""What a run in time takes is estimated, and said or refused, before it begins."""

from __future__ import annotations

import time

import pytest

from catopt.casefile import parse_case
from catopt.errors import InputError
from catopt.model.case import MOST_EVALUATIONS, SwarmSettings
from catopt.verify.dynamic import verify_dynamic
from tests.fuzz.kinds import MOVING


def moving(**changes: str) -> str:
    text = MOVING
    for old, new in (("12 s", "duration"), ("0.2 s", "time_step"), ("12\n", "elements")):
        if new in changes:
            text = text.replace(old, changes[new])
    return text


def test_what_would_take_months_is_refused_by_key_at_once() -> None:
    case = parse_case(moving(duration="30 years", time_step="10 ms"))
    start = time.process_time()
    with pytest.raises(InputError) as caught:
        verify_dynamic(case, convergence_check="none")
    assert time.process_time() - start < 30.0
    said = str(caught.value)
    assert "dynamics.duration: found 9.46728e+08 s; 94,672,800,000 steps of 12 bars" in said
    assert "at most 30 days are allowed: use a shorter duration, a longer time_step" in said


def test_so_is_what_would_not_fit_into_the_memory() -> None:
    text = moving(duration="20 days", time_step="10 ms").replace("elements = 12", "elements = 4")
    case = parse_case(text + 'output_interval = "10 ms"\n')
    with pytest.raises(InputError, match=r"dynamics.output_interval: 172,800,000 steps .* 28 GB"):
        verify_dynamic(case, convergence_check="none")


def test_a_swarm_of_days_is_refused() -> None:
    with pytest.raises(
        InputError, match=r"runs: found 1000; .* 100,000,000,000 evaluations; at most 10,"
    ):
        SwarmSettings(particles=10_000, iterations=10_000, runs=1_000)
    assert SwarmSettings(particles=10_000, iterations=10_000, runs=100).runs == 100
    assert MOST_EVALUATIONS == 10**10


def test_what_takes_minutes_is_announced() -> None:
    """Stopped as soon as it is said: the run itself is not wanted here."""

    class SaidError(Exception):
        """Carries the words."""

    def announce(words: str) -> None:
        raise SaidError(words)

    case = parse_case(moving(duration="30 h"))
    words = (
        r"540,000 steps of 12 bars, 1 time and up to 8 times that for the second run: some 6 min on"
    )
    with pytest.raises(SaidError, match=words):
        verify_dynamic(case, announce=announce)
    verify_dynamic(parse_case(MOVING), convergence_check="none", announce=announce)
