"""Every face has the word and the colour of the one verdict, in both languages."""

from __future__ import annotations

import html
import io
import re
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from typing import Any

import openpyxl
import pytest

from catopt import check_case, design_case, read_case
from catopt.answers.blocks import Answer, Verdict
from catopt.answers.check import check_answer
from catopt.answers.design import design_answer
from catopt.answers.note_size import size_note_answer
from catopt.answers.size import size_answer
from catopt.answers.size_card import fleet_answer
from catopt.checks.verdict import Judgement
from catopt.notes.line import Given, size_note
from catopt.notes.origin import Asked
from catopt.render.card import card_lines
from catopt.render.page import card, page
from catopt.render.terminal import show
from catopt.render.workbook import workbook
from catopt.sizing import Sizing
from catopt.words import LANGUAGES, Language, say
from tests.sizing.at_rest import size_buoy

from .test_faces import Paper


@cache
def buoy() -> Sizing:
    return size_buoy(buoy="pillar 1.8 m", depth="12 m")


def _check() -> tuple[Answer, Judgement, dict[str, Any]]:
    report = check_case(read_case("cases/fso-rang-dong-ship/loaded.toml"))
    return check_answer(report), report.judgement, report.to_dict()


def _fails() -> tuple[Answer, Judgement, dict[str, Any]]:
    case = read_case("cases/tanker-20m-sinker/case.toml")
    report = check_case(replace(case, checks=replace(case.checks, safety_factor=20.0)))
    return check_answer(report), report.judgement, report.to_dict()


def _design() -> tuple[Answer, Judgement, dict[str, Any]]:
    result = design_case(read_case("cases/design-tanker-20m/case.toml"))
    return design_answer(result), result.judgement, result.to_dict()


def _note() -> tuple[Answer, Judgement, dict[str, Any]]:
    note = size_note_answer(size_note(buoy(), Given(), Asked(verify=False)))
    return note, buoy().judgement, buoy().to_dict()


OF: dict[str, tuple[str, Callable[[], tuple[Answer, Judgement, dict[str, Any]]]]] = {
    "check": ("amber", _check),
    "check that fails": ("red", _fails),
    "size": ("amber", lambda: (size_answer(buoy()), buoy().judgement, buoy().to_dict())),
    "note of a sizing": ("amber", _note),
    "design": ("amber", _design),
}
KINDS = {"green": "passes", "amber": "in-part", "red": "fails", "none": ""}


@cache
def made(of: str) -> tuple[Answer, Judgement, dict[str, Any]]:
    return OF[of][1]()


def words(text: str) -> str:
    return re.sub(r"\s+", " ", text)


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("of", OF)
def test_every_face_takes_its_word_and_its_colour(of: str, language: Language) -> None:
    answer, judgement, document = made(of)
    said = say(judgement.said, language)
    assert judgement.colour == OF[of][0]
    assert document["verdict"]["colour"] == judgement.colour
    assert document["verdict"]["said"] == str(judgement.said)
    blocks = [each for each in answer.blocks if isinstance(each, Verdict)]
    assert Verdict.of_judgement(judgement) in blocks
    paper = Paper()
    show(paper, answer, language)
    assert words(said) in words(" ".join(paper.lines))
    # Of an answer on its card, of a note on its first page.
    whole = html.unescape(
        card(answer, language) if answer.card else page(answer, language).decode()
    )
    kind = KINDS[judgement.colour]
    assert re.search(rf'class="verdict {kind}"[^<]*>\s*{re.escape(said)}', words(whole))
    sheets = openpyxl.load_workbook(io.BytesIO(workbook(answer, language)))
    cells = {str(each.value) for sheet in sheets for row in sheet.rows for each in row}
    assert said in cells
    if answer.card:
        lines = " ".join(each.text for each in card_lines(answer, language))
        assert words(said) in words(lines)


def test_a_fleet_has_no_green_row_that_was_not_run() -> None:
    (table,) = (each for each in fleet_answer([buoy()]).blocks if hasattr(each, "columns"))
    (verdict,) = (each for each in table.columns if each.passes)
    assert verdict.passes == (None,)
    assert str(verdict.values[0]) == "passes every check that was made"
    assert "motion" in str(table.columns[-1].values[0])
