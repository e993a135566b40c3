"""The note of a sizing: loads, what holds the line, and what is said, worked out by hand."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import pytest

from catopt.notes.directory import Asked
from catopt.notes.size import Given, SizeNote, size_note
from catopt.words import Message, say, term

from .page_reader import ReadPage, ReadTable, read_page
from .rendered import page_of
from .size_page_cases import EVERY, known_size_note, known_size_page

NINE_DIGITS = 1e-8
"""Relative: numbers that are put in are written with nine digits, five or fewer a product."""
FIVE_DIGITS = 5e-4
"""Relative: forces are products of up to five numbers, one of them squared, each within 5e-5."""
ROUNDING = 1e-13
"""Relative: sums in another order."""


@pytest.fixture(params=EVERY)
def name(request: pytest.FixtureRequest) -> str:
    return str(request.param)


@pytest.fixture
def note(name: str) -> SizeNote:
    return known_size_note(name)


@pytest.fixture
def page(name: str) -> ReadPage:
    return known_size_page(name)


def load_tables(page: ReadPage) -> list[ReadTable]:
    return page.all("size_load")


def test_the_recommendation_is_a_sentence() -> None:
    page = known_size_page("size-buoy")
    said = page.sections["summary"].replace("\N{NO-BREAK SPACE}", " ")
    assert (
        "One line of chain open-link 4D Q2 38 mm, 54.5 m long (1.98 shots), held by a concrete "
        "sinker of 20 t. Swing radius at low water 53.6 m." in said
    )
    assert "Governing: sliding of the sinker in load case storm, high water" in said
    steps = known_size_page("size-buoy").sections["size_identity"]
    assert "54 m for 54.5 m, fails by the uplift angle at the anchor" in steps
    tanker = known_size_page("size-tanker").sections["summary"]
    assert "a Stevpris Mk5 drag anchor of 1" in tanker
    assert "6 lines, evenly spaced" in known_size_page("six").sections["summary"]
    hawser = known_size_page("hawser").sections["summary"].replace("\N{NO-BREAK SPACE}", " ")
    assert "with a clump weight of 10 t at" in hawser


def test_forces_add_up_to_that_of_the_load_case(note: SizeNote, page: ReadPage) -> None:
    """All act along one direction, so that sizes add up with their signs."""
    tables = iter(load_tables(page))
    sums = page.table("size_sums")
    for at, row in zip(note.sizing.settled.posed.loads, sums.rows, strict=True):
        forces = [at.given]
        for _ in at.parts:
            forces += [cells[2].value or 0.0 for cells in next(tables).rows[:-1]]
        shown = dict(zip(sums.headings, row, strict=True))
        assert math.fsum(forces) == pytest.approx(at.horizontal_force, rel=ROUNDING)
        assert shown["Sum (kN)"].value == at.horizontal_force
        assert shown["Depth of still water (m)"].value == at.depth


def test_the_load_case_carries_what_the_loads_add_up_to(name: str, note: SizeNote) -> None:
    """Of several lines each carries no less than the equilibrium gives the most loaded one."""
    states = {each.name: each.horizontal_force for each in note.line.checks.load_cases}
    for at in note.sizing.settled.posed.loads:
        if name != "six":
            assert states[at.load_case] == at.horizontal_force
            continue
        shown = known_size_page(name).table("size_sums").row(at.load_case)
        assert shown[-1].value == states[at.load_case]
        assert note.sizing.pattern is not None
        around = {each.load_case: each.line_force for each in note.sizing.pattern.states}
        assert states[at.load_case] >= around[at.load_case]


def product(text: str) -> float:
    """Work a formula with its numbers put in out, as a pocket calculator would."""
    plain = text.replace("\N{NO-BREAK SPACE}", " ").replace("²", "**2").replace(" · ", " * ")
    plain = plain.replace("−", "-")
    return float(eval(plain, {"__builtins__": {}}))


def test_formulas_with_their_numbers_put_in_give_the_forces(page: ReadPage) -> None:
    for table in load_tables(page):
        for row in table.rows[:-1]:
            _, _, numbers = row[1].text.partition("= ")
            assert numbers, row[0].text
            assert abs(product(numbers)) == pytest.approx(abs(row[2].value or 0.0), rel=FIVE_DIGITS)


def test_what_every_load_case_assumes_is_said_once(page: ReadPage) -> None:
    listed = [each.text for each in page.tagged("li") if each.section == "size_loads"]
    once = [text for text in listed if text.startswith(("Wind, current and waves", "Collinear"))]
    assert len(once) == len(set(once))


def test_a_force_that_is_given_stands_for_the_loads() -> None:
    page = known_size_page("given")
    assert load_tables(page) == []
    assert "The horizontal force was given" in page.sections["size_loads"]
    row = dict(zip(page.table("size_sums").headings, page.table("size_sums").rows[0], strict=True))
    assert row["Given (kN)"].value == 15e3


def test_a_candidate_that_fails_says_why() -> None:
    note = known_size_note("size-buoy")
    first, *rest = note.sizing.candidates
    check = Message(
        "checks.in_case",
        check=Message("checks.sliding"),
        load_case=Message("sizing.storm_high"),
    )
    why = Message("sizing.fails", what=check)
    assert why == "fails: sliding of the sinker (storm, high water)"
    failing = replace(first, settled=None, reason=why)
    told = replace(note, sizing=replace(note.sizing, candidates=(failing, *rest)))
    row = read_page(page_of(told)).table("candidates").rows[0]
    assert [cell.text for cell in row[3:8]] == ["-"] * 5
    assert row[8].text == why
    row = read_page(page_of(told, "vi")).table("candidates").rows[0]
    assert row[8].text == "không đạt: trượt của rùa neo (bão, mực nước cao)"


def test_of_the_lightest_line_the_knees_neighbours_are_left_out() -> None:
    note = known_size_note("hawser")
    assert note.sizing.settled.index == 0
    assert note.sizing.settled.result.recommended != 0
    assert known_size_page("hawser").all("neighbours") == []
    assert known_size_page("size-buoy").all("neighbours") != []
    assert "the lightest" in known_size_page("hawser").sections["size_front"]


@pytest.mark.parametrize("name", ["size-buoy", "given", "sinker"])
def test_the_sinker_is_worked_out_step_by_step(name: str) -> None:
    note, table = known_size_note(name), known_size_page(name).table("size_hold")
    document = note.sizing.to_dict()["sinker"]
    shown = {row[0].text: row for row in table.rows}
    for label, key in (
        ("Mass in air that is needed", "needed_mass_kg"),
        ("Friction on the soil, tan δ", "friction"),
        ("Density of the sinker", "density_kg_per_m3"),
        ("Its weight in water", "submerged_weight_N"),
        ("Safety factor that is wanted", "wanted_factor"),
        ("Factor that is reached", "factor"),
    ):
        assert shown[label][2].value == document[key]
    # From mu (W - V) >= SF H, worked out here once more.
    H = shown["Largest horizontal pull of the line at its anchor"][2].value
    V = shown["Largest lift of the line at its anchor"][2].value
    assert H is not None
    assert V is not None
    W = V + document["wanted_factor"] * H / document["friction"]
    assert shown["Weight in water that is needed"][2].value == pytest.approx(W, rel=ROUNDING)
    mass = W / (9.80665 * (1.0 - 1025.0 / document["density_kg_per_m3"]))
    assert document["needed_mass_kg"] == pytest.approx(mass, rel=ROUNDING)
    # What the user gave stands among the inputs of the note.
    assert (shown["Friction on the soil, tan δ"][3].text == "this note") == (name == "given")
    assert shown["Density of the sinker"][3].text == "catopt's own, recalled [R]"


def test_the_steps_with_their_numbers_put_in_give_their_values() -> None:
    for name in EVERY:
        for row in known_size_page(name).table("size_hold").rows:
            _, lined, numbers = row[1].text.partition("\n= ")
            if lined:
                plain = numbers.replace("−", "-").replace("·", "*").replace("^", "**")
                found = eval(plain, {"__builtins__": {}})
                assert found == pytest.approx(row[2].value, rel=NINE_DIGITS), row[0].text


@pytest.mark.parametrize("name", ["size-tanker", "six", "hawser"])
def test_the_drag_anchor_is_worked_out_step_by_step(name: str) -> None:
    page = known_size_page(name)
    document = known_size_note(name).sizing.to_dict()["drag_anchor"]
    shown = {row[0].text: row[2].value for row in page.table("size_hold").rows}
    assert shown["Mass in air that is needed"] == document["needed_mass_kg"]
    assert shown["Next mass of the series"] == document["mass_kg"]
    assert shown["Its ultimate holding capacity"] == document["holding_capacity_N"]
    assert shown["Safety factor that is wanted"] == document["wanted_factor"]
    assert shown["Factor that is reached"] == document["factor"]
    anchor = known_size_note(name).sizing.drag_anchor
    assert anchor is not None
    assert anchor.capacity.curve.source.text in page.sections["size_hold"]
    sources = {row[0].text: row[3].text for row in page.table("size_hold").rows}
    for label in ("Holding capacity", "Mass"):
        assert "DTOcean" in sources[f"{label} of the reference anchor"]
    assert "DTOcean" in sources["Exponent"]


def test_the_swing_radius_is_the_sum_of_its_parts(note: SizeNote, page: ReadPage) -> None:
    document = note.sizing.to_dict()["swing_radius"]
    *parts, total = page.table("size_swing").rows
    assert [(row[0].text, row[1].value) for row in parts] == [
        (each["name"], each["length_m"]) for each in document["parts"]
    ]
    assert total[1].value == document["total_m"]
    assert math.fsum(row[1].value or 0.0 for row in parts) == total[1].value
    assert document["load_case"] in page.table("size_swing").caption


def test_the_pattern_has_the_rule_beside_the_equilibrium() -> None:
    page, note = known_size_page("six"), known_size_note("six")
    document = note.sizing.to_dict()["pattern"]
    keys = (
        "force_N", "rule_force_N", "line_force_N", "tension_N", "direction_rad", "offset_m",
        "pull_N",
    )  # fmt: skip
    for row, state in zip(page.table("pattern").rows, document["states"], strict=True):
        assert [cell.value for cell in row[1:]] == [state[key] for key in keys]
        # S4's rule for six lines, worked out here.
        assert state["rule_force_N"] == pytest.approx(state["force_N"] / 1.5, rel=ROUNDING)
    assert f"{document['anchor_radius_m']:.3f} m" in page.sections["size_pattern"]


def test_offset_and_pull_of_the_pattern_are_told_to_be_of_another_direction() -> None:
    """Hardest on a line is the force against it; the body goes farthest between two lines."""
    page, note = known_size_page("six"), known_size_note("six")
    table = page.table("pattern")
    assert note.sizing.pattern is not None
    assert note.around is not None
    index = note.sizing.pattern.states.index(note.sizing.pattern.hardest)
    drawn = math.hypot(*note.around.offset)
    offset = next(k for k, each in enumerate(table.headings) if "offset of the body" in each)
    assert (table.rows[index][offset].value or 0.0) > 1.01 * drawn
    assert table.headings[offset].startswith("Largest")
    assert table.headings[offset + 1].startswith("Largest pull")
    assert f"{drawn:.3f} m" in page.sections["size_pattern"]
    assert "are the largest of all directions" in page.sections["size_pattern"]


def test_the_lines_of_the_pattern_balance_the_load() -> None:
    page, note = known_size_page("six"), known_size_note("six")
    assert note.sizing.pattern is not None
    *lines, total, load = page.table("size_lines").rows
    assert len(lines) == 6
    largest = max(row[2].value or 0.0 for row in lines)
    assert largest == pytest.approx(note.sizing.pattern.hardest.line_force, rel=1e-9)
    for axis in (4, 5):
        values = [row[axis].value or 0.0 for row in lines]
        assert total[axis].value == pytest.approx(math.fsum(values), rel=ROUNDING, abs=1e-6)
        # The solver's own residual, of forces of 1e5 N.
        assert total[axis].value == pytest.approx(-(load[axis].value or 0.0), abs=1e-2)


def test_without_a_file_the_options_are_the_inputs() -> None:
    sizing = known_size_note("size-buoy").sizing
    options = (("BUOY", "pillar 2.4 m"), ("--depth", "12 m"))
    page = read_page(page_of(size_note(sizing, Given(None, options), Asked(verify=False))))
    assert [[cell.text for cell in row] for row in page.table("size_options").rows] == [
        list(pair) for pair in options
    ]
    assert page.all("inputs") == []
    assert "size_file" not in page.sections
    assert "verification" not in page.sections


def test_warnings_of_the_sizing_stand_once_each(note: SizeNote, page: ReadPage) -> None:
    listed = [each.text for each in page.tagged("li") if each.section == "warnings"]
    assert listed[: len(note.sizing.warnings)] == list(note.sizing.warnings)
    bare = [text.rstrip(".").casefold() for text in listed]
    assert len(set(bare)) == len(bare)


@pytest.mark.parametrize(("language", "said"), [("en", "this note"), ("vi", "bản thuyết minh này")])
def test_limits_that_no_document_has_are_from_the_note(name: str, language: Any, said: str) -> None:
    """Holding capacity and buoyancy come out of the sizing: there is no case file to look into."""
    page = known_size_page(name, language)
    own = [each for each in known_size_note(name).line.checks.results if not each.source.confidence]
    tables = [table for table in page.tables if table.key == "checks"]
    sources = [row[5].text for table in tables for row in table.rows]
    assert sources.count(said) == len(own)
    assert not {"case file", "tệp số liệu"} & set(sources)


def test_load_cases_have_vietnamese_names_in_every_section(name: str, note: SizeNote) -> None:
    """For catopt made them, and no user did."""
    page = known_size_page(name, "vi")
    cited = ("warnings", "size_file")
    told = " ".join(text for key, text in page.sections.items() if key not in cited)
    for state in note.line.checks.load_cases:
        vietnamese = say(term(state.name), "vi")
        assert vietnamese != state.name
        assert state.name not in told
        assert vietnamese in page.sections["load_cases"]
