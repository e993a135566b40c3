"""How a figure follows from the nominal diameter: the few forms in which sources print it."""

from __future__ import annotations

import math
from bisect import bisect_left
from collections.abc import Callable
from dataclasses import dataclass

from catopt.words import Cited, Message

Given = Callable[[str], float]
"""Value of another quantity of the same component, in SI."""

_MM = 1e3
"""Millimetres in a metre."""


def number(value: float) -> str:
    """Write a number as data files do: ``21900``, ``8.54e10``."""
    mantissa, e, exponent = f"{value:.6g}".partition("e")
    return f"{mantissa}e{int(exponent)}" if e else mantissa


@dataclass(frozen=True)
class Polynomial:
    """Sum of c_n d^n, SI, by powers n and coefficients c_n."""

    terms: tuple[tuple[int, float], ...]

    rests_on = ()

    def value(self, diameter: float, given: Given) -> float:  # noqa: ARG002 - as all formulas
        """Evaluate at a nominal diameter in m."""
        return sum(coefficient * diameter**power for power, coefficient in self.terms)

    def text(self, unit: str) -> str:
        """Write the formula with its unit."""
        powers = {0: "", 1: " d"}
        words = [number(c) + powers.get(n, f" d^{n}") for n, c in self.terms]
        formula = f"{' + '.join(words).replace('+ -', '- ')} {unit}"
        return Message("catalogue.in_metres", formula=formula)


@dataclass(frozen=True)
class ChainLoad:
    """Break or proof load of chain, c d^2 (44 - 0.08 d) in kN with d in mm.

    It peaks at d = 367 mm and means nothing near there: the range of the figure ends far below.
    """

    coefficient: float

    rests_on = ()

    def value(self, diameter: float, given: Given) -> float:  # noqa: ARG002
        """Evaluate at a nominal diameter in m; N."""
        d = diameter * _MM
        return self.coefficient * 1e3 * d**2 * (44.0 - 0.08 * d)

    def text(self, unit: str) -> str:  # noqa: ARG002 - the formula's own
        """Write the formula with its unit."""
        formula = f"{number(self.coefficient)} d^2 (44 - 0.08 d) kN"
        return Message("catalogue.in_millimetres", formula=formula)


@dataclass(frozen=True)
class ChainModulus:
    """EA of chain by DNV-OS-E301: modulus (a + b d) 1e10 N/m2, d in mm, on the area of both legs.

    The constant is a, the slope b; the area is pi d^2 / 2.
    """

    constant: float
    slope: float

    rests_on = ()

    def value(self, diameter: float, given: Given) -> float:  # noqa: ARG002
        """Evaluate at a nominal diameter in m; N."""
        modulus = (self.constant + self.slope * diameter * _MM) * 1e10
        return modulus * math.pi * diameter**2 / 2.0

    def text(self, unit: str) -> str:  # noqa: ARG002
        """Write the formula with its unit."""
        if self.slope == 0.0:
            return Message("catalogue.modulus", modulus=f"{number(self.constant)}e10 N/m2")
        sign = "-" if self.slope < 0.0 else "+"
        slope = number(abs(self.slope))
        modulus = f"({self.constant:.2f} {sign} {slope} d) 1e10 N/m2"
        return Message("catalogue.modulus_by_size", modulus=modulus)


@dataclass(frozen=True)
class Rows:
    """A printed table; between its rows value/d^2 is interpolated linearly.

    Nominal diameters rise, in m; the values beside them are in SI.
    """

    diameters: tuple[float, ...]
    values: tuple[float, ...]

    rests_on = ()

    def value(self, diameter: float, given: Given) -> float:  # noqa: ARG002
        """Evaluate at a nominal diameter in m: the printed value where it is a row's."""
        above = min(max(bisect_left(self.diameters, diameter), 1), len(self.diameters) - 1)
        (low, high) = self.diameters[above - 1 : above + 1]
        if diameter in (low, high):
            return self.values[above - 1 if diameter == low else above]
        ratios = (self.values[above - 1] / low**2, self.values[above] / high**2)
        share = (diameter - low) / (high - low)
        return (ratios[0] + share * (ratios[1] - ratios[0])) * diameter**2

    def text(self, unit: str) -> str:  # noqa: ARG002
        """Say what table it is."""
        low, high = (number(self.diameters[end] * _MM) for end in (0, -1))
        return Message("catalogue.rows", count=len(self.diameters), low=low, high=high)


