"""Reads a buoy as IALA's CALMAR saves one: a file .xmlMB."""

from __future__ import annotations

import math
import os
import re
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Final, NamedTuple

from catopt.documents import read_text, unfit
from catopt.errors import InputError, refused
from catopt.loads.buoy_shape import BuoyShape, BuoySlice
from catopt.model.kinds import Findings
from catopt.tables import number
from catopt.words import Message

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

SUFFIX: Final = ".xmlmb"
"""Of such a file, in small letters."""

_MOST_BYTES: Final = 256 * 1024
"""CALMAR's own are below 2 kB."""

_MM: Final = 1e3


class _Tag(NamedTuple):
    """What an element has: numbers, texts, elements that stand in it once, and any number of."""

    numbers: tuple[str, ...] = ()
    texts: tuple[str, ...] = ()
    one: tuple[str, ...] = ()
    several: tuple[str, ...] = ()


_OUTLINE: Final = _Tag(("Height", "WidthHigh", "WidthLow", "Masse"), ("Name",))
_OF_BUOY: Final = ("ChaineMin", "ChaineMax", "MasseLestUnitaire", "NombreLestMin", "NombreLestMax")
_OF_PART: Final = ("Masse", "OffsetFlotteur", "OffsetOrganeau")
_SIGNED: Final = ("OffsetFlotteur", "OffsetOrganeau")
"""Below 0 what is offset lies above where it is offset from."""
_SLICE: Final = ("ElementDimItem",)
_TAGS: Final = {
    "Calmar": _Tag((), ("version",), ("Buoy",)),
    "Buoy": _Tag(_OF_BUOY, ("Name",), ("Structure", "Flotteur"), ("Pylone", "Equipement")),
    "Structure": _Tag(_OF_PART, ("Name",), (), _SLICE),
    "Flotteur": _Tag(_OF_PART[:1], ("Name",), (), _SLICE),
    "ElementDimItem": _Tag(("H", "D0", "D1", "DI", "Volume")),
    "Pylone": _OUTLINE,
    "Equipement": _OUTLINE,
}


def read_calmar_buoy(
    path: str | os.PathLike[str], *, ballast_pieces: int | None = None
) -> BuoyShape:
    """Read a buoy that CALMAR saved; what displaces more is the hull, float or structure.

    Parameters
    ----------
    path : str or path
        The file, .xmlMB.
    ballast_pieces : int, optional
        Of cast iron; the least number that the buoy may have when left out.

    Raises
    ------
    InputError
        With every problem of the file.
    """
    source = os.fspath(path)
    text = read_text(Path(path), source, kind="buoy of CALMAR", most=_MOST_BYTES)
    return parse_calmar_buoy(text, source, ballast_pieces=ballast_pieces)


def parse_calmar_buoy(
    text: str, source: str = "", *, ballast_pieces: int | None = None
) -> BuoyShape:
    """Read the text of such a file, as `read_calmar_buoy` does; the source names it in messages."""
    found = Findings(source)
    top = _parsed(text, source)
    if top.tag != "Calmar":
        found.add("file", f"<{top.tag}>", Message("refused_sizing.buoy_calmar_saved_begins_with"))
        found.raise_if_any()
    _check(top, "", found)
    found.raise_if_any()
    buoy = _only(top, "Buoy")
    part, tail = _only(buoy, "Flotteur"), _only(buoy, "Structure")
    floats = _slices(part, "Buoy.Flotteur", found)
    frame = _slices(tail, "Buoy.Structure", found)
    masts, marks = (
        tuple(
            made
            for k, each in enumerate(buoy.iter(tag))
            if (made := _outline(each, f"Buoy.{tag}[{k}]", found))
        )
        for tag in ("Pylone", "Equipement")
    )
    least, most = (int(_number(buoy, f"NombreLest{end}")) for end in ("Min", "Max"))
    pieces = least if ballast_pieces is None else ballast_pieces
    if not floats and not frame:
        allowed = Message("refused_sizing.float_or_structure_wants_one")
        found.add("Buoy.Flotteur", Message("refused_sizing.no_element"), allowed)
    if not least <= pieces <= most:
        allowed = Message("refused_sizing.this_buoy_has", least=least, most=most)
        found.add("ballast_pieces", f"{pieces}", allowed)
    found.raise_if_any()

    depth = _number(tail, "OffsetFlotteur") if frame else 0.0
    eye = _number(tail, "OffsetOrganeau")
    hull, structure = floats, frame
    if _volume(frame) > _volume(floats):
        hull, structure, depth, eye = frame, floats, -depth, eye - depth
    name = buoy.get("Name", "")
    masses = [_number(each, "Masse") for each in buoy if "Masse" in each.attrib]
    try:
        return BuoyShape(
            name,
            mass=sum(masses),
            origin=f"IALA CALMAR, {Path(source).name or name}",
            hull=hull,
            structure=structure,
            structure_depth=depth,
            eye_offset=eye,
            pylons=masts,
            topmarks=marks,
            ballast_mass=_number(buoy, "MasseLestUnitaire"),
            ballast_pieces=pieces,
            chain_min=_number(buoy, "ChaineMin") / _MM,
            chain_max=_number(buoy, "ChaineMax") / _MM,
        )
    except InputError as error:
        raise InputError(error.problems, source) from None


