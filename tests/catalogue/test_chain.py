"""Stud-link and studless chain against what the sources printed."""

from __future__ import annotations

import math

import pytest

from catopt import catalogue
from catopt.constants import STANDARD_GRAVITY

from .printed import ATLANTIC, CALMAR_STUD, PILOTFITS, VRYHOF, rows

KN = 1e3
TF = 1e3 * STANDARD_GRAVITY
LBF = 4.4482216152605
INCH = 0.0254

WHOLE_KN = 0.6
"""kN: tables rounded to 1 kN, a few rows of them down instead of to the nearest."""

WHOLE_KG = 0.5 + 1e-9
"""kg/m: tables rounded to 1 kg/m, halves upwards."""


def of(family: str, d_mm: float, grade: str, **variants: str) -> catalogue.Component:
    return catalogue.component(family, d_mm / 1e3, grade=grade, variants=variants)


# ------------------------------------------------------------------ strength


@pytest.mark.parametrize("family", ["chain stud-link", "chain studless"])
@pytest.mark.parametrize(
    ("column", "grade"), list(enumerate(["ORQ", "R3", "R3S", "R4", "R5"], start=1))
)
def test_break_loads_are_vryhof_s(family: str, column: int, grade: str) -> None:
    """Stud-link and studless chain break at the same load; R5 of 132 mm is a misprint there."""
    for row in rows(VRYHOF):
        if (row[0], grade) != (132.0, "R5"):
            assert of(family, row[0], grade).MBL == pytest.approx(
                row[column] * KN, abs=WHOLE_KN * KN
            )


def test_the_misprint_in_vryhof_s_table_is_not_followed() -> None:
    """R5 of 132 mm: 0.0320 x 132^2 x (44 - 0.08 x 132) = 0.0320 x 17424 x 33.44 = 18645 kN."""
    assert of("chain studless", 132, "R5").MBL == pytest.approx(18645 * KN, abs=0.5 * KN)


@pytest.mark.parametrize(
    ("family", "grade", "proof", "break_"),
    [
        ("chain studless", "R3", 1, 2),
        ("chain stud-link", "R3", 1, 2),
        ("chain studless", "R3S", 3, 5),
        ("chain stud-link", "R3S", 4, 5),
        ("chain studless", "R4", 6, 8),
        ("chain stud-link", "R4", 7, 8),
    ],
)
def test_proof_and_break_loads_are_a_maker_s(
    family: str, grade: str, proof: int, break_: int
) -> None:
    """Rounded up to the whole kN, most of them; of R3 it has the higher of two proof loads."""
    variants = {"proof_load": "0.0156"} if grade == "R3" else {}
    for row in rows(PILOTFITS):
        chain = of(family, row[0], grade, **variants)
        assert chain.proof_load == pytest.approx(row[proof] * KN, abs=KN)
        assert chain.MBL == pytest.approx(row[break_] * KN, abs=KN)


@pytest.mark.parametrize(
    ("grade", "break_", "stud", "studless"),
    [
        ("ORQ", 0.0211, 0.0140, 0.0140),
        ("R4S", 0.0304, 0.0240, 0.0213),
        ("R5", 0.0320, 0.0251, 0.0223),
    ],
)
def test_loads_of_the_other_offshore_grades(
    grade: str, break_: float, stud: float, studless: float
) -> None:
    """By c d^2 (44 - 0.08 d) at 100 mm: d^2 (44 - 0.08 d) = 360 000."""
    for family, proof in (("chain stud-link", stud), ("chain studless", studless)):
        chain = of(family, 100, grade)
        assert chain.MBL == pytest.approx(break_ * 360e3 * KN, rel=1e-12)
        assert chain.proof_load == pytest.approx(proof * 360e3 * KN, rel=1e-12)


def test_of_two_proof_loads_of_r3_the_lower_is_the_default() -> None:
    """0.0148 x 360 000 = 5328 kN; the other, 0.0156 x 360 000 = 5616 kN, is a variant."""
    lower = of("chain studless", 100, "R3")
    assert lower.proof_load == pytest.approx(5328 * KN, rel=1e-12)
    assert lower.provenance["proof_load"].confidence == "C"
    other = of("chain studless", 100, "R3", proof_load="0.0156")
    assert other.proof_load == pytest.approx(5616 * KN, rel=1e-12)


