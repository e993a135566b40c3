"""The calculation note: what it holds, read back from its HTML, against the results themselves."""

from __future__ import annotations

import base64
import hashlib
import math
import re
from dataclasses import replace
from pathlib import Path

import pytest

from catopt import catalogue
from catopt.answers.check import QUANTITY_OF
from catopt.catenary import case_curve
from catopt.errors import NotConvergedError
from catopt.notes.line import Note, note_of, read_note
from catopt.notes.origin import SourceFile, file_name
from catopt.quantities import QUANTITIES
from catopt.render.texts import Words
from catopt.report.page.components import components
from catopt.report.page.render import render_page, sections_of
from catopt.report.page.sections import SECTIONS
from catopt.report.tables.load_curve import at_points
from catopt.units import UNITS

from .conftest import buoy_case
from .page_cases import CASES, EVERY, TEXTS, case_path, design_directory, known_note, known_page
from .page_reader import ReadCell, ReadPage, read_page


@pytest.fixture(params=EVERY)
def name(request: pytest.FixtureRequest) -> str:
    return str(request.param)


@pytest.fixture
def note(name: str) -> Note:
    return known_note(name)


@pytest.fixture
def page(name: str) -> ReadPage:
    return known_page(name)


@pytest.fixture
def designed(tmp_path: Path) -> Note:
    return read_note(design_directory(tmp_path))


# ------------------------------------------------------------------ the page as a whole


def test_the_page_is_well_formed_and_refers_to_nothing(note: Note) -> None:
    source = render_page(note)
    page = read_page(source)
    assert page.unclosed == []
    assert not {element.tag for element in page.elements} & {"link", "img", "iframe", "object"}
    for element in page.elements:
        assert not {"src", "href", "srcset", "style", "onclick"} & set(element.attributes), element
        assert "://" not in " ".join(element.attributes.values()), element
    for element in (*page.tagged("style"), *page.tagged("script")):
        assert not re.search(r"url\(|@import|https?:|fetch|XMLHttp|import\(", element.text)


def test_only_the_pages_own_script_may_run(note: Note) -> None:
    page = read_page(render_page(note))
    (policy,) = (
        element.attributes["content"]
        for element in page.tagged("meta")
        if element.attributes.get("http-equiv") == "Content-Security-Policy"
    )
    (script,) = (each for each in page.tagged("script") if "type" not in each.attributes)
    digest = base64.b64encode(hashlib.sha256(script.text.encode()).digest()).decode()
    assert f"script-src 'sha256-{digest}'" in policy
    assert "default-src 'none'" in policy


def test_the_same_case_gives_the_same_bytes(tmp_path: Path, name: str) -> None:
    path = case_path(tmp_path, name)
    first, second = (render_page(read_note(path), "vi") for _ in range(2))
    assert first == second
    assert str(tmp_path).encode() not in first


def test_a_date_stands_only_where_one_is_given() -> None:
    path = CASES / "buoy-9.5m" / "case.toml"
    dated = read_page(render_page(read_note(path, date="21 November 2026")))
    assert dated.table("identity").row("Date")[1].text == "21 November 2026"
    plain = read_page(render_page(read_note(path)))
    assert "Date" not in [row[0].text for row in plain.table("identity").rows]


def test_a_line_that_is_just_level_at_its_anchor_is_not_said_to_lie_on_the_bed() -> None:
    """The length is sought that gives 0 deg: what lies on the bed is rounding."""
    note = read_note(CASES / "tanker-20m-find-length" / "case.toml", verify=False)
    assert 0.0 < note.solution.grounded_length < 1e-9
    hangs = read_page(render_page(note)).table("identity").row("How it hangs")[1].text
    assert hangs == "the whole line hangs, just level at its anchor"


HOSTILE = [
    "<script>alert(1)</script>",
    '"><img src=x onerror=alert(1)>',
    "</title></style></script><b>",
    "$math$ {{ 7*7 }} {% raw %}",
    'it\'s "quoted" & <b>bold</b> &amp;',
    "phao luồng Hải Phòng – số 1",
]


