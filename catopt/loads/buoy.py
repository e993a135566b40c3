"""Horizontal force on a buoy and its chain, after IALA's CALMAR technical reference."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final, Literal, get_args

from catopt.constants import SEA_WATER_DENSITY
from catopt.loads.buoy_shape import BuoyShape, Floating
from catopt.loads.component import LoadComponent, Loads, Number
from catopt.loads.drag import drag_component
from catopt.loads.environment import SeaState, SurfaceCurrent, WaterLevels, Wind
from catopt.loads.source import CALMAR, LoadSource
from catopt.model.validity import Findings
from catopt.words import Measure, Message, Several, term

AIR_DENSITY: Final = 1.29
"""kg/m3; CALMAR prints "129", a misprint."""

DRAG_COEFFICIENT: Final = 1.2
"""Of hull in water, hull in air, pylon, topmark and chain (CALMAR, A)."""

CHAIN_WIDTH: Final = 2.65
"""Width of a chain as the current sees it, in nominal diameters (CALMAR 5.2.1, A)."""

DEEPEST: Final = 200.0
"""m: the limit that CALMAR states."""

FASTEST: Final = 7.0
"""m/s: the limit that CALMAR states for the current."""

ChainSpeed = Literal["surface", "current"]

_FORCES = LoadSource(CALMAR, "section 5", "A")
_CHAIN = LoadSource(CALMAR, "5.2.1", "A")
_GROWTH = "loads.growth"


def surface_speed(wind: Wind, current: SurfaceCurrent, sea: SeaState, depth: float) -> float:
    """Speed of the water at the surface, m/s: tide + 0.015 wind + wave (CALMAR, A).

    Parameters
    ----------
    wind, current, sea : Wind, SurfaceCurrent, SeaState
        All from one side.
    depth : float
        Of the water, m.
    """
    from catopt.waves.current import wind_driven_speed

    driven = wind_driven_speed(wind.speed, "CALMAR")
    return current.speed + driven + sea.surface_velocity(depth)


def buoy_loads(
    shape: BuoyShape,
    wind: Wind,
    current: SurfaceCurrent,
    sea: SeaState,
    levels: WaterLevels,
    *,
    chain_diameter: float,
    pull: float = 0.0,
    marine_growth: float = 0.0,
    chain_speed: ChainSpeed = "surface",
    water_density: float = SEA_WATER_DENSITY,
) -> Loads:
    """Add up the forces of wind, current and waves on a buoy and its chain.

    Parameters
    ----------
    shape : BuoyShape
        The buoy.
    wind, current, sea : Wind, SurfaceCurrent, SeaState
        All from one side, at the same time.
    levels : WaterLevels
        The waves and the height of the chain are those of high water.
    chain_diameter : float
        Nominal, m; 0 leaves the chain out.
    pull : float
        Vertical, of the line on the buoy, N: it adds to the draught.
    marine_growth : float
        Thickness on hull and chain, m. CALMAR has none; the rule D + 2 t is catopt's own.
    chain_speed : {"surface", "current"}
        Speed of the water at the chain, over its whole height: that at the surface, on the safe
        side, or that of tide and wind alone. CALMAR's own choice was not read.
    water_density : float
        kg/m3.

    Returns
    -------
    Loads
        All along one direction. Static: no motion of the buoy, no vortex shedding.

    Raises
    ------
    InputError
        Deeper than 200 m, faster than 7 m/s, a pull above the reserve buoyancy, a draught deeper
        than the water.
    """
    _check(current, levels, chain_diameter, marine_growth, chain_speed)
    floating = shape.afloat(pull, water_density)
    _check_afloat(floating, levels)
    steady = surface_speed(wind, current, SeaState(sea.period, 0.0), levels.high)
    speed = surface_speed(wind, current, sea, levels.high)
    at_chain = speed if chain_speed == "surface" else steady
    water, air = (water_density, speed), (AIR_DENSITY, wind.speed)
    components = [
        *_hull(floating, water, air, marine_growth),
        *_superstructure(shape, air),
    ]
    if chain_diameter > 0.0:
        height = levels.deepest(sea) - floating.keel_depth
        components.append(_chain((water_density, at_chain), chain_diameter, height, marine_growth))
    return Loads(
        Message(
            "loads.buoy_in",
            buoy=shape.name,
            wind=wind.speed,
            tide=current.speed,
            height=sea.hmax,
        ),
        tuple(components),
        (*_assumptions(wind, current, sea, levels, speed), _afloat(floating)),
        _warnings(sea, levels),
        "IALA-CALMAR",
    )


def _hull(
    floating: Floating, water: tuple[float, float], air: tuple[float, float], growth: float
) -> Iterator[LoadComponent]:
    wet = Number("A", floating.hull_area_in_water(growth), "m2", Message("loads.hull_in_water"))
    dry = Number("A", floating.hull_area_in_air, "m2", Message("loads.hull_in_air"))
    note = Message(_GROWTH) if growth > 0.0 else ""
    current, wind = Message("loads.current_on_hull"), Message("loads.wind_on_hull")
    yield drag_component(current, "current", water, wet, _cd(), _FORCES, note=note)
    yield drag_component(wind, "wind", air, dry, _cd(), _FORCES)


def _superstructure(shape: BuoyShape, air: tuple[float, float]) -> Iterator[LoadComponent]:
    parts = (
        (shape.tower_area, "loads.wind_on_tower", "loads.tower"),
        (shape.topmark_area, "loads.wind_on_topmark", "loads.topmark"),
    )
    for area, name, meaning in parts:
        if area > 0.0:
            number = Number("A", area, "m2", Message(meaning))
            yield drag_component(Message(name), "wind", air, number, _cd(), _FORCES)


def _chain(
    water: tuple[float, float], diameter: float, height: float, growth: float
) -> LoadComponent:
    width = CHAIN_WIDTH * diameter + 2.0 * growth
    area = Number("A", width * height, "m2", Message("loads.chain_area"))
    notes = [Message("loads.chain_note", diameter=diameter * 1e3, height=height)]
    if growth > 0.0:
        notes.append(Message(_GROWTH))
    name, note = Message("loads.current_on_chain"), Several(notes)
    return drag_component(name, "current", water, area, _cd(), _CHAIN, note=note)


def _cd() -> Number:
    return Number("Cd", DRAG_COEFFICIENT, "", Message("loads.drag_coefficient"))


def _check(
    current: SurfaceCurrent, levels: WaterLevels, diameter: float, growth: float, at: str
) -> None:
    found = Findings("buoy loads")
    found.number("chain_diameter", diameter, "m", at_least=0.0, at_most=0.2)
    found.number("marine_growth", growth, "m", at_least=0.0, at_most=0.5)
    if at not in get_args(ChainSpeed):
        found.add("chain_speed", repr(at), "one of " + ", ".join(get_args(ChainSpeed)))
    if levels.high > DEEPEST:
        found.add(
            "levels.high", f"{levels.high:g} m", f"CALMAR holds down to {DEEPEST:g} m of water"
        )
    if current.speed > FASTEST:
        found.add("current.speed", f"{current.speed:g} m/s", f"CALMAR holds up to {FASTEST:g} m/s")
    found.raise_if_any()


def _check_afloat(floating: Floating, levels: WaterLevels) -> None:
    if floating.keel_depth >= levels.low:
        found = Findings("buoy loads")
        found.add(
            "levels.low",
            f"{levels.low:g} m",
            f"the buoy reaches {floating.keel_depth:.2f} m below the water: it would touch the bed",
        )
        found.raise_if_any()


def _assumptions(
    wind: Wind, current: SurfaceCurrent, sea: SeaState, levels: WaterLevels, speed: float
) -> tuple[str, ...]:
    orbital = sea.surface_velocity(levels.high)
    driven = speed - current.speed - orbital
    return (
        Message("loads.one_side"),
        Message(
            "loads.surface_speed",
            speed=speed,
            tide=current.speed,
            wind=wind.speed,
            driven=driven,
            orbital=orbital,
            depth=levels.high,
        ),
    )


def _afloat(floating: Floating) -> str:
    reserve = floating.shape.reserve_buoyancy(floating.water_density)
    return Message(
        "loads.afloat",
        pull=Measure("vertical_force", floating.pull),
        draught=floating.draught,
        freeboard=floating.freeboard,
        reserve=Measure("vertical_force", reserve),
        origin=term(floating.shape.origin),
    )


def _warnings(sea: SeaState, levels: WaterLevels) -> tuple[str, ...]:
    limit = sea.breaking_height(levels.high)
    if sea.hmax <= limit:
        return ()
    values = {"height": sea.hmax, "depth": levels.high, "period": sea.period, "limit": limit}
    return (Message("loads.breaks", **values),)
