"""Checked access to a TOML table: what is wrong becomes a problem with its key path."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, TypeVar

from catopt.catalogue.family import meant, nearest
from catopt.documents import parse_toml
from catopt.model.kinds import Findings
from catopt.units import as_written
from catopt.words import LANGUAGES, Cited, Message, Translated

Word = TypeVar("Word", bound=str)

_MM = 1e3


class TomlTable:
    """A table of a file, as the TOML reader returns it, with the path at which it stands.

    Such as ``figure[3]``; empty for the file itself.
    """

    def __init__(self, values: dict[str, Any], path: str, findings: Findings) -> None:
        self.values = values
        self.path = path
        self._findings = findings

    @classmethod
    def of_file(
        cls, text: str, source: str, schema: str, keys: Sequence[str]
    ) -> tuple[TomlTable, Findings]:
        """Read the text of a file of one schema; note what is wrong with its top.

        The keys are those that may stand beside ``schema``; the source names the file in messages.
        """
        findings = Findings(source)
        table = cls(parse_toml(text, source), "", findings)
        table.only("schema", *keys)
        if table.text("schema") not in {schema, None}:
            table.problem("schema", Message("refused_case.word_is_wanted", word=schema))
        return table, findings

    def problem(self, key: str, allowed: str) -> None:
        """Note what is wrong with the value of a key."""
        found = as_written(self.values[key]) if key in self.values else ""
        missing = Message("refused.missing", wanted=allowed)
        self._findings.add(self.at(key), found, allowed if found else missing)

    def at(self, key: str) -> str:
        """Path of a key."""
        return f"{self.path}.{key}" if self.path else key

    def has(self, key: str) -> bool:
        """Whether a key is there."""
        return key in self.values

    def only(self, *keys: str) -> None:
        """Note a problem for each key that does not belong here."""
        for key in self.values:
            if key not in keys:
                near = nearest(key, keys)
                hint = Message("refused.allowed_here", keys=", ".join(keys))
                if near:
                    hint = Message("refused.did_you_mean", near=near)
                self._findings.add(self.at(key), Message("refused.unknown_key"), hint)

    def text(self, key: str, *, required: bool = True) -> str | None:
        """Read a text that is not empty."""
        value = self.values.get(key)
        if value is None and not required:
            return None
        if not isinstance(value, str) or not value.strip():
            self.problem(key, Message("refused.text"))
            return None
        return value

    def said(self, key: str, *, required: bool = True) -> str | None:
        """Read a text in one language, a user's own words, or in all: ``{ en = "", vi = "" }``."""
        value = self.values.get(key)
        if not isinstance(value, dict):
            return self.text(key, required=required)
        if set(value) != set(LANGUAGES) or not all(isinstance(v, str) for v in value.values()):
            self.problem(key, Message("refused.text_for_each", words=", ".join(LANGUAGES)))
            return None
        return Translated(value)

    def cited(self, key: str) -> str | None:
        """Read what is cited as it is printed; catopt's own words are in all languages."""
        said = self.said(key)
        return said if said is None or isinstance(said, Translated) else Cited(said)

    def word(self, key: str, words: Sequence[Word]) -> Word | None:
        """Read one of some words."""
        value = self.values.get(key)
        for each in words:
            if value == each:
                return each
        allowed = Message("refused.one_of", words=", ".join(words))
        self.problem(key, meant(allowed, value, words) if isinstance(value, str) else allowed)
        return None

    def flag(self, key: str) -> bool | None:
        """Read true or false; None when it is left out."""
        value = self.values.get(key)
        if value is not None and not isinstance(value, bool):
            self.problem(key, Message("refused.flag"))
            return None
        return value

    def texts(self, key: str, *, required: bool = False) -> tuple[str, ...]:
        """Read one text or an array of texts."""
        value = self.values.get(key)
        if value is None and not required:
            return ()
        listed = [value] if isinstance(value, str) else value
        right = isinstance(listed, list) and all(isinstance(e, str) and e.strip() for e in listed)
        if not right or not listed or len(set(listed)) < len(listed):
            self.problem(key, Message("refused.different_texts"))
            return ()
        return tuple(listed)

    def number(self, key: str, *, above: float | None = None) -> float | None:
        """Read a number."""
        return self._number(self.values.get(key), self.at(key), above=above)

    def numbers(self, key: str, count: int) -> tuple[float, ...] | None:
        """Read an array of so many numbers."""
        value = self.values.get(key)
        if not isinstance(value, list) or len(value) != count:
            self.problem(key, Message("refused.array_of_numbers", count=count))
            return None
        read = [self._number(each, f"{self.at(key)}[{i}]") for i, each in enumerate(value)]
        known = tuple(each for each in read if each is not None)
        return known if len(known) == count else None

    def span_mm(self, key: str) -> tuple[float, float] | None:
        """Read a range of diameters, ``[19, 185]`` in mm; returned in m."""
        span = self.numbers(key, 2)
        if span is None:
            return None
        if not 0.0 < span[0] < span[1]:
            self.problem(key, Message("refused_file.two_diameters"))
            return None
        return span[0] / _MM, span[1] / _MM

    def rising(self, key: str, what: str = "") -> tuple[float, ...]:
        """Read an array of rising numbers above 0."""
        value = self.values.get(key)
        if not isinstance(value, list) or not value:
            what = what or Message("refused_file.numbers")
            self.problem(key, Message("refused_file.an_array", what=what))
            return ()
        read = self.numbers(key, len(value)) or ()
        if any(not low < high for low, high in zip((0.0, *read), read, strict=False)):
            self.problem(key, Message("refused_file.rise_above_zero"))
        return read

    def rising_mm(self, key: str) -> tuple[float, ...]:
        """Read an array of rising diameters in mm; returned in m."""
        diameters = self.rising(key, Message("refused_file.diameters_in_mm"))
        return tuple(each / _MM for each in diameters)

    def rows(self, key: str) -> list[tuple[float, float]]:
        """Read an array of at least two pairs of positive numbers, the first of each rising."""
        value = self.values.get(key)
        if not isinstance(value, list) or len(value) < 2:
            self.problem(key, Message("refused_file.two_rows"))
            return []
        read: list[tuple[float, float]] = []
        for index, row in enumerate(value):
            at = f"{self.at(key)}[{index}]"
            if not isinstance(row, list) or len(row) != 2:
                allowed = Message("refused_sizing.row_diameter_mm_value_wanted")
                self._findings.add(at, as_written(row), allowed)
                continue
            first, second = (self._number(each, at, above=0.0) for each in row)
            if first is not None and second is not None:
                if read and not first > read[-1][0]:
                    allowed = Message("refused_sizing.diameters_rows_must_rise")
                    self._findings.add(at, f"{first:g} mm", allowed)
                read.append((first, second))
        return read

    def table(self, key: str) -> TomlTable | None:
        """Go into a table; None when it is left out."""
        value = self.values.get(key)
        if value is None:
            return None
        if not isinstance(value, dict):
            self.problem(key, Message("refused.table"))
            return None
        return TomlTable(value, self.at(key), self._findings)

    def tables(self, key: str, *, required: bool = True) -> list[TomlTable]:
        """Go into an array of tables."""
        value = self.values.get(key)
        if value is None and not required:
            return []
        if not isinstance(value, list) or not all(isinstance(each, dict) for each in value):
            self.problem(key, Message("refused_file.tables", key=key))
            return []
        return [TomlTable(e, f"{self.at(key)}[{i}]", self._findings) for i, e in enumerate(value)]

    def named(self, key: str) -> Iterator[tuple[str, TomlTable]]:
        """Go into a table of tables."""
        within = self.table(key)
        if within is None:
            return
        for name in within.values:
            table = within.table(name)
            if table is not None:
                yield name, table

    def _number(self, value: object, at: str, *, above: float | None = None) -> float | None:
        """Read one number, bare: the unit is in the key or in the form of the formula."""
        before = len(self._findings.problems)
        self._findings.number(at, value, "", above=above)
        if len(self._findings.problems) > before:
            return None
        assert isinstance(value, (int, float))
        return float(value)
