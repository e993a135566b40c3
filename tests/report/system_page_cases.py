"""Moored bodies that tests of the command line take as files."""

from pathlib import Path

from .page_cases import case_path


def system_path(folder: Path, name: str) -> Path:
    """Return the path of a body's case."""
    return case_path(folder, {"raised": "raised-anchors"}.get(name, name))
