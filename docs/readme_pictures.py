"""Draws README's and the guide's pictures: ``python docs/readme_pictures.py [NAME ...]``."""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from pathlib import Path

import catopt
from catopt.figures.sizing import (
    elevation,
    front,
    front_lines,
    swing_circle,
    tension_by_length,
)
from catopt.render.picture import pictures

HERE = Path(__file__).parent
CASES = HERE.parent / "cases"


def draw_front() -> bytes:
    """Draw S3's tanker with the front of her designs."""
    found = catopt.design_case(catopt.read_case(CASES / "design-tanker-20m" / "case.toml"))
    document = found.to_dict()
    charts = (front(document), front_lines(found, document))
    return pictures("front", charts, found.case.title)["front.png"]


def draw_buoy() -> bytes:
    """Draw a buoy on its chain, from the side and from above."""
    buoy = catopt.size_buoy("pillar 1.8 m", depth="12 m")
    title = "Pillar 1.8 m, 12 m of water"
    return pictures("buoy", (elevation(buoy), swing_circle(buoy)), title)["buoy.png"]


def draw_ship() -> bytes:
    """Draw the mooring of README's first command."""
    ship = catopt.size_tanker(dwt="50000 t", depth="20 m")
    title = "Tanker of 50,000 DWT, 20 m of water"
    return pictures("ship", elevation(ship), title)["ship.png"]


def draw_by_length() -> bytes:
    """Draw what the length of a buoy's chain does in the storm; it takes some minutes."""
    buoy = catopt.size_buoy("pillar 1.8 m", depth="12 m", in_motion=True, other_lengths=5)
    assert buoy.in_motion is not None
    title = "Pillar 1.8 m, 12 m of water"
    return pictures("by-length", tension_by_length(buoy.in_motion), title)["by-length.png"]


PICTURES: dict[str, Callable[[], bytes]] = {
    "picture-front.png": draw_front,
    "picture-buoy.png": draw_buoy,
    "picture-ship.png": draw_ship,
    "picture-by-length.png": draw_by_length,
}
"""By their files beside this one."""


def main(names: Sequence[str]) -> None:
    """Draw pictures anew, all where none is named."""
    for name in names or PICTURES:
        (HERE / name).write_bytes(PICTURES[name]())


if __name__ == "__main__":
    main(sys.argv[1:])
