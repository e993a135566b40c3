"""The one table of quantities, with symbol, unit and digits: for every table, plot and workbook."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Literal

from catopt.constants import YEAR
from catopt.dimensions import UNITS, Dimension

Units = Literal["", "tf", "kN", "si"]
"""In which forces are shown: each quantity in its own unit of the table, tonne-force, kN, or all of
SI."""

_WITH_FORCE = re.compile(r"(kN|MN|N|kgf|tf)(²?)(.*)")
_FORCES: Mapping[str, Mapping[str, str]] = MappingProxyType(
    {
        "tf": {"N": "kgf", "kN": "tf", "MN": "tf"},
        "kN": {"kgf": "N", "tf": "kN"},
    }
)
"""What stands in the place of each unit of force."""

GREEK = MappingProxyType({"theta0": "θ₀", "theta1": "θ₁", "theta": "θ", "mu": "μ", "rho": "ρ"})
"""Symbols of quantities that are Greek letters."""


_MOST_PLACES = 12
_ROUNDING = 1e-9
"""In SI, of forces, lengths and angles that are put into a calculation: less is rounding."""


@dataclass(frozen=True)
class Quantity:
    """How one quantity, by its key of `QUANTITIES`, is called and printed.

    Scientific notation is for what goes down to rounding error; shortest for what is written in as
    few digits as it has, such as the diameter of a chain; significant where `digits` are those, of
    what is not rounding.
    """

    key: str
    name: str
    symbol: str
    """Empty where there is none."""
    si_unit: str
    """SI unit, in which catopt computes; ``"-"`` for a pure number, as is the field's."""
    field_unit: str
    factor: float
    """SI units in one field unit: 1000 for kN."""
    digits: int
    """After the decimal point, in the field unit."""
    notation: Literal["fixed", "scientific", "shortest", "significant"] = "fixed"
    floor: float = 0.0
    """What is smaller, in SI, is rounding, and printed as less than this."""
    rounding: float = 0.0
    """What is smaller, in SI, is rounding beside the rest of an answer, and printed as zero."""

    def to_field(self, si: float) -> float:
        """Convert a value (or an array) in SI to the field unit."""
        return si / self.factor

    def in_files(self, si: float) -> float:
        """Convert a value in SI to the field unit, without the last digit's noise of doing so.

        Examples
        --------
        >>> QUANTITIES["angle"].in_files(1.0471975511965976)  # 60 deg, not 59.99999999999999
        60.0
        """
        if self.factor == 1.0:
            return si
        field = self.to_field(si)
        short = float(f"{field:.12g}")
        return short if abs(short - field) <= 2.0 * math.ulp(field) else field

    def to_si(self, field: float) -> float:
        """Convert a value (or an array) in the field unit to SI."""
        return field * self.factor

    def in_units(self, units: Units) -> Quantity:
        """Take it in the units that somebody reads, to about the same digits.

        A hand calculation (``exact``) stays in SI, in which its formula holds.

        Examples
        --------
        >>> from catopt.quantities import QUANTITIES
        >>> QUANTITIES["tension"].in_units("tf").format(9806.65e3, unit=True)
        '1000.0000 tf'
        """
        if not units or self.key == "exact":
            return self
        if self.field_unit == "-":
            own = QUANTITIES.get(self.key, self)
            if own.field_unit == "-":
                return self
            shown = own.in_units(units)
            return replace(self, factor=shown.factor, digits=shown.digits)
        unit, factor = self.si_unit, 1.0
        if units != "si":
            found = _WITH_FORCE.fullmatch(self.field_unit)
            if found is None or found[1] not in _FORCES[units]:
                return self
            forces, other = UNITS[Dimension.FORCE], _FORCES[units][found[1]]
            unit, ratio = f"{other}{found[2]}{found[3]}", forces[other] / forces[found[1]]
            factor = self.factor * ratio ** (2 if found[2] else 1)
        if unit == self.field_unit:
            return self
        digits = self.digits
        if self.notation in {"fixed", "shortest"}:
            digits = max(0, digits + round(math.log10(factor / self.factor)))
        return replace(self, field_unit=unit, factor=factor, digits=digits)

    def places(self, si: float) -> int:
        """Count the digits behind the point of a value in SI: more where it is small.

        Two that count are printed of whatever is not zero.

        Examples
        --------
        >>> force = QUANTITIES["tension"]
        >>> [force.places(each) for each in (4281e3, 4.52, 4.5e-3, 0.0, 50.0)]
        [3, 4, 7, 3, 3]
        """
        return places_of(self.to_field(si), self.digits, 2) if self.is_seen(si) else self.digits

    def is_seen(self, si: float) -> bool:
        """Whether a value in SI is more than rounding."""
        return max(_ROUNDING, self.rounding) <= abs(si) < math.inf

    def format(self, si: float | None, *, unit: bool = False, digits: int | None = None) -> str:
        """Print a value in SI in the field unit, with it where wanted; None as a dash."""
        if si is None:
            return "-"
        places = self.digits if digits is None else digits
        value = self.to_field(si)
        if abs(si) < self.floor:
            return f"<{self.to_field(self.floor):.0e}"
        if self.notation == "scientific" and value != 0.0:
            text = f"{value:.{places}e}"
        elif self.notation == "significant":
            text = f"{value if abs(value) >= _ROUNDING else 0.0:.{places}g}"
        elif self.notation == "shortest":
            text = f"{round(value, places):.15g}"
        elif not math.isfinite(value):
            text = f"{value}"
        else:  # rounded first, so that what prints as zero does not print as -0.000
            if self.is_seen(si):
                places = places_of(value, places, 2)
            text = f"{round(value, places) + 0.0:.{places}f}"
        return f"{text} {self.field_unit}" if unit and self.field_unit != "-" else text


