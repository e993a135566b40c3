"""The answer of a result that came by itself, as Python has it, and two answers compared."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from catopt.answers import blocks
from catopt.answers.blocks import Answer, Table, answered, section, tabulate, texts
from catopt.words import Message

if TYPE_CHECKING:
    import pandas as pd

    from catopt.catenary.solution import Solution
    from catopt.design.result import DesignPoint


def layouts() -> dict[str, Callable[[Any], Answer]]:
    """List what lays a result out, by the name of its class."""
    from catopt.answers.check import check_answer
    from catopt.answers.design import design_answer
    from catopt.answers.finding import finding_answer
    from catopt.answers.motion import motion_answer
    from catopt.answers.note_comparison import again_answer
    from catopt.answers.size import size_answer
    from catopt.answers.solution import curve_answer
    from catopt.answers.study import study_answer
    from catopt.answers.system import solved_system
    from catopt.answers.verification import verification_answer

    return {
        "CaseCurve": curve_answer,
        "CheckReport": check_answer,
        "DesignPoint": _design,
        "DesignResult": design_answer,
        "DynamicVerification": motion_answer,
        "FoundValues": finding_answer,
        "NoteAgain": again_answer,
        "Sizing": size_answer,
        "Solution": _solution,
        "SolutionInCurrent": _solution,
        "StudyResult": study_answer,
        "SystemReport": lambda report: solved_system(report.solution),
        "SystemSolution": solved_system,
        "Verification": verification_answer,
    }


def answer_of(result: Any) -> Answer:
    """Lay out a result; TypeError for what is none."""
    name, known = type(result).__name__, layouts()
    if name not in known:
        raise TypeError(f"a {name} has no tables; those of {', '.join(known)} are known")
    answer = known[name](result)
    sections = [
        replace(each, name=each.name or f"{name}-{number}")  # those with a name are on a page
        for number, each in enumerate(answer.sections)
    ]
    return replace(answer, sections=tuple(sections))


def table_of(result: Any) -> pd.DataFrame:
    """Return the main table of a result: the one of its kind, or the first."""
    blocks = answer_of(result).blocks
    tables = [each for each in blocks if isinstance(each, Table) and each.only != "workbook"]
    of_its_kind = [each for each in tables if each.name == "sizing"]
    return (of_its_kind or tables)[0].to_dataframe()


def _solution(solution: Solution) -> Answer:
    from catopt.answers.solution import segments_table, summary

    results = section("captions.results", summary(solution), segments_table(solution))
    return answered("solution", Message("captions.mooring_line"), results)


def _design(point: DesignPoint) -> Answer:
    from catopt.answers.check import check_answer
    from catopt.answers.solution import given_tables

    line = section("captions.given", *given_tables(point.line))
    checks = check_answer(point.checks)
    return replace(checks, sections=(line, *checks.sections))


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
