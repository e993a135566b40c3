"""The page around the answers: doors, forms and buttons, in one language."""

from __future__ import annotations

from functools import partial
from typing import Final

from markupsafe import Markup

from catopt._version import __version__
from catopt.desk.fields import DOORS, START, fields_of
from catopt.words import Language, Message, say

__all__ = ["shell"]


_WAVES: Final = '<path class="wave" d="M2 22q5-4 10 0t10 0 10 0 10 0 10 0 10 0"/>'
_PICTURES: Final = {
    "buoy": Markup(
        f'{_WAVES}<path class="body" d="M28 24v-6h3V6h2v12h3v6z"/>'
        '<path class="rope" d="M32 24q-2 12-22 13"/><path class="body" d="M4 34h8v4H4z"/>'
    ),
    "tanker": Markup(
        f'{_WAVES}<path class="body" d="M22 17h38v9H27z"/><path class="body" d="M52 10h6v7h-6z"/>'
        '<path class="rope" d="M23 18q-4 17-16 19"/><path class="body" d="m3 38 4-5 4 5z"/>'
    ),
    "line": Markup(
        f'{_WAVES}<path class="rope" d="M58 22Q46 37 6 37"/><path class="body" d="m3 38 4-5 4 5z"/>'
        '<circle class="body" cx="58" cy="21" r="3"/>'
    ),
    "body": Markup(
        '<circle class="body" cx="32" cy="20" r="6"/><path class="rope" d="M32 14V3M37 17l19-8'
        'M37 23l19 8M32 26v11M27 23 8 31M27 17 8 9"/>'
    ),
}
"""What the doors look like."""


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
        pictures=_PICTURES,
        unit_of=lambda label: Message("desk.unit_of", label=label),
        slider=lambda label: Message("desk.slider", label=label),
        footer=say(Message("page.footer", version=__version__), language),
    )
    return rendered.removesuffix("\n")
