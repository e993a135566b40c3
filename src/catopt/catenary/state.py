"""What the kernel says of one line: plain numbers, so that compiled code can hold them."""

from __future__ import annotations

import math
from typing import Final, NamedTuple

__all__ = [
    "BELOW_ANCHOR",
    "CONVERGED",
    "GROUNDED",
    "GROUNDED_BETWEEN",
    "INVALID",
    "JUMPS",
    "NOT_CONVERGED",
    "ON_BED",
    "REASONS",
    "REGIMES",
    "SLACK",
    "SUSPENDED",
    "TOO_HEAVY",
    "TOO_SHORT",
    "TOUCHES_TWICE",
    "State",
    "failed",
]

# Status of a solve; only CONVERGED carries an answer.
CONVERGED: Final = 0
TOO_SHORT: Final = 1
TOO_HEAVY: Final = 2
TOUCHES_TWICE: Final = 3
NOT_CONVERGED: Final = 4
INVALID: Final = 5
JUMPS: Final = 6
REASONS: Final = (
    None,
    "too short: the line does not reach from the anchor to the fairlead",
    "too heavy: what hangs from the fairlead weighs more than the tension given",
    "touches twice: a buoyant part lifts the line off the bed between two stretches on it",
    "not converged",
    "invalid input: a number is missing, not finite or out of range",
    "jumps: the line slides on the bed from one side of the span or tension given to the other",
)

# Regime: how the line hangs (docs/regimes.md); an index into REGIMES.
SUSPENDED: Final = 0
BELOW_ANCHOR: Final = 1
GROUNDED: Final = 2
GROUNDED_BETWEEN: Final = 3
ON_BED: Final = 4
SLACK: Final = 5
REGIMES: Final = (
    "suspended",
    "below-anchor",
    "grounded",
    "grounded-between",
    "on-bed",
    "slack",
)


class State(NamedTuple):
    """Equilibrium of one line.

    Attributes
    ----------
    status, regime : int
        Codes above.
    H, V : float
        Forces at the fairlead, N.
    span : float
        m.
    height_error : float
        Computed height of the fairlead less the one asked for, m.
    grounded : float
        Unstretched length on the bed, m.
    H_anchor, V_anchor : float
        Forces on the anchor end, N.
    touchdown, anchor_touchdown : int
        Touchdown codes (walk.py) from the fairlead and, for a raised anchor, from the anchor
        with the pieces counted from the fairlead.
    x_H, x_V, z_H, z_V : float
        Derivatives of span and height by H and V at the fairlead, m/N.
    """

    status: int
    regime: int
    H: float
    V: float
    span: float
    height_error: float
    grounded: float
    H_anchor: float
    V_anchor: float
    touchdown: int
    anchor_touchdown: int
    x_H: float
    x_V: float
    z_H: float
    z_V: float


def failed(status: int) -> State:
    """Return a state that carries no answer."""
    nan = math.nan
    return State(status, 0, nan, nan, nan, nan, nan, nan, nan, 0, 0, nan, nan, nan, nan)
