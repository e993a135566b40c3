"""Units against a units library (pint), and every way to get a unit wrong."""

from __future__ import annotations

import math
import subprocess
import sys
from contextlib import suppress
from fractions import Fraction
from typing import Any

import numpy as np
import pint
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from catopt import Line, Segment, solve
from catopt.errors import InputError
from catopt.units import UNITS, Dimension, as_written, to_si, units_in_si

# Both sides are a handful of rounded products: a few units in the last place.
ROUNDING = 8 * sys.float_info.epsilon


def problem_of(value: object, dimension: Dimension) -> tuple[str, str]:
    """Found and allowed of the one problem of a value."""
    with pytest.raises(InputError) as caught:
        to_si(value, dimension, key="line.length")
    (problem,) = caught.value.problems
    assert problem.key == "line.length"
    return problem.found, problem.allowed


@pytest.fixture(scope="module")
def library() -> pint.UnitRegistry[float]:
    return pint.UnitRegistry()


NOT_IN_THE_LIBRARY = {"shot", "shots", "USD/m"}
"""There a shot is a volume of drink, and no currency is defined."""


@pytest.mark.parametrize(
    ("dimension", "unit"),
    [(d, unit) for d, units in UNITS.items() for unit in units if unit not in NOT_IN_THE_LIBRARY],
)
def test_the_table_agrees_with_the_units_library(
    library: pint.UnitRegistry[float], dimension: Dimension, unit: str
) -> None:
    expected = library.Quantity(1.0, unit).to(dimension.si_unit).magnitude
    assert UNITS[dimension][unit] == pytest.approx(expected, rel=ROUNDING)


def test_every_dimension_has_its_si_unit_in_the_table() -> None:
    for dimension in Dimension:
        if dimension is not Dimension.NUMBER:
            assert UNITS[dimension][dimension.si_unit] == 1.0


@pytest.mark.parametrize("dimension", Dimension)
def test_every_example_is_in_the_table(dimension: Dimension) -> None:
    if dimension is not Dimension.NUMBER:
        example = dimension.example.strip('"')
        assert example.split()[1] in UNITS[dimension]
        assert to_si(example, dimension) > 0.0


