"""A sizing on one screen: 22 lines of 80 columns, one verdict, and the document's own numbers."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from typing import Any

import pytest
import typer.main

from catopt.answers.blocks import Answer, Brief, Facts, Table, Text, Verdict
from catopt.answers.note_size import size_note_answer
from catopt.answers.size import size_answer
from catopt.answers.size_card import miss_answer, size_card
from catopt.casefile.reading import Moored
from catopt.cli.size import as_option, by_option
from catopt.cli.size import size as size_commands
from catopt.constants import YEAR
from catopt.design.neighbours import NoFeasibleDesignError
from catopt.errors import InputError
from catopt.notes.line import Given, size_note
from catopt.notes.origin import Asked
from catopt.quantities import Units
from catopt.render.card import LINES, card_lines
from catopt.render.values import UNITS
from catopt.sizing import Sizing
from catopt.sizing.input_values import ResolvedInputs, input_values
from catopt.sizing.requests import size
from catopt.words import LANGUAGES, Language, Message, Translated, say
from tests.sizing.at_rest import size_buoy, size_tanker

from .results import around, by_force


@cache
def buoy() -> Sizing:
    return size_buoy(buoy="pillar 1.8 m", depth="12 m")


@cache
def steady() -> Sizing:
    return size_buoy(buoy="pillar 1.8 m", depth="12 m", dynamic_factor=1)


@cache
def ship() -> Sizing:
    return size_tanker(dwt="50000 t", depth="20 m")


SIZINGS = {"buoy": buoy, "by force": by_force, "steady": steady, "ship": ship, "lines": around}
of_each = pytest.mark.parametrize("name", SIZINGS)
in_both_languages = pytest.mark.parametrize("language", LANGUAGES)

LONG = Translated({"en": "long words " * 30, "vi": "lời rất dài " * 30})


def screen(of: Sizing, language: Language = "en", units: Units = "") -> list[str]:
    """Lay a sizing out as a command prints it."""
    before = UNITS.set(units)
    try:
        lines = card_lines(size_answer(of), language, Message("answers.more_full"))
    finally:
        UNITS.reset(before)
    return [each.text for each in lines]


def crowded(of: Sizing) -> Sizing:
    """Give a sizing more to say than there is room for."""
    return replace(
        of,
        practice=LONG,
        chain_life=4.2 * YEAR,
        fittings=(LONG, LONG),
        advice=(LONG,) * 5,
        assumptions=(LONG,) * 5,
        defaults=(*of.defaults, *(LONG,) * 5),
    )


@of_each
@in_both_languages
def test_it_has_at_most_22_lines_of_80_columns(name: str, language: Language) -> None:
    of = SIZINGS[name]()
    for each in (of, crowded(of)):
        for units in ("", "tf", "si"):
            lines = screen(each, language, units)
            assert len(lines) <= LINES == 22
            assert max(map(len, lines)) <= 80
            assert not re.search(r"\de\+", "\n".join(lines))


@in_both_languages
def test_no_word_is_cut_and_what_has_no_room_is_counted(language: Language) -> None:
    """Of five items of 90 words the first is cut at a word, and four more are counted."""
    items = tuple(
        Translated({"en": " ".join(f"word{k}-{n}" for n in range(90)), "vi": " ".join(["từ"] * 90)})
        for k in range(5)
    )
    brief = Brief(items, Translated({"en": "items", "vi": "mục"}), 3)
    answer = Answer("some", Translated({"en": "title " * 40, "vi": "tên " * 40}), (), card=(brief,))
    title, *lines = (each.text for each in card_lines(answer, language))
    assert title.endswith("...")
    assert len(lines) == 3
    assert " ".join(lines).endswith({"en": "...; 4 more", "vi": "...; 4 mục nữa"}[language])
    whole = {word for each in (*items, brief.label) for word in say(each, language).split()}
    first = " ".join(lines).rpartition(" ...")[0].partition(": ")[2]
    assert set(first.split()) <= whole

    short = replace(brief, said=("a.", "b", "c"))
    assert card_lines(replace(answer, card=(short,)))[1].text == "Items: a; b; c"


def test_an_item_that_fills_its_line_leaves_room_for_the_count() -> None:
    said = tuple(Translated({"en": "x" * 38 + " " + "y" * 37, "vi": ""}) for _ in range(4))
    answer = Answer("some", Translated({"en": "title", "vi": "tên"}), (), card=(Brief(said),))
    _, line = (each.text for each in card_lines(answer, "en"))
    assert line == "x" * 38 + " ...; 3 more"


@of_each
def test_screen_full_answer_and_note_have_one_verdict_in_the_same_words(name: str) -> None:
    of = SIZINGS[name]()
    found = Verdict.of_judgement(of.judgement)
    note = size_note_answer(size_note(of, Given(), Asked(verify=False)))
    first_page = [each for each in note.sections[0].blocks if isinstance(each, Verdict)]
    in_full = [each for each in size_answer(of).blocks if isinstance(each, Verdict)]
    on_screen = [each for each in size_card(of) if isinstance(each, Verdict)]
    assert first_page == in_full == on_screen == [found]
    assert found.kind == "in-part"  # none of them was run
    assert "motion" in str(found.said)


@of_each
def test_no_box_has_both_words(name: str) -> None:
    of = SIZINGS[name]()
    text = " ".join(screen(of)).lower()
    assert "passes at rest every check of" in text
    assert not re.search(r"\bfail", text)
    assert "không đạt" not in " ".join(screen(of, "vi")).lower()
    broken = replace(of.point.checks, results=tuple(
        replace(each, exceedance=1.0) for each in of.point.checks.results
    ))  # fmt: skip
    point = replace(of.point, checks=broken)
    failing = replace(of, settled=replace(of.settled, point=point)).judgement
    assert failing.colour == "red"
    assert not re.search(r"\bpass", str(failing.said).lower())


def test_steady_forces_are_said_first_where_they_were_asked_for() -> None:
    """The code's own method has none either, and says why: that is not what a user asked for."""
    assert steady().dynamic_factor == buoy().dynamic_factor == 1.0
    assert str(steady().judgement.said).startswith("Steady forces")
    assert str(buoy().judgement.said).startswith("Passes at rest every check")


