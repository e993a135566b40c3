"""Sizings to lay out."""

from __future__ import annotations

from functools import cache

from catopt.loads import (
    SeaState,
    SurfaceCurrent,
    WaterLevels,
    Wind,
    buoy,
    estimated_tanker,
)
from catopt.sizing import (
    BuoyRequest,
    Environment,
    GivenBuoy,
    MooredShip,
    Sizing,
    TankerRequest,
    size_buoy,
    size_tanker,
)


def _place(low: float, high: float) -> Environment:
    return Environment(WaterLevels(low, high), Wind(20.0), SurfaceCurrent(1.2), SeaState(8.0, 2.0))


@cache
def around() -> Sizing:
    """Size the lines around a mooring buoy to which a tanker is tied, held by drag anchors."""
    ship = estimated_tanker("tanker", 120.0, 18.0, 7.0, moulded_depth=9.0)
    moored = MooredShip("loaded", ship, "tanker loaded", 3.0)
    body = buoy("mooring buoy 5.0 m")
    return size_tanker(
        TankerRequest((moored,), _place(20.0, 22.0), buoy=body, hawser=50.0, lines=4)
    )


@cache
def by_force() -> Sizing:
    """Size the line of a buoy whose horizontal force is given, held by a sinker."""
    return size_buoy(BuoyRequest(GivenBuoy(3363.7, 12e3), _place(9.5, 9.5)))
