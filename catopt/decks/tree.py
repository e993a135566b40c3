"""A YAML file as tables that know their lines, and which of their keys were read."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final, Unpack

from catopt.decks.deck import Limits, Notes, refusal
from catopt.documents import check_entries, read_text
from catopt.errors import need_package


@dataclass(frozen=True)
class Item:
    """A value with its line: text, None, a list of items, or a table."""

    row: int
    value: Any


class YamlTable:
    """A mapping: what is read of it is noted, so that the rest can be named.

    `notes` takes problems and remarks; `opened` has all tables of the file that were looked into.
    """

    def __init__(
        self, row: int, items: Mapping[str, Item], notes: Notes, opened: list[YamlTable]
    ) -> None:
        self.row, self.items, self.notes, self.opened = row, items, notes, opened
        self.read: set[str] = set()
        opened.append(self)

    def __contains__(self, key: str) -> bool:
        return key in self.items and self.items[key].value is not None

    def item(self, key: str) -> Item:
        """Return what stands under a key, which counts as read; None where it is not there."""
        self.read.add(key)
        return self.items.get(key, Item(self.row, None))

    def text(self, key: str, default: str = "") -> str:
        """Return a word."""
        found = self.item(key)
        if found.value is None:
            return default
        if not isinstance(found.value, str):
            self.notes.refuse(found.row, key, "one_word")
            return default
        return found.value

    def number(self, key: str, default: float | None = None, **limits: Unpack[Limits]) -> float:
        """Return a number; without a default it has to be there."""
        word = self.text(key)
        if not word and default is not None:
            return default
        if not word:
            self.notes.refuse(self.row, "", "is_missing", name=key)
            return math.nan
        return self.notes.value(self.items[key].row, word, key, **limits)

    def numbers(self, key: str, count: int) -> list[float]:
        """Return a list of numbers, NaN for each that is not given."""
        found = self.item(key)
        words = found.value if isinstance(found.value, list) else []
        if len(words) != count:
            self.notes.refuse(found.row, key, "numbers_are_wanted", count=count)
            return [math.nan] * count
        return [
            math.nan if word.value is None else self.notes.value(word.row, str(word.value), key)
            for word in words
        ]

    def table(self, key: str) -> YamlTable:
        """Return a table, an empty one where there is none."""
        found = self.item(key)
        if found.value is not None and not isinstance(found.value, dict):
            self.notes.refuse(found.row, key, "keys_with_values")
        items = found.value if isinstance(found.value, dict) else {}
        return YamlTable(found.row, items, self.notes, self.opened)

    def items_of(self, key: str) -> list[Item]:
        """Return a list, an empty one where there is none."""
        found = self.item(key)
        if isinstance(found.value, list):
            return found.value
        if found.value is not None:
            self.notes.refuse(found.row, key, "a_list_is_wanted")
        return []

    def tables(self, key: str) -> Iterator[YamlTable]:
        """Yield the tables of a list."""
        for item in self.items_of(key):
            if isinstance(item.value, dict):
                yield YamlTable(item.row, item.value, self.notes, self.opened)
            elif item.value is not None:
                self.notes.refuse(item.row, key, "keys_with_values")

    def named(self, key: str) -> Iterator[tuple[str, YamlTable]]:
        """Yield name and table of each table below, also of one with ``keys`` and ``data``."""
        below = self.table(key)
        for row in below.rows():
            yield row.text("name"), row
        for name in [own for own in below.items if own not in ("keys", "data")]:
            yield name, below.table(name)

    def rows(self) -> Iterator[YamlTable]:
        """Yield the rows of ``keys`` and ``data``, each as a table."""
        heads = [str(item.value) for item in self.items_of("keys")]
        yield from self._rows(heads, self.items_of("data"))

    def columns(self, first: str) -> Iterator[YamlTable]:
        """Yield the rows below a key that names its columns, ``A, B, C``, by its first."""
        for key in [name for name in self.items if name.split(",")[0].strip() == first]:
            heads = [head.strip() for head in key.split(",")]
            yield from self._rows(heads, self.items_of(key))

    def _rows(self, heads: list[str], lines: list[Item]) -> Iterator[YamlTable]:
        for line in lines:
            values = line.value if isinstance(line.value, list) else [line]
            if len(values) > len(heads):
                given = refusal("values", count=len(values))
                self.notes.refuse(line.row, given, "wanted_count", count=len(heads))
            items = dict(zip(heads, values, strict=False))
            yield YamlTable(line.row, items, self.notes, self.opened)

    def say_unread(self, groups: Mapping[str, str]) -> None:
        """Name every key of the file that was not read, by the group that says why.

        `groups`: pattern of a group's keys, by the key of its remark; the first that fits is said.
        """
        found: dict[str, dict[str, list[int]]] = {}
        reported = {id(t.items[key]) for t in self.opened for key in t.read if key in t.items}
        for table in self.opened:
            for key, item in table.items.items():
                if id(item) not in reported and item.value is not None:
                    reported.add(id(item))
                    first = key.split(",")[0].strip()
                    fits = (name for name, keys in groups.items() if re.search(keys, first))
                    group = found.setdefault(next(fits, "unread_unknown"), {})
                    group.setdefault(first, []).append(item.row)
        for name, keys in sorted(found.items()):
            listed = (
                f"{key} ({rows[0]})"
                if len(rows) == 1
                else f"{key} ({rows[0]} and {len(rows) - 1} more)"
                for key, rows in keys.items()
            )
            self.notes.say(name, keys=", ".join(listed))


def parse_yaml(text: str, notes: Notes) -> YamlTable:
    """Read a YAML file whose top is a mapping.

    Raises InputError for what is no YAML, and where PyYAML is not installed.
    """
    need_package("PyYAML", "yaml", notes.source, module="yaml")
    import yaml

    check_entries(text, notes.source, ":,[{-")
    found = Item(1, None)
    try:
        node = yaml.compose(text, Loader=yaml.SafeLoader)
        found = _item(node, notes, set()) if node is not None else found
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        row = mark.line + 1 if mark is not None else 0
        notes.refuse(row, "", "yaml", said=getattr(error, "problem", None) or f"{error}")
    except RecursionError:
        notes.refuse(0, "", "nests_too_deeply")
    found = _with_included(found, notes)
    if not notes.problems and not isinstance(found.value, dict):
        notes.refuse(found.row, "", "keys_with_values")
    notes.raise_if_any()
    return YamlTable(found.row, found.value, notes, [])


_INCLUDE: Final = "includefile"
_MOST_INCLUDED: Final = 100
"""Files that a deck takes in."""


def _with_included(top: Item, notes: Notes) -> Item:
    """Put what included files hold in the place of their names; the tables of a list are joined.

    What stands in an included file has the line of this file that names it.
    """
    taken: list[str] = []
    found = _resolved(top, Path(notes.source).parent, notes, taken)
    if taken:
        notes.say("included", files=", ".join(taken))
    if isinstance(found.value, list) and found.value:
        found = Item(found.row, _joined(found.value))
    return found


def _resolved(item: Item, folder: Path, notes: Notes, taken: list[str]) -> Item:
    """Take in the files that an item names, from a folder, and add them to those `taken`."""
    if isinstance(item.value, list):
        parts: list[Item] = []
        for part in item.value:
            inner = _resolved(part, folder, notes, taken)
            is_file = isinstance(part.value, dict) and _included(part.value) is not None
            parts += inner.value if is_file and isinstance(inner.value, list) else [inner]
        return Item(item.row, parts)
    if not isinstance(item.value, dict):
        return item
    name = _included(item.value)
    if name is not None:
        return _taken_in(item.row, name, folder, notes, taken)
    inside = {key: _resolved(v, folder, notes, taken) for key, v in item.value.items()}
    return Item(item.row, inside)


def _taken_in(row: int, name: str, folder: Path, notes: Notes, taken: list[str]) -> Item:
    """Read the file that a line names."""
    import yaml

    path = folder / name.replace("\\", "/")
    taken.append(name)
    if len(taken) > _MOST_INCLUDED:
        notes.refuse(row, name, "too_many_files", most=_MOST_INCLUDED)
        notes.raise_if_any()
    if not path.is_file():
        notes.refuse(row, name, "no_such_file", path=str(path))
        return Item(row, None)
    text = read_text(path, str(path), kind="input file", broken=True)
    check_entries(text, str(path), ":,[{-")
    try:
        node = yaml.compose(text, Loader=yaml.SafeLoader)
    except yaml.YAMLError as error:
        notes.refuse(row, name, "yaml", said=getattr(error, "problem", None) or f"{error}")
        return Item(row, None)
    inside = Item(row, None) if node is None else _at_row(row, _item(node, notes, set()))
    return _resolved(inside, path.parent, notes, taken)


def _included(table: Mapping[str, Item]) -> str | None:
    """Name the file that stands for a table; None where it is a table of its own."""
    (key, item), *others = table.items() or [("", Item(0, None))]
    is_one = not others and key.lower() == _INCLUDE and isinstance(item.value, str)
    return str(item.value) if is_one else None


def _at_row(row: int, item: Item) -> Item:
    """Put all of another file in the line of this one that names it."""
    if isinstance(item.value, list):
        return Item(row, [_at_row(row, part) for part in item.value])
    if isinstance(item.value, dict):
        return Item(row, {key: _at_row(row, part) for key, part in item.value.items()})
    return Item(row, item.value)


def _joined(parts: list[Item]) -> dict[str, Item] | None:
    """Join the tables of a list into one; of one key lists follow each other; else None."""
    found: dict[str, Item] = {}
    for part in parts:
        if part.value is None:
            continue
        if not isinstance(part.value, dict):
            return None
        for key, item in part.value.items():
            own = found.get(key)
            if own is not None and isinstance(own.value, list) and isinstance(item.value, list):
                item = Item(own.row, [*own.value, *item.value])
            elif own is not None and isinstance(own.value, dict) and isinstance(item.value, dict):
                item = Item(own.row, own.value | item.value)
            found[key] = item
    return found


def _item(node: Any, notes: Notes, seen: set[int]) -> Item:
    """Turn a node of PyYAML into an item; an alias, which lets a small file grow, is refused."""
    row = node.start_mark.line + 1
    if node.id == "scalar":
        return Item(row, None if node.tag.endswith(":null") else str(node.value))
    if id(node) in seen:
        notes.refuse(row, refusal("alias"), "alias_written_out")
        return Item(row, None)
    seen.add(id(node))
    if node.id == "sequence":
        return Item(row, [_item(part, notes, seen) for part in node.value])
    found: dict[str, Item] = {}
    for key, value in node.value:
        name = " ".join(str(key.value).split())
        kept, line = _item(value, notes, seen), key.start_mark.line + 1
        if name in found:
            notes.say("twice", line=line, key=name, value=str(kept.value)[:40])
        found[name] = Item(line, kept.value)
    return Item(row, found)
