"""Breaks a file the way users, editors, other programs and bad luck do."""

from __future__ import annotations

import io
import json
import random
import re
import zipfile
from collections.abc import Callable, Sequence
from typing import Any

__all__ = ["mutated"]

NASTY = (
    "0", "-1", "1", "1e200", "-1e200", "1e-300", "5e-324", "nan", "inf", "-inf", "true", "false",
    '""', '" "', '"x"', '"9.5"', '"9.5 kg"', '"1e400 m"', '"1e-300 m"', '"nan m"', '"-5 m"',
    '"1e200 N/m"', '"9,5 m"', '"5 furlongs"', '"1 kN"', '"20 MN"', '"3 h"', '"30 deg"', '"400 deg"',
    "[]", "[1]", "[[]]", '["a", "a"]', "{}", "{a = 1}", "[1, 2, 3, 4, 5, 6, 7, 8, 9]",
    "1979-05-27", "07:32:00", "2000000000", "9223372036854775807", "9223372036854775808",
    "1" * 5000, "[" * 3000 + "]" * 3000, '"\\u0007"', '"\\u202e"', '"a\\u0000b"', '"\\ufffe"',
    '"' + "long " * 2000 + '"', '"=1+1"', '"a\\nb"', '"../../etc/passwd"', '"/dev/zero"', '"."',
)  # fmt: skip
"""Values as TOML has them; what is JSON, too, goes into JSON."""

PARTS: tuple[Any, ...] = (None, 0, -1, 7, 1e300, "x", "\u0007", "", [], [1], {}, True, {"a": 1})
"""Values as JSON has them."""

CELLS = (
    "", "x", "nan", "inf", "-1", "1e400", "1e300", '"', "=1+1", "0", "1_0", "\u0663", "9" * 200_000,
)  # fmt: skip
"""Cells of a table of numbers."""

RAW = (b"\x00", b"\xff", b"\xef\xbb\xbf", b"\r", b"\x1b[31m", "\u202e".encode(), b"'''", b'"""')
"""Bytes that a file may come to hold."""

VALUE = re.compile(r"^(\s*[\w.\"-]+\s*=\s*)(.+?)(\s*(?:#.*)?)$")
NUMBER = re.compile(r"\d+\.?\d*(?:e[+-]?\d+)?")

Mutation = Callable[[random.Random, str, Sequence[str]], str]


def mutated(rng: random.Random, text: str, others: Sequence[str], form: str) -> bytes:
    """Break a file.

    Parameters
    ----------
    rng : Random
        Decides how.
    text : str
        The file as it should be.
    others : sequence of str
        Files of the same form, of which parts may get in.
    form : {"toml", "json", "csv", "deck", "xlsx", "bytes"}
        What it is.
    """
    if form in ("xlsx", "bytes"):
        data = text.encode("latin-1")
        return (
            _workbook(rng, data) if form == "xlsx" and rng.random() < 0.7 else _damaged(rng, data)
        )
    ways = {"toml": TOML, "json": JSON, "csv": CSV, "deck": DECK}[form]
    for _ in range(rng.choice((1, 1, 1, 2, 3))):
        text = rng.choice(ways)(rng, text, others)
    data = text.encode("utf-8", "surrogatepass")
    return _bytes(rng, data) if rng.random() < 0.06 else data


def _damaged(rng: random.Random, data: bytes) -> bytes:
    """Change some bytes, or cut the end off."""
    out = bytearray(data)
    for _ in range(rng.choice((1, 1, 3, 30))):
        out[rng.randrange(len(out))] = rng.randrange(256)
    return bytes(out[: rng.randrange(len(out))] if rng.random() < 0.2 else out)


def _workbook(rng: random.Random, data: bytes) -> bytes:
    """Pack a workbook anew with another text in one of its parts."""
    with zipfile.ZipFile(io.BytesIO(data)) as packed:
        parts = {name: packed.read(name).decode() for name in packed.namelist()}
    name = rng.choice([*(each for each in parts if "sheet" in each), *parts])
    for _ in range(rng.choice((1, 1, 2))):
        parts[name] = rng.choice((_letter, _number, _tag, _tag, _reference))(rng, parts[name], ())
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as packed:
        for each, text in parts.items():
            packed.writestr(each, text.encode("utf-8", "surrogatepass"))
    return stream.getvalue()


