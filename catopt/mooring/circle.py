"""The watch circle: where a force of one size, from every side, takes the body."""

from __future__ import annotations

import math
from dataclasses import dataclass

from catopt.model.system import System
from catopt.model.validity import Findings
from catopt.mooring.response import Response, response_of
from catopt.mooring.zero_load import zero_load_position
from catopt.patience import paced
from catopt.shown import Tabled
from catopt.ties import first_largest
from catopt.words import Message

__all__ = ["WatchCircle", "watch_circle"]


@dataclass(frozen=True)
class WatchCircle(Tabled):
    """Offsets of a body under a force that goes round.

    Attributes
    ----------
    system : System
        The lines; its own load plays no part.
    force : float
        Size, N.
    directions : tuple of float
        Towards which the force acts, counter-clockwise from x, rad.
    responses : tuple of Response
        The body and its lines at each.
    neutral : (float, float)
        Zero-load position, m.
    """

    system: System
    force: float
    directions: tuple[float, ...]
    responses: tuple[Response, ...]
    neutral: tuple[float, float]

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
    found = Findings("watch circle")
    found.number("force", force, "N", above=0.0)
    found.number("directions", directions, "", at_least=3, at_most=3600)
    found.raise_if_any()
    zero_load = zero_load_position(system)
    angles = tuple(2.0 * math.pi * k / directions for k in range(directions))
    responses = []
    for angle in paced(Message("words.directions", total=directions), angles):
        rest, lines = zero_load.under((force * math.cos(angle), force * math.sin(angle)))
        responses.append(response_of(zero_load, rest, lines))
    neutral = (zero_load.neutral.x, zero_load.neutral.y)
    return WatchCircle(system, force, angles, tuple(responses), neutral)
