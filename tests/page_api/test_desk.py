"""What the page is answered: the command's digits, its errors, and forms made of the tables."""

from __future__ import annotations

import json
import tomllib
from functools import partial
from typing import Any

import pytest

from catopt.answers.blocks import Answer, Table
from catopt.answers.of_result import comparison
from catopt.casefile import template
from catopt.errors import InputError
from catopt.page_api import ask, shell
from catopt.page_api.fields import DOORS, START, Door, fields_of, text_of, values_of
from catopt.sizing.inputs import rows_of
from catopt.units import Dimension, to_si
from catopt.words import LANGUAGES, Language, Message, say
from tests.cli.conftest import CASES, Run, run
from tests.report.page_reader import read_page

__all__ = ["run"]

slow = partial(pytest.param, marks=pytest.mark.slow)


@pytest.mark.parametrize(
    ("call", "command", "case"),
    [
        ("solve", "solve", "buoy-9.5m/case.toml"),
        ("solve", "solve", "ship-200m-sinker/case.toml"),
        ("check", "check", "tanker-20m/case.toml"),
        ("curve", "curve", "buoy-9.5m/case.toml"),
        ("system", "system", "fso-rang-dong/case.toml"),
        slow("size", "size buoy", "size-buoy/sizing.toml"),
        slow("size", "size tanker", "size-tanker/sizing.toml"),
    ],
)
def test_the_document_is_the_commands(run: Run, call: str, command: str, case: str) -> None:
    printed = run(*command.split(), CASES / case, "--json").out
    text = (CASES / case).read_text("utf-8")
    assert json.loads(json.dumps(ask(call, {"text": text}))) == json.loads(printed)


@pytest.mark.parametrize("call", ["open", "solve", "whole", "note", "system"])
def test_lines_between_points_are_told_where_they_are_solved(call: str) -> None:
    """It called `points` an unknown key."""
    (problem,) = ask(call, {"text": template("points")})["problems"]
    assert (problem["key"], problem["found"]) == ("points", "[[points]]")
    assert "catopt system case.toml" in problem["allowed"]


@pytest.mark.parametrize(
    ("text", "found", "way"),
    [
        ("PK\x03\x04\x14\0", "an Excel workbook", "catopt size FILE.xlsx"),
        ("\ufffdPNG\r\n\x1a\n\0", "a picture", "type them into the form"),
        ("\ufffd\ufffd\ufffd\ufffd\0\x10JFIF\0", "a picture", "type them into the form"),
        ('<svg xmlns="x"/>', "a picture", "type them into the form"),
        ("%PDF-1.4\n", "a PDF document", "copy that into a .toml file"),
        ("<!DOCTYPE html>\n<p>", "a web page", "copy that into a .toml file"),
        ("one leg\n--- LINE TYPES ---\n", "an input file of another program", "catopt import"),
        ("%YAML 1.1\n---\n", "an input file of another program", "catopt import"),
        ("site:\n  general:\n", "an input file of another program", "catopt import"),
        ("\0\ufffd\x01", "a file that is not text", "UTF-8"),
    ],
)
def test_what_is_no_case_is_told_with_the_way_out(text: str, found: str, way: str) -> None:
    (problem,) = ask("open", {"text": text})["problems"]
    assert (problem["key"], problem["found"]) == ("file", found)
    assert way in problem["allowed"]
    (told,) = ask("open", {"text": text, "lang": "vi"})["problems"]
    assert told["found"] != found


def test_a_mistake_in_a_case_is_told_by_its_line() -> None:
    (problem,) = ask("open", {"text": "[site]\nwater_depth: 12\n"})["problems"]
    assert problem["key"] == "line 2, column 12"
    assert "not a colon" in problem["allowed"]


