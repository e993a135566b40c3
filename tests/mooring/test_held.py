"""A body held in six freedoms: published stiffnesses, and the derivatives of its own loads."""

from __future__ import annotations

import math
from itertools import product

import pytest

from catopt import Line, PointLoad, Segment, System, solve_system
from catopt.errors import InputError, NoEquilibriumError
from catopt.mooring.fixed_body import at_displacement
from catopt.mooring.network_rest import FREEDOMS, HeldBody

from .layouts import unequal_legs

DEPTHS = {"oc3": 320.0, "oc4": 200.0, "volturnus": 200.0}


def published(name: str, friction: float = 0.0) -> System:
    """Build the mooring of one of three reference turbines; w = (m - pi/4 d^2 rho) g."""
    made = {
        # length, submerged weight, EA, anchor radius, fairlead radius and height, first azimuth
        "oc3": (902.2, 698.0945, 384.243e6, 853.87, 5.2, 250.0, 0.0),
        "oc4": (835.35, 1065.2613, 753.6e6, 837.6, 40.868, 186.0, 60.0),
        "volturnus": (850.0, 5842.1223, 3.27e9, 837.6, 58.0, 186.0, 60.0),
    }
    length, weight, EA, anchor, fairlead, height, first = made[name]
    return System.around(
        Line([Segment(length, weight, EA=EA)]),
        azimuths=[math.radians(first + 120.0 * k) for k in range(3)],
        anchor_radius=anchor,
        fairlead_radius=fairlead,
        fairlead_height=height,
        seabed_friction=friction,
    )


def held(name: str, friction: float = 0.0) -> HeldBody:
    return at_displacement(published(name, friction), origin_height=DEPTHS[name])


def test_oc3_as_its_report_and_as_map() -> None:
    # NREL/TP-500-47535, equation 5-3 (printed to four digits), and MAP++ 1.20.10 with CB 0.001.
    body = held("oc3")
    assert body.load[2] == pytest.approx(-1607e3, abs=0.5e3)
    K = body.stiffness
    assert [K[0][0], K[1][1]] == pytest.approx([41180.0] * 2, abs=5.0)
    assert K[2][2] == pytest.approx(11940.0, abs=5.0)
    assert [K[3][3], K[4][4]] == pytest.approx([311.1e6] * 2, rel=1.1e-3)
    assert K[5][5] == pytest.approx(11.56e6, rel=1e-3)
    # The report's K15 and K51 differ, -2.821e6 and -2.816e6: linearised by differences.
    assert K[4][0] == pytest.approx(-2.816e6, abs=0.6e3)
    assert K[0][4] == pytest.approx(-2.821e6, rel=2.1e-3)
    line = held("oc3", 0.001).lines[0]
    assert line.horizontal_force == pytest.approx(736939.290, abs=0.5)
    assert line.vertical_force == pytest.approx(535727.992, abs=0.5)
    assert line.grounded == pytest.approx(134.785, abs=0.5e-3)


@pytest.mark.parametrize(
    ("name", "load", "diagonal", "K15"),
    [
        # MoorPy 1.3.0 without friction, about the waterline.
        ("oc3", -1607183.5, (41181.2, 11941.5, 310.785e6, 11.5667e6), -2.81543e6),
        ("oc4", -1893319.8, (70836.0, 19140.5, 87.2407e6, 116.970e6), -107232.0),
        ("volturnus", -6082425.6, (71891.4, 60742.6, 258.591e6, 252.292e6), 1.14472e6),
    ],
)
def test_three_turbines_as_moorpy(
    name: str, load: float, diagonal: tuple[float, ...], K15: float
) -> None:
    body = held(name)
    K = body.stiffness
    assert body.load[2] == pytest.approx(load, rel=1e-6)
    assert (K[0][0], K[2][2], K[3][3], K[5][5]) == pytest.approx(diagonal, rel=5e-6)
    assert K[0][4] == pytest.approx(K15, rel=5e-6)


