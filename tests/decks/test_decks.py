"""Decks of MoorDyn and MAP++ as cases: what is read, said and refused."""

from __future__ import annotations

import math
import re
from pathlib import Path

import pytest

from catopt import InputError, read_case, solve_case
from catopt.casefile import parse_case, write_case
from catopt.decks.reading import Asked, is_deck, read_deck
from catopt.mooring.case import report_system
from catopt.words import say
from catopt.words.message import say_refusal
from tests.cli.test_refusals_in_vietnamese import ENGLISH, words_of
from tests.decks.own import C06, MAP, MOORDYN, ONTOLOGY, TWO_SEGMENTS, V1, problems, said
from tests.export.cases import CASES

OC3 = {"types": "0.09 77.7066 384.243e6 0.001 0 0 0 0", "length": 902.2}
OC3_ENDS = {"anchor": "853.87 0", "fairlead": "5.2 0 -70"}
OC4 = {"types": "0.0766 113.35 753.6e6 1.0 0 0 0 0", "length": 835.35}
OC4_ENDS = {"anchor": "418.8 725.383", "fairlead": "20.434 35.393 -14"}
STEEP = {"types": "0.064929 138.73 545e6 1.0 0 0 0 0", "length": 125}
STEEP_ENDS = {"anchor": "-50 0", "fairlead": "0 0 0"}


@pytest.mark.parametrize(
    ("deck", "asked", "H", "V", "T", "H_anchor", "grounded"),
    [
        # MAP++ 1.20.10, summary of OpenFAST's r-test, CB 0.001; three decimals are printed.
        (OC3 | OC3_ENDS, (9.80665, 320.0), 736939.290, 535727.992, 911089.457, 736845.198, 134.785),
        # MAP++ 1.10.01, line 1, CB 1.0.
        (OC4 | OC4_ENDS, (9.80665, 200.0),
         909408.441, 631704.309, 1107282.279, 651246.724, 242.346),
        # MAP++'s own example; its diameter is printed with six decimals.
        (STEEP | STEEP_ENDS, (9.81, 100.0), 17449.668, 149176.924, 150194.026, 670.624, 12.638),
    ],
)  # fmt: skip
def test_printed_figures_of_mappp(
    deck: dict[str, object],
    asked: tuple[float, float],
    H: float,
    V: float,
    T: float,
    H_anchor: float,
    grounded: float,
) -> None:
    """To the printed digits; 2e-8 of the tension is what MAP++'s own tolerance leaves."""
    found = read_deck(MAP.format(**deck), "map.dat", Asked(asked[0], 1025.0, asked[1]))
    solved = solve_case(found.case)
    close = 2e-8 * T + 5e-4
    assert solved.horizontal_force == pytest.approx(H, abs=close)
    assert solved.fairlead.vertical_force == pytest.approx(V, abs=close)
    assert solved.fairlead.tension == pytest.approx(T, abs=close)
    assert solved.anchor.horizontal_force == pytest.approx(H_anchor, abs=close)
    assert solved.grounded_length == pytest.approx(grounded, abs=1e-3)


def test_repeat_turns_clockwise() -> None:
    """An anchor on the x axis turned clockwise by 90 deg lies on -y; at 180 on -x."""
    deck = MAP.format(**OC3, **OC3_ENDS) + "repeat 90 180\n"
    found = read_deck(deck, "map.dat", Asked(9.80665, 1025.0, 320.0))
    system = found.case.system
    assert system is not None
    degrees = [math.degrees(leg.azimuth) for leg in system.legs]
    assert degrees == pytest.approx([0.0, -90.0, -180.0], abs=1e-9)
    assert "clockwise" in said(found)


def test_a_body_with_three_lines() -> None:
    """Radii and directions as in the report, and the H that MAP++ prints for each line."""
    found = read_deck(MOORDYN, "oc3.txt")
    system = found.case.system
    assert system is not None
    assert len(system.legs) == 3
    assert system.legs[0].anchor_radius == pytest.approx(853.87, abs=1e-3)
    assert system.legs[0].fairlead_radius == pytest.approx(5.2, abs=1e-3)
    assert [math.degrees(leg.azimuth) for leg in system.legs] == pytest.approx(
        [0.0, 120.0, -120.0], abs=1e-3
    )
    assert system.force == (0.0, 0.0)
    solved = report_system(found.case).solution
    assert solved.lines[0].solution.horizontal_force == pytest.approx(736939.290, abs=0.02)
    assert "no force on it" in said(found)


