"""Design wind of places in Viet Nam, by wind zone and return period.

Zones are those of QCVN 02:2022/BXD, whose table was not read itself: it is that of a public
registry of it, checked by W0 = 0.0613 V0^2 and the factor of 50 years. A place that is recalled (R)
was read nowhere and counts only where recalled figures are asked for.
"""

from __future__ import annotations

import math
import unicodedata
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

from catopt.constants import YEAR
from catopt.errors import refused
from catopt.words import Message

ZONES: Final[Mapping[str, tuple[float, float]]] = MappingProxyType(
    {
        "I": (650.0, 26.0),
        "II": (950.0, 31.0),
        "III": (1250.0, 36.0),
        "IV": (1550.0, 40.0),
        "V": (1850.0, 43.0),
    }
)
"""By zone of QCVN 02:2022/BXD, 5.2 to 5.4 [B]: base pressure W0, Pa, of a gust of 3 s in 20 years;
wind at 10 m over open country, mean of 10 min in 50 years, m/s."""

FACTORS: Final[Mapping[int, tuple[float, str]]] = MappingProxyType(
    {
        5: (0.74, "R"),
        10: (0.87, "C"),
        20: (1.0, "B"),
        30: (1.10, "C"),
        40: (1.16, "R"),
        50: (1.20, "B"),
        100: (1.37, "R"),
    }
)
"""Wind pressure over that of 20 years, by return period in years: QCVN 02:2009/BXD, with its
confidence: 10 and 30 years as a design text cites them, 50 by the speeds of the zones."""

USUAL_PERIOD: Final = 50.0 * YEAR
"""s, that the table of zones has."""

PLACES: Final[Mapping[str, tuple[str, str]]] = MappingProxyType(
    {
        "Vung Tau": ("II", "C"),
        "Con Dao": ("III", "C"),
        "Ho Chi Minh City": ("II", "C"),
        "Can Tho": ("II", "C"),
        "Truong Sa": ("IV", "C"),
        "Hoang Sa": ("V", "C"),
        "Ha Long": ("III", "R"),
        "Hai Phong": ("IV", "R"),
        "Bach Long Vi": ("V", "R"),
        "Da Nang": ("II", "R"),
        "Quy Nhon": ("III", "R"),
        "Nha Trang": ("II", "R"),
    }
)
"""Zone of a place and its confidence: C of QCVN 02:2022's table in a secondary source."""


@dataclass(frozen=True)
class PlaceWind:
    """Wind of a place: a mean of 10 min at 10 m, m/s, and what it is of."""

    speed: float
    zone: str
    confidence: str
    """The weakest of what it rests on."""
    period: float
    """Return period, s."""


def wind_of_place(name: str, period: float = USUAL_PERIOD, *, recalled: bool = False) -> PlaceWind:
    """Look up the wind of a place, or of ``zone I`` to ``zone V``, for a return period, s.

    V = V(50 years) sqrt(k/k(50 years)) with the factors k of pressure. InputError: an unknown place
    or period; a recalled figure that was not asked for.

    Examples
    --------
    >>> from catopt.loads.design_wind import wind_of_place
    >>> wind_of_place("Vung Tau").speed
    31.0
    """
    found = {_plain(each): each for each in PLACES}
    zone, confidence = "", "B"
    if _plain(name) in found:
        zone, confidence = PLACES[found[_plain(name)]]
    elif _plain(name).startswith("zone "):
        zone = _plain(name).removeprefix("zone ").strip().upper()
    if zone not in ZONES:
        listed = ", ".join((*PLACES, "zone I to V"))
        raise refused("place", f'"{name}"', Message("refused.of_these", words=listed), "place")
    years = period / YEAR
    key = next((each for each in FACTORS if math.isclose(each, years, rel_tol=1e-6)), None)
    if key is None:
        listed = ", ".join(str(each) for each in FACTORS)
        allowed = Message("refused_sizing.period_of_place", listed=listed)
        said = Message("refused_file.years", count=years)
        raise refused("return_period", said, allowed, "place")
    factor, of_period = FACTORS[key]
    weakest = max(confidence, of_period)  # A, B, C, R: by letter
    if weakest == "R" and not recalled:
        as_years: str = Message("refused_file.years", count=years)
        what, found_one = "return_period", as_years
        if confidence == "R":
            what, found_one = "place", f'"{name}"'
        allowed = Message("refused_sizing.recalled_place")
        raise refused(what, found_one, allowed, "place")
    speed = ZONES[zone][1] * math.sqrt(factor / FACTORS[50][0])
    return PlaceWind(speed, zone, weakest, period)


def _plain(name: str) -> str:
    """Leave out accents and capitals: Vũng Tàu is vung tau."""
    apart = unicodedata.normalize("NFD", name.replace("Đ", "D").replace("đ", "d"))
    return "".join(each for each in apart if not unicodedata.combining(each)).strip().lower()
