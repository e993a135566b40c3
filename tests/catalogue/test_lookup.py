"""Looking components up: names, ranges, variants, and what a component can do."""

from __future__ import annotations

import math

import pytest

from catopt import catalogue
from catopt.errors import InputError
from catopt.model import Segment
from tests.test_public_api import HEAVY, loaded_by


def problems(error: pytest.ExceptionInfo[InputError]) -> dict[str, str]:
    """Map each key to what is wrong with it."""
    return {problem.key: f"{problem.found}|{problem.allowed}" for problem in error.value.problems}


# ------------------------------------------------------------------ names


@pytest.mark.parametrize(
    ("name", "family", "grade"),
    [
        ("chain studless R3", "chain studless", "R3"),
        ("Chain Studless r3s", "chain studless", "R3S"),
        ("studless chain R4", "chain studless", "R4"),
        ("chain stud-link U2", "chain stud-link", "U2"),
        ("chain stud link U2", "chain stud-link", "U2"),
        ("chain stud U2", "chain stud-link", "U2"),
        ("chain studless", "chain studless", None),
        ("chain open-link 3.5D Q2", "chain open-link 3.5D", "Q2"),
        ("buoy chain 4D Q1", "chain open-link 4D", "Q1"),
        ("wire 6-strand wire core", "wire 6-strand wire-core", None),
        ("spiral strand", "wire spiral-strand", None),
        ("polyester", "polyester", None),
        ("polyester 8-strand", "polyester 8-strand", None),
        ("hmpe", "HMPE", None),
    ],
)
def test_a_name_is_read(name: str, family: str, grade: str | None) -> None:
    assert catalogue.parse_name(name) == (family, grade)


@pytest.mark.parametrize("family", catalogue.families(), ids=lambda family: family.name)
def test_every_family_is_found_by_all_its_names(family: catalogue.Family) -> None:
    for name in family.names:
        assert catalogue.parse_name(name) == (family.name, None)
        for grade in family.grades:
            assert catalogue.parse_name(f"{name} {grade}") == (family.name, grade)


@pytest.mark.parametrize(
    ("name", "near"),
    [
        ("chain studles R3", "chain studless R3"),
        ("chain studless R6", "chain studless R"),
        ("polyster", "polyester"),
        ("6 strand wire", "wire"),
        ("chain open link 3D Q5", "chain open-link 3D Q"),
    ],
)
def test_a_misspelt_name_gets_the_nearest(name: str, near: str) -> None:
    with pytest.raises(InputError) as error:
        catalogue.parse_name(name)
    (problem,) = error.value.problems
    assert problem.key == "component"
    assert problem.found == f'"{name}"'
    assert problem.allowed.startswith("did you mean")
    assert near in problem.allowed


@pytest.mark.parametrize("name", ["", "zzz", 76, None, ["chain"]])
def test_what_is_no_name_gets_an_example(name: object) -> None:
    with pytest.raises(InputError, match='such as "chain stud-link"'):
        catalogue.parse_name(name)


# ------------------------------------------------------------------ ranges


OUTSIDE_THE_DEFAULT = {
    "polyester": {0.022: {"all": "superline"}},
    "HMPE": {0.012: {"all": "moorpy"}, 0.2: {"all": "moorpy"}},
}
"""Ends of a family that only figures reach which are asked for by name."""


@pytest.mark.parametrize("family", catalogue.families(), ids=lambda family: family.name)
def test_the_ends_of_the_range_are_in_and_beyond_is_an_error(family: catalogue.Family) -> None:
    low, high = family.range
    ends = {low: family.grades[0] if family.grades else None}
    ends[high] = family.grades[-1] if family.grades else None
    for end, grade in ends.items():
        chosen = OUTSIDE_THE_DEFAULT.get(family.name, {})
        made = catalogue.component(family.name, end, grade=grade, variants=chosen.get(end, {}))
        assert made.nominal_diameter == end
    for beyond in (low * 0.99, high * 1.01):
        with pytest.raises(InputError, match=rf"{family.name} is known {family.known_range}"):
            catalogue.component(family.name, beyond, grade=ends[high])


