"""The one table of texts: nothing missing, nothing left over, in both languages alike."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path
from string import Formatter

import pytest
from jinja2 import nodes

import catopt.cli
import catopt.report.page
from catopt.answers.design import OBJECTIVES
from catopt.model.load_case import LOAD_CASE_KINDS
from catopt.render.texts import LANGUAGES, Words, table
from catopt.report.page.render import environment
from catopt.report.page.sections import SECTIONS
from catopt.report.wording.names import METHODS, REGIMES
from catopt.words import Message, is_term, term
from catopt.words.texts import group, groups

PAGE = Path(catopt.report.page.__file__).parent
TEMPLATES = sorted((PAGE / "templates").glob("*.html"))
TEXTS = {
    f"{group}.{key}": text
    for group, texts in table()["texts"].items()
    for key, text in texts.items()
}
MESSAGES = {f"{name}.{key}" for name in groups() for key in group(name)} - set(TEXTS)
"""They have a table of their own, which tests/words looks after."""
KEY = re.compile(r"[a-z_]+\.[a-z_]+")


def holes(text: str) -> set[str]:
    """Names in the braces of a text."""
    return {hole for _, hole, _, _ in Formatter().parse(text) if hole}


@pytest.mark.parametrize("key", TEXTS)
def test_every_text_is_there_in_both_languages(key: str) -> None:
    text = TEXTS[key]
    assert set(text) == set(LANGUAGES)
    assert all(words.strip() for words in text.values())
    assert holes(text["en"]) == holes(text["vi"])


# ------------------------------------------------------------------ what the page asks for


def is_key(value: object) -> bool:
    """Whether a constant looks like the key of a text; a file is none."""
    is_text = isinstance(value, str) and KEY.fullmatch(value) is not None
    return is_text and not str(value).endswith((".html", ".csv"))


def asked_by_code(source: str) -> Iterator[str]:
    """Yield the keys of texts in a module: every string that looks like one of a group's."""
    for node in ast.walk(ast.parse(source)):
        value = node.value if isinstance(node, ast.Constant) else None
        is_asked = is_key(value) and value not in MESSAGES
        if is_asked and str(value).partition(".")[0] in table()["texts"]:
            yield str(value)


def asked_by_template(source: str) -> Iterator[str]:
    """Yield the keys of texts in a template."""
    for node in environment().parse(source).find_all(nodes.Const):
        if is_key(node.value):
            yield node.value


def asked() -> set[str]:
    """Every text that page, workbooks and terminal ask for."""
    found = {f"{section.key}.heading" for sections in SECTIONS.values() for section in sections}
    views = Path(catopt.cli.__file__).parent.glob("*_view.py")
    beside = [(PAGE.parent / name).glob("*.py") for name in ("workbook", "wording")]
    for module in (*PAGE.rglob("*.py"), *(file for files in beside for file in files), *views):
        found |= set(asked_by_code(module.read_text("utf-8")))
    for template in TEMPLATES:
        found |= set(asked_by_template(template.read_text("utf-8")))
    return found


def test_every_text_that_is_asked_for_is_in_the_table() -> None:
    assert sorted(asked() - set(TEXTS)) == []


def test_every_text_of_the_table_is_asked_for() -> None:
    assert sorted(set(TEXTS) - asked()) == []


def test_what_is_asked_for_is_found() -> None:
    assert set(asked_by_code('words("line.gone" if a else "line.heading")')) == {
        "line.gone",
        "line.heading",
    }
    assert set(asked_by_template('<p>{{ words("line.gone", x=1) }}</p>')) == {"line.gone"}


# ------------------------------------------------------------------ no words beside the table


class Outside(HTMLParser):
    """Gathers the words of a template that stand outside of its tags."""

    def __init__(self) -> None:
        super().__init__()
        self.words: list[str] = []

    def handle_data(self, data: str) -> None:
        self.words += re.findall(r"[^\W\d_]{2,}", data)


def words_of_its_own(source: str) -> list[str]:
    """List the words that a template shows and that are not put in."""
    shown = Outside()
    # Where a tag's name is put in, too, it is still a tag.
    tagged = re.sub(r"(</?){{", r"\1x{{", source)
    shown.feed(re.sub(r"{{.*?}}", "0", re.sub(r"{%.*?%}", "", tagged)))
    return shown.words


ALLOWED = {"SHA"}
"""Names that are the same in every language."""


@pytest.mark.parametrize("template", TEMPLATES, ids=lambda path: path.name)
def test_a_template_has_no_words_of_its_own(template: Path) -> None:
    assert set(words_of_its_own(template.read_text("utf-8"))) <= ALLOWED


def test_words_of_a_templates_own_are_noticed() -> None:
    source = '<p{% if a %} class="{{ a }}"{% endif %}>{{ words("line.heading") }} The line</p>'
    assert words_of_its_own(source) == ["The", "line"]


# ------------------------------------------------------------------ names and sentences


NAMES = {
    *(quantity.name for quantity in OBJECTIVES.values()),
    *METHODS.values(),
    *REGIMES,
    *REGIMES.values(),
    *LOAD_CASE_KINDS,
}


@pytest.mark.parametrize("name", sorted(NAMES))
def test_every_name_has_its_vietnamese(name: str) -> None:
    assert is_term(name)
    assert Words("vi").name(name) != name
    assert Words("en").name(name) == name


@pytest.mark.parametrize(
    "term",
    [
        "góc nghiêng dây neo tại đáy", "độ dạt ngang", "lực căng", "khối gia tải", "neo", "phao",
        "xích", "mực nước", "tải trọng", "hệ số an toàn",
    ],
)  # fmt: skip
def test_the_terms_of_the_sources_are_used(term: str) -> None:
    terms = [text["vi"] for name in ("terms", "columns") for text in group(name).values()]
    vietnamese = [*(text["vi"] for text in TEXTS.values()), *terms]
    assert any(term in text.lower() for text in vietnamese)


def test_a_sentence_is_translated_with_what_it_holds() -> None:
    vi = Words("vi")
    named = Message("checks.named_segment", number=2, name="Span")
    assert vi.sentence(Message("checks.tension", segment=named)).text == "lực căng, đoạn 2 (Span)"
    changed = Message("catenary.regime_change", before=term("grounded"), after=term("suspended"))
    assert vi.sentence(changed).text == "nằm một phần trên đáy → treo hoàn toàn"
    assert Words("en").sentence(changed) == ("grounded -> suspended", "")


def test_a_sentence_that_is_not_in_the_table_stays_english_and_says_so() -> None:
    assert Words("vi").sentence("quite another thing") == ("quite another thing", "en")
    assert Words("vi").sentence("") == ("", "")


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_text_that_is_missing_is_a_fault(language: str) -> None:
    words = Words("vi" if language == "vi" else "en")
    with pytest.raises(KeyError):
        words("line.gone")
    with pytest.raises(KeyError):
        words("line.touchdown")
