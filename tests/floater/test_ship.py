"""A ship on two time scales: statics, Newman's drift, the linear spectral result, tensions."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from catopt import Line, Segment, System, solve_system
from catopt.errors import InputError
from catopt.floater import slow_drift, two_scales
from catopt.floater.line_tables import no_tables
from catopt.floater.scales import Scales, scales_of
from catopt.floater.ship_in_weather import ShipInWeather
from catopt.floater.slow_drift import drift_series, wave_numbers_of
from catopt.floater.slow_ship import HEADINGS, SlowShip, rates
from catopt.floater.slow_ship import turn as turn_of
from catopt.floater.stability import linearised, period_of, swing_mode
from catopt.floater.two_scales import MooredShip
from catopt.loads import (
    SeaState,
    SurfaceCurrent,
    Turning,
    Wind,
    equilibrium_headings,
    ship_loads,
)
from catopt.loads.environment import Headings
from catopt.loads.weathervane import YAW_TYPES
from catopt.model import ShipAfloat
from catopt.mooring.net import room_for
from catopt.mooring.under_loads import as_arrays
from catopt.waves import Waves, jonswap, random_waves, regular_wave
from catopt.waves.random_surface import fill_wave_numbers

DEPTH, DENSITY = 60.0, 1025.0
OF = ShipAfloat(190.0, 32.0, 12.0, 18.0, gusts="none", reflection=1.0)
CHAIN = Line([Segment(900.0, 1500.0, EA=9e8)])


def spread(radius: float = 40.0, lines: int = 8, first: float = 22.5) -> System:
    """Lines all round, whose fairleads lie off the origin unless the radius is 0; from deg on."""
    return System.around(
        CHAIN,
        azimuths=[math.radians(360.0 / lines * k + first) for k in range(lines)],
        anchor_radius=880.0 + radius,
        fairlead_radius=radius,
        fairlead_height=DEPTH,
    )


def calm(heading: float = 0.0) -> Waves:
    return regular_wave(0.01, 8.0, direction=heading)


def ship(of: ShipAfloat = OF, **weather: tuple[float, float]) -> ShipInWeather:
    return ShipInWeather(of, DEPTH, DENSITY, **weather)


def polar(speed: float, angle: float) -> tuple[float, float]:
    return speed * math.cos(angle), speed * math.sin(angle)


@pytest.mark.parametrize("heading", [0.0, 0.4, -1.3])
def test_mean_loads_are_those_of_the_loads(heading: float) -> None:
    """Wind, current and drift at a heading beside `ship_loads`, which counts away from the side."""
    from_wind, from_current, from_waves = 0.7, -0.5, 1.9
    weather = ship(
        wind=polar(22.0, from_wind + math.pi), current=polar(1.1, from_current + math.pi)
    )
    waves = regular_wave(3.0, 9.0, direction=from_waves + math.pi)
    seen = Headings(from_wind, from_current, from_waves).seen_at(heading)
    loads = ship_loads(
        weather.ship,
        Wind(22.0),
        SurfaceCurrent(1.1),
        # Half the square of the amplitude, of one wave as of a sea of this height.
        SeaState(9.0, significant_height=3.0 * math.sqrt(2.0)),
        DEPTH,
        wind_on="tanker loaded",
        headings=seen,
        water_density=DENSITY,
    )
    k = np.empty(1)
    fill_wave_numbers(waves.omega, DEPTH, k)
    drift = weather.drift(waves, k, np.array([heading]))[0, 0] * waves.amplitude[0] ** 2
    along, across, _ = weather.steady(heading, drift)
    assert along == pytest.approx(loads.along("surge"), rel=2e-3)
    # Each pushes away from its own side: port is positive from where it comes.
    by_kind = {
        kind: sum(e.force for e in loads.components if e.axis == "sway" and e.kind == kind)
        for kind in ("wind", "current", "wave drift")
    }
    assert across == pytest.approx(-sum(by_kind.values()), rel=2e-3)


def test_a_turret_ship_lies_as_one_on_a_point() -> None:
    """Its heading beside `catopt.loads.equilibrium_headings`, which counts where all comes from."""
    of = replace(OF, mooring_point=80.0, current_yaw="series-60")
    from_wind, from_current, from_waves = 0.9, 0.0, 0.5
    weather = ship(
        of, wind=polar(18.0, from_wind + math.pi), current=polar(0.9, from_current + math.pi)
    )
    waves = regular_wave(2.0, 8.0, direction=from_waves + math.pi)
    rest = MooredShip(spread(0.0), weather).at_rest(waves)
    headings = equilibrium_headings(
        weather.ship,
        Wind(18.0),
        SurfaceCurrent(0.9),
        SeaState(8.0, significant_height=2.0 * math.sqrt(2.0)),
        DEPTH,
        Headings(from_wind, from_current, from_waves),
        Turning(YAW_TYPES["series-60"], 80.0),
        wind_on="tanker loaded",
        water_density=DENSITY,
    )
    assert any(abs(rest.place[2] - each) < 0.01 for each in headings), (rest.place, headings)
    assert len(headings) == 1 + len(rest.others)
    assert rest.stiffness[2] > 0.0


@pytest.mark.parametrize("radius", [0.0, 40.0])
def test_at_rest_it_lies_where_solve_system_has_it(radius: float) -> None:
    """Under its own mean load; and it stays there in time, with the same tensions."""
    system = spread(radius)
    moored = MooredShip(system, ship(wind=polar(25.0, 2.8), current=polar(0.8, 3.0)))
    rest = moored.at_rest(calm())
    yaw = rest.place[2]
    moment = float(np.sum(rest.parts, axis=0)[2]) if radius else 0.0
    solved = solve_system(system.under(rest.force, moment))
    assert rest.place[0] == pytest.approx(solved.position.x, abs=1e-6)
    assert rest.place[1] == pytest.approx(solved.position.y, abs=1e-6)
    if radius:
        assert yaw == pytest.approx(solved.position.yaw, abs=1e-8)
    history = moored.run(calm(), 30.0, 0.0, np.random.default_rng(1), rest)
    if radius:  # one that turns about its turret starts a degree off
        assert history.slow[-1] == pytest.approx(rest.place, abs=1e-4)
    tensions = [each.fairlead.tension for each in (e.solution for e in solved.lines)]
    assert history.slow_tension[0, :, 0] == pytest.approx(tensions, rel=1e-6)
    # A wave of 5 mm moves the fairleads by millimetres.
    assert history.tension[:, :, 0] == pytest.approx(history.slow_tension[:, :, 0], rel=0.01)


def test_the_bow_of_a_tanker_in_ballast_takes_half_of_what_a_wall_does() -> None:
    """Head seas of 5.1 s: panel calculations have 0.42 to 0.60, of a box 0.97 (issue of 4.2)."""
    of = ShipAfloat(210.0, 32.2, 6.07, 16.4, condition="ballast", gusts="none")
    unit = 0.5 * DENSITY * 9.80665 * 32.2
    waves = regular_wave(2.0, 5.1, direction=math.pi)

    def part(of: ShipAfloat) -> float:
        weather = ShipInWeather(of, 20.0, DENSITY)
        k = wave_numbers_of(waves, 20.0)
        return float(-weather.drift(waves, k, np.zeros(1))[0, 0, 0]) / unit

    assert 0.42 < part(of) < 0.60
    assert part(replace(of, drift_factor=1.2)) == pytest.approx(1.2 * part(of))
    # A wedge of 45 deg: sin^2 of it, in short waves.
    assert part(replace(of, entrance=math.radians(45.0))) == pytest.approx(0.5, abs=0.06)
    assert part(replace(of, kind="barge")) == pytest.approx(0.97, abs=0.10)


def test_newman_of_two_waves_by_hand() -> None:
    """a1^2 D1 + a2^2 D2 + a1 a2 (D1 + D2) cos((w1 - w2) t - (p1 - p2))."""
    waves = Waves(
        np.array([1.5, 0.8]), np.array([0.7, 0.9]), np.array([0.3, 1.1]), np.full(2, math.pi)
    )
    moored = MooredShip(spread(), ship())
    k = wave_numbers_of(waves, DEPTH)
    first, second = moored.ship.drift(waves, k, np.zeros(1))[0, :, 0].tolist()
    time = np.arange(0.0, 4001.0)
    found = drift_series(moored.ship, waves, time.size, 0.0)[:, 0, 0]
    expected = 1.5**2 * first + 0.8**2 * second
    expected = expected + 1.2 * (first + second) * np.cos(-0.2 * time + 0.8)
    assert found == pytest.approx(expected, rel=1e-9)


def test_slow_drift_beside_the_spectrum() -> None:
    """Deviation of surge in a small sea within 5 % of the integral of 8 S S D^2 |H|^2."""
    of = replace(OF, surge_damping=0.25)
    system = spread()
    moored = MooredShip(system, ship(of))
    spectrum = jonswap(1.0, 9.0, 2.0)
    slow = []
    for seed in range(6):
        waves = random_waves(spectrum, 400, np.random.default_rng(seed), direction=math.pi)
        rest = moored.at_rest(waves)
        history = moored.run(waves, 10800.0, 600.0, np.random.default_rng(seed), rest)
        slow.append(history.slow[:, 0])
    deviation = math.sqrt(float(np.mean([np.var(each) for each in slow])))

    stiffness = solve_system(system).full_stiffness[0][0]
    mass = float(moored.ship.inertia[0, 0])
    damping = 2.0 * 0.25 * math.sqrt(stiffness * mass)
    omega = np.linspace(0.3, 4.0, 1500)
    k = omega**2 / 9.80665
    for _ in range(100):
        k = omega**2 / (9.80665 * np.tanh(k * DEPTH))
    factor = 1.0 + 2.0 * k * DEPTH / np.sinh(np.minimum(2.0 * k * DEPTH, 600.0))
    D = 0.5 * DENSITY * 9.80665 * factor * 32.0
    mu = np.linspace(1e-4, 1.0, 3000)
    S = spectrum.density(omega)
    force = np.array(
        [
            8.0
            * np.trapezoid(
                S
                * np.interp(omega + each, omega, S, right=0.0)
                * (0.5 * (D + np.interp(omega + each, omega, D))) ** 2,
                omega,
            )
            for each in mu
        ]
    )
    response = 1.0 / np.abs(stiffness - mass * mu**2 + 1j * mu * damping) ** 2
    expected = math.sqrt(float(np.trapezoid(force * response, mu)))
    assert expected < 1.0
    assert deviation == pytest.approx(expected, rel=0.05)


def test_waves_move_the_fairleads() -> None:
    """A long beam swell carries ship and fairleads: the sway of the origin is that of the water."""
    moored = MooredShip(spread(), ship())
    swell = regular_wave(2.0, 20.0, direction=0.5 * math.pi)
    history = moored.run(swell, 80.0, 0.0, np.random.default_rng(1))
    sway = history.whole[:, 1] - history.slow[:, 1]
    k = float(wave_numbers_of(swell, DEPTH)[0])
    over = (math.sinh(k * DEPTH) - math.sinh(k * (DEPTH - 12.0))) / (
        k * 12.0 * math.sinh(k * DEPTH)
    )
    over *= math.sin(16.0 * k) / (16.0 * k)
    assert sway.max() == pytest.approx(over, rel=0.01)
    assert np.ptp(history.tension[:, :, 0], axis=0).min() > 0.0


def unmoved(**own: Any) -> SlowShip:
    """Make a ship without wind, waves, hull forces and damping, of a round mass."""
    none, m, lever = np.zeros((721, 3)), 6e7, -50.0
    a = 1e7
    inertia = np.array(
        [
            [m + a, 0, 0],
            [0, m + a, (m + a) * lever],
            [0, (m + a) * lever, 1e11 + (m + a) * lever**2],
        ]
    )
    slow = SlowShip(
        inverse=np.linalg.inv(inertia), mass=m, added=(a, a), lever=lever, damping=np.zeros(3),
        turn_sway=-a, turn_yaw=0.0, crossflow=0.0, half=95.0, wind_table=none, current_table=none,
        current_x=0.0, current_y=0.0, turns=False, wind=np.zeros((2, 2)),
        drift=np.zeros((2, HEADINGS, 3)), first=0,
    )  # fmt: skip
    return slow._replace(**own)


def rated(moored: MooredShip, slow: SlowShip, state: list[float]) -> np.ndarray:
    net, tables, out = moored.zero_load.net, as_arrays(no_tables()), np.empty(6)
    known = as_arrays(room_for(net))
    assert rates(0.0, np.array(state), slow, as_arrays(net), tables, known, out) == -1
    return out


def test_rates_of_a_turning_ship() -> None:
    """Without any force its kinetic energy stays: what turning axes add does no work.

    In an ideal fluid a turn makes -A11 u r across, as a derivative has it; with A11 = A22 there is
    no moment of Munk.
    """
    moored = MooredShip(spread(0.0), ship(replace(OF, mooring_point=50.0)))
    slow = unmoved()
    out = rated(moored, slow, [0.0, 0.0, 0.6, 1.2, -0.4, 0.01])
    speeds, inertia = np.array([1.2, -0.4, 0.01]), np.linalg.inv(slow.inverse)
    # At the zero-load position the lines pull to no side.
    assert abs(speeds @ inertia @ out[3:]) < 1e-3 * 6e7 * 1.2 * 0.4 * 0.01
    assert out[0] == pytest.approx(1.2 * math.cos(0.6) + 0.4 * math.sin(0.6))
    assert out[2] == 0.01


@pytest.mark.parametrize("turn", [0.0, 0.004])
def test_a_current_past_a_ship_is_a_ship_through_still_water(turn: float) -> None:
    """The water does not know which of the two moves: one acceleration, seen from the shore.

    With every force of the hull there: table, derivatives, strips and the water's mass.
    """
    moored = MooredShip(spread(0.0), ship(replace(OF, mooring_point=50.0), current=(-1.0, 0.4)))
    weather = moored.ship
    slow = unmoved(
        added=weather.added, inverse=np.linalg.inv(weather.inertia),
        mass=weather.mass, turn_sway=weather.turning[0], turn_yaw=weather.turning[1],
        crossflow=weather.crossflow, current_table=weather.current_table,
    )  # fmt: skip
    yaw, flow = 0.3, complex(-1.0, 0.4)
    own = -flow * complex(math.cos(yaw), -math.sin(yaw))
    still = rated(moored, slow._replace(current_x=-1.0, current_y=0.4), [0, 0, yaw, 0, 0, turn])
    moves = rated(moored, slow, [0, 0, yaw, own.real, own.imag, turn])
    # Axes that turn with the ship add r times what its speed is.
    from_shore = [moves[3] - own.imag * turn, moves[4] + own.real * turn, moves[5]]
    assert still[3:].tolist() == pytest.approx(from_shore, rel=1e-9)


def test_strips_of_a_turn_by_hand() -> None:
    """Without a stream the drag of a turn is C L^4/32 r |r|; the sum over ten strips is near it."""
    slow = unmoved(crossflow=1e4, turn_sway=0.0)
    out = np.zeros(3)
    turn_of(slow._replace(lever=0.0), 0.0, 0.0, 0.01, out)
    assert out[2] == pytest.approx(-1e4 * 190.0**4 / 32.0 * 1e-4, rel=0.02)
    # At a drift amidships far above the turn's: 2 |v| r L^3/12 about midships, by hand.
    out = np.zeros(3)
    turn_of(slow._replace(lever=0.0), 0.0, 2.0, 0.001, out)
    assert out[2] == pytest.approx(-1e4 * 2.0 * 2.0 * 0.001 * 190.0**3 / 12.0, rel=0.02)


def test_the_rule_of_rp_2sk() -> None:
    """Mean 10: 6 + 2 x 1 against 5 + 2 x 2."""
    assert Scales(10.0, 2.0, 6.0, 1.0, 5.0, 0.0).combined == 19.0
    assert Scales(10.0, 1.0, 6.0, 1.0, 5.0, 0.0).combined == 18.0


def test_scales_of_two_sines() -> None:
    time = np.linspace(0.0, 6000.0, 60_001)
    slow = 3.0 + 2.0 * np.sin(2.0 * math.pi * time / 100.0)
    whole = slow + 0.5 * np.sin(2.0 * math.pi * time / 8.0)
    found = scales_of([slow], [whole], time, 6000.0)
    assert found.mean == pytest.approx(3.0, abs=1e-3)
    assert found.slow_deviation == pytest.approx(2.0 / math.sqrt(2.0), rel=1e-3)
    assert found.fast_deviation == pytest.approx(0.5 / math.sqrt(2.0), rel=1e-3)
    # Of a normal process of 60 cycles, which is more than a sine's.
    assert found.slow_largest == pytest.approx(
        math.sqrt(2.0) * math.sqrt(2 * math.log(60)), rel=0.01
    )
    assert found.seen == pytest.approx(5.5, abs=0.05)


def test_refused() -> None:
    with pytest.raises(InputError, match=r"floater\.ship\.moulded_depth"):
        ship(replace(OF, moulded_depth=11.0)).ship  # noqa: B018
    with pytest.raises(InputError, match=r"floater\.ship\.draught"):
        ShipInWeather(OF, 11.0, DENSITY).ship  # noqa: B018


def test_a_point_behind_the_lever_of_the_current_has_her_lie_across_it() -> None:
    """By hand: the lever falls evenly from 0.3542 L at the bow; she lies where it is the point's.

    Clarke's (0.5 + 2.4 T/L)/(1 + 0.4 Cb B/T) with L = 184.3 m, B/T = 32/12 and Cb = 0.8.
    """
    lever = (0.5 + 2.4 * 12.0 / 184.3) / (1.0 + 0.4 * 0.8 * 32.0 / 12.0) * 184.3
    off = 0.5 * math.pi * (1.0 - 60.0 / lever)
    weather = ship(replace(OF, mooring_point=60.0), current=polar(1.0, 0.0))
    rest = MooredShip(spread(0.0), weather).at_rest(calm(0.0))
    lies = [abs(math.remainder(e - math.pi, 2.0 * math.pi)) for e in (rest.place[2], *rest.others)]
    assert min(abs(each - off) for each in lies) < 2e-3, (lies, off)


def test_a_swing_grows_at_the_rate_of_the_linearised_ship() -> None:
    """A ship on one long line in a strong current: its growth over time beside the root."""
    of = replace(
        OF, mooring_point=92.0, sway_damping=0.0, yaw_damping=0.0, current_yaw="Clarke-lever"
    )
    line = Line([Segment(900.0, 1500.0, EA=9e8)])
    system = System.around(line, azimuths=[math.pi], anchor_radius=850.0, fairlead_height=DEPTH)
    moored = MooredShip(system, ship(of, current=(2.5, 0.0)))
    rest = moored.at_rest(calm())
    slow = moored._steady(calm(), rest)
    mode = swing_mode(linearised(slow, moored.zero_load.net, rest.place))
    assert mode.period is not None
    assert mode == moored.mode(calm(), rest)
    cycle = int(mode.period)
    start = np.array([*rest.place, 0.0, 0.0, 0.0])
    start[2] += 1e-8
    path = moored._stepped(moored._steady(calm(), rest), rest, 4 * cycle, start)
    yaw = path[:, 2] - rest.place[2]
    early = int(np.abs(yaw[2 * cycle : 3 * cycle]).argmax()) + 2 * cycle
    late = np.interp(early + mode.period, np.arange(yaw.size), yaw)
    assert abs(late) < 0.01
    assert math.log(late / yaw[early]) / mode.period == pytest.approx(mode.rate, rel=0.05)


def test_the_motion_that_grows_the_most_by_hand() -> None:
    """X'' = 0.02 x' - x grows by 0.01 in 2 pi/sqrt(1 - 1e-4) s; one falls by 1."""
    found = swing_mode(np.array([[0.0, 1.0, 0.0], [-1.0, 0.02, 0.0], [0.0, 0.0, -1.0]]))
    assert found.rate == pytest.approx(0.01)
    assert found.period == pytest.approx(2.0 * math.pi / math.sqrt(1.0 - 1e-4))
    wave = np.sin(2.0 * math.pi * np.arange(1000.0) / 125.0)
    assert period_of(wave, 2.0) == pytest.approx(250.0, rel=0.01)


