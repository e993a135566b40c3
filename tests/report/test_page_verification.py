"""The verification in the note: its numbers are verify's, and nothing bad is hidden."""

from __future__ import annotations

from dataclasses import replace
from io import BytesIO
from pathlib import Path
from typing import Any

import openpyxl
import pytest

from catopt.casefile import read_case
from catopt.errors import NotConvergedError
from catopt.model import Case
from catopt.notes.line import Note, note_of, read_note
from catopt.render.texts import LANGUAGES, Language, Words
from catopt.report.page.render import render_page
from catopt.report.tables.verify import part_sentence
from catopt.report.workbook.note import note_workbook
from catopt.verify import case as verify_module
from catopt.verify.case import verify_case
from catopt.verify.compared import Compared
from catopt.verify.result import StaticComparison
from catopt.words import Message
from tests.verify.cases import TOUCHES_TWICE

from .page_cases import CASES, EVERY, case_path, known_note, known_page
from .page_reader import ReadPage, read_page

ROUNDING = 1e-10
"""Tolerance of the truss model: differences below it are shown as such."""


def document_of(name: str, folder: Path) -> dict[str, Any]:
    """Verify a case as ``catopt verify`` does, in the load case that its note draws."""
    case = read_case(case_path(folder, name))
    document = verify_case(case, load_case=known_note(name).load_case or None).to_dict()
    (part,) = document["load_cases"]
    return dict(part)


@pytest.mark.parametrize("name", EVERY)
def test_numbers_are_those_of_verify_s_document(name: str, tmp_path: Path) -> None:
    document, page = document_of(name, tmp_path), known_page(name)
    rows = page.table("verification").rows
    assert len(rows) == len(document["quantities"])
    for row, each in zip(rows, document["quantities"], strict=True):
        _, closed, truss, gap, order, verdict = row
        assert (closed.value, truss.value) == (each["closed_form"], each["extrapolated"])
        over_scale = abs(each["difference"]) / each["scale"]
        assert gap.value == (over_scale if over_scale >= ROUNDING else None)
        assert (gap.text == "<1e-10") == (over_scale < ROUNDING)
        assert order.text == ("–" if each["order"] is None else f"{each['order']:.2f}")
        assert verdict.text == ("agrees" if each["agrees"] else "DIFFERS")
    meshes = page.table("meshes").rows
    assert [[row[0].value, row[1].value] for row in meshes] == [
        [mesh["elements"], mesh["residual"]] for mesh in document["meshes"]
    ]
    for number, row in enumerate(meshes):
        largest = max(
            abs(each["fem"][number] - each["closed_form"]) / each["scale"]
            for each in document["quantities"]
        )
        assert row[2].value == (largest if largest >= ROUNDING else None)


def test_what_verify_remarks_is_told(tmp_path: Path) -> None:
    (remark,) = document_of("slack", tmp_path)["remarks"]
    assert remark in known_page("slack").sections["verification"]


def test_the_load_case_that_is_drawn_is_verified() -> None:
    verification = known_note("states").verification
    assert verification is not None
    assert [part.name for part in verification.parts] == ["storm (high water)"]


def test_it_may_be_left_out() -> None:
    note = read_note(CASES / "buoy-9.5m" / "case.toml", verify=False)
    page = read_page(render_page(note))
    assert "verification" not in page.sections
    assert page.all("verification") == []
    book = openpyxl.load_workbook(BytesIO(note_workbook(note)))
    assert "Verification" not in book.sheetnames


# ------------------------------------------------------------------ what must not be hidden


def seen(note: Note, language: Language = "en") -> tuple[ReadPage, str]:
    """Return the page of a note, and all that its workbook says of the verification."""
    book = openpyxl.load_workbook(BytesIO(note_workbook(note, language)))
    sheet = book["Verification" if language == "en" else Words("vi").name("Verification")]
    said = " ".join(str(cell.value) for row in sheet.iter_rows() for cell in row if cell.value)
    return read_page(render_page(note, language)), said


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_truss_that_does_not_converge_stands_in_place_of_the_table(
    monkeypatch: pytest.MonkeyPatch, language: Language
) -> None:
    def stops(*_: object, **__: object) -> None:
        raise NotConvergedError("Newton's method stopped after 500 iterations")

    monkeypatch.setattr(verify_module, "verify_case", stops)
    note = read_note(CASES / "buoy-9.5m" / "case.toml")
    page, sheet = seen(note, language)
    (loud,) = page.styled("fails", "verification")
    assert loud.text == Words(language)("verification.no_answer")
    assert page.all("verification") == page.all("meshes") == []
    for said in (page.sections["verification"], page.sections["warnings"], sheet):
        assert "Newton's method stopped after 500 iterations" in said
    assert loud.text in sheet


