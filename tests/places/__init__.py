"""Changes that docs/architecture.md shows, made in copies of catopt."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

from tests.snippets import ROOT

PAGE = ROOT / "docs" / "architecture.md"
DIFF = re.compile(r"^```diff (\S+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def applied(text: str, diff: str) -> str:
    """Apply the parts of a diff, each of which stands in the text once."""
    for part in diff.split("@@\n"):
        lines = part.splitlines()
        before = "\n".join(each[1:] for each in lines if not each.startswith("+"))
        after = "\n".join(each[1:] for each in lines if not each.startswith("-"))
        assert text.count(before) == 1, before
        text = text.replace(before, after)
    return text


def section(heading: str) -> str:
    """Text of the page from a heading to the next of its rank or above."""
    page = PAGE.read_text("utf-8")
    begin = page.index(f"\n{heading}\n") + 1
    rank = heading.index(" ")
    following = re.search(rf"^#{{1,{rank}}} ", page[begin + rank :], re.MULTILINE)
    return page[begin:] if following is None else page[begin : begin + rank + following.start()]


@dataclass(frozen=True)
class Copy:
    """A copy of catopt and its tests in which changes are made."""

    folder: Path

    @classmethod
    def changed(cls, folder: Path, heading: str) -> Copy:
        """Make the changes that a section of the page shows, all of them."""
        unread = shutil.ignore_patterns("__pycache__")
        for part in ("catopt", "tests"):
            shutil.copytree(ROOT / part, folder / part, ignore=unread)
        found = DIFF.findall(section(heading))
        assert found
        for name, diff in found:
            path = folder / name
            text = path.read_text("utf-8") if path.exists() else ""
            path.write_text(applied(text, diff), "utf-8")
        return cls(folder)

    def run(self, *words: str | Path) -> subprocess.CompletedProcess[str]:
        """Run a module of the copy."""
        return self._python("-m", *map(str, words))

    def python(self, text: str) -> str:
        """Run a program in the copy; return what it prints."""
        done = self._python("-c", text)
        assert done.returncode == 0, done.stderr
        return done.stdout.strip()

    def _python(self, *words: str) -> subprocess.CompletedProcess[str]:
        environment = {**os.environ, "PYTHONPATH": str(self.folder), "COLUMNS": "100"}
        command = [sys.executable, *words]
        return subprocess.run(
            command, cwd=self.folder, env=environment, capture_output=True, text=True, check=False
        )
