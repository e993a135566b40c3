"""Inputs that people brought to other programs: each ends in a case that is solved, or one reason.

They stand in brought/, in our own words and numbers after public issues, decks and questions of
MoorDyn, MAP++, OrcaFlex, OpenFAST, WEC-Sim and FAModel; H (kN) of each is what MoorPy 1.3.0 finds,
to the digits that are written here.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from catopt import InputError, solve_case, solve_system
from catopt.decks.reading import Asked, read_any_deck
from catopt.model.network import Network
from catopt.mooring.held import hold

BROUGHT = Path(__file__).parent / "brought"


def brought(name: str, asked: Asked | None = None) -> tuple[object, str]:
    found, remarks = read_any_deck((BROUGHT / name).read_text("utf-8"), name, asked)
    return found, "\n".join(remarks)


def forces(name: str, asked: Asked | None = None) -> list[float]:
    """Horizontal force of each line, kN."""
    found, _ = read_any_deck((BROUGHT / name).read_text("utf-8"), name, asked)
    if isinstance(found, Network):
        return [line.fairlead.horizontal_force / 1e3 for line in hold(found).lines]
    if found.system is not None:
        return [line.horizontal_force / 1e3 for line in solve_system(found.system).lines]
    return [solve_case(found).horizontal_force / 1e3]


@pytest.mark.parametrize(
    ("name", "asked", "lines", "H"),
    [
        ("01_moordyn_v1_numnodes.txt", None, 1, 606.347),
        ("03_pontoon_four_corner_lines.txt", None, 4, 3.838),
        ("05_map_type_case.map", Asked(9.81, 1025.0, 320.0), 3, 754.347),
        ("08_early_v2_columns.txt", Asked(depth=200.0), 1, 907.499),
        ("10_turned_body.txt", None, 1, 1163.219),
        ("19_ontology_default_connector.yaml", None, 3, 790.685),
    ],
)
def test_it_is_read_and_solved(name: str, asked: Asked | None, lines: int, H: float) -> None:
    found = forces(name, asked)
    assert len(found) == lines
    assert found == pytest.approx([H] * lines, abs=6e-4)


def test_the_pontoon_is_the_network_that_is_written_by_hand() -> None:
    from catopt.casefile import read_mooring

    found, said = brought("03_pontoon_four_corner_lines.txt")
    by_hand = read_mooring(BROUGHT / "03_answer_as_network.toml")
    assert isinstance(found, Network)
    assert isinstance(by_hand, Network)
    assert {(p.name, p.kind, p.x, p.y, p.height) for p in found.points} == {
        (p.name, p.kind, p.x, p.y, p.height) for p in by_hand.points
    }
    assert "4 lines that are not equal ones around a body" in said


def test_orcaflex_since_11_6_says_the_depth_elsewhere() -> None:
    """80 m to the bed, 79.9 m to where the line lies; MoorPy, with the line on the bed: 163.224."""
    found, said = brought("02_orcaflex_seabedorigindepth.yml")
    assert found.site.water_depth == pytest.approx(79.9, abs=1e-12)  # type: ignore[attr-defined]
    assert forces("02_orcaflex_seabedorigindepth.yml") == pytest.approx([163.224], rel=3e-5)
    assert "SeabedOriginDepth" not in said


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("03_pontoon_four_corner_lines.txt", "catopt import --line N takes one"),
        ("07_failure_advice.txt", "catopt system --line-out"),
        ("08_early_v2_columns.txt", "Can (7), Cat (8), Cdn (9), Cdt (10)"),
        ("10_turned_body.txt", "body 1 is turned by 180 deg about z"),
        ("19_ontology_default_connector.yaml", "shackle is in no table of connectors"),
    ],
)
def test_what_is_taken_otherwise_is_said(name: str, words: str) -> None:
    assert words in brought(name, Asked(depth=200.0) if name[:2] == "08" else None)[1]


def test_the_drag_of_an_early_deck_is_that_of_its_heads() -> None:
    """Can 0.8, Cat 0.25, Cdn 2.0, Cdt 0.4; MoorDyn 2 would read Cd 0.8, Ca 0.25 by their place."""
    found, _ = brought("08_early_v2_columns.txt", Asked(depth=200.0))
    segment = found.line.segments[0]  # type: ignore[attr-defined]
    assert (segment.drag_normal, segment.added_mass_normal) == (2.0, 0.8)


@pytest.mark.parametrize(
    ("name", "asked", "words"),
    [
        ("11_free_body.txt", None, "a body that moves by itself"),
        ("16_grid_node_force.map", Asked(9.81, 1025.0, 30.0), "a constant force on a node"),
        ("17_rope_table.txt", None, "a table of strain and tension"),
    ],
)
def test_what_has_no_case_is_one_error(name: str, asked: Asked | None, words: str) -> None:
    with pytest.raises(InputError, match=words) as caught:
        brought(name, asked)
    assert len(caught.value.problems) == 1


def test_one_fault_of_many_lines_is_told_once() -> None:
    text = (BROUGHT / "03_pontoon_four_corner_lines.txt").read_text("utf-8")
    rows = text.splitlines()
    short = [row + " 0" if row.count(" ") == 8 and row[0].isdigit() else row for row in rows]
    with pytest.raises(InputError) as caught:
        read_any_deck("\n".join(short), "deck.txt")
    assert [(each.key, each.found) for each in caught.value.problems] == [
        ("lines 9, 10, 11, 12, 13, 14, 15 and 16", "10 columns")
    ]
