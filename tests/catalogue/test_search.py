"""Searching the catalogue, against a plain walk through Vryhof's table and its own order."""

from __future__ import annotations

import pytest

from catopt import catalogue
from catopt.errors import InputError

from .printed import VRYHOF, rows

KN = 1e3


@pytest.mark.parametrize("least", [500.0, 1999.0, 6001.0, 9000.0])
@pytest.mark.parametrize(("column", "grade"), [(2, "R3"), (4, "R4"), (5, "R5")])
def test_the_smallest_size_is_the_table_s(least: float, column: int, grade: str) -> None:
    """First row of the printed table that reaches the load, none of them within its rounding."""
    wanted = next(
        row[0] for row in rows(VRYHOF) if row[column] >= least and (row[0], grade) != (132.0, "R5")
    )
    (found,) = catalogue.search(MBL_at_least=least * KN, family="chain studless", grade=grade)
    assert found.name == f"chain studless {grade} {wanted:g} mm"


def test_all_sizes_that_fit() -> None:
    found = catalogue.search(
        family="chain studless R3", diameter_at_least=0.07, diameter_at_most=0.081, all_sizes=True
    )
    sizes = [round(component.nominal_diameter * 1e3, 6) for component in found]
    assert sizes == [70, 73, 76, 78, 81]


def test_one_of_each_family_and_grade_from_the_lightest() -> None:
    found = catalogue.search(MBL_at_least=500 * KN)
    of = [(component.family, component.grade) for component in found]
    assert len(set(of)) == len(of)
    masses = [component.mass for component in found]
    assert masses == sorted(masses)
    assert all(component.MBL_in_water >= 500 * KN for component in found if component.MBL_in_water)
    # Of chain only the long-link one and the short-link one of 13 mm do not reach it: 9 grades of
    # stud-link, 6 of studless, 12 of open-link chain; 8 ropes and 4 wires in 2 grades do.
    assert len(found) == 9 + 6 + 12 + 8 + 4 * 2


def test_nylon_is_judged_wet() -> None:
    """163.95e6 d^2 dry, 0.85 of it wet: 60 mm has 590 and 502 kN, 56 mm 514 and 437 kN."""
    (found,) = catalogue.search(MBL_at_least=500 * KN, family="nylon")
    assert found.nominal_diameter == pytest.approx(0.060)


def test_limits_on_mass_price_and_proof_load() -> None:
    """R3 and R4 have prices; 76 mm of R4 costs -312 x 0.076 + 8.56e4 x 0.076^2 = 470.7.

    Proof load of R3, 50 mm: 0.0148 x 50^2 x 40 = 1480 kN; 48 mm: 0.0148 x 48^2 x 40.16 = 1369 kN.
    """
    found = catalogue.search(price_at_most=471.0, family="chain studless", all_sizes=True)
    assert {component.grade for component in found} == {"R3", "R4"}
    assert max(c.nominal_diameter for c in found if c.grade == "R4") == pytest.approx(0.076)
    light = catalogue.search(mass_at_most=116.0, family="chain studless R3", all_sizes=True)
    assert light[-1].nominal_diameter == pytest.approx(0.076)
    (strong,) = catalogue.search(proof_load_at_least=1479 * KN, family="chain studless R3")
    assert strong.nominal_diameter == pytest.approx(0.050)


def test_nothing_found_is_an_empty_answer() -> None:
    assert catalogue.search(MBL_at_least=1e9) == ()


def test_a_variant_holds_where_a_family_has_it() -> None:
    names = ["chain studless", "polyester 8-strand"]
    found = catalogue.search(MBL_at_least=5e5, family=names, variants={"EA": "orcaflex"})
    variants = {component.family: component.provenance["EA"].variant for component in found}
    assert variants == {"chain studless": "orcaflex", "polyester 8-strand": ""}


def test_every_problem_of_a_search_is_reported() -> None:
    with pytest.raises(InputError) as error:
        catalogue.search(
            MBL_at_least=-1.0,
            mass_at_most=float("nan"),
            family=["chain studles", "polyester"],
            grade="R9",
            variants={"EA": "nobody"},
        )
    keys = [problem.key for problem in error.value.problems]
    assert keys == ["MBL_at_least", "mass_at_most", "family", "grade", "variants.EA"]
