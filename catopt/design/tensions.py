"""The largest tension of each segment, out of a state of the kernel; meant to be compiled."""

from __future__ import annotations

import math
from typing import Any

from catopt.catenary.line_problem import LineProblem
from catopt.catenary.runs import Runs, runs_of
from catopt.catenary.state import State


def segment_tensions(
    state: State, problem: LineProblem, runs: Runs, owner: Any, segments: int, largest: Any
) -> None:
    """Write the largest tension of each segment (N) to `largest`, with the runs as work space.

    Tension is convex along a uniform run: it is largest at one of the ends.
    """
    for segment in range(segments):
        largest[segment] = 0.0
    for row in range(runs_of(state, problem, runs)):
        length = runs.length[row]
        if length > 0.0:
            k = runs.piece[row]
            H = runs.H[row]
            V = runs.V[row]
            upper = V + problem.pieces.weight[k] * length
            H_upper = H + runs.friction[row] * length
            if runs.on_bed[row] == 1:
                V = upper = 0.0
            tension = max(math.sqrt(H * H + V * V), math.sqrt(H_upper * H_upper + upper * upper))
            segment = owner[k]
            largest[segment] = max(largest[segment], tension)