@pytest.mark.parametrize("text", HOSTILE)
def test_what_the_user_writes_is_text_and_nothing_else(text: str) -> None:
    case = buoy_case(title=text, source=text)
    line = replace(case.line.segments[0], name=text)
    case = replace(case, line=type(case.line)([line]))
    source = SourceFile(text, f"title = '''{text}'''", "0" * 64)
    page = read_page(render_page(note_of(case, (source,), date=text)))
    usual = read_page(render_page(note_of(buoy_case(), (replace(source, name="", text=""),))))
    assert page.unclosed == []
    assert {each.tag for each in page.elements} == {each.tag for each in usual.elements}
    (heading,) = page.tagged("h1")
    assert heading.text == text
    assert page.table("identity").row("Source")[1].text == text
    assert page.table("segments").rows[0][1].text == text
    assert page.tagged("pre")[0].text == source.text


def test_sections_are_there_only_where_there_is_something_to_show(designed: Note) -> None:
    buoy = read_note(CASES / "buoy-9.5m" / "case.toml")
    shown = [key for key, _ in sections_of(buoy, Words())]
    assert not {"checks", "load_cases", "front", "warnings"} & set(shown)
    assert [key for key, _ in sections_of(designed, Words())] == [
        each.key for each in SECTIONS[type(designed)] if each.key not in {"swarm", "in_motion"}
    ]
    page = read_page(render_page(buoy))
    assert list(page.sections) == shown
    headings = [element.section for element in page.tagged("h2")]
    assert headings == shown


# ------------------------------------------------------------------ every number


FIELD = {
    **{unit: factor for table in UNITS.values() for unit, factor in table.items()},
    **{each.field_unit: each.factor for each in QUANTITIES.values()},
    "°": math.pi / 180.0, "": 1.0, "kg/m^3": 1.0,
}  # fmt: skip
NUMBER = re.compile(
    r"(?P<number>-?\d+(?:\.(?P<decimals>\d+))?(?:e(?P<power>[+-]?\d+))?) ?(?P<unit>\S*)"
)


def shown_in_si(cell: ReadCell, heading: str) -> tuple[float, float]:
    """Return what a cell shows first, in SI, and half a unit of its last digit."""
    match = NUMBER.match(cell.text.replace("−", "-"))
    assert match is not None, cell
    in_heading = re.search(r"\(([^()]*)\)$", heading)
    unit = match["unit"] or (in_heading[1] if in_heading else "")
    factor = FIELD[unit]
    power = 10.0 ** int(match["power"] or 0)
    half = 0.5 * 10.0 ** -len(match["decimals"] or "") * power * factor
    return float(match["number"]) * factor, half


def test_every_number_is_the_rounding_of_the_value_behind_it(page: ReadPage) -> None:
    """Within half of its last digit, and 1e-9 of itself, to which SI values are written."""
    count = 0
    for table in page.tables:
        for row in table.rows:
            for cell, heading in zip(row, table.headings or [""] * len(row), strict=True):
                if cell.value is not None:
                    shown, half = shown_in_si(cell, heading)
                    assert abs(shown - cell.value) <= half * (1 + 1e-9) + 1e-9 * abs(cell.value)
                    count += 1
    assert count > 50


def test_results_are_those_of_the_solution(note: Note, page: ReadPage) -> None:
    solution, table = note.solution, page.table("results")
    expected = {
        "Inclination at the anchor θ₀": solution.anchor.angle,
        "Span S": solution.span,
        "Fairlead tension T": solution.fairlead.tension,
        "Horizontal force H": solution.horizontal_force,
        "Fairlead vertical force V": solution.fairlead.vertical_force,
        "Inclination at the fairlead θ₁": solution.fairlead.angle,
        "Anchor tension": solution.anchor.tension,
        "Anchor horizontal force": solution.anchor.horizontal_force,
        "Anchor vertical force": solution.anchor.vertical_force,
        "Grounded length": solution.grounded_length,
        "Suspended length": solution.suspended_length,
        "Stretched length": solution.stretched_length,
        "Residual of the height": solution.residual.height,
        "Residual of the span": solution.residual.span,
        "Force left open by rounding of the input": solution.residual.force_uncertainty,
    }
    for label, value in expected.items():
        assert table.row(label)[1].value == value
        digits = float(table.row(label)[2].text.split()[0])
        assert digits == pytest.approx(value, rel=1e-8)  # nine digits are written
    assert ("Line mass in air" in [row[0].text for row in table.rows]) == (
        solution.line.mass is not None
    )


def test_what_was_sought_is_told() -> None:
    note = read_note(CASES / "ship-200m-sinker" / "case.toml")
    assert note.solution.found is not None
    page = read_page(render_page(note))
    row = page.table("results").row("Found length of segment 1 L")
    assert row[1].value == note.solution.found.value
    assert note.solution.found.condition in page.sections["results"]


