"""How a horizontal force on a body is shared over its lines, by the rule of practice of S4."""

from __future__ import annotations

import math

from catopt.errors import InputError, Problem

FEWEST_LINES = 4
"""Two lines carry FT = F, not the half of F that N / 4 would say."""


def loaded_half(lines: int) -> tuple[tuple[float, float], ...]:
    """Lines that the rule counts, for a force along one of an even number of evenly spaced lines.

    For each line less than a quarter turn from the force: its angle to the force, rad, and its
    horizontal force over that of the most loaded line, which is the cosine of the angle. Lines a
    quarter turn or more away carry nothing. InputError: fewer than 4 lines, or an odd number.
    """
    if lines < FEWEST_LINES or lines % 2:
        problem = Problem("lines", str(lines), "the rule wants an even number, 4 or more")
        raise InputError([problem], "load sharing")
    last = (lines - 1) // 4
    angles = [2.0 * math.pi * k / lines for k in range(-last, last + 1)]
    return tuple((angle, math.cos(angle)) for angle in angles)


def load_sharing_factor(lines: int) -> float:
    """Force that the lines carry together, over the horizontal force of the most loaded one.

    The rule of practice (ARGEMA) that S4 quotes: for N evenly spaced lines and a force along one of
    them, that line carries F and the others of the loaded half F cos(angle), each along itself.
    Their sum along the force is (N / 4) F.

    It is the balance of equal lines without pretension whose pull grows in proportion to how far
    they are drawn out. It is no equilibrium of catenaries, which stiffen as they are drawn out and
    pull on the other side too.

    Examples
    --------
    >>> round(load_sharing_factor(6), 12)
    1.5
    """
    return math.fsum(share * math.cos(angle) for angle, share in loaded_half(lines))
