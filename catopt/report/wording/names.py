"""Names that catopt uses in documents, said in words."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from catopt.catenary.solution import Solution

__all__ = ["METHODS", "REGIMES", "how_it_hangs"]

METHODS: Mapping[str, str] = MappingProxyType(
    {"closed-form": "closed form", "pso": "particle swarm"}
)
"""How a line was solved."""

REGIMES: Mapping[str, str] = MappingProxyType(
    {
        "suspended": "the whole line hangs clear of the bed",
        "below-anchor": "the line hangs below its anchor, clear of the bed",
        "grounded": "part of the line lies on the bed, from the anchor to the touchdown",
        "grounded-between": "the line hangs at both ends and lies on the bed between them",
        "on-bed": "the whole line lies on the bed",
        "slack": "slack: the line hangs straight down and the rest lies in bights on the bed",
        "grounded-in-parts": "the line lies on the bed in several stretches, lifted between them",
    }
)
"""How a line hangs."""

_NO_LENGTH = 1e-9
"""Of the line's length: what lies on the bed then is rounding."""


def how_it_hangs(solution: Solution) -> str:
    """Say how the line hangs; with the touchdown at its anchor nothing of it lies on the bed."""
    at_anchor = solution.grounded_length <= _NO_LENGTH * solution.line.length
    if solution.regime == "grounded" and at_anchor:
        return "the whole line hangs, just level at its anchor"
    return REGIMES[solution.regime]