def off(part: StaticComparison, *quantities: str) -> StaticComparison:
    """Return a comparison whose closed form is off by 1 % in some quantities."""
    return replace(part, quantities=tuple(_off(q, quantities) for q in part.quantities))


def _off(each: Compared, wrong: tuple[str, ...]) -> Compared:
    if each.quantity not in wrong:
        return each
    return replace(each, closed_form=(each.closed_form or 0.0) + 0.01 * each.scale)


@pytest.mark.parametrize("language", LANGUAGES)
def test_models_that_differ_are_told_loudly(
    monkeypatch: pytest.MonkeyPatch, language: Language
) -> None:
    honest = verify_case(read_case(CASES / "buoy-9.5m" / "case.toml"))
    found = replace(honest, parts=(off(honest.static, "span", "fairlead_angle"),))
    monkeypatch.setattr(verify_module, "verify_case", lambda _: found)
    page, sheet = seen(read_note(CASES / "buoy-9.5m" / "case.toml"), language)
    words = Words(language)
    differs = words("verification.differs")
    sentence = words.sentence(part_sentence(found.static))
    assert sentence.lang == ""
    assert sentence.text in page.sections["verification"]
    assert sentence.text in sheet
    verdicts = [row[-1].text for row in page.table("verification").rows]
    assert verdicts.count(differs) == 2
    assert sheet.count(differs) == 2 + sentence.text.count(differs)
    assert [each.tag for each in page.styled("fails", "verification")] == ["p", "td", "td"]
    warning = words.sentence(Message("notes.models_differ")).text
    assert warning in page.sections["warnings"]


def test_a_quantity_that_is_not_smooth_is_named() -> None:
    note = known_note("buoy-9.5m")
    assert note.verification is not None
    part = note.verification.static
    first, *others = part.quantities
    rough = replace(first, fem=(first.fem[2], first.fem[0], first.fem[2]))
    broken = replace(note.verification, parts=(replace(part, quantities=(rough, *others)),))
    page, sheet = seen(replace(note, verification=broken))
    told = "the finest mesh was taken and nothing extrapolated: Span."
    assert told in page.sections["verification"]
    assert told in sheet


@pytest.mark.parametrize("case", TOUCHES_TWICE.values(), ids=TOUCHES_TWICE)
def test_the_note_of_a_line_that_touches_twice_shows_that_the_models_agree(case: Case) -> None:
    note = note_of(case, known_note("buoy-9.5m").origin.files)
    assert note.solution.regime == "grounded-in-parts"
    page, _ = seen(note)
    verdicts = {row[-1].text for row in page.table("verification").rows}
    assert verdicts == {"agrees"}


# ------------------------------------------------------------------ in Vietnamese


@pytest.mark.parametrize("name", EVERY)
def test_verdict_and_remarks_are_translated(name: str) -> None:
    verification = known_note(name).verification
    assert verification is not None
    words = Words("vi")
    for english in (part_sentence(verification.static), *verification.static.remarks):
        assert words.sentence(english).lang == ""
    assert not {each.attributes.get("lang") for each in known_page(name, "vi").elements
        if each.section == "verification"} & {"en"}  # fmt: skip


@pytest.mark.parametrize("count", [1, 2, 3, 4, 5, 7])
def test_however_much_differs_is_said_in_vietnamese(count: int) -> None:
    verification = known_note("buoy-9.5m").verification
    assert verification is not None
    part = verification.static
    wrong = [each.quantity for each in part.quantities][:count]
    said = Words("vi").sentence(part_sentence(off(part, *wrong)))
    assert said.lang == ""
    assert said.text.startswith("Hai mô hình KHÔNG KHỚP: độ dạt ngang lệch -")
    assert said.text.count("lệch") == min(count, 4)
    assert ("đại lượng khác" in said.text) == (count > 4)
    assert not any(word in said.text for word in (" by ", " of ", "tension", "allowed"))


def test_the_largest_difference_is_said_in_vietnamese() -> None:
    verification = known_note("buoy-9.5m").verification
    assert verification is not None
    part = verification.static
    slightly = replace(part.of("fairlead_tension"), closed_form=part.of("fairlead_tension").fem[0])
    english = part_sentence(replace(part, quantities=(slightly,)))
    assert "fairlead tension, " in english
    assert (
        Words("vi")
        .sentence(english)
        .text.startswith("Hai mô hình khớp nhau. Sai khác lớn nhất: lực căng tại điểm treo, ")
    )


def test_of_a_slack_line_the_difference_is_not_said_to_be_of_the_tension() -> None:
    """Its scale is a bar's weight over the tolerance, far above the tension."""
    note = known_note("slack")
    assert note.verification is not None
    part = note.verification.static
    assert part.worst.scale > 10.0 * note.solution.fairlead.tension
    english = part_sentence(part)
    assert "of its scale" in english
    assert "of the tension" not in english
    assert "thang so sánh" in Words("vi").sentence(english).text
