"""A ship's slow steps, her lines at every place, and her motions in waves, one by one."""

from __future__ import annotations

import cmath
import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import catopt
from catopt import Line, Segment, System, solve_system
from catopt.errors import NoEquilibriumError
from catopt.floater import two_scales
from catopt.floater.line_tables import no_tables, tables_of
from catopt.floater.ship_in_weather import ShipInWeather
from catopt.floater.slow_drift import SLOW_STEP, grown_share, mean_drift
from catopt.floater.slow_ship import (
    BEYOND,
    HEADINGS,
    SlowShip,
    blow,
    hang_lines,
    rates,
    restore,
    step_slowly,
)
from catopt.floater.tabulated import TabulatedShip
from catopt.floater.two_scales import (
    MooredShip,
    _with_means,
    sample_step,
    slow_at,
)
from catopt.hydro.coefficients import Coefficients
from catopt.loads import SeaState, SurfaceCurrent, Wind, ship_loads
from catopt.loads.environment import Headings
from catopt.mooring.net import room_for
from catopt.mooring.under_loads import as_arrays
from catopt.mooring.zero_load import net_of
from catopt.waves import Waves, regular_wave
from tests.floater.test_ship import CHAIN, OF
from tests.floater.test_ship import spread as all_round

DEPTH, RHO, G = 60.0, 1025.0, 9.80665


def spread(radius: float = 40.0) -> System:
    return all_round(radius, lines=4, first=20.0)


STIFF = Line([Segment(900.0, 1500.0)])


def one_line(line: Line = CHAIN) -> System:
    return System.around(line, azimuths=[math.pi], anchor_radius=880.0, fairlead_height=DEPTH)


def arranged(system: System) -> Any:
    return as_arrays(net_of(system))


def slow_ship(**own: Any) -> SlowShip:
    """Make a ship on which nothing acts but what is given."""
    none = np.zeros((721, 3))
    ship = SlowShip(
        inverse=np.diag([1.0 / 7e7, 1.0 / 9e7, 1.0 / 2e11]), mass=6e7, added=(1e7, 3e7), lever=0.0,
        damping=np.zeros(3), turn_sway=0.0, turn_yaw=0.0, crossflow=0.0, half=95.0, wind_table=none,
        current_table=none, current_x=0.0, current_y=0.0, turns=True, wind=np.zeros((3, 2)),
        drift=np.zeros((3, HEADINGS, 3)), first=0,
    )  # fmt: skip
    return ship._replace(**own)


def accelerated(ship: SlowShip, at: float, state: list[float], radius: float = 0.0) -> np.ndarray:
    """Find the forces that its rates come to, less those of its lines and of turning axes."""
    found = []
    for each in (ship, slow_ship(turns=ship.turns)):
        out = np.empty(6)
        net, tables = arranged(spread(radius)), as_arrays(no_tables())
        known = as_arrays(room_for(net))
        assert rates(at, np.array(state), each, net, tables, known, out) == -1
        found.append(np.linalg.solve(ship.inverse, out[3:]))
    return np.asarray(found[0] - found[1])


def test_drift_is_even_between_samples_and_between_headings() -> None:
    """At a quarter between two samples, and a third between the second and the third heading."""
    drift = np.arange(9.0 * HEADINGS).reshape(3, HEADINGS, 3) ** 2
    state = [0.0, 0.0, 2.0 * math.pi / HEADINGS * (1.0 + 1.0 / 3.0), 0.0, 0.0, 0.0]
    now, then = (drift[n, 1] * 2.0 / 3.0 + drift[n, 2] / 3.0 for n in (1, 2))
    found = accelerated(slow_ship(drift=drift), 1.25, state)
    assert found == pytest.approx(0.75 * now + 0.25 * then, rel=1e-6)
    # The last heading is followed by the first, and the last sample stays at its end.
    state[2] = -math.pi / HEADINGS
    found = accelerated(slow_ship(drift=drift), 2.0, state)
    assert found == pytest.approx(0.5 * (drift[2, -1] + drift[2, 0]), rel=1e-6)