@pytest.mark.parametrize("door", DOORS)
def test_every_unit_that_is_offered_fits_its_quantity(door: Door) -> None:
    """Each is read as the quantity of the first, and is worth no more than 2,000 of it, or less."""
    for field in fields_of(door):
        dimensions = [d for d in Dimension if all(_is_read(unit, d) for unit in field.units)]
        assert dimensions, field.key
        worth = [to_si(f"1 {unit}", dimensions[0]) for unit in field.units]
        assert all(1.0 / 2300.0 < each / worth[0] < 2300.0 for each in worth), field.key
    units = {each.key.rpartition(".")[2]: each.units for each in fields_of(door)}
    assert units["water_depth"] == ("m", "ft", "fathom")
    if door == "buoy":
        assert units["diameter_min"] == ("mm", "cm", "in")
        assert "knots" in units["wind"]
        assert "knots" not in units["wear_rate"]
        assert units["return_period"] == ("years",)
    if door == "line":
        assert units["diameter"] == ("mm", "cm", "in")
        assert units["title"] == ()


def _is_read(unit: str, dimension: Dimension) -> bool:
    try:
        return to_si(f"1 {unit}", dimension) > 0.0
    except InputError:
        return False


def test_a_form_is_the_file_that_says_the_same() -> None:
    values = {"site.water_depth": "9,5", "load.horizontal_force": "3", "checks.safety_factor": "2"}
    made = tomllib.loads(text_of("line", values))
    assert made == {
        "site": {"water_depth": "9.5 m"},
        "load": {"horizontal_force": "3 kN"},
        "checks": {"safety_factor": 2},
    }


@pytest.mark.parametrize("case", ["buoy-9.5m", "ship-200m-sinker", "fso-rang-dong", "size-tanker"])
def test_a_file_that_is_opened_and_saved_says_the_same(case: str) -> None:
    name = "sizing.toml" if case.startswith("size") else "case.toml"
    text = (CASES / case / name).read_text("utf-8")
    opened = ask("open", {"text": text})
    door, values = opened["door"], opened["values"]
    saved = ask("file", {"door": door, "values": values, "base": text})["text"]
    assert tomllib.loads(saved) == tomllib.loads(text)


def test_every_error_is_told_at_once_by_the_key_of_its_field() -> None:
    wrong = {"site.water_depth": "-3 m", "line.segments[0].length": "20 kg"}
    reply = ask("live", {"door": "line", "values": START["line"] | wrong})
    found = {each["key"]: each["found"] for each in reply["problems"]}
    assert found.keys() == wrong.keys()
    assert all(wrong[key] in said for key, said in found.items())
    assert reply["status"] == 2


def test_a_line_that_is_too_short_is_refused_in_the_command_s_words(
    run: Run, tmp_path: Any
) -> None:
    values = {
        "site.water_depth": "20 m",
        "line.segments[0].length": "15 m",
        "line.segments[0].submerged_weight": "360 N/m",
        "load.horizontal_force": "150 kN",
    }
    case = tmp_path / "case.toml"
    case.write_text(text_of("line", values))
    reply = ask("live", {"door": "line", "values": values})
    printed = run("solve", case)
    assert (reply["status"], printed.status) == (3, 3)
    assert " ".join(reply["message"].split()) in " ".join(printed.err.split())


@pytest.mark.parametrize(
    "question",
    [{"lang": "de"}, {"units": "lb"}, {"door": "plane"}, {"text": 3}, {"values": {"title": 1}}],
)
def test_a_question_that_is_none_is_refused(question: dict[str, Any]) -> None:
    assert ask("live", question)["status"] == 2
    assert ask("eval", {"text": "1"})["message"] == "no such question: eval"


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_answer_is_in_the_language_and_the_units_asked_for(language: Language) -> None:
    question = {"door": "line", "values": START["line"], "lang": language, "units": "tf"}
    html = ask("live", question)["html"]
    assert say(Message("desk.answer"), language) in html
    assert "<svg" in html
    assert " kN" not in html


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_field_has_a_label(language: Language) -> None:
    page = read_page(shell(language))
    labels = {each.attributes.get("for", "") for each in page.tagged("label")} - {""}
    fields = [each.attributes for each in page.tagged("input") if "data-key" in each.attributes]
    assert {each["id"] for each in fields} == labels
    assert len(labels) == sum(len(fields_of(door)) for door in DOORS)