@pytest.mark.parametrize(("column", "grade"), [(1, "U1"), (3, "U2"), (5, "U3")])
def test_ship_s_grades_are_an_anchor_chain_table_s(column: int, grade: str) -> None:
    """Within 0.2 %: the table is in pounds, rounded to three or four digits.

    21930 lbf at 1/2 inch is off the table's own ratios by 2.4 %.
    """
    for row in rows(ATLANTIC):
        chain = of("chain stud-link", row[0] * INCH * 1e3, grade)
        for ours, printed in ((chain.proof_load, row[column]), (chain.MBL, row[column + 1])):
            if printed != 21930:
                assert ours == pytest.approx(printed * LBF, rel=2e-3)


def test_the_break_load_of_a_ship_s_grade_is_the_proof_load_of_the_next() -> None:
    for lower, higher in (("U1", "U2"), ("U2", "U3")):
        weak, strong = (of("chain stud-link", 60, grade) for grade in (lower, higher))
        assert weak.MBL == strong.proof_load


@pytest.mark.parametrize(("column", "grade"), [(2, "U1"), (3, "U2"), (4, "U3")])
def test_proof_loads_of_ship_s_grades_against_calmar(column: int, grade: str) -> None:
    """The fit within 1.2 % and, for U1 from 30 mm, within 0.3 %; the variant exactly."""
    for row in rows(CALMAR_STUD):
        printed = row[column] * TF
        chain = of("chain stud-link", row[0], grade)
        close = 3e-3 if grade == "U1" and row[0] >= 30 else 1.21e-2
        assert chain.proof_load == pytest.approx(printed, rel=close)
        table = of("chain stud-link", row[0], grade, all="calmar")
        assert table.proof_load == pytest.approx(printed, rel=1e-12)
        assert table.MBL == pytest.approx(1.414 * printed, rel=1e-12)
        assert table.mass == row[1]
        assert table.provenance["MBL"].confidence == "A"


def test_u2_of_130_mm_is_dtocean_s() -> None:
    """7796.3 kN, which is 795 tf rounded: within half a tf, 0.06 %."""
    assert of("chain stud-link", 130, "U2").MBL == pytest.approx(7796.3 * KN, rel=6.3e-4)


def test_moorpy_s_cubic_is_the_formula_of_r4() -> None:
    """-2.19e9 d^3 + 1.21e9 d^2 + 911 d; its coefficients have three digits: within 0.6 %."""
    for d in (0.05, 0.1, 0.15):
        cubic = -2.19e9 * d**3 + 1.21e9 * d**2 + 9.11e2 * d
        assert of("chain studless", d * 1e3, "R4").MBL == pytest.approx(cubic, rel=6e-3)


def test_the_range_ends_far_below_the_peak_of_the_formula() -> None:
    """d/dd of d^2 (44 - 0.08 d) vanishes at d = 88 / 0.24 = 367 mm."""
    for family in catalogue.families():
        for figure in family.figures:
            if "44 - 0.08 d" in figure.text:
                assert figure.range[1] <= 0.185 < 0.367 / 1.9


# ------------------------------------------------------------------ mass and volume


def test_masses_are_vryhof_s() -> None:
    for row in rows(VRYHOF):
        assert of("chain studless", row[0], "R3").mass == pytest.approx(row[7], abs=WHOLE_KG)
        if row[0] > 40:
            stud = of("chain stud-link", row[0], "R3").mass
            # The coefficient 0.0219 +- 0.0001, and the whole kg of the table.
            assert stud == pytest.approx(row[6], abs=WHOLE_KG + 0.0001 * row[0] ** 2)


def test_orcaflex_s_mass_of_studless_chain_is_half_a_per_cent_less() -> None:
    assert of("chain studless", 100, "R3").mass == pytest.approx(200.0, rel=1e-12)
    assert of("chain studless", 100, "R3", mass="orcaflex").mass == pytest.approx(199.0, rel=1e-12)


