"""Reads the file itself, from bytes to a TOML document, with hints for what often goes wrong."""

from __future__ import annotations

import codecs
import re
import tomllib
from pathlib import Path
from typing import Any

from catopt.errors import InputError, Problem

__all__ = ["parse_toml", "read_text"]

_PLACE = re.compile(r" \(at (line (\d+), column \d+|end of document)\)$")

_HINTS = (
    (r"=\s*[“”‘’„]", 'write plain quotes: "'),
    (r"=\s*[-+]?\d+,\d", "write a decimal point, not a comma"),
    (r"=\s*[-+]?[\d.]+\s*[A-Za-z°%]", 'put a value with a unit in quotes, such as "9.5 m"'),
    (r"=\s*[-+]?\d+\s+\d", "write the number in one piece"),
    (r"=\s*[-+]?(\.\d|\d+\.(\D|$))", "write a digit on both sides of the decimal point"),
    (r"=\s*\"[^\"]*\\", "write / instead of \\, or put the text in single quotes"),
    (r"=\s*[A-Za-z]", "put text in quotes"),
    (r"=\s*(#|$)", "the value is missing"),
    (r'^<|^\{\s*("|$)', "this is no TOML; give a case file, as catopt new writes one"),
    (r'^[^="]+:', "write = between a key and its value, not a colon"),
)
"""What the line at fault looks like, and what to do; the first that fits is given."""

_REASONS = (
    ("Cannot overwrite a value", "this key stands twice in its table; keep one"),
    ("Cannot declare", "this section stands twice; put its keys together in one"),
    ("Illegal character '\\n'", "the closing quote is missing"),
)
"""Reasons of the TOML reader that need plainer words, by how they begin."""

_LONGEST_LINE = 48


def read_text(path: Path, source: str) -> str:
    """Read a case file's text.

    Parameters
    ----------
    path : Path
        The file; UTF-8, with or without the byte-order mark that Windows editors write.
    source : str
        Its name for messages.

    Raises
    ------
    InputError
        When there is no such file, it cannot be read or is not UTF-8.
    """
    try:
        if path.is_dir():
            raise _no_file(source, "it is a folder" + _case_in(path))
        data = path.read_bytes()
    except FileNotFoundError:
        raise _no_file(source, "there is no such file" + _similar(path)) from None
    except (OSError, ValueError) as error:  # ValueError: a NUL in the name
        reason = getattr(error, "strerror", None) or str(error)
        raise _no_file(source, f"it cannot be read: {reason}") from None
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise InputError([_not_utf8(data, error.start)], source) from None


def parse_toml(text: str, source: str) -> dict[str, Any]:
    """Parse TOML text.

    Parameters
    ----------
    text : str
        The document.
    source : str
        Its name for messages.

    Raises
    ------
    InputError
        With the line and column at fault, the line itself and what to do about it.
    """
    # A newline is added so that a fault in the last line is placed there, not at the end.
    document = text.removeprefix("\ufeff").replace("\r\n", "\n") + "\n"
    try:
        return tomllib.loads(document)
    except tomllib.TOMLDecodeError as error:
        problem = _syntax_problem(document, str(error))
    except RecursionError:
        problem = Problem("file", "", "arrays or tables are nested too deeply")
    except ValueError as error:  # a whole number of thousands of digits
        problem = Problem("file", "", str(error))
    raise InputError([problem], source)


def _syntax_problem(document: str, message: str) -> Problem:
    place = _PLACE.search(message)
    reason = message[: place.start()] if place else message
    where, number = (place[1], place[2]) if place else ("file", None)
    line = document.split("\n")[int(number) - 1].strip() if number else ""
    return Problem(where, _shown(line), _advice(line, reason))


def _advice(line: str, reason: str) -> str:
    for beginning, plain in _REASONS:
        if reason.startswith(beginning):
            return plain
    for pattern, hint in _HINTS:
        if re.search(pattern, line):
            return hint
    return reason[:1].lower() + reason[1:]


def _shown(line: str) -> str:
    short = line if len(line) <= _LONGEST_LINE else line[: _LONGEST_LINE - 3] + "..."
    return f"`{repr(short)[1:-1]}`" if short else ""


def _not_utf8(data: bytes, start: int) -> Problem:
    if data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return Problem("file", "UTF-16 text", "save it as UTF-8")
    if b"\0" in data:
        return Problem("file", "no text", "give a case file, as catopt new writes one")
    line = data.count(b"\n", 0, start) + 1
    found = f"the byte 0x{data[start]:02X}"
    return Problem(f"line {line}", found, "save the file as UTF-8")


def _no_file(source: str, reason: str) -> InputError:
    return InputError([Problem("case file", "", reason)], source)


def _case_in(folder: Path) -> str:
    inside = folder / "case.toml"
    return f"; give the file in it, {inside.as_posix()}" if inside.is_file() else "; give a file"


def _similar(path: Path) -> str:
    """Name a file in the same folder that is spelt nearly so."""
    if not path.parent.is_dir():
        return f", and no folder {path.parent.as_posix()}"
    from difflib import get_close_matches

    close = get_close_matches(path.name, sorted(p.name for p in path.parent.iterdir()), n=1)
    return f"; did you mean {(path.parent / close[0]).as_posix()}?" if close else ""
