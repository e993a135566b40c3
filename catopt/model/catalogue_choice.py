"""Which catalogue a case takes its components from."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated

from catopt.model.kinds import File


@dataclass(frozen=True)
class CatalogueChoice:
    """Where components come from, and which of disagreeing figures to follow."""

    file: Annotated[str, File()] = ""
    """Full path of a file with families of one's own; empty when there is none."""
    allow_recalled: bool = False
    """Whether figures that were read in no document (confidence R) may be used."""
    variants: tuple[tuple[str, str], ...] = ()
    """Quantity, or "all", and the variant of it to follow."""

    @property
    def by_quantity(self) -> Mapping[str, str]:
        """The variants as a mapping."""
        return dict(self.variants)
