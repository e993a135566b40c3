"""A bed that slopes: lines on it integrated, hung on it and dragged along it."""

from __future__ import annotations

import math
from typing import Literal

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from catopt.errors import InputError, NotConvergedError
from catopt.fem import LineDamping, LineProperties, TimeStepping, mesh_line
from catopt.fem.dynamic_model import lay_out_moving
from catopt.fem.dynamics import line_at_rest, run_dynamics, run_system_dynamics
from catopt.fem.seabed import Seabed
from catopt.fem.series import Harmonic, series_rows
from catopt.fem.simulation import Simulation
from catopt.fem.sloped_rest import bring_to_rest_on_slope
from catopt.fem.solve import Leg
from catopt.model import Line, Segment
from tests.fem.strings import run

LENGTH, W, EA, MASS, HEIGHT, PULL = 200.0, 1000.0, 5e7, 117.0, 60.0, 40e3
LINE = Line([Segment(LENGTH, W, EA=EA, mass=MASS)])
BARS = 400
HARD = 1e7
"""Stiffness of a bed into which the line sinks by a tenth of a millimetre, N/m2."""

State = Literal["pulled", "none", "laid"]


def integrated(degrees: float, friction: float, state: State) -> tuple[float, float, float]:
    """Integrate a line from its touchdown: span, length on the bed and tension at the anchor.

    Above it dV/ds = w from the slope of the bed on; below it dT/ds = w (sin a + mu cos a) in a line
    that was pulled and that holds what is left, w (sin a - mu cos a) in one that was laid.
    """
    angle = math.radians(degrees)
    rubs = {"pulled": friction, "none": 0.0, "laid": -friction}[state]
    fall = W * (math.sin(angle) + rubs * math.cos(angle))

    def lying(s: float) -> tuple[float, float]:
        """Stretched length of the part on the bed, and tension at its lower end."""
        top = PULL / math.cos(angle)
        found = solve_ivp(
            lambda u, _: [1.0 + max(top - fall * u, 0.0) / EA], (0.0, s), [0.0],
            rtol=1e-10, max_step=1.0,
        )  # fmt: skip
        return float(found.y[0, -1]), max(top - fall * s, 0.0)

    def hanging(s: float) -> tuple[float, float]:
        """Place of the fairlead from the touchdown at the arc length s."""

        def rate(u: float, _: np.ndarray) -> list[float]:
            V = PULL * math.tan(angle) + W * u
            T = math.hypot(PULL, V)
            return [(1.0 + T / EA) * PULL / T, (1.0 + T / EA) * V / T]

        x, z = solve_ivp(rate, (0.0, LENGTH - s), [0.0, 0.0], rtol=1e-10, max_step=1.0).y[:, -1]
        return float(x), float(z)

    def too_high(s: float) -> float:
        return lying(s)[0] * math.sin(angle) + hanging(s)[1] - HEIGHT

    s = brentq(too_high, 0.0, LENGTH, xtol=1e-9)
    on_bed, anchor = lying(s)
    return on_bed * math.cos(angle) + hanging(s)[0], s, anchor


@pytest.mark.slow
@pytest.mark.parametrize("state", ["pulled", "none", "laid"])
@pytest.mark.parametrize("friction", [0.05, 0.6])
@pytest.mark.parametrize("degrees", [-12.0, -3.0, 3.0, 10.0])
def test_a_grounded_line_against_its_integration(
    degrees: float, friction: float, state: State
) -> None:
    span, on_bed, anchor = integrated(degrees, friction, state)
    seabed = Seabed(HARD, friction=friction, initial_friction=state, slope=math.radians(degrees))
    simulation = line_at_rest(
        mesh_line(LINE, BARS), height=HEIGHT, horizontal_force=PULL,
        properties=LineProperties(seabed=seabed),
    )  # fmt: skip
    at = simulation.state
    # The truss's own error: 2e-3 m of 180 m at 400 bars, a fourth of that of 200.
    assert at.x[-1, 0] == pytest.approx(span, abs=5e-3)
    assert -at.force[-1, 0] == pytest.approx(PULL, rel=1e-7)
    bar = LENGTH / BARS
    lies = np.flatnonzero(at.reaction > 0.0)
    assert bar * lies[-1] == pytest.approx(on_bed, abs=1.5 * bar)
    # Half a bar's weight and friction are below it, and the touchdown is anywhere in a bar.
    assert at.tension[0] == pytest.approx(anchor, abs=2.0 * W * bar)


@pytest.mark.slow
@pytest.mark.parametrize("degrees", [-8.0, 8.0])
def test_without_friction_tension_differs_by_the_weight_of_the_height(degrees: float) -> None:
    """Virtual work of a line that slips along itself, wherever it is supported."""
    simulation = line_at_rest(
        mesh_line(LINE, BARS), height=HEIGHT, horizontal_force=PULL,
        properties=LineProperties(seabed=Seabed(HARD, slope=math.radians(degrees))),
    )  # fmt: skip
    at = simulation.state
    lies = at.reaction[1:-1] > 0.0
    assert 0 < lies.sum() < BARS - 1
    middle = 0.5 * (at.x[1:, 2] + at.x[:-1, 2])
    rise = middle[-1] - middle[0]
    # A bar's strain makes it 1 part in 1000 longer; its weight is per unstretched length.
    assert at.tension[-1] - at.tension[0] == pytest.approx(W * rise, rel=2e-3)


