"""Environmental forces on a buoy or a ship, and the anchors and sinkers that hold them.

Every force comes with its formula, the numbers put in and its source. Confidence is A (read in the
primary document), B (in two secondary ones, or in one and checked by numbers), C (in one secondary
one) or R (recalled, read in none: used only when asked for, or where nothing else is there).
"""

from typing import Any
from warnings import warn

from catopt.loads.buoy import buoy, buoy_loads, buoys, read_buoys, surface_speed
from catopt.loads.buoy_shape import BuoyShape, BuoySlice, Floating
from catopt.loads.calmar_file import read_calmar_buoy
from catopt.loads.component import LoadComponent, Loads, LoadSource, Number
from catopt.loads.drag_anchor import (
    DragAnchorSize,
    HoldingCapacity,
    LayingCheck,
    holding_capacity,
    laying_check,
    size_drag_anchor,
)
from catopt.loads.environment import HEAD_ON, Headings, SeaState, SurfaceCurrent, WaterLevels, Wind
from catopt.loads.ship import Ship, estimated_tanker
from catopt.loads.ship_coefficients import (
    ShipCoefficients,
    parse_ship_coefficients,
    read_ship_coefficients,
)
from catopt.loads.ship_loads import METHODS, every_method, governing_loads, ship_loads
from catopt.loads.sinker import SinkerSize, size_sinker
from catopt.loads.tanker_20m import TankerComparison, compare_tanker
from catopt.loads.ufc import UfcWind
from catopt.loads.weathervane import (
    YAW_TYPES,
    Afloat,
    CurrentYaw,
    ShipHeading,
    Turning,
    equilibrium_headings,
    every_lying,
)

__all__ = [
    "HEAD_ON",
    "METHODS",
    "YAW_TYPES",
    "Afloat",
    "BuoyShape",
    "BuoySlice",
    "CurrentYaw",
    "DragAnchorSize",
    "Floating",
    "Headings",
    "HoldingCapacity",
    "LayingCheck",
    "LoadComponent",
    "LoadSource",
    "Loads",
    "Number",
    "SeaState",
    "Ship",
    "ShipCoefficients",
    "ShipHeading",
    "SinkerSize",
    "SurfaceCurrent",
    "TankerComparison",
    "Turning",
    "UfcWind",
    "WaterLevels",
    "Wind",
    "buoy",
    "buoy_loads",
    "buoys",
    "compare_tanker",
    "equilibrium_headings",
    "estimated_tanker",
    "every_lying",
    "every_method",
    "governing_loads",
    "holding_capacity",
    "laying_check",
    "parse_ship_coefficients",
    "read_buoys",
    "read_calmar_buoy",
    "read_ship_coefficients",
    "ship_loads",
    "size_drag_anchor",
    "size_sinker",
    "surface_speed",
]


def __getattr__(name: str) -> Any:
    """Give what has another name now by its old one, for one version."""
    if name == "Lying":
        warn("catopt.loads.Lying is ShipHeading now", DeprecationWarning, stacklevel=2)
        return ShipHeading
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
