"""OrcaFlex's text data as cases: the chain of its CALM buoy by its published figures, and more."""

from __future__ import annotations

import math

import pytest

from catopt import solve_case
from catopt.decks.reading import Asked, is_deck, read_deck
from catopt.export.export_result import exported_lines
from catopt.export.programs import program_input
from catopt.words import say
from tests.decks.own import C06, problems, said
from tests.export.cases import chain_and_wire

ONE = Asked(line=1)


def test_the_chain_of_the_calm_buoy() -> None:
    """Span 300 m; 100 - 0.7946 - 1.5 - 0.1143 high; forces as MoorPy 1.3 and catopt 0.1 had them.

    Their closed form: H 55,439.8 N, T 128,838.7 N, 190.402 m on the bed.
    """
    found = read_deck(C06, "c06.yml", ONE)
    case = found.case
    assert case.load is not None
    assert case.load.span == pytest.approx(300.0, abs=1e-9)
    assert case.fairlead_height == pytest.approx(97.5911, abs=5e-5)
    assert case.site.water_depth == pytest.approx(100.0 - 0.1143, abs=1e-12)
    assert case.anchor_height == 0.0
    (chain,) = case.line.segments
    assert (chain.length, chain.EA) == (345.0, 407257250.0)
    assert chain.submerged_weight == pytest.approx(752.277, abs=5e-4)
    solved = solve_case(case)
    assert solved.horizontal_force == pytest.approx(55439.8, abs=0.05)
    assert solved.fairlead.tension == pytest.approx(128838.7, abs=0.05)
    assert solved.grounded_length == pytest.approx(190.402, abs=5e-4)


def test_drag_goes_from_its_own_diameters_to_the_outer_one() -> None:
    """Cd D is the same; along, OrcaFlex has the area pi D l, and the case Cd on d alone."""
    (chain,) = read_deck(C06, "c06.yml", ONE).case.line.segments
    assert chain.drag_diameter == 0.120015
    assert chain.drag_normal is not None
    assert chain.drag_axial is not None
    assert chain.drag_normal * 0.120015 == pytest.approx(1.0 * 0.14351, rel=1e-14)
    assert chain.drag_axial * 0.120015 == pytest.approx(math.pi * 0.4 * 0.0121276066, rel=1e-14)
    assert (chain.added_mass_normal, chain.added_mass_axial) == (1.0, 0.07)


def test_every_key_is_used_or_named_with_its_line() -> None:
    found = read_deck(C06, "c06.yml", ONE)
    for key in ("StageDuration (5)", "SeabedNormalStiffness (11)", "WindSpeed (12)",
                "ConnectionAzimuth (42 and 1 more)", "TargetSegmentLength (45 and 1 more)",
                "LayAzimuth (47)", "0.1143 m, above", "line 1 of the 2"):  # fmt: skip
        assert key in said(found), key
    assert all(say(each, "vi") != str(each) for each in found.remarks)
    odd = read_deck(C06.replace("    LayAzimuth: 180", "    Wobble: 3"), "c06.yml", ONE)
    assert "Wobble (47)" in said(odd)
    assert "not known" in said(odd)


def test_a_turned_vessel_and_a_clump() -> None:
    """A heading of 90 deg turns (6, 0) to (0, 6). 45 m from End A: 300 m from the anchor."""
    table = """    AttachmentType, Attachmentx, Attachmenty, Attachmentz, AttachmentzRelativeTo:
      - [clump, 0, 0, 45, End A]
      - [clump, 0, 0, 100, End B]
    LayAzimuth: 180
"""
    text = C06.replace("InitialAttitude: [0, 0, 0]", "InitialAttitude: [0, 0, 90]")
    case = read_deck(text.replace("    LayAzimuth: 180\n", table), "c06.yml", ONE).case
    assert case.load is not None
    assert case.load.span == pytest.approx(math.hypot(299.13326732 + 6.86673268, 6.0), abs=1e-7)
    assert [load.position for load in case.line.point_loads] == pytest.approx([100.0, 300.0])
    weight = (5000.0 - 1025.0 * 0.64) * 9.80665
    assert [load.submerged_weight for load in case.line.point_loads] == pytest.approx([weight] * 2)


def test_bending_and_tables_are_named() -> None:
    text = C06.replace("EI: [0, ~]", "EI: [75, ~]").replace(
        "Cd: [1, ~, 0.4]", "Cd: [Generic, ~, 0]"
    )
    found = read_deck(text, "c06.yml", ONE)
    assert "line 19: not used: bending stiffness EI 75000 N m^2" in said(found)
    assert "line 23: not used: Cd Generic, None, 0: a table of OrcaFlex" in said(found)
    assert found.case.line.segments[0].drag_normal is None


def test_an_end_below_where_the_line_lies() -> None:
    found = read_deck(C06.replace("0.1143, 0, 90", "0, 0, 90"), "c06.yml", ONE)
    assert found.case.anchor_height == 0.0
    assert "the end is 0.114 m lower than the line on the bed" in said(found)


def test_all_lines_are_read_unless_one_is_wanted() -> None:
    found = problems(C06)
    assert any("Hose: ID" in each for each in found)
    assert any("--gravity 9.81; OrcaFlex has" in each for each in problems(C06, Asked(9.81)))
    assert is_deck(C06)


def test_units_and_the_order_of_what_is_written() -> None:
    """Tonnes and kN, sections from the fairlead down, the bed half a diameter lower."""
    solved = exported_lines(chain_and_wire(0.4))
    text = program_input("orcaflex", solved).text
    d = math.sqrt(4.0 / math.pi * (178.7 - 1470.0 / 9.80665) / 1025.0)
    lines = [line.strip() for line in text.splitlines()]
    assert lines[0] == "%YAML 1.1"
    assert "MassPerUnitLength: 0.1787" in lines
    assert "EA: 800000.0" in lines
    (depth,) = (float(line.split()[1]) for line in lines if line.startswith("WaterDepth"))
    assert depth == pytest.approx(56.0 + 0.5 * d, rel=1e-14)
    at = lines.index("LineType, Length, TargetSegmentLength:")
    assert lines[at + 1].startswith('- ["wire", 200.0,')
    assert lines[at + 2].startswith('- ["chain", 200.0,')
    assert "- [clump_2, 0, 0, 200.0, End A]" in lines
    (clump,) = [line for line in lines if "clump_2, Mass" in line]
    volume = (6000.0 - 50e3 / 9.80665) / 1025.0
    assert clump.startswith("- {Name: clump_2, Mass: 6.0, Volume: ")
    assert float(clump.split("Volume: ")[1].rstrip("}")) == pytest.approx(volume, rel=1e-12)
    assert lines.index("LineTypes:") < lines.index("Lines:")
