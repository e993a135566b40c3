"""What varies from member to member of a study, and what it is drawn from."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np

from catopt.arrays import Array, Codes

DistributionKind = Literal["normal", "lognormal", "uniform", "gumbel"]


@dataclass(frozen=True)
class Distribution:
    """A distribution of a value.

    `kind`: of which form; gumbel is that of largest values; `first`, `second`: mean and standard
    deviation of the value itself; of a uniform one its ends.

    Examples
    --------
    >>> import numpy as np
    >>> Distribution("normal", 50.0, 5.0).at(np.array([-2.0, 0.0, 2.0])).tolist()
    [40.0, 50.0, 60.0]
    """

    kind: DistributionKind
    first: float
    second: float

    def draw(self, rng: np.random.Generator, count: int) -> Array:
        """Draw so many values."""
        a, b = self.first, self.second
        if self.kind == "normal":
            return rng.normal(a, b, count)
        if self.kind == "lognormal":
            return rng.lognormal(*self._logarithm, count)
        if self.kind == "gumbel":
            return rng.gumbel(*self._gumbel, count)
        return rng.uniform(a, b, count)

    def at(self, normal: Array) -> Array:
        """Values that are exceeded as seldom as a standard normal one exceeds `normal`."""
        from scipy.special import log_ndtr, ndtr

        a, b = self.first, self.second
        if self.kind == "normal":
            return a + b * normal
        if self.kind == "lognormal":
            middle, width = self._logarithm
            return np.exp(middle + width * normal)
        if self.kind == "gumbel":
            mode, scale = self._gumbel
            found: Array = mode - scale * np.log(-log_ndtr(normal))
            return found
        between: Array = a + (b - a) * ndtr(normal)
        return between

    def normal_of(self, values: Array) -> Array:
        """Return standard normal values exceeded as seldom as these: `at` turned round."""
        from scipy.special import ndtri, ndtri_exp

        a, b = self.first, self.second
        if self.kind == "normal":
            return (values - a) / b
        if self.kind == "lognormal":
            middle, width = self._logarithm
            return (np.log(values) - middle) / width
        if self.kind == "gumbel":
            mode, scale = self._gumbel
            rare: Array = ndtri_exp(-np.exp(-(values - mode) / scale))
            return rare
        share: Array = ndtri((values - a) / (b - a))
        return share

    @property
    def _logarithm(self) -> tuple[float, float]:
        """Mean and standard deviation of the logarithm."""
        width = math.sqrt(math.log1p((self.second / self.first) ** 2))
        return math.log(self.first) - 0.5 * width**2, width

    @property
    def _gumbel(self) -> tuple[float, float]:
        """Mode and scale."""
        scale = self.second * math.sqrt(6.0) / math.pi
        return self.first - float(np.euler_gamma) * scale, scale


@dataclass(frozen=True, eq=False)
class Axis:
    """Keys whose values go together; the axes of a study are multiplied.

    `columns`: values by key path, all of the same length: numbers in SI as an array, words and
    counts as they are; `weights`: what each of them counts; None where all count the same;
    `distributions`: by key path, what they were drawn from; empty where they were not.
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
        scaled = self.weights / self.weights.max()  # the sum of the largest floats is none
        shares: Array = scaled / scaled.sum()
        return shares

    def take(self, at: Codes) -> dict[str, Sequence[Any] | Array]:
        """Return the values at some places, by key."""
        return {
            key: column[at] if isinstance(column, np.ndarray) else [column[k] for k in at.tolist()]
            for key, column in self.columns.items()
        }
