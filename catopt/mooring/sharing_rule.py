"""The rule of practice of S4 for load sharing: what it says of a system, or why it cannot."""

from __future__ import annotations

import math
from dataclasses import dataclass

from catopt.errors import InputError, Problem
from catopt.model.kinds import SomeForce
from catopt.model.system import System
from catopt.records import Record
from catopt.words import Message

__all__ = ["SharingRule", "sharing_rule"]

FEWEST_LINES = 4
"""Two lines carry FT = F, not the half of F that N / 4 would say."""


def load_sharing_factor(lines: int) -> float:
    """Force that the lines carry together, over the horizontal force of the most loaded one.

    The rule of practice (ARGEMA) that S4 quotes: for N evenly spaced lines and a force along one of
    them, that line carries F and the others of the loaded half F cos(angle), each along itself.
    Lines a quarter turn or more away carry nothing. The sum along the force is (N / 4) F.

    It is the balance of equal lines without pretension whose pull grows in proportion to how far
    they are drawn out. It is no equilibrium of catenaries, which stiffen as they are drawn out and
    pull on the other side too. InputError: fewer than 4 lines, or an odd number.

    Examples
    --------
    >>> round(load_sharing_factor(6), 12)
    1.5
    """
    if lines < FEWEST_LINES or lines % 2:
        problem = Problem("lines", str(lines), Message("refused_motion.sharing_rule"))
        raise InputError([problem], "load sharing")
    last = (lines - 1) // 4
    shares = [math.cos(2.0 * math.pi * k / lines) for k in range(-last, last + 1)]
    return math.fsum(share * share for share in shares)


SAME_ANGLE = 1e-6
"""rad within which lines count as evenly spaced, and a force as along one of them."""


@dataclass(frozen=True)
class SharingRule(Record):
    """What the rule of practice for load sharing says of the most loaded line.

    In Python lines count from 0.
    """

    DOCUMENT = "applies line+1=line horizontal_force why_not"

    horizontal_force: SomeForce | None
    """Of that line; None where the rule does not apply."""
    line: int | None = None
    """The line that lies against the force; None where the rule does not apply."""
    why_not: str = ""
    """What bars the rule; empty where it applies."""

    @property
    def applies(self) -> bool:
        """Whether the system is one that the rule is made for."""
        return self.horizontal_force is not None


def sharing_rule(system: System) -> SharingRule:
    """Put the rule of practice on a system under its load.

    It wants an even number of equal, evenly spaced lines, 4 or more, and a force along one of
    them: then that line carries the force over N/4 (catopt.mooring.sharing_rule).
    """
    count = len(system.legs)
    if count < FEWEST_LINES or count % 2:
        return _not("even", count=count)
    first = system.legs[0]
    for leg in system.legs:
        is_same = leg.line == first.line and leg.anchor_radius == first.anchor_radius
        if not is_same or leg.fairlead_height != first.fairlead_height:
            return _not("equal")
    turns = sorted((leg.azimuth - first.azimuth) % (2.0 * math.pi) for leg in system.legs)
    for index, turn in enumerate(turns):
        even = 2.0 * math.pi * index / count
        if min(abs(turn - even), abs(turn - even - 2.0 * math.pi)) > SAME_ANGLE:
            return _not("spaced")
    force = math.hypot(*system.force)
    if force == 0.0 or system.moment != 0.0:
        return _not("force")
    against = math.atan2(-system.force[1], -system.force[0])
    for index, leg in enumerate(system.legs):
        away = math.remainder(leg.azimuth - against, 2.0 * math.pi)
        if abs(away) <= SAME_ANGLE:
            return SharingRule(force / load_sharing_factor(count), index)
    return _not("along")


def _not(wanted: str, **values: object) -> SharingRule:
    return SharingRule(None, None, Message(f"mooring.wants_{wanted}", **values))