def test_volume_equivalent_diameters() -> None:
    """sqrt(4 x 20000 / (pi x 7850)) = 1.801 and with 21900 1.885; printed are 1.80 and 1.89."""
    studless, stud = (of(f"chain {kind}", 100, "R3") for kind in ("studless", "stud-link"))
    assert studless.volume_diameter / 0.1 == pytest.approx(1.801, abs=5e-4)
    assert stud.volume_diameter / 0.1 == pytest.approx(1.885, abs=5e-4)
    for kind, ratio in (("studless", 1.80), ("stud-link", 1.89)):
        printed = of(f"chain {kind}", 100, "R3", volume_diameter="ratio")
        assert printed.volume_diameter == pytest.approx(ratio * 0.1, rel=1e-12)
        # The two ways differ by the rounding of the printed ratio.
        default = of(f"chain {kind}", 100, "R3")
        assert printed.submerged_weight == pytest.approx(default.submerged_weight, rel=1e-3)


def test_weight_in_water_is_0_869_of_that_in_air() -> None:
    """1 - 1025/7850 = 0.8694."""
    for family in ("chain stud-link", "chain studless"):
        chain = of(family, 76, "R3")
        in_air = chain.mass * STANDARD_GRAVITY
        assert chain.submerged_weight / in_air == pytest.approx(0.8694, abs=5e-5)


def test_weight_in_water_of_147_mm_is_tu_delft_s() -> None:
    """Studless chain of 147 mm: 376 kg/m in water, printed to the kg."""
    chain = of("chain studless", 147, "R4S")
    assert chain.submerged_weight / STANDARD_GRAVITY == pytest.approx(376.0, abs=0.5)


def test_weight_mass_and_volume_agree() -> None:
    chain = catalogue.component("chain studless R4", 0.1, water_density=1000.0)
    displaced = 1000.0 * math.pi * chain.volume_diameter**2 / 4.0
    weight = (chain.mass - displaced) * STANDARD_GRAVITY
    assert chain.submerged_weight == pytest.approx(weight, rel=1e-14)
    assert chain.submerged_weight > of("chain studless", 100, "R4").submerged_weight


# ------------------------------------------------------------------ stiffness


@pytest.mark.parametrize(
    ("grade", "d2", "d3"),
    [("R3", 8.482e10, -6.283e10), ("R4", 8.561e10, -3.927e10), ("R5", 9.425e10, -5.184e10)],
)
@pytest.mark.parametrize("d", [0.05, 0.1, 0.15])
def test_stiffness_by_dnv_os_e301(grade: str, d2: float, d3: float, d: float) -> None:
    """The coefficients have four digits."""
    chain = of("chain studless", d * 1e3, grade)
    assert chain.EA == pytest.approx(d2 * d**2 + d3 * d**3, rel=1e-4)


def test_modulus_of_r3_at_100_mm() -> None:
    """(5.40 - 0.0040 x 100) 1e10 = 5.0e10 N/m2 on both legs, pi 0.1^2 / 2 = 0.0157080 m2."""
    assert of("chain studless", 100, "R3").EA == pytest.approx(5.0e10 * 0.0157079633, rel=1e-8)


@pytest.mark.parametrize(("d_mm", "per_cent"), [(50, 2.3), (100, 4.8), (150, 7.4)])
def test_moorpy_s_misprint_is_not_copied(d_mm: float, per_cent: float) -> None:
    """MoorPy's EA_d3 = -3.93e7 should be -3.93e10: its EA is too high by these per cent."""
    d = d_mm / 1e3
    moorpy = 85.6e9 * d**2 - 3.93e7 * d**3
    ours = of("chain studless", d_mm, "R4").EA
    assert ours is not None
    assert 100.0 * (moorpy / ours - 1.0) == pytest.approx(per_cent, abs=0.05)
    corrected = 85.6e9 * d**2 - 3.93e10 * d**3
    assert ours == pytest.approx(corrected, rel=1e-3)  # three digits


def test_older_editions_and_orcaflex_are_variants() -> None:
    """R3 at 100 mm: (8.37 - 3.05) 1e10 x 0.015708; OrcaFlex 8.54e10 x 0.01; stud 5.6e10."""
    area = math.pi * 0.1**2 / 2.0
    older = of("chain studless", 100, "R3", EA="dnv-os-e301-2000")
    assert older.EA == pytest.approx(5.32e10 * area, rel=1e-12)
    assert older.provenance["EA"].confidence == "C"
    for grade in ("R3", "R4", "R5", "ORQ", "R3S", "R4S"):
        assert of("chain studless", 100, grade, EA="orcaflex").EA == pytest.approx(
            8.54e8, rel=1e-12
        )
    stud = of("chain stud-link", 100, "R3")
    assert stud.EA == pytest.approx(8.80e8, rel=1e-3)  # MoorPy prints 88.0e9, three digits
    assert of("chain stud-link", 100, "R3", EA="orcaflex").EA == pytest.approx(1.01e9, rel=1e-12)


