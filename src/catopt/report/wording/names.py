"""Names that catopt uses in documents, said in words."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

__all__ = ["METHODS", "REGIMES"]

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
    }
)
"""How a line hangs."""
