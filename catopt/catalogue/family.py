"""A family of components: one kind of chain or rope in its grades and sizes, and their names."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import cache
from typing import Final, NamedTuple

from catopt.catalogue.components import RECALLED, Confidence, Figure, Source
from catopt.errors import refused
from catopt.model.kinds import Length
from catopt.records import Record
from catopt.units import as_written
from catopt.words import Message, typed_name


def in_mm(diameter: float) -> str:
    """Write a diameter in m as makers do: ``76 mm``."""
    return f"{round(diameter * 1e3, 6):g} mm"


@dataclass(frozen=True)
class Sizes:
    """Nominal diameters that are sold.

    A list of sizes is no figure of strength, so that a recalled one is used, and says so.
    """

    diameters: tuple[Length, ...] = ()
    """Nominal diameters that are sold, rising; none when the list is not known."""
    sources: tuple[Source, ...] = ()
    """Documents that list them, at `place`."""
    place: str = ""
    confidence: Confidence = RECALLED
    """Of the list of sizes."""

    @property
    def source_keys(self) -> tuple[str, ...]:
        """Keys of the sources that list them."""
        return tuple(source.key for source in self.sources)

    @property
    def is_recalled(self) -> bool:
        """Whether the list was read in no document."""
        return self.confidence == RECALLED


@dataclass(frozen=True)
class Family(Record):
    """One kind of chain or rope."""

    DOCUMENT = (
        "name title also grades range sizes.diameters=sizes_m sizes.confidence=sizes_confidence "
        "sizes.source_keys=sizes_sources note figures"
    )

    name: str
    """By which it is looked up."""
    title: str
    """In words."""
    also: tuple[str, ...]
    """Other names for it."""
    grades: tuple[str, ...]
    """From the weakest to the strongest; empty when there are none."""
    range: tuple[Length, Length]
    """Smallest and largest nominal diameter."""
    sizes: Sizes
    figures: tuple[Figure, ...]
    """All figures, in the order of the file."""
    note: str = ""
    """What else to know; may be empty."""
    _by_quantity: dict[str, list[Figure]] = field(
        default_factory=dict, init=False, repr=False, compare=False
    )

    def __post_init__(self) -> None:
        for figure in sorted(self.figures, key=lambda figure: not figure.default):
            self._by_quantity.setdefault(figure.quantity, []).append(figure)

    def alternatives(self, quantity: str, grade: str | None) -> tuple[Figure, ...]:
        """List the figures of a quantity that hold for a grade, the default first."""
        return tuple(f for f in self._by_quantity.get(quantity, ()) if f.holds_for(grade))

    def default(self, quantity: str, grade: str | None) -> Figure | None:
        """Find the figure that is used when no variant is named; None when there is none."""
        return next((f for f in self.alternatives(quantity, grade) if f.default), None)

    @property
    def names(self) -> Iterator[str]:
        """Its name and its other names."""
        yield self.name
        yield from self.also

    @property
    def known_range(self) -> Message:
        """The range in words: ``from 19 mm to 185 mm``."""
        return Message("catalogue.from_to", low=in_mm(self.range[0]), high=in_mm(self.range[1]))


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
    if isinstance(name, str):
        plain = _plain(name) if _plain(name) in found else _plain(typed_name(name))
        if plain in found:
            return found[plain]
    near = nearest(name, [shown for _, shown, _ in names]) if isinstance(name, str) else None
    allowed = Message("refused.no_component")
    if near:
        allowed = Message("refused.did_you_mean", near=f'"{near}"')
    elif names:
        allowed = Message("refused.component", example=f'"{names[0][1]}"')
    raise refused("component", as_written(name), allowed)


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
    """Say what is required, and ask after the word that was meant if one is near."""
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
    if re.fullmatch(r"\s*\d+(?:[.,]\d+)?\s*", name):
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


_LINKS: Final = {
    "open-link": "catalogue.open_link",
    "studless": "catalogue.studless",
    "stud-link": "catalogue.stud_link",
}
"""How the links of chains are called."""


def chain_words(component: str, diameter: float | None) -> Message:
    """Say a component and its nominal diameter, m.

    Examples
    --------
    >>> print(chain_words("chain studless R3", 0.073))
    73 mm studless chain R3
    """
    size = 0.0 if diameter is None else round(1e3 * diameter, 6)
    what, _, rest = component.partition(" ")
    links, _, grade = rest.partition(" ")
    if what != "chain" or not grade or links not in _LINKS:
        return Message("catalogue.of_size", component=component, size=size)
    return Message("catalogue.chain_of_size", links=Message(_LINKS[links]), grade=grade, size=size)
