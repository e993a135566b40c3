"""The film of a buoy on its line around the largest tension, as a page that needs no other file."""

from __future__ import annotations

import base64
import hashlib
import json
from typing import TYPE_CHECKING, Final

from catopt.render.looks import stylesheet
from catopt.render.page import file_text, template
from catopt.words import Language, Measure, Message, say

if TYPE_CHECKING:
    from catopt.floater.scene import Scene

_WIDTH: Final = 960
"""Of the drawing, in its own units."""
_CLEAR: Final = 1.05
"""Room above the highest surface and hull, over their height."""
_BELOW: Final = 0.05
"""Of the bed that is drawn, over the height of what is above it."""


def film(scene: Scene, title: str, language: Language = "en") -> bytes:
    """Make the page: the moments of a scene to scale, with a slider, and the tension below."""
    k, x = scene.worst, scene.x
    unit = float(x[-1] - x[0]) / _WIDTH
    highest = max(float(scene.surface.max()), *(float(scene.hull(j)[:, 1].max()) for j in (0, k)))
    top = _CLEAR * highest
    values = {
        "frame": [float(x[0]), top, unit],
        "time": scene.time.round(3).tolist(),
        "line": scene.line.round(3).tolist(),
        "place": scene.place.round(4).tolist(),
        "tension": (scene.tension / 1e3).round(3).tolist(),
        "x": x.round(3).tolist(),
        "surface": scene.surface.round(3).tolist(),
        "outline": scene.outline.round(4).tolist(),
    }
    script = file_text("film.js")
    worst = {"T": Measure("tension", float(scene.tension[k])), "t": float(scene.time[k])}
    seconds = float(scene.time[-1] - scene.time[0])
    words = {
        "said": Message("figures.film", seconds=seconds, **worst),
        "tension": Message("figures.film_tension"),
        "play": Message("figures.film_play"),
        "pause": Message("figures.film_pause"),
        "moment": Message("figures.film_moment"),
    }
    return (
        template("catopt.render", "film.html")
        .render(
            language=language,
            title=title,
            style=stylesheet() + file_text("style.css"),
            script=script,
            script_hash=base64.b64encode(hashlib.sha256(script.encode()).digest()).decode(),
            scene=json.dumps(values, separators=(",", ":")),
            width=_WIDTH,
            height=round((1.0 + _BELOW) * top / unit),
            bed=round(top / unit),
            last=scene.time.size - 1,
            worst=k,
            **{key: say(text, language) for key, text in words.items()},
        )
        .encode()
    )
