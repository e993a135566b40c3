"""From buoy or ship, depth and weather to a mooring: loads, then a case, then the design search.

Nothing is computed here that the parts below do not compute: `catopt.loads` gives the forces, the
case that is made of them goes to `catopt.design`, and what comes out is put together for a reader.
"""

from catopt.sizing.anchorage import DragGround, SinkerGround
from catopt.sizing.buoy import size_buoy
from catopt.sizing.buoy_request import BuoyRequest, GivenBuoy
from catopt.sizing.environment import Environment
from catopt.sizing.line_choice import LineChoice
from catopt.sizing.result import Sizing
from catopt.sizing.tanker import size_tanker
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
    "size_buoy",
    "size_tanker",
]
