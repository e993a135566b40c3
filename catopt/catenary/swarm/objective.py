"""What the swarm makes small: S1's f, the places it may search, and what a place means.

    f = |l(S) - L| + |z(S) - h|

l and z are the unstretched arc length and the height that the line reaches at the span S. With the
inclination theta0 at the anchor, or with what lies on the bed, the vertical force V is known along
all pieces but the last, and with t = V/H each of them is laid out from its lower end:

    t2 - t1 = l/a,    dz = l (t1 + t2) (1/(T1 + T2) + H/(2 EA)),    a = H/w, T = hypot(1, t)

A point load W lets t jump by W/H. The last piece is S1's catenary, S1 (1) and (6). Both are
differences that lose their digits on flat and on steep lines. With b = asinh(t) at its lower end,
r the span from there and u = r / (2 a), they are products, exact to rounding:

    l = a sinh(2 u + b) - a sinh b = 2 a sinh(u) cosh(u + b)
    z = a cosh(2 u + b) - a cosh b = 2 a sinh(u) sinh(u + b)

A piece that stretches gains l H/EA of span and l (t1 + t2) H/(2 EA) of height, so that l(S) is
explicit in r, though not in S. The second unknown is therefore r, the span of the last piece
before its stretch, and S follows from it. For one segment that does not stretch, r is S1's S.
"""

from __future__ import annotations

import math
import sys
from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from catopt.catenary.equilibrium import hung_state
from catopt.catenary.pieces import (
    Pieces,
    has_buoyancy,
    is_inextensible,
    piece_reach,
    total_length,
    total_weight,
)
from catopt.catenary.state import SUSPENDED, State
from catopt.catenary.suspended import NO_TOUCHDOWN, suspended_part

Array = NDArray[np.float64]

_BELOW_ONE = 1.0 - 4.0 * sys.float_info.epsilon
"""Keeps a strict bound strict through the rounding of the bound itself."""

_STRAIGHT = 1e150
"""m: parameter of a piece without weight; to the last digit, such a catenary is straight."""


class Hanging(NamedTuple):
    """What hangs from the fairlead, at each of n places."""

    slope: Array  # V/H at its lowest point
    length: Sequence[float | Array]  # unstretched, of each piece, m
    load: Sequence[float | Array]  # what the line carries on the joint below each piece, N


