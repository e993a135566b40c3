"""An answer as one HTML page that holds all it shows, with a figure's values at the pointer."""

from __future__ import annotations

import base64
import hashlib
import math
from collections.abc import Iterator
from functools import cache
from importlib.resources import files
from typing import TYPE_CHECKING, Any, NamedTuple

from catopt._version import __version__
from catopt.answers.blocks import (
    Answer,
    Block,
    Column,
    Fact,
    Facts,
    Figure,
    FileText,
    Points,
    Step,
    Table,
    Text,
    Trail,
    Value,
    Verdict,
    Warnings,
    exact,
)
from catopt.quantities import GREEK, Quantity
from catopt.render.looks import stylesheet
from catopt.render.svg import svg
from catopt.render.trail import in_numbers, in_symbols
from catopt.render.units import as_wanted
from catopt.render.values import cell, shown
from catopt.words import Language, Message, say

if TYPE_CHECKING:
    from jinja2 import Environment


class _Value(NamedTuple):
    """A text with the value behind it in SI, and the length of its bar."""

    text: str
    si: float | None = None
    bar: float | None = None


class _Cell(NamedTuple):
    """Values with something between them, and the class of the cell."""

    values: tuple[_Value, ...]
    style: str = ""
    between: str = ""


class _Heading(NamedTuple):
    text: str
    is_number: bool = False


class _Table(NamedTuple):
    """A table as plain values."""

    kind: str
    name: str
    caption: str
    headings: tuple[_Heading, ...]
    rows: tuple[tuple[_Cell, ...], ...]
    marked: int | None = None


def page(answer: Answer, language: Language = "en") -> bytes:
    """Render an answer as a page.

    The same answer gives the same bytes: nothing of the place or the hour goes in.

    Sections without a name are left out. The page is complete HTML in UTF-8: it refers to no other
    file and to no network.
    """
    answer, script = as_wanted(answer), _file("script.js")
    made = _environment().get_template("page.html").render(
        language=language,
        version=__version__,
        title=say(answer.title, language),
        kind=say(answer.kind, language),
        sections=_sections(answer, language),
        footer=say(Message("page.footer", version=__version__), language),
        hover=say(Message("page.hover"), language),
        style=stylesheet() + _file("style.css"),
        script=script,
        script_hash=_hash(script),
    )  # fmt: skip
    return made.encode()


def fragment(answer: Answer, language: Language = "en") -> str:
    """Render the sections of an answer that show something, to be put into another page."""
    sections = [each for each in _sections(as_wanted(answer), language) if each["blocks"]]
    template = _environment().get_template("sections.html")
    return template.render(sections=sections, hover=say(Message("page.hover"), language))


def _sections(answer: Answer, language: Language) -> list[dict[str, Any]]:
    return [
        {
            "name": section.name,
            "title": say(section.title, language),
            "blocks": [shown for each in section.blocks for shown in _block(each, language)],
        }
        for section in answer.sections
        if section.name
    ]


@cache
def _environment() -> Environment:
    """Make the templates' environment: all that is put in is escaped, and nothing may lack."""
    from jinja2 import Environment, PackageLoader, StrictUndefined

    return Environment(
        loader=PackageLoader("catopt.render", ""),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )


def _file(name: str) -> str:
    return files("catopt.render").joinpath(name).read_text("utf-8")


def _hash(script: str) -> str:
    """Hash the script, so that the page's own policy runs it and no other."""
    return base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()


# ------------------------------------------------------------------ blocks


def _block(block: Block, language: Language) -> Iterator[Any]:
    """Lay a block out as plain values; nothing of what is not for people."""
    if isinstance(block, Table):
        if block.only in _SEEN and block.length:
            yield from _tables(block, language)
    elif isinstance(block, Facts):
        if block.only in _SEEN:
            yield _facts(block, language)
    elif isinstance(block, Trail):
        yield _trail(block, language)
    elif isinstance(block, Figure):
        caption, figure = say(block.caption, language), svg(block.chart, language)
        yield {"kind": "figure", "caption": caption, "figure": figure}
    elif isinstance(block, FileText):
        yield {"kind": "file", "of": block}
    else:
        yield from _words(block, language)


_SEEN = {"all", "people", "not csv"}


def _words(block: Block, language: Language) -> Iterator[dict[str, Any]]:
    if isinstance(block, Verdict):
        yield _paragraph("", block.words, f"verdict {block.kind}".rstrip(), language)
    elif isinstance(block, Text) and block.only in _SEEN and block.said:
        yield _paragraph(block.caption, block.said, "small" if block.is_small else "", language)
    elif isinstance(block, Points | Warnings) and block.said:
        said = [say(each, language) for each in block.said]
        caption = say(block.caption, language) if isinstance(block, Points) else ""
        style = "" if isinstance(block, Points) else "warnings"
        yield {"kind": "points", "caption": caption, "said": said, "style": style}


def _paragraph(caption: str, said: str, style: str, language: Language) -> dict[str, Any]:
    shown = {"caption": say(caption, language), "said": say(said, language)}
    return {"kind": "text", "style": style, **shown}


