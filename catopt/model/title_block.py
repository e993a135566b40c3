"""The title block of a firm's document: for whom it is, its number, and who answers for it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from catopt.model.kinds import Checked, File, Text

Words = Annotated[str, Text(filled=True)]


@dataclass(frozen=True)
class Revision(Checked):
    """An issue of the document."""

    revision: Annotated[str, Text(filled=True, example='"A"')]
    date: Annotated[str, Text(filled=True, example='"2026-11-29"')] = ""
    changed: Annotated[str, Text(filled=True, example='"First issue"')] = ""
    """What it is for, or what is otherwise."""
    prepared: Annotated[str, Text(filled=True, example='"N. V. An"')] = ""
    """By whom, as the next two."""
    checked: Words = ""
    approved: Words = ""


@dataclass(frozen=True)
class TitleBlock(Checked):
    """What every page of the document says of it."""

    client: Annotated[str, Text(filled=True, example='"Port authority"')] = ""
    project: Annotated[str, Text(filled=True, example='"Buoys of the outer fairway"')] = ""
    number: Annotated[str, Text(filled=True, example='"MO-2041-01"')] = ""
    logo: Annotated[str, File(example='"logo.png"')] = ""
    """PNG, JPEG or SVG."""
    revisions: tuple[Revision, ...] = ()
    """The last one is the present one."""

    @property
    def present(self) -> str:
        """Name of the present revision; empty where there is none."""
        return self.revisions[-1].revision if self.revisions else ""
