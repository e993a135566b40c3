"""What the kernel says of one line: plain numbers, so that compiled code can hold them."""

from __future__ import annotations

import math
from typing import Final, Literal, NamedTuple, get_args

from catopt.catenary.suspended import NO_TOUCHDOWN

# Status of a solve; only CONVERGED carries an answer.
CONVERGED: Final = 0
TOO_SHORT: Final = 1
TOO_HEAVY: Final = 2
NOT_CONVERGED: Final = 3
INVALID: Final = 4
REASONS: Final = (
    None,
    "too short: the line does not reach from the anchor to the fairlead",
    "too heavy: what hangs from the fairlead weighs more than the tension given",
    "not converged",
    "invalid input: a number is missing, not finite or out of range",
)

# Regime: how the line hangs (docs/regimes.md); an index into REGIMES.
SUSPENDED: Final = 0
BELOW_ANCHOR: Final = 1
GROUNDED: Final = 2
GROUNDED_BETWEEN: Final = 3
ON_BED: Final = 4
SLACK: Final = 5
GROUNDED_IN_PARTS: Final = 6
Regime = Literal[
    "suspended",
    "below-anchor",
    "grounded",
    "grounded-between",
    "on-bed",
    "slack",
    "grounded-in-parts",
]
REGIMES: Final[tuple[Regime, ...]] = get_args(Regime)

IN_PARTS: Final = -3
"""Touchdown of a line that is a chain of parts, which upper_part.py and lower_part.py find."""

TURNED: Final = -4
"""Touchdown of a line in parts that was solved from its anchor (sliding.py)."""

LOOSE: Final = -5
"""Touchdown of a line in parts that lies loose up to where its tension begins (sliding.py)."""

NO_DERIVATIVES: Final = (0.0, 0.0, 0.0, 0.0)
"""x_H, x_V, z_H and z_V of a State that has none."""
_NO_NUMBERS: Final = (math.nan,) * 11


class State(NamedTuple):
    """Equilibrium of one line; status and regime are codes above.

    H and V act at the fairlead, H_anchor and V_anchor on the anchor end (N). height_error is the
    computed height of the fairlead less the one asked for (m), grounded the unstretched length on
    the bed (m), `touchdown` where the suspended part ends (suspended.py), or IN_PARTS, TURNED or
    LOOSE. x_H, x_V, z_H and z_V are derivatives of span and height by H and V at the fairlead
    (m/N); 0 where H is 0 and for a line that was solved from its anchor.
    """

    status: int
    regime: int
    touchdown: int
    H: float
    V: float
    span: float
    height_error: float
    grounded: float
    H_anchor: float
    V_anchor: float
    x_H: float
    x_V: float
    z_H: float
    z_V: float


def failed(status: int) -> State:
    """Return a state that carries no answer."""
    return State(status, 0, NO_TOUCHDOWN, *_NO_NUMBERS)
