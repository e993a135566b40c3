"""The note of a moored body: what it holds, read back from its HTML, against the report itself."""

from __future__ import annotations

import hashlib
import math
from dataclasses import replace
from pathlib import Path

import pytest

from catopt.errors import NotConvergedError
from catopt.notes.checking import BODY, line_name
from catopt.notes.rounding import heading_of
from catopt.notes.system import SystemNote, directions_of, read_system_note
from catopt.quantities import QUANTITIES
from catopt.render.svg import WIDTH, Figure
from catopt.render.texts import Words
from catopt.report.page.render import render_page, sections_of
from catopt.report.page.sections import SECTIONS
from catopt.report.page.system.drawings import elevation, plan_section
from catopt.report.page.system.restoring import restoring
from catopt.report.page.system.watch_circle import watch_circle
from catopt.verify.compared import ROUNDING

from .page_reader import ReadPage, read_page
from .system_page_cases import EVERY, TEXTS, TURRET, known_note, known_page, system_path
from .test_page import FIELD, HOSTILE, shown_in_si

LAST_DIGIT = 1e-15
"""Relative: sums in another order, and a change of unit."""
SOLVED = 1e-9
"""Relative: solved twice, from another start."""
ROUNDED = 0.01
"""Coordinates are written to a hundredth, so that a place is off by half of that, twice."""
NINE_DIGITS = 1e-8
"""Relative, of the largest term: numbers that are put in are written with nine digits."""


@pytest.fixture(params=EVERY)
def name(request: pytest.FixtureRequest) -> str:
    return str(request.param)


@pytest.fixture
def note(name: str) -> SystemNote:
    return known_note(name)


@pytest.fixture
def page(name: str) -> ReadPage:
    return known_page(name)


# ------------------------------------------------------------------ the page as a whole


def test_the_page_is_well_formed_and_refers_to_nothing(page: ReadPage) -> None:
    assert page.unclosed == []
    assert not {element.tag for element in page.elements} & {"link", "img", "iframe", "object"}
    for element in page.elements:
        assert not {"src", "href", "srcset", "style", "onclick"} & set(element.attributes), element
        assert "://" not in " ".join(element.attributes.values()), element


@pytest.mark.slow
def test_the_same_case_gives_the_same_bytes(tmp_path: Path, name: str) -> None:
    path = system_path(tmp_path, name)
    first, second = (
        render_page(read_system_note(path, verify=name == "idle"), "vi") for _ in range(2)
    )
    assert first == second
    assert str(tmp_path).encode() not in first


def test_sections_stand_where_there_is_something_to_show(name: str, page: ReadPage) -> None:
    every = [section.key for section in SECTIONS[SystemNote]]
    left_out = {
        TURRET: {"warnings", "system_checks"},
        "arms": set(),
        "raised": {"warnings", "system_checks"},
        "idle": {"warnings", "system_checks", "system_watch_circle"},
        "pulled": set(),
        "lee": {"warnings", "system_checks"},
        "lone": {"warnings", "system_checks"},
    }[name]
    left_out = {"system_motion"} | left_out  # only where somebody asked
    assert list(page.sections) == [key for key in every if key not in left_out]
    assert [element.section for element in page.tagged("h2")] == list(page.sections)


def test_without_the_truss_model_its_section_is_left_out(tmp_path: Path) -> None:
    note = read_system_note(system_path(tmp_path, TURRET), verify=False, date="21.11.2026")
    page = read_page(render_page(note))
    assert "system_verification" not in page.sections
    assert page.table("identity").row("Date")[1].text == "21.11.2026"


@pytest.mark.parametrize("text", HOSTILE)
def test_what_the_user_writes_is_text_and_nothing_else(text: str) -> None:
    note = known_note(TURRET)
    case = replace(note.case, title=text, source=text)
    page = read_page(render_page(replace(note, case=case)))
    assert page.unclosed == []
    assert {each.tag for each in page.elements} == {
        each.tag for each in known_page(TURRET).elements
    }
    assert page.tagged("h1")[0].text == text
    assert page.table("identity").row("Source")[1].text == text


# ------------------------------------------------------------------ every number


