"""Drag of a stream on an area: 1/2 rho C A V^2."""

from __future__ import annotations

from typing import Literal

from catopt.loads.component import Axis, LoadComponent, Number
from catopt.loads.source import LoadSource
from catopt.words import Message


def pressure(density: float, speed: float) -> float:
    """Stagnation pressure 1/2 rho V^2, Pa, of kg/m3 and m/s."""
    return 0.5 * density * speed * speed


def drag(density: float, speed: float, area: float, coefficient: float) -> float:
    """Drag 1/2 rho C A V^2, N, of kg/m3, m/s and m2, which the coefficient is referred to."""
    return pressure(density, speed) * coefficient * area


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
