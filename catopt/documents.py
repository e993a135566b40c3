"""Reads the files that catopt is given: bytes to text, and text to a TOML or JSON document.

Case files, files for sizings, families of components, codes, buoys, tables of numbers and result
directories all come through here, so that whatever is wrong with one of them as a file is refused
in the same words: no regular file, too large, no text, no TOML or JSON, nested too deeply, or with
characters that no title, name or key may have.
"""

from __future__ import annotations

import codecs
import json
import math
import re
import stat
import tomllib
import unicodedata
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path as FilePath
from typing import Any

from catopt.errors import InputError, Problem
from catopt.words import Cited, Message, term
from catopt.words.message import TURNING

Path = tuple[str | int, ...]
"""Keys and array indices from the top of a document: ``("line", "segments", 0, "length")``."""

MOST_BYTES = 4 * 2**20
"""Of a TOML file; those of catopt's own are below 0.1 MB."""

MOST_BYTES_OF_DATA = 64 * 2**20
"""Of a table of numbers or a document of catopt's own: three hours at 50 rows a second."""

_DEEPEST = 20
"""Tables and arrays within each other; a case file needs 6, a document of catopt's own 8."""

MOST_ENTRIES = 200_000
"""Keys, values and tables of a text that a person writes: parsing takes some 20 us for each."""

_LONG_KEY = re.compile(
    r"""(?<![\w.-])(?:[\w-]++|"[^"\n]*+"|'[^'\n]*+')"""
    rf"""(?:[ \t]*+\.[ \t]*+(?:[\w-]++|"[^"\n]*+"|'[^'\n]*+')){{{_DEEPEST},}}+[ \t]*+[=\]]"""
)
"""A dotted key of more parts than tables may be deep: the time that it takes grows with the square
of them."""

_PLACE = re.compile(r" \(at (line (\d+), column (\d+)|end of document)\)$")
_UNIT = re.compile("_(m|N|kg|rad|s|J|USD)(_per_(m|m3|s))?$")
_BARE_KEY = re.compile(r"[A-Za-z0-9_-]+")

_HINTS = (
    (r"=\s*[“”‘’„]", "plain_quotes"),
    (r"=\s*[-+]?\d+,\d", "decimal_point"),
    (r"=\s*[-+]?[\d.]+\s*[A-Za-z°%]", "quote_value"),
    (r"=\s*[-+]?\d+\s+\d", "one_piece"),
    (r"=\s*[-+]?(\.\d|\d+\.(\D|$))", "both_sides"),
    (r"=\s*\"[^\"]*\\", "slash"),
    (r"=\s*[A-Za-z]", "quote_text"),
    (r"=\s*(#|$)", "no_value"),
    (r'^<|^\{\s*("|$)', "no_toml"),
    (r'^[^="]+:', "no_colon"),
)
"""What the line at fault looks like, and what to do; the first that fits is given."""

_REASONS = (
    ("Cannot overwrite a value", "key_twice"),
    ("Cannot declare", "section_twice"),
    ("Illegal character '\\n'", "closing_quote"),
)
"""Reasons of the TOML reader that need plainer words, by how they begin."""

_LONGEST_LINE = 48


def read_text(
    path: FilePath,
    source: str,
    *,
    kind: str = "case file",
    most: int = MOST_BYTES,
    broken: bool = False,
) -> str:
    """Read a text file: UTF-8, with or without the byte-order mark that Windows editors write.

    `source` and `kind` say in messages which file it is and what, `most` how many bytes it may
    have; `broken` passes over bytes that are no UTF-8, as U+FFFD. InputError when there is no such
    file, it is no regular file or too large, cannot be read or is not UTF-8.
    """

    def refused(reason: Message) -> InputError:
        return InputError([Problem(term(kind), "", reason)], source)

    try:
        found = path.stat()
        if stat.S_ISDIR(found.st_mode):
            inside = path / "case.toml"
            if inside.is_file():
                raise refused(Message("refused.a_folder_with", inside=inside.as_posix()))
            raise refused(Message("refused.a_folder"))
        if not stat.S_ISREG(found.st_mode):
            raise refused(Message("refused.no_regular_file"))
        if found.st_size > most:
            size = f"{found.st_size / 2**20:.1f} MB"
            raise refused(Message("refused.too_large", size=size, most=most / 2**20))
        data = path.read_bytes()
    except FileNotFoundError:
        raise refused(_similar(path)) from None
    except (OSError, ValueError) as error:  # ValueError: a NUL in the name
        reason = getattr(error, "strerror", None) or str(error)
        raise refused(Message("refused.not_read", reason=term(reason))) from None
    if broken:
        return data.decode("utf-8-sig", "replace")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise InputError([_not_utf8(data, error.start, kind)], source) from None


