"""What varies from member to member of a study."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    from catopt.study.distribution import Distribution

Array = npt.NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Axis:
    """Keys whose values go together; the axes of a study are multiplied.

    Attributes
    ----------
    columns : mapping of str to sequence
        Values by key path, all of the same length: numbers in SI as an array, words and counts as
        they are.
    weights : array or None
        What each of them counts; None where all count the same.
    distributions : mapping of str to Distribution
        By key path, what they were drawn from; empty where they were not.
    """

    columns: Mapping[str, Sequence[Any] | Array]
    weights: Array | None = None
    distributions: Mapping[str, Distribution] = field(default_factory=dict)

    @property
    def is_drawn(self) -> bool:
        """Whether they were drawn at random."""
        return bool(self.distributions)

    def __len__(self) -> int:
        return len(next(iter(self.columns.values())))

    @property
    def name(self) -> str:
        """What its dimension is called: its key, or rows and draws of several."""
        if len(self.columns) == 1:
            return next(iter(self.columns))
        return "draw" if self.is_drawn else "row: " + ", ".join(self.columns)

    @property
    def shares(self) -> Array:
        """What each of its values counts, in all 1."""
        if self.weights is None:
            return np.full(len(self), 1.0 / len(self))
        shares: Array = self.weights / self.weights.sum()
        return shares

    def take(self, at: npt.NDArray[np.int64]) -> dict[str, Sequence[Any] | Array]:
        """Return the values at some places, by key."""
        return {
            key: column[at] if isinstance(column, np.ndarray) else [column[k] for k in at.tolist()]
            for key, column in self.columns.items()
        }
