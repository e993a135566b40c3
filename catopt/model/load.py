"""What pulls on the line: one of three known quantities."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from catopt.model.kinds import Given, Height, Strength
from catopt.model.validity import Checked, Findings
from catopt.words import Message

LOADS = ("horizontal_force", "span", "fairlead_tension")
"""The quantities of which one is known."""


@dataclass(frozen=True)
class Load(Checked):
    """The one known quantity at the fairlead; the others follow from it."""

    horizontal_force: Strength | None = None
    """N."""
    span: Height | None = None
    """Horizontal distance from the anchor to the fairlead, m; 0 for a plumb line."""
    fairlead_tension: Strength | None = None
    """Effective tension at the fairlead, N."""

    if TYPE_CHECKING:  # numbers in SI or text with a unit; what is kept are numbers

        def __init__(
            self,
            horizontal_force: Given | None = None,
            span: Given | None = None,
            fairlead_tension: Given | None = None,
        ) -> None: ...

    def _check(self, found: Findings) -> None:
        if len(self.given) != 1:
            allowed = Message("refused.one_load")
            found.add(
                "load", " and ".join(self.given) or Message("refused_file.none_of_them"), allowed
            )
            found.raise_if_any()
        found.check()

    @property
    def given(self) -> tuple[str, ...]:
        """Name of the known quantity; one, for a sound load has no more."""
        return tuple(key for key in LOADS if getattr(self, key) is not None)
