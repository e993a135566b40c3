"""The loop over many lines; meant to be compiled."""

from __future__ import annotations

import math
from typing import Any, Final

from catopt.catenary.equilibrium import BY_FORCE, BY_SPAN, force_uncertainty, given_force
from catopt.catenary.layout import LineIntervals, runs_misfit, runs_of
from catopt.catenary.pieces import LineProblem, Pieces, split, total_length
from catopt.catenary.span_or_tension import given_span, given_tension
from catopt.catenary.state import (
    CONVERGED,
    IN_PARTS,
    INVALID,
    LOOSE,
    NOT_CONVERGED,
    TURNED,
    State,
    failed,
)

RESIDUAL_LIMIT: Final = 1e-9
"""How far the line, laid out from its anchor, may miss its fairlead, as a part of its length."""

COLUMNS: Final = (*State._fields[3:], "force_uncertainty")
"""Names of the columns that `fill` writes: all numbers of State, and one more."""


def fill(
    known: int,
    wanted: Any,
    height: Any,
    anchor_height: Any,
    friction: Any,
    length: Any,
    weight: Any,
    compliance: Any,
    position: Any,
    point_weight: Any,
    point_friction: Any,
    pieces: Pieces,
    owner: Any,
    runs: LineIntervals,
    first: int,
    end: int,
    status: Any,
    regime: Any,
    out: Any,
) -> None:
    """Solve lines `first` to `end` (not included) into `status`, `regime` and `out`, by COLUMNS.

    `wanted` holds what is `known`: spans, tensions or forces, one a line like height, anchor_height
    and friction. Tables have a row a line, or one for all; point_friction, one for all lines, is
    below 0 for that of the bed. pieces, owner and runs are work space (pieces.split, runs.runs_of).
    """
    nan = math.nan
    is_one_line = (
        max(len(length), len(weight), len(compliance), len(position), len(point_weight)) == 1
    )
    is_line, weighs = False, False
    for i in range(first, end):
        if i == first or not is_one_line:
            is_line = _take(
                length[i if length.shape[0] > 1 else 0],
                weight[i if weight.shape[0] > 1 else 0],
                compliance[i if compliance.shape[0] > 1 else 0],
                position[i if position.shape[0] > 1 else 0],
                point_weight[i if point_weight.shape[0] > 1 else 0],
                point_friction,
                pieces,
                owner,
            )
            weighs = _weighs(pieces)
        # Slack without weight, it has no shape that would tell its force.
        chord = math.hypot(wanted[i], height[i] - anchor_height[i])
        is_valid = (
            is_line
            and (known != BY_SPAN or weighs or chord > total_length(pieces))
            and (wanted[i] > 0.0 or (wanted[i] == 0.0 and known == BY_SPAN))
            and height[i] >= 0.0
            and anchor_height[i] >= 0.0
            and friction[i] >= 0.0
            and not math.isinf(wanted[i] + height[i] + anchor_height[i] + friction[i])
        )
        problem = LineProblem(pieces, anchor_height[i], height[i], friction[i])
        if not is_valid:
            state = failed(INVALID)
        elif known == BY_FORCE:
            state = given_force(wanted[i], problem)
        elif known == BY_SPAN:
            state = given_span(wanted[i], problem, nan, nan)
        else:
            state = given_tension(wanted[i], problem)
        if state.touchdown in (IN_PARTS, TURNED, LOOSE) and not _is_laid_well(
            state, problem, runs, known, wanted[i]
        ):
            state = failed(NOT_CONVERGED)
        status[i] = state.status
        regime[i] = state.regime
        for column, number in enumerate(state[3:]):
            out[i, column] = number
        out[i, -1] = force_uncertainty(state, problem, known) if state.status == CONVERGED else nan


def _take(
    length: Any,
    weight: Any,
    compliance: Any,
    position: Any,
    point_weight: Any,
    point_friction: Any,
    pieces: Pieces,
    owner: Any,
) -> bool:
    """Cut a line into its pieces; False, with the pieces as they were, when it is no line."""
    if not _are_segments(length, weight, compliance):
        return False
    if not _are_point_loads(position, point_weight, length):
        return False
    split(length, weight, compliance, position, point_weight, point_friction, pieces, owner)
    return True


def _is_laid_well(
    state: State, problem: LineProblem, runs: LineIntervals, known: int, wanted: float
) -> bool:
    """Whether a line in parts, laid out from its anchor, meets its fairlead.

    One that is not in parts does: that is what equilibrium.is_certain asks of it.
    """
    size = total_length(problem.pieces)
    span = wanted if known == BY_SPAN else state.span
    height, along = runs_misfit(state, problem, runs, runs_of(state, problem, runs), span)
    return max(abs(height), abs(along)) <= RESIDUAL_LIMIT * max(size, span)


def _are_segments(length: Any, weight: Any, compliance: Any) -> bool:
    """Whether every segment has a length, a finite weight and a stiffness above 0."""
    for k in range(len(length)):
        if not 0.0 < length[k] < math.inf or not abs(weight[k]) < math.inf:
            return False
        if not 0.0 <= compliance[k] < math.inf:
            return False
    return True


def _weighs(pieces: Pieces) -> bool:
    """Whether anything of the line has a weight."""
    for k in range(len(pieces.length)):
        if pieces.weight[k] != 0.0 or pieces.load[k] != 0.0:
            return True
    return False


def _are_point_loads(position: Any, point_weight: Any, length: Any) -> bool:
    """Whether the point loads have finite weights and rise from the anchor, inside the line."""
    end = 0.0
    for k in range(len(length)):
        end += length[k]
    below = 0.0
    for k in range(len(position)):
        if not 0.0 < position[k] < end or not position[k] >= below:
            return False
        if not abs(point_weight[k]) < math.inf:
            return False
        below = position[k]
    return True
