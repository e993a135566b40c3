"""From a note to the bytes of its page."""

from __future__ import annotations

import base64
import hashlib
from functools import cache
from importlib.resources import files
from typing import TYPE_CHECKING

from catopt.notes.line import Note
from catopt.notes.system import SystemNote
from catopt.render.looks import stylesheet
from catopt.render.texts import Language, Words
from catopt.report.page.sections import SECTIONS, AnyNote

if TYPE_CHECKING:
    from jinja2 import Environment

__all__ = ["environment", "render_page", "sections_of"]


def render_page(note: AnyNote, language: Language = "en") -> bytes:
    """Render the page.

    The same note gives the same bytes: nothing of the place or the hour goes in.

    Parameters
    ----------
    note : Note or another kind
        What it shows.
    language : {"en", "vi"}
        Of its words.

    Returns
    -------
    bytes
        HTML in UTF-8, complete: it refers to no other file and to no network.
    """
    if isinstance(note, Note):
        from catopt.answers.note_line import line_note_answer
        from catopt.render.page import page as new_page

        return new_page(line_note_answer(note), language)
    if isinstance(note, SystemNote):
        from catopt.answers.note_system import system_note_answer
        from catopt.render.page import page as new_page

        return new_page(system_note_answer(note), language)
    words = Words(language)
    script = _file("script.js")
    page = environment().get_template("page.html").render(
        note=note,
        words=words,
        sections=sections_of(note, words),
        style=stylesheet() + _file("style.css"),
        script=script,
        script_hash=_hash(script),
    )  # fmt: skip
    return page.encode()


def sections_of(note: AnyNote, words: Words) -> list[tuple[str, dict[str, object]]]:
    """Build every section that has something to show, by its key."""
    if isinstance(note, Note):
        from catopt.answers.note_line import line_note_answer

        return [(each.name, {}) for each in line_note_answer(note).sections]
    if isinstance(note, SystemNote):
        from catopt.answers.note_system import system_note_answer

        return [(each.name, {}) for each in system_note_answer(note).sections]
    built = ((section.key, section.build(note, words)) for section in SECTIONS[type(note)])
    return [(key, shown) for key, shown in built if shown is not None]


@cache
def environment() -> Environment:
    """Make the templates' environment: all that is put in is escaped, and nothing may lack."""
    from jinja2 import Environment, PackageLoader, StrictUndefined

    return Environment(
        loader=PackageLoader("catopt.report.page"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )


def _file(name: str) -> str:
    return files("catopt.render").joinpath(name).read_text("utf-8")


def _hash(script: str) -> str:
    """Hash the script, so that the page's own policy runs it and no other."""
    return base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
