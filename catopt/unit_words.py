"""Units as people write them beyond the field's own: ``ft``, ``knots``, ``mét``, ``kip/ft``.

A unit is a word, or words with ``*``, ``/`` and whole powers between them. Each word is worth so
much in SI, and has powers of metre, kilogram, second, radian and US dollar. Values are the
definitions: the international foot and pound (1959), the nautical mile of 1852 m, standard gravity.
"""

from __future__ import annotations

import math
import re
import unicodedata
from collections.abc import Mapping
from functools import cache
from typing import Final

from catopt.constants import STANDARD_GRAVITY, YEAR

__all__ = ["Powers", "known", "worth"]

Powers = tuple[int, int, int, int, int]
"""Of metre, kilogram, second, radian and US dollar."""

_METRE, _KILOGRAM, _SECOND = (1, 0, 0, 0, 0), (0, 1, 0, 0, 0), (0, 0, 1, 0, 0)
_SPEED, _NEWTON, _PASCAL = (1, 0, -1, 0, 0), (1, 1, -2, 0, 0), (-1, 1, -2, 0, 0)
_POUND, _FOOT, _NAUTICAL_MILE = 0.45359237, 0.3048, 1852.0
_POUND_FORCE = _POUND * STANDARD_GRAVITY
_TONNE_FORCE = 1000.0 * STANDARD_GRAVITY

_WORDS: Final[tuple[tuple[str, float, Powers], ...]] = (
    ("m metre metres meter meters mét", 1.0, _METRE),
    ("km kilometre kilometres kilometer kilometers kilômét kilomét", 1e3, _METRE),
    ("dm", 0.1, _METRE),
    ("cm centimetre centimetres centimeter centimeters xentimét", 1e-2, _METRE),
    ("mm millimetre millimetres millimeter millimeters milimét", 1e-3, _METRE),
    ("um µm μm", 1e-6, _METRE),
    ("ft foot feet", _FOOT, _METRE),
    ("in inch inches", _FOOT / 12.0, _METRE),
    ("yd yard yards", 3.0 * _FOOT, _METRE),
    ("fathom fathoms ftm", 6.0 * _FOOT, _METRE),
    ("shot shots", 27.5, _METRE),
    ("mi mile miles", 5280.0 * _FOOT, _METRE),
    ("nmi NM nautical_mile nautical_miles hải_lý", _NAUTICAL_MILE, _METRE),
    ("kg kilogram kilograms kilogramme kilôgam kilogam", 1.0, _KILOGRAM),
    ("g gram grams", 1e-3, _KILOGRAM),
    ("t tonne tonnes metric_ton metric_tons metric_tonne metric_tonnes tấn", 1e3, _KILOGRAM),
    ("lb lbs pound pounds", _POUND, _KILOGRAM),
    ("s sec second seconds giây", 1.0, _SECOND),
    ("ms", 1e-3, _SECOND),
    ("min minute minutes phút", 60.0, _SECOND),
    ("h hr hrs hour hours giờ", 3600.0, _SECOND),
    ("d day days ngày", 86400.0, _SECOND),
    ("year years yr yrs năm", YEAR, _SECOND),
    ("kn kt kts knot knots nút", _NAUTICAL_MILE / 3600.0, _SPEED),
    ("mph", 5280.0 * _FOOT / 3600.0, _SPEED),
    ("kph kmh", 1.0 / 3.6, _SPEED),
    ("fps", _FOOT, _SPEED),
    ("rad radian radians", 1.0, (0, 0, 0, 1, 0)),
    ("deg degree degrees độ", math.pi / 180.0, (0, 0, 0, 1, 0)),
    ("gon grad", math.pi / 200.0, (0, 0, 0, 1, 0)),
    ("N newton newtons niutơn", 1.0, _NEWTON),
    ("kN kilonewton kilonewtons kilôniutơn", 1e3, _NEWTON),
    ("MN meganewton meganewtons", 1e6, _NEWTON),
    ("GN giganewton giganewtons", 1e9, _NEWTON),
    ("kgf", STANDARD_GRAVITY, _NEWTON),
    ("tf tấn_lực tonne_force tonnes_force", _TONNE_FORCE, _NEWTON),
    ("lbf", _POUND_FORCE, _NEWTON),
    ("kip kips", 1e3 * _POUND_FORCE, _NEWTON),
    ("Pa pascal", 1.0, _PASCAL),
    ("hPa", 1e2, _PASCAL),
    ("kPa", 1e3, _PASCAL),
    ("MPa", 1e6, _PASCAL),
    ("GPa", 1e9, _PASCAL),
    ("mbar", 1e2, _PASCAL),
    ("bar bars", 1e5, _PASCAL),
    ("psi", _POUND_FORCE / (_FOOT / 12.0) ** 2, _PASCAL),
    ("ksi", 1e3 * _POUND_FORCE / (_FOOT / 12.0) ** 2, _PASCAL),
    ("sqm", 1.0, (2, 0, 0, 0, 0)),
    ("sqft", _FOOT**2, (2, 0, 0, 0, 0)),
    ("l L litre litres liter liters lít", 1e-3, (3, 0, 0, 0, 0)),
    ("J", 1.0, (2, 1, -2, 0, 0)),
    ("USD", 1.0, (0, 0, 0, 0, 1)),
)
_TOGETHER: Final = (
    *("nautical mile", "nautical miles", "metric ton", "metric tons", "metric tonne"),
    *("metric tonnes", "tonne force", "tonnes force", "hải lý", "tấn lực"),
)
"""Units of two words, which are no product."""
_PART: Final = re.compile(r"([*/ ])?([^\W\d]\w*?)(?:\^(-?[1-9]))?(?=[*/ ]|$)")


@cache
def known() -> Mapping[str, tuple[float, Powers]]:
    """List every word with its worth in SI and its powers."""
    return {word: (si, powers) for words, si, powers in _WORDS for word in words.split()}


def worth(unit: str) -> tuple[float, Powers] | None:
    """Find what a unit is worth in SI, and its powers; None for what is no unit.

    Capitals count in what is as short as a symbol.

    Examples
    --------
    >>> value, powers = worth("kip/ft")
    >>> round(value, 4), powers
    (14593.9029, (0, 1, -2, 0, 0))
    >>> worth("Hải lý/giờ")
    (0.5144444444444445, (1, 0, -1, 0, 0))
    """
    text = unicodedata.normalize("NFC", unit)
    for words in _TOGETHER:
        text = re.sub(rf"(?i)\b{words}\b", words.replace(" ", "_"), text)
    if text != "".join(found[0] for found in _PART.finditer(text)):
        return None
    si, powers = 1.0, [0] * 5
    for between, word, power in _PART.findall(text):
        is_long = len(word) > 3 or not word.isascii()
        found = known().get(word) or (known().get(word.casefold()) if is_long else None)
        if found is None:
            return None
        times = int(power or 1) * (-1 if between == "/" else 1)
        si *= found[0] ** times
        powers = [a + times * b for a, b in zip(powers, found[1], strict=True)]
    a, b, c, d, e = powers
    return si, (a, b, c, d, e)
