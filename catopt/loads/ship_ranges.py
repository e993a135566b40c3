"""What decides a ship's motion and is known to no better than a range, with both ends of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType
from typing import Any, Final, Literal, NamedTuple

from catopt.model import ShipAfloat

Cause = Literal["damping", "drift", "current"]
"""Inputs that go together."""


class Ends(NamedTuple):
    """Keys of a ship afloat with what each is at either end of its range."""

    unfavourable: Mapping[str, float]
    favourable: Mapping[str, float]


RANGES: Final[Mapping[Cause, Ends]] = MappingProxyType(
    {
        "damping": Ends(
            {"surge_damping": 0.02, "sway_damping": 0.0, "yaw_damping": 0.0},
            {"surge_damping": 0.10, "sway_damping": 0.10, "yaw_damping": 0.10},
        ),
        "drift": Ends({"drift_factor": 1.2}, {"drift_factor": 0.8}),
        "current": Ends(
            {"lever_factor": 1.1, "turn_factor": 0.75}, {"lever_factor": 0.9, "turn_factor": 1.25}
        ),
    }
)
"""catopt's own: linear damping of slow motions as a part of critical; drift by the spread of panel
calculations of one hull with several bows; lever and damping of a turn by the scatter of hulls
about Clarke's regressions. What a ship afloat has when nothing is given is the middle."""


def at_the_end(of: ShipAfloat, *causes: Cause, favourable: bool = False) -> ShipAfloat:
    """Move some inputs of a ship, or all, to the unfavourable end of their ranges, or the other."""
    for each in causes or tuple(RANGES):
        ends = RANGES[each]
        of = _with(of, ends.favourable if favourable else ends.unfavourable)
    return of


def in_the_middle(of: ShipAfloat) -> ShipAfloat:
    """Put every input that has a range to what it is when nothing is given."""
    middle = ShipAfloat(of.length, of.breadth, of.draught, of.moulded_depth)
    keys = (key for ends in RANGES.values() for key in ends.unfavourable)
    return _with(of, {key: getattr(middle, key) for key in keys})


def _with(of: ShipAfloat, values: Mapping[str, Any]) -> ShipAfloat:
    return replace(of, **values)
