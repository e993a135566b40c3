"""What came of an export, as a value."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

from catopt._version import __version__

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
    closed form says (`catopt.export.expected`); `sources`: what the case was read from.
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
