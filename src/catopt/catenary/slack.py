"""A slack line: no horizontal force, the hanging part straight down, the rest in bights."""

from __future__ import annotations

from catopt.catenary.equilibrium import given_force
from catopt.catenary.pieces import total_weight
from catopt.catenary.setting import Setting
from catopt.catenary.state import CONVERGED, State

__all__ = ["NEARLY_NO_FORCE", "hang_slack", "without_force"]

NEARLY_NO_FORCE = 1e-13
"""H as a part of the weight at which a line hangs straight down to double precision."""


def hang_slack(setting: Setting) -> State:
    """State of a line that carries no horizontal force; its span is the largest of such a line."""
    pieces = setting.pieces
    scale = abs(total_weight(pieces))
    for k in range(len(pieces.length)):
        scale = max(scale, abs(pieces.weight[k]) * pieces.length[k], abs(pieces.load[k]))
        if scale == 0.0 and pieces.compliance[k] > 0.0:
            # Without weight only the stretch sets a force by which to call another one small.
            scale = 1e-3 / pieces.compliance[k]
    state = given_force(NEARLY_NO_FORCE * scale, setting)
    return without_force(state, state.regime, state.span) if state.status == CONVERGED else state


def without_force(state: State, regime: int, span: float) -> State:
    """Return the state with no horizontal force, at a span that needs none."""
    return State(
        state.status,
        regime,
        0.0,
        state.V,
        span,
        state.height_error,
        state.grounded,
        0.0,
        state.V_anchor,
        state.touchdown,
        state.anchor_touchdown,
        state.x_H,
        state.x_V,
        state.z_H,
        state.z_V,
    )