_TIMES = {"proof_load": "catalogue.times_proof_load", "mass": "catalogue.times_mass"}
"""Keys of what a figure may be a multiple of."""


@dataclass(frozen=True)
class Multiple:
    """A multiple of another quantity; the factor is SI per SI."""

    factor: float
    of: str

    @property
    def rests_on(self) -> tuple[str, ...]:
        """The other quantity."""
        return (self.of,)

    def value(self, diameter: float, given: Given) -> float:  # noqa: ARG002
        """Evaluate; the diameter enters through the other quantity."""
        return self.factor * given(self.of)

    def text(self, unit: str) -> str:
        """Write the formula with its unit."""
        of = Message(_TIMES[self.of]) if self.of in _TIMES else self.of.replace("_", " ")
        values = {"factor": number(self.factor), "quantity": of}
        if not unit:
            return Message("catalogue.times_plain", **values)
        return Message("catalogue.times", unit=unit, **values)


@dataclass(frozen=True)
class Density:
    """Volume-equivalent diameter from the mass and the density of the material.

    D = sqrt(4 m / (pi rho)), so that mass, volume and weight in water agree.
    """

    density: float

    rests_on = ("mass",)

    def value(self, diameter: float, given: Given) -> float:  # noqa: ARG002
        """Evaluate; m."""
        return math.sqrt(4.0 * given("mass") / (math.pi * self.density))

    def text(self, unit: str) -> str:  # noqa: ARG002
        """Write the formula with its unit."""
        return Cited(f"sqrt(4 m / (pi rho)), rho = {number(self.density)} kg/m3")


@dataclass(frozen=True)
class Coefficient:
    """A coefficient of drag or added mass with the diameter that it is referred to."""

    coefficient: float
    ratio: float | None
    """The diameter over the nominal one; None for the volume-equivalent diameter."""
    name: str
    """The diameter as the data file names it: ``"d"``, ``"2.65 d"``, ``"d/pi"``, ``"volume"``."""

    @property
    def rests_on(self) -> tuple[str, ...]:
        """The volume-equivalent diameter, where it is referred to that."""
        return () if self.ratio is not None else ("volume_diameter",)

    def value(self, diameter: float, given: Given) -> float:  # noqa: ARG002
        """Return the coefficient."""
        return self.coefficient

    def reference(self, diameter: float, given: Given) -> float:
        """Evaluate the diameter that the coefficient is referred to; m."""
        return given("volume_diameter") if self.ratio is None else self.ratio * diameter

    def text(self, unit: str) -> str:  # noqa: ARG002
        """Write the coefficient with its diameter."""
        value = number(self.coefficient)
        if self.ratio is None:
            return Message("catalogue.on_volume", coefficient=value)
        return Message("catalogue.on", coefficient=value, diameter=self.name)


@dataclass(frozen=True)
class MeanLoad:
    """Dynamic stiffness of fibre rope, (a + b Lm) MBL with Lm = mean tension over MBL.

    The constant is a, the slope b; Lm is a fraction, not a percentage.
    """

    constant: float
    slope: float

    rests_on = ("MBL",)

    def value(self, diameter: float, given: Given) -> float:  # noqa: ARG002
        """Evaluate without mean tension; N."""
        return self.constant * given("MBL")

    def text(self, unit: str) -> str:  # noqa: ARG002
        """Write the formula."""
        a, b = number(self.constant), number(self.slope)
        return Message("catalogue.mean_load", stiffness=f"({a} + {b} Lm) MBL")


@dataclass(frozen=True)
class Constant:
    """A pure number."""

    number: float

    rests_on = ()

    def value(self, diameter: float, given: Given) -> float:  # noqa: ARG002
        """Return the number."""
        return self.number

    def text(self, unit: str) -> str:  # noqa: ARG002
        """Write the number."""
        return Cited(number(self.number))


Formula = (
    Polynomial | ChainLoad | ChainModulus | Rows | Multiple | Density | Coefficient | MeanLoad
    | Constant
)  # fmt: skip
