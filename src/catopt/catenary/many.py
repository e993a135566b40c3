"""The loop over many lines; meant to be compiled."""

from __future__ import annotations

import math
from typing import Any, Final

from catopt.catenary.closing import BY_SPAN
from catopt.catenary.equilibrium import given_force
from catopt.catenary.pieces import Pieces, split
from catopt.catenary.setting import Setting
from catopt.catenary.span import given_span
from catopt.catenary.state import INVALID, failed
from catopt.catenary.tension import given_tension

__all__ = ["BY_FORCE", "COLUMNS", "fill"]

BY_FORCE: Final = 2
"""What is known of each line, beside closing.BY_SPAN (0) and closing.BY_TENSION (1)."""

COLUMNS: Final = (
    "H",
    "V",
    "span",
    "height_error",
    "grounded",
    "H_anchor",
    "V_anchor",
    "x_H",
    "x_V",
    "z_H",
    "z_V",
)
"""Names of the columns that `fill` writes, as in State."""


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
    pieces: Pieces,
    owner: Any,
    first: int,
    end: int,
    status: Any,
    regime: Any,
    out: Any,
) -> None:
    """Solve lines `first` to `end` (not included).

    Parameters
    ----------
    known : int
        What `wanted` holds: spans, tensions or forces.
    wanted, height, anchor_height, friction : array, shape (n,)
        Per line.
    length, weight, compliance, position, point_weight : array, shape (n or 1, segments or loads)
        Per line, or one row for all.
    pieces, owner
        Work space for one line (pieces.split).
    first, end : int
        Range of lines.
    status, regime : array of int, shape (n,)
        Written to.
    out : array, shape (n, 11)
        Written to; COLUMNS names its columns.
    """
    nan = math.nan
    for i in range(first, end):
        is_valid = (
            wanted[i] > 0.0
            and height[i] >= 0.0
            and anchor_height[i] >= 0.0
            and friction[i] >= 0.0
            and not math.isinf(wanted[i] + height[i] + anchor_height[i] + friction[i])
        )
        row_length = length[i if length.shape[0] > 1 else 0]
        row_weight = weight[i if weight.shape[0] > 1 else 0]
        row_compliance = compliance[i if compliance.shape[0] > 1 else 0]
        row_position = position[i if position.shape[0] > 1 else 0]
        row_point_weight = point_weight[i if point_weight.shape[0] > 1 else 0]
        is_valid = (
            is_valid
            and _are_segments(row_length, row_weight, row_compliance)
            and _are_point_loads(row_position, row_point_weight, row_length)
        )
        if is_valid:
            split(
                row_length,
                row_weight,
                row_compliance,
                row_position,
                row_point_weight,
                pieces,
                owner,
            )
        setting = Setting(pieces, anchor_height[i], height[i], friction[i])
        if not is_valid:
            state = failed(INVALID)
        elif known == BY_FORCE:
            state = given_force(wanted[i], setting)
        elif known == BY_SPAN:
            state = given_span(wanted[i], setting, nan, nan)
        else:
            state = given_tension(wanted[i], setting)
        status[i] = state.status
        regime[i] = state.regime
        out[i, 0] = state.H
        out[i, 1] = state.V
        out[i, 2] = state.span
        out[i, 3] = state.height_error
        out[i, 4] = state.grounded
        out[i, 5] = state.H_anchor
        out[i, 6] = state.V_anchor
        out[i, 7] = state.x_H
        out[i, 8] = state.x_V
        out[i, 9] = state.z_H
        out[i, 10] = state.z_V


def _are_segments(length: Any, weight: Any, compliance: Any) -> bool:
    """Whether every segment has a length, a finite weight and a stiffness above 0."""
    for k in range(len(length)):
        if not 0.0 < length[k] < math.inf or not abs(weight[k]) < math.inf:
            return False
        if not 0.0 <= compliance[k] < math.inf:
            return False
    return True


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
