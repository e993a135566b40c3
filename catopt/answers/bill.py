"""The bill of materials of a note: line, weights, anchor, and the fittings that join them."""

from __future__ import annotations

import itertools
from collections import Counter
from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

from catopt.answers.blocks import Block, Rows, Text, tabulate, texts
from catopt.catalogue.fittings import fittings_of
from catopt.words import Cited, Measure, Message, Several, term

if TYPE_CHECKING:
    from catopt.catalogue.fittings import Fitting
    from catopt.model import Case, Segment
    from catopt.notes.sheet import Sheet


class _Item(NamedTuple):
    code: str
    what: str
    nominal_diameter: float | None = None
    length: float | None = None
    mass: float | None = None
    number: int = 1


def bill(sheet: Sheet, held: str) -> Iterator[Block]:
    """List what all lines are made of; `held` says what holds one, where more is known of it."""
    fittings, said = _fittings(sheet)
    items, lines = Rows([*_items(sheet, held), *fittings]), sheet.lines
    yield tabulate(
        "bill",
        texts("no", range(1, len(items.rows) + 1)),
        items.texts("note_sheet.item", "what"),
        items.texts("note_sheet.code", "code"),
        *items.own("nominal_diameter", "length"),
        items.texts("note_sheet.count", lambda item: lines * item.number),
        items.measured("mass", "mass", "mass_in_air", symbol=""),
        items.measured("mass", lambda item: _in_all(item, lines), "note_sheet.mass_together"),
    )
    yield from map(Text, said)
    yield Text(Message("note_sheet.no_allowance"))


def _in_all(item: _Item, lines: int) -> float | None:
    return None if item.mass is None else lines * item.number * item.mass


def _items(sheet: Sheet, held: str) -> Iterator[_Item]:
    """Yield what one line is made of; mass in kg."""
    for segment in sheet.line.segments:
        mass = None if segment.mass is None else segment.mass * segment.length
        code, what = Cited(segment.name or segment.component), described(sheet.case, segment)
        yield _Item(code, what, segment.nominal_diameter, segment.length, mass)
    for load in sheet.line.point_loads:
        key = "clump" if load.submerged_weight > 0.0 else "float"
        yield _Item("", Message(f"note_sheet.{key}_at", place=load.position), mass=load.mass)
    if sheet.anchor is not None:
        name = {"drag": "Drag anchor", "sinker": "Sinker"}[sheet.anchor.kind]
        yield _Item(held, term(name), mass=sheet.anchor.mass)


def described(case: Case, segment: Segment) -> str:
    """Say in words what a segment is made of, as its family of the catalogue is called."""
    if not segment.component:
        return Message("note_sheet.no_component")
    from catopt.catalogue.choice import chosen

    families = chosen(case.catalogue, case.site.water_density).families
    family, grade = families.family(segment.component), families.parse_name(segment.component).grade
    return Several((family.title, Cited(grade)), " ") if grade else family.title


# ------------------------------------------------------------------ fittings


def _fittings(sheet: Sheet) -> tuple[list[_Item], list[Message]]:
    """Choose fittings of one line of chain: items, and what is to be said of the choice.

    There is a shackle at each end and between segments, by the weaker chain that it joins; a single
    line has a swivel between two shackles at its fairlead, a sinker its ring.
    """
    segments, is_single = sheet.line.segments, sheet.lines == 1
    is_held_by_ring = sheet.anchor is not None and sheet.anchor.kind == "sinker"
    ends = [segments[:1], *itertools.pairwise(segments), segments[-1:]]
    chosen: Counter[tuple[str, Fitting]] = Counter()
    unknown: dict[Message, None] = {}
    open_ends = 0
    for k, joined in enumerate(ends):
        wanted = {"shackle": 1}
        if k == 0 and is_held_by_ring:
            wanted["sinker ring"] = 1
        if k == len(segments) and is_single:
            wanted |= {"shackle": 2, "swivel": 1}
        found = [of for each in joined if (of := fittings_of(each, tuple(wanted))) is not None]
        if not found:
            open_ends += 1
            continue
        of = min(found, key=lambda each: each.MBL)
        for use, fitting in of.found.items():
            chosen[use, fitting] += wanted[use]
        unknown |= dict.fromkeys(of.missing.values())
    items = [_item(use, fitting, number) for (use, fitting), number in chosen.items()]
    said = [Message("note_sheet.fittings_chosen")] if items else []
    if open_ends:
        count = {"each": open_ends, "every": open_ends * sheet.lines}
        said.append(Message("note_sheet.fittings", **count))
    return items, [*said, *unknown]


def _item(use: str, fitting: Fitting, number: int) -> _Item:
    size = 1e3 * fitting.size
    source = Cited(f"{fitting.sources[0].title} [{fitting.confidence}]")
    values = {"title": fitting.title, "size": size, "MBL": Measure("MBL", fitting.MBL), "mass": ""}
    what = Message("sizing.fitting", source=source, **values)
    name = Message("sizing.fitting_size", use=term(use), size=size)
    return _Item(name, what, mass=fitting.mass, number=number)
