"""What an old note beside one of this version consists of."""

from __future__ import annotations

from typing import TYPE_CHECKING

from catopt.answers import blocks
from catopt.answers.blocks import Rows, answered, section, tabulate
from catopt.quantities import Quantity
from catopt.words import Cited, Message

if TYPE_CHECKING:
    from catopt.notes.note_comparison import NoteAgain


_CHANGE = Quantity("change", "Change", "", "-", "-", 1.0, 1, "scientific")


def again_answer(result: NoteAgain) -> blocks.Answer:
    """Lay out how many numbers are the same, and each that is not, then and now."""
    of = Rows(result.otherwise)
    words = {"then": result.written_by, "now": result.now, "same": result.same}
    verdict = Message(
        "note.again_otherwise" if result.otherwise else "note.again_same",
        count=len(result.otherwise),
        **words,
    )
    said: list[blocks.Block] = [blocks.Verdict(verdict, not result.otherwise)]
    if result.gone or result.new:
        only = Message("note.again_only", gone=result.gone, new=result.new)
        said.append(blocks.Text(only))
    table = tabulate(
        "note_again",
        of.texts("section", lambda each: Cited(each.section)),
        of.texts("row", lambda each: Cited(each.row)),
        of.texts("column", lambda each: Cited(each.column)),
        of.texts("then", lambda each: Cited(each.then), quantity=blocks.named("coefficient")),
        of.texts("now", lambda each: Cited(each.now), quantity=blocks.named("coefficient")),
        of.measured(_CHANGE, "change", "change"),
    )
    return answered("note_again", Cited(result.note), section("terms.comparison", *said, table))
