"""An answer as one HTML page that holds all it shows."""

from __future__ import annotations

import base64
import hashlib
import json
import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import cache
from importlib.resources import files
from typing import Any, Final, NamedTuple

from jinja2 import Environment, PackageLoader, StrictUndefined, Template

from catopt._version import identity
from catopt.answers.blocks import (
    Answer,
    Block,
    Column,
    Fact,
    Facts,
    Figure,
    FileText,
    PageHead,
    Points,
    Section,
    Step,
    Table,
    Text,
    Trail,
    Verdict,
    Warnings,
    exact,
)
from catopt.figures.chart import Film
from catopt.quantities import GREEK
from catopt.render.svg import stylesheet, svg
from catopt.render.values import SEEN, as_text, as_wanted, cell, in_language, is_seen, parts_of
from catopt.words import Language, Message, say

_MOST = 12
"""Terms of a sum that are all written out; of more, its first two and its last are."""
_POWERS = {"2": "²", "3": "³"}
_TIMES = "\u00a0· "
"""Does not begin a line."""


class _Symbol(str):
    """A symbol, Greek letters as such; of how its number is written its power counts alone."""

    __slots__ = ()

    def __format__(self, spec: str) -> str:
        return GREEK.get(self, str(self)) + _POWERS.get(spec, "")


class _Number(float):
    """A number as it is put in; one that is multiplied has brackets where it is negative."""

    digits = 9
    is_factor = False

    def __format__(self, spec: str) -> str:
        if self.is_factor:
            spec = spec or "()"
        shown = _digits(0.0 + self, self.digits)
        if (spec == "()" or spec in _POWERS) and (self < 0.0 or "e" in shown):
            shown = f"({shown})"
        return shown + ("°" if spec == "°" else _POWERS.get(spec, ""))


def put_in(step: Step) -> str:
    """Write the formula, and below it the same with its numbers; empty where there is neither."""
    return "\n= ".join(each for each in (in_symbols(step), in_numbers(step)) if each)


def in_symbols(step: Step) -> str:
    """Write the formula: ``"a = H / w"``."""
    formula = step.formula if isinstance(step.formula, str) else " ".join(step.formula)
    said = formula.format(**{symbol: _Symbol(symbol) for symbol in step.numbers})
    return " = ".join(each for each in (step.symbol, said) if each)


def in_numbers(step: Step) -> str:
    """Put the numbers in: ``"4000 / 245"``; empty where there are none."""
    if step.terms:
        terms = [" · ".join(_digits(each, step.digits) for each in of) for of in step.terms]
        shown = terms if len(terms) <= _MOST else (*terms[:2], "…", terms[-1])
        return " + ".join(shown).replace("+ −", "− ")
    is_product = not isinstance(step.formula, str)
    numbers = {symbol: _Number(value) for symbol, value in step.numbers.items()}
    for each in numbers.values():
        each.digits, each.is_factor = step.digits, is_product
    formula = _TIMES.join(step.formula) if is_product else str(step.formula)
    return formula.format(**numbers) if numbers else ""


def _digits(value: float, digits: int) -> str:
    """Write a number with so many digits; with nine it can be put in again."""
    return replace(exact(""), digits=digits).format(value).replace("-", "−")


class _Cell(NamedTuple):
    """A text with its class, the value behind it in SI, and the length of its bar."""

    text: str
    style: str = ""
    si: float | None = None
    bar: float | None = None


class _Heading(NamedTuple):
    text: str
    is_number: bool = False


class _LaidTable(NamedTuple):
    """A table as plain values."""

    kind: str
    name: str
    caption: str
    headings: Sequence[_Heading]
    rows: Sequence[Sequence[_Cell]]
    marked: int | None = None


class _Words(NamedTuple):
    """A paragraph, or several points."""

    kind: str
    said: str | Sequence[str]
    caption: str = ""
    style: str = ""


def page(answer: Answer, language: Language = "en") -> bytes:
    """Render an answer as a page.

    The same answer gives the same bytes: nothing of the place or the hour goes in. Sections without
    a name are left out. The page is complete HTML in UTF-8: it refers to no other file and to no
    network.
    """
    answer = as_wanted(answer, language)
    return whole_page(
        "page.html",
        language,
        script=file_text("script.js"),
        style=_on_every_page(answer),
        title=answer.title,
        kind=answer.kind,
        sections=_sections(answer, language),
        contents=say(Message("page.contents"), language) if answer.kind else "",
        head=answer.head,
        footer=say(Message("page.footer", version=identity()), language),
        hover=say(Message("page.hover"), language),
    )


