"""The watch circle: where a force of one size, from every side, takes the body."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from catopt.errors import InputError, Problem
from catopt.model.kinds import Angle, Findings, Place, Strength
from catopt.model.network import Network
from catopt.model.system import System
from catopt.mooring.held import without_load
from catopt.mooring.response import Response, network_response, response_of
from catopt.mooring.zero_load import zero_load_position
from catopt.patience import paced
from catopt.records import Record
from catopt.shown import Tabled
from catopt.ties import first_largest
from catopt.words import Message

__all__ = ["WatchCircle", "watch_circle"]


@dataclass(frozen=True)
class WatchCircle(Tabled, Record):
    """Offsets of a body under a force that goes round."""

    DOCUMENT = "force directions responses"

    system: System | Network
    """The lines; the load on the body plays no part."""
    force: Strength
    """Its size."""
    directions: tuple[Angle, ...]
    """Towards which the force acts, counter-clockwise from x."""
    responses: tuple[Response, ...]
    """The body and its lines at each direction."""
    neutral: tuple[Place, Place]
    """Zero-load position."""

    @property
    def farthest(self) -> int:
        """Index of the direction of the largest offset."""
        return first_largest([each.offset for each in self.responses])

    @property
    def hardest(self) -> int:
        """Index of the direction of the largest tension in any line."""
        return first_largest([each.largest_tension for each in self.responses])


def watch_circle(system: System, *, force: float, directions: int = 120) -> WatchCircle:
    """Let a force go round a body.

    `force`: its size, N; `directions`: how many, evenly from 0, at least 3. The system's own load
    plays no part.

    Raises
    ------
    InputError, NoEquilibriumError, NotConvergedError
        As for `solve_system`.
    """
    angles = _angles(force, directions)
    zero_load = zero_load_position(system)
    responses = []
    for angle in paced(Message("words.directions", total=directions), angles):
        rest, lines = zero_load.under((force * math.cos(angle), force * math.sin(angle)))
        responses.append(response_of(zero_load, rest, lines))
    neutral = (zero_load.neutral.x, zero_load.neutral.y)
    return WatchCircle(system, force, angles, tuple(responses), neutral)


def network_circle(network: Network, *, force: float, directions: int = 120) -> WatchCircle:
    """Let a force go round the one free body of a network; as `watch_circle`.

    InputError, too, where it has none or several; what `at_rest` raises.
    """
    angles = _angles(force, directions)
    if len(network.bodies) != 1:
        found = ", ".join(body.name for body in network.bodies) or Message("refused.none")
        allowed = Message("refused_motion.circle_is_of_one_body")
        raise InputError([Problem("bodies", found, allowed)], "watch circle")
    (body,) = network.bodies
    start = without_load(network)
    responses = []
    for angle in paced(Message("words.directions", total=directions), angles):
        push = (force * math.cos(angle), force * math.sin(angle))
        responses.append(network_response(start.under((replace(body, force=push, moment=0.0),))))
    x, y, _ = start.found.poses[0]
    return WatchCircle(network, force, angles, tuple(responses), (body.x + x, body.y + y))


def _angles(force: float, directions: int) -> tuple[float, ...]:
    """Check what goes round, and say in which directions."""
    found = Findings("watch circle")
    found.number("force", force, "N", above=0.0)
    found.number("directions", directions, "", at_least=3, at_most=3600)
    found.raise_if_any()
    return tuple(2.0 * math.pi * k / directions for k in range(directions))
