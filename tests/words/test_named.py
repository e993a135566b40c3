"""Every option, command and key that a message names exists.

Messages are the texts in both languages, those of the help, and the strings in the code.
"""

from __future__ import annotations

import ast
import re
import tomllib
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import Any

import pytest

import catopt
from catopt.casefile.schema import CaseTable, NetworkTable, TableSchema, entries
from catopt.model.design import FIND_QUANTITIES
from catopt.reproduce import names
from catopt.sizing.kinds import schema_of
from catopt.study.file import StudyTable
from tests.cli.command_page import whole

ROOT = Path(catopt.__file__).parent
TEXTS = sorted((ROOT / "words" / "texts").glob("*.toml"))
HELP = ROOT / "cli" / "help.toml"

EVERYWHERE = {"--help", "--help-all"}
"""Options that no command lists."""
VERBS = {
    "behind",
    "by",
    "compiles",
    "continues",
    "counts",
    "did",
    "does",
    "goes",
    "has",
    "itself",
    "takes",
    "ghi",
}
"""What catopt is said to do, where it is no command."""
OF_OTHERS = {"site.general", "mooring_systems", "line_types"}
"""Keys of other programs' files."""
ROOTS = (CaseTable, NetworkTable, StudyTable, schema_of("buoy"), schema_of("tanker"))
FOR_OTHERS = {"_version.py", "pdf.py"}
"""What types options of another program."""
VALUES = {*FIND_QUANTITIES, *names()}
"""Words with underscores that are values of a key or of an argument."""


def texts_of(table: Mapping[str, Any], name: str) -> Iterator[tuple[str, str]]:
    for key, value in table.items():
        if isinstance(value, Mapping):
            yield from texts_of(value, f"{name}.{key}")
        elif isinstance(value, str):
            yield f"{name}.{key}", value


def strings_of(path: Path) -> Iterator[tuple[str, str]]:
    """Yield the strings of a file that are no docstrings."""
    tree = ast.parse(path.read_text("utf-8"))
    bodies = (body for each in ast.walk(tree) if isinstance(body := getattr(each, "body", 0), list))
    docs = {id(each.value) for body in bodies for each in body if isinstance(each, ast.Expr)}
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in docs:
            yield f"{path.relative_to(ROOT)}:{node.lineno}", node.value


@cache
def texts() -> tuple[tuple[str, str], ...]:
    found = [
        each
        for path in (*TEXTS, HELP)
        for each in texts_of(tomllib.loads(path.read_text("utf-8")), path.stem)
    ]
    return tuple(found)


@cache
def messages() -> tuple[tuple[str, str], ...]:
    files = (path for path in sorted(ROOT.rglob("*.py")) if path.name not in FOR_OTHERS)
    code = (each for path in files for each in strings_of(path))
    return tuple(each for each in (*texts(), *code) if "--" in each[1] or "catopt " in each[1])


# ------------------------------------------------------------------ options and commands


@cache
def commands() -> Mapping[tuple[str, ...], set[str]]:
    """List the options of every command, by the words that are typed after catopt."""
    found: dict[tuple[str, ...], set[str]] = {}

    def walk(one: Any, typed: tuple[str, ...]) -> None:
        found[typed] = {
            option
            for each in one.params
            for option in (*each.opts, *each.secondary_opts)
            if option.startswith("--")
        }
        for name, below in getattr(one, "commands", {}).items():
            walk(below, (*typed, name))

    walk(whole(), ())
    return found


@cache
def options() -> set[str]:
    """All options of all commands."""
    return {*EVERYWHERE, *(option for each in commands().values() for option in each)}


_OPTION = re.compile(r"(?<![\w-])--[a-z][a-z-]*[a-z]")
_TYPED = re.compile(
    r"catopt ([a-z]+)(?!\w)((?: [a-z]+(?!\w))?)((?:,? (?:--[a-z][a-z-]*|[A-Z]+\b|\"[^\"]*\"))*)"
)