@pytest.mark.parametrize(
    ("text", "dimension", "si"),
    [
        ("9.5 m", Dimension.LENGTH, 9.5),
        ("9.5m", Dimension.LENGTH, 9.5),
        (" +9.5   m ", Dimension.LENGTH, 9.5),
        ("-.5 m", Dimension.LENGTH, -0.5),
        ("\u22125 m", Dimension.LENGTH, -5.0),
        ("5. m", Dimension.LENGTH, 5.0),
        ("1e3 mm", Dimension.LENGTH, 1.0),
        ("95 mm", Dimension.LENGTH, 0.095),
        # A comma where no thousands can be meant; both marks; and, with three digits behind one
        # mark, the one reading that is plausible or is written so.
        ("31,3 m", Dimension.LENGTH, 31.3),
        ("0,343 tf", Dimension.FORCE, 0.343 * 9806.65),
        ("3,5e2 m", Dimension.LENGTH, 350.0),
        ("1.234,5 kN", Dimension.FORCE, 1234500.0),
        ("1,234.5 kN", Dimension.FORCE, 1234500.0),
        ("1.234.567 N", Dimension.FORCE, 1234567.0),
        ("1,025 t/m^3", Dimension.DENSITY, 1025.0),
        ("1.020 t/m^3", Dimension.DENSITY, 1020.0),
        ("17.425 m", Dimension.LENGTH, 17.425),
        ("0.343 tf", Dimension.FORCE, 0.343 * 9806.65),
        ("7100 kN", Dimension.FORCE, 7.1e6),
        ("80 MN", Dimension.FORCE, 8e7),
        ("2100 N/m", Dimension.FORCE_PER_LENGTH, 2100.0),
        ("9.5 kgf/m", Dimension.FORCE_PER_LENGTH, 93.163175),
        ("9.5 kg/m", Dimension.FORCE_PER_LENGTH, 93.163175),
        ("0.0095 t/m", Dimension.FORCE_PER_LENGTH, 93.163175),
        ("10.9 kg/m", Dimension.MASS_PER_LENGTH, 10.9),
        ("120 deg", Dimension.ANGLE, 2.0 * math.pi / 3.0),
        ("120°", Dimension.ANGLE, 2.0 * math.pi / 3.0),
        ("1.2 m/s", Dimension.SPEED, 1.2),
        ("2 kn", Dimension.SPEED, 2.0 * 1852.0 / 3600.0),
        ("1025 kg/m^3", Dimension.DENSITY, 1025.0),
        ("1025 kg/m3", Dimension.DENSITY, 1025.0),
        ("1025 kg/m³", Dimension.DENSITY, 1025.0),
        ("1025 kg / m**3", Dimension.DENSITY, 1025.0),
        ("1025 kg·m⁻³", Dimension.DENSITY, 1025.0),
        ("30 %", Dimension.NUMBER, 0.3),
        # 15 fathoms of 6 ft, 27.432 m, rounded as chain makers do.
        ("1 shot", Dimension.LENGTH, 27.5),
        ("4 shots", Dimension.LENGTH, 110.0),
        ("10 years", Dimension.TIME, 10 * 365.25 * 24 * 3600),
        ("1 year", Dimension.TIME, 31557600.0),
        ("0.4 mm/year", Dimension.SPEED, 0.4e-3 / 31557600.0),
        ("120 USD/m", Dimension.PRICE_PER_LENGTH, 120.0),
        ("36.576 USD/ft", Dimension.PRICE_PER_LENGTH, 120.0),
        # Units of words. By definition: 1 ft = 0.3048 m, 1 lb = 0.45359237 kg.
        ("100 ft", Dimension.LENGTH, 30.48),
        ("1 kip", Dimension.FORCE, 1000 * 0.45359237 * 9.80665),
        ("12 kip/ft", Dimension.FORCE_PER_LENGTH, 12000 * 0.45359237 * 9.80665 / 0.3048),
        ("6.4 lb/ft", Dimension.FORCE_PER_LENGTH, 6.4 * 0.45359237 * 9.80665 / 0.3048),
        ("100 gon", Dimension.ANGLE, math.pi / 2.0),
        ("2 tonne", Dimension.MASS, 2000.0),
    ],
)
def test_a_text_is_read_into_si(text: str, dimension: Dimension, si: float) -> None:
    assert to_si(text, dimension) == pytest.approx(si, rel=ROUNDING)


@pytest.mark.parametrize("number", [0, 3, -2.5, 1e-9])
def test_a_bare_number_is_si(number: float) -> None:
    value = to_si(number, Dimension.FORCE)
    assert value == number
    assert isinstance(value, float)


def test_a_bare_number_may_have_another_unit() -> None:
    assert to_si(50000, Dimension.MASS, bare="t") == 5e7
    assert to_si("50000 kg", Dimension.MASS, bare="t") == 50000.0


LENGTH = 'a length is required, such as "9.5 m"'
FORCE = 'a force is required, such as "50 kN"'


