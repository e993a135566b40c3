"""From buoy or ship, depth and weather to a mooring: loads, then a case, then the design search.

Nothing is computed here that the parts below do not compute: `catopt.loads` gives the forces, the
case that is made of them goes to `catopt.design`, and what comes out is put together for a reader.
What a sizing may be told stands in one table, `catopt.sizing.inputs`, which costs nothing to load.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from catopt.sizing.anchorage import DragGround, SinkerGround
    from catopt.sizing.buoy_request import BuoyRequest, GivenBuoy
    from catopt.sizing.environment import Environment
    from catopt.sizing.file import read_sizing
    from catopt.sizing.keywords import size_buoy, size_tanker
    from catopt.sizing.line_choice import LineChoice
    from catopt.sizing.result import Sizing
    from catopt.sizing.tanker_request import MooredShip, TankerRequest

__all__ = [
    "BuoyRequest",
    "DragGround",
    "Environment",
    "GivenBuoy",
    "LineChoice",
    "MooredShip",
    "SinkerGround",
    "Sizing",
    "TankerRequest",
    "read_sizing",
    "size_buoy",
    "size_tanker",
]

_HOMES = {
    "anchorage": ("DragGround", "SinkerGround"),
    "buoy_request": ("BuoyRequest", "GivenBuoy"),
    "environment": ("Environment",),
    "file": ("read_sizing",),
    "keywords": ("size_buoy", "size_tanker"),
    "line_choice": ("LineChoice",),
    "result": ("Sizing",),
    "tanker_request": ("MooredShip", "TankerRequest"),
}
_HOME_OF = {name: home for home, names in _HOMES.items() for name in names}


if not TYPE_CHECKING:  # so that a type checker still finds a misspelt name

    def __getattr__(name: str) -> Any:
        """Load a name on first use (PEP 562)."""
        if name not in _HOME_OF:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        return getattr(import_module(f"{__name__}.{_HOME_OF[name]}"), name)
