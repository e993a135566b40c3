"""No figure without a source and a confidence; what is only recalled stays out unless asked for."""

from __future__ import annotations

from itertools import pairwise

import pytest

from catopt import catalogue
from catopt.catalogue.components import CONFIDENCES, SPECS, weakest
from catopt.errors import InputError

FAMILIES = catalogue.families()
RECALLED = [
    (family.name, figure.quantity, figure.variant)
    for family in FAMILIES
    for figure in family.figures
    if figure.confidence == "R"
]
FEW = {"chain short-link", "chain open-link 9D"}
"""Families of ten sizes or fewer."""
KNOWN = {
    "mass": "mass",
    "volume_diameter": "volume_diameter",
    "MBL": "MBL",
    "proof_load": "proof_load",
    "wet_strength_factor": "wet_strength_factor",
    "EA": "EA",
    "EA_dynamic": "EA_dynamic_terms",
    "drag_normal": "drag_normal",
    "drag_axial": "drag_axial",
    "added_mass_normal": "added_mass_normal",
    "added_mass_axial": "added_mass_axial",
    "price": "price",
}
"""Quantities and where a component has them."""


def middle(family: catalogue.Family) -> float:
    """Take the size in the middle of those that are sold."""
    return family.sizes.diameters[len(family.sizes.diameters) // 2]


@pytest.mark.parametrize("family", FAMILIES, ids=lambda family: family.name)
def test_every_figure_names_document_place_and_confidence(family: catalogue.Family) -> None:
    assert family.figures
    for figure in family.figures:
        assert figure.confidence in CONFIDENCES
        assert figure.place
        assert figure.sources
        for source in figure.sources:
            assert source.key
            assert source.title
            assert source.place
    assert family.sizes.diameters
    assert family.sizes.sources
    assert family.sizes.confidence in CONFIDENCES


@pytest.mark.parametrize("family", FAMILIES, ids=lambda family: family.name)
def test_every_value_of_a_component_has_its_origin(family: catalogue.Family) -> None:
    assert set(KNOWN) == set(SPECS)
    for grade in family.grades or (None,):
        component = catalogue.component(family.name, middle(family), grade=grade)
        for quantity, attribute in KNOWN.items():
            known = getattr(component, attribute) is not None
            assert known == (quantity in component.provenance), (component.name, quantity)
            if not known and not SPECS[quantity].of_some:
                assert component.missing[quantity]
        assert "submerged_weight" in component.provenance
        assert component.recalled == ()


@pytest.mark.parametrize("family", FAMILIES, ids=lambda family: family.name)
def test_every_choice_has_a_default_with_a_reason_or_none_at_all(family: catalogue.Family) -> None:
    for quantity in SPECS:
        for grade in family.grades or (None,):
            found = family.alternatives(quantity, grade)
            if len(found) < 2:
                continue
            assert len({figure.variant for figure in found}) == len(found)
            defaults = [figure for figure in found if figure.default]
            assert len(defaults) <= 1
            assert all(figure.reason for figure in defaults)


@pytest.mark.parametrize("family", FAMILIES, ids=lambda family: family.name)
def test_every_size_that_is_sold_can_be_looked_up(family: catalogue.Family) -> None:
    """Each size in the strongest grade that is made in it, and weight and strength grow with it."""
    for grade in family.grades or (None,):
        made = catalogue.standard().sold(family.name, grade=grade)
        assert len(made) > (10 if family.name not in FEW else 2)
        for smaller, larger in pairwise(made):
            assert smaller.nominal_diameter < larger.nominal_diameter
            assert smaller.mass < larger.mass
            assert smaller.MBL is not None
            assert larger.MBL is not None
            assert smaller.MBL < larger.MBL


def test_some_figures_are_only_recalled() -> None:
    """The tests below have these to do: the stiffness of wire by DNV and the drag of 6 strands."""
    by_construction = [f"wire {c} {k}" for c in ("6x19", "6x36") for k in ("FC", "IWRC")]
    assert sorted(set(RECALLED)) == [
        ("wire 6-strand fibre-core", "EA", "dnv-os-e301"),
        ("wire 6-strand fibre-core", "drag_normal", ""),
        ("wire 6-strand wire-core", "EA", "dnv-os-e301"),
        ("wire 6-strand wire-core", "drag_normal", ""),
        *((name, "drag_normal", "") for name in by_construction),
        ("wire spiral-strand", "EA", "dnv-os-e301"),
    ]


def test_a_recalled_figure_is_off() -> None:
    wire = catalogue.component("wire 6-strand wire-core", 0.076)
    assert wire.drag_normal is None
    assert "recalled" in wire.missing["drag_normal"]
    with pytest.raises(InputError, match=r"variants\.EA: found \"dnv-os-e301\"; only recalled"):
        catalogue.component("wire 6-strand wire-core", 0.076, variants={"EA": "dnv-os-e301"})
    with pytest.raises(InputError, match="recalled"):
        catalogue.component("wire spiral-strand", 0.1, variants={"all": "dnv-os-e301"})


def test_a_recalled_figure_is_used_when_asked_for_and_marked() -> None:
    """7.0e10 N/m2 on pi d^2/4 is 5.498e10 d^2; 1.13e11 is 8.875e10 d^2."""
    wire = catalogue.component(
        "wire 6-strand wire-core", 0.1, variants={"EA": "dnv-os-e301"}, allow_recalled=True
    )
    assert wire.EA == pytest.approx(7.0e10 * 3.14159265 * 0.01 / 4.0, rel=1e-4)
    assert wire.drag_normal == catalogue.Hydrodynamic(1.8, 0.1, "d")
    assert wire.recalled == ("EA", "drag_normal")
    assert wire.provenance["EA"].is_recalled
    strand = catalogue.component(
        "wire spiral-strand", 0.1, variants={"all": "dnv-os-e301"}, allow_recalled=True
    )
    assert strand.EA == pytest.approx(1.13e11 * 3.14159265 * 0.01 / 4.0, rel=1e-4)
    assert strand.recalled == ("EA",)


def test_allowing_recalled_figures_changes_no_other() -> None:
    strict = catalogue.component("wire 6-strand wire-core", 0.1)
    open_ = catalogue.component("wire 6-strand wire-core", 0.1, allow_recalled=True)
    assert strict.EA == open_.EA
    assert set(open_.provenance) - set(strict.provenance) == {"drag_normal"}


def test_confidence_is_the_weakest_of_what_a_figure_rests_on() -> None:
    assert weakest(["B", "A", "C"]) == "C"
    assert weakest([]) == "A"
    # The weight of chain in water rests on a mass of confidence B and a density of A.
    chain = catalogue.component("chain studless R3", 0.1)
    figure = catalogue.standard().family("chain studless").default("volume_diameter", "R3")
    assert figure is not None
    assert figure.confidence == "A"
    assert chain.provenance["volume_diameter"].confidence == "B"
    assert chain.provenance["submerged_weight"].confidence == "B"
    stud = catalogue.component("chain stud-link U2", 0.05, variants={"MBL": "calmar"})
    assert stud.provenance["MBL"].confidence == "B", "1.414 (A) times a proof load that is fitted"


def test_what_was_not_chosen_is_at_hand() -> None:
    """EA of R4 at 100 mm: 8.168e8 N in use, 8.54e8 N by OrcaFlex."""
    chain = catalogue.component("chain studless R4", 0.1)
    others = {(each.quantity, each.variant): each for each in chain.alternatives}
    assert others["EA", "orcaflex"].value == pytest.approx(8.54e8, rel=1e-12)
    assert others["drag_normal", "orcaflex-old"].reference == pytest.approx(0.21, rel=1e-12)
    assert ("EA", "dnv-os-e301-2010") not in others
    # What reaches only 60 mm has no value at 100 mm; a price without default is there to choose.
    stud = catalogue.component("chain stud-link U2", 0.1)
    others = {(each.quantity, each.variant): each for each in stud.alternatives}
    assert others["mass", "calmar"].value is None
    assert others["price", "tud"].value == pytest.approx(75e-6 * (stud.MBL or 0.0), rel=1e-12)
