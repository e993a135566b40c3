"""Anchors and fittings of the catalogue against what their sources print."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from catopt import catalogue
from catopt.catalogue.fittings import OF_A_CHAIN, anchor_types, fittings, fittings_for
from catopt.errors import InputError
from catopt.words import say

LBF = 4.4482216152605

# ------------------------------------------------------------------ anchors

SOLD = {
    "stockless": (136.0, 16443.0, 16),
    "Danforth": (225.0, 13610.0, 21),
    "LWT": (227.0, 45360.0, 19),
    "AC-14": (180.0, 21750.0, 55),
    "Moorfast": (454.0, 45359.0, 17),
    "Bruce cast": (600.0, 9000.0, 6),
    "Stevin": (1000.0, 30000.0, 10),
    "Stevpris Mk5": (1500.0, 65000.0, 13),
    "Bruce FFTS Mk4": (500.0, 40000.0, 12),
    "Bruce FFTS GP": (500.0, 40000.0, 12),
}
"""DTOcean's database: smallest and largest mass of each kind, kg, and how many there are."""


def test_the_masses_that_are_sold() -> None:
    by_name = {each.name: each for each in anchor_types()}
    for name, (low, high, count) in SOLD.items():
        kind = by_name[name]
        assert (*kind.range, len(kind.masses)) == (low, high, count)
        assert list(kind.masses) == sorted(set(kind.masses))
        assert kind.confidence == "C"


def test_every_anchor_names_source_soil_and_price() -> None:
    for kind in anchor_types():
        assert kind.title
        assert kind.sources
        assert kind.holdings
        # MoorPy's point properties: 4.15 dollars of 2024 a kg.
        assert kind.price_per_mass == 4.15
        for holding in kind.holdings:
            assert holding.sources
            assert holding.place
            assert 0.5 < holding.exponent < 1.0


# ------------------------------------------------------------------ fittings

MIL = """
44 247 352
51 318 454
57 396 570
63.5 484 692
70 578 826
76 679 970
89 900 1285
102 1143 1632
"""
"""MIL-DTL-18295F, table II: chain (mm), proof and breaking load of finished components (klbf)."""

GREEN_PIN = """
22 4.75 1.18 279490
32 9.5 3.66 558979
50 25 14.22 1470998
70 55 39.59 3236195
95 120 110 5886000
150 300 340 14715000
"""
"""DTOcean, bow shackle, safety: pin (mm), WLL (t), mass (kg), MBL (N); six or five times WLL."""


def rows(table: str) -> list[list[float]]:
    return [[float(cell) for cell in line.split()] for line in table.strip().splitlines()]


@pytest.mark.parametrize(
    "name",
    ["joining shackle", "anchor shackle", "buoy shackle", "chain joining link", "pear link",
     "anchor joining link", "end link", "spider plate", "swivel shackle", "ground ring"],
)  # fmt: skip
def test_fittings_of_fleet_moorings(name: str) -> None:
    own = {round(each.size * 1e3, 1): each for each in fittings() if each.name == name}
    assert len(own) == 8
    for size, proof, broken in rows(MIL):
        assert own[size].proof_load == pytest.approx(proof * 1e3 * LBF, rel=1e-4)
        assert own[size].MBL == pytest.approx(broken * 1e3 * LBF, rel=1e-4)
        assert own[size].confidence == "A"
        assert own[size].mass is None


def test_fleet_fittings_are_as_strong_as_chain_of_grade_3() -> None:
    """By another table: 0.01961 d^2 (44 - 0.08 d) kN; the standard rounds sizes of inches to mm."""
    for size, _, broken in rows(MIL):
        chain = catalogue.component("chain stud-link U3", size / 1e3)
        assert broken * 1e3 * LBF == pytest.approx(chain.MBL, rel=0.025)


def test_bow_shackles() -> None:
    own = {round(each.size * 1e3): each for each in fittings() if each.name == "bow shackle"}
    for pin, WLL, mass, MBL in rows(GREEN_PIN):
        shackle = own[int(pin)]
        assert (shackle.WLL, shackle.mass) == (WLL * 1e3, mass)
        assert shackle.MBL == pytest.approx(MBL, rel=2e-4)
        factor = 6 if WLL <= 85 else 5
        assert shackle.MBL == pytest.approx(factor * WLL * 9810.0, rel=2e-3)


def test_the_misprint_of_the_swivel_of_132_mm_is_left_out() -> None:
    sizes = [each.size for each in fittings() if each.name == "swivel"]
    assert 0.132 not in sizes
    loads = [each.MBL for each in fittings() if each.name == "swivel"]
    assert loads == sorted(loads)


def test_what_goes_with_a_buoy_chain() -> None:
    """4D Q2 of 38 mm: 907.7 kN. The next bow shackle has 1000.3, the next swivel 980.7 kN."""
    chain = catalogue.component("chain open-link 4D Q2", 0.038)
    assert chain.MBL == pytest.approx(907.7e3, abs=50.0)
    of = fittings_for(chain.name, 0.038, chain.MBL or 0.0)
    assert {use: (each.name, each.MBL) for use, each in of.found.items()} == {
        "shackle": ("bow shackle", 1000.3e3),
        "swivel": ("swivel", 980.7e3),
        "sinker ring": ("ground ring", 1565.8e3),
    }
    assert of.missing == {}
    assert of.weakest is of.found["swivel"]


def test_what_is_missing_is_said() -> None:
    """R5 of 162 mm breaks at 26 MN, far above every ring and shackle that was read."""
    chain = catalogue.component("chain studless R5", 0.162)
    of = fittings_for(chain.name, 0.162, chain.MBL or 0.0)
    assert set(of.missing) == set(OF_A_CHAIN)
    assert of.weakest is None
    assert "the strongest has 7259.5 kN" in of.missing["sinker ring"]


def test_a_fitting_that_is_for_thinner_chain_alone_is_not_called_weak() -> None:
    """U1 of 105 mm breaks at 3850.3 kN; the ring of 102 mm, the largest, has 7259.5 kN."""
    chain = catalogue.component("chain stud-link U1", 0.105)
    of = fittings_for(chain.name, 0.105, chain.MBL or 0.0)
    assert set(of.missing) == {"sinker ring"}
    said = of.missing["sinker ring"]
    assert said == (
        "sinker ring: those in the catalogue as strong as the chain (3850.3 kN) are for "
        "chain of up to 102 mm, not 105 mm. Have one made with a certificate."
    )
    assert "xích đến 102 mm, không dùng cho 105 mm" in say(said, "vi")


@given(
    diameter=st.floats(0.0125, 0.185),
    MBL=st.floats(1e3, 40e6),
)
def test_nothing_is_weaker_than_the_chain(diameter: float, MBL: float) -> None:
    of = fittings_for("chain", diameter, MBL)
    assert set(of.found) | set(of.missing) == set(OF_A_CHAIN)
    assert not set(of.found) & set(of.missing)
    for fitting in of.found.values():
        assert fitting.MBL >= MBL
        assert fitting.name == "bow shackle" or fitting.size >= diameter * (1.0 - 1e-9)


def test_a_chain_without_size_or_strength_is_refused() -> None:
    with pytest.raises(InputError) as error:
        fittings_for("chain", 0.0, float("nan"))
    assert [problem.key for problem in error.value.problems] == ["diameter", "MBL"]