def test_a_ship_that_leaves_the_headings_of_her_drift_is_told_of() -> None:
    """Of headings 70, 71, 0 and 1 alone: from 350 deg up to 5 deg as with all of them."""
    drift = np.arange(9.0 * HEADINGS).reshape(3, HEADINGS, 3) ** 2
    part = slow_ship(drift=np.ascontiguousarray(drift[:, [70, 71, 0, 1]]), first=70)
    net, none, out = arranged(spread()), as_arrays(no_tables()), np.empty(6)
    known = as_arrays(room_for(net))
    for degrees in (-9.0, -1.0, 4.0):
        state = [0.0, 0.0, math.radians(degrees), 0.0, 0.0, 0.0]
        whole = accelerated(slow_ship(drift=drift), 0.5, state)
        assert accelerated(part, 0.5, state) == pytest.approx(whole, rel=1e-9)
    for degrees in (-11.0, 6.0):
        state = [0.0, 0.0, math.radians(degrees), 0.0, 0.0, 0.0]
        assert rates(0.5, np.array(state), part, net, none, known, out) == BEYOND


def test_wind_is_even_between_samples_and_blows_past_what_moves() -> None:
    """At the bow of a ship that heads 30 deg: 12 m/s less what she makes, by a table of one."""
    table = np.zeros((721, 3))
    table[:, 0], table[:, 1], table[:, 2] = 50.0, -20.0, 7.0
    wind = np.array([[0.0, 0.0], [8.0, 4.0], [12.0, -4.0]])
    yaw = math.pi / 6.0
    found = accelerated(slow_ship(wind_table=table, wind=wind), 1.5, [0, 0, yaw, 2.0, -1.0, 0.0])
    blown = complex(10.0, 0.0) * cmath.exp(-1j * yaw) - complex(2.0, -1.0)
    assert found == pytest.approx(abs(blown) ** 2 * np.array([50.0, -20.0, 7.0]), rel=1e-6)


def test_a_stream_is_read_by_where_it_comes_from() -> None:
    """One from 1.25 deg to port of the bow stands half way between two of 720 rows."""
    table = np.outer(np.arange(721.0), [1.0, -2.0, 3.0])
    angle = math.radians(1.25)
    out = np.array([1.0, 1.0, 1.0])
    blow(table, -3.0 * math.sin(angle), -3.0 * math.cos(angle), out)
    assert out == pytest.approx(1.0 + 9.0 * 362.5 * np.array([1.0, -2.0, 3.0]))
    still = np.zeros(3)
    blow(table, 0.0, 0.0, still)
    assert not still.any()


def test_damping_is_about_midships() -> None:
    """100 m behind the point she turns about: v + r x is what is damped, and its lever."""
    ship = slow_ship(damping=np.array([2e5, 3e5, 4e9]), lever=-100.0)
    found = accelerated(ship, 0.0, [0.0, 0.0, 0.4, 1.5, 0.8, 0.002])
    push = -3e5 * (0.8 - 0.2)
    bare = accelerated(ship._replace(damping=np.zeros(3)), 0.0, [0.0, 0.0, 0.4, 1.5, 0.8, 0.002])
    assert found - bare == pytest.approx([-2e5 * 1.5, push, -100.0 * push - 4e9 * 0.002])


def test_her_lines_pull_as_the_solver_of_one_line_has_it() -> None:
    """Force and moment of four lines at a place and a yaw: sums over `catopt.solve`."""
    x, y, yaw = 4.0, -3.0, 0.06
    system, force, moment, tension = spread(), 0j, 0.0, []
    turn, here = cmath.exp(1j * yaw), complex(x, y)
    for leg in system.legs:
        arm = turn * complex(*leg.fairlead)
        away = complex(*leg.anchor) - here - arm
        known = catopt.solve(CHAIN, height=DEPTH, span=abs(away))
        pull = known.horizontal_force * away / abs(away)
        force, moment = force + pull, moment + (arm.conjugate() * pull).imag
        tension.append((known.fairlead.tension, known.anchor.tension))
    expected = [force.real, force.imag, moment]
    net, out = arranged(system), np.empty(3)
    none, known = as_arrays(no_tables()), as_arrays(room_for(net))
    assert restore(x, y, yaw, net, none, known, out) == -1
    assert out == pytest.approx(expected, rel=1e-8)
    tables = tables_of(net, 5.0)
    assert restore(x, y, yaw, net, tables, known, out) == -1
    # A table is 2e-3 of the closed form of each line, whose pulls are all but opposite.
    size = 2e-3 * max(each for each, _ in tension)
    assert out[:2] == pytest.approx(expected[:2], abs=size)
    assert out[2] == pytest.approx(expected[2], abs=40.0 * size)
    hung = np.empty((1, 4, 2))
    path, ways = np.array([[x, y, yaw]]), np.zeros((1, 4, 3))
    for given, near in ((none, 1e-8), (tables, 2e-3)):
        assert hang_lines(path, ways, True, net, given, hung) == (1, -1)
        assert hung[0] == pytest.approx(np.array(tension), rel=near)