def test_point_loads_are_those_of_the_solution(note: Note, page: ReadPage) -> None:
    states, loads = note.solution.point_loads, note.solution.line.point_loads
    assert bool(page.all("point_load_results")) == bool(states)
    if states:
        rows = [[cell.value for cell in row[1:]] for row in page.table("point_load_results").rows]
        assert rows == [[s.x, s.z, s.seabed_reaction] for s in states]
        rows = [[cell.value for cell in row[2:]] for row in page.table("point_loads").rows]
        assert rows == [[load.position, load.submerged_weight, load.mass] for load in loads]


def test_segments_are_those_of_the_line(note: Note, page: ReadPage) -> None:
    table = page.table("segments")
    for index, segment in enumerate(note.solution.line.segments):
        shown = dict(zip(table.headings, table.rows[index], strict=True))
        assert shown["Length L (m)"].value == segment.length
        assert shown["Submerged weight per length w (N/m)"].value == segment.submerged_weight
        for heading, value in (
            ("Minimum breaking load MBL (kN)", segment.MBL),
            ("Mass per length m (kg/m)", segment.mass),
        ):
            assert (shown[heading].value if heading in shown else None) == value


def test_checks_are_those_of_the_report(note: Note, page: ReadPage) -> None:
    results = note.checks.results
    rows = [row for table in page.all("checks") for row in table.rows]
    assert len(rows) == len(results)
    for row, result in zip(rows, results, strict=True):
        name, demand, capacity, utilisation, verdict, source, _ = row
        assert name.text == result.name
        assert (demand.value, capacity.value) == (result.demand, result.capacity)
        assert demand.text == QUANTITY_OF[result.kind].format(result.demand, unit=True)
        assert utilisation.value == result.utilisation
        assert verdict.text == ("passes" if result.passes else "FAILS")
        assert source.text in (result.source.text, "case file")
        assert (source.text == "case file") == (result.source.code == "user")
    marked = [table.rows[index] for table in page.all("checks") for index in table.marked]
    governing = note.checks.governing
    assert [row[0].text for row in marked] == ([] if governing is None else [governing.name])


def test_utilisation_bars_are_as_long_as_the_utilisation(note: Note, page: ReadPage) -> None:
    """In percent, to a tenth; a bar ends at the full width, in another colour."""
    bars = [
        element for element in page.tagged("rect")
        if element.attributes.get("class") in ("used", "over")
    ]  # fmt: skip
    used = [each.utilisation for each in note.checks.results if each.utilisation is not None]
    assert len(bars) == len(used)
    for bar, utilisation in zip(bars, used, strict=True):
        width = float(bar.attributes["width"])
        assert width == pytest.approx(100.0 * min(max(utilisation, 0.0), 1.0), abs=0.05)
        assert bar.attributes["class"] == ("over" if utilisation > 1.0 else "used")


def test_curve_points_are_those_of_the_curve(note: Note, page: ReadPage) -> None:
    assert note.curve is not None
    columns = at_points(note.curve)
    table = page.table("curve")
    shown = [[cell.value for cell in row] for row in table.rows]
    known = [
        [None if math.isnan(value) else value for value in row]
        for row in zip(*(values for _, values in columns), strict=True)
    ]
    assert all(row in known for row in shown)
    assert (shown[0], shown[-1]) == (known[0], known[-1])
    marks = note.curve.curve.marks
    assert bool(page.all("marks")) == bool(marks)
    if marks:
        rows = page.table("marks").rows
        assert [row[1].text for row in rows] == [mark.event for mark in marks]
        assert [row[4].value for row in rows] == [mark.horizontal_force for mark in marks]


def test_load_cases_are_those_that_were_solved() -> None:
    note = known_note("states")
    table = read_page(render_page(note)).table("load_cases")
    assert [row[0].text for row in table.rows] == ["storm (high water)", "everyday"]
    for row, (_, solution) in zip(table.rows, note.checks.solutions, strict=True):
        assert [cell.value for cell in row[2:]] == [
            solution.horizontal_force,
            solution.fairlead_height,
            solution.span,
            solution.fairlead.tension,
            solution.anchor.horizontal_force,
            solution.anchor.vertical_force,
            solution.grounded_length,
        ]
    assert note.checks.governing is not None
    assert [table.rows[index][0].text for index in table.marked] == [
        note.checks.governing.load_case
    ]


