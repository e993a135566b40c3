"""Buoys of the library as hulls: what they displace, how they swing, and what is refused."""

from __future__ import annotations

import math

import pytest

from catopt.errors import InputError
from catopt.floater.hulls import buoy_hull, floating_buoy
from catopt.model import Floater


def test_real_buoy_floats_at_its_draught() -> None:
    """Mass and ballast's own buoyancy by hand: Archimedes."""
    shape = floating_buoy(Floater("T-5000l-2.4m"))
    hull = buoy_hull(Floater("T-5000l-2.4m"), 15.0, 1025.0, 3000.0)
    displaced = 1025.0 * (hull.volume + shape.ballast / shape.ballast_density)
    assert displaced == pytest.approx(shape.total_mass + 3000.0 / 9.80665, rel=1e-3)
    assert hull.eyes == ((0.0, 0.0, shape.eye),)


def test_generic_drum_by_hand() -> None:
    """A drum of 3.5 m by the formula: heave stiffness, and metacentre with its mass spread."""
    hull = buoy_hull(Floater("mooring buoy 3.5 m"), 20.0, 1025.0, 0.0)
    shape = floating_buoy(Floater("mooring buoy 3.5 m"))
    area = 0.25 * math.pi * shape.hull_diameter**2
    assert hull.stiffness[1, 1] == pytest.approx(1025.0 * 9.80665 * area)
    draught = shape.mass / (1025.0 * area)
    assert hull.draught == pytest.approx(draught)
    assert hull.centre == pytest.approx(0.5 * shape.hull_depth)
    second = math.pi / 64.0 * shape.hull_diameter**4
    righting = 1025.0 * 9.80665 * (second + area * draught * (0.5 * draught - hull.centre))
    assert hull.stiffness[2, 2] == pytest.approx(righting)
    spread = shape.hull_diameter**2 / 16.0 + shape.hull_depth**2 / 12.0
    assert hull.inertia / hull.mass == pytest.approx(spread, rel=1e-6)


def test_what_is_given_is_taken() -> None:
    of = Floater("pillar 2.4 m", centre_of_gravity=0.3, pitch_radius=0.9, pitch_damping=0.05)
    hull = buoy_hull(of, 12.0, 1025.0, 2000.0)
    assert hull.centre == 0.3
    assert hull.inertia == pytest.approx(hull.mass * 0.81)
    # The line's pull at the eye, 1.5 m under the bottom, rights it, too.
    upright = hull.stiffness[2, 2] + 2000.0 * (0.3 + 1.5)
    inertia = hull.inertia + hull.radiation.infinite[2, 2]
    assert hull.damping[2] == pytest.approx(2.0 * 0.05 * math.sqrt(inertia * upright))


def test_wind_is_the_drag_of_what_is_out_of_the_water() -> None:
    of = Floater("pillar 2.4 m", wind_speed=20.0, centre_of_gravity=0.4)
    shape, hull = floating_buoy(of), buoy_hull(of, 12.0, 1025.0, 0.0)
    area = (1.5 - hull.draught) * 2.4 + 3.5 * 1.0 * 0.5 + 0.5
    assert hull.wind[0] == pytest.approx(0.5 * 1.29 * 1.2 * area * 400.0)
    assert shape.deck < hull.wind[1] < shape.deck + 3.5


@pytest.mark.parametrize(
    ("of", "key"),
    [
        (Floater("pillar 2.5 m"), "floater.buoy"),
        (Floater("pillar 2.4 m", centre_of_gravity=2.5), "floater.centre_of_gravity"),
    ],
)
def test_refusals(of: Floater, key: str) -> None:
    with pytest.raises(InputError) as caught:
        buoy_hull(of, 12.0, 1025.0, 1000.0)
    assert [each.key for each in caught.value.problems] == [key]
