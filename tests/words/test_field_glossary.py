"""docs/glossary.md explains every label of the first screens, and every word that it marks."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest

import catopt

ROOT = Path(catopt.__file__).parents[1]
PAGE = (ROOT / "docs" / "glossary.md").read_text("utf-8")
LABELS, TERMS = (
    {row.split(" | ")[0].lower() for row in re.findall(r"^\| (.+) \|$", part, re.MULTILINE)}
    for part in PAGE.split("## Terms")
)
SCREENS = ("README.md", "docs/quick-start.md", "docs/how-to/size-a-buoy.md")
COMMANDS = ("catopt size ", "catopt solve ")
BRIEF = re.compile(r"^([A-Z][A-Za-z, ]+): ")
FACTS = re.compile(r"(?:^| {3,})([A-Z](?:[A-Za-z0-9,/]| (?! ))*) {2,}(?=\d|after )")


def labels(screen: str) -> Iterator[str]:
    """Yield the labels of a screen, without the time that some end with."""
    for line in screen.splitlines():
        brief = BRIEF.match(line)
        for label in [brief[1]] if brief else FACTS.findall(line):
            yield re.sub(r", \d.*", "", label).lower()


def screens(name: str) -> Iterator[str]:
    text = (ROOT / name).read_text("utf-8")
    for command, screen in re.findall(r"```sh run\n(.*?)```\n\n```text\n(.*?)```", text, re.DOTALL):
        if any(each in command for each in COMMANDS):
            yield screen
    yield from re.findall(r"```sh\n[^`]*catopt size[^`]*```\n\n```text\n(.*?)```", text, re.DOTALL)


@pytest.mark.parametrize("name", SCREENS)
def test_every_label_of_a_first_screen_is_explained(name: str) -> None:
    found = {label for screen in screens(name) for label in labels(screen)}
    assert len(found) > 8
    assert found - LABELS == set()


def test_every_word_that_is_marked_is_explained() -> None:
    marked = {each.lower() for each in re.findall(r"\*([^*]+)\*", PAGE)}
    known = {word for term in TERMS for word in re.split(r", | \(|\)", term)}
    assert len(marked) > 10
    assert {each for each in marked if each.removesuffix("s") not in known} == set()
