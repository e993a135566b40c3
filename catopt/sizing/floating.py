"""How a buoy floats on its line in the steady storm: draught, freeboard and heel."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from catopt.constants import STANDARD_GRAVITY
from catopt.largest import largest
from catopt.loads.buoy_heel import heel_at_rest
from catopt.loads.buoy_shape import BuoyShape
from catopt.model.kinds import Angle, Height, Place, SomeForce
from catopt.records import Record
from catopt.words import Message, is_said

if TYPE_CHECKING:
    from catopt.sizing.buoy_request import BuoyRequest
    from catopt.sizing.result import Sizing

_ON_CHAIN: Final = "loads.current_on_chain"


ESTIMATED_HEEL: Final = math.radians(15.0)
"""rad: beyond it the righting moment is no longer in proportion to the heel, as is taken."""


@dataclass(frozen=True)
class FloatsInStorm(Record):
    """How a buoy floats where its line pulls it down the most, under steady forces."""

    DOCUMENT = "load_case pull draught freeboard least_freeboard heel run_up edge_freeboard"

    load_case: str
    """Where that is."""
    pull: SomeForce
    """Of the line, downwards, with the weight of marine growth."""
    draught: Height
    """Of the hull."""
    freeboard: Place
    """From still water to the deck, upright."""
    least_freeboard: Height
    """That the mooring must leave."""
    heel: Angle | None
    """By the moments of wind, current and line, rad; None for a buoy that would not float upright
    by the centre of gravity that is assumed."""
    run_up: Height
    """Of the current's surface against the hull, V^2 / 2 g."""
    edge_freeboard: Place | None
    """At the edge of the deck that dips, less the run-up; None without a heel."""

    @property
    def awash(self) -> Message | None:
        """What keeps its deck from standing above water, for the verdict; None where it does."""
        if self.heel is None or self.edge_freeboard is None:
            return Message("verdict.not_upright")
        if self.edge_freeboard < 0.0:
            heel, depth = math.degrees(self.heel), -self.edge_freeboard
            return Message("verdict.deck", heel=heel, depth=depth)
        return None

    @property
    def heeled(self) -> Message | None:
        """A steady heel that is an estimate, being large, for the verdict; None below that."""
        if self.heel is None or self.heel <= ESTIMATED_HEEL:
            return None
        return Message("verdict.heeled", heel=math.degrees(self.heel))


def floats_in_storm(request: BuoyRequest, of: Sizing) -> FloatsInStorm | None:
    """Float the buoy of a request on its recommended line; None where its shape is not known."""
    shape, density = request.buoy, request.environment.water_density
    if not isinstance(shape, BuoyShape):
        return None

    name, solution = largest(of.intact, lambda each: each[1].fairlead.vertical_force)
    reserve = shape.reserve_buoyancy(density)
    grown = reserve - (of.reserve_buoyancy or reserve)
    pull = min(max(0.0, solution.fairlead.vertical_force) + grown, reserve)
    floating = shape.afloat(pull, density)
    # What pushes on the buoy itself; of the chain the current's drag is none of it.
    parts = [part for each in of.settled.posed.loads[:1] for part in each.parts]
    every = [each for part in parts for each in part.components]
    wind, current = (
        math.fsum(e.force for e in every if e.kind == kind and not is_said(e.name, _ON_CHAIN))
        for kind in ("wind", "current")
    )
    how = request.in_motion
    own = None if how is None else how.centre_of_gravity
    heel = heel_at_rest(shape, density, pull, wind, current, own)
    run_up = request.environment.current.speed**2 / (2.0 * STANDARD_GRAVITY)
    edge = None
    if heel is not None:
        dips = 0.5 * shape.widest * math.sin(heel)
        edge = floating.freeboard * math.cos(heel) - dips - run_up
    return FloatsInStorm(
        load_case=name,
        pull=pull,
        draught=floating.draught,
        freeboard=floating.freeboard,
        least_freeboard=shape.least_freeboard,
        heel=heel,
        run_up=run_up,
        edge_freeboard=edge,
    )
