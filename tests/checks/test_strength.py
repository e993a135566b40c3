"""Strength at the end of the service life: worn chain, wire and rope, by hand."""

from __future__ import annotations

from dataclasses import replace

import pytest

from catopt import catalogue
from catopt.checks.case import check_case
from catopt.checks.criteria import strength_of
from catopt.checks.kinds import CheckSource
from catopt.checks.result import CheckReport, CheckResult
from catopt.constants import YEAR
from catopt.errors import InputError
from catopt.model import CatalogueChoice, Checks, Line, Segment, Service
from catopt.model.line import line_kind

from .lines import CLOSE, GROUNDED, PLAIN, asking

MM_A_YEAR = 1e-3 / YEAR
WORN = Service(life=25.0 * YEAR, wear_rate=0.4 * MM_A_YEAR)
"""10 mm off the nominal diameter."""

CHAIN = Segment(60.0, 1000.0, component="chain studless R3", nominal_diameter=0.076)


def load(d: float) -> float:
    """Chain's formula, d^2 (44 - 0.08 d) with d in mm; times c it is in kN."""
    return d * d * (44.0 - 0.08 * d)


def test_own_figures_go_with_the_square_of_the_diameter() -> None:
    """100 mm worn to 90 mm: 200 kN * 0.9^2 = 162 kN, 100 kN * 0.81 = 81 kN."""
    strength = strength_of(PLAIN, WORN)
    assert strength.MBL == pytest.approx(162e3, rel=CLOSE)
    assert strength.proof_load == pytest.approx(81e3, rel=CLOSE)
    assert strength.note == "100 mm worn to 90 mm"


def test_a_component_takes_the_catalogue_s_strength_at_its_end_diameter() -> None:
    """R3, 76 mm less 4 mm: 0.0223 * 72^2 * (44 - 0.08 * 72) = 4420.67 kN; proof 0.0148: 2933.89."""
    service = Service(life=20.0 * YEAR, wear_rate=0.2 * MM_A_YEAR)
    strength = strength_of(CHAIN, service)
    assert strength.MBL == pytest.approx(4420.67e3, rel=1e-6)  # printed to six digits above
    assert strength.proof_load == pytest.approx(2933.89e3, rel=1e-5)
    assert strength.kind == "chain"


def test_without_wear_a_component_is_as_new() -> None:
    """0.0223 * 76^2 * (44 - 6.08) = 4884.28 kN."""
    assert strength_of(CHAIN).MBL == pytest.approx(4884.28e3, rel=1e-6)
    assert strength_of(CHAIN, Service(life=20.0 * YEAR)).note == ""


def test_a_figure_of_one_s_own_beside_a_component_wears_in_proportion() -> None:
    """5000 kN * load(72) / load(76) = 5000 * 0.905081 = 4525.40 kN."""
    service = Service(life=20.0 * YEAR, wear_rate=0.2 * MM_A_YEAR)
    strength = strength_of(replace(CHAIN, MBL=5e6), service)
    assert strength.MBL == pytest.approx(5e6 * load(72.0) / load(76.0), rel=CLOSE)
    assert strength.MBL == pytest.approx(4525.40e3, rel=1e-6)


def test_below_the_catalogue_s_range_the_square_holds() -> None:
    """Studless chain starts at 19 mm: worn by 1 mm, (18/19)^2 of its strength when new."""
    small = replace(CHAIN, nominal_diameter=0.019)
    service = Service(life=10.0 * YEAR, wear_rate=0.1 * MM_A_YEAR)
    new, old = strength_of(small).MBL, strength_of(small, service).MBL
    assert new is not None
    assert old == pytest.approx(new * (18.0 / 19.0) ** 2, rel=CLOSE)


def test_down_to_the_catalogue_s_smallest_size_its_formula_holds() -> None:
    """20 mm worn to 19 mm: load(19)/load(20), where the square is 0.9025."""
    small = replace(CHAIN, nominal_diameter=0.020)
    service = Service(life=5.0 * YEAR, wear_rate=0.2 * MM_A_YEAR - 1e-12 * MM_A_YEAR)
    new, old = strength_of(small).MBL, strength_of(small, service).MBL
    assert new is not None
    assert old == pytest.approx(new * load(19.0) / load(20.0), rel=1e-9)
    assert load(19.0) / load(20.0) > 0.904


