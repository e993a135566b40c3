"""The page around the answers: doors, forms and buttons, in one language."""

from __future__ import annotations

from functools import cache, partial
from typing import TYPE_CHECKING

from catopt._version import __version__
from catopt.desk.fields import DOORS, START, fields_of
from catopt.words import Language, Message, say

if TYPE_CHECKING:
    from jinja2 import Environment

__all__ = ["shell"]


def shell(language: Language = "en") -> str:
    """Render the body of the page as HTML, every word in a language.

    Examples
    --------
    >>> 'data-key="site.water_depth"' in shell("vi")
    True
    """
    return (
        _environment()
        .get_template("shell.html")
        .render(
            language=language,
            doors=DOORS,
            fields={door: fields_of(door) for door in DOORS},
            start=START,
            say=lambda key: say(Message(f"desk.{key}"), language),
            words=partial(say, language=language),
            slider=lambda label: Message("desk.slider", label=label),
            footer=say(Message("page.footer", version=__version__), language),
        )
    )


@cache
def _environment() -> Environment:
    from jinja2 import Environment, PackageLoader, StrictUndefined

    return Environment(
        loader=PackageLoader("catopt.desk", ""),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