@pytest.mark.parametrize("moored", ["buoy", "tanker"])
def test_the_form_of_a_sizing_has_every_row_of_the_table(moored: Door) -> None:
    rows = [each.key for each in rows_of(moored) if each.takes != "FILE"]
    assert sorted(each.key for each in fields_of(moored)) == sorted(rows)


@pytest.mark.parametrize("door", DOORS)
def test_a_form_begins_with_values_of_its_own_fields(door: Door) -> None:
    assert values_of(door, text_of(door, START[door])) == START[door]


@pytest.mark.parametrize(
    ("door", "key", "value", "label", "result"),
    [
        ("line", "load.horizontal_force", "170 kN", "Horizontal force", "Span"),
        slow("tanker", "environment.current", "1.5 m/s", "Tidal current", "Chain"),
    ],
)
def test_two_answers_stand_beside_each_other(
    door: Door, key: str, value: str, label: str, result: str
) -> None:
    """What differs between the inputs, and both results as each answer shows them alone."""
    form = {"door": door, "values": START[door] | {key: value}}
    kept = ask("file", {"door": door, "values": START[door]})["text"]
    page = read_page(ask("compare", form | {"kept": kept})["html"])
    assert [cell.text for cell in page.table("asked").row(label)[1:]] == [START[door][key], value]
    rows = {row[0]: row[1:] for table in page.tables for row in table.texts()}
    one, other = rows[result]
    assert one != other
    assert one.split(",")[0] in ask("whole", {"text": kept})["html"]
    assert other.split(",")[0] in ask("whole", form)["html"]


def test_two_inputs_of_one_name_are_both_compared() -> None:
    """Soil is asked for an anchor and for a sinker."""
    report = Answer("desk", "", (), "")
    rows = [("Soil", "sand", ""), ("Soil", "", "rock")]
    asked = comparison(report, report, rows).blocks[0]
    assert isinstance(asked, Table)
    assert list(zip(*(each.values for each in asked.columns), strict=True)) == rows


def test_an_answer_beside_itself_differs_in_nothing() -> None:
    kept = ask("file", {"door": "line", "values": START["line"]})["text"]
    html = ask("compare", {"text": kept, "kept": kept, "lang": "vi"})["html"]
    assert say(Message("desk.same"), "vi") in html
    assert "<td" not in html


@pytest.mark.slow
def test_a_sizing_shows_the_recommended_line_before_its_inputs() -> None:
    """The card and the drawings stand first; inputs are in what is folded away below them."""
    shown = ask("whole", {"door": "tanker", "values": START["tanker"]})
    inputs = say(Message("sizing.inputs"), "en")
    assert 'class="headline"' in shown["card"]
    assert inputs in shown["more"]
    assert inputs not in shown["card"] + shown["html"]


def test_what_a_file_beside_the_case_says_now_is_what_counts(
    tmp_path: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    """An answer is kept by its text; a file that the text names may have changed."""
    monkeypatch.chdir(tmp_path)
    text = ask("file", {"door": "line", "values": START["line"]})["text"]
    text += '\n[catalogue]\nfile = "own"\n'
    families = tmp_path / "own"
    families.write_text('schema = "catopt.families/1"\n', encoding="utf-8")
    assert "html" in ask("live", {"text": text})
    families.write_text("families of yesterday", encoding="utf-8")
    assert ask("live", {"text": text})["status"] == 2


@pytest.mark.parametrize("moored", ["buoy", "tanker"])
def test_an_empty_field_says_what_is_taken_and_never_an_example_of_it(moored: Door) -> None:
    """Of what is left out; an example stands only where nothing is taken, as such."""
    rows = {each.key: each for each in rows_of(moored)}
    for field in fields_of(moored):
        row, hint = rows[field.key], say(field.hint, "en")
        if row.default or row.left_out:
            assert "such as" not in hint
        else:
            assert hint.startswith("such as ")
    taken = {each.key: say(each.hint, "en") for each in fields_of("buoy")}
    assert taken["environment.current"] == "taken: 1 m/s"