def _tables(table: Table, language: Language) -> Iterator[_Table]:
    columns = [each for each in table.columns if each.only not in {"files", "workbook"}]
    headings = tuple(_Heading(_heading(each, language), each.is_number) for each in columns)
    every = range(table.length) if table.shown is None else table.shown
    marked = -1 if table.marked is None else table.marked
    for caption, rows in table.parts or ((table.caption, every),):
        yield _Table(
            "table",
            table.name,
            say(caption, language),
            headings,
            tuple(tuple(_cell(each, row, language) for each in columns) for row in rows),
            list(rows).index(marked) if marked in rows else None,
        )


def _heading(column: Column, language: Language) -> str:
    """Head a column: name, symbol and unit; no unit for a pure number."""
    name, quantity = say(column.name, language), column.quantity
    if quantity is None:
        return name
    label = _label(name, quantity)
    return label if quantity.field_unit == "-" else f"{label} ({quantity.field_unit})"


def _label(name: str, quantity: Quantity | None) -> str:
    symbol = quantity.symbol if quantity else ""
    return f"{name} {GREEK.get(symbol, symbol)}".rstrip()


def _cell(column: Column, row: int, language: Language) -> _Cell:
    value, quantity = column.values[row], column.quantity_of(row)
    is_use = quantity is not None and quantity.key == "utilisation"
    passes = column.passes[row] if column.passes else None
    style = "" if column.is_number else "words"
    if passes is not None:
        style = f"{style} {'passes' if passes else 'fails'}"
    si = _si(value)
    if si is not None and quantity is not None and abs(si) < quantity.floor:
        si = None  # rounding, which is another on each machine
    return _Cell((_Value(cell(column, row, language), si, si if is_use else None),), style)


def _si(value: Value) -> float | None:
    """Return a number that is behind a text; none where it is not known or without bounds."""
    return None if value is None or isinstance(value, str) or not math.isfinite(value) else value


def _facts(block: Facts, language: Language) -> _Table:
    """Lay named values out, those of quantities in SI, too; words alone have no headings."""
    facts = [each for each in block.facts if each.only in _SEEN]
    has_si = any(each.quantity is not None and _is_other(each.quantity) for each in facts)
    rows = tuple(_fact(each, language, has_si=has_si) for each in facts)
    heads = ["page.what", "page.value", *(["page.si"] if has_si else [])]
    only_words = all(isinstance(each.value, str) for each in facts)
    headings = tuple(
        _Heading(say(Message(key), language), k > 0 and not only_words)
        for k, key in enumerate(heads)
    )
    kind = "facts" if only_words and not block.caption else "table"
    return _Table(kind, block.name, say(block.caption, language), headings, rows)


def _is_other(quantity: Quantity) -> bool:
    return quantity.si_unit != quantity.field_unit


def _fact(fact: Fact, language: Language, *, has_si: bool) -> tuple[_Cell, ...]:
    name = _Cell((_Value(_label(say(fact.name, language), fact.quantity)),), "words")
    value, si = fact.value, _si(fact.value)
    ways = (fact.quantity, *(fact.also if si is not None else ()))
    said = " = ".join(shown(value, each, language, unit=True) for each in ways)
    laid = (name, _Cell((_Value(said, si),)))
    if not has_si:
        return laid
    quantity = fact.quantity
    in_si = "" if si is None or quantity is None else _in_si(quantity, si)
    return (*laid, _Cell((_Value(in_si),)))


def _in_si(quantity: Quantity, si: float) -> str:
    """Write a value in SI; where it is printed as zero, what rounding left is none, too."""
    is_zero = quantity.notation == "fixed" and quantity.format(si) == quantity.format(0.0)
    return exact(quantity.si_unit).format(0.0 if is_zero else si, unit=True)


# ------------------------------------------------------------------ trails


def _trail(block: Trail, language: Language) -> _Table:
    """Lay steps out: what comes out, its equation, its numbers put in, and what others have."""
    steps = block.steps
    keys = {
        "page.what": True,
        "page.equation": any(each.equation for each in steps),
        "page.put_in": True,
        "page.value": True,
        block.stated: bool(block.stated),
        "page.source": any(each.source for each in steps),
    }
    wanted = [key for key, is_there in keys.items() if is_there]
    headings = [
        _Heading(
            say(key if key == block.stated else Message(key), language),
            key in {"page.value", block.stated},
        )
        for key in wanted
    ]
    cells = ({key: _step(key, each, block, language) for key in wanted} for each in steps)
    rows = tuple(tuple(row.values()) for row in cells)
    return _Table("table", block.name, say(block.caption, language), tuple(headings), rows)


def _step(key: str, step: Step, block: Trail, language: Language) -> _Cell:
    if key == "page.what":
        return _Cell((_Value(say(step.name, language)),), "words")
    if key == "page.equation":
        return _Cell((_Value(step.equation),))
    if key == "page.put_in":
        lines = [each for each in (in_symbols(step), in_numbers(step)) if each]
        return _Cell((_Value("\n= ".join(lines)),), "formula")
    if key == "page.source":
        return _Cell((_Value(say(step.source, language)),), "words")
    value = step.stated if key == block.stated else step.value
    if value is None:
        return _Cell((_Value("" if key == block.stated else "-"),))
    return _Cell((_Value(step.quantity.format(value, unit=True), value),))
