"""What pulls on the line: one of three known quantities."""

from __future__ import annotations

from dataclasses import dataclass

from catopt.errors import InputError, Problem
from catopt.model.validity import Findings

LOADS = {"horizontal_force": "N", "span": "m", "fairlead_tension": "N"}
"""The quantities of which one is known, with their units."""


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
        given = self.given
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
        found = Findings("Load", self)
        found.number(given[0], getattr(self, given[0]), LOADS[given[0]], above=0.0)
        found.raise_if_any()

    @property
    def given(self) -> tuple[str, ...]:
        """Name of the known quantity; one, for a sound load has no more."""
        values = (self.horizontal_force, self.span, self.fairlead_tension)
        return tuple(key for key, value in zip(LOADS, values, strict=True) if value is not None)