def test_grades_without_a_figure_of_dnv_take_orcaflex_s() -> None:
    for grade in ("ORQ", "R3S", "R4S"):
        chain = of("chain studless", 100, grade)
        assert chain.EA == pytest.approx(8.54e8, rel=1e-12)
        assert chain.provenance["EA"].variant == "orcaflex"


# ------------------------------------------------------------------ drag, added mass, price


@pytest.mark.parametrize(
    ("family", "normal", "axial", "old", "old_axial", "old_added"),
    [
        ("chain stud-link", 2.6, 1.4, 2.26, 0.60, 0.07),
        ("chain studless", 2.4, 1.15, 2.1, 0.54, 0.08),
    ],
)
def test_drag_and_added_mass(
    family: str, normal: float, axial: float, old: float, old_axial: float, old_added: float
) -> None:
    """Each coefficient with its diameter: nominal, nominal over pi, volume-equivalent."""
    chain = of(family, 100, "R4")
    assert chain.drag_normal == catalogue.Hydrodynamic(normal, 0.1, "d")
    assert chain.drag_diameter == 0.1
    assert chain.drag_axial is not None
    assert chain.drag_axial.coefficient == axial
    assert chain.drag_axial.diameter == pytest.approx(0.1 / math.pi, rel=1e-15)
    assert chain.added_mass_normal == catalogue.Hydrodynamic(1.0, chain.volume_diameter, "volume")
    assert chain.added_mass_axial == catalogue.Hydrodynamic(0.5, chain.volume_diameter, "volume")
    before = of(family, 100, "R4", all="orcaflex-old")
    assert before.drag_normal is not None
    assert before.drag_axial is not None
    assert before.added_mass_axial is not None
    assert before.drag_normal.coefficient == 1.0
    assert before.drag_normal.diameter == pytest.approx(old * 0.1, rel=1e-15)
    assert before.drag_axial.coefficient == 0.4
    assert before.drag_axial.diameter == pytest.approx(old_axial * 0.1 / math.pi, rel=1e-15)
    assert before.added_mass_axial.coefficient == old_added


def test_drag_is_moorpy_s_on_the_volume_equivalent_diameter() -> None:
    """MoorPy: 1.333 on 1.80 d and 1.376 on 1.89 d; axial 0.639 and 0.741: three digits."""
    for family, ratio, normal, axial in (
        ("chain studless", 1.80, 1.333, 0.639),
        ("chain stud-link", 1.89, 1.376, 0.741),
    ):
        chain = of(family, 100, "R4")
        assert chain.drag_normal is not None
        assert chain.drag_axial is not None
        ours = chain.drag_normal.coefficient * chain.drag_normal.diameter
        assert ours == pytest.approx(normal * ratio * 0.1, rel=1e-3)
        # Its axial coefficient goes with the area pi D per length, the standard's with d:
        # 1.15 d = 0.639 x 1.80 d and 1.4 d = 0.741 x 1.89 d.
        assert chain.drag_axial.coefficient == pytest.approx(axial * ratio, rel=1e-3)


def test_prices() -> None:
    """R4 of 100 mm: 825, in the older set 517, TU Delft's 740 dollars per metre; R3 571.6."""
    chain = of("chain studless", 100, "R4")
    assert chain.price == pytest.approx(825.0, abs=0.5)
    assert of("chain studless", 100, "R4", price="moorpy-old").price == pytest.approx(517, abs=0.5)
    assert of("chain studless", 100, "R4", price="tud").price == pytest.approx(740.0, abs=0.5)
    # -234 x 0.1 + 5.95e4 x 0.01
    assert of("chain stud-link", 100, "R3").price == pytest.approx(571.6, rel=1e-12)


def test_prices_of_two_sets_never_meet_by_themselves() -> None:
    """A grade that the new set lacks has no price, rather than one that is a third lower."""
    for grade in ("ORQ", "R3S", "R4S", "R5"):
        chain = of("chain studless", 100, grade)
        assert chain.price is None
        assert "moorpy-old" in chain.missing["price"]