def numbers_in(found: Any) -> Iterator[float]:
    """Yield every number of a document, those in its texts, too."""
    if isinstance(found, dict):
        for each in found.values():
            yield from numbers_in(each)
    elif isinstance(found, list):
        for each in found:
            yield from numbers_in(each)
    elif isinstance(found, str):
        yield from (float(each) for each in re.findall(r"\d+(?:\.\d+)?", found.replace(",", "")))
    elif isinstance(found, float | int):
        yield float(found)


@of_each
@in_both_languages
def test_every_number_on_the_screen_is_one_of_the_document(name: str, language: Language) -> None:
    of = replace(SIZINGS[name](), chain_life=4.2 * YEAR)
    there = list(numbers_in(of.to_dict()))
    text = "\n".join(screen(of, language)).replace(",", "")
    tokens = re.findall(r"(?<![\w.-])\d+(?:\.\d+)?(?![\w.-]*\d)", text)
    assert len(tokens) > 20
    for token in tokens:
        digits = len(token.partition(".")[2])
        ways = (1.0, 1e-3, 1e3, 1.0 / YEAR)
        near = any(f"{abs(each) * way:.{digits}f}" == token for each in there for way in ways)
        counted = re.search(rf"{token} (more|mục nữa)", text)
        assert near or counted, token


@of_each
def test_its_words_are_messages(name: str) -> None:
    of = SIZINGS[name]()
    for block in size_card(of):
        assert not isinstance(block, Table)  # it has none
        said = block.facts if isinstance(block, Facts) else [block.said]
        if isinstance(block, Brief):
            said = [*block.said, *([block.label] if block.label else [])]
        for each in said:
            words = getattr(each, "name", each)
            assert isinstance(words, Message), words


def test_what_a_later_core_says_has_its_place() -> None:
    """What stands beside the line is on the screen, in the full answer, the note, the document."""
    own = {key: Translated({"en": f"{key} said", "vi": f"{key} nói"}) for key in ("a", "b", "c")}
    of = replace(
        buoy(), practice=own["a"], fittings=(own["b"],), advice=(own["c"],), chain_life=7.3 * YEAR
    )
    lines = screen(of)
    for wanted in ("Practice: a said", "Fittings: b said", "Notes: "):
        assert any(each.startswith(wanted) for each in lines)
    assert any("c said" in each for each in lines)
    assert any("after 7.3 years" in each for each in lines)
    document = of.to_dict()
    assert (document["practice"], document["fittings"]) == ("a said", ["b said"])
    assert (document["advice"], document["chain_life_s"]) == (["c said"], 7.3 * YEAR)
    full = [each.said for each in size_answer(of).blocks if isinstance(each, Text)]
    assert {"A said.", "b said", "c said"} <= set(map(str, full))


