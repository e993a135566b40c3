"""What is moored, as frozen values in SI: no input, no output, no solving."""

from catopt.model.case import Case, Checks, SwarmSettings
from catopt.model.find import Find
from catopt.model.line import Line, PointLoad, Segment
from catopt.model.load import Load
from catopt.model.site import Site

__all__ = [
    "Case",
    "Checks",
    "Find",
    "Line",
    "Load",
    "PointLoad",
    "Segment",
    "Site",
    "SwarmSettings",
]
