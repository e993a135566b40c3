"""A few of the signals of ``python -m tests.signals``."""

from __future__ import annotations

import signal
import sys

import pytest

from tests.signals.campaign import COMMANDS, run

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(sys.platform == "win32", reason="signals are others there"),
]

COUNT = len(COMMANDS)


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
def test_a_signal_at_any_time_ends_in_order(number: signal.Signals) -> None:
    tally = run(number, COUNT, seed=16)
    assert tally.faults == []
    assert sum(tally.ends.values()) == COUNT
