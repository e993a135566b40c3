"""The card of an answer, however much the answer holds."""

from __future__ import annotations

from time import process_time

from catopt.answers.blocks import (
    Answer,
    Brief,
    Column,
    Fact,
    Facts,
    Points,
    Section,
    Table,
    Verdict,
    Warnings,
    measured,
    texts,
)
from catopt.answers.check import check_answer
from catopt.casefile import read_case
from catopt.checks.case import check_case
from catopt.render.card import LINES, card_lines
from catopt.render.terminal import table_lines
from catopt.words import Message

WARNING = " ".join(["a remark on a figure that was printed"] * 8)
"""Of some fifty words: more than a line of the card has room for."""


def test_an_answer_of_many_remarks_is_laid_out_at_once() -> None:
    """`catopt reproduce` has hundreds of them; once each was folded again for each that was cut."""
    many = [
        Section(f"Print {k}", (Warnings((f"{k}: {WARNING}",) * 40), Points((WARNING,) * 40)))
        for k in range(100)
    ]
    began = process_time()
    lines = [each.text for each in card_lines(Answer("prints", "Prints", tuple(many)))]
    assert process_time() - began < 2.0
    assert lines[0] == "Prints"
    assert 3 < len(lines) <= LINES
    assert max(map(len, lines)) <= 80


def numbers(name: str, rows: int, caption: str) -> Table:
    return Table(name, (Column("x", tuple(range(rows))),), caption)


def test_what_a_screen_does_without_is_named_and_what_is_to_be_known_stays() -> None:
    known = Brief((WARNING,), Message("answers.card_to_be_known"), 3)
    facts = Facts("body", tuple(Fact(f"fact {k}", "x" * 60) for k in range(12)), "Body")
    card = (
        Verdict("It holds.", True),
        numbers("out", 9, "One line out"),
        numbers("circle", 9, "Watch circle"),
        numbers("lines", 9, "Lines"),
        facts,
        known,
        Brief(("Solved.",)),
    )
    lines = [each.text for each in card_lines(Answer("system", "Body", (), card=card))]
    assert len(lines) <= LINES
    assert lines[:2] == ["Body", "It holds."]
    assert any(each.startswith("Notes: ") for each in lines)
    (named,) = (each for each in lines if each.startswith("Not on this screen (--full): "))
    assert named.endswith(": Body")
    assert not any("Solved" in each or "fact" in each for each in lines)


def test_facts_are_cut_after_tables_and_counted() -> None:
    facts = Facts("body", tuple(Fact(f"fact {k}", "x" * 60) for k in range(18)), "Body")
    card = (facts, numbers("lines", 9, "Lines"))
    lines = [each.text.strip() for each in card_lines(Answer("system", "Body", (), card=card))]
    assert len(lines) <= LINES
    shown = [each for each in lines if each.startswith("fact ")]
    assert len(shown) > 3
    assert f"and {18 - len(shown)} more" in lines
    assert "and 7 more rows" in lines


def test_tables_without_rows_columns_or_values_take_no_line() -> None:
    tables = (numbers("joints", 0, "Joints"), Table("dashes", (Column("x", ("-", "")),), "Dashes"))
    card = (Verdict("It holds.", True), *tables, numbers("lines", 1, "Lines"))
    lines = [each.text for each in card_lines(Answer("system", "Body", (), card=card))]
    assert lines == ["Body", "It holds.", "", "x", "0", ""]


def test_a_column_that_is_dropped_gives_its_room_back() -> None:
    """Of the verdicts of a buoy "Reserve buoyancy" was cut though ten columns stayed empty."""
    case = read_case("cases/design-buoy-9.5m/case.toml")
    lines = [each.text for each in card_lines(check_answer(check_case(case)))]
    for kind in ("Tension", "Uplift angle", "Reserve buoyancy"):
        (row,) = (each for each in lines if each.startswith(f"{kind}   "))
        assert row.endswith("storm, high water")
    assert max(map(len, lines)) <= 80


def test_headings_are_broken_before_words_below_them_are_cut() -> None:
    words = "storm, high water, one line damaged"
    columns = (
        texts("load_case", [words]),
        *(measured("tension", [4625e3]) for _ in range(3)),
        measured("utilisation", [0.139]),
    )
    lines = table_lines(Table("t", columns), 5, "en")
    assert lines[-1].startswith(words)
