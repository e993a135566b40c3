"""Drag of a stream on an area: 1/2 rho C A V^2."""

from __future__ import annotations

from typing import Literal

from catopt.loads.component import Axis, LoadComponent, Number
from catopt.loads.source import LoadSource
from catopt.words import Message

__all__ = ["drag", "drag_component", "pressure"]


def pressure(density: float, speed: float) -> float:
    """Stagnation pressure 1/2 rho V^2, Pa.

    Parameters
    ----------
    density : float
        kg/m3.
    speed : float
        m/s.
    """
    return 0.5 * density * speed * speed


def drag(density: float, speed: float, area: float, coefficient: float) -> float:
    """Drag 1/2 rho C A V^2, N.

    Parameters
    ----------
    density : float
        kg/m3.
    speed : float
        m/s.
    area : float
        m2.
    coefficient : float
        Referred to that area.
    """
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

    Parameters
    ----------
    name, kind, source, axis, note
        As of `LoadComponent`.
    stream : tuple of float
        Density, kg/m3, and speed, m/s.
    area, coefficient : Number
        m2, and what is referred to it.
    sign : float
        1 or -1: the force along its axis.
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