def places_of(value: float, places: int, count: int) -> int:
    """Count the digits behind the point for so many that count, or fewer that say the same."""
    if value == 0.0:
        return places
    most = min(count - 1 - math.floor(math.log10(abs(value))), _MOST_PLACES)
    if most <= places:
        return places
    text = f"{value:.{most}f}"
    return max(places, most - (len(text) - len(text.rstrip("0"))))


_SMALL, _SMALL_COUNT = 2, 5
_SCALED = re.compile(r"N\b|kg$")


def fitted(quantity: Quantity, values: Iterable[float], rounding: float = 0.0) -> Quantity:
    """Take a quantity of forces or masses with digits for the largest of some values, in SI.

    Where it has fewer than three that count, as at model scale, it gets five. What is smaller than
    `rounding` is printed as zero.

    Examples
    --------
    >>> fitted(QUANTITIES["tension"], [0.41394, 0.65609]).format(0.41394)
    '0.00041394'
    """
    if quantity.notation != "fixed":
        return quantity
    taken = replace(quantity, rounding=rounding) if rounding > quantity.rounding else quantity
    if not _SCALED.search(quantity.si_unit):
        return taken
    sizes = (abs(taken.to_field(each)) for each in values if taken.is_seen(each))
    largest = max(sizes, default=0.0)
    if 0.0 < largest < 10.0 ** (_SMALL - taken.digits):
        return replace(taken, digits=places_of(largest, taken.digits, _SMALL_COUNT))
    return taken


def _length(key: str, name: str, symbol: str) -> Quantity:
    return Quantity(key, name, symbol, "m", "m", 1.0, 3)


def _diameter(key: str, name: str, symbol: str) -> Quantity:
    return Quantity(key, name, symbol, "m", "mm", 1e-3, 1)


def _force(key: str, name: str, symbol: str) -> Quantity:
    return Quantity(key, name, symbol, "N", "kN", 1e3, 3)


