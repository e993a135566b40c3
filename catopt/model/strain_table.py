"""A rope that does not stretch in proportion to its tension: strain over tension by a table."""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import NoReturn

from catopt.errors import InputError, Problem
from catopt.model.kinds import Findings
from catopt.words import Message


def table_misfits(
    strain: Sequence[float], tension: Sequence[float], key: str = "strain_tension"
) -> list[Problem]:
    """List what of a table of strains and tensions, N, is wrong; `key` names the tensions."""
    if len(strain) != len(tension):
        found = Message("refused.numbers", count=len(tension))
        return [Problem(key, found, Message("refused.so_many", count=len(strain)))]
    problems = []
    for name, values in (("strain", strain), (key, tension)):
        if len(values) < 2:
            found = Message("refused.numbers", count=len(values))
            problems.append(Problem(name, found, Message("refused_case.table_of_two")))
        elif values[0] != 0.0:
            problems.append(
                Problem(f"{name}[0]", f"{values[0]:g}", Message("refused_case.table_from_zero"))
            )
        for k, (lower, upper) in enumerate(pairwise(values), start=1):
            if not upper > lower:
                allowed = Message("refused.above", bound=f"{lower:g}")
                problems.append(Problem(f"{name}[{k}]", f"{upper:g}", allowed))
    if problems:
        return problems
    pairs = zip(pairwise(strain), pairwise(tension), strict=True)
    for k, ((e, more), (T, larger)) in enumerate(pairs, start=1):
        # Beyond this the straight line of the row would begin below a strain of -1.
        most = e + (1.0 + e) * (larger - T) / T if T > 0.0 else math.inf
        if not more < most:
            allowed = Message("refused_case.table_softens", most=most)
            problems.append(Problem(f"strain[{k}]", f"{more:g}", allowed))
    return problems


@dataclass(frozen=True)
class StrainTable:
    """Strain of a rope at some tensions, N, both from 0 and rising; straight lines between them.

    It stands in the place of `Segment.EA`. One line is solved by it at rest (`solve`, ``catopt
    solve``) and verified by the truss model. Everything that needs one axial stiffness refuses it.

    Parameters
    ----------
    strain : sequence of float
        Elongation over unstretched length.
    tension : sequence of float or str
        N, or text with a unit.

    Raises
    ------
    InputError
        Fewer than two rows, not from 0, not rising.

    Examples
    --------
    >>> from catopt import StrainTable
    >>> rope = StrainTable([0.0, 0.05, 0.1], ["0 kN", "20 kN", "60 kN"])
    >>> round(rope.strain_at(40e3), 9)
    0.075
    """

    strain: tuple[float, ...]
    tension: tuple[float, ...]

    def __init__(self, strain: Iterable[float], tension: Iterable[float | str]) -> None:
        object.__setattr__(self, "strain", tuple(strain))
        object.__setattr__(self, "tension", tuple(tension))
        found = Findings(of=self)
        found.each("strain", "", at_least=0.0)
        found.each("tension", "N", at_least=0.0)
        found.raise_if_any()
        found.problems += table_misfits(self.strain, self.tension, "tension")
        found.raise_if_any()

    def strain_at(self, tension: float) -> float:
        """Strain at a tension, N; beyond the last row its slope goes on, which answers refuse."""
        k = self._row(tension)
        return self.strain[k] + (tension - self.tension[k]) * self.slope(k)

    def law(self, least: float, most: float) -> tuple[float, float]:
        """Return e and c, 1/N, of the strain e + c T that stands for tensions between two, N.

        It has the table's chord between them and its mean.
        """
        k = self._row(0.5 * (least + most))
        if self._row(least) == self._row(most):
            return self.strain[k] - self.slope(k) * self.tension[k], self.slope(k)
        inside = [T for T in self.tension if least < T < most]
        places = [least, *inside, most]
        strains = [self.strain_at(T) for T in places]
        pairs = zip(pairwise(places), pairwise(strains), strict=True)
        mean = math.fsum(0.5 * (b - a) * (u + v) for (a, b), (u, v) in pairs) / (most - least)
        c = (strains[-1] - strains[0]) / (most - least)
        return mean - 0.5 * c * (least + most), c

    def slope(self, k: int) -> float:
        """Strain gained per tension from a row, from 0, to the next, 1/N."""
        return (self.strain[k + 1] - self.strain[k]) / (self.tension[k + 1] - self.tension[k])

    def _row(self, tension: float) -> int:
        return min(max(bisect_right(self.tension, tension) - 1, 0), len(self.tension) - 2)

    def _refuse(self, *_: object) -> NoReturn:
        allowed = Message("refused_case.table_is_no_stiffness")
        raise InputError([Problem("EA", Message("refused_case.table_of_strain"), allowed)])

    # What reckons with one axial stiffness does not know this rope.
    __float__ = __rtruediv__ = __truediv__ = __mul__ = __rmul__ = _refuse
    __lt__ = __gt__ = __le__ = __ge__ = __abs__ = __neg__ = _refuse
