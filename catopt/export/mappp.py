"""A MAP++ input file: four sections, and what it says of itself as comments at its end."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from catopt.decks.deck import Deck
from catopt.export.exported import exact

_TOLERANCES = ("inner_ftol 1e-12", "inner_gtol 1e-12", "inner_xtol 1e-12", "outer_tol 1e-5")
"""With its own for the lines, 1e-6, MAP++ does not balance a node below which friction acts."""

_KINDS = {"fixed": "fix", "coupled": "vessel", "free": "connect"}


def mappp_lines(deck: Deck, said: Iterable[str]) -> Iterator[str]:
    """Yield the lines of the file; `said`: what it says of itself.

    A comment begins with a blank for MAP++ itself, and with ``!`` for OpenFAST.
    """
    yield "---- LINE DICTIONARY ----"
    yield "LineType Diam MassDenInAir EA CB CIntDamp Ca Cdn Cdt"
    yield "(-) (m) (kg/m) (N) (-) (Pa-s) (-) (-) (-)"
    for name, kind in deck.types.items():
        across, along, added, _ = kind.drag or (0.0, 0.0, 0.0, 0.0)
        at_rest = (kind.diameter, kind.mass, kind.EA, kind.friction or 0.0)
        yield " ".join([name, *map(exact, (*at_rest, 0.0, added, across, along))])
    yield "---- NODE PROPERTIES ----"
    yield "Node Type X Y Z M B FX FY FZ"
    yield "(-) (-) (m) (m) (m) (kg) (m3) (N) (N) (N)"
    for point in deck.points.values():
        # Write a node; MAP++ is to find where a free one comes to rest.
        mark = "#" if point.end == "free" else ""
        place = [mark + exact(each) for each in (point.x, point.y, point.z)]
        if point.end == "fixed" and point.z == -deck.depth:
            place[2] = "depth"
        forces = "0 0 0" if mark else "# # #"
        of_body = f"{exact(point.mass)} {exact(point.volume)}"
        yield " ".join([point.name, _KINDS[point.end], *place, of_body, forces])
    yield "---- LINE PROPERTIES ----"
    yield "Line LineType UnstrLen NodeAnch NodeFair Flags"
    yield "(-) (-) (m) (-) (-) (-)"
    for number, piece in enumerate(deck.pieces, start=1):
        ends = " ".join(piece.ends)
        yield f"{number} {piece.type} {exact(piece.length)} {ends} tension_fair h_fair"
    yield "---- SOLVER OPTIONS ----"
    yield "Option"
    yield "(-)"
    yield from _TOLERANCES
    for line in said:
        yield f" ! {line}".rstrip()