def parse_toml(text: str, source: str) -> dict[str, Any]:
    """Parse TOML text; `source` is its name for messages.

    InputError with the line and column at fault, the line itself and what to do about it; or with
    every key or text that has characters it may not have. Of a file whose name does not end in
    ``.toml`` no line is told: it may be any file, named by mistake.
    """
    # A newline is added so that a fault in the last line is placed there, not at the end.
    document = text.removeprefix("\ufeff").replace("\r\n", "\n") + "\n"
    check_entries(document, source, "=,[{")
    if found := _LONG_KEY.search(document):
        place = f"line {document.count(chr(10), 0, found.start()) + 1}"
        allowed = Message("refused_command.key_has_more_than_parts", deepest=_DEEPEST)
        raise InputError([Problem(place, _shown(found[0]), allowed)], source)

    def parse() -> dict[str, Any]:
        try:
            return tomllib.loads(document)
        except tomllib.TOMLDecodeError as error:
            problem = _syntax_problem(document, str(error))
            if source and not source.lower().endswith(".toml"):
                problem = replace(problem, found="")
            raise InputError([problem], source) from None

    return _parsed(parse, source)


def check_entries(text: str, source: str, marks: str) -> None:
    """Refuse a text, before it is parsed, with more entries than anybody writes: by their marks."""
    entries = sum(map(text.count, marks))
    if entries > MOST_ENTRIES:
        allowed = Message("refused_command.are_most_give_long_tables", most_entries=MOST_ENTRIES)
        found = Message("refused_command.keys_and_values", count=entries)
        raise InputError([Problem("file", found, allowed)], source)


def parse_json(text: str, source: str) -> dict[str, Any]:
    """Parse JSON text, whose top is an object; `source` is its name for messages.

    InputError as for `parse_toml`; and when it is no object, or has NaN or Infinity.
    """

    def parse() -> dict[str, Any]:
        try:
            found = json.loads(
                text.removeprefix("\ufeff"), parse_constant=_finite, parse_float=_finite
            )
        except json.JSONDecodeError as error:
            place = f"line {error.lineno}, column {error.colno}"
            line = text.split("\n")[error.lineno - 1].strip()
            allowed = Message("refused_command.no_json", msg=error.msg)
            raise InputError([Problem(place, _shown(line), allowed)], source) from None
        if not isinstance(found, dict):
            raise InputError([Problem("file", "", Message("refused.object"))], source)
        return found

    return _parsed(parse, source)


def dotted(path: Path) -> str:
    """Write a path as ``line.segments[0].length``."""
    text = ""
    for part in path:
        if isinstance(part, int):
            text += f"[{part}]"
        else:
            text += ("." if text else "") + (part if _BARE_KEY.fullmatch(part) else repr(part))
    return text


def figures(of: object, keys: str) -> dict[str, Any]:
    """List attributes by keys that end in their unit, if any: ``mass_kg`` is the mass, in kg."""
    found = {key: getattr(of, _UNIT.sub("", key)) for key in keys.split()}
    return {k: list(value) if isinstance(value, tuple) else value for k, value in found.items()}


def attributes(document: dict[str, Any]) -> dict[str, Any]:
    """Return what is listed by such keys by the attributes themselves."""
    return {_UNIT.sub("", key): value for key, value in document.items()}


def unfit(text: str) -> str:
    """Name the first character that no title, name or key may have; empty where there is none.

    These are control characters (save the line end and the tab), marks that turn the direction of
    writing, and the code points that are no characters: terminals obey them, and no SVG file may
    hold them.
    """
    for each in text:
        code = ord(each)
        is_control = unicodedata.category(each) in ("Cc", "Cs", "Zl", "Zp") and each not in "\n\t"
        is_none = code & 0xFFFE == 0xFFFE or 0xFDD0 <= code <= 0xFDEF
        if is_control or is_none or each in TURNING:
            key = "refused.control_character" if is_control else "refused.no_character"
            name = unicodedata.name(each, "").lower()
            if name:
                return Message("refused.character_named", code=f"{code:04X}", name=Cited(name))
            return Message(key, code=f"{code:04X}")
    return ""


