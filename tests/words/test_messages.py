"""Messages are English as text, keep their values, and have every text in both languages."""

from __future__ import annotations

import ast
import copy
import json
import pickle
import re
import tomllib
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from string import Formatter

import pytest

import catopt
from catopt.quantities import QUANTITIES
from catopt.words import (
    LANGUAGES,
    Listed,
    Measure,
    Message,
    Sentence,
    Several,
    Told,
    heading,
    is_said,
    is_term,
    quantity_name,
    say,
    term,
)
from catopt.words.saved import messages_in, with_messages
from catopt.words.texts import group, groups

PACKAGE = Path(catopt.__file__).parent
TEXTS = {f"{name}.{key}": text for name in groups() for key, text in group(name).items()}

RISES = Message("catenary.rises", height=0.25)
RISES_VI = "dây nhô lên 0.25 m trên mực nước; trọng lượng của phần đó vẫn lấy như trong nước"


def holes(text: str) -> set[str]:
    """Names in the braces of a text."""
    return {hole for _, hole, _, _ in Formatter().parse(text) if hole is not None}


def forms(text: object) -> list[str]:
    """All texts of a language: one, or two by number."""
    if isinstance(text, str):
        return [text]
    assert isinstance(text, dict)
    assert set(text) == {"one", "many"}
    return list(text.values())


@cache
def texts_in_code() -> tuple[set[str], list[list[str]]]:
    """Return every text constant of the source, and every f-string by its parts.

    A part of an f-string that is put in is empty.
    """
    plain, built = set(), []
    for path in PACKAGE.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            if isinstance(node, ast.Constant) and isinstance(node.value, str):
                plain.add(node.value)
            elif isinstance(node, ast.JoinedStr):
                built.append([
                    str(each.value) if isinstance(each, ast.Constant) else ""
                    for each in node.values
                ])  # fmt: skip
    return plain, built


def pattern(parts: list[str], put_in: str) -> str:
    return "".join(re.escape(part) or put_in for part in parts)


def test_every_text_is_there_in_both_languages_with_the_same_holes() -> None:
    for key, text in TEXTS.items():
        assert set(text) == set(LANGUAGES), key
        told = [form for language in LANGUAGES for form in forms(text[language])]
        assert all(form.strip() for form in told), key
        assert len({frozenset(holes(form) - {"count"}) for form in told}) == 1, key


COMPOSED = {
    *("inputs", "columns", "captions", "solution", "curve", "answers", "quantities"),
    "note_motion",
}
"""Groups whose keys are put together where they are used, of the group and a name."""

SAID_BY_WORD = {"terms", "columns"}
"""Groups that are looked up by the English that code or data have, too."""

LEAST = 4
"""Letters of an f-string from which it says something of the text that it makes."""


def built_in_code() -> re.Pattern[str]:
    """Match what f-strings of the source make."""
    built = [each for each in texts_in_code()[1] if sum(map(str.isalpha, "".join(each))) >= LEAST]
    return re.compile("|".join(sorted(f"(?:{pattern(each, '.+')})" for each in built)))