def test_wear_of_the_whole_diameter_leaves_nothing_and_less_of_it_something() -> None:
    """A loss of 1/8 m in a second, exact in binary."""
    service = Service(life=1.0, wear_rate=0.125)
    with pytest.raises(InputError, match=r"segment\.diameter: found 125 mm; .* 125 mm over"):
        strength_of(replace(PLAIN, nominal_diameter=0.125), service)
    assert strength_of(replace(PLAIN, nominal_diameter=0.25), service).MBL == 50e3


@pytest.mark.parametrize("diameter", [0.02, 0.076, 0.18])
def test_the_square_is_on_the_safe_side_for_chain(diameter: float) -> None:
    """d^2 (44 - 0.08 d): the second factor grows as d falls."""
    chain = catalogue.component("chain studless R4", diameter)
    end = 0.95 * diameter
    assert chain.MBL is not None
    assert end >= 0.019
    worn = chain.MBL_at(end)
    assert worn is not None
    assert worn > chain.MBL * 0.95**2


def test_a_segment_has_a_wear_rate_of_its_own() -> None:
    """0.8 mm a year for 25 years: 100 mm to 80 mm, 200 kN * 0.64 = 128 kN."""
    segment = replace(PLAIN, wear_rate=0.8 * MM_A_YEAR)
    assert strength_of(segment, WORN).MBL == pytest.approx(128e3, rel=CLOSE)


def test_the_worn_strength_is_the_capacity_and_the_weight_stays() -> None:
    """50 kN beside 162 / 3 = 54 kN; the tension is that of the new line."""
    case = asking(checks=Checks(codes=("UFC-4-159-03",)), service=WORN)
    tension = check_case(case).results[0]
    assert tension.capacity == pytest.approx(54e3, rel=CLOSE)
    assert tension.demand == pytest.approx(50e3, rel=CLOSE)
    assert tension.note.startswith("MBL 162 kN / 3, 100 mm worn to 90 mm; ")
    assert "printed for new break strength" in tension.note


def problem(segment: Segment, service: Service) -> tuple[str, str]:
    with pytest.raises(InputError) as caught:
        check_case(asking(checks=Checks(safety_factor=2.0), line=Line([segment]), service=service))
    (found,) = caught.value.problems
    return found.key, found.allowed


def test_wear_needs_a_diameter() -> None:
    key, allowed = problem(replace(PLAIN, nominal_diameter=None), WORN)
    assert key == "line.segments[0].diameter"
    assert "give the nominal diameter, or leave the wear out" in allowed


def test_wear_that_leaves_nothing_is_refused() -> None:
    key, allowed = problem(replace(PLAIN, nominal_diameter=0.01), WORN)
    assert key == "line.segments[0].diameter"
    assert "10 mm over the service life leaves nothing of the line" in allowed


def test_nylon_is_taken_wet_once() -> None:
    """40 mm: 163.95e6 * 0.04^2 = 262.32 kN dry, 15 % less wet: 222.972 kN.

    By UFC that is 74.324 kN, whether the segment brings its wet MBL or the catalogue gives it.
    """
    bare = Segment(60.0, 1000.0, component="nylon", nominal_diameter=0.04)
    ready = catalogue.component("nylon", 0.04).segment(60.0)
    assert ready.MBL == pytest.approx(222.972e3, rel=CLOSE)
    for segment in (bare, replace(bare, MBL=ready.MBL)):
        case = asking(checks=Checks(codes=("UFC-4-159-03",)), line=Line([segment]))
        assert check_case(case).results[0].capacity == pytest.approx(222.972e3 / 3.0, rel=CLOSE)


