"""What the swarm makes small: S1's f, the places it may search, and what a place means.

    f = |l(S) - L| + |z(S) - h|

with the arc length l, S1 (6), and the height z, S1 (1), that a catenary reaches at the span S. Both
are differences that lose their digits on flat and on steep lines. With b = asinh(tan theta0) and
u = S / (2 a) they are products, exact to rounding:

    l = a sinh(2 u + b) - a sinh b = 2 a sinh(u) cosh(u + b)
    z = a cosh(2 u + b) - a cosh b = 2 a sinh(u) sinh(u + b)

A swarm needs of a line only what `Objective` lists. Another kind of line, of several segments or
with point loads, is another subclass: it says what its unknowns are and by how much they miss.
"""

from __future__ import annotations

import math
import sys
from abc import ABC, abstractmethod
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

__all__ = ["Array", "GroundedObjective", "Objective", "Shape", "SuspendedObjective", "objective_of"]

Array = NDArray[np.float64]

_BELOW_ONE = 1.0 - 4.0 * sys.float_info.epsilon
"""Keeps a strict bound strict through the rounding of the bound itself."""


@dataclass(frozen=True)
class Shape:
    """How a line hangs.

    Attributes
    ----------
    angle : float
        Inclination at the anchor theta0, rad.
    span : float
        S, m.
    grounded_length : float
        Length on the bed, m.
    """

    angle: float
    span: float
    grounded_length: float


@dataclass(frozen=True)
class Objective(ABC):
    """f of one uniform inextensible line, over places of shape (n, 2): one row a particle.

    Attributes
    ----------
    length, height : float
        L and h, m.
    horizontal_force, submerged_weight : float
        H, N, and w, N/m.
    """

    length: float
    height: float
    horizontal_force: float
    submerged_weight: float

    @property
    @abstractmethod
    def bounds(self) -> tuple[Array, Array]:
        """Least and greatest place, each of shape (2,); both belong to the search."""

    @abstractmethod
    def misses(self, places: Array) -> tuple[Array, Array]:
        """By how much each place misses the length and the height, m; shape (n,) each."""

    @abstractmethod
    def shape(self, place: Array) -> Shape:
        """Read one place, of shape (2,)."""

    @abstractmethod
    def span_by_length(self, shape: Shape) -> float:
        """Span that S1 (5) gives for the rest of a shape, m."""

    def __call__(self, places: Array) -> Array:
        """Evaluate f at each place, m."""
        length, height = self.misses(places)
        f: Array = np.abs(length) + np.abs(height)
        return f

    @cached_property
    def parameter(self) -> float:
        """The catenary's parameter a = H / w, m."""
        return self.horizontal_force / self.submerged_weight

    @property
    def rounding(self) -> float:
        """Least f that can be told from zero, m: the rounding of the lengths that it compares."""
        return 4.0 * sys.float_info.epsilon * (self.length + self.height)

    def tension(self, shape: Shape) -> float:
        """Tension at the fairlead, S1 (7), N."""
        return math.hypot(self.horizontal_force, self.vertical_force(shape))

    def vertical_force(self, shape: Shape) -> float:
        """Vertical force at the fairlead: that at the anchor and the weight of what hangs, N."""
        hanging = self.length - shape.grounded_length
        return self.horizontal_force * math.tan(shape.angle) + self.submerged_weight * hanging

    @property
    def _greatest_reach(self) -> float:
        """Upper bound of a hanging line's span, m.

        S1 (10) keeps the line longer than its chord. S1 (6) grows with theta0, so that a span
        which takes more than L already at theta0 = 0 is out of reach, too; this also keeps every
        hyperbolic function far from overflow.
        """
        chord = math.sqrt((self.length - self.height) * (self.length + self.height))
        level = self.parameter * math.asinh(self.length / self.parameter)
        return min(chord * _BELOW_ONE, level)


class SuspendedObjective(Objective):
    """All of the line hangs. A place is (theta0, S), as in S1."""

    @property
    def bounds(self) -> tuple[Array, Array]:
        """S1 (8), (9), (10)."""
        least_positive = sys.float_info.min
        upright = math.nextafter(math.pi / 2.0, 0.0)
        return np.array([0.0, least_positive]), np.array([upright, self._greatest_reach])

    def misses(self, places: Array) -> tuple[Array, Array]:
        """l(S) - L and z(S) - h."""
        double = 2.0 * self.parameter
        u = places[:, 1] / double
        middle = np.arcsinh(np.tan(places[:, 0]))
        middle += u
        factor = np.sinh(u)
        factor *= double
        return factor * np.cosh(middle) - self.length, factor * np.sinh(middle) - self.height

    def shape(self, place: Array) -> Shape:
        """(theta0, S) is the shape."""
        return Shape(float(place[0]), float(place[1]), 0.0)

    def span_by_length(self, shape: Shape) -> float:
        """Evaluate a asinh(p) - a asinh(t), p = L/a + t, by the sinh of the difference."""
        a = self.parameter
        t = math.tan(shape.angle)
        p = self.length / a + t
        crossed = p * math.hypot(1.0, t) + t * math.hypot(1.0, p)
        return a * math.asinh((self.length / a) * ((p + t) / crossed))


class GroundedObjective(Objective):
    """Part of the line lies on the bed, theta0 = 0. A place is (g, S - g).

    g is the grounded length. The swarm searches over the span S - g of the hanging part in place
    of S: on a line that hangs steeply z depends on S - g alone, and strongly, so that over (g, S)
    the minimum lies in a slanting slot which a swarm, moving by coordinates, finds hardly or not.
    """

    @property
    def bounds(self) -> tuple[Array, Array]:
        """0 <= g <= L - h, for what hangs is no shorter than it is high; 0 < S - g as S."""
        least_positive = sys.float_info.min
        most = np.array([self.length - self.height, self._greatest_reach])
        return np.array([0.0, least_positive]), most

    def misses(self, places: Array) -> tuple[Array, Array]:
        """l(S - g) - (L - g) and z(S - g) - h."""
        double = 2.0 * self.parameter
        u = places[:, 1] / double
        sinh = np.sinh(u)
        factor = double * sinh
        hanging = self.length - places[:, 0]
        return factor * np.cosh(u) - hanging, factor * sinh - self.height

    def shape(self, place: Array) -> Shape:
        """Add the span of the hanging part to the grounded length."""
        grounded, reach = float(place[0]), float(place[1])
        return Shape(0.0, grounded + reach, grounded)

    def span_by_length(self, shape: Shape) -> float:
        """Evaluate g + a asinh((L - g)/a)."""
        a = self.parameter
        return shape.grounded_length + a * math.asinh((self.length - shape.grounded_length) / a)


def objective_of(
    length: float, height: float, horizontal_force: float, submerged_weight: float
) -> Objective:
    """Choose f: part of the line lies on the bed when L > L_min = sqrt(h (h + 2 a)).

    Parameters
    ----------
    length, height : float
        L and h, m; L above h.
    horizontal_force, submerged_weight : float
        N and N/m, above 0.
    """
    least = math.sqrt(height) * math.sqrt(height + 2.0 * horizontal_force / submerged_weight)
    kind = GroundedObjective if length > least else SuspendedObjective
    return kind(length, height, horizontal_force, submerged_weight)