@pytest.mark.parametrize(
    ("value", "dimension", "found", "allowed"),
    [
        (
            "9.5",
            Dimension.LENGTH,
            '"9.5"',
            'a unit is missing: write "9.5 m", or 9.5 without quotes',
        ),
        ("0.3", Dimension.NUMBER, '"0.3"', "a pure number is required: write 0.3 without quotes"),
        ("", Dimension.LENGTH, '""', LENGTH),
        ("   ", Dimension.LENGTH, '"   "', LENGTH),
        ("m", Dimension.LENGTH, '"m"', LENGTH),
        ("about 9 m", Dimension.LENGTH, '"about 9 m"', LENGTH),
        (True, Dimension.LENGTH, "true", LENGTH),
        (None, Dimension.LENGTH, "None", LENGTH),
        ({"a": 1}, Dimension.LENGTH, "a table", LENGTH),
        ([9.5], Dimension.LENGTH, "an array of 1", LENGTH),
        (math.nan, Dimension.LENGTH, "nan", f"must be finite; {LENGTH}"),
        (-math.inf, Dimension.LENGTH, "-inf", f"must be finite; {LENGTH}"),
        ("nan m", Dimension.LENGTH, '"nan m"', f"must be finite; {LENGTH}"),
        ("-Inf m", Dimension.LENGTH, '"-Inf m"', f"must be finite; {LENGTH}"),
        ("1e999 m", Dimension.LENGTH, '"1e999 m"', f"must be finite; {LENGTH}"),
        ("1e308 km", Dimension.LENGTH, '"1e308 km"', f"must be finite; {LENGTH}"),
        (
            10**400,
            Dimension.LENGTH,
            "a whole number of more than 40 digits",
            f"must be finite; {LENGTH}",
        ),
        ("50.000 t", Dimension.MASS, '"50.000 t"', 'has two meanings: write "50 t" or "50000 t"'),
        ("50,000 t", Dimension.MASS, '"50,000 t"', 'has two meanings: write "50 t" or "50000 t"'),
        ("50.000", Dimension.MASS, '"50.000"', 'has two meanings: write "50 kg" or "50000 kg"'),
        ("1,500", Dimension.NUMBER, '"1,500"', "has two meanings: write 1.5 or 1500"),
        (
            "2,500 ft",
            Dimension.LENGTH,
            '"2,500 ft"',
            'has two meanings: write "2.5 ft" or "2500 ft"',
        ),
        ("1,2,3 m", Dimension.LENGTH, '"1,2,3 m"', f"not a single number; {LENGTH}"),
        ("1.5.5 m", Dimension.LENGTH, '"1.5.5 m"', f"not a single number; {LENGTH}"),
        ("1,5.5,5 m", Dimension.LENGTH, '"1,5.5,5 m"', f"not a single number; {LENGTH}"),
        ("5, m", Dimension.LENGTH, '"5, m"', f"not a single number; {LENGTH}"),
        ("1 000 m", Dimension.LENGTH, '"1 000 m"', f"not a single number; {LENGTH}"),
        ("1_000 m", Dimension.LENGTH, '"1_000 m"', f"not a single number; {LENGTH}"),
        ("5 m 20 cm", Dimension.LENGTH, '"5 m 20 cm"', f"not a unit known here; {LENGTH}"),
        ("3 bananas", Dimension.LENGTH, '"3 bananas"', f"not a unit known here; {LENGTH}"),
        ("3 degC", Dimension.LENGTH, '"3 degC"', f"not a unit known here; {LENGTH}"),
        ("3 m/", Dimension.LENGTH, '"3 m/"', f"not a unit known here; {LENGTH}"),
        ("3 m3", Dimension.LENGTH, '"3 m3", a volume', LENGTH),
        ("3 m4", Dimension.LENGTH, '"3 m4"', f"not a unit known here; {LENGTH}"),
        (
            "3 ppm",
            Dimension.ANGLE,
            '"3 ppm"',
            'not a unit known here; an angle is required, such as "5 deg"',
        ),
        ("9.5 kg", Dimension.LENGTH, '"9.5 kg", a mass', LENGTH),
        ("31 ft", Dimension.FORCE, '"31 ft", a length', FORCE),
        ("5 kN", Dimension.NUMBER, '"5 kN", a force', "a pure number is required, such as 0.5"),
        ("3 tf", Dimension.MASS, '"3 tf", a force', 'a mass is required, such as "5 t"'),
        (
            "9.5 kgf/m",
            Dimension.MASS_PER_LENGTH,
            '"9.5 kgf/m", a weight per length',
            'a mass per length is required, such as "10.9 kg/m"',
        ),
        (
            "50 t",
            Dimension.FORCE,
            '"50 t", a mass',
            'a force is required: write "50 tf" or "490.3 kN"',
        ),
        (
            "300 kg",
            Dimension.FORCE,
            '"300 kg", a mass',
            'a force is required: write "300 kgf" or "2.942 kN"',
        ),
        ("7100 KN", Dimension.FORCE, '"7100 KN"', "capitals matter: write kN"),
        ("9.5 M", Dimension.LENGTH, '"9.5 M"', "capitals matter: write m"),
        ("10 H", Dimension.TIME, '"10 H"', "capitals matter: write h"),
        (
            "120 USD",
            Dimension.PRICE_PER_LENGTH,
            '"120 USD"',
            'not a unit known here; a price per length is required, such as "120 USD/m"',
        ),
        (
            "50 kn",
            Dimension.FORCE,
            '"50 kn", a speed',
            "a force is required; capitals matter: write kN",
        ),
        (
            "80 mN",
            Dimension.FORCE,
            '"80 mN"',
            "mN is the millinewton; capitals matter: write MN or N",
        ),
        (
            "5 ton",
            Dimension.FORCE,
            '"5 ton"',
            "ton is ambiguous; write t (1000 kg) or tf (9.80665 kN)",
        ),
    ],
)
def test_a_wrong_value_is_explained(
    value: object, dimension: Dimension, found: str, allowed: str
) -> None:
    assert problem_of(value, dimension) == (found, allowed)


