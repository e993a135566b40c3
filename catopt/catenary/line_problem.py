"""A line with all that its equilibrium depends on, save the load."""

from __future__ import annotations

from typing import NamedTuple

from catopt.catenary.pieces import Pieces, has_buoyancy
from catopt.compiled import inlined

LEAST_FORCE, GREATEST_FORCE = 1e-30, 1e30
"""N: beyond them products of forces leave the range of double precision."""


class LineProblem(NamedTuple):
    """A line with all that its equilibrium depends on, save the load.

    Heights are above the bed (m), friction is the Coulomb coefficient of the bed.
    """

    pieces: Pieces
    anchor_height: float
    fairlead_height: float
    friction: float


@inlined
def is_plain(problem: LineProblem) -> bool:
    """Whether nothing floats and the anchor lies on the bed: then the suspended part tells all."""
    return problem.anchor_height == 0.0 and not has_buoyancy(problem.pieces)