def test_version_1_has_its_own_columns() -> None:
    """Can Cat Cdn Cdt and length, segments, nodes; CdAx of pi d is drag_axial of d over pi."""
    found = read_deck(V1, "v1.dat")
    segment = found.case.line.segments[0]
    assert (segment.added_mass_normal, segment.added_mass_axial) == (1.0, 0.3)
    assert segment.drag_normal == 1.6
    assert segment.drag_axial == pytest.approx(0.1 * math.pi, rel=1e-15)
    assert segment.length == 902.2
    assert "version 1" in said(found)
    assert "has no g" in said(found)


def test_segments_and_a_clump_weight() -> None:
    """By hand, w = (m - pi/4 d^2 rho) g and W = (M - rho V) g.

    Chain (200 - 0.0314159265 x 1025) x 9.81 = 1646.105, rope (25 - 0.0176714587 x 1025) x 9.81 =
    67.559 N/m; clump weight (5000 - 656) x 9.81 = 42614.64 N.
    """
    found = read_deck(TWO_SEGMENTS, "two.txt")
    case = found.case
    chain, rope = case.line.segments
    assert (chain.name, rope.name, chain.length, rope.length) == ("chain", "rope", 500.0, 380.0)
    assert chain.submerged_weight == pytest.approx(1646.105, abs=5e-4)
    assert rope.submerged_weight == pytest.approx(67.559, abs=5e-4)
    (load,) = case.line.point_loads
    assert load.position == 500.0
    assert load.submerged_weight == pytest.approx(42614.64, abs=1e-8)
    assert (load.mass, load.drag_product, load.added_mass_coefficient) == (5000.0, 1.5, 0.5)
    assert "line 5: not used: bending stiffness EI 120000 N m^2 of rope" in said(found)


def test_statics_of_two_segments_are_those_of_moorpy_in_print() -> None:
    """MoorPy 1.3 on its own second deck, which is this one without the clump weight."""
    case = read_deck(TWO_SEGMENTS.replace("5000 0.64 1.5", "0 0 0"), "two.txt").case
    solved = solve_case(case)
    assert solved.horizontal_force == pytest.approx(550966.2, abs=0.6)
    assert solved.fairlead.tension == pytest.approx(686269.1, abs=0.7)
    assert solved.grounded_length == pytest.approx(267.041, abs=1e-3)


@pytest.mark.parametrize("text", [MOORDYN, TWO_SEGMENTS, V1])
def test_the_case_is_a_case_file(text: str) -> None:
    case = read_deck(text, "deck.txt").case
    assert parse_case(write_case(case)) == case


def test_remarks_are_said_in_vietnamese() -> None:
    found = read_deck(TWO_SEGMENTS, "two.txt")
    assert any("độ cứng uốn" in say(remark, "vi") for remark in found.remarks)