@dataclass(frozen=True)
class Objective(ABC):
    """f of one line anchored on the bed, over places of shape (n, 2): one row a particle."""

    pieces: Pieces
    height: float  # h, m
    horizontal_force: float  # H, N

    @property
    @abstractmethod
    def bounds(self) -> tuple[Array, Array]:
        """Least and greatest place, each of shape (2,); both belong to the search."""

    @abstractmethod
    def hanging(self, first: Array) -> Hanging:
        """Say what hangs, from the first unknown of each place, shape (n,)."""

    @abstractmethod
    def touchdown(self, first: float) -> int:
        """Touchdown code (suspended.py) of one place, from its first unknown."""

    def __call__(self, places: Array) -> Array:
        """Evaluate f at each place, m."""
        length, height = self.misses(places)
        f: Array = np.abs(length) + np.abs(height)
        return f

    def misses(self, places: Array) -> tuple[Array, Array]:
        """l(S) - L and z(S) - h at each place, m; shape (n,) each."""
        hanging = self.hanging(places[:, 0])
        slope, height = self._foot_of_last_piece(hanging)
        double = 2.0 * self.parameters[-1]
        u = places[:, 1] / double
        middle = np.arcsinh(slope)
        middle += u
        factor = np.sinh(u)
        factor *= double
        length = factor * np.cosh(middle)
        rise = factor * np.sinh(middle)
        if self.pieces.compliance[-1] > 0.0:
            rise += length * (slope + length / double) * self._strains[-1]
        return length - hanging.length[-1], rise + height - self.height

    def vertical_force(self, places: Array) -> Array:
        """Vertical force at the fairlead at each place, N; shape (n,)."""
        slope, length, load = self.hanging(places[:, 0])
        V = self.horizontal_force * slope
        for k, weight in enumerate(self.pieces.weight):
            V = V + (load[k] + weight * length[k])
        return V

    def state(self, place: Array, friction: float) -> State:
        """Lay out the whole line at one place, of shape (2,); its span is S by length, S1 (5).

        The friction of the bed acts on what lies there, of which f knows nothing.
        """
        V = float(self.vertical_force(place[np.newaxis])[0])
        touchdown = self.touchdown(place[0])
        return hung_state(self.horizontal_force, V, self.pieces, self.height, friction, touchdown)

    def excess(self, place: Array) -> float:
        """S of one place less S by length, S1 (5), m: they differ in the last piece alone."""
        H, row = self.horizontal_force, place[np.newaxis]
        hanging = self.hanging(row[:, 0])
        slope, _ = self._foot_of_last_piece(hanging)
        length = float(np.ravel(hanging.length[-1])[0])
        V1 = H * float(slope[0])
        V2 = V1 + self.pieces.weight[-1] * length
        T1, T2 = math.hypot(H, V1), math.hypot(H, V2)
        whole = piece_reach(H, V1, V2, T1, T2, length, self.pieces.compliance[-1])
        stretch = (length + float(self.misses(row)[0][0])) * self._strains[-1]
        return float(place[1]) + stretch - whole.dx

    @cached_property
    def parameters(self) -> tuple[float, ...]:
        """The catenary's parameter a = H / w of each piece, m; negative for one that floats."""
        return tuple(
            math.copysign(min(self.horizontal_force / abs(w), _STRAIGHT), w) if w else _STRAIGHT
            for w in self.pieces.weight
        )

    @cached_property
    def _strains(self) -> tuple[float, ...]:
        """H/EA of each piece."""
        return tuple(c * self.horizontal_force for c in self.pieces.compliance)

    @cached_property
    def length(self) -> float:
        """L, m."""
        return total_length(self.pieces)

    @property
    def rounding(self) -> float:
        """Least f that can be told from zero, m: the rounding of the lengths that it compares."""
        return 4.0 * sys.float_info.epsilon * (self.length + self.height)

    def _foot_of_last_piece(self, hanging: Hanging) -> tuple[Array, Array | float]:
        """V/H and height (m) at the lower end of the last piece."""
        slope = hanging.slope
        height: Array | float = 0.0
        for k, length in enumerate(hanging.length[:-1]):
            upper = slope + length / self.parameters[k]
            tensions = np.hypot(1.0, slope) + np.hypot(1.0, upper)
            height = height + length * (slope + upper) * (1.0 / tensions + 0.5 * self._strains[k])
            slope = upper + hanging.load[k + 1] / self.horizontal_force
        return slope, height

    @property
    def _greatest_reach(self) -> float:
        """Upper bound of the span of the last piece, before its stretch, m.

        At a given span l is least where the piece starts level, or, when a buoyant part may let it
        start downwards, where its vertex is in its middle: a span that takes more than the piece
        has even then is out of reach. This keeps every hyperbolic function far from overflow.
        S1 (10) keeps a line that does not stretch longer than its chord.
        """
        length, a = self.pieces.length[-1], abs(self.parameters[-1])
        sides = 2.0 if has_buoyancy(self.pieces) else 1.0
        reach = sides * a * math.asinh(length / (sides * a))
        if is_inextensible(self.pieces):
            chord = math.sqrt((self.length - self.height) * (self.length + self.height))
            reach = min(chord * _BELOW_ONE, reach)
        return max(reach, 2.0 * sys.float_info.min)


