"""What a directory that ``--out`` wrote says of a note: its case, and what was asked of it."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from catopt.casefile.design_directory import DESIGN_CASE
from catopt.errors import InputError, Problem
from catopt.verify.proof import Proof

__all__ = ["Asked", "asked_in", "case_path"]

_SOLUTION, _VERIFICATION = "solution.json", "verify.json"
_SHOWN = 5
"""Names of files that a refusal lists."""


@dataclass(frozen=True)
class Asked:
    """What a note shows beside the closed form.

    Attributes
    ----------
    swarm : bool
        The line by the particle swarm, too.
    motion : bool
        The line in motion, too.
    proof : {"none", "step", "bars"}
        How that is proven.
    """

    swarm: bool = False
    motion: bool = False
    proof: Proof = "step"


def case_path(path: Path) -> Path:
    """Return the case file of a path: the path itself, or the case file in a directory.

    Raises
    ------
    InputError
        A directory without a case file; the message says what is in it.
    """
    if not path.is_dir():
        return path
    if (path / DESIGN_CASE).is_file():
        return path / DESIGN_CASE
    allowed = (
        f"a directory with a {DESIGN_CASE} is wanted, as --out of catopt solve, check, curve, "
        f"verify, system and design writes it; there is {_contents(path)}. Give a case file, or "
        "run the command with --out once more, for older directories have no case"
    )
    raise InputError([Problem("CASE", str(path), allowed)], "options")


def asked_in(path: Path) -> Asked:
    """Read what was asked of the case of a result directory; nothing further of a case file."""
    solution = _document(path / _SOLUTION, "catopt.solution/")
    verification = _document(path / _VERIFICATION, "catopt.verify/")
    dynamic = verification.get("dynamic")
    swarm = solution.get("method") == "pso"
    if dynamic is None:
        return Asked(swarm)
    return Asked(swarm, motion=True, proof=dynamic["load_cases"][0].get("proof", "step"))


def _document(path: Path, schema: str) -> dict[str, Any]:
    """Read a document of catopt; empty where there is none of that kind."""
    try:
        document = json.loads(path.read_text("utf-8"))
    except (OSError, ValueError):
        return {}
    is_ours = isinstance(document, dict) and str(document.get("schema", "")).startswith(schema)
    return document if is_ours else {}


def _contents(directory: Path) -> str:
    """Say in words what a directory has."""
    names = sorted(each.name for each in directory.iterdir() if not each.name.startswith("."))
    if not names:
        return "nothing in it"
    more = len(names) - _SHOWN
    return ", ".join(names[:_SHOWN]) + (f" and {more} more" if more > 0 else "")