def test_the_range_is_that_of_the_figure_and_named() -> None:
    with pytest.raises(InputError) as error:
        catalogue.component("chain stud-link R3", 0.0175)
    assert problems(error) == {"MBL": "|known from 19 mm to 185 mm, not at 17.5 mm"}
    assert catalogue.component("chain stud-link U3", 0.0175).MBL is not None


def test_a_diameter_in_mm_is_noticed() -> None:
    with pytest.raises(InputError, match=r"did you mean 0\.076\?"):
        catalogue.component("chain studless R3", 76)


@pytest.mark.parametrize("diameter", [0.0, -0.076, math.nan, math.inf, "76 kg", True])
def test_what_is_no_diameter_is_an_error(diameter: object) -> None:
    with pytest.raises(InputError, match="diameter"):
        catalogue.component("chain studless R3", diameter)  # type: ignore[arg-type]


def test_sizes_between_those_sold_are_in_the_catalogue() -> None:
    """60.5 mm: 0.0223 x 60.5^2 x (44 - 4.84) = 3196 kN."""
    chain = catalogue.component("chain studless R3", 0.0605)
    assert chain.MBL == pytest.approx(3196e3, abs=0.5e3)


def test_rounding_of_a_diameter_does_not_matter() -> None:
    """17.5 x 1e-3 is not the double nearest to 0.0175; 12.5 mm is the end of a table."""
    table = {"proof_load": "calmar"}
    for d in (12.5e-3, 0.0125, 12.5 / 1e3, 0.012499999999999999):
        chain = catalogue.component("chain stud-link U1", d, variants=table)
        assert chain.proof_load == pytest.approx(4.69 * 9806.65, rel=1e-12)


# ------------------------------------------------------------------ every problem at once


def test_every_problem_of_a_call_is_reported() -> None:
    with pytest.raises(InputError) as error:
        catalogue.component(
            "chain studless",
            0.3,
            grade="R6",
            variants={"EAA": "orcaflex", "drag_normal": "dnv"},
            water_density=0.0,
        )
    assert set(problems(error)) == {
        "grade", "diameter", "water_density", "variants", "variants.drag_normal",
    }  # fmt: skip
    assert "one of ORQ, R3, R3S, R4, R4S, R5" in problems(error)["grade"]
    assert "did you mean EA?" in problems(error)["variants"]
    assert "dnv-os-e301, orcaflex-old, calmar" in problems(error)["variants.drag_normal"]


def test_a_grade_is_wanted_where_there_are_grades_and_only_there() -> None:
    with pytest.raises(InputError, match="grade: missing; one of ORQ"):
        catalogue.component("chain studless", 0.076)
    with pytest.raises(InputError, match="polyester has no grades"):
        catalogue.component("polyester", 0.2, grade="R3")
    assert catalogue.component("chain studless", 0.076, grade="r3").grade == "R3"


def test_a_variant_of_another_grade_is_none() -> None:
    with pytest.raises(InputError, match=r"variants\.EA.*one of orcaflex is required"):
        catalogue.component("chain studless R3S", 0.076, variants={"EA": "dnv-os-e301-2010"})
    with pytest.raises(InputError, match=r"variants\.MBL.*only one value"):
        catalogue.component("chain studless R3S", 0.076, variants={"MBL": "vryhof"})


def test_a_variant_that_does_not_reach_is_an_error_where_it_was_asked_for() -> None:
    with pytest.raises(InputError, match=r"mass: known from 12\.5 mm to 60 mm by calmar"):
        catalogue.component("chain stud-link U2", 0.076, variants={"mass": "calmar"})
    thin = {"mass": "moorpy", "MBL": "moorpy"}
    with pytest.raises(InputError, match=r"price: known from 20\.64 mm"):
        catalogue.component("HMPE", 0.016, variants={"price": "omae-2025", **thin})
    assert catalogue.component("HMPE", 0.016, variants=thin).price is None