def _tag(rng: random.Random, text: str, _: Sequence[str]) -> str:
    """Take an element's tag out, or put the text of another element in its place."""
    tags = list(re.finditer(r"<[^>]*>", text))
    texts = list(re.finditer(r">([^<>]+)<", text))
    if texts and rng.random() < 0.6:
        one, other = rng.choice(texts), rng.choice(texts)
        return text[: one.start(1)] + rng.choice((other[1], *CELLS[:-1])) + text[one.end(1) :]
    one = rng.choice(tags)
    return text[: one.start()] + text[one.end() :]


def _reference(rng: random.Random, text: str, _: Sequence[str]) -> str:
    """Put a cell elsewhere, near or far."""
    cells = list(re.finditer(r'r="([A-Z]+)(\d+)"', text))
    if not cells:
        return text
    one = rng.choice(cells)
    place = rng.choice(("XFD1048576", f"B{one[2]}", f"{one[1]}1048576", "A1", "ZZZZ1", "B0"))
    return text[: one.start()] + f'r="{place}"' + text[one.end() :]


def _bytes(rng: random.Random, data: bytes) -> bytes:
    """Do to the bytes what no editor does."""
    at = rng.randrange(len(data) + 1)
    way = rng.randrange(5)
    if way == 0:
        return data[:at]
    if way == 1:
        return data[:at] + rng.choice(RAW) + data[at:]
    if way == 2:
        return data[:at] + bytes([rng.randrange(256)]) + data[at + 1 :]
    if way == 3:
        return data.decode("utf-8", "replace").encode("utf-16")
    return rng.randbytes(rng.randrange(200))


# ------------------------------------------------------------------ lines of any text


def _drop_line(rng: random.Random, text: str, _: Sequence[str]) -> str:
    lines = text.split("\n")
    del lines[rng.randrange(len(lines))]
    return "\n".join(lines)


def _repeat_line(rng: random.Random, text: str, _: Sequence[str]) -> str:
    lines = text.split("\n")
    lines.insert(rng.randrange(len(lines) + 1), rng.choice(lines))
    return "\n".join(lines)


def _swap_lines(rng: random.Random, text: str, _: Sequence[str]) -> str:
    lines = text.split("\n")
    i, j = rng.randrange(len(lines)), rng.randrange(len(lines))
    lines[i], lines[j] = lines[j], lines[i]
    return "\n".join(lines)


def _strange_lines(rng: random.Random, text: str, others: Sequence[str]) -> str:
    lines, strange = text.split("\n"), rng.choice(others).split("\n")
    first = rng.randrange(len(strange))
    at = rng.randrange(len(lines) + 1)
    lines[at:at] = strange[first : first + rng.choice((1, 2, 5, 10))]
    return "\n".join(lines)


def _letter(rng: random.Random, text: str, _: Sequence[str]) -> str:
    at = rng.randrange(len(text) + 1)
    return (
        text[:at]
        + rng.choice('"[]{}=,.\n#x9 \\-\t\u00b5\u202e\x0b')
        + text[at + rng.randrange(2) :]
    )


def _number(rng: random.Random, text: str, _: Sequence[str]) -> str:
    """Change one number by a factor, by its sign or in its last digit."""
    found = list(NUMBER.finditer(text))
    if not found:
        return text
    one = rng.choice(found)
    value = float(one[0])
    factor = rng.choice((0.0, -1.0, 0.5, 2.0, 1.0 + 1e-9, 1e-3, 1e3, 1e-9, 1e9, 1e30, 1e-30))
    return f"{text[: one.start()]}{value * factor:.15g}{text[one.end() :]}"


# ------------------------------------------------------------------ TOML


