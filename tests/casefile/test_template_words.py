"""Every alternative that a comment of a template names is one that is read."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest

from catopt.casefile import TEMPLATES, parse_case, template
from catopt.casefile.reading import Moored
from catopt.casefile.schema import CaseTable, NetworkTable, TableSchema, entries
from catopt.model.kinds import OneOf
from catopt.sizing.file import read_file
from catopt.sizing.kinds import schema_of
from catopt.study.file import StudyTable

SIZED: dict[str, Moored] = {"size-buoy": "buoy", "size-tanker": "tanker"}
TOPS: dict[str, type[TableSchema]] = {
    "points": NetworkTable,
    "study": StudyTable,
    **{name: schema_of(moored) for name, moored in SIZED.items()},
}
"""What the templates that are no cases are for, and their schema."""

Keys = dict[str, list[str]]

TAKEN_IN: dict[tuple[str, str], Keys] = {
    ("kind", "reference"): {"load_cases": ["name", "horizontal_force"]},
    ("state", "one_line_out"): {"load_cases": ["name", "horizontal_force"]},
    ("condition", "new"): {
        "load_cases": ["name", "horizontal_force"],
        "service": ["[]", "life", "wear_rate"],
    },
    ("kind", "drag"): {"anchor": ["holding_capacity"]},
    ("quantity", "clump_weight"): {
        "find": ["anchor_angle"],
        "line.point_loads": ["position", "submerged_weight"],
    },
    ("quantity", "limit_force"): {"line.segments": ["MBL"]},
    ("drag_axial_area", "pi D"): {"line.segments": ["drag_axial"]},
    ("profile", "wind"): {"current": ["depth"]},
    **{
        ("wear_zone", zone): {"service": ["[]", "life", "wear_table"]}
        for zone in ("splash", "catenary", "wire")
    },
    **{
        ("wear_table", name): {"service": ["[]", "life"]}
        for name in ("E301", "E301-inspected", "E301-Norway", "tropical")
    },
    ("profile", "table"): {"current": ["depths", "speeds"]},
}
"""Keys that are commented out and go with an alternative, by section."""
LEFT_OUT: dict[tuple[str, str], Keys] = {
    ("quantity", "touchdown_force"): {"load": ["[]", "horizontal_force"]},
    ("quantity", "limit_force"): {"load": ["[]", "horizontal_force"]},
    ("profile", "table"): {"current": ["speed"]},
}
"""Keys that do not go with it."""


class Named(NamedTuple):
    """A key, and a word of its comment that may stand for its value."""

    template: str
    section: str
    key: str
    word: str


def lines_of(text: str) -> Iterator[tuple[str, str, str]]:
    """Yield each line of a template with its section and its key, commented out or not."""
    section = ""
    for line in text.splitlines():
        header = re.match(r"(?:# )?\[+([\w.]+)\]+", line)
        section = header.group(1) if header else section
        given = re.match(r"(?:# )?(\w+) = ", line)
        yield section, given.group(1) if given else "[]" if header else "", line


def named() -> Iterator[Named]:
    """Yield every alternative that a comment names: "or one, another; and further words"."""
    for name in TEMPLATES:
        for section, key, line in lines_of(template(name)):
            _, _, comment = line.rpartition("  # ")
            said = re.match(r"or (?!others of|a component)([^;:(]+)", comment)
            if key not in ("", "[]") and said:
                for word in re.split(r", ", said.group(1)):
                    yield Named(name, section, key, word.strip().strip('"'))


def with_word(named: Named) -> str:
    """Write the template with the word for its value, and with what goes with it."""
    choice = (named.key, named.word)
    taken = {named.section: [named.key]} | TAKEN_IN.get(choice, {})
    taken[named.section] = [named.key, *taken[named.section]]
    out = LEFT_OUT.get(choice, {})
    written = []
    for section, key, line in lines_of(template(named.template)):
        if key in out.get(section, []):
            continue
        bare = line.removeprefix("# ") if key in [*taken.get(section, []), "[]"] else line
        bare = line if key == "[]" and section not in taken else bare
        if (section, key) == (named.section, named.key):
            bare = re.sub(r'"[^"]*"', f'"{named.word}"', bare, count=1)
        written.append(bare)
    return "\n".join(written)


@pytest.mark.parametrize("each", list(named()), ids=lambda each: ".".join(each[1:]))
def test_a_named_alternative_is_read(each: Named, tmp_path: Path) -> None:
    text = with_word(each)
    assert f'"{each.word}"' in text
    if each.template in SIZED:
        path = tmp_path / "sizing.toml"
        path.write_text(text, encoding="utf-8")
        assert read_file(path, SIZED[each.template]).findings == ()
    else:
        parse_case(text)


def kind_of(top: type[TableSchema], section: str, key: str) -> object:
    """Look up what a key of a section holds."""
    table = top
    for part in section.split(".") if section else []:
        inner = entries(table)[part].table
        assert inner is not None
        table = inner
    return entries(table)[key].kind


def test_where_a_key_takes_one_of_several_words_all_are_named() -> None:
    """In the template that has every key, and wherever others of them are named at all."""
    found = list(named())
    for name in TEMPLATES:
        top = TOPS.get(name, CaseTable)
        for section, key, line in lines_of(template(name)):
            if key in ("", "[]"):
                continue
            kind = kind_of(top, section, key)
            words = {each.word for each in found if each[:3] == (name, section, key)}
            given = set(re.findall(r'"([^"]*)"', line.partition("  #")[0]))
            if isinstance(kind, OneOf) and (words or name in ("buoy", "motion")):
                assert words | given == set(kind.words), (name, key)
