"""Kinds of line: chain, wire rope and fibre rope, which codes have factors of their own for."""

from __future__ import annotations

from typing import Literal, get_args

LineKind = Literal["chain", "wire", "rope"]
"""Chain, steel wire rope of any make, fibre rope."""

LINE_KINDS: tuple[LineKind, ...] = get_args(LineKind)

_WORDS: dict[LineKind, tuple[str, ...]] = {
    "chain": ("chain",),
    "wire": ("wire", "spiral"),
    "rope": (
        "rope",
        "polyester",
        "nylon",
        "polyamide",
        "polypropylene",
        "polyethylene",
        "hmpe",
        "aramid",
    ),
}
"""Words of a component's name by the kind they tell; wire comes before rope, for "wire rope"."""


def line_kind(component: str) -> LineKind | None:
    """Tell the kind of line from the name of a component; None when it does not tell it."""
    name = component.casefold()
    return next((kind for kind, words in _WORDS.items() if any(w in name for w in words)), None)
