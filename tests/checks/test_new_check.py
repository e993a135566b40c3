"""A new kind of check is made as docs/architecture.md shows it, in a copy of catopt, and runs."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import jsonschema
import pytest

from tests.places import Copy
from tests.snippets import ROOT

CASE = ROOT / "cases" / "tanker-20m" / "case.toml"
DESIGN = ROOT / "cases" / "design-tanker-20m" / "case.toml"


@pytest.fixture(scope="module")
def copy(tmp_path_factory: pytest.TempPathFactory) -> Copy:
    """Give a copy in which the page's changes are made."""
    folder = tmp_path_factory.mktemp("new-check") / "copy"
    made = Copy.changed(folder, "## A new check, a new column")
    assert made.run("tests.schemas").returncode == 0
    return made


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
def test_it_is_checked_and_shown(copy: Copy, tmp_path: Path, lang: str, word: str) -> None:
    case = with_limit(CASE, tmp_path, "80 kN")
    shown = copy.run("catopt", "check", case, "--lang", lang)
    assert shown.returncode == 0, shown.stderr
    assert word in " ".join(shown.stdout.split())
    made = copy.run("catopt", "report", case, "--lang", lang, "--out", tmp_path / "note")
    assert made.returncode == 0, made.stderr
    notes = [each.read_text("utf-8") for each in (tmp_path / "note").glob("*.html")]
    assert any(word.capitalize() in each or word in each for each in notes)


@pytest.mark.slow
def test_its_document_keeps_to_the_schema(copy: Copy, tmp_path: Path) -> None:
    said = copy.run("catopt", "check", with_limit(CASE, tmp_path, "80 kN"), "--json")
    document = json.loads(said.stdout)
    schema = copy.run("tests.checks.test_new_check")
    jsonschema.validate(document, json.loads(schema.stdout))
    (found,) = [each for each in document["checks"] if each["kind"] == "anchor_pull"]
    assert found["capacity"] == 80e3
    assert not found["passes"]


@pytest.mark.slow
def test_a_search_that_does_not_keep_it_says_so(copy: Copy, tmp_path: Path) -> None:
    said = copy.run("catopt", "design", with_limit(DESIGN, tmp_path, "80 kN"))
    assert said.returncode == 2
    assert "anchor_pull" in said.stderr
    assert "the search does not apply this check" in said.stderr


if __name__ == "__main__":
    import catopt.schemas

    sys.stdout.write(json.dumps(catopt.schemas.schema("catopt.check/1")))
