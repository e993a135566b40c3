"""Inputs that people brought to other programs: each ends in a case that is solved, or one reason.

They stand in brought/, in our own words and numbers after public issues, decks and questions of
MoorDyn, MAP++, OrcaFlex, OpenFAST, WEC-Sim and FAModel; H (kN) of each is what MoorPy 1.3.0 finds,
to the digits that are written here.
"""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from catopt import (
    InputError,
    NoEquilibriumError,
    StrainTable,
    read_case,
    solve_case,
    solve_many,
    solve_system,
)
from catopt.casefile import parse_case
from catopt.decks.reading import Asked, read_any_deck
from catopt.fem.solve import solve_line
from catopt.model.network import Network
from catopt.mooring.fixed_body import hold

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
    assert "4 lines that are not equal lines around a body" in said


def test_orcaflex_since_11_6_says_the_depth_elsewhere() -> None:
    """80 m to the bed, 79.9 m to where the line lies; MoorPy, with the line on the bed: 163.224."""
    found, said = brought("02_orcaflex_seabedorigindepth.yml")
    assert found.site.water_depth == pytest.approx(79.9, abs=1e-12)  # type: ignore[attr-defined]
    assert forces("02_orcaflex_seabedorigindepth.yml") == pytest.approx([163.224], rel=3e-5)
    assert "SeabedOriginDepth" not in said


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("03_pontoon_four_corner_lines.txt", "catopt import --line N extracts one"),
        ("07_failure_advice.txt", "catopt system --line-out"),
        ("08_early_v2_columns.txt", "Can (7), Cat (8), Cdn (9), Cdt (10)"),
        ("10_turned_body.txt", "body 1 is rotated by 180 deg about z"),
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
    ],
)
def test_what_has_no_case_is_one_error(name: str, asked: Asked | None, words: str) -> None:
    with pytest.raises(InputError, match=words) as caught:
        brought(name, asked)
    assert len(caught.value.problems) == 1


def test_a_table_of_strains_is_read_from_beside_the_deck() -> None:
    """What it solves to: tests/catenary/test_by_table.py, beside MoorDyn."""
    deck = BROUGHT / "17_rope_table.txt"
    found, _ = read_any_deck(deck.read_text("utf-8"), str(deck))
    EA = found.line.segments[0].EA  # type: ignore[union-attr]
    assert EA == StrainTable([0.0, 0.05, 0.1, 0.2], [0.0, 20e3, 60e3, 220e3])
    with pytest.raises(InputError, match="is next to the deck"):
        read_any_deck(deck.read_text("utf-8"), "elsewhere.txt")
    with pytest.raises(InputError, match="is next to the deck"):
        read_any_deck(deck.read_text("utf-8").replace("stiff.dat", "/etc/hosts"), str(deck))


def test_a_float_on_one_line_stands_over_its_anchor() -> None:
    """6 kN at the float, 400 m x 2 N/m less at its foot, stretched by 5.6 kN x 400 m / 4 MN."""
    from catopt.casefile import read_mooring

    found = hold(read_mooring(BROUGHT / "14_subsurface_float.toml"))  # type: ignore[arg-type]
    assert found.lines[0].fairlead.tension == pytest.approx(6e3, rel=1e-12)
    assert found.place_of("float") == pytest.approx((0.0, 0.0, 400.56), abs=1e-6)


def test_the_node_of_a_grid_is_in_balance_under_its_force() -> None:
    """Each line hangs as the elastic catenary with the pull of its end, and the pulls sum up.

    w of the rope is below 0: it floats up, and hangs the other way round.
    """
    network, said = brought("16_grid_node_force.map", Asked(9.81, 1025.0, 30.0))
    assert isinstance(network, Network)
    assert "free points" in said
    found = hold(network)
    x, y, z = found.place_of("2")
    assert y == 0.0
    w, EA = (1.3 - math.pi / 4.0 * 0.05**2 * 1025.0) * 9.81, 3e6
    total = [-30e3, 15e3]
    for line, anchor, length in zip(found.lines, (150.0, -150.0), (108.0, 204.0), strict=True):
        H, top = line.fairlead.horizontal_force, line.fairlead.vertical_force
        foot = top - w * length
        span = H / w * (math.asinh(top / H) - math.asinh(foot / H)) + H * length / EA
        rise = (math.hypot(H, top) - math.hypot(H, foot)) / w + (top + foot) * length / (2.0 * EA)
        assert (abs(x - anchor), z) == pytest.approx((span, rise), rel=1e-9)
        total[0] += math.copysign(H, anchor - x)
        total[1] -= top
    assert total == pytest.approx([0.0, 0.0], abs=1e-4)


