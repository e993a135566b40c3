"""How what has a role looks in a drawing: one table, for the page and for pictures.

Colours are by the palette of Okabe and Ito, which every kind of colour vision tells apart.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Literal, NamedTuple

Sign = Literal["", "circle", "square", "diamond", "triangle", "cross", "tick", "words"]

COLOURS: Mapping[str, tuple[str, str]] = {
    "paper": ("#ffffff", "#15181b"),
    "ink": ("#1a1a1a", "#e8e8e8"),
    "quiet": ("#595959", "#a9b0b6"),
    "rule": ("#c9c9c9", "#444b52"),
    "blue": ("#0072b2", "#56b4e9"),
    "orange": ("#c04f00", "#f0913a"),
    "green": ("#00795a", "#2fc79c"),
    "purple": ("#a8568a", "#dd9cc4"),
    "water": ("#d9ecf8", "#14303f"),
    "surface": ("#3b86b5", "#6fb7dc"),
    "bed": ("#e4dacb", "#3d352a"),
    "bed-edge": ("#7a6a55", "#b7a488"),
    "bad": ("#a81c1c", "#ff8a80"),
}
"""Each colour on light paper and on dark."""


class Look(NamedTuple):
    """How a role looks; lengths in units of a drawing that is 640 wide.

    Attributes
    ----------
    stroke : str
        Name of the colour of lines; empty: none.
    width : float
        Of lines.
    dash : tuple of float
        Lengths of dashes and gaps; empty: solid.
    fill : str
        Name of the colour of what is closed; empty: none.
    opacity : float
        Of the fill.
    sign : str
        What marks a place.
    size : float
        Half the breadth of the sign.
    """

    stroke: str = ""
    width: float = 1.0
    dash: tuple[float, ...] = ()
    fill: str = ""
    opacity: float = 1.0
    sign: Sign = ""
    size: float = 6.0


LOOKS: Mapping[str, Look] = {
    # Frames and dimensions.
    "frame": Look("rule"),
    "grid": Look("rule", 0.7),
    "thin": Look("quiet", 0.8),
    "dimension": Look("ink"),
    "arrow-head": Look(fill="ink"),
    "zero": Look("quiet", 0.8),
    # Water, bed and the line in it.
    "water": Look(fill="water"),
    "surface": Look("surface", 1.6),
    "bed": Look(fill="bed"),
    "bed-edge": Look("bed-edge", 1.4),
    "mooring": Look("ink", 2.4),
    "grounded": Look("orange", 7.0),
    "failing": Look("bad", 3.0, sign="circle", size=13.0),
    "anchor": Look("paper", 1.0, fill="ink", sign="triangle", size=9.0),
    "anchor-spot": Look("paper", 1.0, fill="ink", sign="triangle"),
    "touchdown": Look("ink", 2.0, sign="tick", size=11.0),
    "fairlead": Look("ink", 2.0, fill="paper", sign="circle"),
    "clump": Look("ink", 1.4, fill="purple", sign="square", size=7.0),
    "buoy": Look("ink", 1.4, fill="green", sign="diamond", size=8.0),
    "joint-spot": Look("quiet", 1.8, fill="paper", sign="circle", size=4.0),
    # Curves, and levels beside them.
    "first": Look("blue", 2.2),
    "second": Look("orange", 2.2, (8.0, 3.0)),
    "third": Look("green", 2.2, (2.0, 4.0)),
    "fourth": Look("purple", 2.2, (8.0, 2.0, 2.0, 2.0)),
    "faint": Look("green", 1.0, (3.0, 2.0)),
    "rest": Look("green", 1.6, (2.0, 4.0)),
    "between": Look(fill="blue", opacity=0.12),
    "capacity": Look("bad", 2.0, (3.0, 3.0)),
    "limit": Look("green", 1.8, (6.0, 3.0)),
    "interval": Look("orange", 3.0),
    "joint": Look("quiet", 1.2, (2.0, 3.0)),
    "touchdown-at": Look("orange", 1.4, (7.0, 3.0)),
    "load-at": Look("purple", 1.4, (9.0, 2.0, 2.0, 2.0)),
    "nodes": Look("orange", 1.4, fill="paper", sign="circle", size=3.0),
    "peak": Look("ink", 1.2, fill="paper", sign="circle", size=3.0),
    "probable": Look("ink", 1.0, fill="orange", sign="diamond", size=7.0),
    "reference": Look("ink", 2.0, fill="paper", sign="circle"),
    "event": Look("quiet", 1.0, fill="paper", sign="circle", size=11.0),
    # A front.
    "design": Look(fill="blue", sign="circle", size=4.0),
    "lowest": Look("blue", 1.4, fill="paper", sign="circle", size=3.5),
    "middle": Look(fill="blue", sign="circle", size=4.5),
    "highest": Look(fill="ink", sign="square", size=5.0),
    "end": Look("ink", 1.6, sign="circle", size=7.0),
    "recommended": Look("green", 2.4, sign="circle", size=10.0),
    "present": Look("ink", 1.4, fill="orange", sign="square", size=5.0),
    "chosen": Look("bad", 2.4, sign="circle", size=7.0),
    # A body from above.
    "leg": Look("ink", 1.6),
    "lying": Look("orange", 4.0),
    "arm": Look("quiet", 3.0),
    "touchdown-spot": Look("ink", 1.4, fill="paper", sign="circle", size=3.2),
    "neutral": Look("blue", 2.0, sign="cross", size=8.0),
    "offset-mark": Look("blue", 3.4),
    "push": Look("purple", 3.0),
    "push-head": Look(fill="purple"),
    "model-a": Look("orange", 2.0, fill="paper", sign="square"),
    "model-b": Look("blue", 2.0, fill="paper", sign="circle"),
    "number": Look(fill="ink", sign="words"),
    "most-loaded": Look(fill="bad", sign="words"),
    "beside": Look(fill="ink", sign="words"),
}
"""The look of each role."""


def stylesheet() -> str:
    """Write the looks as CSS, in light and in dark colours."""
    return "\n".join(_rules()) + "\n"


def _rules() -> Iterator[str]:
    light, dark = (
        "".join(f"--{name}:{pair[index]};" for name, pair in COLOURS.items()) for index in (0, 1)
    )
    yield f":root{{{light}}}"
    yield f"@media screen and (prefers-color-scheme: dark){{:root{{{dark}}}}}"
    for role, look in LOOKS.items():
        rule = f"fill:var(--{look.fill});" if look.fill else "fill:none;"
        if look.opacity < 1.0:
            rule += f"fill-opacity:{look.opacity:g};"
        if look.stroke:
            rule += f"stroke:var(--{look.stroke});stroke-width:{look.width:g};"
        if look.dash:
            rule += f"stroke-dasharray:{' '.join(f'{each:g}' for each in look.dash)};"
        yield f"svg .{role}{{{rule}}}"