def test_the_load_case_that_governs_is_drawn() -> None:
    note = known_note("states")
    states = dict(note.checks.solutions)
    assert note.load_case == "storm (high water)"
    assert note.solution.span == states[note.load_case].span
    assert note.case.site.water_depth == 11.0


# ------------------------------------------------------------------ inputs and components


def test_every_input_stands_as_given_and_in_si() -> None:
    page = read_page(render_page(known_note("leg")))
    table = page.table("inputs")
    expected = {
        "site.water_depth": ('"56 m"', 56.0),
        "site.seabed_friction": ("0.6", 0.6),
        "line.segments[0].submerged_weight": ('"30.4 kgf/m"', 30.4 * 9.80665),
        "line.segments[0].EA": ('"382 MN"', 382e6),
        "line.point_loads[1].submerged_weight": ('"-40 kN"', -40e3),
        "load.horizontal_force": ('"1.2 MN"', 1.2e6),
        "line.segments[0].name": ('"wire"', None),
    }
    for key, (given, value) in expected.items():
        _, shown, si = table.row(key)
        assert shown.text == given
        assert si.value == (None if value is None else pytest.approx(value, rel=1e-15))
    values = sum("=" in line for line in TEXTS["leg"].splitlines())
    assert len(table.rows) == values - 1  # without the title


def test_inputs_of_many_values_are_shown_by_their_ends() -> None:
    note = read_note(CASES / "buoy-9.5m" / "case.toml")
    lengths = [f"{length} m" for length in range(10, 40)]
    design = {"design": {"segments": [{"lengths": lengths}]}}
    given_so = replace(note, origin=replace(note.origin, inputs=design))
    table = read_page(render_page(given_so)).table("inputs")
    ((_, given, si),) = table.rows
    assert given.text == '"10 m", "11 m", … "39 m" (30)'
    assert si.text == "10 m, 11 m, … 39 m (30)"


def test_components_have_their_sources_and_confidence(designed: Note) -> None:
    """A figure of the design's own is told from one of the catalogue."""
    table = read_page(render_page(designed)).table("component")
    shown = {row[0].text: row for row in table.rows}
    assert table.caption == "chain studless R3 76 mm"
    assert shown["Mass per length"][1].value == 115.0
    assert [cell.text for cell in shown["Mass per length"][2:]] == ["", "", "case file"]
    assert shown["Volume-equivalent diameter"][3].text in {"A", "B", "C"}
    assert ": " in shown["Volume-equivalent diameter"][4].text


def test_the_catalogues_figures_name_their_documents() -> None:
    note = known_note("states")
    chain = catalogue.component("chain studless R3", 0.076)
    page = read_page(render_page(note))
    shown = {row[0].text: row for row in page.table("component").rows}
    row = shown["Minimum breaking load"]
    assert row[1].value == chain.MBL
    assert row[3].text == chain.provenance["MBL"].confidence
    assert chain.provenance["MBL"].place in row[4].text
    cited = {element.text for element in page.tagged("dt")}
    assert {source.key for source in chain.provenance["MBL"].sources} <= cited
    assert components(note, Words())["own"] is False


def test_the_case_file_is_there_in_full_with_its_hash(tmp_path: Path) -> None:
    path = case_path(tmp_path, "leg")
    page = read_page(render_page(read_note(path)))
    assert page.tagged("pre")[0].text == path.read_text("utf-8")
    digest = hashlib.sha256(path.read_bytes()).hexdigest()
    assert page.table("identity").row("File")[1].text == f"leg.toml, SHA-256 {digest}"


def test_a_case_file_with_a_byte_order_mark_is_read_and_hashed_as_it_is(tmp_path: Path) -> None:
    path = tmp_path / "windows.toml"
    path.write_bytes(b"\xef\xbb\xbf" + TEXTS["slack"].replace("\n", "\r\n").encode())
    note = read_note(path)
    assert note.origin.files[0].sha256 == hashlib.sha256(path.read_bytes()).hexdigest()
    assert not note.origin.files[0].text.startswith("\ufeff")


# ------------------------------------------------------------------ warnings


def test_warnings_stand_once_each() -> None:
    note = read_note(CASES / "buoy-9.5m" / "case.toml")
    page = read_page(render_page(replace(note, warnings=("one thing", "another"))))
    (listed,) = page.styled("warnings")
    assert listed.tag == "ul"
    assert [e.text for e in page.tagged("li") if e.section == "warnings"] == [
        "one thing",
        "another",
    ]