def test_every_number_is_the_rounding_of_the_value_behind_it(
    page: ReadPage, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Within half of its last digit, and 1e-9 of itself, to which nine digits are written."""
    for unit in ("kN/rad", "kN*m/rad"):
        monkeypatch.setitem(FIELD, unit, 1e3)
    for unit in ("N m", "N*m"):
        monkeypatch.setitem(FIELD, unit, 1.0)
    count = 0
    for table in page.tables:
        for row in table.rows:
            for cell, heading in zip(row, table.headings or [""] * len(row), strict=True):
                if cell.value is not None:
                    shown, half = shown_in_si(cell, heading)
                    assert abs(shown - cell.value) <= half * (1 + 1e-9) + 1e-9 * abs(cell.value)
                    count += 1
    assert count > 100


def test_results_are_those_of_the_body(note: SystemNote, page: ReadPage) -> None:
    solution, table = note.solution, page.table("system_results")
    expected = {
        "Force on the body, along x": solution.system.force[0],
        "Force on the body, along y": solution.system.force[1],
        "Zero-load position x": solution.neutral.x,
        "Zero-load position y": solution.neutral.y,
        "Position under the load x": solution.position.x,
        "Position under the load y": solution.position.y,
        "Offset along x": solution.offset[0],
        "Offset along y": solution.offset[1],
        "Offset": math.hypot(*solution.offset),
        "Stiffness kxx": solution.stiffness[0][0],
        "Stiffness kxy": solution.stiffness[0][1],
        "Stiffness kyy": solution.stiffness[1][1],
        "Residual of the balance of forces": solution.residual.force,
    }
    if solution.system.turns:
        expected |= {
            "Moment on the body": solution.system.moment,
            "Zero-load yaw": solution.neutral.yaw,
            "Yaw under the load": solution.position.yaw,
            "Stiffness of x against yaw": solution.full_stiffness[0][2],
            "Stiffness of y against yaw": solution.full_stiffness[1][2],
            "Stiffness in yaw": solution.full_stiffness[2][2],
            "Residual of the balance of moments": solution.residual.moment,
        }
    assert {row[0].text: row[1].value for row in table.rows} == expected
    for row in table.rows:
        # Nine digits, or what is left of a zero at 1e-9.
        digits = float(row[2].text.split()[0])
        assert digits == pytest.approx(row[1].value, rel=1e-8, abs=1e-9)


def test_lines_are_those_of_the_solution(note: SystemNote, page: ReadPage) -> None:
    solution, table = note.solution, page.table("system_lines")
    for row, line in zip(table.rows, solution.lines, strict=True):
        assert [cell.value for cell in row[1:]] == [
            line.leg.azimuth,
            line.horizontal_force,
            line.tension,
            line.solution.anchor.tension,
            line.solution.span,
            line.solution.grounded_length,
            line.utilisation(note.case.checks.safety_factor),
        ]
    assert table.marked == [solution.most_loaded]


def test_one_line_out_is_that_of_the_report(note: SystemNote, page: ReadPage) -> None:
    table = page.table("line_out")
    for row, each, used in zip(table.rows, note.report.line_out, note.left, strict=True):
        assert row[0].text == str(each.missing + 1)
        response = each.response
        if response is None:
            assert [cell.value for cell in row[1:]] == [None] * 7
            assert each.refusal in page.sections["system_line_out"]
            continue
        values = [response.x, response.y, response.offset, response.largest_tension]
        assert [cell.value for cell in row[1:5]] == values
        assert row[5].text == str(response.most_loaded + 1)
        assert [cell.value for cell in row[6:]] == [response.least_grounded, used]


def test_a_line_that_is_gone_loads_the_others_more() -> None:
    """By the factor of the strength, the utilisation is that of the fairlead's segment at least."""
    note = known_note(TURRET)
    MBL = note.case.line.segments[-1].MBL
    assert MBL is not None
    for each, used in zip(note.report.line_out, note.left, strict=True):
        assert each.response is not None
        assert used is not None
        assert used >= each.response.largest_tension / MBL * (1.0 - SOLVED)


def test_the_watch_circle_is_that_of_the_report(note: SystemNote, page: ReadPage) -> None:
    circle = note.report.circle
    assert bool(page.all("watch_circle")) == (circle is not None) == any(note.solution.system.force)
    if circle is None:
        return
    known = dict(zip(circle.directions, circle.responses, strict=True))
    rows = page.table("watch_circle").rows
    assert len(rows) >= 12
    for row in rows:
        response = known[row[0].value]  # type: ignore[index]
        values = [response.x, response.y, response.offset, response.largest_tension]
        assert [cell.value for cell in row[1:5]] == values
    shown = [known[row[0].value] for row in rows]  # type: ignore[index]
    assert circle.responses[circle.farthest] in shown
    assert circle.responses[circle.hardest] in shown


def test_restoring_curves_are_those_of_the_report(note: SystemNote, page: ReadPage) -> None:
    curves = note.report.curves
    assert len(curves) == len(page.all("restoring")) == 2
    for table, curve in zip(page.all("restoring"), curves, strict=True):
        known = [
            [offset, force, across, response.largest_tension]
            for offset, force, across, response in zip(
                curve.offset, curve.force, curve.force_across, curve.responses, strict=True
            )
        ]
        shown = [[cell.value for cell in row[:4]] for row in table.rows]
        assert all(row in known for row in shown)
        assert shown[0] == known[0]
        assert shown[-1] == known[-1]


def test_a_restoring_curve_goes_half_as_far_again_as_the_load_or_nearly_as_far() -> None:
    """Lines that do not stretch and are nearly taut are too short for more."""
    for name, share in ((TURRET, 1.5), ("lee", 0.9)):
        note = known_note(name)
        far = share * math.hypot(*note.solution.offset)
        for curve in note.report.curves:
            assert curve.offset[-1] == pytest.approx(far, rel=LAST_DIGIT)
            assert -curve.offset[0] == curve.offset[-1]


@pytest.mark.parametrize(
    ("force", "expected"),
    [
        ((-4e6, 0.0), (180.0, 90.0)),
        ((1e5, 1e5), (45.0, 135.0)),
        ((0.0, -1.0), (-90.0, 0.0)),
        ((-1e5, 1e5), (135.0, 45.0)),
        ((0.0, 0.0), (0.0, 90.0)),
    ],
)
def test_curves_go_along_the_force_and_across_it(
    force: tuple[float, float], expected: tuple[float, float]
) -> None:
    found = [math.degrees(angle) for angle in directions_of(force)]
    assert found == pytest.approx(expected, abs=1e-12)


def test_a_body_that_turns_is_told_to_be_free_to_turn_along_the_curves() -> None:
    """The moments of its lines vanish on both curves, whatever the moment of the case."""
    told = "free to turn, and no moment acts on it"
    for section in ("system_watch_circle", "system_restoring"):
        assert told in known_page("arms").sections[section]
        assert told not in known_page(TURRET).sections[section]
    system = known_note("arms").solution.system
    assert system.turns
    assert system.moment != 0.0
    # Its four lines are alike, so that all sides are: a moment would break the mirror.
    circle = known_note("arms").report.circle
    assert circle is not None
    mirrored = [circle.responses[k].largest_tension for k in (10, 20)]
    assert mirrored[0] == pytest.approx(mirrored[1], rel=SOLVED)


# ------------------------------------------------------------------ what decides


def test_the_title_block_says_what_decides() -> None:
    page, note = known_page(TURRET), known_note(TURRET)
    told = [element.text for element in page.styled("verdict", "system_identity")]
    factor = note.solution.lines[1].utilisation()
    assert told == [
        f"Most loaded is line 2: {note.loaded.tension / 1e3:.3f} kN at its fairlead. Largest "
        f"utilisation {factor:.3f} of the breaking load, with a safety factor of 1.00.",
        "The body goes 21.738 m from its zero-load position, towards 180.00 deg.",
        "With any one line gone: at most 2333.375 kN at a fairlead, in line 2 without line 1; the "
        "body goes at most 26.368 m, without line 1. Largest utilisation 0.380 of the breaking "
        "load, with a safety factor of 1.00.",
    ]
    assert page.table("identity").row("Mooring lines")[1].text == "9"
    force = page.table("identity").row("Force on the body")[1].text
    assert force == "4281.000 kN towards 180.00 deg, counter-clockwise from x"


def test_a_line_that_the_body_cannot_do_without_is_told() -> None:
    page = known_page("lone")
    (told,) = page.styled("fails", "system_identity")
    assert told.text == "Without line 1 there is no equilibrium."
    assert "no equilibrium: no line is left" in page.sections["system_line_out"]


def test_what_is_overrun_is_told_in_red() -> None:
    page, note = known_page("pulled"), known_note("pulled")
    failing = [each.text for each in page.styled("fails", "system_identity")]
    assert len(failing) == 3  # the checks, the intact body, one line out
    assert "1 of 6 checks fails" in failing[0]
    used = max(line.utilisation(2.0) or 0.0 for line in note.solution.lines)
    assert f"{used:.3f}" in failing[1]
    assert used > 1.0


def test_a_body_that_nothing_pushes_stays() -> None:
    told = [each.text for each in known_page("idle").styled("verdict", "system_identity")]
    assert told[1] == "The body is 0.000 m from its zero-load position."


def test_the_rule_of_practice_stands_beside_the_balance_or_says_why_not() -> None:
    note, page = known_note("pulled"), known_page("pulled")
    H = note.solution.lines[0].horizontal_force
    told = f"line 1 would carry H = 666.667 kN; by the balance it carries {H / 1e3:.3f} kN"
    assert told in page.sections["system_results"]
    assert "this system has 9." in known_page(TURRET).sections["system_results"]


# ------------------------------------------------------------------ checks


@pytest.mark.parametrize("name", ["arms", "pulled"])
def test_checks_are_those_of_every_line(name: str) -> None:
    note, page = known_note(name), known_page(name)
    results, table = note.checks.results, page.table("checks")
    assert len(table.rows) == len(results)
    for row, result in zip(table.rows, results, strict=True):
        of_it = "body" if result.load_case == BODY else result.load_case.removeprefix("line ")
        assert row[0].text == of_it
        assert row[1].text == result.name
        assert [cell.value for cell in row[2:5]] == [
            result.demand, result.capacity, result.utilisation
        ]  # fmt: skip
        assert row[5].text == ("passes" if result.passes else "FAILS")
    governing = note.checks.governing
    assert [results[index] for index in table.marked] == [governing]


def test_a_line_is_checked_as_the_balance_has_it() -> None:
    """The tension that is checked is the largest of each segment of each line."""
    note = known_note("arms")
    for index, line in enumerate(note.solution.lines):
        (tension,) = [
            each
            for each in note.checks.results
            if each.load_case == line_name(index) and each.kind == "tension"
        ]
        expected = line.solution.segments[0].max_tension
        assert tension.demand == pytest.approx(expected, rel=SOLVED)
        MBL = line.leg.line.segments[0].MBL
        assert MBL is not None
        assert tension.capacity == pytest.approx(MBL / 2.0, rel=LAST_DIGIT)


def test_the_reserve_of_buoyancy_is_against_all_lines_together() -> None:
    note = known_note("arms")
    (found,) = [each for each in note.checks.results if each.load_case == BODY]
    pull = sum(line.solution.fairlead.vertical_force for line in note.solution.lines)
    assert found.demand == pytest.approx(pull, rel=LAST_DIGIT)
    assert found.capacity == 700e3
    assert found.passes == (pull <= 700e3)


# ------------------------------------------------------------------ the equation trail


def value_of(formula: str) -> float:
    """Work a sum with its numbers put in out, as a pocket calculator would."""
    plain = formula.replace("−", "-").replace("√", "math.sqrt").replace("²", "**2")
    return float(eval(plain, {"math": math}))


def test_the_pulls_balance_the_force_with_the_numbers_of_the_page(
    note: SystemNote, page: ReadPage
) -> None:
    table = page.table("pulls")
    H, angle, along, across = (
        [row[table.headings.index(name)].value for row in table.rows]
        for name in ("H (N)", "φ", "H cos φ (N)", "H sin φ (N)")
    )
    largest = max(value for value in H if value is not None)
    for force, turn, x, y in zip(H, angle, along, across, strict=True):
        assert force is not None
        assert turn is not None
        assert (x, y) == (force * math.cos(turn), force * math.sin(turn))
    for axis, values in enumerate((along, across)):
        total = math.fsum(value for value in values if value is not None)
        assert total + note.solution.system.force[axis] == pytest.approx(0.0, abs=1e-9 * largest)


def test_every_step_of_the_balance_gives_what_it_says(note: SystemNote, page: ReadPage) -> None:
    largest = max(line.horizontal_force for line in note.solution.lines)
    for row in page.table("balance").rows:
        put_in = row[1].text.split("=")[-1]
        value = row[2].value
        assert value is not None
        if "…" not in put_in:
            arm = max(leg.anchor_radius for leg in note.solution.system.legs)
            scale = {"m": arm, "N": largest, "N m": largest * arm}[row[2].text.partition(" ")[2]]
            assert value_of(put_in) == pytest.approx(value, rel=NINE_DIGITS, abs=1e-8 * scale)
        if row[3].value is not None:
            scale = max(abs(row[3].value), largest if row[2].text.endswith("N") else 1.0)
            moments = largest * 100.0 if row[2].text.endswith("N m") else 0.0
            assert value == pytest.approx(row[3].value, abs=1e-9 * max(scale, moments))


def test_the_most_loaded_line_is_followed(note: SystemNote, page: ReadPage) -> None:
    assert f"Line {note.solution.most_loaded + 1}," in page.sections["system_line_trail"]
    rows = {row[0].text: row for row in page.table("trail").rows}
    row = rows["Tension at the fairlead"]
    assert row[3].value == pytest.approx(note.loaded.tension, rel=1e-9)
    assert row[4].value == note.loaded.tension
    assert rows["Span"][4].value == note.loaded.solution.span


# ------------------------------------------------------------------ verification


def test_the_verification_is_that_of_the_body(note: SystemNote, page: ReadPage) -> None:
    part = note.compared
    assert part is not None
    assert part.verdict == "agrees"
    loaded = note.solution.most_loaded
    shown = [row for table in page.all("verification") for row in table.rows]
    wanted = [each for each in part.quantities if each.line in (None, loaded)]
    assert [row[1].value for row in shown] == [each.closed_form for each in wanted]
    assert [row[2].value for row in shown] == [each.extrapolated for each in wanted]
    rows = page.table("compared_lines").rows
    for index, row in enumerate(rows):
        gaps = [each.gap for each in part.quantities if each.line == index]
        if row[2].value is not None:  # none where it is rounding
            assert row[2].value == pytest.approx(max(gaps), abs=ROUNDING)
    assert len(rows) == len(note.solution.lines)
    assert [row[0].value for row in page.table("meshes").rows] == [
        mesh.elements for mesh in part.meshes
    ]


def test_a_truss_without_an_answer_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def stops(*_: object, **__: object) -> None:
        raise NotConvergedError("it stopped short")

    monkeypatch.setattr("catopt.verify.case.verify_case", stops)
    note = read_system_note(system_path(tmp_path, "idle"))
    page = read_page(render_page(note))
    assert "it stopped short" in page.sections["warnings"]
    assert "NOT VERIFIED" in page.sections["system_verification"]


def test_what_cannot_be_computed_is_left_out_and_said(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def stops(*_: object, **__: object) -> None:
        raise NotConvergedError("it wanders")

    monkeypatch.setattr("catopt.mooring.case.watch_circle", stops)
    monkeypatch.setattr("catopt.mooring.case.restoring_curve", stops)
    beside = "is left out, for somewhere on it it wanders"
    note = read_system_note(system_path(tmp_path, TURRET), verify=False)
    assert note.warnings == (
        "the watch circle is left out: it wanders",
        f"the restoring curve towards 180.00 deg {beside}",
        f"the restoring curve towards 90.00 deg {beside}",
    )
    shown = [key for key, _ in sections_of(note, Words())]
    assert not {"system_watch_circle", "system_restoring"} & set(shown)


# ------------------------------------------------------------------ what it rests on


def test_the_case_file_is_there_in_full_with_its_hash(tmp_path: Path) -> None:
    path = system_path(tmp_path, "arms")
    page = read_page(render_page(read_system_note(path, verify=False)))
    assert page.tagged("pre")[0].text == TEXTS["arms"]
    digest = hashlib.sha256(path.read_bytes()).hexdigest()
    assert page.table("identity").row("File")[1].text == f"arms.toml, SHA-256 {digest}"
    assert page.table("inputs").row("system.fairlead_radius")[2].value == 25.0


def test_components_have_their_sources() -> None:
    page = known_page("arms")
    assert page.table("component").caption == "chain studless R3 76 mm"
    assert len(page.tagged("dt")) > 0
    (row,) = page.table("segments").rows
    assert row[1].text == "chain studless R3 76 mm"


# ------------------------------------------------------------------ drawings


def drawings(note: SystemNote) -> list[Figure]:
    words = Words()
    built = (plan_section(note, words), elevation(note, words), watch_circle(note, words),
             restoring(note, words))  # fmt: skip
    return [
        value for shown in built if shown for value in shown.values() if isinstance(value, Figure)
    ]


def test_a_flat_line_is_drawn_again_with_its_heights_magnified() -> None:
    assert elevation(known_note(TURRET), Words())["magnified"] is not None
    assert elevation(known_note("raised"), Words())["magnified"] is None


def test_every_point_that_answers_is_on_the_paper_and_says_something(note: SystemNote) -> None:
    for figure in drawings(note):
        assert len(figure.points) >= 2
        for point in figure.points:
            assert -ROUNDED <= point.x <= WIDTH + ROUNDED
            assert -ROUNDED <= point.y <= figure.height + ROUNDED
            assert point.text


def test_points_of_the_figures_say_what_the_report_has() -> None:
    note = known_note(TURRET)
    circle, curve = note.report.circle, note.report.curves[0]
    assert circle is not None
    shown, curves = watch_circle(note, Words()), restoring(note, Words())
    assert shown is not None
    assert curves is not None
    tension = QUANTITIES["tension"]
    response = circle.responses[30]
    assert shown["track"].points[30].text == (
        f"force towards 90.00 deg: offset {response.offset:.3f} m (x = {response.x:.3f} m, "
        f"y = {response.y:.3f} m), largest tension "
        f"{tension.format(response.largest_tension, unit=True)} in line {response.most_loaded + 1}"
    )
    last = curves["figure"].points[len(curve.offset) - 1].text
    assert last.startswith(
        f"towards 180.00 deg: offset {curve.offset[-1]:.3f} m, force {curve.force[-1] / 1e3:.3f} kN"
    )


def test_a_restoring_curve_is_drawn_up_to_four_times_the_force() -> None:
    """What a taut line takes beyond that would press the rest flat; the table has it."""
    for name, is_whole in ((TURRET, True), ("pulled", False), ("idle", True)):
        note = known_note(name)
        shown = restoring(note, Words())
        assert shown is not None
        most = 4.0 * math.hypot(*note.solution.system.force) or math.inf
        forces = [force for curve in note.report.curves for force in curve.force]
        drawn = [force for force in forces if abs(force) <= most]
        assert (len(drawn) == len(forces)) == is_whole
        figure = shown["figure"]
        assert len(figure.points) == len(drawn)
        assert bool(figure.notes) != is_whole
        assert shown["tables"][0].rows[-1][1].si == note.report.curves[0].force[-1]


def test_what_rounding_leaves_is_no_direction() -> None:
    assert heading_of(-21.7, -4.7e-14) == math.pi
    assert heading_of(0.0, 0.0) == 0.0
    assert heading_of(1.0, 1.0) == math.pi / 4.0


# ------------------------------------------------------------------ Vietnamese

CITED = {"checks": {6}, "component": {2, 4}}
"""Columns that cite documents, in the language of the documents."""


def test_the_vietnamese_page_leaves_only_citations_in_english(name: str) -> None:
    page = known_page(name, "vi")
    assert page.tagged("html")[0].attributes["lang"] == "vi"
    for table in page.tables:
        for row in table.rows:
            for index, cell in enumerate(row):
                if cell.lang:
                    assert index in CITED.get(table.key, set()), (table.key, cell)
    for element in page.tagged("span"):
        assert not element.attributes.get("lang"), element


def test_both_languages_have_the_same_numbers_and_other_words(name: str) -> None:
    pages = [known_page(name, "en"), known_page(name, "vi")]
    english, vietnamese = (
        [cell.value for table in page.tables for row in table.rows for cell in row]
        for page in pages
    )
    assert english == vietnamese
    assert list(pages[0].sections) == list(pages[1].sections)
    headings = [[each.text for each in page.tagged("h2")] for page in pages]
    assert not set(headings[0]) & set(headings[1])
    captions = [[table.caption for table in page.tables if table.caption] for page in pages]
    cited = {table.caption for page in pages for table in page.all("component")}
    assert not (set(captions[0]) & set(captions[1])) - cited


def test_no_text_of_the_page_is_missing_in_vietnamese(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    from tests.cli.vietnamese import gathered, untranslated

    missing = gathered(monkeypatch)
    render_page(known_note(name), "vi")
    assert untranslated(missing) == []
