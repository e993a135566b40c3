"""A note as the bytes of its page and of its workbook."""

from __future__ import annotations

from typing import TYPE_CHECKING

from catopt.cli.note_kind import answer_of
from catopt.render.page import page
from catopt.render.workbook import workbook
from catopt.words import Language

if TYPE_CHECKING:
    from catopt.cli.note_kind import AnyNote


def page_of(note: AnyNote, language: Language = "en") -> bytes:
    """Render the page of a note."""
    return page(answer_of(note), language)


def workbook_of(note: AnyNote, language: Language = "en") -> bytes:
    """Lay the workbook of a note out."""
    return workbook(answer_of(note), language)
