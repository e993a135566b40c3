"""A new kind of check is made as docs/architecture.md shows it, in a copy of catopt, and runs."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import jsonschema
import pytest

from tests.snippets import ROOT

PAGE = ROOT / "docs" / "architecture.md"
DIFF = re.compile(r"^```diff (\S+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
CASE = ROOT / "cases" / "tanker-20m" / "case.toml"
DESIGN = ROOT / "cases" / "design-tanker-20m" / "case.toml"


def applied(text: str, diff: str) -> str:
    """Apply the parts of a diff, each of which stands in the text once."""
    for part in diff.split("@@\n"):
        lines = part.splitlines()
        before = "\n".join(each[1:] for each in lines if not each.startswith("+"))
        after = "\n".join(each[1:] for each in lines)
        assert text.count(before) == 1, before
        text = text.replace(before, after)
    return text


Typed = Callable[..., subprocess.CompletedProcess[str]]


@pytest.fixture(scope="module")
def typed(tmp_path_factory: pytest.TempPathFactory) -> Typed:
    """Give what runs Python in a copy in which the page's changes are made."""
    copy = tmp_path_factory.mktemp("new-check")
    unread = shutil.ignore_patterns("__pycache__")
    for part in ("catopt", "tests"):
        shutil.copytree(ROOT / part, copy / part, ignore=unread)
    found = DIFF.findall(PAGE.read_text("utf-8"))
    assert len(found) == 3
    for name, diff in found:
        path = copy / name
        path.write_text(applied(path.read_text("utf-8"), diff), "utf-8")

    def run(*words: str | Path) -> subprocess.CompletedProcess[str]:
        command = [sys.executable, "-m", *map(str, words)]
        environment = {**os.environ, "PYTHONPATH": str(copy), "COLUMNS": "100"}
        return subprocess.run(
            command, cwd=copy, env=environment, capture_output=True, text=True, check=False
        )

    assert run("tests.schemas").returncode == 0
    return run


def with_limit(case: Path, folder: Path, limit: str) -> Path:
    """Write a case that asks for the new check."""
    path = folder / "case.toml"
    text = case.read_text("utf-8")
    path.write_text(text.replace("[checks]", f"[checks]\nmax_anchor_pull = '{limit}'", 1), "utf-8")
    return path


@pytest.mark.slow
@pytest.mark.parametrize(
    ("lang", "word"), [("en", "horizontal pull at the anchor"), ("vi", "lực kéo ngang tại neo")]
)
def test_it_is_checked_and_shown(typed: Typed, tmp_path: Path, lang: str, word: str) -> None:
    case = with_limit(CASE, tmp_path, "80 kN")
    shown = typed("catopt", "check", case, "--lang", lang)
    assert shown.returncode == 0, shown.stderr
    assert word in " ".join(shown.stdout.split())
    made = typed("catopt", "report", case, "--lang", lang, "--out", tmp_path / "note")
    assert made.returncode == 0, made.stderr
    notes = [each.read_text("utf-8") for each in (tmp_path / "note").glob("*.html")]
    assert any(word.capitalize() in each or word in each for each in notes)


@pytest.mark.slow
def test_its_document_keeps_to_the_schema(typed: Typed, tmp_path: Path) -> None:
    said = typed("catopt", "check", with_limit(CASE, tmp_path, "80 kN"), "--json")
    document = json.loads(said.stdout)
    schema = typed("tests.checks.test_new_check")
    jsonschema.validate(document, json.loads(schema.stdout))
    (found,) = [each for each in document["checks"] if each["kind"] == "anchor_pull"]
    assert found["capacity"] == 80e3
    assert not found["passes"]


@pytest.mark.slow
def test_a_search_that_does_not_keep_it_says_so(typed: Typed, tmp_path: Path) -> None:
    said = typed("catopt", "design", with_limit(DESIGN, tmp_path, "80 kN"))
    assert said.returncode == 2
    assert "anchor_pull" in said.stderr
    assert "no search keeps this check" in said.stderr


if __name__ == "__main__":
    import catopt.schemas

    sys.stdout.write(json.dumps(catopt.schemas.schema("catopt.check/1")))