def words_of_data(value: object) -> Iterator[str]:
    """Yield every text of a data file, and every key."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, dict):
        for key, each in value.items():
            yield from (key, *words_of_data(each))
    elif isinstance(value, list):
        for each in value:
            yield from words_of_data(each)


def folded(text: str) -> str:
    return text.lower().replace("_", " ")


def composed_in_code() -> list[re.Pattern[str]]:
    """List every key that is put together, as ``note.{key}``, with a group for each part."""
    composed = (pattern(each, "(.+)") for each in texts_in_code()[1])
    return [re.compile(each) for each in composed if re.match(r"([a-z_]+|\(\.\+\))\\\.", each)]


@pytest.mark.slow
def test_every_text_is_used() -> None:
    shell = (PACKAGE / "desk" / "shell.html").read_text("utf-8")
    asked = {f"desk.{name}" for name in re.findall(r'say\("(\w+)"\)', shell)}
    code = {*QUANTITIES, *texts_in_code()[0], *asked}
    code |= {key.replace("-", "_") for key in code}
    data = [
        tomllib.loads(path.read_text("utf-8"))
        for path in PACKAGE.rglob("*.toml")
        if path.parent.name != "texts"
    ]
    words = {folded(each) for each in (*code, *words_of_data(data))}
    built = built_in_code()
    composed = composed_in_code()

    def is_used(key: str) -> bool:
        if key in code:
            return True
        group, _, name = key.partition(".")
        english = str(TEXTS[key]["en"])
        if group in SAID_BY_WORD and (folded(english) in words or built.fullmatch(english)):
            return True
        if group in COMPOSED and (name in code or built.fullmatch(name) is not None):
            return True
        found = (pattern.fullmatch(key) for pattern in composed)
        return any(each and code.issuperset(each.groups()) for each in found)

    unused = [key for key in TEXTS if not is_used(key)]
    assert unused == []


def test_a_term_has_one_translation() -> None:
    found: dict[str, str] = {}
    for name in ("terms", "columns", "quantities"):
        for text in group(name).values():
            english, vietnamese = text["en"], text["vi"]
            assert isinstance(english, str)
            assert isinstance(vietnamese, str)
            assert found.setdefault(english, vietnamese) == vietnamese


def test_a_text_of_a_data_file_is_said() -> None:
    told = Told({"en": "no figure", "vi": "không có số liệu"})
    assert told == "no figure"
    assert say(told, "vi") == "không có số liệu"
    with pytest.raises(KeyError):
        Told({"en": "no figure"})


def test_a_sentence_ends_with_one_full_stop() -> None:
    assert Sentence(RISES) == f"{RISES}."
    assert Sentence("it holds.", capital=True) == "It holds."
    assert say(Sentence(RISES, capital=True), "vi") == f"D{RISES_VI[1:]}."


def test_messages_are_found_again_in_a_document() -> None:
    listed = Listed((Message("words.and"), "b", Measure("tension", 1e3).__str__()), "or")
    strong = Message("checks.MBL", strength=Measure("tension", 7.3e6), factor=3.0)
    written = Told({"en": "yes", "vi": "có"})
    document = {
        "a": [RISES, "plain"],
        "b": {"c": Several((strong, listed)), "d": 1.0, "e": Sentence(written), "f": term("sand")},
    }
    read = json.loads(json.dumps(document))
    again = with_messages(read, json.loads(json.dumps(messages_in(document))))
    assert again == document
    assert read["a"][0] == RISES
    assert say(read["a"][0], "vi") == RISES
    assert say(again["a"][0], "vi") == RISES_VI
    assert say(again["b"]["c"], "vi") == say(Several((strong, listed)), "vi")
    assert say(again["b"]["e"], "vi") == "có."
    assert say(again["b"]["f"], "vi") == "cát"


def test_every_quantity_has_its_name() -> None:
    assert set(group("quantities")) == set(QUANTITIES)
    for key, quantity in QUANTITIES.items():
        assert quantity_name(key) == quantity.name


def test_headings_are_said_with_symbol_and_unit() -> None:
    tension = Message("columns.fairlead_tension")
    assert heading(tension, QUANTITIES["tension"]) == "Fairlead tension T (kN)"
    assert heading(tension, QUANTITIES["tension"], "vi") == "Lực căng tại điểm treo T (kN)"
    assert heading(quantity_name("cost"), QUANTITIES["cost"], si=True) == "Cost (USD)"
    demand = Message("columns.of_row", name=Message("columns.demand"))
    assert demand == "Demand (unit of the row)"
    assert say(demand, "vi") == "Giá trị tính toán (đơn vị theo hàng)"


def test_a_message_is_its_english_and_is_said_in_vietnamese_with_what_it_holds() -> None:
    english = (
        "the line rises 0.25 m above the water surface; its weight there is taken as submerged"
    )
    assert english == RISES == say(RISES, "en")
    assert json.dumps([RISES]) == json.dumps([english])
    assert say(RISES, "vi") == RISES_VI
    held = Message("checks.in_load_case", name="storm", said=RISES)
    assert say(held, "vi") == f'trường hợp tải trọng "storm": {RISES_VI}'
    both = Several((RISES, "the user's own"), " | ")
    assert both == f"{RISES} | the user's own"
    assert say(both, "vi") == f"{RISES_VI} | the user's own"


def test_other_words_stay_as_they_are() -> None:
    assert say("made fast {here}", "vi") == "made fast {here}"
    named = Message("checks.named_segment", number=2, name="{braces}")
    assert say(named, "vi") == "đoạn 2 ({braces})"
    assert term("a user's own") == "a user's own"
    assert is_term("Fairlead tension")
    assert say(term("sand"), "vi") == "cát"


def test_number_chooses_the_text() -> None:
    one = Message("catenary.first_load_case", name="a", count=1, others='"b"')
    two = Message("catenary.first_load_case", name="a", count=2, others='"b", "c"')
    assert "there is also" in one
    assert "there are also" in two
    assert '"b", "c"' in say(two, "vi")


@pytest.mark.parametrize("message", [RISES, Several((RISES, "plain"))])
def test_a_message_keeps_its_values_when_it_is_copied_or_sent(message: Message) -> None:
    for same in (copy.deepcopy(message), pickle.loads(pickle.dumps(message))):
        assert same == message
        assert say(same, "vi") == say(message, "vi")


def test_a_message_without_its_value_is_a_fault() -> None:
    with pytest.raises(KeyError, match="height"):
        Message("catenary.rises")
    with pytest.raises(KeyError):
        Message("catenary.no_such_text")


def test_a_message_is_known_by_its_key() -> None:
    assert is_said(RISES, "catenary.rises")
    assert not is_said(RISES, "catenary.slack")
    assert not is_said(str(RISES), "catenary.rises")


def test_a_measure_is_said_in_the_unit_of_the_field() -> None:
    assert f"{Measure('tension', 7.3e6):.4g}" == "7300 kN"
    assert str(Measure("nominal_diameter", 0.0761)) == "76.1 mm"