def test_what_is_written_is_shown_short_and_on_one_line() -> None:
    assert as_written("a\nb\x1b[31m") == '"a\\nb\\x1b[31m"'
    assert as_written("x" * 100) == '"' + "x" * 37 + '..."'
    assert as_written('Master\'s "buoy"') == '"Master\'s "buoy""'


@given(st.text(max_size=30), st.sampled_from(list(Dimension)))
@settings(deadline=None)  # words are listed in one of the examples
def test_any_text_is_read_or_refused(text: str, dimension: Dimension) -> None:
    _read_or_refused(text, dimension)


@given(
    st.floats(allow_nan=False),
    st.lists(st.sampled_from(["m", "kN", "/", "*", "^", "3", " ", "°", "ft", "-"]), max_size=6),
    st.sampled_from(list(Dimension)),
)
@settings(deadline=None)
def test_any_composed_unit_is_read_or_refused(
    number: float, unit: list[str], dimension: Dimension
) -> None:
    _read_or_refused(f"{number}{''.join(unit)}", dimension)


def _read_or_refused(text: str, dimension: Dimension) -> None:
    with suppress(InputError):
        assert math.isfinite(to_si(text, dimension))


KNOT, LB, FT = 1852.0 / 3600.0, 0.45359237, 0.3048
G0 = 9.80665
AS_WRITTEN = [
    # What buoy officers, ship's officers and engineers write, in English and in Vietnamese.
    ("12 ft", Dimension.LENGTH, 12 * FT),
    ("12 feet", Dimension.LENGTH, 12 * FT),
    ("20 metres", Dimension.LENGTH, 20.0),
    ("20 meters", Dimension.LENGTH, 20.0),
    ("11 fathom", Dimension.LENGTH, 66 * FT),
    ("11 fathoms", Dimension.LENGTH, 66 * FT),
    ("3 yd", Dimension.LENGTH, 9 * FT),
    ("2 in", Dimension.LENGTH, 0.0508),
    ("2 inches", Dimension.LENGTH, 0.0508),
    ("2 shots", Dimension.LENGTH, 55.0),
    ("1 nmi", Dimension.LENGTH, 1852.0),
    ("1 nautical mile", Dimension.LENGTH, 1852.0),
    ("12 mét", Dimension.LENGTH, 12.0),
    ("12 me\u0301t", Dimension.LENGTH, 12.0),  # the accent written apart
    ("12 Mét", Dimension.LENGTH, 12.0),
    ("40 milimét", Dimension.LENGTH, 0.04),
    ("1 hải lý", Dimension.LENGTH, 1852.0),
    ("50 knots", Dimension.SPEED, 50 * KNOT),
    ("50 Knots", Dimension.SPEED, 50 * KNOT),
    ("3 kt", Dimension.SPEED, 3 * KNOT),
    ("3 kts", Dimension.SPEED, 3 * KNOT),
    ("3 hải lý/giờ", Dimension.SPEED, 3 * KNOT),
    ("36 km/h", Dimension.SPEED, 10.0),
    ("36 km/giờ", Dimension.SPEED, 10.0),
    ("10 mph", Dimension.SPEED, 4.4704),
    ("5 ft/s", Dimension.SPEED, 5 * FT),
    ("5 mét/giây", Dimension.SPEED, 5.0),
    ("15 tấn", Dimension.MASS, 15000.0),
    ("15 tonnes", Dimension.MASS, 15000.0),
    ("15 metric tons", Dimension.MASS, 15000.0),
    ("10 lbs", Dimension.MASS, 10 * LB),
    ("10 kilôgam", Dimension.MASS, 10.0),
    ("15 tấn lực", Dimension.FORCE, 15000 * G0),
    ("5 kips", Dimension.FORCE, 5000 * LB * G0),
    ("500 lbf", Dimension.FORCE, 500 * LB * G0),
    ("8 sec", Dimension.TIME, 8.0),
    ("8 giây", Dimension.TIME, 8.0),
    ("5 năm", Dimension.TIME, 5 * 31557600.0),
    ("30 phút", Dimension.TIME, 1800.0),
    ("30 degrees", Dimension.ANGLE, math.pi / 6.0),
    ("30 độ", Dimension.ANGLE, math.pi / 6.0),
    ("100 sqft", Dimension.AREA, 100 * FT**2),
    ("64 lb/ft^3", Dimension.DENSITY, 64 * LB / FT**3),
    ("2,4 tấn/m3", Dimension.DENSITY, 2400.0),
]
"""By definition: 1 ft = 0.3048 m, a fathom 6 ft, 1 lb = 0.45359237 kg, a mile 5280 ft."""