def _parsed(text: str, source: str) -> Element:
    """Parse XML that declares nothing: no entity is expanded and no other file is read."""
    from xml.etree import ElementTree

    if declared := re.search(r"<!(?!--)\w*", text):
        allowed = Message("refused_sizing.buoy_calmar_declares_nothing_take")
        raise refused("file", declared[0], allowed, source)
    try:
        return ElementTree.fromstring(text)
    except ElementTree.ParseError as error:
        line, column = error.position
        place = f"line {line}, column {column + 1}"
        reason = Message("refused_sizing.no_xml", said=str(error).partition(":")[0])
        raise refused(place, "", reason, source) from None


def _check(of: Element, path: str, found: Findings) -> None:
    """Note what of an element and of those in it is missing, unknown or no number."""
    tag = _TAGS[of.tag]
    _check_attributes(of, path, tag, found)
    for text in (of.text, *(each.tail for each in of)):
        if text and text.strip():
            between = Message("refused_sizing.text_between")
            found.add(path or of.tag, between, Message("refused_sizing.take_out"))
    for name in tag.one:
        if (count := len(of.findall(name))) != 1:
            there = Message("refused_motion.of_them", count=count)
            found.add(_at(path, name), there, Message("refused_sizing.one_wanted"))
    inside = tag.one + tag.several
    counts: dict[str, int] = {}
    for each in of:
        index = counts[each.tag] = counts.get(each.tag, -1) + 1
        at = _at(path, each.tag if each.tag in tag.one else f"{each.tag}[{index}]")
        if each.tag in inside:
            _check(each, at, found)
        else:
            found.add(at, Message("refused_sizing.unknown_element"), _allowed(inside))


def _check_attributes(of: Element, path: str, tag: _Tag, found: Findings) -> None:
    for key in (*tag.texts, *tag.numbers):
        if key not in of.attrib:
            found.add(_at(path, key), "", Message("refused.is_missing"))
    for key, value in of.attrib.items():
        if key in tag.numbers:
            _check_number(_at(path, key), value, found)
        elif key not in tag.texts:
            unknown = Message("refused_sizing.unknown_attribute")
            found.add(_at(path, key), unknown, _allowed(tag.texts + tag.numbers))
        elif unfit(value):
            found.add(_at(path, key), unfit(value), Message("refused.out_of_text"))


def _allowed(names: Sequence[str]) -> str:
    if not names:
        return Message("refused_sizing.none_allowed_here")
    return Message("refused_sizing.allowed_here", names=", ".join(names))


def _check_number(at: str, value: str, found: Findings) -> None:
    read = number(value)
    if math.isnan(read):
        allowed = Message("refused_sizing.number_with_decimal_point_wanted")
        found.add(at, f'"{value}"', allowed)
        return
    if "NombreLest" in at and read % 1.0:
        found.add(at, f'"{value}"', Message("refused.whole"))
    else:
        found.number(at, read, "", at_least=None if at.endswith(_SIGNED) else 0.0)


def _at(path: str, key: str) -> str:
    return f"{path}.{key}" if path else key


def _only(of: Element, tag: str) -> Element:
    (found,) = of.findall(tag)
    return found


def _number(of: Element, key: str) -> float:
    return float(of.attrib[key])


def _slices(of: Element, at: str, found: Findings) -> tuple[BuoySlice, ...]:
    """Make the slices of float or structure, from the lowest upwards as they stand there."""
    made = []
    for index, each in enumerate(of):
        height, lower, upper, inner, volume = (
            _number(each, key) for key in _TAGS[each.tag].numbers
        )
        try:
            made.append(BuoySlice(height, lower, upper, inner, volume or None))
        except InputError as error:
            _keep(error, f"{at}.ElementDimItem[{index}]", found)
    return tuple(made)


def _outline(of: Element, at: str, found: Findings) -> BuoySlice | None:
    try:
        return BuoySlice(*(_number(of, key) for key in ("Height", "WidthLow", "WidthHigh")))
    except InputError as error:
        _keep(error, at, found)
        return None


_KEYS: Final = {
    "height": ("H", "Height"),
    "lower": ("D0", "WidthLow"),
    "upper": ("D1", "WidthHigh"),
    "inner": ("DI", "DI"),
    "volume": ("Volume", "Volume"),
}


def _keep(error: InputError, at: str, found: Findings) -> None:
    """Note the problems of a slice by the file's own names."""
    for each in error.problems:
        key = _KEYS[each.key]["ElementDimItem" not in at]
        found.add(f"{at}.{key}", each.found, each.allowed)


def _volume(slices: tuple[BuoySlice, ...]) -> float:
    return sum(each.displaced(each.height) for each in slices)