# ------------------------------------------------------------------ nothing passes

BARE: dict[Moored, dict[str, object]] = {
    "buoy": {"buoy": "pillar 1.8 m", "depth": "12 m", "current": "4 m/s", "hs": "3 m"},
    "tanker": {"dwt": "50000 t", "depth": "20 m", "max_swing": "300 m"},
}
SPELLED = {"buoy": by_option, "tanker": as_option}


@cache
def missed(moored: Moored, **more: str) -> tuple[NoFeasibleDesignError, ResolvedInputs]:
    of = input_values(moored, {**BARE[moored], **more}, SPELLED[moored], "options")
    with pytest.raises(NoFeasibleDesignError) as caught:
        size(of)
    return caught.value, of


def said_of(moored: Moored, **more: str) -> list[str]:
    return said_in("en", moored, **more)


def said_in(language: Language, moored: Moored, **more: str) -> list[str]:
    return [each.text for each in card_lines(miss_answer(*missed(moored, **more)), language)]


MISSES: list[tuple[Moored, dict[str, str]]] = [
    ("buoy", {}),
    ("buoy", {"diameter_max": "16 mm"}),
    ("tanker", {}),
    ("tanker", {"anchor": "sinker"}),
]


@pytest.mark.parametrize(("moored", "more"), MISSES)
@in_both_languages
def test_where_nothing_passes_one_screen_says_so(
    moored: Moored, more: dict[str, str], language: Language
) -> None:
    lines = said_in(language, moored, **more)
    assert 4 <= len(lines) <= LINES
    assert max(map(len, lines)) <= 80
    miss = missed(moored, **more)[0].near_miss
    assert miss is not None
    for kind in {each.kind for each in miss.failing}:
        name = say(Message(f"checks.{kind}_short"), language)
        heads = [each for each in lines if each.startswith(f"{name[:1].upper()}{name[1:]}: ")]
        assert len(heads) == 1


@pytest.mark.parametrize(("moored", "more"), MISSES)
def test_what_would_help_are_options_of_the_command(moored: Moored, more: dict[str, str]) -> None:
    group: Any = typer.main.get_command(size_commands)
    options = {name for each in group.commands[moored].params for name in each.opts}
    said = " ".join(said_of(moored, **more))
    named = re.findall(r"\((--[a-z-]+|[a-z_.]+_[a-z_.]+)\)", said)
    assert named
    assert set(named) <= options


def test_lines_are_advised_in_place_of_the_swing_that_they_bar() -> None:
    """Both together are refused; the advice, taken, is read as several lines."""
    said = " ".join(said_of("tanker"))
    assert "several lines around the ship (--lines 4 in place of --max-swing" in said
    own = dict(BARE["tanker"])
    with pytest.raises(InputError, match="it applies to one line"):
        size(input_values("tanker", {**own, "lines": 4}, as_option, "options"))
    del own["max_swing"]
    assert input_values("tanker", {**own, "lines": 4}, as_option, "options")["lines"] == 4


def test_no_size_is_asked_for_where_every_size_was_tried() -> None:
    """A buoy's chain has the sizes that it is made for, a ship's those up to 120 mm of 185."""
    assert "(--diameter-max)" in " ".join(said_of("buoy"))
    assert "diameter" not in " ".join(said_of("buoy", diameter_max="60 mm"))
    assert "(--diameter-max)" in " ".join(said_of("buoy", diameter_max="16 mm"))
    assert "(--diameter-max)" in " ".join(said_of("tanker"))
    assert "diameter" not in " ".join(said_of("tanker", diameter_max="185 mm"))


def test_nothing_is_named_that_a_buoy_does_not_have() -> None:
    said = " ".join(said_of("buoy", diameter_max="16 mm"))
    assert not re.search("clump|--lines|drag anchor|max-swing", said)
    assert "(BUOY)" in said or "buoyancy" not in said.lower()


def test_it_is_spelled_as_the_caller_spells_it() -> None:
    error, of = missed("tanker")
    of.errors.spell = lambda name, _=None: f"ship file: {name}"
    try:
        said = " ".join(each.text for each in card_lines(miss_answer(error, of)))
    finally:
        of.errors.spell = as_option
    assert "(ship file: max_swing)" in said
    assert "--" not in said