@pytest.mark.parametrize(("text", "dimension", "si"), AS_WRITTEN)
def test_units_as_people_write_them_are_read(text: str, dimension: Dimension, si: float) -> None:
    assert to_si(text, dimension) == pytest.approx(si, rel=ROUNDING)


def test_tonnes_for_a_force_are_answered_with_the_way_out_in_either_language() -> None:
    for unit in ("t", "tonnes", "tấn"):
        assert problem_of(f"15 {unit}", Dimension.FORCE)[1] == (
            'a force is required: write "15 tf" or "147.1 kN"'
        )


OTHERWISE_THERE = {"shot", "shots", "USD", "J"}
"""A shot is a volume of drink there, no currency is defined, an energy is no moment."""
BY_SURVEY_FOOT = {"fathom", "fathoms"}
"""Six survey feet there, 2e-6 longer than six international ones."""


def test_words_agree_with_the_units_library(library: pint.UnitRegistry[float]) -> None:
    compared = 0
    for word, (si, _) in units_in_si().items():
        try:
            expected = library.Quantity(1.0, word).to_root_units().to_base_units().magnitude
        except (pint.UndefinedUnitError, AttributeError):
            continue
        if word in OTHERWISE_THERE:
            continue
        assert si == pytest.approx(expected, rel=3e-6 if word in BY_SURVEY_FOOT else ROUNDING), word
        compared += 1
    assert compared > 80


def test_no_units_library_is_wanted() -> None:
    code = (
        "import sys; sys.modules['pint'] = None\n"
        "from catopt.units import Dimension, to_si\n"
        "assert to_si('3 ft', Dimension.LENGTH) and to_si('50 knots', Dimension.SPEED)\n"
        "try: to_si('3 bananas', Dimension.LENGTH)\n"
        "except Exception as error: assert 'not a unit known here' in str(error)\n"
        "else: sys.exit(1)"
    )
    subprocess.run([sys.executable, "-c", code], check=True, timeout=60)


@pytest.mark.parametrize(
    ("text", "si"),
    [("5/8 in", 0.015875), ("1 1/4 in", 0.03175), ("1-1/8 in", 0.028575), ("5/16in", 0.0079375)],
)
def test_a_common_fraction(text: str, si: float) -> None:
    """An inch is 0.0254 m."""
    assert to_si(text, Dimension.LENGTH) == pytest.approx(si, rel=1e-15)


@pytest.mark.parametrize("text", ["5/8", "5/0 in", "5//8 in", "5/8/2 in", "1/1025 in"])
def test_what_is_no_common_fraction(text: str) -> None:
    with pytest.raises(InputError):
        to_si(text, Dimension.LENGTH)


@pytest.mark.parametrize("kind", [np.int64, np.int32, np.uint8, np.float32, np.array, Fraction])
def test_every_real_number_is_one(kind: Any) -> None:
    found = to_si(kind(75), Dimension.LENGTH)
    assert found == 75.0
    assert type(found) is float
    line = Line([Segment(length=kind(100), submerged_weight=kind(90))])
    assert type(line.length) in (int, float)
    plain = solve(Line([Segment(length=100, submerged_weight=90)]), height=60, span=75)
    assert solve(line, height=kind(60), span=kind(75)) == plain
