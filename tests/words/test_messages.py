"""Messages are English as text, keep their values, and have every text in both languages."""

from __future__ import annotations

import ast
import copy
import errno
import json
import os
import pickle
import re
import tomllib
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from string import Formatter

import pytest

import catopt
from catopt import words
from catopt.quantities import QUANTITIES, Quantity
from catopt.units import Dimension
from catopt.words import (
    LANGUAGES,
    Listed,
    Measure,
    Message,
    Sentence,
    Several,
    Translated,
    heading,
    say,
    term,
)
from catopt.words.message import group, groups
from catopt.words.message_records import messages_in, with_messages

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
                parts = (getattr(each, "value", "") for each in node.values)
                built.append([each if isinstance(each, str) else "" for each in parts])
    return plain, built


def pattern(parts: list[str], put_in: str) -> str:
    return "".join(re.escape(part) or put_in for part in parts)


def test_every_text_is_there_in_both_languages_with_the_same_holes() -> None:
    for key, text in TEXTS.items():
        assert set(text) == set(LANGUAGES), key
        told = [form for language in LANGUAGES for form in forms(text[language])]
        assert all(form.strip() for form in told), key
        assert len({frozenset(holes(form) - {"count"}) for form in told}) == 1, key


ONE_WORD = re.compile(r"(?<![\w./=\"\[-])[a-z]{4,}\b(?![.=:])")
"""In an f-string: a word that is no key, no unit and no label."""


def english_in(node: ast.expr) -> Iterator[str]:
    """Yield what an argument says in plain words, outside of what makes a message."""
    if isinstance(node, ast.Call):
        return
    said = ""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        said = node.value
    elif isinstance(node, ast.JoinedStr):
        said = "".join(
            each for part in node.values if isinstance(each := getattr(part, "value", 0), str)
        )
    else:
        for each in ast.iter_child_nodes(node):
            if isinstance(each, ast.expr):
                yield from english_in(each)
    is_word = isinstance(node, ast.JoinedStr) and ONE_WORD.search(said)
    if is_word or re.search(r"(?<![\w./=-])[a-z]{2,} +([\d.]+ +)?[a-z]{2,}(?![\w.=-])", said):
        yield said


def with_what_it_names(node: ast.expr, tree: ast.Module) -> Iterator[ast.expr]:
    """Yield an argument and, of a variable, whatever its file assigns to one of that name."""
    yield node
    if isinstance(node, ast.Name):
        for each in ast.walk(tree):
            if isinstance(each, ast.Assign) and any(
                isinstance(target, ast.Name) and target.id == node.id for target in each.targets
            ):
                yield each.value


REFUSES = {"Problem": 3, "Finding": 3, "add": 3, "problem": 2, "refuse": 3, "refused": 3}
"""What notes something wrong, and how many of its arguments say so; the first says where."""


def test_nothing_is_refused_in_plain_english() -> None:
    """Neither what was found nor what is required, in any part of catopt."""
    found = [
        (path.relative_to(PACKAGE).as_posix(), node.lineno, said)
        for path in PACKAGE.rglob("*.py")
        for tree in [ast.parse(path.read_text("utf-8"))]
        for node in ast.walk(tree)
        if isinstance(node, ast.Call)
        for name in [getattr(node.func, "attr", getattr(node.func, "id", ""))]
        for given in [*node.args[1 : REFUSES.get(name, 0)], *(k.value for k in node.keywords)]
        if name in REFUSES
        for each in with_what_it_names(given, tree)
        for said in english_in(each)
    ]
    assert found == []
    assert list(english_in(ast.parse("f'{count} of them are here'", mode="eval").body))


SAYS = {
    **dict.fromkeys(("note", "text", "progress", "working", "announce", "said"), 0),
    **dict.fromkeys(("leave", "wrong", "missing"), 1),
}
"""What says something beside an answer, or makes a finding; which of its arguments is said."""


def test_no_command_says_anything_in_plain_english() -> None:
    """Neither beside an answer, nor while it works, nor where it ends; nor does what it reads."""
    parts = ("cli", "design", "study", "casefile")
    found = [
        (path.relative_to(PACKAGE).as_posix(), node.lineno, said)
        for part in parts
        for path in (PACKAGE / part).rglob("*.py")
        for tree in [ast.parse(path.read_text("utf-8"))]
        for node in ast.walk(tree)
        if isinstance(node, ast.Call)
        for name in [getattr(node.func, "attr", getattr(node.func, "id", ""))]
        if name in SAYS and len(node.args) > SAYS[name]
        for each in with_what_it_names(node.args[SAYS[name]], tree)
        for said in english_in(each)
    ]
    assert found == []


COMPOSED = {
    *("inputs", "columns", "captions", "solution", "curve", "answers", "quantities"),
    "note_motion",
}
"""Groups whose keys are put together where they are used, of the group and a name."""