def test_moored_by_the_stern_it_lies_stern_on() -> None:
    for point, expected in ((80.0, 0.3 - math.pi), (-80.0, 0.3)):
        weather = ship(replace(OF, mooring_point=point), current=polar(1.0, 0.3))
        rest = MooredShip(spread(0.0), weather).at_rest(calm(0.3))
        assert rest.place[2] == pytest.approx(expected, abs=1e-3)


def of_step(step: float, monkeypatch: pytest.MonkeyPatch) -> None:
    for module in (two_scales, slow_drift):
        monkeypatch.setattr(module, "SLOW_STEP", step)


def test_slow_motion_is_of_second_order_in_its_step(monkeypatch: pytest.MonkeyPatch) -> None:
    """The drift is linear between samples: a quarter of the difference for half the step."""
    waves = random_waves(jonswap(6.0, 11.0), 30, np.random.default_rng(2), direction=2.6)
    found = {}
    for step in (2.0, 1.0, 0.5):
        of_step(step, monkeypatch)
        moored = MooredShip(spread(), ship())
        history = moored.run(waves, 200.0, 0.0, np.random.default_rng(1), step=10.0)
        found[step] = history.slow[:, :2]
    first = np.abs(found[2.0] - found[1.0]).max()
    second = np.abs(found[1.0] - found[0.5]).max()
    assert math.log2(first / second) == pytest.approx(2.0, abs=0.3)


