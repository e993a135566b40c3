"""Writing a directory of files whole or not at all."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Collection, Mapping
from pathlib import Path
from time import time
from typing import Any

from catopt.casefile.reading import DESIGN_CASE
from catopt.casefile.writing import text_digest
from catopt.errors import InputError, Problem
from catopt.interrupt import signals_wait
from catopt.render.files import document_bytes
from catopt.schemas import CASE_DIGEST
from catopt.words import Message, Several, term

_TEMPORARY = re.compile(r"\..+\.\d+\.tmp")
_STALE = 600.0
"""Seconds after which nobody is still writing a temporary file: all are written within a few."""


def check_directory(directory: Path) -> None:
    """Make sure that files can be written to a directory, or that it can be made; nothing is left.

    Raises InputError where it is a file, or cannot be made or written to.
    """
    if directory.exists() and not directory.is_dir():
        raise _refused(directory, Message("refused_command.is_a_file"))
    place = directory
    try:
        while not place.exists() and place != place.parent:
            place = place.parent
        probe = _temporary(place / "probe")
        probe.touch()
        probe.unlink()
    except OSError as error:
        raise _refused(directory, _reason(error)) from error


def write_files(
    directory: Path,
    contents: Mapping[str, bytes],
    keep: Collection[Path] = (),
    case: bytes | None = None,
) -> tuple[Path, ...]:
    """Write files so that none is ever seen half written, and that all are of one answer.

    All are first written under temporary names; only then does each take its place, and with it
    that of an older file of the same name. A signal waits until the last one has. Every document of
    catopt among them carries the digest of its case, which goes first, so that a directory in which
    even a power cut left parts of two answers is recognised. That is `case`, or the case file among
    them; `keep` are files that were read, in whose place nothing is written.

    Raises InputError where the directory or a file in it cannot be written, or would go in the
    place of one to keep.
    """
    check_directory(directory)
    try:
        directory.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise _refused(directory, _reason(error)) from error
    of = contents.get(DESIGN_CASE) if case is None else case
    places = {directory / name: _marked(each, of) for name, each in contents.items()}
    for place in places:
        if any((place.exists() and read.exists() and place.samefile(read)) for read in keep):
            raise _refused(place, Message("refused_command.is_read"))
    try:
        _sweep(directory)
        for place, content in places.items():
            with _temporary(place).open("wb") as stream:
                stream.write(content)
                stream.flush()
                os.fsync(stream.fileno())
        with signals_wait():
            for place in sorted(places, key=_rank):
                _temporary(place).replace(place)
    except OSError as error:
        raise _refused(directory, _reason(error)) from error
    finally:
        for place in places:
            _temporary(place).unlink(missing_ok=True)
    return tuple(places)


def _rank(place: Path) -> int:
    """Order of the files: the case first, documents that carry its digest last."""
    return 0 if place.name == DESIGN_CASE else 2 if place.suffix == ".json" else 1


def _marked(content: bytes, case: bytes | None) -> bytes:
    """Put the digest of the case into a document of catopt; leave every other file."""
    if case is None or not content.startswith(b'{\n  "schema": "catopt.'):
        return content
    return document_bytes(with_digest(json.loads(content), text_digest(case.decode())))


def with_digest(document: dict[str, Any], digest: str) -> dict[str, Any]:
    """Put the digest of its case into a document, after its schema."""
    mark = {CASE_DIGEST: digest}
    return {"schema": document["schema"], **mark} | document | mark


def _sweep(directory: Path) -> None:
    """Remove temporary files that a run which was killed left behind."""
    for place in directory.glob(".*.tmp"):
        if _TEMPORARY.fullmatch(place.name) and time() - place.stat().st_mtime > _STALE:
            place.unlink(missing_ok=True)


def _temporary(place: Path) -> Path:
    """Name a file beside its place, for `replace` is only whole within one file system."""
    return place.with_name(f".{place.name}.{os.getpid()}.tmp")


def _reason(error: OSError) -> Message:
    name = f"{Path(error.filename2 or error.filename).name}: " if error.filename else ""
    return Message(
        "refused_command.not_written",
        reason=Several((name, term(error.strerror or str(error))), ""),
    )


def _refused(directory: Path, why: Message) -> InputError:
    return InputError([Problem("--out", str(directory), why)])
