"""The calculation note of each sizing of a study."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from catopt.report.files import write_files

if TYPE_CHECKING:
    from catopt.sizing import Sizing
    from catopt.words import Language


@dataclass(frozen=True)
class StudyNotes:
    """Writes the note of a sizing as a page: ``0007-pillar-at-km-12.html``.

    Attributes
    ----------
    folder, source : str
        Where notes go, and the file that all sizings have in common.
    language : {"en", "vi"}
        Of the notes.
    """

    folder: str
    source: str
    language: Language

    def __call__(self, member: int, changes: Mapping[str, Any], sizing: Sizing) -> None:
        """Write the note of a member, counted from 0, with its own values."""
        from catopt.answers.note_size import size_note_answer
        from catopt.notes.origin import read_source
        from catopt.notes.size import Given, size_note
        from catopt.render.page import page

        own = tuple((key, _written(value)) for key, value in changes.items())
        note = size_note(sizing, Given(read_source(Path(self.source)), own))
        title = re.sub(r"[^a-z0-9]+", "-", str(changes.get("title", "")).casefold()).strip("-")
        name = "-".join([f"{member + 1:04d}", *([title] if title else [])]) + ".html"
        content = page(size_note_answer(note), self.language)
        write_files(Path(self.folder), {name: content})


def _written(value: Any) -> str:
    return f"{value:.10g} (SI)" if isinstance(value, float) else str(value)