REFUSED = {
    MOORDYN: [
        ("--- LINES ---", "--- RODS ---\nx\nx\n1 rod Free 0 0 0 0 0 -5 4 -\n--- LINES ---",
         18, "rods"),
        ("--- LINES ---", "--- BODIES ---\nx\nx\n1 Free 0 0 0 0 0 0 1 0 0 1 0 0\n--- LINES ---",
         18, "body that moves by itself"),
        ("3 main 3 6", "3 main 3 9", 20, "no such point"),
        ("3 main 3 6", "3 chain 3 6", 20, "known: main"),
        ("3 main 3 6", "3 main 3 R1A", 20, "rods"),
        ("320 WtrDpth", "bath.txt WtrDpth", 24, "bed is level"),
        ("320 WtrDpth", "300 WtrDpth", 9, "below the bed"),
        ("1 main 1 4 902.2", "1 main 1 4 -902.2", 18, "above 0"),
        (" 1.6 1.0 0.1 0.0", " 1.6 1.0 0.1 0.0 0 0", 5, "12 columns"),
        ("384.243e6", "polyester.txt", 5, "is next to the deck"),
        ("--- OPTIONS ---", "--- SPRINGS ---\n1 2 3\n--- OPTIONS ---", 22, "not known"),
    ],
    ONTOLOGY: [
        ("{type: chain, length: 497.7}", "{type: wire, length: 497.7}", 21, "known: polyester,"),
        ("{type: chain, length: 497.7}", "{subsections: [[], []]}", 21, "parallel lines cannot"),
        ("{type: chain, length", "{mooringFamily: hair, d_nom: 1, length", 21, "chain_"),
        ("connectorType: clump", "connectorType: link", 22, "known: clump"),
        ("[leg, 150, drag1]", "[foot, 150, drag1]", 15, "known: leg"),
        ("[leg, 150, drag1]", "[leg, 150, drag1, 1]", 15, "4 values"),
        ("ms1, -1600", "ms2, -1600", 6, "one of ms1"),
        ("span: 642", "span: wide", 19, "a number above 0"),
        ("    span: 642\n", "", 18, "span is missing"),
        ("topsides:\n", "array_mooring: {line_data: [[a, b]]}\ntopsides:\n", 7, "--line N"),
        ("water_depth: 200,", "water_depth: 200, water_depth: *x,", 2, "not YAML"),
        ("topsides:\n", "topsides: [\n", 8, "not YAML"),
        ("water_depth: 200, ", "", 0, "water depth is missing"),
    ],
    C06: [
        ("UnitsSystem: SI", "UnitsSystem: US", 0, "save the model in SI"),
        ("SeabedType: Flat", "SeabedType: Profile", 9, "Flat is required"),
        ("  WindSpeed", "  SeabedSlope: 2\n  WindSpeed", 12, "level bed"),
        ("Category: General", "Category: Homogeneous pipe", 14, "General is required"),
        ("ID: 0\n", "ID: 0.05\n", 17, "hollow"),
        ("EA: 407.25725e3", "EA: rope", 20, "a number above 0"),
        ("    Connection: Free", "    Connection: Rotation", 34, "Free or Fixed"),
        ("InitialAttitude: [0, 0, 0]", "InitialAttitude: [2, 3, 0]", 34, "the order of several"),
        ("[CALM Base, 6, 0, -1.5, 0", "[Mooring9, 6, 0, -1.5, 0", 42, "one of CALM Base"),
        ("General:\n", "BaseFile: other.yml\nGeneral:\n", 3, "not followed"),
        ('[2.5" Chain, 195', "[rope, 195", 46, "known: 2.5"),
    ],
}  # fmt: skip
"""Of each deck what is replaced by what, and the line and words of the refusal; 0: the file."""


@pytest.mark.parametrize(
    ("deck", "change"),
    [(deck, change) for deck, rows in REFUSED.items() for change in rows],
    ids=lambda each: each[3] if isinstance(each, tuple) else each.splitlines()[0],
)
def test_what_has_no_case_is_refused_with_its_line(
    deck: str, change: tuple[str, str, int, str]
) -> None:
    old, new, line, words = change
    assert old in deck
    found = problems(deck.replace(old, new, 1), Asked(line=1) if deck is C06 else None)
    place = rf"lines? {line}\b.*: " if line else "file: "
    assert any(re.match(place, each) and words in each for each in found), found


@pytest.mark.slow
def test_every_refusal_is_said_in_vietnamese() -> None:
    """Nothing English stands in it but the deck's own words, and keys."""
    decks = [(deck, deck.replace(*row[:2], 1)) for deck, rows in REFUSED.items() for row in rows]
    asked = Asked(9.80665, 1025.0, 320.0)
    flags = ("omit_contact", "linear_spring", "damage_time", "wobble")
    whole = MAP.format(**OC3, **OC3_ENDS)
    decks += [(MAP, whole.replace("tension_fair", flag)) for flag in flags]
    for of, deck in decks:
        with pytest.raises(InputError) as caught:
            read_deck(
                deck, "deck.txt", asked if of is MAP else Asked(line=1) if of is C06 else None
            )
        told = say_refusal(caught.value.source, caught.value.problems, "vi")
        own = {*re.findall("[a-z]{2,}", deck), "deck"}
        assert words_of(told) & ENGLISH - own == set(), told


