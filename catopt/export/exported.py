"""What came of an export, as a value, and what the closed form says of its lines."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from operator import attrgetter
from textwrap import wrap
from typing import Any, Literal

from catopt._version import __version__
from catopt.catenary.solution import Solution
from catopt.export.exported_line import ExportedLine, ExportedLines

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
class Source:
    """A file that the case was read from: its name without the folder, SHA-256 of its bytes."""

    name: str
    sha256: str


@dataclass(frozen=True)
class Exported:
    """The input of another program.

    `title`: of the case; `text`: of the file, ASCII; `remarks`: what the other program takes
    otherwise than the case says, which stands in the file too; `expected`: of each line, what the
    closed form says (`catopt.export.exported`); `sources`: what the case was read from.
    """

    format: Format
    title: str
    text: str
    remarks: tuple[str, ...]
    expected: tuple[dict[str, Any], ...]
    sources: tuple[Source, ...] = ()
    version: str = __version__

    @property
    def content(self) -> bytes:
        """The file's bytes."""
        return self.text.encode("ascii")

    def to_dict(self, path: str | None = None) -> dict[str, Any]:
        """Build the document that ``catopt export --json`` prints (schema catopt.export/1).

        `path`: where the file was written; None: nowhere, and the document holds its text.
        """
        from hashlib import sha256

        return {
            "schema": "catopt.export/1",
            "title": self.title,
            "format": self.format,
            "path": path,
            "bytes": len(self.content),
            "sha256": sha256(self.content).hexdigest(),
            "version": self.version,
            "sources": [{"name": each.name, "sha256": each.sha256} for each in self.sources],
            "lines": list(self.expected),
            "remarks": list(self.remarks),
            "text": self.text if path is None else None,
        }


ROUNDING = 1e-12
"""Of a number over the fairlead tension: what is below it is shown as 0."""


_FOUND = (
    ("span_m", "span", "m", "span"),
    ("horizontal_force_N", "H", "N", "horizontal_force"),
    ("fairlead_vertical_force_N", "V at fairlead", "N", "fairlead.vertical_force"),
    ("fairlead_tension_N", "T at fairlead", "N", "fairlead.tension"),
    ("anchor_tension_N", "T at anchor", "N", "anchor.tension"),
    ("anchor_vertical_force_N", "V at anchor", "N", "anchor.vertical_force"),
    ("grounded_length_m", "on the bed", "m", "grounded_length"),
)
"""Key in a document, words and unit in a file, and where a `Solution` has it."""


def exported(
    to: Format, solved: ExportedLines, text: str, remarks: Iterable[str], sources: Iterable[Source]
) -> Exported:
    """Put the text of a file together with what should be found by whoever runs it."""
    answers = tuple(_expected(line) for line in solved.lines)
    return Exported(to, solved.case.title, text, tuple(remarks), answers, tuple(sources))


def _expected(line: ExportedLine) -> dict[str, Any]:
    """List what should be found: under the case's friction, and where the bed has none."""
    at_rest = None if line.at_rest is None else _forces(line.at_rest)
    return {"name": line.name, **_forces(line.solution), "without_friction": at_rest}


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
    forces = _forces(solution)
    rounding = ROUNDING * solution.fairlead.tension
    return ", ".join(
        f"{words} {significant(forces[key] if abs(forces[key]) > rounding else 0.0)} {unit}"
        for key, words, unit, _ in _FOUND
    )


def _forces(solution: Solution) -> dict[str, float]:
    return {key: attrgetter(name)(solution) for key, _, _, name in _FOUND}