def test_rope_does_not_corrode_unless_it_is_said_to_wear() -> None:
    rope = replace(PLAIN, component="polyester", nominal_diameter=0.14)
    assert strength_of(rope, WORN).MBL == 200e3
    own = replace(rope, wear_rate=0.4 * MM_A_YEAR)
    assert strength_of(own, WORN).MBL is not None
    assert strength_of(own, WORN).MBL != 200e3


def test_variants_of_the_case_count() -> None:
    """The proof load of U3 chain of 40 mm as CALMAR tabulates it, not by the formula."""
    stud = replace(CHAIN, component="chain stud-link U3", nominal_diameter=0.04)
    choice = CatalogueChoice(variants=(("proof_load", "calmar"),))
    table, formula = strength_of(stud, None, choice), strength_of(stud)
    known = catalogue.component("chain stud-link U3", 0.04, variants={"proof_load": "calmar"})
    assert table.proof_load == known.proof_load
    assert table.proof_load != formula.proof_load


@pytest.mark.parametrize(
    ("component", "kind"),
    [
        ("chain studless R3", "chain"),
        ("chain open-link 4D Q1", "chain"),
        ("wire 6-strand wire-core", "wire"),
        ("wire rope fibre-core", "wire"),
        ("Spiral strand sheathed", "wire"),
        ("polyester 8-strand", "rope"),
        ("nylon", "rope"),
        ("HMPE", "rope"),
        ("", None),
        ("my own", None),
    ],
)
def test_kinds_of_line(component: str, kind: str | None) -> None:
    assert line_kind(component) == kind


def test_every_family_of_the_catalogue_has_a_kind() -> None:
    assert all(line_kind(family.name) for family in catalogue.families())


def test_the_line_is_the_one_that_was_given() -> None:
    """The case of the tests itself: no service, no change."""
    assert strength_of(GROUNDED.line.segments[0]).MBL == 200e3


def test_own_figures_of_a_line_that_is_sold_nowhere_need_no_catalogue() -> None:
    own = replace(CHAIN, component="chain of our own forge", MBL=5e6, proof_load=3.5e6)
    strength = strength_of(own)
    assert (strength.MBL, strength.proof_load) == (5e6, 3.5e6)
    with pytest.raises(InputError, match="chain of our own forge"):
        strength_of(replace(own, proof_load=None))  # that is to be looked up


def test_both_figures_of_one_s_own_beside_a_component_wear_in_proportion() -> None:
    """76 mm less 4 mm: 5000 and 3500 kN times load(72) / load(76) = 0.905081."""
    service = Service(life=20.0 * YEAR, wear_rate=0.2 * MM_A_YEAR)
    strength = strength_of(replace(CHAIN, MBL=5e6, proof_load=3.5e6), service)
    assert strength.MBL == pytest.approx(4525.40e3, rel=1e-6)
    assert strength.proof_load == pytest.approx(3167.78e3, rel=1e-6)


def test_a_criterion_says_why_a_proof_load_is_not_known() -> None:
    """Nobody sells wire by a proof load: the catalogue has none, and says so."""
    wire = Segment(60.0, 300.0, component="wire 6-strand wire-core", nominal_diameter=0.05)
    strength = strength_of(wire)
    reasons = dict(strength.missing)
    assert strength.MBL is not None
    assert strength.proof_load is None
    assert set(reasons) <= {"MBL", "proof_load"}  # not the drag, which the catalogue lacks too
    with pytest.raises(InputError) as caught:
        strength.need("proof_load", "line.segments[0]", "the test")
    said = str(caught.value)
    assert "line.segments[0].proof_load" in said
    assert reasons.get("proof_load", "missing") in said


@pytest.mark.parametrize(("second", "shown"), [(0.5 + 1e-12, 0), (0.51, 1), (0.49, 0)])
def test_of_checks_that_rounding_tells_apart_the_first_is_shown(second: float, shown: int) -> None:
    source = CheckSource("code")
    first, other = (
        CheckResult("tension", "tension", f"case {k}", 1.0, 2.0, "N", exceedance, source)
        for k, exceedance in enumerate((0.5, second))
    )
    assert CheckReport("", (first, other), ()).tightest_by_state == (shown,)
