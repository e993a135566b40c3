"""What is shown in Vietnamese is taken in Vietnamese, too: buoys, families, soils, materials."""

from __future__ import annotations

import pytest

import catopt
from catopt.loads.buoy import buoy, buoys
from catopt.loads.drag_anchor import SOILS
from catopt.loads.sinker import ADHESION, SOIL_FRICTION, soil_named
from catopt.sizing.input_values import input_values
from catopt.words import say, term, typed_name
from catopt.words.message import display_name, group

GENERIC = [each.name for each in buoys() if display_name(each.name, "vi") != each.name]


@pytest.mark.parametrize("name", GENERIC)
def test_a_buoy_is_known_by_the_name_that_is_shown(name: str) -> None:
    assert buoy(display_name(name, "vi")).name == name


@pytest.mark.parametrize("soil", sorted({*SOIL_FRICTION, *ADHESION, *SOILS}))
def test_a_soil_is_known_by_its_vietnamese_name(soil: str) -> None:
    assert soil_named(say(term(soil), "vi")) == soil_named(soil)


def test_a_component_is_known_by_the_name_that_is_shown() -> None:
    shown = display_name("chain studless R3 76 mm", "vi").removesuffix(" 76 mm")
    assert shown == "xích không ngáng R3"
    found = catopt.component(shown, diameter="76 mm")
    assert found == catopt.component("chain studless R3", diameter="76 mm")


def test_the_inputs_of_a_sizing_are_read_in_vietnamese() -> None:
    given = {"buoy": "Phao trụ 1.8 m", "depth": "12 m", "soil": "sét mềm", "sinker": "thép"}
    read = input_values("buoy", given)
    assert (read["buoy"], read["soil"], read["sinker"]) == ("pillar 1.8 m", "soft clay", "steel")


def test_other_text_stays_as_it_is() -> None:
    for each in ("Stevpris Mk5", "pillar 1.8 m", "API-RP-2SK", "phao của tôi", "a/b.toml"):
        assert typed_name(each) == each
    assert {str(each["vi"]) for each in group("names").values()} > {"phao trụ 1.8 m"}