SAID_BY_WORD = {"terms", "columns", "names"}
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
    shell = (PACKAGE / "page_api" / "shell.html").read_text("utf-8")
    asked = {f"desk.{name}" for name in re.findall(r'say\("(\w+)"\)', shell)}
    code = {*QUANTITIES, *texts_in_code()[0], *asked, *(each.name for each in Dimension)}
    code |= {os.strerror(each) for each in errno.errorcode}
    code |= {re.sub("[- ]", "_", key) for key in code}
    data = [
        tomllib.loads(path.read_text("utf-8"))
        for path in PACKAGE.rglob("*.toml")
        if path.parent.name != "texts"
    ]
    known = {folded(each) for each in (*code, *words_of_data(data))}
    built = built_in_code()
    composed = composed_in_code()

    def is_used(key: str) -> bool:
        if key in code:
            return True
        group, _, name = key.partition(".")
        english = str(TEXTS[key]["en"])
        if group in SAID_BY_WORD and (folded(english) in known or built.fullmatch(english)):
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


def test_messages_are_found_again_in_a_document() -> None:
    listed = Listed((Message("words.and"), "b", Measure("tension", 1e3).__str__()), "or")
    strong = Message("checks.MBL", strength=Measure("tension", 7.3e6), factor=3.0)
    written = Translated({"en": "yes", "vi": "có"})
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
        assert words.quantity_name(key) == quantity.name


RISES_EN = "the line rises 0.25 m above the water surface; its weight there is taken as submerged"


@pytest.mark.parametrize(
    ("message", "english", "vietnamese"),
    [
        (RISES, RISES_EN, RISES_VI),
        (
            Message("checks.in_load_case", name="storm", said=RISES),
            f'load case "storm": {RISES_EN}',
            f'trường hợp tải trọng "storm": {RISES_VI}',
        ),
        (
            Several((RISES, "the user's own"), " | "),
            f"{RISES_EN} | the user's own",
            f"{RISES_VI} | the user's own",
        ),
        (Sentence(RISES), f"{RISES_EN}.", f"{RISES_VI}."),
        (Sentence(RISES, capital=True), f"T{RISES_EN[1:]}.", f"D{RISES_VI[1:]}."),
        (Sentence("it holds.", capital=True), "It holds.", "It holds."),
        (
            Translated({"en": "no figure", "vi": "không có số liệu"}),
            "no figure",
            "không có số liệu",
        ),
        (term("sand"), "sand", "cát"),
        (term("a user's own"), "a user's own", "a user's own"),
        ("made fast {here}", "made fast {here}", "made fast {here}"),
        (
            Message("checks.named_segment", number=2, name="{braces}"),
            "segment 2 ({braces})",
            "đoạn 2 ({braces})",
        ),
        (
            Message("columns.of_row", name=Message("columns.demand")),
            "Demand (unit of the row)",
            "Giá trị tính toán (đơn vị theo hàng)",
        ),
    ],
)
def test_a_message_is_its_english_and_is_said_in_vietnamese_with_what_it_holds(
    message: str, english: str, vietnamese: str
) -> None:
    assert message == english == say(message, "en")
    assert json.dumps([message]) == json.dumps([english])
    assert say(message, "vi") == vietnamese


def test_headings_are_said_with_symbol_and_unit() -> None:
    tension, heading = QUANTITIES["tension"], words.heading
    fairlead = Message("columns.fairlead_tension")
    assert heading(fairlead, tension) == "Fairlead tension T (kN)"
    assert heading(fairlead, tension, "vi") == "Lực căng tại điểm treo T (kN)"
    assert heading(words.quantity_name("cost"), QUANTITIES["cost"], si=True) == "Cost (USD)"
    assert words.is_term("Fairlead tension")


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
    with pytest.raises(KeyError):
        Translated({"en": "no figure"})


def test_a_message_is_known_by_its_key() -> None:
    assert words.is_said(RISES, "catenary.rises")
    assert not words.is_said(RISES, "catenary.slack")
    assert not words.is_said(str(RISES), "catenary.rises")


def test_a_measure_is_said_in_the_unit_of_the_field() -> None:
    assert f"{Measure('tension', 7.3e6):.4g}" == "7300 kN"
    assert str(Measure("nominal_diameter", 0.0761)) == "76.1 mm"
    assert str(Measure("nominal_diameter", 0.019)) == "19.0 mm"


def test_no_number_has_an_exponent_that_people_do_not_read() -> None:
    """In three digits 1000 m were 1e+03 m."""
    said = Message("sizing.below_lightest", weight=12345.0, height=1000.0, name="chain")
    assert "12300 kN: 1000 m of chain" in said
    assert "12300 kN: 1000 m chain" in say(said, "vi")
    assert f"{Measure('tension', 1.5e6):.2g}" == "1500 kN"
    assert f"{Measure('tension', 1.5e12):.2g}" == "1.5e+09 kN"
    small = Message("sizing.below_lightest", weight=1.5e-7, height=0.5, name="chain")
    assert "1.5e-07 kN: 0.5 m" in small


def test_a_unit_that_is_a_word_is_said_in_the_language() -> None:
    life = Quantity("life", "Life", "", "s", "years", 31557600.0, 4)
    assert heading(Message("fatigue.life"), life).endswith(" (years)")
    assert heading(Message("fatigue.life"), life, "vi").endswith(" (năm)")
