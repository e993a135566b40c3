"""The catalogue as a case chooses it."""

from __future__ import annotations

import pytest

from catopt.catalogue import component
from catopt.catalogue.choice import chosen
from catopt.errors import InputError, Problem
from catopt.model import CatalogueChoice

WATER = 1025.0


def test_without_a_choice_it_is_catopts_own() -> None:
    plain = chosen(CatalogueChoice(), WATER)
    assert plain.component("chain studless R3", 0.076) == component("chain studless R3", 0.076)
    sizes = [each.nominal_diameter for each in plain.sold("chain studless R3")]
    assert (sizes[0], sizes[-1], len(sizes)) == (0.019, 0.185, 63)  # VRY's column of diameters


def test_a_component_without_the_variant_keeps_its_default() -> None:
    choice = CatalogueChoice(variants=(("EA", "dnv-os-e301-2000"),))
    found = chosen(choice, WATER)
    of_chain = found.component("chain studless R4", 0.076).provenance["EA"]
    of_rope = found.component("polyester", 0.2).provenance["EA"]
    assert of_chain.variant == "dnv-os-e301-2000"
    assert of_rope.variant != "dnv-os-e301-2000"
    assert found.variants_of_none(["polyester", "chain studless R4"]) == []


def test_a_variant_of_no_component_is_named_with_those_that_there_are() -> None:
    found = chosen(CatalogueChoice(variants=(("EA", "spam"), ("MBL", "spam"))), WATER)
    of_EA, of_MBL = found.variants_of_none(["chain studless R4"])
    assert of_EA == Problem(
        "EA", '"spam"', "one of dnv-os-e301-2010, dnv-os-e301-2000, orcaflex is required"
    )
    assert of_MBL == Problem("MBL", '"spam"', "there is only one value; leave it out")


def test_a_recalled_variant_wants_to_be_asked_for() -> None:
    variants = (("EA", "dnv-os-e301"),)
    with pytest.raises(InputError, match="only recalled"):
        chosen(CatalogueChoice(variants=variants), WATER).component(
            "wire 6-strand wire-core", 0.096
        )
    asked = chosen(CatalogueChoice(allow_recalled=True, variants=variants), WATER)
    assert "EA" in asked.component("wire 6-strand wire-core", 0.096).recalled


def test_the_weight_is_in_the_water_that_is_given() -> None:
    fresh, salt = (
        chosen(CatalogueChoice(), water).component("chain studless R3", 0.076)
        for water in (1000.0, WATER)
    )
    assert fresh.submerged_weight > salt.submerged_weight
    assert fresh.mass == salt.mass
