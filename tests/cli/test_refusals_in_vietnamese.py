"""Every refusal of the transcripts, said in Vietnamese with nothing English in it."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import get_args

import pytest

from catopt.casefile.reading import Moored
from catopt.casefile.schema import entries
from catopt.casefile.writing import TEMPLATES
from catopt.catalogue import standard
from catopt.cli.app import _PLACES
from catopt.export.export_result import Format
from catopt.loads.buoy import buoys
from catopt.loads.drag_anchor import ANCHORS, SOILS
from catopt.loads.ship_coefficients import TYPES
from catopt.loads.sinker import SOIL_FRICTION
from catopt.model.case import Boundary
from catopt.reproduce import names as studies
from catopt.sizing.inputs import inputs_of
from catopt.words import LANGUAGES
from catopt.words.message import group, groups
from tests.casefile.test_schema import tables

from .cases import write_files
from .conftest import Run
from .test_transcripts import MAKES, run_as, sessions, steps

REFUSED = [each for each in sessions() if any(line[:5] == "exit " for line in each.values[0])]


def words_of(text: str) -> set[str]:
    """List the words of a text outside of quotes and holes, names of files and options."""
    plain = re.sub(r"'[^']*'|\"[^\"]*\"|`[^`]*`|\{[^}]*\}|\[[^]]*\]|--?\w[\w-]*", " ", text)
    return set(re.findall(r"(?<![\w./=-])[a-z]{2,}(?![\w./=-])", plain))


def english_words() -> set[str]:
    """List the words of refusals in English that stand in none in Vietnamese."""
    found: dict[str, set[str]] = {language: set() for language in LANGUAGES}
    for name in groups():
        for text in group(name).values():
            for language in LANGUAGES if name.startswith("refused") else ("vi",):
                told = text[language]
                for form in [told] if isinstance(told, str) else told.values():
                    found[language] |= words_of(form)
    return found["en"] - found["vi"] - names()


def names() -> set[str]:
    """List the words of what has one name in every language: keys, families, kinds and soils."""
    found = {*studies(), *_PLACES, *TEMPLATES, *TYPES, *SOILS, *SOIL_FRICTION, *get_args(Boundary)}
    found |= {each.name for each in buoys()}
    found |= {*keys(), *ANCHORS, *get_args(Format)}
    families = standard().families
    found |= {each for family in families for each in (family.name, *family.grades)}
    return {word for each in found for word in re.findall(r"[a-z]{2,}", each.replace("_", " "))}


def keys() -> Iterator[str]:
    """Yield the keys of files, and the words that they take."""
    for table in tables().values():
        yield from entries(table)
        for entry in entries(table).values():
            yield from getattr(entry.kind, "words", ())
    for moored in get_args(Moored):
        for each in inputs_of(moored).values():
            yield from (each.name, *each.path, *each.words)


ENGLISH = english_words()


def refusals(run: Run, session: list[str]) -> Iterator[tuple[str, set[str]]]:
    """Run a session, what is refused in it in Vietnamese; yield what is said, and its own words."""
    own = words_of(" ".join(session).replace("_", " "))
    for command, said in steps(session):
        if make := MAKES.get(command[0]):
            make(*(text.replace("\\n", "\n") for text in command[1:]))
        elif said["exit"] and "with an answer" not in said["exit"][0]:
            ran = run_as(run, ["CATOPT_LANG=vi", *command], said["<"])
            assert ran.out == ""
            refused = ran.err[max(ran.err.find("catopt: "), 0) :]  # behind what a command does
            if "CATOPT_LANG=fr" not in command:
                yield refused, own
        else:
            run_as(run, command, said["<"])


def test_words_that_only_english_has_are_known() -> None:
    assert {"required", "missing", "leave", "below", "the", "goes"} <= ENGLISH


@pytest.mark.parametrize("session", REFUSED)
def test_no_refusal_is_english(run: Run, inside: Path, session: list[str]) -> None:
    write_files(inside)
    for said, own in refusals(run, session):
        told = re.sub(r"(?m)^  [^:\n]*: ", "", said)  # without the keys
        assert words_of(told) & ENGLISH - own == set(), said