def test_warnings_of_a_line_come_without_the_name_of_its_only_load() -> None:
    (warning,) = known_note("slack").warnings
    assert warning.startswith("the line is slack")


def test_a_curve_that_cannot_be_is_left_out_and_said(monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(*_: object, **__: object) -> None:
        raise NotConvergedError("it wanders")

    monkeypatch.setattr(case_curve, "curve_case", fail)
    note = read_note(CASES / "buoy-9.5m" / "case.toml")
    assert note.curve is None
    assert note.warnings == ("the load curve is left out: it wanders",)
    assert "curve" not in read_page(render_page(note)).sections


# ------------------------------------------------------------------ the front


def test_the_front_is_that_of_the_document(designed: Note) -> None:
    page = read_page(render_page(designed))
    assert designed.chosen is not None
    front = designed.chosen.document["front"]
    table = page.table("front")
    for row, point in zip(table.rows, front, strict=True):
        values = [cell.value for cell in row[1:4]]
        assert values == [point["mass_kg"], point["offset_m"], point["excursion_m"]]
        assert row[4].text == f"chain studless R3, {point['segments'][0]['length_m']:g} m; " + (
            "0.25 t, s = 7 m"
        )
    assert table.marked == [1]
    assert [row[-1].text for row in page.table("neighbours").rows] == [
        "passes",
        "FAILS: too short",
        "FAILS: uplift angle at the anchor (storm (high water))",
    ]
    assert "a price was read in no document" in page.sections["warnings"]
    beside = "Mass in air 3.450 t, Largest span 61.000 m; FAILS: offset (storm (high water))."
    assert beside in page.sections["front"]


def test_the_recommended_design_is_taken_unless_another_is_named(tmp_path: Path) -> None:
    directory = design_directory(tmp_path)
    assert read_note(directory).solution.line.length == 46.0
    third = read_note(directory, 3)
    assert third.solution.line.length == 47.0
    page = read_page(render_page(third))
    assert page.table("front").marked == [2]
    assert len(page.styled("chosen", "front")) == 2  # in the figure and in its legend


def test_a_long_front_is_shown_in_part_and_says_so(tmp_path: Path) -> None:
    page = read_page(render_page(read_note(design_directory(tmp_path, 12))))
    assert len(page.table("front").rows) == 12
    other = tmp_path / "long"
    other.mkdir()
    page = read_page(render_page(read_note(design_directory(other, 200))))
    rows = [int(row[0].text) for row in page.table("front").rows]
    assert len(rows) <= 28
    assert {1, 2, 200} <= set(rows)  # the ends, and the one that is recommended
    assert f"{200 - len(rows)} more designs" in page.sections["front"]
    points = [each for each in page.styled("design", "front") if "cx" in each.attributes]
    assert len(points) == 201  # all of them in the figure, and one in its legend


# ------------------------------------------------------------------ names


@pytest.mark.parametrize(
    ("place", "design", "name"),
    [
        ("cases/buoy-9.5m/case.toml", None, "buoy-9.5m.html"),
        ("mine.toml", None, "mine.html"),
        ("result", 3, "result-design-3.html"),
    ],
)
def test_a_page_is_named_after_its_case(
    tmp_path: Path, place: str, design: int | None, name: str
) -> None:
    path = tmp_path / place
    if design is not None:
        path.mkdir()
    assert file_name(path, design) == name


# ------------------------------------------------------------------ Vietnamese


FOREIGN = {"checks": {5}, "component": {2, 4}}
"""Columns that cite documents, in the language of the documents."""


def test_the_vietnamese_page_leaves_only_citations_in_english(name: str) -> None:
    page = known_page(name, "vi")
    assert page.tagged("html")[0].attributes["lang"] == "vi"
    for table in page.tables:
        for row in table.rows:
            for index, cell in enumerate(row):
                if cell.lang:
                    assert index in FOREIGN.get(table.key, set()), (table.key, cell)
    for element in page.tagged("span"):
        assert not element.attributes.get("lang") or element.section == "warnings", element


def test_both_languages_have_the_same_numbers(name: str) -> None:
    pages = [known_page(name, "en"), known_page(name, "vi")]
    english, vietnamese = (
        [cell.value for table in page.tables for row in table.rows for cell in row]
        for page in pages
    )
    assert english == vietnamese
    assert list(pages[0].sections) == list(pages[1].sections)