def unknown_options(text: str) -> list[str]:
    """List what a text tells to type and no command has."""
    wrong = [option for option in _OPTION.findall(text) if option not in options()]
    for name, below, rest in _TYPED.findall(text):
        typed: tuple[str, ...] = (name,)
        if typed not in commands():
            wrong += [] if name in VERBS else [f"catopt {name}"]
            continue
        if (name, below.strip()) in commands():
            typed = (name, below.strip())
        own = {*commands()[typed], *commands()[()], *EVERYWHERE}
        wrong += [f"catopt {name} {o}" for o in _OPTION.findall(rest) if o not in own]
    return wrong


def test_every_option_and_command_that_is_named_exists() -> None:
    assert len(messages()) > 300
    assert [(place, wrong) for place, text in messages() if (wrong := unknown_options(text))] == []


# ------------------------------------------------------------------ keys


@cache
def keys() -> Mapping[str, set[str]]:
    """All keys of files, each with those of the tables that it opens anywhere."""
    found: dict[str, set[str]] = {}
    seen: set[type[TableSchema]] = set()
    left: list[type[TableSchema]] = list(ROOTS)
    while left:
        table = left.pop()
        if table in seen:
            continue
        seen.add(table)
        for key, entry in entries(table).items():
            below = found.setdefault(key, set())
            if entry.table is not None:
                below |= set(entries(entry.table))
                left.append(entry.table)
    return found


@cache
def attributes() -> set[str]:
    """List the attributes of ships, buoys and sizings: Python gives some that no file has."""
    code = (
        path.read_text("utf-8") for of in ("loads", "sizing") for path in (ROOT / of).glob("*.py")
    )
    return {name for text in code for name in re.findall(r"(?m)^    ([a-z_]+): ", text)}


_PLACEHOLDER = re.compile(r"\{[^}]*\}")
_HEADER = re.compile(r"\[{1,2}([a-z]+(?:_[a-z]+)*(?:\.[a-z_]+)*)\]{1,2}")
_KEY = re.compile(r"(?<![\w./-])([a-z]{2,}(?:_[a-zA-Z0-9]+)+)(?![\w(/=-])")
_BELOW = re.compile(r"(?<![\w./-])([a-z_]+)\.([a-z_]+)(?![\w.(/])")


def unknown_keys(text: str) -> list[str]:
    """List tables, keys and keys of tables that a text names and no file has."""
    said = _PLACEHOLDER.sub("", text)
    wrong = [
        f"[{name}]" for name in _HEADER.findall(said) if not set(name.split(".")) <= keys().keys()
    ]
    known = {*keys(), *VALUES, *OF_OTHERS, *attributes()}
    wrong += [key for key in _KEY.findall(said) if key not in known]
    for table, key in _BELOW.findall(said):
        if keys().get(table) and key not in keys()[table] and f"{table}.{key}" not in OF_OTHERS:
            wrong.append(f"{table}.{key}")
    return wrong


def test_every_key_that_is_named_exists() -> None:
    assert [(place, wrong) for place, text in texts() if (wrong := unknown_keys(text))] == []


# ------------------------------------------------------------------ the tests can fail


@pytest.mark.parametrize(
    ("text", "wrong"),
    [
        ("catopt system --without takes each out", ["--without", "catopt system --without"]),
        ("catopt check CASE --line-out", ["catopt check --line-out"]),
        ("catopt swim CASE", ["catopt swim"]),
        ("catopt catalog show NAME --diameter", []),
        ("with --line-out of catopt system; catopt has none", []),
    ],
)
def test_an_option_that_is_none_is_found(text: str, wrong: list[str]) -> None:
    assert unknown_options(text) == wrong


@pytest.mark.parametrize(
    ("text", "wrong"),
    [
        ("a table [chekcs] is required", ["[chekcs]"]),
        ("give line.segmets and site.water_depth", ["line.segmets"]),
        ("give seabed_frictoin, or {no_key}", ["seabed_frictoin"]),
        ("give [[load_cases]] and min_grounded_length", []),
    ],
)
def test_a_key_that_is_none_is_found(text: str, wrong: list[str]) -> None:
    assert unknown_keys(text) == wrong
