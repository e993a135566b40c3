"""The glossary, docs/thuat-ngu.md: its terms stand in the texts, and what it refuses does not."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import catopt
from catopt.words import Message, say
from catopt.words.message import group, groups

PACKAGE = Path(catopt.__file__).parent
DOCS = PACKAGE.parent / "docs"
PAGE = DOCS / "thuat-ngu.md"


def rows() -> list[list[str]]:
    table = [line for line in PAGE.read_text("utf-8").splitlines() if line.startswith("| ")]
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in table[1:]]


def vietnamese() -> Iterator[tuple[str, str]]:
    """Yield every Vietnamese text that users read, with where it stands."""
    for name in groups():
        for key, text in group(name).items():
            told = text["vi"]
            for form in [told] if isinstance(told, str) else told.values():
                yield f"{name}.{key}", form
    for path in (
        PACKAGE / "cli/help.toml",
        *PACKAGE.glob("*/data/*.toml"),
        *DOCS.glob("cach-lam/*.md"),
        DOCS / "bat-dau-nhanh.md",
        PACKAGE / "page_api/shell.html",
    ):
        yield str(path), path.read_text("utf-8")


def found(word: str, text: str) -> bool:
    return re.search(rf"(?<!\w){re.escape(word)}(?!\w)", text, re.IGNORECASE) is not None


def test_no_refused_word_stands_in_a_text() -> None:
    refused = [word.strip() for _, _, words in rows() for word in words.split(",")]
    assert {"cục nặng", "khối neo", "của chính nó"} <= set(refused)
    told = list(vietnamese())
    assert len(told) > 3000
    assert [(at, word) for at, text in told for word in refused if found(word, text)] == []


def test_every_term_of_the_glossary_is_used() -> None:
    every = "\n".join(text for _, text in vietnamese())
    terms = [term.strip() for _, terms, _ in rows() for term in terms.split(",")]
    assert len(terms) >= 17
    assert [term for term in terms if not found(term, every)] == []


def test_no_comma_stands_between_digits() -> None:
    """Decimals have a point, and thousands a space: a comma beside a point would mislead."""
    texts = [
        (f"{name}.{key}", str(text["vi"])) for name in groups() for key, text in group(name).items()
    ]
    assert [(at, text) for at, text in texts if re.search(r"\d,\d", text)] == []
    said = Message("design.unsolved", count=6111)
    assert "6,111" in said
    assert "6\N{NO-BREAK SPACE}111" in say(said, "vi")
