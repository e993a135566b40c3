"""Friction of the bed as a line's past has left it: three states, and what they do in motion."""

from __future__ import annotations

import math

import numpy as np
import pytest

import catopt
from catopt.errors import InputError
from catopt.fem import (
    Bed,
    Harmonic,
    LineDamping,
    LineProperties,
    Seabed,
    TimeStepping,
    run_dynamics,
    solve_line,
)
from catopt.model.dynamics import INITIAL_FRICTION

WEIGHT, LENGTH, HEIGHT, MU, H = 1000.0, 400.0, 50.0, 0.5, 200e3
LINE = catopt.Line([catopt.Segment(length=LENGTH, submerged_weight=WEIGHT, EA=1e9, mass=117.0)])
LYING = LENGTH - HEIGHT * math.sqrt(1.0 + 2.0 * H / (WEIGHT * HEIGHT))
"""Of a catenary that is level where it touches down, without stretch."""
SENSE = {"pulled": -1.0, "none": 0.0, "laid": 1.0}


def test_a_laid_line_holds_what_the_bed_carries_of_it_more_than_the_pull() -> None:
    rest = solve_line(
        LINE, height=HEIGHT, horizontal_force=H, seabed_friction=MU, elements=400,
        bed=Bed(friction_law="laid"),
    )  # fmt: skip
    # All of the bed's reactions rub, that of the half bar at the anchor too.
    assert rest.anchor.horizontal_force == pytest.approx(H + MU * rest.bed_reaction.sum(), rel=1e-9)
    # Stretch is 1e-4 of the length; bars of 1 m tell the touchdown to a part of one.
    assert rest.anchor.horizontal_force == pytest.approx(H + MU * WEIGHT * LYING, rel=2e-3)
    assert rest.fairlead.horizontal_force == pytest.approx(H, rel=1e-9)
    assert (np.diff(rest.tension[:200]) < 0.0).all()


def at_rest(state: str, amplitude: float = 0.0) -> catopt.fem.History:
    properties = LineProperties(
        damping=LineDamping(critical_ratio=1.0),
        seabed=Seabed(friction=MU, initial_friction=state),  # type: ignore[arg-type]
    )
    return run_dynamics(
        LINE, TimeStepping(24.0, 0.1, ramp_time=8.0), height=HEIGHT, horizontal_force=H,
        properties=properties, elements=80, motion=Harmonic(8.0, (amplitude, 0.0, 0.0)),
    )  # fmt: skip


@pytest.mark.parametrize("state", INITIAL_FRICTION)
def test_a_run_begins_with_the_friction_asked_for(state: str) -> None:
    """Within the half bar at either end of what lies, 2.5 m of 5 m bars."""
    history = at_rest(state)
    expected = H + SENSE[state] * MU * WEIGHT * LYING
    assert history.anchor_tension[0, 0] == pytest.approx(expected, abs=MU * WEIGHT * 5.0)
    # And stays there while nothing moves: Newton's tolerance, and the ring of settling.
    assert history.anchor_tension[-1, 0] == pytest.approx(history.anchor_tension[0, 0], rel=1e-3)


def test_a_small_motion_leaves_the_anchor_what_it_had() -> None:
    """Friction of 100 m takes up 50 kN: far from the touchdown the line does not stir."""
    ends = {state: at_rest(state, 0.02).anchor_tension[:, 0] for state in INITIAL_FRICTION}
    for state, tension in ends.items():
        assert np.ptp(tension) < 0.02 * H, state
    assert ends["laid"].mean() > ends["none"].mean() > ends["pulled"].mean()


def test_a_great_motion_makes_them_one() -> None:
    """When all of the line slips both ways the past is forgotten: to a tenth in two periods."""
    pulled, none, laid = (at_rest(state, 3.0).anchor_tension[:, 0] for state in INITIAL_FRICTION)
    for other in (none, laid):
        assert np.abs(other - pulled)[-80:].max() < 0.1 * abs(other[0] - pulled[0])


def test_another_state_is_refused() -> None:
    with pytest.raises(InputError, match="initial_friction: found 'lain'; one of pulled, none"):
        Seabed(initial_friction="lain")  # type: ignore[arg-type]