def test_finer_is_half_the_step_under_the_same_loads(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of one wave the drift is steady: there nothing but the step is another."""
    moored, waves = MooredShip(spread(), ship()), calm(0.3)
    finer = moored.run(waves, 200.0, 0.0, np.random.default_rng(1), finer=True)
    of_step(0.5, monkeypatch)
    halved = moored.run(waves, 200.0, 0.0, np.random.default_rng(1))
    assert finer.course == pytest.approx(halved.course[::2], abs=1e-12)
    assert finer.time[1] == pytest.approx(halved.time[1] / 2)


def test_a_small_ship_says_that_her_areas_are_scaled() -> None:
    """A boat of 15 m has a deckhouse of 2.5 m: AF = 3.3 (0.33 + 2.5) m2; her own areas count."""
    boat = ShipAfloat(length=15.0, breadth=3.3, draught=1.1, moulded_depth=1.43)
    small = ShipInWeather(boat, 10.0, DENSITY)
    assert small.ship.frontal_area == pytest.approx(3.3 * 2.83, rel=1e-12)
    assert "shorter than the ships of 90 m" in str(small.scaled[0])
    known = replace(boat, frontal_area=9.0, lateral_area=30.0)
    assert ShipInWeather(known, 10.0, DENSITY).scaled == ()
    assert ShipInWeather(OF, DEPTH, DENSITY).scaled == ()