def _on_every_page(answer: Answer) -> str:
    """Write the style of what stands in the margins of every printed page."""
    head = answer.head or PageHead("", "")
    corners = {
        "top-left": _quoted(head.firm or answer.title),
        "top-right": _quoted(head.number),
        "bottom-left": _quoted(answer.title if head.firm else ""),
        "bottom-right": 'counter(page) " / " counter(pages)',
    }
    said = " ".join(f"@{place} {{ content: {words}; }}" for place, words in corners.items())
    return f"@page {{ {said} }}\n"


def _quoted(text: str) -> str:
    """Write a text as a string of a style sheet, whatever is in it."""
    return '"' + "".join(c if c.isalnum() or c == " " else f"\\{ord(c):x} " for c in text) + '"'


def whole_page(
    name: str, language: Language, *, script: str, style: str = "", **values: Any
) -> bytes:
    """Render a template of a page that refers to no other file; `style` adds to that of all."""
    # The page's own policy runs the script of this hash and no other.
    script_hash = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
    rendered = template("catopt.render", name).render(
        language=language,
        version=identity(),
        style=stylesheet() + file_text("style.css") + style,
        script=script,
        script_hash=script_hash,
        **values,
    )
    return rendered.encode()


def fragment(answer: Answer, language: Language = "en") -> str:
    """Render the sections of an answer that show something, to be put into another page."""
    laid = _sections(as_wanted(answer, language), language)
    shown, hover = [each for each in laid if each.blocks], say(Message("page.hover"), language)
    return template("catopt.render", "sections.html").render(
        sections=shown, hover=hover, contents=""
    )


def card(answer: Answer, language: Language = "en") -> str:
    """Render the card of an answer, to be put into another page."""
    wanted = as_wanted(answer, language)
    blocks = [(type(each).__name__.lower(), each) for each in wanted.card]
    values = {
        f"{fact.name}": as_text(fact.value, fact.quantity, unit=True)
        for _, each in blocks
        if isinstance(each, Facts)
        for fact in each.facts
    }
    return template("catopt.render", "card.html").render(
        title=wanted.title, blocks=blocks, facts=values, said=lambda text: say(text, language)
    )


def _sections(answer: Answer, language: Language) -> list[Section]:
    """Lay the sections out; `answer` has its words in the language, but for headings of a page."""
    laid = []
    for section in answer.sections:
        if section.name:
            seen = (part for each in section.blocks if is_seen(each) for part in _block(each))
            laid.append(replace(section, blocks=tuple(seen)))
    return in_language(laid, language)


