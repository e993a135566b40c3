"""Up to which force a load curve is of interest, where nobody says."""

from __future__ import annotations

import math
from collections.abc import Mapping
from contextlib import suppress

from catopt.catenary.find import find_limit_force
from catopt.errors import NoAnswerError
from catopt.model import Line
from catopt.words import Message

BEYOND = 1.05
LEAST = 0.01
"""A range that is not given runs from this part of a force to that, which shows its mark."""


def limit_force(
    line: Line, place: Mapping[str, float], safety_factor: float
) -> tuple[float, Message] | None:
    """Return the horizontal force at which a segment is first at its limit, and what it is.

    None where no MBL is known, or none is reached.
    """
    if any(segment.MBL is not None for segment in line.segments):
        with suppress(NoAnswerError):
            found = find_limit_force(line, safety_factor=safety_factor, segment=None, **place)
            return found.value, Message("catenary.limit_force", condition=found.condition)
    return None


def weight_force(line: Line) -> tuple[float, Message]:
    """Return what a line weighs, as the force of a curve of which nothing else is known, N."""
    weight = math.fsum(abs(each.submerged_weight) * each.length for each in line.segments)
    return weight, Message("catenary.line_weight")