_TABLE = (
    _force("horizontal_force", "Horizontal force", "H"),
    _force("vertical_force", "Vertical force", "V"),
    _force("tension", "Tension", "T"),
    _force("point_weight", "Submerged weight", "W"),
    _force("seabed_reaction", "Seabed reaction", "R"),
    Quantity("MBL", "Minimum breaking load", "MBL", "N", "kN", 1e3, 1),
    Quantity("proof_load", "Proof load", "", "N", "kN", 1e3, 1),
    Quantity("EA", "Axial stiffness", "EA", "N", "MN", 1e6, 2),
    _diameter("nominal_diameter", "Nominal diameter", "d"),
    _diameter("volume_diameter", "Volume-equivalent diameter", ""),
    _diameter("drag_diameter", "Drag diameter", ""),
    Quantity("coefficient", "Coefficient", "", "-", "-", 1.0, 3),
    Quantity("strain", "Strain", "", "-", "-", 1.0, 5),
    Quantity("price", "Price", "", "USD/m", "USD/m", 1.0, 2),
    Quantity("cost", "Cost", "", "USD", "USD", 1.0, 0),
    replace(_length("span", "Span", "S"), rounding=1e-6),
    _length("offset", "Offset", ""),
    _length("excursion", "Excursion", ""),
    _length("height", "Height", "h"),
    _length("fairlead_height", "Fairlead height", ""),
    _length("anchor_height", "Anchor height", ""),
    _length("water_depth", "Water depth", "d"),
    _length("contact_offset", "Contact offset", ""),
    _length("length", "Length", "L"),
    _length("grounded_length", "Grounded length", ""),
    _length("suspended_length", "Suspended length", ""),
    _length("stretched_length", "Stretched length", ""),
    _length("position", "Position from the anchor", ""),
    _length("s", "Arc length", "s"),
    _length("x", "Distance from the anchor", "x"),
    _length("z", "Height above the seabed", "z"),
    Quantity("angle", "Inclination", "theta", "rad", "deg", math.pi / 180.0, 2),
    Quantity("angle_rad", "Inclination", "theta", "rad", "rad", 1.0, 4),
    Quantity("submerged_weight", "Submerged weight per length", "w", "N/m", "N/m", 1.0, 2),
    Quantity("mass", "Mass", "m", "kg", "t", 1e3, 3),
    Quantity("mass_per_length", "Mass per length", "m", "kg/m", "kg/m", 1.0, 2),
    Quantity("wear_rate", "Wear", "", "m/s", "mm/year", 1e-3 / YEAR, 3, "shortest"),
    Quantity("utilisation", "Utilisation", "", "-", "-", 1.0, 3),
    Quantity("failing", "Checks that fail", "", "-", "-", 1.0, 0),
    Quantity("reserve", "Mean over standard deviation", "", "-", "-", 1.0, 2),
    Quantity("zero_crossing_period", "Zero-crossing period", "T_z", "s", "s", 1.0, 2),
    Quantity("safety_factor", "Safety factor", "SF", "-", "-", 1.0, 2),
    Quantity("friction", "Seabed friction", "mu", "-", "-", 1.0, 2),
    Quantity("density", "Density", "rho", "kg/m^3", "kg/m^3", 1.0, 1),
    Quantity("adhesion", "Adhesion", "c", "N/m^2", "kPa", 1e3, 1),
    Quantity("base_area", "Area of the base", "A", "m^2", "m^2", 1.0, 2),
    Quantity("moment", "Moment on the body", "M", "N*m", "kN*m", 1e3, 1),
    Quantity("stiffness", "Stiffness", "k", "N/m", "kN/m", 1e3, 3),
    Quantity("force_by_turning", "Force by turning", "k", "N/rad", "kN/rad", 1e3, 1),
    Quantity("moment_by_shift", "Moment by displacement", "k", "N*m/m", "kN*m/m", 1e3, 1),
    Quantity("moment_by_turning", "Moment by turning", "k", "N*m/rad", "kN*m/rad", 1e3, 0),
    Quantity("objective", "Objective", "f", "m", "m", 1.0, 2, "scientific"),
    Quantity("residual", "Residual", "", "m", "m", 1.0, 2, "scientific"),
    Quantity("angle_difference", "Difference of angles", "", "rad", "rad", 1.0, 2, "scientific"),
    Quantity("force_difference", "Difference of forces", "", "N", "N", 1.0, 2, "scientific"),
)

QUANTITIES: Mapping[str, Quantity] = MappingProxyType({q.key: q for q in _TABLE})
"""Every quantity by its key."""


def significant(unit: str, digits: int = 6) -> Quantity:
    """Take what is written with some significant digits, in an SI unit."""
    return Quantity("", "", "", unit, unit, 1.0, digits, "significant")


def fixed(unit: str, digits: int) -> Quantity:
    """Take what is written with some digits after the point, in an SI unit."""
    return Quantity("", "", "", unit, unit, 1.0, digits)
