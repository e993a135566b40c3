"""Where each limit of an input lies: what is at it is taken, what is beyond it is refused by name.

Limits are those of docs/loads.md and of the messages; what a hull or a wave can be follows from
geometry: a block of a ship fills its box, a buoy may not touch the bed.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import pytest

from catopt.dimensions import Dimension
from catopt.errors import InputError
from catopt.loads import (
    BuoyShape,
    Headings,
    SeaState,
    Ship,
    SurfaceCurrent,
    Turning,
    UfcWind,
    WaterLevels,
    Wind,
    buoy_loads,
    equilibrium_headings,
    estimated_tanker,
    holding_capacity,
    size_drag_anchor,
    size_sinker,
)
from catopt.loads.ship import next_size
from catopt.loads.ship_loads import flat_side_drift
from catopt.loads.tcn_222_95 import tcn_loads
from catopt.loads.ufc import transverse_coefficient
from catopt.loads.weathervane import CurrentYaw
from catopt.model.kinds import Measured, out_of_range

Make = Callable[[float], object]
Limit = tuple[str, Make, float, float]
"""Key in the message, what is made of a number, the last number taken, one that is refused."""

BOX = Ship("box", 100.0, 100.0, 20.0, 5.0, 10e3, 100.0, 800.0, 300.0)
"""It fills length x breadth x draught, 10,000 m3, and breadth x draught amidships, 100 m2."""

TINY = Ship("tiny", 0.05, 0.05, 0.05, 0.05, 1e-9, 1e-9, 1.0, 1.0)

DRUM = BuoyShape("drum", hull_diameter=2.0, hull_depth=2.0, mass=1025.0 * math.pi)
"""It floats at a draught of 1 m."""

LIGHT = replace(DRUM, mass=0.5)
FAR = math.radians(10.0)


def loads(
    chain_diameter: float = 0.0,
    marine_growth: float = 0.0,
    depth: float = 20.0,
    current: float = 1.0,
) -> object:
    return buoy_loads(
        DRUM,
        Wind(0.0),
        SurfaceCurrent(current),
        SeaState(6.0, 0.0),
        WaterLevels.steady(depth),
        chain_diameter=chain_diameter,
        marine_growth=marine_growth,
    )


def drift(depth: float = 20.0, reflection: float = 1.0) -> object:
    sea = SeaState(8.0, 2.0)
    return flat_side_drift(sea, depth, reflection=reflection, water_density=1025.0)


def by_tcn(chi: float) -> object:
    return tcn_loads(
        BOX,
        Wind(0.0),
        SurfaceCurrent(0.0),
        SeaState(8.0, 2.0),
        20.0,
        headings=Headings(),
        wave_coefficient=chi,
        water_density=1025.0,
    )


def moored_at(point: float) -> object:
    return equilibrium_headings(
        BOX,
        Wind(20.0),
        SurfaceCurrent(0.0),
        SeaState(5.0, 0.0),
        20.0,
        Headings(),
        Turning(CurrentYaw(0.0, 0.0), point),
        wind_on="tanker loaded",
    )


def anchored(force: float = 1e3, **how: float) -> object:
    return size_drag_anchor("stockless", "sand", force, **how)  # type: ignore[arg-type]


def sunk(horizontal: float = 1.0, vertical: float = 0.0, **how: float) -> object:
    return size_sinker(horizontal, vertical, **{"friction": 0.5, **how})  # type: ignore[arg-type]


def tanker_of(**size: float) -> Ship:
    usual = {"length": 100.0, "breadth": 20.0, "draught": 5.0, "moulded_depth": 8.0}
    return estimated_tanker("t", **{**usual, **size})  # type: ignore[arg-type]


def shallow(draught: float) -> Ship:
    return replace(BOX, draught=draught, displacement=1e-9, midship_area=1e-9)


def wind_of(**change: float) -> UfcWind:
    return replace(UfcWind(0.9, 0.5, 0.6, 1.5, "single"), **change)  # type: ignore[arg-type]


WEATHER: list[Limit] = [
    ("speed", Wind, 100.0, 100.1),
    ("speed", Wind, 0.0, -0.1),
    ("height", lambda z: Wind(20.0, z), 1e-6, 0.0),
    ("height", lambda z: Wind(20.0).at(z), 1e-6, 0.0),
    ("exponent", lambda n: Wind(20.0).at(5.0, n), 0.5, 0.501),
    ("exponent", lambda n: Wind(20.0).at(5.0, n), 0.0, -0.001),
    ("speed", SurfaceCurrent, 10.0, 10.1),
    ("speed", SurfaceCurrent, 0.0, -0.1),
    ("period", lambda T: SeaState(T, 1.0), 30.0, 30.1),
    ("period", lambda T: SeaState(T, 1.0), 1e-6, 0.0),
    ("significant_height", lambda H: SeaState(8.0, H), 40.0, 40.1),
    ("significant_height", lambda H: SeaState(8.0, H), 0.0, -0.1),
    ("maximum_height", lambda H: SeaState(8.0, None, H), 40.0, 40.1),
    ("maximum_height", lambda H: SeaState(8.0, None, H), 0.0, -0.1),
    ("maximum_height", lambda H: SeaState(8.0, 2.0, H), 2.0, 1.999),
    ("high", lambda d: WaterLevels(5.0, d), 12e3, 12.001e3),
    ("high", lambda d: WaterLevels(5.0, d), 5.0, 4.999),
    ("low", lambda d: WaterLevels(d, 5.0), 1e-6, 0.0),
    ("wind", lambda a: Headings(wind=a), math.pi, 3.1416),
    ("current", lambda a: Headings(current=a), -math.pi, -3.1416),
    ("waves", lambda a: Headings(waves=a), math.pi, 3.1416),
    ("reflection", lambda R: drift(reflection=R), 1.0, 1.001),
    ("reflection", lambda R: drift(reflection=R), 0.0, -0.001),
    ("depth", lambda d: drift(d), 1e-3, 0.0),
    ("wave_coefficient", by_tcn, 1.0, 1.001),
    ("wave_coefficient", by_tcn, 0.0, -0.001),
]

SHIPS: list[Limit] = [
    ("length_overall", lambda L: replace(BOX, length_overall=L), 600.0, 600.1),
    ("length_overall", lambda L: replace(TINY, length_overall=L), 0.05, 0.0),
    (
        "length_waterline",
        lambda L: replace(BOX, length_overall=600.0, length_waterline=L),
        600.0,
        600.1,
    ),
    ("length_waterline", lambda L: replace(BOX, length_waterline=L), 100.0, 100.1),
    ("length_waterline", lambda L: replace(TINY, length_waterline=L), 0.05, 0.0),
    ("breadth", lambda B: replace(BOX, breadth=B), 100.0, 100.1),
    ("breadth", lambda B: replace(TINY, breadth=B), 0.05, 0.0),
    ("draught", lambda T: replace(BOX, breadth=100.0, draught=T), 100.0, 100.1),
    ("draught", lambda T: replace(BOX, draught=T), 20.0, 20.1),
    ("draught", shallow, 0.01, 0.0),
    ("displacement", lambda V: replace(BOX, displacement=V), 10e3, 10.001e3),
    ("displacement", lambda V: replace(BOX, displacement=V), 1e-6, 0.0),
    ("midship_area", lambda A: replace(BOX, midship_area=A), 100.0, 100.1),
    ("midship_area", lambda A: replace(BOX, midship_area=A), 1e-6, 0.0),
    ("lateral_area", lambda A: replace(BOX, lateral_area=A), 1e-6, 0.0),
    ("frontal_area", lambda A: replace(BOX, frontal_area=A), 1e-6, 0.0),
    ("lateral_centre", lambda x: replace(BOX, lateral_centre=x), 50.0, 50.1),
    ("lateral_centre", lambda x: replace(BOX, lateral_centre=x), -50.0, -50.1),
    ("draught", BOX.check_afloat, 5.001, 5.0),
    ("depth", shallow(0.01).check_afloat, 0.05, 0.0),
    ("mooring_point", moored_at, 50.0, 50.1),
    (
        "moulded_depth",
        lambda D: estimated_tanker("t", 100.0, 20.0, 5.0, moulded_depth=D),
        5.001,
        5.0,
    ),
    ("length_overall", lambda L: tanker_of(length=L, lateral_area=1.0), 0.05, 0.0),
    ("breadth", lambda B: tanker_of(breadth=B, draught=0.05), 0.05, 0.0),
    ("draught", lambda T: tanker_of(draught=T), 0.05, 0.0),
    ("moulded_depth", lambda D: tanker_of(draught=0.05, moulded_depth=D), 0.06, 0.0),
    ("T/d", lambda r: transverse_coefficient(r, 0.8), 1.0, 1.001),
    ("T/d", lambda r: transverse_coefficient(r, 0.8), 0.0, -0.001),
    ("C0", lambda C: transverse_coefficient(0.5, C), 3.2, 3.201),
    ("C0", lambda C: transverse_coefficient(0.5, C), 1e-6, 0.0),
    ("K", lambda K: transverse_coefficient(0.5, 0.8, exponent=K), 1e-6, 0.0),
    ("transverse", lambda C: wind_of(transverse=C), 3.0, 3.01),
    ("transverse", lambda C: wind_of(transverse=C), 1e-6, 0.0),
    ("from_ahead", lambda C: wind_of(from_ahead=C), 3.0, 3.01),
    ("from_astern", lambda C: wind_of(from_astern=C), 3.0, 3.01),
    ("zero_angle", lambda a: wind_of(zero_angle=a), 3.14159, math.pi),
    ("zero_angle", lambda a: wind_of(zero_angle=a), 1e-6, 0.0),
]

BUOYS: list[Limit] = [
    ("hull_diameter", lambda D: replace(LIGHT, hull_diameter=D), 30.0, 30.1),
    ("hull_diameter", lambda D: replace(LIGHT, hull_diameter=D), 0.1, 0.099),
    ("hull_depth", lambda D: replace(LIGHT, hull_depth=D), 60.0, 60.1),
    ("hull_depth", lambda D: replace(LIGHT, hull_depth=D), 0.1, 0.099),
    ("mass", lambda m: replace(DRUM, hull_diameter=30.0, hull_depth=60.0, mass=m), 1e7, 1.001e7),
    ("mass", lambda m: replace(DRUM, mass=m), 1e-3, 0.0),
    ("least_freeboard", lambda f: replace(DRUM, least_freeboard=f), 0.0, -0.01),
    ("tower_height", lambda h: replace(DRUM, tower_height=h), 0.0, -0.01),
    ("tower_solidity", lambda s: replace(DRUM, tower_solidity=s), 1.0, 1.001),
    ("tower_solidity", lambda s: replace(DRUM, tower_solidity=s), 0.0, -0.001),
    ("topmark_area", lambda A: replace(DRUM, topmark_area=A), 0.0, -0.01),
    ("tube_length", lambda t: replace(DRUM, tube_diameter=0.1, tube_length=t), 60.0, 60.1),
    ("tube_length", lambda t: replace(DRUM, tube_diameter=0.1, tube_length=t), 0.0, -0.01),
    ("tube_diameter", lambda D: replace(DRUM, tube_diameter=D, tube_length=0.1), 2.0, 2.001),
    # a tube of 1 m displaces pi/4 of the hull's pi m3 for each metre: 4 m lift it out of the water
    ("mass", lambda t: replace(DRUM, tube_diameter=1.0, tube_length=t), 3.99, 4.01),
    # the draught of the drum is 1 m, so that a freeboard of 1 m is all it has
    ("mass", lambda f: replace(DRUM, least_freeboard=f), 0.999, 1.001),
    ("pull", DRUM.afloat, 0.0, -1.0),
    ("water_density", lambda rho: DRUM.afloat(0.0, rho), 900.0, 899.0),
    ("water_density", lambda rho: DRUM.afloat(0.0, rho), 1100.0, 1101.0),
    ("chain_diameter", lambda d: loads(chain_diameter=d), 0.2, 0.201),
    ("chain_diameter", lambda d: loads(chain_diameter=d), 0.0, -0.001),
    ("marine_growth", lambda t: loads(marine_growth=t), 0.5, 0.501),
    ("marine_growth", lambda t: loads(marine_growth=t), 0.0, -0.001),
    ("levels.high", lambda d: loads(depth=d), 200.0, 200.1),
    ("levels.low", lambda d: loads(depth=d), 1.001, DRUM.afloat().keel_depth),
    ("current.speed", lambda V: loads(current=V), 7.0, 7.01),
]

ANCHORS: list[Limit] = [
    ("mass", lambda m: holding_capacity("stockless", "sand", m), 16443.0, 16444.0),
    ("mass", lambda m: holding_capacity("stockless", "sand", m), 136.0, 135.9),
    ("uplift_limit", lambda a: anchored(uplift_limit=a), FAR, 1.001 * FAR),
    ("uplift_limit", lambda a: anchored(uplift_limit=a), 0.0, -0.001),
    ("uplift_angle", lambda a: anchored(uplift_angle=a), 0.0, -0.001),
    ("uplift_angle", lambda a: anchored(uplift_angle=a, uplift_limit=FAR), FAR, -FAR),
    ("safety_factor", lambda f: anchored(safety_factor=f), 1.0, 0.999),
    ("horizontal_force", anchored, 0.0, -1.0),
    ("series[0]", lambda m: next_size(1.0, (m, 2.0), "x"), 0.05, 0.0),
    ("horizontal_force", sunk, 0.0, -1.0),
    ("vertical_force", lambda V: sunk(1.0, V), 0.0, -1.0),
    ("safety_factor", lambda f: sunk(safety_factor=f), 1.0, 0.999),
    ("friction", lambda mu: sunk(friction=mu), 1.5, 1.501),
    ("friction", lambda mu: sunk(friction=mu), 1e-3, 0.0),
    ("density", lambda rho: sunk(density=rho), 20e3, 20.1e3),
    ("density", lambda rho: sunk(density=rho), 1026.0, 1025.0),
    ("water_density", lambda rho: sunk(water_density=rho), 900.0, 899.0),
    ("water_density", lambda rho: sunk(water_density=rho), 1100.0, 1101.0),
]


@pytest.mark.parametrize(("key", "make", "taken", "refused"), [*WEATHER, *SHIPS, *BUOYS, *ANCHORS])
def test_what_is_at_a_limit_is_taken_and_what_is_beyond_it_is_not(
    key: str, make: Make, taken: float, refused: float
) -> None:
    make(taken)
    with pytest.raises(InputError) as caught:
        make(refused)
    assert {each.key for each in caught.value.problems} == {key}


def test_a_size_that_rounding_makes_too_small_is_still_enough() -> None:
    """A part in 1e9 is what solving a line may be wrong by; two of them are not."""
    assert next_size(2.0 * (1.0 + 0.5e-9), (1.0, 2.0, 3.0), "x") == 2.0
    assert next_size(2.0 * (1.0 + 2e-9), (1.0, 2.0, 3.0), "x") == 3.0


def test_a_barge_fills_its_box_whatever_its_dimensions() -> None:
    """L (B T) and (L B) T differ in the last digit for one barge in eight; both are its volume."""
    tenths = [(200 + 7 * k, 40 + 3 * k, 10 + k) for k in range(200)]
    for length, breadth, draught in ((a / 10.0, b / 10.0, c / 10.0) for a, b, c in tenths):
        barge = tanker_of(
            length=length,
            breadth=breadth,
            draught=draught,
            moulded_depth=2.0 * draught,
            is_square_ended=True,
        )
        assert barge.displacement == pytest.approx(length * breadth * draught, rel=1e-14)


@pytest.mark.parametrize("most", [0.1 * 3.0, math.pi / 2.0, 1e-9, 7e5])
def test_rounding_breaks_no_bound_and_more_than_it_does(most: float) -> None:
    for times, is_beyond in ((1.0, False), (1.0 + 4e-16, False), (1.0 + 1e-9, True)):
        assert bool(out_of_range(most * times, "m", None, None, most)) == is_beyond
        assert bool(out_of_range(-most * times, "m", None, -most, None)) == is_beyond
        assert Measured(Dimension.LENGTH, at_most=most).allows(most * times) == (not is_beyond)
    assert out_of_range(math.nan, "m", None, None, most)
    assert out_of_range(-5e-324, "m", None, 0.0, None)  # nothing but a number below 0 is below it
