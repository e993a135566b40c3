"""What pulls on the line: one of three known quantities."""

from __future__ import annotations

from dataclasses import dataclass

from catopt.errors import InputError, Problem
from catopt.model.validity import Findings

__all__ = ["LOADS", "Load"]

LOADS = ("horizontal_force", "span", "fairlead_tension")
"""The quantities of which one is known."""


@dataclass(frozen=True)
class Load:
    """The one known quantity at the fairlead; the others follow from it.

    Attributes
    ----------
    horizontal_force : float or None
        Horizontal force, N.
    span : float or None
        Horizontal distance from the anchor to the fairlead, m.
    fairlead_tension : float or None
        Effective tension at the fairlead, N.
    """

    horizontal_force: float | None = None
    span: float | None = None
    fairlead_tension: float | None = None

    def __post_init__(self) -> None:
        given = {
            key: (value, unit)
            for key, value, unit in (
                ("horizontal_force", self.horizontal_force, "N"),
                ("span", self.span, "m"),
                ("fairlead_tension", self.fairlead_tension, "N"),
            )
            if value is not None
        }
        if len(given) != 1:
            raise InputError(
                [
                    Problem(
                        "load",
                        " and ".join(given) if given else "none of them",
                        "exactly one of horizontal_force, span and fairlead_tension is wanted",
                    )
                ],
                "Load",
            )
        found = Findings("Load")
        for key, (value, unit) in given.items():
            found.number(key, value, unit, above=0.0)
        found.raise_if_any()

    @property
    def given(self) -> tuple[str, ...]:
        """Name of the known quantity; one, for a sound load has no more."""
        return tuple(key for key in LOADS if getattr(self, key) is not None)
