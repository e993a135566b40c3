"""The card of an answer, however much the answer holds."""

from __future__ import annotations

from time import process_time

from catopt.answers.blocks import Answer, Points, Section, Warnings
from catopt.render.card import LINES, WIDTH, card_lines

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
    assert max(map(len, lines)) <= WIDTH
