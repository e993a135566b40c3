"""Names of components as users write them: ``"chain studless R3"``."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Iterator, Sequence
from functools import cache
from typing import NamedTuple

from catopt.catalogue.family import Family
from catopt.errors import InputError, Problem
from catopt.units import as_written
from catopt.words import Message

_SIMILAR = 0.6
"""Share of letters in common (difflib's ratio) from which a name counts as misspelt."""


class ComponentName(NamedTuple):
    """A family and one of its grades; None for a family without grades, or when it is left out."""

    family: str
    grade: str | None


def find_name(name: object, families: Iterable[Family]) -> ComponentName:
    """Read a name. Capitals, hyphens and the order of the words do not matter.

    InputError: there is none of that name; the message gives the nearest.
    """
    names = list(_names(families))
    found = {plain: stands_for for plain, _, stands_for in reversed(names)}
    if isinstance(name, str) and _plain(name) in found:
        return found[_plain(name)]
    near = nearest(name, [shown for _, shown, _ in names]) if isinstance(name, str) else None
    allowed = Message("refused.no_component")
    if near:
        allowed = Message("refused.did_you_mean", near=f'"{near}"')
    elif names:
        allowed = Message("refused.component", example=f'"{names[0][1]}"')
    raise InputError([Problem("component", as_written(name), allowed)])


def shared_names(families: Sequence[Family]) -> list[tuple[str, str]]:
    """List names that two families would share, each with the family that has it already."""
    owners: dict[tuple[str, ...], int] = {}
    shared = []
    for index, family in enumerate(families):
        for name in family.names:
            owner = owners.setdefault(_plain(name), index)
            if owner != index:
                shared.append((name, families[owner].name))
    return shared


def nearest(word: str, words: Iterable[str]) -> str | None:
    """Find the one of some words that a word is a misspelling of, if any."""
    from difflib import get_close_matches

    by_plain = {_letters(each): each for each in words}
    close = get_close_matches(_letters(word), by_plain, n=1, cutoff=_SIMILAR)
    return by_plain[close[0]] if close else None


def meant(wanted: Message, word: str, words: Iterable[str]) -> Message:
    """Say what is wanted, and ask after the word that was meant if one is near."""
    near = nearest(word, words)
    return Message("refused.and_meant", wanted=wanted, near=near) if near else wanted


def _names(families: Iterable[Family]) -> Iterator[tuple[tuple[str, ...], str, ComponentName]]:
    """List every name, comparable and as shown, with what it stands for."""
    for family in families:
        for name in family.names:
            yield _plain(name), name, ComponentName(family.name, None)
            for grade in family.grades:
                full = f"{name} {grade}"
                yield _plain(full), full, ComponentName(family.name, grade)


@cache
def _plain(name: str) -> tuple[str, ...]:
    """Bring a name to a form that is the same for all spellings.

    Remembered: a design search looks hundreds of components up, each among all names.
    """
    return tuple(sorted(_letters(name).split()))


_SIZE = re.compile(r'(?<![\w.])((?:dn\s*)?\d+(?:[.,]\d+)?\s*(?:mm|cm|m|in|")|dn\s*\d+)(?!\w)', re.I)


def split_size(name: str) -> tuple[str, str | None]:
    """Take the size out of a name: ``"polyester 160mm"`` is ``("polyester", "160mm")``.

    A number is a size with its unit or with DN, or where it stands alone.
    """
    alone = re.fullmatch(r"\s*\d+(?:[.,]\d+)?\s*", name)
    if alone:
        return "", name.strip()
    found = _SIZE.search(name)
    if found is None:
        return name, None
    return (name[: found.start()] + name[found.end() :]).strip(), found[1]


def words_of(name: str) -> tuple[str, ...]:
    """List the words of a name as they are compared: small, without accents."""
    return tuple(re.findall(r"[\w./\"]+", _letters(name)))


def _letters(name: str) -> str:
    """Bring letters to their plain form; Vietnamese loses its accents, as many type it."""
    apart = unicodedata.normalize("NFD", name.casefold().replace("đ", "d"))
    plain = "".join(each for each in apart if not unicodedata.combining(each))
    return re.sub(r"[\s_-]+", " ", plain).strip()
