"""A film as a page that needs no other file: to scale, with a slider, and the tension below."""

from __future__ import annotations

import json
from typing import Final

from catopt.figures.chart import Film
from catopt.render.page import file_text, whole_page
from catopt.words import Language, Message, say

_WIDTH: Final = 960
"""Of the drawing, in its own units."""
_BELOW: Final = 0.05
"""Of the bed that is drawn, over the height of what is above it."""


def film_page(film: Film, title: str, language: Language = "en") -> bytes:
    """Make the page of a film."""
    unit = film.wide / _WIDTH
    words = {
        "said": film.title,
        "tension": Message("figures.film_tension"),
        "play": Message("figures.film_play"),
        "pause": Message("figures.film_pause"),
        "moment": Message("figures.film_moment"),
    }
    scene = {"frame": [film.left, film.top, unit], **film.values}
    return whole_page(
        "film.html",
        language,
        script=file_text("film.js"),
        title=title,
        kind="",
        scene=json.dumps(scene, separators=(",", ":")),
        width=_WIDTH,
        height=round((1.0 + _BELOW) * film.top / unit),
        bed=round(film.top / unit),
        last=len(film.values["time"]) - 1,
        worst=film.worst,
        **{key: say(text, language) for key, text in words.items()},
    )