@cache
def template(package: str, name: str) -> Template:
    """Read a template of a package: all that is put in is escaped, and nothing may lack."""
    environment = Environment(
        loader=PackageLoader(package, ""),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    return environment.get_template(name)


def file_text(name: str) -> str:
    """Read a file that stands beside the renderers."""
    return files("catopt.render").joinpath(name).read_text("utf-8")


# ------------------------------------------------------------------ blocks


def _block(block: Block) -> Iterator[Any]:
    """Lay a block out as plain values."""
    match block:
        case Table():
            yield from _tables(block)
        case Facts():
            yield _facts(block)
        case Trail():
            yield _trail(block)
        case FileText():
            yield {"kind": "file", "of": block}
        case Figure():
            yield {"kind": "figure", "caption": block.caption, "figure": svg(block.chart)}
        case Verdict():
            yield _Words("text", block.said, style=f"verdict {block.kind}".rstrip())
        case Text() if block.said:
            yield _Words("text", block.said, block.caption, "small" if block.is_small else "")
        case Points() if block.said:
            yield _Words("points", block.said, block.caption)
        case Warnings() if block.said:
            yield _Words("points", block.said, style="warnings")


def _tables(table: Table) -> Iterator[_LaidTable]:
    columns = [each for each in table.columns if each.only not in {"files", "workbook"}]
    headings = []
    for each in columns:
        label, quantity = _label(each), each.quantity
        if quantity is not None and quantity.field_unit != "-":  # a pure number has no unit
            label = f"{label} ({quantity.field_unit})"
        headings.append(_Heading(label, each.is_number))
    for caption, rows in parts_of(table):
        yield _LaidTable(
            "table",
            table.name,
            caption,
            headings,
            [[_cell(each, row) for each in columns] for row in rows],
            next((k for k, row in enumerate(rows) if row == table.marked), None),
        )


def _label(of: Column | Fact) -> str:
    """Name what has a quantity, with its symbol."""
    symbol = of.quantity.symbol if of.quantity else ""
    return f"{of.name} {GREEK.get(symbol, symbol)}".rstrip()


def _cell(column: Column, row: int) -> _Cell:
    quantity, si = column.quantity_of(row), _si(column.values[row])
    style = "" if column.is_number else "words"
    passes = column.passes[row] if column.passes else None
    if passes is not None:
        style = f"{style} {'passes' if passes else 'fails'}"
    if si is not None and quantity is not None and abs(si) < quantity.floor:
        si = None  # rounding, which is another on each machine
    is_use = quantity is not None and quantity.key == "utilisation"
    return _Cell(cell(column, row), style, si, si if is_use else None)


def _si(value: object) -> float | None:
    """Return a number that is behind a text; none where it is not known or without bounds."""
    return value if isinstance(value, int | float) and math.isfinite(value) else None


def _facts(block: Facts) -> _LaidTable:
    """Lay named values out, those of quantities in SI, too; words alone have no headings."""
    facts = [each for each in block.facts if each.only in SEEN]
    quantities = [each.quantity for each in facts if each.quantity is not None]
    has_si = any(each.si_unit != each.field_unit for each in quantities)
    only_words = all(isinstance(each.value, str) for each in facts)
    names = ("page.what", "page.value", "page.si")[: 3 if has_si else 2]
    headings = [_Heading(Message(name), name != "page.what" and not only_words) for name in names]
    rows = [_fact(each)[: len(names)] for each in facts]
    kind = "facts" if only_words and not block.caption else "table"
    return _LaidTable(kind, block.name, block.caption, headings, rows)


def _fact(fact: Fact) -> tuple[_Cell, ...]:
    """Lay out a name, its value in all its units, and the value in SI."""
    si, quantity = _si(fact.value), fact.quantity
    ways = (quantity, *(fact.also if si is not None else ()))
    said = " = ".join(as_text(fact.value, each, unit=True) for each in ways)
    in_si = ""
    if si is not None and quantity is not None:
        # Where it is printed as zero, what rounding left is none, too.
        is_zero = quantity.notation == "fixed" and quantity.format(si) == quantity.format(0.0)
        in_si = exact(quantity.si_unit).format(0.0 if is_zero else si, unit=True)
    return _Cell(_label(fact), "words"), _Cell(said, si=si), _Cell(in_si)


def _trail(block: Trail) -> _LaidTable:
    """Lay steps out: what comes out, its equation, its numbers put in, and what others have."""
    steps = block.steps
    columns: dict[str, list[_Cell]] = {
        Message("page.what"): [_Cell(each.name, "words") for each in steps]
    }
    if any(each.equation for each in steps):
        columns[Message("page.equation")] = [_Cell(each.equation) for each in steps]
    columns[Message("page.put_in")] = [_Cell(put_in(each), "formula") for each in steps]
    columns[Message("page.value")] = [_result(each, each.value, "-") for each in steps]
    if block.stated:
        columns[block.stated] = [_result(each, each.stated, "") for each in steps]
    if any(each.source for each in steps):
        columns[Message("page.source")] = [_Cell(each.source, "words") for each in steps]
    numbers = {Message("page.value"), block.stated}
    headings = [_Heading(each, each in numbers) for each in columns]
    rows = list(zip(*columns.values(), strict=True))
    return _LaidTable("table", block.name, block.caption, headings, rows)


def _result(step: Step, value: float | None, unknown: str) -> _Cell:
    if value is None:
        return _Cell(unknown)
    return _Cell(step.quantity.format(value, unit=True), si=value)


_WIDTH: Final = 960
"""Of the drawing, in its own units."""
_BELOW: Final = 0.05
"""Of the bed that is drawn, over the height of what is above it."""


def film_page(film: Film, title: str, language: Language = "en") -> bytes:
    """Make the page of a film."""
    unit = film.wide / _WIDTH
    words = {
        "said": film.title,
        "tension": Message("figures.film_tension"),
        "play": Message("figures.film_play"),
        "pause": Message("figures.film_pause"),
        "moment": Message("figures.film_moment"),
    }
    scene = {"frame": [film.left, film.top, unit], **film.values}
    return whole_page(
        "film.html",
        language,
        script=file_text("film.js"),
        title=title,
        kind="",
        scene=json.dumps(scene, separators=(",", ":")),
        width=_WIDTH,
        height=round((1.0 + _BELOW) * film.top / unit),
        bed=round(film.top / unit),
        last=len(film.values["time"]) - 1,
        worst=film.worst,
        **{key: say(text, language) for key, text in words.items()},
    )
