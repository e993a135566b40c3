"""The fast judgement in motion: what a sizing does unless it is told otherwise, in seconds.

A ship is run as in the full way, the same hours of the same seeds in every load case, on lines that
are read out of tables (`catopt.floater.tabulated`). A buoy is run by the full model, but once and
for less time in each load case, and every load case is judged by the runs of all of them, by the
upper end of the interval that their peaks leave, times a margin. Fewer lines are looked at than in
the full way; where only the margin stands against the last of them, its size is run in the full
way.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Final

from catopt.casefile.reading import Moored
from catopt.sizing.in_motion import LEAST_DURATION, RunsAfloat

BUOY_TIME: Final = 1600.0
"""s, that a line of a buoy is run for in all its load cases together."""
MARGIN: Final = 1.25
"""By which a buoy's tensions are taken larger than these runs say: what the full model came to
beyond them, in the comparison of benchmarks/results/quick.md."""
SINKER_MARGIN: Final = 1.25
"""By which a sinker is taken heavier than what stays in these runs: how far one slides hangs on a
few peaks of hours, and falls steeply as it is heavier."""
MOST_LINES: Final = 4
"""Lines of a buoy that are run at most."""
NEAR: Final = 0.75
"""Of a ship's size: the least that is looked at in its place."""
_SHIP_RUN: Final = 10800.0
_SHIP_RUNS: Final = 3


def quick_runs(moored: Moored) -> RunsAfloat:
    """Give the runs of the fast judgement of a buoy or a ship."""
    if moored == "buoy":
        return RunsAfloat(1, BUOY_TIME, quick=True, margin=MARGIN, sinker_margin=SINKER_MARGIN)
    return RunsAfloat(_SHIP_RUNS, _SHIP_RUN, quick=True)


def shared_out(how: RunsAfloat, states: int) -> RunsAfloat:
    """Share the time that a line of a buoy is run for out to its load cases."""
    return replace(how, duration=max(LEAST_DURATION, BUOY_TIME / states))


def lines_of(how: RunsAfloat, height: float) -> dict[str, Any]:
    """Say on what lines a search runs a ship, in seas up to a height, m: out of tables if fast."""
    from catopt.verify.two_scales import on_tables

    return {"on_lines": on_tables(height)} if how.quick else {}
