"""The page around the answers: doors, forms and buttons, in one language."""

from __future__ import annotations

from functools import partial

from catopt._version import __version__
from catopt.desk.fields import DOORS, START, fields_of
from catopt.words import Language, Message, say

__all__ = ["shell"]


def shell(language: Language = "en") -> str:
    """Render the body of the page as HTML, every word in a language.

    Examples
    --------
    >>> 'data-key="site.water_depth"' in shell("vi")
    True
    """
    from catopt.render.page import template

    rendered = template("catopt.desk", "shell.html").render(
        language=language,
        doors=DOORS,
        fields={door: fields_of(door) for door in DOORS},
        start=START,
        say=lambda key: say(Message(f"desk.{key}"), language),
        words=partial(say, language=language),
        slider=lambda label: Message("desk.slider", label=label),
        footer=say(Message("page.footer", version=__version__), language),
    )
    return rendered.removesuffix("\n")
