"""What came of an export, as a value, and what the closed form says of its lines."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from hashlib import sha256
from textwrap import wrap
from typing import Annotated, Any, Literal
from warnings import warn

from catopt._version import __version__
from catopt.catenary.solution import Solution
from catopt.export.exported_line import ExportedLines
from catopt.records import Counted, Digest, From, Record, laid_out

_WITHOUT_MARKS = str.maketrans({"đ": "d", "Đ": "D"})


def plain(text: str) -> str:
    """Return a text in one line of ASCII: letters lose their marks, the rest becomes ``?``."""
    apart = unicodedata.normalize("NFKD", text.translate(_WITHOUT_MARKS))
    kept = "".join(letter for letter in apart if not unicodedata.combining(letter))
    return " ".join(kept.encode("ascii", "replace").decode("ascii").split())


def word(text: str, instead: str) -> str:
    """Return a text as one word of letters, digits and underscores that begins with a letter.

    `instead`: taken where nothing is left, and put before what does not begin with a letter.
    """
    kept = re.sub(r"[^A-Za-z0-9.]+", "_", plain(text).replace("?", " ")).strip("_.")
    kept = kept.replace(".", "p")
    if not kept:
        return instead
    return kept if kept[0].isalpha() else f"{instead}_{kept}"


def exact(value: float) -> str:
    """Return a number that reads back as the same double, for YAML 1.1 too: ``1.0e-07``."""
    digits = repr(float(value) + 0.0)
    return digits if "." in digits else digits.replace("e", ".0e")


def folded(text: str) -> list[str]:
    """Fold to 100 columns; nothing in it looks like the head of a section."""
    indent = " " * (len(text) - len(text.lstrip()))
    safe = plain(text)
    while "---" in safe:
        safe = safe.replace("---", "--")
    return wrap(
        safe, 100, initial_indent=indent, subsequent_indent=indent + "  ", break_on_hyphens=False
    )


def significant(value: float) -> str:
    """Return a number with ten significant digits; what is below 1e-9 is rounding and 0."""
    return f"{value:.10g}" if abs(value) > 1e-9 else "0"


Format = Literal["moordyn", "map", "moorpy", "ontology", "orcaflex", "dxf"]


@dataclass(frozen=True)
class Source(Record):
    """A file that the case was read from."""

    DOCUMENT = "name sha256"

    name: str
    """Without its folder."""
    sha256: Digest
    """SHA-256 of its bytes."""


@dataclass(frozen=True)
class FoundForces(Record):
    """What the closed form finds of a line."""

    DOCUMENT = (
        "solution.span solution.horizontal_force "
        "solution.fairlead.vertical_force=fairlead_vertical_force_N "
        "solution.fairlead.tension=fairlead_tension_N solution.anchor.tension=anchor_tension_N "
        "solution.anchor.vertical_force=anchor_vertical_force_N solution.grounded_length"
    )

    solution: Solution

    def __getitem__(self, key: str) -> Any:
        """Read it as the document has it: what was a dictionary up to 1.0.0."""
        warn("what is expected is read as solution.fairlead.tension", DeprecationWarning, 2)
        return self.to_dict()[key]


@dataclass(frozen=True)
class Expected(FoundForces):
    """What is to be found of a line of an exported file."""

    DOCUMENT = f"name {FoundForces.DOCUMENT} without_friction"

    name: str
    """Of the leg, or its number."""
    without_friction: FoundForces | None
    """The same line between the same ends on a bed without friction, which other programs find at
    rest; None where the bed has none or nothing lies on it."""


@dataclass(frozen=True)
class Exported(Record):
    """What catopt export has written: the lines of a case as the input of another program."""

    SCHEMA = "catopt.export/1"
    DOCUMENT = (
        "title format path size=bytes sha256 version sources expected=lines remarks _kept_text=text"
    )

    format: Format
    """What reads the file: MoorDyn and MoorPy, MAP++, Python with MoorPy, programs of the floating
    array ontology, OrcaFlex, or CAD programs."""
    title: str
    """Title of the case; empty when it has none."""
    text: str
    """Of the file, ASCII."""
    remarks: tuple[str, ...]
    """What the other program takes otherwise than the case says, and what an engineer should know;
    they stand in the file too."""
    expected: Annotated[tuple[Expected, ...], From(1)]
    """Each line as the closed form finds it, with the EA that stands in the file."""
    sources: Annotated[tuple[Source, ...], From(1)] = ()
    """Files that the case was read from; the case file first."""
    version: str = __version__
    """Of catopt."""
    path: str | None = None
    """Where the file was written; None where no place was given, and text holds it."""

    @property
    def content(self) -> bytes:
        """The file's bytes."""
        return self.text.encode("ascii")

    @property
    def size(self) -> Counted:
        """Size of the file."""
        return len(self.content)

    @property
    def sha256(self) -> Digest:
        """SHA-256 of the file."""
        return sha256(self.content).hexdigest()

    @property
    def _kept_text(self) -> str | None:
        """The file itself; None where it was written to a path."""
        return self.text if self.path is None else None

    def to_dict(self, path: str | None = None) -> dict[str, Any]:
        """Build the document that ``catopt export --json`` prints, of a file written to a path."""
        return laid_out(replace(self, path=path))