def hung_on_slope(friction: float, angle: float) -> Simulation:
    """Lay a line up the slope, held at its upper end, its lower end free."""
    bed, damping = Seabed(HARD, friction=friction, slope=angle), LineDamping(critical_ratio=1.0)
    of = LineProperties(damping=damping, seabed=bed, mass_matrix="lumped")
    lines = lay_out_moving([mesh_line(LINE, 100)], of)
    lines = lines._replace(lower_free=np.array([True]))
    s = np.linspace(0.0, LENGTH, 101)
    x = np.column_stack([s * math.cos(angle), 0.0 * s, s * math.sin(angle)])
    return Simulation(lines, x)


@pytest.mark.parametrize(("state", "sense"), [("none", 0.0), ("laid", -1.0)])
def test_a_line_that_hangs_on_the_slope(state: State, sense: float) -> None:
    """T = w (sin a - mu cos a) s at the arc length s from the free end, if it was let down."""
    angle, friction = math.radians(20.0), 0.2
    simulation = hung_on_slope(friction, angle)
    bring_to_rest_on_slope(simulation, state)
    s = np.linspace(0.0, LENGTH, 101)
    middle = 0.5 * (s[1:] + s[:-1])
    expected = W * (math.sin(angle) + sense * friction * math.cos(angle)) * middle
    # The free end has half a bar; friction is settled to 1e-5 of the tension at each node.
    assert simulation.state.tension == pytest.approx(expected, abs=2e-3 * expected[-1])


@pytest.mark.slow
def test_a_line_dragged_up_and_let_down_the_slope() -> None:
    """Slowly: w (sin a + mu cos a) L at the upper end going up, w (sin a - mu cos a) L going down.

    Friction takes mu w cos a of every metre over all its way, down and up.
    """
    angle, friction, period = math.radians(20.0), 0.2, 200.0
    simulation = hung_on_slope(friction, angle)
    bring_to_rest_on_slope(simulation, "none")
    way = (math.cos(angle), 0.0, math.sin(angle))
    simulation.prescribed_motion = series_rows(
        simulation.state.x[-1:], [Harmonic(period, way, (0.5 * math.pi,) * 3)], 0.25 * period
    )
    simulation.start()
    record = run(simulation, 800, 1, 0.5, nodes=range(101))
    along = record.end_force[:, 0, 1] @ np.array(way)
    speed = np.gradient(record.fairlead[:, 0] @ np.array(way), record.time)
    later, fast = record.time > period, 0.8 * np.abs(speed).max()
    for sense in (1.0, -1.0):
        pull = -along[later & (sense * speed > fast)]
        expected = W * (math.sin(angle) + sense * friction * math.cos(angle)) * LENGTH
        # Its nodes slip one after the other, by which the pull swings about its mean.
        assert pull.mean() == pytest.approx(expected, rel=0.01)
        assert pull == pytest.approx(expected, rel=0.04)
    balance = simulation.balance(record)
    ways = np.abs(np.diff(record.nodes @ np.array(way), axis=0)).sum(axis=0)
    carried = np.r_[1.0, np.full(99, 2.0), 1.0]
    taken = friction * W * math.cos(angle) * float(ways @ carried)
    # At each of the five turns nodes go back 1 mm before they slip, of a metre or two.
    assert balance.friction == pytest.approx(taken, rel=0.01)
    assert abs(balance.numerical) < 0.01 * taken


def test_a_line_that_does_not_touch_the_bed_is_that_over_a_level_one() -> None:
    taut = Line([Segment(80.0, W, EA=EA, mass=MASS)])
    stepping = TimeStepping(20.0, 0.05, ramp_time=5.0)
    found = [
        run_dynamics(
            taut, stepping, height=HEIGHT, span=60.0, motion=Harmonic(8.0, (0.5, 0.0, 0.5)),
            properties=LineProperties(seabed=Seabed(friction=0.5, slope=angle)), elements=40,
        )
        for angle in (0.0, math.radians(6.0))
    ]  # fmt: skip
    assert found[0].grounded_length.max() == found[1].grounded_length.max() == 0.0
    np.testing.assert_allclose(found[0].fairlead_force, found[1].fairlead_force, rtol=1e-9)


def test_a_line_that_slides_down_past_its_anchor_is_refused() -> None:
    seabed = Seabed(friction=0.6, slope=math.radians(17.0))
    with pytest.raises(NotConvergedError, match="slides down past its anchor, by 1"):
        line_at_rest(
            mesh_line(LINE, 100), height=HEIGHT, horizontal_force=PULL,
            properties=LineProperties(seabed=seabed),
        )  # fmt: skip


def test_a_bed_that_rises_above_the_fairlead_is_refused() -> None:
    seabed = Seabed(slope=math.radians(18.5))
    with pytest.raises(InputError, match=r"the bed rises to 61\.9 m under the fairlead"):
        line_at_rest(
            mesh_line(LINE, 100), height=HEIGHT, span=185.0,
            properties=LineProperties(seabed=seabed),
        )  # fmt: skip


def test_a_slope_is_for_one_line() -> None:
    legs = [Leg(LINE, (-180.0, 0.0, 0.0)), Leg(LINE, (180.0, 0.0, 0.0))]
    with pytest.raises(InputError, match=r"seabed.slope"):
        run_system_dynamics(
            legs, TimeStepping(1.0, 0.1), height=HEIGHT, position=(0.0, 0.0),
            properties=LineProperties(seabed=Seabed(slope=0.1)),
        )  # fmt: skip