def test_one_fault_of_many_lines_is_told_once() -> None:
    text = (BROUGHT / "03_pontoon_four_corner_lines.txt").read_text("utf-8")
    rows = text.splitlines()
    short = [row + " 0" if row.count(" ") == 8 and row[0].isdigit() else row for row in rows]
    with pytest.raises(InputError) as caught:
        read_any_deck("\n".join(short), "deck.txt")
    assert [(each.key, each.found) for each in caught.value.problems] == [
        ("lines 9, 10, 11, 12, 13, 14, 15 and 16", "10 columns")
    ]


def test_a_plumb_deck_is_solved() -> None:
    """600 m of line up 600 m of water, bare of tension at its foot, with what it stretches lying.

    The part l that hangs is stretched to the height: l + w l^2 / (2 EA) = 600 m.
    """
    found, _ = read_any_deck((BROUGHT / "20b_vertical_deck.txt").read_text("utf-8"), "20b.txt")
    assert not isinstance(found, Network)
    rest = solve_case(found)
    w = (685.0 - math.pi / 4.0 * 0.333**2 * 1025.0) * 9.80665
    hangs = (math.sqrt(1.0 + 2.0 * w * 600.0 / 3.27e9) - 1.0) * 3.27e9 / w
    assert (rest.span, rest.horizontal_force) == (0.0, 0.0)
    assert rest.fairlead.tension == pytest.approx(w * hangs, rel=1e-12)
    assert rest.anchor.tension == 0.0


@pytest.mark.parametrize("place", ["solve", "solve_many", "truss"])
def test_a_plumb_tether_is_stretched(place: str) -> None:
    """T = EA dL / L +- w L / 2 of a uniform line: 137,482 x 0.015 / 1.985 +- 0.9925 N."""
    case = read_case(BROUGHT / "20_vertical_span_zero.toml")
    top, foot = (137482.0 * 0.015 / 1.985 + side * 0.9925 for side in (1.0, -1.0))
    if place == "truss":
        truss = solve_line(case.line, height=2.0, span=0.0, elements=40)
        assert truss.end_tension[-1, -1] == pytest.approx(top, rel=1e-6)
        return
    if place == "solve":
        rest = solve_case(case)
        found = (rest.fairlead.tension, rest.anchor.tension, rest.span, rest.stretched_length)
    else:
        many = solve_many(case.line, height=2.0, span=[0.0])
        found = (many.tension[0], many.anchor_tension[0], many.span[0], 2.0)
    assert found == pytest.approx((top, foot, 0.0, 2.0), rel=1e-12)


def test_a_taut_tether_wants_a_longer_line() -> None:
    """The line weighs 55 N; EA (28 - 27.5) / 27.5 + 55 / 2 = 3663.86 N are its stretch."""
    case = read_case(BROUGHT / "06_tether_tension_message.toml")
    with pytest.raises(NoEquilibriumError) as caught:
        solve_case(case)
    said = str(caught.value)
    assert "stretching it that far takes 3663.86 N" in said
    assert "or a longer line" in said
    assert "weighs" not in said


def test_a_stiffness_beyond_all_lines_is_none() -> None:
    """MoorPy's tests have EA 7.51e12 N for a line that does not stretch."""
    text = "[site]\nwater_depth = 60\n[line]\n[[line.segments]]\nlength = 200\n"
    text += "submerged_weight = 900\nEA = {}\n[load]\nspan = 180\n"
    found = solve_case(parse_case(text.format("7.51e12")))
    assert (
        "segment 1 is practically inextensible: no line has an EA of 7.51e+12 N" in found.warnings
    )
    without = solve_case(parse_case(text.replace("EA = {}", "")))
    # What it stretches is T / EA, 1e-8 of its length, at tensions of some 100 kN.
    assert found.fairlead.tension == pytest.approx(without.fairlead.tension, rel=1e-6)
    assert not any("inextensible" in each for each in without.warnings)
    with pytest.raises(InputError, match="not plausible"):
        parse_case(text.format("1e21"))
