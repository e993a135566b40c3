"""Documents follow from a class's annotations, however Python keeps them."""

from __future__ import annotations

from typing import Any, NamedTuple

from catopt.model.kinds import Force
from catopt.records import Record


class Part(NamedTuple):
    """Its namespace has no annotations on Python 3.14."""

    name: str
    pull: Force


class Lazy(type):
    """Makes the annotations of its classes when they are asked for, as Python 3.14 does."""

    def __new__(cls, name: str, bases: tuple[type, ...], inside: dict[str, Any]) -> Lazy:
        kept = inside.pop("__annotations__", {})
        made = super().__new__(cls, name, bases, inside)
        _KEPT[made] = kept
        return made

    @property
    def __annotations__(cls) -> dict[str, Any]:  # type: ignore[override]
        return _KEPT.get(cls, {})


_KEPT: dict[type, dict[str, Any]] = {}


class Whole(Record, metaclass=Lazy):
    """Of a force and parts."""

    DOCUMENT = "tension parts(name pull) first.pull=first"

    tension: Force
    parts: tuple[Part, ...]
    first: Part

    def __init__(self) -> None:
        self.tension, self.first = 5.0, Part("a", 1.0)
        self.parts = (self.first, Part("b", 2.0))


def test_annotations_that_are_made_when_asked_for_are_found() -> None:
    assert "__annotations__" not in vars(Whole)
    assert Whole().to_dict() == {
        "tension_N": 5.0,
        "parts": [{"name": "a", "pull_N": 1.0}, {"name": "b", "pull_N": 2.0}],
        "first": 1.0,
    }
