"""What the documentation shows is what happens: its snippets run, its links lead somewhere."""

from __future__ import annotations

import re
from pathlib import Path
from typing import get_args

import pytest

from catopt.catenary.state import Regime
from tests.snippets import FENCE, PAGES, README, ROOT, Block, blocks, produce, shown, shows


def _of_readme() -> list[Block]:
    """Select what a newcomer types first."""
    return [block for block in shown() if block.page == README]


def check(block: Block, folder: Path) -> None:
    """Run a block and compare what it prints with what the page shows, if it shows any."""
    printed = produce(block, folder)
    if block.output is not None:
        assert shows(block.output, printed), "write it anew: python -m tests.snippets"


@pytest.mark.parametrize("block", _of_readme(), ids=str)
def test_what_readme_shows_runs_and_prints_it(block: Block, tmp_path: Path) -> None:
    check(block, tmp_path)


@pytest.mark.slow  # each block is a process of its own, and there are many
@pytest.mark.parametrize("block", shown(), ids=str)
def test_what_every_page_shows_runs_and_prints_it(block: Block, tmp_path: Path) -> None:
    check(block, tmp_path)


def test_readme_shows_what_the_first_command_prints_and_python_that_runs() -> None:
    """The tests above have these to do."""
    install, *others = blocks(README)
    assert install.code == ('catopt size tanker --dwt "50000 t" --depth "20 m" --out mooring\n')
    assert install.output is not None
    assert {"sh", "python"} <= {block.language for block in others}


def test_readme_gives_exactly_the_two_commands() -> None:
    lines = [line for line in README.read_text("utf-8").splitlines() if line.startswith("pip ")]
    assert lines == [
        'pip install . && catopt size tanker --dwt "50000 t" --depth "20 m" --out mooring',
        'pip install ".[test]" && pytest',
    ]


def test_a_wrong_output_and_a_failing_command_are_caught(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text(
        "```python run\nprint(6 * 7)\n```\n\n```text\n43\n```\n"
        "```sh run\ncatopt solve gone.toml\n```\n```python\nnot run\n```\n"
    )
    wrong, failing = blocks(page)
    assert (wrong.output, produce(wrong, tmp_path / "a")) == ("43\n", "42\n")
    with pytest.raises(AssertionError, match=r"catopt solve gone\.toml ended with 2"):
        produce(failing, tmp_path / "b")


@pytest.mark.parametrize(
    ("excerpt", "is_shown"),
    [
        ("a\nb\nc", True),
        ("a\n...\nc", True),
        ("...\nc", True),
        ("a\n...", True),
        ("a\nc", False),
        ("b\n...", False),
        ("...\nb", False),
        ("a\n...\nd\n...", False),
        ("...\n.\nc", False),
    ],
)
def test_lines_left_out_stand_for_any_and_the_others_for_themselves(
    excerpt: str, is_shown: bool
) -> None:
    assert shows(excerpt, "a\nb\nc\n") is is_shown


LINK = re.compile(r"(?<!!)\[[^\]]*\]\((?P<target>[^)\s]+)\)")
HEADING = re.compile(r"^#+ +(?P<title>.+?) *$", re.MULTILINE)


def anchors(page: Path) -> set[str]:
    """Anchors that GitHub gives the headings of a page."""
    text = FENCE.sub("", page.read_text(encoding="utf-8"))
    titles = [match["title"].lower() for match in HEADING.finditer(text)]
    return {re.sub(r"[^\w\- ]", "", title).replace(" ", "-") for title in titles}


def broken_links(page: Path) -> list[str]:
    """Links of a page to a file or a heading that is not there."""
    text = FENCE.sub("", page.read_text(encoding="utf-8"))
    broken = []
    for match in LINK.finditer(text):
        target = match["target"]
        if re.match(r"[a-z]+:", target):
            continue
        path, _, anchor = target.partition("#")
        goal = (page.parent / path).resolve() if path else page
        if not goal.exists() or (anchor and anchor not in anchors(goal)):
            broken.append(target)
    return broken


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_every_link_leads_somewhere(page: Path) -> None:
    assert broken_links(page) == []


def test_a_broken_link_is_caught(tmp_path: Path) -> None:
    (tmp_path / "there.md").write_text("# A heading, with words\n")
    page = tmp_path / "page.md"
    page.write_text(
        "[a](there.md) [b](gone.md) [c](there.md#a-heading-with-words) [d](there.md#other) "
        "[e](https://example.org/x)\n```text\n[f](gone.md)\n```\n"
    )
    assert broken_links(page) == ["gone.md", "there.md#other"]


@pytest.mark.parametrize(
    "page", [p for p in PAGES if p.parent.name == "docs" and p.name != "index.md"], ids=str
)
def test_the_index_names_every_page(page: Path) -> None:
    index = (ROOT / "docs" / "index.md").read_text(encoding="utf-8")
    assert f"({page.relative_to(ROOT / 'docs').as_posix()})" in index


def test_every_regime_is_explained() -> None:
    text = (ROOT / "docs" / "regimes.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| `([a-z-]+)` \|", text, re.MULTILINE)
    assert rows == list(get_args(Regime))


def test_what_is_new_is_short() -> None:
    """Who upgrades reads it whole: it had grown to 11,400 words, as one wrote it who changed it."""
    text = (ROOT / "CHANGELOG.md").read_text("utf-8")
    sections = re.split(r"^## ", text, flags=re.M)[1:]
    words = {each.split("\n")[0]: len(each.split()) for each in sections}
    unreleased, release, *_ = words.values()
    assert unreleased <= 1000, words
    assert release <= 2000, words
