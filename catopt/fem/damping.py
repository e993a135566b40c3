"""Damping of the line itself: axial, and Rayleigh's from two frequencies."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np

from catopt.arrays import Array
from catopt.model.dynamics import BARS
from catopt.model.kinds import Findings
from catopt.words import Message


@dataclass(frozen=True)
class LineDamping:
    """What damps a line beside the water.

    The first three add up to an axial force per rate of strain. Rayleigh's C = alpha M + beta K,
    S4 [3.17], takes for K the tangent of the bars' forces, those across the bar included; alpha
    damps motion as a whole, too.
    """

    internal: float = 0.0  # axial force per rate of strain, N s, of every bar
    critical_ratio: float = 0.0  # as a part of what is critical for a bar on its own, l0 sqrt(EA m)
    critical_length: float | Literal["bar"] | None = None  # of that bar, m; None: a hundredth of
    # its line, whatever the mesh; "bar": of each bar itself, so that the damping falls as bars get
    # shorter (MoorDyn's negative BA), and a run with twice the bars is one of another line
    stiffness_time: float = 0.0  # as a multiple of EA, s: c = stiffness_time EA
    mass_factor: float = 0.0  # alpha, 1/s
    stiffness_factor: float = 0.0  # beta, s

    def __post_init__(self) -> None:
        found = Findings("LineDamping")
        for key, unit in (
            ("internal", "N s"),
            ("critical_ratio", ""),
            ("stiffness_time", "s"),
            ("mass_factor", "1/s"),
            ("stiffness_factor", "s"),
        ):
            found.number(key, getattr(self, key), unit, at_least=0.0)
        if self.critical_length not in (None, "bar"):
            found.number("critical_length", self.critical_length, "m", above=0.0)
        found.raise_if_any()

    def per_bar(self, length: Array, EA: Array, mass: Array, line_length: Array) -> Array:
        """Axial force per rate of strain of each bar, N s, Rayleigh's share included.

        Every bar has its unstretched length, m, axial stiffness, N, mass, kg/m, and the length of
        the line that it is of, m.
        """
        of: Array | float = length
        if self.critical_length != "bar":
            given = self.critical_length
            of = line_length / BARS if given is None else given
        critical = self.critical_ratio * of * np.sqrt(EA * mass)
        total: Array = self.internal + critical + (self.stiffness_time + self.stiffness_factor) * EA
        return total


def rayleigh_factors(
    first: float, second: float, ratio: float, ratio_second: float | None = None
) -> tuple[float, float]:
    """Alpha (1/s) and beta (s) that damp two angular frequencies by given ratios, S4 [3.17].

    From ratio = alpha/(2 omega) + beta omega/2 at both; for one ratio
    alpha = 2 ratio w1 w2/(w1 + w2), beta = 2 ratio/(w1 + w2).

    Parameters
    ----------
    first, second : float
        Angular frequencies, rad/s, such as the two lowest of `natural_frequencies`.
    ratio, ratio_second : float
        Of critical damping; the same at both unless given.

    Raises
    ------
    InputError
        When a frequency is not above 0 or both are the same.
    """
    found = Findings("rayleigh_factors")
    found.number("first", first, "rad/s", above=0.0)
    found.number("second", second, "rad/s", above=0.0)
    found.number("ratio", ratio, "", at_least=0.0)
    if not found.problems and math.isclose(first, second, rel_tol=1e-9):
        found.add("second", f"{second:g} rad/s", Message("refused_motion.differs_from_first"))
    found.raise_if_any()
    other = ratio if ratio_second is None else ratio_second
    over = 2.0 / (second**2 - first**2)
    alpha = over * first * second * (ratio * second - other * first)
    beta = over * (other * second - ratio * first)
    return alpha, beta
