"""From buoy or ship, depth and weather to a mooring: loads, then a case, then the design search.

Nothing is computed here that the parts below do not compute: `catopt.loads` gives the forces, the
case that is made of them goes to `catopt.design`, and what comes out is put together for a reader.
What a sizing may be told stands in one table, `catopt.sizing.inputs`, which costs nothing to load.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from catopt.sizing.buoy_request import BuoyRequest as BuoyRequest
    from catopt.sizing.buoy_request import GivenBuoy as GivenBuoy
    from catopt.sizing.environment import Environment as Environment
    from catopt.sizing.file import read_sizing as read_sizing
    from catopt.sizing.keywords import size_buoy as size_buoy
    from catopt.sizing.keywords import size_tanker as size_tanker
    from catopt.sizing.line_choice import LineChoice as LineChoice
    from catopt.sizing.pattern import DragGround as DragGround
    from catopt.sizing.pattern import SinkerGround as SinkerGround
    from catopt.sizing.result import Sizing as Sizing
    from catopt.sizing.tanker_request import MooredShip as MooredShip
    from catopt.sizing.tanker_request import TankerRequest as TankerRequest

_HOMES = {
    "buoy_request": ("BuoyRequest", "GivenBuoy"),
    "environment": ("Environment",),
    "file": ("read_sizing",),
    "keywords": ("size_buoy", "size_tanker"),
    "line_choice": ("LineChoice",),
    "pattern": ("DragGround", "SinkerGround"),
    "result": ("Sizing",),
    "tanker_request": ("MooredShip", "TankerRequest"),
}
_HOME_OF = {name: home for home, names in _HOMES.items() for name in names}
__all__ = sorted(_HOME_OF)


if not TYPE_CHECKING:  # so that a type checker still finds a misspelt name

    def __getattr__(name: str) -> Any:
        """Load a name on first use (PEP 562)."""
        if name not in _HOME_OF:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        return getattr(import_module(f"{__name__}.{_HOME_OF[name]}"), name)