ROUNDING = 1e-12
"""Of a number over the fairlead tension: what is below it is shown as 0."""


_SAID = ("span", "H", "V at fairlead", "T at fairlead", "T at anchor", "V at anchor", "on the bed")
"""What stands in a file for the keys of `FoundForces`."""


def exported(
    to: Format, solved: ExportedLines, text: str, remarks: Iterable[str], sources: Iterable[Source]
) -> Exported:
    """Put the text of a file together with what should be found by whoever runs it."""
    answers = tuple(
        Expected(
            each.solution, each.name, None if each.at_rest is None else FoundForces(each.at_rest)
        )
        for each in solved.lines
    )
    return Exported(to, solved.case.title, text, tuple(remarks), answers, tuple(sources))


def heading(
    first: str,
    solved: ExportedLines,
    own: Sequence[str],
    remarks: Sequence[str],
    sources: Sequence[Source],
) -> Iterator[str]:
    """Yield what a file says of itself.

    `first`: what it is; `own`: how it has to be read; `remarks`: what stands in it otherwise than
    in the case; `sources`: what the case was read from.
    """
    yield f"{first}; written by catopt {__version__}"
    if solved.case.title:
        yield from folded(f"Case: {solved.case.title}")
    for source in sources:
        yield from folded(f"From {source.name}, SHA-256 {source.sha256}")
    yield ""
    for line in in_words(solved):
        yield from folded(line)
    yield ""
    for line in own:
        yield from folded(line)
    for number, remark in enumerate(remarks, start=1):
        yield from folded(f"Remark {number}: {remark}")


def in_words(solved: ExportedLines) -> Iterator[str]:
    """Yield lines of text that say what should be found, in SI."""
    yield "Closed form of catopt, SI units, tensions without the water's pressure (effective):"
    for line in solved.lines:
        yield f"  {plain(line.name)}: {_sentence(line.solution)}"
        if line.at_rest is not None:
            yield f"    on a bed without friction: {_sentence(line.at_rest)}"
    if solved.system is not None:
        assert solved.system is not None
        where, force = solved.system.position, solved.system.system.force
        yield (
            f"  body at x {significant(where.x)} m, y {significant(where.y)} m, yaw "
            f"{significant(where.yaw)} rad, where the {len(solved.lines)} lines balance a force of "
            f"{significant(force[0])} N along x and {significant(force[1])} N along y"
        )


def _sentence(solution: Solution) -> str:
    found, rounding = FoundForces(solution).to_dict(), ROUNDING * solution.fairlead.tension
    return ", ".join(
        f"{said} {significant(value if abs(value) > rounding else 0.0)} {key.rpartition('_')[2]}"
        for said, (key, value) in zip(_SAID, found.items(), strict=True)
    )
