"""What a value is drawn from."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np

from catopt.study.axis import Array

Kind = Literal["normal", "lognormal", "gumbel", "uniform"]


@dataclass(frozen=True)
class Distribution:
    """A distribution of a value.

    Attributes
    ----------
    kind : {"normal", "lognormal", "gumbel", "uniform"}
        Of which form; gumbel is that of largest values.
    first, second : float
        Mean and standard deviation of the value itself; of a uniform one its ends.

    Examples
    --------
    >>> import numpy as np
    >>> Distribution("normal", 50.0, 5.0).at(np.array([-2.0, 0.0, 2.0])).tolist()
    [40.0, 50.0, 60.0]
    """

    kind: Kind
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
