"""Buoys of the library as hulls: what they displace, how they swing, and what is refused."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from catopt.errors import InputError
from catopt.floater import hulls
from catopt.floater.hulls import _radiation, _rigid, buoy_hull, floating_buoy
from catopt.hydro import build
from catopt.hydro.build import Radiation
from catopt.hydro.cylinder import FloatingCylinder
from catopt.loads.buoy_heel import slices_of
from catopt.model import Floater, HullAfloat


@pytest.fixture(autouse=True)
def few_frequencies(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Nothing here hangs on how finely radiation is tabulated: four frequencies of sixty."""
    monkeypatch.setattr(build, "_COUNT", 4)
    hulls._hull.cache_clear()
    yield
    hulls._hull.cache_clear()


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


def test_inertia_of_a_tower_buoy_is_summed_over_its_slices() -> None:
    """Discs of the buoy's shape, each with R^2/4 + h^2/12 about itself, and the ballast."""
    of = Floater("T-5000l-2.4m")
    shape, hull = floating_buoy(of), buoy_hull(of, 15.0, 1025.0, 3000.0)
    discs = slices_of(shape)
    volume = math.fsum(each.volume for each in discs)
    centre, own = hull.centre, 0.0
    for each in discs:
        long = each.top - each.foot
        square = each.volume / (math.pi * long)
        about = 0.25 * square + long**2 / 12.0 + (0.5 * (each.foot + each.top) - centre) ** 2
        own += shape.mass * each.volume / volume * about
    own += shape.ballast * (shape.lowest - centre) ** 2
    assert hull.inertia == pytest.approx(own)
    assert hull.mass == shape.mass + shape.ballast
    assert hull.constant[1] == pytest.approx(
        1025.0 * 9.80665 * shape.ballast / shape.ballast_density
    )


def test_drag_of_a_drum_by_hand() -> None:
    """0.5 rho C D across each slice; 0.5 rho C of the widest disc along the axis."""
    of = Floater("mooring buoy 3.5 m", heave_drag=1.3)
    shape, hull = floating_buoy(of), buoy_hull(of, 20.0, 1025.0, 0.0)
    assert hull.drag == pytest.approx(
        np.full(hull.foot.size, 0.5 * 1025.0 * shape.drag_in_water * shape.hull_diameter)
    )
    face = 0.25 * math.pi * shape.hull_diameter**2
    assert hull.bottom_drag == pytest.approx(0.5 * 1025.0 * 1.3 * face)
    assert hull.bottom_radius == 0.5 * shape.hull_diameter


def test_a_pull_beyond_its_buoyancy_is_carried_to_nine_tenths() -> None:
    """Where its radiation is found: at the draught of 0.9 of its reserve, whatever the pull."""
    of = Floater("mooring buoy 3.5 m", centre_of_gravity=0.3)
    shape = floating_buoy(of)
    reserve = shape.reserve_buoyancy(1025.0)
    area = 0.25 * math.pi * shape.hull_diameter**2
    hull = buoy_hull(of, 20.0, 1025.0, 5.0 * reserve)
    displaced = shape.mass + 0.9 * reserve / 9.80665
    assert hull.draught == pytest.approx(displaced / (1025.0 * area))
    assert buoy_hull(of, 20.0, 1025.0, -100.0).draught == pytest.approx(shape.mass / 1025.0 / area)


def test_what_hangs_below_a_hull_adds_what_it_displaces() -> None:
    """A tube under a drum: rho V across it, by strips about the centre of gravity, by hand.

    In the wave it is pushed by what it displaces, once more than the pressure does.
    """
    of = Floater("T-5000l-2.4m")
    hull, slices = _rigid(of, 1025.0, 3000.0, floating_buoy(of))
    assert slices.below.any()
    whole = _radiation(hull, slices, 15.0)
    volume = slices.volume * (slices.below > 0.0)
    drum = np.clip((hull.draught - slices.foot) / (slices.top - slices.foot), 0.0, 1.0)
    floats = float((slices.volume * drum).sum() - volume.sum())
    # The drum's own by a cylinder that floats as deep as the drum displaces.
    radius = math.sqrt(hull.waterplane[0] / math.pi)
    cylinder = FloatingCylinder(
        radius, floats / hull.waterplane[0], 15.0, hull.centre - hull.draught, 1025.0, hull.gravity
    )
    own = Radiation.of_cylinder(cylinder)
    arm = 0.5 * (slices.foot + slices.top) - hull.centre
    mass = 1025.0 * volume
    more = whole.infinite - own.infinite
    assert more[0, 0] == pytest.approx(mass.sum())
    assert more[0, 2] == pytest.approx(mass @ arm)
    assert more[2, 2] == pytest.approx(mass @ arm**2)
    assert whole.added_mass - own.added_mass == pytest.approx(np.broadcast_to(more, (4, 3, 3)))
    assert whole.excitation is not None
    assert own.excitation is not None
    # Airy's acceleration at the middle of each slice, -i omega^2 cosh k(z + d)/sinh kd.
    omega = own.omega[1]
    k = omega**2 / 9.80665
    for _ in range(200):
        k = omega**2 / (9.80665 * math.tanh(k * 15.0))
    z = arm + hull.centre - hull.draught
    along = -1j * omega**2 * np.cosh(k * (z + 15.0)) / math.sinh(k * 15.0)
    pushed = whole.excitation[1] - own.excitation[1]
    assert pushed[0] == pytest.approx(along @ mass)
    assert pushed[2] == pytest.approx(along @ (mass * arm))
    assert pushed[1] == 0.0


@pytest.mark.parametrize("name", ["hull.h5", "hull.dat", "hull.mat"])
@pytest.mark.parametrize("is_there", [True, False])
def test_coefficients_of_another_program_are_refused(
    tmp_path: Path, name: str, is_there: bool
) -> None:
    """What no reader knows is named whether it is there or not; an unknown stem may be WAMIT's."""
    if is_there:
        (tmp_path / name).write_text("1 2 3")
    of = HullAfloat(str(tmp_path / name), 1e6, (0.0, 0.0, 0.0), (1.0, 1.0, 1.0), 1.0)
    with pytest.raises(InputError) as caught:
        hulls._read(of, 1025.0)
    known = not is_there and name == "hull.dat"
    assert caught.value.problems[0].key == ("files" if known else "floater.hull.file")


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