@pytest.mark.parametrize("with_tables", [False, True])
def test_waves_move_each_fairlead_off_its_place(with_tables: bool) -> None:
    """1 m out, 2 m aside and 3 m up beside `catopt.solve`; what turns freely keeps its arms."""
    net = arranged(one_line())
    tables = tables_of(net, 5.0) if with_tables else as_arrays(no_tables())
    path, ways = np.array([[3.0, 1.0, 0.7], [0.0, 0.0, 0.0]]), np.zeros((2, 1, 3))
    ways[0, 0] = 1.0, 2.0, 3.0
    out = np.empty((2, 1, 2))
    assert hang_lines(path, ways, False, net, tables, out) == (2, -1)
    for found, span, height in zip(
        out[:, 0], (math.hypot(884.0, 3.0), 880.0), (63.0, 60.0), strict=True
    ):
        known = catopt.solve(CHAIN, height=height, span=span)
        near = 2e-3 if with_tables else 1e-8
        assert found == pytest.approx([known.fairlead.tension, known.anchor.tension], rel=near)
    net = arranged(one_line(STIFF))
    tables = tables_of(net, 5.0) if with_tables else tables
    far = np.array([[0.0, 0.0, 0.0], [60.0, 0.0, 0.0]])
    assert hang_lines(far, ways, False, net, tables, out) == (1, 0)


def test_steps_are_those_of_another_solver_of_equations() -> None:
    """Beside scipy's DOP853 to 1e-12: four steps of 1 s of a motion of minutes are at 1e-8."""
    net, none = arranged(spread()), as_arrays(no_tables())
    room = as_arrays(room_for(net))
    damping = np.array([1e6, 2e6, 5e9])
    drift = np.zeros((5, HEADINGS, 3))
    drift[:, :, 0] = np.array([0.0, 3e5, 6e5, 9e5, 12e5])[:, np.newaxis]
    ship = slow_ship(damping=damping, crossflow=3e4, drift=drift, wind=np.zeros((5, 2)))
    path = np.zeros((5, 6))
    path[0] = 6.0, -4.0, 0.03, 0.5, -0.3, 0.002
    assert step_slowly(1.0, ship, net, none, room, np.zeros((5, 6)), path) == (4, -1)

    def slope(t: float, state: np.ndarray) -> np.ndarray:
        out = np.empty(6)
        assert rates(min(t, 4.0), state, ship, net, none, room, out) == -1
        return out

    known = solve_ivp(slope, (0.0, 4.0), path[0], "DOP853", range(5), rtol=1e-12, atol=1e-12)
    assert path == pytest.approx(known.y.T, rel=1e-6, abs=1e-8)


def test_a_line_that_does_not_reach_stops_the_steps_and_the_run() -> None:
    """The first line, too; the message says which, and when."""
    weather = ShipInWeather(OF, DEPTH, RHO)
    moored = MooredShip(one_line(STIFF), weather)
    net = arranged(one_line(STIFF))
    room = as_arrays(room_for(net))
    path = np.zeros((4, 6))
    path[0, 0] = 60.0
    found = step_slowly(
        1.0,
        slow_ship(turns=False),
        net,
        as_arrays(no_tables()),
        room,
        np.zeros((5, 6)),
        path,
    )
    assert found == (0, 0)
    waves = regular_wave(0.01, 8.0)
    rest = moored.at_rest(waves)
    with pytest.raises(NoEquilibriumError, match="line 1"):
        moored.run(
            waves, 20.0, 0.0, np.random.default_rng(1), rest, start=np.array([60.0, 0, 0, 0, 0, 0])
        )
    with pytest.raises(NoEquilibriumError, match="line 1"):
        moored.still_tension(np.array([[60.0, 0.0, 0.0]]))


