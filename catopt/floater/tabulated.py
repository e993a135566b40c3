"""A ship on lines out of tables: a search looks at many lines in the time that one takes.

Two things are taken more simply than by `MooredShip`: tensions are read out of tables of the closed
form, and the waves move each line's fairlead as they moved it on the line that was run first.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from catopt.arrays import Array
from catopt.floater.line_tables import span_under, tables_of
from catopt.floater.two_scales import MooredShip, ShipAtRest
from catopt.mooring.zero_load import BodyRest
from catopt.waves import Waves


@dataclass(frozen=True, eq=False)
class TabulatedShip(MooredShip):
    """A ship on lines out of tables.

    `known`: motions in waves by seas and times, which the lines of a search share; `way`: that a
    fairlead may rise or fall by, m.
    """

    known: dict[Any, Any] = field(default_factory=dict)
    way: float = 5.0

    @cached_property
    def _tables(self) -> Any:
        found = tables_of(self._net, self.way)
        return super()._tables if found is None else found

    def _fast(
        self, waves: Waves, time: Array, slow: Array, rest: ShipAtRest
    ) -> tuple[Array, Array, Array]:
        # What is known to no better than a range moves her little in waves.
        ship, legs = self.ship, len(self.system.legs)
        weather = (ship.hull, ship.wind, ship.current, ship.of.wind_direction)
        key = (*weather, waves, time.size, float(time[0]), legs)
        if key not in self.known:
            self.known[key] = super()._fast(waves, time, slow, rest)
        moved: tuple[Array, Array, Array] = self.known[key]
        return moved

    def _held(self, load: Array, yaw: float) -> BodyRest:
        """Find where a single line is as taut as the load asks for; several by closed form."""
        if self.system.turns or len(self.system.legs) > 1 or self._tables.table[0] < 0:
            return super()._held(load, yaw)
        cosine, sine = math.cos(yaw), math.sin(yaw)
        along, across, _ = load.tolist()
        x, y = along * cosine - across * sine, along * sine + across * cosine
        force, (leg,) = math.hypot(x, y), self.system.legs
        span = span_under(force, leg.fairlead_height, self._tables)
        if force == 0.0 or math.isnan(span.length):
            return super()._held(load, yaw)
        u, v = -x / force, -y / force
        stiff, aside = span.stiffness, force / span.length
        xx, yy = stiff * u * u + aside * v * v, stiff * v * v + aside * u * u
        xy = (stiff - aside) * u * v
        place_x = leg.anchor[0] - span.length * u - leg.fairlead[0]
        place_y = leg.anchor[1] - span.length * v - leg.fairlead[1]
        stiffness = ((xx, xy, 0.0), (xy, yy, 0.0), (0.0, 0.0, 0.0))
        return BodyRest(place_x, place_y, 0.0, 0, 0.0, 0.0, (-x, -y, 0.0), stiffness)
