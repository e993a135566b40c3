"""What the rounding of the input alone leaves open of the forces of a line."""

from __future__ import annotations

import math

from catopt.catenary.line_problem import LineProblem
from catopt.catenary.pieces import total_length
from catopt.catenary.root_search import BY_SPAN, BY_TENSION
from catopt.catenary.state import State
from catopt.compiled import inlined

HALF_A_DIGIT = 2.0**-53
"""Part of a number by which its nearest double misses it at most."""

LEFT_BY_SOLVER = 2.0**-49
"""Part of the length by which the solver itself may miss the span or the height by rounding."""


@inlined
def force_uncertainty(state: State, problem: LineProblem, known: int) -> float:
    """Bound of the change of the forces at the fairlead when every input is off by its rounding, N.

    The lengths, the span and the heights are moved by half a unit in their last place, all in the
    worst sense, with what rounding leaves of the solver's own residual, and the forces follow by
    the line's derivatives. A line that does not stretch and is nearly taut magnifies this by as
    much as it is stiff. What is `known` is root_search.BY_SPAN, BY_TENSION, or else the horizontal
    force.
    """
    T = math.sqrt(state.H * state.H + state.V * state.V)
    own = HALF_A_DIGIT * T
    if state.H == 0.0 or state.z_V <= 0.0:
        return own
    length = total_length(problem.pieces)
    left = LEFT_BY_SOLVER * length
    dz = left + HALF_A_DIGIT * (length + problem.fairlead_height + problem.anchor_height)
    if known == BY_SPAN:
        dx = left + HALF_A_DIGIT * (length + state.span)
        determinant = state.x_H * state.z_V - state.x_V * state.z_H
        if determinant <= 0.0:
            return own
        dH = (state.z_V * dx + abs(state.x_V) * dz) / determinant
        dV = (abs(state.z_H) * dx + abs(state.x_H) * dz) / determinant
    elif known == BY_TENSION:
        # With the tension and the height held H dH + V dV = T dT, z_H dH + z_V dV = dz.
        determinant = state.H * state.z_V - state.V * state.z_H
        if determinant == 0.0:
            return own
        dH = (state.z_V * T * own + abs(state.V) * dz) / abs(determinant)
        dV = (abs(state.z_H) * T * own + state.H * dz) / abs(determinant)
    else:
        dH = own
        dV = (dz + abs(state.z_H) * dH) / state.z_V
    return own + max(dH, dV)
