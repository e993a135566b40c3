"""A sizing put as a case: the loads that were computed, and the case that they make."""

from __future__ import annotations

import math
from dataclasses import dataclass

from catopt.loads.component import Loads
from catopt.loads.drag_anchor import DragAnchorSize
from catopt.loads.weathervane import Lying
from catopt.model import Case


@dataclass(frozen=True)
class LoadsAt:
    """The loads of one load case.

    Attributes
    ----------
    load_case : str
        Its name.
    depth : float
        Of the still water, m.
    parts : tuple of Loads
        On the ship, on the buoy; empty where the force was given.
    given : float
        Force that was given instead, N.
    shared : bool
        Whether the load is that of a body with several lines, of which the case has one.
    lying : Lying or None
        Of a ship: how it lies under the largest force of all directions and stable headings.
    """

    load_case: str
    depth: float
    parts: tuple[Loads, ...] = ()
    given: float = 0.0
    shared: bool = False
    lying: Lying | None = None

    @property
    def horizontal_force(self) -> float:
        """Sum of all parts, along one direction, N."""
        return math.fsum([self.given, *(part.horizontal_force for part in self.parts)])


@dataclass(frozen=True)
class Posed:
    """What goes to the design search.

    Attributes
    ----------
    case : Case
        With load cases, checks and design.
    loads : tuple of LoadsAt
        Of each extreme load case, in the order of the case.
    drag_anchor : DragAnchorSize or None
        That the case is held by, where it is one.
    """

    case: Case
    loads: tuple[LoadsAt, ...]
    drag_anchor: DragAnchorSize | None = None