def sloping() -> System:
    """Build four lines that differ, one with a clump weight, on fairleads of different heights."""
    plain = Line([Segment(420.0, 900.0, EA=4e8)])
    weighted = Line([Segment(430.0, 700.0, EA=6e8)], [PointLoad(300.0, 50e3)])
    return System(unequal_legs(plain, weighted))


AWAY = (3.0, -2.0, 1.5, 0.04, -0.06, 0.1)


def test_stiffness_is_minus_the_derivative_of_the_load() -> None:
    # Central differences of the load by displacements; rotations about fixed axes on top of the
    # ones given are differences of the load at small angles only, hence about no rotation.
    system = sloping()
    at = (*AWAY[:3], 0.0, 0.0, 0.0)
    body = at_displacement(system, origin_height=80.0, displacement=at)
    scale = [max(map(abs, row)) for row in body.stiffness]
    for j, step in enumerate((1e-4,) * 3 + (1e-6,) * 3):
        plus, minus = (
            at_displacement(
                system,
                origin_height=80.0,
                displacement=tuple(v + sign * step * (k == j) for k, v in enumerate(at)),
            ).load
            for sign in (1.0, -1.0)
        )
        for i in range(6):
            slope = -(plus[i] - minus[i]) / (2.0 * step)
            assert body.stiffness[i][j] == pytest.approx(slope, abs=1e-6 * scale[i]), (i, j)


def test_turning_everything_turns_the_answer() -> None:
    # A body turned by its yaw alone stands as the same body whose fairleads were put there.
    system = sloping()
    body = at_displacement(system, origin_height=80.0, displacement=AWAY)
    again = at_displacement(
        system, origin_height=80.0, displacement=(*AWAY[:5], AWAY[5] + 2 * math.pi)
    )
    assert body.load == pytest.approx(again.load, rel=1e-9)
    # Moments about another origin: M' = M + (old - new) x F, heights apart by 10 m.
    upright = (*AWAY[:3], 0.0, 0.0, 0.0)
    low = at_displacement(system, origin_height=70.0, displacement=upright).load
    high = at_displacement(system, origin_height=80.0, displacement=upright).load
    assert low[:3] == pytest.approx(high[:3], rel=1e-12)
    assert low[3] == pytest.approx(high[3] - 10.0 * high[1], rel=1e-9)
    assert low[4] == pytest.approx(high[4] + 10.0 * high[0], rel=1e-9)


def test_in_plan_it_is_that_of_the_equilibrium() -> None:
    from dataclasses import replace

    system = replace(sloping(), force=(150e3, 60e3), yaw_free=True)
    solution = solve_system(system)
    rest = solution.position
    body = at_displacement(
        system, origin_height=80.0, displacement=(rest.x, rest.y, 0.0, 0.0, 0.0, rest.yaw)
    )
    planar = (0, 1, 5)
    for (i, a), (j, b) in product(enumerate(planar), enumerate(planar)):
        assert body.stiffness[a][b] == pytest.approx(solution.full_stiffness[i][j], rel=1e-6)
    assert (body.load[0], body.load[1]) == pytest.approx((-150e3, -60e3), rel=1e-6)
    assert abs(body.load[5]) < 1e-6 * 150e3 * 9.0


def test_what_has_no_stiffness_is_refused() -> None:
    system = published("oc3")
    with pytest.raises(InputError, match="its fairlead must not be below the bed"):
        at_displacement(system, origin_height=320.0, displacement=(0.0, 0.0, -251.0, 0.0, 0.0, 0.0))
    with pytest.raises(InputError, match="line 1 hangs slack"):
        at_displacement(system, origin_height=320.0, displacement=(300.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    stiff = System.around(
        Line([Segment(902.2, 698.0945)]),
        azimuths=[0.0, 2.0, 4.0],
        anchor_radius=853.87,
        fairlead_height=250.0,
    )
    with pytest.raises(NoEquilibriumError):
        at_displacement(stiff, origin_height=320.0, displacement=(-60.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    assert len(FREEDOMS) == 6
