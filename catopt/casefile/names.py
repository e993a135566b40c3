"""What a user may have meant by a key that a table does not have."""

from __future__ import annotations

from collections.abc import Iterator

from catopt.casefile.location import header
from catopt.casefile.schema import CaseTable, Table, VariantsTable, entries
from catopt.documents import Path
from catopt.words import Message

_SIMILAR = 0.6
"""Share of letters in common (difflib's ratio) from which a key counts as misspelt."""

_SHORT = 4
"""Letters of a word that is another word when its first letter is another: wind is not find."""


def nearest(table: type[Table], key: str, top: type[Table] = CaseTable) -> str | None:
    """Return the key of `table` that `key` is a misspelling of or the symbol for, if any.

    `top` is the schema of the whole file.
    """
    own = list(entries(table))
    if key in table.symbols:
        return table.symbols[key]
    by_plain = {_plain(known): known for known in own}
    if _plain(key) in by_plain:
        return by_plain[_plain(key)]
    plain = _plain(key)
    longer = [known for known in own if known.endswith(f"_{plain}")]
    if len(longer) == 1:
        return longer[0]  # friction for seabed_friction
    if any(_elsewhere(key, top)):
        return None  # right elsewhere, so hardly a misspelling
    from difflib import get_close_matches

    likely = [known for known in by_plain if len(plain) > _SHORT or known[1:] != plain[1:]]
    close = get_close_matches(plain, likely, n=1, cutoff=_SIMILAR)
    return by_plain[close[0]] if close else None


def stands_for(table: type[Table], key: str, top: type[Table] = CaseTable) -> str | None:
    """Return the key of `table` that a key it does not have was to give, if any."""
    return table.later[key] if key in table.later else nearest(table, key, top)


def hint(table: type[Table], key: str, top: type[Table] = CaseTable) -> str:
    """Say what to do about a key that `table` does not have."""
    near = nearest(table, key, top)
    if near is not None:
        return Message("refused.did_you_mean", near=near)
    places = list(_elsewhere(key, top))
    if places:
        *others, last = places
        if not others:
            return Message("refused.move", place=last)
        return Message("refused.move_or", places=", ".join(others), last=last)
    return Message("refused.allowed_here", keys=", ".join(entries(table)))


def _plain(key: str) -> str:
    return key.casefold().replace("-", "_").replace(" ", "_")


def _elsewhere(
    key: str, table: type[Table], path: Path = (), *, array: bool = False
) -> Iterator[str]:
    """List the tables in which `key` would be right, by the lines that open them."""
    for name, entry in entries(table).items():
        below = (*path, name)
        if table is VariantsTable:
            continue  # its keys are names of quantities
        if name == key:
            is_table = entry.table is not None
            yield header(below, array=entry.array) if is_table else header(path, array=array)
        if entry.table is not None:
            yield from _elsewhere(key, entry.table, below, array=entry.array)