def test_outside_what_was_read_the_nearest_inside_is_named() -> None:
    """The default rows of HMPE run from 28 to 120 mm, those of polyester from 138 to 315 mm."""
    with pytest.raises(InputError, match=r"MBL: known from 28 mm to 120 mm by dtocean, not at 20"):
        catalogue.component("HMPE", 0.020)
    with pytest.raises(InputError, match=r"MBL: known from 138 mm to 315 mm by moorline, not at"):
        catalogue.component("polyester", 0.120)
    small = catalogue.component("polyester", 0.120, variants={"all": "superline"})
    assert small.MBL == 4022e3


def test_need_names_what_is_not_known() -> None:
    chain = catalogue.component("chain open-link 3D Q2", 0.04)
    chain.need("MBL", "proof_load", "mass")
    with pytest.raises(InputError) as error:
        chain.need("EA", "price", "MBL")
    assert set(problems(error)) == {"EA", "price"}
    with pytest.raises(InputError, match="proof_load: no figure in the catalogue"):
        catalogue.component("polyester", 0.2).need("proof_load")


# ------------------------------------------------------------------ what a component can do


def test_a_segment_of_it() -> None:
    chain = catalogue.component("chain studless R3", 0.076)
    segment = chain.segment(300.0)
    assert segment == Segment(
        length=300.0,
        submerged_weight=chain.submerged_weight,
        EA=chain.EA or 0.0,
        mass=chain.mass,
        MBL=chain.MBL,
        name="chain studless R3 76 mm",
        component="chain studless R3",
        nominal_diameter=0.076,
        proof_load=chain.proof_load,
        price=chain.price,
        drag_diameter=0.076,
        drag_normal=2.4,
        drag_axial=1.15 / math.pi,
        added_mass_normal=1.0,
        added_mass_axial=0.5,
    )
    assert chain.segment(1.0, name="ground chain").name == "ground chain"


def test_strength_at_a_worn_diameter() -> None:
    """R3 of 76 mm worn to 70 mm: 4196 kN in Vryhof's table, proof 2936 kN in a maker's."""
    chain = catalogue.component("chain studless R3", 0.076, variants={"proof_load": "0.0156"})
    assert chain.MBL_at(0.070) == pytest.approx(4196e3, abs=0.6e3)
    assert chain.proof_load_at(0.070) == pytest.approx(2936e3, abs=1e3)
    assert chain.mass == pytest.approx(115.52, rel=1e-12), "the weight stays that of the new chain"
    with pytest.raises(InputError, match="not at 10 mm"):
        chain.MBL_at(0.010)
    assert catalogue.component("polyester", 0.2).proof_load_at(0.19) is None


def test_strength_at_a_worn_diameter_keeps_the_variant() -> None:
    """R3 with the higher proof load: 0.0156 / 0.0148 of the default."""
    higher = catalogue.component("chain studless R3", 0.076, variants={"proof_load": "0.0156"})
    usual = catalogue.component("chain studless R3", 0.076)
    first, second = higher.proof_load_at(0.07), usual.proof_load_at(0.07)
    assert first is not None
    assert second is not None
    assert first / second == pytest.approx(0.0156 / 0.0148, rel=1e-12)


def test_components_are_values() -> None:
    first, second = (catalogue.component("chain studless R3", 0.076) for _ in range(2))
    assert first == second
    assert len({first, second, catalogue.component("chain studless R4", 0.076)}) == 2
    with pytest.raises(AttributeError):
        first.mass = 1.0  # type: ignore[misc]


def test_looking_up_loads_nothing_heavy() -> None:
    code = (
        "from catopt import catalogue\n"
        "catalogue.component('chain studless R3', 0.076).segment(10.0)\n"
        "catalogue.search(MBL_at_least=5e5)"
    )
    assert loaded_by(code) & (HEAVY | {"rich"}) == set()