def _parsed(parse: Callable[[], dict[str, Any]], source: str) -> dict[str, Any]:
    """Parse a document and look through it for what no document may have."""
    try:
        document = parse()
    except RecursionError:
        raise InputError([_too_deep(())], source) from None
    except ValueError as error:
        is_long = "integer string conversion" in str(error)  # a number of thousands of digits
        said = Message("refused_command.number_has_too_many_digits") if is_long else str(error)
        raise InputError([Problem("file", "", said)], source) from None
    problems = list(_unfit_parts(document))
    if problems:
        raise InputError(problems, source)
    return document


def _unfit_parts(document: dict[str, Any]) -> Iterator[Problem]:
    """Find keys and texts with characters that they may not have, and what is nested too deeply."""
    waiting: list[tuple[Path, Any]] = [((), document)]
    while waiting:
        path, value = waiting.pop()
        if len(path) > _DEEPEST:
            yield _too_deep(path)
            return
        if isinstance(value, dict):
            for key in value:
                if unfit(key):
                    yield Problem(dotted((*path, key)), unfit(key), Message("refused.out_of_key"))
            waiting += [((*path, key), each) for key, each in reversed(value.items())]
        elif isinstance(value, list):
            parts = reversed([((*path, index), each) for index, each in enumerate(value)])
            waiting += [part for part in parts if not isinstance(part[1], int | float)]
        elif isinstance(value, str) and unfit(value):
            yield Problem(dotted(path), unfit(value), Message("refused.out_of_text"))


def _too_deep(path: Path) -> Problem:
    return Problem(dotted(path[:2]) or "file", "", Message("refused.too_deep"))


def _finite(word: str) -> float:
    found = float(word)
    if not math.isfinite(found):
        raise ValueError(f"{word} is no finite number")
    return found


def _syntax_problem(document: str, message: str) -> Problem:
    place = _PLACE.search(message)
    reason = message[: place.start()] if place else message
    line = document.split("\n")[int(place[2]) - 1].strip() if place and place[2] else ""
    where: str = place[1] if place else "file"
    if place and place[2]:
        where = Message("refused.line_column", line=place[2], column=place[3])
    keys = [key for beginning, key in _REASONS if reason.startswith(beginning)]
    keys += [key for pattern, key in _HINTS if re.search(pattern, line)]
    advice = Message(f"refused.{keys[0]}") if keys else reason[:1].lower() + reason[1:]
    return Problem(where, _shown(line), advice)


def _shown(line: str) -> str:
    short = line if len(line) <= _LONGEST_LINE else line[: _LONGEST_LINE - 3] + "..."
    return f"`{repr(short)[1:-1]}`" if short else ""


def _not_utf8(data: bytes, start: int, kind: str) -> Problem:
    if data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return Problem("file", Message("refused.utf16_text"), Message("refused.save_utf8"))
    if b"\0" in data:
        key = "refused.give_case_file" if kind == "case file" else "refused.give_utf8"
        return Problem("file", Message("refused.no_text"), Message(key, kind=term(kind)))
    line = data.count(b"\n", 0, start) + 1
    byte = Message("refused.the_byte", byte=f"{data[start]:02X}")
    return Problem(f"line {line}", byte, Message("refused.save_utf8_file"))


def _similar(path: FilePath) -> Message:
    """Say that there is no such file, and name one beside it that is spelt nearly so."""
    if not path.parent.is_dir():
        return Message("refused.no_folder", folder=path.parent.as_posix())
    from difflib import get_close_matches

    # Without the ending, which makes all files of a kind alike.
    stems = {each.stem: each for each in sorted(path.parent.glob(f"*{path.suffix}"))}
    close = get_close_matches(path.stem, stems, n=1)
    if close:
        return Message("refused.no_file_but", near=stems[close[0]].as_posix())
    return Message("refused.no_file")
