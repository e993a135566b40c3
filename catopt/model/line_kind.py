"""Chain, steel wire rope or fibre rope: told by the name of a component."""

from __future__ import annotations

from typing import Literal, get_args

LineKind = Literal["chain", "wire", "rope"]
"""Chain, steel wire rope of any make, fibre rope: codes have factors of their own for each."""
LINE_KINDS: tuple[LineKind, ...] = get_args(LineKind)

_ROPES = "rope polyester nylon polyamide polypropylene polyethylene hmpe aramid"
_WORDS: dict[LineKind, str] = {"chain": "chain", "wire": "wire spiral", "rope": _ROPES}
"""Words in a component's name by the kind of line; wire comes before rope, for "wire rope"."""


def line_kind(component: str) -> LineKind | None:
    """Return the kind of line by the name of a component; None when it does not say."""
    name = component.casefold()
    for kind, words in _WORDS.items():
        if any(word in name for word in words.split()):
            return kind
    return None
