"""A line whose friction lets it slide: the spans between the two sides of a jump.

With much friction the span of a line that leaves the bed again (towards a raised anchor or under a
buoy) can jump as the horizontal force grows: at one force it rests with most of it on the bed and
nothing left of the force, and with most of it lifted and nothing lost. Between the two it has an
equilibrium at every span; under a constant force it would slide out of it, between ends that are
held it stays. Followed from the anchor, the tension grows along the bed, and each force at the
anchor belongs to just one line: so there the span is sought over that force.
"""

from __future__ import annotations

from catopt.catenary.pieces import turned
from catopt.catenary.setting import Setting
from catopt.catenary.state import TURNED, State

__all__ = ["from_its_anchor", "turned_back"]


def from_its_anchor(setting: Setting) -> Setting:
    """Return the line with its ends exchanged: friction adds to its tension on the way down."""
    return Setting(
        turned(setting.pieces),
        setting.fairlead_height,
        setting.anchor_height,
        -setting.friction,
    )


def turned_back(state: State) -> State:
    """Return the state of a line that was solved with its ends exchanged."""
    return State(
        state.status,
        state.regime,
        state.H_anchor,
        -state.V_anchor,
        state.span,
        -state.height_error,
        state.grounded,
        state.H,
        -state.V,
        TURNED,
        0.0,
        0.0,
        0.0,
        0.0,
    )
