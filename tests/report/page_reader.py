"""A page of catopt read back from its HTML: a calculation note, or an answer of the desk."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field
from html.parser import HTMLParser
from typing import Any

VOID = {"meta", "link", "br", "img", "input", "hr"}


@dataclass
class ReadCell:
    """A cell: its text, and the value behind it."""

    text: str = ""
    value: Any = None


@dataclass
class ReadTable:
    """A table of the page."""

    key: str
    headings: list[str] = field(default_factory=list)
    rows: list[list[ReadCell]] = field(default_factory=list)
    marked: list[int] = field(default_factory=list)
    caption: str = ""

    def row(self, first: str) -> list[ReadCell]:
        """Return the row with a first cell."""
        return self.by_name()[first]

    def by_name(self) -> dict[str, list[ReadCell]]:
        """Return all rows by their first cells."""
        return {row[0].text: row for row in reversed(self.rows)}

    def column(self, heading: str) -> list[Any]:
        """Return the values below a heading."""
        index = self.headings.index(heading)
        return [row[index].value for row in self.rows]

    def texts(self) -> list[list[str]]:
        """Return what all cells show."""
        return [[cell.text for cell in row] for row in self.rows]


@dataclass
class Element:
    """An element with its attributes and the section that it stands in."""

    tag: str
    attributes: dict[str, str]
    section: str
    text: str = ""


@dataclass
class ReadPage:
    """A page: its tables, its elements, and the text of each section."""

    tables: list[ReadTable] = field(default_factory=list)
    elements: list[Element] = field(default_factory=list)
    sections: dict[str, str] = field(default_factory=dict)
    unclosed: list[str] = field(default_factory=list)

    def table(self, key: str) -> ReadTable:
        """Return the only table of a key."""
        (found,) = self.all(key)
        return found

    def all(self, key: str) -> list[ReadTable]:
        """Return all tables of a key."""
        return [table for table in self.tables if table.key == key]

    def tagged(self, tag: str, section: str = "") -> list[Element]:
        """Return all elements of a tag, in a section when one is given."""
        return [e for e in self.elements if e.tag == tag and section in ("", e.section)]

    def styled(self, style: str, section: str = "") -> list[Element]:
        """Return all elements of a class, in a section when one is given."""
        there = [each for each in self.elements if section in ("", each.section)]
        return [each for each in there if style in each.attributes.get("class", "").split()]


class _Reader(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.page = ReadPage()
        self._open: list[Element] = []
        self._section = ""

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.handle_starttag(tag, attrs)
        if tag not in VOID:
            self._open.pop()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = {key: value or "" for key, value in attrs}
        if tag == "section" and "id" in given:
            self._section = given["id"]
            self.page.sections[self._section] = ""
        element = Element(tag, given, self._section)
        self.page.elements.append(element)
        tables = self.page.tables
        if tag == "table":
            tables.append(ReadTable(given.get("data-key", "")))
        elif tag == "tr" and not self._inside("thead"):
            if "marked" in given.get("class", ""):
                tables[-1].marked.append(len(tables[-1].rows))
            tables[-1].rows.append([])
        elif tag in ("td", "th") and not self._inside("thead"):
            tables[-1].rows[-1].append(ReadCell())
        elif tag == "th":
            tables[-1].headings.append("")
        elif tag == "data":
            tables[-1].rows[-1][-1].value = float(given["value"])
        if tag not in VOID:
            self._open.append(element)

    def handle_endtag(self, tag: str) -> None:
        while self._open:
            last = self._open.pop()
            if last.tag == tag:
                break
            self.page.unclosed.append(last.tag)
        else:
            self.page.unclosed.append(f"/{tag}")
        if tag == "section":
            self._section = ""

    def handle_data(self, data: str) -> None:
        if not self._open:
            return
        here = self._open[-1]
        here.text += data
        if here.tag in ("script", "style"):
            return
        if self._section:
            self.page.sections[self._section] += data
        if self._inside("thead") and self._inside("th"):
            self.page.tables[-1].headings[-1] += data
        elif self._inside("td") or self._inside("th"):
            self.page.tables[-1].rows[-1][-1].text += data
        elif here.tag == "caption":
            self.page.tables[-1].caption += data

    def _inside(self, tag: str) -> bool:
        return any(element.tag == tag for element in self._open)


def read_page(page: bytes | str) -> ReadPage:
    """Read a page; white space at the ends of cells is dropped."""
    reader = _Reader()
    reader.feed(page if isinstance(page, str) else page.decode())
    reader.close()
    for table in reader.page.tables:
        for row in table.rows:
            for cell in row:
                cell.text = cell.text.strip()
    return reader.page


def calculate(printed: str) -> float:
    """Type an expression of a page, with its numbers put in, into a calculator."""
    signs = {"\N{NO-BREAK SPACE}": " ", "−": "-", "·": "*", "²": "**2", "^": "**", "√": "sqrt"}
    for sign, plain in signs.items():
        printed = printed.replace(sign, plain)
    text = re.sub(r"tan (\S+)°", r"tan(radians(\1))", printed)
    text = re.sub(r"asinh (\(?-?[\d.e+-]+\)?)", r"asinh(\1)", text)
    # What stands side by side is multiplied.
    text = re.sub(r"(?<=[\d)]) (?=sqrt|asinh|\()", "*", text)
    names = {key: getattr(math, key) for key in ("sqrt", "asinh", "atan", "tan", "radians")}
    return float(eval(text, {"__builtins__": {}, "max": max, **names}))
