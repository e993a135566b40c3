"""A tanker's note and workbook in Vietnamese have nothing English in them but what is cited."""

from __future__ import annotations

import io
import re
from collections.abc import Callable
from functools import cache

import openpyxl
import pytest

from catopt.answers.note_size import size_note_answer
from catopt.answers.size import size_answer
from catopt.notes.line import Given, size_note
from catopt.notes.origin import Asked
from catopt.render.page import page
from catopt.render.values import in_units
from catopt.render.workbook import workbook
from catopt.sizing import Sizing
from catopt.words import LANGUAGES, Language, Message, say
from tests.sizing.at_rest import size_tanker

from .page_reader import read_page

CITED = re.compile(
    r"^(UFC|Blendermann|DTOcean|IALA|NREL|BEMRosetta|Davies, Baca|Pilotfits|Vryhof|C\. Kunte|"
    r"D\. Djokic|[A-Z]{2,}(, [A-Z]{2,})*: )"
)
"""A document, or the place in one behind the keys of documents."""
NAMES = re.compile(
    r"UFC-4-159-03|UFC-Blendermann|chain studless R3( \d+ mm)?(, [\d.]+ m)?|Stevpris Mk5|"
    r"catopt( size tanker)?|catopt \d.*|MPCOST|--\w+|PIANC 2002|true"
)
"""Codes, names of components and of commands, a flag as files have it; those in text stand beside
Vietnamese words."""
FORMULA = re.compile(r"[=·^]|\b(cos|sqrt|atan|asinh)\b|USD/m|\bdeg\b|\brad\b|^rho\b")
"""Formulas, numbers with their symbols, and units."""
WORD = re.compile(r"[A-Za-z]{3,}")


@cache
def sized() -> Sizing:
    return size_tanker(dwt="50000 t", depth="20 m")


@cache
def runs_of_the_page(language: Language) -> set[str]:
    answer = in_units(size_note_answer(size_note(sized(), Given(), Asked(verify=False))), "tf")
    read = read_page(page(answer, language))
    words = {"h1", "h2", "h3", "p", "li", "figcaption", "text", "caption"}
    found = {each.text.strip() for each in read.elements if each.tag in words}
    for table in read.tables:
        found |= {*table.headings, *(text for row in table.texts() for text in row)}
    return found


def runs_of_the_workbook(language: Language) -> set[str]:
    made = workbook(in_units(size_answer(sized()), "tf"), language)
    book = openpyxl.load_workbook(io.BytesIO(made), data_only=True)
    cells = (value for sheet in book for row in sheet.iter_rows(values_only=True) for value in row)
    return {*book.sheetnames, *(value for value in cells if isinstance(value, str))}


def is_allowed(run: str) -> bool:
    return bool(
        CITED.match(run)
        or NAMES.fullmatch(run)
        or FORMULA.search(run)
        or not WORD.search(run)
        or re.fullmatch(r"([0-9]+ )?[A-Z]{2,}", run)  # units and currencies
    )


@pytest.mark.parametrize("runs", [runs_of_the_page, runs_of_the_workbook])
def test_what_is_the_same_in_both_languages_is_a_name_or_cited(
    runs: Callable[[Language], set[str]],
) -> None:
    english, vietnamese = (runs(language) for language in LANGUAGES)
    assert len(vietnamese) > 100
    assert sorted(each for each in english & vietnamese if not is_allowed(each)) == []


def test_an_english_word_is_noticed() -> None:
    assert not is_allowed("Design basis")
    assert not is_allowed("studless chain")
    assert is_allowed("UFC 4-159-03 Design: Moorings (3 October 2005), Table 3-7, page 26 [A]")


def test_the_words_and_the_grouping_are_those_of_the_field() -> None:
    """A comma groups thousands in English and marks decimals in Vietnamese."""
    assert isinstance(sized().case.title, Message)
    assert say(sized().case.title, "vi") == "Neo tàu dầu 50000 DWT ở độ sâu nước 20 m"
    said = " ".join(runs_of_the_page("vi"))
    assert "50,000" not in said
    assert "Tỷ số lực kéo đứt / lực căng lớn nhất" in said
    assert "xích không ngáng" in said.casefold()
