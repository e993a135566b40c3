"""The rule of practice for load sharing, put on a system: what it would say, or why it cannot."""

from __future__ import annotations

import math
from dataclasses import dataclass

from catopt.model.system import System
from catopt.mooring.load_sharing import FEWEST_LINES, load_sharing_factor
from catopt.words import Message

__all__ = ["SharingRule", "sharing_rule"]

SAME_ANGLE = 1e-6
"""rad within which lines count as evenly spaced, and a force as along one of them."""


@dataclass(frozen=True)
class SharingRule:
    """What the rule says of the most loaded line.

    Attributes
    ----------
    horizontal_force : float or None
        Its horizontal force, N; None where the rule does not apply.
    line : int or None
        That line, counted from 0.
    why_not : str
        What bars the rule.
    """

    horizontal_force: float | None
    line: int | None = None
    why_not: str = ""


def sharing_rule(system: System) -> SharingRule:
    """Put the rule of practice on a system under its load.

    It wants an even number of equal, evenly spaced lines, 4 or more, and a force along one of
    them: then that line carries the force over N/4 (catopt.mooring.load_sharing).
    """
    count = len(system.legs)
    if count < FEWEST_LINES or count % 2:
        return _not(Message("mooring.wants_even", count=count))
    first = system.legs[0]
    for leg in system.legs:
        is_same = leg.line == first.line and leg.anchor_radius == first.anchor_radius
        if not is_same or leg.fairlead_height != first.fairlead_height:
            return _not(Message("mooring.wants_equal"))
    turns = sorted((leg.azimuth - first.azimuth) % (2.0 * math.pi) for leg in system.legs)
    for index, turn in enumerate(turns):
        even = 2.0 * math.pi * index / count
        if min(abs(turn - even), abs(turn - even - 2.0 * math.pi)) > SAME_ANGLE:
            return _not(Message("mooring.wants_spaced"))
    force = math.hypot(*system.force)
    if force == 0.0 or system.moment != 0.0:
        return _not(Message("mooring.wants_force"))
    against = math.atan2(-system.force[1], -system.force[0])
    for index, leg in enumerate(system.legs):
        away = math.remainder(leg.azimuth - against, 2.0 * math.pi)
        if abs(away) <= SAME_ANGLE:
            return SharingRule(force / load_sharing_factor(count), index)
    return _not(Message("mooring.wants_along"))


def _not(why: str) -> SharingRule:
    return SharingRule(None, None, why)
