"""What the documentation shows is what happens: its snippets run, its links lead somewhere.

A fenced block marked ``sh run`` or ``python run`` is run in a folder of its own that holds a copy
of ``cases/``. A ``text`` block that follows it at once, with nothing but blank lines between, is
its output, character for character.
"""

from __future__ import annotations

import contextlib
import io
import os
import re
import shlex
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
PAGES = sorted(
    [*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md"), *(ROOT / "reports").rglob("*.md")]
)
README = ROOT / "README.md"

FENCE = re.compile(r"^```(?P<info>[^\n`]*)\n(?P<body>.*?)^```$", re.MULTILINE | re.DOTALL)


@dataclass(frozen=True)
class Block:
    """A fenced block, and the output shown after it (None when none is shown)."""

    page: Path
    line: int
    info: str
    body: str
    output: str | None

    def __str__(self) -> str:
        return f"{self.page.relative_to(ROOT).as_posix()}:{self.line}"


def blocks(page: Path) -> list[Block]:
    """Every fenced block of a page with the output that follows it."""
    text = page.read_text(encoding="utf-8")
    found = list(FENCE.finditer(text))
    result = []
    for index, match in enumerate(found):
        output = None
        if index + 1 < len(found):
            after = found[index + 1]
            between = text[match.end() : after.start()]
            if after["info"] == "text" and not between.strip():
                output = after["body"]
        line = text.count("\n", 0, match.start()) + 1
        result.append(Block(page, line, match["info"].strip(), match["body"], output))
    return result


def marked(info: str) -> list[Block]:
    return [block for page in PAGES for block in blocks(page) if block.info == info]


@pytest.fixture
def workplace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Make a folder with a copy of the cases and work there."""
    shutil.copytree(ROOT / "cases", tmp_path / "cases")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def run_catopt(command: str, folder: Path) -> subprocess.CompletedProcess[str]:
    """Run one line ``catopt ...`` as somebody with a terminal of 80 columns would."""
    program, *arguments = shlex.split(command, comments=True)
    assert program == "catopt", f"{command!r} is not a catopt command"
    environment = {k: v for k, v in os.environ.items() if k not in {"FORCE_COLOR", "NO_COLOR"}}
    return subprocess.run(
        [sys.executable, "-m", "catopt", *arguments],
        cwd=folder,
        env={**environment, "COLUMNS": "80", "PYTHONUTF8": "1"},
        capture_output=True,
        encoding="utf-8",
        check=False,
        timeout=120,
    )


@pytest.mark.parametrize("block", marked("sh run"), ids=str)
def test_every_shown_command_prints_what_is_shown(block: Block, workplace: Path) -> None:
    printed = ""
    for command in block.body.splitlines():
        run = run_catopt(command, workplace)
        assert run.returncode == 0, f"{command}\n{run.stderr}"
        printed += run.stdout
    if block.output is not None:
        assert printed.strip("\n") == block.output.strip("\n")


@pytest.mark.parametrize("block", marked("python run"), ids=str)
@pytest.mark.usefixtures("workplace")
def test_every_shown_python_runs_and_prints_what_is_shown(block: Block) -> None:
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(compile(block.body, str(block), "exec"), {"__name__": "__main__"})
    if block.output is not None:
        assert printed.getvalue().strip("\n") == block.output.strip("\n")


def test_readme_shows_commands_and_python_that_run() -> None:
    """The two tests above have something to do."""
    infos = [block.info for block in blocks(README)]
    assert {"sh run", "python run"} <= set(infos)


def test_readme_gives_exactly_the_two_commands() -> None:
    lines = [line for line in README.read_text("utf-8").splitlines() if line.startswith("pip ")]
    assert lines == [
        "pip install . && catopt reproduce buoy_9p5m",
        'pip install ".[test]" && pytest',
    ]


def test_readme_shows_what_the_first_command_prints(tmp_path: Path) -> None:
    (block,) = [b for b in blocks(README) if b.body.startswith("pip install . && ")]
    command = block.body.strip().removeprefix("pip install . && ")
    run = run_catopt(command, tmp_path)
    assert run.returncode == 0, run.stderr
    assert block.output is not None
    assert run.stdout.strip("\n") == block.output.strip("\n")


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