class SuspendedObjective(Objective):
    """All of the line hangs. A place is (theta0, r); r is S for a single piece, as in S1."""

    @property
    def bounds(self) -> tuple[Array, Array]:
        """S1 (8), (9), (10)."""
        upright = math.nextafter(math.pi / 2.0, 0.0)
        return np.array([0.0, sys.float_info.min]), np.array([upright, self._greatest_reach])

    def hanging(self, first: Array) -> Hanging:
        """Take all of the line, inclined by theta0 at its lower end."""
        return Hanging(np.tan(first), self.pieces.length, self.pieces.load)

    def touchdown(self, first: float) -> int:  # noqa: ARG002 - the same for every theta0
        """Nowhere."""
        return NO_TOUCHDOWN

    def state(self, place: Array, friction: float) -> State:
        """Lay out the line with the very theta0 of the place."""
        hung = super().state(place, friction)
        V_anchor = self.horizontal_force * math.tan(place[0])
        return hung._replace(regime=SUSPENDED, V_anchor=V_anchor)


class GroundedObjective(Objective):
    """Part of the line lies on the bed and ends there level. A place is (c, r).

    c is the grounded length, in which a clump weight counts as the length of line that weighs as
    much on average, the equivalent length W/q of S2 (30). So one number says where the line
    touches down and, where that is at a clump weight, how much of it the bed carries.

    c moves the lower end of the last piece. So over (c, S) in place of (c, r) the minimum would lie
    in a narrow slanting slot, and a swarm moves by coordinates (benchmarks/results/swarm.md).
    """

    @property
    def bounds(self) -> tuple[Array, Array]:
        """0 <= c up to the first buoyant part, and what does not stretch and hangs is above h."""
        room = self.length - self.height if is_inextensible(self.pieces) else self.length
        most = 0.0
        for length, weight, load in zip(*self._columns, strict=True):
            if weight < 0.0 or load < 0.0 or room <= 0.0:
                break
            most += load / self._mean_weight + min(length, room)
            room -= length
        return np.array([0.0, sys.float_info.min]), np.array([most, self._greatest_reach])

    def hanging(self, first: Array) -> Hanging:
        """Leave out what the bed carries; the rest is level at its lower end."""
        lengths: list[float | Array] = []
        loads: list[float | Array] = []
        for (lower, upper), length, _, load in zip(self._marks, *self._columns, strict=True):
            lifted = np.maximum(lower - first, 0.0) * self._mean_weight
            loads.append(np.minimum(lifted, load) if load > 0.0 else load)
            lengths.append(np.minimum(np.maximum(upper - first, 0.0), length))
        return Hanging(np.zeros_like(first), lengths, loads)

    def touchdown(self, first: float) -> int:
        """Inside a piece, or at a clump weight that the bed carries in part."""
        for k, (lower, upper) in enumerate(self._marks):
            if first < lower:
                return 2 * k + 1
            if first < upper:
                return 2 * k
        return 2 * len(self._marks) - 2

    @property
    def _columns(self) -> tuple[Sequence[float], Sequence[float], Sequence[float]]:
        """Length and weight of each piece, and what hangs on the joint below it."""
        return self.pieces.length, self.pieces.weight, self.pieces.load[: len(self.pieces.length)]

    @cached_property
    def _marks(self) -> tuple[tuple[float, float], ...]:
        """Value of c with the touchdown at the lower and at the upper end of each piece, m."""
        marks = []
        upper = 0.0
        for length, _, load in zip(*self._columns, strict=True):
            lower = upper + max(load, 0.0) / self._mean_weight
            upper = lower + length
            marks.append((lower, upper))
        return tuple(marks)

    @cached_property
    def _mean_weight(self) -> float:
        """Weight of line and point loads per length of line, N/m."""
        parts = zip(*self._columns, strict=True)
        weight = math.fsum(abs(w) * length + abs(load) for length, w, load in parts)
        return weight / self.length


def objective_of(pieces: Pieces, height: float, horizontal_force: float) -> Objective:
    """Choose f: part of the line lies on the bed when it rises too high where it leaves it level.

    For a uniform line that does not stretch this is L > L_min = sqrt(h (h + 2 a)).
    """
    level = suspended_part(horizontal_force, total_weight(pieces), pieces, NO_TOUCHDOWN)
    kind = GroundedObjective if level.z > height else SuspendedObjective
    return kind(pieces, height, horizontal_force)
