"""Drag of a stream on an area: 1/2 rho C A V^2."""

from __future__ import annotations

from typing import Literal

from catopt.loads.component import Axis, LoadComponent, Number
from catopt.loads.environment import Wind
from catopt.loads.ship import Ship
from catopt.loads.source import LoadSource
from catopt.words import Message


def drag(density: float, speed: float, area: float, coefficient: float) -> float:
    """Drag 1/2 rho C A V^2, N, of kg/m3, m/s and m2, which the coefficient is referred to."""
    return 0.5 * density * speed * speed * coefficient * area


def drag_component(
    name: str,
    kind: Literal["wind", "current"],
    stream: tuple[float, float],
    area: Number,
    coefficient: Number,
    source: LoadSource,
    *,
    axis: Axis = "along",
    sign: float = 1.0,
    note: str = "",
) -> LoadComponent:
    """Make the component of a drag.

    The stream is its density, kg/m3, and its speed, m/s; the coefficient is referred to the area,
    m2; the sign is that of the force along its axis. The rest is as of `LoadComponent`.
    """
    density, speed = stream
    force = sign * drag(density, speed, area.value, coefficient.value)
    medium = "loads.air_density" if kind == "wind" else "loads.water_density"
    numbers = (
        Number("rho", density, "kg/m3", Message(medium)),
        Number("V", speed, "m/s", Message("loads.speed")),
        area,
        coefficient,
    )
    factors = ("1/2", "{rho}", "{V:2}", f"{{{area.symbol}}}", f"{{{coefficient.symbol}}}")
    return LoadComponent(name, kind, axis, factors, numbers, force, source, note)


Referred = tuple[str, str, float, LoadSource]
"""Symbols of an area and of its coefficient, the coefficient itself and where it comes from."""


def wind_on_ship(
    ship: Ship, wind: Wind, air_density: float, along: Referred, across: Referred, note: str
) -> tuple[LoadComponent, LoadComponent]:
    """Make the wind along a ship, on its frontal area, and across it, on the lateral one."""

    def component(name: str, axis: Axis, area: float, meaning: str, of: Referred) -> LoadComponent:
        symbol, letter, coefficient, source = of
        return drag_component(
            Message(name),
            "wind",
            (air_density, wind.speed),
            Number(symbol, area, "m2", Message(meaning)),
            Number(letter, coefficient, "", Message("loads.coefficient_here")),
            source,
            axis=axis,
            note=note,
        )

    frontal, lateral = ship.frontal_area, ship.lateral_area
    return (
        component("loads.wind_along", "surge", frontal, "loads.frontal_area", along),
        component("loads.wind_across", "sway", lateral, "loads.lateral_area", across),
    )
