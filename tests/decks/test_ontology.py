"""The floating array ontology as cases: by hand, what is said and refused, and written back."""

from __future__ import annotations

import math
import sys
from dataclasses import replace

import pytest
import yaml

from catopt import InputError
from catopt.decks.deck import Notes
from catopt.decks.reading import Asked, is_deck, read_deck
from catopt.decks.tree import parse_yaml
from catopt.export.export_result import exported_lines
from catopt.export.programs import program_input
from catopt.words import say
from tests.decks.own import ONTOLOGY, problems, said
from tests.export.cases import CASES, chain_and_wire, tanker

G = 9.80665


def test_what_is_read() -> None:
    """By hand.

    A heading of 30 deg, clockwise from north, is an azimuth of 60; the anchor lies 58 + 642 m out.
    Chain (480.9 - pi/4 0.279^2 1025) g; clump (5000 - 0.64 x 1025) g.
    """
    found = read_deck(ONTOLOGY, "farm.yaml")
    case = found.case
    assert case.system is not None
    degrees = [math.degrees(leg.azimuth) for leg in case.system.legs]
    assert degrees == pytest.approx([60.0, -60.0, -180.0], abs=1e-9) or degrees == pytest.approx(
        [60.0, -60.0, 180.0], abs=1e-9
    )
    assert [leg.anchor_radius for leg in case.system.legs] == pytest.approx([700.0] * 3, rel=1e-12)
    assert case.system.legs[0].fairlead_radius == pytest.approx(58.0, rel=1e-12)
    assert (case.fairlead_height, case.site.water_depth) == (186.0, 200.0)
    chain, rope = case.line.segments
    assert (chain.length, rope.length, rope.EA, rope.mass) == (497.7, 199.8, 164e6, 22.5)
    assert (chain.MBL, chain.nominal_diameter, rope.MBL) == (25.2e6, 0.155, None)
    weight = (480.9 - 0.25 * math.pi * 0.279**2 * 1025.0) * G
    assert chain.submerged_weight == pytest.approx(weight, rel=1e-14)
    (load,) = case.line.point_loads
    assert (load.position, load.mass) == (497.7, 5000.0)
    assert load.submerged_weight == pytest.approx((5000.0 - 0.64 * 1025.0) * G, rel=1e-14)


def test_every_key_is_used_or_named_with_its_line() -> None:
    words = said(read_deck(ONTOLOGY, "farm.yaml"))
    for key in (
        "rho_air (2)",
        "topsides (7)",
        "cost (25)",
        "stiffness note (28)",
        "ID (6)",
        "anchorType (14 and 2 more)",
        "adjustable (23)",
        "anchor_types (31)",
    ):
        assert key in words, key
    assert "line 6: the one platform is placed at x = y = 0" in words
    assert "the deck has no g" in words
    found = read_deck(ONTOLOGY, "farm.yaml")
    assert all(say(each, "vi") != str(each) for each in found.remarks)


def test_a_key_that_nobody_knows_is_named() -> None:
    text = ONTOLOGY.replace("span: 642", "span: 642\n    wobble: 3")
    assert "wobble (20)" in said(read_deck(text, "farm.yaml"))


def test_fairleads_by_their_place_and_a_turned_platform() -> None:
    """r_rel (50, 0) with a heading of 90 deg stays on x; the platform turned by 90 deg: on -y."""
    fairleads = "platform: {fairleads: [{r_rel: [50, 0, -14], headings: [90, 210, 330]}]}"
    text = ONTOLOGY.replace("platform: {rFair: 58, zFair: -14}", fairleads)
    text = text.replace("anchorType]", "anchorType, fairlead]")
    for number, (old, new) in enumerate((("30", "90"), ("150", "210"), ("270", "330")), start=1):
        text = text.replace(f"[leg, {old}, drag1]", f"[leg, {new}, drag1, {number}]")
    system = read_deck(text, "farm.yaml").case.system
    assert system is not None
    turned = read_deck(text.replace("800, 0]", "800, 90]"), "farm.yaml").case.system
    assert turned is not None
    for found, azimuth in ((system, 0.0), (turned, -90.0)):
        assert math.degrees(found.legs[0].azimuth) == pytest.approx(azimuth, abs=1e-9)
        assert found.legs[0].fairlead_radius == pytest.approx(50.0, rel=1e-12)
        assert found.legs[0].anchor_radius == pytest.approx(692.0, rel=1e-12)


def test_a_family_has_the_figures_of_moorpy() -> None:
    """Chain of 0.1 m: 20e3 d^2 = 200 kg/m, 1.8 d, 85.6e9 d^2 - 3.93e7 d^3 = 855.9607 MN."""
    text = ONTOLOGY.replace("{type: chain, length", "{mooringFamily: chain, d_nom: .1, length")
    found = read_deck(text, "farm.yaml")
    chain = found.case.line.segments[0]
    assert chain.mass == pytest.approx(200.0)
    assert chain.EA == pytest.approx(855.9607e6, rel=1e-12)
    weight = (200.0 - 0.25 * math.pi * 0.18**2 * 1025.0) * G
    assert chain.submerged_weight == pytest.approx(weight, rel=1e-12)
    assert "line 21: chain by its nominal diameter" in said(found)


def test_one_line_beside_shared_ones() -> None:
    text = ONTOLOGY.replace("topsides:\n", "array_mooring: {line_data: [[a, b]]}\ntopsides:\n")
    found = read_deck(text, "farm.yaml", Asked(line=2))
    assert found.case.load is not None
    assert found.case.load.span == pytest.approx(642.0, rel=1e-12)
    assert "array_mooring (7)" in said(found)


def test_a_list_in_itself_and_aliases() -> None:
    for text in ("a: &x [1]\nb: *x", "a: &x [*x]"):
        with pytest.raises(InputError, match="alias"):
            parse_yaml(text, Notes("x.yaml"))


def test_without_pyyaml_it_is_said_how_to_have_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "yaml", None)
    assert problems(ONTOLOGY) == ["PyYAML: is not installed: pip install 'catopt[yaml]'"]


def test_it_is_a_deck_for_every_command() -> None:
    assert is_deck(ONTOLOGY)
    assert not is_deck((CASES / "buoy-9.5m" / "case.toml").read_text("utf-8"))


def test_numbers_are_numbers_for_pyyaml() -> None:
    """YAML 1.1 takes 164e6 and 1e-07 for words."""
    document = yaml.safe_load(program_input("ontology", exported_lines(chain_and_wire())).text)
    numbers = document["mooring_line_types"]["chain"].values()
    assert all(isinstance(each, float) for each in numbers)
    sections = document["mooring_line_configs"]["line_1"]["sections"]
    assert [part.get("length") for part in sections] == [200.0, None, 200.0]


def test_a_raised_anchor_has_no_place_in_the_ontology() -> None:
    with pytest.raises(InputError, match=r"line.anchor_height: found 3 m; must be 0"):
        program_input("ontology", exported_lines(replace(tanker(), anchor_height=3.0)))
