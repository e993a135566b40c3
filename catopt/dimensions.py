"""What a quantity can be, and the table of units that the field writes."""

from __future__ import annotations

import math
from collections.abc import Mapping
from enum import Enum
from types import MappingProxyType

from catopt.constants import STANDARD_GRAVITY, YEAR


class Dimension(Enum):
    """What a quantity is: its noun for messages, its SI unit, and a value as a case file has it.

    The smallest and the largest value (SI, without sign) between which every plausible one lies
    that is not 0 keep apart what a file can mean from slips of the unit or of a power of ten: an
    angle of more than a turn is one in degrees. Of what has a direction, rounding leaves 1e-14.
    """

    LENGTH = ("a length", "m", '"9.5 m"', 1e-18, 1e6)
    FORCE = ("a force", "N", '"50 kN"', 1e-18, 1e12)
    FORCE_PER_LENGTH = ("a weight per length", "N/m", '"9.5 kgf/m"', 1e-9, 1e7)
    MASS = ("a mass", "kg", '"5 t"', 1e-9, 1e10)
    MASS_PER_LENGTH = ("a mass per length", "kg/m", '"10.9 kg/m"', 1e-9, 1e6)
    DENSITY = ("a density", "kg/m^3", '"1025 kg/m^3"', 1e-3, 3e4)
    MOMENT = ("a moment", "N*m", '"5 MN*m"', 1e-18, 1e15)
    ANGLE = ("an angle", "rad", '"5 deg"', 1e-18, 7.0)
    SPEED = ("a speed", "m/s", '"1.2 m/s"', 1e-15, 200.0)
    ACCELERATION = ("an acceleration", "m/s^2", '"9.81 m/s^2"', 1e-9, 1e4)
    TIME = ("a time", "s", '"8 s"', 1e-6, 1e11)
    AREA = ("an area", "m^2", '"380 mm^2"', 1e-12, 1e7)
    VOLUME = ("a volume", "m^3", '"2.5 m^3"', 1e-12, 1e8)
    PRESSURE = ("a pressure or modulus", "Pa", '"56 GPa"', 1e-6, 1e15)
    DAMPING = ("a damping", "N*s/m", '"50 kN*s/m"', 1e-9, 1e12)
    DAMPING_PER_LENGTH = ("a damping per length", "N*s/m^2", '"10 kN*s/m^2"', 1e-9, 1e12)
    PRICE_PER_LENGTH = ("a price per length", "USD/m", '"120 USD/m"', 1e-6, 1e7)
    NUMBER = ("a pure number", "", "0.5", 1e-9, 1e6)

    def __init__(self, noun: str, si_unit: str, example: str, least: float, most: float) -> None:
        self.noun, self.si_unit, self.example = noun, si_unit, example
        self.smallest, self.largest = least, most


_TONNE, _TONNE_FORCE = 1000.0, 1000.0 * STANDARD_GRAVITY
_KNOT = 1852.0 / 3600.0
_SHOT = 27.5

UNITS: Mapping[Dimension, Mapping[str, float]] = MappingProxyType(
    {
        Dimension.LENGTH: {
            "m": 1.0,
            "mm": 1e-3,
            "cm": 1e-2,
            "km": 1e3,
            "shot": _SHOT,
            "shots": _SHOT,
        },
        Dimension.FORCE: {
            "N": 1.0,
            "kN": 1e3,
            "MN": 1e6,
            "kgf": STANDARD_GRAVITY,
            "tf": _TONNE_FORCE,
        },
        Dimension.FORCE_PER_LENGTH: {
            "N/m": 1.0,
            "kN/m": 1e3,
            "kgf/m": STANDARD_GRAVITY,
            "tf/m": _TONNE_FORCE,
        },
        Dimension.MASS: {"kg": 1.0, "t": _TONNE},
        Dimension.MASS_PER_LENGTH: {"kg/m": 1.0, "t/m": _TONNE},
        Dimension.DENSITY: {"kg/m^3": 1.0, "t/m^3": _TONNE, "g/cm^3": 1e3},
        Dimension.MOMENT: {"N*m": 1.0, "kN*m": 1e3, "MN*m": 1e6, "tf*m": _TONNE_FORCE},
        Dimension.ANGLE: {"rad": 1.0, "deg": math.pi / 180.0},
        Dimension.SPEED: {
            "m/s": 1.0,
            "cm/s": 1e-2,
            "km/h": 1.0 / 3.6,
            "kn": _KNOT,
            "knot": _KNOT,
            "mm/year": 1e-3 / YEAR,
        },
        Dimension.ACCELERATION: {"m/s^2": 1.0},
        Dimension.TIME: {"s": 1.0, "min": 60.0, "h": 3600.0, "year": YEAR, "years": YEAR},
        Dimension.AREA: {"m^2": 1.0, "cm^2": 1e-4, "mm^2": 1e-6},
        Dimension.VOLUME: {"m^3": 1.0},
        Dimension.PRESSURE: {
            "Pa": 1.0,
            "kPa": 1e3,
            "MPa": 1e6,
            "GPa": 1e9,
            "N/m^2": 1.0,
            "kN/m^2": 1e3,
            "N/mm^2": 1e6,
        },
        Dimension.DAMPING: {"N*s/m": 1.0, "kN*s/m": 1e3, "kg/s": 1.0},
        Dimension.DAMPING_PER_LENGTH: {"N*s/m^2": 1.0, "kN*s/m^2": 1e3, "Pa*s": 1.0},
        Dimension.PRICE_PER_LENGTH: {"USD/m": 1.0},
        Dimension.NUMBER: {"%": 1e-2},
    }
)
"""SI units in one of each unit that the field writes.

A knot is 1852 m/h, a shot of chain 27.5 m, a year the Julian one.
"""
