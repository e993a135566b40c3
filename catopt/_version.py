"""The version, with its commit: asked of git in a checkout, kept by the build elsewhere.

A release is a commit with the tag of `RELEASE`. Any other commit is a development version before
it, which names the commit and says when its files were changed: ``1.1.0.dev9+g0123abcd.changed``.
"""

from __future__ import annotations

import runpy
from functools import cache
from pathlib import Path

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    __version__: str

RELEASE = "1.1.0"
"""The release that this tree is, or leads to."""

NO_GIT = f"{RELEASE}.dev0+no.git"
"""Version of a tree of which neither git nor a build says from which commit it is."""


@cache
def version_and_commit() -> tuple[str, str]:
    """Return the version (PEP 440) and the first eight digits of its commit, empty if not known."""
    root = Path(__file__).parents[1]
    if (root / ".git").exists():
        return _of_checkout(root)
    built = Path(__file__).with_name("_build.py")
    if not built.exists():
        return NO_GIT, ""
    told: dict[str, str] = runpy.run_path(str(built))
    return told["VERSION"], told["COMMIT"]


def identity() -> str:
    """Name the program as notes do: the version, with its commit where that is not part of it."""
    version, commit = version_and_commit()
    return version if commit in version else f"{version} ({commit})"


def _of_checkout(root: Path) -> tuple[str, str]:
    import subprocess

    def git(*arguments: str) -> str:
        command = ["git", "-C", str(root), *arguments]
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()

    try:
        described = git("describe", "--always", "--dirty", "--abbrev=8", "--exclude=*")
        count, tags = git("rev-list", "--count", "HEAD"), git("tag", "--points-at", "HEAD").split()
    except (OSError, subprocess.CalledProcessError):  # no git, or it refuses another user's tree
        return NO_GIT, ""
    commit, _, changed = described.partition("-")
    if f"v{RELEASE}" in tags and not changed:
        return RELEASE, commit
    return f"{RELEASE}.dev{count}+g{commit}{'.changed' if changed else ''}", commit


def __getattr__(name: str) -> Any:
    """Ask for the version when it is first wanted (PEP 562): most answers never do."""
    if name != "__version__":
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return version_and_commit()[0]
