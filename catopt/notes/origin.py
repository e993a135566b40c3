"""Where a note comes from: its files with their values, what a directory says, its date."""

from __future__ import annotations

import base64
import hashlib
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Final

from catopt._version import identity
from catopt.casefile import case_digest, read_mooring
from catopt.casefile import reading as design_directory
from catopt.casefile.reading import DESIGN_CASE, DESIGN_DOCUMENT, SIZING
from catopt.casefile.schema import CaseTable, TableSchema, entries
from catopt.documents import MOST_BYTES_OF_DATA, dotted, parse_toml, read_text
from catopt.documents import Path as Keys
from catopt.errors import InputError, Problem, refused
from catopt.model import Case, TitleBlock
from catopt.model.kinds import Kind, Measured
from catopt.model.network import require_case
from catopt.records import Digest
from catopt.schemas import CASE_DIGEST, is_ours, read_any, read_document
from catopt.units import as_written
from catopt.verify.convergence_check import ConvergenceCheck
from catopt.words import Message

_MOST = 8
"""Values of an array that are all shown; of a longer one the first two and the last are."""
_LONGEST = 160
"""Characters of a text that are shown; the whole of it stands in the case file below."""
_FREE_TEXT = {"title", "source", "document"}
"""What stands in the title block already."""


@dataclass(frozen=True)
class Input:
    """A value of a file: where it is, as it is written there, and in SI.

    `si` is a text for several values, None for what is not measured; `unit` the SI unit, empty for
    a pure number.
    """

    key: str
    given: str
    si: float | str | None = None
    unit: str = ""


@dataclass(frozen=True)
class SourceFile:
    """A file that the note rests on."""

    name: str
    """Without its folder."""
    text: str
    sha256: Digest
    """SHA-256 of its bytes."""


@dataclass(frozen=True)
class Origin:
    """What a note rests on: its files, the case file first, with every value of that.

    The date is as it was given, empty when none was; the version is that of catopt.
    """

    files: tuple[SourceFile, ...]
    inputs: tuple[Input, ...] = ()
    date: str = ""
    version: str = field(default_factory=identity)
    logo: str = ""
    """Of the firm, as the address that holds all of it (``data:``); empty without one."""


def origin_of(
    files: tuple[SourceFile, ...],
    date: str = "",
    schema: type[TableSchema] = CaseTable,
    title_block: TitleBlock | None = None,
) -> Origin:
    """Say where a note comes from; the first of the files, as its schema has it, has its inputs."""
    document = parse_toml(files[0].text, files[0].name)
    logo = "" if title_block is None or not title_block.logo else _embedded(Path(title_block.logo))
    return Origin(files, inputs_of(document, schema), _writable(date), logo=logo)


_PICTURES: Final = {".png": "png", ".jpg": "jpeg", ".jpeg": "jpeg", ".svg": "svg+xml"}
_MOST_OF_A_LOGO: Final = 1_000_000


def _embedded(picture: Path) -> str:
    """Read a picture as an address that holds it; InputError for what is none."""
    kind = _PICTURES.get(picture.suffix.lower())
    wanted = Message("refused_file.a_logo", most=_MOST_OF_A_LOGO / 1e6)
    if not picture.is_file():
        there_is = Message("notes.no_such_picture", path=picture)
        raise refused("document.logo", there_is, wanted)
    content = picture.read_bytes()
    if kind is None or len(content) > _MOST_OF_A_LOGO:
        raise refused("document.logo", str(picture), wanted)
    return f"data:image/{kind};base64,{base64.b64encode(content).decode()}"


def source_of(name: str, text: str) -> SourceFile:
    """Take a text as the file of a name."""
    return SourceFile(name, text, hashlib.sha256(text.encode()).hexdigest())


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


# ------------------------------------------------------------------ values of a file


def inputs_of(document: dict[str, Any], schema: type[TableSchema]) -> tuple[Input, ...]:
    """List every value of a file, as the TOML reader returns it, that is no free text."""
    found = leaves(document, schema)
    return tuple(_input(*leaf) for leaf in found if leaf[0][0] not in _FREE_TEXT)


def leaves(
    document: dict[str, Any], schema: type[TableSchema], path: Keys = ()
) -> Iterator[tuple[Keys, Kind | None, Any]]:
    """Yield every value of a case file with its path and its kind; arrays of values are whole."""
    known = entries(schema)
    for key, value in document.items():
        entry = known.get(key)
        inner = None if entry is None else entry.table
        here = (*path, key)
        if inner is not None and isinstance(value, dict):
            yield from leaves(value, inner, here)
        elif inner is not None and isinstance(value, list):
            for index, each in enumerate(value):
                yield from leaves(each, inner, (*here, index))
        else:
            yield here, None if entry is None else entry.kind, value


def _input(path: Keys, kind: Kind | None, value: Any) -> Input:
    many = value if isinstance(value, list) else [value]
    given = _some(many, lambda each: as_written(each, _LONGEST))
    if not isinstance(kind, Measured):
        return Input(dotted(path), given)
    unit = kind.dimension.si_unit
    read = [kind.read(each) for each in many]
    if len(read) == 1:
        return Input(dotted(path), given, read[0], unit)
    return Input(dotted(path), given, _some(read, lambda each: f"{each:.9g} {unit}".rstrip()), unit)


def _some(values: Sequence[Any], show: Callable[[Any], str]) -> str:
    """Show all of a few values, or the ends of many with their number."""
    if len(values) <= _MOST:
        return ", ".join(show(value) for value in values)
    first, second, last = (show(values[index]) for index in (0, 1, -1))
    return f"{first}, {second}, … {last} ({len(values)})"


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
    convergence_check: ConvergenceCheck = "step"

    def with_options(
        self, *, swarm: bool | None = None, motion: bool | None = None, once: bool | None = None
    ) -> Asked:
        """Return it with what options say; None leaves it."""
        said: dict[str, Any] = {"swarm": swarm, "motion": motion}
        if once is not None:
            said["convergence_check"] = "none" if once else "step"
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
        return design_directory.read_case_or_design(place, None), (read_source(place),), None
    document = design_directory.read_design_document(path)
    number = document["recommended"] + 1 if design is None else design
    case = require_case(design_directory.read_design(path, number), str(path))
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
    names = sorted(each.name for each in path.iterdir() if not each.name.startswith("."))
    shown, more = ", ".join(names[:_SHOWN]), len(names) - _SHOWN
    contents = Message("refused_command.nothing_in_it")
    if names:
        key = "contents_and_more" if more > 0 else "contents"
        contents = Message(f"refused_command.{key}", shown=shown, more=more)
    key = "refused_command.directory_with_wanted_out_catopt"
    allowed = Message(key, design_case=DESIGN_CASE, path=contents)
    raise refused("CASE", str(path), allowed, "options")


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
    return replace(
        asked, motion=True, convergence_check=dynamic["load_cases"][0].get("proof", "step")
    )


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
