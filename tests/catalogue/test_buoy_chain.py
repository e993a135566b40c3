"""IALA's open-link buoy chain against CALMAR's table."""

from __future__ import annotations

import pytest

from catopt import catalogue
from catopt.constants import STANDARD_GRAVITY
from catopt.errors import InputError

from .printed import CALMAR_OPEN, rows

TF = 1e3 * STANDARD_GRAVITY
LINKS = ["3D", "3.5D", "4D", "5D"]
GRADES = ["Q1", "Q2", "Q3"]
MISPRINTS = {(38.0, "Q3"), (20.0, "Q1"), (20.0, "Q2"), (20.0, "Q3")}


def of(links: str, d_mm: float, grade: str, **variants: str) -> catalogue.Component:
    return catalogue.component(f"chain open-link {links} {grade}", d_mm / 1e3, variants=variants)


@pytest.mark.parametrize(("column", "links"), list(enumerate(LINKS, start=1)))
@pytest.mark.parametrize(("load", "grade"), list(enumerate(GRADES, start=5)))
def test_every_printed_row(column: int, links: str, load: int, grade: str) -> None:
    """Break over proof load is 2.0 for open links (CALMAR technical reference, section 7.2)."""
    for row in rows(CALMAR_OPEN):
        chain = of(links, row[0], grade)
        assert chain.mass == row[column]
        if (row[0], grade) in MISPRINTS:
            continue
        assert chain.proof_load == pytest.approx(row[load] * TF, rel=1e-14)
        assert chain.MBL == pytest.approx(2.0 * row[load] * TF, rel=1e-14)
        assert chain.provenance["MBL"].confidence == "A"


def test_the_misprint_of_38_mm_is_left_out() -> None:
    """66.87 tf is off the trend between 35 and 40 mm, which gives 57.9 tf."""
    proof = of("3D", 38, "Q3").proof_load
    assert proof is not None
    assert proof / TF == pytest.approx(57.9, abs=0.05)


@pytest.mark.parametrize(
    ("grade", "printed", "trend"), [("Q1", 10.6, 10.08), ("Q2", 13.46, 12.77), ("Q3", 16.82, 16.04)]
)
def test_the_row_of_20_mm_is_left_out(grade: str, printed: float, trend: float) -> None:
    """It is 5 % above what 18 and 22 mm give: half way (8.36/18^2 + 12.23/22^2)/2 x 20^2 = 10.21.

    The fit of the column, 0.248 d^2 kN, has 10.1 tf; what is taken lies between it and the row.
    """
    below, above = (next(r for r in rows(CALMAR_OPEN) if r[0] == d) for d in (18.0, 22.0))
    column = 5 + GRADES.index(grade)
    halfway = (below[column] / 18.0**2 + above[column] / 22.0**2) / 2.0 * 20.0**2
    proof = of("4D", 20, grade).proof_load
    assert proof is not None
    assert proof == pytest.approx(halfway * TF, rel=1e-12)
    assert trend * TF < proof < 0.97 * printed * TF


NINE_D = """
16 4.4 3.26
18 5.6 4.08
20 6.9 5.1
23 9.1 6.42
26 12 8.15
30 15 11.21
33 19 13.25
36 22 16.31
39 26 19.37
"""
"""CALMAR, table of chains, rows 9D: DN (mm), MasseLin (kg/m), proof load (tf) of all grades."""


def test_long_link_chain_as_printed() -> None:
    """Without the row of 13 mm; mass and load over d^2 agree within 6 % of their middle."""
    for d_mm, mass, tf in rows(NINE_D):
        chain = catalogue.component("chain open-link 9D", d_mm / 1e3)
        assert chain.mass == mass
        assert chain.proof_load == pytest.approx(tf * TF, rel=1e-14)
        assert chain.MBL == pytest.approx(2.0 * tf * TF, rel=1e-14)
        assert tf / d_mm**2 == pytest.approx(0.01246, rel=0.06)
    with pytest.raises(InputError, match="from 16 mm to 39 mm"):
        catalogue.component("chain open-link 9D", 0.013)


@pytest.mark.parametrize(
    ("links", "coefficient"), [("3D", 0.0219), ("3.5D", 0.0204), ("4D", 0.0194), ("5D", 0.0186)]
)
def test_fitted_masses(links: str, coefficient: float) -> None:
    """From the rows of 50 mm: 54.8, 51, 48.5 and 46.5 kg/m."""
    for d_mm in (20.0, 50.0):
        fitted = of(links, d_mm, "Q1", mass="fit").mass
        assert fitted == pytest.approx(coefficient * d_mm**2, rel=1e-12)
    assert of(links, 50, "Q1", mass="fit").mass == pytest.approx(of(links, 50, "Q1").mass, rel=1e-3)


@pytest.mark.parametrize(("grade", "coefficient"), [("Q1", 0.248), ("Q2", 0.314), ("Q3", 0.392)])
def test_fitted_proof_loads(grade: str, coefficient: float) -> None:
    """0.248, 0.314 and 0.392 d^2 kN; from 22 mm the rows lie within 1.2 % of it."""
    assert of("4D", 50, grade, proof_load="fit").proof_load == pytest.approx(
        coefficient * 2500e3, rel=1e-12
    )
    for row in rows(CALMAR_OPEN):
        if row[0] >= 22:
            table, fit = (of("4D", row[0], grade, proof_load=v) for v in ("calmar", "fit"))
            assert table.proof_load == pytest.approx(fit.proof_load, rel=0.012)


def test_between_rows_value_over_d2_is_interpolated() -> None:
    """4D at 36.5 mm, half way from 35 to 38 mm: (23.8/35^2 + 28/38^2) / 2 x 36.5^2."""
    ratio = (23.8 / 35.0**2 + 28.0 / 38.0**2) / 2.0
    assert of("4D", 36.5, "Q2").mass == pytest.approx(ratio * 36.5**2, rel=1e-12)


def test_drag_is_iala_s() -> None:
    """Area 2.65 d times the height of the catenary, coefficient 1.2 (section 5.2.1)."""
    drag = of("3D", 40, "Q2").drag_normal
    assert drag is not None
    assert (drag.coefficient, drag.name) == (1.2, "2.65 d")
    assert drag.diameter == pytest.approx(0.106, rel=1e-12)


def test_weight_in_water_with_calmar_s_density_of_steel() -> None:
    """Open link 3D of 40 mm: 35 kg/m x g0 x (1 - 1025/7850) = 298.4 N/m."""
    assert of("3D", 40, "Q2").submerged_weight == pytest.approx(298.4, abs=0.05)


def test_nothing_is_made_up_for_what_no_source_has() -> None:
    chain = of("3D", 40, "Q2")
    assert (chain.EA, chain.drag_axial, chain.price) == (None, None, None)
    assert set(chain.missing) == {
        "EA", "drag_axial", "added_mass_normal", "added_mass_axial", "price",
    }  # fmt: skip
    assert chain.segment(20.0).EA == float("inf")
