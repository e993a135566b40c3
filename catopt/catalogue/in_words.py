"""A size of a component in the words of the field."""

from __future__ import annotations

from types import MappingProxyType
from typing import Final

from catopt.words import Message

_LINKS: Final = MappingProxyType(
    {
        "open-link": "catalogue.open_link",
        "studless": "catalogue.studless",
        "stud-link": "catalogue.stud_link",
    }
)
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
