"""Two answers of one kind beside each other: what was asked differently, and what that comes to."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from catopt.answers import blocks
from catopt.answers.blocks import tabulate, texts
from catopt.words import Message

Row = tuple[str, str, str]


def comparison(
    kept: blocks.Answer, present: blocks.Answer, inputs: Sequence[Row]
) -> blocks.Section:
    """Lay out two answers of one kind; what only one of them has is left out.

    Of `inputs`, what was asked differently: its label, of the kept answer, and of the present one.
    """
    return blocks.Section(
        Message("desk.compared"), tuple(_blocks(kept, present, inputs)), "compared"
    )


def _blocks(
    kept: blocks.Answer, present: blocks.Answer, inputs: Sequence[Row]
) -> Iterator[blocks.Block]:
    said, also_said = _words(kept), _words(present)
    one, other = _facts(kept), _facts(present)
    if not inputs and (one, said) == (other, also_said):
        yield blocks.Text(Message("desk.same"))
        return
    if inputs:
        yield _beside("asked", "desk.inputs", inputs)
    both = [(name, words, also_said[name]) for name, words in said.items() if name in also_said]
    if both:
        yield _beside("said", "desk.answer", both)
    names = [name for name in one if name in other]
    if names:
        units = tuple(each for name in names if (each := one[name].quantity) is not None)
        yield tabulate(
            "compared",
            texts("what", names),
            texts("desk.kept_one", [one[name].value for name in names], units=units),
            texts("desk.present_one", [other[name].value for name in names], units=units),
        )


def _beside(name: str, caption: str, rows: Sequence[Row]) -> blocks.Table:
    headings = ("what", "desk.kept_one", "desk.present_one")
    columns = map(texts, headings, zip(*rows, strict=True))
    return tabulate(name, *columns, caption=Message(caption))


def _facts(answer: blocks.Answer) -> dict[str, blocks.Fact]:
    """Find the numbers among the facts of an answer, by name; not those that repeat its inputs."""
    return {
        fact.name: fact
        for block in answer.blocks
        if isinstance(block, blocks.Facts) and block.name != "inputs"
        for fact in block.facts
        if fact.quantity is not None and isinstance(fact.value, int | float)
    }


def _words(answer: blocks.Answer) -> dict[str, str]:
    """Find the verdict, and what a sizing says of its recommended line, by name."""
    found: dict[str, str] = {}
    for block in answer.blocks:
        if isinstance(block, blocks.Verdict):
            found.setdefault(Message("captions.checks"), block.said)
        elif isinstance(block, blocks.Table) and block.name == "sizing":
            what, _, words = block.columns
            rows = zip(what.values, words.values, strict=True)
            found |= {
                name: said
                for name, said in rows
                if isinstance(name, str) and isinstance(said, str) and said
            }
    return found
