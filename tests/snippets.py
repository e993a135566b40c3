"""Commands and Python shown in the documentation, and what they print.

A fenced block marked ``sh run`` or ``python run`` is run in a folder of its own that holds a copy
of ``cases/`` and what ``catopt new`` wrote in the blocks of the page before. So is what follows
``&& `` in README's install line. A ``text`` block that comes next, with nothing but blank lines or
the beginning of a fold between, is the output, character for character; a line ``...`` in it stands
for lines left out.

``python -m tests.snippets`` writes every such output anew, but for those with lines left out.
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
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

__all__ = [
    "ELLIPSIS",
    "FENCE",
    "PAGES",
    "README",
    "ROOT",
    "Block",
    "blocks",
    "produce",
    "shown",
    "shows",
]

ROOT = Path(__file__).parents[1]
README = ROOT / "README.md"
PAGES = sorted(
    [*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md"), *(ROOT / "reports").rglob("*.md")]
)
FENCE = re.compile(r"^```(?P<info>[^\n`]*)\n(?P<body>.*?)^```$", re.MULTILINE | re.DOTALL)
FOLD = re.compile(r"</?details>|<summary>.*?</summary>", re.DOTALL)
"""What folds a long output away; it may stand between a block and what it prints."""
INSTALL = "pip install . && "
ELLIPSIS = "..."


@dataclass(frozen=True)
class Block:
    """A fenced block that is run.

    Attributes
    ----------
    page, line : Path, int
        Where it begins.
    language : str
        ``"sh"`` or ``"python"``.
    code : str
        What is run.
    output : str or None
        What is shown of its output; None when nothing is.
    output_span : tuple of int
        Where in the page that stands; empty when nothing is.
    before : tuple of str
        Commands of the page's blocks before that write the files it starts from.
    """

    page: Path
    line: int
    language: str
    code: str
    output: str | None
    output_span: tuple[int, int]
    before: tuple[str, ...] = ()

    def __str__(self) -> str:
        return f"{self.page.name}:{self.line}"


def blocks(page: Path) -> Iterator[Block]:
    """Every block of a page that is run."""
    text = page.read_text(encoding="utf-8")
    found = list(FENCE.finditer(text))
    before: tuple[str, ...] = ()
    for index, match in enumerate(found):
        language, _, mark = match["info"].partition(" ")
        code = match["body"].removeprefix(INSTALL)
        if mark != "run" and code == match["body"]:
            continue
        after = found[index + 1] if index + 1 < len(found) else None
        line = text.count("\n", 0, match.start()) + 1
        between = FOLD.sub("", text[match.end() : after.start()]) if after else ""
        if after and after["info"] == "text" and not between.strip():
            yield Block(page, line, language, code, after["body"], after.span("body"), before)
        else:
            yield Block(page, line, language, code, None, (0, 0), before)
        before += tuple(each for each in code.splitlines() if each.startswith("catopt new "))


def shown() -> list[Block]:
    """Every block of every page that is run."""
    return [block for page in PAGES for block in blocks(page)]


def produce(block: Block, folder: Path) -> str:
    """Run a block in a new folder that is given a copy of the cases; return what it prints."""
    shutil.copytree(ROOT / "cases", folder / "cases")
    for command in block.before:
        _run(command, folder)
    if block.language == "sh":
        return "".join(_run(command, folder) for command in block.code.splitlines())
    assert block.language == "python", f"{block} is marked to run, but not as sh or python"
    printed = io.StringIO()
    with contextlib.chdir(folder), contextlib.redirect_stdout(printed):
        exec(compile(block.code, str(block), "exec"), {"__name__": "__main__"})
    return printed.getvalue()


def shows(excerpt: str, printed: str) -> bool:
    """Whether what a page shows is what is printed, `ELLIPSIS` standing for any lines."""
    parts = [
        re.escape(part) for part in re.split(r"^\.\.\.$\n?", excerpt.strip("\n") + "\n", flags=re.M)
    ]
    return re.fullmatch("(?:.*\n)*?".join(parts), printed.strip("\n") + "\n") is not None


def _run(command: str, folder: Path) -> str:
    """Run one line ``catopt ...`` as somebody with a terminal of 80 columns would."""
    program, *arguments = shlex.split(command, comments=True)
    assert program == "catopt", f"{command!r} is not a catopt command"
    environment = {k: v for k, v in os.environ.items() if k not in {"FORCE_COLOR", "NO_COLOR"}}
    run = subprocess.run(
        [sys.executable, "-m", "catopt", *arguments],
        cwd=folder,
        env={**environment, "COLUMNS": "80", "PYTHONUTF8": "1"},
        capture_output=True,
        encoding="utf-8",
        check=False,
        timeout=300,
    )
    assert run.returncode == 0, f"{command} ended with {run.returncode}\n{run.stderr}"
    return run.stdout


def _refresh(page: Path) -> None:
    """Write the outputs that a page shows anew."""
    text = page.read_text(encoding="utf-8")
    for block in reversed(list(blocks(page))):
        if block.output is not None and ELLIPSIS not in block.output.splitlines():
            with tempfile.TemporaryDirectory() as folder:
                output = produce(block, Path(folder)).strip("\n")
            start, end = block.output_span
            text = f"{text[:start]}{output}\n{text[end:]}"
    page.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    for each in PAGES:
        _refresh(each)
