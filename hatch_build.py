"""Puts into what is built what git and the host say of it: version, commit, addresses."""

import os
import runpy
import subprocess
from pathlib import Path
from tempfile import NamedTemporaryFile
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface
from hatchling.metadata.plugin.interface import MetadataHookInterface


class KeepVersion(BuildHookInterface):  # type: ignore[misc, type-arg, unused-ignore]
    """Adds ``catopt/_build.py`` to a wheel and to a source distribution."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Write the file, unless the tree is only linked to or has one from its distribution."""
        package = Path(self.root) / "catopt"
        if version == "editable" or (package / "_build.py").exists():
            return
        own = runpy.run_path(str(package / "_version.py"))
        found, commit = own["version_and_commit"]()
        with NamedTemporaryFile("w", suffix=".py", delete=False, encoding="utf-8") as file:
            file.write('"""Of which commit this was built."""\n\n')
            file.write(f'VERSION = "{found}"\nCOMMIT = "{commit}"\n')
        self.kept = Path(file.name)
        build_data["force_include"][file.name] = "catopt/_build.py"

    def finalize(self, version: str, build_data: dict[str, Any], artifact_path: str) -> None:  # noqa: ARG002
        """Take the temporary file away."""
        if hasattr(self, "kept"):
            self.kept.unlink(missing_ok=True)


class Addresses(MetadataHookInterface):  # type: ignore[misc, unused-ignore]
    """Gives the project the addresses of the repository that it is built from, if it has one."""

    def update(self, metadata: dict[str, Any]) -> None:
        """Fill the project's URLs."""
        address = _address(self.root)
        places = {"Source": "", "Changelog": "/blob/main/CHANGELOG.md", "Issues": "/issues"}
        metadata["urls"] = {name: address + place for name, place in places.items() if address}


def _address(root: str) -> str:
    if "GITHUB_REPOSITORY" in os.environ:
        return f"{os.environ['GITHUB_SERVER_URL']}/{os.environ['GITHUB_REPOSITORY']}"
    asked = ["git", "-C", root, "remote", "get-url", "origin"]
    try:
        said = subprocess.run(asked, capture_output=True, text=True, check=True).stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        return ""
    return said.removesuffix(".git") if said.startswith("https://") else ""
