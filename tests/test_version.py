"""The version: from git in a checkout, kept by a build, said where neither knows it."""

from __future__ import annotations

import re
import runpy
import shutil
import subprocess
import tomllib
from pathlib import Path

import pytest

from catopt._version import NO_GIT, RELEASE

SOURCE = Path(__file__).parents[1] / "catopt" / "_version.py"


def git(folder: Path, *arguments: str) -> str:
    command = ["git", "-C", str(folder), "-c", "user.name=n", "-c", "user.email=e", *arguments]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.strip()


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    """Make a tree with the module in it, without git."""
    (tmp_path / "catopt").mkdir()
    shutil.copy(SOURCE, tmp_path / "catopt" / "_version.py")
    return tmp_path


@pytest.fixture
def checkout(tree: Path) -> Path:
    """Make a repository of one commit."""
    git(tree, "init", "-q")
    git(tree, "add", ".")
    git(tree, "commit", "-qm", "first")
    return tree


def change(tree: Path) -> None:
    place = tree / "catopt" / "_version.py"
    place.write_text(place.read_text() + "# changed\n")


def told(tree: Path) -> tuple[str, str]:
    found: tuple[str, str] = runpy.run_path(str(tree / "catopt" / "_version.py"))[
        "version_and_commit"
    ]()
    return found


needs_git = pytest.mark.skipif(shutil.which("git") is None, reason="there is no git")


@needs_git
def test_a_commit_is_named_after_the_release_that_it_leads_to(checkout: Path) -> None:
    commit = git(checkout, "rev-parse", "--short=8", "HEAD")
    assert told(checkout) == (f"{RELEASE}.dev1+g{commit}", commit)


@needs_git
def test_changed_files_are_said(checkout: Path) -> None:
    change(checkout)
    assert told(checkout)[0].endswith(".changed")


@needs_git
def test_the_tag_of_the_release_makes_it_one(checkout: Path) -> None:
    git(checkout, "tag", f"v{RELEASE}")
    assert told(checkout)[0] == RELEASE
    change(checkout)
    assert told(checkout)[0].endswith(".changed")


@needs_git
def test_a_repository_around_an_installed_package_is_not_its_own(checkout: Path) -> None:
    inner = checkout / "site-packages"
    shutil.copytree(checkout / "catopt", inner / "catopt")
    assert told(inner) == (NO_GIT, "")


def test_a_tree_without_git_says_so(tree: Path) -> None:
    assert told(tree) == (NO_GIT, "")


def test_a_build_keeps_it(tree: Path) -> None:
    (tree / "catopt" / "_build.py").write_text('VERSION = "1.1.0"\nCOMMIT = "0123abcd"\n')
    assert told(tree) == ("1.1.0", "0123abcd")


def test_a_release_is_tried_with_the_lowest_and_the_newest_numba() -> None:
    """Its internals are patched: no version between the bounds of pyproject.toml is a guess."""
    root = SOURCE.parents[1]
    asked = tomllib.loads((root / "pyproject.toml").read_text("utf-8"))["project"]["dependencies"]
    bounds = {each.split(">=")[0]: each.split(">=")[1] for each in asked if ">=" in each}
    lowest, beyond = bounds["numba"].split(",<")
    major, minor = map(int, beyond.split("."))
    workflow = (root / ".github" / "workflows" / "release.yml").read_text("utf-8")
    tried = dict.fromkeys(re.findall(r'"(\w+)==([\d.]+)\.\*"', workflow))
    for name in ("numpy", "scipy", "pandas"):
        assert (name, bounds[name]) in tried
    assert ("numba", lowest) in tried
    assert ("numba", f"{major}.{minor - 1}") in tried
