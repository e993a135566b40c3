"""Dimensions of a ship from its deadweight: the table, its fits and another register."""

from __future__ import annotations

import math

import pytest

from catopt.errors import InputError
from catopt.loads.ship import MOULDED, ship_dimensions

FITS = {
    "tanker": {
        "length": (10.38, 0.2785, 0.07),
        "breadth": (0.779, 0.3478, 0.04),
        "moulded_depth": (0.749, 0.2843, 0.03),
        "draught": (0.669, 0.2713, 0.04),
    },
    "bulk carrier": {
        "length": (8.75, 0.2932, 0.04),
        "breadth": (0.910, 0.3264, 0.04),
        "moulded_depth": (0.664, 0.2982, 0.04),
        "draught": (0.415, 0.3134, 0.04),
    },
    "general cargo": {
        "length": (6.69, 0.3243, 0.02),
        "breadth": (1.175, 0.3067, 0.02),
        "moulded_depth": (0.440, 0.3495, 0.02),
        "draught": (0.390, 0.3275, 0.02),
    },
}
"""a DWT^b and the largest error that is stated of it (engineering facts, second sheet, 3)."""

ROUNDED = 0.006
"""Beside that: the errors are whole per cent, and 0.1 m of a draught of 8 m is another."""

RANGES = {"tanker": (3e3, 300e3), "bulk carrier": (10e3, 300e3), "general cargo": (5e3, 40e3)}


@pytest.mark.parametrize("kind", FITS)
def test_every_deadweight_is_near_the_fit_of_the_same_source(kind: str) -> None:
    first, last = RANGES[kind]
    for step in range(61):
        tonnes = first * (last / first) ** (step / 60)
        found = ship_dimensions(kind, tonnes * 1e3)
        for name, (a, b, error) in FITS[kind].items():
            assert getattr(found, name) == pytest.approx(a * tonnes**b, rel=error + ROUNDED)


@pytest.mark.parametrize(
    ("kind", "a", "b"), [("tanker", 1621.4, 0.0165), ("bulk carrier", 2040.7, 0.0156)]
)
@pytest.mark.parametrize("tonnes", [20e3, 45e3, 100e3, 300e3])
def test_lengths_agree_with_another_register(kind: str, a: float, b: float, tonnes: float) -> None:
    """Danish Maritime Authority: DWT = a exp(b LOA); within 15 % from 20,000 t, as stated."""
    length = math.log(tonnes / a) / b
    assert ship_dimensions(kind, tonnes * 1e3).length == pytest.approx(length, rel=0.15)


def test_a_row_of_the_table_is_met_and_halfway_is_the_geometric_mean() -> None:
    """Tankers of 10,000 and 20,000 t: 145 and 174 m, 19.0 and 24.5 m; 14,142 t lies between."""
    assert ship_dimensions("tanker", 50e6) == (210.0, 32.2, 16.4, 12.6)
    between = ship_dimensions("tanker", 1e7 * math.sqrt(2.0))
    # sqrt(145 * 174) = 158.84 and sqrt(19.0 * 24.5) = 21.575, rounded as the table is.
    assert between[:2] == (159.0, 21.6)


@pytest.mark.parametrize(
    ("kind", "tonnes", "allowed"),
    [
        ("tanker", 2999.0, "from 3000 to 300000 t"),
        ("general cargo", 50e3, "from 5000 to 40000 t"),
        ("ferry", 5e3, "one of tanker, bulk carrier, general cargo"),
    ],
)
def test_nothing_is_estimated_beyond_the_table(kind: str, tonnes: float, allowed: str) -> None:
    with pytest.raises(InputError, match=allowed):
        ship_dimensions(kind, tonnes * 1e3)


# Deadweight; LOA, breadth, depth and full draught of tanker, bulk carrier and general cargo (second
# sheet, section 3: PIANC 2002 / ROM 3.1, recalled).
ROWS = """
  3000  90 13.0  7.2  6.0 |                    |
  5000 110 15.0  8.6  7.0 |                    | 105 15.8  8.5  6.4
 10000 145 19.0 10.0  7.8 | 130 18.0 10.0  7.5 | 133 19.8 11.2  8.0
 20000 174 24.5 12.6  9.8 | 160 23.5 12.6  9.3 | 166 24.8 13.8 10.0
 30000 188 28.0 14.2 10.8 |                    | 188 27.7 16.0 11.3
 40000 200 30.0 15.4 11.8 | 195 29.0 16.3 11.5 | 209 30.0 18.0 12.5
 50000 210 32.2 16.4 12.6 |                    |
 60000 217 36.0 17.0 13.0 | 220 33.5 18.2 12.8 |
100000 250 43.0 19.8 15.1 | 255 39.0 20.8 15.3 |
150000 285 49.5 22.0 16.9 | 290 44.0 23.3 17.5 |
200000 310 55.0 24.0 18.5 | 315 48.5 25.0 19.0 |
300000 350 63.0 27.0 21.0 | 350 56.0 28.1 21.8 |
"""


@pytest.mark.parametrize("row", ROWS.split("\n")[1:-1])
def test_every_row_of_the_table_is_that_of_the_sheet(row: str) -> None:
    tonnes, of_kinds = float(row[:6]), row[6:].split("|")
    for kind, cells in zip(("tanker", "bulk carrier", "general cargo"), of_kinds, strict=True):
        figures = [float(cell) for cell in cells.split()]
        if figures:
            found = ship_dimensions(kind, tonnes * 1e3)
            assert list(found) == pytest.approx(figures, rel=1e-12)


def test_the_moulded_depth_that_is_taken_for_want_of_another() -> None:
    """1.3 draughts (docs/sizing.md); the table has 16.4/12.6 = 1.302 for a tanker of 50,000 t."""
    assert MOULDED == 1.3
    of = ship_dimensions("tanker", 50e6)
    assert of.moulded_depth / of.draught == pytest.approx(1.302, abs=5e-4)