def _value(rng: random.Random, text: str, _: Sequence[str]) -> str:
    lines = text.split("\n")
    places = [index for index, line in enumerate(lines) if VALUE.match(line)]
    if not places:
        return text
    index = rng.choice(places)
    found = VALUE.match(lines[index])
    assert found is not None
    lines[index] = f"{found[1]}{rng.choice(NASTY)}{found[3]}"
    return "\n".join(lines)


def _key(rng: random.Random, text: str, _: Sequence[str]) -> str:
    keys = list(re.finditer(r"^\s*([\w-]+)\s*=|^\[+([\w.]+)\]+", text, re.MULTILINE))
    if not keys:
        return text
    one = rng.choice(keys)
    group = 1 if one[1] else 2
    name = one[group]
    at = rng.randrange(len(name))
    other = rng.choice((name[:at] + name[at + 1 :], name.upper(), f'"{name}\\u0007"', name + "_x"))
    return text[: one.start(group)] + other + text[one.end(group) :]


def _section(rng: random.Random, text: str, others: Sequence[str]) -> str:
    """Leave a section out, or take one from another file in."""
    parts = re.split(r"(?=^\[)", text, flags=re.MULTILINE)
    strange = re.split(r"(?=^\[)", rng.choice(others), flags=re.MULTILINE)
    if rng.random() < 0.5 and len(parts) > 1:
        del parts[rng.randrange(len(parts))]
    else:
        parts.append("\n" + rng.choice(strange))
    return "".join(parts)


# ------------------------------------------------------------------ JSON


def _node(rng: random.Random, text: str, _: Sequence[str]) -> str:
    """Put something else in the place of one part of a document, or leave it out."""
    try:
        document = json.loads(text)
    except ValueError:
        return text
    places: list[tuple[Any, Any]] = []
    waiting = [document]
    while waiting:
        part = waiting.pop()
        if isinstance(part, dict):
            places += [(part, key) for key in part]
            waiting += part.values()
        elif isinstance(part, list):
            places += [(part, index) for index in range(len(part))]
            waiting += part
    if not places:
        return text
    part, key = rng.choice(places)
    if rng.random() < 0.3:
        del part[key]
    else:
        part[key] = rng.choice(
            (None, 0, -1, 7, 1e300, "x", "\u0007", "", [], [1], {}, True, {"a": 1})
        )
    return json.dumps(document, indent=1)


# ------------------------------------------------------------------ CSV


def _cell(rng: random.Random, text: str, _: Sequence[str]) -> str:
    lines = text.split("\n")
    index = rng.randrange(len(lines))
    cells = lines[index].split(",")
    cells[rng.randrange(len(cells))] = rng.choice(CELLS)
    lines[index] = ",".join(cells)
    return "\n".join(lines)


LINES: tuple[Mutation, ...] = (
    _drop_line,
    _repeat_line,
    _swap_lines,
    _strange_lines,
    _letter,
    _number,
)
TOML: tuple[Mutation, ...] = (*LINES, *(_number,) * 5, *(_value,) * 4, _key, _section)
JSON: tuple[Mutation, ...] = (*LINES, *(_number,) * 2, *(_node,) * 7)
CSV: tuple[Mutation, ...] = (*LINES, *(_number,) * 2, *(_cell,) * 4)


def _word(rng: random.Random, text: str, _: Sequence[str]) -> str:
    """Put another word into a line of words with blanks between them, or take one away."""
    lines = text.split("\n")
    k = rng.randrange(len(lines))
    words = lines[k].split()
    if not words:
        return text
    at = rng.randrange(len(words))
    words[at : at + 1] = rng.choice(([], [rng.choice(WORDS)], [words[at], rng.choice(WORDS)]))
    lines[k] = rng.choice((" ", " ", " ", "\t")).join(words)
    return "\n".join(lines)


WORDS = (
    *(cell for cell in CELLS if cell), "Free", "Fixed", "Coupled", "Vessel1", "connect", "depth",
    "#", "#5", "Body1", "R1A", "seabed", "1", "2", "99", "a|b", "omit_contact", "repeat", "---",
)  # fmt: skip
"""What the words of a deck may come to be."""

DECK: tuple[Mutation, ...] = (*LINES, *(_number,) * 2, *(_word,) * 5)
