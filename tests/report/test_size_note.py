"""The note of a sizing: loads, what holds the line, and what is said, worked out by hand."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import pytest

from catopt.notes.line import Given, size_note
from catopt.notes.origin import Asked
from catopt.words import LANGUAGES, Message, say, term

from .notes import SIZINGS, note_named, page_named, shown
from .page_reader import ReadPage, calculate

NINE_DIGITS = 1e-8
"""Relative: numbers that are put in are written with nine digits, five or fewer a product."""
FIVE_DIGITS = 5e-4
"""Relative: forces are products of up to five numbers, one of them squared, each within 5e-5."""
ROUNDING = 1e-13
"""Relative: sums in another order."""


@pytest.fixture(params=SIZINGS)
def name(request: pytest.FixtureRequest) -> str:
    return str(request.param)


@pytest.fixture
def note(name: str) -> Any:
    return note_named(name)


@pytest.fixture
def page(name: str) -> ReadPage:
    return page_named(name)


def test_forces_add_up_to_that_of_the_load_case(note: Any, page: ReadPage) -> None:
    """All act along one direction, so that sizes add up with their signs."""
    tables = iter(page.all("size_load"))
    sums = page.table("size_sums")
    loads = note.sizing.settled.posed.loads
    for at in loads:
        forces = [at.given]
        for _ in at.parts:
            forces += [cells[2].value for cells in next(tables).rows[:-1]]
        assert math.fsum(forces) == pytest.approx(at.horizontal_force, rel=ROUNDING)
    assert sums.column("Sum (kN)") == [at.horizontal_force for at in loads]
    assert sums.column("Depth of still water (m)") == [at.depth for at in loads]


def test_the_load_case_carries_what_the_loads_add_up_to(name: str, note: Any) -> None:
    """Of several lines each carries no less than the equilibrium gives the most loaded one."""
    states = {each.name: each.horizontal_force for each in note.line.checks.load_cases}
    for at in note.sizing.settled.posed.loads:
        factor = note.sizing.dynamic_factor
        sums = page_named(name).table("size_sums").row(at.load_case)
        assert sums[-1].value == states[at.load_case]
        if name != "six":
            assert states[at.load_case] == factor * at.horizontal_force
            continue
        around = {each.load_case: each.line_force for each in note.sizing.pattern.states}
        assert states[at.load_case] >= around[at.load_case]


def test_formulas_with_their_numbers_put_in_give_the_forces(page: ReadPage) -> None:
    for table in page.all("size_load"):
        for row in table.rows[:-1]:
            _, _, numbers = row[1].text.partition("= ")
            assert numbers, row[0].text
            force = abs(row[2].value)
            assert abs(calculate(numbers)) == pytest.approx(force, rel=FIVE_DIGITS)


def test_what_every_load_case_assumes_is_said_once(page: ReadPage) -> None:
    listed = [each.text for each in page.tagged("li", "size_loads")]
    once = [text for text in listed if text.startswith(("Wind, current and waves", "Collinear"))]
    assert len(once) == len(set(once))


def test_a_force_that_is_given_stands_for_the_loads() -> None:
    page = page_named("given")
    assert page.all("size_load") == []
    assert page.table("size_sums").column("Given (kN)")[0] == 15e3


def test_a_candidate_that_fails_says_why() -> None:
    note = note_named("size-buoy")
    first, *rest = note.sizing.candidates
    which = {"check": Message("checks.sliding"), "load_case": Message("sizing.storm_high")}
    check = Message("checks.in_case", **which)
    why = Message("sizing.fails", what=check)
    assert why == "fails: sliding of the sinker (storm, high water)"
    failing = replace(first, settled=None, reason=why)
    told = replace(note, sizing=replace(note.sizing, candidates=(failing, *rest)))
    english, vietnamese = (shown(told, each).table("candidates").texts()[0] for each in LANGUAGES)
    assert english[3:9] == ["-"] * 5 + [why]
    assert vietnamese[8] == "không đạt: trượt của rùa neo (bão, mực nước cao)"


def test_of_the_lightest_line_the_knees_neighbours_are_left_out() -> None:
    settled = note_named("hawser").sizing.settled
    assert settled.index == 0
    assert settled.result.recommended != 1
    assert page_named("hawser").all("neighbours") == []
    assert page_named("size-buoy").all("neighbours") != []


SAME_OF_BOTH = (
    ("Mass in air required", "needed_mass_kg"),
    ("Safety factor that is required", "wanted_factor"),
    ("Factor achieved", "factor"),
)
"""Rows of a sinker and of a drag anchor, with their keys in the document."""


@pytest.mark.parametrize("name", ["size-buoy", "given", "sinker"])
def test_the_sinker_is_worked_out_step_by_step(name: str) -> None:
    document = note_named(name).sizing.to_dict()["sinker"]
    rows = page_named(name).table("size_hold").by_name()
    for label, key in (
        *SAME_OF_BOTH,
        ("Friction on the soil, tan δ", "friction"),
        ("Density of the sinker", "density_kg_per_m3"),
        ("Its weight in water", "submerged_weight_N"),
    ):
        assert rows[label][2].value == document[key]
    # From mu (W - V) >= SF H, worked out here once more.
    H = rows["Largest horizontal pull of the line at its anchor"][2].value
    V = rows["Largest lift of the line at its anchor"][2].value
    W = V + document["wanted_factor"] * H / document["friction"]
    assert rows["Weight in water required"][2].value == pytest.approx(W, rel=ROUNDING)
    mass = W / (9.80665 * (1.0 - 1025.0 / document["density_kg_per_m3"]))
    assert document["needed_mass_kg"] == pytest.approx(mass, rel=ROUNDING)
    # What the user gave stands among the inputs of the note.
    assert (rows["Friction on the soil, tan δ"][3].text == "this note") == (name == "given")
    assert rows["Density of the sinker"][3].text == "catopt's own, recalled [R]"


def test_the_steps_with_their_numbers_put_in_give_their_values(page: ReadPage) -> None:
    for row in page.table("size_hold").rows:
        _, lined, numbers = row[1].text.partition("\n= ")
        if lined:
            found = calculate(numbers)
            assert found == pytest.approx(row[2].value, rel=NINE_DIGITS), row[0].text


@pytest.mark.parametrize("name", ["size-tanker", "six", "hawser"])
def test_the_drag_anchor_is_worked_out_step_by_step(name: str) -> None:
    page, sizing = page_named(name), note_named(name).sizing
    document = sizing.to_dict()["drag_anchor"]
    rows = page.table("size_hold").by_name()
    for label, key in (
        *SAME_OF_BOTH,
        ("Next mass of the series", "mass_kg"),
        ("Its ultimate holding capacity", "holding_capacity_N"),
    ):
        assert rows[label][2].value == document[key]
    assert sizing.drag_anchor.capacity.curve.source.text in page.sections["size_hold"]


def test_the_swing_radius_is_the_sum_of_its_parts(note: Any, page: ReadPage) -> None:
    document = note.sizing.to_dict()["swing_radius"]
    *parts, total = page.table("size_swing").rows
    assert [(row[0].text, row[1].value) for row in parts] == [
        (each["name"], each["length_m"]) for each in document["parts"]
    ]
    assert total[1].value == document["total_m"]
    assert math.fsum(row[1].value for row in parts) == total[1].value
    assert document["load_case"] in page.table("size_swing").caption


def test_the_pattern_has_the_rule_beside_the_equilibrium() -> None:
    """Hardest on a line is the force against it; the body goes farthest between two lines."""
    page, note = page_named("six"), note_named("six")
    table, document = page.table("pattern"), note.sizing.to_dict()["pattern"]
    forces = ("force_N", "rule_force_N", "line_force_N", "tension_N")
    keys = (*forces, "direction_rad", "offset_m", "pull_N")
    for row, state in zip(table.rows, document["states"], strict=True):
        assert [cell.value for cell in row[1:]] == [state[key] for key in keys]
        # S4's rule for six lines, worked out here.
        assert state["rule_force_N"] == pytest.approx(state["force_N"] / 1.5, rel=ROUNDING)
    assert f"{document['anchor_radius_m']:.3f} m" in page.sections["size_pattern"]
    index = note.sizing.pattern.states.index(note.sizing.pattern.hardest)
    drawn = math.hypot(*note.around.offset)
    offset = next(k for k, each in enumerate(table.headings) if "offset of the body" in each)
    assert table.rows[index][offset].value > 1.01 * drawn
    assert table.headings[offset].startswith("Largest")
    assert table.headings[offset + 1].startswith("Largest downward pull")
    assert f"{drawn:.3f} m" in page.sections["size_pattern"]


def test_the_lines_of_the_pattern_balance_the_load() -> None:
    pattern = note_named("six").sizing.pattern
    *lines, total, load = page_named("six").table("size_lines").rows
    assert len(lines) == 6
    largest = max(row[2].value for row in lines)
    assert largest == pytest.approx(pattern.hardest.line_force, rel=1e-9)
    for axis in (4, 5):
        values = [row[axis].value for row in lines]
        assert total[axis].value == pytest.approx(math.fsum(values), rel=ROUNDING, abs=1e-6)
        # The solver's own residual, of forces of 1e5 N.
        assert total[axis].value == pytest.approx(-load[axis].value, abs=1e-2)


def test_without_a_file_the_options_are_the_inputs() -> None:
    sizing = note_named("size-buoy").sizing
    options = (("BUOY", "pillar 2.4 m"), ("--depth", "12 m"))
    page = shown(size_note(sizing, Given(None, options), Asked(verify=False)))
    assert page.table("size_options").texts() == [list(pair) for pair in options]
    assert page.all("inputs") == []
    assert not {"size_file", "verification"} & set(page.sections)


def test_warnings_of_the_sizing_stand_once_each(note: Any, page: ReadPage) -> None:
    listed = [each.text for each in page.tagged("li", "warnings")]
    assert listed[: len(note.sizing.warnings)] == list(note.sizing.warnings)
    bare = [text.rstrip(".").casefold() for text in listed]
    assert len(set(bare)) == len(bare)


@pytest.mark.parametrize(("language", "said"), [("en", "this note"), ("vi", "bản thuyết minh này")])
def test_limits_that_no_document_has_are_from_the_note(name: str, language: Any, said: str) -> None:
    """Holding capacity and buoyancy come out of the sizing: there is no case file to look into."""
    own = [each for each in note_named(name).line.checks.results if not each.source.confidence]
    tables = page_named(name, language).all("checks")
    sources = [row[5].text for table in tables for row in table.rows]
    assert sources.count(said) == len(own)
    assert not {"case file", "tệp số liệu"} & set(sources)


def test_load_cases_have_vietnamese_names_in_every_section(name: str, note: Any) -> None:
    """For catopt made them, and no user did."""
    page = page_named(name, "vi")
    cited = ("warnings", "size_file")
    told = " ".join(text for key, text in page.sections.items() if key not in cited)
    for state in note.line.checks.load_cases:
        vietnamese = say(term(state.name), "vi")
        assert vietnamese != state.name
        assert state.name not in told
        assert vietnamese in page.sections["load_cases"]