def test_cross_flow_is_the_current_s_force_abeam() -> None:
    """Over length and the square of the speed, as `ship_loads` has the force of 1 m/s abeam."""
    weather = ShipInWeather(OF, DEPTH, RHO)
    loads = ship_loads(
        weather.ship, Wind(0.0), SurfaceCurrent(1.0), SeaState(8.0, significant_height=0.0), DEPTH,
        wind_on="tanker loaded", headings=Headings(0.0, 0.5 * math.pi, 0.0), water_density=RHO,
    )  # fmt: skip
    push = abs(sum(each.force for each in loads.components if each.axis == "sway"))
    assert weather.crossflow * weather.ship.length_waterline == pytest.approx(push, rel=1e-3)


def test_a_wall_that_reflects_drifts_by_hand() -> None:
    """1/2 rho g R^2 (1 + 2 kd/sinh 2kd) over the width that it shows, in the waves' direction."""
    weather = ShipInWeather(replace(OF, reflection=0.6, mooring_point=50.0), DEPTH, RHO)
    waves = regular_wave(2.0, 9.0, direction=0.0)
    k = 1.0
    for _ in range(300):
        k = waves.omega[0] ** 2 / (G * math.tanh(k * DEPTH))
    factor = 1.0 + 2.0 * k * DEPTH / math.sinh(2.0 * k * DEPTH)
    ahead, abeam = weather.drift(waves, np.array([k]), np.array([math.pi, -0.5 * math.pi]))[:, 0]
    unit = 0.5 * RHO * G * 0.36 * factor
    assert ahead == pytest.approx([-unit * 32.0, 0.0, 0.0], abs=1e-6 * unit)
    push = unit * weather.ship.length_waterline
    assert abeam == pytest.approx([0.0, push, -50.0 * push], abs=1e-6 * push)


def test_inertia_is_moved_to_where_the_lines_are() -> None:
    """Steiner: of mass and the water's in sway about a point 50 m ahead of midships."""
    here = ShipInWeather(OF, DEPTH, RHO).inertia
    there = ShipInWeather(replace(OF, mooring_point=50.0), DEPTH, RHO).inertia
    assert here[1, 2] == 0.0
    assert there[0, 0] == here[0, 0]
    assert there[1, 2] == there[2, 1] == pytest.approx(-50.0 * here[1, 1])
    assert there[2, 2] == pytest.approx(here[2, 2] + 2500.0 * here[1, 1])
    # A tenth of the mass is carried along in surge; the ship's own gyration is L/4.
    weather = ShipInWeather(OF, DEPTH, RHO)
    assert here[0, 0] == pytest.approx(1.1 * RHO * weather.ship.displacement)
    own = weather.mass * (0.25 * weather.ship.length_waterline) ** 2
    assert own < here[2, 2] < 2.5 * own


def test_the_water_that_sways_with_her_is_clarkes() -> None:
    """Pi (T/L)^2 (1 + 0.16 Cb B/T - 5.1 (B/L)^2) over rho L^3/2, written out anew."""
    weather = ShipInWeather(OF, DEPTH, RHO)
    L, block = weather.ship.length_waterline, weather.block
    shape = 1.0 + 0.16 * block * 32.0 / 12.0 - 5.1 * (32.0 / L) ** 2
    assert weather.added[1] == pytest.approx(0.5 * RHO * math.pi * 144.0 * L * shape)


def test_a_steady_gust_is_more_wind(monkeypatch: pytest.MonkeyPatch) -> None:
    """15 m/s with a gust of 5 m/s that stays, from the rest of 15 m/s, is 20 m/s from there."""
    monkeypatch.setattr(two_scales, "gust_series", lambda _, n, *__: np.full(n, 5.0))
    waves = regular_wave(0.01, 8.0)
    gusty, steady = (
        MooredShip(spread(), ShipInWeather(of, DEPTH, RHO, wind=(speed, 0.0)))
        for of, speed in ((replace(OF, gusts="NPD"), 15.0), (OF, 20.0))
    )
    rest = gusty.at_rest(waves)
    with_gust, without = (
        each.run(waves, 8.0, 0.0, np.random.default_rng(1), rest) for each in (gusty, steady)
    )
    assert with_gust.course == pytest.approx(without.course, abs=1e-12)
    assert with_gust.course[-1, 0] > rest.place[0] + 1e-4
    assert with_gust.tension.shape == with_gust.slow_tension.shape == (with_gust.time.size, 4, 2)


