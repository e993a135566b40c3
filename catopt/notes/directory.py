"""What a directory that ``--out`` wrote says of a note: its case, and what was asked of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from catopt.casefile import case_digest, design_directory, read_case, read_mooring
from catopt.casefile.design_directory import DESIGN_CASE, DESIGN_DOCUMENT
from catopt.errors import InputError, Problem
from catopt.model import Case
from catopt.notes.origin import SourceFile, read_source
from catopt.schemas import CASE_DIGEST, is_ours, read_any, read_document
from catopt.verify.proof import Proof
from catopt.words import Message

_SOLUTION, _VERIFICATION = "solution.json", "verify.json"
_SHOWN = 5
"""Names of files that a refusal lists."""


@dataclass(frozen=True)
class Asked:
    """What a note shows beside the closed form, and the date of its title block.

    That is the truss model, unless `verify` is False, the line by the particle swarm, and the line
    in motion, with how that is proven.
    """

    date: str = ""
    verify: bool = True
    swarm: bool = False
    motion: bool = False
    proof: Proof = "step"

    def with_options(
        self, *, swarm: bool | None = None, motion: bool | None = None, once: bool | None = None
    ) -> Asked:
        """Return it with what options say; None leaves it."""
        proof = None if once is None else "none" if once else "step"
        said: dict[str, Any] = {"swarm": swarm, "motion": motion, "proof": proof}
        return replace(self, **{name: value for name, value in said.items() if value is not None})


@dataclass(frozen=True)
class Chosen:
    """A design, counted from 1, out of a front as a document of schema catopt.design/1."""

    document: dict[str, Any]
    number: int


def read_with_sources(
    path: Path, design: int | None
) -> tuple[Case, tuple[SourceFile, ...], Chosen | None]:
    """Read a case file, or a design out of a result directory, and the files that it is from.

    A design counts from 1; it is the recommended one when left out.
    """
    if design is None and not (path / DESIGN_DOCUMENT).is_file():
        place = case_path(path)
        return read_case(place), (read_source(place),), None
    document = design_directory.read_design_document(path)
    number = document["recommended"] + 1 if design is None else design
    case = design_directory.read_design(path, number)
    sources = (read_source(path / DESIGN_CASE), read_source(path / DESIGN_DOCUMENT))
    return case, sources, Chosen(document, number)


def case_path(path: Path) -> Path:
    """Return the case file of a path: the path itself, or the case file in a directory.

    Raises InputError for a directory without one; the message says what is in it.
    """
    if not path.is_dir():
        return path
    if (path / DESIGN_CASE).is_file():
        return path / DESIGN_CASE
    allowed = Message(
        "refused_command.directory_with_wanted_out_catopt",
        design_case=DESIGN_CASE,
        path=_contents(path),
    )
    raise InputError([Problem("CASE", str(path), allowed)], "options")


def asked_in(path: Path, *, date: str = "", verify: bool = True) -> Asked:
    """Read what was asked of the case of a result directory; nothing further of a case file.

    Raises InputError for a document that cannot be read, is not as its schema has it, or is of
    another case than the directory's.
    """
    asked = Asked(date, verify)
    if not path.is_dir():
        return asked
    found = {place.name: read_any(place) for place in sorted(path.glob("*.json"))}
    ours = {name: each for name, each in found.items() if is_ours(each)}
    _refuse_mixed(path, ours)
    for name in ours.keys() & {_SOLUTION, _VERIFICATION}:
        read_document(path / name, ours[name]["schema"])
    asked = replace(asked, swarm=ours.get(_SOLUTION, {}).get("method") == "pso")
    dynamic = ours.get(_VERIFICATION, {}).get("dynamic")
    if dynamic is None:
        return asked
    return replace(asked, motion=True, proof=dynamic["load_cases"][0].get("proof", "step"))


def _refuse_mixed(directory: Path, documents: Mapping[str, dict[str, Any]]) -> None:
    """Refuse documents of another case than that of the directory, or of a design of its front.

    Those of versions that wrote no digest are taken as they are.
    """
    digests = {name: each[CASE_DIGEST] for name, each in documents.items() if CASE_DIGEST in each}
    if not digests or not (directory / DESIGN_CASE).is_file():
        return
    own = case_digest(read_mooring(directory / DESIGN_CASE))
    strange = {name for name, digest in digests.items() if digest != own}
    if strange and DESIGN_DOCUMENT in documents.keys() - strange:
        count = len(design_directory.read_design_document(directory)["front"])
        designs = (
            design_directory.read_design(directory, number) for number in range(1, count + 1)
        )
        known = {case_digest(each) for each in designs}
        strange = {name for name in strange if digests[name] not in known}
    if strange:
        allowed = Message("refused_command.another_case_than_beside_run", design_case=DESIGN_CASE)
        raise InputError([Problem(name, "", allowed) for name in sorted(strange)], str(directory))


def _contents(directory: Path) -> Message:
    """Say in words what a directory has."""
    names = sorted(each.name for each in directory.iterdir() if not each.name.startswith("."))
    if not names:
        return Message("refused_command.nothing_in_it")
    more = len(names) - _SHOWN
    shown = ", ".join(names[:_SHOWN])
    key = "refused_command.contents_and_more" if more > 0 else "refused_command.contents"
    return Message(key, shown=shown, more=more)
