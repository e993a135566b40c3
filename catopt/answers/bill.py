"""The bill of materials of a note: line, weights, anchor, and the fittings that join them."""

from __future__ import annotations

import itertools
import math
from collections import Counter
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Final, NamedTuple

from catopt.answers.blocks import Block, Rows, Text, if_known, measured, tabulate, texts
from catopt.catalogue.fittings import fittings_of
from catopt.words import Cited, Measure, Message, Several, term

if TYPE_CHECKING:
    from catopt.catalogue.fittings import Fitting
    from catopt.model import Case, Line, Segment
    from catopt.model.network import Network
    from catopt.notes.sheet import Stated


class Prices(NamedTuple):
    """Prices that a user gave: of chain and sinker USD a tonne, of the fittings of a line USD."""

    chain: float | None = None
    sinker: float | None = None
    fittings: float | None = None


NO_PRICES: Final = Prices()


class _Item(NamedTuple):
    code: str
    what: str
    nominal_diameter: float | None = None
    length: float | None = None
    mass: float | None = None
    number: int = 1
    price: float | None = None


def bill(sheet: Stated, held: str, prices: Prices = NO_PRICES) -> Iterator[Block]:
    """List what all lines are made of; `held` says what holds one, where more is known of it."""
    parts, (fittings, said) = list(_items(sheet, held, prices)), _fittings(sheet)
    if fittings and prices.fittings is not None:
        all_fittings = Message("note_sheet.fittings_set")
        fittings.append(_Item("", all_fittings, price=prices.fittings, number=sheet.lines))
    items = Rows([*parts, *fittings])
    paid = [_in_all(item, item.price) for item in items.rows]
    yield tabulate(
        "bill",
        texts("no", range(1, len(items.rows) + 1)),
        items.texts("note_sheet.item", "what"),
        items.texts("note_sheet.code", "code"),
        *items.own("nominal_diameter", "length"),
        items.texts("note_sheet.count", "number"),
        items.measured("mass", "mass", "mass_in_air", symbol=""),
        items.measured("mass", lambda item: _in_all(item, item.mass), "note_sheet.mass_together"),
        *if_known(measured("cost", paid, "note_sheet.price_together", symbol="")),
    )
    if any(price is not None for price in paid):
        total = math.fsum(price for price in paid if price is not None)
        yield Text(_priced(total, parts, fittings))
    yield from map(Text, said)
    yield Text(Message("note_sheet.no_allowance"))


def _in_all(item: _Item, of_one: float | None) -> float | None:
    return None if of_one is None else item.number * of_one


def _of_mass(price: float | None, mass: float | None) -> float | None:
    return None if price is None or mass is None else 1e-3 * price * mass


def _priced(total: float, parts: Sequence[_Item], fittings: Sequence[_Item]) -> Message:
    """Say what all known prices come to, USD, and what has none."""
    unpriced = [item.what for item in parts if item.price is None]
    if fittings and all(item.price is None for item in fittings):
        unpriced.append(Message("note_sheet.its_fittings"))
    if not unpriced:
        return Message("note_sheet.prices", total=total)
    return Message("note_sheet.prices_but", total=total, names=Several(unpriced, ", "))


def _items(sheet: Stated, held: str, prices: Prices) -> Iterator[_Item]:
    """Yield what the lines are made of; mass in kg, price in USD."""
    for line, count, _ in sheet.made:
        yield from _of_line(sheet, line, count, prices)
    anchors = sum(each.number for each in sheet.made if each.is_held)
    if sheet.anchor is not None and anchors:
        name = {"drag": "Drag anchor", "sinker": "Sinker"}[sheet.anchor.kind]
        mass = sheet.anchor.mass
        price = _of_mass(prices.sinker, mass) if sheet.anchor.kind == "sinker" else None
        yield _Item(held, term(name), mass=mass, price=price, number=anchors)


def _of_line(sheet: Stated, line: Line, count: int, prices: Prices) -> Iterator[_Item]:
    for segment in line.segments:
        mass = None if segment.mass is None else segment.mass * segment.length
        code, what = Cited(segment.name or segment.component), described(sheet.case, segment)
        price = _of_mass(prices.chain, mass)
        if price is None and segment.price is not None:
            price = segment.price * segment.length
        yield _Item(code, what, segment.nominal_diameter, segment.length, mass, count, price)
    for load in line.point_loads:
        key = "clump" if load.submerged_weight > 0.0 else "float"
        what = Message(f"note_sheet.{key}_at", place=load.position)
        yield _Item("", what, mass=load.mass, number=count)


def described(case: Case | Network, segment: Segment) -> str:
    """Say in words what a segment is made of, as its family of the catalogue is called."""
    if not segment.component:
        return Message("note_sheet.no_component")
    from catopt.catalogue.choice import chosen

    families = chosen(case.catalogue, case.site.water_density).families
    family, grade = families.family(segment.component), families.parse_name(segment.component).grade
    return Several((family.title, Cited(grade)), " ") if grade else family.title


# ------------------------------------------------------------------ fittings


def _fittings(sheet: Stated) -> tuple[list[_Item], list[Message]]:
    """Choose fittings of lines of chain: items, and what is to be said of the choice.

    There is a shackle at each end and between segments, by the weaker chain that it joins; a single
    line has a swivel between two shackles at its fairlead, a sinker its ring.
    """
    has_ring = sheet.anchor is not None and sheet.anchor.kind == "sinker"
    chosen: Counter[tuple[str, Fitting]] = Counter()
    unknown: dict[Message, None] = {}
    open_ends = every_open_end = 0
    for kind in sheet.made:
        segments = kind.line.segments
        ends = [segments[:1], *itertools.pairwise(segments), segments[-1:]]
        for k, joined in enumerate(ends):
            wanted = {"shackle": 1}
            if k == 0 and has_ring and kind.is_held:
                wanted["sinker ring"] = 1
            if k == len(segments) and sheet.lines == 1:
                wanted |= {"shackle": 2, "swivel": 1}
            found = [of for each in joined if (of := fittings_of(each, tuple(wanted))) is not None]
            if not found:
                open_ends += 1
                every_open_end += kind.number
                continue
            of = min(found, key=lambda each: each.MBL)
            for use, fitting in of.found.items():
                chosen[use, fitting] += kind.number * wanted[use]
            unknown |= dict.fromkeys(of.missing.values())
    items = [_item(use, fitting, number) for (use, fitting), number in chosen.items()]
    said = [Message("note_sheet.fittings_chosen")] if items else []
    if open_ends:
        key = "fittings" if len(sheet.made) == 1 else "fittings_in_all"
        count = {"each": open_ends, "every": every_open_end}
        said.append(Message(f"note_sheet.{key}", **count))
    return items, [*said, *unknown]


def _item(use: str, fitting: Fitting, number: int) -> _Item:
    size = 1e3 * fitting.size
    source = Cited(f"{fitting.sources[0].title} [{fitting.confidence}]")
    values = {"title": fitting.title, "size": size, "MBL": Measure("MBL", fitting.MBL), "mass": ""}
    what = Message("sizing.fitting", source=source, **values)
    name = Message("sizing.fitting_size", use=term(use), size=size)
    return _Item(name, what, mass=fitting.mass, number=number)
