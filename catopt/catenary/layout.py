"""The line laid out from the anchor up, as stretches that each have a place."""

from __future__ import annotations

from dataclasses import replace

from catopt.catenary.line_problem import LineProblem
from catopt.catenary.runs import Runs, most_runs, run_reach, runs_of, slack_share
from catopt.catenary.state import State
from catopt.catenary.stretch import Stretch


def lay_out(state: State, problem: LineProblem) -> tuple[Stretch, ...]:
    """Place every run of the line, from the anchor up."""
    pieces = problem.pieces
    room = most_runs(len(pieces.length))
    columns = [[0.0] * room for _ in range(5)]
    runs = Runs([0] * room, [0] * room, *columns)
    count = runs_of(state, problem, runs)
    stretches: list[Stretch] = []
    start, x, z = 0.0, 0.0, problem.anchor_height
    for row in range(count - 1, -1, -1):
        piece = runs.piece[row]
        stretch = Stretch(
            start,
            runs.length[row],
            pieces.weight[piece],
            pieces.compliance[piece],
            x,
            z,
            runs.H[row],
            runs.V[row],
            runs.friction[row],
            runs.on_bed[row] == 1,
            piece,
            slope=runs.slope[row],
        )
        stretches.append(stretch)
        x, z = end_of(stretch, stretch.length)
        start += stretch.length
    return _gathered(state, stretches, x)


def _gathered(state: State, stretches: list[Stretch], span: float) -> tuple[Stretch, ...]:
    """Draw the ends of a slack line together: what carries no tension lies in bights."""
    part = slack_share(state, span)
    if part == 1.0:
        return tuple(stretches)
    return tuple(replace(each, x=each.x * part, gathered=part) for each in stretches)


def end_of(stretch: Stretch, length: float) -> tuple[float, float]:
    """Place of the point `length` (m, unstretched) above the lower end of a stretch."""
    dx, dz = run_reach(
        stretch.horizontal_force,
        stretch.vertical_force,
        length,
        stretch.submerged_weight,
        stretch.compliance,
        stretch.friction,
        stretch.slope,
        stretch.on_bed,
    )
    return stretch.x + dx * stretch.gathered, stretch.z + dz
