"""The note of one line: what it computes, and what its page says in words."""

from __future__ import annotations

import hashlib
import json
from dataclasses import replace
from pathlib import Path

import pytest

from catopt.casefile.schema import CaseTable
from catopt.notes.line import read_note
from catopt.notes.origin import Asked, file_name, inputs_of
from catopt.notes.system import read_system_note
from tests.answers.results import report_with

from .notes import CASES, LINES, OWN, RESULT, TURRET, case_path, note_named, page_named, shown, stop
from .page_reader import ReadPage

BUOY = case_path("buoy-9.5m")


def test_a_date_stands_only_where_one_is_given() -> None:
    line = read_note(BUOY, date="21 November 2026")
    body = read_system_note(case_path(TURRET), asked=Asked("21.11.2026", verify=False))
    assert shown(line).table("identity").row("Date")[1].text == "21 November 2026"
    assert shown(body).table("identity").row("Date")[1].text == "21.11.2026"
    assert "system_verification" not in shown(body).sections
    assert "Date" not in page_named("buoy-9.5m").table("identity").by_name()


def test_a_line_that_is_just_level_at_its_anchor_is_not_said_to_lie_on_the_bed() -> None:
    """The length is sought that gives 0 deg: what lies on the bed is rounding, or nothing."""
    note = read_note(CASES / "tanker-20m-find-length" / "case.toml", verify=False)
    assert note.solution.grounded_length < 1e-9
    hangs = shown(note).table("identity").row("Configuration")[1].text
    assert hangs == "the whole line hangs, just level at its anchor"


def test_sections_are_there_only_where_there_is_something_to_show() -> None:
    few, every = (set(page_named(name).sections) for name in ("buoy-9.5m-slack", "designed"))
    assert every - few == {"checks", "load_cases", "front", "warnings"}
    assert few < every


@pytest.mark.parametrize("name", LINES)
def test_utilisation_bars_are_as_long_as_the_utilisation(name: str) -> None:
    """In percent, to a tenth; a bar ends at the full width, in another colour."""
    drawn = [each.attributes for each in page_named(name).tagged("rect")]
    bars = [each for each in drawn if each.get("class") in ("used", "over")]
    results = note_named(name).checks.results
    used = [each.utilisation for each in results if each.utilisation is not None]
    for bar, utilisation in zip(bars, used, strict=True):
        width = 100.0 * min(max(utilisation, 0.0), 1.0)
        assert float(bar["width"]) == pytest.approx(width, abs=0.05)
        assert bar["class"] == ("over" if utilisation > 1.0 else "used")


def test_the_load_case_that_governs_is_drawn_and_verified() -> None:
    note = note_named("states")
    states = dict(note.checks.solutions)
    assert note.load_case == "storm (high water)"
    assert note.solution.span == states[note.load_case].span
    assert note.case.site.water_depth == 11.0
    assert [part.name for part in note.verification.parts] == [note.load_case]


def test_inputs_of_many_values_are_shown_by_their_ends() -> None:
    note = note_named("buoy-9.5m")
    lengths = [f"{length} m" for length in range(10, 40)]
    design = {"design": {"segments": [{"lengths": lengths}]}}
    given_so = replace(note, origin=replace(note.origin, inputs=inputs_of(design, CaseTable)))
    ((_, given, si),) = shown(given_so).table("inputs").rows
    assert given.text == '"10 m", "11 m", … "39 m" (30)'
    assert si.text == "10 m, 11 m, … 39 m (30)"


def test_a_case_file_with_a_byte_order_mark_is_read_shown_and_hashed_as_it_is(
    tmp_path: Path,
) -> None:
    path = tmp_path / "windows.toml"
    text = (OWN / "slack.toml").read_text("utf-8")
    path.write_bytes(b"\xef\xbb\xbf" + text.replace("\n", "\r\n").encode())
    (file,) = read_note(path).origin.files
    assert file.sha256 == hashlib.sha256(path.read_bytes()).hexdigest()
    assert not file.text.startswith("\ufeff")
    page = page_named("leg")
    leg = (OWN / "leg.toml").read_bytes()
    assert page.tagged("pre")[0].text == leg.decode()
    digest = hashlib.sha256(leg).hexdigest()
    assert page.table("identity").row("File")[1].text == f"leg.toml, SHA-256 {digest}"