def test_on_one_line_the_motion_of_her_point_is_that_of_her_fairlead() -> None:
    """A fairlead at the origin, whose arm stays nothing however she turns."""
    moored = MooredShip(one_line(), ShipInWeather(OF, DEPTH, RHO, current=(0.5, 0.0)))
    wave = regular_wave(1.0, 9.0, direction=2.5)
    time = np.arange(0.0, 20.0, 2.0)
    slow = np.stack([0.0 * time, 0.0 * time, 0.05 * time], axis=1)
    own, ways, _ = moored._fast(wave, time, slow, moored.at_rest(wave))
    assert ways.shape == (10, 1, 3)
    assert ways[:, 0, :2] == pytest.approx(own)


def test_stiffness_at_rest_is_in_the_ships_axes() -> None:
    """Of a ship that lies at 0.7 rad on a spread: the solver's own, turned to her by matrices."""
    wind = (25.0 * math.cos(0.7), 25.0 * math.sin(0.7))
    of = replace(OF, mooring_point=80.0)
    moored = MooredShip(spread(0.0), ShipInWeather(of, DEPTH, RHO, wind=wind, current=wind))
    slow = replace(moored, ship=replace(moored.ship, current=(0.5, 0.4)))
    rest = slow.at_rest(regular_wave(0.01, 8.0))
    assert abs(math.sin(2.0 * rest.place[2])) > 0.5
    stiff = np.array(solve_system(spread(0.0).under(rest.force, 0.0)).full_stiffness)[:2, :2]
    c, s = math.cos(rest.place[2]), math.sin(rest.place[2])
    turn = np.array([[c, s], [-s, c]])
    own = turn @ stiff @ turn.T
    assert rest.stiffness[:2] == pytest.approx((own[0, 0], own[1, 1]), rel=1e-5)
    # What turns her back: the weather's own moment by its heading.
    drift = mean_drift(slow.ship, regular_wave(0.01, 8.0))
    moment = [
        slow.ship.steady(rest.place[2] + d, drift(rest.place[2] + d))[2] for d in (-1e-3, 1e-3)
    ]
    assert rest.stiffness[2] == pytest.approx(-(moment[1] - moment[0]) / 2e-3, rel=1e-3)
    assert rest.mean_loads["wind"] == pytest.approx(slow.ship.blown(rest.place[2])[0].tolist())


def test_on_one_tabulated_line_she_lies_where_closed_form_has_her() -> None:
    """A table is within 2e-3 of the force, which moves a taut line by some centimetres."""
    weather = ShipInWeather(replace(OF, mooring_point=80.0), DEPTH, RHO, current=(1.6, 1.1))
    waves = regular_wave(0.01, 8.0)
    exact = MooredShip(one_line(), weather).at_rest(waves)
    found = TabulatedShip(one_line(), weather).at_rest(waves)
    assert found.place == pytest.approx(exact.place, abs=0.05)
    assert found.parts[1] == pytest.approx(exact.parts[1])
    # Across the pull the stiffness is force over span; along it, a chord of 5 % in force.
    assert found.stiffness == pytest.approx(exact.stiffness, rel=0.08)


def test_what_varies_grows_as_a_smooth_step() -> None:
    """3 s^2 - 2 s^3 of a ramp of 8 s, sampled each second; at once without one."""
    assert SLOW_STEP == 1.0
    found = grown_share(12, 8.0)
    assert found[[0, 2, 4, 8, 11]] == pytest.approx([0.0, 0.15625, 0.5, 1.0, 1.0])
    assert grown_share(3, 0.0).tolist() == [1.0, 1.0, 1.0]


def test_samples_between_samples() -> None:
    assert _with_means(np.array([[1.0], [3.0], [9.0]])).ravel().tolist() == [
        1.0,
        2.0,
        3.0,
        6.0,
        9.0,
    ]
    path = np.array([[0.0, 5.0], [2.0, 7.0], [6.0, 1.0]])
    assert slow_at(np.array([0.5, 1.25]), path).tolist() == [[1.0, 6.0], [3.0, 5.5]]
    # A twentieth of the mean period: of energies 1 and 4 at 1 and 2 rad/s it is 2 pi/1.8.
    sea = Waves(np.array([1.0, 2.0]), np.array([1.0, 2.0]), np.zeros(2), np.zeros(2))
    assert sample_step(sea) == pytest.approx(2.0 * math.pi / 1.8 / 20.0)
    assert sample_step(replace(sea, omega=np.array([0.1, 0.2]))) == SLOW_STEP


