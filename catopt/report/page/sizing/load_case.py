"""Load cases of a sizing in the reader's language: catopt made their names, and no user did."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from catopt.checks.result import CheckSource
from catopt.notes.line import Chosen, Note
from catopt.render.texts import Words
from catopt.words import term

__all__ = ["load_case_words", "said_line", "said_names"]


def load_case_words(name: str, words: Words) -> str:
    """Say a load case: ``"storm, high water"``."""
    return words.name(name)


def said_names(line: Note, words: Words) -> dict[str, str]:
    """Say every load case of a line's note, by its name."""
    return {state.name: load_case_words(state.name, words) for state in line.checks.load_cases}


def said_line(line: Note, words: Words) -> Note:
    """Fit a line's note into that of its sizing.

    Its load cases get their names in the reader's language, and a limit that no document has is
    from this note: of a sizing there is no case file.

    Parameters
    ----------
    line : Note
        Of the recommended line.
    words : Words
        Language.
    """
    names = said_names(line, words)
    of = line.checks
    checks = replace(
        of,
        results=tuple(
            replace(each, load_case=names[each.load_case], source=_said_source(each.source))
            for each in of.results
        ),
        solutions=tuple((names[name], solution) for name, solution in of.solutions),
        load_cases=tuple(replace(each, name=names[each.name]) for each in of.load_cases),
    )
    chosen = line.chosen
    if chosen is not None:
        chosen = Chosen(_renamed(chosen.document, names), chosen.number)
    return replace(
        line, checks=checks, load_case=names.get(line.load_case, line.load_case), chosen=chosen
    )


def _said_source(source: CheckSource) -> CheckSource:
    return replace(source, document=term("this note")) if source.confidence is None else source


def _renamed(value: Any, names: Mapping[str, str]) -> Any:
    """Put the names in wherever a document has them; its messages say them themselves."""
    if isinstance(value, dict):
        return {key: _renamed(each, names) for key, each in value.items()}
    if isinstance(value, list):
        return [_renamed(each, names) for each in value]
    return names.get(value, value) if isinstance(value, str) else value