def test_warnings_of_a_line_come_without_the_name_of_its_only_load() -> None:
    (warning,) = note_named("slack").warnings
    assert warning.startswith("the line is slack")


def test_a_curve_that_cannot_be_is_left_out_and_said(monkeypatch: pytest.MonkeyPatch) -> None:
    stop(monkeypatch, "catopt.catenary.case_curve.curve_case", "it wanders")
    note = read_note(CASES / "ship-200m" / "case.toml")
    assert note.curve is None
    assert note.warnings == ("the load curve is left out: it wanders",)
    assert "curve" not in shown(note).sections


def test_the_front_is_that_of_the_document() -> None:
    designed, page = note_named("designed"), page_named("designed")
    front = designed.chosen.document["front"]
    table = page.table("front")
    for row, point in zip(table.rows, front, strict=True):
        values = [cell.value for cell in row[1:4]]
        assert values == [point["mass_kg"], point["offset_m"], point["excursion_m"]]
        length = f"{point['segments'][0]['length_m']:g} m"
        assert row[4].text == f"chain studless R3, {length}; 0.25 t, s = 7 m"
    assert table.marked == [1]


def test_the_recommended_design_is_taken_unless_another_is_named() -> None:
    assert note_named("designed").solution.line.length == 46.0
    third = read_note(RESULT, 3)
    assert third.solution.line.length == 47.0
    page = shown(third)
    assert page.table("front").marked == [2]
    assert len(page.styled("chosen", "front")) == 2  # in the figure and in its legend


@pytest.mark.slow
def test_a_long_front_is_shown_in_part_and_says_so(tmp_path: Path) -> None:
    (tmp_path / "case.toml").write_bytes((RESULT / "case.toml").read_bytes())
    document = json.loads((RESULT / "design.json").read_text("utf-8"))
    first = document["front"][0]

    def front_of(designs: int) -> ReadPage:
        document["front"] = [
            first | {"mass_kg": 4500.0 + 115.0 * k, "offset_m": 55.0 - 10.0 * k / designs}
            for k in range(designs)
        ]
        (tmp_path / "design.json").write_text(json.dumps(document), encoding="utf-8")
        return shown(read_note(tmp_path))

    assert len(front_of(12).table("front").rows) == 12
    page = front_of(200)
    rows = [int(row[0].text) for row in page.table("front").rows]
    assert len(rows) <= 28
    assert {1, 2, 200} <= set(rows)  # the ends, and the one that is recommended
    assert f"{200 - len(rows)} more designs" in page.sections["front"]
    points = [each for each in page.styled("design", "front") if "cx" in each.attributes]
    assert len(points) == 201  # all of them in the figure, and one in its legend


def test_a_page_is_named_after_its_case(tmp_path: Path) -> None:
    assert file_name(tmp_path / "cases" / "buoy-9.5m" / "case.toml", None) == "buoy-9.5m.html"
    assert file_name(tmp_path / "mine.toml", None) == "mine.html"
    assert file_name(RESULT, 3) == "result-design-3.html"


def test_allowed_tensions_are_those_of_the_checks() -> None:
    note = note_named("states")
    governing = [each for each in note.checks.results if each.load_case == note.load_case]
    tensions = [each.capacity for each in governing if each.kind == "tension"]
    assert len(tensions) == 2  # by the code, and by the case's own factor, which is stricter
    assert note.allowed == [min(tensions)]
    assert note_named("leg").allowed == [6140e3 / 2.0, 2500e3 / 2.0]
    assert note_named("slack").allowed == [None]


def test_many_runs_are_left_out_and_none_converged_is_said() -> None:
    note = note_named("swarm")
    many = replace(report_with((1.0, 1e-7)), runs=40, converged_runs=0)
    many = replace(many, objectives=(1e-7,) * 40, iterations_flown=(2,) * 40)
    page = shown(replace(note, swarm=replace(note.swarm, swarm=many)))
    assert len(page.table("swarm_runs").rows) == 30
    assert "10 more runs" in page.sections["swarm"]
    (verdict,) = page.styled("verdict", "swarm")
    assert "fails" in verdict.attributes["class"]
    assert "0 of 40 runs" in verdict.text