def test_motions_by_a_table_of_one_wave_by_hand() -> None:
    """Six constant answers about a point 30 m aft and 5 m to port, 58 m up; crest 20 m ahead.

    The ship lies at 0.4 rad and turns slowly to 1.4: what is alike at all headings stays so, and
    its phase is the wave's where the crest is counted.
    """
    rao = np.array([0.4 + 0.1j, -0.3j, 0.8, 0.01 + 0.02j, -0.03, 0.005j])
    omega, heading = np.array([0.3, 0.6, 0.9]), np.linspace(0.0, 2.0 * math.pi, 9)
    response = Coefficients(omega, heading, response=np.broadcast_to(rao, (3, 9, 6)) + 0j)
    moored = MooredShip(
        spread(), ShipInWeather(OF, DEPTH, RHO), response, (-30.0, 5.0, 58.0), (20.0, 0.0)
    )
    wave = Waves(np.array([1.5]), np.array([0.6]), np.array([0.7]), np.array([0.9]))
    rest = replace(moored.at_rest(wave), place=(12.0, -7.0, 0.4))
    time = np.array([0.0, 5.0, 11.0, 2300.0])
    yaws = np.array([0.4, 0.6, 1.0, 1.4])
    slow = np.stack([0.0 * time, 0.0 * time, yaws], axis=1)
    own, ways, turn = moored._fast(wave, time, slow, rest)
    k = 0.6**2 / G
    for _ in range(300):
        k = 0.6**2 / (G * math.tanh(k * DEPTH))
    for n, (t, yaw) in enumerate(zip(time, yaws, strict=True)):
        crest = complex(12.0, -7.0) + 20.0 * cmath.exp(1j * yaw)
        ahead = k * (crest * cmath.exp(-0.9j)).real
        moved = (1.5 * rao * cmath.exp(1j * (ahead + 0.7 - 0.6 * t))).real

        def way(x: float, y: float, z: float) -> np.ndarray:
            arm = np.array([x + 30.0, y - 5.0, z - 58.0])
            along, aside, up = moved[:3] + np.cross(moved[3:], arm)  # noqa: B023 - called here
            level = complex(along, aside) * cmath.exp(1j * yaw)  # noqa: B023
            return np.array([level.real, level.imag, up])

        # Between grid points 5 deg apart a vector that turns by the crest's way is a chord: 5e-3.
        assert own[n] == pytest.approx(way(0.0, 0.0, DEPTH)[:2], abs=6e-3)
        assert turn[n] == pytest.approx(moved[5], abs=1e-4)
        for j, leg in enumerate(moored.system.legs):
            assert ways[n, j] == pytest.approx(way(*leg.fairlead, DEPTH), abs=6e-3)


def test_a_run_begins_after_its_ramp_and_ends_in_time() -> None:
    """Samples from 10 s on, each 0.5 s; whole motion is slow motion and the waves'."""
    moored = MooredShip(spread(), ShipInWeather(OF, DEPTH, RHO))
    waves = regular_wave(1.0, 12.0, direction=math.pi)
    history = moored.run(waves, 20.3, 10.0, np.random.default_rng(1), step=0.5)
    assert history.time == pytest.approx(np.arange(10.0, 20.3, 0.5))
    assert history.course.shape == (22, 3)
    assert history.slow == pytest.approx(slow_at(history.time, history.course))
    finer = moored.run(waves, 12.0, 10.0, np.random.default_rng(1), step=0.5, finer=True)
    assert finer.time == pytest.approx(np.arange(10.0, 12.1, 0.25))
    assert np.ptp(history.whole[:, 0] - history.slow[:, 0]) > 0.1
    assert np.abs(history.whole[:, 2] - history.slow[:, 2]).max() < 1e-6  # no yaw in head seas


def test_in_steady_weather_wind_gusts_with_its_ramp() -> None:
    """Gusts draw on the generator, and only where there is wind and they are asked for."""
    gusty = replace(OF, gusts="NPD")
    waves = regular_wave(0.01, 8.0)
    for of, wind, moves in (
        (gusty, (15.0, 0.0), True),
        (OF, (15.0, 0.0), False),
        (gusty, (0.0, 0.0), False),
    ):
        moored = MooredShip(spread(), ShipInWeather(of, DEPTH, RHO, wind=wind))
        rest = moored.at_rest(waves)
        first, second = (
            moored.run(waves, 6.0, 0.0, np.random.default_rng(seed), rest).course for seed in (1, 2)
        )
        assert bool((first[-1] != second[-1]).any()) == moves