def test_a_joint_of_three_lines_is_refused_where_one_line_is_wanted() -> None:
    deck = TWO_SEGMENTS.replace("3 Coupled", "4 Coupled 800 50 0 0 0 0 0\n3 Coupled").replace(
        "2 chain 2 1", "3 rope 4 2 380 20 -\n2 chain 2 1"
    )
    (problem,) = problems(deck, Asked(line=1))
    assert problem.startswith("line 11: found point 2 of 3 lines")


def test_all_errors_at_once() -> None:
    deck = MOORDYN.replace("384.243e6", "stiff").replace("902.2 20", "long 20")
    found = problems(deck)
    assert [problem.split(":")[0] for problem in found] == [
        "line 5",
        "lines 18, 19 and 20",
    ]


@pytest.mark.parametrize("flag", ["omit_contact", "linear_spring", "wobble"])
def test_flags_of_mappp_that_change_the_answer(flag: str) -> None:
    deck = MAP.format(**OC3, **OC3_ENDS).replace("tension_fair", flag)
    (problem,) = problems(deck, Asked(9.80665, 1025.0, 320.0))
    assert problem.startswith(f"line 13: found {flag};")


def test_mappp_asks_for_what_it_has_not() -> None:
    (problem,) = problems(MAP.format(**OC3, **OC3_ENDS))
    assert '--gravity 9.80665 --density "1025 kg/m^3" --depth "200 m"' in problem


def test_a_word_for_the_bed_tabs_and_a_key_twice() -> None:
    deck = MOORDYN.replace("1 Fixed 853.87 0 -320", "1\tFixed 853.87 0 seabed").replace(
        "1025 rho", "1000 rho\n1025 rho"
    )
    found = read_deck(deck, "deck.txt")
    assert found.case.anchor_height == 0.0
    assert found.case.site.water_density == 1025.0
    for words in ("line 9: Z seabed", "line 9: a tab", "line 24: rho is given twice"):
        assert words in said(found)


def test_one_line_of_several() -> None:
    found = read_deck(MOORDYN, "deck.txt", Asked(line=2))
    assert found.case.system is None
    assert found.case.load is not None
    span = math.hypot(426.935 - 2.6, 739.473112 - 4.503332)
    assert found.case.load.span == pytest.approx(span, rel=1e-14)
    assert problems(MOORDYN, Asked(line=4)) == [
        "file: found --line 4; the deck has the lines 1 to 3"
    ]


def test_a_given_depth_beside_that_of_the_deck_is_refused() -> None:
    assert any("leave the option out" in each for each in problems(MOORDYN, Asked(depth=300.0)))


def test_which_file_is_a_deck(tmp_path: Path) -> None:
    place = tmp_path / "oc3.dat"
    place.write_bytes(MOORDYN.encode().replace(b"(m3)", b"(m\xb3)"))
    assert read_case(place).title == "oc3"
    assert is_deck(MOORDYN)
    assert not is_deck((CASES / "buoy-9.5m" / "case.toml").read_text("utf-8"))


def test_what_a_terminal_would_obey_is_refused_by_its_line() -> None:
    text = MOORDYN.replace("902.2", "902.2\u202e", 1).replace("main", "\x1b[31mmain", 1)
    found = problems(text)
    assert [each.split(":")[0] for each in found] == ["line 5", "line 18"]
    assert "remove it from the file" in found[0]
    assert not set("\x1b\u202e") & set("".join(found))


def test_a_long_word_is_shown_cut() -> None:
    (found,) = problems(MOORDYN.replace("902.2", "9x" * 100_000, 1))
    assert "..." in found
    assert len(found) < 200


def test_windows_line_ends() -> None:
    assert read_deck(MOORDYN.replace("\n", "\r\n"), "oc3.txt") == read_deck(MOORDYN, "oc3.txt")
