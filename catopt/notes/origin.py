"""Where a note comes from: the files that it rests on, when and by which version it was made."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from pathlib import Path

from catopt._version import __version__
from catopt.casefile.design_directory import DESIGN_CASE
from catopt.casefile.schema import CaseTable, Table
from catopt.casefile.sizing_file import SIZING
from catopt.documents import MOST_BYTES_OF_DATA, parse_toml, read_text
from catopt.notes.inputs import Input, inputs_of


@dataclass(frozen=True)
class SourceFile:
    """A file that the note rests on: its name, its text and the SHA-256 of its bytes."""

    name: str
    text: str
    sha256: str


@dataclass(frozen=True)
class Origin:
    """What a note rests on: its files, the case file first, with every value of that.

    The date is as it was given, empty when none was; the version is that of catopt.
    """

    files: tuple[SourceFile, ...]
    inputs: tuple[Input, ...] = ()
    date: str = ""
    version: str = __version__


def origin_of(
    files: tuple[SourceFile, ...], date: str = "", schema: type[Table] = CaseTable
) -> Origin:
    """Say where a note comes from; the first of the files, as its schema has it, has its inputs."""
    document = parse_toml(files[0].text, files[0].name)
    return Origin(files, inputs_of(document, schema), _writable(date))


def read_source(path: Path) -> SourceFile:
    """Read a file that a note rests on; InputError where it cannot be read."""
    text = read_text(path, str(path), most=MOST_BYTES_OF_DATA)
    return SourceFile(_writable(path.name), text, hashlib.sha256(path.read_bytes()).hexdigest())


def _writable(text: str) -> str:
    """Replace what no file can hold: bytes of a name or an option that are no text."""
    return text.encode("utf-8", "replace").decode("utf-8")


def file_name(path: Path, design: int | None) -> str:
    """Name the page of a case: that of the file, or of the folder of a file with the usual name.

    With the number of the design, if it is one.
    """
    place = path.resolve()
    name = place.name if place.is_dir() else place.stem
    if place.name in (DESIGN_CASE, SIZING) and not place.is_dir():
        name = place.parent.name or name
    return f"{name}.html" if design is None else f"{name}-design-{design}.html"
